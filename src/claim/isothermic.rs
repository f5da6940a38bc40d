//! Sec. 3.4: Koebe and i-isothermic meshes.

use super::Claim;

pub(super) const CLAIMS: &[Claim] = &[];
