//! What was found on each element, and the report made of it.

use std::fmt;

use rayon::prelude::*;

use super::residual::Answer;
use super::verdict::Verdict;
use crate::mesh::{FaceId, VertexId};

/// What a residual belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Element {
    /// A face.
    Face(FaceId),
    /// A vertex.
    Vertex(VertexId),
    /// An edge, by its ends.
    Edge(VertexId, VertexId),
}

impl fmt::Display for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Element::Face(face) => write!(f, "face {}", face.0),
            Element::Vertex(v) => write!(f, "vertex {}", v.0),
            Element::Edge(a, b) => write!(f, "edge {}-{}", a.0, b.0),
        }
    }
}

/// Why a property is not defined on an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Reason {
    /// The face plane is isotropic: the top view of the face lies on a line.
    VerticalFace(FaceId),
    /// All points of the face lie on a line, so it has no plane.
    CollinearFace(FaceId),
    /// The oriented area of the face is zero, so it has no normal that could be oriented.
    NoOrientation(FaceId),
    /// The ends of the edge have the same top view.
    IsotropicEdge,
    /// The top view of the face is not strictly convex.
    NotEmbedded(FaceId),
    /// In the top view both faces lie on the same side of the edge, or one is flat.
    FoldedEdge,
    /// The top view is no disc with a convex boundary, so that edges alone do not decide.
    NotConvex,
    /// The face of the Gauss image has no plane that is the graph of a function.
    VerticalImage(FaceId),
    /// The signed area of the top view of the face is zero, so that it has no curvature.
    ZeroArea(FaceId),
    /// The face is no quad.
    NoQuad(FaceId),
    /// Three corners of the face lie on a line in the top view.
    StraightCorner(FaceId),
    /// The lift of the face to the unit i-sphere is not planar.
    NoLift(FaceId),
    /// An odd number of faces meet at the vertex, so that rows and columns are not told apart.
    OddValence,
    /// More faces meet at the vertex than are looked at.
    HighValence,
    /// All edges at the vertex lie in a plane, so that they lie on no cone or on many.
    FlatVertex(VertexId),
    /// An edge at the vertex has length zero, and so no direction.
    PointEdge(VertexId),
    /// The two edges at the vertex lie on a line.
    StraightVertex(VertexId),
    /// Vertices with two edges separate others of the face.
    LooseFace(FaceId),
    /// A search for cones that fit together, from this vertex on, was given up.
    ManyCones(VertexId),
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Reason::VerticalFace(face) => {
                write!(f, "face {} is vertical: its top view lies on a line", face.0)
            }
            Reason::CollinearFace(face) => {
                write!(f, "face {} has no plane: its points lie on a line", face.0)
            }
            Reason::NoOrientation(face) => {
                write!(
                    f,
                    "the oriented area of face {} is zero, so its sides are not told apart",
                    face.0
                )
            }
            Reason::IsotropicEdge => write!(f, "the edge is vertical or of length zero"),
            Reason::NotEmbedded(face) => {
                write!(f, "the top view of face {} is not strictly convex", face.0)
            }
            Reason::FoldedEdge => write!(f, "the top view is folded along the edge"),
            Reason::VerticalImage(face) => {
                write!(f, "face {} of the Gauss image is vertical or collinear", face.0)
            }
            Reason::ZeroArea(face) => {
                write!(f, "the area of face {} in the top view is 0", face.0)
            }
            Reason::NoQuad(face) => write!(f, "face {} is no quad", face.0),
            Reason::StraightCorner(face) => {
                write!(f, "three corners of face {} lie on a line in the top view", face.0)
            }
            Reason::NoLift(face) => {
                write!(f, "the lift of face {} to the unit i-sphere is not planar", face.0)
            }
            Reason::OddValence => write!(f, "an odd number of faces meet there"),
            Reason::HighValence => write!(f, "more than 16 faces meet there"),
            Reason::FlatVertex(v) => write!(f, "the edges at vertex {} lie in a plane", v.0),
            Reason::PointEdge(v) => write!(f, "an edge at vertex {} has length zero", v.0),
            Reason::StraightVertex(v) => {
                write!(f, "the two edges at vertex {} lie on a line", v.0)
            }
            Reason::LooseFace(face) => {
                write!(f, "vertices with two edges separate others of face {}", face.0)
            }
            Reason::ManyCones(v) => {
                write!(f, "no cones that fit together were found from vertex {} on", v.0)
            }
            Reason::NotConvex => write!(
                f,
                "the top view is no disc with a convex boundary here, so that edges alone do not decide"
            ),
        }
    }
}

/// A residual that does not vanish.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure<V> {
    /// The condition that it belongs to.
    pub condition: &'static str,
    /// `|residual| / scale`, free of units: the scale is the sum of the sizes of its terms.
    pub defect: f64,
    /// The exact residual, where it was asked for and lies in the field.
    pub residual: Option<V>,
}

impl<V> Failure<V> {
    /// The one with the larger defect; of equals the first.
    pub fn worse(self, other: Self) -> Self {
        if other.defect > self.defect { other } else { self }
    }
}

/// What a check found on one element.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome<V> {
    /// All residuals are exactly zero.
    Holds,
    /// No residual: the property holds by itself, as planarity of a triangle does.
    Trivial,
    /// Zero cannot be excluded for the box of the printed digits.
    Consistent,
    /// Not decided, or only within a tolerance.
    Undecided,
    /// A residual is not zero.
    Fails(Failure<V>),
    /// The property is not defined here.
    Undefined(Reason),
}

impl<V> Outcome<V> {
    /// The outcome of residuals of which the worst is `answer`.
    pub fn of(answer: Answer, failure: impl FnOnce() -> Failure<V>) -> Self {
        match answer {
            Answer::Zero => Outcome::Holds,
            Answer::InBox => Outcome::Consistent,
            Answer::Near => Outcome::Undecided,
            Answer::Nonzero => Outcome::Fails(failure()),
        }
    }
}

/// The element that is worst, as evidence.
#[derive(Clone, Debug, PartialEq)]
pub struct Witness<V> {
    /// Where.
    pub element: Element,
    /// What does not vanish there.
    pub failure: Failure<V>,
}

/// The result of checking one property on a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Report<V> {
    /// The name of the property.
    pub property: &'static str,
    /// Elements with at least one residual that could be looked at.
    pub checked: usize,
    /// Elements on which the property holds by itself.
    pub trivial: usize,
    /// Elements that are possible within the box of the printed digits, no more.
    pub consistent: usize,
    /// Elements not decided.
    pub undecided: usize,
    /// Elements on which the property fails, in order.
    pub failures: Vec<Element>,
    /// Elements on which the property is not defined, in order.
    pub undefined: Vec<(Element, Reason)>,
    /// The failure with the largest defect; of equals the first.
    pub worst: Option<Witness<V>>,
}

impl<V> Report<V> {
    /// An empty report.
    pub fn new(property: &'static str) -> Self {
        Report {
            property,
            checked: 0,
            trivial: 0,
            consistent: 0,
            undecided: 0,
            failures: Vec::new(),
            undefined: Vec::new(),
            worst: None,
        }
    }

    /// The verdict on the whole mesh.
    pub fn verdict(&self) -> Verdict {
        if !self.failures.is_empty() {
            Verdict::Refuted
        } else if !self.undefined.is_empty() || self.undecided > 0 {
            Verdict::Undecided
        } else if self.consistent > 0 {
            Verdict::Consistent
        } else if self.checked > 0 {
            Verdict::Proved
        } else {
            Verdict::Vacuous
        }
    }

    /// Adds what was found on one more element.
    pub fn add(&mut self, element: Element, outcome: Outcome<V>) {
        match outcome {
            Outcome::Holds => self.checked += 1,
            Outcome::Trivial => self.trivial += 1,
            Outcome::Consistent => {
                self.checked += 1;
                self.consistent += 1;
            }
            Outcome::Undecided => {
                self.checked += 1;
                self.undecided += 1;
            }
            Outcome::Undefined(reason) => self.undefined.push((element, reason)),
            Outcome::Fails(failure) => {
                self.checked += 1;
                self.failures.push(element);
                self.note_failure(Witness { element, failure });
            }
        }
    }

    fn note_failure(&mut self, witness: Witness<V>) {
        if self.worst.as_ref().is_none_or(|w| witness.failure.defect > w.failure.defect) {
            self.worst = Some(witness);
        }
    }

    /// Joins the report of the elements that follow.
    fn join(mut self, next: Self) -> Self {
        self.checked += next.checked;
        self.trivial += next.trivial;
        self.consistent += next.consistent;
        self.undecided += next.undecided;
        self.failures.extend(next.failures);
        self.undefined.extend(next.undefined);
        if let Some(witness) = next.worst {
            self.note_failure(witness);
        }
        self
    }

    /// Checks elements in parallel; the report does not depend on the number of threads.
    ///
    /// Only for the worst element the outcome is asked for with exact residuals.
    pub fn collect(
        property: &'static str,
        elements: &[Element],
        outcome: impl Fn(Element, bool) -> Outcome<V> + Sync,
    ) -> Self
    where
        V: Send,
    {
        const CHUNK: usize = 4096;
        let part = |chunk: &[Element]| {
            let mut report = Report::new(property);
            for &element in chunk {
                report.add(element, outcome(element, false));
            }
            report
        };
        let parts: Vec<_> = elements.par_chunks(CHUNK).map(part).collect();
        let mut report = parts.into_iter().fold(Report::new(property), Report::join);
        if let Some(Witness { element, failure }) = &mut report.worst
            && let Outcome::Fails(exact) = outcome(*element, true)
        {
            *failure = exact;
        }
        report
    }
}
