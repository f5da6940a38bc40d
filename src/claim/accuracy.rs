//! Sec. 4: curvatures at the vertices of triangle meshes.

use super::Claim;

pub(super) const CLAIMS: &[Claim] = &[];
