//! The way back: exact meshes near optimised ones.

use isogeo::check::{Decider, Verdict};
use isogeo::construct::quad_patch;
use isogeo::mesh::{FaceList, Mesh};
use isogeo::net::Net;
use isogeo::optimise::rationalise::{
    NoExactMesh, Options, Rationalised, i_circular, i_conical, planar,
};
use isogeo::optimise::{Design, Goal, Movement, mean_edge};
use isogeo::space::Point;

/// A patch of `n` by `n` quads near the i-principal lines of a surface, optimised.
fn optimised(n: usize, goal: Goal) -> Mesh<f64> {
    let at = |i: usize| i as f64 / n as f64 - 0.45;
    let point = |i: usize, j: usize| {
        let (x, y) = (at(i), at(j));
        let wobble = |k: usize| 0.01 / n as f64 * ((7 * i + 13 * j + 5 * k) as f64 * 2.399).sin();
        let z = 0.5 * x * x + 0.3 * y * y + 0.1 * x * x * y;
        Point::new(x + wobble(1), y + wobble(2), z + wobble(3))
    };
    let points = (0..=n).flat_map(|i| (0..=n).map(move |j| (i, j))).map(|(i, j)| point(i, j));
    let mesh = Mesh::new(points.collect(), quad_patch(n, n)).expect("a patch is a mesh");
    let found = Design::new(goal, mesh.points.len()).run(&mesh, |_| true).expect("memory suffices");
    Mesh { points: found.points, ..mesh }
}

fn exact(goal: Goal, mesh: &Mesh<f64>) -> Result<Rationalised, NoExactMesh> {
    let options = Options::of(&mesh.points);
    match goal {
        Goal::Planar => planar(mesh, &options),
        Goal::ICircular => i_circular(mesh, &options),
        _ => i_conical(mesh, &options),
    }
}

fn verdict(goal: Goal, exact: &Rationalised) -> Verdict {
    let decider = Decider::of_rationals(&exact.mesh.points);
    Net::new(&exact.mesh.topology, &decider).check(goal.property()).verdict()
}

#[test]
fn optimised_patches_have_exact_neighbours() {
    for goal in [Goal::Planar, Goal::ICircular, Goal::IConical] {
        let mesh = optimised(6, goal);
        let found = exact(goal, &mesh).unwrap_or_else(|why| panic!("{goal:?}: {why}"));
        assert_eq!(verdict(goal, &found), Verdict::Proved, "{goal:?}");
        let edge = mean_edge(&mesh.topology, &mesh.points);
        let moved = found.movement.largest / edge;
        assert!(moved < 1e-4, "{goal:?}: {moved:e} edges");
        assert!(found.bits < 4000, "{goal:?}: {} bits", found.bits);
        // What is said of the distance is so.
        let back: Vec<_> =
            found.mesh.points.iter().map(|p| p.map(isogeo::scalar::Approx::to_f64)).collect();
        assert_eq!(Movement::between(&mesh.points, &back), found.movement);
        // One disturbed coordinate is seen.
        let mut spoilt = found.clone();
        spoilt.mesh.points[24].z += &isogeo::scalar::Field::from_ratio(1, 1 << 50);
        assert_eq!(verdict(goal, &spoilt), Verdict::Refuted, "{goal:?}");
    }
}

#[test]
fn numbers_stay_short_as_patches_grow() {
    let bits = |goal, n| exact(goal, &optimised(n, goal)).expect("an exact mesh").bits;
    // Planar: linear in the distance from the middle; i-circular: quadratic, by the faces between.
    let (small, large) = (bits(Goal::Planar, 6), bits(Goal::Planar, 12));
    assert!(large < 4 * small, "{small} {large}");
    let (small, large) = (bits(Goal::ICircular, 5), bits(Goal::ICircular, 10));
    assert!(large < 10 * small, "{small} {large}");
}

/// Hexagons: every inner vertex is the intersection of three planes.
#[test]
fn hexagons_become_planar() {
    let mut points = Vec::new();
    let mut faces = FaceList::new();
    let mut index = std::collections::BTreeMap::new();
    for (a, b) in (0..4).flat_map(|a| (0..4).map(move |b| (a, b))) {
        let (cx, cy) = (f64::from(a) * 1.5, (f64::from(b) + 0.5 * f64::from(a)) * 3f64.sqrt());
        faces.push((0..6).map(|k| {
            let angle = f64::from(k) * std::f64::consts::FRAC_PI_3;
            let (x, y) = (cx + angle.cos(), cy + angle.sin());
            let key = ((x * 1000.0).round() as i64, (y * 1000.0).round() as i64);
            *index.entry(key).or_insert_with(|| {
                points.push(Point::new(x, y, 0.02 * x * x + 0.03 * y * y));
                points.len() as u32 - 1
            })
        }));
    }
    let mesh = Mesh::new(points, faces).expect("hexagons");
    let design = Design::new(Goal::Planar, mesh.points.len());
    let found = design.run(&mesh, |_| true).expect("memory suffices");
    let mesh = Mesh { points: found.points, ..mesh };
    let found = exact(Goal::Planar, &mesh).expect("an exact mesh");
    assert_eq!(verdict(Goal::Planar, &found), Verdict::Proved);
    assert!(
        found.movement.largest < 1e-4 && found.bits < 1000,
        "{:?} {}",
        found.movement,
        found.bits
    );
}

#[test]
fn what_has_no_exact_neighbour_is_said() {
    // All vertices of a face on a line: no plane is determined.
    let points = (0..4).map(|i| Point::new(f64::from(i), 0.0, 0.0)).collect();
    let mut faces = FaceList::new();
    faces.push([0, 1, 2, 3]);
    let line = Mesh::new(points, faces).expect("a mesh");
    for goal in [Goal::ICircular, Goal::IConical] {
        let found = exact(goal, &line);
        assert!(
            found.as_ref().map_or(true, |f| verdict(goal, f) != Verdict::Proved),
            "{goal:?}: {found:?}"
        );
    }
    // Not a number is no mesh.
    let mut mesh = optimised(2, Goal::Planar);
    mesh.points[4].z = f64::NAN;
    for goal in [Goal::Planar, Goal::ICircular, Goal::IConical] {
        assert!(exact(goal, &mesh).is_err(), "{goal:?}");
    }
    // A patch that is not planar has an exact neighbour only farther away, and that is said.
    let mut bent = optimised(4, Goal::Planar);
    bent.points[12].z += 0.01;
    let found = exact(Goal::Planar, &bent).expect("an exact mesh");
    assert_eq!(verdict(Goal::Planar, &found), Verdict::Proved);
    assert!(found.movement.largest > 1e-3, "{:?}", found.movement);
}
