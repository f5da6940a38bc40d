//! Sec. 4: Christoffel duals, i-minimal meshes, constant curvatures.

use super::Claim;

pub(super) const CLAIMS: &[Claim] = &[];
