//! Floor 7: optimisation in doubles, and the way back to exact meshes.
