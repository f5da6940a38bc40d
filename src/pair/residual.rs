//! The residuals of pairs: polynomials in points of M and of S.
//!
//! Points of one mesh form a block, which may be translated by itself.

use super::{Forms, four_mixed_areas};
use crate::check::Residual;
use crate::scalar::Ring;
use crate::space::{Point, TopView, Vector3};

/// A component, x, y or z by number, of the cross product `(m₁ − m₀) × (s₁ − s₀)`: all vanish iff
/// the two edges are parallel.
///
/// The zero vector is parallel to everything.
#[derive(Clone, Copy, Debug)]
pub struct ParallelEdges(pub usize);

impl Residual<4> for ParallelEdges {
    const TRANSLATES: bool = true;
    const BLOCK: usize = 2;

    #[inline]
    fn eval<R: Ring>(self, [m0, m1, s0, s1]: &[Point<R>; 4], _: &R) -> R {
        let (e, d) = (m1 - m0, s1 - s0);
        match self.0 {
            0 => R::det2(&e.y, &e.z, &d.y, &d.z),
            1 => R::det2(&e.z, &e.x, &d.z, &d.x),
            _ => R::det2(&e.x, &e.y, &d.x, &d.y),
        }
    }
}

/// `det(m₁ − m₀, m₂ − m₀, s₁ − s₀)`: zero iff the line from `s₀` to `s₁` is parallel to the plane
/// through three points of M; positive if it rises to the side that sees them counter-clockwise.
#[derive(Clone, Copy, Debug)]
pub struct ParallelPlanes;

impl Residual<5> for ParallelPlanes {
    const TRANSLATES: bool = true;
    const BLOCK: usize = 3;

    #[inline]
    fn eval<R: Ring>(self, [m0, m1, m2, s0, s1]: &[Point<R>; 5], _: &R) -> R {
        Vector3::det(&(m1 - m0), &(m2 - m0), &(s1 - s0))
    }
}

/// `4 area(F, S)` of two triangles in the top view (16); that of polygons is the sum over a fan of
/// triangles. Zero for all faces of an i-minimal pair (19).
#[derive(Clone, Copy, Debug)]
pub struct MixedArea;

impl Residual<6> for MixedArea {
    const TRANSLATES: bool = true;
    const BLOCK: usize = 3;

    #[inline]
    fn eval<R: Ring>(self, points: &[Point<R>; 6], _: &R) -> R {
        four_mixed_areas(&triangle(points, 0), &triangle(points, 3))
    }
}

/// Compares a curvature (17) of two faces, each with its image, without division:
/// `16 (area(F, S) area(F₀) − area(F₀, S₀) area(F))` for H and the same with `area(S)` for K.
///
/// For triangles; that of polygons is the sum over the pairs of triangles of their fans. Zero iff
/// the curvatures agree, where both areas are not zero.
#[derive(Clone, Copy, Debug)]
pub enum SameCurvature {
    /// H, the quotient of mixed area and area.
    Mean,
    /// K, the quotient of the areas.
    Gauss,
}

impl Residual<12> for SameCurvature {
    const TRANSLATES: bool = true;
    const BLOCK: usize = 3;

    #[inline]
    fn eval<R: Ring>(self, points: &[Point<R>; 12], _: &R) -> R {
        let [f, g] = [0, 6].map(|i| Forms::of(&triangle(points, i), &triangle(points, i + 3)));
        match self {
            SameCurvature::Mean => R::det2(&f.mixed, &f.first, &g.mixed, &g.first),
            SameCurvature::Gauss => R::det2(&f.second, &f.first, &g.second, &g.first),
        }
    }
}

fn triangle<R: Ring, const K: usize>(points: &[Point<R>; K], start: usize) -> [TopView<R>; 3] {
    std::array::from_fn(|i| points[start + i].top_view())
}
