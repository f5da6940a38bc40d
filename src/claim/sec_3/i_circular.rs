//! Sec. 3.2, Theorem 1: the i-circular meshes, by their lift and by parallel inscribed quads.

use std::array;

use super::instance::{concyclic, free_plane, mesh_of, net, one_face, over};
use super::{
    Claim, Control, Counterexample, Evidence, Experiment, Grade, Hypothesis, Identity, Run, Source,
    Trial,
};
use crate::check::Residual;
use crate::construct::{inscribed_v_parallel, lift};
use crate::mesh::{FaceList, Mesh};
use crate::net::i_circular::Concyclic;
use crate::net::planar::Coplanar;
use crate::net::scribed::OnSigma;
use crate::pair::Parallel;
use crate::scalar::{Field, Rational, RationalField, Ring};
use crate::space::{ParabolicSphere, Point, TopView, Vector3};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "thm-1-v",
        statement: "A planar mesh is i-circular iff its lift to Σ has planar faces: the in-circle \
                    determinant of four top views is, up to its sign, twice the determinant of the lifted \
                    points, six times their volume. Then the lift is the only inscribed v-parallel mesh.",
        formula: "in-circle determinant = -2 det(s₁ - s₀, s₂ - s₀, s₃ - s₀)",
        source: Source::Paper("Sec. 3.2, Theorem 1"),
        hypotheses: &[Hypothesis::stated(CIRCULAR), Hypothesis::silent(NOT_VERTICAL)],
        said: Grade::Certified,
        argument: "For all k: a face is planar, or concyclic, iff three of its corners and each other one \
                   are; the faces of a mesh are tested one by one. A point of Σ is determined by its \
                   top view, so the lift is unique.",
        evidence: &[
            Evidence::identity::<LiftedVolume>("the volume", &[4], &[4]),
            Evidence::identity::<LiftedFace>(
                "one face with k corners",
                &[4, 5, 6, 7, 8],
                &[4, 5, 6, 8],
            ),
            Evidence::experiment::<LiftedNet>("nets", &[2, 3]),
        ],
        controls: &[
            Control {
                without: CIRCULAR,
                shows: "the lift of a planar kite is not planar",
                counterexample: Counterexample::Unknowns {
                    evidence: 1,
                    size: 4,
                    unknowns: &["0", "0", "1", "0", "0", "1", "1", "2", "0", "1", "1"],
                    constrained: &["3", "3"],
                },
            },
            Control {
                without: NOT_VERTICAL,
                shows: "of a vertical face the lift has no plane with a gradient, either",
                counterexample: Counterexample::Witness(vertical_face),
            },
        ],
    },
    Claim {
        id: "thm-1-converse",
        statement: "A planar quad with edges parallel to those of a quad inscribed to Σ is i-circular.",
        formula: "",
        source: Source::Paper("Sec. 3.2, Theorem 1"),
        hypotheses: &[Hypothesis::stated(INSCRIBED), Hypothesis::silent(NO_ZERO_EDGE)],
        said: Grade::Certified,
        argument: "All quads parallel to the inscribed one arise from two free edges. If its first and \
                   third corner agree, the parallel quads are folded, too, and have two equal corners or \
                   all on a line. Other faces: only quads are claimed.",
        evidence: &[Evidence::identity::<ParallelToInscribed>("one quad", &[1], &[1])],
        controls: &[
            Control {
                without: INSCRIBED,
                shows: "every quad is parallel to itself",
                counterexample: Counterexample::Witness(kite_itself),
            },
            Control {
                without: NO_ZERO_EDGE,
                shows: "every quad is parallel to a point of Σ",
                counterexample: Counterexample::Witness(constant_image),
            },
        ],
    },
];

const CIRCULAR: &str = "the top view of every face is concyclic";
const NOT_VERTICAL: &str = "the top view of no face is collinear";
const INSCRIBED: &str = "S₁ is planar and inscribed";
const NO_ZERO_EDGE: &str = "no edge of S₁ has length zero";

struct LiftedVolume;

impl Identity for LiftedVolume {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let at = (0..4).map(|_| trial.free_point()).collect();
        let m = one_face(trial, at)?;
        let s = lift(&m);
        let corners = |m: &Mesh<T>| std::array::from_fn(|i| m.points[i].clone());
        let volume = Coplanar.eval(&corners(&s), &T::one());
        let circle = Concyclic.eval(&corners(&m), &T::one());
        trial.equal("volume", &(volume * T::from_i64(-2)), &circle);
        for p in s.points {
            trial.zero("on Σ", OnSigma.eval(&[p], &T::one()));
        }
        Ok(())
    }
}

struct LiftedFace;

impl Identity for LiftedFace {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let plane = free_plane(trial);
        let at = concyclic(trial, CIRCULAR)?;
        trial.nonzero(NOT_VERTICAL, &(&at[1] - &at[0]).det(&(&at[2] - &at[0])))?;
        let m = one_face(trial, over(&plane, &at))?;
        let pair = trial.accepted("inscribed and v-parallel", inscribed_v_parallel(&m))?;
        let s = trial.made_mesh(pair.image().clone());
        for (p, x) in s.points.iter().zip(&at) {
            trial.equal("the same top view", &p.top_view().distance2(x), &T::zero());
            trial.zero("on Σ", OnSigma.eval(array::from_ref(p), &T::one()));
        }
        trial.exhibit("S", &s);
        Ok(())
    }
}

struct LiftedNet;

impl Experiment for LiftedNet {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        let m = net(trial)?;
        let pair = trial.accepted("inscribed and v-parallel", inscribed_v_parallel(&m))?;
        for p in &pair.image().points {
            trial.zero("on Σ", OnSigma.eval(array::from_ref(p), &T::one()));
        }
        trial.exhibit("M", &m);
        Ok(())
    }
}

fn vertical_face() -> Result<String, String> {
    let (q, mut faces) = (Rational::from_i64, FaceList::new());
    faces.push(0..4);
    let points = (0..4).map(|i| Point::new(q(i), q(0), q(i * i * i))).collect();
    let m = Mesh::new(points, faces).map_err(|e| e.to_string())?;
    match inscribed_v_parallel(&m) {
        Err(error) => Ok(error.to_string()),
        Ok(_) => Err("there is a pair".into()),
    }
}

struct ParallelToInscribed;

impl Identity for ParallelToInscribed {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let at = concyclic(trial, INSCRIBED)?;
        let first = trial.free_point();
        let factors = [trial.free(), trial.free()];
        let s = one_face(trial, over_sigma(&at))?;
        let f: [_; 4] = std::array::from_fn(|j| &s.points[(j + 1) % 4] - &s.points[j]);
        for f in &f {
            trial.nonzero(NO_ZERO_EDGE, &f.top_view().length2())?;
        }
        let det = f[2].top_view().det(&f[3].top_view());
        trial.parameter("the first and the third corner differ", &det)?;
        // m₃ lies on the lines through m₂ and m₀.
        let second = &first + &scaled(&f[0], &factors[0]);
        let third = &second + &scaled(&f[1], &factors[1]);
        let diagonal = (&third - &first).top_view();
        let fourth = &first + &scaled(&f[3], &(f[2].top_view().det(&diagonal) / det));
        let m = one_face(trial, vec![first, second, third, fourth])?;
        trial.accepted("parallel", Parallel::new(&m, &s))?;
        let m = trial.made_mesh(m);
        let corners = std::array::from_fn(|i| m.points[i].clone());
        trial.zero("i-circular", Concyclic.eval(&corners, &T::one()));
        trial.zero("planar", Coplanar.eval(&corners, &T::one()));
        trial.exhibit("M", &m);
        trial.exhibit("S", &s);
        Ok(())
    }
}

fn over_sigma<T: Field>(at: &[TopView<T>]) -> Vec<Point<T>> {
    let sigma = ParabolicSphere::unit();
    at.iter().map(|x| sigma.contact_at(x).point).collect()
}

fn scaled<T: Field>(v: &Vector3<T>, by: &T) -> Vector3<T> {
    Vector3::new(&v.x * by, &v.y * by, &v.z * by)
}

/// A flat kite that is not concyclic, with a parallel image, and its in-circle determinant.
fn kite(image: [[i64; 3]; 4]) -> Result<String, String> {
    let corners = [[0, 0, 0], [1, 0, 0], [3, 3, 0], [0, 1, 0]];
    let (m, s) = (mesh_of(&corners, &[&[0, 1, 2, 3]])?, mesh_of(&image, &[&[0, 1, 2, 3]])?);
    Parallel::new(&m, &s).map_err(|error| error.to_string())?;
    let corners = std::array::from_fn(|i| m.points[i].clone());
    let circle = Concyclic.eval(&corners, &Rational::one());
    if circle.is_zero() {
        Err("it is i-circular".into())
    } else {
        Ok(format!("i-circular: {circle}"))
    }
}

fn kite_itself() -> Result<String, String> {
    kite([[0, 0, 0], [1, 0, 0], [3, 3, 0], [0, 1, 0]])
}

fn constant_image() -> Result<String, String> {
    kite([[2, 0, 2]; 4])
}
