//! Floor 0: numbers. Everything above is written once, generic over these.
//!
//! | type | is | order | exact |
//! | --- | --- | --- | --- |
//! | [`Rational`] | ℚ, the program's own (malachite) | yes | yes |
//! | [`BigRational`] | ℚ again (num-rational): the oracle of the first | yes | yes |
//! | [`BigInt`] | ℤ: fractions cleared | yes | yes |
//! | [`Narrow`], [`Wide`] | ℤ up to 2 or `W` words, without heap | –, yes | yes |
//! | [`Fraction`] | fractions over another, not reduced | where `R` has one | as `R` |
//! | [`Quadratic`] | `a + b √D` over another: regular hexagons and octagons | where `T` has one | as `T` |
//! | [`Dual`] | value and first derivatives over another; nests | no | as `T` |
//! | [`Prime61`] | integers modulo the prime 2^61 − 1: fast identity tests | no | yes |
//! | [`Residue`] | ℤ/2^(64 W): zero tests under a bound | no | yes |
//! | [`Symbol`] | unknowns: what was done is recorded, then decided | by shadow | yes |
//! | `f64` | doubles | yes | no |
//! | [`DoubleDouble`] | pairs of doubles: 106 bits | yes | no |
//! | [`Ball`] | rigorous enclosures, over `f64`, `DoubleDouble` or `BigInt` | where disjoint | no |
//! | [`Variation`] | a value and its change within a box | no | no |
//! | [`Magnitude`] | sizes without cancellation | – | no |
//!
//! [`LinearSystem`] is elimination over ℚ: exact ranks and kernels of sparse systems.
//! [`Numeral`] is not a scalar: it is a number as a file prints it.

mod ball;
mod bounded;
mod double_double;
mod dual;
mod float;
mod fraction;
mod integer;
mod linear;
mod magnitude;
#[cfg(feature = "malachite")]
mod malachite;
mod numeral;
mod order;
mod prime;
mod quadratic;
mod rational;
mod residue;
pub(crate) mod ring;
mod symbol;
mod variation;
mod wide;

pub use ball::{Ball, Midpoint};
pub use bounded::{Bounded, Narrow};
pub use double_double::DoubleDouble;
pub use dual::Dual;
pub use fraction::Fraction;
pub use linear::{Echelon, LinearSystem, NoSuchUnknown};
pub use magnitude::Magnitude;
pub use num_bigint::BigInt;
pub use num_rational::BigRational;
pub use numeral::{Base, Numeral, NumeralError, ReadAs};
pub use order::{Approx, Ordered, Sign};
pub use prime::Prime61;
pub use quadratic::Quadratic;
pub(crate) use rational::ratio_to_f64;
pub use rational::{Rational, RationalField};
pub use residue::Residue;
pub use ring::{DivRef, Field, Ring, RingRef, Same, det3};
pub(crate) use symbol::Quotients;
pub use symbol::{
    Branch, Degrees, Evaluation, Instruction, Mutation, NodeId, NormalForms, Outcome, Polynomial,
    Program, Quotient, Symbol, TooLarge, record,
};
pub use variation::Variation;
pub use wide::Wide;
