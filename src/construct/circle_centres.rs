//! The top view of an i-conical mesh as centres of a circle pattern (Theorem 2), and whether it is a
//! Voronoi diagram.
//!
//! An i-conical mesh is v-parallel to circumscribed meshes S₁, see
//! [`circumscribed_v_parallel`](super::circumscribed_v_parallel()). Let `x_f` be the top view of the point where
//! the face f of S₁ touches Σ: its plane has the height `(|x'|² − |x' − x_f|²)/2` over `x'`. So the
//! faces around a vertex v have *sites* `x_f` on one circle about `v'`, with `R² = |v'|² − 2z`; an edge lies on
//! the bisector of the sites of its faces, and the line through the two sites is the radical axis
//! of the circles at its ends.
//!
//! It is the Voronoi diagram of the sites only where no circle has a site inside, which is where S₁ lies
//! nowhere below a plane of its own: where it is convex.

use std::fmt;

use rayon::prelude::*;

use crate::mesh::{FaceId, Mesh, NoPlane, VertexId};
use crate::scalar::{Field, Ordered, Sign};
use crate::space::{Circle, Dual, TopView};

/// The circles about the top views of the vertices of a circumscribed mesh, and the sites that they pass
/// through.
#[derive(Clone, Debug, PartialEq)]
pub struct CircleCentres<T> {
    /// For every face the top view of its point on Σ.
    pub sites: Vec<TopView<T>>,
    /// For every vertex the circle about it through the sites of its faces; its squared radius is
    /// not negative. A vertex without faces has a circle of any kind.
    pub circles: Vec<Circle<T>>,
}

/// Why a mesh is not circumscribed.
#[derive(Clone, Debug, PartialEq)]
pub enum NotCircumscribed<T> {
    /// A face without a plane, or with an isotropic one.
    Plane(NoPlane<T>),
    /// A face whose plane does not touch Σ.
    Face {
        /// The face.
        face: FaceId,
        /// `|p|² + 2t` for its gradient p and height t, exactly.
        residual: T,
    },
}

impl<T: fmt::Display> fmt::Display for NotCircumscribed<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NotCircumscribed::Plane(reason) => reason.fmt(f),
            NotCircumscribed::Face { face, residual } => {
                write!(f, "face {} does not touch the unit i-sphere: residual {residual}", face.0)
            }
        }
    }
}

impl<T: fmt::Debug + fmt::Display> std::error::Error for NotCircumscribed<T> {}

/// A site inside of a circle about a vertex.
#[derive(Clone, Debug, PartialEq)]
pub struct Intruder<T> {
    /// The vertex.
    pub vertex: VertexId,
    /// The face with that site.
    pub face: FaceId,
    /// The power of the site with respect to the circle, negative: twice the height of the vertex
    /// over the plane of the face.
    pub power: T,
}

impl<T: Field> CircleCentres<T> {
    /// The pattern of a circumscribed mesh.
    ///
    /// ```
    /// use isogeo::construct::{CircleCentres, circumscribed_v_parallel, translational_net};
    /// use isogeo::mesh::FaceId;
    /// use isogeo::scalar::{Field, Rational, Ring};
    /// use isogeo::space::TopView;
    /// let profile: Vec<_> = (0..4).map(|i| (Rational::from_i64(i), Rational::from_i64(i * i))).collect();
    /// let m = translational_net(&profile, &profile)?;
    /// let at = |x| TopView::new(Rational::from_ratio(x, 2), Rational::from_ratio(1, 2));
    /// let inside = circumscribed_v_parallel(&m, FaceId(0), &at(1))?;
    /// assert_eq!(CircleCentres::new(inside.image())?.intruder(), None); // unit squares about their middles
    /// let beside = circumscribed_v_parallel(&m, FaceId(0), &at(3))?;
    /// assert!(CircleCentres::new(beside.image())?.intruder().is_some());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// A face without a plane, or whose plane does not touch Σ. In `f64` that is never found to be so.
    pub fn new(mesh: &Mesh<T>) -> Result<Self, NotCircumscribed<T>> {
        let two = T::from_i64(2);
        let site = |face: FaceId| {
            let plane = mesh.face_plane(face).map_err(NotCircumscribed::Plane)?;
            let site = plane.gradient.dual();
            let residual = site.norm2() + plane.height * &two;
            if residual.is_zero() {
                Ok(site)
            } else {
                Err(NotCircumscribed::Face { face, residual })
            }
        };
        let circle = |v: VertexId| {
            let point = &mesh.points[v.index()];
            let centre = point.top_view();
            let radius2 = centre.norm2() - &two * &point.z;
            Circle::new(centre, radius2)
        };
        Ok(CircleCentres {
            sites: mesh.topology.faces().map(site).collect::<Result<_, _>>()?,
            circles: mesh.topology.vertices().map(circle).collect(),
        })
    }
}

impl<T: Field + Ordered> CircleCentres<T> {
    /// The first vertex whose circle has sites inside, with the first of these; `None` if all circles
    /// are empty.
    ///
    /// With empty circles, every face without boundary edges whose top view is a simple polygon without
    /// straight corners is the Voronoi cell of its site among all sites: its vertices lie in the cell, which is
    /// convex, and its edges on the boundary. That is decided for the whole mesh, not edge by edge, so it needs no
    /// convex boundary, and the product of the numbers of vertices and faces in time.
    /// Isolated vertices count as well.
    pub fn intruder(&self) -> Option<Intruder<T>> {
        let inside = |(v, circle): (usize, &Circle<T>)| {
            self.sites.iter().enumerate().find_map(|(f, site)| {
                let power = circle.power(site);
                let (vertex, face) = (VertexId(v as u32), FaceId(f as u32));
                let negative = power.certain_sign() == Some(Sign::Negative);
                negative.then_some(Intruder { vertex, face, power })
            })
        };
        self.circles.par_iter().enumerate().find_map_first(inside)
    }
}
