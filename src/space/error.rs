//! What the constructors of this floor refuse.

use std::fmt;

/// Why an object of isotropic space does not exist for the given data.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SpaceError {
    /// Three points whose top views are collinear: their plane is isotropic or not determined,
    /// and no i-circle of elliptic type passes through them.
    CollinearTopViews,
    /// An i-sphere or i-circle of parabolic type with `A = 0`: a plane or a line.
    ZeroCurvature,
    /// An i-sphere of cylindrical type with radius 0.
    ZeroRadius,
    /// An isotropic plane whose direction in the top view is the zero vector.
    ZeroDirection,
    /// A rotation with `c² + s² ≠ 1`.
    NotARotation,
    /// A scaling with a factor 0.
    ZeroFactor,
    /// A matrix R with `Rᵀ G R ≠ k G`.
    NotAnIsometry,
    /// A reflection at a vector v with `⟨v, v⟩ = 0`.
    IsotropicVector,
    /// A normal n with `n·n ≠ 1`.
    NotAUnitNormal,
    /// An oriented plane with the normal (0, 0, −1), which (12) sends to infinity.
    SouthPole,
    /// The image passes through the centre of a transformation, or lies at infinity.
    AtInfinity,
}

impl fmt::Display for SpaceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            SpaceError::CollinearTopViews => "the top views of the points are collinear",
            SpaceError::ZeroCurvature => "the quadratic coefficient is 0",
            SpaceError::ZeroRadius => "the squared radius is 0",
            SpaceError::ZeroDirection => "the direction in the top view is 0",
            SpaceError::NotARotation => "c² + s² is not 1",
            SpaceError::ZeroFactor => "a factor of the scaling is 0",
            SpaceError::NotAnIsometry => "the matrix does not keep the inner product",
            SpaceError::IsotropicVector => "the vector is isotropic",
            SpaceError::NotAUnitNormal => "the normal does not have length 1",
            SpaceError::SouthPole => "the normal is (0, 0, −1)",
            SpaceError::AtInfinity => "the image lies at infinity",
        })
    }
}

impl std::error::Error for SpaceError {}
