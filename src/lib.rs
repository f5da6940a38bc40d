//! Discrete surfaces in isotropic geometry, checked exactly.

pub mod mesh;
pub mod scalar;
pub mod space;
