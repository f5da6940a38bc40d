//! Options of the sphere transformations.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::{InputOptions, OutputOptions};

/// Invert at an i-sphere: an i-M-transformation, which keeps i-circular meshes
#[derive(Debug, Args)]
#[command(after_help = "\
--at: (x, y, z) goes to c + r² (x − c₁, y − c₂, z)/|x' − c|², the inversion at the cylinder over the
circle with centre c and squared radius r² (negative for an imaginary one); its centre in space has
height 0. A vertex over c has no image, which is an error; a face whose circle passes through c
becomes vertical.
--sphere: z goes to 2 s(x, y) − z, the inversion at the i-sphere s = A(x² + y²)/2 + Bx + Cy + D.
Data on elements are left out. Of planar faces, in general only i-circular ones stay planar.
--by incircles: of an i-isothermic mesh with radii (data on vertices, 'radius') the circles of faces
are inverted, which are orthogonal to the vertex circles. Their planes meet again in the vertices of
an i-isothermic mesh with signed radii, which are kept; the top views of its vertices are the centres
of the inverted vertex circles. That there is no such image is a result: exit code 1.
Examples:
  isogeo invert shell.iso.json --at 1/2,3 --radius2 4 -o inverted.iso.json
  isogeo invert shell.iso.json --sphere 1,0,0,0 -o reflected.iso.json
  isogeo invert enneper.iso.json --at 1/3,7 --by incircles -o biharmonic.iso.json")]
pub struct InvertOptions {
    #[command(flatten)]
    pub input: InputOptions,
    /// The centre of the top view: the axis of the cylinder
    #[arg(
        long,
        value_name = "X,Y",
        allow_hyphen_values = true,
        required_unless_present = "sphere"
    )]
    pub at: Option<String>,
    /// The squared radius
    #[arg(long, value_name = "R2", default_value = "1", allow_hyphen_values = true)]
    pub radius2: String,
    /// An i-sphere of parabolic type, or a plane, instead of a cylinder
    #[arg(
        long,
        value_name = "A,B,C,D",
        allow_hyphen_values = true,
        conflicts_with_all = ["at", "radius2"]
    )]
    pub sphere: Option<String>,
    /// What is inverted
    #[arg(long, value_enum, default_value_t = Inverted::Vertices)]
    pub by: Inverted,
    #[command(flatten)]
    pub output: OutputOptions,
}

/// What an inversion is applied to
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Inverted {
    /// The points
    Vertices,
    /// The circles of faces of an i-isothermic mesh with radii
    Incircles,
}

/// Map between isotropic and Euclidean space: i-circular to conical, i-isothermic to edge-offset
#[derive(Debug, Args)]
#[command(after_help = "\
A vertex (a, b, c) becomes the plane with unit normal n = (2a, 2b, 1 − a² − b²)/(1 + a² + b²) and
n·x + 2c/(1 + a² + b²) = 0 (12), a face becomes the vertex of the cone of revolution that belongs to
its circle: the circumcircle, or the circle orthogonal to touching circles around the vertices whose
radii stand as data on vertices under 'radius'. A conical mesh keeps its planes exactly, as data on
faces n1, n2, n3, h: the unit normals are rational. The side of the normals is that of positive
distance. An edge-offset mesh keeps the axes of its cones, as data on vertices s1, s2, s3. With
--to isotropic axes or planes are used that stand there, else planes that are computed from the
vertices, if their unit normals are rational; from axes comes an i-isothermic mesh with radii.
That there is no image is a result: exit code 1 if it is refuted, else 3. The exit code is 3, too, if
some faces run against their planes: then other offsets are conical meshes, this one is not.
Examples:
  isogeo transfer shell.iso.json --to euclidean -o conical.iso.json --gauss sphere.iso.json
  isogeo transfer conical.iso.json --to isotropic -o circular.iso.json")]
pub struct TransferOptions {
    #[command(flatten)]
    pub input: InputOptions,
    /// Where to
    #[arg(long, value_enum)]
    pub to: Space,
    /// The circles of faces [default: incircles if the vertices have radii, else circumcircles]
    #[arg(long, value_enum)]
    pub by: Option<Circles>,
    /// Also write the Gauss image S, tangent to the unit sphere
    #[arg(long, value_name = "S")]
    pub gauss: Option<PathBuf>,
    /// Write the offset at distance D, the image plus D times S [default: 0]
    #[arg(short, long, value_name = "D", allow_hyphen_values = true)]
    pub distance: Option<String>,
    #[command(flatten)]
    pub output: OutputOptions,
}

/// The two geometries
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Space {
    /// Oriented planes of Euclidean space
    Euclidean,
    /// Points of isotropic space
    Isotropic,
}

/// Circles of faces in the top view
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Circles {
    /// Of an i-circular mesh: gives a conical mesh
    Circumcircles,
    /// Of an i-isothermic mesh with radii: gives an edge-offset mesh
    Incircles,
}
