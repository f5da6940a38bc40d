//! Floor 5: pairs of meshes with the same combinatorics.

pub mod linear_space;
