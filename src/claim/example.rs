//! A small exact instance of a claim, to look at.

use super::Evidence;
use super::draw::Seed;
use super::trial::Trial;
use crate::mesh::Mesh;
use crate::scalar::Rational;

/// An instance with names for its values.
#[derive(Clone, Debug, Default)]
pub struct Example {
    /// Named values, in the order in which the evidence names them.
    pub values: Vec<(String, Rational)>,
    /// Named meshes.
    pub meshes: Vec<(&'static str, Mesh<Rational>)>,
    /// What vanishes on it.
    pub goals: Vec<String>,
}

/// The first instance of small numbers that satisfies the hypotheses; always the same.
pub fn example(evidence: &Evidence) -> Option<Example> {
    let &size = evidence.sampled.first()?;
    (0..64).find_map(|attempt| {
        let mut source = Seed::of(0).source(evidence.shows, attempt);
        let mut trial = Trial::new(size, move || source.small());
        (evidence.runs.rational)(&mut trial).ok()?;
        let mut goals: Vec<String> = trial.goals.iter().map(|(name, _)| name.to_string()).collect();
        goals.dedup();
        let values = trial.values.into_iter().map(|(name, value)| (name.into_owned(), value));
        Some(Example { values: values.collect(), meshes: trial.meshes, goals })
    })
}
