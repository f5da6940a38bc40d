//! i-motions and scalings (1): they are groups, and the images of objects fit together.

use std::fmt::Debug;

use isogeo::scalar::{RationalField, Ring};
use isogeo::space::*;
use proptest::prelude::*;

use super::{Draw, Verdict, laws};

laws! {
    motions_are_a_group
    scalings_are_a_group
    motions_keep_distances_and_angles
    motions_keep_incidence
    scalings_keep_incidence
    motions_keep_tangency_and_sections
    scalings_keep_tangency_and_sections
    a_circle_through_points_moves_with_them
    rotations_are_checked
}

/// `one` then `two` is the same in one step, `back` undoes `one`.
fn acts<G: Transform<X>, X: PartialEq + Debug>(
    [one, two, both, back, identity]: [&G; 5],
    object: &X,
) -> Verdict {
    let image = one.apply(object);
    prop_assert_eq!(both.apply(object), two.apply(&image));
    prop_assert_eq!(&back.apply(&image), object);
    prop_assert_eq!(&identity.apply(object), object);
    Ok(())
}

macro_rules! acts_on_everything {
    ($group:expr, $draw:expr) => {{
        let (group, draw) = ($group, $draw);
        acts(group, &draw.point())?;
        acts(group, &draw.top_view())?;
        acts(group, &draw.vector())?;
        acts(group, &(&draw.point() - &draw.point()))?;
        acts(group, &draw.gradient())?;
        acts(group, &draw.plane())?;
        acts(group, &draw.isotropic_plane())?;
        acts(group, &draw.contact())?;
        let sphere = draw.sphere();
        acts(group, &sphere)?;
        acts(group, &MoebiusSphere::from(draw.plane()))?;
        acts(group, &draw.cylinder())?;
        acts(group, &sphere.section(&draw.plane()))?;
        acts(group, &sphere.isotropic_section(&draw.isotropic_plane()))?;
        acts(group, &draw.polynomial().jet(&draw.top_view()).unwrap())?;
    }};
}

fn motions_are_a_group<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (m, n, identity) = (draw.motion(), draw.motion(), Motion::identity());
    let (both, back) = (m.then(&n), m.inverse());
    prop_assert_eq!(&m.then(&back), &identity);
    prop_assert_eq!(&back.then(&m), &identity);
    let k = draw.motion();
    prop_assert_eq!(both.then(&k), m.then(&n.then(&k)));
    let group = [&m, &n, &both, &back, &identity];
    acts_on_everything!(group, &mut *draw);
    acts(group, &draw.polynomial())?;

    let mut wrong = both.clone();
    wrong.shear.x += &Q::one();
    let off_axis = Point::new(Q::one(), Q::zero(), Q::zero());
    prop_assert!(acts([&m, &n, &wrong, &back, &identity], &off_axis).is_err());
    Ok(())
}

fn scalings_are_a_group<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (m, n, identity) = (draw.scaling(), draw.scaling(), Scaling::identity());
    let (both, back) = (m.then(&n), m.inverse());
    prop_assert_eq!(&m.then(&back), &identity);
    let group = [&m, &n, &both, &back, &identity];
    acts_on_everything!(group, &mut *draw);

    let vertical = both.vertical() + Q::one();
    prop_assume!(!vertical.is_zero());
    let wrong = Scaling::new(both.horizontal().clone(), vertical).unwrap();
    let up = Point::new(Q::zero(), Q::zero(), Q::one());
    prop_assert!(acts([&m, &n, &wrong, &back, &identity], &up).is_err());
    Ok(())
}

fn motions_keep_distances_and_angles<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let motion = draw.motion();
    let (p, q) = (draw.point(), draw.point());
    let (mp, mut mq) = (motion.apply(&p), motion.apply(&q));
    prop_assert_eq!(mp.i_distance2(&mq), p.i_distance2(&q));
    prop_assert_eq!(mp.top_view(), motion.apply(&p.top_view()));
    prop_assert_eq!(&mq - &mp, motion.apply(&(&q - &p)));

    let (f, g) = (draw.plane(), draw.plane());
    let (mf, mut mg) = (motion.apply(&f), motion.apply(&g));
    prop_assert_eq!(mf.i_angle2(&mg), f.i_angle2(&g));
    prop_assert_eq!(&mf.gradient, &motion.apply(&f.gradient));

    let above = Point::new(p.x.clone(), p.y.clone(), draw.number());
    prop_assert!(motion.apply(&above).is_parallel_to(&mp));
    let shifted = Plane::new(f.gradient.clone(), draw.number());
    prop_assert!(motion.apply(&shifted).is_parallel_to(&mf));

    // d + d² + 2 is neither d nor −d.
    mq.x += &((&mq.x - &mp.x).square() + Q::from_i64(2));
    prop_assert_ne!(mp.i_distance2(&mq), p.i_distance2(&q));
    mg.gradient.x += &((&mg.gradient.x - &mf.gradient.x).square() + Q::from_i64(2));
    prop_assert_ne!(mf.i_angle2(&mg), f.i_angle2(&g));
    prop_assert!(!motion.apply(&g).is_parallel_to(&mg));
    Ok(())
}

/// A point of each object lies on its image; a point beside it does not.
macro_rules! incidence {
    ($map:expr, $draw:expr) => {{
        let (map, draw) = ($map, $draw);
        let (at, u) = (draw.top_view(), draw.number());
        let plane = draw.plane();
        let mut image = map.apply(&plane.point_at(&at));
        prop_assert!(map.apply(&plane).contains(&image));
        image.z += &Q::one();
        prop_assert!(!map.apply(&plane).contains(&image));

        let contact = draw.contact();
        prop_assert_eq!(map.apply(&contact).plane(), map.apply(&contact.plane()));

        let sphere = draw.sphere();
        let contact = map.apply(&sphere.contact_at(&at));
        prop_assert_eq!(map.apply(&sphere).contact_at(&map.apply(&at)), contact.clone());
        prop_assert!(map.apply(&sphere).contains(&contact.point));
        prop_assert!(!map.apply(&sphere).contains(&(&contact.point + &up())));

        let line = draw.isotropic_plane();
        let parabola = sphere.isotropic_section(&line);
        let mut image = map.apply(&parabola.point_at(&u));
        prop_assert!(map.apply(&line).contains(&image));
        prop_assert!(map.apply(&parabola).contains(&image));
        image.z += &Q::one();
        prop_assert!(map.apply(&line).contains(&image));
        prop_assert!(!map.apply(&parabola).contains(&image));

        let on = draw.point();
        let cylinder =
            CylindricalSphere::new(Circle::new(at.clone(), at.distance2(&on.top_view())));
        prop_assume!(cylinder.is_ok());
        let cylinder = cylinder.unwrap();
        prop_assert!(cylinder.contains(&on) && map.apply(&cylinder).contains(&map.apply(&on)));
        let centre = map.apply(&at.at_height(Q::zero()));
        prop_assert!(!map.apply(&cylinder).contains(&centre));
    }};
}

fn up<Q: Ring>() -> Vector3<Q> {
    Vector3::new(Q::zero(), Q::zero(), Q::one())
}

fn motions_keep_incidence<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let motion = draw.motion();
    incidence!(&motion, &mut *draw);
    Ok(())
}

fn scalings_keep_incidence<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let scaling = draw.scaling();
    incidence!(&scaling, &mut *draw);
    Ok(())
}

/// Sections and tangent planes of images are the images of sections and tangent planes.
macro_rules! sections {
    ($map:expr, $draw:expr) => {{
        let (map, draw) = ($map, $draw);
        let (sphere, plane, line) = (draw.sphere(), draw.plane(), draw.isotropic_plane());
        let image = map.apply(&sphere);
        prop_assert_eq!(image.section(&map.apply(&plane)), map.apply(&sphere.section(&plane)));
        prop_assert_eq!(
            image.isotropic_section(&map.apply(&line)),
            map.apply(&sphere.isotropic_section(&line))
        );
        let mut tangent = map.apply(&sphere.tangent_plane(&draw.top_view()));
        prop_assert!(image.tangency(&tangent).is_zero());
        tangent.height += &Q::one();
        prop_assert!(!image.tangency(&tangent).is_zero());

        let cylinder = draw.cylinder();
        prop_assert_eq!(
            map.apply(&cylinder).section(&map.apply(&plane)),
            map.apply(&cylinder.section(&plane))
        );
        let centre = cylinder.top_view().centre.clone();
        let touching = line.residual(&centre).square() / line.direction().length2();
        prop_assume!(!touching.is_zero());
        let touching = CylindricalSphere::new(Circle::new(centre, touching)).unwrap();
        prop_assert!(map.apply(&touching).tangency(&map.apply(&line)).is_zero());
        let through =
            IsotropicPlane::new(touching.top_view().centre.clone(), line.direction().clone());
        prop_assert!(!map.apply(&touching).tangency(&map.apply(&through.unwrap())).is_zero());
    }};
}

fn motions_keep_tangency_and_sections<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let motion = draw.motion();
    sections!(&motion, &mut *draw);
    Ok(())
}

fn scalings_keep_tangency_and_sections<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let scaling = draw.scaling();
    sections!(&scaling, &mut *draw);
    Ok(())
}

fn a_circle_through_points_moves_with_them<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let motion = draw.motion();
    let [a, b, c] = [draw.point(), draw.point(), draw.point()];
    let Ok(circle) = ICircle::through(&a, &b, &c) else {
        let (u, v) = ((&b - &a).top_view(), (&c - &a).top_view());
        prop_assert!(u.det(&v).is_zero());
        return Ok(());
    };
    prop_assert!([&a, &b, &c].iter().all(|p| circle.contains(p)));
    let [ma, mb, mut mc] = [&a, &b, &c].map(|p| motion.apply(p));
    prop_assert_eq!(ICircle::through(&ma, &mb, &mc).unwrap(), motion.apply(&circle));
    mc.z += &Q::one();
    prop_assert_ne!(ICircle::through(&ma, &mb, &mc).unwrap(), motion.apply(&circle));
    Ok(())
}

fn rotations_are_checked<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let rotation = draw.rotation();
    let (c, s) = (rotation.cos().clone(), rotation.sin().clone());
    prop_assert_eq!(Rotation::new(c.clone(), s.clone()), Ok(rotation));
    prop_assume!(c != -Q::from_ratio(1, 2));
    prop_assert_eq!(Rotation::new(c + Q::one(), s), Err(SpaceError::NotARotation));
    Ok(())
}
