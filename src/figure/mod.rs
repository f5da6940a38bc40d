//! Floor 9: the figures of the paper, as exact data and as pictures.
//!
//! A [`Figure`] makes exact meshes, says what holds on them, and draws them. What it says is checked
//! before it is drawn: there is no picture of something that does not hold.

mod comparison;
pub mod draw;
mod exhibit;
mod fig_01;
mod fig_02;
mod fig_03;
mod fig_04;
mod fig_05;
mod fig_06;
mod fig_07;
mod fig_08;
mod fig_09;
mod fig_10;
mod fig_11;
mod files;
mod frozen;
mod gallery;
mod lines;
mod nets;
pub mod page;
mod sheet;

pub use comparison::comparison;
pub use exhibit::{Exhibit, NotSo, Remark};
pub use files::Kind;
pub use gallery::{gallery, index};

use std::fmt;

use crate::mesh::{Mesh, TopologyError};
use crate::scalar::Rational;
use draw::Scene;

/// A figure of the paper.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    /// Its number in the paper.
    pub number: u8,
    /// What it shows, in a few words.
    pub title: &'static str,
    /// The caption, with the parameters.
    pub caption: &'static str,
    /// The claims that it illustrates.
    pub claims: &'static [&'static str],
    make: fn() -> Result<Plate, NoFigure>,
}

/// What a figure is made of.
#[derive(Clone, Debug)]
pub struct Plate {
    /// The exact meshes.
    pub exhibits: Vec<Exhibit>,
    /// The picture.
    pub scene: Scene,
}

/// Why there is no figure.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoFigure {
    /// A construction refused its parameters.
    Construction(String),
    /// Something that the figure says does not hold.
    NotSo(NotSo),
}

impl fmt::Display for NoFigure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoFigure::Construction(why) => write!(f, "{why}"),
            NoFigure::NotSo(what) => write!(f, "{what}"),
        }
    }
}

impl std::error::Error for NoFigure {}

impl NoFigure {
    fn of(error: impl fmt::Debug) -> Self {
        NoFigure::Construction(format!("{error:?}"))
    }
}

impl From<TopologyError> for NoFigure {
    fn from(error: TopologyError) -> Self {
        NoFigure::of(error)
    }
}

impl Figure {
    /// All figures, in the order of the paper.
    pub const ALL: [Figure; 11] = [
        fig_01::FIGURE,
        fig_02::FIGURE,
        fig_03::FIGURE,
        fig_04::FIGURE,
        fig_05::FIGURE,
        fig_06::FIGURE,
        fig_07::FIGURE,
        fig_08::FIGURE,
        fig_09::FIGURE,
        fig_10::FIGURE,
        fig_11::FIGURE,
    ];

    /// Makes the meshes, checks what the figure says of them, and draws.
    ///
    /// # Errors
    /// [`NoFigure::NotSo`] names what does not hold.
    pub fn plate(&self) -> Result<Plate, NoFigure> {
        let plate = (self.make)()?;
        for exhibit in &plate.exhibits {
            exhibit.check(&plate.exhibits).map_err(NoFigure::NotSo)?;
        }
        Ok(plate)
    }
}

type Surface = Mesh<Rational>;
