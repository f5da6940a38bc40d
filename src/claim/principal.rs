//! Sec. 3.2: i-circular and i-conical meshes.

use super::Claim;

pub(super) const CLAIMS: &[Claim] = &[];
