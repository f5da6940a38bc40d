//! The curvatures of one face or vertex, or why there are none: as reports and files need them.

use serde_json::{Value, json};

use super::{Curvatures, ExactPair, Forms, VertexUndefined};
use crate::mesh::{FaceId, VertexId, VertexKind};
use crate::scalar::{BigInt, Fraction, Ordered, Rational, Sign};

/// The elements that have curvatures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum At {
    /// Faces (17).
    Faces,
    /// Vertices (22).
    Vertices,
}

impl At {
    /// As in lists for programs.
    pub fn name(self) -> &'static str {
        match self {
            At::Faces => "faces",
            At::Vertices => "vertices",
        }
    }
}

/// The faces or the vertices of a pair.
pub(crate) struct Elements<'a> {
    /// The pair.
    pub pair: ExactPair<'a>,
    /// What of it.
    pub at: At,
    /// The vertices of the image that M determines; empty where the image was given.
    pub determined: Vec<bool>,
}

/// Forms and curvatures of one element.
#[cfg_attr(not(feature = "cli"), allow(dead_code))]
pub(crate) struct Found {
    /// The forms.
    pub forms: Forms<Fraction<BigInt>>,
    /// H and K.
    pub curvatures: Curvatures<Fraction<BigInt>>,
    /// Whether `D(s)` has the sign that the orientation of the faces does not have.
    pub reversed: bool,
}

/// Why there are none.
#[cfg_attr(not(feature = "cli"), allow(dead_code))]
pub(crate) struct Undefined {
    /// In short, for counts.
    pub kind: &'static str,
    /// In full.
    pub reason: String,
}

impl Elements<'_> {
    /// How many there are.
    pub fn count(&self) -> usize {
        match self.at {
            At::Faces => self.pair.topology().face_count(),
            At::Vertices => self.pair.topology().vertex_count(),
        }
    }

    /// Forms and curvatures of one of them.
    pub fn find(&self, index: usize) -> Result<Found, Undefined> {
        match self.at {
            At::Faces => self.at_face(FaceId(index as u32)),
            At::Vertices => self.at_vertex(VertexId(index as u32)),
        }
    }

    fn at_face(&self, face: FaceId) -> Result<Found, Undefined> {
        let corners = self.pair.topology().face(face);
        if !self.determined.is_empty() && !corners.iter().all(|v| self.determined[v.index()]) {
            let reason = "the mesh does not determine its Gauss image at the boundary";
            let reason = format!("face {} has no curvature: {reason}", face.0);
            return Err(Undefined { kind: "as the mesh does not determine their image", reason });
        }
        let forms = self.pair.face_forms(face);
        let curvatures = forms
            .curvatures()
            .map_err(|e| Undefined { kind: "of area 0 in the top view", reason: e.to_string() })?;
        Ok(Found { forms: forms.four, curvatures, reversed: false })
    }

    fn at_vertex(&self, vertex: VertexId) -> Result<Found, Undefined> {
        let undefined = |e: VertexUndefined| Undefined { kind: kind(&e), reason: e.to_string() };
        let forms = self.pair.vertex_forms(vertex).map_err(undefined)?;
        let curvatures = forms.curvatures().map_err(undefined)?;
        let turned = (forms.four.second.certain_sign(), self.pair.star_orientation(vertex));
        let opposite = (Some(Sign::Negative), Sign::Positive);
        let reversed = turned == opposite || turned == (Some(Sign::Positive), Sign::Negative);
        Ok(Found { forms: forms.four, curvatures, reversed })
    }

    /// The entry of one of them for programs: H and K, or why there are none.
    pub fn json(&self, index: usize, found: &Result<Found, Undefined>) -> Value {
        let name = match self.at {
            At::Faces => "face",
            At::Vertices => "vertex",
        };
        let found = match found {
            Ok(found) => found,
            Err(none) => return json!({ name: index, "undefined": none.reason }),
        };
        let Curvatures { mean, gauss } = &found.curvatures;
        let mut value = json!({ name: index, "H": lowest_terms(mean), "K": lowest_terms(gauss) });
        if found.reversed {
            value["image_reversed"] = json!(true);
        }
        value
    }
}

/// A number as text; `None` only where it is none.
pub(crate) fn lowest_terms(x: &Fraction<BigInt>) -> Option<String> {
    x.reduced::<Rational>().map(|x| x.to_string())
}

fn kind(undefined: &VertexUndefined) -> &'static str {
    match undefined {
        VertexUndefined::NotInterior(_, VertexKind::Isolated) => "in no face",
        VertexUndefined::NotInterior(_, VertexKind::Pinched) => "where the mesh is pinched",
        VertexUndefined::NotInterior(..) => "on the boundary",
        VertexUndefined::ZeroMeasure(_) => "with a Gauss image of measure 0",
        VertexUndefined::NotAGraph(..) | VertexUndefined::ZeroLength(..) => "at a vertical face",
    }
}
