//! Commands and options.

use std::num::NonZeroU16;
use std::path::PathBuf;

use clap::builder::styling::{AnsiColor, Styles};
use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::scalar::ReadAs;

/// Discrete surfaces in isotropic geometry, checked exactly.
#[derive(Debug, Parser)]
#[command(name = "isogeo", version, about, styles = STYLES, propagate_version = true)]
#[command(after_help = "\
Verdicts: proved, refuted, consistent (with the printed digits), undecided, vacuous.
Exit codes: 0 everything asked for is proved; 1 something is refuted; 2 bad input or usage;
            3 nothing refuted, but not everything proved; 130 interrupted.
Example:
  isogeo check roof.obj --is planar,i-circular")]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
    /// How reports and errors are printed
    #[arg(long, value_enum, default_value_t = Layout::Text, global = true)]
    pub format: Layout,
}

const STYLES: Styles = Styles::styled()
    .header(AnsiColor::Blue.on_default().bold())
    .usage(AnsiColor::Blue.on_default().bold())
    .literal(AnsiColor::Cyan.on_default());

/// The layout of reports.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Layout {
    /// For people
    Text,
    /// For programs: one object with a `schema`
    Json,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    Check(CheckOptions),
    Info(InfoOptions),
    Convert(ConvertOptions),
    Dual(DualOptions),
    Move(MoveOptions),
    /// Print a completion script for a shell
    #[command(
        after_help = "Example:\n  isogeo completions bash > ~/.local/share/bash-completion/completions/isogeo"
    )]
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
    /// Print the manual page
    #[command(after_help = "Example:\n  isogeo man | man -l -")]
    Man,
}

/// How the numbers of a file are understood
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Reading {
    /// The text is the number: 0.1 is 1/10
    Decimal,
    /// The text stands for the box of half a unit of its last digit
    Rounded,
    /// The text stands for the nearest double, taken exactly
    Double,
}

impl From<Reading> for ReadAs {
    fn from(reading: Reading) -> ReadAs {
        match reading {
            Reading::Decimal => ReadAs::Decimal,
            Reading::Rounded => ReadAs::Rounded,
            Reading::Double => ReadAs::Double,
        }
    }
}

#[derive(Debug, Args)]
pub struct InputOptions {
    /// The mesh: .obj, .off, .ply or .iso.json
    pub mesh: PathBuf,
    /// How its numbers are understood [default: rounded; decimal if the file says that it is exact]
    #[arg(long, value_enum, value_name = "READING")]
    pub read_as: Option<Reading>,
}

/// Judge a mesh: a verdict for every property, with the worst element and its exact residual
#[derive(Debug, Args)]
#[command(after_help = "\
Properties: planar, i-circular, i-conical, inscribed, circumscribed, midscribed (to the unit
i-sphere 2z = x² + y²), delaunay (top view), circular, conical (Euclidean).
Without --is all are judged and the exit code is 0.
The defect of a residual is its size, divided by the sum of the sizes of its terms: free of units.
Example:
  isogeo check roof.obj --is planar,i-circular --format json")]
pub struct CheckOptions {
    #[command(flatten)]
    pub input: InputOptions,
    /// The properties to judge, separated by commas
    #[arg(long, value_name = "PROPERTY", value_delimiter = ',')]
    pub is: Vec<String>,
    /// Count a residual of at most T times its scale as undecided instead of refuted
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    pub tolerance: Option<f64>,
}

/// Describe a mesh: counts, valences, boundary loops, orientation, digits, bounding box
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  isogeo info roof.obj")]
pub struct InfoOptions {
    #[command(flatten)]
    pub input: InputOptions,
}

#[derive(Debug, Args)]
pub struct OutputOptions {
    /// The file to write: .obj, .off, .ply, .iso.json or .vtu
    #[arg(short, long, value_name = "OUT")]
    pub output: PathBuf,
}

/// Convert between formats, exactly where the target can be
#[derive(Debug, Args)]
#[command(after_help = "\
Fractions that are no finite decimals are rounded to doubles in OBJ, OFF, PLY and VTU, which is
said; --clear-denominators avoids it: xy is scaled by D and z by D², so that the unit i-sphere is
kept, and all coordinates become integers that every tool reads exactly.
Example:
  isogeo convert roof.iso.json roof.obj --clear-denominators")]
pub struct ConvertOptions {
    #[command(flatten)]
    pub input: InputOptions,
    /// The file to write: .obj, .off, .ply, .iso.json or .vtu
    pub output: PathBuf,
    /// Write integers: xy times the common denominator D, z times D²
    #[arg(long, conflicts_with = "digits")]
    pub clear_denominators: bool,
    /// Write decimals of N significant digits
    #[arg(long, value_name = "N", value_parser = digits)]
    pub digits: Option<NonZeroU16>,
}

fn digits(text: &str) -> Result<NonZeroU16, &'static str> {
    text.parse().map_err(|_| "expected a whole number from 1 to 65535")
}

/// Write the metric dual: vertices are the poles of the face planes
#[derive(Debug, Args)]
#[command(after_help = "\
The plane z = p·x' + t of a face becomes the vertex (p, −t), an interior vertex becomes a face.
i-circular meshes become i-conical ones and conversely. The mesh must be planar, exactly.
Example:
  isogeo dual shell.iso.json -o dual.iso.json")]
pub struct DualOptions {
    #[command(flatten)]
    pub input: InputOptions,
    #[command(flatten)]
    pub output: OutputOptions,
}

/// Apply an isotropic motion: rotate the top view, shear in z-direction, translate
#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "\
x' = a + cx − sy,  y' = b + sx + cy,  z' = c₀ + c₁x + c₂y + z  with  c² + s² = 1, exactly.
Numbers are integers, decimals or fractions.
Example:
  isogeo move roof.obj --rotate 3/5,4/5 --shear 1/2,0 --translate 0,0,10 -o moved.iso.json"
)]
pub struct MoveOptions {
    #[command(flatten)]
    pub input: InputOptions,
    /// Cosine and sine of the rotation of the top view
    #[arg(long, value_name = "C,S", allow_hyphen_values = true)]
    pub rotate: Option<String>,
    /// The shear in z-direction
    #[arg(long, value_name = "C1,C2", allow_hyphen_values = true)]
    pub shear: Option<String>,
    /// The translation
    #[arg(long, value_name = "A,B,C", allow_hyphen_values = true)]
    pub translate: Option<String>,
    #[command(flatten)]
    pub output: OutputOptions,
}
