//! i-M-transformations (Sec. 2.1): a group, and what it keeps.

use isogeo::scalar::{Approx, Field, Rational, RationalField, Ring};
use isogeo::space::*;
use proptest::prelude::*;

use super::{Draw, Verdict, laws};

laws! {
    they_are_a_group
    motions_and_scalings_are_among_them
    inversions_at_cylinders_are_involutions
    inversions_at_spheres_are_involutions
    spheres_go_to_spheres
    circles_go_to_circles
    the_unit_cylinder_inverts_circles_as_theory_says
    the_top_view_is_a_planar_moebius_transformation
    matrices_are_checked
}

type Map<Q> = MoebiusTransformation<Q>;

fn they_are_a_group<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (m, n, k) = (draw.moebius(), draw.moebius(), draw.moebius());
    let (both, back) = (m.then(&n), m.inverse());
    prop_assert_eq!(&m.then(&back), &Map::identity());
    prop_assert_eq!(&back.then(&m), &Map::identity());
    prop_assert_eq!(both.then(&k), m.then(&n.then(&k)));
    prop_assert_eq!(both.factor(), &(m.factor() * n.factor()));

    let (point, sphere) = (draw.point(), draw.sphere());
    prop_assert_eq!(both.map_sphere(&sphere), n.map_sphere(&m.map_sphere(&sphere)));
    prop_assert_eq!(&back.map_sphere(&m.map_sphere(&sphere)), &*sphere);
    if let Ok(image) = m.map_point(&point) {
        prop_assert_eq!(back.map_point(&image), Ok(point.clone()));
        if let Ok(image) = n.map_point(&image) {
            prop_assert_eq!(both.map_point(&point), Ok(image));
        }
    }
    let circle = sphere.section(&draw.plane());
    if let Ok(image) = m.map_circle(&circle) {
        prop_assert_eq!(back.map_circle(&image), Ok(circle.clone()));
        if let Ok(image) = n.map_circle(&image) {
            prop_assert_eq!(both.map_circle(&circle), Ok(image));
        }
    }
    prop_assert_ne!(m.then(&Map::addition(&sphere)), m);
    Ok(())
}

fn motions_and_scalings_are_among_them<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (motion, scaling) = (draw.motion(), draw.scaling());
    let (by_motion, by_scaling) = (Map::from(&motion), Map::from(&scaling));
    prop_assert_eq!(by_motion.factor(), &Q::one());
    let (point, sphere) = (draw.point(), draw.sphere());
    let circle = sphere.section(&draw.plane());
    prop_assert_eq!(by_motion.map_point(&point), Ok(motion.apply(&point)));
    prop_assert_eq!(by_scaling.map_point(&point), Ok(scaling.apply(&point)));
    prop_assert_eq!(by_motion.map_circle(&circle), Ok(motion.apply(&circle)));
    prop_assert_eq!(by_scaling.map_circle(&circle), Ok(scaling.apply(&circle)));
    let other = draw.motion();
    prop_assert_eq!(by_motion.then(&(&other).into()), Map::from(&motion.then(&other)));
    prop_assert_eq!(by_motion.inverse(), Map::from(&motion.inverse()));
    let mut wrong = motion.clone();
    wrong.translation.z += &Q::one();
    prop_assert_ne!(Map::from(&wrong), by_motion);
    Ok(())
}

/// `moebius-cylindrical`
fn inversions_at_cylinders_are_involutions<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (cylinder, height, point) = (draw.cylinder(), draw.number(), draw.point());
    let map = Map::inversion_at_cylinder(&cylinder, &height);
    prop_assert_eq!(map.then(&map), Map::identity());
    let Circle { centre, radius2 } = cylinder.top_view();
    let distance2 = centre.distance2(&point.top_view());
    let Some(inverse) = distance2.try_inv() else {
        prop_assert_eq!(map.map_point(&point), Err(SpaceError::AtInfinity));
        return Ok(());
    };
    // x ↦ c + r² (x − c)/|x' − c'|²
    let centre = centre.at_height(height);
    let (from, factor) = (&point - &centre, radius2 * inverse);
    let expected = &centre + &Vector3::new(&factor * &from.x, &factor * &from.y, &factor * &from.z);
    prop_assert_eq!(map.map_point(&point), Ok(expected));
    prop_assert_eq!(map.map_point(&centre), Err(SpaceError::AtInfinity));

    let wrong = Circle::new(cylinder.top_view().centre.clone(), radius2 + radius2);
    let wrong = Map::inversion_at_cylinder(&CylindricalSphere::new(wrong).unwrap(), &centre.z);
    prop_assert_ne!(map.then(&wrong), Map::identity());
    Ok(())
}

/// `moebius-parabolic`
fn inversions_at_spheres_are_involutions<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (sphere, point) = (draw.sphere(), draw.point());
    let map = Map::inversion_at(&sphere);
    prop_assert_eq!(map.then(&map), Map::identity());
    let at = point.top_view();
    let double = sphere.height_at(&at) * Q::from_i64(2);
    prop_assert_eq!(map.map_point(&point), Ok(at.at_height(double - &point.z)));
    prop_assert_eq!(&map.map_sphere(&sphere), &*sphere);
    let mut other = (*sphere).clone();
    other.plane.height += &Q::one();
    prop_assert_ne!(&map.map_sphere(&other), &other);
    prop_assert_ne!(map.then(&Map::inversion_at(&other)), Map::identity());
    Ok(())
}

/// Incidence and contact of i-M-spheres, planes included.
fn spheres_go_to_spheres<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (map, sphere, at) = (draw.moebius(), draw.sphere(), draw.top_view());
    let tangent = MoebiusSphere::from(sphere.tangent_plane(&at));
    for (sphere, other) in [(&*sphere, &tangent), (&tangent, &*sphere)] {
        let (image, other) = (map.map_sphere(sphere), map.map_sphere(other));
        let Ok(mut point) = map.map_point(&at.at_height(sphere.height_at(&at))) else {
            continue;
        };
        prop_assert!(image.contains(&point) && other.contains(&point));
        let here = point.top_view();
        prop_assert_eq!(image.gradient_at(&here), other.gradient_at(&here));
        point.z += &Q::one();
        prop_assert!(!image.contains(&point));
        point.x += &Q::one();
        let same = image == other || image.a == other.a;
        prop_assert!(
            same || image.gradient_at(&point.top_view()) != other.gradient_at(&point.top_view())
        );
    }
    Ok(())
}

/// An i-circle through three points goes to that through the images; so four points on one stay.
fn circles_go_to_circles<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let map = draw.moebius();
    let points = [draw.point(), draw.point(), draw.point()];
    let [a, b, c] = &points;
    let circle = ICircle::through(a, b, c);
    prop_assume!(circle.is_ok());
    let circle = circle.unwrap();
    let image = map.map_circle(&circle);
    let images: Result<Vec<_>, _> = points.iter().map(|p| map.map_point(p)).collect();
    let (Ok(image), Ok(images)) = (image, images) else {
        return Ok(());
    };
    prop_assert_eq!(ICircle::through(&images[0], &images[1], &images[2]), Ok(image.clone()));

    // The other end of a diameter, and a point beside the circle.
    let centre = circle.centre();
    let opposite = &centre + &(&centre - a);
    let beside = &opposite + &Vector3::new(Q::zero(), Q::zero(), Q::one());
    if let (Ok(opposite), Ok(beside)) = (map.map_point(&opposite), map.map_point(&beside)) {
        prop_assert!(image.contains(&opposite));
        prop_assert!(!image.contains(&beside));
    }
    Ok(())
}

/// Centre c/N, radius ρ/N, plane p + 2tc/N, −t/N, for `N = |c|² − ρ²`.
fn the_unit_cylinder_inverts_circles_as_theory_says<Q: RationalField>(
    draw: &mut Draw<Q>,
) -> Verdict {
    let origin = TopView::new(Q::zero(), Q::zero());
    let unit = CylindricalSphere::new(Circle::new(origin, Q::one())).unwrap();
    let map = Map::inversion_at_cylinder(&unit, &Q::zero());
    let mut circle = ICircle { plane: draw.plane(), top_view: draw.circle() };
    let Circle { centre: c, radius2 } = circle.top_view.clone();
    let Some(inverse) = (c.norm2() - &radius2).try_inv() else {
        prop_assert_eq!(map.map_circle(&circle), Err(SpaceError::AtInfinity));
        return Ok(());
    };
    let Plane { gradient: p, height: t } = circle.plane.clone();
    let centre = TopView::new(&c.x * &inverse, &c.y * &inverse);
    let twice = &t * Q::from_i64(2);
    let gradient = Gradient::new(p.x + &twice * &centre.x, p.y + &twice * &centre.y);
    let expected = ICircle {
        plane: Plane::new(gradient, -(t * &inverse)),
        top_view: Circle::new(centre, radius2 * inverse.square()),
    };
    prop_assert_eq!(map.map_circle(&circle), Ok(expected.clone()));
    circle.plane.height += &Q::one();
    prop_assert_ne!(map.map_circle(&circle), Ok(expected));
    Ok(())
}

/// Cross ratios of top views stay, or become conjugate; heights have no influence.
fn the_top_view_is_a_planar_moebius_transformation<Q: RationalField>(
    draw: &mut Draw<Q>,
) -> Verdict {
    let map = draw.moebius();
    let points = [draw.top_view(), draw.top_view(), draw.top_view(), draw.top_view()];
    let images: Result<Vec<_>, _> = points.iter().map(|p| map.map_top_view(p)).collect();
    let Ok(images) = images else {
        return Ok(());
    };
    let (Some([re, im]), Some(ratio)) = (cross_ratio(&points), cross_ratio(&images)) else {
        return Ok(());
    };
    prop_assert!(ratio == [re.clone(), im.clone()] || ratio == [re.clone(), -&im]);
    let wrong = &images[0] + &Vector2::new(Q::one(), Q::zero());
    let images = [wrong, images[1].clone(), images[2].clone(), images[3].clone()];
    prop_assert_ne!(cross_ratio(&images), Some([re.clone(), im.clone()]));
    prop_assert_ne!(cross_ratio(&images), Some([re, -im]));

    let lifted = map.map_point(&points[0].at_height(draw.number()));
    prop_assert_eq!(lifted.map(|p| p.top_view()), map.map_top_view(&points[0]));
    Ok(())
}

/// `(a − c)(b − d)/((a − d)(b − c))` of complex numbers; `None` if two of them agree.
fn cross_ratio<Q: RationalField>(points: &[TopView<Q>]) -> Option<[Q; 2]> {
    let [a, b, c, d] = points else { return None };
    let times = |u: Vector2<Q>, v: Vector2<Q>| {
        Vector2::new(&u.x * &v.x - &u.y * &v.y, &u.x * &v.y + &u.y * &v.x)
    };
    let (over, under) = (times(a - c, b - d), times(a - d, b - c));
    let scale = under.length2().try_inv()?;
    let conjugate = Vector2::new(under.x, -under.y);
    let ratio = times(over, conjugate);
    let all_differ = !ratio.length2().is_zero() && a != b && c != d;
    all_differ.then(|| [ratio.x * &scale, ratio.y * &scale])
}

/// The representation by `Rᵀ G R = k G`.
fn matrices_are_checked<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let map = draw.moebius();
    let (mut linear, shift) = (map.linear().clone(), map.shift().clone());
    let checked = Map::with_factor(linear.clone(), shift.clone(), map.factor().clone());
    prop_assert_eq!(checked, Ok(map.clone()));
    prop_assert_eq!(Map::new(linear.clone(), shift.clone()).is_ok(), *map.factor() == Q::one());
    let zero = Map::with_factor(linear.clone(), shift.clone(), Q::zero());
    prop_assert_eq!(zero, Err(SpaceError::ZeroFactor));
    // One entry of a row that is not isotropic, far from any other solution of the quadratic.
    linear[1][1] = linear[1][1].square() + Q::from_i64(1_000_003);
    linear[2][1] = linear[2][1].square() + Q::from_i64(3);
    let wrong = Map::with_factor(linear, shift, map.factor().clone());
    prop_assert_eq!(wrong, Err(SpaceError::NotAnIsometry));
    Ok(())
}

/// A product of generators of every kind.
fn sample<T: Field>(q: impl Fn(i64, i64) -> T) -> Map<T> {
    let cylinder = |x, y, radius2| {
        CylindricalSphere::new(Circle::new(TopView::new(q(x, 2), q(y, 3)), q(radius2, 5))).unwrap()
    };
    let motion = Motion {
        rotation: Rotation::from_parameter(&q(1, 3)).unwrap(),
        shear: Vector2::new(q(1, 10), q(-3, 10)),
        translation: Vector3::new(q(1, 1), q(2, 1), q(3, 1)),
    };
    Map::inversion_at_cylinder(&cylinder(5, 1, 7), &q(1, 2))
        .then(&(&motion).into())
        .then(&Map::inversion_at(&MoebiusSphere::new(q(3, 10), q(1, 10), q(1, 5), q(-1, 1))))
        .then(&(&Scaling::new(q(2, 3), q(-3, 1)).unwrap()).into())
        .then(&Map::inversion_at_cylinder(&cylinder(-3, 9, -2), &q(0, 1)))
}

/// The same code in doubles: observed, not proved.
#[test]
fn doubles_are_near() {
    let exact = sample(Rational::from_ratio);
    let near = sample(f64::from_ratio);
    for (x, y, z) in [(0, 0, 0), (1, -1, 4), (7, 2, -3)] {
        let point = Point::new(x, y, z).map(|&n| Rational::from_i64(n));
        let image = exact.map_point(&point).unwrap();
        assert_eq!(exact.inverse().map_point(&image), Ok(point.clone()));
        let [point, image] = [point, image].map(|p| p.map(Approx::to_f64));
        let observed = near.map_point(&point).unwrap();
        assert!((&observed - &image).length2() < 1e-20);
        let back = near.inverse().map_point(&observed).unwrap();
        assert!((&back - &point).length2() < 1e-16);
    }
}
