//! Sec. 2.1: metric duality, of points and planes and of surfaces.

use super::space::polynomial;
use super::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Stop, Trial,
};
use crate::scalar::{Field, Rational, Ring};
use crate::space::{
    ContactElement, Dual, Gradient, Graph, Hessian, Jet2, ParabolicSphere, ParametricSurface,
    Plane, Polynomial, TopView,
};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "duality-involution",
        statement: "The metric dual of the dual is the object itself: for points and non-isotropic \
                    planes, top views and gradients, contact elements and i-spheres.",
        formula: "(p₁, p₂, p₃)* : z = p₁x + p₂y − p₃",
        source: Source::Paper("Sec. 2.1, metric duality"),
        hypotheses: &[],
        said: Grade::Certified,
        argument: "",
        evidence: &[Evidence::identity::<Involution>("twice dual", &[1], &[1])],
        controls: &[],
    },
    Claim {
        id: "duality-incidence",
        statement: "Duality reverses inclusions: a point lies on a non-isotropic plane iff the pole \
                    of the plane lies on the polar plane of the point.",
        formula: "p ∈ P ⇔ P* ∈ p*",
        source: Source::Paper("Sec. 2.1, metric duality"),
        hypotheses: &[],
        said: Grade::Certified,
        argument: "The point lies over the plane by as much as the pole over the polar plane. What \
                   is dual to a line follows: the points of two planes are the planes of two points.",
        evidence: &[Evidence::identity::<Incidence>("heights over planes", &[1], &[1])],
        controls: &[],
    },
    Claim {
        id: "duality-metric",
        statement: "The i-distance of points is the i-angle of their polar planes, and conversely.",
        formula: "|p − q|ᵢ² = ∠ᵢ(p*, q*)²",
        source: Source::Paper("Sec. 2.1, metric duality"),
        hypotheses: &[],
        said: Grade::Certified,
        argument: "",
        evidence: &[Evidence::identity::<Metric>("squares of both", &[1], &[1])],
        controls: &[],
    },
    Claim {
        id: "duality-parallel",
        statement: "Points are parallel iff their polar planes are.",
        formula: "p' = q' ⇔ ∇p* = ∇q*",
        source: Source::Paper("Sec. 2.1, metric duality"),
        hypotheses: &[],
        said: Grade::Certified,
        argument: "The difference of the gradients is that of the top views, so they vanish together.",
        evidence: &[Evidence::identity::<Parallelism>("differences", &[1], &[1])],
        controls: &[],
    },
    Claim {
        id: "duality-sigma",
        statement: "A non-isotropic plane touches Σ iff its pole lies on Σ; it touches in the pole. \
                    The plane cuts Σ in an i-circle around the point over its pole.",
        formula: "|p|² + 2t = 0 ⇔ P* ∈ Σ",
        source: Source::Paper("Sec. 2.1, 3.2"),
        hypotheses: &[],
        said: Grade::Certified,
        argument: "The tangency is, but for the sign, the height of the pole over Σ.",
        evidence: &[Evidence::identity::<AtSigma>("poles and contact", &[1], &[1])],
        controls: &[],
    },
    Claim {
        id: "eq-10-dual-surface",
        statement: "The poles of the tangent planes of a graph make up the surface (10), and where it \
                    is regular the poles of its tangent planes are the points of the graph.",
        formula: "(x, y, f)* = (f_x, f_y, x f_x + y f_y − f)",
        source: Source::Paper("Sec. 2.1, (10)"),
        hypotheses: &[Hypothesis::stated(REGULAR)],
        said: Grade::Certified,
        argument: "A tangent plane depends on first derivatives, and that of the dual surface on \
                   second ones: polynomials have any of these at a point. The size is the degree.",
        evidence: &[
            Evidence::identity::<Poles>("poles of tangent planes", &[2, 3], &[2, 3, 4]),
            Evidence::identity::<DoubleDual>("the dual of the dual", &[2, 3], &[2, 3]),
        ],
        controls: &[Control {
            without: REGULAR,
            shows: "the dual of a parabolic cylinder is a curve",
            counterexample: Counterexample::Witness(cylinder),
        }],
    },
    Claim {
        id: "eq-11-curvatures",
        statement: "The curvatures of the dual surface are H/K and 1/K. The dual of an i-minimal \
                    surface is i-minimal.",
        formula: "H* = H/K,  K* = 1/K",
        source: Source::Paper("Sec. 2.1, (11)"),
        hypotheses: &[Hypothesis::stated(REGULAR)],
        said: Grade::Certified,
        argument: "The curvatures of the dual surface at a point depend on derivatives of f up to the \
                   third there, and polynomials of degree 3 have any of these. H* vanishes with H.",
        evidence: &[
            Evidence::identity::<DualCurvatures>("the surface (10)", &[3], &[2, 3]),
            Evidence::identity::<DualJet>("the dual jet", &[1], &[1]),
        ],
        controls: &[Control {
            without: REGULAR,
            shows: "the dual of a parabolic cylinder is a curve",
            counterexample: Counterexample::Witness(cylinder),
        }],
    },
];

const REGULAR: &str = "K != 0";

/// `z = x²/2` over the origin.
fn cylinder() -> Result<String, String> {
    let f = Polynomial::new([(2, 0, Rational::from_ratio(1, 2))]);
    let at = TopView::new(Rational::zero(), Rational::zero());
    let curvature = f.jet(&at).ok_or("no jet")?.curvature();
    match ParametricSurface::dual_of(&f).jet(&at) {
        Some(jet) => Err(format!("the dual is regular, K* = {}", jet.curvature())),
        None => Ok(format!("no tangent plane of the dual, where K = {curvature}")),
    }
}

fn plane<T: Field>(trial: &mut Trial<T>) -> Plane<T> {
    Plane::new(Gradient::new(trial.free(), trial.free()), trial.free())
}

fn equal_planes<T: Field>(trial: &mut Trial<T>, what: &'static str, e: &Plane<T>, f: &Plane<T>) {
    trial.equal(what, &e.gradient.x, &f.gradient.x);
    trial.equal(what, &e.gradient.y, &f.gradient.y);
    trial.equal(what, &e.height, &f.height);
}

/// A polynomial f of the degree that is the size, with the jet of its graph somewhere.
fn graph<T: Field>(trial: &mut Trial<T>) -> Result<(Polynomial<T>, Jet2<T>), Stop> {
    let f = polynomial(trial, 0..=trial.size() as u32)?;
    let at = TopView::new(trial.free(), trial.free());
    let jet = trial.accepted("no jet", f.jet(&at).ok_or(()))?;
    Ok((f, jet))
}

struct Involution;

impl Identity for Involution {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let p = trial.free_point();
        let polar = p.dual();
        let (x, y, t) = (polar.gradient.x, polar.gradient.y, polar.height);
        let polar = Plane::new(Gradient::new(trial.made(x), trial.made(y)), trial.made(t));
        equal_planes(
            trial,
            "the polar plane",
            &polar,
            &Plane::new(Gradient::new(p.x.clone(), p.y.clone()), -&p.z),
        );
        trial.equal_points("point", &polar.dual(), &p);
        let e = plane(trial);
        let pole = trial.made_point(e.dual());
        equal_planes(trial, "plane", &pole.dual(), &e);
        let (back, there) = (p.top_view().dual().dual(), e.gradient.dual().dual());
        trial.zero("top view", back.distance2(&p.top_view()));
        trial.zero("gradient", there.i_angle2(&e.gradient));
        let element = ContactElement::new(p, e.gradient);
        let twice = element.dual().dual();
        trial.equal_points("contact element", &twice.point, &element.point);
        equal_planes(trial, "contact element", &twice.plane(), &element.plane());
        let [a, b, c, d] = [(); 4].map(|()| trial.free());
        trial.parameter("the i-sphere is no plane", &a)?;
        let sphere = trial.accepted("a plane", ParabolicSphere::new(a, b, c, d))?;
        let twice = sphere.dual().dual();
        trial.equal("i-sphere", &twice.a, &sphere.a);
        equal_planes(trial, "i-sphere", &twice.plane, &sphere.plane);
        Ok(())
    }
}

struct Incidence;

impl Identity for Incidence {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (p, e) = (trial.free_point(), plane(trial));
        let pole = trial.made_point(e.dual());
        trial.equal("heights over planes", &p.dual().residual(&pole), &e.residual(&p));
        let element = ContactElement::new(p, e.gradient);
        let dual = element.dual();
        trial.zero("the dual of a contact element", dual.plane().residual(&element.plane().dual()));
        equal_planes(trial, "the plane of the point", &dual.plane(), &element.point.dual());
        // A plane touches an i-sphere iff its pole lies on the dual sphere.
        let [a, b, c, d] = [(); 4].map(|()| trial.free());
        trial.parameter("the i-sphere is no plane", &a)?;
        let sphere = trial.accepted("a plane", ParabolicSphere::new(a, b, c, d))?;
        let on_dual = sphere.dual().residual(&pole) * &sphere.a;
        trial.zero(
            "tangent planes",
            on_dual + sphere.tangency(&Plane::new(pole.top_view().dual(), -pole.z)),
        );
        Ok(())
    }
}

struct Metric;

impl Identity for Metric {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (p, q) = (trial.free_point(), trial.free_point());
        let distance2 = trial.made(p.i_distance2(&q));
        trial.show("d²", &distance2);
        trial.equal("points", &p.dual().i_angle2(&q.dual()), &distance2);
        let (e, f) = (plane(trial), plane(trial));
        let angle2 = trial.made(e.i_angle2(&f));
        trial.equal("planes", &e.dual().i_distance2(&f.dual()), &angle2);
        Ok(())
    }
}

struct Parallelism;

impl Identity for Parallelism {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (p, q) = (trial.free_point(), trial.free_point());
        let turned = &p.dual().gradient - &q.dual().gradient;
        let (turned, apart) = (trial.made_vector2(turned), &p.top_view() - &q.top_view());
        trial.equal("gradients", &turned.x, &apart.x);
        trial.equal("gradients", &turned.y, &apart.y);
        let (e, f) = (plane(trial), plane(trial));
        let apart = trial.made_vector2(&e.dual().top_view() - &f.dual().top_view());
        let turned = &e.gradient - &f.gradient;
        trial.equal("top views", &apart.x, &turned.x);
        trial.equal("top views", &apart.y, &turned.y);
        let over = p.top_view().at_height(q.z);
        trial.zero("parallel points", over.dual().i_angle2(&p.dual()));
        let beside = Plane::new(e.gradient.clone(), f.height);
        trial.zero("parallel planes", beside.dual().i_distance2(&e.dual()));
        Ok(())
    }
}

struct AtSigma;

impl Identity for AtSigma {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let sigma = ParabolicSphere::unit();
        let e = plane(trial);
        let pole = trial.made_point(e.dual());
        let over = sigma.residual(&pole);
        trial.zero("tangency", sigma.tangency(&e) + over);
        let circle = sigma.section(&e);
        trial.zero("over the centre", circle.top_view.centre.distance2(&pole.top_view()));
        trial.zero("radius", circle.top_view.radius2 + sigma.residual(&pole));
        let at = TopView::new(trial.free(), trial.free());
        let contact = sigma.contact_at(&at);
        trial.equal_points("the pole is the contact", &contact.plane().dual(), &contact.point);
        trial.zero("on Σ", sigma.residual(&contact.point));
        let dual = sigma.dual();
        trial.equal("Σ is its own dual", &dual.residual(&pole), &sigma.residual(&pole));
        Ok(())
    }
}

struct Poles;

impl Identity for Poles {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (f, jet) = graph(trial)?;
        let at = jet.contact.point.top_view();
        let dual = trial.made_point(ParametricSurface::dual_of(&f).point_at(&at));
        trial.equal_points("pole of the tangent plane", &dual, &jet.tangent_plane().dual());
        let Gradient { x, y } = &jet.contact.gradient;
        let height = &at.x * x + &at.y * y - &jet.contact.point.z;
        trial.equal_points("(10)", &dual, &TopView::new(x.clone(), y.clone()).at_height(height));
        Ok(())
    }
}

struct DoubleDual;

impl Identity for DoubleDual {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (f, jet) = graph(trial)?;
        let at = jet.contact.point.top_view();
        trial.nonzero(REGULAR, &jet.curvature())?;
        let dual = trial.defined(REGULAR, ParametricSurface::dual_of(&f).jet(&at))?;
        let back = trial.made_point(dual.tangent_plane().dual());
        trial.equal_points("the point of the graph", &back, &jet.contact.point);
        Ok(())
    }
}

struct DualCurvatures;

impl Identity for DualCurvatures {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (f, jet) = graph(trial)?;
        let at = jet.contact.point.top_view();
        let (k, h) = (jet.curvature(), jet.mean_curvature());
        trial.nonzero(REGULAR, &k)?;
        let dual = trial.defined(REGULAR, ParametricSurface::dual_of(&f).jet(&at))?;
        let (k1, h1) = (trial.made(dual.curvature()), trial.made(dual.mean_curvature()));
        trial.show("K", &k);
        trial.show("K*", &k1);
        trial.equal("K K*", &(&k * k1), &T::one());
        trial.equal("H* K", &(h1 * k), &h);
        Ok(())
    }
}

struct DualJet;

impl Identity for DualJet {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let contact =
            ContactElement::new(trial.free_point(), Gradient::new(trial.free(), trial.free()));
        let hessian = Hessian { xx: trial.free(), xy: trial.free(), yy: trial.free() };
        let jet = Jet2 { contact, hessian };
        let k = jet.curvature();
        trial.nonzero(REGULAR, &k)?;
        let dual = trial.defined(REGULAR, jet.dual())?;
        trial.equal("K K*", &(&k * dual.curvature()), &T::one());
        trial.equal("H* K", &(dual.mean_curvature() * k), &jet.mean_curvature());
        trial.equal_points("pole", &dual.contact.point, &jet.tangent_plane().dual());
        equal_planes(trial, "polar plane", &dual.tangent_plane(), &jet.contact.point.dual());
        // The Gauss map of the dual surface undoes that of the graph.
        let v = trial.free_vector2();
        let back = dual.hessian.apply(&jet.hessian.apply(&v));
        trial.equal("inverse shape operator", &back.x, &v.x);
        trial.equal("inverse shape operator", &back.y, &v.y);
        Ok(())
    }
}
