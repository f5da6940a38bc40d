//! Faces of all kinds, and meshes on them without any property.

use proptest::prelude::*;

use super::number::number;
use crate::construct::quad_patch;
use crate::mesh::{FaceId, FaceList, Mesh, VertexId};
use crate::scalar::Field;
use crate::space::Point;

/// Combinatorics as numbers of vertices with faces: single faces, patches, closed surfaces, fans
/// of any valence, mixed faces, pinched and isolated vertices; those of few faces first.
///
/// ```
/// use isogeo::mesh::Topology;
/// use isogeo::strategy::combinatorics;
/// assert!(combinatorics().into_iter().all(|(vertices, faces)| Topology::new(vertices, faces).is_ok()));
/// ```
pub fn combinatorics() -> Vec<(usize, FaceList)> {
    let cube: [&[u32]; 6] =
        [&[0, 3, 2, 1], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]];
    vec![
        (3, list(&[&[0, 1, 2]])),
        (4, quad_patch(1, 1)),
        (6, list(&[&[0, 1, 2, 3, 4, 5]])),
        (7, list(&[&[0, 1, 2, 3, 4], &[0, 5, 6, 1]])),
        // Pinched at vertex 2, and an isolated vertex 5.
        (6, list(&[&[0, 1, 2], &[2, 3, 4]])),
        fan(3, 1),
        fan(3, 2),
        (4, list(&[&[0, 1, 2], &[0, 3, 1], &[1, 3, 2], &[2, 3, 0]])),
        (9, quad_patch(2, 2)),
        fan(4, 2),
        fan(4, 3),
        fan(5, 1),
        fan(5, 2),
        (12, quad_patch(3, 2)),
        (8, list(&cube)),
        fan(6, 1),
    ]
}

fn list(faces: &[&[u32]]) -> FaceList {
    let mut list = FaceList::new();
    faces.iter().for_each(|face| list.push(face.iter().copied()));
    list
}

/// `faces` faces of `edges + 2` corners around vertex 0.
pub(super) fn fan(faces: u32, edges: u32) -> (usize, FaceList) {
    let rim = faces * edges;
    let mut list = FaceList::new();
    for i in 0..faces {
        let corners = (0..=edges).map(|j| 1 + (i * edges + j) % rim);
        list.push(std::iter::once(0).chain(corners));
    }
    ((rim + 1) as usize, list)
}

/// The most vertices of [`combinatorics`].
const VERTICES: usize = 13;

/// Meshes on all [`combinatorics`] with coordinates from a strategy: nothing holds on them but by
/// chance, which with [`small`](super::small()) numbers is not rare.
///
/// ```
/// use isogeo::scalar::Rational;
/// use isogeo::strategy::{any_mesh, small};
/// use proptest::strategy::{Strategy, ValueTree};
/// use proptest::test_runner::TestRunner;
/// let tree = any_mesh(small::<Rational>()).new_tree(&mut TestRunner::deterministic());
/// assert!(tree.is_ok_and(|tree| tree.current().topology.face_count() > 0));
/// ```
pub fn any_mesh<Q: Field>(
    coordinate: impl Strategy<Value = Q> + Clone,
) -> impl Strategy<Value = Mesh<Q>> {
    let point = [coordinate.clone(), coordinate.clone(), coordinate];
    let points = prop::collection::vec(point, VERTICES);
    (prop::sample::select(combinatorics()), points).prop_filter_map(
        "the combinatorics are those of meshes",
        |((vertices, faces), points)| {
            let points = points.into_iter().take(vertices).map(|[x, y, z]| Point::new(x, y, z));
            Mesh::new(points.collect(), faces).ok()
        },
    )
}

/// Points with a number for every coordinate.
pub(super) fn points<Q: Field>(count: usize) -> impl Strategy<Value = Vec<Point<Q>>> + Clone {
    let point = [number(), number(), number()].prop_map(|[x, y, z]| Point::new(x, y, z));
    prop::collection::vec(point, count)
}

/// The same mesh with vertices and faces renamed and the first corners of faces moved on, in a way
/// that follows from the seed. Data on elements are not carried over.
pub fn relabelled<T: Clone>(mesh: &Mesh<T>, seed: u64) -> Mesh<T> {
    let order = |n: usize, salt: u64| {
        let key = |i: u32| {
            let mixed = (seed ^ salt).wrapping_add(u64::from(i));
            (mixed.wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(23), i)
        };
        let mut keys: Vec<(u64, u32)> = (0..n as u32).map(key).collect();
        keys.sort_unstable();
        keys.into_iter().map(|(_, i)| i).collect::<Vec<u32>>()
    };
    let vertices = order(mesh.points.len(), 1);
    let mut new_name = vec![0u32; vertices.len()];
    for (new, &old) in vertices.iter().enumerate() {
        new_name[old as usize] = new as u32;
    }
    let mut faces = FaceList::new();
    for &f in &order(mesh.topology.face_count(), 2) {
        let corners = mesh.topology.face(FaceId(f));
        let shift = (seed.wrapping_add(f.into()) % corners.len() as u64) as usize;
        let rename = |v: &VertexId| new_name[v.index()];
        faces.push(corners[shift..].iter().chain(&corners[..shift]).map(rename));
    }
    let points = vertices.iter().map(|&old| mesh.points[old as usize].clone()).collect();
    // Renaming keeps a mesh; were it not so, the mesh itself would be an answer, too.
    Mesh::new(points, faces).unwrap_or_else(|_| mesh.clone())
}
