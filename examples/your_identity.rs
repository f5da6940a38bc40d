//! An identity of your own, tested on random meshes.
//!
//! `cargo run --example your_identity`: for every v-parallel pair (M, S) and every vertex with
//! curvatures, the H of M + dS over S is H + d. What fails is made small: change the `+` below.

use isogeo::pair::VParallel;
use isogeo::scalar::Rational;
use isogeo::strategy::{small, v_parallel};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Ten lines: a strategy for the data, and what holds on them.
    fn mean_curvature_is_shifted(pair in v_parallel::<Rational>(), d in small::<Rational>()) {
        let (m, s) = (&pair.surface, &pair.gauss);
        let pair = VParallel::new(m, s).map_err(|e| TestCaseError::fail(e.to_string()))?;
        let moved = pair.offset(&d);
        let moved = VParallel::new(&moved, s).map_err(|e| TestCaseError::fail(e.to_string()))?;
        for v in m.topology.interior_vertices() {
            let [Ok(h), Ok(shifted)] = [&pair, &moved].map(|pair| pair.vertex_curvatures(v)) else { continue };
            prop_assert_eq!(shifted.mean, h.mean + &d, "vertex {}", v.0);
        }
    }
}

/// Panics with the smallest pair that is found if the identity does not hold.
pub fn holds() {
    mean_curvature_is_shifted();
}

#[allow(dead_code, reason = "the tests call the identity alone")]
fn main() {
    holds();
    println!("it holds on 64 random pairs");
}
