//! Instances: the evidence on random rational numbers, and the smallest one that fails.

use std::time::{Duration, Instant};

use super::draw::Seed;
use super::trial::{Run, Stop, Trial};
use super::{Claim, Evidence};
use crate::mesh::Mesh;
use crate::mesh::file::{Format, Options as FileOptions, write_string};
use crate::scalar::{BigRational, Rational, RationalField};

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

/// What one run showed.
enum Shown {
    Holds,
    Excluded,
    Fails(String),
}

fn judge<Q: RationalField>(trial: &mut Trial<Q>, run: fn(&mut Trial<Q>) -> Run) -> Shown {
    match run(trial) {
        Err(Stop::Excluded(_)) => Shown::Excluded,
        Err(Stop::Failed(why)) => Shown::Fails(why.into_owned()),
        Ok(()) => match trial.broken() {
            Some((what, residual)) => Shown::Fails(format!("{what}: {residual}")),
            None if trial.goals.is_empty() => Shown::Excluded,
            None => Shown::Holds,
        },
    }
}

/// Draws instances: half of them over each exact scalar.
pub(super) fn sample(claim: &Claim, evidence: &Evidence, samples: usize, seed: Seed) -> Sampling {
    let start = Instant::now();
    let mut sampling = Sampling::default();
    let purpose = format!("{} {}", claim.id, evidence.shows);
    for index in 0..samples {
        let Some(&size) = evidence.sampled.get(index % evidence.sampled.len().max(1)) else {
            break;
        };
        let mut source = seed.source(&purpose, index as u64);
        let shown = if (index / evidence.sampled.len()).is_multiple_of(2) {
            let mut trial = Trial::new(size, move || source.fraction::<Rational>());
            let shown = judge(&mut trial, evidence.runs.rational);
            if let Shown::Fails(_) = shown {
                let failure = shrink(evidence.runs.rational, size, trial.unknowns);
                sampling.failure = Some(failure);
            }
            shown
        } else {
            let mut trial = Trial::new(size, move || source.fraction::<BigRational>());
            let shown = judge(&mut trial, evidence.runs.big_rational);
            if let Shown::Fails(_) = shown {
                let failure = shrink(evidence.runs.big_rational, size, trial.unknowns);
                sampling.failure = Some(failure);
            }
            shown
        };
        match shown {
            Shown::Holds => sampling.instances += 1,
            Shown::Excluded => sampling.excluded += 1,
            Shown::Fails(_) => break,
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
) -> Failure {
    let fails = |size, unknowns: &[Q]| {
        let mut trial = Trial::given(size, unknowns.to_vec());
        match judge(&mut trial, run) {
            Shown::Fails(what) => Some((what, trial.meshes, trial.unknowns)),
            _ => None,
        }
    };
    let mut best = fails(size, &unknowns);
    while size > 1
        && let Some(smaller) = fails(size - 1, &unknowns)
    {
        size -= 1;
        unknowns.clone_from(&smaller.2);
        best = Some(smaller);
    }
    let mut attempts = 0;
    let mut simpler = true;
    while simpler && attempts < SIMPLER {
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
        |(what, meshes, _)| (what, meshes),
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
