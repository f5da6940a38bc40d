//! Options of the design of meshes.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::limits::LimitOptions;
use super::{InputOptions, OutputOptions};

/// Move the vertices of a mesh until it is planar, i-circular or i-conical
#[derive(Debug, Args)]
#[command(after_help = "\
A mesh near its goal moves as little as the conditions ask for. One that is far from it, or with other
wishes, first takes a compromise in which the conditions count more and more: with closeness to where
it was or to a target (by vertical distance), with the shape (the change of edges), with fairness
(second differences along the polylines of the mesh). Nothing depends on the unit or the position of the mesh. What comes out is a mesh of doubles in
which the property is observed; --rationalize makes an exact mesh near it, in which it is proved, and
--certify proves that an exact mesh with the property lies within a printed distance.
--fix keeps vertices where they are: boundary, corners (boundary vertices in one face), or vertices by
their numbers from 0. --slide lets boundary vertices move along the boundary, a polygon; corners stay.
--subdivide K: K times the mesh is refined by the rules of Catmull and Clark and optimised again.
Ctrl-C ends the work and keeps the best mesh so far (exit code 130).
Exit code: 0 the property is proved; 3 it is observed, or known to exist, or was not reached.
Examples:
  isogeo optimize roof.obj --to planar --fix boundary -o planar.obj
  isogeo optimize roof.obj --to i-conical --fairness 0.1 --rationalize -o exact.iso.json
  isogeo optimize coarse.obj --to i-circular --subdivide 3 --near shape.obj -o fine.obj --picture fine.svg")]
pub struct OptimizeOptions {
    #[command(flatten)]
    pub input: InputOptions,
    /// What the mesh shall become
    #[arg(long, value_enum)]
    pub to: Wish,
    /// What stays where it is: boundary, corners, or vertices by number, separated by commas
    #[arg(long, value_name = "WHAT")]
    pub fix: Option<String>,
    /// What moves along the polygon of the boundary
    #[arg(long, value_enum)]
    pub slide: Option<Slide>,
    /// A mesh to be near to, by vertical distance
    #[arg(long, value_name = "MESH2")]
    pub near: Option<PathBuf>,
    /// The weight of fairness; closeness has 1
    #[arg(long, value_name = "W", default_value_t = 0.0, value_parser = weight)]
    pub fairness: f64,
    /// The weight of the shape: edges change as little as they may; closeness has 1
    #[arg(long, value_name = "W", default_value_t = 10.0, value_parser = weight)]
    pub shape: f64,
    /// Refine so many times, and optimise each time
    #[arg(long, value_name = "K", default_value_t = 0, value_parser = clap::value_parser!(u8).range(0..=8))]
    pub subdivide: u8,
    /// All coordinates at once, or the top view first and then the heights
    #[arg(long, value_enum, default_value_t = Approach::Joint)]
    pub method: Approach,
    /// The most steps of each stage
    #[arg(long, value_name = "N", default_value_t = 50)]
    pub steps: usize,
    /// Make an exact mesh near the one in doubles, in which the property is proved
    #[arg(long)]
    pub rationalize: bool,
    /// How far no vertex shall move then [default: a millionth of the size of the mesh]
    #[arg(long, value_name = "D", value_parser = weight, requires = "rationalize")]
    pub within: Option<f64>,
    /// Prove that an exact mesh with the property is near, and write the certificate (.iso.json)
    #[arg(long)]
    pub certify: bool,
    /// A picture of the mesh before and after (SVG)
    #[arg(long, value_name = "SVG")]
    pub picture: Option<PathBuf>,
    #[command(flatten)]
    pub output: OutputOptions,
}

/// Prove that an exact mesh with a property is near a mesh in doubles, and write the certificate
#[derive(Debug, Args)]
#[command(after_help = "\
The numbers of the file are read as doubles; the property is one of real numbers, and no doubles
may have it. By the theorem of Newton and Kantorovich, in verified bounds, a mesh of real numbers
with the property is proved to exist, no vertex of which is farther from the same vertex of this
one than a printed radius. --fix names vertices that both share. The mesh is written unchanged with
the property, the radius and the fixed vertices; check proves it again from the mesh alone, with
the verdict 'exists'. That there is no proof is a result: exit code 3.
Examples:
  isogeo certify planar.obj --is planar --fix boundary -o planar.iso.json
  isogeo check planar.iso.json --is planar")]
pub struct CertifyOptions {
    /// The mesh: .obj, .off, .ply or .iso.json
    pub mesh: PathBuf,
    /// What the exact mesh is
    #[arg(long, value_enum, value_name = "PROPERTY")]
    pub is: Wish,
    /// What stays where it is: boundary, corners, or vertices by number, separated by commas
    #[arg(long, value_name = "WHAT")]
    pub fix: Option<String>,
    /// The file to write: .iso.json
    #[arg(short, long, value_name = "OUT")]
    pub output: PathBuf,
    #[command(flatten)]
    pub limits: LimitOptions,
}

/// What a mesh shall become
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Wish {
    /// Faces lie in planes
    Planar,
    /// Planar, with concyclic top views of faces
    ICircular,
    /// Planar, with concyclic gradients around interior vertices
    IConical,
    /// Planar, with circumcircles in Euclidean space
    Circular,
    /// Planar, with Euclidean cones of revolution around interior vertices
    Conical,
}

/// What moves along a curve
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Slide {
    /// The vertices of the boundary; corners stay
    Boundary,
}

/// How the conditions are approached
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Approach {
    /// All coordinates at once
    Joint,
    /// First the top view, then the heights, for which planarity is linear
    TwoStage,
}

fn weight(text: &str) -> Result<f64, &'static str> {
    let weight: Result<f64, _> = text.parse();
    weight
        .ok()
        .filter(|w| w.is_finite() && *w >= 0.0)
        .ok_or("expected a number that is not negative")
}
