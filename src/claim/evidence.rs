//! Evidence: generic code with everything that it is run over.

use super::trial::{Run, Trial};
use crate::scalar::{BigRational, Field, Rational, RationalField, Symbol};

/// An identity or an implication over any field: decided, and sampled.
///
/// `run` draws unknowns, makes an instance from them that satisfies the hypotheses, calls the
/// functions that users call, and states what has to vanish. It must not start threads.
pub trait Identity {
    /// One run.
    ///
    /// # Errors
    /// Where the unknowns do not satisfy a hypothesis, or the code under test refuses them.
    fn run<T: Field>(trial: &mut Trial<T>) -> Run;
}

/// A statement about rational numbers that is no identity: it is sampled.
pub trait Experiment {
    /// One run.
    ///
    /// # Errors
    /// As for [`Identity::run`].
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run;
}

/// One identity or experiment, over each scalar.
#[derive(Clone, Copy, Debug)]
pub struct Runs {
    pub(super) rational: fn(&mut Trial<Rational>) -> Run,
    pub(super) big_rational: fn(&mut Trial<BigRational>) -> Run,
    pub(super) symbol: Option<fn(&mut Trial<Symbol>) -> Run>,
}

/// A part of the evidence for a claim.
#[derive(Clone, Copy, Debug)]
pub struct Evidence {
    /// What it shows, in a few words.
    pub shows: &'static str,
    /// The code.
    pub runs: Runs,
    /// The sizes for which it is decided; empty where it is sampled only.
    pub decided: &'static [usize],
    /// The sizes of the instances.
    pub sampled: &'static [usize],
}

impl Evidence {
    /// An identity that is decided for some sizes, and sampled for some.
    pub const fn identity<I: Identity>(
        shows: &'static str,
        decided: &'static [usize],
        sampled: &'static [usize],
    ) -> Self {
        let runs = Runs {
            rational: I::run::<Rational>,
            big_rational: I::run::<BigRational>,
            symbol: Some(I::run::<Symbol>),
        };
        Evidence { shows, runs, decided, sampled }
    }

    /// An experiment on instances of some sizes.
    pub const fn experiment<E: Experiment>(shows: &'static str, sampled: &'static [usize]) -> Self {
        let runs = Runs {
            rational: E::run::<Rational>,
            big_rational: E::run::<BigRational>,
            symbol: None,
        };
        Evidence { shows, runs, decided: &[], sampled }
    }
}
