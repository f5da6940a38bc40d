//! Metric duality (Sec. 2.1).

use std::fmt::Debug;

use isogeo::scalar::RationalField;
use isogeo::space::*;
use proptest::prelude::*;

use super::{Draw, Verdict, laws};

laws! {
    duality_is_an_involution
    duality_keeps_incidence
    duality_exchanges_distance_and_angle
    duality_exchanges_parallel_points_and_planes
    planes_touch_sigma_at_their_poles
    the_dual_of_a_sphere_envelops_the_polar_planes
}

fn involution<X: Dual + PartialEq + Debug>(object: &X) -> Verdict {
    prop_assert_eq!(&object.dual().dual(), object);
    Ok(())
}

fn duality_is_an_involution<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    involution(&draw.point())?;
    involution(&draw.plane())?;
    involution(&draw.top_view())?;
    involution(&draw.gradient())?;
    involution(&draw.contact())?;
    involution(&draw.sphere())?;
    prop_assert_eq!(ParabolicSphere::<Q>::unit().dual(), ParabolicSphere::unit());

    let point = draw.point();
    let mut plane = point.dual();
    plane.height += &Q::one();
    prop_assert_ne!(plane.dual(), point);
    Ok(())
}

fn duality_keeps_incidence<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (mut point, plane) = (draw.point(), draw.plane());
    // One and the same number says how far they are from being incident.
    prop_assert_eq!(plane.residual(&point), point.dual().residual(&plane.dual()));
    point.z = plane.height_at(&point.top_view());
    prop_assert!(point.dual().contains(&plane.dual()));
    let contact = draw.contact();
    prop_assert_eq!(contact.dual().point, contact.plane().dual());
    prop_assert_eq!(contact.dual().plane(), contact.point.dual());
    point.z += &Q::one();
    prop_assert!(!point.dual().contains(&plane.dual()));
    Ok(())
}

fn duality_exchanges_distance_and_angle<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (p, q) = (draw.point(), draw.point());
    prop_assert_eq!(p.i_distance2(&q), p.dual().i_angle2(&q.dual()));
    let (f, g) = (draw.plane(), draw.plane());
    prop_assert_eq!(f.i_angle2(&g), f.dual().i_distance2(&g.dual()));
    let mut wrong = q.dual();
    // d + d² + 2 is neither d nor −d.
    wrong.gradient.x += &((&q.x - &p.x).square() + Q::from_i64(2));
    prop_assert_ne!(p.i_distance2(&q), p.dual().i_angle2(&wrong));
    Ok(())
}

fn duality_exchanges_parallel_points_and_planes<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let p = draw.point();
    let mut q = p.top_view().at_height(draw.number());
    prop_assert!(p.is_parallel_to(&q) && p.dual().is_parallel_to(&q.dual()));
    q.y += &Q::one();
    prop_assert!(!p.is_parallel_to(&q) && !p.dual().is_parallel_to(&q.dual()));
    Ok(())
}

/// `duality-sigma`, in both directions: the two residuals agree up to sign.
fn planes_touch_sigma_at_their_poles<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let sigma = ParabolicSphere::unit();
    let plane = draw.plane();
    prop_assert_eq!(sigma.tangency(&plane), -sigma.residual(&plane.dual()));
    let touching = sigma.contact_at(&draw.top_view());
    prop_assert_eq!(touching.dual(), touching.clone());
    let mut tangent = touching.plane();
    prop_assert!(sigma.tangency(&tangent).is_zero() && tangent.dual() == touching.point);
    tangent.height += &Q::one();
    prop_assert!(!sigma.tangency(&tangent).is_zero() && !sigma.contains(&tangent.dual()));
    Ok(())
}

fn the_dual_of_a_sphere_envelops_the_polar_planes<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let sphere = draw.sphere();
    let contact = sphere.contact_at(&draw.top_view());
    let mut polar = contact.point.dual();
    prop_assert!(sphere.dual().contains(&contact.plane().dual()));
    prop_assert!(sphere.dual().tangency(&polar).is_zero());
    polar.height += &Q::one();
    prop_assert!(!sphere.dual().tangency(&polar).is_zero());
    Ok(())
}
