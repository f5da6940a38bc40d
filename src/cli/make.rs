//! `isogeo make`: exact families of meshes.

use std::path::Path;

use serde_json::{Value, json};

use super::arguments::{Layout, MakeOptions};
use super::failure::Failure;
use super::{Status, koebe, output, words};
use crate::construct::ENCLOSURE;
use crate::construct::family::{Enclosure, Family, Member, Parameter, Values};
use crate::mesh::Mesh;
use crate::mesh::file::{self, Options};
use crate::net::Property;
use crate::pair::PairProperty;
use crate::scalar::{Ball, Rational, RationalField};

/// Writes the surface, and its Gauss image where there is one.
pub fn run(options: &MakeOptions, layout: Layout) -> Result<Status, Failure> {
    if options.family == "koebe" {
        let limits = options.limits.limits();
        return koebe::run(&parameters(&options.parameters)?, &options.output, &limits, layout);
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
    let enclosure =
        member.enclosure.as_ref().map(|e| certificate(e, &given_values(family, &given)));
    let meshes =
        [("surface", Some(&member.surface), enclosure), ("gauss", member.gauss.as_ref(), None)];
    for (name, mesh, certificate) in meshes {
        let Some(mesh) = mesh else { continue };
        let path = directory.join(format!("{name}.iso.json"));
        file::write(&path, mesh, &Options { certificate, ..Options::default() })?;
        written.push((path, mesh));
    }
    report(family, &member, &written, layout)?;
    Ok(Status::Proved)
}

/// The parameters as they are used.
fn given_values(family: Family, given: &[(String, String)]) -> Value {
    let value = |p: &Parameter| {
        let own = given.iter().rfind(|(name, _)| name == p.name);
        let text = own.map_or(p.default, |(_, text)| text.as_str());
        (p.name.to_owned(), Value::from(text))
    };
    Value::Object(family.parameters().iter().map(value).collect())
}

/// What stands in the file of a mesh that encloses another.
fn certificate(enclosure: &Enclosure, parameters: &Value) -> Value {
    let ends = |root: &Ball<Rational>| {
        let (low, high) = (&root.mid - &root.radius, &root.mid + &root.radius);
        json!([low.to_string(), high.to_string()])
    };
    let range = enclosure.written_gauss.as_ref();
    json!({ ENCLOSURE: {
        "says": "not exact: a mesh with constant K lies within the radius of every coordinate",
        "property": PairProperty::ConstantK.name(),
        "K": enclosure.gauss.to_string(),
        "radius": enclosure.radius.to_string(),
        "roots": enclosure.roots.iter().map(ends).collect::<Vec<_>>(),
        "written_K": range.map(|range| range.each_ref().map(Rational::to_string)),
        "parameters": parameters,
    } })
}

fn report(
    family: Family,
    member: &Member,
    written: &[(impl AsRef<Path>, &Mesh<Rational>)],
    layout: Layout,
) -> Result<(), Failure> {
    let (alone, pair) = member.proves(family);
    let alone: Vec<_> = alone.into_iter().map(Property::name).collect();
    let pair: Vec<_> = pair.into_iter().map(PairProperty::name).collect();
    let files = written.iter().map(|(path, mesh)| {
        (
            path.as_ref().display().to_string(),
            mesh.topology.vertex_count(),
            mesh.topology.face_count(),
        )
    });
    let enclosure = member.enclosure.as_ref();
    if layout.is_json() {
        let files = files.map(
            |(file, vertices, faces)| json!({ "file": file, "vertices": vertices, "faces": faces }),
        );
        let mut made = json!({
            "schema": "isogeo.made/1",
            "family": family.name(),
            "files": files.collect::<Vec<_>>(),
            "proves": { "mesh": alone, "pair": pair },
        });
        if let Some(e) = enclosure {
            made["encloses"] = json!({
                "property": PairProperty::ConstantK.name(),
                "K": e.gauss.to_string(),
                "radius": e.radius.to_string(),
            });
        }
        return output::print_json(&made);
    }
    let mut text = String::new();
    for (index, (file, vertices, faces)) in files.enumerate() {
        let size = format!("{}, {}", words::vertices(vertices), words::count(faces, "face"));
        let how = if index == 0 && enclosure.is_some() { "NOT exact" } else { "written exactly" };
        text += &format!("{file}: {size}, {how}\n");
    }
    if let Some(e) = enclosure {
        text += &format!(
            "  encloses a mesh with K = {} at all faces, whose coordinates are irrational: each is within\n  \
             2^{} of the written one (see the certificate); constant-k itself is not proved\n",
            e.gauss,
            exponent_above(&e.radius)
        );
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

/// An exponent e with `number ≤ 2^e`.
fn exponent_above(number: &Rational) -> i64 {
    number.numerator().bits() as i64 - number.denominator().bits() as i64 + 1
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
