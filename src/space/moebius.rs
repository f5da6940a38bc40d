//! i-M-transformations: the Möbius geometry of isotropic space (Sec. 2.1).

use super::similarity::{Model, Similarity};
use super::{
    Circle, CylindricalSphere, Gradient, ICircle, MoebiusSphere, Motion, OrientedCircle, Plane,
    Point, Scaling, SpaceError, TopView, Transform,
};
use crate::scalar::{Field, Ring};

/// i-M-spheres as points `(A, B, C, D)`, with `⟨s, s⟩ = B² + C² − 2AD`.
///
/// The inner product of a difference with itself is 0 iff the i-M-spheres touch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct IsotropicModel;

impl Model for IsotropicModel {
    fn lower<T: Ring>([a, b, c, d]: &[T; 4]) -> [T; 4] {
        [-d, b.clone(), c.clone(), -a]
    }
}

/// An i-M-transformation: it maps i-M-spheres `(A, B, C, D)` by an affine similarity, and points, as
/// intersections of i-M-spheres, accordingly.
///
/// Generators are i-motions, scalings, and the inversions at i-spheres of both types. The group is
/// isomorphic to that of [L-transformations](super::laguerre::LaguerreTransformation), by `From` in both directions; with factor
/// `k = 1` it is M₁₀ⁱ. A vertical scaling by μ after a horizontal one by λ has `k = (μ/λ)²`.
///
/// The point over `x'` at height z counts as `d = (1, −x, −y, |x'|²/2)`, the *point circle*, with
/// `⟨d, s⟩ = −z` for the i-M-spheres s through it; an i-circle in the plane `z = p·x' + t` as the line
/// from `(0, p, t)` in the direction `(1, −m, (|m|² − r²)/2)`. If the first coordinate of the image of
/// the direction is 0, the object passes through the centre and goes to infinity.
///
/// ```
/// use isogeo::space::{Circle, CylindricalSphere, MoebiusTransformation, Point, SpaceError, TopView};
/// let unit = CylindricalSphere::new(Circle::new(TopView::new(0.0, 0.0), 1.0))?;
/// let inversion = MoebiusTransformation::inversion_at_cylinder(&unit, &0.0);
/// let image = inversion.map_point(&Point::new(2.0, 0.0, 3.0));
/// assert_eq!(image, Ok(Point::new(0.5, 0.0, 0.75))); // divided by |x'|² = 4
/// let centre = inversion.map_point(&Point::new(0.0, 0.0, 3.0));
/// assert_eq!(centre, Err(SpaceError::AtInfinity));
/// # Ok::<(), SpaceError>(())
/// ```
pub type MoebiusTransformation<T> = Similarity<T, IsotropicModel>;

impl<T: Clone> MoebiusSphere<T> {
    /// The coefficients `[A, B, C, D]`.
    pub fn coefficients(&self) -> [T; 4] {
        let Plane { gradient, height } = &self.plane;
        [self.a.clone(), gradient.x.clone(), gradient.y.clone(), height.clone()]
    }
}

impl<T> From<[T; 4]> for MoebiusSphere<T> {
    fn from([a, b, c, d]: [T; 4]) -> Self {
        MoebiusSphere::new(a, b, c, d)
    }
}

impl<T: Field> MoebiusTransformation<T> {
    /// The inversion at an i-M-sphere, `z ↦ 2 s(x') − z`: the top view stays.
    ///
    /// ```
    /// use isogeo::space::{MoebiusSphere, MoebiusTransformation, Point};
    /// let sigma = MoebiusSphere::new(1.0, 0.0, 0.0, 0.0);
    /// let image = MoebiusTransformation::inversion_at(&sigma).map_point(&Point::new(2.0, 0.0, 5.0));
    /// assert_eq!(image, Ok(Point::new(2.0, 0.0, -1.0))); // Σ has height 2 there
    /// ```
    pub fn inversion_at(sphere: &MoebiusSphere<T>) -> Self {
        Similarity::reflection_at_point(&sphere.coefficients())
    }

    /// The inversion at an i-sphere of cylindrical type, with the centre `c` at a height on its axis:
    /// `x ↦ c + r² (x − c)/|x' − c'|²`. The top view is inverted at the circle.
    ///
    /// An imaginary sphere has `r² < 0`. Points of the axis go to infinity.
    pub fn inversion_at_cylinder(sphere: &CylindricalSphere<T>, height: &T) -> Self {
        let direction = direction(sphere.top_view());
        let scale = T::from_i64(2) / &sphere.top_view().radius2;
        // The plane at the height of the centre stays.
        let level = [T::zero(), T::zero(), T::zero(), height.clone()];
        let reflect = |s: [T; 4]| {
            let s: [T; 4] = std::array::from_fn(|i| &s[i] - &level[i]);
            let twice = IsotropicModel::product(&s, &direction) * &scale;
            std::array::from_fn(|i| &s[i] - &twice * &direction[i] + &level[i])
        };
        Similarity::of_affine(reflect, T::one())
    }

    /// `z ↦ z + s(x')`, which adds an i-M-sphere.
    pub fn addition(sphere: &MoebiusSphere<T>) -> Self {
        Similarity::translation(sphere.coefficients())
    }

    /// The image of an i-M-sphere. A plane may become a sphere, and conversely.
    pub fn map_sphere(&self, sphere: &MoebiusSphere<T>) -> MoebiusSphere<T> {
        self.image(&sphere.coefficients()).into()
    }

    /// The image of a point.
    ///
    /// # Errors
    /// [`SpaceError::AtInfinity`] over the centre.
    pub fn map_point(&self, point: &Point<T>) -> Result<Point<T>, SpaceError> {
        let start = direction(&Circle::new(point.top_view(), T::zero()));
        let (direction, height) = self.hyperplane(&start, &point.z);
        let (at, scale) = centre_of(direction)?;
        Ok(at.at_height(height * scale))
    }

    /// The image of a top view under the planar Möbius transformation that this one appears as.
    ///
    /// # Errors
    /// [`SpaceError::AtInfinity`] at the centre.
    pub fn map_top_view(&self, at: &TopView<T>) -> Result<TopView<T>, SpaceError> {
        Ok(self.map_point(&at.at_height(T::zero()))?.top_view())
    }

    /// The image of an i-circle of elliptic type.
    ///
    /// The inversion at the unit cylinder maps the i-circle with the centre c and the radius ρ in the
    /// plane `z = p·x' + t` to that with the centre `c/N` and the radius `ρ/N`, `N = |c|² − ρ²`, in the
    /// plane with `p + 2tc/N` and `−t/N`.
    ///
    /// # Errors
    /// [`SpaceError::AtInfinity`] if the top view passes through the centre: the image is an i-circle
    /// of parabolic type or a line.
    pub fn map_circle(&self, circle: &ICircle<T>) -> Result<ICircle<T>, SpaceError> {
        let line = self.turn(&direction(&circle.top_view));
        let [a, b, c, d] = self.image(&MoebiusSphere::from(circle.plane.clone()).coefficients());
        let (centre, scale) = centre_of(line.clone())?;
        let radius2 = &circle.top_view.radius2 * self.factor() * scale.square();
        // The point of the line with first coordinate 0 is the plane.
        let [_, x, y, t] = line.map(|coordinate| &a * &scale * coordinate);
        let plane = Plane::new(Gradient::new(b - x, c - y), d - t);
        Ok(ICircle { plane, top_view: Circle::new(centre, radius2) })
    }

    /// The image of a circle of the top view together with a point over its centre.
    ///
    /// They stand for all i-circles in planes through the point whose top views are orthogonal to the
    /// circle; the images of these are related in the same way to the image. It is no image of the
    /// point alone, unless the radius is 0. The inversion at the unit cylinder has `m/N`, `r/N` and
    /// `z/N` with `N = |m|² − r²`, so the radius changes its sign where the circle is around the centre.
    ///
    /// ```
    /// use isogeo::space::{Circle, CylindricalSphere, MoebiusTransformation, OrientedCircle, SpaceError, TopView};
    /// let unit = CylindricalSphere::new(Circle::new(TopView::new(0.0, 0.0), 1.0))?;
    /// let inversion = MoebiusTransformation::inversion_at_cylinder(&unit, &0.0);
    /// let circle = OrientedCircle { centre: TopView::new(1.0, 0.0), radius: 3.0 };
    /// let (image, height) = inversion.map_centred(&circle, &4.0)?;
    /// assert_eq!((image.centre.x, image.radius, height), (-0.125, -0.375, -0.5)); // N = −8
    /// # Ok::<(), SpaceError>(())
    /// ```
    ///
    /// # Errors
    /// [`SpaceError::AtInfinity`] if the circle passes through the centre. [`SpaceError::NotAnIsometry`]
    /// for a factor `k ≠ 1`, whose root the radius would take.
    pub fn map_centred(
        &self,
        circle: &OrientedCircle<T>,
        height: &T,
    ) -> Result<(OrientedCircle<T>, T), SpaceError> {
        if *self.factor() != T::one() {
            return Err(SpaceError::NotAnIsometry);
        }
        let (direction, height) = self.hyperplane(&direction(&circle.circle()), height);
        let (centre, scale) = centre_of(direction)?;
        let radius = &circle.radius * &scale;
        Ok((OrientedCircle { centre, radius }, height * scale))
    }
}

/// `(1, −m, (|m|² − r²)/2)`, with `⟨d, d⟩ = r²`: the direction of the lines that are the i-circles over
/// a circle.
fn direction<T: Field>(Circle { centre, radius2 }: &Circle<T>) -> [T; 4] {
    let half = (centre.norm2() - radius2) * T::from_ratio(1, 2);
    [T::one(), -&centre.x, -&centre.y, half]
}

/// The centre of the circle in a direction with any first coordinate but 0, and the inverse of that
/// coordinate.
fn centre_of<T: Field>([a, b, c, _]: [T; 4]) -> Result<(TopView<T>, T), SpaceError> {
    let scale = a.try_inv().ok_or(SpaceError::AtInfinity)?;
    Ok((TopView::new(-b * &scale, -c * &scale), scale))
}

impl<T: Field> From<&Motion<T>> for MoebiusTransformation<T> {
    fn from(motion: &Motion<T>) -> Self {
        Similarity::of_affine(by_spheres(motion), T::one())
    }
}

impl<T: Field> From<&Scaling<T>> for MoebiusTransformation<T> {
    fn from(scaling: &Scaling<T>) -> Self {
        let factor = (scaling.vertical() / scaling.horizontal()).square();
        Similarity::of_affine(by_spheres(scaling), factor)
    }
}

fn by_spheres<T: Field>(map: &impl Transform<MoebiusSphere<T>>) -> impl Fn([T; 4]) -> [T; 4] {
    |coefficients| map.apply(&coefficients.into()).coefficients()
}
