//! Sec. 4, curvatures at faces: mixed areas, offsets.

use super::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Trial,
};
use crate::pair::{Curvatures, Forms, OffsetResiduals, four_mixed_areas, twice_area};
use crate::scalar::{Field, Ring};
use crate::space::{TopView, Vector2};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-15-16-form",
        statement: "The mixed area of polygons with k corners is the polar form of the area: symmetric, \
                    linear in each polygon, unchanged by translations.",
        formula: "area(F + dS) = area(F) + 2d area(F, S) + d² area(S)",
        source: Source::Paper("Sec. 4, (15), (16)"),
        hypotheses: &[],
        said: Grade::Certified,
        argument: "For all k: both sides are sums over the edges, and the difference of two consecutive k \
                   is the identity for a triangle.",
        evidence: &[Evidence::identity::<PolarForm>(
            "the law of offsets, symmetry, linearity, translations",
            &[3, 4, 5, 6, 7, 8],
            &[3, 4, 5, 8],
        )],
        controls: &[],
    },
    Claim {
        id: "eq-17-18",
        statement: "The curvatures of the face F + dS, seen with the same S, follow from those of F.",
        formula: "K(Fᵈ) = K / (1 + 2dH + d²K),  H(Fᵈ) = (H + dK) / (1 + 2dH + d²K)",
        source: Source::Paper("Sec. 4, (17), (18)"),
        hypotheses: &[Hypothesis::silent(AREA), Hypothesis::silent(OFFSET_AREA)],
        said: Grade::Certified,
        argument: "For all k: (18) follows from eq-15-16-form, since only the three areas enter.",
        evidence: &[Evidence::identity::<OffsetCurvatures>(
            "(15)-(18) on the corners of F + dS",
            &[3, 4, 5, 6, 7, 8],
            &[3, 4, 5, 8],
        )],
        controls: &[
            Control {
                without: AREA,
                shows: "a bow-tie of area 0 has no curvatures",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 4,
                    unknowns: &[
                        "0", "0", "1", "1", "1", "0", "0", "1", "0", "0", "1", "0", "1", "1", "0",
                        "1", "1",
                    ],
                    constrained: &[],
                },
            },
            Control {
                without: OFFSET_AREA,
                shows: "the triangle F = S at d = -1 shrinks to a point",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 3,
                    unknowns: &["0", "0", "1", "0", "0", "1", "0", "0", "1", "0", "0", "1", "-1"],
                    constrained: &[],
                },
            },
        ],
    },
    Claim {
        id: "cmc-offset",
        statement: "A mesh of constant mean curvature H has an offset of constant mean curvature -H.",
        formula: "d = -1/H:  H(Fᵈ) = -H",
        source: Source::Paper("Sec. 4, after (18)"),
        hypotheses: &[Hypothesis::stated(MEAN), Hypothesis::silent(NOT_UMBILIC)],
        said: Grade::Certified,
        argument: "Face by face, since d is the same for all faces; (18) holds by eq-17-18.",
        evidence: &[Evidence::identity::<OppositeMean>("H of the offset at d = -1/H", &[1], &[1])],
        controls: &[
            Control {
                without: MEAN,
                shows: "where H = 0 there is no such distance",
                counterexample: unknowns(1, &["0", "-1"]),
            },
            Control {
                without: NOT_UMBILIC,
                shows: "S as its own Gauss image, H = K = 1: the offset at d = -1 is a point",
                counterexample: unknowns(1, &["1", "1"]),
            },
        ],
    },
    Claim {
        id: "cgc-offset",
        statement: "A mesh of constant mean curvature H has an offset of constant curvature 4H².",
        formula: "d = -1/(2H):  K(Fᵈ) = 4H²",
        source: Source::Paper("Sec. 4, after (18)"),
        hypotheses: &[Hypothesis::stated(MEAN), Hypothesis::silent(CURVED)],
        said: Grade::Certified,
        argument: "Face by face, since d is the same for all faces; (18) holds by eq-17-18.",
        evidence: &[Evidence::identity::<ConstantGauss>(
            "K of the offset at d = -1/(2H)",
            &[1],
            &[1],
        )],
        controls: &[
            Control {
                without: MEAN,
                shows: "where H = 0 there is no such distance",
                counterexample: unknowns(1, &["0", "-1"]),
            },
            Control {
                without: CURVED,
                shows: "a face with H = 1, K = 0: the area of the offset face vanishes",
                counterexample: unknowns(1, &["1", "0"]),
            },
        ],
    },
];

pub(super) const AREA: &str = "area(F) != 0";
const OFFSET_AREA: &str = "1 + 2dH + d²K != 0, that is, area(F + dS) != 0";
const MEAN: &str = "H != 0";
const CURVED: &str = "K != 0";
const NOT_UMBILIC: &str = "K != H²";

const fn unknowns(size: usize, unknowns: &'static [&'static str]) -> Counterexample {
    Counterexample::Unknowns { evidence: 0, size, unknowns, constrained: &[] }
}

fn polygon<T: Field>(trial: &mut Trial<T>) -> Vec<TopView<T>> {
    (0..trial.size()).map(|_| TopView::new(trial.free(), trial.free())).collect()
}

fn moved<T: Ring>(f: &[TopView<T>], by: impl Fn(usize) -> Vector2<T>) -> Vec<TopView<T>> {
    f.iter().enumerate().map(|(n, corner)| corner + &by(n)).collect()
}

struct PolarForm;

impl Identity for PolarForm {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (f, s, r) = (polygon(trial), polygon(trial), polygon(trial));
        let (d, t) = (trial.free(), trial.free_vector2());
        let offset = moved(&f, |n| s[n].position().scaled(&d));
        let expected = T::from_i64(2) * twice_area(&f)
            + T::from_i64(2) * &d * four_mixed_areas(&f, &s)
            + T::from_i64(2) * d.square() * twice_area(&s);
        trial.equal("4 area(F + dS)", &(T::from_i64(2) * twice_area(&offset)), &expected);
        let mixed = four_mixed_areas(&f, &s);
        trial.equal("symmetric", &mixed, &four_mixed_areas(&s, &f));
        let linear = &mixed + &d * four_mixed_areas(&r, &s);
        let sum = moved(&f, |n| r[n].position().scaled(&d));
        trial.equal("linear", &four_mixed_areas(&sum, &s), &linear);
        trial.equal("translated", &four_mixed_areas(&moved(&f, |_| t.clone()), &s), &mixed);
        Ok(())
    }
}

struct OffsetCurvatures;

impl Identity for OffsetCurvatures {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (f, s) = (polygon(trial), polygon(trial));
        let d = trial.free();
        let forms = Forms::of(&f, &s);
        trial.nonzero(AREA, &forms.first)?;
        let Curvatures { mean, gauss } = trial.defined(AREA, forms.at_face())?;
        trial.show("H", &mean);
        trial.show("K", &gauss);
        trial.nonzero(OFFSET_AREA, &forms.offset(&d).first)?;
        let residuals = trial.defined(OFFSET_AREA, OffsetResiduals::of(&f, &s, &d))?;
        trial.zero("area", residuals.area);
        trial.zero("H", residuals.mean);
        trial.zero("K", residuals.gauss);
        Ok(())
    }
}

fn curvatures<T: Field>(trial: &mut Trial<T>) -> Curvatures<T> {
    Curvatures { mean: trial.free(), gauss: trial.free() }
}

struct OppositeMean;

impl Identity for OppositeMean {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let face = curvatures(trial);
        trial.nonzero(MEAN, &face.mean)?;
        trial.nonzero(NOT_UMBILIC, &face.discriminant())?;
        let d = trial.defined(MEAN, face.distance_to_opposite_mean())?;
        let d = trial.made(d);
        let offset = trial.defined(NOT_UMBILIC, face.offset(&d))?;
        trial.show("H", &face.mean);
        trial.show("K", &face.gauss);
        trial.show("d", &d);
        trial.zero("H(Fᵈ) + H", offset.mean + &face.mean);
        Ok(())
    }
}

struct ConstantGauss;

impl Identity for ConstantGauss {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let face = curvatures(trial);
        trial.nonzero(MEAN, &face.mean)?;
        trial.nonzero(CURVED, &face.gauss)?;
        let d = trial.defined(MEAN, face.distance_to_constant_gauss())?;
        let d = trial.made(d);
        let offset = trial.defined(CURVED, face.offset(&d))?;
        trial.show("H", &face.mean);
        trial.show("K", &face.gauss);
        trial.show("d", &d);
        trial.equal("K(Fᵈ) = 4H²", &offset.gauss, &(T::from_i64(4) * face.mean.square()));
        Ok(())
    }
}
