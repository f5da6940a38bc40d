//! Scattered samples: exact Delaunay meshes, formulas, point files, the accuracy of (22).

mod accuracy;
mod expression;
mod mesh;
#[cfg(feature = "cli")]
mod program;
