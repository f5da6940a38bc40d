//! Combinatorics against a naive oracle that compares every face with every other.

use std::collections::{BTreeMap, BTreeSet};

use isogeo::construct::quad_patch;
use isogeo::mesh::{FaceId, FaceList, HalfEdge, Topology, TopologyError, VertexId, VertexKind};
use proptest::prelude::*;

use crate::meshes::combinatorics;

type Faces = Vec<Vec<u32>>;

fn list(faces: &[Vec<u32>]) -> FaceList {
    let mut list = FaceList::new();
    faces.iter().for_each(|f| list.push(f.iter().copied()));
    list
}

fn faces_of(topology: &Topology) -> Faces {
    topology.faces().map(|f| topology.face(f).iter().map(|v| v.0).collect()).collect()
}

fn sides(face: &[u32]) -> impl Iterator<Item = (u32, u32)> + '_ {
    (0..face.len()).map(|i| (face[i], face[(i + 1) % face.len()]))
}

/// The faces that run through an edge in this direction.
fn along(faces: &[Vec<u32>], side: (u32, u32)) -> Vec<usize> {
    (0..faces.len()).filter(|&f| sides(&faces[f]).any(|s| s == side)).collect()
}

fn is_face(face: &[u32], vertices: u32) -> bool {
    let different: BTreeSet<_> = face.iter().collect();
    face.len() >= 3 && different.len() == face.len() && face.iter().all(|&v| v < vertices)
}

fn is_mesh(faces: &[Vec<u32>], vertices: u32) -> bool {
    faces.iter().all(|f| is_face(f, vertices))
        && faces.iter().flat_map(|f| sides(f)).all(|s| along(faces, s).len() == 1)
}

/// The faces at a vertex, grouped: faces belong together that share an edge at it.
fn fans(faces: &[Vec<u32>], v: u32) -> Vec<BTreeSet<usize>> {
    let mut groups: Vec<BTreeSet<usize>> =
        (0..faces.len()).filter(|&f| faces[f].contains(&v)).map(|f| BTreeSet::from([f])).collect();
    for (a, b) in faces.iter().flat_map(|f| sides(f)).filter(|&(a, b)| a == v || b == v) {
        let here: BTreeSet<_> =
            [along(faces, (a, b)), along(faces, (b, a))].concat().into_iter().collect();
        let (joined, apart): (Vec<_>, Vec<_>) =
            groups.into_iter().partition(|g| !g.is_disjoint(&here));
        groups = apart;
        groups.extend(joined.into_iter().reduce(|a, b| &a | &b));
    }
    groups
}

fn kind(faces: &[Vec<u32>], v: u32) -> VertexKind {
    let open = |&(a, b): &(u32, u32)| (a == v || b == v) && along(faces, (b, a)).is_empty();
    match fans(faces, v).len() {
        0 => VertexKind::Isolated,
        1 if faces.iter().flat_map(|f| sides(f)).any(|s| open(&s)) => VertexKind::Boundary,
        1 => VertexKind::Interior,
        _ => VertexKind::Pinched,
    }
}

/// How often the boundary closes: its edges follow each other through the fan at their common end.
fn loop_count(faces: &[Vec<u32>]) -> usize {
    let boundary: Vec<_> = faces
        .iter()
        .flat_map(|f| sides(f))
        .filter(|&(a, b)| along(faces, (b, a)).is_empty())
        .collect();
    let next = |(a, b): (u32, u32)| {
        let fans = fans(faces, b);
        let fan = fans.iter().find(|fan| fan.contains(&along(faces, (a, b))[0])).unwrap();
        let out: Vec<_> =
            boundary.iter().filter(|&&s| s.0 == b && fan.contains(&along(faces, s)[0])).collect();
        assert_eq!(out.len(), 1, "a fan has one end");
        *out[0]
    };
    let mut left: BTreeSet<_> = boundary.iter().copied().collect();
    let mut loops = 0;
    while let Some(first) = left.pop_first() {
        loops += 1;
        let mut at = next(first);
        while at != first {
            assert!(left.remove(&at), "the boundary does not branch");
            at = next(at);
        }
    }
    loops
}

fn component_count(faces: &[Vec<u32>], vertices: u32) -> usize {
    let mut name: Vec<u32> = (0..vertices).collect();
    for _ in 0..vertices {
        for f in faces {
            let least = f.iter().map(|&v| name[v as usize]).min().unwrap();
            f.iter().for_each(|&v| name[v as usize] = least);
        }
    }
    name.into_iter().collect::<BTreeSet<_>>().len()
}

fn holds_against_the_oracle(faces: &[Vec<u32>], vertices: u32) -> Result<(), TestCaseError> {
    let topology = Topology::new(vertices as usize, list(faces)).unwrap();
    prop_assert_eq!(&faces_of(&topology), faces);
    let half_edges: Vec<HalfEdge> = topology.faces().flat_map(|f| topology.half_edges(f)).collect();
    let ends = |h| (topology.origin(h).0, topology.target(h).0);
    let mut edges = BTreeSet::new();
    for &h in &half_edges {
        let (a, b) = ends(h);
        edges.insert((a.min(b), a.max(b)));
        prop_assert_eq!(along(faces, (a, b)), vec![topology.face_at(h).index()]);
        let twin = topology.twin(h);
        prop_assert_eq!(twin.map(ends), (!along(faces, (b, a)).is_empty()).then_some((b, a)));
        prop_assert!(twin.is_none_or(|t| topology.twin(t) == Some(h)));
        prop_assert_eq!(topology.prev(topology.next(h)), h);
    }
    prop_assert_eq!(topology.edge_count(), edges.len());
    let listed: Vec<_> = topology
        .edges()
        .map(|h| {
            let (a, b) = ends(h);
            (a.min(b), a.max(b))
        })
        .collect();
    prop_assert_eq!(listed.len(), edges.len());
    prop_assert_eq!(listed.into_iter().collect::<BTreeSet<_>>(), edges.clone());
    prop_assert_eq!(topology.component_count(), component_count(faces, vertices));
    let euler = i64::from(vertices) - edges.len() as i64 + faces.len() as i64;
    prop_assert_eq!(topology.euler_characteristic(), euler);
    for v in topology.vertices() {
        prop_assert_eq!(topology.kind(v), kind(faces, v.0), "vertex {}", v.0);
        let star: Vec<HalfEdge> = topology.star(v).collect();
        prop_assert!(star.iter().all(|&h| topology.origin(h) == v));
        let around: BTreeSet<_> = star.iter().map(|&h| topology.face_at(h).index()).collect();
        prop_assert_eq!(around.len(), star.len());
        if topology.kind(v) != VertexKind::Isolated {
            prop_assert!(fans(faces, v.0).contains(&around));
        }
        // Counter-clockwise: into v before a half-edge is out of v after it.
        for (&h, &after) in star.iter().zip(star.iter().skip(1)) {
            prop_assert_eq!(topology.twin(topology.prev(h)), Some(after));
        }
        if topology.kind(v) == VertexKind::Boundary {
            prop_assert_eq!(topology.twin(star[0]), None);
        }
        for w in topology.vertices().filter(|&w| w != v) {
            let found = topology.edge(v, w).map(ends);
            let (there, back) = ((v.0, w.0), (w.0, v.0));
            let expected = [there, back].into_iter().find(|&s| !along(faces, s).is_empty());
            prop_assert_eq!(found, expected);
        }
    }
    let loops = topology.boundary_loops();
    prop_assert_eq!(loops.len(), loop_count(faces));
    let walked: Vec<_> =
        loops.iter().flat_map(|l| (0..l.len()).map(|i| (l[i].0, l[(i + 1) % l.len()].0))).collect();
    let boundary: BTreeSet<_> =
        half_edges.iter().filter(|&&h| topology.twin(h).is_none()).map(|&h| ends(h)).collect();
    prop_assert_eq!(walked.len(), boundary.len());
    prop_assert_eq!(walked.into_iter().collect::<BTreeSet<_>>(), boundary);
    Ok(())
}

/// The dual of the dual is the mesh of the faces all of whose corners are interior.
fn duality_holds(topology: &Topology) -> Result<(), TestCaseError> {
    let Ok(dual) = topology.dual() else {
        return Ok(());
    };
    let neighbours = topology.edges().filter_map(|h| {
        let (f, g) = (topology.face_at(h), topology.face_at(topology.twin(h)?));
        Some((f.min(g), f.max(g)))
    });
    let mut neighbours: Vec<_> = neighbours.collect();
    neighbours.sort_unstable();
    if neighbours.windows(2).any(|pair| pair[0] == pair[1]) {
        // Faces with two edges in common, between which a vertex is not interior: the dual glues
        // what was apart, and is a mesh all the same.
        return Ok(());
    }
    let interior: Vec<_> = topology.interior_vertices().collect();
    prop_assert_eq!(&dual.vertex_of_face, &interior);
    for f in topology.faces() {
        let all = topology.face(f).iter().all(|&v| topology.kind(v) == VertexKind::Interior);
        prop_assert_eq!(dual.topology.kind(VertexId(f.0)) == VertexKind::Interior, all);
    }
    let Ok(back) = dual.topology.dual() else {
        return Ok(());
    };
    for (k, f) in back.vertex_of_face.iter().enumerate() {
        let corners = topology.face(FaceId(f.0));
        let named: Vec<_> = back
            .topology
            .face(FaceId(k as u32))
            .iter()
            .map(|v| dual.vertex_of_face[v.index()])
            .collect();
        let turns = (0..corners.len()).any(|i| [&corners[i..], &corners[..i]].concat() == named);
        prop_assert!(turns, "{:?} {:?}", corners, named);
    }
    Ok(())
}

/// Faces kept one after the other where they still form a mesh: all kinds of vertices occur.
fn random_mesh() -> impl Strategy<Value = (Faces, u32)> {
    (4u32..=9).prop_flat_map(|n| {
        let face = prop::collection::vec(0..n, 3..=5);
        (prop::collection::vec(face, 0..40), Just(n)).prop_map(|(candidates, n)| {
            let mut faces = Faces::new();
            for face in candidates {
                faces.push(face);
                if !is_mesh(&faces, n) {
                    faces.pop();
                }
            }
            (faces, n)
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 192, ..ProptestConfig::default() })]

    #[test]
    fn random_meshes_are_what_the_oracle_says((faces, n) in random_mesh()) {
        holds_against_the_oracle(&faces, n)?;
        duality_holds(&Topology::new(n as usize, list(&faces)).unwrap())?;
    }

    #[test]
    fn garbage_gets_an_error_that_is_true(
        faces in prop::collection::vec(prop::collection::vec(0u32..7, 2..=5), 1..6), n in 5u32..=7,
    ) {
        let named = |f: FaceId| faces[f.index()].as_slice();
        let undirected = |(a, b): (VertexId, VertexId)| {
            let (a, b) = (a.0, b.0);
            (along(&faces, (a, b)), along(&faces, (b, a)))
        };
        let distinct = |list: &[FaceId]| list.iter().collect::<BTreeSet<_>>().len() == list.len();
        let earlier_are_faces = |f: FaceId| faces[..f.index()].iter().all(|f| is_face(f, n));
        match Topology::new(n as usize, list(&faces)) {
            Ok(_) => prop_assert!(is_mesh(&faces, n)),
            Err(TopologyError::FaceTooSmall { face, corners }) => {
                prop_assert!(corners < 3 && named(face).len() == corners && earlier_are_faces(face));
            }
            Err(TopologyError::NoSuchVertex { face, vertex, vertices }) => {
                prop_assert!(vertices == n && vertex >= n && named(face).contains(&vertex) && earlier_are_faces(face));
            }
            Err(TopologyError::RepeatedVertex { face, vertex }) => {
                let times = named(face).iter().filter(|&&v| v == vertex.0).count();
                prop_assert!(times > 1 && earlier_are_faces(face));
            }
            Err(TopologyError::WrongOrientation { edge, faces: (f, g) }) => {
                let (there, back) = undirected(edge);
                prop_assert_eq!(there, vec![f.index(), g.index()]);
                prop_assert!(back.is_empty());
            }
            Err(TopologyError::NonManifoldEdge { edge, faces: (f, g, h) }) => {
                let (there, back) = undirected(edge);
                let all = [there, back].concat();
                prop_assert!(distinct(&[f, g, h]) && [f, g, h].iter().all(|f| all.contains(&f.index())));
            }
            Err(TopologyError::TooLarge) => prop_assert!(false, "not large"),
        }
    }
}

#[test]
fn the_shared_combinatorics_are_what_the_oracle_says() {
    for (n, faces) in combinatorics() {
        let topology = Topology::new(n, faces).unwrap();
        holds_against_the_oracle(&faces_of(&topology), n as u32).unwrap();
        duality_holds(&topology).unwrap();
    }
    let grid = Topology::new(30, quad_patch(4, 5)).unwrap();
    duality_holds(&grid).unwrap();
    // Not vacuous: a patch of 4 by 5 faces has 12 interior vertices and 2 by 3 inner faces.
    let dual = grid.dual().unwrap().topology;
    assert_eq!((dual.vertex_count(), dual.face_count()), (20, 12));
    assert_eq!(dual.dual().unwrap().topology.face_count(), 6);
}

#[test]
fn random_meshes_have_every_kind_of_vertex() {
    // The control of the generator.
    use proptest::strategy::ValueTree;
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let mut seen = BTreeMap::new();
    for _ in 0..200 {
        let (faces, n) = random_mesh().new_tree(&mut runner).unwrap().current();
        for v in 0..n {
            *seen.entry(format!("{:?}", kind(&faces, v))).or_insert(0) += 1;
        }
    }
    assert!(seen.len() == 4 && seen.values().all(|&n| n >= 10), "{seen:?}");
}

#[test]
fn what_is_no_mesh_is_named() {
    let error = |n, faces: &[&[u32]]| {
        let faces: Faces = faces.iter().map(|f| f.to_vec()).collect();
        Topology::new(n, list(&faces)).unwrap_err()
    };
    let (v, f) = (VertexId, FaceId);
    // A band of three quads with half a turn.
    let moebius = error(6, &[&[0, 1, 3, 2], &[2, 3, 5, 4], &[4, 5, 0, 1]]);
    assert_eq!(
        moebius,
        TopologyError::WrongOrientation { edge: (v(0), v(1)), faces: (f(0), f(2)) }
    );
    let book = error(5, &[&[2, 3, 0], &[3, 2, 1], &[2, 3, 4]]);
    let pages = (f(0), f(1), f(2));
    assert_eq!(book, TopologyError::NonManifoldEdge { edge: (v(2), v(3)), faces: pages });
    let long: Vec<u32> = (0..20).chain([7]).collect();
    assert_eq!(
        error(20, &[&[0, 1, 2], &long]),
        TopologyError::RepeatedVertex { face: f(1), vertex: v(7) }
    );
    // A vertex of valence 2 has a dual face of two corners.
    let pillow = Topology::new(3, list(&[vec![0, 1, 2], vec![0, 2, 1]])).unwrap();
    assert_eq!(pillow.dual(), Err(TopologyError::FaceTooSmall { face: f(0), corners: 2 }));
}

#[test]
fn hubs_of_a_hundred_thousand_faces_cost_no_more_than_their_faces() {
    // Looking for every edge by its ends from either side: quadratic, this would take minutes.
    const N: u32 = 100_000;
    let closed =
        |hub: u32, first: u32| (0..N).map(move |i| vec![hub, first + i, first + (i + 1) % N]);
    let pinched = (0..N / 2).map(|i| vec![0, 1 + 2 * i, 2 + 2 * i]);
    let double = closed(0, 1).chain(closed(N + 1, 1).map(|f| vec![f[0], f[2], f[1]]));
    for (vertices, faces) in [
        (N + 1, closed(0, 1).collect::<Faces>()),
        (N + 1, closed(N, 0).collect()),
        (N + 1, pinched.collect()),
        (N + 2, double.collect()),
    ] {
        let topology = Topology::new(vertices as usize, list(&faces)).unwrap();
        for h in topology.edges() {
            let (a, b) = (topology.origin(h), topology.target(h));
            assert_eq!(topology.edge(a, b), Some(h));
            assert_eq!(topology.edge(b, a), topology.twin(h).or(Some(h)));
        }
        assert_eq!(topology.component_count(), 1);
        assert!(topology.boundary_loops().len() <= N as usize / 2);
    }
}
