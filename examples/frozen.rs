//! Makes the meshes of Figs. 4 and 5 that come from optimisation: control meshes are subdivided and
//! optimised in turn, and the results are made exact and frozen, as doubles differ between machines.
//!
//! `cargo run --release --example frozen -- src/figure/frozen` writes them.

use std::error::Error;
use std::path::Path;
use std::sync::Arc;

use isogeo::construct::quad_patch;
use isogeo::construct::subdivision::{Sharp, catmull_clark};
use isogeo::mesh::file::{Options, write};
use isogeo::mesh::{Mesh, VertexId, VertexKind};
use isogeo::optimise::rationalise::{self, i_circular, i_conical};
use isogeo::optimise::{Design, Goal, Mobility, Target, mean_edge};
use isogeo::space::Point;

/// How a mesh comes about.
pub struct Recipe {
    /// What it shall be.
    pub goal: Goal,
    /// The names of the meshes that are frozen, that of the last level last.
    pub names: &'static [&'static str],
    /// The mesh that it starts from.
    pub control: Control,
    /// Whether it is to approximate the [`given`] surface with its boundary.
    pub fitted: bool,
}

/// A grid with heights `along + across`, its top view bent by `w ↦ w + bend w²` for `w = x + iy`.
pub struct Control {
    /// The lines of the grid across the first axis.
    pub x: &'static [f64],
    /// The lines across the second.
    pub y: &'static [f64],
    /// The part of the heights that depends on `x`.
    pub along: &'static [f64],
    /// The part that depends on `y`.
    pub across: &'static [f64],
    /// The coefficient of `w²`.
    pub bend: [f64; 2],
}

/// The meshes of the figures.
pub const RECIPES: [Recipe; 4] = [
    Recipe {
        goal: Goal::ICircular,
        names: &["roof"],
        control: Control {
            x: &[-6.0, -3.0, 0.0, 3.0, 6.0],
            y: &[-3.0, -1.0, 1.0, 3.0],
            along: &[0.8, 1.2, -0.4, -0.6, 1.6],
            across: &[0.0, 1.8, 1.6, -0.6],
            bend: [0.0, -0.045],
        },
        fitted: false,
    },
    Recipe {
        goal: Goal::IConical,
        names: &["canopy"],
        control: Control {
            x: &[-5.0, -2.5, 0.0, 2.5, 5.0],
            y: &[-3.0, -1.0, 1.0, 3.0],
            along: &[-0.6, 1.8, 2.6, 1.4, -1.2],
            across: &[-0.2, 1.2, 1.3, -0.4],
            bend: [-0.035, 0.0],
        },
        fitted: false,
    },
    Recipe {
        goal: Goal::IConical,
        names: &["m0", "m1", "m2"],
        control: Control {
            x: &[-4.5, -1.5, 1.5, 4.5],
            y: &[-3.5, -1.2, 1.2, 3.5],
            along: &[2.6, 0.3, 0.1, 3.0],
            across: &[-1.6, 0.0, 0.1, -1.1],
            bend: [0.03, 0.01],
        },
        fitted: false,
    },
    Recipe {
        goal: Goal::IConical,
        names: &["fitted"],
        control: Control {
            x: &[-5.0, -2.5, 0.0, 2.5, 5.0],
            y: &[-3.0, -1.0, 1.0, 3.0],
            along: &[0.0; 5],
            across: &[0.0; 4],
            bend: [0.0, 0.0],
        },
        fitted: true,
    },
];

/// The surface that is approximated: `z = -x²/24 - y²/7 + xy/100 + x³/400`, sampled.
pub fn given() -> Result<Mesh<f64>, Box<dyn Error>> {
    let height = |x: f64, y: f64| -x * x / 24.0 - y * y / 7.0 + x * y / 100.0 + x * x * x / 400.0;
    let at = |i: i32, n: i32| f64::from(2 * i - n) / 4.0;
    let grid = (0..=26).flat_map(|i| (0..=18).map(move |j| (at(i, 26), at(j, 18))));
    let points = grid.map(|(x, y)| Point::new(x, y, height(x, y))).collect();
    Ok(Mesh::new(points, quad_patch(26, 18))?)
}

impl Control {
    /// The mesh.
    pub fn mesh(&self) -> Result<Mesh<f64>, Box<dyn Error>> {
        let [a, b] = self.bend;
        let point = |(x, z): (&f64, &f64), (y, w): (&f64, &f64)| {
            let (p, q) = (x * x - y * y, 2.0 * x * y);
            Point::new(x + a * p - b * q, y + b * p + a * q, z + w)
        };
        let columns = self.x.iter().zip(self.along);
        let row = |c| self.y.iter().zip(self.across).map(move |r| point(c, r));
        let faces = quad_patch(self.x.len() - 1, self.y.len() - 1);
        Ok(Mesh::new(columns.flat_map(row).collect(), faces)?)
    }
}

impl Recipe {
    /// Optimises, and twice subdivides and optimises again; of each level the mesh before and after.
    ///
    /// A mesh that is fitted is first raised onto the given surface; its corners are fixed, and
    /// its boundary slides.
    pub fn levels(&self) -> Result<Vec<[Mesh<f64>; 2]>, Box<dyn Error>> {
        let target = if self.fitted { Target::new(&given()?).map(Arc::new) } else { None };
        let mut sharp = Sharp { keep_corners: true, ..Sharp::default() };
        let mut mesh = self.control.mesh()?;
        let mut levels = Vec::new();
        loop {
            if let Some(target) = &target {
                mesh.points.iter_mut().for_each(|p| p.z = target.height(&p.top_view()).0);
            }
            let mobility = |v| if self.fitted { sliding(&mesh, v) } else { Mobility::Free };
            let design = Design {
                fairness: 1.0,
                shape: if self.fitted { 100.0 } else { 10.0 },
                target: target.clone(),
                mobility: mesh.topology.vertices().map(mobility).collect(),
                ..Design::new(self.goal, mesh.points.len())
            };
            let found = design.run(&mesh, |_| true).map_err(|_| "there is not enough memory")?;
            let after = Mesh { points: found.points, ..mesh.clone() };
            levels.push([mesh, after.clone()]);
            if levels.len() == 3 {
                return Ok(levels);
            }
            (mesh, sharp) = catmull_clark(&after, &sharp)?;
        }
    }
}

/// Along the boundary for a vertex there, and not at all for a corner.
fn sliding(mesh: &Mesh<f64>, v: VertexId) -> Mobility {
    let topology = &mesh.topology;
    let star: Vec<_> = topology.star(v).collect();
    match &star[..] {
        _ if topology.kind(v) != VertexKind::Boundary => Mobility::Free,
        [first, .., last] => {
            let ends = [topology.target(*first), topology.origin(topology.prev(*last))];
            let [from, to] = ends.map(|v| &mesh.points[v.index()]);
            Mobility::along(from, to)
        }
        _ => Mobility::Fixed,
    }
}

/// Writes the frozen meshes into a folder: exact ones that are at most a hundredth of an edge from
/// those of the optimisation.
pub fn write_all(folder: &Path) -> Result<(), Box<dyn Error>> {
    for recipe in &RECIPES {
        let levels = recipe.levels()?;
        for (name, [before, found]) in recipe.names.iter().rev().zip(levels.iter().rev()) {
            let within = mean_edge(&before.topology, &before.points) / 100.0;
            let options =
                rationalise::Options { within, ..rationalise::Options::of(&found.points) };
            let exact = match recipe.goal {
                Goal::ICircular => i_circular(found, &options)?,
                _ => i_conical(found, &options)?,
            };
            write(folder.join(format!("{name}.iso.json")), &exact.mesh, &Options::default())?;
        }
    }
    Ok(())
}

#[allow(dead_code, reason = "the tests compare the meshes themselves")]
fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).ok_or("usage: frozen FOLDER")?;
    write_all(Path::new(&folder))
}
