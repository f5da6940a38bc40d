//! H and K with what follows from them alone.

use super::Roots;
use crate::scalar::{Approx, BigInt, Field, Fraction, Ordered, RationalField, Ring, Sign};

/// The i-mean curvature H and the i-curvature K of a face (17) or of a vertex (22).
///
/// Both stay if the orientation of both meshes is reversed. Σ as its own Gauss image has
/// `H = K = 1`; the sign of the shape operator is that of (7).
///
/// ```
/// use isogeo::pair::{Curvatures, Roots};
/// use isogeo::scalar::{Field, Rational, Ring};
/// let q = |n| Rational::from_i64(n);
/// let saddle = Curvatures { mean: q(0), gauss: q(-1) };
/// let half = Rational::from_ratio(1, 2);
/// let offset = Curvatures { mean: Rational::from_ratio(-2, 3), gauss: Rational::from_ratio(-4, 3) };
/// assert_eq!(saddle.offset(&half), Some(offset));
/// assert_eq!(saddle.v_offset(&half).gauss, Rational::from_ratio(-3, 4));
/// assert_eq!(saddle.principal().exact(), Some([q(-1), q(1)].as_slice()));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Curvatures<T> {
    /// The mean curvature H.
    pub mean: T,
    /// The curvature K.
    pub gauss: T,
}

impl<T: Ring> Curvatures<T> {
    /// `H² − K`: negative where there are no principal curvatures.
    ///
    /// Never negative at convex faces parallel to convex faces (Minkowski).
    pub fn discriminant(&self) -> T {
        self.mean.square() - &self.gauss
    }

    /// H and K of the vertex of the mesh `M + d·z_S`, whose vertices are moved vertically, in a
    /// v-parallel pair: `H + d` and `K + 2dH + d²`, the dual of (18).
    pub fn v_offset(&self, d: &T) -> Self {
        let mean = &self.mean + d;
        let gauss = &self.gauss + d * (&self.mean + &mean);
        Curvatures { mean, gauss }
    }
}

impl<T: Field> Curvatures<T> {
    /// (18): H and K of the face `F + dS` of the offset, seen with the same S:
    /// `H(Fᵈ) = (H + dK)/(1 + 2dH + d²K)`, `K(Fᵈ) = K/(1 + 2dH + d²K)`.
    ///
    /// `None` where the denominator vanishes: the face has area 0.
    pub fn offset(&self, d: &T) -> Option<Self> {
        let mean = &self.mean + d * &self.gauss;
        let scale = (T::one() + d * (&self.mean + &mean)).try_inv()?;
        Some(Curvatures { mean: mean * &scale, gauss: &self.gauss * scale })
    }

    /// The distance `d = −1/H` at which the offset has the mean curvature `−H`, if `K ≠ H²`; a
    /// mesh with constant H has one with constant `−H`. `None` where `H = 0`.
    pub fn distance_to_opposite_mean(&self) -> Option<T> {
        (-&self.mean).try_inv()
    }

    /// The distance `d = −1/(2H)` at which the offset has the curvature `4H²`, if `K ≠ 0`; a mesh
    /// with constant H has one with constant K. `None` where `H = 0`.
    pub fn distance_to_constant_gauss(&self) -> Option<T> {
        (T::from_i64(-2) * &self.mean).try_inv()
    }

    /// (11): `H/K` and `1/K`, the curvatures of the dual element; `None` where `K = 0`.
    ///
    /// For a vertex of a v-parallel pair they are those of the dual face, and conversely.
    pub fn dual(&self) -> Option<Self> {
        let gauss = self.gauss.try_inv()?;
        Some(Curvatures { mean: &self.mean * &gauss, gauss })
    }
}

impl Curvatures<Fraction<BigInt>> {
    /// The same numbers in lowest terms.
    pub fn reduced<Q: RationalField>(&self) -> Option<Curvatures<Q>> {
        Some(Curvatures { mean: self.mean.reduced()?, gauss: self.gauss.reduced()? })
    }

    /// The principal curvatures `H ± √(H² − K)` in ascending order, correct up to a few roundings;
    /// `None` where `H² < K` or they are beyond the range of doubles.
    pub fn principal_f64(&self) -> Option<[f64; 2]> {
        let discriminant = self.discriminant();
        if discriminant.certain_sign()? == Sign::Negative {
            return None;
        }
        // The root without cancellation first; the other from the product K.
        let (mean, root) = (self.mean.to_f64(), discriminant.to_f64().sqrt());
        let large = if mean < 0.0 { mean - root } else { mean + root };
        let small = if large == 0.0 { 0.0 } else { self.gauss.to_f64() / large };
        let roots = [large.min(small), large.max(small)];
        roots.iter().all(|x| x.is_finite()).then_some(roots)
    }
}

impl<T: RationalField> Curvatures<T> {
    /// The principal curvatures `H ± √(H² − K)`.
    pub fn principal(&self) -> Roots<T> {
        Roots::of(&T::one(), &-&self.mean, &self.gauss)
    }
}
