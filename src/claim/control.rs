//! Negative controls: without a hypothesis, or with one number moved, the claim must fail.

use super::draw::Seed;
use super::trial::{Run, Stop, Trial};
use super::{Claim, Evidence, Hypothesis};
use crate::mesh::file::parse_fraction;
use crate::scalar::Rational;

/// A counterexample to the claim without one of its hypotheses.
#[derive(Clone, Copy, Debug)]
pub struct Control {
    /// The hypothesis that is dropped, by its text.
    pub without: &'static str,
    /// What the counterexample is, in words.
    pub shows: &'static str,
    /// The counterexample.
    pub counterexample: Counterexample,
}

/// An exact instance that satisfies all hypotheses but one.
#[derive(Clone, Copy, Debug)]
pub enum Counterexample {
    /// The unknowns of a run of the evidence of this number, in which the hypothesis is not asked.
    Unknowns {
        /// The number of the evidence.
        evidence: usize,
        /// The size.
        size: usize,
        /// The unknowns, as `p/q`; zeros follow.
        unknowns: &'static [&'static str],
        /// What takes the place of the first numbers that are constrained by relations.
        constrained: &'static [&'static str],
    },
    /// A computation of its own: `Ok` says what fails, with its exact residual.
    Witness(fn() -> Result<String, String>),
}

/// Runs a control: `Ok` says how the claim fails, `Err` why it does not.
pub(super) fn check(claim: &Claim, control: &Control) -> Result<String, String> {
    if !claim.hypotheses.iter().any(|h| h.says == control.without) {
        return Err(format!("{:?} is no hypothesis of this claim", control.without));
    }
    let (evidence, mut trial) = match control.counterexample {
        Counterexample::Witness(run) => return run(),
        Counterexample::Unknowns { evidence, size, unknowns, constrained } => {
            let mut constrained = numbers(constrained)?.into_iter();
            let trial = Trial::given(size, numbers(unknowns)?)
                .forgetting(move |value| constrained.next().unwrap_or(value));
            (evidence, trial.ignoring(control.without))
        }
    };
    let evidence = claim.evidence.get(evidence).ok_or("no such evidence")?;
    match (evidence.runs.rational)(&mut trial) {
        Err(Stop::Failed(why)) => Ok(why.into_owned()),
        Err(Stop::Excluded(other)) => Err(format!("another hypothesis is violated: {other}")),
        Ok(()) => match trial.broken() {
            Some((what, residual)) => Ok(format!("{what}: {residual}")),
            None => Err("nothing breaks without it".into()),
        },
    }
}

fn numbers(texts: &[&str]) -> Result<Vec<Rational>, String> {
    texts.iter().map(|text| parse_fraction(text).map_err(|e| format!("{e:?}"))).collect()
}

/// The hypotheses for which there is no control.
pub(super) fn uncontrolled(claim: &Claim) -> impl Iterator<Item = &'static Hypothesis> {
    let controls = claim.controls;
    claim.hypotheses.iter().filter(move |h| !controls.iter().any(|c| c.without == h.says))
}

/// Moves each constructed number of an instance in turn; the goals have to notice. Gives how many
/// were moved, or the first that nobody noticed.
pub(super) fn disturb(evidence: &Evidence, seed: Seed) -> Result<usize, String> {
    let Some(&size) = evidence.sampled.first() else { return Ok(0) };
    let run: fn(&mut Trial<Rational>) -> Run = evidence.runs.rational;
    // The first instance that is not degenerate.
    let trial = |attempt: u64| {
        let mut source = seed.source(evidence.shows, attempt);
        Trial::new(size, move || source.shadow())
    };
    let found = (0..16).find_map(|attempt| {
        let mut instance = trial(attempt);
        (run(&mut instance).is_ok()).then_some((attempt, instance.made))
    });
    let Some((attempt, made)) = found else { return Err("no instance to disturb".into()) };
    for n in 0..made {
        let mut moved = trial(attempt).moving(n);
        if run(&mut moved).is_ok() && moved.broken().is_none() {
            return Err(format!("nobody notices when constructed number {n} is moved"));
        }
    }
    Ok(made)
}
