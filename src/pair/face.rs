//! Curvatures at faces of f-parallel pairs (17).

use std::fmt;

use rayon::prelude::*;

use super::{Curvatures, FParallel, Forms, Misfit, OffsetLaw, Which};
use crate::mesh::{FaceId, Mesh, Topology, VertexId};
use crate::scalar::Field;
use crate::space::{Point, TopView, Vector2};

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
        self.four.at_face().ok_or(ZeroArea(self.face))
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

/// H and K of all faces (17), in parallel; at memory speed in `f64`.
///
/// The meshes are given by their combinatorics and their points; nothing else is asked of them, so
/// that they are f-parallel is for [`FParallel`] to check, where numbers do not round.
///
/// # Errors
/// [`Misfit::Points`] for a list of points that is too short or too long; in the list, a face of
/// signed area 0.
pub fn face_curvatures<T: Field>(
    topology: &Topology,
    mesh: &[Point<T>],
    image: &[Point<T>],
) -> Result<Vec<Result<Curvatures<T>, ZeroArea>>, Misfit<T>> {
    for (which, points) in [(Which::Mesh, mesh), (Which::Image, image)] {
        if points.len() != topology.vertex_count() {
            return Err(Misfit::Points(which));
        }
    }
    let vector = |points: &[Point<T>], from: &Point<T>, to: VertexId| {
        let to = &points[to.index()];
        Vector2::new(&to.x - &from.x, &to.y - &from.y)
    };
    let curvatures = |face: FaceId| {
        let (first, rest) = topology.face(face).split_first().ok_or(ZeroArea(face))?;
        let (m, s) = (&mesh[first.index()], &image[first.index()]);
        let fan = rest.iter().map(|&v| (vector(mesh, m, v), vector(image, s, v)));
        Forms::of_fan(fan).at_face().ok_or(ZeroArea(face))
    };
    let faces = (0..topology.face_count() as u32).into_par_iter().with_min_len(4096);
    Ok(faces.map(|face| curvatures(FaceId(face))).collect())
}

fn top_views<T: Clone>(mesh: &Mesh<T>, face: FaceId) -> Vec<TopView<T>> {
    mesh.topology.face(face).iter().map(|v| mesh.points[v.index()].top_view()).collect()
}
