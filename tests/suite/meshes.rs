//! Meshes that the tests share: exact families and combinatorics with every kind of vertex.

use isogeo::construct::{circular_net, quad_patch, translational_net};
use isogeo::mesh::{FaceList, Mesh, VertexId};
use isogeo::scalar::{BigRational, Field, Ring};
use isogeo::space::Point;
use proptest::prelude::*;

pub type Q = BigRational;

/// Fractions with small numerators and denominators, so that coincidences are frequent.
pub fn small() -> impl Strategy<Value = Q> + Clone {
    (-3i64..=3, 1i64..=3).prop_map(|(p, q)| Q::from_ratio(p, q))
}

/// Fractions among which coincidences are rare.
pub fn fraction() -> impl Strategy<Value = Q> + Clone {
    (-9999i64..=9999, 1i64..=99).prop_map(|(p, q)| Q::from_ratio(p, q))
}

/// Increasing positions with any heights.
pub fn profile(points: usize) -> impl Strategy<Value = Vec<(Q, Q)>> {
    prop::collection::vec(((1i64..=40, 1i64..=9), fraction()), points).prop_map(|steps| {
        let mut x = Q::from_i64(0);
        steps
            .into_iter()
            .map(|((p, q), z)| {
                x = &x + Q::from_ratio(p, q);
                (x.clone(), z)
            })
            .collect()
    })
}

/// Translational nets: planar, i-circular and i-conical.
pub fn translational() -> impl Strategy<Value = Mesh<Q>> {
    (2usize..=4, 2usize..=4)
        .prop_flat_map(|(m, n)| (profile(m + 1), profile(n + 1)))
        .prop_map(|(f, g)| translational_net(&f, &g).expect("a grid is a mesh"))
}

/// i-circular nets from random Cauchy data near a grid.
pub fn circular() -> impl Strategy<Value = Mesh<Q>> {
    let ratio = (1i64..=9).prop_map(|p| Q::from_ratio(p, 10));
    (2usize..=3, 2usize..=3)
        .prop_flat_map(move |(m, n)| {
            let jitter = (-9i64..=9, -9i64..=9, -50i64..=50);
            (
                prop::collection::vec(jitter.clone(), m),
                prop::collection::vec(jitter, n),
                prop::collection::vec(ratio.clone(), m * n),
            )
        })
        .prop_filter_map("degenerate Cauchy data", |(rows, columns, ratios)| {
            let near = |x: usize, y: usize, (a, b, z): (i64, i64, i64)| {
                let at = |n: usize, d: i64| Q::from_ratio(n as i64 * 40 + d, 40);
                Point::new(at(x, a), at(y, b), Q::from_ratio(z, 10))
            };
            let corner = Point::new(Q::from_i64(0), Q::from_i64(0), Q::from_i64(0));
            let n = columns.len();
            let line = |offsets: Vec<(i64, i64, i64)>, along_x: bool| {
                let points = offsets
                    .into_iter()
                    .enumerate()
                    .map(move |(i, d)| if along_x { near(i + 1, 0, d) } else { near(0, i + 1, d) });
                std::iter::once(corner.clone()).chain(points).collect::<Vec<_>>()
            };
            let (rows, columns) = (line(rows, true), line(columns, false));
            circular_net(&rows, &columns, |i, j| ratios[i * n + j].clone())?.ok()
        })
}

/// Combinatorics of many kinds: patches, closed surfaces, fans of any valence, mixed faces.
pub fn combinatorics() -> Vec<(usize, FaceList)> {
    let list = |faces: &[&[u32]]| {
        let mut list = FaceList::new();
        faces.iter().for_each(|f| list.push(f.iter().copied()));
        list
    };
    let fan = |k: u32, per_face: u32| {
        // k faces of `per_face + 2` corners around vertex 0.
        let rim = k * per_face;
        let mut list = FaceList::new();
        for i in 0..k {
            let corners = (0..=per_face).map(|j| 1 + (i * per_face + j) % rim);
            list.push(std::iter::once(0).chain(corners));
        }
        ((rim + 1) as usize, list)
    };
    vec![
        (9, quad_patch(2, 2)),
        (12, quad_patch(3, 2)),
        (4, list(&[&[0, 1, 2], &[0, 3, 1], &[1, 3, 2], &[2, 3, 0]])),
        (
            8,
            list(&[
                &[0, 3, 2, 1],
                &[4, 5, 6, 7],
                &[0, 1, 5, 4],
                &[1, 2, 6, 5],
                &[2, 3, 7, 6],
                &[3, 0, 4, 7],
            ]),
        ),
        fan(3, 1),
        fan(3, 2),
        fan(4, 2),
        fan(5, 1),
        fan(5, 2),
        fan(6, 1),
        fan(4, 3),
        (7, list(&[&[0, 1, 2, 3, 4], &[0, 5, 6, 1]])),
        (6, list(&[&[0, 1, 2, 3, 4, 5]])),
        // Pinched at vertex 2, and an isolated vertex 5.
        (6, list(&[&[0, 1, 2], &[2, 3, 4]])),
    ]
}

/// Meshes of all these kinds with coordinates from `coordinate`.
pub fn any_mesh(coordinate: impl Strategy<Value = Q> + Clone) -> impl Strategy<Value = Mesh<Q>> {
    prop::sample::select(combinatorics()).prop_flat_map(move |(vertices, faces)| {
        let point = [coordinate.clone(), coordinate.clone(), coordinate.clone()];
        prop::collection::vec(point, vertices).prop_map(move |points| {
            let points = points.into_iter().map(|[x, y, z]| Point::new(x, y, z)).collect();
            Mesh::new(points, faces.clone()).expect("the combinatorics are those of a mesh")
        })
    })
}

/// The same mesh with vertices and faces renamed and the first corners of faces moved on.
pub fn relabelled<T: Clone>(mesh: &Mesh<T>, seed: u64) -> Mesh<T> {
    let order = |n: usize, salt: u64| {
        let mut keys: Vec<(u64, u32)> = (0..n as u32)
            .map(|i| {
                (
                    (seed ^ salt)
                        .wrapping_add(u64::from(i))
                        .wrapping_mul(0x9e37_79b9_7f4a_7c15)
                        .rotate_left(23),
                    i,
                )
            })
            .collect();
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
        let corners = mesh.topology.face(isogeo::mesh::FaceId(f));
        let shift = (seed as usize + f as usize) % corners.len();
        let rename = |v: &VertexId| new_name[v.index()];
        faces.push(corners[shift..].iter().chain(&corners[..shift]).map(rename));
    }
    let points = vertices.iter().map(|&old| mesh.points[old as usize].clone()).collect();
    Mesh::new(points, faces).expect("renaming keeps a mesh")
}
