//! `isogeo offset`: the meshes M + dS.

use serde_json::json;

use super::arguments::{Layout, OffsetOptions};
use super::failure::Failure;
use super::input::{self, Input};
use super::numbers::numbers;
use super::{Status, output, words};
use crate::check::Verdict;
use crate::mesh::Mesh;
use crate::mesh::file::Options;
use crate::pair::{Couple, FParallel, Misfit, PairProperty, Parallel, VParallel};
use crate::scalar::Rational;

/// Writes the offset, or says why the meshes are no pair: a result, not an error.
pub fn run(options: &OffsetOptions, layout: Layout) -> Result<Status, Failure> {
    let [distance] = numbers("--distance", &options.distance)?;
    let input = input::read(&options.input)?;
    let image = input::read_image(&options.gauss, &options.input, &input)?;
    let (mesh, gauss) = (input.exact(), image.exact());
    let bar = output::progress(mesh.topology.face_count(), "checking the pair");
    let found = offset(&mesh, &gauss, &distance, options.vertical);
    bar.finish_and_clear();
    match found {
        Ok((pair, offset)) => {
            let rounded = input.is_inexact() || image.is_inexact();
            let write = Options { rounded, ..Options::default() };
            let dropped = mesh.data.vertex.len() + mesh.data.face.len() > 0;
            let mut said =
                vec![("offset", json!({ "pair": pair.name(), "distance": distance.to_string() }))];
            if dropped {
                said.push(("data_kept", json!(false)));
            }
            output::write_saying(&options.output.output, &offset, &write, layout, said)?;
            if !layout.is_json() {
                let left_out = if dropped { "; the data of M are left out" } else { "" };
                output::print(&format!("  the pair is {}{left_out}\n", pair.name()))?;
            }
            Ok(Status::Proved)
        }
        Err(misfits) => refuse(&misfits, &input, &image, layout),
    }
}

type Misfits = Vec<(PairProperty, Misfit<Rational>)>;

/// The offset and the pair that it is one of, or why the meshes are none.
fn offset(
    mesh: &Mesh<Rational>,
    gauss: &Mesh<Rational>,
    distance: &Rational,
    vertical: bool,
) -> Result<(PairProperty, Mesh<Rational>), Misfits> {
    use PairProperty::{FParallel as F, Parallel as P, VParallel as V};
    if vertical {
        let pair = VParallel::new(mesh, gauss).map_err(|misfit| vec![(V, misfit)])?;
        return Ok((V, pair.offset(distance)));
    }
    match FParallel::new(mesh, gauss) {
        Ok(pair) => Ok((F, pair.offset(distance))),
        Err(planes) => match Parallel::new(mesh, gauss) {
            Ok(pair) => Ok((P, pair.offset(distance))),
            Err(edges) => Err(vec![(F, planes), (P, edges)]),
        },
    }
}

/// Says why the meshes are no pair, and whether that is certain in the reading of the files.
fn refuse(
    misfits: &Misfits,
    input: &Input,
    image: &Input,
    layout: Layout,
) -> Result<Status, Failure> {
    let decider = input.decider().followed_by(image.decider());
    let couple = Couple::new(input.topology(), image.topology(), &decider);
    let couple = couple.map_err(|misfit| Failure::usage(misfit.to_string()))?;
    let refuted = |property| couple.check(property).verdict() == Verdict::Refuted;
    let status = match misfits.iter().all(|&(property, _)| refuted(property)) {
        true => Status::Refuted,
        false => Status::Open,
    };
    if layout.is_json() {
        let reasons = misfits.iter().map(|(property, misfit)| {
            json!({ "property": property.name(), "reason": misfit.to_string() })
        });
        output::print_json(&json!({
            "schema": "isogeo.no-offset/1",
            "file": input.file.name,
            "gauss": image.file.name,
            "reasons": reasons.collect::<Vec<_>>(),
        }))?;
    } else {
        let mut text = format!("{} and {}: no offset\n", input.file.name, image.file.name);
        for (property, misfit) in misfits {
            let reason = misfit.map(words::exact);
            text.push_str(&format!("  not {}: {reason}\n", property.name()));
        }
        if status == Status::Open && (input.is_rounded() || image.is_rounded()) {
            text.push_str(
                "  they may be a pair within their digits; an offset needs an exact one\n",
            );
        }
        output::print(&text)?;
    }
    Ok(status)
}
