//! From isotropic to Euclidean space: circles of faces to cones of revolution at vertices.

use super::{AXIS_DATA, NoTransfer, PLANE_DATA};
use crate::construct::koebe::section;
use crate::mesh::{Data, FaceId, Mesh, NoPlane, VertexId};
use crate::scalar::{Field, Ordered, Sign};
use crate::space::laguerre::{Cone, OrientedPlane};
use crate::space::{ICircle, Point, Vector3};

/// A Euclidean mesh N with its Gauss image S: parallel, and tangent to the unit sphere.
///
/// The vertices of S are the axes of the cones at the vertices of N, so the planes or edges of
/// N + dS have the constant distance d from those of N.
#[derive(Clone, Debug, PartialEq)]
pub struct EuclideanImage<T> {
    /// The mesh N.
    pub mesh: Mesh<T>,
    /// The mesh S: its faces or edges touch the unit sphere.
    pub gauss: Mesh<T>,
}

/// The conical mesh τ(M) of an i-circular mesh M (Remark 1).
///
/// The vertices are those of the cones that belong to the circumcircles of the faces, see
/// [`Cone::of_isotropic`]; the face planes are [`OrientedPlane::of_isotropic`] of the interior
/// vertices, and stand as data on the faces under the names [`PLANE_DATA`]. The faces of the Gauss
/// image touch the unit sphere: `n·s = 1`.
///
/// Where the surface that N stands for has singularities, the faces of N run against their oriented
/// planes, see [`EuclideanImage::turned_faces`]; [offsets](EuclideanImage::offset) at another distance are free
/// of them.
///
/// ```
/// use isogeo::construct::transfer::conical_image;
/// use isogeo::construct::translational_net;
/// use isogeo::scalar::{Rational, Ring};
/// let q = |n: i64| Rational::from_i64(n);
/// let profile: Vec<_> = (0..4).map(|i| (q(i), q(i * i))).collect();
/// let conical = conical_image(&translational_net(&profile, &profile)?)?.mesh;
/// assert_eq!((conical.topology.vertex_count(), conical.topology.face_count()), (9, 4));
/// // The plane of vertex (1, 1, 2) of M: n = (2, 2, −1)/3.
/// assert_eq!(conical.data.face["n3"][0].to_string(), "-1/3");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// A face that is not i-circular, or whose circle stands for a great circle; dual combinatorics that
/// are no mesh. In `f64` larger faces than triangles are never found to be i-circular.
pub fn conical_image<T: Field>(mesh: &Mesh<T>) -> Result<EuclideanImage<T>, NoTransfer<T>> {
    let mut image = by_circles(mesh, |_| T::zero())?;
    let planes = mesh.topology.interior_vertices();
    let planes: Vec<_> =
        planes.map(|v| OrientedPlane::of_isotropic(&mesh.points[v.index()])).collect();
    let numbers: [fn(&OrientedPlane<T>) -> &T; 4] =
        [|p| &p.normal().x, |p| &p.normal().y, |p| &p.normal().z, OrientedPlane::height];
    for (name, number) in PLANE_DATA.into_iter().zip(numbers) {
        let column = planes.iter().map(|plane| number(plane).clone()).collect();
        image.mesh.data.face.insert(name.to_owned(), column);
    }
    Ok(image)
}

/// The edge-offset mesh τ(M) of an i-isothermic mesh M (Remark 2), whose vertices carry circles of
/// the top view with signed radii: they touch along edges, and each face has a circle orthogonal to
/// those of its vertices, its incircle.
///
/// The vertices are those of the cones that belong to the incircles; the edges of the Gauss image
/// touch the unit sphere. A vertex v of M with the radius r becomes a face in the plane
/// `2v₁x + 2v₂y + (1 − n)z + 2v₃ = 0` with `n = |v'|² − r²`, which is that of (12) if `r = 0`. That plane
/// alone does not tell the scale of its numbers, so the vertices of the Gauss image are kept as data
/// on the vertices, under the names [`AXIS_DATA`].
///
/// # Errors
/// Vertex circles that do not touch or have no common orthogonal circle, a face that is not planar or
/// whose circle stands for a great circle, dual combinatorics that are no mesh.
pub fn edge_offset_image<T: Field>(
    mesh: &Mesh<T>,
    radii: &[T],
) -> Result<EuclideanImage<T>, NoTransfer<T>> {
    if radii.len() != mesh.topology.vertex_count() {
        return Err(NoTransfer::NoRadii);
    }
    for edge in mesh.topology.edges() {
        let edge = [mesh.topology.origin(edge), mesh.topology.target(edge)];
        let [v, w] = edge.map(VertexId::index);
        let distance2 = mesh.points[v].i_distance2(&mesh.points[w]);
        let residual = distance2 - (&radii[v] + &radii[w]).square();
        if !residual.is_zero() {
            return Err(NoTransfer::NotTouching { edge, residual });
        }
    }
    let mut image = by_circles(mesh, |v| radii[v.index()].square())?;
    let numbers: [fn(&Point<T>) -> &T; 3] = [|s| &s.x, |s| &s.y, |s| &s.z];
    for (name, number) in AXIS_DATA.into_iter().zip(numbers) {
        let column = image.gauss.points.iter().map(|s| number(s).clone()).collect();
        image.mesh.data.vertex.insert(name.to_owned(), column);
    }
    Ok(image)
}

/// The cones of the circles that are orthogonal to circles around the vertices: the circumcircles
/// if their radii are 0.
fn by_circles<T: Field>(
    mesh: &Mesh<T>,
    radius2: impl Fn(VertexId) -> T,
) -> Result<EuclideanImage<T>, NoTransfer<T>> {
    // Over the plane z = c·x − N/2 lies the circle orthogonal to all whose lifts are in it.
    let half = T::from_ratio(1, 2);
    let lifted = |v: VertexId| {
        let at = mesh.points[v.index()].top_view();
        at.at_height((at.norm2() - radius2(v)) * &half)
    };
    let points = mesh.topology.vertices().map(lifted).collect();
    let lift = Mesh { topology: mesh.topology.clone(), points, data: Data::default() };
    let cone = |face: FaceId| {
        let plane = mesh.face_plane(face)?;
        let top_view = lift.face_plane(face).map(section).map_err(|reason| match reason {
            NoPlane::NotPlanar { face, residual } => NoTransfer::NoCircle { face, residual },
            reason => reason.into(),
        })?;
        Cone::of_isotropic(&ICircle { plane, top_view }).map_err(|_| NoTransfer::Cylinder(face))
    };
    let cones = mesh.topology.faces().map(cone).collect::<Result<Vec<_>, NoTransfer<T>>>()?;
    let topology = mesh.topology.dual()?.topology;
    let mesh_of = |points| Mesh { topology: topology.clone(), points, data: Data::default() };
    let (vertices, axes) = cones
        .into_iter()
        .map(|Cone { vertex, axis: Vector3 { x, y, z } }| (vertex, Point::new(x, y, z)))
        .unzip();
    Ok(EuclideanImage { mesh: mesh_of(vertices), gauss: mesh_of(axes) })
}

impl<T: Field> EuclideanImage<T> {
    /// The offset N + dS at the distance d on the side of the normals: `h ↦ h − d`.
    pub fn offset(mut self, d: &T) -> Self {
        for (point, axis) in self.mesh.points.iter_mut().zip(&self.gauss.points) {
            *point = &*point + &Vector3::new(d * &axis.x, d * &axis.y, d * &axis.z);
        }
        if let Some(heights) = self.mesh.data.face.get_mut(PLANE_DATA[3]) {
            heights.iter_mut().for_each(|h| *h -= d);
        }
        self
    }
}

impl<T: Field + Ordered> EuclideanImage<T> {
    /// The faces of a conical image that run clockwise, seen against their normals.
    ///
    /// All or none is a question of orientation; where some are among others, N passes through a
    /// singularity, and as a mesh of oriented faces it is not conical there.
    pub fn turned_faces(&self) -> Vec<FaceId> {
        let data = &self.mesh.data.face;
        let [n1, n2, n3, _] = PLANE_DATA;
        let columns = [n1, n2, n3].map(|name| data.get(name).map_or(&[][..], Vec::as_slice));
        let turned = |face: &FaceId| {
            let Vector3 { x, y, z } = super::isotropic::vector_area(&self.mesh, *face);
            let along = |(area, column): (T, &[T])| match column.get(face.index()) {
                Some(n) => area * n,
                None => T::zero(),
            };
            let sum = [x, y, z].into_iter().zip(columns).map(along);
            let sum = sum.fold(T::zero(), |sum, term| sum + term);
            sum.certain_sign() == Some(Sign::Negative)
        };
        self.mesh.topology.faces().filter(turned).collect()
    }
}
