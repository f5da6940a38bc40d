//! Sec. 4: quads with mixed area 0.

use super::packing::{face_at, one_face, tangential, witnessed};
use super::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Stop, Trial,
};
use crate::check::Residual;
use crate::construct::{face_circle, koebe_mesh};
use crate::mesh::FaceId;
use crate::net::i_isothermic::{CoplanarPoles, TouchingCircles};
use crate::pair::{FParallel, MixedArea, Parallel, four_mixed_areas};
use crate::scalar::{Field, Rational, Ring};
use crate::space::{Gradient, OrientedCircle, Plane, Point, TopView, Vector2};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-20",
        statement: "Two parallel quads have mixed area 0 iff each diagonal of one is parallel to the other \
                    diagonal of the other.",
        formula: "area(F, S) = 0  <=>  13 ∥ 2*4*  and  24 ∥ 1*3*",
        source: Source::Paper("Sec. 4, (20), Fig. 7"),
        hypotheses: &[Hypothesis::stated(PARALLEL)],
        said: Grade::Certified,
        argument: "4 area(F, S) = det(13, 2*4*) + det(1*3*, 24) for any two quads, and the two terms differ by \
                   the cross products of corresponding edges, with signs; so for parallel quads, degenerate \
                   ones included, each of them is 2 area(F, S). In space: faces in planes that are not \
                   isotropic have the diagonals of their top views.",
        evidence: &[
            Evidence::identity::<ParallelQuads>(
                "parallel quads in space, and the one that has mixed area 0",
                &[1],
                &[1],
            ),
            Evidence::identity::<AnyQuads>("the two identities for any two quads", &[1], &[1]),
        ],
        controls: &[Control {
            without: PARALLEL,
            shows: "the unit square and a quad with 1*3* = (-1, 0), 2*4* = (1, 2)",
            counterexample: Counterexample::Witness(|| {
                let [f, s] = [[(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 0), (0, 0), (-1, 0), (1, 2)]]
                    .map(|corners| corners.map(|(x, y)| at(x, y)));
                let mixed = four_mixed_areas(&f, &s);
                if !mixed.is_zero() {
                    return Err(format!("4 area(F, S) = {mixed}"));
                }
                witnessed("area(F, S) = 0, but det(13, 2*4*)", &diagonals(&f, &s)[0])
            }),
        }],
    },
    Claim {
        id: "eq-20-one-diagonal",
        statement: "For parallel quads one pair of parallel diagonals is enough: the two conditions in (20) \
                    are equations between the same numbers.",
        formula: "2 area(F, S) = det(13, 2*4*) = det(1*3*, 24)",
        source: Source::Ours,
        hypotheses: &[Hypothesis::stated(PARALLEL)],
        said: Grade::Certified,
        argument: "The quad that is made has one pair of parallel diagonals and is otherwise any quad \
                   parallel to F.",
        evidence: &[Evidence::identity::<OneDiagonal>(
            "a parallel quad with one parallel diagonal",
            &[1],
            &[1],
        )],
        controls: &[Control {
            without: PARALLEL,
            shows: "the unit square and a quad with 1*3* = (-1, 1), 2*4* = (1, 0)",
            counterexample: Counterexample::Witness(|| {
                let [f, s] = [[(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 0), (0, 0), (-1, 1), (1, 0)]]
                    .map(|corners| corners.map(|(x, y)| at(x, y)));
                let [first, second] = diagonals(&f, &s);
                if !second.is_zero() {
                    return Err(format!("det(1*3*, 24) = {second}"));
                }
                witnessed("det(1*3*, 24) = 0, but det(13, 2*4*)", &first)
            }),
        }],
    },
    Claim {
        id: "eq-20-incircle",
        statement: "If a quad has an incircle, so has every parallel quad with mixed area 0: the lengths of \
                    its tangents are inverse to those of the first.",
        formula: "R*_j = μ / R_j",
        source: Source::Paper("Sec. 4, Fig. 7"),
        hypotheses: &[Hypothesis::silent(NO_POINT), Hypothesis::silent(OFF_CIRCLE)],
        said: Grade::Certified,
        argument: "Up to similarity F is circumscribed to the unit circle. All its parallel quads with \
                   mixed area 0 are reached, since by eq-20-one-diagonal one pair of parallel diagonals makes \
                   them; corners on the incircle are those between edges on one line.",
        evidence: &[Evidence::identity::<Incircle>(
            "the quad made from a parallel diagonal has an incircle",
            &[1],
            &[1],
        )],
        controls: &[
            Control {
                without: NO_POINT,
                shows: "a point is parallel to everything and has no incircle",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &["0", "1/2", "2", "-3", "0"],
                    constrained: &[],
                },
            },
            Control {
                without: OFF_CIRCLE,
                shows: "a triangle with the point of contact as a fourth corner has only segments",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &["0", "0", "2", "-3", "1"],
                    constrained: &[],
                },
            },
        ],
    },
];

const PARALLEL: &str =
    "corresponding edges are parallel; the zero vector is parallel to everything";
const NO_POINT: &str = "S is not a point";
const OFF_CIRCLE: &str = "no vertex lies on its incircles: R_j != 0";
const SPANNED: &str = "two edges of F that meet at corner 1 or 3 are not parallel";

fn at(x: i64, y: i64) -> TopView<Rational> {
    TopView::new(Rational::from_i64(x), Rational::from_i64(y))
}

/// `det(13, 2*4*)` and `det(1*3*, 24)`.
fn diagonals<T: Ring>(f: &[TopView<T>; 4], s: &[TopView<T>; 4]) -> [T; 2] {
    [(&f[2] - &f[0]).det(&(&s[3] - &s[1])), (&s[2] - &s[0]).det(&(&f[3] - &f[1]))]
}

struct AnyQuads;

impl Identity for AnyQuads {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let f: [_; 4] = std::array::from_fn(|_| TopView::new(trial.free(), trial.free()));
        let s: [_; 4] = std::array::from_fn(|_| TopView::new(trial.free(), trial.free()));
        let [first, second] = diagonals(&f, &s);
        trial.equal("4 area(F, S)", &four_mixed_areas(&f, &s), &(&first + &second));
        let edge = |v: &[TopView<T>; 4], j: usize| &v[(j + 1) % 4] - &v[j];
        let cross = |j: usize| edge(&f, j).det(&edge(&s, j));
        trial.equal("terms", &(second - first), &(cross(0) - cross(1) + cross(2) - cross(3)));
        Ok(())
    }
}

/// The quad parallel to F with two corners given on the first edge and a third by its factor.
fn parallel_quad<T: Field>(
    f: &[Point<T>; 4],
    first: &Point<T>,
    factors: [&T; 2],
) -> Option<[Point<T>; 4]> {
    let e: [_; 4] = std::array::from_fn(|j| &f[(j + 1) % 4] - &f[j]);
    let step = |p: &Point<T>, j: usize, factor: &T| {
        Point::new(&p.x + &e[j].x * factor, &p.y + &e[j].y * factor, &p.z + &e[j].z * factor)
    };
    let second = step(first, 0, factors[0]);
    let third = step(&second, 1, factors[1]);
    let back = first.top_view();
    let gap = &back - &third.top_view();
    let last = gap.det(&e[3].top_view()).try_div(&e[2].top_view().det(&e[3].top_view()))?;
    let fourth = step(&third, 2, &last);
    Some([first.clone(), second, third, fourth])
}

/// A planar quad in space over any other in the top view.
fn planar_quad<T: Field>(trial: &mut Trial<T>) -> [Point<T>; 4] {
    let plane = Plane::new(Gradient::new(trial.free(), trial.free()), trial.free());
    std::array::from_fn(|_| plane.point_at(&TopView::new(trial.free(), trial.free())))
}

fn spanned<T: Field>(trial: &mut Trial<T>, f: &[Point<T>; 4]) -> Run {
    let view = |j: usize| f[j].top_view();
    let corner = |i: usize, j: usize, k: usize| (&view(j) - &view(i)).det(&(&view(k) - &view(j)));
    trial.parameter(SPANNED, &corner(0, 1, 2))?;
    trial.parameter(SPANNED, &corner(2, 3, 0))
}

struct ParallelQuads;

impl Identity for ParallelQuads {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let f = planar_quad(trial);
        spanned(trial, &f)?;
        let (first, second) = (trial.free(), trial.free());
        let start = trial.free_point();
        let s = trial.defined(SPANNED, parallel_quad(&f, &start, [&first, &second]))?;
        let goals = |trial: &mut Trial<T>, s: [Point<T>; 4]| -> Result<T, Stop> {
            let s = s.map(|p| trial.made_point(p));
            let views = [&f, &s].map(|q| q.clone().map(|p| p.top_view()));
            let [m, s] = [f.to_vec(), s.to_vec()].map(|q| face_at(q));
            let (m, s) = (trial.accepted("F", m)?, trial.accepted("S", s)?);
            trial.exhibit("F", &m);
            trial.exhibit("S", &s);
            trial.accepted("parallel", Parallel::new(&m, &s))?;
            let pair = trial.accepted("f-parallel", FParallel::new(&m, &s))?;
            let mixed = pair.face_forms(FaceId(0)).mixed_area();
            trial.show("area(F, S)", &mixed);
            let [one, other] = diagonals(&views[0], &views[1]);
            let twice = &mixed * T::from_i64(2);
            trial.equal("det(13, 2*4*)", &one, &twice);
            trial.equal("det(1*3*, 24)", &other, &twice);
            let points = |i: usize| {
                let corners = [0, i, i + 1];
                let all = corners.map(|c| &m.points[c]).into_iter();
                let all: Vec<_> = all.chain(corners.map(|c| &s.points[c])).collect();
                std::array::from_fn(|n| all[n].clone())
            };
            let fan = [1, 2].map(|i| MixedArea.eval(&points(i), &T::one()));
            let [a, b] = fan;
            trial.equal("4 area(F, S)", &(a + b), &(twice * T::from_i64(2)));
            Ok(mixed)
        };
        goals(trial, s)?;
        // det(13, 2*4*) is linear in the factors of the edges: with this one it vanishes.
        let view = |j: usize| f[j].top_view();
        let long = &view(2) - &view(0);
        let [e1, e2, e3] = [1, 2, 3].map(|j: usize| &view((j + 1) % 4) - &view(j));
        let e0 = &view(1) - &view(0);
        // s3 - s1 = a e1 + b e2 with b = -det(first e0 + a e1, e3)/det(e2, e3).
        let scale = e2.det(&e3);
        let slope = long.det(&e1) * &scale - long.det(&e2) * e1.det(&e3);
        trial.parameter("the factor of edge 12 decides over the mixed area", &slope)?;
        let constant = &first * long.det(&e2) * e0.det(&e3);
        let Some(solved) = constant.try_div(&slope) else { return Ok(()) };
        let dual = trial.defined(SPANNED, parallel_quad(&f, &start, [&first, &solved]))?;
        let mixed = goals(trial, dual)?;
        trial.zero("mixed area", mixed);
        Ok(())
    }
}

/// The quad parallel to F from the corner `s₀` with `1*3* = a 24`.
fn with_diagonal<T: Field>(f: &[TopView<T>; 4], s0: &TopView<T>, a: &T) -> Option<[TopView<T>; 4]> {
    let e: [_; 4] = std::array::from_fn(|j| &f[(j + 1) % 4] - &f[j]);
    let diagonal = (&f[3] - &f[1]).scaled(a);
    let s2 = s0 + &diagonal;
    // s1 lies on the lines along e0 from s0 and along e1 from s2, s3 likewise.
    let meet = |along: &Vector2<T>, other: &Vector2<T>| {
        Some(s0 + &along.scaled(&diagonal.det(other).try_div(&along.det(other))?))
    };
    Some([s0.clone(), meet(&e[0], &e[1])?, s2, meet(&e[3], &e[2])?])
}

struct OneDiagonal;

impl Identity for OneDiagonal {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let f = planar_quad(trial);
        spanned(trial, &f)?;
        let f = f.map(|p| p.top_view());
        let (a, start) = (trial.free(), TopView::new(trial.free(), trial.free()));
        let s = trial.defined(SPANNED, with_diagonal(&f, &start, &a))?;
        let s = s.map(|p| TopView::new(trial.made(p.x), trial.made(p.y)));
        trial.zero("4 area(F, S)", four_mixed_areas(&f, &s));
        let [one, other] = diagonals(&f, &s);
        trial.zero("det(1*3*, 24)", other);
        trial.zero("det(13, 2*4*)", one);
        for j in 0..4 {
            let edge = |q: &[TopView<T>; 4]| &q[(j + 1) % 4] - &q[j];
            trial.zero("parallel edges", edge(&f).det(&edge(&s)));
        }
        Ok(())
    }
}

struct Incircle;

impl Identity for Incircle {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let polygon = tangential(trial, 4, OFF_CIRCLE)?;
        let a = trial.free();
        trial.nonzero(NO_POINT, &a)?;
        let f: [_; 4] = std::array::from_fn(|j| polygon[j].centre.clone());
        let start = TopView::new(T::zero(), T::zero());
        let s = trial.defined(OFF_CIRCLE, with_diagonal(&f, &start, &a))?;
        trial.zero("4 area(F, S)", four_mixed_areas(&f, &s));
        // The first edge gives the factor μ.
        let (e, image) = (&f[1] - &f[0], &s[1] - &s[0]);
        let length2 = e.length2();
        trial.parameter("the first edge of F has a length", &length2)?;
        let factor = e.dot(&image) * &polygon[0].radius * &polygon[1].radius;
        let Some(factor) = factor.try_div(&length2) else { return Ok(()) };
        let mut circles = Vec::new();
        for (j, centre) in s.iter().enumerate() {
            let radius = trial.defined(OFF_CIRCLE, factor.try_div(&polygon[j].radius))?;
            circles.push(OrientedCircle { centre: centre.clone(), radius });
        }
        has_incircle(trial, &circles, NO_POINT)
    }
}

/// Goals: the edges between the centres of these circles touch one circle, in the points where the
/// circles touch.
fn has_incircle<T: Field>(
    trial: &mut Trial<T>,
    circles: &[OrientedCircle<T>],
    defined: &'static str,
) -> Run {
    let circles: Vec<_> = circles
        .iter()
        .map(|c| OrientedCircle {
            centre: TopView::new(trial.made(c.centre.x.clone()), trial.made(c.centre.y.clone())),
            radius: trial.made(c.radius.clone()),
        })
        .collect();
    let n = circles.len();
    for (j, circle) in circles.iter().enumerate() {
        let next = &circles[(j + 1) % n];
        trial.zero("touching", circle.tangency(next));
        let number = |r: &T| Point::new(r.clone(), T::zero(), T::zero());
        let ends = [circle, next].map(|c| c.centre.at_height(T::zero()));
        let [p, q] = ends;
        let points = [p, q, number(&circle.radius), number(&next.radius)];
        trial.zero("touching circles", TouchingCircles.eval(&points, &T::one()));
    }
    for j in 3..n {
        let corner = |i: usize| &circles[[0, 1, 2, j][i % 4]];
        let points = std::array::from_fn(|i| match i {
            0..4 => corner(i).centre.at_height(T::zero()),
            _ => Point::new(corner(i).radius.clone(), T::zero(), T::zero()),
        });
        trial.zero("coplanar poles", CoplanarPoles.eval(&points, &T::one()));
    }
    let koebe = koebe_mesh(circles.clone(), one_face(n));
    let koebe = trial.accepted("a face", koebe)?;
    let found = trial.defined(defined, face_circle(&koebe, FaceId(0)).ok().flatten())?;
    trial.show("radius of the incircle", &found.radius);
    for (j, circle) in circles.iter().enumerate() {
        let next = &circles[(j + 1) % n];
        let edge = &next.centre - &circle.centre;
        let distance = edge.det(&(&found.centre - &circle.centre));
        let expected = &found.radius * (&circle.radius + &next.radius);
        trial.equal("distance from an edge", &distance, &expected);
        trial.zero("orthogonal", found.orthogonality(circle));
    }
    Ok(())
}
