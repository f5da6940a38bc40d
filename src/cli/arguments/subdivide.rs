//! Options of subdivision.

use clap::{Args, ValueEnum};

use super::{InputOptions, OutputOptions};

/// Subdivide a mesh: Catmull-Clark on its vertices, or on the planes of its faces, exactly
#[derive(Debug, Args)]
#[command(after_help = "\
--scheme catmull-clark: faces of any size become quads. The boundary becomes a cubic B-spline that
nothing beside it moves; creases are treated in the same way. A vertex with more than two sharp
edges stays, so do pinched and isolated ones.
--scheme dual: Catmull-Clark on the poles of the face planes, and back: a face for every face,
interior edge and vertex, a vertex for every corner (for i-conical meshes with K ≠ 0). Planes are
fitted where a face is not planar, points where planes do not meet. The boundary becomes a quadratic
B-spline. That planes determine no point (K = 0), or are vertical, is a result: exit code 3.
Neither keeps planarity, circles or cones: the result is where an optimisation starts from. Data on
elements are left out.
Examples:
  isogeo subdivide roof.obj -n 2 --keep-corners --crease 0-4-8,1-5 -o fine.iso.json
  isogeo subdivide conical.iso.json --scheme dual -o fine.iso.json")]
pub struct SubdivideOptions {
    #[command(flatten)]
    pub input: InputOptions,
    /// How many times: edges are halved each time
    #[arg(
        short = 'n',
        long = "steps",
        value_name = "K",
        default_value_t = 1,
        value_parser = clap::value_parser!(u8).range(1..=8)
    )]
    pub steps: u8,
    /// What is refined
    #[arg(long, value_enum, default_value_t = Scheme::CatmullClark)]
    pub scheme: Scheme,
    /// Keep boundary vertices of a single face where they are
    #[arg(long)]
    pub keep_corners: bool,
    /// Edges to keep sharp: chains of vertices, counted from 0
    #[arg(long, value_name = "V-V-..", value_delimiter = ',')]
    pub crease: Vec<String>,
    #[command(flatten)]
    pub output: OutputOptions,
}

/// What a subdivision refines
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Scheme {
    /// The vertices
    CatmullClark,
    /// The planes of the faces
    Dual,
}
