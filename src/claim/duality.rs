//! Sec. 2.1: metric duality.

use super::Claim;

pub(super) const CLAIMS: &[Claim] = &[];
