//! Sec. 2: isotropic space, its transformations, Laguerre geometry.

mod duality;
mod laguerre;
mod moebius;
mod motion;
mod space;

use super::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Stop, Trial,
};

/// The claims, in the order of the paper.
pub(super) const CLAIMS: &[&[Claim]] = &[
    motion::CLAIMS,
    space::CLAIMS,
    duality::CLAIMS,
    moebius::CLAIMS,
    laguerre::CLAIMS,
    laguerre::group::CLAIMS,
];
