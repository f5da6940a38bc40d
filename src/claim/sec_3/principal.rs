//! Sec. 3.2: angles of i-circular faces and i-conical vertices, and the cone at a vertex.

use super::instance::{
    CORNERS, all_different, gradient, gradient_incircle, on_circle, pyramid, star, sum, turn,
    unless,
};
use super::{
    Claim, Control, Counterexample, Evidence, Experiment, Grade, Hypothesis, Identity, Run, Source,
    Trial,
};
use crate::check::Residual;
use crate::construct::circumscribed_f_parallel;
use crate::mesh::FaceId;
use crate::net::i_circular::Concyclic;
use crate::net::i_conical::{Balance, ConcyclicGradients};
use crate::net::scribed::TouchesSigma;
use crate::scalar::{Field, Ordered, Rational, RationalField, Ring, Sign};
use crate::space::{Dual, Gradient, Plane, Point, Rotation, TopView, Vector2};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-13-circular",
        statement: "The sine of the sum of opposite angles of a quad, times its four sides, is, up to its sign, \
                    the in-circle determinant of the top view: the sums are multiples of π iff the corners are \
                    concyclic or collinear. In an embedded convex quad they are π iff it is concyclic.",
        formula: "α₁ + α₃ = α₂ + α₄ = π",
        source: Source::Paper("Sec. 3.2, (13)"),
        hypotheses: &[Hypothesis::silent(CONVEX)],
        said: Grade::Certified,
        argument: "Modulo π it is decided, for every quad. Angles of an embedded convex quad lie between 0 \
                   and π, their sums between 0 and 2π, where π is the only zero of the sine: the step to \
                   real angles is this argument, and exact signs on instances.",
        evidence: &[
            Evidence::identity::<OppositeAngles>("modulo π", &[1], &[1]),
            Evidence::experiment::<ConvexQuad>("convex quads, by signs", &[1]),
        ],
        controls: &[Control {
            without: CONVEX,
            shows: "the bow-tie in a square has equal opposite angles",
            counterexample: Counterexample::Witness(bow_tie),
        }],
    },
    Claim {
        id: "eq-14-conical",
        statement: "With the jumps p_j - p_(j-1) = w_j J e_j of the gradients across the four edges of a \
                    vertex, their in-circle determinant is the product of the w_j and the balance \
                    Im(e₀ e₂ conj(e₁ e₃)): so the vertex is i-conical iff (14) holds modulo π. For edges \
                    in cyclic order both sums are then π.",
        formula: "ω₁ + ω₃ = ω₂ + ω₄ = π",
        source: Source::Paper("Sec. 3.2, (14)"),
        hypotheses: &[
            Hypothesis::silent(NOT_COPLANAR),
            Hypothesis::silent(NOT_ISOTROPIC),
            Hypothesis::silent(CYCLIC),
        ],
        said: Grade::Certified,
        argument: "Modulo π it is decided: only the planes of the faces enter, and each is spanned by \
                   two edges. Edges in cyclic order enclose four positive angles with the sum 2π, so \
                   that ω₁ + ω₃ lies between 0 and 2π, where π is the only zero of the sine: this step \
                   is an argument, and exact signs on instances.",
        evidence: &[
            Evidence::identity::<Jumps>("modulo π", &[1], &[1]),
            Evidence::identity::<Normals>("gradients by normals", &[1], &[1]),
            Evidence::experiment::<CyclicStar>("edges in cyclic order, by signs", &[1]),
        ],
        controls: &[
            Control {
                without: NOT_COPLANAR,
                shows: "with two coplanar faces a vertex is i-conical whatever its angles",
                counterexample: Counterexample::Witness(coplanar_faces),
            },
            Control {
                without: NOT_ISOTROPIC,
                shows: "at an edge of length 0 the planes need not agree: balanced, and not i-conical",
                counterexample: Counterexample::Witness(vertical_edge),
            },
            Control {
                without: CYCLIC,
                shows: "an i-conical vertex with one edge turned around",
                counterexample: Counterexample::Witness(turned_edge),
            },
        ],
    },
    Claim {
        id: "conical-cone",
        statement: "Four face planes at a vertex v of M touch a common isotropic cone of revolution iff \
                    their gradients lie on a circle; its centre is the top view of the vertex s of the \
                    circumscribed mesh S, and the cone is that of the planes of S at s, moved to v.",
        formula: "|p_j - s'|² = |s'|² - 2 s₃",
        source: Source::Paper("Sec. 3.2"),
        hypotheses: &[Hypothesis::stated(ON_CIRCLE), Hypothesis::silent(NOT_COLLINEAR)],
        said: Grade::Certified,
        argument: "The planes of S touch Σ and pass through s: they are those of a cone of revolution. \
                   Conversely planes at a constant i-angle from that with the gradient s' have their \
                   gradients on a circle. Up to an i-motion a closed pyramid has the planes of any \
                   vertex of valence 4 at its apex, and there is no condition at its base.",
        evidence: &[Evidence::identity::<ConeAtApex>("the apex of a pyramid", &[1], &[1])],
        controls: &[
            Control {
                without: ON_CIRCLE,
                shows: "gradients on no circle",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &["1", "2", "1", "1", "2", "-2", "1/2", "1", "0"],
                    constrained: &["-1", "-1"],
                },
            },
            Control {
                without: NOT_COLLINEAR,
                shows: "gradients on a line: the planes touch a vertical cylinder, s is at infinity",
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

const CONVEX: &str = "the top view is an embedded convex quad";
const NOT_COPLANAR: &str = "adjacent faces are not coplanar";
const NOT_ISOTROPIC: &str = "no edge is isotropic";
const CYCLIC: &str = "the top views of the edges are in cyclic order";
const ON_CIRCLE: &str = "the gradients lie on a circle";
const NOT_COLLINEAR: &str = "the gradients are not collinear";

/// The angles of a quad as cosines and sines, times the lengths of their legs.
fn corners<T: Field>(quad: &[Point<T>; 4]) -> [Vector2<T>; 4] {
    std::array::from_fn(|j| {
        let leg = |i: usize| (&quad[i % 4] - &quad[j]).top_view();
        turn(&leg(j + 1), &leg(j + 3))
    })
}

struct OppositeAngles;

impl Identity for OppositeAngles {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let quad = [(); 4].map(|()| trial.free_point());
        let angles = corners(&quad);
        let residual = Concyclic.eval(&quad, &T::one());
        trial.show("in-circle determinant", &residual);
        trial.equal("sin(α₁ + α₃)", &sum(&angles[0], &angles[2]).y, &residual);
        trial.equal("sin(α₂ + α₄)", &sum(&angles[1], &angles[3]).y, &-residual);
        Ok(())
    }
}

struct ConvexQuad;

impl Experiment for ConvexQuad {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        // Parameters that increase run around the circle once.
        let (centre, radius) = (trial.free_vector2(), trial.free());
        trial.parameter("a circle", &radius)?;
        let mut parameter = trial.free();
        let mut quad = Vec::new();
        for _ in 0..4 {
            let ray = trial.accepted("a direction", Rotation::from_parameter(&parameter))?;
            let step = trial.free();
            trial.parameter("different corners", &step)?;
            parameter = parameter + step.square();
            let at = &centre + &Vector2::new(ray.cos() * &radius, ray.sin() * &radius);
            let z = trial.free();
            quad.push(Point::new(at.x, at.y, z));
        }
        let quad: [Point<T>; 4] = trial.accepted("four corners", quad.try_into())?;
        let angles = corners(&quad);
        for angle in &angles {
            trial.zero("an angle below π", unless(Sign::Positive, &angle.y));
        }
        for (a, b) in [(0, 2), (1, 3)] {
            let sum = sum(&angles[a], &angles[b]);
            trial.zero("sine of the sum", sum.y);
            trial.zero("cosine of the sum", unless(Sign::Negative, &sum.x));
        }
        Ok(())
    }
}

fn points<const N: usize>(coordinates: [[i64; 3]; N]) -> [Point<Rational>; N] {
    coordinates.map(|[x, y, z]| Point::new(x, y, z).map(|&c| Rational::from_i64(c)))
}

fn bow_tie() -> Result<String, String> {
    let quad = points([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0]]);
    let angles = corners(&quad);
    // As they are seen, without a sign.
    let seen = |n: usize| Vector2::new(angles[n].x.clone(), angles[n].y.magnitude());
    let sine = sum(&seen(0), &seen(2)).y;
    if !Concyclic.eval(&quad, &Rational::one()).is_zero() || sine.is_zero() {
        return Err("it obeys (13)".into());
    }
    Ok(format!("sin(α₁ + α₃) times the four sides: {sine}"))
}

/// The edges at the first point of a star.
fn edges<T: Field>(points: &[Point<T>]) -> Vec<Vector2<T>> {
    points[1..].iter().map(|x| (x - &points[0]).top_view()).collect()
}

struct Jumps;

impl Identity for Jumps {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        // Four planes through the vertex meet in the edges.
        let v = trial.free_point();
        let drawn = [(); 4].map(|()| Gradient::new(trial.free(), trial.free()));
        let mut at = vec![v.clone()];
        for j in 0..4 {
            let jump = &drawn[j] - &drawn[(j + 3) % 4];
            let length = trial.free();
            trial.nonzero(NOT_COPLANAR, &jump.length2())?;
            trial.nonzero(NOT_ISOTROPIC, &length)?;
            let top_view = &v.top_view() + &jump.turned().scaled(&length);
            at.push(Plane::through_point(&v, drawn[j].clone()).point_at(&top_view));
        }
        let at: [Point<T>; 5] = trial.accepted("a star", at.try_into())?;
        let e = edges(&at);
        for j in 0..4 {
            let (jump, next) = (&drawn[j] - &drawn[(j + 3) % 4], &drawn[(j + 1) % 4] - &drawn[j]);
            trial.parameter(CORNERS, &jump.det(&next))?;
        }
        let mesh = star(trial, at.to_vec())?;
        let mut p = Vec::new();
        for face in 0..4 {
            p.push(gradient(trial, &mesh, face)?);
        }
        let mut product = Balance.eval(&at, &T::one());
        trial.show("balance", &product);
        let (odd, even) = (turn(&e[0], &e[1]), turn(&e[2], &e[3]));
        trial.equal("sin(ω₁ + ω₃)", &sum(&odd, &even).y, &-&product);
        let (odd, even) = (turn(&e[1], &e[2]), turn(&e[3], &e[0]));
        trial.equal("sin(ω₂ + ω₄)", &sum(&odd, &even).y, &product);
        for j in 0..4 {
            let jump = &p[j] - &p[(j + 3) % 4];
            trial.zero("jump along the edge", jump.dot(&e[j]));
            let weight = jump.dot(&e[j].turned()) / e[j].length2();
            product = product * weight;
        }
        let gradients = gradient_incircle([&p[0], &p[1], &p[2], &p[3]]);
        trial.equal("in-circle determinant of the gradients", &gradients, &product);
        trial.exhibit("star", &mesh);
        Ok(())
    }
}

struct Normals;

impl Identity for Normals {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let apex = trial.free_point();
        let gradients = [(); 4].map(|()| Gradient::new(trial.free(), trial.free()));
        let [a, b, c, d] = &gradients;
        let mut expected = gradient_incircle([a, b, c, d]);
        let mut at = Vec::new();
        for p in &gradients {
            // Any triangle of the plane, up to a rotation.
            let (u, v) = (trial.free_vector2(), trial.free());
            let plane = Plane::through_point(&apex, p.clone());
            let along = |step: Vector2<T>| plane.point_at(&(&apex.top_view() + &step));
            at.push(apex.clone());
            at.push(along(Vector2::new(v.clone(), T::zero())));
            at.push(along(u.clone()));
            expected = expected * (u.y * v).square();
        }
        let at: [Point<T>; 12] = trial.accepted("twelve points", at.try_into())?;
        trial.equal("degree 16", &ConcyclicGradients.eval(&at, &T::one()), &expected);
        Ok(())
    }
}

struct CyclicStar;

impl Experiment for CyclicStar {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        let first = trial.free_vector2();
        trial.nonzero(NOT_ISOTROPIC, &first.length2())?;
        // Two angles between 0 and π; then ω₃ = π − ω₁ and ω₄ = π − ω₂.
        let mut turns = Vec::new();
        for _ in 0..2 {
            let half = trial.free();
            trial.parameter("an angle", &half)?;
            turns.push(trial.accepted("an angle", Rotation::from_parameter(&half.square()))?);
        }
        let second = turns[0].turn(&first);
        let third = turns[1].turn(&second);
        let fourth = -&turns[1].turn(&first);
        let v = trial.free_point();
        let mut at = vec![v.clone()];
        for e in [first, second, third, fourth] {
            let (length, z) = (trial.free(), trial.free());
            trial.nonzero(NOT_ISOTROPIC, &length)?;
            at.push((&v.top_view() + &e.scaled(&length.square())).at_height(z));
        }
        let e = edges(&at);
        for j in 0..4 {
            let order = unless(Sign::Positive, &e[j].det(&e[(j + 1) % 4]));
            trial.zero("in cyclic order", order);
        }
        let opposite = sum(&turn(&e[0], &e[1]), &turn(&e[2], &e[3]));
        trial.zero("sin(ω₁ + ω₃)", opposite.y);
        trial.zero("cos(ω₁ + ω₃)", unless(Sign::Negative, &opposite.x));
        let mesh = star(trial, at)?;
        let mut p = Vec::new();
        for face in 0..4 {
            p.push(gradient(trial, &mesh, face)?);
        }
        trial.zero("i-conical", gradient_incircle([&p[0], &p[1], &p[2], &p[3]]));
        Ok(())
    }
}

/// The in-circle determinant of the gradients of a star of quads, and its balance.
fn conical_and_balance(star: [[i64; 3]; 5]) -> Option<[Rational; 2]> {
    let at = points(star);
    let plane = |j: usize| Plane::through(&at[0], &at[1 + j], &at[1 + (j + 1) % 4]).ok();
    let [a, b, c, d] = [plane(0)?, plane(1)?, plane(2)?, plane(3)?].map(|plane| plane.gradient);
    Some([gradient_incircle([&a, &b, &c, &d]), Balance.eval(&at, &Rational::one())])
}

fn coplanar_faces() -> Result<String, String> {
    // The faces at the second edge lie in z = 0.
    let star = [[0, 0, 0], [2, 0, 0], [1, 3, 0], [-1, 1, 0], [0, -1, 1]];
    match conical_and_balance(star) {
        Some([conical, balance]) if conical.is_zero() && !balance.is_zero() => {
            Ok(format!("balance: {balance}"))
        }
        _ => Err("it obeys (14)".into()),
    }
}

fn vertical_edge() -> Result<String, String> {
    // The first edge has length 0; a longer one would lie in vertical faces.
    let at = points([[0, 0, 0], [0, 0, 0], [1, 2, 3], [-2, 1, 1], [1, -3, 2]]);
    let corner = points([[3, 0, 1], [2, -1, 5]]);
    let triangles = [
        [&at[1], &corner[0], &at[2]],
        [&at[0], &at[2], &at[3]],
        [&at[0], &at[3], &at[4]],
        [&at[1], &at[4], &corner[1]],
    ];
    let at12: [Point<Rational>; 12] = std::array::from_fn(|i| triangles[i / 3][i % 3].clone());
    let conical = ConcyclicGradients.eval(&at12, &Rational::one());
    if conical.is_zero() || !Balance.eval(&at, &Rational::one()).is_zero() {
        return Err("it obeys (14)".into());
    }
    Ok(format!("in-circle determinant of the normals: {conical}"))
}

fn turned_edge() -> Result<String, String> {
    // ω₁ + ω₃ = π with the third edge in the opposite direction.
    let star = [[0, 0, 0], [5, 0, 1], [3, 4, 0], [4, -3, 2], [0, -1, -1]];
    let at = points(star);
    let e = edges(&at);
    let seen = |a: usize, b: usize| {
        let angle = turn(&e[a], &e[b]);
        Vector2::new(angle.x, angle.y.magnitude())
    };
    let sine = sum(&seen(0, 1), &seen(2, 3)).y;
    match conical_and_balance(star) {
        Some([conical, balance]) if conical.is_zero() && balance.is_zero() && !sine.is_zero() => {
            Ok(format!("sin(ω₁ + ω₃) times the four lengths: {sine}"))
        }
        other => Err(format!("{other:?}, {sine}")),
    }
}

struct ConeAtApex;

impl Identity for ConeAtApex {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let height = trial.free();
        let three = [(); 3].map(|()| TopView::new(trial.free(), trial.free()));
        let [a, b, c] = &three;
        trial.nonzero(NOT_COLLINEAR, &(b - a).det(&(c - a)))?;
        let fourth = on_circle(trial, ON_CIRCLE, [a, b, c])?;
        for [a, b] in [[a, b], [b, c], [c, a]] {
            trial.nonzero(NOT_COLLINEAR, &(b - a).det(&(&fourth - a)))?;
        }
        let p = [a, b, c, &fourth].map(Dual::dual);
        let xs = [&p[0].x, &p[1].x, &p[2].x, &p[3].x, &T::zero()];
        all_different(trial, "the gradients differ in x", &xs)?;
        let m = pyramid(trial, &height, &p)?;
        let image = trial.accepted("circumscribed and f-parallel", circumscribed_f_parallel(&m))?;
        let s = trial.made_mesh(image.pair.image().clone());
        let radius2 = s.points[0].top_view().norm2() - T::from_i64(2) * &s.points[0].z;
        for (j, p) in p.iter().enumerate() {
            let distance2 = p.dual().distance2(&s.points[0].top_view());
            trial.equal("on the circle about s'", &distance2, &radius2);
            let face = m.topology.face(FaceId(j as u32));
            let at = std::array::from_fn(|i| s.points[face[i].index()].clone());
            trial.zero("touches Σ", TouchesSigma.eval(&at, &T::one()));
        }
        trial.exhibit("M", &m);
        trial.exhibit("S", &s);
        Ok(())
    }
}
