//! Sec. 3.4: the edges and vertices of Koebe meshes.

use std::array;

use super::instance::{circles, contact, free_circle, incircle, with_radii};
use super::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Trial,
};
use crate::check::Residual;
use crate::net::i_isothermic::{CoplanarPoles, TouchingCircles};
use crate::net::scribed::{EdgeTouchesSigma, OnSigma};
use crate::scalar::{Field, Rational, Ring};
use crate::space::{Circle, Dual, OrientedCircle, Plane, Rotation, TopView, Vector2};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "koebe-edge",
        statement: "Two touching circles, with signed radii: the planes that cut Σ over them meet over \
                    their common tangent, in a line that touches Σ over the point of contact; and so \
                    does the line of their poles, along the centres.",
        formula: "height over Σ along the tangent = -|x - t|²/2",
        source: Source::Paper("Sec. 3.4"),
        hypotheses: &[Hypothesis::stated(TOUCHING), Hypothesis::silent(SUM)],
        said: Grade::Certified,
        argument: "",
        evidence: &[Evidence::identity::<TouchingPair>("two circles", &[1], &[1])],
        controls: &[
            Control {
                without: TOUCHING,
                shows: "circles at a distance: the line of the poles misses Σ",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &["0", "0", "1", "1", "0", "1"],
                    constrained: &["3", "0"],
                },
            },
            Control {
                without: SUM,
                shows: "a circle and itself, turned over, have no point of contact",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &["0", "0", "1", "-1", "0", "1"],
                    constrained: &["0", "0"],
                },
            },
        ],
    },
    Claim {
        id: "koebe-vertex",
        statement: "The planes of circles meet in a point v iff their poles are coplanar, that is, iff a \
                    circle orthogonal to all exists; its centre is v', its squared radius |v'|² - 2 v₃. \
                    Circles that touch in a cycle of four have concyclic contacts; that does not suffice.",
        formula: "ρ² = |v'|² - 2 v₃",
        source: Source::Paper("Sec. 3.4"),
        hypotheses: &[Hypothesis::silent(ORTHOGONAL), Hypothesis::silent(NOT_COLLINEAR)],
        said: Grade::Certified,
        argument: "For k circles: three with centres that are not collinear have one orthogonal circle, \
                   and each other one is orthogonal to it iff its plane passes through v. A cycle of four \
                   touching circles arises, up to i-motions, from three radii and two directions: the \
                   fourth radius is then the solution of a linear equation.",
        evidence: &[
            Evidence::identity::<OrthogonalCircle>("four circles", &[1], &[1]),
            Evidence::identity::<CycleOfFour>("a cycle of four", &[1], &[1]),
        ],
        controls: &[
            Control {
                without: ORTHOGONAL,
                shows: "unit circles on a rhombus touch in a cycle",
                counterexample: Counterexample::Witness(rhombus),
            },
            Control {
                without: NOT_COLLINEAR,
                shows: "three circles in a row: their planes are parallel to a line",
                counterexample: Counterexample::Witness(row),
            },
        ],
    },
];

const TOUCHING: &str = "the circles touch, with their signs";
const SUM: &str = "r₁ + r₂ != 0";
const ORTHOGONAL: &str = "a circle is orthogonal to all";
const NOT_COLLINEAR: &str = "the centres are not collinear";

struct TouchingPair;

impl Identity for TouchingPair {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let first = free_circle(trial);
        let (radius, parameter, along) = (trial.free(), trial.free(), trial.free());
        let ray = trial.accepted("a direction", Rotation::from_parameter(&parameter))?;
        let distance = &first.radius + &radius;
        trial.nonzero(SUM, &distance)?;
        let between = Vector2::new(ray.cos() * &distance, ray.sin() * &distance);
        let centre = trial.constrained_vector2((&first.centre + &between).position());
        let second = OrientedCircle { centre: TopView::new(centre.x, centre.y), radius };
        trial.relation(TOUCHING, first.tangency(&second))?;
        let residual = TouchingCircles.eval(&with_radii(&[&first, &second]), &T::one());
        trial.zero("touching", residual);

        let t = trial.defined(SUM, contact(&first, &second))?;
        let poles = [first.pole(), second.pole()];
        trial.zero("the line of the poles touches Σ", EdgeTouchesSigma.eval(&poles, &T::one()));
        let factor = &first.radius / distance;
        let on_line = |a: &T, b: &T| a + &factor * (b - a);
        let height = on_line(&poles[0].z, &poles[1].z);
        trial.zero("over the contact", OnSigma.eval(&[t.at_height(height)], &T::one()));

        // A point of the common tangent, and the planes there.
        let across = (&second.centre - &first.centre).turned().scaled(&along);
        let at = &t + &across;
        let [a, b] = poles.each_ref().map(|pole| pole.dual().point_at(&at));
        trial.equal("the planes meet over the tangent", &a.z, &b.z);
        let over = OnSigma.eval(array::from_ref(&a), &T::one());
        trial.equal("their line touches Σ", &over, &-across.length2());
        let ends = [a, poles[0].dual().point_at(&t)];
        trial.zero("their line as an edge", EdgeTouchesSigma.eval(&ends, &T::one()));
        Ok(())
    }
}

struct OrthogonalCircle;

impl Identity for OrthogonalCircle {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let circles = [(); 4].map(|()| free_circle(trial));
        let [a, b, c, d] = &circles;
        let det = (&b.centre - &a.centre).det(&(&c.centre - &a.centre));
        trial.nonzero(NOT_COLLINEAR, &det)?;
        let spanned = Plane::through(&a.pole(), &b.pole(), &c.pole());
        let v = trial.defined(NOT_COLLINEAR, spanned.ok())?.dual();
        let v = trial.made_point(v);
        for circle in [a, b, c] {
            trial.zero("in the plane of a circle", circle.pole().dual().residual(&v));
        }
        let radius2 = v.top_view().norm2() - T::from_i64(2) * &v.z;
        let orthogonal = Circle::new(v.top_view(), radius2);
        for circle in [a, b, c] {
            let power = orthogonal.power(&circle.centre);
            trial.equal("orthogonal", &power, &circle.radius.square());
        }
        // For the fourth both miss by the same, and so do the four poles.
        let miss = d.pole().dual().residual(&v);
        let power = orthogonal.power(&d.centre) - d.radius.square();
        trial.equal("the fourth plane", &(T::from_i64(2) * &miss), &power);
        let poles = CoplanarPoles.eval(&with_radii(&[a, b, c, d]), &T::one());
        trial.equal("four poles", &poles, &(power * det));
        let same = OrientedCircle { centre: v.top_view(), radius: T::zero() };
        trial.equal("by the pair", &a.orthogonality(&same), &orthogonal.radius2);
        Ok(())
    }
}

struct CycleOfFour;

impl Identity for CycleOfFour {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let [a, b, d] = [(); 3].map(|()| trial.free());
        let parameters = [trial.free(), trial.free()];
        let mut rays = Vec::new();
        for parameter in &parameters {
            let ray = trial.accepted("a direction", Rotation::from_parameter(parameter))?;
            trial.parameter("a direction", &(T::one() + parameter.square()))?;
            rays.push(Vector2::new(ray.cos().clone(), ray.sin().clone()));
        }
        let ab = &a + &b;
        let second = TopView::new(ab.clone(), T::zero());
        let fourth = TopView::new(T::zero(), T::zero());
        let fourth = &fourth + &rays[0].scaled(&(&a + &d));
        // |second + (b + c) ray - fourth| = c + d is linear in c.
        let from = &(&second - &fourth) + &rays[1].scaled(&b);
        let slope = (from.dot(&rays[1]) - &d) * T::from_i64(2);
        trial.parameter("the fourth circle is no line", &slope)?;
        let c = (d.square() - from.length2()) / slope;
        let third = &second + &rays[1].scaled(&(&b + &c));
        let origin = TopView::new(T::zero(), T::zero());
        let circles = [(origin, a), (second, b), (third, c), (fourth, d)]
            .map(|(centre, radius)| OrientedCircle { centre, radius });
        let mut contacts = Vec::new();
        for j in 0..4 {
            let (one, next) = (&circles[j], &circles[(j + 1) % 4]);
            trial.zero("touching", one.tangency(next));
            trial.parameter("r₁ + r₂ is not 0", &(&one.radius + &next.radius))?;
            let contact = trial.accepted("a contact", contact(one, next).ok_or("none"))?;
            let at = trial.made_vector2(contact.position());
            contacts.push(TopView::new(at.x, at.y));
        }
        let [a, b, c, d] = [0, 1, 2, 3].map(|j| &contacts[j]);
        trial.zero("the contacts are concyclic", incircle([a, b, c, d]));
        Ok(())
    }
}

fn rhombus() -> Result<String, String> {
    let circles = circles([[10, 0, 13], [0, 24, 13], [-10, 0, 13], [0, -24, 13]], 13);
    let touch = (0..4).all(|j| circles[j].tangency(&circles[(j + 1) % 4]).is_zero());
    let poles = CoplanarPoles.eval(&with_radii(&circles.each_ref()), &Rational::one());
    if !touch || poles.is_zero() {
        return Err("a circle is orthogonal to all".into());
    }
    Ok(format!("determinant of the poles: {poles}"))
}

fn row() -> Result<String, String> {
    let [a, b, c] = circles([[0, 0, 1], [2, 0, 1], [6, 0, 3]], 1).map(|circle| circle.pole());
    let plane = Plane::through(&a, &b, &c);
    plane.map_or_else(|error| Ok(error.to_string()), |_| Err("they meet in a point".into()))
}
