//! Drawing: plane scenes, spatial models, painter's order, and the formats.

mod color;
mod model;
mod order;
mod painter;
mod pdf;
#[cfg(feature = "png")]
mod png;
mod scene;
mod svg;
mod tikz;
mod view;

pub use color::Color;
pub use model::{Model, Paint, Piece};
pub use painter::painted;
pub use pdf::pdf;
#[cfg(feature = "png")]
pub use png::png;
pub use scene::{Anchor, Item, Scene, Stroke};
pub(super) use svg::escaped;
pub use svg::svg;
pub use tikz::tikz;
pub use view::View;
