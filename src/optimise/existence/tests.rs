//! Bounds against samples of what they bound.

use super::bounds::{deviation, lipschitz, residual};
use super::eigenvalue::{bound, guess};
use super::factor::misfit;
use super::problem::Problem;
use super::rounding::{down, gamma, largest, up};
use crate::construct::quad_patch;
use crate::mesh::Topology;
use crate::optimise::normal::NormalMatrix;
use crate::optimise::{Goal, Mobility};
use crate::scalar::{BigRational, Numeral, Ordered};
use crate::space::{Point, Vector3};

const N: usize = 4;

/// A number in [-1, 1), one of many.
fn number(k: usize) -> f64 {
    2.0 * ((k as f64 + 0.5).sqrt() * 1e4).fract() - 1.0
}

fn points() -> Vec<Point<f64>> {
    let grid = (0..=N).flat_map(|i| (0..=N).map(move |j| (i as f64, j as f64)));
    let point = |(k, (x, y))| {
        let shift = |i: usize| 0.05 * number(3 * k + i);
        Point::new(x + shift(0), y + shift(1), x * x / 4.0 - x * y / 8.0 + shift(2))
    };
    grid.enumerate().map(point).collect()
}

fn topology() -> Topology {
    Topology::new((N + 1) * (N + 1), quad_patch(N, N)).expect("a patch is a mesh")
}

fn problem(points: &[Point<f64>], goal: Goal) -> Problem<'_> {
    let mobility = vec![Mobility::Free; points.len()];
    Problem::new(&topology(), points, goal, mobility).expect("conditions")
}

fn vectors(seed: usize) -> Vec<Vector3<f64>> {
    let vector = |k: usize| {
        let k = 1000 * seed + 3 * k;
        Vector3::new(number(k), number(k + 1), number(k + 2))
    };
    (0..(N + 1) * (N + 1)).map(vector).collect()
}

fn near_a_face(mut vectors: Vec<Vector3<f64>>, seed: usize) -> Vec<Vector3<f64>> {
    let (i, j) = (seed % N, seed / N % N);
    let near = |k: usize| (k / (N + 1)).wrapping_sub(i) < 2 && (k % (N + 1)).wrapping_sub(j) < 2;
    let zero = Vector3::new(0.0, 0.0, 0.0);
    (0..vectors.len()).filter(|&k| !near(k)).for_each(|k| vectors[k] = zero);
    vectors
}

fn size(vectors: &[Vector3<f64>]) -> f64 {
    vectors.iter().map(Vector3::length2).sum::<f64>().sqrt()
}

fn moved(points: &[Point<f64>], by: &[Vector3<f64>], factor: f64) -> Vec<Point<f64>> {
    let moved = |(p, v): (&Point<f64>, &Vector3<f64>)| {
        Point::new(p.x + factor * v.x, p.y + factor * v.y, p.z + factor * v.z)
    };
    points.iter().zip(by).map(moved).collect()
}

/// `J w` at other points, divided by the lengths of the problem.
fn slopes(problem: &Problem<'_>, at: &[Point<f64>], w: &[Vector3<f64>]) -> Vec<f64> {
    let own = problem.system.linearise(at, &problem.mobility);
    let slopes = problem.system.times(&own, w);
    let scaled = |(row, slope)| slope * own.lengths[row] / problem.at.lengths[row];
    slopes.into_iter().enumerate().map(scaled).collect()
}

fn norm(values: impl Iterator<Item = f64>) -> f64 {
    values.map(|x| x * x).sum::<f64>().sqrt()
}

#[test]
fn derivatives_change_less_than_the_bound_says() {
    let points = points();
    for goal in [Goal::Planar, Goal::ICircular, Goal::IConical, Goal::Circular] {
        let problem = problem(&points, goal);
        let reach = 0.125;
        let bound = lipschitz(&problem, reach).expect("polynomials");
        let mut most: f64 = 0.0;
        for seed in 0..50 {
            // What changes most is near a face.
            let [x, y, w] = [1, 2, 3].map(|i| near_a_face(vectors(3 * seed + i), seed));
            let at = |v: &[Vector3<f64>]| moved(&points, v, reach / size(v));
            let (p, q) = (at(&x), at(&y));
            let way: Vec<_> = p.iter().zip(&q).map(|(p, q)| q - p).collect();
            let (before, after) = (slopes(&problem, &p, &w), slopes(&problem, &q, &w));
            let change = norm(before.iter().zip(&after).map(|(a, b)| a - b));
            most = most.max(change / (size(&way) * size(&w)));
        }
        assert!(most <= bound, "{goal:?}: {most} is above {bound}");
        // Not a bound of anything.
        assert!(most > bound / 1000.0, "{goal:?}: {most} is far below {bound}");
    }
}

#[test]
fn a_centre_that_is_elsewhere_deviates_and_has_residuals() {
    let points = points();
    for goal in [Goal::Planar, Goal::ICircular, Goal::IConical, Goal::Circular] {
        let mut problem = problem(&points, goal);
        assert!(deviation(&problem).expect("polynomials") < 1024.0 * f64::EPSILON);
        // At the points themselves doubles know the residuals.
        let observed = norm(problem.at.residuals.iter().copied());
        let bounded = residual(&problem).expect("polynomials");
        assert!(
            (bounded / observed - 1.0).abs() < f64::EPSILON.sqrt(),
            "{goal:?}: {bounded} {observed}"
        );
        problem.shifts = vectors(7).iter().map(|v| v.scaled(&0.01)).collect();
        let there = moved(&points, &problem.shifts, 1.0);
        let w = vectors(8);
        let change = slopes(&problem, &there, &w);
        let change = norm(change.iter().zip(slopes(&problem, &points, &w)).map(|(a, b)| a - b));
        let bound = deviation(&problem).expect("polynomials");
        assert!(change / size(&w) <= bound && bound < 1.0, "{goal:?}: {bound}");
        let observed = problem.system.residuals(&there, &problem.at.lengths);
        let observed = norm(observed.into_iter());
        let bounded = residual(&problem).expect("polynomials");
        assert!(
            (bounded / observed - 1.0).abs() < f64::EPSILON.sqrt(),
            "{goal:?}: {bounded} {observed}"
        );
    }
}

#[test]
fn the_bound_of_the_smallest_eigenvalue_is_below_it() {
    let points = points();
    for goal in [Goal::Planar, Goal::ICircular, Goal::IConical] {
        let problem = problem(&points, goal);
        let mut matrix = NormalMatrix::new(&problem.system, points.len());
        let mut factor = matrix.analyse(&problem.system, &points).expect("memory");
        matrix.fill(&problem.system, &problem.at, 0.0);
        factor.factorise(&matrix.starts, &matrix.rows, &matrix.values).expect("a factor");
        let guess = guess(&mut factor, problem.system.rows());
        let bound = bound(&problem, &mut matrix, &mut factor, guess).expect("a bound");
        let (guess, _) = guess;
        assert!(bound < guess && bound > guess / 4.0, "{goal:?}: {bound} {guess}");
        // A claim above the eigenvalue finds no factor, or one that is far away.
        matrix.fill(&problem.system, &problem.at, -2.0 * guess);
        assert!(factor.factorise(&matrix.starts, &matrix.rows, &matrix.values).is_err());
    }
}

#[test]
fn a_spoilt_factor_is_noticed() {
    let points = points();
    let problem = problem(&points, Goal::ICircular);
    let mut matrix = NormalMatrix::new(&problem.system, points.len());
    let mut factor = matrix.analyse(&problem.system, &points).expect("memory");
    matrix.fill(&problem.system, &problem.at, 0.0);
    factor.factorise(&matrix.starts, &matrix.rows, &matrix.values).expect("a factor");
    let found = misfit(&matrix, &factor, 15, 10.0).expect("a factor");
    assert!(found < 4096.0 * f64::EPSILON, "{found}");
    let spoil = 1.0 / 1024.0;
    let mut counted = 0;
    for place in 0..factor.values.len() {
        let value = factor.values[place];
        factor.values[place] = f64::NAN;
        // What stands above the diagonal of a block means nothing.
        if misfit(&matrix, &factor, 15, 10.0).expect("a factor").is_nan() {
            counted += 1;
            factor.values[place] = value + spoil;
            let spoilt = misfit(&matrix, &factor, 15, 10.0).expect("a factor");
            assert!(spoilt > spoil / 2.0 * value.abs().min(0.1), "{place}: {spoilt}");
        }
        factor.values[place] = value;
    }
    // Where the matrix has an entry, so has the factor.
    assert!(counted >= matrix.values.len(), "{counted} of {}", matrix.values.len());
    matrix.values[17] += spoil;
    assert!(misfit(&matrix, &factor, 15, 10.0).expect("a factor") > spoil);
}

#[test]
fn bounds_are_rounded_outwards() {
    let exact = |x: f64| Numeral::from_f64(x).expect("finite").value::<BigRational>();
    for k in 0..1000 {
        let (x, y) = (number(k).abs(), number(k + 5000).abs());
        let (sum, product) = (exact(x) + exact(y), exact(x) * exact(y));
        assert!(exact(up(x + y)) > sum && exact(down(x + y)) < sum);
        assert!(exact(up(x * y)) > product && exact(down(x * y)) < product);
        assert!(exact(up(x * y)) < product.magnitude() * exact(1.0 + 16.0 * f64::EPSILON));
    }
    assert!(gamma(1) > f64::EPSILON / 2.0 && gamma(1) < f64::EPSILON);
    assert_eq!(gamma(usize::MAX), f64::INFINITY);
    assert_eq!(largest([1.0, 3.0, 2.0]), 3.0);
    assert!(largest([1.0, f64::NAN, 2.0]).is_nan());
    assert!(largest([f64::INFINITY, f64::NAN]).is_nan());
}
