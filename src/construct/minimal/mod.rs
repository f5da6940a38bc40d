//! i-minimal surfaces with their Gauss images (Sec. 4, Fig. 8, Fig. 10): `H = 0` (19).
//!
//! | surface | Koebe mesh | smooth |
//! | --- | --- | --- |
//! | [`saddle`] | the square grid, lifted | `z = (x² − y²)/2` |
//! | [`enneper`] | the same, inverted | `w = −ζ³/3, z = −½ Re ζ²` |
//! | [`logarithmoid`] | concentric rings | `z = −ln r` |
//! | [`bonnet`] | the same, inverted | `w = ζ + sinh ζ, z = Re cosh ζ` |
//! | [`helicoid`] | – | `z = −arg x'`: an A-net, conjugate to the logarithmoid |
//! | [`Weierstrass`] | – | any: circular nets and A-nets from a discrete holomorphic function |
//!
//! Those from Koebe meshes S are Christoffel duals M of S, scaled by the square of the first radius of
//! the packing before inversion; both carry the signed radii of their vertex circles. They are
//! i-minimal in both senses: `H = 0` at faces for the pair (M, S), and at vertices for the
//! v-parallel Koebe mesh over the circles of M. Their rows and columns lie in planes. Near branch
//! points the top view has several sheets, and nothing here asks for an embedding.

mod bonnet;
mod complex;
mod enneper;
mod helicoid;
mod logarithmoid;
mod saddle;
mod weierstrass;

use std::fmt;

use super::{NoChristoffelDual, ThroughCentre};
use crate::mesh::Mesh;
use crate::mesh::TopologyError;

pub use bonnet::bonnet;
pub use enneper::enneper;
pub use helicoid::helicoid;
pub use logarithmoid::logarithmoid;
pub use saddle::saddle;
pub use weierstrass::{Weierstrass, WeierstrassData};

/// A mesh M with a mesh S that stands for its Gauss image.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshPair<T> {
    /// The mesh M.
    pub surface: Mesh<T>,
    /// The mesh S with the same faces.
    pub gauss: Mesh<T>,
}

/// Why a surface does not exist for the given data.
#[derive(Clone, Debug, PartialEq)]
pub enum NoSurface<T> {
    /// A circle through the centre of the inversion.
    ThroughCentre(ThroughCentre),
    /// A rotation whose sine is 0 or ±1: the sectors have no width, or the rings no end.
    NoSector,
    /// Two values of the discrete holomorphic function agree, or the next one is at infinity, in
    /// this row and column.
    Singular(usize, usize),
    /// The Christoffel dual does not close.
    NoDual(Box<NoChristoffelDual<T>>),
    /// More elements than can be counted.
    Topology(TopologyError),
}

impl<T: fmt::Display> fmt::Display for NoSurface<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoSurface::ThroughCentre(reason) => reason.fmt(f),
            NoSurface::NoSector => f.write_str("the sine of half a sector is 0, 1 or -1"),
            NoSurface::Singular(i, j) => {
                write!(f, "the holomorphic function is singular in row {i}, column {j}")
            }
            NoSurface::NoDual(reason) => reason.fmt(f),
            NoSurface::Topology(reason) => reason.fmt(f),
        }
    }
}

impl<T: fmt::Debug + fmt::Display> std::error::Error for NoSurface<T> {}

impl<T> From<TopologyError> for NoSurface<T> {
    fn from(reason: TopologyError) -> Self {
        NoSurface::Topology(reason)
    }
}

impl<T> From<ThroughCentre> for NoSurface<T> {
    fn from(reason: ThroughCentre) -> Self {
        NoSurface::ThroughCentre(reason)
    }
}

impl<T> From<NoChristoffelDual<T>> for NoSurface<T> {
    fn from(reason: NoChristoffelDual<T>) -> Self {
        NoSurface::NoDual(Box::new(reason))
    }
}
