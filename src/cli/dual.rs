//! `isogeo dual`: the metric dual.

use super::arguments::{DualOptions, Layout};
use super::failure::Failure;
use super::input::{self, Input};
use super::{Status, output, words};
use crate::check::Verdict;
use crate::construct::{NoDual, metric_dual};
use crate::mesh::file::Options;
use crate::net::{Net, Property};
use crate::scalar::Rational;

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
                NoDual::NotPlanar { .. } if is_refuted(&input) => Status::Refuted,
                _ => Status::Open,
            };
            if layout.is_json() {
                output::print_json(&serde_json::json!({
                    "schema": "isogeo.no-dual/1",
                    "file": input.file.name,
                    "reason": reason.to_string(),
                }))?;
            } else {
                let reason = in_short(&reason, status);
                output::print(&format!("{}: no metric dual: {reason}\n", input.file.name))?;
            }
            Ok(status)
        }
    }
}

/// Whether the mesh is not planar, whatever the unprinted digits were.
fn is_refuted(input: &Input) -> bool {
    let decider = input.decider();
    let planar = Net::new(input.topology(), &decider).check(Property::Planar);
    planar.verdict() == Verdict::Refuted
}

fn in_short(reason: &NoDual<Rational>, status: Status) -> String {
    match reason {
        NoDual::NotPlanar { face, residual } => {
            let hint = match status {
                Status::Refuted => "",
                _ => "\n  the mesh may be planar within its digits; a dual needs exact planarity",
            };
            format!(
                "face {} is not planar: a vertex lies {} above the plane of three others{hint}",
                face.0,
                words::exact(residual),
            )
        }
        reason => reason.to_string(),
    }
}
