//! Pages: one self-contained HTML file with a viewer; it opens from a disk and asks for nothing.

use std::fmt::Write;

use serde_json::{Map, Value, json};

use super::draw::escaped;
use crate::mesh::Mesh;
use crate::net::RADIUS;
use crate::scalar::{Approx, Rational};

/// A mesh on a page.
#[derive(Clone, Debug)]
pub struct Sight<'a> {
    /// Its name, shown below it.
    pub name: String,
    /// The mesh; its data are shown beside the pointer, exactly.
    pub mesh: &'a Mesh<Rational>,
    /// A mesh S with the same faces, for the offset M + dS.
    pub gauss: Option<&'a Mesh<Rational>>,
    /// The data of faces that colours them: blue below 0, red above, by the rank of their sizes.
    pub color: Option<&'a str>,
}

/// The page that shows meshes side by side with one camera: sliders for the shear, the heights and the
/// offset, exact values beside the pointer, the top view with circles of radius data.
pub fn page(title: &str, caption: &str, sights: &[Sight<'_>]) -> String {
    let data = json!({
        "title": title,
        "meshes": sights.iter().map(mesh_json).collect::<Vec<_>>(),
    });
    // Inside a script element only this could end it.
    let data = data.to_string().replace("</", "<\\/");
    let mut page = String::new();
    // Writing to a string does not fail.
    let _ = write!(
        page,
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; \
         script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:\">\n\
         <title>{title}</title>\n<style>\n{style}</style>\n</head>\n<body>\n<div id=\"stage\"></div>\n\
         <div id=\"caption\"><h1>{title}</h1><p>{caption}</p></div>\n<div id=\"names\"></div>\n\
         <div id=\"panel\"></div>\n<div id=\"tip\"></div>\n\
         <script id=\"data\" type=\"application/json\">{data}</script>\n<script>\n{script}</script>\n\
         </body>\n</html>\n",
        title = escaped(title),
        caption = escaped(caption),
        style = include_str!("viewer.css"),
        script = include_str!("viewer.js"),
    );
    page
}

fn mesh_json(sight: &Sight<'_>) -> Value {
    let mesh = sight.mesh;
    let faces = mesh
        .topology
        .faces()
        .map(|f| mesh.topology.face(f).iter().map(|v| v.index()).collect::<Vec<_>>());
    let exact = mesh.points.iter().map(|p| p.coordinates().map(Rational::to_string));
    let named = |arrays: &std::collections::BTreeMap<String, Vec<Rational>>| {
        let texts = |values: &Vec<Rational>| values.iter().map(Rational::to_string).collect();
        let pairs = arrays.iter().map(|(name, values)| (name.clone(), texts(values)));
        pairs.collect::<Map<String, Value>>()
    };
    let mut value = json!({
        "name": sight.name,
        "points": floats(mesh),
        "exact": exact.collect::<Vec<_>>(),
        "faces": faces.collect::<Vec<_>>(),
        "data": { "vertex": named(&mesh.data.vertex), "face": named(&mesh.data.face) },
    });
    if let Some(gauss) = sight.gauss {
        value["gauss"] = json!(floats(gauss));
    }
    if let Some(radii) = mesh.data.vertex.get(RADIUS) {
        let circles = mesh.points.iter().zip(radii);
        let circles = circles.map(|(p, r)| [p.x.to_f64(), p.y.to_f64(), r.to_f64()]);
        value["circles"] = json!(circles.collect::<Vec<_>>());
    }
    if let Some(values) = sight.color.and_then(|name| mesh.data.face.get(name)) {
        value["values"] = json!(ranked(values));
    }
    value
}

fn floats(mesh: &Mesh<Rational>) -> Vec<[f64; 3]> {
    mesh.points.iter().map(|p| p.coordinates().map(Approx::to_f64)).collect()
}

/// The place of each size among all sizes, with the sign of the value: every colour is used, whatever
/// the spread.
fn ranked(values: &[Rational]) -> Vec<f64> {
    let values: Vec<f64> = values.iter().map(Approx::to_f64).collect();
    let mut sizes: Vec<f64> = values.iter().map(|x| x.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    let rank = |x: f64| sizes.partition_point(|size| *size < x.abs()) + 1;
    let fraction = |x: f64| x.signum() * rank(x) as f64 / sizes.len() as f64;
    values.iter().map(|&x| if x == 0.0 { 0.0 } else { fraction(x) }).collect()
}
