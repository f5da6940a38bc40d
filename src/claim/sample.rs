//! Instances: the evidence on random rational numbers, and the smallest one that fails.

use std::time::{Duration, Instant};

use super::draw::Seed;
use super::trial::{Run, Stop, Trial, caught};
use super::{Claim, Evidence};
use crate::mesh::Mesh;
use crate::mesh::file::{Format, Options as FileOptions, write_string};
use crate::scalar::{Rational, RationalField};

/// How often a failing instance is made simpler.
const SIMPLER: usize = 400;

/// What the instances of one piece of evidence showed.
#[derive(Clone, Debug, Default)]
pub struct Sampling {
    /// Instances on which all goals vanish, over both exact scalars.
    pub instances: usize,
    /// Draws that fell outside the hypotheses.
    pub excluded: usize,
    /// The first failure, made small.
    pub failure: Option<Failure>,
    /// How long it took.
    pub time: Duration,
}

/// An instance on which the claim fails.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// The size.
    pub size: usize,
    /// The unknowns, as `p/q`.
    pub unknowns: Vec<String>,
    /// What does not vanish, and its value; or what was refused.
    pub what: String,
    /// The meshes of the instance as `.iso.json`, with their names.
    pub meshes: Vec<(&'static str, String)>,
}

/// One instance of a claim: a piece of evidence, a size, an exact scalar, and unknowns.
#[derive(Clone, Debug)]
pub struct Instance<'a> {
    evidence: &'a Evidence,
    size: usize,
    /// Whether it is run over the second exact scalar.
    second: bool,
    unknowns: Unknowns,
}

#[derive(Clone, Debug)]
enum Unknowns {
    Drawn { seed: Seed, purpose: String, index: u64 },
    Given(Vec<Rational>),
}

impl<'a> Instance<'a> {
    /// The instance of this number. Pieces of evidence take turns, and so do their sizes and the exact
    /// scalars; the unknowns follow from the claim, the seed and the index.
    pub fn new(claim: &'a Claim, seed: Seed, index: u64) -> Option<Self> {
        let mut parts = claim.evidence.iter().filter(|part| !part.sampled.is_empty());
        let count = parts.clone().count() as u64;
        let evidence = parts.nth(index.checked_rem(count)? as usize)?;
        Instance::of(claim, evidence, seed, index / count)
    }

    /// The instance of a piece of evidence on given unknowns, then zeros, over the first exact scalar.
    pub fn given(
        claim: &'a Claim,
        evidence: usize,
        size: usize,
        unknowns: Vec<Rational>,
    ) -> Option<Self> {
        let evidence = claim.evidence.get(evidence)?;
        let unknowns = Unknowns::Given(unknowns);
        Some(Instance { evidence, size, second: false, unknowns })
    }

    fn of(claim: &Claim, evidence: &'a Evidence, seed: Seed, index: u64) -> Option<Self> {
        let count = evidence.sampled.len() as u64;
        let size = *evidence.sampled.get(index.checked_rem(count)? as usize)?;
        let purpose = format!("{} {}", claim.id, evidence.shows);
        let unknowns = Unknowns::Drawn { seed, purpose, index };
        Some(Instance { evidence, size, second: !(index / count).is_multiple_of(2), unknowns })
    }

    /// The number of the piece of evidence in its claim, and the size.
    pub fn place(&self, claim: &Claim) -> (usize, usize) {
        let same = |part: &Evidence| std::ptr::eq(part, self.evidence);
        (claim.evidence.iter().position(same).unwrap_or(0), self.size)
    }

    /// Runs it: holds, is excluded, or fails. Each unknown that was drawn is heard of, as numerator and
    /// denominator where both fit 64 bits.
    ///
    /// # Errors
    /// [`Stop::Excluded`] outside of the hypotheses or where there is nothing to check,
    /// [`Stop::Failed`] where a goal does not vanish.
    pub fn run(&self, mut hear: impl FnMut(Option<(i64, i64)>)) -> Run {
        if self.second {
            let (run, unknowns) = self.run_over(self.evidence.runs.big_rational);
            unknowns.iter().for_each(|q| hear(q.small_fraction()));
            run
        } else {
            let (run, unknowns) = self.run_over(self.evidence.runs.rational);
            unknowns.iter().for_each(|q| hear(q.small_fraction()));
            run
        }
    }

    /// Its unknowns, and the meshes that the evidence shows.
    pub fn show(&self) -> (Vec<Rational>, Vec<Mesh<Rational>>) {
        fn shown<Q: RationalField>(
            instance: &Instance<'_>,
            run: fn(&mut Trial<Q>) -> Run,
        ) -> (Vec<Rational>, Vec<Mesh<Rational>>) {
            let mut trial = instance.trial();
            // What it comes to is not asked here.
            let _ = caught(|| run(&mut trial));
            let meshes = trial.meshes.iter().map(|(_, mesh)| mesh.map(Q::convert));
            (trial.unknowns.iter().map(Q::convert).collect(), meshes.collect())
        }
        if self.second {
            shown(self, self.evidence.runs.big_rational)
        } else {
            shown(self, self.evidence.runs.rational)
        }
    }

    /// The failure, made small or as it is; `None` where there is none.
    pub fn failure(&self, simpler: bool) -> Option<Failure> {
        if self.second {
            self.failure_over(self.evidence.runs.big_rational, simpler)
        } else {
            self.failure_over(self.evidence.runs.rational, simpler)
        }
    }

    fn trial<Q: RationalField>(&self) -> Trial<Q> {
        match &self.unknowns {
            Unknowns::Drawn { seed, purpose, index } => {
                let mut source = seed.source(purpose, *index);
                Trial::new(self.size, move || source.fraction())
            }
            Unknowns::Given(given) => {
                Trial::given(self.size, given.iter().map(Rational::convert).collect())
            }
        }
    }

    fn run_over<Q: RationalField>(&self, run: fn(&mut Trial<Q>) -> Run) -> (Run, Vec<Q>) {
        let mut trial = self.trial();
        (judge(&mut trial, run), trial.unknowns)
    }

    fn failure_over<Q: RationalField>(
        &self,
        run: fn(&mut Trial<Q>) -> Run,
        simpler: bool,
    ) -> Option<Failure> {
        let (found, unknowns) = self.run_over(run);
        let attempts = if simpler { SIMPLER } else { 0 };
        matches!(found, Err(Stop::Failed(_))).then(|| shrink(run, self.size, unknowns, attempts))
    }
}

fn judge<Q: RationalField>(trial: &mut Trial<Q>, run: fn(&mut Trial<Q>) -> Run) -> Run {
    caught(|| run(trial))?;
    match trial.broken() {
        Some((what, residual)) => Err(Stop::Failed(format!("{what}: {residual}").into())),
        None if trial.goals.is_empty() => Err(Stop::Excluded("there is nothing to check")),
        None => Ok(()),
    }
}

/// Draws instances: half of them over each exact scalar.
pub(super) fn sample(claim: &Claim, evidence: &Evidence, samples: usize, seed: Seed) -> Sampling {
    let start = Instant::now();
    let mut sampling = Sampling::default();
    for index in 0..samples as u64 {
        let Some(instance) = Instance::of(claim, evidence, seed, index) else { break };
        match instance.run(|_| ()) {
            Ok(()) => sampling.instances += 1,
            Err(Stop::Excluded(_)) => sampling.excluded += 1,
            Err(Stop::Failed(_)) => {
                sampling.failure = instance.failure(true);
                break;
            }
        }
    }
    sampling.time = start.elapsed();
    sampling
}

/// Makes a failing instance as small as it gets: a smaller size, then simpler numbers.
fn shrink<Q: RationalField>(
    run: fn(&mut Trial<Q>) -> Run,
    mut size: usize,
    mut unknowns: Vec<Q>,
    most: usize,
) -> Failure {
    let fails = |size, unknowns: &[Q]| {
        let mut trial = Trial::given(size, unknowns.to_vec());
        match judge(&mut trial, run) {
            Err(Stop::Failed(what)) => Some((what, trial.meshes, trial.unknowns)),
            _ => None,
        }
    };
    let mut best = fails(size, &unknowns);
    while most > 0
        && size > 1
        && let Some(smaller) = fails(size - 1, &unknowns)
    {
        size -= 1;
        unknowns.clone_from(&smaller.2);
        best = Some(smaller);
    }
    let mut attempts = 0;
    let mut simpler = true;
    while simpler && attempts < most {
        simpler = false;
        for n in 0..unknowns.len() {
            for candidate in candidates(&unknowns[n]) {
                let old = std::mem::replace(&mut unknowns[n], candidate);
                attempts += 1;
                if let Some(found) = fails(size, &unknowns) {
                    best = Some(found);
                    simpler = true;
                    break;
                }
                unknowns[n] = old;
            }
        }
    }
    let (what, meshes) = best.map_or_else(
        || ("the failure does not repeat".into(), Vec::new()),
        |(what, meshes, _)| (what.into_owned(), meshes),
    );
    let text = |mesh: &Mesh<Q>| {
        let written = write_string("", Format::IsoJson, mesh, &FileOptions::default());
        written.map(|(text, _)| text).unwrap_or_default()
    };
    Failure {
        size,
        unknowns: unknowns.iter().map(Q::to_string).collect(),
        what,
        meshes: meshes.iter().map(|(name, mesh)| (*name, text(mesh))).collect(),
    }
}

/// Simpler numbers than this one, the simplest first.
fn candidates<Q: RationalField>(value: &Q) -> Vec<Q> {
    let weight = |q: &Q| q.numerator().bits() + q.denominator().bits();
    let rounded = Q::from_fraction(value.numerator() / value.denominator(), 1.into());
    let small = [0, 1, -1, 2].map(Q::from_i64);
    let all = small.into_iter().chain(rounded);
    all.filter(|q| weight(q) < weight(value)).collect()
}
