//! Sec. 2.1: i-spheres and their sections, surfaces and their curvatures.

use super::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Stop, Trial,
};
use crate::scalar::{Dual as Differential, Field, Rational, Ring};
use crate::space::{
    ContactElement, Gradient, Graph, Hessian, ICircle, IsotropicPlane, Jet2, MoebiusSphere, Motion,
    ParabolicSphere, Plane, Point, Polynomial, Rotation, TopView, Transform, Vector2,
};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-3-sections",
        statement: "A non-isotropic plane cuts an i-sphere of parabolic type in an i-circle, whose \
                    top view is a circle, real or imaginary; an isotropic plane cuts it in a \
                    parabola of the curvature A.",
        formula: "centre (p − (B, C))/A, squared radius (|p − (B, C)|² + 2A(t − D))/A²",
        source: Source::Paper("Sec. 2.1, (3)"),
        hypotheses: &[Hypothesis::stated(CURVED)],
        said: Grade::Certified,
        argument: "Over any top view the height of the plane over the sphere is a multiple of the \
                   power of the circle, so that both vanish together; in an isotropic plane the \
                   heights over sphere and parabola agree.",
        evidence: &[
            Evidence::identity::<Section>("a non-isotropic plane", &[1], &[1]),
            Evidence::identity::<IsotropicSection>("an isotropic plane", &[1], &[1]),
        ],
        controls: &[Control {
            without: CURVED,
            shows: "with A = 0 the planes z = x and z = 0 have a line in common",
            counterexample: Counterexample::Witness(two_planes),
        }],
    },
    Claim {
        id: "eq-6-gauss",
        statement: "The tangent planes of a graph and of Σ at the Gauss image are parallel, and the \
                    shape operator is the derivative of the Gauss map.",
        formula: "σ(x, y, f) = (f_x, f_y, (f_x² + f_y²)/2),  dσ'(v) = ∇²f · v",
        source: Source::Paper("Sec. 2.1, (6), (7)"),
        hypotheses: &[],
        said: Grade::Certified,
        argument: "The image depends on the gradient alone, so polynomials of second order show all \
                   of it. Along a straight line their Gauss map is linear: its derivative is its \
                   difference.",
        evidence: &[Evidence::identity::<Gauss>("graphs of second order", &[2], &[2])],
        controls: &[],
    },
    Claim {
        id: "eq-8-9-curvatures",
        statement: "K is the determinant of the Hessian and 2H its trace; they are the product and \
                    the sum of the i-principal curvatures, whose directions are conjugate and \
                    orthogonal in the top view.",
        formula: "K = κ₁κ₂ = f_xx f_yy − f_xy²,  2H = κ₁ + κ₂ = Δf",
        source: Source::Paper("Sec. 2.1, (8), (9)"),
        hypotheses: &[],
        said: Grade::Certified,
        argument: "A jet of second order says all about H and K. The size is the degree of the \
                   polynomial; its derivatives are compared with those that dual numbers give.",
        evidence: &[
            Evidence::identity::<Derivatives>("jets of polynomials", &[2, 3], &[2, 3, 4]),
            Evidence::identity::<Principal>("principal curvatures", &[1], &[1]),
        ],
        controls: &[],
    },
];

const CURVED: &str = "A != 0";

/// Three common points of the planes `z = x` and `z = 0`, which lie on no i-circle.
fn two_planes() -> Result<String, String> {
    let [zero, one, two] = [0, 1, 2].map(Rational::from_i64);
    let sphere = MoebiusSphere::new(zero.clone(), one.clone(), zero.clone(), zero.clone());
    let points = [&zero, &one, &two].map(|y| Point::new(zero.clone(), y.clone(), zero.clone()));
    let [a, b, c] = &points;
    if !points.iter().all(|p| sphere.contains(p)) {
        return Err("no common points".into());
    }
    match ICircle::through(a, b, c) {
        Ok(circle) => Err(format!("they lie on an i-circle with r² = {}", circle.top_view.radius2)),
        Err(error) => Ok(error.to_string()),
    }
}

fn sphere<T: Field>(trial: &mut Trial<T>) -> Result<ParabolicSphere<T>, Stop> {
    let [a, b, c, d] = [(); 4].map(|()| trial.free());
    trial.nonzero(CURVED, &a)?;
    trial.defined(CURVED, ParabolicSphere::new(a, b, c, d).ok())
}

struct Section;

impl Identity for Section {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let sphere = sphere(trial)?;
        let plane = Plane::new(Gradient::new(trial.free(), trial.free()), trial.free());
        let mut circle = sphere.section(&plane);
        circle.top_view.centre.x = trial.made(circle.top_view.centre.x);
        circle.top_view.centre.y = trial.made(circle.top_view.centre.y);
        circle.top_view.radius2 = trial.made(circle.top_view.radius2);
        trial.show("r²", &circle.top_view.radius2);
        let point = plane.point_at(&TopView::new(trial.free(), trial.free()));
        let [beside, power] = circle.residuals(&point);
        trial.zero("in the plane", beside);
        trial.zero("the sphere over the circle", sphere.residual(&point) + &sphere.a * power);
        trial.zero("the centre", plane.residual(&circle.centre()));
        let radius2 = &circle.top_view.radius2 * sphere.a.square();
        trial.equal("tangent where r = 0", &radius2, &sphere.tangency(&plane));
        Ok(())
    }
}

struct IsotropicSection;

impl Identity for IsotropicSection {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let sphere = sphere(trial)?;
        let origin = TopView::new(trial.free(), trial.free());
        let direction = trial.free_vector2();
        trial.parameter("the plane is not x = const; turned, it is", &direction.x)?;
        trial.parameter("the direction has a length", &direction.length2())?;
        let plane = trial.accepted("no plane", IsotropicPlane::new(origin, direction))?;
        let parabola = sphere.isotropic_section(&plane);
        trial.equal("curvature", parabola.curvature(), &sphere.a);
        let u = trial.free();
        let mut point = plane.top_view_at(&u).at_height(trial.free());
        let [beside, over] = parabola.residuals(&point);
        trial.zero("in the plane", beside);
        trial.equal("over the parabola", &(T::from_i64(2) * over), &sphere.residual(&point));
        point.z = parabola.point_at(&u).z;
        trial.zero("on the sphere", sphere.residual(&point));
        Ok(())
    }
}

/// A polynomial of a degree with all its coefficients, none of them 0.
pub(super) fn polynomial<T: Field>(
    trial: &mut Trial<T>,
    degrees: std::ops::RangeInclusive<u32>,
) -> Result<Polynomial<T>, Stop> {
    let mut terms = Vec::new();
    for degree in degrees {
        for i in 0..=degree {
            let a = trial.free();
            trial.parameter("a coefficient is not 0; those with 0 are limits", &a)?;
            terms.push((i, degree - i, a));
        }
    }
    Ok(Polynomial::new(terms))
}

struct Gauss;

impl Identity for Gauss {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let f = polynomial(trial, 0..=2)?;
        let at = TopView::new(trial.free(), trial.free());
        let jet = trial.accepted("no jet", f.jet(&at).ok_or(()))?;
        let image = trial.made_point(jet.gauss_image());
        let sigma = ParabolicSphere::unit();
        let touching = sigma.tangent_plane(&image.top_view());
        trial.zero("on Σ", sigma.residual(&image));
        trial.zero("parallel planes", touching.i_angle2(&jet.tangent_plane()));
        let slope = &touching.gradient - &jet.contact.gradient;
        trial.zero("parallel planes", slope.x);
        trial.zero("parallel planes", slope.y);
        let v = trial.free_vector2();
        let other = trial.accepted("no jet", f.jet(&(&at + &v)).ok_or(()))?.gauss_image();
        let moved = &image.top_view() + &jet.hessian.apply(&v);
        trial.equal("shape operator", &other.x, &moved.x);
        trial.equal("shape operator", &other.y, &moved.y);
        Ok(())
    }
}

struct Derivatives;

/// A number with its gradient and Hessian.
type Second<T> = Differential<Differential<T, 2>, 2>;

impl Identity for Derivatives {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let f = polynomial(trial, 0..=trial.size() as u32)?;
        let at = TopView::new(trial.free(), trial.free());
        let jet = trial.accepted("no jet", f.jet(&at).ok_or(()))?;
        let variable = |x: &T, i| Second::variable(Differential::variable(x.clone(), i), i);
        let constant = |a: &T| Second::constant(Differential::constant(a.clone()));
        let value = f.substitute(&variable(&at.x, 0), &variable(&at.y, 1), constant);
        let [[xx, xy], [_, yy]] = value.partials.clone().map(|d| d.partials);
        let [x, y] = value.value.partials;
        trial.equal("f", &jet.contact.point.z, &value.value.value);
        trial.equal("f_x", &jet.contact.gradient.x, &x);
        trial.equal("f_y", &jet.contact.gradient.y, &y);
        let (k, h) = (trial.made(jet.curvature()), trial.made(jet.mean_curvature()));
        trial.show("K", &k);
        trial.show("H", &h);
        trial.equal("K", &k, &(&xx * &yy - xy.square()));
        trial.equal("2H", &(T::from_i64(2) * h), &(xx + yy));
        Ok(())
    }
}

struct Principal;

impl Identity for Principal {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let t = trial.free();
        trial.parameter("1 + t² is not 0, as in ordered fields", &(T::one() + t.square()))?;
        let rotation = trial.accepted("no rotation", Rotation::from_parameter(&t))?;
        let kappa = [trial.free(), trial.free()];
        let own = Hessian { xx: kappa[0].clone(), xy: T::zero(), yy: kappa[1].clone() };
        let axes = [Vector2::new(T::one(), T::zero()), Vector2::new(T::zero(), T::one())];
        let axes = axes.map(|axis| rotation.turn(&axis));
        let Hessian { xx, xy, yy } = Motion { rotation, ..Motion::identity() }.apply(&own);
        let hessian = Hessian { xx: trial.made(xx), xy: trial.made(xy), yy: trial.made(yy) };
        for (axis, kappa) in axes.iter().zip(&kappa) {
            let (image, multiple) = (hessian.apply(axis), axis.scaled(kappa));
            trial.equal("an eigenvector", &image.x, &multiple.x);
            trial.equal("an eigenvector", &image.y, &multiple.y);
            trial.zero("a principal direction", hessian.principality(axis));
        }
        let [first, second] = &axes;
        trial.zero("conjugate", hessian.form(first, second));
        trial.zero("orthogonal", first.dot(second));
        let [first, second] = &kappa;
        let contact = ContactElement::new(trial.free_point(), Gradient::new(T::zero(), T::zero()));
        let jet = Jet2 { contact, hessian };
        trial.equal("K", &jet.curvature(), &(first * second));
        trial.equal("2H", &(T::from_i64(2) * jet.mean_curvature()), &(first + second));
        Ok(())
    }
}
