//! Sec. 2.1: isotropic sphere transformations.

use super::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Stop, Trial,
};
use crate::check::Residual;
use crate::net::i_circular::Concyclic;
use crate::scalar::Field;
use crate::space::{
    Circle, CylindricalSphere, Gradient, ICircle, MoebiusSphere, MoebiusTransformation, Plane,
    Point, TopView, Vector3,
};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "moebius-parabolic",
        statement: "The inversion at an i-M-sphere is an involution that keeps top views. It maps \
                    i-M-spheres to i-M-spheres and elliptic i-circles to such.",
        formula: "(x', z) ↦ (x', 2s(x') − z)",
        source: Source::Paper("Sec. 2.1, isotropic sphere transformations"),
        hypotheses: &[],
        said: Grade::Certified,
        argument: "The image of a point lies over the image of a sphere by as much as the point over \
                   the sphere, but for the sign; so exactly the points of the sphere are mapped to \
                   those of its image.",
        evidence: &[
            Evidence::identity::<Parabolic>("points and i-M-spheres", &[1], &[1]),
            Evidence::identity::<ParabolicOnCircles>("elliptic i-circles", &[1], &[1]),
        ],
        controls: &[],
    },
    Claim {
        id: "moebius-cylindrical",
        statement: "The inversion at an i-sphere of cylindrical type, with a centre c on its axis, is \
                    an involution of the points off the axis. It appears in the top view as the \
                    inversion at the circle, and corresponding points lie on lines through c. It \
                    maps i-M-spheres to i-M-spheres, and elliptic i-circles off the centre to such.",
        formula: "x ↦ c + r² (x − c)/|x' − c'|²",
        source: Source::Paper("Sec. 2.1, isotropic sphere transformations"),
        hypotheses: &[
            Hypothesis::stated(RADIUS),
            Hypothesis::silent(OFF_AXIS),
            Hypothesis::silent(OFF_CENTRE),
        ],
        said: Grade::Certified,
        argument: "The image of a point lies over the image of a sphere by a multiple, not 0, of what \
                   the point lies over the sphere. A translation puts the centre at the origin. The \
                   in-circle determinant of four top views is multiplied by a product of powers, so \
                   the planar map is a Möbius map.",
        evidence: &[
            Evidence::identity::<Cylindrical>("points and i-M-spheres", &[1], &[1]),
            Evidence::identity::<CylindricalOnCircles>("elliptic i-circles", &[1], &[1]),
            Evidence::identity::<Planar>("circles of the top view", &[1], &[1]),
        ],
        controls: &[
            Control {
                without: RADIUS,
                shows: "an isotropic line instead of a cylinder",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &["0", "0", "0", "0", "1", "2", "3"],
                    constrained: &[],
                },
            },
            Control {
                without: OFF_AXIS,
                shows: "a point over the centre has no image",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &["0", "0", "0", "1", "0", "0", "3"],
                    constrained: &[],
                },
            },
            Control {
                without: OFF_CENTRE,
                shows: "the circle |x' − (1, 0)| = 1 passes through the centre",
                counterexample: Counterexample::Unknowns {
                    evidence: 1,
                    size: 1,
                    unknowns: &["0", "0", "0", "1", "0", "0", "1", "1", "0", "2", "0"],
                    constrained: &[],
                },
            },
        ],
    },
];

const RADIUS: &str = "r² != 0";
const OFF_AXIS: &str = "the point does not lie on the axis";
const OFF_CENTRE: &str = "the top view of the i-circle does not pass through the centre";

fn sphere<T: Field>(trial: &mut Trial<T>) -> MoebiusSphere<T> {
    MoebiusSphere::new(trial.free(), trial.free(), trial.free(), trial.free())
}

fn top_view<T: Field>(trial: &mut Trial<T>) -> TopView<T> {
    TopView::new(trial.free(), trial.free())
}

/// An i-circle of elliptic type with one of its points.
fn circle_with_point<T: Field>(trial: &mut Trial<T>) -> (ICircle<T>, Point<T>) {
    let plane = Plane::new(Gradient::new(trial.free(), trial.free()), trial.free());
    let (centre, at) = (top_view(trial), top_view(trial));
    let radius2 = centre.distance2(&at);
    let point = plane.point_at(&at);
    (ICircle { plane, top_view: Circle::new(centre, radius2) }, point)
}

/// All numbers of an i-circle count as constructed.
fn made<T: Field>(trial: &mut Trial<T>, circle: ICircle<T>) -> ICircle<T> {
    let ICircle { plane: Plane { gradient, height }, top_view: Circle { centre, radius2 } } =
        circle;
    let gradient = Gradient::new(trial.made(gradient.x), trial.made(gradient.y));
    let plane = Plane::new(gradient, trial.made(height));
    let centre = TopView::new(trial.made(centre.x), trial.made(centre.y));
    ICircle { plane, top_view: Circle::new(centre, trial.made(radius2)) }
}

/// The image of the points of an i-circle is the image of the i-circle: tested on one point where
/// the circle is known, and by the way back, which needs every number of the image.
fn circles_to_circles<T: Field>(
    trial: &mut Trial<T>,
    inversion: &MoebiusTransformation<T>,
    circle: &ICircle<T>,
    image: &ICircle<T>,
    point: &Point<T>,
) -> Run {
    let moved = trial.accepted("a point on the axis", inversion.map_point(point))?;
    let [beside, power] = image.residuals(&moved);
    trial.zero("in the plane", beside);
    trial.zero("in the top view", power);
    let back = trial.accepted("a circle through the centre", inversion.map_circle(image))?;
    trial.equal("there and back: plane", &back.plane.gradient.x, &circle.plane.gradient.x);
    trial.equal("there and back: plane", &back.plane.gradient.y, &circle.plane.gradient.y);
    trial.equal("there and back: plane", &back.plane.height, &circle.plane.height);
    let (back, start) = (&back.top_view, &circle.top_view);
    trial.equal("there and back: centre", &back.centre.x, &start.centre.x);
    trial.equal("there and back: centre", &back.centre.y, &start.centre.y);
    trial.equal("there and back: radius", &back.radius2, &start.radius2);
    Ok(())
}

struct Parabolic;

impl Identity for Parabolic {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (at, sphere, p) = (sphere(trial), sphere(trial), trial.free_point());
        let inversion = MoebiusTransformation::inversion_at(&at);
        let image = trial.accepted("at infinity", inversion.map_point(&p))?;
        let image = trial.made_point(image);
        let height = T::from_i64(2) * at.height_at(&p.top_view()) - &p.z;
        trial.equal_points("the inversion", &image, &p.top_view().at_height(height));
        let back = trial.accepted("at infinity", inversion.map_point(&image))?;
        trial.equal_points("an involution", &back, &p);
        let moved = inversion.map_sphere(&sphere);
        trial.zero("points of spheres", moved.residual(&image) + sphere.residual(&p));
        let fixed = inversion.map_sphere(&at);
        trial.equal("its sphere stays", &fixed.residual(&p), &at.residual(&p));
        let kept = trial.accepted("at infinity", inversion.map_top_view(&p.top_view()))?;
        trial.zero("the top view stays", kept.distance2(&p.top_view()));
        Ok(())
    }
}

struct ParabolicOnCircles;

impl Identity for ParabolicOnCircles {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let inversion = MoebiusTransformation::inversion_at(&sphere(trial));
        let (circle, point) = circle_with_point(trial);
        let image = trial.accepted("at infinity", inversion.map_circle(&circle))?;
        let image = made(trial, image);
        circles_to_circles(trial, &inversion, &circle, &image, &point)
    }
}

/// The inversion at a cylinder with a centre on its axis.
struct Inversion<T> {
    centre: Point<T>,
    radius2: T,
    map: MoebiusTransformation<T>,
}

fn inversion<T: Field>(trial: &mut Trial<T>, centre: Point<T>) -> Result<Inversion<T>, Stop> {
    let radius2 = trial.free();
    trial.nonzero(RADIUS, &radius2)?;
    let cylinder = CylindricalSphere::new(Circle::new(centre.top_view(), radius2.clone())).ok();
    let cylinder = trial.defined(RADIUS, cylinder)?;
    let map = MoebiusTransformation::inversion_at_cylinder(&cylinder, &centre.z);
    Ok(Inversion { centre, radius2, map })
}

struct Cylindrical;

impl Identity for Cylindrical {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let c = trial.free_point();
        let Inversion { centre: c, radius2, map: inversion } = inversion(trial, c)?;
        let p = trial.free_point();
        let distance2 = p.i_distance2(&c);
        trial.nonzero(OFF_AXIS, &distance2)?;
        let image = trial.defined(OFF_AXIS, inversion.map_point(&p).ok())?;
        let image = trial.made_point(image);
        // Both sides are multiplied by the squared distance.
        let times = |v: Vector3<T>, t: &T| Vector3::new(v.x * t, v.y * t, v.z * t);
        let expected = &c + &times(&p - &c, &radius2);
        trial.equal_points("the inversion", &(&c + &times(&image - &c, &distance2)), &expected);
        let back = trial.accepted("at infinity", inversion.map_point(&image))?;
        trial.equal_points("an involution", &back, &p);
        let sphere = sphere(trial);
        let moved = inversion.map_sphere(&sphere);
        let over = moved.residual(&image) * &distance2;
        trial.equal("points of spheres", &over, &(sphere.residual(&p) * &radius2));
        let below = trial.accepted("at infinity", inversion.map_top_view(&p.top_view()))?;
        trial.zero("seen in the top view", below.distance2(&image.top_view()));
        Ok(())
    }
}

struct CylindricalOnCircles;

impl Identity for CylindricalOnCircles {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let c = trial.free_point();
        let Inversion { centre: c, map: inversion, .. } = inversion(trial, c)?;
        let (circle, point) = circle_with_point(trial);
        trial.nonzero(OFF_CENTRE, &circle.top_view.power(&c.top_view()))?;
        let image = trial.defined(OFF_CENTRE, inversion.map_circle(&circle).ok())?;
        let image = made(trial, image);
        trial.parameter("the point lies off the axis", &point.i_distance2(&c))?;
        circles_to_circles(trial, &inversion, &circle, &image, &point)
    }
}

struct Planar;

impl Identity for Planar {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let origin = Point::new(T::zero(), T::zero(), T::zero());
        let Inversion { radius2, map, .. } = inversion(trial, origin)?;
        let at = [(); 4].map(|()| top_view(trial));
        let mut images = Vec::new();
        let mut factor = T::one();
        for x in &at {
            trial.nonzero(OFF_AXIS, &x.norm2())?;
            images.push(trial.defined(OFF_AXIS, map.map_top_view(x).ok())?);
            factor = factor * x.norm2();
        }
        let level = |x: &TopView<T>| x.at_height(T::zero());
        let before = Concyclic.eval(&at.each_ref().map(level), &T::one());
        let after = Concyclic.eval(&std::array::from_fn(|i| level(&images[i])), &T::one());
        // Its orientation turns over.
        let scale = radius2.square() * radius2.square();
        trial.zero("circles to circles", after * factor + before * scale);
        Ok(())
    }
}
