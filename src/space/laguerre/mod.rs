//! Laguerre geometry: oriented planes and spheres of Euclidean space, and their isotropic model
//! (Sec. 2.2).
//!
//! The map τ from the isotropic model to Euclidean space, and its inverse (12):
//!
//! | in isotropic space | in Euclidean space | by |
//! | --- | --- | --- |
//! | [`Point`](super::Point) | oriented plane, `n ≠ (0, 0, −1)` | [`OrientedPlane::to_isotropic`], [`OrientedPlane::of_isotropic`] |
//! | [`MoebiusSphere`](super::MoebiusSphere) | oriented sphere | `From`, in both directions |
//! | [`ICircle`](super::ICircle) | cone of revolution, `n ≠ (0, 0, −1)` | [`Cone::to_isotropic`], [`Cone::of_isotropic`] |
//! | [`MoebiusTransformation`](super::MoebiusTransformation) | [`LaguerreTransformation`] | `From`, in both directions |
//!
//! Everything is rational: a plane through rational points has a place here only if its unit normal
//! is rational, but every rational point of isotropic space gives such a plane.

mod cone;
mod plane;
mod sphere;
mod transformation;

pub use cone::Cone;
pub use plane::OrientedPlane;
pub use sphere::OrientedSphere;
pub use transformation::{LaguerreTransformation, StandardModel};
