//! Floor 8: the ledger — what the paper claims, said exactly, with its evidence.
//!
//! A [`Claim`] says something about the functions that users call. Its [`Evidence`] is a piece of
//! generic code that makes an instance from unknowns and states what must vanish on it:
//!
//! - over rationals drawn at random it gives *instances*;
//! - over [`Symbol`](crate::scalar::Symbol)s it is recorded once and *decided* for all values of the
//!   unknowns; every division and every comparison on the way must follow from a hypothesis;
//! - with one number moved, or one hypothesis dropped, it must fail: [`Control`];
//! - with one instruction of the record made wrong, it must fail: [`mutants`].
//!
//! | folder | section of the paper |
//! | --- | --- |
//! | `sec_2` | isotropic space, its transformations, Laguerre geometry |
//! | `sec_3` | parallel, i-circular, i-conical, i-isothermic meshes |
//! | `sec_4` | curvatures, Christoffel duals, i-minimal meshes |

use std::fmt;

mod certificate;
mod control;
mod decide;
mod draw;
mod evidence;
mod example;
mod ledger;
mod mutant;
mod sample;
mod sec_2;
mod sec_3;
mod sec_4;
mod trial;
mod verify;

pub use certificate::{
    Certificate, Combination, Findings, Part, Refused, Script, Step, certificate,
};
pub use control::{Control, Counterexample};
pub use decide::{Condition, Decision, Undecided};
pub use draw::{NoSeed, Seed};
pub use evidence::{Evidence, Experiment, Identity, Runs};
pub use example::{Example, example};
pub use ledger::ledger;
pub use mutant::{MutantTally, mutants};
pub use sample::{Failure, Instance, Sampling};
pub use trial::{Run, Stop, Trial, caught};
pub use verify::{Options, PartReport, Report, Verdict, verify};

/// How much is shown for a claim, in rising order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Grade {
    /// Exact, on random instances over ℚ.
    Instances,
    /// For all inputs but with a probability of error below 2^-128: one exact evaluation at a
    /// random point, with the degrees tracked.
    DecidedUpTo,
    /// For all inputs: the recorded code gives zero as a rational function.
    Decided,
    /// A certificate was checked by a program that is not ours.
    Certified,
}

impl Grade {
    /// Its name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Grade::Instances => "instances",
            Grade::DecidedUpTo => "decided up to 2^-128",
            Grade::Decided => "decided",
            Grade::Certified => "certified",
        }
    }
}

impl fmt::Display for Grade {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Where a claim comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// The paper, at this place.
    Paper(&'static str),
    /// Found here.
    Ours,
}

/// A condition of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hypothesis {
    /// The condition, in words or as a formula; [`Trial`]s and [`Control`]s name it by this text.
    pub says: &'static str,
    /// Whether the paper leaves it unsaid.
    pub silent: bool,
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Source::Paper(place) => place,
            Source::Ours => "ours",
        })
    }
}

impl Hypothesis {
    /// A condition that the paper states.
    pub const fn stated(says: &'static str) -> Self {
        Hypothesis { says, silent: false }
    }

    /// A condition that the paper leaves unsaid.
    pub const fn silent(says: &'static str) -> Self {
        Hypothesis { says, silent: true }
    }
}

/// A claim of the ledger.
#[derive(Clone, Copy, Debug)]
pub struct Claim {
    /// Its stable name.
    pub id: &'static str,
    /// What it says, in words.
    pub statement: &'static str,
    /// What it says, as a formula; may be empty.
    pub formula: &'static str,
    /// Where it comes from.
    pub source: Source,
    /// Under which conditions.
    pub hypotheses: &'static [Hypothesis],
    /// The grade of evidence that we say it has.
    pub said: Grade,
    /// Why what is decided is all of the claim: the argument for all k, the step from one face to
    /// the mesh; may be empty.
    pub argument: &'static str,
    /// What is run.
    pub evidence: &'static [Evidence],
    /// What breaks without a hypothesis: at least one for each.
    pub controls: &'static [Control],
}

/// The claims of the sections.
const SECTIONS: [&[&[Claim]]; 3] = [sec_2::CLAIMS, sec_3::CLAIMS, sec_4::CLAIMS];

/// All claims in the order of the paper.
pub fn claims() -> impl Iterator<Item = &'static Claim> {
    SECTIONS.into_iter().flatten().copied().flatten()
}

/// The claim of this name.
pub fn claim(id: &str) -> Option<&'static Claim> {
    claims().find(|claim| claim.id == id)
}
