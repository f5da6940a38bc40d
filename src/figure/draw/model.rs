//! Models: polygons and lines in space.

use super::{Color, Stroke};
use crate::mesh::{FaceId, Mesh};
use crate::scalar::Approx;

/// How a polygon is painted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Paint {
    /// One colour for each side, lit.
    Sides([Color; 2]),
    /// One colour for both sides, not lit: for values.
    Flat(Color),
    /// Only the edges; what is behind shows through.
    Wire,
}

/// A piece of a model.
#[derive(Clone, Debug, PartialEq)]
pub enum Piece {
    /// A polygon; each edge from its corner to the next is drawn or not.
    Face {
        /// The corners.
        corners: Vec<[f64; 3]>,
        /// Whether the edge after each corner is drawn.
        drawn: Vec<bool>,
        /// How it is painted.
        paint: Paint,
        /// Its edges.
        stroke: Stroke,
    },
    /// A segment.
    Segment {
        /// The ends.
        ends: [[f64; 3]; 2],
        /// The line.
        stroke: Stroke,
    },
}

/// Pieces in space, in any order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    /// The pieces.
    pub pieces: Vec<Piece>,
}

impl Model {
    /// Adds the faces of a mesh, `paint` for each. Faces that are not triangles are cut into
    /// triangles where they are not planar for the eye; cuts are not drawn.
    pub fn add_mesh<T: Approx>(
        &mut self,
        mesh: &Mesh<T>,
        stroke: Stroke,
        paint: impl Fn(FaceId) -> Paint,
    ) {
        for face in mesh.topology.faces() {
            let corners = mesh.topology.face(face).iter().map(|v| {
                let p = &mesh.points[v.index()];
                [p.x.to_f64(), p.y.to_f64(), p.z.to_f64()]
            });
            let corners: Vec<_> = corners.collect();
            let drawn = vec![true; corners.len()];
            self.pieces.push(Piece::Face { corners, drawn, paint: paint(face), stroke });
        }
    }

    /// Adds a line through points.
    pub fn add_line(&mut self, points: impl IntoIterator<Item = [f64; 3]>, stroke: Stroke) {
        let points: Vec<_> = points.into_iter().collect();
        let segments = points.windows(2).map(|w| Piece::Segment { ends: [w[0], w[1]], stroke });
        self.pieces.extend(segments);
    }

    /// All corners and ends.
    pub fn points(&self) -> impl Iterator<Item = [f64; 3]> {
        self.pieces
            .iter()
            .flat_map(|piece| match piece {
                Piece::Face { corners, .. } => corners.as_slice(),
                Piece::Segment { ends, .. } => ends.as_slice(),
            })
            .copied()
    }

    /// The same model with every point mapped.
    pub fn map(mut self, f: impl Fn([f64; 3]) -> [f64; 3]) -> Model {
        for piece in &mut self.pieces {
            match piece {
                Piece::Face { corners, .. } => corners.iter_mut().for_each(|p| *p = f(*p)),
                Piece::Segment { ends, .. } => ends.iter_mut().for_each(|p| *p = f(*p)),
            }
        }
        self
    }
}
