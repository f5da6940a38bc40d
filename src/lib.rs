//! Discrete surfaces in isotropic geometry, checked exactly.

pub mod check;
#[cfg(feature = "cli")]
pub mod cli;
pub mod construct;
pub mod mesh;
pub mod net;
pub mod scalar;
pub mod space;
