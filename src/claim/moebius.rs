//! Sec. 2.1: isotropic sphere transformations.

use super::Claim;

pub(super) const CLAIMS: &[Claim] = &[];
