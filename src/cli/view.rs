//! `isogeo view`: meshes on one interactive page.

use std::collections::BTreeSet;
use std::path::PathBuf;

use super::arguments::{Layout, ViewOptions};
use super::failure::Failure;
use super::{Status, input, output};
use crate::figure::page::{Sight, page};
use crate::mesh::Mesh;
use crate::mesh::file::write_whole;
use crate::scalar::Rational;

/// Reads the meshes and writes the page.
pub fn run(options: &ViewOptions, layout: Layout) -> Result<Status, Failure> {
    let exact =
        |path: &PathBuf| Ok(input::read_file(path, options.read_as, &options.limits)?.exact());
    let meshes = options.meshes.iter().map(exact).collect::<Result<Vec<_>, Failure>>()?;
    let gauss = options.gauss.as_ref().map(exact).transpose()?;
    let sights: Vec<Sight<'_>> = options
        .meshes
        .iter()
        .zip(&meshes)
        .map(|(path, mesh)| {
            let fits = |s: &&Mesh<Rational>| s.topology == mesh.topology;
            Sight {
                name: path.file_name().map_or_else(String::new, |n| n.to_string_lossy().into()),
                mesh,
                gauss: gauss.as_ref().filter(fits),
                color: options.color.as_deref().filter(|name| mesh.data.face.contains_key(*name)),
            }
        })
        .collect();
    if options.gauss.is_some() && sights.iter().all(|sight| sight.gauss.is_none()) {
        return Err(Failure::usage("the Gauss image has other faces than the meshes"));
    }
    if let Some(name) = &options.color
        && sights.iter().all(|sight| sight.color.is_none())
    {
        let known: BTreeSet<&String> = meshes.iter().flat_map(|m| m.data.face.keys()).collect();
        let known = known.into_iter().cloned().collect::<Vec<_>>().join(", ");
        let help = if known.is_empty() {
            "the faces have no values".into()
        } else {
            format!("there are {known}")
        };
        return Err(Failure::with_help(format!("no mesh has values '{name}' on its faces"), help));
    }
    let title = sights.iter().map(|sight| sight.name.as_str()).collect::<Vec<_>>().join(", ");
    let text = page(&title, "", &sights);
    write_whole(&options.out, text.as_bytes())?;
    let (file, size) = (options.out.display().to_string(), text.len());
    if layout.is_json() {
        output::print_json(&serde_json::json!({
            "schema": "isogeo.written/1", "file": file, "bytes": size, "meshes": meshes.len(),
        }))?;
    } else {
        output::print(&format!("{file}: {} kB, opens in any browser\n", size / 1000))?;
    }
    Ok(Status::Proved)
}
