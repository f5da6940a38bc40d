//! Options of pairs of meshes: curvatures, Gauss images, offsets, Christoffel duals, families.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::limits::LimitOptions;
use super::{InputOptions, OutputOptions};
use crate::construct::family::Family;

/// Compute H and K at faces or at vertices, exactly, of the mesh and a Gauss image
#[derive(Debug, Args)]
#[command(after_help = "\
At faces of an f-parallel pair H = area(F, S)/area(F) and K = area(S)/area(F), in the top view (17);
at vertices of a v-parallel pair H = D(v, s)/D(s) and K = D(v)/D(s), with areas of gradients (22).
Without --gauss the image is the one that the mesh itself determines: at faces the image
circumscribed to the unit i-sphere, of an i-conical mesh; at vertices the lift to it, of a triangle
mesh or an i-circular one. Numbers that are rounded are taken as they are printed.
Undefined values are reported with their reason; in a file their column 'defined' is 0.
Examples:
  isogeo curvature survey.obj --at vertices -o survey.vtu
  isogeo curvature shell.iso.json --at faces --gauss gauss.iso.json --format json")]
pub struct CurvatureOptions {
    #[command(flatten)]
    pub input: InputOptions,
    /// Where
    #[arg(long, value_enum)]
    pub at: At,
    /// The mesh S that stands for the Gauss image
    #[arg(long, value_name = "S")]
    pub gauss: Option<PathBuf>,
    /// In JSON also the integrated values: area(F), area(F, S), area(S), or D(v), D(v, s), D(s)
    #[arg(long)]
    pub integrated: bool,
    /// Write the mesh with H and K as data: .vtu (doubles, with defects) or .iso.json (exact)
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// The elements that have curvatures
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum At {
    /// Faces
    Faces,
    /// Vertices
    Vertices,
}

/// Write a Gauss image: a mesh inscribed or circumscribed to the unit i-sphere, exactly
#[derive(Debug, Args)]
#[command(after_help = "\
Kinds:
  lift           the same top view, lifted to the unit i-sphere; M i-circular, or of triangles
  delaunay       the same, where the top view of M is moreover a Delaunay triangulation
  inscribed      parallel edges, vertices on the sphere; M i-circular, faces with an even number of
                 sides; one for every start of vertex --at [default: mean of the gradients there]
  circumscribed  parallel planes, touching the sphere; M i-conical. With --start: the same top view,
                 and face --at touches over the start
That there is none is a result: exit code 1 if it is refuted, else 3.
Example:
  isogeo gauss shell.iso.json --kind inscribed --start 1/3,1/2 -o gauss.iso.json")]
pub struct GaussOptions {
    #[command(flatten)]
    pub input: InputOptions,
    /// Which Gauss image
    #[arg(long, value_enum)]
    pub kind: GaussKind,
    /// The top view of the image of vertex --at, or of the contact point of face --at
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
    pub start: Option<String>,
    /// The vertex or face to start from [default: 0; without --start, the first vertex of most faces]
    #[arg(long, value_name = "N")]
    pub at: Option<u32>,
    #[command(flatten)]
    pub output: OutputOptions,
}

/// Which Gauss image
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum GaussKind {
    /// f-parallel, vertices on the unit i-sphere
    Inscribed,
    /// f-parallel, or v-parallel with --start: planes that touch the unit i-sphere
    Circumscribed,
    /// v-parallel, vertices on the unit i-sphere
    Lift,
    /// The lift over a Delaunay triangulation
    Delaunay,
}

/// Write the offset M + dS of a mesh M with a Gauss image S
#[derive(Debug, Args)]
#[command(after_help = "\
M and S must be f-parallel or have parallel edges, exactly; with --vertical they must have the same
top view, and vertices are moved by d times the height of S. That they do not fit is a result: exit
code 1 if it is refuted, else 3. Data on elements are left out: they are those of M.
Example:
  isogeo offset shell.iso.json --gauss gauss.iso.json -d 1/2 -o offset.iso.json")]
pub struct OffsetOptions {
    #[command(flatten)]
    pub input: InputOptions,
    /// The mesh S, with the faces of M
    #[arg(long, value_name = "S")]
    pub gauss: PathBuf,
    /// The distance: an integer, a decimal or a fraction
    #[arg(short, long, value_name = "D", allow_hyphen_values = true)]
    pub distance: String,
    /// Move vertices vertically, in a pair with the same top view
    #[arg(long)]
    pub vertical: bool,
    #[command(flatten)]
    pub output: OutputOptions,
}

/// Write the Christoffel dual: parallel edges, mixed area 0 at every face
#[derive(Debug, Args)]
#[command(after_help = "\
With signed radii R in data.vertex.radius the edges are divided by R_i R_j, with signs that alternate
around every face; without, the ratios of the diagonals of planar quads tell the factors (Koenigs).
Written as .iso.json, the factors are its certificate. That it does not close is a result, with the
vertex, face or cycle that fails: exit code 1 if it is refuted, else 3.
Example:
  isogeo christoffel koebe.iso.json -o minimal.iso.json")]
pub struct ChristoffelOptions {
    #[command(flatten)]
    pub input: InputOptions,
    #[command(flatten)]
    pub output: OutputOptions,
}

/// Make an exact family of meshes: DIR/surface.iso.json, and DIR/gauss.iso.json where there is one
#[derive(Debug, Args)]
#[command(after_help = families_help())]
pub struct MakeOptions {
    /// The family
    pub family: String,
    /// M rows by N columns of faces, or M rings by N sectors
    #[arg(long, value_name = "MxN")]
    pub n: Option<String>,
    /// Parameters: name=value, or name=value,value
    #[arg(short, long = "parameter", value_name = "NAME=VALUE,..", allow_hyphen_values = true)]
    pub parameters: Vec<String>,
    /// The folder to write to; it is made if it is not there
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
    #[command(flatten)]
    pub limits: LimitOptions,
}

/// The families with their parameters and defaults.
fn families_help() -> String {
    let mut text = String::from("Families, with --n and -p as they are by default:\n");
    for family in Family::ALL {
        let [m, n] = family.size();
        let parameters =
            family.parameters().iter().map(|p| format!(" -p {}={}", p.name, p.default));
        let parameters: String = parameters.collect();
        text +=
            &format!("  {} --n {m}x{n}{parameters}\n      {}\n", family.name(), family.summary());
    }
    text + "\
  koebe -p mesh=FILE [-p outer=N]
      the i-Koebe mesh with these combinatorics, in doubles: all edges touch the unit i-sphere; with
      a boundary its radii are data.vertex.radius of the file or 1, a closed mesh is closed by face N
Values are integers, decimals or fractions; vertex radii are written as data.vertex.radius.
Examples:
  isogeo make enneper --n 8x8 -p center=4,4 -o enneper
  isogeo check enneper/surface.iso.json --with enneper/gauss.iso.json --is f-parallel,i-minimal"
}
