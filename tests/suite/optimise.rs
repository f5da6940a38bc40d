//! Optimisation: derivatives, steps, goals.

mod curvatures;
mod derivatives;
mod exact;
mod existence;
mod goals;
mod rationalise;
mod shapes;
