//! The plane of a face.

use std::fmt;

use super::{FaceId, Mesh};
use crate::scalar::Field;
use crate::space::{Plane, Point};

/// Why a face has no plane `z = p·x' + t`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoPlane<T> {
    /// Its points do not lie in the plane that three of them span.
    NotPlanar {
        /// The face.
        face: FaceId,
        /// How far the first other point lies above that plane, exactly.
        residual: T,
    },
    /// The top views of its points are collinear: the face is vertical or collinear itself.
    NotAGraph(FaceId),
}

impl<T> NoPlane<T> {
    /// The same with `f` applied to every number.
    pub fn map<S>(&self, f: impl Fn(&T) -> S) -> NoPlane<S> {
        match self {
            NoPlane::NotPlanar { face, residual } => {
                NoPlane::NotPlanar { face: *face, residual: f(residual) }
            }
            NoPlane::NotAGraph(face) => NoPlane::NotAGraph(*face),
        }
    }
}

impl<T: fmt::Display> fmt::Display for NoPlane<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoPlane::NotPlanar { face, residual } => write!(
                f,
                "face {} is not planar: a vertex lies {residual} above the plane of three others",
                face.0
            ),
            NoPlane::NotAGraph(face) => write!(f, "face {} is vertical or collinear", face.0),
        }
    }
}

impl<T: fmt::Debug + fmt::Display> std::error::Error for NoPlane<T> {}

impl<T: Field> Mesh<T> {
    /// The plane of a face: through three of its points, checked at the others.
    ///
    /// # Errors
    /// Where there is none, or it is isotropic.
    pub fn face_plane(&self, face: FaceId) -> Result<Plane<T>, NoPlane<T>> {
        let corners: Vec<&Point<T>> =
            self.topology.face(face).iter().map(|v| &self.points[v.index()]).collect();
        let plane = spanning_plane(&corners).ok_or(NoPlane::NotAGraph(face))?;
        // A triangle is planar, whatever the rounding of its plane.
        let checked = if corners.len() > 3 { corners.as_slice() } else { &[] };
        match checked.iter().map(|p| plane.residual(p)).find(|r| !r.is_zero()) {
            None => Ok(plane),
            Some(residual) => Err(NoPlane::NotPlanar { face, residual }),
        }
    }
}

/// The plane through three points whose top views are not collinear: three in a row if possible.
pub(crate) fn spanning_plane<T: Field>(points: &[&Point<T>]) -> Option<Plane<T>> {
    let in_a_row = points.windows(3).find_map(|p| Plane::through(p[0], p[1], p[2]).ok());
    in_a_row.or_else(|| {
        let (first, rest) = points.split_first()?;
        let second = rest.iter().find(|p| !p.is_parallel_to(first))?;
        rest.iter().find_map(|p| Plane::through(first, second, p).ok())
    })
}
