//! The families of meshes by name, with their parameters, defaults, and what they prove.
//!
//! Each is one call of a construction, over rational numbers. Where a curve is not rational, its
//! points are chosen so that they are, or the mesh is enclosed: see the summaries and
//! [`Enclosure`].

mod enclosed;
mod member;
mod values;

pub use member::{Enclosure, Member, NoMember};
pub use values::{BadValue, Values};

use crate::net::Property;
use crate::pair::PairProperty;

/// A family of meshes that can be asked for by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Family {
    /// Elliptic, hyperbolic and parabolic paraboloids.
    Paraboloid,
    /// The right hyperbolic paraboloid with its Koebe mesh.
    Saddle,
    /// The isotropic Enneper surface.
    Enneper,
    /// The rotational i-minimal surface.
    Logarithmoid,
    /// The conjugate A-net of the logarithmoid.
    Helicoid,
    /// The isotropic counterpart of Bonnet's surface.
    Bonnet,
    /// An i-minimal circular net from random holomorphic data.
    Weierstrass,
    /// A random i-circular net.
    CircularNet,
    /// A random i-conical net.
    ConicalNet,
    /// A triangulated graph.
    TriangleGraph,
    /// A rotational mesh with constant H.
    RotationalCmc,
    /// A rotational mesh with constant K.
    RotationalConstantK,
    /// A rotational hexagonal mesh with H = 0.
    HexMinimal,
    /// A rotational hexagonal mesh with constant H.
    HexCmc,
    /// A rotational hexagonal mesh with constant K.
    HexConstantK,
}

/// A parameter of a family.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// Its name.
    pub name: &'static str,
    /// Its value, as it would be given.
    pub default: &'static str,
}

const fn parameter(name: &'static str, default: &'static str) -> Parameter {
    Parameter { name, default }
}

impl Family {
    /// All families, in the order of lists.
    pub const ALL: [Family; 15] = [
        Family::Paraboloid,
        Family::Saddle,
        Family::Enneper,
        Family::Logarithmoid,
        Family::Helicoid,
        Family::Bonnet,
        Family::Weierstrass,
        Family::CircularNet,
        Family::ConicalNet,
        Family::TriangleGraph,
        Family::RotationalCmc,
        Family::RotationalConstantK,
        Family::HexMinimal,
        Family::HexCmc,
        Family::HexConstantK,
    ];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Family::Paraboloid => "paraboloid",
            Family::Saddle => "saddle",
            Family::Enneper => "enneper",
            Family::Logarithmoid => "logarithmoid",
            Family::Helicoid => "helicoid",
            Family::Bonnet => "bonnet",
            Family::Weierstrass => "weierstrass",
            Family::CircularNet => "circular-net",
            Family::ConicalNet => "conical-net",
            Family::TriangleGraph => "triangle-graph",
            Family::RotationalCmc => "rotational-cmc",
            Family::RotationalConstantK => "rotational-constant-k",
            Family::HexMinimal => "hex-minimal",
            Family::HexCmc => "hex-cmc",
            Family::HexConstantK => "hex-constant-k",
        }
    }

    /// The family of that name.
    pub fn from_name(name: &str) -> Option<Family> {
        Family::ALL.into_iter().find(|family| family.name() == name)
    }

    /// What it is, in one line.
    pub fn summary(self) -> &'static str {
        match self {
            Family::Paraboloid => "z = (A x² + B y²)/2 over a square grid, H = (A + B)/2, K = AB",
            Family::Saddle => "i-minimal: dual of the square grid of circles, z = (x² - y²)/2",
            Family::Enneper => "i-minimal: dual of the same circles, inverted at a center",
            Family::Logarithmoid => {
                "i-minimal: dual of rings of circles; cosine and sine of half a sector"
            }
            Family::Helicoid => "i-minimal A-net with skew faces, conjugate to the logarithmoid",
            Family::Bonnet => "i-minimal: dual of rings of circles, inverted at a center",
            Family::Weierstrass => {
                "i-minimal circular net from random holomorphic data; mean=H: H constant"
            }
            Family::CircularNet => {
                "random i-circular net, with a parallel net inscribed to the sphere"
            }
            Family::ConicalNet => "random i-conical net, with the net circumscribed to the sphere",
            Family::TriangleGraph => {
                "graph of a formula (+ - * / ^) over a lattice, two triangles a cell, with its lift"
            }
            Family::RotationalCmc => "r R - H r² = C for the radii r of M and R of S",
            Family::RotationalConstantK => {
                "r² - R²/K = C; exact for squares of fractions, else enclosed to so many bits"
            }
            Family::HexMinimal => {
                "hexagons with H = 0, S circumscribed; cosine and sine of half a sector"
            }
            Family::HexCmc => "hexagons with H constant, S almost circumscribed",
            Family::HexConstantK => {
                "hexagons with K constant; exact for squares of fractions, else enclosed to so many bits"
            }
        }
    }

    /// Rows and columns, or rings and sectors, that are made by default.
    pub fn size(self) -> [usize; 2] {
        match self {
            Family::Paraboloid | Family::Saddle => [12, 12],
            Family::Enneper => [8, 8],
            Family::Logarithmoid | Family::Helicoid => [8, 14],
            Family::Bonnet => [6, 14],
            Family::Weierstrass | Family::ConicalNet => [4, 4],
            Family::CircularNet => [5, 5],
            Family::TriangleGraph => [12, 12],
            Family::RotationalCmc | Family::RotationalConstantK => [12, 14],
            Family::HexMinimal | Family::HexCmc | Family::HexConstantK => [6, 14],
        }
    }

    /// The parameters with their defaults.
    pub fn parameters(self) -> &'static [Parameter] {
        const SECTOR: Parameter = parameter("half-angle", "40/41,9/41");
        const BITS: Parameter = parameter("bits", "64");
        match self {
            Family::Paraboloid => const { &[parameter("curvatures", "1,1/2")] },
            Family::Saddle => &[],
            Family::Enneper => const { &[parameter("center", "0,0")] },
            Family::Logarithmoid | Family::Helicoid => const { &[SECTOR] },
            Family::Bonnet => const { &[SECTOR, parameter("center", "-1/2,1/5")] },
            Family::Weierstrass => const { &[parameter("seed", "1"), parameter("mean", "0")] },
            Family::CircularNet | Family::ConicalNet => const { &[parameter("seed", "1")] },
            Family::TriangleGraph => {
                const { &[parameter("formula", "x^3/3-x*y^2"), parameter("step", "1/6")] }
            }
            Family::RotationalCmc => {
                const { &[SECTOR, parameter("mean", "1"), parameter("integral", "-1/2")] }
            }
            Family::RotationalConstantK => {
                const { &[SECTOR, parameter("curvature", "-1"), parameter("integral", "1"), BITS] }
            }
            Family::HexMinimal => const { &[SECTOR, parameter("integral", "7/3")] },
            Family::HexCmc => {
                const { &[SECTOR, parameter("mean", "1"), parameter("integral", "-3")] }
            }
            Family::HexConstantK => {
                const { &[SECTOR, parameter("curvature", "1"), parameter("integral", "7/3"), BITS] }
            }
        }
    }

    /// What `check` proves of the surface, and of the surface with its Gauss image, where they are
    /// exact; see [`Member::proves`].
    pub fn proves(self) -> (&'static [Property], &'static [PairProperty]) {
        use PairProperty as P;
        use Property::*;
        match self {
            Family::Paraboloid => {
                (&[Planar, ICircular, IConical], &[P::FParallel, P::Cmc, P::ConstantK])
            }
            Family::Saddle | Family::Enneper | Family::Logarithmoid | Family::Bonnet => (
                &[Planar, IIsothermic, Koenigs, IMinimal],
                &[P::Parallel, P::FParallel, P::ChristoffelDual, P::IMinimal],
            ),
            Family::Helicoid => (&[ANet], &[]),
            Family::Weierstrass => (&[ICircular, IIsothermic], &[P::FParallel, P::Cmc]),
            Family::CircularNet => (&[ICircular], &[P::FParallel]),
            Family::ConicalNet => (&[IConical], &[P::FParallel]),
            Family::TriangleGraph => (&[], &[P::VParallel]),
            Family::RotationalCmc => (&[ICircular, IConical], &[P::FParallel, P::Cmc]),
            Family::RotationalConstantK => (&[ICircular, IConical], &[P::FParallel, P::ConstantK]),
            Family::HexMinimal => (&[Planar], &[P::FParallel, P::IMinimal]),
            Family::HexCmc => (&[Planar], &[P::FParallel, P::Cmc]),
            Family::HexConstantK => (&[Planar], &[P::FParallel, P::ConstantK]),
        }
    }
}
