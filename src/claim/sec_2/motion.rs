//! Sec. 2.1: i-motions and what they keep.

use super::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Stop, Trial,
};
use crate::check::Residual;
use crate::net::i_circular::Concyclic;
use crate::net::i_conical::{Balance, ConcyclicGradients};
use crate::net::i_isothermic::{CoplanarPoles, CrossRatioProduct, TouchingCircles};
use crate::net::i_minimal::MixedMeasure;
use crate::net::koenigs::DiagonalProduct;
use crate::net::planar::Coplanar;
use crate::pair::{MixedArea, ParallelPlanes};
use crate::scalar::{Field, Rational, Ring};
use crate::space::{
    ContactElement, Gradient, Hessian, Jet2, MoebiusSphere, Motion, Plane, Point, Rotation,
    Scaling, TopView, Transform, Vector2,
};

pub(super) const CLAIMS: &[Claim] = &[Claim {
    id: "eq-1-motions",
    statement: "The i-motions form a group. They keep i-distances and i-angles, parallel points, \
                parallel planes and incidence, H and K of surfaces, and the classes of meshes of \
                isotropic geometry; those that speak of Σ, with Σ moved along.",
    formula: "x' ↦ R x' + (a, b),  z ↦ c + c₁x + c₂y + z",
    source: Source::Paper("Sec. 2.1, (1), (2)"),
    hypotheses: &[Hypothesis::stated(UNIT)],
    said: Grade::Certified,
    argument: "A class of meshes is the set where residuals vanish, and each is a function of few \
               points. That of a vertex of valence n is a difference of two products of n factors, \
               each of which the rotation multiplies by the same number, so what holds for n = 2, 4 \
               holds for all n. The gradients of four planes are those of any triangles in them.",
    evidence: &[
        Evidence::identity::<Group>("products and inverses", &[1], &[1]),
        Evidence::identity::<Invariants>("distances, angles, incidence, spheres", &[1], &[1]),
        Evidence::identity::<Curvatures>("H, K and the graph of second order", &[1], &[1]),
        Evidence::identity::<Classes>("residuals on points", &[4, 2], &[2, 4, 6]),
        Evidence::identity::<Radii>("residuals on circles and on pairs", &[1], &[1]),
        Evidence::identity::<Gradients>("concyclic gradients", &[1], &[1]),
    ],
    controls: &[Control {
        without: UNIT,
        shows: "c = 2, s = 0 stretches distances",
        counterexample: Counterexample::Witness(stretched),
    }],
}];

const UNIT: &str = "c² + s² = 1";

/// With the matrix `2·1` for R.
fn stretched() -> Result<String, String> {
    let [two, zero] = [2, 0].map(Rational::from_i64);
    let refused = Rotation::new(two.clone(), zero.clone());
    let map = Scaling::new(two.clone(), Rational::one()).map_err(|e| e.to_string())?;
    let (p, q) =
        (Point::new(zero.clone(), zero.clone(), zero.clone()), Point::new(two, zero.clone(), zero));
    let change = map.apply(&p).i_distance2(&map.apply(&q)) - p.i_distance2(&q);
    if change.is_zero() || refused.is_ok() {
        return Err("the distance stays".into());
    }
    Ok(format!("squared i-distance: {change}"))
}

/// A rotation by any angle but the half turn; where it is decided, the half turn included.
fn rotation<T: Field>(trial: &mut Trial<T>) -> Result<Rotation<T>, Stop> {
    let t = trial.free();
    let rational = trial.accepted("1 + t² = 0", Rotation::from_parameter(&t))?;
    let c = trial.constrained(rational.cos().clone());
    let s = trial.constrained(rational.sin().clone());
    trial.relation(UNIT, c.square() + s.square() - T::one())?;
    trial.accepted("not a rotation", Rotation::new(c, s))
}

fn motion<T: Field>(trial: &mut Trial<T>) -> Result<Motion<T>, Stop> {
    let rotation = rotation(trial)?;
    let (shear, translation) = (trial.free_vector2(), trial.free_vector3());
    Ok(Motion { rotation, shear, translation })
}

fn plane<T: Field>(trial: &mut Trial<T>) -> Plane<T> {
    Plane::new(Gradient::new(trial.free(), trial.free()), trial.free())
}

struct Group;

impl Identity for Group {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (first, next) = (motion(trial)?, motion(trial)?);
        let p = trial.free_point();
        let both = first.then(&next);
        trial.equal_points("one after the other", &both.apply(&p), &next.apply(&first.apply(&p)));
        let norm = |r: &Rotation<T>| r.cos().square() + r.sin().square();
        trial.equal("a rotation again", &norm(&both.rotation), &norm(&first.rotation));
        let inverse = first.inverse();
        trial.equal_points("there and back", &inverse.apply(&first.apply(&p)), &p);
        trial.equal_points("back and there", &first.apply(&inverse.apply(&p)), &p);
        trial.equal("the inverse rotation", &norm(&inverse.rotation), &T::one());
        trial.equal_points("the identity", &Motion::identity().apply(&p), &p);
        Ok(())
    }
}

struct Invariants;

impl Identity for Invariants {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let motion = motion(trial)?;
        let (p, q) = (trial.free_point(), trial.free_point());
        let (e, f) = (plane(trial), plane(trial));
        let (p1, q1) = (motion.apply(&p), motion.apply(&q));
        let (e1, f1) = (motion.apply(&e), motion.apply(&f));
        trial.equal("i-distance²", &p1.i_distance2(&q1), &p.i_distance2(&q));
        trial.equal("i-angle²", &e1.i_angle2(&f1), &e.i_angle2(&f));
        trial.equal("incidence", &e1.residual(&p1), &e.residual(&p));
        let over = motion.apply(&p.top_view().at_height(q.z.clone())).top_view();
        trial.zero("parallel points", over.distance2(&p1.top_view()));
        let beside = motion.apply(&Plane::new(e.gradient.clone(), f.height.clone()));
        trial.zero("parallel planes", beside.i_angle2(&e1));
        trial.equal_points("vectors", &(&p1 + &motion.apply(&(&q - &p))), &q1);
        let sphere = MoebiusSphere { a: trial.free(), plane: f };
        let image = motion.apply(&sphere);
        trial.equal("points and spheres", &image.residual(&p1), &sphere.residual(&p));
        trial.equal("planes and spheres", &image.tangency(&e1), &sphere.tangency(&e));
        Ok(())
    }
}

struct Curvatures;

/// The height over `at` of the graph of second order with this jet.
fn taylor<T: Field>(jet: &Jet2<T>, at: &TopView<T>) -> T {
    let step = at - &jet.contact.point.top_view();
    let quadratic = jet.hessian.form(&step, &step) * T::from_ratio(1, 2);
    jet.tangent_plane().height_at(at) + quadratic
}

impl Identity for Curvatures {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let motion = motion(trial)?;
        let contact =
            ContactElement::new(trial.free_point(), Gradient::new(trial.free(), trial.free()));
        let hessian = Hessian { xx: trial.free(), xy: trial.free(), yy: trial.free() };
        let jet = Jet2 { contact, hessian };
        let image = motion.apply(&jet);
        trial.equal("H", &image.mean_curvature(), &jet.mean_curvature());
        trial.equal("K", &image.curvature(), &jet.curvature());
        let at = TopView::new(trial.free(), trial.free());
        let moved = motion.apply(&at.at_height(taylor(&jet, &at)));
        trial.equal("the moved graph", &taylor(&image, &moved.top_view()), &moved.z);
        Ok(())
    }
}

struct Classes;

/// The most points that are used here: of a vertex of valence 6.
const MOST: usize = 13;

/// A residual on the first of some points; where it asks for more, it does not look at them.
fn at<T: Ring, const K: usize>(residual: impl Residual<K>, points: &[Point<T>]) -> T {
    let point = |i: usize| points[i % points.len()].clone();
    residual.eval(&std::array::from_fn(point), &T::one())
}

impl Identity for Classes {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let valence = trial.size();
        let motion = motion(trial)?;
        let points: Vec<Point<T>> = (0..1 + 2 * valence).map(|_| trial.free_point()).collect();
        let moved: Vec<Point<T>> = points.iter().map(|p| motion.apply(p)).collect();
        let mut kept = |what, of: &dyn Fn(&[Point<T>]) -> T| {
            trial.equal(what, &of(&moved), &of(&points));
        };
        kept("Koenigs", &|p| at::<T, MOST>(DiagonalProduct { valence }, p));
        kept("i-minimal", &|p| at::<T, MOST>(MixedMeasure::<false> { valence }, p));
        kept("planar, asymptotic", &|p| at(Coplanar, p));
        kept("i-circular", &|p| at(Concyclic, p));
        kept("i-conical", &|p| at(Balance, p));
        // A product of complex numbers, one for each face, turns as often.
        let product = |p: &[Point<T>]| {
            let [x, y] =
                [true, false].map(|real| at::<T, MOST>(CrossRatioProduct { valence, real }, p));
            Vector2::new(x, y)
        };
        let often = (1..valence).fold(motion.rotation.clone(), |r, _| r.then(&motion.rotation));
        let (expected, found) = (often.turn(&product(&points)), product(&moved));
        trial.equal("i-isothermic of circular type", &found.x, &expected.x);
        trial.equal("i-isothermic of circular type", &found.y, &expected.y);
        Ok(())
    }
}

struct Radii;

impl Identity for Radii {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let motion = motion(trial)?;
        let centres: [Point<T>; 4] = std::array::from_fn(|_| trial.free_point());
        let zero = T::zero;
        let radii: [Point<T>; 4] =
            std::array::from_fn(|_| Point::new(trial.free(), zero(), zero()));
        let moved = centres.each_ref().map(|p| motion.apply(p));
        let with_radii = |p: &[Point<T>; 4]| [p.as_slice(), radii.as_slice()].concat();
        let (before, after) = (with_radii(&centres), with_radii(&moved));
        let poles = |p| at(CoplanarPoles, p);
        trial.equal("coplanar poles", &poles(&after), &poles(&before));
        let touching = |p: &[Point<T>]| at(TouchingCircles, &[&p[..2], &p[4..6]].concat());
        trial.equal("touching circles", &touching(&after), &touching(&before));
        let points: Vec<Point<T>> = (0..6).map(|_| trial.free_point()).collect();
        let moved: Vec<Point<T>> = points.iter().map(|p| motion.apply(p)).collect();
        trial.equal("parallel planes", &at(ParallelPlanes, &moved), &at(ParallelPlanes, &points));
        trial.equal("mixed areas", &at(MixedArea, &moved), &at(MixedArea, &points));
        Ok(())
    }
}

struct Gradients;

impl Identity for Gradients {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let motion = motion(trial)?;
        let corners = [(0, 0), (1, 0), (0, 1)];
        let [x, y, z] = corners.map(|(x, y)| TopView::new(T::from_i64(x), T::from_i64(y)));
        let planes: [Plane<T>; 4] = std::array::from_fn(|_| plane(trial));
        let points: Vec<Point<T>> =
            planes.iter().flat_map(|e| [&x, &y, &z].map(|at| e.point_at(at))).collect();
        let moved: Vec<Point<T>> = points.iter().map(|p| motion.apply(p)).collect();
        let [before, after] = [points, moved].map(|p| at(ConcyclicGradients, &p));
        trial.equal("i-conical", &after, &before);
        Ok(())
    }
}
