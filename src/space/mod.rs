//! Floor 1: isotropic 3-space itself, without meshes (Sec. 2.1).

mod point;

pub use point::{Point, TopView, Vector2, Vector3};
