//! `isogeo make`: exact families of meshes.

use std::path::Path;

use serde_json::json;

use super::arguments::{Layout, MakeOptions};
use super::failure::Failure;
use super::{Status, koebe, output, words};
use crate::construct::family::{Family, Values};
use crate::mesh::Mesh;
use crate::mesh::file::{self, Options};
use crate::net::Property;
use crate::pair::PairProperty;
use crate::scalar::Rational;

/// Writes the surface, and its Gauss image where there is one.
pub fn run(options: &MakeOptions, layout: Layout) -> Result<Status, Failure> {
    if options.family == "koebe" {
        return koebe::run(&parameters(&options.parameters)?, &options.output, layout);
    }
    let family = Family::from_name(&options.family).ok_or_else(|| {
        let known = Family::ALL.map(Family::name).join(", ") + ", koebe";
        let message = format!("there is no family '{}'", options.family);
        Failure::with_help(message, format!("the families are {known}"))
    })?;
    let size = options.n.as_deref().map_or(Ok(family.size()), size)?;
    let given = parameters(&options.parameters)?;
    let help = format!("isogeo make --help lists the parameters of {}", family.name());
    let failure =
        |reason: String| Failure::with_help(format!("{}: {reason}", family.name()), &help);
    let values = Values::new(family, &given).map_err(|reason| failure(reason.to_string()))?;
    let bar = output::progress(size[0] * size[1], "making the surface");
    let member = family.member(size, &values).map_err(|reason| failure(reason.to_string()))?;
    bar.finish_and_clear();
    let directory = &options.output;
    std::fs::create_dir_all(directory).map_err(|e| {
        Failure::io(format!("the folder {} cannot be made: {e}", directory.display()))
    })?;
    let mut written = Vec::new();
    let meshes = [("surface", Some(&member.surface)), ("gauss", member.gauss.as_ref())];
    for (name, mesh) in meshes {
        let Some(mesh) = mesh else { continue };
        let path = directory.join(format!("{name}.iso.json"));
        file::write(&path, mesh, &Options::default())?;
        written.push((path, mesh));
    }
    report(family, &written, layout)?;
    Ok(Status::Proved)
}

fn report(
    family: Family,
    written: &[(impl AsRef<Path>, &Mesh<Rational>)],
    layout: Layout,
) -> Result<(), Failure> {
    let (alone, pair) = family.proves();
    let alone: Vec<_> = alone.iter().copied().map(Property::name).collect();
    let pair: Vec<_> = pair.iter().copied().map(PairProperty::name).collect();
    let files = written.iter().map(|(path, mesh)| {
        (
            path.as_ref().display().to_string(),
            mesh.topology.vertex_count(),
            mesh.topology.face_count(),
        )
    });
    if layout.is_json() {
        let files = files.map(
            |(file, vertices, faces)| json!({ "file": file, "vertices": vertices, "faces": faces }),
        );
        return output::print_json(&json!({
            "schema": "isogeo.made/1",
            "family": family.name(),
            "files": files.collect::<Vec<_>>(),
            "proves": { "mesh": alone, "pair": pair },
        }));
    }
    let mut text = String::new();
    for (file, vertices, faces) in files {
        let size = format!("{}, {}", words::vertices(vertices), words::count(faces, "face"));
        text += &format!("{file}: {size}, written exactly\n");
    }
    let mut proofs = Vec::new();
    if !alone.is_empty() {
        proofs.push(alone.join(", "));
    }
    if !pair.is_empty() {
        proofs.push(format!("with gauss.iso.json {}", pair.join(", ")));
    }
    output::print(&format!("{text}  check proves: {}\n", proofs.join("; ")))
}

/// Rows and columns.
fn size(text: &str) -> Result<[usize; 2], Failure> {
    const MOST: usize = 5000;
    let number = |part: &str| part.parse().ok().filter(|n| (1..=MOST).contains(n));
    let size = text.split_once(['x', '×']).and_then(|(m, n)| Some([number(m)?, number(n)?]));
    size.ok_or_else(|| {
        Failure::with_help(
            format!("--n takes the numbers of rows and columns, not '{text}'"),
            format!("as in --n 12x8, each from 1 to {MOST}"),
        )
    })
}

/// Pairs `name=value`; what follows a comma without a name belongs to the value before.
fn parameters(texts: &[String]) -> Result<Vec<(String, String)>, Failure> {
    let mut all: Vec<(String, String)> = Vec::new();
    for text in texts {
        for (place, part) in text.split(',').enumerate() {
            match (part.split_once('='), all.last_mut().filter(|_| place > 0)) {
                (Some((name, value)), _) => all.push((name.trim().into(), value.trim().into())),
                (None, Some((_, value))) => *value += &format!(",{part}"),
                (None, None) => {
                    return Err(Failure::with_help(
                        format!("-p takes name=value, not '{text}'"),
                        "as in -p center=1/2,1/3 or -p mean=1,integral=-3",
                    ));
                }
            }
        }
    }
    Ok(all)
}
