//! Floor 1: isotropic 3-space itself, without meshes (Sec. 2.1).
//!
//! | noun | is |
//! | --- | --- |
//! | [`Point`], [`TopView`] | points, and their projections in the isotropic direction z |
//! | [`Plane`], [`Gradient`], [`IsotropicPlane`] | graphs `z = p·x' + t`, and vertical planes |
//! | [`ContactElement`] | a point with a plane through it |
//! | [`Dual`] | metric duality: points and planes, i-distance and i-angle |
//! | [`ParabolicSphere`], [`CylindricalSphere`], [`MoebiusSphere`] | i-spheres, i-M-spheres |
//! | [`ICircle`], [`ParabolicCircle`], [`Circle`], [`OrientedCircle`] | i-circles; circles of the top view, also with signs |
//! | [`Motion`], [`Rotation`], [`Scaling`] | i-motions (1) and similarities; [`Transform`] applies them |
//! | [`MoebiusTransformation`], [`Similarity`] | i-M-transformations, and the 4-space of spheres that they act on |
//! | [`laguerre`] | oriented planes, spheres and cones of Euclidean space, in the isotropic model (12) |
//! | [`Graph`], [`Jet2`], [`Hessian`] | smooth surfaces `z = f(x, y)` and their curvatures (4)–(11) |
//! | [`Polynomial`], [`ParametricSurface`] | two classes of such surfaces with exact jets |
//!
//! Lengths and angles stay squared, so that everything stays in the field of the coordinates.

mod action;
mod circle;
mod contact;
mod duality;
mod error;
mod expression;
mod gradient;
pub mod laguerre;
mod moebius;
mod motion;
mod oriented_circle;
mod parabolic_circle;
mod parametric;
mod plane;
mod point;
mod polynomial;
mod scaling;
mod similarity;
mod sphere;
mod surface;

pub use action::Transform;
pub use circle::{Circle, ICircle};
pub use contact::ContactElement;
pub use duality::Dual;
pub use error::SpaceError;
pub use expression::{Expression, ExpressionError};
pub use gradient::Gradient;
pub use moebius::{IsotropicModel, MoebiusTransformation};
pub use motion::{Motion, Rotation};
pub use oriented_circle::OrientedCircle;
pub use parabolic_circle::ParabolicCircle;
pub use parametric::ParametricSurface;
pub use plane::{IsotropicPlane, Plane};
pub use point::{Point, TopView, Vector2, Vector3};
pub use polynomial::Polynomial;
pub use scaling::Scaling;
pub use similarity::{Model, Similarity};
pub use sphere::{CylindricalSphere, MoebiusSphere, ParabolicSphere};
pub use surface::{Graph, Hessian, Jet2};
