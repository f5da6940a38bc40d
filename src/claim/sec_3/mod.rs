//! Sec. 3: parallel meshes, i-circular and i-conical meshes, Koebe and i-isothermic meshes.

mod contact;
mod i_circular;
mod i_conical;
mod inscribed;
mod instance;
mod isothermic;
mod koebe;
mod offset;
mod parallel;
mod principal;
mod remark_1;
mod remark_2;

use super::{
    Claim, Control, Counterexample, Evidence, Experiment, Grade, Hypothesis, Identity, Run, Source,
    Stop, Trial,
};

/// The claims, in the order of the paper.
pub(super) const CLAIMS: &[&[Claim]] = &[
    parallel::CLAIMS,
    offset::vertex::CLAIMS,
    offset::edge::CLAIMS,
    offset::face::CLAIMS,
    principal::CLAIMS,
    i_circular::CLAIMS,
    inscribed::CLAIMS,
    i_conical::CLAIMS,
    contact::CLAIMS,
    remark_1::CLAIMS,
    koebe::CLAIMS,
    isothermic::CLAIMS,
    remark_2::CLAIMS,
];
