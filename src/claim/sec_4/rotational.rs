//! Sec. 4: rotational meshes with constant curvatures.

use super::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Stop, Trial,
};
use crate::construct::hexagonal::HexagonalRings;
use crate::construct::minimal::MeshPair;
use crate::construct::rotational::{
    RingRadii, constant_mean_rings, negative_curvature_rings, positive_curvature_rings,
    rotational_pair,
};
use crate::pair::{FParallel, FaceForms, twice_area};
use crate::scalar::Field;
use crate::space::Rotation;

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "hex-rotational",
        statement: "Rotational meshes of hexagons have first integrals: with the steps δ, δ' of the offsets of \
                    face planes in M and S from ring to ring, H = 0, H constant or K constant at all faces says \
                    that one number C is the same for all steps.",
        formula: "H = 0: δδ' = C AB,  H constant: δδ' - Hδ² = C AB,  K constant: δ² - δ'²/K = C AB",
        source: Source::Paper("Sec. 4, Fig. 10"),
        hypotheses: &[
            Hypothesis::silent(RINGS),
            Hypothesis::silent(STEPS),
            Hypothesis::silent(ONE_INTEGRAL),
        ],
        said: Grade::Certified,
        argument: "The areas of a face are differences of one expression at its two steps, which is decided for \
                   any steps; so the curvature asked for is constant on rings iff C is. Faces of a ring \
                   are turned copies. With K = k² the steps are parametrised rationally; where S is \
                   prescribed, as circumscribed to Σ, the same equation asks for roots.",
        evidence: &[
            Evidence::identity::<Areas>("areas and mixed areas of any steps", &[1], &[1, 2]),
            Evidence::identity::<Minimal>("H = 0 with any image", &[1], &[1, 2, 3]),
            Evidence::identity::<Mean>("H constant", &[1], &[1, 2, 3]),
            Evidence::identity::<Gauss>("K = k² constant", &[1], &[1, 2, 3]),
        ],
        controls: &[
            Control {
                without: RINGS,
                shows: "two rings with A = 0",
                counterexample: Counterexample::Unknowns {
                    evidence: 1,
                    size: 1,
                    unknowns: &["1/2", "1", "3/5", "3"],
                    constrained: &[],
                },
            },
            Control {
                without: STEPS,
                shows: "rings of S in one plane cannot be those of an M with C != 0",
                counterexample: Counterexample::Unknowns {
                    evidence: 1,
                    size: 1,
                    unknowns: &["1/3", "1", "2", "4", "0", "1", "1"],
                    constrained: &[],
                },
            },
            Control {
                without: ONE_INTEGRAL,
                shows: "another C in the second step",
                counterexample: Counterexample::Unknowns {
                    evidence: 1,
                    size: 1,
                    unknowns: &["1/3", "1", "2", "4", "1", "2", "1"],
                    constrained: &["3"],
                },
            },
        ],
    },
    Claim {
        id: "quad-rotational",
        statement: "Rotational meshes of quads have first integrals in the radii r, r' of rings of M and S, \
                    with any sector.",
        formula: "H constant: rr' - Hr² = C,  K constant: r² - r'²/K = C",
        source: Source::Ours,
        hypotheses: &[Hypothesis::stated(SECTOR), Hypothesis::stated(RADII)],
        said: Grade::Certified,
        argument: "A face belongs to two consecutive rings; area and mixed area are differences of r² and rr' there.",
        evidence: &[
            Evidence::identity::<QuadMean>("H constant", &[1], &[1, 2, 3]),
            Evidence::identity::<QuadPositive>("K = k²", &[1], &[1, 2, 3]),
            Evidence::identity::<QuadNegative>("K = -k²", &[1], &[1, 2, 3]),
        ],
        controls: &[
            Control {
                without: SECTOR,
                shows: "sectors without a width",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &["0", "1", "1", "1", "2"],
                    constrained: &[],
                },
            },
            Control {
                without: RADII,
                shows: "a ring of M that is a point has no image with C != 0",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &["1/2", "1", "1", "0", "2"],
                    constrained: &[],
                },
            },
        ],
    },
];

const RINGS: &str = "A and B are not 0 between consecutive rings";
const STEPS: &str = "the steps that are divided by are not 0";
const ONE_INTEGRAL: &str = "C is the same for all steps";
const SECTOR: &str = "the sine of a sector is not 0";
const RADII: &str = "the radii and parameters that are divided by are not 0";

/// Half a sector from its parameter.
fn rotation<T: Field>(trial: &mut Trial<T>, says: &'static str) -> Result<Rotation<T>, Stop> {
    let t = trial.free();
    trial.nonzero(says, &t)?;
    trial.parameter("1 + t² is not 0", &(T::one() + t.square()))?;
    trial.defined(says, Rotation::from_parameter(&t).ok())
}

/// Rings of hexagons with free slopes.
fn rings<T: Field>(trial: &mut Trial<T>) -> Result<(HexagonalRings<T>, Rotation<T>), Stop> {
    let half = rotation(trial, RINGS)?;
    let slopes: Vec<T> = (0..trial.size() + 2).map(|_| trial.free()).collect();
    for pair in slopes.windows(2) {
        trial.nonzero(RINGS, &(&pair[1] - half.cos() * &pair[0]))?;
        trial.nonzero(RINGS, &(half.cos() * &pair[1] - &pair[0]))?;
    }
    let rings = trial.defined(RINGS, HexagonalRings::new(half.clone(), slopes).ok())?;
    Ok((rings, half))
}

fn steps<T: Field>(trial: &mut Trial<T>) -> Result<Vec<T>, Stop> {
    let steps: Vec<T> = (0..trial.size() + 1).map(|_| trial.free()).collect();
    for step in &steps {
        trial.nonzero(STEPS, step)?;
    }
    Ok(steps)
}

/// The forms of the faces of a pair of meshes.
fn forms<T: Field>(trial: &mut Trial<T>, pair: &MeshPair<T>) -> Result<Vec<FaceForms<T>>, Stop> {
    let gauss = trial.made_mesh(pair.gauss.clone());
    trial.exhibit("M", &pair.surface);
    trial.exhibit("S", &gauss);
    for face in pair.surface.topology.faces() {
        let corners = pair.surface.topology.face(face).iter().take(3);
        let views: Vec<_> = corners.map(|v| pair.surface.points[v.index()].top_view()).collect();
        trial.parameter("the first corners of a face are not on a line", &twice_area(&views))?;
    }
    let f_pair = trial.accepted("f-parallel", FParallel::new(&pair.surface, &gauss))?;
    Ok(pair.surface.topology.faces().map(|face| f_pair.face_forms(face)).collect())
}

struct Areas;

impl Identity for Areas {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (rings, half) = rings(trial)?;
        let (mesh, image) = (steps(trial)?, steps(trial)?);
        let pair = trial.accepted("a pair", rings.pair(&mesh, &image, 1))?;
        let forms = forms(trial, &pair)?;
        // area = s (P δ²) between two steps, with P = 1/AB.
        let over = |n: usize, value: T| {
            value.try_div(&rings.products()[n]).map(|quotient| quotient * half.sin())
        };
        let mut between = |n: usize, f: &dyn Fn(usize) -> T| {
            let (after, before) = (over(n + 1, f(n + 1)), over(n, f(n)));
            Ok::<T, Stop>(trial.defined(RINGS, after)? - trial.defined(RINGS, before)?)
        };
        let mut expected = Vec::new();
        for n in 0..forms.len() {
            expected.push([
                between(n, &|n| mesh[n].square())?,
                between(n, &|n| &mesh[n] * &image[n])?,
                between(n, &|n| image[n].square())?,
            ]);
        }
        for (forms, [area, mixed, second]) in forms.iter().zip(&expected) {
            trial.equal("area(F)", &forms.area(), area);
            trial.equal("area(F, S)", &forms.mixed_area(), mixed);
            trial.equal("area(S)", &forms.image_area(), second);
        }
        Ok(())
    }
}

/// The steps of a rule, in which each C but the first is one that has to be the same as that.
fn with_integrals<T: Field>(
    trial: &mut Trial<T>,
    rule: impl Fn(&T) -> Option<Vec<T>>,
) -> Result<Vec<T>, Stop> {
    let first = trial.free();
    let mut found = trial.defined(STEPS, rule(&first))?;
    // One more C: a relation of its own is decided with one unknown.
    let other = trial.constrained(first.clone());
    trial.relation(ONE_INTEGRAL, &other - &first)?;
    let steps = trial.defined(STEPS, rule(&other))?;
    for (step, other) in found.iter_mut().zip(steps).skip(1) {
        *step = other;
    }
    for step in &found {
        trial.parameter("C is not 0 and no step of M", step)?;
    }
    Ok(found)
}

struct Minimal;

impl Identity for Minimal {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (rings, _) = rings(trial)?;
        let image = steps(trial)?;
        let mesh = with_integrals(trial, |c| rings.minimal(&image, c))?;
        let pair = trial.accepted("a pair", rings.pair(&mesh, &image, 1))?;
        for forms in forms(trial, &pair)? {
            trial.zero("area(F, S)", forms.mixed_area());
        }
        Ok(())
    }
}

struct Mean;

impl Identity for Mean {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (rings, _) = rings(trial)?;
        let mesh = steps(trial)?;
        let mean = trial.free();
        trial.show("H", &mean);
        let image = with_integrals(trial, |c| rings.constant_mean(&mesh, &mean, c))?;
        let pair = trial.accepted("a pair", rings.pair(&mesh, &image, 1))?;
        for forms in forms(trial, &pair)? {
            trial.equal("area(F, S) = H area(F)", &forms.mixed_area(), &(forms.area() * &mean));
        }
        Ok(())
    }
}

struct Gauss;

impl Identity for Gauss {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (rings, _) = rings(trial)?;
        let factors = steps(trial)?;
        let (root, integral) = (trial.free(), trial.free());
        trial.show("k", &root);
        let found = rings.constant_gauss(&factors, &root, &integral);
        let (mesh, image) = trial.defined(STEPS, found)?;
        for step in mesh.iter().chain(&image) {
            trial.parameter("C is not 0 and no step of M", step)?;
        }
        let pair = trial.accepted("a pair", rings.pair(&mesh, &image, 1))?;
        for forms in forms(trial, &pair)? {
            trial.equal(
                "area(S) = k² area(F)",
                &forms.image_area(),
                &(forms.area() * root.square()),
            );
        }
        Ok(())
    }
}

/// A pair from rings, and its forms.
fn quads<T: Field>(
    trial: &mut Trial<T>,
    rings: &[RingRadii<T>],
    sector: &Rotation<T>,
) -> Result<Vec<FaceForms<T>>, Stop> {
    for pair in rings.windows(2) {
        let [inner, outer] = [&pair[0].radius, &pair[1].radius];
        trial.parameter("rings that follow each other differ", &(outer - inner))?;
        trial.parameter("no ring of M is a point", outer)?;
        trial.parameter("no ring of M is a point", inner)?;
    }
    let pair = trial.defined(SECTOR, rotational_pair(rings, sector, 1).ok())?;
    forms(trial, &pair)
}

struct QuadMean;

impl Identity for QuadMean {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let sector = rotation(trial, SECTOR)?;
        let (mean, integral) = (trial.free(), trial.free());
        let radii: Vec<T> = (0..=trial.size()).map(|_| trial.free()).collect();
        for radius in &radii {
            trial.nonzero(RADII, radius)?;
        }
        let rings = trial.defined(RADII, constant_mean_rings(&radii, &mean, &integral))?;
        for RingRadii { radius, image } in &rings {
            trial.equal("rr' - Hr²", &(radius * image - &mean * radius.square()), &integral);
        }
        for forms in quads(trial, &rings, &sector)? {
            trial.equal("area(F, S) = H area(F)", &forms.mixed_area(), &(forms.area() * &mean));
        }
        Ok(())
    }
}

struct QuadPositive;

impl Identity for QuadPositive {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let sector = rotation(trial, SECTOR)?;
        let (root, integral) = (trial.free(), trial.free());
        trial.nonzero(RADII, &root)?;
        let parameters: Vec<T> = (0..=trial.size()).map(|_| trial.free()).collect();
        for parameter in &parameters {
            trial.nonzero(RADII, parameter)?;
        }
        let found = positive_curvature_rings(&parameters, &root, &integral);
        let rings = trial.defined(RADII, found)?;
        for RingRadii { radius, image } in &rings {
            let value = root.square() * radius.square() - image.square();
            trial.equal("k² r² - r'²", &value, &integral);
        }
        for forms in quads(trial, &rings, &sector)? {
            trial.equal(
                "area(S) = k² area(F)",
                &forms.image_area(),
                &(forms.area() * root.square()),
            );
        }
        Ok(())
    }
}

struct QuadNegative;

impl Identity for QuadNegative {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let sector = rotation(trial, SECTOR)?;
        let (root, amplitude) = (trial.free(), trial.free());
        trial.nonzero(RADII, &root)?;
        let parameters: Vec<T> = (0..=trial.size()).map(|_| trial.free()).collect();
        for parameter in &parameters {
            trial.parameter("1 + u² is not 0", &(T::one() + parameter.square()))?;
        }
        let found = negative_curvature_rings(&parameters, &root, &amplitude);
        let rings = trial.defined(RADII, found)?;
        for RingRadii { radius, image } in &rings {
            let value = root.square() * radius.square() + image.square();
            trial.equal("k² r² + r'²", &value, &amplitude.square());
        }
        for forms in quads(trial, &rings, &sector)? {
            let expected = -(forms.area() * root.square());
            trial.equal("area(S) = -k² area(F)", &forms.image_area(), &expected);
        }
        Ok(())
    }
}
