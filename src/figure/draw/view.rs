//! From space to the plane.

/// A parallel projection: the viewer looks down from a direction; z stays upright.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    right: [f64; 3],
    up: [f64; 3],
    towards: [f64; 3],
}

impl View {
    /// The top view: x to the right, y up.
    pub const TOP: View =
        View { right: [1.0, 0.0, 0.0], up: [0.0, 1.0, 0.0], towards: [0.0, 0.0, 1.0] };

    /// From the side where the viewer stands, `(x, y, z)`, not straight above. Only roots and the four
    /// operations are used, so that pictures are the same on every machine.
    pub fn from([x, y, z]: [f64; 3]) -> View {
        let (flat, length) = ((x * x + y * y).sqrt(), (x * x + y * y + z * z).sqrt());
        if flat == 0.0 {
            return View::TOP;
        }
        let (c, s) = (x / flat, y / flat);
        let (rise, run) = (z / length, flat / length);
        View {
            right: [-s, c, 0.0],
            up: [-rise * c, -rise * s, run],
            towards: [run * c, run * s, rise],
        }
    }

    /// Where a point of space appears.
    pub fn project(&self, p: [f64; 3]) -> [f64; 2] {
        [dot(self.right, p), dot(self.up, p)]
    }

    /// How near the viewer a point is; greater is nearer.
    pub fn depth(&self, p: [f64; 3]) -> f64 {
        dot(self.towards, p)
    }

    /// Whether a plane with this normal shows its upper side.
    pub fn sees(&self, normal: [f64; 3]) -> bool {
        dot(self.towards, normal) >= 0.0
    }

    /// How a plane with this normal is lit, from over the viewer's left shoulder: between 0.8 and 1.15.
    pub fn light(&self, normal: [f64; 3]) -> f64 {
        let lamp = [0, 1, 2].map(|i| self.towards[i] + 0.7 * self.up[i] - 0.5 * self.right[i]);
        let lengths = (dot(normal, normal) * dot(lamp, lamp)).sqrt();
        if lengths == 0.0 { 1.0 } else { 0.8 + 0.35 * dot(lamp, normal).abs() / lengths }
    }
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
