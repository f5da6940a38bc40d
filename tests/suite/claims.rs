//! The ledger holds; and the machine that says so can fail in every way it should.

use isogeo::claim::{
    Claim, Control, Counterexample, Evidence, Experiment, Grade, Hypothesis, Identity, Options,
    Report, Run, Seed, Source, Trial, Verdict, claim, claims, ledger, mutants, verify,
};
use isogeo::mesh::file::{Format, read_bytes};
use isogeo::mesh::{FaceList, Mesh};
use isogeo::pair::twice_area;
use isogeo::scalar::{Field, Rational, RationalField, Ring};
use isogeo::space::TopView;

fn judged(claims: &[&'static Claim]) -> Vec<Report> {
    verify(claims, &Options { samples: 12, seed: Seed::of(1) }, &|_| {})
}

#[test]
fn every_claim_holds_and_the_page_is_true() {
    let reports = judged(&claims().collect::<Vec<_>>());
    for report in &reports {
        let id = report.claim.id;
        assert_eq!(report.verdict(), Verdict::Holds, "{id}: {:?}", report.failures());
    }
    let page = std::fs::read_to_string("proofs/README.md").expect("proofs/README.md");
    assert!(
        page == ledger(&reports),
        "proofs/README.md is old: isogeo claims verify --ledger proofs/README.md"
    );
}

/// The names by which others cite the claims of the paper.
const CITED: &str = "\
    cgc-offset christoffel-dual cmc-offset conical-cone delaunay-lift duality-f-v \
    duality-incidence duality-involution duality-metric duality-parallel duality-sigma \
    eq-1-motions eq-10-dual-surface eq-11-curvatures eq-12-cones eq-12-spheres eq-13-circular \
    eq-14-conical eq-15-16-form eq-17-18 eq-20 eq-20-incircle eq-21-22-duality eq-22-cotan \
    eq-3-sections eq-6-gauss eq-8-9-curvatures fig-11-accuracy fig-8-planar-lines \
    fig-9-concurrent hex-rotational i-minimal-dual koebe-edge koebe-minimal koebe-vertex \
    laguerre-group minkowski moebius-cylindrical moebius-parabolic offset-edge offset-face \
    offset-vertex parallel-linear r-normals-coplanar remark-1 remark-2-edge-offset \
    remark-2-moebius remark-4 thm-1-converse thm-1-f thm-1-v thm-2-dual thm-2-f thm-2-v \
    thm-2-voronoi thm-3";

#[test]
fn names_are_stable() {
    let mut names: Vec<&str> = claims().map(|claim| claim.id).collect();
    for id in CITED.split_whitespace() {
        let claim = claim(id).unwrap_or_else(|| panic!("{id} is gone"));
        assert_ne!(claim.source, Source::Ours, "{id}");
        let open = ["parallel-linear", "thm-2-voronoi", "delaunay-lift"].contains(&id);
        assert_eq!(claim.said == Grade::Instances, open, "{id} is {}", claim.said);
    }
    names.sort_unstable();
    let count = names.len();
    names.dedup();
    assert_eq!(names.len(), count, "a name stands twice");
    let ours = claims().filter(|claim| claim.source == Source::Ours).count();
    assert_eq!(count, CITED.split_whitespace().count() + ours);
}

/// Every operation of a formula that a claim runs is needed: made wrong, a claim falls.
#[test]
fn every_line_of_a_formula_is_missed_when_it_is_wrong() {
    let tallies = mutants(claims());
    let unnoticed: Vec<String> = tallies
        .iter()
        .filter(|(_, tally)| tally.killed == 0)
        .map(|((file, line), tally)| format!("{file}:{line} ({} mutants)", tally.survived))
        .collect();
    assert_eq!(unnoticed, [""; 0]);
}

const CONCYCLIC: &str = "x0 y1 = x1 y0";

/// True, but for the hypothesis under which it is true.
struct Trapezoid;

impl Identity for Trapezoid {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (a, b, t) = (trial.free(), trial.free(), trial.free());
        let (c, d) = (&a * &t, &b * &t);
        let (c, d) = (trial.constrained(c), trial.constrained(d));
        trial.relation(CONCYCLIC, &a * &d - &b * &c)?;
        let triangle = [(T::zero(), T::zero()), (a, b), (c, d)].map(|(x, y)| TopView::new(x, y));
        trial.zero("area", twice_area(&triangle));
        Ok(())
    }
}

/// False.
struct Area;

impl Identity for Area {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let triangle = [(); 3].map(|()| TopView::new(trial.free(), trial.free()));
        let mut faces = FaceList::new();
        faces.push([0, 1, 2]);
        let points = triangle.iter().map(|v| v.at_height(T::zero())).collect();
        let mesh = trial.accepted("a triangle", Mesh::new(points, faces))?;
        trial.exhibit("triangle", &mesh);
        trial.zero("area", twice_area(&triangle));
        Ok(())
    }
}

/// True, but it divides by something that no hypothesis excludes.
struct Division;

impl Identity for Division {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (a, b) = (trial.free(), trial.free());
        let inverse = trial.defined("always", (&a - &b).try_inv())?;
        trial.equal("one", &(inverse * (a - b)), &T::one());
        Ok(())
    }
}

/// Moves something that does not matter.
struct Idle;

impl Identity for Idle {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let a = trial.free();
        let _ = trial.made(a.clone());
        trial.equal("the same", &a.square(), &(&a * &a));
        Ok(())
    }
}

/// Has no goals.
struct Nothing;

impl Experiment for Nothing {
    fn run<T: RationalField>(_: &mut Trial<T>) -> Run {
        Ok(())
    }
}

const TRUE: Claim = Claim {
    id: "trapezoid",
    statement: "A triangle with corners on a line through its first corner has area 0.",
    formula: "",
    source: Source::Ours,
    hypotheses: &[Hypothesis::stated(CONCYCLIC)],
    said: Grade::Decided,
    argument: "",
    evidence: &[Evidence::identity::<Trapezoid>("area", &[1], &[1])],
    controls: &[Control {
        without: CONCYCLIC,
        shows: "the unit triangle",
        counterexample: Counterexample::Witness(|| Ok("area: 1".into())),
    }],
};

#[test]
fn a_relation_is_a_hypothesis() {
    static CLAIM: Claim = TRUE;
    let reports = judged(&[&CLAIM]);
    assert_eq!(reports[0].failures(), [""; 0]);
    assert_eq!((reports[0].shown(), reports[0].verdict()), (Grade::Decided, Verdict::Holds));
    // The counterexample, and two constrained numbers moved.
    assert_eq!(reports[0].controls(), 3);
}

#[test]
fn what_is_wrong_with_a_claim_is_found() {
    const SURE: Claim = Claim { hypotheses: &[], controls: &[], ..TRUE };
    static FALSE: Claim =
        Claim { evidence: &[Evidence::identity::<Area>("area", &[1], &[1])], ..SURE };
    static UNSTATED: Claim =
        Claim { evidence: &[Evidence::identity::<Division>("division", &[1], &[1])], ..SURE };
    static IDLE: Claim =
        Claim { evidence: &[Evidence::identity::<Idle>("idle", &[1], &[1])], ..SURE };
    static SAMPLED: Claim =
        Claim { evidence: &[Evidence::identity::<Trapezoid>("area", &[], &[1])], ..TRUE };
    static UNCONTROLLED: Claim = Claim { controls: &[], ..TRUE };
    static HARMLESS: Claim = Claim {
        controls: &[Control {
            without: CONCYCLIC,
            shows: "nothing",
            counterexample: Counterexample::Unknowns {
                evidence: 0,
                size: 1,
                unknowns: &["1", "2"],
                constrained: &[],
            },
        }],
        ..TRUE
    };
    static VACUOUS: Claim = Claim {
        said: Grade::Instances,
        evidence: &[Evidence::experiment::<Nothing>("nothing", &[1])],
        ..SURE
    };
    let reports = judged(&[&FALSE, &UNSTATED, &IDLE, &SAMPLED, &UNCONTROLLED, &HARMLESS, &VACUOUS]);
    // The failure is small, and a file.
    let failure = reports[0].parts[0].sampling.failure.as_ref().expect("a failure");
    let (name, text) = &failure.meshes[0];
    let file = read_bytes("triangle.iso.json", Format::IsoJson, text.as_bytes()).expect("a mesh");
    assert_eq!((*name, file.topology().face_count()), ("triangle", 1));
    assert!(failure.unknowns.iter().all(|n| ["0", "1", "-1"].contains(&n.as_str())));
    let said: Vec<String> = reports
        .iter()
        .map(|r| format!("{}: {}", r.verdict().name(), r.failures().join("; ")))
        .collect();
    // Lines of this file move.
    let said = said.join("\n");
    let mut parts = said.split("claims.rs:");
    let first = parts.next().unwrap_or_default().to_string();
    let said = parts.fold(first, |text, part| {
        text + "claims.rs" + part.trim_start_matches(|c: char| c.is_ascii_digit())
    });
    insta::assert_snapshot!(said);
}

#[test]
fn edges_of_length_zero_have_no_place_among_directions() {
    // Found by a campaign on `minkowski`: in the order of directions 0 was equal to everything, so that
    // a polygon that was called convex was none, and H² - K = -1/25.
    let minkowski = isogeo::claim::claim("minkowski").expect("a claim");
    let unknowns = [0, -1, -1, 0, -1, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0].map(Rational::from_i64);
    let instance = isogeo::claim::Instance::given(minkowski, 1, 3, unknowns.into());
    assert_eq!(instance.expect("evidence").run(|_| ()), Ok(()));
    let nothing = isogeo::claim::Instance::given(minkowski, 1, 1, Vec::new());
    assert!(matches!(
        nothing.expect("evidence").run(|_| ()),
        Err(isogeo::claim::Stop::Excluded(_))
    ));
}
