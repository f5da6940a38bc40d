//! What a file says of an exact mesh near its own.

use std::fmt;

use serde_json::{Value, json};

use super::{Existence, NoProof, Pinned, prove};
use crate::mesh::file::parse_fraction;
use crate::mesh::{Topology, VertexId};
use crate::net::Property;
use crate::optimise::Goal;
use crate::scalar::{Approx, Numeral, Rational, Ring};
use crate::space::Point;

/// The claim that an exact mesh with a property is near, to be verified from the mesh alone.
///
/// In a file it stands under `certificate.existence`:
/// `{"property":"i-circular","radius":"7/20000000000000000","pinned":"boundary"}`; `pinned` may also be a list of
/// vertices, or be left out.
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// The property, as a goal.
    pub goal: Goal,
    /// No vertex is farther than that from the same vertex of the exact mesh.
    pub radius: Rational,
    /// The vertices that both meshes share.
    pub pinned: Pinned,
}

/// Why a certificate is not verified.
#[derive(Clone, Debug, PartialEq)]
pub enum NotVerified {
    /// It is not written as one.
    Unreadable(&'static str),
    /// The coordinates of a vertex are no doubles.
    NoDoubles(VertexId),
    /// No exact mesh is proved to exist.
    NoProof(NoProof),
    /// An exact mesh exists, but is proved only within a larger distance.
    Farther(f64),
}

impl Certificate {
    /// The name of the claim within the certificate of a file.
    pub const NAME: &'static str = "existence";

    /// The claim that a proof supports.
    ///
    /// Its radius leaves room for other roundings: a sixteenth, and twice what is not known of the exact
    /// mesh.
    pub fn new(goal: Goal, pinned: Pinned, proved: &Existence) -> Self {
        let bound = proved.radius + 2.0 * proved.reach;
        // Two digits are off by less than a twentieth.
        let digits = format!("{:.1e}", bound * 17.0 / 16.0);
        // What is infinite has no digits; 0 is never verified.
        let radius = digits.parse().map_or_else(|_| Rational::zero(), |r: Numeral| r.value());
        Certificate { goal, radius, pinned }
    }

    /// Proves that an exact mesh is near one in doubles, and how near.
    ///
    /// # Errors
    /// Where the coordinates are no doubles, or there is no proof.
    pub fn make(
        topology: &Topology,
        points: &[Point<Rational>],
        goal: Goal,
        pinned: Pinned,
    ) -> Result<(Self, Existence), NotVerified> {
        let points = doubles(points)?;
        let proved = prove(topology, &points, goal, &pinned).map_err(NotVerified::NoProof)?;
        Ok((Certificate::new(goal, pinned, &proved), proved))
    }

    /// Reads a claim.
    ///
    /// # Errors
    /// Where it is not written as one: [`NotVerified::Unreadable`].
    pub fn read(claim: &Value) -> Result<Self, NotVerified> {
        let unreadable = NotVerified::Unreadable;
        let claim = claim.as_object().ok_or(unreadable("it is no object"))?;
        if claim.keys().any(|key| !["property", "radius", "pinned"].contains(&key.as_str())) {
            return Err(unreadable("it has other members than property, radius and pinned"));
        }
        let text = |name| claim.get(name).and_then(Value::as_str);
        let property = text("property").and_then(Property::from_name);
        let goal = Goal::ALL.into_iter().find(|goal| Some(goal.property()) == property);
        let radius = text("radius").and_then(|radius| parse_fraction(radius).ok());
        let vertex = |v: &Value| Some(VertexId(u32::try_from(v.as_u64()?).ok()?));
        let pinned = match claim.get("pinned") {
            None => Some(Pinned::Nothing),
            Some(Value::String(name)) => (name == "boundary").then_some(Pinned::Boundary),
            Some(Value::Array(list)) => {
                list.iter().map(vertex).collect::<Option<_>>().map(Pinned::Vertices)
            }
            Some(_) => None,
        };
        Ok(Certificate {
            goal: goal.ok_or(unreadable("it names no property that can be certified"))?,
            radius: radius.ok_or(unreadable("it states no radius as a fraction"))?,
            pinned: pinned
                .ok_or(unreadable("it pins neither the boundary nor a list of vertices"))?,
        })
    }

    /// The claim as it stands in a file.
    pub fn json(&self) -> Value {
        let mut claim =
            json!({ "property": self.goal.property().name(), "radius": self.radius.to_string() });
        match &self.pinned {
            Pinned::Nothing => {}
            Pinned::Boundary => claim["pinned"] = json!("boundary"),
            Pinned::Vertices(list) => claim["pinned"] = list.iter().map(|v| v.0).collect(),
        }
        claim
    }

    /// Whether the claim, once verified, says that the exact mesh has a property: its own, and planarity.
    pub fn covers(&self, property: Property) -> bool {
        property == self.goal.property() || property == Property::Planar
    }

    /// Verifies the claim from the mesh alone.
    ///
    /// # Errors
    /// Why it is not verified.
    pub fn verify(
        &self,
        topology: &Topology,
        points: &[Point<Rational>],
    ) -> Result<Existence, NotVerified> {
        let points = doubles(points)?;
        let proved =
            prove(topology, &points, self.goal, &self.pinned).map_err(NotVerified::NoProof)?;
        match exact(proved.radius) {
            Some(radius) if radius <= self.radius => Ok(proved),
            _ => Err(NotVerified::Farther(proved.radius)),
        }
    }
}

/// The same points in doubles, exactly.
fn doubles(points: &[Point<Rational>]) -> Result<Vec<Point<f64>>, NotVerified> {
    let double = |(v, point): (u32, &Point<Rational>)| {
        let rounded = point.map(Rational::to_f64);
        let same = |(x, c): (&f64, &Rational)| exact(*x).is_some_and(|x| x == *c);
        let is_same = rounded.coordinates().into_iter().zip(point.coordinates()).all(same);
        if is_same { Ok(rounded) } else { Err(NotVerified::NoDoubles(VertexId(v))) }
    };
    (0..).zip(points).map(double).collect()
}

fn exact(x: f64) -> Option<Rational> {
    Numeral::from_f64(x).map(|x| x.value())
}

impl fmt::Display for NotVerified {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NotVerified::Unreadable(why) => write!(f, "{why}"),
            NotVerified::NoDoubles(v) => {
                write!(f, "the coordinates of vertex {} are no doubles", v.0)
            }
            NotVerified::NoProof(reason) => write!(f, "{reason}"),
            NotVerified::Farther(radius) => {
                write!(f, "an exact mesh is proved to exist only within {radius:.1e}")
            }
        }
    }
}

impl std::error::Error for NotVerified {}
