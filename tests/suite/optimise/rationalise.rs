//! From doubles back to exact meshes: what comes out is decided exactly.

use std::collections::BTreeMap;

use isogeo::check::{Decider, Verdict};
use isogeo::construct::hexagonal::HexagonalRings;
use isogeo::construct::{circular_net, metric_dual, quad_patch};
use isogeo::mesh::{FaceId, FaceList, Mesh, VertexId};
use isogeo::net::{Net, Property};
use isogeo::optimise::rationalise::*;
use isogeo::scalar::{Approx, Field, Rational};
use isogeo::space::{Point, Rotation};
use proptest::prelude::*;

use super::shapes::{dual, inverted, rings, with_noise, zonohedron};
use crate::meshes::circular;

type Method = fn(&Mesh<f64>, &Options) -> Result<Rationalised, NoExactMesh>;

const METHODS: [(Property, Method); 3] = [
    (Property::Planar, planar),
    (Property::ICircular, i_circular),
    (Property::IConical, i_conical),
];

fn verdict(mesh: &Mesh<Rational>, property: Property) -> Verdict {
    let decider = Decider::of_rationals(&mesh.points);
    Net::new(&mesh.topology, &decider).check(property).verdict()
}

fn list(faces: impl IntoIterator<Item = Vec<u32>>) -> FaceList {
    let mut list = FaceList::new();
    faces.into_iter().for_each(|face| list.push(face));
    list
}

/// What is asked of every result: the same combinatorics, near, proved; and a coordinate disturbs it.
fn succeeds(mesh: &Mesh<f64>, within: f64, (property, method): (Property, Method)) -> u64 {
    let options = Options { within, ..Options::of(&mesh.points) };
    let found = method(mesh, &options).unwrap_or_else(|reason| panic!("{property:?}: {reason}"));
    assert_eq!(found.mesh.topology, mesh.topology);
    assert!(found.movement.largest <= within, "{property:?}: {:?}", found.movement);
    assert!(found.movement.rms <= found.movement.largest);
    let apart = mesh
        .points
        .iter()
        .zip(&found.mesh.points)
        .map(|(p, q)| (&q.map(Approx::to_f64) - p).length2().sqrt());
    assert_eq!(apart.fold(0.0, f64::max), found.movement.largest);
    assert_eq!(verdict(&found.mesh, property), Verdict::Proved);
    let again = method(mesh, &options).expect("as before");
    assert_eq!(again.mesh, found.mesh);
    let mut disturbed = found.mesh;
    let middle = mesh.points.len() / 2;
    let little = Rational::from_ratio(1, 1 << 40);
    disturbed.points[middle].y += &little;
    disturbed.points[middle].z += &little;
    assert_eq!(verdict(&disturbed, property), Verdict::Refuted);
    found.bits
}

#[test]
fn grids() {
    let (circular, conical) = (with_noise(&inverted(10), 1e-12), with_noise(&dual(10), 1e-12));
    let bits = succeeds(&circular, 1e-6, METHODS[0]);
    assert!(bits < 400, "a few for every step: {bits}");
    let bits = succeeds(&circular, 1e-4, METHODS[1]);
    assert!(bits < 1500, "a few for every face: {bits}");
    let bits = succeeds(&conical, 1e-4, METHODS[2]);
    assert!(bits < 2000, "{bits}");
}

#[test]
fn grids_of_practical_size() {
    let options = |mesh: &Mesh<f64>| Options { within: 1e-3, ..Options::of(&mesh.points) };
    let mesh = with_noise(&inverted(30), 1e-12);
    let [planar, circular] = [METHODS[0], METHODS[1]].map(|(property, method)| {
        let found = method(&mesh, &options(&mesh)).expect("a mesh");
        assert_eq!(verdict(&found.mesh, property), Verdict::Proved);
        assert!(found.movement.largest < 1e-3);
        found.bits
    });
    assert!(planar < 500 && circular < 6000, "{planar}, {circular}");
}

/// A sector of a surface of revolution is planar, i-circular and i-conical.
#[test]
fn trapezoids() {
    let points = (0..=8).flat_map(|i| (0..=8).map(move |j| (i, j))).map(|(i, j)| {
        let (r, angle) = (1.0 + f64::from(i) / 8.0, f64::from(j) / 9.0);
        Point::new(r * angle.cos(), r * angle.sin(), r * r * r / 4.0)
    });
    let mesh = Mesh::new(points.collect(), quad_patch(8, 8)).expect("a patch");
    for method in METHODS {
        succeeds(&with_noise(&mesh, 1e-13), 1e-4, method);
    }
}

#[test]
fn hexagons() {
    let rotation = Rotation::new(Rational::from_ratio(12, 13), Rational::from_ratio(5, 13));
    let slopes = (0..8).map(|k| Rational::from_ratio(3i64.pow(k), 2i64.pow(k))).collect();
    let rings = HexagonalRings::new(rotation.expect("a rotation"), slopes).expect("rings");
    let exact = rings.mesh(&rings.circumscribed(), 12).expect("hexagons");
    let mesh = with_noise(&exact.map(Approx::to_f64), 1e-12);
    let bits = succeeds(&mesh, 1e-6, METHODS[0]);
    assert!(bits < 150, "planes are free: {bits}");
}

/// The cross-ratio −1 around a vertex: discrete powers in sectors, lifted to Σ.
fn star(sectors: u32, n: usize) -> Mesh<f64> {
    let gamma = 4.0 / f64::from(sectors);
    let mut radii = vec![0.0, 1.0];
    for k in 1..n {
        let (last, here) = (radii[k - 1], radii[k]);
        let step = 2.0 * k as f64 * (here - last);
        radii.push(here * (gamma * last - step) / (gamma * here - step));
    }
    let ray = |k: u32| {
        let (s, c) = (std::f64::consts::TAU / f64::from(sectors) * f64::from(k)).sin_cos();
        radii.iter().map(|r| Point::new(r * c, r * s, r * r / 2.0)).collect::<Vec<_>>()
    };
    let (mut names, mut points) = (BTreeMap::new(), Vec::new());
    let mut faces = Vec::new();
    for k in 0..sectors {
        let sector =
            circular_net(&ray(k), &ray(k + 1), |_, _| 0.5).expect("regular").expect("a mesh");
        let mut name = |v: &VertexId| {
            let (i, j) = (v.index() / (n + 1), v.index() % (n + 1));
            let key = match (i, j) {
                (0, 0) => (0, 0, 0),
                (i, 0) => (k, i, 0),
                (0, j) => ((k + 1) % sectors, j, 0),
                (i, j) => (k, i, j),
            };
            *names.entry(key).or_insert_with(|| {
                points.push(sector.points[v.index()]);
                points.len() as u32 - 1
            })
        };
        let corners = |f| sector.topology.face(f).to_vec();
        for face in sector.topology.faces().map(corners) {
            faces.push(face.iter().map(&mut name).collect());
        }
    }
    Mesh::new(points, list(faces)).expect("a star")
}

#[test]
fn vertices_of_three_and_five_faces() {
    for sectors in [3, 5, 6] {
        let mesh = with_noise(&star(sectors, 4), 1e-13);
        succeeds(&mesh, 1e-5, METHODS[0]);
        succeeds(&mesh, 1e-3, METHODS[1]);
    }
    let options = Options::of(&star(3, 2).points);
    let error = i_conical(&star(3, 2), &options).expect_err("a vertex of three faces");
    assert_eq!((error.at, error.why), (Element::Vertex(VertexId(0)), Obstacle::NotRegular));
}

/// A grid without some faces in the middle.
#[test]
fn a_hole() {
    let whole = inverted(9);
    let middle =
        |f: &FaceId| (3..6).contains(&(f.index() / 9)) && (3..5).contains(&(f.index() % 9));
    let faces = whole.topology.faces().filter(|f| !middle(f));
    let faces = faces.map(|f| whole.topology.face(f).iter().map(|v| v.0).collect());
    let mesh = Mesh::new(whole.points.clone(), list(faces)).expect("a mesh");
    let (isolated, rest) =
        (mesh.topology.component_count() - 1, mesh.topology.boundary_loops().len());
    assert_eq!((isolated, rest), (2, 2));
    succeeds(&with_noise(&mesh, 1e-12), 1e-5, METHODS[0]);
    let error = i_circular(&mesh, &Options::of(&mesh.points)).expect_err("a hole");
    assert_eq!(error.why, Obstacle::Stuck);
}

/// Rings of quads around a hole: they close in a linear system.
#[test]
fn closed_rings() {
    let mesh = rings(9, 14, 1.0 / 4.0);
    let bits = succeeds(&with_noise(&mesh, 1e-13), 1e-5, METHODS[0]);
    assert!(bits < 8000, "{bits}");
}

#[test]
fn closed_meshes() {
    let zonohedron = zonohedron(7);
    assert_eq!(zonohedron.topology.euler_characteristic(), 2);
    succeeds(&with_noise(&zonohedron, 1e-13), 1e-5, METHODS[0]);
    // A sheared cube of 2 × 2 × 6 flat quads.
    let (mut names, mut points, mut faces) = (BTreeMap::new(), Vec::new(), Vec::new());
    let mut name = |p: [i32; 3]| {
        *names.entry(p).or_insert_with(|| {
            let [x, y, z] = p.map(|c| f64::from(c) - 1.0);
            points.push(Point::new(x + 0.3 * y, y + 0.1 * z, z + 0.2 * x));
            points.len() as u32 - 1
        })
    };
    for (k, side) in [(0, 0), (0, 2), (1, 0), (1, 2), (2, 0), (2, 2)] {
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let mut corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| {
                let mut p = [side, i, j];
                p.rotate_right(k);
                name(p)
            });
            if side == 0 {
                corners.reverse();
            }
            faces.push(corners.to_vec());
        }
    }
    let cube = Mesh::new(points, list(faces)).expect("closed");
    succeeds(&with_noise(&cube, 1e-13), 1e-5, METHODS[0]);
}

/// Walls have no poles, and need none.
#[test]
fn vertical_faces() {
    let points = (0..5).flat_map(|i| [0.0, 1.0].map(|z| (f64::from(i), z)));
    let points = points.map(|(x, z)| Point::new(x, x * x / 3.0, z + 0.1 * x));
    let faces = (0..4).map(|i| vec![2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1]);
    let mesh = Mesh::new(points.collect(), list(faces)).expect("a wall");
    succeeds(&with_noise(&mesh, 1e-13), 1e-5, METHODS[0]);
    let error = i_conical(&mesh, &Options::of(&mesh.points)).expect_err("no poles");
    assert_eq!((error.at, error.why), (Element::Face(FaceId(0)), Obstacle::Degenerate));
}

/// A mesh that is not planar is moved far, and that is said.
#[test]
fn far_from_the_property() {
    let bent = inverted(6);
    let mut bent = with_noise(&bent, 1e-12);
    bent.points[24].z += 0.1;
    for (property, method) in METHODS {
        let Ok(found) = method(&bent, &Options::of(&bent.points)) else { continue };
        assert!(found.movement.largest > 0.01, "{property:?}: {:?}", found.movement);
        assert_eq!(verdict(&found.mesh, property), Verdict::Proved);
    }
}

#[test]
fn what_stops_it() {
    let mesh = inverted(4);
    let options = Options::of(&mesh.points);
    let mut infinite = mesh.clone();
    infinite.points[3].y = f64::NAN;
    let mut double = mesh.clone();
    double.points[12] = double.points[13];
    let short = Options { most_bits: 20, ..options };
    let torus = (0..3).flat_map(|i| (0..3).map(move |j| (i, j))).map(|(i, j): (u32, u32)| {
        let at = |i: u32, j: u32| 3 * (i % 3) + j % 3;
        vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]
    });
    let torus = Mesh::new(mesh.points[..9].to_vec(), list(torus)).expect("a torus");
    let pentagon =
        Mesh::new(mesh.points[..5].to_vec(), list([vec![0, 1, 2, 3, 4]])).expect("a face");
    // Four faces around a vertex at the boundary.
    let fan = (0..4).map(|k| vec![0, 1 + 2 * k, 2 + 2 * k, 3 + 2 * k]);
    let fan = Mesh::new(star(5, 1).points[..10].to_vec(), list(fan)).expect("a fan");
    let bowl = |m: &Mesh<f64>| {
        let lift = |p: &Point<f64>| Point::new(p.x, p.y, p.x * p.x + 0.3 * p.y * p.y);
        Mesh { points: m.points.iter().map(lift).collect(), ..m.clone() }
    };
    let cases: [(Method, &Mesh<f64>, &Options, &str); 9] = [
        (planar, &infinite, &options, "vertex 3: a coordinate is no finite number"),
        (i_circular, &infinite, &options, "vertex 3: a coordinate is no finite number"),
        (i_conical, &infinite, &options, "vertex 3: a coordinate is no finite number"),
        (i_circular, &double, &options, "what it should be determined by is degenerate"),
        (planar, &mesh, &short, "its numbers become too long"),
        (i_circular, &mesh, &short, "its numbers become too long"),
        (planar, &torus, &options, "vertex 0: no order"),
        (i_circular, &pentagon, &options, "face 0: it is no quad"),
        (i_conical, &bowl(&fan), &options, "vertex 0: more than three face planes"),
    ];
    for (method, mesh, options, reason) in cases {
        let error = method(mesh, options).expect_err(reason);
        assert!(error.to_string().contains(reason), "{error}, not {reason}");
    }
}

#[test]
fn nothing_and_little() {
    let empty = Mesh::new(Vec::new(), FaceList::new()).expect("no mesh");
    let cloud = Mesh::new(inverted(2).points, FaceList::new()).expect("points");
    let triangle = Mesh::new(inverted(2).points[..3].to_vec(), list([vec![0, 1, 2]])).expect("one");
    for (_, method) in METHODS {
        assert_eq!(method(&empty, &Options::of(&[])).expect("nothing").mesh.points, []);
        let found = method(&cloud, &Options::of(&cloud.points)).expect("points");
        assert!(found.movement.largest <= Options::of(&cloud.points).within);
    }
    assert!(planar(&triangle, &Options::of(&triangle.points)).is_ok());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Random i-circular nets, and their duals, come back.
    #[test]
    fn random_nets(mesh in circular(), factor in 1f64..1e4) {
        let doubles = mesh.map(Approx::to_f64);
        let near = |points| {
            let options = Options::of(points);
            Options { within: factor * options.within, ..options }
        };
        let options = near(&doubles.points);
        for (property, method) in &METHODS[..2] {
            let Ok(found) = method(&doubles, &options) else { continue };
            let known = [Verdict::Proved, Verdict::Undecided];
            prop_assert!(known.contains(&verdict(&found.mesh, *property)), "{:?}", property);
            // Edges of some of these nets are thousands of times as long as others.
            let most = 1000.0 * options.within;
            prop_assert!(found.movement.largest <= most, "{:?}: {:?}", property, found.movement);
        }
        if let Ok(dual) = metric_dual(&mesh) {
            let doubles = dual.map(Approx::to_f64);
            if let Ok(found) = i_conical(&doubles, &near(&doubles.points)) {
                let known = [Verdict::Proved, Verdict::Undecided, Verdict::Vacuous];
                prop_assert!(known.contains(&verdict(&found.mesh, Property::IConical)));
            }
        }
    }
}
