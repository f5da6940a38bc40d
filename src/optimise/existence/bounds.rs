//! What is known for certain of the equations near the centre. All are divided, row by row, by the
//! lengths of the gradients in the linearisation.

use super::NoProof;
use super::problem::Problem;
use super::rounding::{largest, length, up};
use crate::mesh::VertexId;
use crate::scalar::{Ball, DoubleDouble, Dual, Magnitude, Ordered};
use crate::space::Point;

/// The coordinates within `reach` of one of the centre.
pub fn ball(difference: DoubleDouble, shift: f64, reach: f64) -> Ball<f64> {
    Ball::of_pair(&difference) + Ball::new(shift, reach)
}

/// Not below the length of the vector of residuals at the centre.
pub fn residual(problem: &Problem<'_>) -> Result<f64, NoProof> {
    let row = |row| {
        let sharp = |x: DoubleDouble| Ball::new(x, DoubleDouble::from(0.0));
        let value = problem.value(row, |difference, shift| sharp(difference) + sharp(shift.into()));
        Some(up(value?.bound().above() / problem.at.lengths[row]))
    };
    problem.rows(row).map(length)
}

/// Not below the 2-norm of `J(x̂) − J̃`: how much the derivative at the centre differs from the matrix that was
/// factorised.
pub fn deviation(problem: &Problem<'_>) -> Result<f64, NoProof> {
    let row = |row| {
        let places = problem.places(row);
        let balls = problem.local(places, |difference, shift| ball(difference, shift, 0.0));
        let constant = |p: &Point<Ball<f64>>| p.map(|c| Dual::<_, 3>::constant(*c));
        let mut corners: Vec<_> = balls.iter().map(constant).collect();
        let scale = Ball::new(problem.at.lengths[row], 0.0);
        let gradients = &problem.at.gradients[problem.system.range(row)];
        let mut square = 0.0;
        for (i, (v, g)) in places.iter().zip(gradients).enumerate() {
            if !problem.is_free(*v) {
                continue;
            }
            let Point { x, y, z } = balls[i];
            let [x, y, z] = Dual::variables([x, y, z]);
            corners[i] = Point::new(x, y, z);
            let slopes = problem.polynomial(row).eval(&corners)?.partials;
            corners[i] = constant(&balls[i]);
            for (slope, g) in slopes.iter().zip([g.x, g.y, g.z]) {
                let bound = (slope - scale * Ball::new(g, 0.0)).bound();
                square = up(square + bound * bound);
            }
        }
        Some(up(up(square.sqrt()) / problem.at.lengths[row]))
    };
    problem.rows(row).map(|rows| coupled(problem, &rows))
}

/// Not below a Lipschitz constant of the derivative `J` in the 2-norm, where no point is farther than `reach` from
/// the centre.
///
/// The sum of the sizes of all second derivatives of a polynomial is at most the second derivative of
/// the polynomial with positive signs, at the sizes of the coordinates, in the direction (1, …, 1).
pub fn lipschitz(problem: &Problem<'_>, reach: f64) -> Result<f64, NoProof> {
    let row = |row| {
        let size = |difference, shift| {
            let size = Magnitude(ball(difference, shift, reach).magnitude());
            Dual::<_, 1>::variable(Dual::<_, 1>::variable(size, 0), 0)
        };
        let second = problem.value(row, size)?.partials[0].partials[0].0.bound();
        let repeated = up((most_repeated(problem.places(row)) as f64).sqrt());
        Some(up(second * repeated / problem.at.lengths[row]))
    };
    problem.rows(row).map(|rows| coupled(problem, &rows))
}

/// How often the vertex that comes most often stands in a list.
pub fn most_repeated(places: &[VertexId]) -> usize {
    places.iter().map(|v| places.iter().filter(|w| *w == v).count()).max().unwrap_or(0)
}

/// Not below the norm of a linear map whose row `i` is at most `rows[i]` times the length of the part of
/// a vector that belongs to the points of equation `i`: since
/// `Σᵢ bᵢ² Σ_{v in i} |w_v|² ≤ max_v (Σ_{i at v} bᵢ²) |w|²`.
fn coupled(problem: &Problem<'_>, rows: &[f64]) -> f64 {
    let mut squares = vec![0.0; problem.mobility.len()];
    for (row, bound) in rows.iter().enumerate() {
        for v in problem.places(row).iter().filter(|v| problem.is_free(**v)) {
            let square = &mut squares[v.index()];
            *square = up(*square + bound * bound);
        }
    }
    up(largest(squares).sqrt())
}
