//! The command `figure`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

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
    /// What to write, separated by commas [default: all]
    #[arg(long = "as", value_enum, value_name = "KIND", value_delimiter = ',')]
    pub kinds: Vec<FigureKind>,
    /// Write nothing: compare with what is there
    #[arg(long)]
    pub check: bool,
}

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum FigureKind {
    /// The exact meshes, .iso.json
    Json,
    /// The picture for pages
    Svg,
    /// The picture for LaTeX and for print
    Pdf,
    /// The picture as a LaTeX source
    Tikz,
    /// The meshes for ParaView
    Vtu,
}
