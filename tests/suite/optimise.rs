//! Optimisation: derivatives, steps, goals.

mod derivatives;
mod existence;
mod goals;
