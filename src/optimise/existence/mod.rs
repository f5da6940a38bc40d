//! Proofs that an exact mesh is near.
//!
//! An optimisation in doubles ends where conditions hold up to rounding; no coordinate of the mesh that is meant may
//! be a double. Still its existence can be proved, and how near it is.
//!
//! Let `c` be the conditions, each divided by the length of its gradient, `x̃` the points in doubles and
//! `J̃` a matrix in doubles near the derivative `J` of `c`, whose columns of pinned vertices are 0. Near `x̃`
//! there is a centre `x̂`, not in doubles, where `c` is as small as some 30 digits allow. The mesh is looked for at
//! `x̂ + M u` with `M = J̃ᵀ (J̃ J̃ᵀ)⁻¹`: pinned vertices stay, and `F(u) = c(x̂ + M u)` has as many
//! equations as unknowns. Verified bounds in the 2-norm are known of
//!
//! - `σ`, not above the smallest singular value of `J̃`, so that `|M| ≤ 1/σ`;
//! - `r ≥ |c(x̂)|`, evaluated over pairs of doubles;
//! - `q ≥ |J(x̂) − J̃| / σ`, so that `|F′(0)⁻¹| ≤ β = 1/(1 − q)` where `q < 1`, since `J̃ M` is the unit matrix;
//! - `L`, a Lipschitz constant of `J` within `ρ = 2 β r / σ` of `x̂`, so that `L / σ²` is one of `F′`.
//!
//! If `h = β² L r / σ² ≤ 1/2`, the theorem of Newton and Kantorovich gives a zero of `F` with `|u| ≤ 2 β r`
//! (J. M. Ortega, The Newton-Kantorovich theorem, Amer. Math. Monthly 75, 1968). So there are real
//! points for which all conditions vanish, and no vertex of theirs is farther than `ρ` from that of `x̂`.
//!
//! ```
//! use isogeo::mesh::{FaceList, Mesh};
//! use isogeo::optimise::Goal;
//! use isogeo::optimise::existence::{Pinned, prove};
//! use isogeo::space::Point;
//! // One corner of a square is lifted by the rounding of a tenth.
//! let third = 0.1 + 0.2 - 0.3;
//! let at = |x, y, z| Point::new(x, y, z);
//! let points = vec![at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0), at(1.0, 1.0, third), at(0.0, 1.0, 0.0)];
//! let mut faces = FaceList::new();
//! faces.push([0, 1, 2, 3]);
//! let mesh = Mesh::new(points, faces)?;
//! let exact = prove(&mesh.topology, &mesh.points, Goal::ICircular, &Pinned::Nothing)?;
//! assert!(third / 5.0 < exact.radius && exact.radius < third);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bounds;
mod certificate;
mod eigenvalue;
mod factor;
mod no_proof;
mod pinned;
mod problem;
mod rounding;
mod shape;
#[cfg(test)]
mod tests;

pub use certificate::{Certificate, NotVerified};
pub use no_proof::NoProof;
pub use pinned::Pinned;

use super::Goal;
use super::normal::NormalMatrix;
use crate::mesh::Topology;
use crate::space::Point;
use problem::Problem;
use rounding::{down, largest, length, up};

/// An exact mesh that has a property, near one in doubles. All numbers are bounds, rounded upwards (the
/// singular value downwards), in the unit of the mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Existence {
    /// No vertex of the mesh is farther than that from the same vertex of the exact mesh.
    pub radius: f64,
    /// The same for all vertices together: the root of the sum of the squares of the distances.
    pub distance: f64,
    /// The number of equations.
    pub equations: usize,
    /// `σ`, not above the smallest singular value of the matrix of unit gradients.
    pub singular_value: f64,
    /// `r`, the size of the residuals at the centre, to first order the distances to where they vanish.
    pub residual: f64,
    /// `ρ`, how far no vertex of the exact mesh is from that of the centre.
    pub reach: f64,
    /// `q`, how much the derivative at the centre differs from the matrix, over `σ`.
    pub deviation: f64,
    /// `L`, the Lipschitz constant of the derivative.
    pub lipschitz: f64,
    /// `h`, which must not exceed 1/2.
    pub contraction: f64,
}

/// Proves that a mesh with a property lies near one in doubles, where some vertices do not move.
///
/// The mesh has planar faces, too, as every goal asks for them. The cost is that of two or three sparse
/// factorisations, and of one sparse product of the last factor with its transpose.
///
/// # Errors
/// Why there is no proof; see [`NoProof`].
pub fn prove(
    topology: &Topology,
    points: &[Point<f64>],
    goal: Goal,
    pinned: &Pinned,
) -> Result<Existence, NoProof> {
    if !shape::is_asked(topology, goal) {
        return Err(NoProof::Vacuous);
    }
    let mobility = pinned.mobility(topology)?;
    let mut problem = Problem::new(topology, points, goal, mobility)?;
    let equations = problem.system.rows();
    let mut matrix = NormalMatrix::new(&problem.system, points.len());
    let factor = matrix.analyse(&problem.system, points);
    let mut factor = factor.map_err(|_| NoProof::OutOfMemory)?;
    let mut factorise = |damping: f64| {
        matrix.fill(&problem.system, &problem.at, damping);
        factor.factorise(&matrix.starts, &matrix.rows, &matrix.values)
    };
    if factorise(0.0).is_err() {
        let row = match factorise(f64::EPSILON.sqrt()) {
            Ok(()) => eigenvalue::guess(&mut factor, equations).1,
            Err(_) => 0,
        };
        return Err(problem.dependent(row, 0.0, f64::EPSILON));
    }
    let guess = eigenvalue::guess(&mut factor, equations);
    problem.approach(&mut factor)?;
    let smallest = eigenvalue::bound(&problem, &mut matrix, &mut factor, guess)?;

    let singular_value = down(smallest.sqrt());
    let residual = bounds::residual(&problem)?;
    let deviation = up(bounds::deviation(&problem)? / singular_value);
    let margin = down(1.0 - deviation);
    // What is not a number is no proof.
    let is_invertible = margin > 0.0;
    if !is_invertible {
        return Err(NoProof::TooFar { deviation, contraction: f64::INFINITY });
    }
    let inverse = up(1.0 / margin);
    let reach = up(2.0 * inverse * residual / singular_value);
    let lipschitz = bounds::lipschitz(&problem, reach)?;
    let contraction = up(inverse * inverse * lipschitz * residual / smallest);
    let is_near = contraction <= 0.5;
    if !is_near {
        return Err(NoProof::TooFar { deviation, contraction });
    }
    shape::is_as_asked(&problem, topology, goal, reach)?;
    let moved = || problem.shifts.iter().map(|s| length([s.x, s.y, s.z]));
    Ok(Existence {
        radius: up(largest(moved()) + reach),
        distance: up(length(moved()) + reach),
        equations,
        singular_value,
        residual,
        reach,
        deviation,
        lipschitz,
        contraction,
    })
}
