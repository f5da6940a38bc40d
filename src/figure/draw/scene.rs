//! Plane scenes: what every format can write.

use super::Color;

/// A picture: items in the order in which they are painted. Units are millimetres, y is up.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Width and height.
    pub size: [f64; 2],
    /// What is painted, the lowest first.
    pub items: Vec<Item>,
}

/// A line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Its colour.
    pub color: Color,
    /// Its width.
    pub width: f64,
}

impl Stroke {
    /// A line of this colour and width.
    pub const fn new(color: Color, width: f64) -> Self {
        Stroke { color, width }
    }
}

/// Where a text stands at its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// It begins there.
    Start,
    /// It is centred there.
    Middle,
    /// It ends there.
    End,
}

/// One thing that is painted.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// A polygon.
    Polygon {
        /// Its corners.
        corners: Vec<[f64; 2]>,
        /// Its inside.
        fill: Option<Color>,
        /// Its outline.
        stroke: Option<Stroke>,
    },
    /// A line through points.
    Polyline {
        /// The points.
        points: Vec<[f64; 2]>,
        /// The line.
        stroke: Stroke,
    },
    /// A circle.
    Circle {
        /// Its centre.
        center: [f64; 2],
        /// Its radius.
        radius: f64,
        /// Its inside.
        fill: Option<Color>,
        /// Its line.
        stroke: Option<Stroke>,
    },
    /// A line of text.
    Text {
        /// Where it stands, on the base line.
        at: [f64; 2],
        /// The height of the type.
        size: f64,
        /// How it stands there.
        anchor: Anchor,
        /// The text.
        text: String,
    },
}

impl Item {
    /// The same item scaled, then moved; lines keep their width, texts their size.
    pub fn moved(self, scale: f64, by: [f64; 2]) -> Item {
        let at = |p: [f64; 2]| [p[0] * scale + by[0], p[1] * scale + by[1]];
        let all = |points: Vec<[f64; 2]>| points.into_iter().map(at).collect();
        match self {
            Item::Polygon { corners, fill, stroke } => {
                Item::Polygon { corners: all(corners), fill, stroke }
            }
            Item::Polyline { points, stroke } => Item::Polyline { points: all(points), stroke },
            Item::Circle { center, radius, fill, stroke } => {
                Item::Circle { center: at(center), radius: radius * scale, fill, stroke }
            }
            Item::Text { at: place, size, anchor, text } => {
                Item::Text { at: at(place), size, anchor, text }
            }
        }
    }

    /// The box of its geometry: least and greatest x and y.
    fn bounds(&self) -> Vec<[f64; 2]> {
        match self {
            Item::Polygon { corners: points, .. } | Item::Polyline { points, .. } => points.clone(),
            Item::Circle { center: [x, y], radius, .. } => {
                let r = radius.abs();
                vec![[x - r, y - r], [x + r, y + r]]
            }
            Item::Text { at, .. } => vec![*at],
        }
    }
}

impl Scene {
    /// The width of the thinnest line.
    pub const HAIR: f64 = 0.08;

    /// An empty picture.
    pub fn new(width: f64, height: f64) -> Self {
        Scene { size: [width, height], items: Vec::new() }
    }

    /// Puts items, in any units, into the box with this lower left corner and size: as large as they
    /// fit, and centred. Gives the scale.
    pub fn place(&mut self, items: Vec<Item>, corner: [f64; 2], size: [f64; 2]) -> f64 {
        let points = items.iter().flat_map(Item::bounds);
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for p in points {
            for i in 0..2 {
                low[i] = low[i].min(p[i]);
                high[i] = high[i].max(p[i]);
            }
        }
        if low.iter().chain(&high).any(|x| !x.is_finite()) {
            return 1.0;
        }
        let fit = |i: usize| if high[i] > low[i] { size[i] / (high[i] - low[i]) } else { f64::MAX };
        let scale = fit(0).min(fit(1)).min(f64::MAX / 4.0);
        let by = |i: usize| corner[i] + size[i] / 2.0 - scale * (low[i] + high[i]) / 2.0;
        let by = [by(0), by(1)];
        self.items.extend(items.into_iter().map(|item| item.moved(scale, by)));
        scale
    }

    /// Writes a line of text.
    pub fn text(&mut self, at: [f64; 2], size: f64, anchor: Anchor, text: impl Into<String>) {
        self.items.push(Item::Text { at, size, anchor, text: text.into() });
    }
}
