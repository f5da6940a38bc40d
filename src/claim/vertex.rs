//! Sec. 4: curvatures at vertices.

use super::Claim;

pub(super) const CLAIMS: &[Claim] = &[];
