//! Similarities of the 4-space of spheres: what i-M-transformations and L-transformations have in
//! common (Sec. 2.2).

use std::array::from_fn;
use std::fmt::Debug;
use std::marker::PhantomData;

use super::SpaceError;
use crate::scalar::{Field, Ring};

/// Coordinates for spheres as points of a 4-space, with their inner product `⟨x, y⟩ = xᵀ G y`.
///
/// There are two: [`StandardModel`](super::laguerre::StandardModel), `(m₁, m₂, m₃, r)`, and
/// [`IsotropicModel`](super::IsotropicModel), `(A, B, C, D)`. In both `G² = 1`.
pub trait Model: Copy + Debug + PartialEq + Send + Sync + 'static {
    /// `G x`.
    fn lower<T: Ring>(x: &[T; 4]) -> [T; 4];

    /// `⟨x, y⟩`.
    fn product<T: Ring>(x: &[T; 4], y: &[T; 4]) -> T {
        T::dot(x.each_ref(), Self::lower(y).each_ref())
    }
}

/// An affine similarity `x ↦ R x + a` with `Rᵀ G R = k G`, `k ≠ 0`, of the spheres in coordinates `M`.
///
/// Two spheres touch iff the difference of their points is isotropic, so similarities keep
/// tangency. Those with factor `k = 1` make up the groups of the paper, with six parameters in R and
/// four in a: `RᵀDR = D` of Sec. 2.2 and M₁₀ⁱ of Sec. 2.1. The representation is faithful, and since
/// both are kept as matrices the group needs no normal form: equal maps are equal values. The
/// matrices are arrays: linear algebra crates ask for number traits that exact scalars of other
/// crates do not have, and four rows need no more than three loops.
///
/// They are used as [`MoebiusTransformation`](super::MoebiusTransformation) and
/// [`LaguerreTransformation`](super::laguerre::LaguerreTransformation).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Similarity<T, M> {
    linear: [[T; 4]; 4],
    shift: [T; 4],
    factor: T,
    model: PhantomData<M>,
}

impl<T, M> Similarity<T, M> {
    /// The matrix R, by rows.
    pub const fn linear(&self) -> &[[T; 4]; 4] {
        &self.linear
    }

    /// The vector a.
    pub const fn shift(&self) -> &[T; 4] {
        &self.shift
    }

    /// The factor k of inner products; 1 for the transformations of the paper.
    pub const fn factor(&self) -> &T {
        &self.factor
    }
}

impl<T: Ring, M: Model> Similarity<T, M> {
    /// The map `x ↦ R x + a`, R by rows.
    ///
    /// ```
    /// use isogeo::space::{SpaceError, laguerre::LaguerreTransformation};
    /// let (mut r, a) = ([[0.0; 4]; 4], [0.0; 4]);
    /// (0..4).for_each(|i| r[i][i] = 1.0);
    /// r[3][3] = -1.0; // turns the orientation of every sphere
    /// assert!(LaguerreTransformation::new(r, a).is_ok());
    /// r[3][3] = 2.0;
    /// assert_eq!(LaguerreTransformation::new(r, a), Err(SpaceError::NotAnIsometry));
    /// ```
    ///
    /// # Errors
    /// [`SpaceError::NotAnIsometry`] unless `Rᵀ G R = G`, without tolerance; types that round
    /// compose [reflections](Similarity::reflection) and the like instead.
    pub fn new(linear: [[T; 4]; 4], shift: [T; 4]) -> Result<Self, SpaceError> {
        Similarity::with_factor(linear, shift, T::one())
    }

    /// The map `x ↦ R x + a` with the factor k of inner products.
    ///
    /// # Errors
    /// [`SpaceError::NotAnIsometry`] unless `Rᵀ G R = k G`; [`SpaceError::ZeroFactor`] if `k = 0`.
    pub fn with_factor(linear: [[T; 4]; 4], shift: [T; 4], factor: T) -> Result<Self, SpaceError> {
        if factor.is_zero() {
            return Err(SpaceError::ZeroFactor);
        }
        let images = transposed(&linear);
        let units = unit_vectors::<T>();
        let fits = |i: usize, j: usize| {
            M::product(&images[i], &images[j]) == M::product(&units[i], &units[j]) * &factor
        };
        if !(0..4).all(|i| (i..4).all(|j| fits(i, j))) {
            return Err(SpaceError::NotAnIsometry);
        }
        Ok(Similarity::trusted(linear, shift, factor))
    }

    /// The map with a matrix that is known to fit.
    pub(super) fn trusted(linear: [[T; 4]; 4], shift: [T; 4], factor: T) -> Self {
        Similarity { linear, shift, factor, model: PhantomData }
    }

    /// The affine map that `f` is, with its factor.
    pub(super) fn of_affine(f: impl Fn([T; 4]) -> [T; 4], factor: T) -> Self {
        let shift = f(from_fn(|_| T::zero()));
        let images = unit_vectors().map(|unit| {
            let image = f(unit);
            from_fn(|i| &image[i] - &shift[i])
        });
        Similarity::trusted(transposed(&images), shift, factor)
    }

    /// The map that moves nothing.
    pub fn identity() -> Self {
        Similarity::translation(from_fn(|_| T::zero()))
    }

    /// `x ↦ x + a`.
    pub fn translation(shift: [T; 4]) -> Self {
        Similarity::trusted(unit_vectors(), shift, T::one())
    }

    /// `x ↦ 2s − x`, the reflection at a sphere as a point.
    pub fn reflection_at_point(point: &[T; 4]) -> Self {
        let linear = unit_vectors().map(|row: [T; 4]| row.map(|x| -x));
        Similarity::trusted(linear, from_fn(|i| &point[i] + &point[i]), T::one())
    }

    /// `R v`, the image of a difference of spheres.
    pub fn turn(&self, v: &[T; 4]) -> [T; 4] {
        self.linear.each_ref().map(|row| T::dot(row.each_ref(), v.each_ref()))
    }

    /// `R x + a`, the image of a sphere.
    pub fn image(&self, x: &[T; 4]) -> [T; 4] {
        let turned = self.turn(x);
        from_fn(|i| &turned[i] + &self.shift[i])
    }

    /// The image of the hyperplane `⟨d, x⟩ = −w` as `(R d, k w − ⟨R d, a⟩)`. With isotropic `d` it
    /// consists of the spheres that touch a plane, or pass through a point of isotropic space.
    pub(super) fn hyperplane(&self, d: &[T; 4], w: &T) -> ([T; 4], T) {
        let normal = self.turn(d);
        let value = &self.factor * w - M::product(&normal, &self.shift);
        (normal, value)
    }

    /// This map, then `next`.
    pub fn then(&self, next: &Self) -> Self {
        let columns = transposed(&self.linear).map(|column| next.turn(&column));
        let factor = &self.factor * &next.factor;
        Similarity::trusted(transposed(&columns), next.image(&self.shift), factor)
    }
}

impl<T: Field, M: Model> Similarity<T, M> {
    /// The map that undoes this one: its matrix is `G Rᵀ G / k`.
    pub fn inverse(&self) -> Self {
        let scale = T::one() / &self.factor;
        let right = transposed(&self.linear).map(|column| M::lower(&column));
        let both = transposed(&right).map(|column| M::lower(&column));
        let linear = transposed(&both).map(|row| row.map(|x| x * &scale));
        let mut inverse = Similarity::trusted(linear, from_fn(|_| T::zero()), scale);
        inverse.shift = inverse.turn(&self.shift).map(|x| -x);
        inverse
    }

    /// The reflection `x ↦ x − 2 ⟨x, v⟩/⟨v, v⟩ v` at the hyperplane orthogonal to `v`. These
    /// generate all matrices R with `Rᵀ G R = G`.
    ///
    /// # Errors
    /// [`SpaceError::IsotropicVector`] if `⟨v, v⟩ = 0`.
    pub fn reflection(v: &[T; 4]) -> Result<Self, SpaceError> {
        let inverse = M::product(v, v).try_inv().ok_or(SpaceError::IsotropicVector)?;
        let reflect = |x: [T; 4]| {
            let twice = M::product(&x, v) * &inverse * T::from_i64(2);
            from_fn(|i| &x[i] - &twice * &v[i])
        };
        Ok(Similarity::of_affine(reflect, T::one()))
    }
}

fn unit_vectors<T: Ring>() -> [[T; 4]; 4] {
    from_fn(|i| from_fn(|j| T::from_i64(i64::from(i == j))))
}

fn transposed<T: Clone>(matrix: &[[T; 4]; 4]) -> [[T; 4]; 4] {
    from_fn(|i| from_fn(|j| matrix[j][i].clone()))
}
