//! The laws, by what they are about. Each is a strategy with what holds on all that it makes.

mod combinatorics;
mod control;
mod curvature;
mod decider;
mod duality;
mod files;
mod image;
mod invariance;

use std::fmt::Display;

use super::law::Law;
use crate::claim::{Run, Stop};

/// All laws, then the controls.
pub(super) fn all() -> impl Iterator<Item = &'static Law> {
    let laws = [
        decider::LAWS,
        invariance::LAWS,
        duality::LAWS,
        image::LAWS,
        curvature::LAWS,
        files::LAWS,
        combinatorics::LAWS,
        control::LAWS,
    ];
    laws.into_iter().flatten()
}

/// Holds, or fails for a reason.
fn check(holds: bool, why: impl FnOnce() -> String) -> Run {
    if holds { Ok(()) } else { Err(fails(why())) }
}

fn fails(why: impl Into<String>) -> Stop {
    Stop::Failed(why.into().into())
}

/// A result that must not be refused.
fn accepted<V, E: Display>(what: &str, result: Result<V, E>) -> Result<V, Stop> {
    result.map_err(|why| fails(format!("{what}: {why}")))
}

/// A result that is there on all instances of the law.
fn given<V, E>(hypothesis: &'static str, result: Result<V, E>) -> Result<V, Stop> {
    result.map_err(|_| Stop::Excluded(hypothesis))
}
