//! `isogeo dual`: the metric dual.

use super::arguments::{DualOptions, Layout};
use super::failure::Failure;
use super::{Status, input, output};
use crate::construct::{NoDual, metric_dual};
use crate::mesh::file::Options;

/// Writes the dual, or says why there is none: a result, not an error.
pub fn run(options: &DualOptions, layout: Layout) -> Result<Status, Failure> {
    let input = input::read(&options.input)?;
    match metric_dual(&input.exact()) {
        Ok(dual) => {
            output::write(&options.output.output, &dual, &Options::default(), layout)?;
            Ok(Status::Proved)
        }
        Err(reason) => {
            let status = match reason {
                NoDual::NotPlanar { .. } => Status::Refuted,
                NoDual::NoPole(_) | NoDual::Topology(_) => Status::Open,
            };
            if layout.is_json() {
                output::print_json(&serde_json::json!({
                    "schema": "isogeo.no-dual/1",
                    "file": input.file.name,
                    "reason": reason.to_string(),
                }));
            } else {
                output::print(&format!("{}: no metric dual: {reason}\n", input.file.name));
            }
            Ok(status)
        }
    }
}
