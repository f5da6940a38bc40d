//! Isotropic space (Sec. 2.1): laws over both exact scalars, and named values.
//!
//! A law is a generic function of random [`Draw`]s; `laws!` runs it for `Rational` and for
//! `BigRational`. Each law ends with its negative control: one coordinate disturbed, and it fails.

mod curvature;
mod draw;
mod dual;
mod incidence;
mod laguerre;
mod moebius;
mod motions;

pub(crate) use draw::laws;
pub use draw::{Draw, Verdict, numbers};
