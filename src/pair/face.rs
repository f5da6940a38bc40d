//! Curvatures at faces of f-parallel pairs (17).

use std::fmt;

use super::{Curvatures, FParallel, Forms, OffsetLaw};
use crate::mesh::{FaceId, Mesh};
use crate::scalar::Field;
use crate::space::TopView;

/// Area, mixed area and area of the Gauss image of a face with any number of corners.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FaceForms<T> {
    /// The face.
    pub face: FaceId,
    /// `4 area(F)`, `4 area(F, S)`, `4 area(S)`.
    pub four: Forms<T>,
}

/// A face whose top view has signed area 0, though it may be no segment (a bow-tie): H and K are
/// not defined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ZeroArea(pub FaceId);

impl fmt::Display for ZeroArea {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "face {} has no curvature: its area in the top view is 0", self.0.0)
    }
}

impl std::error::Error for ZeroArea {}

impl<T: Field> FaceForms<T> {
    /// `area(F)` in the top view (15); positive if counter-clockwise.
    pub fn area(&self) -> T {
        &self.four.first * T::from_ratio(1, 4)
    }

    /// `area(F, S)` (16).
    pub fn mixed_area(&self) -> T {
        &self.four.mixed * T::from_ratio(1, 4)
    }

    /// `area(S)`.
    pub fn image_area(&self) -> T {
        &self.four.second * T::from_ratio(1, 4)
    }

    /// (17): `K = area(S) / area(F)` and `H = area(F, S) / area(F)`.
    ///
    /// # Errors
    /// Where `area(F) = 0`.
    pub fn curvatures(&self) -> Result<Curvatures<T>, ZeroArea> {
        let scale = self.four.first.try_inv().ok_or(ZeroArea(self.face))?;
        Ok(Curvatures { mean: &self.four.mixed * &scale, gauss: &self.four.second * scale })
    }

    /// How H and K of the offset faces `F + dS` depend on d (18).
    pub fn offset_law(&self) -> OffsetLaw<T> {
        OffsetLaw::new(self.four.clone())
    }
}

impl<T: Field> FParallel<'_, T> {
    /// The forms of a face (15), (16).
    pub fn face_forms(&self, face: FaceId) -> FaceForms<T> {
        let four = Forms::of(&top_views(self.mesh(), face), &top_views(self.image(), face));
        FaceForms { face, four }
    }

    /// H and K of a face (17).
    ///
    /// ```
    /// use isogeo::construct::translational_net;
    /// use isogeo::mesh::FaceId;
    /// use isogeo::pair::FParallel;
    /// use isogeo::scalar::{Field, Rational, Ring};
    /// use isogeo::space::{Scaling, Transform};
    /// let at = |x: i64| (Rational::from_i64(x), Rational::from_i64(x * x));
    /// let m = translational_net(&[at(0), at(1)], &[at(0), at(1)])?;
    /// let s = m.map(|c| c * Rational::from_i64(3)); // S = 3M: both principal curvatures are 3
    /// let h = FParallel::new(&m, &s).map(|pair| pair.face_curvatures(FaceId(0)).map(|c| c.mean));
    /// assert_eq!(h, Ok(Ok(Rational::from_i64(3))));
    /// # Ok::<(), isogeo::mesh::TopologyError>(())
    /// ```
    ///
    /// # Errors
    /// Where the signed area of the face is 0.
    pub fn face_curvatures(&self, face: FaceId) -> Result<Curvatures<T>, ZeroArea> {
        self.face_forms(face).curvatures()
    }
}

fn top_views<T: Clone>(mesh: &Mesh<T>, face: FaceId) -> Vec<TopView<T>> {
    mesh.topology.face(face).iter().map(|v| mesh.points[v.index()].top_view()).collect()
}
