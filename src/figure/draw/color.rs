//! Colours, and the map for signed curvatures.

use std::fmt;

/// A colour: red, green, blue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Color(pub [u8; 3]);

impl Color {
    /// Lines and text.
    pub const INK: Color = Color([0x1b, 0x2a, 0x41]);
    /// The upper side of faces.
    pub const FRONT: Color = Color([0x7f, 0xab, 0xdc]);
    /// The lower side of faces.
    pub const BACK: Color = Color([0xe3, 0xb5, 0x7c]);
    /// Circles.
    pub const CIRCLE: Color = Color([0xc4, 0x3c, 0x39]);
    /// A second family of circles.
    pub const OTHER_CIRCLE: Color = Color([0x2f, 0x7d, 0x5b]);
    /// What is beside the point: axes, connecting lines.
    pub const FAINT: Color = Color([0x9a, 0xa3, 0xb0]);
    /// Paper.
    pub const WHITE: Color = Color([0xff, 0xff, 0xff]);

    /// The colour between this one and another; 0 is this one.
    pub fn mixed(self, other: Color, t: f64) -> Color {
        let t = t.clamp(0.0, 1.0);
        let mix = |i: usize| f64::from(self.0[i]) * (1.0 - t) + f64::from(other.0[i]) * t;
        Color([0, 1, 2].map(|i| mix(i).round() as u8))
    }

    /// The colour of a signed value in −1..1: blue below 0, nearly white at 0, red above.
    pub fn signed(value: f64) -> Color {
        const LOW: Color = Color([0x2a, 0x5d, 0xa0]);
        const ZERO: Color = Color([0xf6, 0xf4, 0xef]);
        const HIGH: Color = Color([0xb9, 0x3a, 0x2c]);
        ZERO.mixed(if value < 0.0 { LOW } else { HIGH }, value.abs())
    }

    /// The same colour under less light, or more; 1 changes nothing.
    pub fn lit(self, light: f64) -> Color {
        if light <= 1.0 {
            return Color([0, 0, 0]).mixed(self, light);
        }
        self.mixed(Color::WHITE, light - 1.0)
    }
}

/// As in `#1b2a41`.
impl fmt::Display for Color {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [r, g, b] = self.0;
        write!(f, "#{r:02x}{g:02x}{b:02x}")
    }
}
