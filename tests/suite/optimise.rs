//! Optimisation: derivatives, steps, goals.

mod curvatures;
mod derivatives;
mod existence;
mod goals;
