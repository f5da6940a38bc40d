//! Sec. 2.1: isotropic space, duality, spheres and their transformations.

use super::Claim;

pub(super) const CLAIMS: &[Claim] = &[];
