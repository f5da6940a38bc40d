//! Transformations of isotropic space.

use proptest::prelude::*;

use super::number::{nonzero, number, small};
use crate::scalar::Field;
use crate::space::laguerre::LaguerreTransformation;
use crate::space::{
    Circle, CylindricalSphere, MoebiusSphere, MoebiusTransformation, Motion, Rotation, Scaling,
    TopView, Vector2, Vector3,
};

/// Rational rotations of the top view: the tangent of half the angle is a small fraction.
pub fn rotation<Q: Field>() -> impl Strategy<Value = Rotation<Q>> {
    small().prop_filter_map("ordered fields have all", |t| Rotation::from_parameter(&t).ok())
}

/// i-motions (1).
pub fn motion<Q: Field>() -> impl Strategy<Value = Motion<Q>> {
    (rotation(), [small(), small()], [number(), number(), number()]).prop_map(
        |(rotation, [c, d], [x, y, z])| Motion {
            rotation,
            shear: Vector2::new(c, d),
            translation: Vector3::new(x, y, z),
        },
    )
}

/// Scalings of the top view and of heights, by factors of either sign.
pub fn scaling<Q: Field>() -> impl Strategy<Value = Scaling<Q>> {
    (nonzero(), nonzero()).prop_filter_map("no factor is 0", |(x, z)| Scaling::new(x, z).ok())
}

/// i-M-transformations: an i-motion and a scaling, with inversions at i-spheres of both types before
/// and between them.
pub fn moebius<Q: Field>() -> impl Strategy<Value = MoebiusTransformation<Q>> {
    let centre = [small::<Q>(), small(), small()];
    let cylinder = (centre, nonzero()).prop_filter_map("a radius", |([x, y, z], radius2)| {
        let sphere = CylindricalSphere::new(Circle::new(TopView::new(x, y), radius2)).ok()?;
        Some(MoebiusTransformation::inversion_at_cylinder(&sphere, &z))
    });
    let sphere = [small(), small(), small(), small()]
        .prop_map(|sphere| MoebiusTransformation::inversion_at(&MoebiusSphere::from(sphere)));
    let inversions = (prop::option::of(sphere), prop::option::of(cylinder));
    (inversions, motion(), scaling()).prop_map(|((sphere, cylinder), motion, scaling)| {
        let inversions = [sphere, cylinder].into_iter().flatten();
        let similarity = MoebiusTransformation::from(&motion).then(&(&scaling).into());
        inversions.fold(similarity, |map, inversion| inversion.then(&map))
    })
}

/// L-transformations: the i-M-transformations in the coordinates of Laguerre geometry (Sec. 2.2).
pub fn laguerre<Q: Field>() -> impl Strategy<Value = LaguerreTransformation<Q>> {
    moebius().prop_map(|map| LaguerreTransformation::from(&map))
}
