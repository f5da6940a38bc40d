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
//! | chapter | section of the paper |
//! | --- | --- |
//! | `space` | 2.1 |
//! | `laguerre` | 2.2 |
//! | `parallel` | 3.1 |
//! | `principal` | 3.2 |
//! | `isothermic` | 3.4 |
//! | `curvature`, `quads`, `christoffel`, `minimal`, `lines`, `airy`, `rotational`, `vertex`, `stress`, `edge`, `accuracy` | 4 |

use std::fmt;

mod control;
mod decide;
mod draw;
mod evidence;
mod example;
mod ledger;
mod mutant;
mod sample;
mod trial;
mod verify;

mod packing;
mod stars;

mod accuracy;
mod airy;
mod christoffel;
mod curvature;
mod edge;
mod isothermic;
mod laguerre;
mod lines;
mod minimal;
mod parallel;
mod principal;
mod quads;
mod rotational;
mod space;
mod stress;
mod vertex;

pub use control::{Control, Counterexample};
pub use decide::{Condition, Decision, Undecided};
pub use draw::{NoSeed, Seed};
pub use evidence::{Evidence, Experiment, Identity, Runs};
pub use example::{Example, example};
pub use ledger::ledger;
pub use mutant::{MutantTally, mutants};
pub use sample::{Failure, Sampling};
pub use trial::{Run, Stop, Trial};
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

/// The chapters of the ledger in the order of the paper.
const CHAPTERS: [&[Claim]; 16] = [
    space::CLAIMS,
    laguerre::CLAIMS,
    parallel::CLAIMS,
    principal::CLAIMS,
    isothermic::CLAIMS,
    curvature::CLAIMS,
    quads::CLAIMS,
    christoffel::CLAIMS,
    minimal::CLAIMS,
    lines::CLAIMS,
    airy::CLAIMS,
    rotational::CLAIMS,
    vertex::CLAIMS,
    stress::CLAIMS,
    edge::CLAIMS,
    accuracy::CLAIMS,
];

/// All claims in the order of the paper.
pub fn claims() -> impl Iterator<Item = &'static Claim> {
    CHAPTERS.into_iter().flatten()
}

/// The claim of this name.
pub fn claim(id: &str) -> Option<&'static Claim> {
    claims().find(|claim| claim.id == id)
}
