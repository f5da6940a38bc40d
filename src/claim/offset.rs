//! Sec. 3.1: offsets of meshes in Euclidean space.

use super::Claim;

pub(super) const CLAIMS: &[Claim] = &[];
