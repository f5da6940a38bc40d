//! Properties of pairs, decided like those of single meshes: residual, verdict, witness.
//!
//! | property | element | holds iff |
//! | --- | --- | --- |
//! | `parallel` | edge | the edges of M and S are [parallel](ParallelEdges) |
//! | `f-parallel` | face | M is planar and the planes are [parallel](ParallelPlanes) |
//! | `v-parallel` | vertex, face | the top views agree, and both meshes are planar |
//! | `christoffel-dual` | edge, face | parallel, f-parallel, and the [mixed area](MixedArea) is 0 (20) |
//! | `i-minimal` | face | f-parallel, and H = 0 (19) |
//! | `cmc` | face | f-parallel, and H is that of the other faces ([`SameCurvature`]) |
//! | `constant-k` | face | f-parallel, and K is that of the other faces |
//!
//! Vertical faces are undefined, and where H or K is asked for, faces whose signed area in the top
//! view is 0. Curvatures are compared with those of one face: of the smallest faces that have them
//! the first.

use super::Misfit;
use super::residual::{MixedArea, ParallelEdges, ParallelPlanes, SameCurvature};
use crate::check::{Answer, Decide, Element, Failure, Outcome, Reason, Report};
use crate::mesh::{FaceId, Topology, VertexId};
use crate::net::planar::{self, Coplanar, Difference, Position, ProjectedArea};
use crate::scalar::Sign;

/// A property of a pair of meshes M and S that can be checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PairProperty {
    /// Corresponding edges are parallel.
    Parallel,
    /// Corresponding face planes are parallel.
    FParallel,
    /// Corresponding vertices have the same top view.
    VParallel,
    /// Edges are parallel and the mixed areas of faces vanish.
    ChristoffelDual,
    /// H = 0 at every face.
    IMinimal,
    /// H is the same at every face.
    Cmc,
    /// K is the same at every face.
    ConstantK,
}

impl PairProperty {
    /// All properties, in the order of reports.
    pub const ALL: [PairProperty; 7] = [
        PairProperty::Parallel,
        PairProperty::FParallel,
        PairProperty::VParallel,
        PairProperty::ChristoffelDual,
        PairProperty::IMinimal,
        PairProperty::Cmc,
        PairProperty::ConstantK,
    ];

    /// The name on the command line and in reports.
    pub fn name(self) -> &'static str {
        match self {
            PairProperty::Parallel => "parallel",
            PairProperty::FParallel => "f-parallel",
            PairProperty::VParallel => "v-parallel",
            PairProperty::ChristoffelDual => "christoffel-dual",
            PairProperty::IMinimal => "i-minimal",
            PairProperty::Cmc => "cmc",
            PairProperty::ConstantK => "constant-k",
        }
    }

    /// The property of that name.
    pub fn from_name(name: &str) -> Option<PairProperty> {
        PairProperty::ALL.into_iter().find(|p| p.name() == name)
    }

    /// The curvature that is the same at all faces.
    fn constant(self) -> Option<SameCurvature> {
        match self {
            PairProperty::Cmc => Some(SameCurvature::Mean),
            PairProperty::ConstantK => Some(SameCurvature::Gauss),
            _ => None,
        }
    }
}

/// Two meshes M and S with the same combinatorics, of which it is asked what pair they are.
///
/// Unlike [`FParallel`](super::FParallel) and its kin, which exist only where the meshes fit
/// exactly, a couple can be any two meshes, also of rounded numbers.
///
/// ```
/// use isogeo::check::{Plain, Verdict};
/// use isogeo::construct::translational_net;
/// use isogeo::pair::{Couple, PairProperty};
/// use isogeo::scalar::{BigRational, Field, Ring};
/// let at = |x: i64, z: i64| (BigRational::from_i64(x), BigRational::from_i64(z));
/// let m = translational_net(&[at(0, 0), at(2, 1)], &[at(0, 0), at(3, 5)])?;
/// let mut s = m.map(|c| c * BigRational::from_i64(3));
/// let verdict = |s: &isogeo::mesh::Mesh<BigRational>, property| {
///     let points = [m.points.as_slice(), &s.points].concat();
///     let couple = Couple::new(&m.topology, &s.topology, &Plain(&points)).map(|c| c.check(property));
///     couple.map(|report| report.verdict())
/// };
/// assert_eq!(verdict(&s, PairProperty::FParallel), Ok(Verdict::Proved));
/// s.points[3].z += &BigRational::from_ratio(1, 1 << 40);
/// assert_eq!(verdict(&s, PairProperty::FParallel), Ok(Verdict::Refuted));
/// # Ok::<(), isogeo::mesh::TopologyError>(())
/// ```
#[derive(Debug)]
pub struct Couple<'a, D> {
    topology: &'a Topology,
    decide: &'a D,
}

impl<'a, D: Decide> Couple<'a, D> {
    /// The combinatorics of M and of S, and a decider for the points of M followed by those of S:
    /// with `n` vertices, vertex `i` of S is number `n + i`.
    ///
    /// # Errors
    /// The first difference of the combinatorics.
    pub fn new(
        mesh: &'a Topology,
        image: &Topology,
        decide: &'a D,
    ) -> Result<Self, Misfit<D::Value>> {
        Misfit::of_topologies(mesh, image)?;
        Ok(Couple { topology: mesh, decide })
    }

    /// Checks one property on all its elements; linear in the size of the meshes, in parallel.
    pub fn check(&self, property: PairProperty) -> Report<D::Value> {
        let reference = property.constant().and_then(|_| self.reference());
        Report::collect(property.name(), &self.elements(property), |element, exact| {
            Judge { couple: self, property, reference, exact }.outcome(element)
        })
    }

    fn elements(&self, property: PairProperty) -> Vec<Element> {
        let topology = self.topology;
        let faces = topology.faces().map(Element::Face);
        let edge = |h| Element::Edge(topology.origin(h), topology.target(h));
        match property {
            PairProperty::Parallel => topology.edges().map(edge).collect(),
            PairProperty::VParallel => {
                topology.vertices().map(Element::Vertex).chain(faces).collect()
            }
            PairProperty::ChristoffelDual => topology.edges().map(edge).chain(faces).collect(),
            PairProperty::FParallel
            | PairProperty::IMinimal
            | PairProperty::Cmc
            | PairProperty::ConstantK => faces.collect(),
        }
    }

    /// The face whose curvature is that of the others: a small one, so that comparing is cheap.
    fn reference(&self) -> Option<FaceId> {
        let mut faces: Vec<FaceId> = self.topology.faces().collect();
        faces.sort_by_key(|&f| self.topology.face(f).len());
        faces.into_iter().find(|&face| {
            Judge { couple: self, property: PairProperty::Cmc, reference: None, exact: false }
                .curved(face)
                .is_ok()
        })
    }

    /// The vertex of S that corresponds to one of M.
    fn image(&self, v: VertexId) -> VertexId {
        VertexId(v.0 + self.topology.vertex_count() as u32)
    }
}

/// Judges elements, with or without the exact value of what does not vanish.
struct Judge<'a, D> {
    couple: &'a Couple<'a, D>,
    property: PairProperty,
    reference: Option<FaceId>,
    exact: bool,
}

impl<D: Decide> Judge<'_, D> {
    fn outcome(&self, element: Element) -> Outcome<D::Value> {
        match (self.property, element) {
            (_, Element::Edge(a, b)) => self.edge(a, b),
            (_, Element::Vertex(v)) => self.vertex(v),
            (PairProperty::VParallel, Element::Face(f)) => self.both_planar(f),
            (property, Element::Face(f)) => match self.face(property, f) {
                Ok(outcome) | Err(outcome) => outcome,
            },
        }
    }

    fn edge(&self, a: VertexId, b: VertexId) -> Outcome<D::Value> {
        let decide = self.couple.decide;
        let at = [a, b, self.couple.image(a), self.couple.image(b)];
        let components = || (0..3).map(ParallelEdges);
        let answer = components().map(|residual| decide.decide(residual, at)).max();
        Outcome::of(answer.unwrap_or(Answer::Zero), || {
            self.worst_of(
                components()
                    .map(|residual| decide.failure("parallel edges", residual, at, self.exact)),
            )
        })
    }

    fn vertex(&self, v: VertexId) -> Outcome<D::Value> {
        let decide = self.couple.decide;
        let at = [v, self.couple.image(v)];
        let coordinates = || (0..2).map(Difference);
        let answer = coordinates().map(|residual| decide.decide(residual, at)).max();
        Outcome::of(answer.unwrap_or(Answer::Zero), || {
            self.worst_of(
                coordinates()
                    .map(|residual| decide.failure("same top view", residual, at, self.exact)),
            )
        })
    }

    fn worst_of(&self, failures: impl Iterator<Item = Failure<D::Value>>) -> Failure<D::Value> {
        let none = Failure { condition: self.property.name(), defect: 0.0, residual: None };
        failures.reduce(Failure::worse).unwrap_or(none)
    }

    /// Whether the face is planar and not vertical in M and in S.
    fn both_planar(&self, face: FaceId) -> Outcome<D::Value> {
        let corners = self.couple.topology.face(face);
        let images: Vec<VertexId> = corners.iter().map(|&v| self.couple.image(v)).collect();
        let planar = self.planar("planar", corners, undefined(face));
        let image = |answer: Answer| {
            let vertical = |_| Reason::VerticalImage(face);
            Ok(answer.max(self.planar("planar Gauss image", &images, vertical)?))
        };
        match planar.and_then(image) {
            Ok(Answer::Zero) if corners.len() == 3 => Outcome::Trivial,
            Ok(answer) => Outcome::of(answer, || self.worst_of(std::iter::empty())),
            Err(outcome) => outcome,
        }
    }

    /// Whether a face is planar; as an error if that is settled to its disadvantage.
    fn planar(
        &self,
        condition: &'static str,
        corners: &[VertexId],
        undefined: impl Fn(Position) -> Reason,
    ) -> Result<Answer, Outcome<D::Value>> {
        let decide = self.couple.decide;
        let shape = planar::shape(decide, corners);
        match shape.position {
            _ if shape.planar == Answer::Nonzero => {
                let places = planar::places(decide, corners).into_iter().flatten();
                Err(Outcome::Fails(decide.worst(condition, Coplanar, places, self.exact)))
            }
            Position::Graph => Ok(shape.planar),
            position => Err(Outcome::Undefined(undefined(position))),
        }
    }

    /// Whether the planes of a face are parallel; as an error if they are not, or there are none.
    fn parallel_planes(&self, face: FaceId) -> Result<Answer, Outcome<D::Value>> {
        let (decide, corners) = (self.couple.decide, self.couple.topology.face(face));
        let planar = self.planar("planar", corners, undefined(face))?;
        let triangle = planar::triangle(decide, ProjectedArea::TopView, corners);
        let (Some([a, b, c]), [first, rest @ ..]) = (triangle, corners) else {
            return Err(Outcome::Undefined(Reason::VerticalFace(face)));
        };
        let image = |v: &VertexId| self.couple.image(*v);
        let places = rest.iter().map(|v| [a, b, c, image(first), image(v)]);
        let answer = places.clone().map(|at| decide.decide(ParallelPlanes, at)).max();
        match answer.unwrap_or(Answer::Zero) {
            Answer::Nonzero => {
                let condition = "parallel face planes";
                Err(Outcome::Fails(decide.worst(condition, ParallelPlanes, places, self.exact)))
            }
            answer => Ok(answer.max(planar)),
        }
    }

    /// The same for a face that has curvatures: its area is not 0.
    fn curved(&self, face: FaceId) -> Result<Answer, Outcome<D::Value>> {
        let planes = self.parallel_planes(face)?;
        let area = self.fan(face).map(|[a, b, c, ..]| [a, b, c]).collect::<Vec<_>>();
        match self.couple.decide.sign_of_sum(ProjectedArea::TopView, &area).0 {
            Sign::Zero => Err(Outcome::Undefined(Reason::ZeroArea(face))),
            _ => Ok(planes),
        }
    }

    /// The triangles of a face from its first corner, with their images.
    fn fan(&self, face: FaceId) -> impl Iterator<Item = [VertexId; 6]> + Clone {
        let corners = self.couple.topology.face(face);
        let image = |v| self.couple.image(v);
        corners.windows(2).skip(1).map(move |w| {
            let triangle = [corners[0], w[0], w[1]];
            let [a, b, c] = triangle;
            [a, b, c, image(a), image(b), image(c)]
        })
    }

    /// What an f-parallel pair is on a face; as an error where it is none.
    fn face(
        &self,
        property: PairProperty,
        face: FaceId,
    ) -> Result<Outcome<D::Value>, Outcome<D::Value>> {
        let decide = self.couple.decide;
        let planes = match property {
            PairProperty::FParallel => {
                let answer = self.parallel_planes(face)?;
                return Ok(Outcome::of(answer, || self.worst_of(std::iter::empty())));
            }
            PairProperty::ChristoffelDual => self.parallel_planes(face)?,
            _ => self.curved(face)?,
        };
        let Some(curvature) = property.constant() else {
            let places: Vec<_> = self.fan(face).collect();
            let answer = decide.decide_sum(MixedArea, &places).max(planes);
            return Ok(Outcome::of(answer, || {
                decide.failure_of_sum("mixed area 0", MixedArea, &places, self.exact)
            }));
        };
        let other = self.reference.unwrap_or(face);
        let pairs = self.fan(face).flat_map(|own| self.fan(other).map(move |g| join(own, g)));
        let places: Vec<_> = pairs.collect();
        let answer = decide.decide_sum(curvature, &places).max(planes);
        let condition = match curvature {
            SameCurvature::Mean => "the same H",
            SameCurvature::Gauss => "the same K",
        };
        Ok(Outcome::of(answer, || decide.failure_of_sum(condition, curvature, &places, self.exact)))
    }
}

/// Why a face of M has no plane that is a graph.
fn undefined(face: FaceId) -> impl Fn(Position) -> Reason {
    move |position| match position {
        Position::Collinear => Reason::CollinearFace(face),
        Position::Vertical | Position::Graph => Reason::VerticalFace(face),
    }
}

/// Two triangles with their images.
fn join(a: [VertexId; 6], b: [VertexId; 6]) -> [VertexId; 12] {
    std::array::from_fn(|i| if i < 6 { a[i] } else { b[i - 6] })
}
