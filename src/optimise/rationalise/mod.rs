//! From doubles back to exact meshes: near a mesh that has a property up to rounding, one over ℚ that has
//! it, with numbers of bounded length.
//!
//! Coordinates that are rounded one by one lose the property, and vertices that are solved for one after the
//! other have numbers whose length grows exponentially. Here vertices, or face planes, are placed in an order in
//! which each meets few conditions with those before it; what is free is rounded to dyadic fractions of few
//! bits, near to where the vertex shall be; and conditions are written so that every step adds a bounded number
//! of bits, not a factor:
//!
//! - [`planar`]: the last vertex of a quad is `p + s (q − p) + t (r − p)` with rounded s and t. Bits add up
//!   along the depth of the order, which starts in the middle. Planes of hexagons are free, and their vertices
//!   are intersections of three. Where rings close, bits would multiply; there top views or normals are
//!   rounded, and heights or offsets solve a sparse linear system, about `b` bits for each of its equations.
//! - [`i_circular`]: each vertex of a quad mesh has a direction of few bits, a Gaussian integer. A quad adds
//!   the bits of a few of them to the denominators, once: bits add up over the quads between a vertex and
//!   the middle.
//! - [`i_conical`]: the same for the metric dual; vertices at the boundary are placed in planes that are there.
//!
//! Rounding becomes finer until no vertex is moved further than was asked for. Everything is
//! deterministic; topology and orders are kept. Nothing is claimed: whether the result has the property,
//! [`Net::check`](crate::net::Net::check) decides. A mesh that is far from the property is moved far, or
//! becomes wild, and [`Rationalised::movement`] says so: a tolerance is for the caller to choose.
//!
//! Measured with `cargo bench --bench rationalise`: meshes of size 1 with noise of 10⁻¹² and
//! vertices moved by at most 10⁻⁶, seconds of all attempts:
//!
//! | class | mesh | faces | bits | seconds |
//! | --- | --- | --- | --- | --- |
//! | planar | n × n quads, n = 10, 30, 100 | 100, 900, 10 000 | 211, 583, 1 758 | 0.003, 0.03, 0.6 |
//! | planar | hexagons | 360 | 148 | 0.02 |
//! | planar | 4, 8, 12 rings of 40 quads | 160, 320, 480 | 2 642, 7 913, 11 932 | 0.5, 2, 5 |
//! | planar | closed, parallelograms | 20, 90, 210 | 803, 3 030, 5 080 | 0.01, 0.3, 2 |
//! | i-circular | n × n quads, n = 10, 20, 30, 40 | 100 … 1 600 | 1 168, 3 899, 9 618, 15 807 | 0.006, 0.05, 0.3, 0.9 |
//! | i-conical | n × n quads, n = 10, 20, 30, 40 | 100 … 1 600 | 1 350, 4 548, 9 009, 18 345 | 0.007, 0.06, 0.3, 1.7 |

mod circular;
mod conical;
mod direction;
mod dyadic;
mod heights;
mod incidence;
mod linear;
mod march;
mod offsets;
mod outcome;
mod placing;
mod planar;

pub use circular::i_circular;
pub use conical::i_conical;
pub use outcome::{Element, NoExactMesh, Obstacle, Rationalised};
pub use planar::planar;

use super::{Frame, Movement};
use crate::mesh::file::MAX_DIGITS;
use crate::mesh::{Data, Mesh, VertexId};
use crate::scalar::{Approx, Rational, RationalField, Ring};
use crate::space::{Plane, Point, TopView, Vector3};

/// How near the exact mesh shall be, and how long its numbers may become.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Rounding becomes finer until no vertex is moved further, or until that does not help.
    pub within: f64,
    /// Longer numbers are refused.
    pub most_bits: u64,
}

impl Options {
    /// No vertex moves further than a millionth of the size of the mesh, and all numbers can be written
    /// to files.
    ///
    /// ```
    /// use isogeo::optimise::rationalise::Options;
    /// use isogeo::space::Point;
    /// let points = [Point::new(-1.0, 0.0, 0.0), Point::new(1.0, 1.0, 0.0)];
    /// assert_eq!(Options::of(&points).within, 2f64.powi(-20));
    /// ```
    pub fn of(points: &[Point<f64>]) -> Options {
        let within = Frame::of(points).unit * 2f64.powi(-20);
        // Each digit takes more than three bits.
        Options { within, most_bits: 3 * MAX_DIGITS as u64 }
    }
}

/// The bits of parameters, from attempt to attempt.
const BITS: [i32; 8] = [12, 16, 20, 24, 28, 32, 40, 48];

/// The first attempt that is near enough, or else the nearest.
///
/// Distances are taken to halve with every bit, so that few attempts are made.
fn nearest(
    mesh: &Mesh<f64>,
    options: &Options,
    attempt: impl Fn(i32) -> Result<Vec<Point<Rational>>, NoExactMesh>,
) -> Result<Rationalised, NoExactMesh> {
    let attempt = |bits| Rationalised::new(mesh, attempt(bits)?).of_at_most(options.most_bits);
    let mut best: Result<Rationalised, NoExactMesh> = attempt(BITS[0]);
    let mut next = BITS[0];
    for &bits in &BITS[1..] {
        let reached = match &best {
            Ok(found) if found.movement.largest > options.within => found.movement.largest,
            // It may be so by coarse rounding.
            Err(reason) if reason.why == Obstacle::Degenerate => f64::INFINITY,
            _ => break,
        };
        let is_enough = 2f64.powi(next - bits) * reached <= options.within;
        if best.is_ok() && !is_enough && bits < BITS[BITS.len() - 1] {
            continue;
        }
        let found = attempt(bits);
        next = bits;
        let distance = found.as_ref().map_or(f64::INFINITY, |found| found.movement.largest);
        if distance < reached || best.is_err() {
            best = found;
        }
        if best.is_ok() && distance > reached / 2.0 {
            break;
        }
    }
    best
}

impl Rationalised {
    fn new(mesh: &Mesh<f64>, points: Vec<Point<Rational>>) -> Self {
        let rounded: Vec<_> = points.iter().map(|p| p.map(Approx::to_f64)).collect();
        let movement = Movement::between(&mesh.points, &rounded);
        let bits = points.iter().map(bits).max().unwrap_or(0);
        let mesh = Mesh { topology: mesh.topology.clone(), points, data: Data::default() };
        Rationalised { mesh, movement, bits }
    }

    fn of_at_most(self, most_bits: u64) -> Result<Self, NoExactMesh> {
        match self.mesh.points.iter().position(|p| bits(p) > most_bits) {
            Some(v) => Err(Obstacle::TooManyBits.at_vertex(VertexId(v as u32))),
            None => Ok(self),
        }
    }
}

/// The bits of the longest numerator or denominator of a coordinate.
fn bits(p: &Point<Rational>) -> u64 {
    let longer = |c: &Rational| c.numerator().bits().max(c.denominator().bits());
    p.coordinates().into_iter().map(longer).max().unwrap_or(0)
}

/// The points of a mesh in a frame from which exact points lead back.
struct Inside {
    points: Vec<Point<f64>>,
    unit: Rational,
    middle: Vector3<Rational>,
}

impl Inside {
    fn of(points: &[Point<f64>]) -> Result<Inside, NoExactMesh> {
        let wrong = points.iter().position(|p| p.coordinates().iter().any(|c| !c.is_finite()));
        if let Some(v) = wrong {
            return Err(Obstacle::NotFinite.at_vertex(VertexId(v as u32)));
        }
        let Frame { middle, unit } = Frame::of(points);
        // A middle of few bits.
        let round = |c: f64| (c / unit).round() * unit;
        let middle = Vector3::new(round(middle.x), round(middle.y), round(middle.z));
        let frame = Frame { middle, unit };
        let [x, y, z, unit] = [middle.x, middle.y, middle.z, unit].map(dyadic::finite);
        let points = points.iter().map(|p| frame.inside(p)).collect();
        Ok(Inside { points, unit, middle: Vector3 { x, y, z } })
    }

    /// The point of the mesh of a point in the frame.
    fn back(&self, p: &Point<Rational>) -> Point<Rational> {
        &p.map(|c| c * &self.unit) + &self.middle
    }

    /// The same for planes.
    fn plane_back(&self, plane: &Plane<Rational>) -> Plane<Rational> {
        let origin = TopView::new(Rational::zero(), Rational::zero());
        let above = self.back(&origin.at_height(plane.height.clone()));
        Plane::through_point(&above, plane.gradient.clone())
    }
}
