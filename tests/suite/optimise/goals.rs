//! Meshes that reach their goals, and some that cannot.

use isogeo::check::Observed;
use isogeo::construct::quad_patch;
use isogeo::mesh::{FaceList, Mesh, VertexId};
use isogeo::net::Net;
use isogeo::optimise::{
    Design, Designed, Ending, Goal, Method, Mobility, Movement, Projection, Stage, System,
};
use isogeo::space::Point;

/// A patch of `n` by `n` quads over a surface with both kinds of curvature, all of its coordinates disturbed.
pub fn patch(n: usize) -> Mesh<f64> {
    disturbed(n, |x, y| 0.3 * (1.7 * x + 0.3).sin() * (1.3 * y - 0.2).cos() + 0.2 * x * y)
}

/// A patch of `n` by `n` quads over the unit square, all of its coordinates disturbed.
fn disturbed(n: usize, height: impl Fn(f64, f64) -> f64) -> Mesh<f64> {
    let point = |i: usize, j: usize| {
        let (x, y) = (i as f64 / n as f64, j as f64 / n as f64);
        let wobble = |k: usize| 0.02 / n as f64 * ((7 * i + 13 * j + 5 * k) as f64 * 2.399).sin();
        Point::new(x + wobble(1), y + wobble(2), height(x, y) + wobble(3))
    };
    let points = (0..=n).flat_map(|i| (0..=n).map(move |j| (i, j))).map(|(i, j)| point(i, j));
    Mesh::new(points.collect(), quad_patch(n, n)).expect("a patch is a mesh")
}

pub fn run(design: &Design, mesh: &Mesh<f64>) -> Designed {
    design.run(mesh, |_| true).expect("memory suffices")
}

/// The largest defect of the property that the goal asks for, relative to the terms of its residual.
fn defect(goal: Goal, mesh: &Mesh<f64>, points: &[Point<f64>]) -> f64 {
    let observed = Observed { points, tolerance: 0.0 };
    let defects = Net::new(&mesh.topology, &observed).defects(goal.property());
    defects.into_iter().fold(0.0, f64::max)
}

#[test]
fn a_patch_reaches_every_goal() {
    let mesh = patch(6);
    for goal in Goal::ALL {
        let found = run(&Design::new(goal, mesh.points.len()), &mesh);
        let name = goal.property().name();
        assert_eq!(
            found.ending,
            Ending::Converged,
            "{name}: {:?}",
            found.steps.iter().map(|s| s.distance()).collect::<Vec<_>>()
        );
        let (before, after) =
            (defect(goal, &mesh, &mesh.points), defect(goal, &mesh, &found.points));
        assert!(before > 1e-5, "{name}: {before:e} is no test");
        assert!(after < 1e-12, "{name}: {after:e}");
        let movement = Movement::between(&mesh.points, &found.points);
        assert!(movement.largest < 0.5 / 6.0, "{name}: {movement:?}");
    }
}

/// A pentagonal star of quads about vertex 0, with a pentagon and a triangle attached, over a function.
pub fn star(height: impl Fn(f64, f64) -> f64) -> Mesh<f64> {
    let ring = |r: f64, k: f64| {
        let angle = std::f64::consts::TAU * k / 10.0;
        let (x, y) = (r * angle.cos(), r * angle.sin());
        Point::new(x, y, height(x, y))
    };
    let mut points = vec![ring(0.0, 0.0)];
    points.extend((0..5).map(|k| ring(1.0, 2.0 * f64::from(k))));
    points.extend((0..5).map(|k| ring(1.6, 2.0 * f64::from(k) + 1.0)));
    points.extend([ring(2.2, 0.2), ring(2.6, 0.6), ring(2.3, 1.1)]);
    let mut faces = FaceList::new();
    for k in 0..5 {
        faces.push([0, 1 + k, 6 + k, 1 + (k + 1) % 5]);
    }
    faces.push([1, 11, 12, 13, 6]);
    faces.push([2, 6, 13]);
    Mesh::new(points, faces).expect("a mesh")
}

/// Pentagons, triangles and quads in one mesh, and vertices of 3 and of 5 faces.
#[test]
fn faces_of_any_size_and_vertices_of_any_valence() {
    let mesh = star(|x, y| 0.3 * x * y + 0.1 * x * x * y - 0.2 * y * y);
    for goal in [Goal::Planar, Goal::ICircular, Goal::IConical, Goal::Conical] {
        let found = run(&Design::new(goal, mesh.points.len()), &mesh);
        assert_eq!(found.ending, Ending::Converged, "{goal:?}: {:?}", found.steps.last());
        let after = defect(goal, &mesh, &found.points);
        assert!(after < 1e-11, "{goal:?}: {after:e}");
    }
}

#[test]
fn nothing_depends_on_the_unit() {
    let mesh = patch(5);
    let scaled = |factor: f64| mesh.map(|c| c * factor);
    for goal in [Goal::Planar, Goal::ICircular, Goal::IConical] {
        let design = Design::new(goal, mesh.points.len());
        let own = run(&design, &mesh);
        // By a power of two to the last bit.
        let large = run(&design, &scaled(1024.0));
        assert_eq!(
            large.points,
            own.points.iter().map(|p| p.map(|c| c * 1024.0)).collect::<Vec<_>>()
        );
        for factor in [1e-6, 1e6] {
            let other = run(&design, &scaled(factor));
            let back: Vec<_> = other.points.iter().map(|p| p.map(|c| c / factor)).collect();
            let difference = Movement::between(&own.points, &back).largest;
            assert!(difference < 1e-12, "{goal:?}: {difference:e}");
            assert_eq!(other.steps.len(), own.steps.len());
        }
    }
}

#[test]
fn nothing_depends_on_the_position() {
    let mesh = patch(5);
    let far = Mesh {
        points: mesh.points.iter().map(|p| Point::new(p.x + 4096.0, p.y, p.z - 512.0)).collect(),
        ..mesh.clone()
    };
    let design = Design::new(Goal::ICircular, mesh.points.len());
    let (own, other) = (run(&design, &mesh), run(&design, &far));
    let back: Vec<_> =
        other.points.iter().map(|p| Point::new(p.x - 4096.0, p.y, p.z + 512.0)).collect();
    let difference = Movement::between(&own.points, &back).largest;
    assert!(difference < 1e-11, "{difference:e}");
}

#[test]
fn what_is_fixed_stays() {
    let mesh = patch(6);
    let mut design = Design::new(Goal::IConical, mesh.points.len());
    for v in mesh.topology.boundary_loops().concat() {
        design.mobility[v.index()] = Mobility::Fixed;
    }
    let found = run(&design, &mesh);
    assert_eq!(found.ending, Ending::Converged);
    for v in mesh.topology.vertices() {
        let stays = found.points[v.index()] == mesh.points[v.index()];
        let fixed = design.mobility[v.index()] == Mobility::Fixed;
        assert_eq!(stays, fixed, "vertex {}", v.0);
    }
}

#[test]
fn what_slides_stays_on_its_line() {
    let mesh = patch(4);
    let mut design = Design::new(Goal::ICircular, mesh.points.len());
    let (v, direction) = (VertexId(2), Mobility::along(&mesh.points[1], &mesh.points[3]));
    design.mobility[v.index()] = direction;
    let found = run(&design, &mesh);
    let moved = &found.points[v.index()] - &mesh.points[v.index()];
    let across = &moved - &direction.part(&moved);
    assert!(moved.length2() > 1e-8 && across.length2() < 1e-30, "{moved:?} {across:?}");
}

/// How far a point is from a closed polygon.
fn distance(p: &Point<f64>, polygon: &[Point<f64>]) -> f64 {
    let sides = polygon.iter().zip(polygon.iter().cycle().skip(1));
    let distances = sides.map(|(a, b)| {
        let (along, seen) = (b - a, p - a);
        let part = (along.dot(&seen) / along.length2()).clamp(0.0, 1.0);
        (&seen - &along.scaled(&part)).length2().sqrt()
    });
    distances.fold(f64::INFINITY, f64::min)
}

#[test]
fn a_boundary_that_slides_stays_on_its_polygon() {
    let mesh = disturbed(6, |x, y| 0.4 * x * x - 0.3 * y * y);
    let loops = mesh.topology.boundary_loops();
    let polygon: Vec<_> = loops[0].iter().map(|v| mesh.points[v.index()]).collect();
    let farthest = |found: &Designed| {
        let distances = loops[0].iter().map(|v| distance(&found.points[v.index()], &polygon));
        distances.fold(0.0, f64::max)
    };
    let mut design = Design::new(Goal::ICircular, mesh.points.len());
    let (free, n) = (run(&design, &mesh), loops[0].len());
    assert!(farthest(&free) > 1e-4, "{:e} is no test", farthest(&free));
    for (i, v) in loops[0].iter().enumerate() {
        let [before, after] = [n - 1, 1].map(|k| &polygon[(i + k) % n]);
        design.mobility[v.index()] = match mesh.topology.star(*v).count() {
            1 => Mobility::Fixed,
            _ => Mobility::along(before, after),
        };
    }
    let tangents = run(&design, &mesh);
    assert!(farthest(&tangents) > 1e-6, "{:e} is no test", farthest(&tangents));
    design.curves = loops.clone();
    let slid = run(&design, &mesh);
    assert_eq!(slid.ending, Ending::Converged, "{:?}", slid.steps.last());
    assert!(farthest(&slid) < 1e-14, "{:e}", farthest(&slid));
    let movement = Movement::between(&mesh.points, &slid.points);
    assert!(movement.largest > 1e-4, "{movement:?} is no test");
    let defect = defect(Goal::ICircular, &mesh, &slid.points);
    assert!(defect < 1e-12, "{defect:e}");
}

/// The parameter lines of this surface are far from conjugate: shortest steps lead vertices over
/// several edges.
#[test]
fn what_strays_is_brought_nearer() {
    let at = |i: usize| i as f64 / 12.0 - 1.0;
    let places = (0..25).flat_map(|j| (0..25).map(move |i| (at(i), at(j))));
    let height = |x: f64, y: f64| 0.3 * (1.7 * x + 0.3).sin() * (1.3 * y - 0.2).cos() + 0.2 * x * y;
    let points: Vec<_> = places.map(|(x, y)| Point::new(x, y, height(x, y))).collect();
    let mesh = Mesh::new(points, quad_patch(24, 24)).expect("a patch is a mesh");
    let found = run(&Design::new(Goal::Planar, mesh.points.len()), &mesh);
    assert_eq!(found.ending, Ending::Converged);

    let system = System::new(Goal::Planar.conditions(&mesh.topology, &mesh.points));
    let (mut shortest, free) = (mesh.points.clone(), vec![Mobility::Free; mesh.points.len()]);
    let mut projection = Projection::new(&system, &free, &mesh.points).expect("memory suffices");
    let ending = projection.run(&mut shortest, 50, Stage::Projection, |_| true);
    assert_eq!(ending, Ending::Converged);

    let way = |points: &[Point<f64>]| Movement::between(&mesh.points, points).rms;
    assert!(way(&shortest) > 1.0 / 12.0, "{} is no test", way(&shortest));
    assert!(
        1.25 * way(&found.points) < way(&shortest),
        "{} {}",
        way(&found.points),
        way(&shortest)
    );
}

#[test]
fn what_cannot_be_reached_is_said() {
    let mesh = patch(3);
    let mut design = Design::new(Goal::Planar, mesh.points.len());
    design.mobility.fill(Mobility::Fixed);
    let found = run(&design, &mesh);
    assert_eq!(found.ending, Ending::Stuck);
    assert_eq!(found.points, mesh.points);
    // Three corners of each face are fixed to heights that no plane fits.
    let points = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 1.0), (0.0, 1.0, 0.0)];
    let points = points.map(|(x, y, z)| Point::new(x, y, z)).to_vec();
    let mut faces = FaceList::new();
    faces.push([0, 1, 2, 3]);
    let skew = Mesh::new(points, faces).expect("a mesh");
    let mut design = Design::new(Goal::Planar, 4);
    design.mobility[..3].fill(Mobility::Fixed);
    assert_eq!(run(&design, &skew).ending, Ending::Converged);
    design.mobility.fill(Mobility::Horizontal);
    assert_ne!(run(&design, &skew).points, skew.points);
}

#[test]
fn two_stages_reach_the_same_goals() {
    let mesh = patch(6);
    for goal in [Goal::ICircular, Goal::IConical] {
        let design = Design { method: Method::TwoStage, ..Design::new(goal, mesh.points.len()) };
        let found = run(&design, &mesh);
        assert_eq!(found.ending, Ending::Converged, "{goal:?}");
        assert!(defect(goal, &mesh, &found.points) < 1e-12);
        let stages =
            found.steps.iter().map(|s| s.stage.name()).collect::<std::collections::BTreeSet<_>>();
        assert_eq!(stages.into_iter().collect::<Vec<_>>(), ["heights", "projection", "top view"]);
    }
}

#[test]
fn whoever_watches_can_stop_it() {
    let mesh = patch(6);
    let design = Design::new(Goal::ICircular, mesh.points.len());
    let mut seen = 0;
    let found = design
        .run(&mesh, |_| {
            seen += 1;
            seen < 2
        })
        .expect("memory suffices");
    assert_eq!((found.ending, found.steps.len()), (Ending::Stopped, 2));
    // One step was made, and it made the mesh better.
    assert!(found.steps[1].distance() < found.steps[0].distance());
}

#[test]
fn fairness_makes_polylines_fairer() {
    let mesh = patch(8);
    let roughness = |points: &[Point<f64>]| {
        let at = |i: usize, j: usize| &points[9 * i + j];
        let second = |a: &Point<f64>, b: &Point<f64>, c: &Point<f64>| {
            let d = &(a - b) + &(c - b);
            d.length2()
        };
        let inner = (1..8).flat_map(|i| (1..8).map(move |j| (i, j)));
        inner
            .map(|(i, j)| {
                second(at(i - 1, j), at(i, j), at(i + 1, j))
                    + second(at(i, j - 1), at(i, j), at(i, j + 1))
            })
            .sum::<f64>()
    };
    let plain = run(&Design::new(Goal::IConical, mesh.points.len()), &mesh);
    let design = Design { fairness: 10.0, ..Design::new(Goal::IConical, mesh.points.len()) };
    let fair = run(&design, &mesh);
    assert_eq!(fair.ending, Ending::Converged);
    assert!(
        roughness(&fair.points) < 0.8 * roughness(&plain.points),
        "{} {}",
        roughness(&fair.points),
        roughness(&plain.points)
    );
    assert!(fair.steps.iter().any(|s| s.energy.is_some()));
}
