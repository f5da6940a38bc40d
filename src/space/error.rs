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
        })
    }
}

impl std::error::Error for SpaceError {}
