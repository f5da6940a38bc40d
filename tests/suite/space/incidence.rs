//! Planes, circles and the sections of i-spheres (3).

use isogeo::scalar::{BigRational, Rational, RationalField};
use isogeo::space::*;
use proptest::prelude::*;

use super::{Draw, Verdict, laws};

laws! {
    a_plane_contains_its_three_points
    plane_sections_are_i_circles
    isotropic_sections_are_parabolas
    tangent_planes_meet_spheres_in_a_point
    parabolas_do_not_depend_on_the_parameter
    every_point_of_its_axis_is_centre_of_a_cylinder
}

fn a_plane_contains_its_three_points<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let [a, b, mut c] = [draw.point(), draw.point(), draw.point()];
    let Ok(plane) = Plane::through(&a, &b, &c) else {
        let line = IsotropicPlane::through(&a.top_view(), &b.top_view());
        prop_assert!(line.is_err() || line.unwrap().contains(&c));
        return Ok(());
    };
    prop_assert!([&a, &b, &c].iter().all(|p| plane.contains(p)));
    c.z += &Q::one();
    prop_assert_eq!(plane.residual(&c), Q::one());

    let on = &(&a + &(&b - &a));
    prop_assert_eq!(Plane::through(&a, &b, on), Err(SpaceError::CollinearTopViews));
    Ok(())
}

/// `eq-3-sections`: a point of the plane has the same power, times −A/2, over the circle and over
/// the sphere; so they vanish together, for imaginary circles as well.
fn plane_sections_are_i_circles<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (sphere, plane) = (draw.sphere(), draw.plane());
    let mut section = sphere.section(&plane);
    let point = plane.point_at(&draw.top_view());
    let power = section.top_view.power(&point.top_view());
    prop_assert_eq!(sphere.residual(&point), -(&sphere.a * power));
    prop_assert!(plane.contains(&section.centre()));
    let from_centre = point.i_distance2(&section.centre()) - &section.top_view.radius2;
    prop_assert_eq!(section.residuals(&point), [Q::zero(), from_centre]);

    section.top_view.radius2 += &Q::one();
    let power = section.top_view.power(&point.top_view());
    prop_assert_ne!(sphere.residual(&point), -(&sphere.a * power));
    Ok(())
}

fn isotropic_sections_are_parabolas<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (sphere, line, u) = (draw.sphere(), draw.isotropic_plane(), draw.number());
    let parabola = sphere.isotropic_section(&line);
    let mut point = parabola.point_at(&u);
    prop_assert!(sphere.contains(&point) && line.contains(&point) && parabola.contains(&point));
    prop_assert_eq!(parabola.curvature(), &sphere.a);
    let gradient = sphere.gradient_at(&point.top_view());
    prop_assert_eq!(parabola.slope_at(&u), gradient.along(line.direction()));
    point.z += &Q::one();
    prop_assert!(!sphere.contains(&point) && !parabola.contains(&point));
    Ok(())
}

fn tangent_planes_meet_spheres_in_a_point<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (sphere, at) = (draw.sphere(), draw.top_view());
    let mut tangent = sphere.tangent_plane(&at);
    let section = sphere.section(&tangent);
    prop_assert_eq!(&section.top_view, &Circle::new(at, Q::zero()));
    prop_assert!(sphere.contains(&section.centre()));
    // Upwards for A > 0, and downwards for A < 0, the plane comes to lie inside.
    tangent.height += &sphere.a;
    prop_assert_eq!(sphere.section(&tangent).top_view.radius2, Q::from_i64(2));
    Ok(())
}

fn parabolas_do_not_depend_on_the_parameter<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (sphere, line) = (draw.sphere(), draw.isotropic_plane());
    let other = IsotropicPlane::new(
        line.top_view_at(&draw.number()),
        line.direction().scaled(&draw.non_zero()),
    );
    let other = other.unwrap();
    prop_assert_eq!(&line, &other);
    let parabola = sphere.isotropic_section(&line);
    prop_assert_eq!(&parabola, &sphere.isotropic_section(&other));

    let normal = line.direction().turned();
    let beside = IsotropicPlane::new(line.origin() + &normal, line.direction().clone()).unwrap();
    prop_assert_ne!(&line, &beside);
    prop_assert_ne!(&line, &IsotropicPlane::new(line.origin().clone(), normal).unwrap());
    let (slope, height) = (parabola.slope().clone(), parabola.height() + Q::one());
    let lifted = ParabolicCircle::new(line, sphere.a.clone(), slope, height).unwrap();
    prop_assert_ne!(parabola, lifted);
    Ok(())
}

fn every_point_of_its_axis_is_centre_of_a_cylinder<Q: RationalField>(d: &mut Draw<Q>) -> Verdict {
    let (cylinder, point) = (d.cylinder(), d.point());
    let Circle { centre, radius2 } = cylinder.top_view();
    let mut on_axis = centre.at_height(d.number());
    prop_assert_eq!(cylinder.residual(&point), point.i_distance2(&on_axis) - radius2);
    // d + d² + 2 is neither d nor −d.
    on_axis.x += &((&on_axis.x - &point.x).square() + Q::from_i64(2));
    prop_assert_ne!(cylinder.residual(&point), point.i_distance2(&on_axis) - radius2);
    Ok(())
}

fn the_plane_below_sigma_cuts_in_an_imaginary_circle<Q: RationalField>() {
    let q = Q::from_i64;
    let plane = Plane::new(Gradient::new(q(1), q(2)), q(-3));
    let section = ParabolicSphere::unit().section(&plane);
    // |x' − (1, 2)|² = 1 + 4 − 6
    assert_eq!(section.top_view, Circle::new(TopView::new(q(1), q(2)), q(-1)));
    assert!(section.top_view.is_imaginary());
    assert_eq!(section.centre(), Point::new(q(1), q(2), q(2)));
    let touching = Plane::new(Gradient::new(q(1), q(2)), Q::from_ratio(-5, 2));
    assert!(!ParabolicSphere::unit().section(&touching).top_view.is_imaginary());
}

fn degenerate_data_are_refused<Q: RationalField>() {
    let q = Q::from_i64;
    let origin = TopView::new(q(0), q(0));
    let sphere = ParabolicSphere::new(q(0), q(1), q(2), q(3));
    assert_eq!(sphere, Err(SpaceError::ZeroCurvature));
    let plane = MoebiusSphere::from(Plane::new(Gradient::new(q(1), q(2)), q(3)));
    assert_eq!(ParabolicSphere::try_from(plane), Err(SpaceError::ZeroCurvature));
    let cylinder = CylindricalSphere::new(Circle::new(origin.clone(), q(0)));
    assert_eq!(cylinder, Err(SpaceError::ZeroRadius));
    assert_eq!(IsotropicPlane::through(&origin, &origin), Err(SpaceError::ZeroDirection));
    let line = IsotropicPlane::new(origin.clone(), Vector2::new(q(1), q(0))).unwrap();
    let parabola = ParabolicCircle::new(line, q(0), q(1), q(1));
    assert_eq!(parabola, Err(SpaceError::ZeroCurvature));
    let at = |x, y| TopView::new(q(x), q(y));
    let circle = Circle::through(&at(0, 0), &at(1, 2), &at(3, 6));
    assert_eq!(circle, Err(SpaceError::CollinearTopViews));
    assert_eq!(Scaling::new(q(0), q(1)), Err(SpaceError::ZeroFactor));
    assert_eq!(Scaling::new(q(1), q(0)), Err(SpaceError::ZeroFactor));
}

#[test]
fn values_over_both_scalars() {
    the_plane_below_sigma_cuts_in_an_imaginary_circle::<Rational>();
    the_plane_below_sigma_cuts_in_an_imaginary_circle::<BigRational>();
    degenerate_data_are_refused::<Rational>();
    degenerate_data_are_refused::<BigRational>();
}
