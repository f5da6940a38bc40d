//! What is written: a mesh of doubles, alone or with a certificate, or an exact mesh.

use serde_json::{Value, json};

use super::wishes::fixed;
use crate::check::{Decider, Verdict};
use crate::cli::arguments::{Layout, OptimizeOptions};
use crate::cli::certify::{in_numbers, in_words};
use crate::cli::failure::Failure;
use crate::cli::{Status, output, words};
use crate::mesh::Mesh;
use crate::mesh::file::{Format, Options};
use crate::net::Net;
use crate::optimise::existence::{Certificate, Pinned};
use crate::optimise::rationalise::{self, NoExactMesh, Rationalised};
use crate::optimise::{Goal, mean_edge};
use crate::scalar::{Numeral, Rational};

/// The part of an edge beyond which an exact mesh is another one.
const FAR: f64 = 1.0 / 16.0;

/// Writes the mesh as it was asked for, with the report.
pub fn finish(
    options: &OptimizeOptions,
    goal: Goal,
    found: &Mesh<f64>,
    mut report: Value,
    layout: Layout,
) -> Result<Status, Failure> {
    let path = &options.output.output;
    if options.rationalize {
        let bar = output::spinner("looking for an exact mesh");
        let exact = exact(options, goal, found)?;
        bar.finish_and_clear();
        match exact {
            Ok(exact)
                if exact.movement.largest > FAR * mean_edge(&found.topology, &found.points) =>
            {
                let distance = exact.movement.largest;
                report["rationalized"] =
                    json!({ "reason": "the exact mesh is not near", "movement_largest": distance });
                say(
                    layout,
                    &format!(
                        "  no exact mesh near it: the one that was found is {distance:.1e} away\n"
                    ),
                )?;
            }
            Ok(exact) => {
                let decider = Decider::of_rationals(&exact.mesh.points);
                let net = Net::new(&exact.mesh.topology, &decider);
                let verdict = net.check(goal.property()).verdict();
                report["rationalized"] = in_numbers_exact(&exact, verdict);
                say(layout, &exact_in_words(&exact, verdict, found))?;
                let fields = [("optimize", report)];
                output::write_saying(path, &exact.mesh, &Options::default(), layout, fields)?;
                return Ok(if verdict == Verdict::Proved { Status::Proved } else { Status::Open });
            }
            Err(reason) => {
                report["rationalized"] = json!({ "reason": reason.to_string() });
                say(layout, &format!("  no exact mesh: {reason}\n"))?;
            }
        }
    }
    let doubles = found.map(|c| Numeral::from_f64(*c).map(|n| n.value()).unwrap_or_default());
    let mut write = Options { rounded: true, ..Options::default() };
    if Format::from_path(path) == Some(Format::IsoJson) && (options.certify || options.rationalize)
    {
        let bar = output::spinner("proving that an exact mesh is near");
        let made =
            Certificate::make(&doubles.topology, &doubles.points, goal, pinned(options, &doubles)?);
        bar.finish_and_clear();
        match made {
            Ok((certificate, proved)) => {
                report["existence"] = in_numbers(&certificate, &proved);
                say(layout, &format!("  {}\n", in_words(&certificate)))?;
                write.certificate = Some(json!({ Certificate::NAME: certificate.json() }));
            }
            Err(reason) => {
                report["existence"] = json!({ "reason": reason.to_string() });
                say(layout, &format!("  no exact mesh is proved to be near: {reason}\n"))?;
            }
        }
    }
    output::write_saying(path, &doubles, &write, layout, [("optimize", report)])?;
    Ok(Status::Open)
}

/// The options that go together.
pub fn fits(options: &OptimizeOptions, goal: Goal) -> Result<(), Failure> {
    let is_json = Format::from_path(&options.output.output) == Some(Format::IsoJson);
    if options.certify && !is_json {
        return Err(Failure::with_help(
            "--certify needs a file that can hold a certificate",
            "write an .iso.json file",
        ));
    }
    if options.rationalize && matches!(goal, Goal::Circular | Goal::Conical) {
        let name = goal.property().name();
        return Err(Failure::with_help(
            format!("--rationalize knows no exact {name} meshes"),
            "there are planar, i-circular, i-conical; isogeo transfer --to euclidean makes exact conical ones",
        ));
    }
    Ok(())
}

fn exact(
    options: &OptimizeOptions,
    goal: Goal,
    found: &Mesh<f64>,
) -> Result<Result<Rationalised, NoExactMesh>, Failure> {
    let mut how = rationalise::Options::of(&found.points);
    if let Some(within) = options.within {
        how.within = within;
    }
    match goal {
        Goal::Planar => Ok(rationalise::planar(found, &how)),
        Goal::ICircular => Ok(rationalise::i_circular(found, &how)),
        Goal::IConical => Ok(rationalise::i_conical(found, &how)),
        Goal::Circular | Goal::Conical => {
            fits(options, goal).and(Err(Failure::usage("no exact meshes")))
        }
    }
}

fn in_numbers_exact(exact: &Rationalised, verdict: Verdict) -> Value {
    json!({
        "verdict": verdict.name(),
        "movement_rms": exact.movement.rms,
        "movement_largest": exact.movement.largest,
        "movement_at": exact.movement.at.0,
        "bits": exact.bits,
    })
}

fn exact_in_words(exact: &Rationalised, verdict: Verdict, found: &Mesh<f64>) -> String {
    let edge = mean_edge(&found.topology, &found.points);
    format!(
        "  exact mesh: {}; {} edge lengths from the doubles at most, vertex {}; numbers of {} bits at most\n",
        verdict.name(),
        words::defect(exact.movement.largest / edge),
        exact.movement.at.0,
        exact.bits
    )
}

fn pinned(options: &OptimizeOptions, mesh: &Mesh<Rational>) -> Result<Pinned, Failure> {
    match options.fix.as_deref().map(str::trim) {
        None => Ok(Pinned::Nothing),
        Some("boundary") => Ok(Pinned::Boundary),
        Some(list) => Ok(Pinned::Vertices(fixed(list, &mesh.topology)?)),
    }
}

fn say(layout: Layout, text: &str) -> Result<(), Failure> {
    if layout.is_json() { Ok(()) } else { output::print(text) }
}
