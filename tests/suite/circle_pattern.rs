//! Circle patterns from combinatorics, in doubles: known answers, laws of the patterns, refusals.

use std::f64::consts::{PI, TAU};

use isogeo::check::Residual;
use isogeo::construct::{
    CircleCondition, CirclePattern, Koebe, NoPattern, discrete_power, quad_patch,
};
use isogeo::mesh::{FaceList, Mesh, Topology, VertexId, VertexKind};
use isogeo::net::planar::Coplanar;
use isogeo::scalar::{Field, Quadratic, Rational, Ring};
use isogeo::space::Point;

/// What angles, and lengths as parts of others, may be wrong by after a few thousand roundings.
const SMALL: f64 = 1e-11;

fn patch(rows: usize, columns: usize) -> Topology {
    Topology::new((rows + 1) * (columns + 1), quad_patch(rows, columns)).unwrap()
}

/// The vertex circles of the unit square grid, inverted at a point outside.
fn inverted(v: VertexId, columns: usize) -> f64 {
    let (i, j) = (v.index() / (columns + 1), v.index() % (columns + 1));
    let (x, y) = (i as f64 + 3.0, j as f64 + 2.5);
    0.5 / (x * x + y * y - 0.25)
}

fn closed(vertices: usize, faces: &[&[u32]]) -> Topology {
    let mut list = FaceList::new();
    faces.iter().for_each(|f| list.push(f.iter().copied()));
    Topology::new(vertices, list).unwrap()
}

fn cube() -> Topology {
    closed(
        8,
        &[&[0, 3, 2, 1], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]],
    )
}

#[test]
fn an_inverted_grid_is_found_from_its_boundary() {
    let mesh = patch(12, 17);
    let asked = |v| CircleCondition::Radius(inverted(v, 17));
    let pattern = CirclePattern::disc(&mesh, asked).unwrap();
    assert!(pattern.defect < 1e-13, "{}", pattern.defect);
    for v in mesh.vertices() {
        let error = pattern.vertex_radius(v) / inverted(v, 17) - 1.0;
        assert!(error.abs() < SMALL, "vertex {}: {error}", v.0);
    }
    // One boundary radius disturbed: the angles are still met, by another pattern.
    let other =
        |v: VertexId| CircleCondition::Radius(inverted(v, 17) * if v.0 == 5 { 1.01 } else { 1.0 });
    let other = CirclePattern::disc(&mesh, other).unwrap();
    let moved = other.vertex_radius(VertexId(23)) / pattern.vertex_radius(VertexId(23)) - 1.0;
    assert!(other.defect < 1e-13 && moved.abs() > 1e-4);
}

/// Small systems are factorised, in the order of the file or another, larger ones are not: the names
/// of the vertices do not matter.
#[test]
fn relabelled_meshes_have_the_same_pattern() {
    for (n, stride) in [(20, 10), (60, 10)] {
        let count = (n + 1) * (n + 1);
        let name = |v: usize| (v * stride % count) as u32;
        let mesh = patch(n, n);
        let mut faces = FaceList::new();
        for f in mesh.faces() {
            faces.push(mesh.face(f).iter().map(|v| name(v.index())));
        }
        let other = Topology::new(count, faces).unwrap();
        let mut asked = vec![0.0; count];
        mesh.vertices().for_each(|v| asked[name(v.index()) as usize] = inverted(v, n));
        let pattern =
            CirclePattern::disc(&other, |v| CircleCondition::Radius(asked[v.index()])).unwrap();
        assert!(pattern.defect < 1e-13, "{}", pattern.defect);
        for v in other.vertices() {
            let error = pattern.vertex_radius(v) / asked[v.index()] - 1.0;
            assert!(error.abs() < SMALL, "vertex {}: {error}", v.0);
        }
    }
}

/// `r²(r₁+r₂+r₃+r₄) = r₁r₂r₃ + ...`, for faces and for interior vertices of valence 4.
#[test]
fn radii_solve_the_equation_of_schramm() {
    let mesh = patch(9, 9);
    let wild = |v: VertexId| CircleCondition::Radius(1.0 + f64::from(v.0 * 7 % 11) / 5.0);
    let pattern = CirclePattern::disc(&mesh, wild).unwrap();
    let residual = |r: f64, around: [f64; 4]| {
        let sum: f64 = around.iter().sum();
        let triples: f64 = around.iter().map(|a| around.iter().product::<f64>() / a).sum();
        (r * r * sum - triples) / triples
    };
    for f in mesh.faces() {
        let corners: [VertexId; 4] = mesh.face(f).try_into().unwrap();
        let around = corners.map(|v| pattern.vertex_radius(v));
        assert!(residual(pattern.face_radius(f), around).abs() < SMALL);
    }
    for v in mesh.interior_vertices() {
        let around: Vec<f64> = mesh.star(v).map(|h| pattern.face_radius(mesh.face_at(h))).collect();
        let r = pattern.vertex_radius(v);
        assert!(residual(r, around[..].try_into().unwrap()).abs() < SMALL);
        assert!(residual(1.1 * r, around[..].try_into().unwrap()).abs() > 1e-3);
    }
}

/// How far an edge is from touching Σ, and a face from being planar: as parts of their sizes.
fn misses(mesh: &Mesh<f64>) -> (f64, f64) {
    let topology = &mesh.topology;
    let edge = |h| {
        let [p, q] = [topology.origin(h), topology.target(h)].map(|v| mesh.points[v.index()]);
        // The discriminant of the common points of the line and Σ.
        let (dx, dy, dz) = (q.x - p.x, q.y - p.y, q.z - p.z);
        let (length2, slope) = (dx * dx + dy * dy, p.x * dx + p.y * dy - dz);
        let power = p.x * p.x + p.y * p.y - 2.0 * p.z;
        (slope * slope - length2 * power).abs() / (slope * slope + length2 * power.abs())
    };
    let face = |f| {
        let corners: Vec<_> = topology.face(f).iter().map(|v| mesh.points[v.index()]).collect();
        let [a, b, c, rest @ ..] = corners.as_slice() else { return 0.0 };
        let (u, v) = (b - a, c - a);
        let normal = u.cross(&v);
        let height = |p: &Point<f64>| {
            let w = p - a;
            (normal.dot(&w)).abs() / (normal.length2() * w.length2()).sqrt()
        };
        rest.iter().map(height).fold(0.0, f64::max)
    };
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
    (largest(&mut topology.edges().map(edge)), largest(&mut topology.faces().map(face)))
}

#[test]
fn the_lift_is_midscribed_and_planar() {
    let mesh = patch(8, 6);
    let asked = |v| CircleCondition::Radius(inverted(v, 6));
    let koebe = CirclePattern::disc(&mesh, asked).unwrap().koebe();
    assert!(koebe.gap < SMALL, "{}", koebe.gap);
    let (edges, faces) = misses(&koebe.mesh);
    assert!(edges < SMALL && faces < SMALL, "{edges} {faces}");
    // One vertex raised by a thousandth of its radius: both are seen.
    let mut other = koebe.mesh.clone();
    other.points[30].z += 1e-3 * other.data.vertex["radius"][30].powi(2);
    let (edges, faces) = misses(&other);
    assert!(edges > 1e-6 && faces > 1e-6, "{edges} {faces}");
}

#[test]
fn closed_koebe_meshes_touch_the_sphere_with_every_edge() {
    for mesh in solids() {
        for outer in mesh.faces() {
            let koebe = Koebe::closed(&mesh, outer).unwrap();
            let (edges, faces) = misses(&koebe.mesh);
            assert!(edges < SMALL && faces < SMALL, "{edges} {faces}");
            for (p, &r) in koebe.mesh.points.iter().zip(&koebe.mesh.data.vertex["radius"]) {
                assert!(r > 0.0);
                assert!((p.z - (p.x * p.x + p.y * p.y - r * r) / 2.0).abs() < SMALL);
            }
            // The vertices of the outer face lie in its plane: that of the unit circle.
            for v in mesh.face(outer) {
                assert!((koebe.mesh.points[v.index()].z - 0.5).abs() < SMALL);
            }
        }
    }
}

/// A tetrahedron, a cube, a pyramid over a heptagon, and one over a prism.
fn solids() -> Vec<Topology> {
    let tetrahedron = closed(4, &[&[0, 1, 2], &[0, 2, 3], &[0, 3, 1], &[1, 3, 2]]);
    let mut pyramid: Vec<Vec<u32>> = (0..7).map(|i| vec![7, i, (i + 1) % 7]).collect();
    pyramid.push((0..7).rev().collect());
    let mut house: Vec<Vec<u32>> = (0..5).map(|i| vec![10, i, (i + 1) % 5]).collect();
    house.extend((0..5).map(|i| vec![i, 5 + i, 5 + (i + 1) % 5, (i + 1) % 5]));
    house.push((5..10).rev().collect());
    let solid = |vertices, faces: Vec<Vec<u32>>| {
        closed(vertices, &faces.iter().map(Vec::as_slice).collect::<Vec<_>>())
    };
    vec![tetrahedron, cube(), solid(8, pyramid), solid(11, house)]
}

#[test]
fn closed_meshes_have_their_patterns_on_the_sphere() {
    for mesh in solids() {
        for first in mesh.vertices() {
            let pattern = CirclePattern::sphere(&mesh, first).unwrap();
            let finite = |radii: &[f64]| radii.iter().filter(|r| r.is_finite()).count();
            assert_eq!(finite(&pattern.vertex_radii), mesh.vertex_count() - 2);
            assert_eq!(finite(&pattern.face_radii), mesh.face_count() - 2);
            assert!(pattern.defect < 1e-13, "{}", pattern.defect);
            assert!(pattern.layout().gap < SMALL);
        }
    }
}

/// From where the circles of an edge are lines, all finite circles of a cube are equal: they fill a
/// square, three by three with the lines.
#[test]
fn the_circles_of_a_cube_are_equal_by_symmetry() {
    let mesh = cube();
    let pattern = CirclePattern::sphere(&mesh, VertexId(0)).unwrap();
    // The two faces opposite to the edge, and its two opposite vertices, by the symmetry of the edge.
    let [lines, finite] = [true, false].map(|line| {
        mesh.faces().filter(|&f| pattern.face_radius(f).is_infinite() == line).collect::<Vec<_>>()
    });
    assert_eq!((lines.len(), finite.len()), (2, 4));
    let ends: Vec<f64> = pattern.vertex_radii.iter().copied().filter(|r| r.is_finite()).collect();
    assert_eq!(ends.len(), 6);
    let mut sorted = ends.clone();
    sorted.sort_by(f64::total_cmp);
    // Four vertices beside the lines are alike, the two opposite ones are alike.
    let alike = |a: f64, b: f64| (a / b - 1.0).abs() < SMALL;
    assert!(alike(sorted[0], sorted[1]) && alike(sorted[2], sorted[5]));
    assert!(!alike(sorted[1], sorted[2]));
}

#[test]
fn an_angle_problem_is_solved_up_to_scale() {
    // A rectangle: boundary vertices straight, corners right angles.
    let mesh = patch(3, 5);
    let asked = |v: VertexId| {
        let (i, j) = (v.index() / 6, v.index() % 6);
        let corner = (i == 0 || i == 3) && (j == 0 || j == 5);
        CircleCondition::Angle(if corner { PI / 2.0 } else { PI })
    };
    let pattern = CirclePattern::disc(&mesh, asked).unwrap();
    assert!(pattern.defect < 1e-13);
    let first = pattern.vertex_radius(VertexId(0));
    assert!(pattern.vertex_radii.iter().all(|r| (r / first - 1.0).abs() < SMALL));
    // With one angle changed the sum is wrong.
    let wrong = |v: VertexId| match asked(v) {
        CircleCondition::Angle(a) if v.0 == 0 => CircleCondition::Angle(a + 0.1),
        asked => asked,
    };
    assert!(matches!(CirclePattern::disc(&mesh, wrong), Err(NoPattern::AngleSum { .. })));
}

#[test]
fn what_has_no_pattern_is_refused_with_the_part_that_is_wrong() {
    // Vertex 4 lies inside and has two faces only: its two kites cannot make a full turn.
    let mesh = closed(5, &[&[0, 1, 4, 3], &[1, 2, 3, 4]]);
    assert_eq!(mesh.kind(VertexId(4)), VertexKind::Interior);
    let refused = CirclePattern::disc(&mesh, |_| CircleCondition::Radius(1.0));
    assert_eq!(refused.map(|_| ()), Err(NoPattern::TooMuch(vec![4])));
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = CirclePattern::disc(&mesh, |_| CircleCondition::Radius(bad));
        assert_eq!(refused.map(|_| ()), Err(NoPattern::NotPositive(0)), "{bad}");
    }
    let refused = CirclePattern::disc(&mesh, |_| CircleCondition::Angle(TAU));
    assert!(matches!(refused, Err(NoPattern::AngleSum { .. })));
}

/// The answer does not depend on how work is shared between threads, or on the unit.
#[test]
fn patterns_scale_with_their_boundary() {
    let mesh = patch(40, 40);
    let of = |unit: f64| {
        CirclePattern::disc(&mesh, |v| CircleCondition::Radius(unit * inverted(v, 40))).unwrap()
    };
    let (one, again, small) = (of(1.0), of(1.0), of(1e-6));
    assert_eq!(one.vertex_radii, again.vertex_radii);
    for (a, b) in one.vertex_radii.iter().zip(&small.vertex_radii) {
        assert!((b / a * 1e6 - 1.0).abs() < SMALL);
    }
}

/// A face of many corners is no reason for a square of entries.
#[test]
fn faces_may_have_many_corners() {
    let k = 300;
    let mut faces = FaceList::new();
    (0..k).for_each(|i| faces.push([i, (i + 1) % k, k + (i + 1) % k, k + i]));
    faces.push(k..2 * k);
    let points = vec![Point::new(0.0, 0.0, 0.0); 2 * k as usize];
    let mesh = Mesh::new(points, faces).unwrap();
    let pattern = CirclePattern::disc(&mesh.topology, |_| CircleCondition::Radius(1.0)).unwrap();
    assert!(pattern.defect < 1e-13 && pattern.layout().gap < SMALL);
    let inner = pattern.vertex_radius(VertexId(k));
    assert!(inner > 0.9 && inner < 1.0);
}

/// Residuals of planarity at all faces and of tangency at all edges.
fn koebe_residuals<T: Field>(mesh: &Mesh<T>) -> Vec<T> {
    let topology = &mesh.topology;
    let point = |v: &VertexId| mesh.points[v.index()].clone();
    let planar = topology.faces().map(|f| {
        let corners: Vec<Point<T>> = topology.face(f).iter().map(point).collect();
        Coplanar.eval::<T>(&corners.try_into().unwrap(), &T::one())
    });
    let tangent = topology.edges().map(|h| {
        let [p, q] = [topology.origin(h), topology.target(h)].map(|v| point(&v));
        let d = &q - &p;
        let slope = p.top_view().position().dot(&d.top_view()) - &d.z;
        let power = p.top_view().norm2() - T::from_i64(2) * &p.z;
        slope.square() - d.top_view().length2() * power
    });
    planar.chain(tangent).collect()
}

#[test]
fn discrete_powers_are_koebe_meshes_exactly() {
    type Root2 = Quadratic<Rational, 2>;
    type Root3 = Quadratic<Rational, 3>;
    let q = Rational::from_ratio;
    let half_root2 = Root2::new(q(0, 1), q(1, 2));
    let power = |gamma| discrete_power(&gamma, (&half_root2, &half_root2), 3).unwrap().unwrap();
    let mesh = power(Root2::from_ratio(1, 2));
    assert!(koebe_residuals(&mesh).iter().all(Root2::is_zero));
    // f(2) = 2/(2 − γ) on the axis: here 4/3, the square of the radius of the corner is 1.
    assert_eq!((&mesh.points[4].x, &mesh.points[4].y), (&Root2::from_ratio(4, 3), &Root2::zero()));
    assert_eq!(mesh.points[0].z, Root2::from_ratio(-1, 2));
    // A corner that is no unit vector: the circles do not fit.
    let long = discrete_power(&q(1, 2), (&q(1, 1), &q(1, 1)), 3).unwrap().unwrap();
    assert!(!koebe_residuals(&long).iter().all(Rational::is_zero));
    // Another unit vector is the corner of a Koebe mesh all the same.
    let other = discrete_power(&q(1, 2), (&q(3, 5), &q(4, 5)), 3).unwrap().unwrap();
    assert!(koebe_residuals(&other).iter().all(Rational::is_zero));

    let (half, root) = (Root3::from_ratio(1, 2), Root3::new(q(0, 1), q(1, 2)));
    let mesh = discrete_power(&Root3::from_ratio(2, 3), (&half, &root), 3).unwrap().unwrap();
    assert!(koebe_residuals(&mesh).iter().all(Root3::is_zero));
    let obtuse = discrete_power(&Root3::from_ratio(4, 3), (&-half, &root), 3).unwrap().unwrap();
    assert!(koebe_residuals(&obtuse).iter().all(Root3::is_zero));
    let zero = discrete_power(&q(0, 1), (&q(0, 1), &q(1, 1)), 3).unwrap();
    assert!(zero.is_none(), "γ = 0 is no power");
}
