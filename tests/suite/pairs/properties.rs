//! Properties of pairs as verdicts: the fast decider against the definition and against curvatures,
//! invariance, controls.

use isogeo::check::{Decider, Element, Plain, Reason, Report, Verdict as Found};
use isogeo::construct::*;
use isogeo::mesh::{FaceId, FaceList, Mesh, VertexId};
use isogeo::pair::*;
use isogeo::scalar::{Field, Rational, RationalField, Ring};
use isogeo::space::*;
use proptest::prelude::*;

use super::*;
use crate::meshes::{combinatorics, relabelled};
use crate::nets::findings;

laws! {
    in 24 cases:
    fast_and_plain_agree_on_any_meshes
    fast_and_plain_agree_on_pairs
    inscribed_images_are_f_parallel_and_lifts_v_parallel
    faces_of_any_size_are_f_parallel_to_those_of_dual_meshes
    couples_say_what_curvatures_do
    translational_nets_have_christoffel_duals
    homothetic_pairs_have_constant_curvatures
    names_do_not_matter
    similarities_do_not_matter
    the_place_of_the_image_does_not_matter
}

pub fn definition<Q: RationalField>(m: &Mesh<Q>, s: &Mesh<Q>, property: PairProperty) -> Report<Q> {
    let points = [m.points.as_slice(), &s.points].concat();
    Couple::new(&m.topology, &s.topology, &Plain(&points)).unwrap().check(property)
}

fn fast<Q: RationalField>(m: &Mesh<Q>, s: &Mesh<Q>, property: PairProperty) -> Report<Rational> {
    let [m, s] = [m, s].map(|mesh| mesh.map(Q::convert::<Rational>));
    let decider = Decider::of_rationals(&m.points).followed_by(Decider::of_rationals(&s.points));
    Couple::new(&m.topology, &s.topology, &decider).unwrap().check(property)
}

fn verdict<Q: RationalField>(m: &Mesh<Q>, s: &Mesh<Q>, property: PairProperty) -> Found {
    fast(m, s, property).verdict()
}

fn agree<Q: RationalField>(m: &Mesh<Q>, s: &Mesh<Q>) -> Verdict {
    for property in PairProperty::ALL {
        let (slow, quick) = (definition(m, s, property), fast(m, s, property));
        prop_assert_eq!(findings(&slow), findings(&quick), "{} {:?} {:?}", property.name(), m, s);
        if let (Some(a), Some(b)) = (slow.worst, quick.worst) {
            prop_assert!((a.failure.defect - b.failure.defect).abs() <= 1e-9, "{:?} {:?}", a, b);
            // Sums are one value; among several residuals the worst is chosen by rounded numbers.
            let sums = ["mixed area 0", "the same H", "the same K"];
            let found = (a.element, a.failure.condition);
            if sums.contains(&found.1) && found == (b.element, b.failure.condition) {
                let exact = b.failure.residual.map(|r| r.convert::<Q>());
                prop_assert_eq!(a.failure.residual, exact);
            }
        }
    }
    Ok(())
}

/// A mesh with few different coordinates, so that coincidences are frequent.
fn coarse<Q: RationalField>(draw: &mut Draw<Q>, count: usize) -> Vec<Point<Q>> {
    let few: [Q; 4] = [q(0, 1), q(1, 1), q(-1, 1), q(1, 2)];
    let mut number = || few[draw.index(4)].clone();
    (0..count).map(|_| Point::new(number(), number(), number())).collect()
}

fn fast_and_plain_agree_on_any_meshes<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    for (count, faces) in combinatorics() {
        let m = Mesh::new(coarse(draw, count), faces).unwrap();
        let mut image = coarse(draw, count);
        if draw.index(2) == 0 {
            let copied = draw.index(count);
            image[..copied].clone_from_slice(&m.points[..copied]);
        }
        agree(&m, &Mesh { points: image, ..m.clone() })?;
    }
    Ok(())
}

fn fast_and_plain_agree_on_pairs<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = polygon(draw);
    agree(&m, &parallel_polygon(draw, &m))?;
    let m = circular(draw, 2, 2);
    agree(&m, &lift(&m))?;
    if let Ok(pair) = inscribed_f_parallel(&m, VertexId(4), &draw.top_view()) {
        agree(&m, pair.image())?;
        // Far beyond one common denominator.
        let small = Q::one() / Q::from_i64(1_000_003) / Q::from_i64(999_999_999_989);
        let tiny = m.map(|c| c * &small);
        agree(&tiny, &pair.image().map(|c| c + &small))?;
    }
    Ok(())
}

/// The least step that no printed digit would show.
fn bit<Q: RationalField>() -> Q {
    q(1, 1 << 40)
}

/// The faces at a vertex.
fn around<T>(mesh: &Mesh<T>, v: VertexId) -> Vec<Element> {
    let faces = mesh.topology.faces().filter(|&f| mesh.topology.face(f).contains(&v));
    faces.map(Element::Face).collect()
}

/// The edges at a vertex.
pub fn edges_at<T>(mesh: &Mesh<T>, v: VertexId) -> Vec<Element> {
    let topology = &mesh.topology;
    let ends = topology.edges().map(|h| (topology.origin(h), topology.target(h)));
    ends.filter(|&(a, b)| a == v || b == v).map(|(a, b)| Element::Edge(a, b)).collect()
}

fn inscribed_images_are_f_parallel_and_lifts_v_parallel<Q: RationalField>(
    draw: &mut Draw<Q>,
) -> Verdict {
    let m = circular(draw, 2, 2);
    if !graph_faces(&m) {
        return Ok(());
    }
    let pair = inscribed_f_parallel(&m, VertexId(4), &draw.top_view()).unwrap();
    let mut s = pair.into_image();
    prop_assert_eq!(verdict(&m, &s, PairProperty::Parallel), Found::Proved);
    prop_assert_eq!(verdict(&m, &s, PairProperty::FParallel), Found::Proved);
    let v = VertexId(draw.index(9) as u32);
    s.points[v.index()].z += &bit::<Q>();
    prop_assert_eq!(fast(&m, &s, PairProperty::FParallel).failures, around(&m, v));
    let moved = fast(&m, &s, PairProperty::Parallel).failures;
    let edges = edges_at(&m, v);
    prop_assert_eq!(&moved, &edges);
    for property in [PairProperty::Cmc, PairProperty::ConstantK, PairProperty::IMinimal] {
        let found = fast(&m, &s, property).failures;
        prop_assert!(around(&m, v).iter().all(|f| found.contains(f)), "{}", property.name());
    }
    let mut s = lift(&m);
    prop_assert_eq!(verdict(&m, &s, PairProperty::VParallel), Found::Proved);
    s.points[v.index()].y -= &bit::<Q>();
    let moved = fast(&m, &s, PairProperty::VParallel).failures;
    prop_assert_eq!(moved[0], Element::Vertex(v));
    prop_assert!(moved[1..].iter().all(|f| around(&m, v).contains(f)));
    // Raised, the top view is the same, but faces of S are not planar any more.
    let mut s = lift(&m);
    s.points[v.index()].z += &bit::<Q>();
    let report = fast(&m, &s, PairProperty::VParallel);
    prop_assert_eq!(report.failures, around(&m, v));
    prop_assert_eq!(report.worst.map(|w| w.failure.condition), Some("planar Gauss image"));
    Ok(())
}

/// The duals of two triangle meshes with the same top view: valences become sizes of faces.
fn dual_pair<Q: RationalField>(draw: &mut Draw<Q>) -> Option<(Mesh<Q>, Mesh<Q>)> {
    let triangles = triangle_patch(draw, 4, 4);
    let others = with_heights(draw, &triangles);
    let pair = (metric_dual(&triangles).ok()?, metric_dual(&others).ok()?);
    graph_faces(&pair.0).then_some(pair)
}

/// `duality-f-v`
fn faces_of_any_size_are_f_parallel_to_those_of_dual_meshes<Q: RationalField>(
    draw: &mut Draw<Q>,
) -> Verdict {
    let Some((m, mut s)) = dual_pair(draw) else { return Ok(()) };
    agree(&m, &s)?;
    prop_assert_eq!(verdict(&m, &s, PairProperty::FParallel), Found::Proved);
    let v = VertexId(draw.index(m.points.len()) as u32);
    s.points[v.index()].z -= &bit::<Q>();
    prop_assert_eq!(fast(&m, &s, PairProperty::FParallel).failures, around(&m, v));
    agree(&m, &s)
}

/// The properties fail exactly where the curvatures of [`FParallel`] say so.
fn couples_say_what_curvatures_do<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = circular(draw, 2, 2);
    let pairs = [
        dual_pair(draw),
        inscribed_f_parallel(&m, VertexId(4), &draw.top_view())
            .ok()
            .map(|p| (m.clone(), p.into_image())),
    ];
    for (m, s) in pairs.into_iter().flatten() {
        let pair = FParallel::new(&m, &s).unwrap();
        let curvatures: Vec<_> = m.topology.faces().map(|f| pair.face_curvatures(f)).collect();
        let size = |f: &FaceId| m.topology.face(*f).len();
        let curved = || m.topology.faces().filter(|f| curvatures[f.0 as usize].is_ok());
        let Some(first) = curved().min_by_key(size) else { continue };
        let forms = pair.face_forms(first).four;
        for (property, of) in [
            (PairProperty::IMinimal, (|c: &Curvatures<Q>| c.mean.clone()) as fn(&_) -> Q),
            (PairProperty::Cmc, |c| c.mean.clone()),
            (PairProperty::ConstantK, |c| c.gauss.clone()),
        ] {
            let report = definition(&m, &s, property);
            let at = |f: FaceId| curvatures[f.0 as usize].as_ref().ok().map(of);
            let expected = match property {
                PairProperty::IMinimal => Some(Q::zero()),
                _ => at(first),
            };
            let other = curved().filter(|&f| at(f) != expected).map(Element::Face);
            prop_assert_eq!(&report.failures, &other.collect::<Vec<_>>(), "{}", property.name());
            let flat = m.topology.faces().filter(|&f| at(f).is_none());
            let flat: Vec<_> = flat.map(|f| (Element::Face(f), Reason::ZeroArea(f))).collect();
            prop_assert_eq!(&report.undefined, &flat);
            if let Some(worst) = report.worst
                && let Element::Face(f) = worst.element
                && let (Some(here), Some(there)) = (at(f), expected)
            {
                let area = pair.face_forms(f).four.first;
                let scale =
                    if property == PairProperty::IMinimal { area } else { area * &forms.first };
                prop_assert_eq!(worst.failure.residual, Some((here - there) * scale));
            }
        }
    }
    Ok(())
}

/// With edges a, b of a translational net, the edges a, −b close and have mixed area 0.
fn translational_nets_have_christoffel_duals<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let profile = |draw: &mut Draw<Q>| -> Vec<(Q, Q)> {
        (0..=3).map(|i| (Q::from_i64(20 * i) + draw.number(), draw.number())).collect()
    };
    let (f, mut g) = (profile(draw), profile(draw));
    let m = translational_net(&f, &g).unwrap();
    g.iter_mut().for_each(|(y, z)| (*y, *z) = (-y.clone(), -z.clone()));
    let mut s = translational_net(&f, &g).unwrap();
    for property in PairProperty::ALL {
        let expected =
            if property == PairProperty::VParallel { Found::Refuted } else { Found::Proved };
        prop_assert_eq!(verdict(&m, &s, property), expected, "{}", property.name());
    }
    agree(&m, &s)?;
    // The last row of edges a bit longer: edges are parallel, only the last faces have H ≠ 0.
    let last = |i: usize| i % 4 == 3;
    let long = |i: usize, p: &Point<Q>| {
        let step = &s.points[i] - &s.points[i - 1];
        let by = bit::<Q>();
        Point::new(&p.x + step.x * &by, &p.y + step.y * &by, &p.z + step.z * by)
    };
    let stretched = s.points.iter().enumerate();
    let points: Vec<_> =
        stretched.map(|(i, p)| if last(i) { long(i, p) } else { p.clone() }).collect();
    let other = Mesh { points, ..s.clone() };
    prop_assert_eq!(verdict(&m, &other, PairProperty::Parallel), Found::Proved);
    let rim: Vec<_> = [2, 5, 8].map(|f| Element::Face(FaceId(f))).into();
    for property in PairProperty::ALL {
        if matches!(
            property,
            PairProperty::ChristoffelDual
                | PairProperty::IMinimal
                | PairProperty::Cmc
                | PairProperty::ConstantK
        ) {
            prop_assert_eq!(&fast(&m, &other, property).failures, &rim, "{}", property.name());
        }
    }
    // One coordinate moved by a bit: the edges and faces there.
    s.points[5].z += &bit::<Q>();
    let failures = fast(&m, &s, PairProperty::ChristoffelDual).failures;
    prop_assert_eq!(failures, [edges_at(&m, VertexId(5)), around(&m, VertexId(5))].concat());
    Ok(())
}

fn homothetic_pairs_have_constant_curvatures<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let Some((m, _)) = dual_pair(draw) else { return Ok(()) };
    let factor = draw.non_zero();
    let mut s = m.map(|c| c * &factor);
    let curved = definition(&m, &s, PairProperty::Cmc).undefined.is_empty();
    let expected = if curved { Found::Proved } else { Found::Undecided };
    for property in [PairProperty::Cmc, PairProperty::ConstantK] {
        prop_assert_eq!(verdict(&m, &s, property), expected);
    }
    s.points[0].z += &bit::<Q>();
    for property in [PairProperty::Cmc, PairProperty::ConstantK] {
        let report = fast(&m, &s, property);
        let at = around(&m, VertexId(0));
        prop_assert_eq!(&report.failures, &at);
        let condition = report.worst.map(|w| w.failure.condition);
        prop_assert_eq!(condition, (!at.is_empty()).then_some("parallel face planes"));
    }
    Ok(())
}

fn names_do_not_matter<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = circular(draw, 2, 2);
    let seed = 1 + draw.index(60) as u64;
    let image = inscribed_f_parallel(&m, VertexId(4), &draw.top_view()).map(|p| p.into_image());
    for s in image.into_iter().chain([lift(&m), m.map(|c| c * &q(2, 1))]) {
        let (other, image) = (relabelled(&m, seed), relabelled(&s, seed));
        for property in PairProperty::ALL {
            let (a, b) = (fast(&m, &s, property), fast(&other, &image, property));
            prop_assert_eq!(a.verdict(), b.verdict(), "{}", property.name());
            prop_assert_eq!(a.undefined.len(), b.undefined.len());
            // Which face others are compared with depends on the names.
            let compared = matches!(property, PairProperty::Cmc | PairProperty::ConstantK);
            prop_assert!(compared || a.failures.len() == b.failures.len());
        }
    }
    Ok(())
}

fn similarities_do_not_matter<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (motion, scaling) = (draw.motion(), draw.scaling());
    let translation = Vector3::new(Q::zero(), Q::zero(), Q::zero());
    let linear = Motion { translation, ..motion.clone() };
    let m = circular(draw, 2, 2);
    let image = inscribed_f_parallel(&m, VertexId(4), &draw.top_view()).map(|p| p.into_image());
    let similar = |g: &Motion<Q>, mesh: &Mesh<Q>| g.apply(&scaling.apply(mesh));
    for s in image.into_iter().chain([lift(&m), m.map(|c| c * &q(-1, 3))]) {
        for property in PairProperty::ALL {
            let together = if property == PairProperty::VParallel { &motion } else { &linear };
            let (other, image) = (similar(&motion, &m), similar(together, &s));
            let (a, b) = (fast(&m, &s, property), fast(&other, &image, property));
            prop_assert_eq!(findings(&a), findings(&b), "{}", property.name());
        }
    }
    Ok(())
}

/// Only the shape of S enters, also into the defect.
fn the_place_of_the_image_does_not_matter<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = circular(draw, 2, 2);
    let mut s = lift(&m);
    s.points[3].x += &draw.number();
    let far = Q::from_i64(1 << 40);
    let points = s.points.iter().map(|p| Point::new(&p.x + &far, &p.y - &far, &p.z + &far));
    let away = Mesh { points: points.collect(), ..s.clone() };
    for property in PairProperty::ALL.into_iter().filter(|&p| p != PairProperty::VParallel) {
        let (a, b) = (fast(&m, &s, property), fast(&m, &away, property));
        prop_assert_eq!(findings(&a), findings(&b), "{}", property.name());
        let defect = |report: Report<Rational>| report.worst.map_or(0.0, |w| w.failure.defect);
        prop_assert!((defect(a) - defect(b)).abs() <= 1e-9, "{}", property.name());
    }
    Ok(())
}

fn flat(points: &[[i64; 2]], faces: &[&[u32]]) -> Mesh<Rational> {
    let mut list = FaceList::new();
    faces.iter().for_each(|f| list.push(f.iter().copied()));
    let points = points.iter().map(|p| Point::new(p[0], p[1], 0).map(|&c| Rational::from_i64(c)));
    Mesh::new(points.collect(), list).unwrap()
}

#[test]
fn names_of_properties_lead_back() {
    for property in PairProperty::ALL {
        assert_eq!(PairProperty::from_name(property.name()), Some(property));
    }
    assert_eq!(PairProperty::from_name("planar"), None);
}

#[test]
fn a_bow_tie_has_no_curvature_but_a_mixed_area() {
    // A square and a bow-tie beside it; S is the mesh itself.
    let points = [[0, 0], [1, 0], [1, 1], [0, 1], [2, 1], [2, 0]];
    let m = flat(&points, &[&[0, 1, 2, 3], &[2, 1, 4, 5]]);
    let undefined = vec![(Element::Face(FaceId(1)), Reason::ZeroArea(FaceId(1)))];
    for property in [PairProperty::Cmc, PairProperty::ConstantK, PairProperty::IMinimal] {
        assert_eq!(fast(&m, &m, property).undefined, undefined, "{}", property.name());
    }
    assert_eq!(verdict(&m, &m, PairProperty::Cmc), Found::Undecided);
    // area(F, F) = area(F) is 1 for the square and 0 for the bow-tie.
    let dual = fast(&m, &m, PairProperty::ChristoffelDual);
    assert_eq!(dual.failures, [Element::Face(FaceId(0))]);
    assert_eq!(dual.worst.and_then(|w| w.failure.residual), Some(Rational::from_i64(4)));
}

#[test]
fn vertical_faces_are_undefined() {
    let mut wall = flat(&[[0, 0], [1, 0], [1, 0], [0, 0]], &[&[0, 1, 2, 3]]);
    wall.points[2].z = Rational::one();
    wall.points[3].z = Rational::one();
    let vertical = vec![(Element::Face(FaceId(0)), Reason::VerticalFace(FaceId(0)))];
    for property in PairProperty::ALL.into_iter().filter(|&p| p != PairProperty::Parallel) {
        assert_eq!(fast(&wall, &wall, property).undefined, vertical, "{}", property.name());
    }
    assert_eq!(verdict(&wall, &wall, PairProperty::Parallel), Found::Proved);
    let floor = flat(&[[0, 0], [1, 0], [1, 1], [0, 1]], &[&[0, 1, 2, 3]]);
    let image = vec![(Element::Face(FaceId(0)), Reason::VerticalImage(FaceId(0)))];
    assert_eq!(fast(&floor, &wall, PairProperty::VParallel).undefined, image);
    // A Gauss image may degenerate where only planes or edges are asked for.
    let point = floor.map(|_| Rational::one());
    assert_eq!(verdict(&floor, &point, PairProperty::FParallel), Found::Proved);
    assert_eq!(verdict(&floor, &point, PairProperty::IMinimal), Found::Proved);
}

#[test]
fn without_faces_there_is_nothing_to_check() {
    let cloud = flat(&[[0, 0], [1, 0]], &[]);
    for property in PairProperty::ALL {
        let expected = match property {
            PairProperty::VParallel => Found::Proved,
            _ => Found::Vacuous,
        };
        assert_eq!(verdict(&cloud, &cloud, property), expected, "{}", property.name());
    }
}

/// Two flat hexagons: S moved in the plane stays f-parallel, and H tells.
#[test]
fn hexagons_with_constant_h_and_one_that_is_spoilt() {
    let ring =
        [[2, 0], [1, 2], [-1, 2], [-2, 0], [-1, -2], [1, -2], [4, 0], [5, 2], [4, 4], [2, 4]];
    let m = flat(&ring, &[&[0, 1, 2, 3, 4, 5], &[0, 6, 7, 8, 9, 1]]);
    let mut s = m.map(|c| c * Rational::from_i64(-3));
    assert_eq!(verdict(&m, &s, PairProperty::Cmc), Found::Proved);
    assert_eq!(verdict(&m, &s, PairProperty::ConstantK), Found::Proved);
    s.points[8].x += &Rational::from_ratio(1, 1 << 40);
    for (property, condition) in
        [(PairProperty::Cmc, "the same H"), (PairProperty::ConstantK, "the same K")]
    {
        let report = fast(&m, &s, property);
        assert_eq!(report.failures, [Element::Face(FaceId(1))]);
        assert_eq!(report.worst.map(|w| w.failure.condition), Some(condition));
    }
    assert_eq!(verdict(&m, &s, PairProperty::FParallel), Found::Proved);
    assert_eq!(verdict(&m, &s, PairProperty::Parallel), Found::Refuted);
}

#[test]
fn combinatorics_that_differ_are_an_error() {
    let m = flat(&[[0, 0], [1, 0], [1, 1], [0, 1]], &[&[0, 1, 2], &[0, 2, 3]]);
    let other = flat(&[[0, 0], [1, 0], [1, 1], [0, 1]], &[&[0, 1, 2], &[2, 3, 0]]);
    let fewer = flat(&[[0, 0], [1, 0], [1, 1]], &[&[0, 1, 2]]);
    let decider = Decider::of_rationals(&m.points);
    let misfit = |s: &Mesh<Rational>| Couple::new(&m.topology, &s.topology, &decider).err();
    assert_eq!(misfit(&other), Some(Misfit::Face(FaceId(1))));
    let counts = Misfit::Counts { vertices: (4, 3), faces: (2, 1) };
    assert_eq!(misfit(&fewer), Some(counts));
}
