//! The files of a figure.

use serde_json::{Value, json};

#[cfg(feature = "png")]
use super::draw::png;
use super::draw::{pdf, svg, tikz};
use super::page::{Sight, page};
use super::{Exhibit, Figure, Plate};
use crate::construct::vertex_circles;
use crate::mesh::file::{FileError, Format, Options, write_string};
use crate::pair::ExactPair;
use crate::pair::element::{At, Elements};
use crate::scalar::Rational;
use crate::space::OrientedCircle;

/// A kind of file that a figure has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The exact meshes, and what the figure says of them with circles and curvatures.
    Json,
    /// The picture for pages.
    Svg,
    /// The picture for LaTeX and for print.
    Pdf,
    /// The picture as pixels, 300 to the inch; for builds with the feature `png`.
    Png,
    /// The picture as a LaTeX source.
    Tikz,
    /// The meshes for ParaView.
    Vtu,
    /// The meshes on an interactive page.
    Html,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Kind; 7] =
        [Kind::Json, Kind::Svg, Kind::Pdf, Kind::Png, Kind::Tikz, Kind::Vtu, Kind::Html];

    /// Whether this build writes it.
    pub fn is_built(self) -> bool {
        self != Kind::Png || cfg!(feature = "png")
    }
}

impl Figure {
    /// The name of its folder, as in `fig-08`.
    pub fn folder(&self) -> String {
        format!("fig-{:02}", self.number)
    }

    /// The names and contents of its files of one kind; the same on every machine.
    ///
    /// # Errors
    /// Where a mesh has no text in the format, or the build does not have the kind.
    pub fn files(&self, plate: &Plate, kind: Kind) -> Result<Vec<(String, Vec<u8>)>, FileError> {
        let folder = self.folder();
        let meshes = |format, extension: &str| -> Result<Vec<_>, FileError> {
            let one = |exhibit: &Exhibit| {
                let name = format!("{}.{extension}", exhibit.name);
                let (text, _) = write_string(&name, format, &exhibit.mesh, &Options::default())?;
                Ok((name, text.into_bytes()))
            };
            plate.exhibits.iter().map(one).collect()
        };
        match kind {
            Kind::Json => {
                let mut files: Vec<_> = meshes(Format::IsoJson, "iso.json")?;
                files.push((format!("{folder}.json"), self.facts(plate).into_bytes()));
                Ok(files)
            }
            Kind::Vtu => meshes(Format::Vtu, "vtu"),
            Kind::Html => Ok(vec![(format!("{folder}.html"), self.page(plate).into_bytes())]),
            Kind::Svg => {
                Ok(vec![(format!("{folder}.svg"), svg(&plate.scene, self.title).into_bytes())])
            }
            Kind::Pdf => Ok(vec![(format!("{folder}.pdf"), pdf(&plate.scene, self.title))]),
            Kind::Png => Ok(vec![picture(format!("{folder}.png"), plate)?]),
            Kind::Tikz => Ok(vec![(format!("{folder}.tex"), tikz(&plate.scene).into_bytes())]),
        }
    }

    /// What the figure says, for programs: caption, claims, and of each mesh what was proved, with the
    /// circles of its radii and its curvatures as exact numbers.
    fn facts(&self, plate: &Plate) -> String {
        let exhibit = |exhibit: &Exhibit| {
            let mut value = json!({
                "name": exhibit.name,
                "vertices": exhibit.mesh.topology.vertex_count(),
                "faces": exhibit.mesh.topology.face_count(),
                "proved": exhibit.holds.iter().map(|p| p.name()).collect::<Vec<_>>(),
                "proved_with": exhibit.with.iter()
                    .map(|(image, p)| json!({ "image": image, "property": p.name() }))
                    .collect::<Vec<_>>(),
                "shown": exhibit.shown.iter().map(|remark| remark.says).collect::<Vec<_>>(),
            });
            if let Some(circles) = vertex_circles(&exhibit.mesh) {
                let numbers = |c: &OrientedCircle<Rational>| {
                    [&c.centre.x, &c.centre.y, &c.radius].map(Rational::to_string)
                };
                value["circles"] = json!(circles.iter().map(numbers).collect::<Vec<_>>());
            }
            if let Some(found) = curvatures(exhibit, &plate.exhibits) {
                value["curvatures"] = found;
            }
            value
        };
        let facts = json!({
            "schema": "isogeo.figure/1",
            "number": self.number,
            "title": self.title,
            "caption": self.caption,
            "claims": self.claims,
            "meshes": plate.exhibits.iter().map(exhibit).collect::<Vec<_>>(),
        });
        format!("{facts:#}\n")
    }

    /// The meshes side by side; one that has its Gauss image with it gets the slider of the offset.
    fn page(&self, plate: &Plate) -> String {
        let sights = plate.exhibits.iter().map(|exhibit| {
            let gauss = gauss_image(exhibit, &plate.exhibits);
            Sight {
                name: exhibit.name.into(),
                mesh: &exhibit.mesh,
                gauss: gauss.filter(|(_, at)| *at == At::Faces).map(|(image, _)| &image.mesh),
                color: None,
            }
        });
        let sights: Vec<Sight<'_>> = sights.collect();
        page(&format!("Fig. {}: {}", self.number, self.title), self.caption, &sights)
    }
}

/// The Gauss image of an exhibit, and where the pair has curvatures.
fn gauss_image<'a>(exhibit: &Exhibit, exhibits: &'a [Exhibit]) -> Option<(&'a Exhibit, At)> {
    let (name, at) = exhibit.curved()?;
    Some((exhibits.iter().find(|e| e.name == name)?, at))
}

/// H and K of all faces or vertices, as the command `curvature` gives them.
fn curvatures(exhibit: &Exhibit, exhibits: &[Exhibit]) -> Option<Value> {
    let (image, at) = gauss_image(exhibit, exhibits)?;
    let [points, image_points] = [exhibit, image].map(|e| e.mesh.points.as_slice().into());
    let pair = ExactPair::new(&exhibit.mesh.topology, points, image_points);
    let elements = Elements { pair, at, determined: Vec::new() };
    let values = (0..elements.count()).map(|i| elements.json(i, &elements.find(i)));
    let values = values.collect::<Vec<_>>();
    Some(json!({ "at": at.name(), "image": image.name, "values": values }))
}

#[cfg(feature = "png")]
fn picture(name: String, plate: &Plate) -> Result<(String, Vec<u8>), FileError> {
    match png(&plate.scene) {
        Some(picture) => Ok((name, picture)),
        None => Err(FileError::new("size", "png", &name, "the picture has no size for print")),
    }
}

#[cfg(not(feature = "png"))]
fn picture(name: String, _: &Plate) -> Result<(String, Vec<u8>), FileError> {
    let message = "PNG pictures are not drawn by this build";
    let help = "build with the feature 'png': cargo install --path . --features png";
    Err(FileError::new("feature", "png", &name, message).help(help))
}
