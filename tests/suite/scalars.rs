//! Floor 0, numbers: the laws that every instance obeys, their agreement with each other, and one
//! named case for every error that was found.

mod agreement;
mod balls;
mod derivatives;
mod double_doubles;
mod expression;
mod laws;
mod liar;
mod numerals;
mod obedience;
mod prime;
mod quadratics;
mod rounding;
mod samples;
mod symbols;
mod variations;
