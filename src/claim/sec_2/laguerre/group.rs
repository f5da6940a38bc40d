//! L-transformations and i-M-transformations.

use crate::claim::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Stop, Trial,
};

use super::{circle, free_sphere, made, plane_of, power_of_origin};
use crate::scalar::{Field, Rational, Ring};
use crate::space::laguerre::{Cone, LaguerreTransformation, OrientedPlane, OrientedSphere};
use crate::space::{MoebiusSphere, MoebiusTransformation, Point, TopView, Transform, Vector3};

pub(in crate::claim) const CLAIMS: &[Claim] = &[Claim {
    id: "laguerre-group",
    statement: "The maps S ↦ a + R S with RᵀDR = D keep the contact of oriented spheres and the \
                    tangency of planes and spheres, and they form a group. In the isotropic model \
                    they are the i-M-transformations; offsetting by d is z ↦ z + d(1 + |x'|²)/2.",
    formula: "RᵀDR = D,  D = diag(1, 1, 1, −1)",
    source: Source::Paper("Sec. 2.2"),
    hypotheses: &[Hypothesis::stated(ISOMETRY), Hypothesis::silent(IMAGE_SOUTH)],
    said: Grade::Certified,
    argument: "The matrices are products of reflections at vectors of length not 0, and what two \
                   maps keep, their product keeps.",
    evidence: &[
        Evidence::identity::<Isometries>("contact, tangency", &[1], &[1]),
        Evidence::identity::<Groups>("products, inverses", &[1], &[1]),
        Evidence::identity::<Offsets>("offsets", &[1], &[1]),
        Evidence::identity::<Models>("the same in the isotropic model", &[1], &[1]),
        Evidence::identity::<ModelsOfCones>("cones and i-circles", &[1], &[1]),
    ],
    controls: &[
        Control {
            without: ISOMETRY,
            shows: "twice the radius",
            counterexample: Counterexample::Witness(twice_the_radius),
        },
        Control {
            without: IMAGE_SOUTH,
            shows: "the reflection at the plane z = 0 turns (0, 0, 1) to (0, 0, −1)",
            counterexample: Counterexample::Unknowns {
                evidence: 3,
                size: 1,
                unknowns: &["0", "0", "1", "0", "0", "0", "0", "0", "0", "0", "3"],
                constrained: &[],
            },
        },
    ],
}];

const ISOMETRY: &str = "RᵀDR = D";

const IMAGE_SOUTH: &str = "the image of the plane does not have the normal (0, 0, −1)";

/// `diag(1, 1, 1, 2)` on a point and a sphere that touch.
fn twice_the_radius() -> Result<String, String> {
    let [zero, one, two] = [0, 1, 2].map(Rational::from_i64);
    let matrix: [[Rational; 4]; 4] = std::array::from_fn(|i| {
        let diagonal = if i == 3 { &two } else { &one };
        std::array::from_fn(|j| if i == j { diagonal.clone() } else { zero.clone() })
    });
    let refused = LaguerreTransformation::new(matrix, std::array::from_fn(|_| zero.clone()));
    let at = |x: &Rational, radius: &Rational| {
        OrientedSphere::new(Point::new(x.clone(), zero.clone(), zero.clone()), radius.clone())
    };
    let (before, after) =
        (at(&zero, &zero).contact(&at(&one, &one)), at(&zero, &zero).contact(&at(&one, &two)));
    if refused.is_ok() || !before.is_zero() || after.is_zero() {
        return Err("contact stays".into());
    }
    Ok(format!("contact: {after}"))
}

/// A reflection and a translation of the 4-space of spheres.
fn reflection<T: Field>(trial: &mut Trial<T>) -> Result<LaguerreTransformation<T>, Stop> {
    let v = [(); 4].map(|()| trial.free());
    let length2 = v[0].square() + v[1].square() + v[2].square() - v[3].square();
    trial.parameter("the vector of the reflection has a length", &length2)?;
    let shift = [(); 4].map(|()| trial.free());
    let reflection = trial.accepted("no reflection", LaguerreTransformation::reflection(&v))?;
    Ok(reflection.then(&LaguerreTransformation::translation(shift)))
}

/// The image of a plane, and by what its tangency is divided.
fn moved<T: Field>(
    trial: &mut Trial<T>,
    map: &LaguerreTransformation<T>,
    plane: &OrientedPlane<T>,
) -> Result<(OrientedPlane<T>, T), Stop> {
    let Vector3 { x, y, z } = plane.normal().clone();
    let [.., last] = map.turn(&[x, y, z, T::one()]);
    trial.parameter("an isotropic vector has a last coordinate, as in ordered fields", &last)?;
    Ok((map.apply(plane), last))
}

struct Isometries;

impl Identity for Isometries {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let map = reflection(trial)?;
        let again = LaguerreTransformation::new(map.linear().clone(), map.shift().clone());
        let map = trial.accepted(ISOMETRY, again)?;
        let (first, second) = (free_sphere(trial), free_sphere(trial));
        let [first_image, second_image] = [&first, &second].map(|sphere| map.apply(sphere));
        let first_image = OrientedSphere {
            centre: trial.made_point(first_image.centre),
            radius: trial.made(first_image.radius),
        };
        trial.equal("contact", &first_image.contact(&second_image), &first.contact(&second));
        let point = trial.free_point();
        let plane = plane_of(trial, &point)?;
        let (image, last) = moved(trial, &map, &plane)?;
        let touching = first_image.tangency(&image) * last;
        trial.equal("tangency", &touching, &first.tangency(&plane));
        trial.equal("a unit normal", &image.normal().length2(), &T::one());
        Ok(())
    }
}

struct Groups;

impl Identity for Groups {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (map, next) = (reflection(trial)?, reflection(trial)?);
        let sphere = free_sphere(trial);
        let (product, inverse) = (map.then(&next), map.inverse());
        let image = map.apply(&sphere);
        let mut same = |what, a: OrientedSphere<T>, b: &OrientedSphere<T>| {
            trial.equal_points(what, &a.centre, &b.centre);
            trial.equal(what, &a.radius, &b.radius);
        };
        same("one after the other", product.apply(&sphere), &next.apply(&image));
        same("there and back", inverse.apply(&image), &sphere);
        same("back and there", map.apply(&inverse.apply(&sphere)), &sphere);
        same("the identity", LaguerreTransformation::identity().apply(&sphere), &sphere);
        Ok(())
    }
}

struct Offsets;

impl Identity for Offsets {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let d = trial.free();
        let offset = LaguerreTransformation::offset(d.clone());
        let sphere = free_sphere(trial);
        let image = offset.apply(&sphere);
        trial.equal_points("the centre stays", &image.centre, &sphere.centre);
        trial.equal("the radius grows", &image.radius, &(&sphere.radius + &d));
        let p = trial.free_point();
        let plane = plane_of(trial, &p)?;
        let (plane, _) = moved(trial, &offset, &plane)?;
        let half = (T::one() + p.top_view().norm2()) * T::from_ratio(1, 2);
        let raised = p.top_view().at_height(&p.z + &d * half);
        let point = trial.accepted("the south pole", plane.to_isotropic())?;
        let point = trial.made_point(point);
        trial.equal_points("the point is raised", &point, &raised);
        let isotropic = MoebiusTransformation::from(&offset);
        let image = trial.accepted("at infinity", isotropic.map_point(&p))?;
        trial.equal_points("by the i-M-transformation", &image, &raised);
        Ok(())
    }
}

struct Models;

impl Identity for Models {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let map = reflection(trial)?;
        let isotropic = MoebiusTransformation::from(&map);
        let p = trial.free_point();
        let plane = plane_of(trial, &p)?;
        let (plane, _) = moved(trial, &map, &plane)?;
        trial.nonzero(IMAGE_SOUTH, &(T::one() + &plane.normal().z))?;
        let image = trial.defined(IMAGE_SOUTH, isotropic.map_point(&p).ok())?;
        let image = trial.made_point(image);
        let expected = trial.defined(IMAGE_SOUTH, plane.to_isotropic().ok())?;
        trial.equal_points("planes and points", &image, &expected);
        let sphere = free_sphere(trial);
        let image = isotropic.map_sphere(&MoebiusSphere::from(&sphere));
        let expected = MoebiusSphere::from(&map.apply(&sphere));
        for (a, b) in image.coefficients().iter().zip(&expected.coefficients()) {
            trial.equal("spheres", a, b);
        }
        let back = LaguerreTransformation::from(&isotropic).apply(&sphere);
        trial.equal_points("there and back", &back.centre, &map.apply(&sphere).centre);
        trial.equal("there and back", &back.radius, &map.apply(&sphere).radius);
        Ok(())
    }
}

struct ModelsOfCones;

impl Identity for ModelsOfCones {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let map = reflection(trial)?;
        let circle = circle(trial);
        let n = power_of_origin(&circle);
        trial.parameter("the cone is no cylinder", &(T::one() + &n))?;
        let cone = trial.accepted("a cylinder", Cone::of_isotropic(&circle))?;
        let isotropic = MoebiusTransformation::from(&map);
        let TopView { x, y } = &circle.top_view.centre;
        let [first, ..] = isotropic.turn(&[T::one(), -x, -y, n * T::from_ratio(1, 2)]);
        trial.parameter("the image does not pass through the centre", &first)?;
        let image = trial.accepted("at infinity", isotropic.map_circle(&circle))?;
        let n = T::one() + power_of_origin(&image);
        trial.parameter("the image of the cone is no cylinder", &n)?;
        let expected = trial.accepted("a cylinder", Cone::of_isotropic(&image))?;
        let Vector3 { x, y, z } = cone.axis.clone();
        let [.., last] = map.turn(&[x, y, z, T::one()]);
        trial.parameter("the image of the cone is no cylinder", &last)?;
        let image = trial.accepted("a cylinder", map.map_cone(&cone))?;
        let image = made(trial, image);
        trial.equal_points("vertex", &image.vertex, &expected.vertex);
        trial.equal("axis", &image.axis.x, &expected.axis.x);
        trial.equal("axis", &image.axis.y, &expected.axis.y);
        trial.equal("axis", &image.axis.z, &expected.axis.z);
        Ok(())
    }
}
