//! Exact meshes that are proved to exist near meshes in doubles, and proofs that must fail.

use isogeo::check::{Element, Plain, Verdict};
use isogeo::construct::circular_net;
use isogeo::mesh::{FaceId, FaceList, Mesh, VertexId};
use isogeo::net::{Net, Property};
use isogeo::optimise::existence::{Certificate, Existence, NoProof, NotVerified, Pinned, prove};
use isogeo::optimise::{Design, Ending, Goal, Mobility};
use isogeo::scalar::{Approx, Field, Numeral, Rational, Ring};
use isogeo::space::Point;
use serde_json::json;

use super::goals::{patch, run, star};

const GOALS: [Goal; 4] = [Goal::Planar, Goal::ICircular, Goal::IConical, Goal::Circular];

fn exact(mesh: &Mesh<f64>) -> Mesh<Rational> {
    mesh.map(|c| Numeral::from_f64(*c).expect("finite").value())
}

fn proof(mesh: &Mesh<f64>, goal: Goal) -> Result<Existence, NoProof> {
    prove(&mesh.topology, &mesh.points, goal, &Pinned::Nothing)
}

fn optimised(mesh: &Mesh<f64>, goal: Goal) -> Mesh<f64> {
    let found = run(&Design::new(goal, mesh.points.len()), mesh);
    assert_eq!(found.ending, Ending::Converged);
    Mesh { points: found.points, ..mesh.clone() }
}

/// A square whose corner 2 lies at the given point.
fn square(corner: [f64; 3]) -> Mesh<f64> {
    let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], corner, [0.0, 1.0, 0.0]];
    let points = points.map(|[x, y, z]| Point::new(x, y, z)).to_vec();
    Mesh::new(points, quad(4)).expect("a mesh")
}

fn quad(n: u32) -> FaceList {
    let mut faces = FaceList::new();
    faces.push(0..n);
    faces
}

#[test]
fn what_reaches_a_goal_has_an_exact_mesh_near() {
    let mesh = patch(5);
    for goal in GOALS {
        let found = optimised(&mesh, goal);
        let name = goal.property().name();
        let proved = proof(&found, goal).unwrap_or_else(|reason| panic!("{name}: {reason}"));
        assert!(proved.radius < 1e-14, "{name}: {proved:?}");
        assert!(proved.radius <= proved.distance, "{name}: {proved:?}");
        // The control: before, it was no such mesh, and none is proved to be that near.
        let before = proof(&mesh, goal).map(|proved| proved.radius);
        assert!(before.as_ref().map_or(true, |radius| *radius > 1e-5), "{name}: {before:?}");
    }
}

#[test]
fn faces_and_vertices_of_any_size_are_proved() {
    let mesh = star(|x, y| 0.5 * (x * x + y * y) + 0.1 * x * y + 0.02 * x * x * y);
    for goal in [Goal::Planar, Goal::ICircular, Goal::IConical] {
        let proved = proof(&optimised(&mesh, goal), goal);
        assert!(proved.as_ref().is_ok_and(|proved| proved.radius < 1e-14), "{goal:?}: {proved:?}");
    }
    let reason = NoProof::NotPolynomial { name: "cone of revolution" };
    assert_eq!(proof(&mesh, Goal::Conical), Err(reason));
}

/// Three corners are pinned, and the fourth has one way to go: to height 0.
#[test]
fn the_distance_to_the_only_exact_mesh_is_the_radius() {
    let height = 0.1 + 0.2 - 0.3;
    let mesh = square([1.0, 1.0, height]);
    let pinned = Pinned::Vertices([0, 1, 3].map(VertexId).to_vec());
    let proved = prove(&mesh.topology, &mesh.points, Goal::Planar, &pinned).expect("a proof");
    assert!(proved.radius >= height);
    assert!(proved.radius <= height * (1.0 + 1e-12));
    // All four share the way if they may.
    let proved = proof(&mesh, Goal::Planar).expect("a proof");
    assert!(proved.distance >= height / 2.0 && proved.distance <= height * (0.5 + 1e-12));
    assert!(proved.radius >= height / 4.0 && proved.radius <= height * (0.25 + 1e-12));
}

/// A point goes straight to the unit circle: its distance is irrational and known to many digits.
#[test]
fn the_distance_to_a_circle_is_the_radius() {
    for corner in [[0.6, -0.8], [0.28, -0.96], [0.6, -0.801], [-0.1, -0.999]] {
        let points = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], corner];
        let points = points.map(|[x, y]| Point::new(x, y, 0.0)).to_vec();
        let mesh = Mesh::new(points, quad(4)).expect("a mesh");
        let pinned = Pinned::Vertices([0, 1, 2].map(VertexId).to_vec());
        let proved =
            prove(&mesh.topology, &mesh.points, Goal::ICircular, &pinned).expect("a proof");
        // 1 − |p| = (1 − |p|²) / (1 + |p|), where only the denominator is rounded.
        let [x, y] = corner.map(|c| Numeral::from_f64(c).expect("finite").value::<Rational>());
        let power = Rational::one() - x.square() - y.square();
        let length = (corner[0] * corner[0] + corner[1] * corner[1]).sqrt();
        let distance = power.to_f64().abs() / (1.0 + length);
        assert!(proved.radius >= distance * (1.0 - 1e-12), "{corner:?}: {proved:?}");
        // The gradient at the point is not quite that on the way.
        assert!(proved.radius <= distance * (1.0 + 1e-5), "{corner:?}: {proved:?} {distance:e}");
    }
}

/// An exact net, rounded: the exact mesh that is found is not farther than the one that was there.
#[test]
fn the_exact_mesh_is_not_farther_than_the_one_that_was_rounded() {
    let q = |p, d| Rational::from_ratio(p, d);
    let along = |i: i64, x: i64, y: i64| {
        Point::new(q(x * i, 3) + q(i * i, 17), q(y * i, 3) + q(i, 19), q(i * i, 7) + q(i * y, 5))
    };
    let rows: Vec<_> = (0..4).map(|i| along(i, 1, 0)).collect();
    let columns: Vec<_> = (0..4).map(|i| along(i, 0, 1)).collect();
    let ratio = |i: usize, j: usize| q(7 + i as i64 - j as i64, 15);
    let net = circular_net(&rows, &columns, ratio).expect("a net").expect("a mesh");
    let report = Net::new(&net.topology, &Plain(&net.points)).check(Property::ICircular);
    assert_eq!(report.verdict(), Verdict::Proved);
    let rounded = net.map(Approx::to_f64);
    let doubles = exact(&rounded);
    let squares = net.points.iter().zip(&doubles.points).map(|(p, r)| {
        let d = p - r;
        (d.x.square() + d.y.square() + d.z.square()).to_f64()
    });
    let distance = squares.sum::<f64>().sqrt();
    assert!(distance > 0.0);
    for goal in [Goal::Planar, Goal::ICircular] {
        let proved = proof(&rounded, goal).expect("a proof");
        assert!(proved.distance > 0.0);
        assert!(proved.distance < distance * (1.0 + 1e-9), "{goal:?}: {proved:?} {distance:e}");
    }
    // The control: one coordinate farther away, and so is the exact mesh.
    let mut moved = rounded.clone();
    moved.points[5].z += 1e-9;
    let proved = proof(&moved, Goal::ICircular).expect("a proof");
    assert!(proved.distance > distance);
}

#[test]
fn pinned_vertices_stay() {
    let mesh = patch(4);
    let mut design = Design::new(Goal::Planar, mesh.points.len());
    for v in mesh.topology.boundary_loops().concat() {
        design.mobility[v.index()] = Mobility::Fixed;
    }
    let mesh = Mesh { points: run(&design, &mesh).points, ..mesh };
    for pinned in [Pinned::Boundary, Pinned::of(&design.mobility)] {
        let proved = prove(&mesh.topology, &mesh.points, Goal::Planar, &pinned);
        assert!(proved.as_ref().is_ok_and(|proved| proved.radius < 1e-14), "{proved:?}");
    }
    // If nothing may move, nothing can be made exact.
    let all = Pinned::Vertices(mesh.topology.vertices().collect());
    let found = prove(&mesh.topology, &mesh.points, Goal::Planar, &all);
    assert!(matches!(found, Err(NoProof::Rigid { name: "planar", .. })), "{found:?}");
    let found =
        prove(&mesh.topology, &mesh.points, Goal::Planar, &Pinned::Vertices(vec![VertexId(99)]));
    assert_eq!(found, Err(NoProof::NoSuchVertex(VertexId(99))));
}

/// If three planar faces at a vertex of a cube have i-circles, all six have: the vertices lie on an i-sphere. So
/// conditions depend on each other, although the mesh is exact.
#[test]
fn dependent_conditions_are_no_proof() {
    let ring =
        |r: f64, z: f64| [[r, r], [-r, r], [-r, -r], [r, -r]].map(|[x, y]| Point::new(x, y, z));
    let points = [ring(1.0, 1.0), ring(2.0, 0.0)].concat();
    let mut faces = FaceList::new();
    faces.push([0, 1, 2, 3]);
    faces.push([7, 6, 5, 4]);
    for i in 0..4 {
        let j = (i + 1) % 4;
        faces.push([i, 4 + i, 4 + j, j]);
    }
    let cube = Mesh::new(points.clone(), faces).expect("a mesh");
    let property = Property::ICircular;
    let rational = exact(&cube);
    let report = Net::new(&cube.topology, &Plain(&rational.points)).check(property);
    assert_eq!(report.verdict(), Verdict::Proved);
    let found = proof(&cube, Goal::ICircular);
    assert!(matches!(found, Err(NoProof::Dependent { .. })), "{found:?}");
    assert!(proof(&cube, Goal::Planar).is_ok());
    // It is said where, also in a larger mesh.
    let mut more = FaceList::new();
    more.push([8, 9, 10, 11]);
    cube.topology.faces().for_each(|f| more.push(cube.topology.face(f).iter().map(|v| v.0)));
    let beside =
        [[5.0, 0.0], [6.0, 0.0], [6.0, 1.0], [5.0, 1.0]].map(|[x, y]| Point::new(x, y, 0.0));
    let both = Mesh::new([points.clone(), beside.to_vec()].concat(), more).expect("a mesh");
    match proof(&both, Goal::ICircular) {
        Err(NoProof::Dependent { at, .. }) => assert!(at.iter().all(|v| v.0 < 8), "{at:?}"),
        other => panic!("{other:?}"),
    }
    // The control: with the three faces at vertex 1 there is a proof.
    let mut three = FaceList::new();
    for f in [0, 2, 3].map(FaceId) {
        three.push(cube.topology.face(f).iter().map(|v| v.0));
    }
    let open = Mesh::new(points, three).expect("a mesh");
    assert!(proof(&open, Goal::ICircular).is_ok());
}

#[test]
fn what_is_far_away_is_no_proof() {
    // A corner far above the square: the derivative changes too much on the way.
    let found = proof(&square([1.0, 1.0, 40.0]), Goal::ICircular);
    assert!(matches!(found, Err(NoProof::TooFar { .. })), "{found:?}");
    let found = proof(&square([f64::NAN, 1.0, 0.0]), Goal::ICircular);
    assert!(found.is_err(), "{found:?}");
    let found = proof(&square([1.0, f64::MAX, 0.0]), Goal::ICircular);
    assert!(found.is_err(), "{found:?}");
}

#[test]
fn vertical_faces_have_no_i_circle() {
    // A square, exactly, and a vertical triangle at one of its edges.
    let points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 1]];
    let points: Vec<_> =
        points.map(|p| p.map(f64::from)).map(|[x, y, z]| Point::new(x, y, z)).into();
    let mut faces = quad(4);
    faces.push([1, 0, 4]);
    let mut mesh = Mesh::new(points, faces).expect("a mesh");
    let found = proof(&mesh, Goal::ICircular);
    assert_eq!(found, Err(NoProof::Degenerate(Element::Face(FaceId(1)))));
    assert!(proof(&mesh, Goal::Planar).is_ok());
    assert!(proof(&mesh, Goal::Circular).is_ok());
    mesh.points[4].y = 0.5;
    assert!(proof(&mesh, Goal::ICircular).is_ok());
}

#[test]
fn what_asks_for_nothing_is_not_proved() {
    let triangle = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|[x, y]| Point::new(x, y, x * y));
    let mesh = Mesh::new(triangle.to_vec(), quad(3)).expect("a mesh");
    assert_eq!(proof(&mesh, Goal::ICircular), Err(NoProof::Vacuous));
    assert_eq!(proof(&square([1.0, 1.0, 0.0]), Goal::IConical), Err(NoProof::Vacuous));
}

/// A mesh with its certificate, both as they stand in a file.
fn certified() -> (Mesh<Rational>, Certificate) {
    let mesh = exact(&optimised(&patch(4), Goal::ICircular));
    let made = Certificate::make(&mesh.topology, &mesh.points, Goal::ICircular, Pinned::Nothing);
    (mesh, made.expect("a proof").0)
}

#[test]
fn a_certificate_is_verified_from_the_mesh_alone() {
    let (mesh, certificate) = certified();
    let read = Certificate::read(&certificate.json()).expect("what was written");
    assert_eq!(read, certificate);
    let proved = read.verify(&mesh.topology, &mesh.points).expect("the same proof");
    assert!(proved.radius < read.radius.to_f64());
    assert!(read.covers(Property::ICircular) && read.covers(Property::Planar));
    assert!(!read.covers(Property::IConical));
}

#[test]
fn false_certificates_fail() {
    let (mesh, certificate) = certified();
    let verify = |claim: &Certificate, mesh: &Mesh<Rational>| {
        claim.verify(&mesh.topology, &mesh.points).expect_err("a false claim")
    };
    // Too small a radius.
    let radius = &certificate.radius * Rational::from_ratio(1, 2);
    let claim = Certificate { radius, ..certificate.clone() };
    assert!(matches!(verify(&claim, &mesh), NotVerified::Farther(_)));
    // A disturbed mesh, and one that is not in doubles.
    let mut moved = mesh.clone();
    moved.points[7].x = moved.points[7].x.clone() + Rational::from_ratio(1, 1 << 40);
    assert!(matches!(verify(&certificate, &moved), NotVerified::Farther(_)));
    moved.points[7].x = Rational::from_ratio(1, 3);
    assert_eq!(verify(&certificate, &moved), NotVerified::NoDoubles(VertexId(7)));
    // Another property.
    let claim = Certificate { goal: Goal::IConical, ..certificate.clone() };
    assert!(matches!(verify(&claim, &mesh), NotVerified::Farther(_) | NotVerified::NoProof(_)));
    // Vertices that cannot stay.
    let all = Pinned::Vertices(mesh.topology.vertices().collect());
    let claim = Certificate { pinned: all, ..certificate };
    assert!(matches!(verify(&claim, &mesh), NotVerified::NoProof(NoProof::Rigid { .. })));
}

#[test]
fn what_is_no_certificate_is_said() {
    for (claim, why) in [
        (json!("i-circular"), "no object"),
        (json!({ "property": "inscribed", "radius": "1" }), "no property"),
        (json!({ "property": "planar" }), "no radius"),
        (json!({ "property": "planar", "radius": 1.0 }), "no radius"),
        (json!({ "property": "planar", "radius": "1/0" }), "no radius"),
        (json!({ "property": "planar", "radius": "1", "pinned": "corner" }), "boundary"),
        (json!({ "property": "planar", "radius": "1", "pinned": [-1] }), "boundary"),
        (json!({ "property": "planar", "radius": "1", "trusted": true }), "other members"),
    ] {
        let found = Certificate::read(&claim).expect_err("no certificate").to_string();
        assert!(found.contains(why), "{claim}: {found}");
    }
}
