//! Certificates: what a claim decides, as programs for a checker that is not ours.
//!
//! A [`Script`] is a recorded run of the evidence with its hypotheses and goals in order. It is
//! written as a Coq file whose theorem says, over every field, that nothing is divided by zero and
//! that the goals vanish. `proofs/coq/program` has the checker that proves it, with its own proof;
//! [`Script::check`] decides the same in the same way.

mod algebra;
mod check;
mod coq;
mod manifest;
mod script;

pub use check::{Combination, Findings, Refused};
pub use coq::{Certificate, Part, certificate};
pub use script::{Script, Step};
