//! Floor 3: from residuals to verdicts. Knows points and polynomials, no mesh class.
//!
//! A [`Residual`] is a polynomial in the coordinates of a few points. [`Decide`] says whether it
//! vanishes: [`Plain`] by evaluating it in a field, [`Decider`] fast, with fixed-width integers and
//! rigorous bounds, and over the boxes that rounded numbers stand for. What is found on each
//! element becomes a [`Report`] with a [`Verdict`].

mod decider;
mod integers;
mod local;
mod plain;
mod report;
mod residual;
mod roots;
mod verdict;

pub use decider::Decider;
pub use plain::{Observed, Plain};
pub use report::{Element, Failure, Outcome, Reason, Report, Witness};
pub use residual::{Answer, Decide, Residual, RootSum};
pub use verdict::Verdict;
