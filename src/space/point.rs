//! Points of isotropic space and their top views.

use std::ops::{Add, Neg, Sub};

use crate::scalar::{Ring, det3};

/// The top view `x' = (x, y)` of a point: its projection in the isotropic direction z (Sec. 2.1).
///
/// A top view is no [`Gradient`](super::Gradient), though both are pairs of numbers: only metric
/// duality turns one into the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TopView<T> {
    /// First coordinate.
    pub x: T,
    /// Second coordinate.
    pub y: T,
}

/// A point `(x, y, z)` of isotropic 3-space; z is the isotropic direction and points up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Point<T> {
    /// First coordinate.
    pub x: T,
    /// Second coordinate.
    pub y: T,
    /// Height, in the isotropic direction.
    pub z: T,
}

/// A difference of two top views, or of two gradients.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Vector2<T> {
    /// First coordinate.
    pub x: T,
    /// Second coordinate.
    pub y: T,
}

/// A difference of two points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Vector3<T> {
    /// First coordinate.
    pub x: T,
    /// Second coordinate.
    pub y: T,
    /// Height.
    pub z: T,
}

impl<T> TopView<T> {
    /// The top view `(x, y)`.
    pub const fn new(x: T, y: T) -> Self {
        TopView { x, y }
    }
}

impl<T> Point<T> {
    /// The point `(x, y, z)`.
    pub const fn new(x: T, y: T, z: T) -> Self {
        Point { x, y, z }
    }

    /// The point with `f` applied to every coordinate: the step from one scalar to another.
    pub fn map<S>(&self, mut f: impl FnMut(&T) -> S) -> Point<S> {
        Point { x: f(&self.x), y: f(&self.y), z: f(&self.z) }
    }

    /// The coordinates in order.
    pub fn coordinates(&self) -> [&T; 3] {
        [&self.x, &self.y, &self.z]
    }
}

impl<T: Clone> Point<T> {
    /// The top view `(x, y)`.
    pub fn top_view(&self) -> TopView<T> {
        TopView { x: self.x.clone(), y: self.y.clone() }
    }
}

impl<T: Ring> TopView<T> {
    /// The square of the i-distance: the Euclidean distance of top views (2).
    pub fn distance2(&self, other: &Self) -> T {
        (self - other).length2()
    }

    /// `|x'|²`.
    pub fn norm2(&self) -> T {
        self.x.square() + self.y.square()
    }

    /// The position vector: from the origin to this top view.
    pub fn position(&self) -> Vector2<T> {
        Vector2 { x: self.x.clone(), y: self.y.clone() }
    }

    /// The point over this top view at height `z`.
    pub fn at_height(&self, z: T) -> Point<T> {
        Point { x: self.x.clone(), y: self.y.clone(), z }
    }
}

impl<T: Ring> Point<T> {
    /// The square of the i-distance `(x₁ − x₂)² + (y₁ − y₂)²` (2).
    ///
    /// It stays squared, so that it stays in the field. Zero means parallel, not equal.
    ///
    /// ```
    /// use isogeo::space::Point;
    /// let (p, q) = (Point::new(0, 0, 5).map(|&c| c as f64), Point::new(3.0, 4.0, -7.0));
    /// assert_eq!(p.i_distance2(&q), 25.0);
    /// ```
    pub fn i_distance2(&self, other: &Self) -> T {
        let d = self - other;
        d.x.square() + d.y.square()
    }

    /// Whether two points have the same top view (*parallel points*, Sec. 2.1).
    pub fn is_parallel_to(&self, other: &Self) -> bool {
        self.x == other.x && self.y == other.y
    }
}

impl<T> Vector2<T> {
    /// The vector `(x, y)`.
    pub const fn new(x: T, y: T) -> Self {
        Vector2 { x, y }
    }
}

impl<T> Vector3<T> {
    /// The vector `(x, y, z)`.
    pub const fn new(x: T, y: T, z: T) -> Self {
        Vector3 { x, y, z }
    }
}

impl<T: Ring> Vector2<T> {
    /// The multiple `factor · v`.
    pub fn scaled(&self, factor: &T) -> Self {
        Vector2 { x: &self.x * factor, y: &self.y * factor }
    }

    /// The squared Euclidean length.
    pub fn length2(&self) -> T {
        self.x.square() + self.y.square()
    }

    /// The inner product.
    pub fn dot(&self, other: &Self) -> T {
        T::dot([&self.x, &self.y], [&other.x, &other.y])
    }

    /// `det(a, b) = a₁ b₂ − a₂ b₁`; positive if `other` lies counter-clockwise of `self`.
    pub fn det(&self, other: &Self) -> T {
        T::det2(&self.x, &self.y, &other.x, &other.y)
    }

    /// The vector turned by a right angle counter-clockwise, `J(a, b) = (−b, a)`.
    pub fn turned(&self) -> Self {
        Vector2 { x: -&self.y, y: self.x.clone() }
    }
}

impl<T: Ring> Vector3<T> {
    /// The multiple `factor · v`.
    pub fn scaled(&self, factor: &T) -> Self {
        Vector3 { x: &self.x * factor, y: &self.y * factor, z: &self.z * factor }
    }

    /// The top view of the vector.
    pub fn top_view(&self) -> Vector2<T> {
        Vector2 { x: self.x.clone(), y: self.y.clone() }
    }

    /// The squared *Euclidean* length; the isotropic one is that of the top view.
    pub fn length2(&self) -> T {
        T::dot([&self.x, &self.y, &self.z], [&self.x, &self.y, &self.z])
    }

    /// The Euclidean inner product.
    pub fn dot(&self, other: &Self) -> T {
        T::dot([&self.x, &self.y, &self.z], [&other.x, &other.y, &other.z])
    }

    /// The cross product.
    pub fn cross(&self, other: &Self) -> Self {
        Vector3 {
            x: T::det2(&self.y, &self.z, &other.y, &other.z),
            y: T::det2(&self.z, &self.x, &other.z, &other.x),
            z: T::det2(&self.x, &self.y, &other.x, &other.y),
        }
    }

    /// The determinant of three vectors: six times a signed volume, 0 iff they are coplanar.
    pub fn det(a: &Self, b: &Self, c: &Self) -> T {
        det3([&a.x, &a.y, &a.z], [&b.x, &b.y, &b.z], [&c.x, &c.y, &c.z])
    }
}

impl<T: Ring> Sub for &TopView<T> {
    type Output = Vector2<T>;
    fn sub(self, other: Self) -> Vector2<T> {
        Vector2 { x: &self.x - &other.x, y: &self.y - &other.y }
    }
}

impl<T: Ring> Add<&Vector2<T>> for &TopView<T> {
    type Output = TopView<T>;
    fn add(self, v: &Vector2<T>) -> TopView<T> {
        TopView { x: &self.x + &v.x, y: &self.y + &v.y }
    }
}

impl<T: Ring> Add for &Vector2<T> {
    type Output = Vector2<T>;
    fn add(self, other: Self) -> Vector2<T> {
        Vector2 { x: &self.x + &other.x, y: &self.y + &other.y }
    }
}

impl<T: Ring> Neg for &Vector2<T> {
    type Output = Vector2<T>;
    fn neg(self) -> Vector2<T> {
        Vector2 { x: -&self.x, y: -&self.y }
    }
}

impl<T: Ring> Sub for &Point<T> {
    type Output = Vector3<T>;
    fn sub(self, other: Self) -> Vector3<T> {
        Vector3 { x: &self.x - &other.x, y: &self.y - &other.y, z: &self.z - &other.z }
    }
}

impl<T: Ring> Add for &Vector3<T> {
    type Output = Vector3<T>;
    fn add(self, v: &Vector3<T>) -> Vector3<T> {
        Vector3 { x: &self.x + &v.x, y: &self.y + &v.y, z: &self.z + &v.z }
    }
}

impl<T: Ring> Sub for &Vector3<T> {
    type Output = Vector3<T>;
    fn sub(self, v: &Vector3<T>) -> Vector3<T> {
        Vector3 { x: &self.x - &v.x, y: &self.y - &v.y, z: &self.z - &v.z }
    }
}

impl<T: Ring> Add<&Vector3<T>> for &Point<T> {
    type Output = Point<T>;
    fn add(self, v: &Vector3<T>) -> Point<T> {
        Point { x: &self.x + &v.x, y: &self.y + &v.y, z: &self.z + &v.z }
    }
}
