//! Isotropic Koebe meshes: all edges touch the unit i-sphere Σ (Sec. 3.4, Theorem 3).
//!
//! Over a packing of circles that touch along the edges of a mesh, with another circle orthogonal to
//! those of every face, lies one such mesh: its vertices are the poles of the circles, its face
//! planes cut Σ over the face circles. The radii are kept with the mesh, as a certificate; only with
//! their signs do they tell which way a circle was turned by an inversion.

use crate::mesh::{Data, FaceId, FaceList, Mesh, NoPlane, Topology, TopologyError};
use crate::net::RADIUS;
use crate::scalar::{Field, Ring};
use crate::space::{Circle, Dual, OrientedCircle, Plane, TopView};

/// The mesh of the poles of circles, with the signed radii as data of the vertices.
///
/// Its edges touch Σ where the circles touch, and its faces are planar where the circles of a face
/// have a common orthogonal circle; neither is asked here: see
/// [`Property`](crate::net::Property)`::{Planar, Midscribed}`.
///
/// ```
/// use isogeo::construct::{koebe_mesh, quad_patch, square_packing};
/// let mesh = koebe_mesh(square_packing::<f64>(1, 1), quad_patch(1, 1))?;
/// assert_eq!(mesh.points[3].z, (1.0 + 1.0 - 0.25) / 2.0);
/// # Ok::<(), isogeo::mesh::TopologyError>(())
/// ```
///
/// # Errors
/// Where the faces form no mesh on these circles.
pub fn koebe_mesh<T: Field>(
    circles: Vec<OrientedCircle<T>>,
    faces: FaceList,
) -> Result<Mesh<T>, TopologyError> {
    Ok(poles(Topology::new(circles.len(), faces)?, circles))
}

/// The same on combinatorics with as many vertices as there are circles.
pub(super) fn poles<T: Field>(topology: Topology, circles: Vec<OrientedCircle<T>>) -> Mesh<T> {
    let points = circles.iter().map(OrientedCircle::pole).collect();
    let mut data = Data::default();
    data.vertex.insert(RADIUS.to_owned(), circles.into_iter().map(|c| c.radius).collect());
    Mesh { topology, points, data }
}

/// The circle of the top view over which a plane cuts Σ: orthogonal to those whose poles lie in it.
pub(super) fn section<T: Field>(plane: Plane<T>) -> Circle<T> {
    let centre = TopView::new(plane.gradient.x, plane.gradient.y);
    let radius2 = centre.norm2() + plane.height * T::from_i64(2);
    Circle::new(centre, radius2)
}

/// The vertex circles of a mesh, if it has radii: centres are the top views of the vertices.
pub fn vertex_circles<T: Ring>(mesh: &Mesh<T>) -> Option<Vec<OrientedCircle<T>>> {
    let radii = mesh.data.vertex.get(RADIUS)?;
    let circle = |(p, radius): (&crate::space::Point<T>, &T)| OrientedCircle {
        centre: p.top_view(),
        radius: radius.clone(),
    };
    (radii.len() == mesh.points.len()).then(|| mesh.points.iter().zip(radii).map(circle).collect())
}

/// The incircle of the top view of a face of a Koebe mesh: the circle over which its plane cuts Σ.
///
/// With the plane `z = p·x' + t` the centre is p and `ρ² = |p|² + 2t`. The radius itself, without a
/// root, is the height of the centre over an edge of length `r₀ + r₁`:
/// `ρ = det(v₁ − v₀, p − v₀)/(r₀ + r₁)`. It is positive where the face with positive radii runs
/// counter-clockwise.
///
/// `None` where the mesh has no radii or the first edge has length 0.
///
/// # Errors
/// A face without a plane.
pub fn face_circle<T: Field>(
    mesh: &Mesh<T>,
    face: FaceId,
) -> Result<Option<OrientedCircle<T>>, NoPlane<T>> {
    let centre = mesh.face_plane(face)?.gradient.dual();
    let radius = mesh.data.vertex.get(RADIUS).and_then(|radii| {
        let [a, b, ..] = mesh.topology.face(face) else { return None };
        let at = mesh.points[a.index()].top_view();
        let edge = &mesh.points[b.index()].top_view() - &at;
        let length = radii.get(a.index())? + radii.get(b.index())?;
        edge.det(&(&centre - &at)).try_div(&length)
    });
    Ok(radius.map(|radius| OrientedCircle { centre, radius }))
}

/// Schramm's equation for a circle ρ and the four circles that are orthogonal to it and touch in a
/// cycle: `ρ² (r₁ + r₂ + r₃ + r₄) − r₁ r₂ r₃ − r₂ r₃ r₄ − r₃ r₄ r₁ − r₄ r₁ r₂`, zero iff they fit.
///
/// So a packing with vertices of valence 4 is determined by its radii; vertices and faces change
/// roles, and radii their inverses.
///
/// ```
/// assert_eq!(isogeo::construct::schramm_residual(&1.0, [&1.0; 4]), 0.0);
/// assert_eq!(isogeo::construct::schramm_residual(&2.0, [&1.0; 4]), 12.0);
/// ```
pub fn schramm_residual<T: Ring>(radius: &T, [a, b, c, d]: [&T; 4]) -> T {
    let (ab, cd) = (a + b, c + d);
    radius.square() * (&ab + &cd) - a * b * cd - c * d * ab
}
