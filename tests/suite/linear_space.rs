//! The spaces of parallel and v-parallel meshes: known dimensions, exact members, controls.

use isogeo::construct::{circular_net, metric_dual, quad_patch};
use isogeo::mesh::{FaceList, Mesh, VertexKind};
use isogeo::pair::linear_space::{ParallelSpace, parallel_space, v_parallel_space};
use isogeo::scalar::{BigRational, Field, Rational, RationalField, Ring};
use isogeo::space::{Point, Vector3};
use proptest::prelude::*;

use super::elimination::gauss;
use super::meshes::{any_mesh, circular, small, translational};

type Q = BigRational;

fn q(n: i64) -> Q {
    Q::from_i64(n)
}

/// A stream of integers from `-size` to `size` (splitmix64).
fn noise(seed: u64, size: i64) -> impl Iterator<Item = Q> {
    (1..).map(move |i: u64| {
        let mut z = seed.wrapping_add(i.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        q((z >> 40) as i64 % (2 * size + 1) - size)
    })
}

/// A patch of quads over the plane z = 0 with points moved at random from a grid of step 10.
fn flat(m: usize, n: usize) -> Mesh<Q> {
    let mut moves = noise(7, 3);
    let mut near = |i: usize| q(10 * i as i64) + moves.next().expect("endless");
    let points = (0..=m).flat_map(|i| (0..=n).map(move |j| (i, j)));
    let points = points.map(|(i, j)| Point::new(near(i), near(j), q(0))).collect();
    Mesh::new(points, quad_patch(m, n)).expect("a patch")
}

/// A grid of triangles with random heights.
fn triangles(m: usize, n: usize) -> Mesh<Q> {
    let flat = flat(m, n);
    let mut faces = FaceList::new();
    for f in flat.topology.faces() {
        let [a, b, c, d] = [0, 1, 2, 3].map(|i| flat.topology.face(f)[i].0);
        faces.push([a, b, c]);
        faces.push([a, c, d]);
    }
    let lifted = flat.points.iter().zip(noise(3, 50));
    let points = lifted.map(|(p, z)| Point::new(p.x.clone(), p.y.clone(), z));
    Mesh::new(points.collect(), faces).expect("a patch")
}

fn mesh(points: &[[i64; 3]], faces: &[&[u32]]) -> Mesh<Q> {
    let mut list = FaceList::new();
    faces.iter().for_each(|f| list.push(f.iter().copied()));
    let points = points.iter().map(|&[x, y, z]| Point::new(q(x), q(y), q(z))).collect();
    Mesh::new(points, list).expect("a mesh")
}

fn cube() -> Mesh<Q> {
    let corners = [[0, 0], [1, 0], [1, 1], [0, 1]];
    let points: Vec<_> = [0, 1].iter().flat_map(|&z| corners.map(|[x, y]| [x, y, z])).collect();
    let faces: [&[u32]; 6] =
        [&[0, 3, 2, 1], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]];
    mesh(&points, &faces)
}

fn edges<T: RationalField>(mesh: &Mesh<T>) -> Vec<Vector3<T>> {
    let at = |v: isogeo::mesh::VertexId| &mesh.points[v.index()];
    mesh.topology
        .edges()
        .map(|h| at(mesh.topology.target(h)) - at(mesh.topology.origin(h)))
        .collect()
}

/// `e × e' = 0` for all edges, by definition.
fn is_parallel<T: RationalField>(a: &Mesh<T>, b: &Mesh<T>) -> bool {
    let zero = |v: &Vector3<T>| v.x.is_zero() && v.y.is_zero() && v.z.is_zero();
    edges(a).iter().zip(&edges(b)).all(|(e, f)| zero(&e.cross(f)))
}

/// The dimension of `{M' : e × e' = 0}` by Gauss on all coordinates: nothing in common with ours.
fn dimension_by_coordinates(mesh: &Mesh<Q>) -> usize {
    let size = 3 * mesh.points.len();
    let mut rows = Vec::new();
    for (h, e) in mesh.topology.edges().zip(edges(mesh)) {
        let (a, b) = (mesh.topology.origin(h).index(), mesh.topology.target(h).index());
        let e = [e.x, e.y, e.z];
        for axis in 0..3 {
            let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
            let mut row = vec![q(0); size];
            for (v, sign) in [(b, 1), (a, -1)] {
                row[3 * v + j] += &(&e[i] * q(sign));
                row[3 * v + i] -= &(&e[j] * q(sign));
            }
            rows.push(row);
        }
    }
    size - gauss(rows).1.len()
}

fn members_are_parallel<T: RationalField>(mesh: &Mesh<T>, space: &ParallelSpace<'_, T>) {
    let (basis, translations) = (space.basis(), space.translations());
    assert_eq!(basis.len(), space.dimension_modulo_translations());
    assert_eq!(translations.len(), 3 * space.component_count());
    assert_eq!(basis.len() + translations.len(), space.dimension());
    let all: Vec<&Mesh<T>> = basis.iter().chain(&translations).collect();
    for (k, member) in all.iter().enumerate() {
        assert!(is_parallel(mesh, member), "element {k}");
        assert_eq!(member.topology, mesh.topology);
    }
    let coordinates = |m: &&Mesh<T>| -> Vec<T> {
        m.points.iter().flat_map(|p| p.coordinates().map(T::clone)).collect()
    };
    let rows: Vec<Vec<T>> = all.iter().map(coordinates).collect();
    assert_eq!(gauss(rows).1.len(), space.dimension(), "a basis is independent");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// All combinatorics, points that often coincide, faces that are rarely planar.
    #[test]
    fn parallel_dimensions_are_those_of_coordinates(mesh in any_mesh(small())) {
        let space = parallel_space(&mesh);
        prop_assert_eq!(space.dimension(), dimension_by_coordinates(&mesh));
        members_are_parallel(&mesh, &space);
        let working = mesh.map(|x| x.convert::<Rational>());
        let again = parallel_space(&working);
        prop_assert_eq!(space.dimension(), again.dimension());
        let basis: Vec<_> = again.basis().iter().map(|m| m.map(|x| x.convert::<Q>())).collect();
        prop_assert_eq!(space.basis(), basis, "both exact scalars give the same basis");
    }

    #[test]
    fn v_parallel_dimensions_are_those_of_gauss(mesh in any_mesh(small())) {
        let space = v_parallel_space(&mesh);
        let determinant = |z: &[Q], [a, b, c, d]: [usize; 4]| {
            let at = |v: usize| {
                Point::new(mesh.points[v].x.clone(), mesh.points[v].y.clone(), z[v].clone())
            };
            Vector3::det(&(&at(b) - &at(a)), &(&at(c) - &at(a)), &(&at(d) - &at(a)))
        };
        // All quadruples of every face: planarity is linear in the heights.
        let mut rows = Vec::new();
        for f in mesh.topology.faces() {
            let face: Vec<usize> = mesh.topology.face(f).iter().map(|v| v.index()).collect();
            let k = face.len();
            let quadruples = (0..k).flat_map(|a| (0..a).flat_map(move |b| {
                (0..b).flat_map(move |c| (0..c).map(move |d| [a, b, c, d]))
            }));
            for at in quadruples.map(|at| at.map(|i| face[i])) {
                let unit = |v: usize| (0..mesh.points.len()).map(|i| q((i == v).into())).collect();
                let values = (0..mesh.points.len()).map(|v| determinant(&Vec::from_iter::<Vec<Q>>(unit(v)), at));
                rows.push(values.collect::<Vec<Q>>());
            }
        }
        prop_assert_eq!(space.dimension(), mesh.points.len() - gauss(rows).1.len());
        for member in space.basis() {
            let heights: Vec<Q> = member.points.iter().map(|p| p.z.clone()).collect();
            prop_assert!(space.contains(&heights));
        }
    }

    #[test]
    fn translational_nets_scale_their_profiles(mesh in translational()) {
        let space = parallel_space(&mesh);
        let (m, n) = sides(&mesh);
        prop_assert_eq!(space.dimension_modulo_translations(), m + n);
        members_are_parallel(&mesh, &space);
        let heights = v_parallel_space(&mesh);
        prop_assert_eq!(heights.dimension(), m + n + 1);
        prop_assert!(heights.contains(&lift(&mesh)));
    }

    #[test]
    fn circular_nets_lift_to_the_unit_i_sphere(mesh in circular()) {
        let space = v_parallel_space(&mesh);
        let (m, n) = sides(&mesh);
        prop_assert_eq!(space.dimension(), m + n + 1);
        prop_assert!(space.contains(&lift(&mesh)));
        prop_assert!(space.contains(&mesh.points.iter().map(|p| p.z.clone()).collect::<Vec<_>>()));
        let affine = |p: &Point<Q>| q(3) * &p.x - q(2) * &p.y + q(5);
        prop_assert!(space.contains(&mesh.points.iter().map(affine).collect::<Vec<_>>()));
        prop_assert_eq!(parallel_space(&mesh).dimension(), m + n + 3);
    }
}

/// `z = |x'|² / 2` at all vertices.
fn lift(mesh: &Mesh<Q>) -> Vec<Q> {
    mesh.points.iter().map(|p| p.top_view().norm2() / q(2)).collect()
}

/// The numbers of rows and columns of a patch: from its faces and its vertices.
fn sides(mesh: &Mesh<Q>) -> (usize, usize) {
    let (faces, vertices) = (mesh.topology.face_count(), mesh.points.len());
    let sum = vertices - faces - 1;
    let m = (1..=sum).find(|m| m * (sum - m) == faces).expect("a patch");
    (m, sum - m)
}

#[test]
fn a_general_patch_has_one_dimension_for_every_row_and_column() {
    for (m, n) in [(1, 1), (1, 6), (4, 3), (9, 8)] {
        let patch = flat(m, n);
        assert_eq!(v_parallel_space(&patch).dimension(), m + n + 1, "{m} × {n}");
        assert_eq!(parallel_space(&patch).dimension(), m + n + 3, "{m} × {n}");
    }
    members_are_parallel(&flat(3, 3), &parallel_space(&flat(3, 3)));
}

#[test]
fn one_vertex_moved_costs_dimensions() {
    // The top view of a 2 × 2 patch of squares; a lift of any quads has 2 + 2 + 1 dimensions.
    let grid = mesh(
        &[
            [0, 0, 0],
            [0, 1, 1],
            [0, 2, 4],
            [1, 0, 1],
            [1, 1, 2],
            [1, 2, 5],
            [2, 0, 4],
            [2, 1, 5],
            [2, 2, 8],
        ],
        &[&[0, 3, 4, 1], &[1, 4, 5, 2], &[3, 6, 7, 4], &[4, 7, 8, 5]],
    );
    assert_eq!(parallel_space(&grid).dimension_modulo_translations(), 4);
    assert!(v_parallel_space(&grid).contains(&lift(&grid)));
    let mut bent = grid.clone();
    bent.points[8].z = q(9);
    assert_eq!(parallel_space(&bent).dimension_modulo_translations(), 3, "one face is not planar");
    assert_eq!(v_parallel_space(&bent).dimension(), 5, "the top view is the same");
    let mut moved = grid.clone();
    moved.points[8].x = q(3);
    assert!(!v_parallel_space(&moved).contains(&lift(&moved)), "one face is not concyclic");
    assert_eq!(v_parallel_space(&moved).dimension(), 5);
    let mut heights = lift(&grid);
    heights[4] += &q(1);
    assert!(!v_parallel_space(&grid).contains(&heights));
    assert!(!v_parallel_space(&grid).contains(&heights[1..]), "one height is missing");
}

#[test]
fn triangle_meshes_have_all_heights_and_only_similar_parallels() {
    let patch = triangles(4, 3);
    assert_eq!(v_parallel_space(&patch).dimension(), patch.points.len());
    let space = parallel_space(&patch);
    assert_eq!((space.dimension(), space.dimension_modulo_translations()), (4, 1));
    members_are_parallel(&patch, &space);
}

/// Trivalent meshes: face planes move freely, and at the boundary the lines of the edges in them.
/// Two faces meet in a boundary vertex with two planes and two lines: one condition.
#[test]
fn trivalent_meshes_move_their_face_planes() {
    let cube = cube();
    assert_eq!(parallel_space(&cube).dimension(), 6, "width, depth, height and translations");
    members_are_parallel(&cube, &parallel_space(&cube));
    let trivalent = metric_dual(&triangles(5, 4)).expect("no vertical triangle");
    let t = &trivalent.topology;
    let boundary_edges = t.edges().filter(|&h| t.twin(h).is_none()).count();
    let of_two_faces = t
        .vertices()
        .filter(|&v| t.kind(v) == VertexKind::Boundary && t.star(v).count() == 2)
        .count();
    let space = parallel_space(&trivalent);
    // Vertices in no face are components of their own.
    let isolated = t.vertices().filter(|&v| t.kind(v) == VertexKind::Isolated).count();
    let expected = t.face_count() + boundary_edges - of_two_faces + 3 * isolated;
    assert_eq!(space.dimension(), expected);
    members_are_parallel(&trivalent, &space);
    assert_eq!(space.dimension(), dimension_by_coordinates(&trivalent));
}

#[test]
fn components_count_one_by_one() {
    let mut points: Vec<Point<Q>> = cube().points;
    points.extend(triangles(1, 1).points);
    points.push(Point::new(q(0), q(0), q(9)));
    let mut faces = FaceList::new();
    for (source, offset) in [(cube(), 0), (triangles(1, 1), 8)] {
        for f in source.topology.faces() {
            faces.push(source.topology.face(f).iter().map(|v| v.0 + offset));
        }
    }
    let both = Mesh::new(points, faces).expect("two components and a vertex");
    let space = parallel_space(&both);
    assert_eq!((space.component_count(), space.dimension()), (3, 3 + 1 + 9));
    members_are_parallel(&both, &space);
}

/// A tube of `n` quads around a cube without top and bottom, and a torus of quads.
#[test]
fn cycles_that_no_face_fills_close() {
    let cube = cube();
    let mut faces = FaceList::new();
    for f in cube.topology.faces().skip(2) {
        faces.push(cube.topology.face(f).iter().map(|v| v.0));
    }
    let tube = Mesh::new(cube.points, faces).expect("an annulus");
    let space = parallel_space(&tube);
    assert_eq!(space.dimension_modulo_translations(), 3, "without the cycle it would be 5");
    members_are_parallel(&tube, &space);
    // The product of two polygons, 4 × 3: a torus of parallelograms that does not embed.
    let (p, r) = ([[0, 0], [3, 1], [4, 5], [-1, 3]], [[0, 0], [5, -1], [2, 7]]);
    let place = |i: usize, j: usize| {
        [p[i][0] + r[j][0], p[i][1] + 2 * r[j][1], p[i][0] * p[i][1] - r[j][0]]
    };
    let points: Vec<_> = (0..12).map(|k| place(k / 3, k % 3)).collect();
    let at = |i: u32, j: u32| (i % 4) * 3 + j % 3;
    let quads: Vec<[u32; 4]> = (0..12)
        .map(|k| (k / 3, k % 3))
        .map(|(i, j)| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])
        .collect();
    let quads: Vec<&[u32]> = quads.iter().map(|f| &f[..]).collect();
    let torus = mesh(&points, &quads);
    assert_eq!(torus.topology.euler_characteristic(), 0);
    let space = parallel_space(&torus);
    assert_eq!(space.dimension(), dimension_by_coordinates(&torus));
    assert_eq!(space.dimension_modulo_translations(), 1 + 1, "polygons of 4 and 3 edges in space");
    members_are_parallel(&torus, &space);
}

#[test]
fn an_edge_of_length_zero_is_parallel_to_all() {
    let collapsed = mesh(&[[0, 0, 0], [2, 0, 0], [2, 0, 0], [0, 1, 0]], &[&[0, 1, 2, 3]]);
    let space = parallel_space(&collapsed);
    assert_eq!(space.dimension(), dimension_by_coordinates(&collapsed));
    assert_eq!(space.dimension_modulo_translations(), 3);
    members_are_parallel(&collapsed, &space);
    let point = mesh(&[[1, 1, 1]; 4], &[&[0, 1, 2], &[0, 2, 3]]);
    assert_eq!(parallel_space(&point).dimension(), 12, "everything is parallel to a point");
}

#[test]
fn vertical_faces_are_planar_with_any_heights() {
    let wall = mesh(&[[0, 0, 0], [1, 1, 5], [2, 2, 1], [3, 3, 8]], &[&[0, 1, 2, 3]]);
    assert_eq!(v_parallel_space(&wall).dimension(), 4);
    assert_eq!(v_parallel_space(&wall).free_vertices().len(), 4);
}

#[test]
fn a_basis_of_a_larger_circular_net_contains_the_net() {
    let line = |along_x: bool| -> Vec<Point<Q>> {
        let place = |i: i64| if along_x { (4 * i, i * i % 3) } else { (i % 2, 4 * i) };
        let places = (0..=4).map(place);
        places.map(|(x, y)| Point::new(q(x), q(y), Q::from_ratio(x * x + y, 7))).collect()
    };
    let net = circular_net(&line(true), &line(false), |_, _| Q::from_ratio(2, 5));
    let net = net.expect("no degenerate face").expect("a patch");
    let space = v_parallel_space(&net);
    assert_eq!(space.dimension(), 9);
    let free = space.free_vertices();
    let basis = space.basis();
    for (v, point) in net.points.iter().enumerate() {
        let terms = basis.iter().zip(&free).map(|(b, f)| &b.points[v].z * &net.points[f.index()].z);
        assert_eq!(terms.fold(q(0), |s, t| s + t), point.z, "vertex {v}");
    }
}
