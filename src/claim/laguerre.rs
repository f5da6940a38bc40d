//! Sec. 2.2: Laguerre geometry and its isotropic model.

use super::Claim;

pub(super) const CLAIMS: &[Claim] = &[];
