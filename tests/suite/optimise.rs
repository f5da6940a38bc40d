//! Optimisation: derivatives, steps, goals.

mod derivatives;
mod goals;
