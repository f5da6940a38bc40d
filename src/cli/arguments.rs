//! Commands and options.

#[cfg(feature = "campaigns")]
mod campaigns;
mod claims;
#[cfg(feature = "optimise")]
mod design;
mod figures;
mod limits;
mod pairs;
mod spheres;
mod subdivide;

use std::num::NonZeroU16;
use std::path::PathBuf;

use clap::builder::styling::{AnsiColor, Styles};
use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::scalar::ReadAs;
#[cfg(feature = "campaigns")]
pub use campaigns::{FuzzOptions, MergeOptions, ReplayOptions};
pub use claims::{CertificateOptions, ClaimsCommand, ClaimsOptions, System, VerifyOptions};
#[cfg(feature = "optimise")]
pub use design::{Approach, CertifyOptions, OptimizeOptions, Slide, Wish};
pub use figures::{FigureKind, FigureOptions, ViewOptions};
pub use limits::LimitOptions;
pub use pairs::{
    At, ChristoffelOptions, CurvatureOptions, GaussKind, GaussOptions, MakeOptions, OffsetOptions,
};
pub use spheres::{Circles, InvertOptions, Inverted, Space, TransferOptions};
pub use subdivide::{Scheme, SubdivideOptions};

/// Discrete surfaces in isotropic geometry, checked exactly.
#[derive(Debug, Parser)]
#[command(name = "isogeo", version, about, styles = STYLES, propagate_version = true)]
#[command(after_help = "\
Verdicts: proved, refuted, consistent (with the printed digits), exists (an exact mesh is near),
          undecided, vacuous.
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
    Curvature(CurvatureOptions),
    Gauss(GaussOptions),
    Offset(OffsetOptions),
    Christoffel(ChristoffelOptions),
    Make(MakeOptions),
    Move(MoveOptions),
    Invert(InvertOptions),
    Transfer(TransferOptions),
    Subdivide(SubdivideOptions),
    Triangulate(TriangulateOptions),
    Accuracy(AccuracyOptions),
    Claims(ClaimsOptions),
    #[cfg(feature = "campaigns")]
    Fuzz(FuzzOptions),
    #[cfg(feature = "campaigns")]
    Merge(MergeOptions),
    #[cfg(feature = "campaigns")]
    Replay(ReplayOptions),
    #[cfg(feature = "optimise")]
    Optimize(OptimizeOptions),
    #[cfg(feature = "optimise")]
    Certify(CertifyOptions),
    Figure(FigureOptions),
    View(ViewOptions),
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
    #[command(flatten)]
    pub limits: LimitOptions,
}

/// Judge a mesh: a verdict for every property, with the worst element and its exact residual
#[derive(Debug, Args)]
#[command(after_help = "\
Properties: planar, i-circular, i-conical, inscribed, circumscribed, midscribed (to the unit
i-sphere 2z = x² + y²), delaunay (top view), i-isothermic (touching circles with the signed radii in
data.vertex.radius; without radii, circular quads with factorised cross-ratios), koenigs (planar quads
with a Christoffel dual around interior vertices), i-minimal (H = 0 at vertices, with the lift), a-net
(planar vertex stars), circular, conical, edge-offset (Euclidean).
Properties of a pair M, S, with --with S: parallel (edges), f-parallel (face planes), v-parallel
(top views), christoffel-dual (parallel, mixed areas 0), i-minimal (H = 0 at every face), cmc (H is
the same at every face), constant-k. S has the faces of M, with the vertices in the same order.
Without --is all are judged and the exit code is 0.
Where the numbers of an .iso.json file refute a property, but it has a certificate that an exact
mesh is near (see certify), that is verified from the mesh alone; then the verdict is 'exists'.
The defect of a residual is its size, divided by the sum of the sizes of its terms: free of units.
Examples:
  isogeo check roof.obj --is planar,i-circular --format json
  isogeo check roof.obj --with gauss.iso.json --is f-parallel,i-minimal")]
pub struct CheckOptions {
    #[command(flatten)]
    pub input: InputOptions,
    /// The properties to judge, separated by commas
    #[arg(long, value_name = "PROPERTY", value_delimiter = ',')]
    pub is: Vec<String>,
    /// A second mesh S, such as a Gauss image: judge the pair, too
    #[arg(long, value_name = "MESH2")]
    pub with: Option<PathBuf>,
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

/// Write the Delaunay mesh of scattered samples, every sign decided exactly
#[derive(Debug, Args)]
#[command(after_help = "\
Lines 'x y z' with blanks, commas or semicolons between; # starts a comment; a header line is
skipped. Vertices keep the order of the file; points on one empty circle are joined to the
lexicographically lowest, so the mesh depends on the set of points alone.
With --sample the heights are those of a formula over the top views in FILE: exact for + - * / ^,
rounded to doubles for sin cos exp sqrt log.
Examples:
  isogeo triangulate survey.csv -o survey.iso.json
  isogeo triangulate --sample 'x^2/2 - x*y' --at places.txt -o graph.iso.json")]
pub struct TriangulateOptions {
    /// The samples: lines of three numbers
    #[arg(required_unless_present = "sample", conflicts_with_all = ["sample", "at"])]
    pub points: Option<PathBuf>,
    /// Take heights from a formula in x and y
    #[arg(long, value_name = "EXPR", requires = "at", allow_hyphen_values = true)]
    pub sample: Option<String>,
    /// The top views to sample at: lines of two numbers, a third is not looked at
    #[arg(long, value_name = "FILE", requires = "sample")]
    pub at: Option<PathBuf>,
    /// How numbers are understood
    #[arg(long, value_enum, value_name = "READING", default_value_t = Reading::Decimal)]
    pub read_as: Reading,
    #[command(flatten)]
    pub limits: LimitOptions,
    #[command(flatten)]
    pub output: OutputOptions,
}

/// Compare the curvatures (22) of sampled surfaces with the smooth ones, by class of triangulation
#[derive(Debug, Args)]
#[command(after_help = "\
The surface z = EXPR is sampled on triangulations of the unit square (oblique and mapped ones lie
about it); errors are those of H against Δf/2 and of K against det of the Hessian, at the vertices
in the inner quarter, exactly for formulas of + - * / ^. 'mean' is weighted by area.
Classes: lattice, right-angled, mapped, union-jack, delaunay (random points).
Example:
  isogeo accuracy 'x^4/12 + y^2/2 + x*y^3/6' --class right-angled,union-jack")]
pub struct AccuracyOptions {
    /// The surface: a formula in x and y
    #[arg(value_name = "EXPR", allow_hyphen_values = true)]
    pub expression: String,
    /// The classes of triangulation, separated by commas [default: all]
    #[arg(long, value_name = "CLASS", value_delimiter = ',')]
    pub class: Vec<String>,
    /// The mesh sizes 1/N, from coarse to fine
    #[arg(long, value_name = "N,..", value_delimiter = ',', default_value = "8,16,32,64")]
    pub sizes: Vec<u32>,
    /// The seed of the random points
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
}
