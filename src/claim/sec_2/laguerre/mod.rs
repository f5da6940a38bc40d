//! Sec. 2.2: oriented spheres and cones, and their isotropic model.

use super::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Stop, Trial,
};
use crate::scalar::{Field, Rational, Ring};
use crate::space::laguerre::{Cone, OrientedPlane, OrientedSphere};
use crate::space::{Circle, Gradient, ICircle, MoebiusSphere, Plane, Point, TopView, Vector3};

pub(super) mod group;

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-12-spheres",
        statement: "An oriented plane touches an oriented sphere iff its point lies on the i-M-sphere \
                    of the sphere. Every i-M-sphere is that of exactly one oriented sphere, Σ that of \
                    the centre (0, 0, 1/2) and the radius 1/2.",
        formula: "(A, B, C, D) = (r + m₃, −m₁, −m₂, (r − m₃)/2)",
        source: Source::Paper("Sec. 2.2, (12)"),
        hypotheses: &[Hypothesis::stated(NORMAL), Hypothesis::silent(SOUTH)],
        said: Grade::Certified,
        argument: "The point of a plane lies over the i-M-sphere by 2/(1 + n₃) times the distance by \
                   which the plane misses the sphere.",
        evidence: &[
            Evidence::identity::<Spheres>("planes and spheres", &[1], &[1]),
            Evidence::identity::<Bijection>("spheres and i-M-spheres", &[1], &[1]),
        ],
        controls: &[
            Control {
                without: NORMAL,
                shows: "the normal (1, 1, 0) is too long",
                counterexample: Counterexample::Witness(long_normal),
            },
            Control {
                without: SOUTH,
                shows: "the floor seen from below has no point",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &["1", "1"],
                    constrained: &["0", "0", "-1"],
                },
            },
        ],
    },
    Claim {
        id: "eq-12-cones",
        statement: "The points of an i-M-circle are the tangent planes of an oriented cone of \
                    revolution. Its vertex is finite iff the circle is not the image of a great \
                    circle; otherwise the planes envelop a cylinder.",
        formula: "g₃ = −2t/(1 + N), g' = g₃c − p, s = (2c, 1 − N)/(1 + N), N = |c|² − ρ²",
        source: Source::Paper("Sec. 2.2, (12)"),
        hypotheses: &[Hypothesis::silent(GREAT)],
        said: Grade::Certified,
        argument: "The two residuals of a plane at the cone are combinations of the two of its point \
                   at the i-circle, with an invertible matrix. The normals of the planes lie in the \
                   plane 2c·n' + (1 − N)n₃ = 1 + N, which contains the centre of the sphere iff \
                   1 + N = 0. Other i-M-circles, as common points of two i-M-spheres, are the common \
                   planes of two spheres.",
        evidence: &[
            Evidence::identity::<Cones>("elliptic i-circles", &[1], &[1]),
            Evidence::identity::<GreatCircle>("normals in a plane", &[1], &[1]),
            Evidence::identity::<TwoSpheres>("two i-M-spheres", &[1], &[1]),
        ],
        controls: &[Control {
            without: GREAT,
            shows: "the unit circle at the height 0 stands for a vertical cylinder",
            counterexample: Counterexample::Unknowns {
                evidence: 0,
                size: 1,
                unknowns: &["0", "0", "0", "0", "0", "1", "2", "3"],
                constrained: &[],
            },
        }],
    },
];

const NORMAL: &str = "n·n = 1";

const SOUTH: &str = "n₃ != −1";

const GREAT: &str = "1 + N != 0: the i-circle is not the image of a great circle";

/// What ordered fields have.
const DEFINITE: &str = "1 + |x'|² is not 0, as in ordered fields";

/// The plane `x + y = 0` with the normal (1, 1, 0), as if that had length 1, and a sphere.
fn long_normal() -> Result<String, String> {
    let [zero, one] = [0, 1].map(Rational::from_i64);
    let normal = Vector3::new(one.clone(), one.clone(), zero.clone());
    let refused = OrientedPlane::new(normal.clone(), zero.clone());
    let distance = &normal.x + &normal.y - &one;
    let sphere =
        OrientedSphere::new(Point::new(one.clone(), one.clone(), zero.clone()), one.clone());
    let over = MoebiusSphere::from(&sphere).residual(&Point::new(normal.x, normal.y, zero));
    let missed = over - Rational::from_i64(2) * distance;
    if refused.is_ok() || missed.is_zero() {
        return Err("nothing breaks".into());
    }
    Ok(format!("height over the i-M-sphere and distance differ by {missed}"))
}

fn top_view<T: Field>(trial: &mut Trial<T>) -> TopView<T> {
    TopView::new(trial.free(), trial.free())
}

fn free_sphere<T: Field>(trial: &mut Trial<T>) -> OrientedSphere<T> {
    OrientedSphere::new(trial.free_point(), trial.free())
}

/// The plane of a point of the isotropic model, which may be any but those with n₃ = −1.
fn plane_of<T: Field>(trial: &mut Trial<T>, p: &Point<T>) -> Result<OrientedPlane<T>, Stop> {
    trial.parameter(DEFINITE, &(T::one() + p.top_view().norm2()))?;
    Ok(OrientedPlane::of_isotropic(p))
}

struct Spheres;

impl Identity for Spheres {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let at = top_view(trial).at_height(T::zero());
        let Vector3 { x, y, z } = plane_of(trial, &at)?.normal().clone();
        let normal = Vector3::new(trial.constrained(x), trial.constrained(y), trial.constrained(z));
        trial.relation(NORMAL, normal.length2() - T::one())?;
        let scale = T::one() + &normal.z;
        let height = trial.free();
        let plane = trial.accepted("no unit normal", OrientedPlane::new(normal, height))?;
        trial.nonzero(SOUTH, &scale)?;
        let point = trial.defined(SOUTH, plane.to_isotropic().ok())?;
        let point = trial.made_point(point);
        let sphere = free_sphere(trial);
        let over = MoebiusSphere::from(&sphere).residual(&point) * &scale;
        trial.equal("tangency", &over, &(T::from_i64(2) * sphere.tangency(&plane)));
        let back = plane_of(trial, &point)?;
        trial.equal("the inverse of (12)", &back.normal().x, &plane.normal().x);
        trial.equal("the inverse of (12)", &back.normal().y, &plane.normal().y);
        trial.equal("the inverse of (12)", &back.normal().z, &plane.normal().z);
        trial.equal("the inverse of (12)", back.height(), plane.height());
        trial.equal("a unit normal", &back.normal().length2(), &T::one());
        Ok(())
    }
}

struct Bijection;

impl Identity for Bijection {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let sphere = free_sphere(trial);
        let back = OrientedSphere::from(&MoebiusSphere::from(&sphere));
        trial.equal_points("the centre again", &back.centre, &sphere.centre);
        trial.equal("the radius again", &back.radius, &sphere.radius);
        let isotropic = MoebiusSphere::from([(); 4].map(|()| trial.free()));
        let back = MoebiusSphere::from(&OrientedSphere::from(&isotropic));
        for (a, b) in back.coefficients().iter().zip(&isotropic.coefficients()) {
            trial.equal("the i-M-sphere again", a, b);
        }
        let half = T::from_ratio(1, 2);
        let ball = OrientedSphere::new(Point::new(T::zero(), T::zero(), half.clone()), half);
        let sigma = [T::one(), T::zero(), T::zero(), T::zero()];
        for (a, b) in MoebiusSphere::from(&ball).coefficients().iter().zip(&sigma) {
            trial.equal("Σ", a, b);
        }
        let p = trial.free_point();
        let touching = ball.tangency(&plane_of(trial, &p)?);
        let twice = (T::one() + p.top_view().norm2()) * touching;
        trial.equal("Σ", &twice, &MoebiusSphere::from(sigma).residual(&p));
        Ok(())
    }
}

fn circle<T: Field>(trial: &mut Trial<T>) -> ICircle<T> {
    let plane = Plane::new(Gradient::new(trial.free(), trial.free()), trial.free());
    ICircle { plane, top_view: Circle::new(top_view(trial), trial.free()) }
}

fn power_of_origin<T: Field>(circle: &ICircle<T>) -> T {
    circle.top_view.power(&TopView::new(T::zero(), T::zero()))
}

fn made<T: Field>(trial: &mut Trial<T>, cone: Cone<T>) -> Cone<T> {
    let Cone { vertex, axis: Vector3 { x, y, z } } = cone;
    let vertex = trial.made_point(vertex);
    Cone { vertex, axis: Vector3::new(trial.made(x), trial.made(y), trial.made(z)) }
}

struct Cones;

impl Identity for Cones {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let circle = circle(trial);
        let scale = T::one() + power_of_origin(&circle);
        trial.nonzero(GREAT, &scale)?;
        let cone = trial.defined(GREAT, Cone::of_isotropic(&circle).ok())?;
        let cone = made(trial, cone);
        let point = top_view(trial).at_height(trial.free());
        let plane = plane_of(trial, &point)?;
        let [beside, power] = circle.residuals(&point);
        let [distance, turned] = cone.tangency(&plane);
        let (two, larger) = (T::from_i64(2), T::one() + point.top_view().norm2());
        trial.equal(
            "through the vertex",
            &(distance * &larger),
            &(&two * beside - &cone.vertex.z * &power),
        );
        trial.zero("at an angle to the axis", turned * &larger * &scale + two * power);
        // s₃ + 1 = 2/(1 + N)
        let back = trial.accepted("the vertical plane", cone.to_isotropic())?;
        trial.equal("the plane again", &back.plane.gradient.x, &circle.plane.gradient.x);
        trial.equal("the plane again", &back.plane.gradient.y, &circle.plane.gradient.y);
        trial.equal("the plane again", &back.plane.height, &circle.plane.height);
        trial.equal("the centre again", &back.top_view.centre.x, &circle.top_view.centre.x);
        trial.equal("the centre again", &back.top_view.centre.y, &circle.top_view.centre.y);
        trial.equal("the radius again", &back.top_view.radius2, &circle.top_view.radius2);
        Ok(())
    }
}

struct GreatCircle;

impl Identity for GreatCircle {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let circle = circle(trial);
        let point = trial.free_point();
        let plane = plane_of(trial, &point)?;
        let n = trial.made(power_of_origin(&circle));
        let (normal, centre) = (plane.normal(), &circle.top_view.centre);
        let along = centre.position().dot(&normal.top_view()) * T::from_i64(2);
        let beside = along + (T::one() - &n) * &normal.z - T::one() - &n;
        let larger = T::one() + point.top_view().norm2();
        let power = circle.top_view.power(&point.top_view());
        trial.zero("normals in a plane", beside * larger + T::from_i64(2) * power);
        Ok(())
    }
}

struct TwoSpheres;

impl Identity for TwoSpheres {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let spheres = [(); 2].map(|()| MoebiusSphere::from([(); 4].map(|()| trial.free())));
        let [first, second] = spheres.each_ref().map(OrientedSphere::from);
        let apart = &second.radius - &first.radius;
        trial.parameter("the spheres do not envelop a cylinder", &apart)?;
        let scale = trial.accepted("a cylinder", apart.try_inv().ok_or(()))?;
        // The point of the line of spheres that has radius 0.
        let (s, t) = (&second.radius * &scale, &first.radius * &scale);
        let [m, n] = [&first.centre, &second.centre];
        let between = |a: &T, b: &T| a * &s - b * &t;
        let vertex = Point::new(between(&m.x, &n.x), between(&m.y, &n.y), between(&m.z, &n.z));
        let vertex = trial.made_point(vertex);
        let point = trial.free_point();
        let distance = plane_of(trial, &point)?.distance(&vertex);
        let larger = T::one() + point.top_view().norm2();
        let [over, under] = spheres.each_ref().map(|sphere| sphere.residual(&point));
        trial.equal(
            "common planes pass through the vertex",
            &(distance * larger),
            &between(&over, &under),
        );
        Ok(())
    }
}
