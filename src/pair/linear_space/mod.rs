//! The linear spaces of meshes parallel, and v-parallel, to a given one (Sec. 3.1).
//!
//! Both have an exact dimension and an exact basis. In general an `m × n` patch of quads has
//! `m + n` dimensions of parallel meshes modulo translations (one factor for every row and column
//! of faces) and `m + n + 1` of v-parallel ones (the heights along two polygons that cross).

mod cycles;
mod parallel;
mod v_parallel;

pub use parallel::{ParallelSpace, parallel_space};
pub use v_parallel::{VParallelSpace, v_parallel_space};

use crate::mesh::{Data, Mesh};
use crate::scalar::{LinearSystem, RationalField};
use crate::space::Point;

/// Adds an equation whose unknowns the caller has counted.
fn add<T: RationalField>(system: &mut LinearSystem, entries: impl IntoIterator<Item = (usize, T)>) {
    let added = system.push(entries);
    debug_assert!(added.is_ok(), "an unknown beyond those of the mesh");
}

/// The combinatorics of a mesh with other points.
fn with_points<T: Clone>(mesh: &Mesh<T>, points: Vec<Point<T>>) -> Mesh<T> {
    Mesh { topology: mesh.topology.clone(), points, data: Data::default() }
}
