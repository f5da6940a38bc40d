//! The public strategies: they keep what they promise, and shrink to a few faces.

use isogeo::check::{Plain, Verdict};
use isogeo::mesh::{Mesh, Topology, TopologyError};
use isogeo::net::{Net, Property};
use isogeo::pair::{FParallel, VParallel};
use isogeo::scalar::{BigRational, Field, Rational, RationalField, Ring};
use isogeo::space::Transform;
use isogeo::space::laguerre::LaguerreTransformation;
use isogeo::strategy::*;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{RngAlgorithm, TestCaseError, TestError, TestRng, TestRunner};

use crate::meshes::Q;

fn verdict<T: RationalField>(mesh: &Mesh<T>, property: Property) -> Verdict {
    Net::new(&mesh.topology, &Plain(&mesh.points)).check(property).verdict()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    #[test]
    fn planar_meshes_are_planar(
        mesh in prop_oneof![quad_patches::<Q>(), polygons()], circular in circular::<Q>(),
    ) {
        let expected = |mesh: &Mesh<Q>| {
            let triangles = mesh.topology.faces().all(|f| mesh.topology.face(f).len() == 3);
            if triangles { Verdict::Vacuous } else { Verdict::Proved }
        };
        prop_assert_eq!(verdict(&mesh, Property::Planar), expected(&mesh));
        prop_assert_eq!(verdict(&circular, Property::Planar), Verdict::Proved);
        prop_assert_eq!(verdict(&circular, Property::ICircular), Verdict::Proved);
    }

    #[test]
    fn conical_and_koebe_meshes_are_what_they_are_called(
        conical in conical::<Rational>(), koebe in koebe::<Rational>(),
    ) {
        prop_assert_eq!(verdict(&conical, Property::Planar), Verdict::Proved);
        prop_assert_eq!(verdict(&conical, Property::IConical), Verdict::Proved);
        prop_assert_eq!(verdict(&koebe, Property::Planar), Verdict::Proved);
        prop_assert_eq!(verdict(&koebe, Property::Midscribed), Verdict::Proved);
    }

    #[test]
    fn pairs_are_parallel(f in f_parallel::<Rational>(), v in v_parallel::<Rational>(), m in i_minimal::<Rational>()) {
        prop_assert!(FParallel::new(&f.surface, &f.gauss).is_ok());
        prop_assert!(VParallel::new(&v.surface, &v.gauss).is_ok());
        let pair = FParallel::new(&m.surface, &m.gauss);
        prop_assert_eq!(verdict(&m.gauss, Property::Inscribed), Verdict::Proved);
        if let Ok(pair) = pair {
            for face in m.surface.topology.faces() {
                prop_assert!(pair.face_forms(face).mixed_area().is_zero());
            }
        }
    }

    #[test]
    fn graphs_of_triangles_are_embedded(
        mesh in prop_oneof![jittered::<Q>(), delaunay_graph()], lattice in lattice::<Q>(),
    ) {
        let signs = |mesh: &Mesh<Q>| {
            let area = |f| isogeo::pair::twice_area(&mesh.topology.face(f).iter()
                .map(|v| mesh.points[v.index()].top_view()).collect::<Vec<_>>());
            mesh.topology.faces().map(area).collect::<Vec<Q>>()
        };
        prop_assert!(signs(&mesh).iter().all(|area| *area > Q::zero()));
        let areas = signs(&lattice);
        prop_assert!(!areas[0].is_zero() && areas.iter().all(|area| *area == areas[0]));
    }

    #[test]
    fn transformations_are_invertible(map in moebius::<Q>(), other in laguerre::<Q>(), motion in motion::<Q>()) {
        prop_assert_eq!(map.then(&map.inverse()), isogeo::space::MoebiusTransformation::identity());
        prop_assert_eq!(other.then(&other.inverse()), LaguerreTransformation::identity());
        let p = isogeo::space::Point::new(Q::from_i64(1), Q::from_i64(2), Q::from_ratio(3, 7));
        prop_assert_eq!(motion.inverse().apply(&motion.apply(&p)), p);
    }

    #[test]
    fn broken_faces_are_refused_for_what_is_wrong(faces in broken()) {
        let refused = Topology::new(faces.vertices, faces.face_list());
        let fits = matches!((faces.defect, &refused),
            (Defect::TooSmall, Err(TopologyError::FaceTooSmall { .. }))
            | (Defect::NoSuchVertex, Err(TopologyError::NoSuchVertex { .. }))
            | (Defect::Repeated, Err(TopologyError::RepeatedVertex { .. }))
            | (Defect::Doubled | Defect::TurnedOver | Defect::ThreeAtAnEdge, Err(_)));
        prop_assert!(fits, "{:?} {:?}", faces, refused);
    }
}

/// The smallest mesh of a strategy that a false statement fails on.
fn smallest<S: Strategy<Value = Mesh<BigRational>>>(
    meshes: S,
    holds: impl Fn(&Mesh<BigRational>) -> bool,
) -> Mesh<BigRational> {
    let config = ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(512) };
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let found = TestRunner::new_with_rng(config, rng).run(&meshes, |mesh| match holds(&mesh) {
        true => Ok(()),
        false => Err(TestCaseError::fail("false")),
    });
    match found {
        Err(TestError::Fail(_, mesh)) => mesh,
        other => panic!("no counterexample: {other:?}"),
    }
}

#[test]
fn failures_shrink_to_a_few_faces() {
    let planar = |mesh: &Mesh<Q>| verdict(mesh, Property::ICircular) != Verdict::Refuted;
    assert_eq!(smallest(quad_patches(), planar).topology.face_count(), 1);
    let conical = |mesh: &Mesh<Q>| verdict(mesh, Property::IConical) != Verdict::Refuted;
    assert!(smallest(any_mesh(small()), conical).topology.face_count() <= 6);
    assert!(smallest(star(), conical).topology.face_count() <= 6);
    let delaunay = |mesh: &Mesh<Q>| verdict(mesh, Property::Delaunay) != Verdict::Refuted;
    // Rows and columns are cut off behind the failure, not before it.
    assert!(smallest(jittered(), delaunay).topology.face_count() <= 8);
    let inscribed = |mesh: &Mesh<Q>| verdict(mesh, Property::Inscribed) != Verdict::Refuted;
    assert_eq!(smallest(cauchy(), inscribed).topology.face_count(), 1);
    assert_eq!(smallest(koebe(), inscribed).topology.face_count(), 1);
}

#[test]
fn near_degenerate_meshes_are_degenerate_and_nearly_so() {
    // Among a few hundred, each kind of thing happens: all verdicts of planarity, and a tiny residual.
    let mut runner = TestRunner::deterministic();
    let meshes = near_degenerate(circular::<Q>());
    let (mut verdicts, mut tiny) = (Vec::new(), 0);
    for _ in 0..300 {
        let mesh = meshes.new_tree(&mut runner).expect("a mesh").current();
        let report = Net::new(&mesh.topology, &Plain(&mesh.points)).check(Property::ICircular);
        verdicts.push(report.verdict());
        tiny += usize::from(report.worst.is_some_and(|w| w.failure.defect < 1e-9));
    }
    for verdict in [Verdict::Proved, Verdict::Refuted, Verdict::Undecided] {
        assert!(verdicts.contains(&verdict), "{verdict}");
    }
    assert!(tiny > 10, "{tiny}");
}
