//! Sec. 3.2, Theorem 1: the inscribed meshes parallel to an i-circular one.

use std::array;

use super::instance::{
    CORNERS, concyclic, free_plane, free_top_view, incircle, mesh_of, net, one_face, over,
};
use super::{
    Claim, Control, Counterexample, Evidence, Experiment, Grade, Hypothesis, Identity, Run, Source,
    Stop, Trial,
};
use crate::check::Residual;
use crate::construct::{NoGaussImage, inscribed_f_parallel};
use crate::mesh::{FaceId, FaceList, Mesh, VertexId};
use crate::net::i_circular::Concyclic;
use crate::net::scribed::OnSigma;
use crate::scalar::{Field, Rational, RationalField, Ring};
use crate::space::{Dual, Gradient, ParabolicSphere, Plane, TopView, Vector2};

pub(super) const CLAIMS: &[Claim] = &[Claim {
    id: "thm-1-f",
    statement: "A planar i-circular mesh has an inscribed mesh with parallel edges through every point \
                    of Σ. A step over an edge e is the reflection of the top view at the line through \
                    the gradient g of either face, across e; around a quad the four steps miss the \
                    start x by (2 I / N) i w (x - g), with w = e₁ e₃ conj(e₀ e₂), N = |w| and the \
                    in-circle determinant I, and so close iff it is concyclic.",
    formula: "x₄ - x = (2 I / N) i w (x - g)",
    source: Source::Paper("Sec. 3.2, Theorem 1"),
    hypotheses: &[
        Hypothesis::stated(CIRCULAR),
        Hypothesis::silent(EDGES),
        Hypothesis::silent(EVEN),
        Hypothesis::silent(SIMPLY),
        Hypothesis::silent(START),
    ],
    said: Grade::Certified,
    argument: "A step is an involution that only depends on the edge. A face with 2n corners is cut into \
                   quads by the diagonals from one corner, and a step along a diagonal and back is none: \
                   so it closes as its quads do; the gap is that of any quad up to an i-motion. With all \
                   faces closed every cycle of a simply connected mesh closes; around a vertex nothing further is asked. The image of a face lies at \
                   the distance |x - g| from g, so an edge of it vanishes only where (g - x)·e = 0.",
    evidence: &[
        Evidence::identity::<StepsAroundQuad>("the gap of any quad", &[1], &[1]),
        Evidence::identity::<ClosedFace>("one i-circular face", &[4], &[4, 6, 8]),
        Evidence::identity::<StepOverEdge>("a step is the same for both faces", &[1], &[1]),
        Evidence::experiment::<InscribedNet>("nets", &[2, 3]),
    ],
    controls: &[
        Control {
            without: CIRCULAR,
            shows: "a planar quad that is not concyclic",
            counterexample: Counterexample::Unknowns {
                evidence: 1,
                size: 4,
                unknowns: &["0", "0", "1", "0", "0", "1", "1", "2", "0", "1", "1", "2", "5"],
                constrained: &["3", "3"],
            },
        },
        Control {
            without: EDGES,
            shows: "along a vertical edge there is no second point of Σ",
            counterexample: Counterexample::Witness(vertical_edge),
        },
        Control {
            without: EVEN,
            shows: "three reflections at lines through g are no identity",
            counterexample: Counterexample::Witness(triangle),
        },
        Control {
            without: SIMPLY,
            shows: "a flat ring of three i-circular quads",
            counterexample: Counterexample::Witness(ring_of_three),
        },
        Control {
            without: START,
            shows: "over the gradient of a face every step is none",
            counterexample: Counterexample::Witness(start_over_gradient),
        },
    ],
}];

const CIRCULAR: &str = "the top view of every face is concyclic";
const EDGES: &str = "no edge is isotropic";
const EVEN: &str = "faces have an even number of sides";
const SIMPLY: &str = "M is simply connected";
const START: &str = "the start is not over the gradient of a face";

/// The product of two vectors as complex numbers.
fn times<T: Field>(a: &Vector2<T>, b: &Vector2<T>) -> Vector2<T> {
    Vector2::new(&a.x * &b.x - &a.y * &b.y, &a.x * &b.y + &a.y * &b.x)
}

struct StepsAroundQuad;

impl Identity for StepsAroundQuad {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        // Up to an i-motion the face lies in z = 0, and its first edge along x from the origin.
        let (origin, zero) =
            (TopView::new(T::zero(), T::zero()), Gradient::new(T::zero(), T::zero()));
        let plane = Plane::new(zero, T::zero());
        let second = TopView::new(trial.free(), T::zero());
        let at = [origin, second, free_top_view(trial), free_top_view(trial)];
        let start = free_top_view(trial);
        let e: [Vector2<T>; 4] = std::array::from_fn(|j| &at[(j + 1) % 4] - &at[j]);
        for e in &e {
            trial.nonzero(EDGES, &e.length2())?;
        }
        trial.parameter(CORNERS, &e[0].det(&e[1]))?;
        let even = times(&e[0], &e[2]);
        let w = times(&times(&e[1], &e[3]), &Vector2::new(even.x.clone(), -even.y));
        let [a, b, c, d] = &at;
        let circle = incircle([a, b, c, d]);
        // Both have the length of the first edge as a factor.
        trial.parameter("the quad is not concyclic", &(&circle / &e[0].x))?;
        let from_g = &start - &plane.gradient.dual();
        let along = times(&w, &from_g).turned();
        trial.parameter("the gap has an x", &(&along.x / &e[0].x))?;
        let norm = e.iter().fold(T::one(), |product, e| product * e.length2());
        let gap = along.scaled(&(T::from_i64(2) * &circle / norm));
        let m = one_face(trial, over(&plane, &at))?;
        match inscribed_f_parallel(&m, VertexId(0), &start) {
            Err(NoGaussImage::FaceOpen { residual, .. }) => {
                trial.show("I", &circle);
                trial.equal("gap in x", &residual.x, &gap.x);
                trial.equal("gap in y", &residual.y, &gap.y);
                let sigma = ParabolicSphere::unit();
                let rise = sigma.height_at(&(&start + &gap)) - sigma.height_at(&start);
                trial.equal("gap in z", &residual.z, &rise);
                Ok(())
            }
            Err(error) => Err(Stop::Failed(format!("{error:?}").into())),
            Ok(_) => Err(Stop::Failed("it closes".into())),
        }
    }
}

struct ClosedFace;

impl Identity for ClosedFace {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let plane = free_plane(trial);
        let at = concyclic(trial, CIRCULAR)?;
        let start = free_top_view(trial);
        let g = plane.gradient.dual();
        trial.nonzero(START, &start.distance2(&g))?;
        for (j, x) in at.iter().enumerate() {
            trial.nonzero(EDGES, &x.distance2(&at[(j + 1) % at.len()]))?;
        }
        let m = one_face(trial, over(&plane, &at))?;
        let pair = inscribed_f_parallel(&m, VertexId(0), &start);
        let pair = trial.accepted("inscribed and f-parallel", pair)?;
        trial.accepted("with parallel edges", pair.parallel())?;
        let s = trial.made_mesh(pair.image().clone());
        for p in &s.points {
            trial.zero("on Σ", OnSigma.eval(array::from_ref(p), &T::one()));
            trial.equal("|s - g|", &p.top_view().distance2(&g), &start.distance2(&g));
        }
        let corners = std::array::from_fn(|i| s.points[i].clone());
        trial.zero("S is i-circular", Concyclic.eval(&corners, &T::one()));
        trial.exhibit("M", &m);
        trial.exhibit("S", &s);
        Ok(())
    }
}

struct StepOverEdge;

impl Identity for StepOverEdge {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        // Two rectangles with a common edge.
        let (a, e, plane) = (free_top_view(trial), trial.free_vector2(), free_plane(trial));
        let (left, right, fold) = (trial.free(), trial.free(), trial.free());
        let start = free_top_view(trial);
        for length in [&e.length2(), &left, &right] {
            trial.nonzero(EDGES, length)?;
        }
        let other = &plane.gradient + &e.turned().scaled(&fold);
        let other = Plane::through_point(&plane.point_at(&a), other);
        let b = &a + &e;
        let beside = |x: &TopView<T>, by: &T| x + &e.turned().scaled(by);
        let mut points =
            over(&plane, &[a.clone(), b.clone(), beside(&b, &left), beside(&a, &left)]);
        points.extend(over(&other, &[beside(&a, &right), beside(&b, &right)]));
        let mut faces = FaceList::new();
        faces.push([0, 1, 2, 3]);
        faces.push([1, 0, 4, 5]);
        let m = trial.accepted("two rectangles", Mesh::new(points, faces))?;
        let pair = inscribed_f_parallel(&m, VertexId(0), &start);
        let pair = trial.accepted("inscribed and f-parallel", pair)?;
        let s = trial.made_mesh(pair.image().clone());
        for (face, plane) in m.topology.faces().zip([plane, other]) {
            for h in m.topology.half_edges(face) {
                let ends = [m.topology.origin(h), m.topology.target(h)].map(VertexId::index);
                let [x, y] = ends.map(|v| m.points[v].top_view());
                let [from, to] = ends.map(|v| s.points[v].top_view());
                let (edge, g) = (&y - &x, plane.gradient.dual());
                trial.zero("across the edge", (&to - &from).det(&edge));
                let middle = &(&from - &g) + &(&to - &g);
                trial.zero("reflected at the line through g", middle.dot(&edge));
            }
        }
        for p in &s.points {
            trial.zero("on Σ", OnSigma.eval(array::from_ref(p), &T::one()));
        }
        Ok(())
    }
}

struct InscribedNet;

impl Experiment for InscribedNet {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        let m = net(trial)?;
        let start = free_top_view(trial);
        for h in m.topology.edges() {
            let [v, w] = [m.topology.origin(h), m.topology.target(h)].map(VertexId::index);
            trial.nonzero(EDGES, &m.points[v].i_distance2(&m.points[w]))?;
        }
        let pair = inscribed_f_parallel(&m, VertexId(0), &start);
        let pair = trial.accepted("inscribed and f-parallel", pair)?;
        trial.accepted("with parallel edges", pair.parallel())?;
        let s = pair.image();
        for p in &s.points {
            trial.zero("on Σ", OnSigma.eval(array::from_ref(p), &T::one()));
        }
        for face in m.topology.faces() {
            let corners = s.topology.face(face);
            let corners = std::array::from_fn(|i| s.points[corners[i].index()].clone());
            trial.zero("S is i-circular", Concyclic.eval(&corners, &T::one()));
        }
        trial.exhibit("M", &m);
        Ok(())
    }
}

/// Why a mesh has no inscribed f-parallel one through the point of Σ over (1, 2).
fn refusal(m: &Mesh<Rational>) -> Result<String, String> {
    let start = TopView::new(Rational::from_i64(1), Rational::from_i64(2));
    match inscribed_f_parallel(m, VertexId(0), &start) {
        Err(error) => Ok(error.to_string()),
        Ok(_) => Err("there is one".into()),
    }
}

fn vertical_edge() -> Result<String, String> {
    // Coplanar points of an isotropic plane on a circle that is a line.
    let points = [[0, 0, 0], [0, 0, 1], [1, 0, 3], [2, 0, 0]];
    refusal(&mesh_of(&points, &[&[0, 1, 2, 3]])?)
}

fn triangle() -> Result<String, String> {
    refusal(&mesh_of(&[[0, 0, 0], [1, 0, 0], [0, 1, 0]], &[&[0, 1, 2]])?)
}

fn ring_of_three() -> Result<String, String> {
    // The outer corners are 30 a/|a|² for the inner ones.
    let points = [[1, 0, 0], [-1, 1, 0], [-1, -2, 0], [30, 0, 0], [-15, 15, 0], [-6, -12, 0]];
    let m = mesh_of(&points, &[&[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]])?;
    for face in m.topology.faces() {
        let corners = m.topology.face(face);
        let corners = std::array::from_fn(|i| m.points[corners[i].index()].clone());
        if !Concyclic.eval(&corners, &Rational::one()).is_zero() {
            return Err(format!("face {} is not i-circular", face.0));
        }
    }
    refusal(&m)
}

fn start_over_gradient() -> Result<String, String> {
    // A square in the plane z = x.
    let m = mesh_of(&[[0, 0, 0], [1, 0, 1], [1, 1, 1], [0, 1, 0]], &[&[0, 1, 2, 3]])?;
    let gradient = m.face_plane(FaceId(0)).map_err(|error| error.to_string())?.gradient;
    let pair = inscribed_f_parallel(&m, VertexId(0), &gradient.dual());
    let s = pair.map_err(|error| error.to_string())?.into_image();
    if s.points.iter().any(|p| *p != s.points[0]) {
        return Err("S has an edge".into());
    }
    Ok("the four corners of S agree".into())
}
