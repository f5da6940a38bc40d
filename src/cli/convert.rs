//! `isogeo convert`: between formats.

use super::arguments::{ConvertOptions, Layout};
use super::failure::Failure;
use super::{Status, input, output};
use crate::mesh::file::{Options, clear_denominators};

/// Reads, clears denominators if asked to, writes.
pub fn run(options: &ConvertOptions, layout: Layout) -> Result<Status, Failure> {
    let input = input::read(&options.input)?;
    let mut mesh = input.exact();
    let mut notes = input.file.notes.clone();
    notes.remove("coords");
    let certificate = input.file.certificate.clone();
    let rounded = input.is_inexact();
    let mut write = Options { digits: options.digits, rounded, notes, certificate };
    if options.clear_denominators {
        let cleared = clear_denominators(&mesh).ok_or_else(|| {
            Failure::with_help(
                "the common denominator of the coordinates is too large",
                "write .iso.json, which keeps fractions",
            )
        })?;
        write.notes = cleared.notes();
        write.certificate = None;
        // Integers scaled by D and D² no longer show how far they can be trusted.
        write.rounded = false;
        mesh = cleared.mesh;
    }
    output::write(&options.output, &mesh, &write, layout)?;
    Ok(Status::Proved)
}
