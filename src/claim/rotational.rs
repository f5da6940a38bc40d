//! Sec. 4: rotational meshes with constant curvatures.

use super::Claim;

pub(super) const CLAIMS: &[Claim] = &[];
