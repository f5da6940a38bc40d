//! The mesh: canonical, proved Delaunay, covering the hull, and what a naive search finds.

use std::collections::BTreeSet;

use isogeo::check::{Decider, Residual, Verdict};
use isogeo::construct::{NoTriangulation, delaunay, voronoi_areas};
use isogeo::mesh::{FaceList, Mesh, VertexId};
use isogeo::net::i_circular::Concyclic;
use isogeo::net::planar::ProjectedArea;
use isogeo::net::{Net, Property};
use isogeo::scalar::{Field, Numeral, Rational, RationalField, Ring};
use isogeo::space::Point;
use proptest::prelude::*;

type P = Point<Rational>;

fn ratio(p: i64, q: i64) -> Rational {
    Rational::from_ratio(p, q)
}

fn points(places: &[(i64, i64)]) -> Vec<P> {
    let z = |(i, &(x, y)): (usize, &(i64, i64))| {
        Point::new(x, y, (7 * i as i64) % 5).map(|&c| Rational::from_i64(c))
    };
    places.iter().enumerate().map(z).collect()
}

fn verdict(mesh: &Mesh<Rational>) -> Verdict {
    Net::new(&mesh.topology, &Decider::of_rationals(&mesh.points))
        .check(Property::Delaunay)
        .verdict()
}

/// A face by its top views.
fn corners(mesh: &Mesh<Rational>) -> Vec<Vec<String>> {
    let name = |v: &VertexId| {
        let p = &mesh.points[v.index()];
        format!("{} {}", p.x, p.y)
    };
    mesh.topology.faces().map(|f| mesh.topology.face(f).iter().map(name).collect()).collect()
}

fn turn(a: &P, b: &P, c: &P) -> Rational {
    ProjectedArea::TopView.eval(&[a.clone(), b.clone(), c.clone()], &Rational::one())
}

fn inside(a: &P, b: &P, c: &P, d: &P) -> Rational {
    Concyclic.eval(&[a, b, c, d].map(P::clone), &Rational::one())
}

/// Twice the area of the convex hull, by Andrew's chain.
fn twice_hull_area(points: &[P]) -> Rational {
    let mut sorted: Vec<&P> = points.iter().collect();
    sorted.sort_by(|p, q| (&p.x, &p.y).partial_cmp(&(&q.x, &q.y)).expect("rationals are ordered"));
    let chain = |list: &mut dyn Iterator<Item = &P>| {
        let mut chain: Vec<P> = Vec::new();
        for p in list {
            while let [.., a, b] = chain.as_slice() {
                if turn(a, b, p) > Rational::zero() {
                    break;
                }
                chain.pop();
            }
            chain.push(p.clone());
        }
        chain
    };
    let mut hull = chain(&mut sorted.iter().copied());
    let upper = chain(&mut sorted.iter().rev().copied());
    hull.pop();
    hull.extend(upper);
    let fan = hull.windows(2).map(|w| turn(&hull[0], &w[0], &w[1]));
    fan.fold(Rational::zero(), |sum, area| sum + area)
}

/// All that a Delaunay mesh of these points must be.
fn is_right(points: &[P]) -> Result<Mesh<Rational>, TestCaseError> {
    let mesh =
        delaunay(points.to_vec()).map_err(|e| TestCaseError::fail(format!("{e}: {points:?}")))?;
    prop_assert_eq!(&mesh.points, points);
    // With one triangle there is no edge to check.
    let expected = if mesh.topology.face_count() == 1 { Verdict::Vacuous } else { Verdict::Proved };
    prop_assert_eq!(verdict(&mesh), expected, "{:?}", corners(&mesh));
    let mut area = Rational::zero();
    for f in mesh.topology.faces() {
        let [a, b, c] = mesh.topology.face(f) else { unreachable!("triangles") };
        let own = turn(&points[a.index()], &points[b.index()], &points[c.index()]);
        prop_assert!(own > Rational::zero(), "face {} is not counter-clockwise", f.0);
        area += &own;
    }
    prop_assert_eq!(area, twice_hull_area(points));
    Ok(mesh)
}

/// Triples with an empty circumcircle and no fourth point on it, counter-clockwise; for the others
/// on a common circle, the fan from the lowest. Every triple against every point.
fn oracle(points: &[P]) -> BTreeSet<BTreeSet<usize>> {
    let zero = Rational::zero();
    let mut faces = BTreeSet::new();
    let n = points.len();
    for (a, b, c) in
        (0..n).flat_map(|a| (a + 1..n).flat_map(move |b| (b + 1..n).map(move |c| (a, b, c))))
    {
        let (b, c) = match turn(&points[a], &points[b], &points[c]) {
            area if area == zero => continue,
            area if area < zero => (c, b),
            _ => (b, c),
        };
        let place = |d: usize| inside(&points[a], &points[b], &points[c], &points[d]);
        let values: Vec<Rational> = (0..n).map(place).collect();
        if values.iter().any(|v| *v > zero) {
            continue;
        }
        let mut circle: Vec<usize> = (0..n).filter(|&d| values[d] == zero).collect();
        let by_place = |&d: &usize| (points[d].x.clone(), points[d].y.clone());
        circle.sort_by_key(by_place);
        let low = circle.remove(0);
        // The others counter-clockwise around the lowest, by exact turns.
        circle.sort_by(|&p, &q| {
            let t = turn(&points[low], &points[p], &points[q]);
            zero.partial_cmp(&t).expect("rationals are ordered")
        });
        faces.extend(circle.windows(2).map(|w| BTreeSet::from([low, w[0], w[1]])));
    }
    faces
}

fn distinct(places: Vec<(i64, i64)>) -> Vec<(i64, i64)> {
    let mut seen = BTreeSet::new();
    places.into_iter().filter(|&p| seen.insert(p)).collect()
}

fn are_collinear(points: &[P]) -> bool {
    points[2..].iter().all(|p| turn(&points[0], &points[1], p).is_zero())
}

/// Places on a small grid: many on lines and circles.
fn grid_places(side: i64, most: usize) -> impl Strategy<Value = Vec<(i64, i64)>> {
    prop::collection::vec((0..side, 0..side), 3..most)
        .prop_map(distinct)
        .prop_filter("three points not on a line", |places| {
            places.len() >= 3 && !are_collinear(&points(places))
        })
}

/// An exact affine image of grid places that doubles cannot hold.
fn skewed(places: &[(i64, i64)], tiny: i32) -> Vec<P> {
    let small = (0..tiny).fold(ratio(1, 3), |s, _| s * ratio(1, 10_007));
    let image = |p: &P| {
        let x = &p.x * ratio(1, 10) + &p.y * ratio(3, 7);
        let y = &p.y * ratio(1, 10) - &p.x * ratio(1, 7);
        // Far away, so that some fall together when rounded; a similarity but for a tiny shear.
        Point::new(
            ratio(10_000_019, 3) + &x * &small,
            ratio(1, 3) + &y * &small + &x * &small * &small,
            p.z.clone(),
        )
    };
    points(places).iter().map(image).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, ..ProptestConfig::default() })]

    #[test]
    fn small_grids_agree_with_the_search(places in grid_places(5, 14)) {
        let points = points(&places);
        let mesh = is_right(&points)?;
        let found: BTreeSet<BTreeSet<usize>> = mesh.topology.faces()
            .map(|f| mesh.topology.face(f).iter().map(|v| v.index()).collect())
            .collect();
        prop_assert_eq!(found, oracle(&points));
    }

    #[test]
    fn the_order_of_the_points_does_not_matter(places in grid_places(6, 40), seed in any::<u64>()) {
        let mesh = is_right(&points(&places))?;
        let mut order: Vec<usize> = (0..places.len()).collect();
        order.sort_by_key(|&i| (seed ^ i as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(29));
        let permuted = delaunay(order.iter().map(|&i| mesh.points[i].clone()).collect()).unwrap();
        prop_assert_eq!(corners(&mesh), corners(&permuted));
    }

    #[test]
    fn what_doubles_cannot_tell_apart_is_right(places in grid_places(6, 30), tiny in 0..8) {
        let points = skewed(&places, tiny);
        prop_assume!(!are_collinear(&points));
        is_right(&points)?;
    }

    #[test]
    fn clusters_within_one_double_are_right(
        centres in grid_places(4, 8),
        offsets in prop::collection::vec((0usize..8, 0i64..4, 0i64..4), 1..20),
    ) {
        // Around each centre a grid of size 2^-80: in doubles all of it is the centre.
        let unit = (0..80).fold(Rational::one(), |s, _| s * ratio(1, 2));
        let mut all = points(&centres);
        for (centre, i, j) in offsets {
            let p = &all[centre % centres.len()];
            let moved = Point::new(
                &p.x + Rational::from_i64(i) * &unit,
                &p.y + Rational::from_i64(j) * &unit,
                p.z.clone(),
            );
            if !all.iter().any(|q| q.is_parallel_to(&moved)) {
                all.push(moved);
            }
        }
        is_right(&all)?;
    }

    #[test]
    fn scattered_fractions_are_right(list in prop::collection::vec((-999i64..999, 1i64..99, -999i64..999, 1i64..99), 3..60)) {
        let mut all: Vec<P> = Vec::new();
        for (a, b, c, d) in list {
            let p = Point::new(ratio(a, b), ratio(c, d), Rational::zero());
            if !all.iter().any(|q| q.is_parallel_to(&p)) {
                all.push(p);
            }
        }
        prop_assume!(all.len() >= 3 && !are_collinear(&all));
        is_right(&all)?;
    }

    #[test]
    fn a_flipped_edge_is_found(places in grid_places(9, 30), at in any::<prop::sample::Index>()) {
        // The control: another diagonal in two triangles that are not on one circle.
        let mesh = is_right(&points(&places))?;
        let t = &mesh.topology;
        let edges: Vec<_> = t.edges().filter(|&h| t.twin(h).is_some()).collect();
        prop_assume!(!edges.is_empty());
        let h = edges[at.index(edges.len())];
        let g = t.twin(h).unwrap();
        let (a, b) = (t.origin(h), t.target(h));
        let (c, d) = (t.target(t.next(h)), t.target(t.next(g)));
        let p = |v: VertexId| &mesh.points[v.index()];
        prop_assume!(!inside(p(a), p(b), p(c), p(d)).is_zero());
        prop_assume!(turn(p(a), p(d), p(c)) > Rational::zero() && turn(p(d), p(b), p(c)) > Rational::zero());
        let mut faces = FaceList::new();
        for f in t.faces() {
            if f == t.face_at(h) {
                faces.push([a.0, d.0, c.0]);
            } else if f == t.face_at(g) {
                faces.push([d.0, b.0, c.0]);
            } else {
                faces.push(t.face(f).iter().map(|v| v.0));
            }
        }
        let flipped = Mesh::new(mesh.points.clone(), faces).unwrap();
        prop_assert_eq!(verdict(&flipped), Verdict::Refuted);
    }

    #[test]
    fn voronoi_cells_are_those_of_half_planes(places in grid_places(7, 30)) {
        let mesh = is_right(&points(&places))?;
        for (v, area) in mesh.topology.vertices().zip(voronoi_areas(&mesh)) {
            if let Some(area) = area {
                prop_assert_eq!(area, cell(&mesh.points, v.index()), "vertex {}", v.0);
            }
        }
    }
}

/// The area of the Voronoi cell, from a large square cut by all bisectors.
fn cell(points: &[P], v: usize) -> Rational {
    let far = 1_000_000;
    let mut polygon: Vec<(Rational, Rational)> =
        [(-far, -far), (far, -far), (far, far), (-far, far)]
            .map(|(x, y)| (ratio(x, 1), ratio(y, 1)))
            .into();
    for q in points.iter().filter(|q| !q.is_parallel_to(&points[v])) {
        let p = &points[v];
        let half = ratio(1, 2);
        // Positive on the side of p.
        let side = |(x, y): &(Rational, Rational)| {
            let (mx, my) = ((&p.x + &q.x) * &half, (&p.y + &q.y) * &half);
            (x - mx) * (&p.x - &q.x) + (y - my) * (&p.y - &q.y)
        };
        let mut cut = Vec::new();
        for (i, a) in polygon.iter().enumerate() {
            let b = &polygon[(i + 1) % polygon.len()];
            let (sa, sb) = (side(a), side(b));
            if sa >= Rational::zero() {
                cut.push(a.clone());
            }
            if (sa > Rational::zero() && sb < Rational::zero())
                || (sa < Rational::zero() && sb > Rational::zero())
            {
                let t = &sa / (&sa - &sb);
                cut.push((&a.0 + &t * (&b.0 - &a.0), &a.1 + &t * (&b.1 - &a.1)));
            }
        }
        polygon = cut;
    }
    let n = polygon.len();
    let twice = (0..n).fold(Rational::zero(), |sum, i| {
        let ((a, b), (c, d)) = (&polygon[i], &polygon[(i + 1) % n]);
        sum + a * d - b * c
    });
    twice * ratio(1, 2)
}

#[test]
fn a_circle_of_points_is_a_fan_from_the_lowest() {
    // All twelve lattice points on x² + y² = 25; the lowest is (-5, 0).
    let circle: Vec<(i64, i64)> = (-5..=5i64)
        .flat_map(|x| (-5..=5i64).map(move |y| (x, y)))
        .filter(|(x, y)| x * x + y * y == 25)
        .collect();
    let mesh = delaunay(points(&circle)).unwrap();
    assert_eq!(mesh.topology.face_count(), 10);
    assert!(corners(&mesh).iter().all(|face| face[0] == "-5 0"), "{:?}", corners(&mesh));
    assert_eq!(verdict(&mesh), Verdict::Proved);
}

#[test]
fn one_cocircular_point_moved_by_a_hair_decides() {
    // 2^-200 is far below what doubles of this size see.
    let hair = (0..200).fold(Rational::one(), |h, _| h * ratio(1, 2));
    for inwards in [true, false] {
        let mut square = points(&[(0, 0), (1, 0), (1, 1), (0, 1)]);
        square[2].x = if inwards { &square[2].x - &hair } else { &square[2].x + &hair };
        let mesh = delaunay(square).unwrap();
        // Moved in, (1, 1) lies inside the circle of the others, so it is joined to (0, 0).
        let joined = mesh.topology.edge(VertexId(0), VertexId(2)).is_some();
        assert_eq!(joined, inwards, "{:?}", corners(&mesh));
    }
}

#[test]
fn a_hull_that_rounding_bends_is_straight() {
    // On the line y = 3x/7 exactly, and on neither side of it once.
    let mut all: Vec<P> =
        (0..50).map(|i| Point::new(ratio(i, 10), ratio(3 * i, 70), Rational::zero())).collect();
    all.push(Point::new(ratio(1, 1), ratio(5, 1), Rational::zero()));
    let mesh = is_right(&all).unwrap();
    assert_eq!(mesh.topology.face_count(), 49);
    all.push(Point::new(ratio(1, 1), ratio(-5, 1), Rational::zero()));
    assert_eq!(is_right(&all).unwrap().topology.face_count(), 98);
}

#[test]
fn a_large_grid_is_right() {
    let n = 40;
    let tenth =
        |k: i64| "0.1".parse::<Numeral>().unwrap().value::<Rational>() * Rational::from_i64(k);
    let all: Vec<P> =
        (0..n * n).map(|k| Point::new(tenth(k / n), tenth(k % n), Rational::zero())).collect();
    let mesh = is_right(&all).unwrap();
    assert_eq!(mesh.topology.face_count() as i64, 2 * (n - 1) * (n - 1));
    // Every square is cut from its lowest corner, so the valence is 6 and cells are squares.
    let cells = voronoi_areas(&mesh);
    assert!(cells.iter().flatten().all(|area| *area == ratio(1, 100)));
    assert_eq!(cells.iter().flatten().count() as i64, (n - 2) * (n - 2));
}

#[test]
fn what_has_no_triangulation_says_why() {
    let error = |places: &[(i64, i64)]| delaunay(points(places)).unwrap_err();
    assert_eq!(error(&[]), NoTriangulation::TooFew { found: 0 });
    assert_eq!(error(&[(0, 0), (1, 0)]), NoTriangulation::TooFew { found: 2 });
    assert_eq!(error(&[(0, 0), (1, 1), (2, 2), (5, 5)]), NoTriangulation::Collinear);
    let twice = error(&[(0, 0), (1, 1), (0, 1), (1, 1), (7, 5)]);
    assert_eq!(twice, NoTriangulation::SameTopView(VertexId(1), VertexId(3)));
    assert_eq!(twice.to_string(), "points 1 and 3 have the same top view");
    // Two points are the same even where there would be too few.
    assert_eq!(error(&[(2, 1), (2, 1)]), NoTriangulation::SameTopView(VertexId(0), VertexId(1)));
    let far = (0..40).fold(Rational::one(), |p, _| p * ratio(1_000_000_007, 1));
    let mut line = points(&[(0, 0), (1, 1), (2, 2)]);
    line[2].x += &far.try_inv().unwrap();
    assert!(delaunay(line).is_ok(), "not on a line by less than any double shows");
}

#[test]
fn sizes_beyond_doubles_are_right() {
    let power = |n: usize| (0..n).fold(Rational::one(), |p, _| p * ratio(1_000_000_007, 1));
    for scale in [power(60), power(60).try_inv().unwrap()] {
        let all = points(&[(0, 0), (3, 1), (5, 4), (1, 7), (2, 2), (4, 6), (3, 3)]);
        let scaled: Vec<P> =
            all.iter().map(|p| Point::new(&p.x * &scale, &p.y * &scale, p.z.clone())).collect();
        let (mesh, other) = (is_right(&all).unwrap(), is_right(&scaled).unwrap());
        assert_eq!(mesh.topology, other.topology);
        assert!(scaled[1].x.numerator().bits() + scaled[1].x.denominator().bits() > 1100);
    }
}
