//! i-motions: the isotropic congruence transformations (1).

use super::{SpaceError, Vector2, Vector3};
use crate::scalar::{Field, Ring};

/// A rotation of the top view by an angle with cosine `c` and sine `s`, counter-clockwise.
///
/// ```
/// use isogeo::space::{Rotation, SpaceError, Vector2};
/// let quarter = Rotation::new(0.0, 1.0)?;
/// assert_eq!(quarter.turn(&Vector2::new(1.0, 0.0)), Vector2::new(0.0, 1.0));
/// assert_eq!(Rotation::new(1.0, 1.0), Err(SpaceError::NotARotation));
/// # Ok::<(), SpaceError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Rotation<T> {
    c: T,
    s: T,
}

impl<T> Rotation<T> {
    /// The cosine.
    pub fn cos(&self) -> &T {
        &self.c
    }

    /// The sine.
    pub fn sin(&self) -> &T {
        &self.s
    }
}

impl<T: Ring> Rotation<T> {
    /// The rotation with cosine `c` and sine `s`.
    ///
    /// # Errors
    /// [`SpaceError::NotARotation`] unless `c² + s² = 1`, without tolerance; types that round
    /// have [`from_parameter`](Rotation::from_parameter) and [`by_angle`](Rotation::by_angle).
    pub fn new(c: T, s: T) -> Result<Self, SpaceError> {
        if c.square() + s.square() != T::one() {
            return Err(SpaceError::NotARotation);
        }
        Ok(Rotation { c, s })
    }

    /// The rotation by the angle 0.
    pub fn identity() -> Self {
        Rotation { c: T::one(), s: T::zero() }
    }

    /// The rotation by the opposite angle.
    pub fn inverse(&self) -> Self {
        Rotation { c: self.c.clone(), s: -&self.s }
    }

    /// This rotation, then `next`: the sum of the angles.
    pub fn then(&self, next: &Self) -> Self {
        Rotation {
            c: T::det2(&self.c, &self.s, &next.s, &next.c),
            s: T::dot([&self.c, &self.s], [&next.s, &next.c]),
        }
    }

    /// The image of a vector of the top view.
    pub fn turn(&self, v: &Vector2<T>) -> Vector2<T> {
        Vector2 {
            x: T::det2(&self.c, &self.s, &v.y, &v.x),
            y: T::dot([&self.s, &self.c], [&v.x, &v.y]),
        }
    }
}

impl<T: Field> Rotation<T> {
    /// The rational rotation `c = (1 − t²)/(1 + t²)`, `s = 2t/(1 + t²)`; `t` is the tangent of
    /// half the angle. Every rotation arises but the half turn `(−1, 0)`.
    ///
    /// # Errors
    /// [`SpaceError::NotARotation`] if `1 + t² = 0`, which no ordered field allows.
    pub fn from_parameter(t: &T) -> Result<Self, SpaceError> {
        let (one, t2) = (T::one(), t.square());
        let scale = (&one + &t2).try_inv().ok_or(SpaceError::NotARotation)?;
        Ok(Rotation { c: (one - t2) * &scale, s: t * T::from_i64(2) * scale })
    }
}

impl Rotation<f64> {
    /// The rotation by an angle in radians, counter-clockwise; `c² + s² = 1` up to rounding.
    pub fn by_angle(angle: f64) -> Self {
        Rotation { c: angle.cos(), s: angle.sin() }
    }
}

/// An i-motion (1): `x' ↦ R x' + (a, b)`, `z ↦ c + c₁x + c₂y + z`.
///
/// What it does to points, planes and the rest: [`Transform`](super::Transform).
///
/// ```
/// use isogeo::space::{Motion, Point, Rotation, Transform, Vector2, Vector3};
/// let motion = Motion {
///     rotation: Rotation::new(0.0, 1.0)?,
///     shear: Vector2::new(10.0, 0.0),
///     translation: Vector3::new(0.0, 0.0, 5.0),
/// };
/// assert_eq!(motion.apply(&Point::new(1.0, 0.0, 0.0)), Point::new(0.0, 1.0, 15.0));
/// # Ok::<(), isogeo::space::SpaceError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Motion<T> {
    /// The rotation `R` of the top view.
    pub rotation: Rotation<T>,
    /// The shear `(c₁, c₂)`: a difference of gradients, in the coordinates before the rotation.
    pub shear: Vector2<T>,
    /// The translation `(a, b, c)`.
    pub translation: Vector3<T>,
}

impl<T: Ring> Motion<T> {
    /// The motion in another ring: `f` must be a homomorphism, so that rotations stay rotations.
    pub(super) fn map<S: Ring>(&self, f: impl Fn(&T) -> S) -> Motion<S> {
        let Motion { rotation, shear, translation } = self;
        Motion {
            rotation: Rotation { c: f(&rotation.c), s: f(&rotation.s) },
            shear: Vector2::new(f(&shear.x), f(&shear.y)),
            translation: Vector3::new(f(&translation.x), f(&translation.y), f(&translation.z)),
        }
    }

    /// The motion that moves nothing.
    pub fn identity() -> Self {
        let zero = T::zero;
        Motion {
            rotation: Rotation::identity(),
            shear: Vector2::new(zero(), zero()),
            translation: Vector3::new(zero(), zero(), zero()),
        }
    }

    /// This motion, then `next`.
    pub fn then(&self, next: &Self) -> Self {
        let (start, step) = (&self.translation, &next.translation);
        let turned = next.rotation.turn(&start.top_view());
        Motion {
            rotation: self.rotation.then(&next.rotation),
            shear: &self.shear + &self.rotation.inverse().turn(&next.shear),
            translation: Vector3 {
                x: turned.x + &step.x,
                y: turned.y + &step.y,
                z: &start.z + &step.z + next.shear.dot(&start.top_view()),
            },
        }
    }

    /// The motion that undoes this one.
    pub fn inverse(&self) -> Self {
        let rotation = self.rotation.inverse();
        let shear = -&self.rotation.turn(&self.shear);
        let back = -&rotation.turn(&self.translation.top_view());
        let rise = shear.dot(&self.translation.top_view()) + &self.translation.z;
        Motion { rotation, shear, translation: Vector3 { x: back.x, y: back.y, z: -rise } }
    }
}
