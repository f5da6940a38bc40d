//! Optimisation: derivatives, steps, goals.

mod derivatives;
mod goals;
mod rationalise;
