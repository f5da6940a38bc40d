//! Sec. 4: Minkowski's inequality, and why curvatures of convex faces are real.

use std::cmp::Ordering;

use super::curvature::AREA;
use super::{
    Claim, Control, Counterexample, Evidence, Experiment, Grade, Hypothesis, Identity, Run, Source,
    Stop, Trial,
};
use crate::pair::Forms;
use crate::scalar::{Field, Ordered, Rational, RationalField, Ring, Sign};
use crate::space::{TopView, Vector2};

pub(super) const CLAIMS: &[Claim] = &[Claim {
    id: "minkowski",
    statement: "Faces that are convex have principal curvatures.",
    formula: "H² - K >= 0;\nquads: (area(F,S)² - area(F) area(S)) · 4 D12 D34 = det(d, d*)² D23 D41, \
                  Dij = det of consecutive edges of F, d and d* corresponding diagonals",
    source: Source::Paper("Sec. 4, after (17)"),
    hypotheses: &[
        Hypothesis::stated(PARALLEL_EDGES),
        Hypothesis::stated(CONVEX),
        Hypothesis::silent(AREA),
    ],
    said: Grade::Certified,
    argument: "For quads the sign is read off from the formula: all Dij of a convex face have the same \
                   sign. If exactly one corner is reflex, D12 D23 D34 D41 < 0 and H² < K unless S is homothetic to F. \
                   For more corners it is Minkowski's inequality for mixed areas; instances here.",
    evidence: &[
        Evidence::identity::<QuadDiscriminant>("the discriminant of a quad, exactly", &[1], &[1]),
        Evidence::experiment::<ConvexDiscriminant>(
            "H² - K of convex polygons, sums of triangles",
            &[1, 2, 3],
        ),
    ],
    controls: &[
        Control {
            without: PARALLEL_EDGES,
            shows: "a square and the same square after a quarter turn",
            counterexample: Counterexample::Witness(not_parallel),
        },
        Control {
            without: CONVEX,
            shows: "a face with one reflex corner",
            counterexample: Counterexample::Witness(dart),
        },
        Control {
            without: AREA,
            shows: "a bow-tie of area 0 has no curvatures",
            counterexample: Counterexample::Unknowns {
                evidence: 0,
                size: 1,
                constrained: &[],
                unknowns: &["0", "0", "1", "1", "1", "0", "0", "1"],
            },
        },
    ],
}];

const PARALLEL_EDGES: &str = "corresponding edges of F and S are parallel";
const CONVEX: &str = "F is convex, or some combination of F and S is";

/// The quad with parallel edges `λ₄eᵢ`, but for a part `μe₃` of the third edge that the first two
/// make good; `None` where these are parallel.
fn parallel_quad<T: Field>(
    edges: &[Vector2<T>; 4],
    [fourth, more]: &[T; 2],
    start: TopView<T>,
) -> Option<[TopView<T>; 4]> {
    let [e1, e2, e3, _] = edges;
    let corner = e1.det(e2).try_inv()?;
    let first = fourth - more * (e3.det(e2) * &corner);
    let second = fourth - more * (e1.det(e3) * &corner);
    let s1 = &start + &e1.scaled(&first);
    let s2 = &s1 + &e2.scaled(&second);
    let s3 = &s2 + &e3.scaled(&(fourth + more));
    Some([start, s1, s2, s3])
}

fn edges<T: Ring>(quad: &[TopView<T>; 4]) -> [Vector2<T>; 4] {
    std::array::from_fn(|i| &quad[(i + 1) % 4] - &quad[i])
}

struct QuadDiscriminant;

impl Identity for QuadDiscriminant {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let f = [(); 4].map(|()| TopView::new(trial.free(), trial.free()));
        let edges = edges(&f);
        let dets: [T; 4] = std::array::from_fn(|i| edges[i].det(&edges[(i + 1) % 4]));
        trial.parameter("the first corner is not straight", &dets[0])?;
        let (factors, start) = ([trial.free(), trial.free()], trial.free_vector2());
        let start = TopView::new(start.x, start.y);
        let Some(s) = parallel_quad(&edges, &factors, start) else {
            return Err(Stop::Excluded("the first corner is not straight"));
        };
        let s = s.map(|v| TopView::new(trial.made(v.x), trial.made(v.y)));
        let forms = Forms::of(&f, &s);
        trial.nonzero(AREA, &forms.first)?;
        let curvatures = trial.defined(AREA, forms.at_face())?;
        let discriminant = curvatures.discriminant();
        trial.show("H² - K", &discriminant);
        trial.equal(
            "H² - K from the areas",
            &(&discriminant * forms.first.square()),
            &forms.discriminant(),
        );
        let diagonals = (&f[2] - &f[0]).det(&(&s[2] - &s[0]));
        let [d12, d23, d34, d41] = dets;
        let expected = T::from_i64(4) * diagonals.square() * d23 * d41;
        trial.equal("the discriminant", &(forms.discriminant() * d12 * d34), &expected);
        Ok(())
    }
}

/// Directions in counter-clockwise order, from that of the x-axis; of vectors other than 0.
fn by_angle<T: Ordered>(a: &Vector2<T>, b: &Vector2<T>) -> Ordering {
    let below = |v: &Vector2<T>| match (v.y.certain_sign(), v.x.certain_sign()) {
        (Some(Sign::Zero), x) => x == Some(Sign::Negative),
        (y, _) => y == Some(Sign::Negative),
    };
    let turn = match b.det(a).certain_sign() {
        Some(Sign::Negative) => Ordering::Less,
        Some(Sign::Positive) => Ordering::Greater,
        _ => Ordering::Equal,
    };
    below(a).cmp(&below(b)).then(turn)
}

struct ConvexDiscriminant;

impl Experiment for ConvexDiscriminant {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        // The edges of triangles, in the order of their directions, are those of a convex polygon.
        let mut edges = Vec::new();
        for _ in 0..trial.size() {
            let (u, v, factor) = (trial.free_vector2(), trial.free_vector2(), trial.free());
            let w = -&(&u + &v);
            edges.extend([u, v, w].map(|edge| (edge, factor.clone())));
        }
        // Zero has no direction.
        edges.retain(|(edge, _)| !edge.length2().is_zero());
        edges.sort_by(|a, b| by_angle(&a.0, &b.0));
        let origin = TopView::new(T::zero(), T::zero());
        let (mut f, mut s) = (vec![origin.clone()], vec![origin]);
        for (edge, factor) in edges.iter().skip(1) {
            f.push(&f[f.len() - 1] + edge);
            s.push(&s[s.len() - 1] + &edge.scaled(factor));
        }
        let forms = Forms::of(&f, &s);
        trial.nonzero(AREA, &forms.first)?;
        let curvatures = trial.defined(AREA, forms.at_face())?;
        let discriminant = curvatures.discriminant();
        let negative = discriminant.certain_sign() == Some(Sign::Negative);
        trial.zero("the negative part of H² - K", if negative { discriminant } else { T::zero() });
        Ok(())
    }
}

fn square() -> [TopView<Rational>; 4] {
    [(0, 0), (1, 0), (1, 1), (0, 1)].map(corner)
}

fn corner((x, y): (i64, i64)) -> TopView<Rational> {
    TopView::new(Rational::from_i64(x), Rational::from_i64(y))
}

/// Says that `H² < K`, if it is so.
fn negative(f: &[TopView<Rational>], s: &[TopView<Rational>]) -> Result<String, String> {
    let curvatures = Forms::of(f, s).at_face().ok_or("area(F) = 0")?;
    let discriminant = curvatures.discriminant();
    match discriminant.certain_sign() {
        Some(Sign::Negative) => Ok(format!("H² - K = {discriminant}")),
        _ => Err(format!("H² - K = {discriminant} is not negative")),
    }
}

fn not_parallel() -> Result<String, String> {
    let f = square();
    let s = [1, 2, 3, 0].map(|i: usize| f[i].clone());
    negative(&f, &s)
}

fn dart() -> Result<String, String> {
    let f = [(0, 0), (4, 0), (1, 1), (0, 4)].map(corner);
    let factors = [Rational::zero(), Rational::one()];
    let s = parallel_quad(&edges(&f), &factors, corner((0, 0))).ok_or("a straight corner")?;
    negative(&f, &s)
}
