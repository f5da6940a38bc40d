//! Offsets M + dS, and their curvatures as functions of d (18).

use super::{Curvatures, FParallel, Forms, Parallel, Roots, VParallel};
use crate::mesh::{Data, Mesh};
use crate::scalar::{Field, RationalField, Ring};
use crate::space::Point;

/// H and K of the offset faces `F + dS`, seen with the same S, as rational functions of d (18).
///
/// Numerators and denominator are polynomials in d, given by ascending coefficients and four times
/// as large as the areas:
///
/// ```math
/// H(Fᵈ) = (area(F, S) + d area(S)) / (area(F) + 2d area(F, S) + d² area(S)),
/// K(Fᵈ) = area(S) / (area(F) + 2d area(F, S) + d² area(S)).
/// ```
///
/// This holds for every k-gon, also where `area(F) = 0` and H, K of F itself are not defined.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OffsetLaw<T> {
    four: Forms<T>,
}

impl<T: Ring> OffsetLaw<T> {
    pub(super) const fn new(four: Forms<T>) -> Self {
        OffsetLaw { four }
    }

    /// The numerator of H, of degree 1.
    pub fn mean_numerator(&self) -> [T; 2] {
        [self.four.mixed.clone(), self.four.second.clone()]
    }

    /// The numerator of K, a constant.
    pub fn gauss_numerator(&self) -> &T {
        &self.four.second
    }

    /// The common denominator, of degree 2: four times the area of the offset face.
    pub fn denominator(&self) -> [T; 3] {
        let Forms { first, mixed, second } = &self.four;
        [first.clone(), mixed * T::from_i64(2), second.clone()]
    }
}

impl<T: Field> OffsetLaw<T> {
    /// H and K at a distance, from the formula; `None` at a critical one.
    pub fn at(&self, d: &T) -> Option<Curvatures<T>> {
        let Forms { first, mixed, second } = self.four.offset(d);
        let scale = first.try_inv()?;
        Some(Curvatures { mean: mixed * &scale, gauss: second * scale })
    }
}

impl<T: RationalField> OffsetLaw<T> {
    /// The critical distances, at which the area of the offset face vanishes: `−1/κ` for the
    /// principal curvatures κ that are not 0.
    pub fn critical(&self) -> Roots<T> {
        Roots::of(&self.four.second, &self.four.mixed, &self.four.first)
    }
}

impl<T: Ring> Parallel<'_, T> {
    /// The offset `M + dS`, vertex by vertex: parallel to M and to S.
    pub fn offset(&self, d: &T) -> Mesh<T> {
        sum(self.mesh(), self.image(), d)
    }
}

impl<T: Field> FParallel<'_, T> {
    /// The offset `M + dS`, vertex by vertex: its faces are parallel to those of M and of S, but
    /// for critical d they may degenerate.
    pub fn offset(&self, d: &T) -> Mesh<T> {
        sum(self.mesh(), self.image(), d)
    }
}

impl<T: Field> VParallel<'_, T> {
    /// The offset in the vertical sense: the points `(m', z_m + d z_s)`, v-parallel to M and to S.
    pub fn offset(&self, d: &T) -> Mesh<T> {
        combined(self.mesh(), self.image(), |m, s| {
            Point::new(m.x.clone(), m.y.clone(), &m.z + d * &s.z)
        })
    }
}

fn sum<T: Ring>(mesh: &Mesh<T>, image: &Mesh<T>, d: &T) -> Mesh<T> {
    combined(mesh, image, |m, s| Point::new(&m.x + d * &s.x, &m.y + d * &s.y, &m.z + d * &s.z))
}

fn combined<T: Clone>(
    mesh: &Mesh<T>,
    image: &Mesh<T>,
    point: impl Fn(&Point<T>, &Point<T>) -> Point<T>,
) -> Mesh<T> {
    let points = mesh.points.iter().zip(&image.points).map(|(m, s)| point(m, s)).collect();
    Mesh { topology: mesh.topology.clone(), points, data: Data::default() }
}
