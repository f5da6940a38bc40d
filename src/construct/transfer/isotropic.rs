//! From Euclidean to isotropic space: oriented face planes to vertices (12).

use super::{NoTransfer, PLANE_DATA};
use crate::mesh::{Data, FaceId, Mesh, VertexId};
use crate::scalar::{Field, RationalField};
use crate::space::laguerre::OrientedPlane;
use crate::space::{Point, Vector3};

/// The i-circular mesh M with τ(M) = N, of a conical mesh N with oriented planes of its faces: the
/// vertices are their images under (12), in the order of the faces; interior vertices of N become
/// faces.
///
/// # Errors
/// A vertex of N that does not lie in the planes of its faces, or at which their unit normals lie
/// on no circle; a plane with the normal (0, 0, −1); dual combinatorics that are no mesh.
pub fn circular_image<T: Field>(
    mesh: &Mesh<T>,
    planes: &[OrientedPlane<T>],
) -> Result<Mesh<T>, NoTransfer<T>> {
    for (face, plane) in mesh.topology.faces().zip(planes) {
        let distances =
            mesh.topology.face(face).iter().map(|v| plane.distance(&mesh.points[v.index()]));
        if let Some(residual) = distances.into_iter().find(|d| !d.is_zero()) {
            return Err(NoTransfer::NotPlanar { face, residual });
        }
    }
    for vertex in mesh.topology.interior_vertices() {
        let faces = mesh.topology.star(vertex).map(|h| mesh.topology.face_at(h));
        let normals: Vec<_> = faces.filter_map(|f| planes.get(f.index())).collect();
        if let Some(residual) = off_circle(&normals) {
            return Err(NoTransfer::NotConical { vertex, residual });
        }
    }
    image_of_planes(mesh, planes)
}

/// The vertices are the images of the planes under (12), whatever they fit.
fn image_of_planes<T: Field>(
    mesh: &Mesh<T>,
    planes: &[OrientedPlane<T>],
) -> Result<Mesh<T>, NoTransfer<T>> {
    let image = |(face, plane): (FaceId, &OrientedPlane<T>)| {
        plane.to_isotropic().map_err(|_| NoTransfer::SouthPole(face))
    };
    let points = mesh.topology.faces().zip(planes).map(image).collect::<Result<Vec<_>, _>>()?;
    Ok(Mesh { topology: mesh.topology.dual()?.topology, points, data: Data::default() })
}

/// What doubles show of the [`circular_image`] of any Euclidean mesh, with normals along the vector
/// areas: an observation, since a rounded unit normal is none.
///
/// # Errors
/// [`NoTransfer::NoNormal`] and the like; nothing is found to be not planar or not conical.
pub fn observed_image(mesh: &Mesh<f64>) -> Result<Mesh<f64>, NoTransfer<f64>> {
    let plane = |face: FaceId| {
        let Vector3 { x, y, z } = vector_area(mesh, face);
        let length = x.hypot(y).hypot(z);
        let scale = length.try_inv().ok_or(NoTransfer::NoNormal(face))?;
        let normal = Vector3::new(x * scale, y * scale, z * scale);
        let through = OrientedPlane::trusted(normal, 0.0);
        let corners = mesh.topology.face(face);
        let sum: f64 = corners.iter().map(|v| through.distance(&mesh.points[v.index()])).sum();
        Ok(OrientedPlane::trusted(normal, -sum / corners.len() as f64))
    };
    let planes = mesh.topology.faces().map(plane).collect::<Result<Vec<_>, NoTransfer<f64>>>()?;
    image_of_planes(mesh, &planes)
}

/// The first volume that is not 0 of a tetrahedron of three different unit normals and another.
fn off_circle<T: Field>(planes: &[&OrientedPlane<T>]) -> Option<T> {
    let mut normals = Vec::with_capacity(planes.len());
    for normal in planes.iter().map(|plane| plane.normal()) {
        if !normals.contains(&normal) {
            normals.push(normal);
        }
    }
    let [a, b, c, others @ ..] = normals.as_slice() else {
        return None;
    };
    let from_a = |v: &Vector3<T>| Vector3::new(&v.x - &a.x, &v.y - &a.y, &v.z - &a.z);
    let (b, c) = (from_a(b), from_a(c));
    others.iter().map(|d| Vector3::det(&b, &c, &from_a(d))).find(|volume| !volume.is_zero())
}

/// The oriented planes of the faces that stand in the data of a mesh, or `None` if there are none.
///
/// # Errors
/// [`NoTransfer::NotAUnitNormal`].
pub fn stored_planes<T: Field>(
    mesh: &Mesh<T>,
) -> Option<Result<Vec<OrientedPlane<T>>, NoTransfer<T>>> {
    let column = |name: &str| mesh.data.face.get(name);
    let [x, y, z, h] = PLANE_DATA.map(column);
    let (x, y, z, h) = (x?, y?, z?, h?);
    let plane = |face: FaceId| {
        let number = |column: &[T]| column.get(face.index()).map_or(T::zero(), T::clone);
        let normal = Vector3::new(number(x), number(y), number(z));
        OrientedPlane::new(normal, number(h)).map_err(|_| NoTransfer::NotAUnitNormal(face))
    };
    Some(mesh.topology.faces().map(plane).collect())
}

/// The oriented planes of the faces of a Euclidean mesh, with normals along the vector areas.
///
/// # Errors
/// [`NoTransfer::NoNormal`], [`NoTransfer::Irrational`]: only planes with rational unit normals have
/// a place in the isotropic model over ℚ.
pub fn oriented_planes<Q: RationalField>(
    mesh: &Mesh<Q>,
) -> Result<Vec<OrientedPlane<Q>>, NoTransfer<Q>> {
    let plane = |face: FaceId| {
        let area = vector_area(mesh, face);
        let length2 = area.length2();
        let length = length2.root();
        let scale = match length.map(|length| length.try_inv()) {
            None => return Err(NoTransfer::Irrational { face, length2 }),
            Some(None) => return Err(NoTransfer::NoNormal(face)),
            Some(Some(scale)) => scale,
        };
        let normal = Vector3::new(area.x * &scale, area.y * &scale, area.z * scale);
        let height = mesh.topology.face(face).first().map_or(Q::zero(), |v: &VertexId| {
            let [x, y, z] = mesh.points[v.index()].coordinates();
            -Q::dot([&normal.x, &normal.y, &normal.z], [x, y, z])
        });
        OrientedPlane::new(normal, height).map_err(|_| NoTransfer::NotAUnitNormal(face))
    };
    mesh.topology.faces().map(plane).collect()
}

/// Twice the vector area of a face: along the normal from which it runs counter-clockwise.
pub(super) fn vector_area<T: Field>(mesh: &Mesh<T>, face: FaceId) -> Vector3<T> {
    let corners: Vec<&Point<T>> =
        mesh.topology.face(face).iter().map(|v| &mesh.points[v.index()]).collect();
    let zero = Vector3::new(T::zero(), T::zero(), T::zero());
    let Some((first, rest)) = corners.split_first() else {
        return zero;
    };
    rest.windows(2).fold(zero, |sum, pair| {
        let part = (pair[0] - first).cross(&(pair[1] - first));
        Vector3::new(sum.x + part.x, sum.y + part.y, sum.z + part.z)
    })
}
