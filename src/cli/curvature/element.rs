//! The curvatures of one element, as the outputs need them.

use serde_json::json;

use crate::cli::arguments::At;
use crate::mesh::{FaceId, VertexId, VertexKind};
use crate::pair::{Curvatures, ExactPair, Forms, VertexUndefined};
use crate::scalar::{Approx, BigInt, Field, Fraction, Ordered, Rational, Sign};

/// The faces or the vertices of a pair.
pub struct Elements<'a> {
    /// The pair.
    pub pair: ExactPair<'a>,
    /// What of it.
    pub at: At,
    /// The vertices of the image that M determines; empty where the image was given.
    pub determined: Vec<bool>,
}

/// Forms and curvatures of one element.
pub struct Found {
    forms: Forms<Fraction<BigInt>>,
    curvatures: Curvatures<Fraction<BigInt>>,
    reversed: bool,
}

/// Why there are none.
pub struct Undefined {
    /// In short, for counts.
    pub kind: &'static str,
    /// In full.
    pub reason: String,
}

/// An element in the numbers of a summary.
pub struct Short {
    /// H and K, correctly rounded.
    pub values: [f64; 2],
    /// Their signs, exact.
    pub signs: [Sign; 2],
    /// Whether `H² < K`.
    pub complex: bool,
    /// Whether `D(s)` has the sign that the orientation of the faces does not have.
    pub reversed: bool,
}

/// An element in all forms that are asked for.
pub struct Row {
    /// The numbers of the summary.
    pub found: Result<Short, Undefined>,
    /// The entry for programs.
    pub json: Option<String>,
    /// H and K in lowest terms.
    pub exact: Option<Curvatures<Rational>>,
}

impl Row {
    /// Keeps of an element what is needed.
    pub fn new(found: Result<Found, Undefined>, json: Option<String>, exact: bool) -> Self {
        let exact = match &found {
            Ok(found) if exact => found.curvatures.reduced(),
            _ => None,
        };
        Row { found: found.map(|found| found.short()), json, exact }
    }
}

impl Found {
    fn short(&self) -> Short {
        let both = [&self.curvatures.mean, &self.curvatures.gauss];
        let sign = |x: &Fraction<BigInt>| x.certain_sign().unwrap_or(Sign::Zero);
        Short {
            values: both.map(Approx::to_f64),
            signs: both.map(sign),
            // The discriminant of the forms has the same sign and smaller numbers.
            complex: sign(&self.forms.discriminant()) == Sign::Negative,
            reversed: self.reversed,
        }
    }
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

    /// One entry of `values`.
    pub fn json(&self, index: usize, found: &Result<Found, Undefined>, integrated: bool) -> String {
        let name = match self.at {
            At::Faces => "face",
            At::Vertices => "vertex",
        };
        let found = match found {
            Ok(found) => found,
            Err(none) => return json!({ name: index, "undefined": none.reason }).to_string(),
        };
        let text = |x: &Fraction<BigInt>| x.reduced::<Rational>().map(|x| x.to_string());
        let Curvatures { mean, gauss } = &found.curvatures;
        let mut value = json!({
            name: index,
            "H": text(mean),
            "K": text(gauss),
            "discriminant": text(&found.curvatures.discriminant()),
            "kappa": found.curvatures.principal_f64(),
        });
        if found.reversed {
            value["image_reversed"] = json!(true);
        }
        if integrated {
            let names = match self.at {
                At::Faces => ["area", "mixed_area", "image_area"],
                At::Vertices => ["measure", "mixed_measure", "image_measure"],
            };
            let Forms { first, mixed, second } = &found.forms;
            for (name, form) in names.into_iter().zip([first, mixed, second]) {
                value[name] = json!(text(&(form * Fraction::from_ratio(1, 4))));
            }
        }
        value.to_string()
    }
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
