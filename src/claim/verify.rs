//! The verdict on a claim: everything that it says is run.

use std::time::Instant;

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use super::certificate::{Certificate, certificate};
use super::control::{check, disturb, uncontrolled};
use super::decide::{Decision, Undecided, decide};
use super::sample::{Sampling, sample};
use super::{Claim, Grade, Seed};

/// What to run.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Instances for each piece of evidence.
    pub samples: usize,
    /// Where all that is random comes from.
    pub seed: Seed,
}

/// Whether a claim holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Everything that was run agrees.
    Holds,
    /// Something does not.
    Fails,
    /// There was nothing to look at.
    Vacuous,
}

impl Verdict {
    /// Its name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Holds => "holds",
            Verdict::Fails => "fails",
            Verdict::Vacuous => "vacuous",
        }
    }
}

/// What one piece of evidence showed.
#[derive(Clone, Debug)]
pub struct PartReport {
    /// What it is about.
    pub shows: &'static str,
    /// What was decided, for each size.
    pub decisions: Vec<Result<Decision, Undecided>>,
    /// What the instances showed.
    pub sampling: Sampling,
    /// How many constructed numbers were moved, and each was noticed; or which was not.
    pub disturbed: Result<usize, String>,
}

/// What is shown for a claim.
#[derive(Clone, Debug)]
pub struct Report {
    /// The claim.
    pub claim: &'static Claim,
    /// The evidence, piece by piece.
    pub parts: Vec<PartReport>,
    /// The certificate, where Coq has checked it as it is now.
    pub certificate: Option<Certificate>,
    /// The controls: how the claim fails without each hypothesis, or why it does not.
    pub controls: Vec<Result<String, String>>,
    /// The time of everything, in seconds.
    pub seconds: f64,
}

impl Report {
    /// The least that is shown by all that was decided; instances where nothing was.
    pub fn shown(&self) -> Grade {
        let decisions = self.parts.iter().flat_map(|part| &part.decisions);
        let grades = decisions.map(|d| d.as_ref().map_or(Grade::Instances, |d| d.grade));
        grades.min().unwrap_or(Grade::Instances)
    }

    /// Instances on which the claim was checked.
    pub fn instances(&self) -> usize {
        self.parts.iter().map(|part| part.sampling.instances).sum()
    }

    /// Controls that broke the claim, as they should: dropped hypotheses and moved numbers.
    pub fn controls(&self) -> usize {
        let moved = self.parts.iter().filter_map(|part| part.disturbed.as_ref().ok());
        self.controls.iter().filter(|c| c.is_ok()).count() + moved.sum::<usize>()
    }

    /// All that went wrong, in words.
    pub fn failures(&self) -> Vec<String> {
        let mut failures = Vec::new();
        for part in &self.parts {
            for undecided in part.decisions.iter().filter_map(|d| d.as_ref().err()) {
                failures.push(format!("{}: {undecided}", part.shows));
            }
            if let Some(failure) = &part.sampling.failure {
                let unknowns = failure.unknowns.join(" ");
                let (size, what) = (failure.size, &failure.what);
                failures.push(format!("{}: size {size}, unknowns {unknowns}: {what}", part.shows));
            }
            if let Err(unnoticed) = &part.disturbed {
                failures.push(format!("{}: {unnoticed}", part.shows));
            }
        }
        for (control, outcome) in self.claim.controls.iter().zip(&self.controls) {
            if let Err(why) = outcome {
                failures.push(format!("control without \"{}\": {why}", control.without));
            }
        }
        for hypothesis in uncontrolled(self.claim) {
            failures.push(format!("no control drops \"{}\"", hypothesis.says));
        }
        if self.shown() < self.claim.said {
            let (said, shown) = (self.claim.said.name(), self.shown().name());
            failures.push(format!("said is {said}, shown is {shown}"));
        }
        failures
    }

    /// Whether the claim holds, and shows what it says.
    pub fn verdict(&self) -> Verdict {
        if !self.failures().is_empty() {
            Verdict::Fails
        } else if self.parts.is_empty() || self.parts.iter().any(|p| p.sampling.instances == 0) {
            Verdict::Vacuous
        } else {
            Verdict::Holds
        }
    }
}

/// Runs everything that the claims say; `done` hears of each claim when it is finished, in any
/// order. The reports are in the order of the claims.
pub fn verify(
    claims: &[&'static Claim],
    options: &Options,
    done: &(dyn Fn(&Report) + Sync),
) -> Vec<Report> {
    let report = |claim: &&'static Claim| {
        let report = one(claim, options);
        done(&report);
        report
    };
    claims.par_iter().map(report).collect()
}

fn one(claim: &'static Claim, options: &Options) -> Report {
    let start = Instant::now();
    let part = |evidence: &super::Evidence| PartReport {
        shows: evidence.shows,
        decisions: {
            let sizes = evidence.decided.iter();
            sizes.map(|&size| decide(claim, evidence, size, options.seed)).collect()
        },
        sampling: sample(claim, evidence, options.samples, options.seed),
        disturbed: disturb(evidence, options.seed),
    };
    let mut parts: Vec<PartReport> = claim.evidence.iter().map(part).collect();
    let decided = |p: &PartReport| p.decisions.iter().flatten().any(|d| d.grade == Grade::Decided);
    let certificate = if parts.iter().any(decided) { certificate(claim) } else { None };
    let certificate = certificate.filter(Certificate::is_checked);
    for (evidence, part) in parts.iter_mut().enumerate() {
        for decision in part.decisions.iter_mut().flatten() {
            let covered = certificate.as_ref().is_some_and(|c| c.covers(evidence, decision.size));
            if covered && decision.grade == Grade::Decided {
                decision.grade = Grade::Certified;
            }
        }
    }
    Report {
        claim,
        parts,
        certificate,
        controls: claim.controls.iter().map(|control| check(claim, control)).collect(),
        seconds: start.elapsed().as_secs_f64(),
    }
}
