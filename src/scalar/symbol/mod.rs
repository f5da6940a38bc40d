//! Symbols: a run of generic code on unknowns, recorded as a straight-line program.
//!
//! A function that is generic over [`Field`](super::Field) runs on [`Symbol`]s as on any number;
//! what remains is the [`Program`] of the operations that it performed. What the program computes
//! is then decided for all values of the unknowns at once, by the [`NormalForms`] of rational
//! functions.

mod evaluation;
mod normal_form;
mod polynomial;
mod program;
mod tape;

pub use evaluation::Evaluation;
pub(crate) use normal_form::Quotients;
pub use normal_form::{NormalForms, Quotient};
pub use polynomial::{Polynomial, TooLarge};
pub use program::{Branch, Degrees, Instruction, Mutation, NodeId, Outcome, Program};
pub use tape::{Symbol, record};
