//! Meshes that an optimisation in doubles produced, made exact and kept: doubles differ between
//! machines, and the figures must not.
//!
//! The example `frozen` has the control meshes and makes the files:
//! `cargo run --release --example frozen -- src/figure/frozen`. The tests run the optimisation again
//! and compare.

use super::{NoFigure, Surface};
use crate::mesh::file::{Format, read_bytes};
use crate::scalar::ReadAs;

pub(super) const ROOF: &str = include_str!("frozen/roof.iso.json");
pub(super) const CANOPY: &str = include_str!("frozen/canopy.iso.json");
pub(super) const M0: &str = include_str!("frozen/m0.iso.json");
pub(super) const M1: &str = include_str!("frozen/m1.iso.json");
pub(super) const M2: &str = include_str!("frozen/m2.iso.json");
pub(super) const FITTED: &str = include_str!("frozen/fitted.iso.json");

/// The mesh of a text.
pub(super) fn frozen(text: &str) -> Result<Surface, NoFigure> {
    let file = read_bytes("frozen", Format::IsoJson, text.as_bytes()).map_err(NoFigure::of)?;
    file.to_exact(ReadAs::Decimal).map_err(NoFigure::of)
}
