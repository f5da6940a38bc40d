//! Sec. 3.1: parallel meshes.

use super::Claim;

pub(super) const CLAIMS: &[Claim] = &[];
