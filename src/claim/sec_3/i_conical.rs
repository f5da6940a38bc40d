//! Sec. 3.2, Theorem 2: i-conical meshes, their duals and parallel circumscribed meshes.

use super::instance::{
    CORNERS, all_different, free_top_view, gradient_incircle, incircle, mesh_of, net, on_circle,
    pyramid,
};
use super::{
    Claim, Control, Counterexample, Evidence, Experiment, Grade, Hypothesis, Identity, Run, Source,
    Stop, Trial,
};
use crate::check::Residual;
use crate::construct::{NoDual, circumscribed_f_parallel, metric_dual, translational_net};
use crate::mesh::{Mesh, NoPlane, VertexId};
use crate::net::i_conical::Balance;
use crate::scalar::{Field, Rational, RationalField, Ring};
use crate::space::{Dual, Gradient, ParabolicSphere};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "thm-2-dual",
        statement: "The metric dual of an i-conical mesh is i-circular and that of an i-circular mesh \
                    i-conical: the gradients of the faces around an element of M are the top views of \
                    the corners of its dual, and conversely. The dual of the dual is the mesh.",
        formula: "",
        source: Source::Paper("Sec. 3.2, Theorem 2"),
        hypotheses: &[Hypothesis::silent(NOT_VERTICAL), Hypothesis::silent(NOT_COLLINEAR)],
        said: Grade::Certified,
        argument: "A pyramid, here up to an i-motion, has an interior vertex of valence 4 and a face of 4 \
                   corners, and so has its dual; duality is local, so the same holds at every vertex and face of any mesh, and \
                   for more corners three and each other one are compared.",
        evidence: &[
            Evidence::identity::<DualPyramid>("a pyramid, twice", &[1], &[1]),
            Evidence::experiment::<DualNet>("nets", &[3, 4]),
        ],
        controls: &[
            Control {
                without: NOT_VERTICAL,
                shows: "the pole of a vertical face is at infinity",
                counterexample: Counterexample::Witness(vertical_face),
            },
            Control {
                without: NOT_COLLINEAR,
                shows: "the dual of a cylinder over a parabola has collinear faces, and no dual",
                counterexample: Counterexample::Witness(cylinder),
            },
        ],
    },
    Claim {
        id: "thm-2-f",
        statement: "An i-conical mesh has a circumscribed mesh with parallel face planes and edges: its \
                    planes are z = p·x - |p|²/2, and those around a vertex meet in one point.",
        formula: "",
        source: Source::Paper("Sec. 3.2, Theorem 2"),
        hypotheses: &[Hypothesis::stated(CONICAL), Hypothesis::silent(NOT_COLLINEAR)],
        said: Grade::Certified,
        argument: "Each vertex is placed by the planes around it alone, and up to an i-motion a pyramid has \
                   those of any vertex of valence 4 at its apex. Edges between faces that are not coplanar lie in two \
                   planes, which are parallel to those of M.",
        evidence: &[
            Evidence::identity::<CircumscribedPyramid>("a pyramid", &[1], &[1]),
            Evidence::experiment::<CircumscribedNet>("duals of i-circular nets", &[3]),
        ],
        controls: &[
            Control {
                without: CONICAL,
                shows: "gradients on no circle: the four planes have no common point",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &["1", "2", "1", "1", "2", "-2", "1/2", "1", "0"],
                    constrained: &["-1", "-1"],
                },
            },
            Control {
                without: NOT_COLLINEAR,
                shows: "collinear gradients: the planes are parallel to that of a vertical cylinder",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &["1", "2", "1", "1", "2", "-2", "5", "1", "0"],
                    constrained: &["-1", "4"],
                },
            },
        ],
    },
];

const NOT_VERTICAL: &str = "no face of M is vertical";
const NOT_COLLINEAR: &str = "around every vertex are three gradients that are not collinear";
const CONICAL: &str = "the gradients around every vertex are concyclic";

/// Gradients of the sides of a pyramid: any, or concyclic ones.
fn sides<T: Field>(
    trial: &mut Trial<T>,
    hypothesis: Option<&'static str>,
) -> Result<[Gradient<T>; 4], Stop> {
    let [a, b, c] = [(); 3].map(|()| free_top_view(trial));
    trial.nonzero(NOT_COLLINEAR, &(&b - &a).det(&(&c - &a)))?;
    let d = match hypothesis {
        Some(hypothesis) => on_circle(trial, hypothesis, [&a, &b, &c])?,
        None => free_top_view(trial),
    };
    for [x, y, z] in [[&a, &b, &d], [&b, &c, &d], [&c, &a, &d]] {
        trial.nonzero(NOT_COLLINEAR, &(y - x).det(&(z - x)))?;
    }
    let xs = [&a.x, &b.x, &c.x, &d.x, &T::zero()];
    all_different(trial, "the gradients differ in x", &xs)?;
    Ok([a, b, c, d].map(|x| x.dual()))
}

/// The gradients of all faces, where every face has one.
fn gradients<T: Field>(mesh: &Mesh<T>, hypothesis: &'static str) -> Result<Vec<Gradient<T>>, Stop> {
    let plane = |face| match mesh.face_plane(face) {
        Ok(plane) => Ok(plane.gradient),
        Err(NoPlane::NotAGraph(_)) => Err(Stop::Excluded(hypothesis)),
        Err(error) => Err(Stop::Failed(format!("{error:?}").into())),
    };
    mesh.topology.faces().map(plane).collect()
}

/// The numbers of the faces around a vertex.
pub(super) fn around<T>(mesh: &Mesh<T>, v: VertexId) -> Vec<usize> {
    mesh.topology.star(v).map(|h| mesh.topology.face_at(h).index()).collect()
}

struct DualPyramid;

impl Identity for DualPyramid {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (height, p) = (trial.free(), sides(trial, None)?);
        let m = pyramid(trial, &height, &p)?;
        let dual = trial.accepted("the dual", metric_dual(&m))?;
        let dual = trial.made_mesh(dual);
        let own = gradients(&m, NOT_VERTICAL)?;
        let other = gradients(&dual, NOT_COLLINEAR)?;
        for (p, pole) in own.iter().zip(&dual.points) {
            trial.equal("top view of a pole", &p.x, &pole.x);
            trial.equal("top view of a pole", &p.y, &pole.y);
        }
        for (x, p) in m.points.iter().zip(&other) {
            trial.equal("gradient of a dual face", &x.x, &p.x);
            trial.equal("gradient of a dual face", &x.y, &p.y);
        }
        // The apex and its dual face; the base and its dual vertex.
        let [a, b, c, d] = [0, 1, 2, 3].map(|j| dual.points[j].top_view());
        let circle = incircle([&a, &b, &c, &d]);
        trial.equal("dual face", &circle, &gradient_incircle([&own[0], &own[1], &own[2], &own[3]]));
        let [a, b, c, d] = [1, 2, 3, 4].map(|j| m.points[j].top_view());
        let circle = incircle([&a, &b, &c, &d]);
        let conical = gradient_incircle([&other[1], &other[2], &other[3], &other[4]]);
        trial.equal("dual vertex", &circle, &conical);
        let twice = trial.accepted("the dual of the dual", metric_dual(&dual))?;
        for (x, y) in m.points.iter().zip(&twice.points) {
            trial.equal_points("the dual of the dual", x, y);
        }
        trial.exhibit("M", &m);
        trial.exhibit("M*", &dual);
        Ok(())
    }
}

/// The dual of an i-circular net, with the gradients of its faces.
pub(super) fn dual_net<T: RationalField>(
    trial: &mut Trial<T>,
    hypothesis: &'static str,
) -> Result<(Mesh<T>, Vec<Gradient<T>>), Stop> {
    let m = net(trial)?;
    let dual = match metric_dual(&m) {
        Err(NoDual::NoPole(_)) => return Err(Stop::Excluded(CORNERS)),
        dual => trial.accepted("the dual", dual)?,
    };
    let gradients = gradients(&dual, hypothesis)?;
    Ok((dual, gradients))
}

struct DualNet;

impl Experiment for DualNet {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        let (dual, p) = dual_net(trial, NOT_COLLINEAR)?;
        for v in dual.topology.interior_vertices() {
            let p: Vec<_> = around(&dual, v).into_iter().map(|f| &p[f]).collect();
            if let [a, b, c, d] = p.as_slice() {
                trial.zero("i-conical", gradient_incircle([a, b, c, d]));
            }
            let ends: Vec<_> = dual.topology.star(v).map(|h| dual.topology.target(h)).collect();
            if let [a, b, c, d] = ends.as_slice() {
                let at = [v, *a, *b, *c, *d].map(|v| dual.points[v.index()].clone());
                trial.zero("balanced", Balance.eval(&at, &T::one()));
            }
        }
        trial.exhibit("M*", &dual);
        Ok(())
    }
}

fn vertical_face() -> Result<String, String> {
    let m = mesh_of(&[[0, 0, 0], [1, 1, 0], [1, 1, 1], [0, 0, 1]], &[&[0, 1, 2, 3]])?;
    metric_dual(&m).map_or_else(|error| Ok(error.to_string()), |_| Err("it has a dual".into()))
}

fn cylinder() -> Result<String, String> {
    let q = Rational::from_i64;
    let curve: Vec<_> = (0..5).map(|i| (q(i), q(i * i))).collect();
    let line: Vec<_> = (0..5).map(|i| (q(i), q(i))).collect();
    let m = translational_net(&curve, &line).map_err(|error| error.to_string())?;
    let dual = metric_dual(&m).map_err(|error| error.to_string())?;
    metric_dual(&dual).map_or_else(|error| Ok(error.to_string()), |_| Err("it has a dual".into()))
}

struct CircumscribedPyramid;

impl Identity for CircumscribedPyramid {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (height, p) = (trial.free(), sides(trial, Some(CONICAL))?);
        let m = pyramid(trial, &height, &p)?;
        let image = trial.accepted("circumscribed and f-parallel", circumscribed_f_parallel(&m))?;
        trial.accepted("with parallel edges", image.pair.parallel())?;
        trial.zero("nothing is free", T::from_i64(image.free.len() as i64));
        let s = trial.made_mesh(image.pair.image().clone());
        for face in m.topology.faces() {
            let plane = ParabolicSphere::unit().tangent_plane(&image.pair.gradient(face).dual());
            for v in m.topology.face(face) {
                trial.zero("in the plane that touches Σ", plane.residual(&s.points[v.index()]));
            }
        }
        trial.exhibit("M", &m);
        trial.exhibit("S", &s);
        Ok(())
    }
}

struct CircumscribedNet;

impl Experiment for CircumscribedNet {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        let (m, _) = dual_net(trial, NOT_COLLINEAR)?;
        let image = match circumscribed_f_parallel(&m) {
            Err(error) if error.is_undefined() => return Err(Stop::Excluded(NOT_COLLINEAR)),
            image => trial.accepted("circumscribed and f-parallel", image)?,
        };
        let s = image.pair.image();
        for face in m.topology.faces() {
            let plane = ParabolicSphere::unit().tangent_plane(&image.pair.gradient(face).dual());
            for v in m.topology.face(face) {
                trial.zero("in the plane that touches Σ", plane.residual(&s.points[v.index()]));
            }
        }
        trial.exhibit("M", &m);
        Ok(())
    }
}
