//! Sec. 4: weights of edges at vertices, and offsets in the vertical sense.

use super::stars::{IMAGE_MEASURE, NOT_VERTICAL, at_heights, dual_stars, triangles};
use super::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Trial,
};
use crate::mesh::{Mesh, VertexId};
use crate::pair::{Ray, VParallel, star_forms};
use crate::scalar::Field;
use crate::space::Vector2;

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "vertex-stress",
        statement: "The weights of the edges at a vertex of a v-parallel pair (jump of the gradient over \
                    length) are in equilibrium; the mixed measure is the Laplacian of the heights of one \
                    mesh with the weights of the other; and the weights are the derivatives of the measure \
                    by the heights.",
        formula: "Σ w_j e_j = 0,  2 D(v, s) = Σ w_j(f) (g_j - g_v) = Σ w_j(g) (f_j - f_v),  ∂D(v)/∂f_j = w_j",
        source: Source::Ours,
        hypotheses: &[Hypothesis::stated(NOT_VERTICAL)],
        said: Grade::Certified,
        argument: "For all k as in eq-22-cotan; the measure is quadratic in the heights, so that its central \
                   difference is its derivative at any step.",
        evidence: &[
            Evidence::identity::<Stress>("any two v-parallel stars", &[3, 4], &[3, 4, 5, 6, 8]),
            Evidence::identity::<DualStress>("two stars given by gradients", K_GONS, &[3, 4, 5, 8]),
        ],
        controls: &[Control {
            without: NOT_VERTICAL,
            shows: "a triangle over a segment",
            counterexample: Counterexample::Unknowns {
                evidence: 0,
                size: 3,
                unknowns: &["0", "0", "0", "1", "0", "0", "2", "0", "1", "0", "1", "0"],
                constrained: &[],
            },
        }],
    },
    Claim {
        id: "v-offset",
        statement: "Moving the vertices of M by d times the heights of a v-parallel S changes the curvatures \
                    at vertices polynomially: the dual of (18).",
        formula: "H(v^d) = H + d,  K(v^d) = K + 2dH + d²",
        source: Source::Ours,
        hypotheses: &[Hypothesis::stated(NOT_VERTICAL), Hypothesis::stated(IMAGE_MEASURE)],
        said: Grade::Certified,
        argument: "For all k: gradients are linear in the heights, and by eq-15-16-form the measures of the sum \
                   are D(v) + 2d D(v, s) + d² D(s).",
        evidence: &[
            Evidence::identity::<VOffset>("any two v-parallel stars", &[3, 4], &[3, 4, 5, 6, 8]),
            Evidence::identity::<DualVOffset>(
                "two stars given by gradients",
                K_GONS,
                &[3, 4, 5, 8],
            ),
        ],
        controls: &[
            Control {
                without: NOT_VERTICAL,
                shows: "a triangle over a segment",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 3,
                    unknowns: &["0", "0", "0", "1", "0", "0", "2", "0", "1", "0", "1", "0"],
                    constrained: &[],
                },
            },
            Control {
                without: IMAGE_MEASURE,
                shows: "over a plane there are no curvatures",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 3,
                    unknowns: &["0", "0", "0", "1", "0", "0", "0", "1", "1", "-1", "-1", "1"],
                    constrained: &[],
                },
            },
        ],
    },
];

const K_GONS: &[usize] = &[3, 4, 5, 6, 7, 8];

struct Stress;

impl Identity for Stress {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let mesh = triangles(trial)?;
        let other: Vec<T> = mesh.points.iter().map(|_| trial.free()).collect();
        let image = at_heights(&mesh, |n| other[n].clone());
        stress(trial, &mesh, &image)?;
        derivatives(trial, &mesh, &image)
    }
}

struct DualStress;

impl Identity for DualStress {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let [mesh, image] = dual_stars(trial)?;
        stress(trial, &mesh, &image)
    }
}

fn stress<T: Field>(trial: &mut Trial<T>, mesh: &Mesh<T>, image: &Mesh<T>) -> Run {
    let pair = trial.defined(NOT_VERTICAL, VParallel::new(mesh, image).ok())?;
    let v = VertexId(0);
    let forms = trial.accepted("interior", pair.vertex_forms(v))?;
    let twice = forms.mixed_measure() * T::from_i64(2);
    let load = trial.accepted("a star", pair.load(v))?;
    trial.equal("load", &load, &twice);
    let laplacian = trial.accepted("a star", pair.laplacian(v))?;
    trial.equal("Laplacian", &laplacian, &twice);
    let star = trial.accepted("a star", pair.star(v))?;
    for which in [0, 1] {
        let sum = star.iter().fold(Vector2::new(T::zero(), T::zero()), |sum, edge| {
            &sum + &edge.edge.scaled(&edge.weight[which])
        });
        trial.zero("equilibrium", sum.x);
        trial.zero("equilibrium", sum.y);
    }
    Ok(())
}

/// The forms without a division, and the derivatives of the measure.
fn derivatives<T: Field>(trial: &mut Trial<T>, mesh: &Mesh<T>, image: &Mesh<T>) -> Run {
    let pair = trial.defined(NOT_VERTICAL, VParallel::new(mesh, image).ok())?;
    let v = VertexId(0);
    let forms = trial.accepted("interior", pair.vertex_forms(v))?;
    let star = trial.accepted("a star", pair.star(v))?;
    let rays: Vec<_> =
        star.iter().map(|e| Ray { edge: e.edge.clone(), rise: e.rise.clone() }).collect();
    let (cleared, divisor) = trial.defined(NOT_VERTICAL, star_forms(&rays))?;
    trial.equal("4 D(v)", &cleared.first, &(&forms.four.first * &divisor));
    trial.equal("4 D(v, s)", &cleared.mixed, &(&forms.four.mixed * &divisor));
    trial.equal("4 D(s)", &cleared.second, &(&forms.four.second * &divisor));
    // Moving the vertex itself, and one neighbour.
    for (moved, weight) in trial.accepted("a star", pair.jacobian_row(v))?.into_iter().take(2) {
        let step = |by: &T| {
            at_heights(mesh, |n| {
                let z = mesh.points[n].z.clone();
                if n == moved.index() { z + by } else { z }
            })
        };
        let (up, down) = (step(&T::one()), step(&T::from_i64(-1)));
        let [up, down] = [&up, &down].map(|m| VParallel::new(m, image).ok());
        let up = trial.defined(NOT_VERTICAL, up)?.vertex_forms(v);
        let down = trial.defined(NOT_VERTICAL, down)?.vertex_forms(v);
        let (up, down) = (trial.accepted("interior", up)?, trial.accepted("interior", down)?);
        let difference = up.measure() - down.measure();
        trial.equal("derivative of D(v)", &difference, &(weight * T::from_i64(2)));
    }
    Ok(())
}

struct VOffset;

impl Identity for VOffset {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let mesh = triangles(trial)?;
        let other: Vec<T> = mesh.points.iter().map(|_| trial.free()).collect();
        let image = at_heights(&mesh, |n| other[n].clone());
        v_offset(trial, &mesh, &image)
    }
}

struct DualVOffset;

impl Identity for DualVOffset {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let [mesh, image] = dual_stars(trial)?;
        v_offset(trial, &mesh, &image)
    }
}

fn v_offset<T: Field>(trial: &mut Trial<T>, mesh: &Mesh<T>, image: &Mesh<T>) -> Run {
    let d = trial.free();
    let pair = trial.defined(NOT_VERTICAL, VParallel::new(mesh, image).ok())?;
    let v = VertexId(0);
    let forms = trial.accepted("interior", pair.vertex_forms(v))?;
    trial.nonzero(IMAGE_MEASURE, &forms.image_measure())?;
    let curvatures = trial.defined(IMAGE_MEASURE, pair.vertex_curvatures(v).ok())?;
    let offset = trial.made_mesh(pair.offset(&d));
    let moved = trial.accepted("v-parallel", VParallel::new(&offset, image))?;
    let found = trial.defined(IMAGE_MEASURE, moved.vertex_curvatures(v).ok())?;
    trial.show("H", &found.mean);
    trial.show("K", &found.gauss);
    let law = curvatures.v_offset(&d);
    trial.equal("H", &found.mean, &law.mean);
    trial.equal("K", &found.gauss, &law.gauss);
    trial.equal("H + d", &found.mean, &(&curvatures.mean + &d));
    let gauss = &curvatures.gauss + T::from_i64(2) * &d * &curvatures.mean + d.square();
    trial.equal("K + 2dH + d²", &found.gauss, &gauss);
    Ok(())
}
