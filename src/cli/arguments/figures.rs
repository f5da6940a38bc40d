//! The command `figure`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::Reading;
use super::limits::LimitOptions;

/// Make the figures of the paper: exact data and pictures
#[derive(Debug, Args)]
#[command(after_help = "\
What a figure says of its meshes is checked exactly before it is drawn. Each figure gets a folder.
Example:
  isogeo figure 8 --out figures --as svg,tikz
  isogeo figure all --out paper_figures --check")]
pub struct FigureOptions {
    /// The number of the figure, or 'all'
    #[arg(value_name = "ID")]
    pub id: String,
    /// The folder for the figures
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// What to write, separated by commas [default: all that this build has]
    #[arg(long = "as", value_enum, value_name = "KIND", value_delimiter = ',')]
    pub kinds: Vec<FigureKind>,
    /// Write nothing: compare with what is there
    #[arg(long)]
    pub check: bool,
}

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum FigureKind {
    /// The exact meshes, .iso.json, and what is said of them, with H and K
    Json,
    /// The picture for pages
    Svg,
    /// The picture for LaTeX and for print
    Pdf,
    /// The picture at 300 dots per inch; for builds with the feature png
    Png,
    /// The picture as a LaTeX source
    Tikz,
    /// The meshes for ParaView
    Vtu,
    /// The meshes on an interactive page
    Html,
}

/// Write meshes as one interactive page that needs no network
#[derive(Debug, Args)]
#[command(after_help = "\
Drag to turn, wheel to zoom; the pointer tells the exact numbers of a vertex or a face. Sliders shear
the mesh (an i-motion), stretch its heights and offset it with --gauss; double-click puts one back. The
address keeps the view. The top view shows the vertex circles of meshes with radii.
Example:
  isogeo view roof.obj dual.iso.json -o roof.html")]
pub struct ViewOptions {
    /// The meshes, shown side by side with one camera
    #[arg(required = true, value_name = "MESH")]
    pub meshes: Vec<PathBuf>,
    /// How their numbers are understood [default: as each file says]
    #[arg(long, value_enum, value_name = "READING")]
    pub read_as: Option<Reading>,
    /// A mesh S with the same faces, for a slider of the offset M + dS
    #[arg(long, value_name = "S")]
    pub gauss: Option<PathBuf>,
    /// Colour the faces by these values of theirs, such as K or H
    #[arg(long, value_name = "NAME")]
    pub color: Option<String>,
    /// The page
    #[arg(short, long = "output", value_name = "OUT.html")]
    pub out: PathBuf,
    #[command(flatten)]
    pub limits: LimitOptions,
}
