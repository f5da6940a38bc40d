//! The files of a figure.

use super::draw::{pdf, svg, tikz};
use super::page::{Sight, page};
use super::{Exhibit, Figure, Plate};
use crate::mesh::file::{FileError, Format, Options, write_string};
use crate::pair::PairProperty;

/// A kind of file that a figure has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The exact meshes.
    Json,
    /// The picture for pages.
    Svg,
    /// The picture for LaTeX and for print.
    Pdf,
    /// The picture as a LaTeX source.
    Tikz,
    /// The meshes for ParaView.
    Vtu,
    /// The meshes on an interactive page.
    Html,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Kind; 6] =
        [Kind::Json, Kind::Svg, Kind::Pdf, Kind::Tikz, Kind::Vtu, Kind::Html];
}

impl Figure {
    /// The name of its folder, as in `fig-08`.
    pub fn folder(&self) -> String {
        format!("fig-{:02}", self.number)
    }

    /// The names and contents of its files of one kind; the same on every machine.
    ///
    /// # Errors
    /// Where a mesh has no text in the format.
    pub fn files(&self, plate: &Plate, kind: Kind) -> Result<Vec<(String, Vec<u8>)>, FileError> {
        let folder = self.folder();
        let meshes = |format, extension: &str| {
            let one = |exhibit: &Exhibit| {
                let name = format!("{}.{extension}", exhibit.name);
                let (text, _) = write_string(&name, format, &exhibit.mesh, &Options::default())?;
                Ok((name, text.into_bytes()))
            };
            plate.exhibits.iter().map(one).collect()
        };
        match kind {
            Kind::Json => meshes(Format::IsoJson, "iso.json"),
            Kind::Vtu => meshes(Format::Vtu, "vtu"),
            Kind::Html => Ok(vec![(format!("{folder}.html"), self.page(plate).into_bytes())]),
            Kind::Svg => {
                Ok(vec![(format!("{folder}.svg"), svg(&plate.scene, self.title).into_bytes())])
            }
            Kind::Pdf => Ok(vec![(format!("{folder}.pdf"), pdf(&plate.scene, self.title))]),
            Kind::Tikz => Ok(vec![(format!("{folder}.tex"), tikz(&plate.scene).into_bytes())]),
        }
    }

    /// The meshes side by side; one that has its Gauss image with it gets the slider of the offset.
    fn page(&self, plate: &Plate) -> String {
        let mesh = |name| plate.exhibits.iter().find(|e| e.name == name).map(|e| &e.mesh);
        let sights = plate.exhibits.iter().map(|exhibit| {
            let image = exhibit.with.iter().find(|(_, p)| *p == PairProperty::FParallel);
            Sight {
                name: exhibit.name.into(),
                mesh: &exhibit.mesh,
                gauss: image.and_then(|&(name, _)| mesh(name)),
                color: None,
            }
        });
        let sights: Vec<Sight<'_>> = sights.collect();
        page(&format!("Fig. {}: {}", self.number, self.title), self.caption, &sights)
    }
}
