//! Floor 4: classes of mesh, one file each: definition, residual, and what is undefined.
//!
//! | property | element | residual vanishes iff |
//! | --- | --- | --- |
//! | [`planar`] | face | its points lie in a plane |
//! | [`circular`](i_circular) `i-circular` | face | planar, and the top view is concyclic |
//! | [`conical`](i_conical) `i-conical` | interior vertex | the gradients of its faces are concyclic |
//! | [`scribed`] `inscribed` | vertex | it lies on the unit i-sphere Σ |
//! | [`scribed`] `circumscribed` | face | its plane touches Σ |
//! | [`scribed`] `midscribed` | edge | its line touches Σ |
//! | [`delaunay`] | edge, face | no circumcircle of the top view has a vertex inside |
//! | [`i_isothermic`] `i-isothermic` | face, edge or vertex | touching circles with radii; else factorised cross-ratios |
//! | [`koenigs`] | face, interior vertex | planar quads; ratios of diagonals have the product 1 |
//! | [`i_minimal`] `i-minimal` | interior vertex | the mixed measure with the lift to Σ is 0 |
//! | [`a_net`] `a-net` | interior vertex | its edges lie in a plane |
//! | [`euclidean`] `circular`, `conical` | face, interior vertex | the Euclidean notions |
//! | [`edge_offset`] `edge-offset` | face, vertex, edge | the Euclidean notion: planar, edges on cones, a joint choice of axes that meet |
//!
//! Boundary rule: vertex properties are tested where the faces around a vertex form one closed
//! cycle; boundary and pinched vertices are no elements of the check. Only `edge-offset` speaks of the edges
//! at such vertices, which need no cycle.

pub mod a_net;
mod choice;
pub mod delaunay;
pub mod edge_offset;
pub mod euclidean;
pub mod i_circular;
pub mod i_conical;
pub mod i_isothermic;
pub mod i_minimal;
pub mod koenigs;
pub mod planar;
pub mod scribed;
mod star;

use std::sync::OnceLock;

use rayon::prelude::*;

use crate::check::{Decide, Element, Failure, Outcome, Report, Residual};
use crate::mesh::{FaceId, Topology, VertexId};
pub use planar::FaceShape;

/// The name of the data on vertices that hold the signed radii of vertex circles, the certificate of
/// i-isothermic meshes.
pub const RADIUS: &str = "radius";

/// A property of a single mesh that can be checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Property {
    /// Faces lie in planes.
    Planar,
    /// Faces have isotropic circumcircles.
    ICircular,
    /// The face planes at a vertex touch an isotropic cone of revolution.
    IConical,
    /// Vertices lie on the unit i-sphere.
    Inscribed,
    /// Face planes touch the unit i-sphere.
    Circumscribed,
    /// Edges touch the unit i-sphere.
    Midscribed,
    /// The top view is a Delaunay triangulation.
    Delaunay,
    /// The mesh discretises the curvature lines of an isothermic surface.
    IIsothermic,
    /// A planar quad mesh with a Christoffel dual, as far as interior vertices tell.
    Koenigs,
    /// H = 0 at interior vertices, with the lift to the unit i-sphere.
    IMinimal,
    /// The edges at a vertex lie in a plane.
    ANet,
    /// Faces have Euclidean circumcircles.
    Circular,
    /// The face planes at a vertex touch a Euclidean cone of revolution.
    Conical,
    /// A parallel mesh has edges that touch the unit sphere of Euclidean space.
    EdgeOffset,
}

impl Property {
    /// All properties, in the order of reports.
    pub const ALL: [Property; 14] = [
        Property::Planar,
        Property::ICircular,
        Property::IConical,
        Property::Inscribed,
        Property::Circumscribed,
        Property::Midscribed,
        Property::Delaunay,
        Property::IIsothermic,
        Property::Koenigs,
        Property::IMinimal,
        Property::ANet,
        Property::Circular,
        Property::Conical,
        Property::EdgeOffset,
    ];

    /// The name on the command line and in reports.
    pub fn name(self) -> &'static str {
        match self {
            Property::Planar => "planar",
            Property::ICircular => "i-circular",
            Property::IConical => "i-conical",
            Property::Inscribed => "inscribed",
            Property::Circumscribed => "circumscribed",
            Property::Midscribed => "midscribed",
            Property::Delaunay => "delaunay",
            Property::IIsothermic => "i-isothermic",
            Property::Koenigs => "koenigs",
            Property::IMinimal => "i-minimal",
            Property::ANet => "a-net",
            Property::Circular => "circular",
            Property::Conical => "conical",
            Property::EdgeOffset => "edge-offset",
        }
    }

    /// The property of that name.
    pub fn from_name(name: &str) -> Option<Property> {
        Property::ALL.into_iter().find(|p| p.name() == name)
    }
}

/// A mesh whose classes are being asked for: combinatorics, a way to decide, and what has been
/// found out about the faces.
#[derive(Debug)]
pub struct Net<'a, D> {
    topology: &'a Topology,
    decide: &'a D,
    radii: Option<VertexId>,
    shapes: OnceLock<Vec<FaceShape>>,
    axes: OnceLock<edge_offset::Axes>,
    disc: OnceLock<bool>,
}

impl<'a, D: Decide> Net<'a, D> {
    /// Combinatorics and a decider for the points of the same mesh.
    pub fn new(topology: &'a Topology, decide: &'a D) -> Self {
        let (shapes, axes, disc) = (OnceLock::new(), OnceLock::new(), OnceLock::new());
        Net { topology, decide, radii: None, shapes, axes, disc }
    }

    /// The same with signed radii of vertex circles: they are the x-coordinates of the decider's
    /// points from `first` on, as many as there are vertices.
    ///
    /// With them `i-isothermic` asks for touching circles, and the lift of `i-minimal` is that of
    /// the circles.
    pub fn with_radii(mut self, first: VertexId) -> Self {
        self.radii = Some(first);
        self
    }

    /// Checks one property on all its elements.
    ///
    /// Linear in the size of the mesh, in parallel; what is found about the faces is kept for the
    /// next property.
    pub fn check(&self, property: Property) -> Report<D::Value> {
        let elements = self.elements(property);
        self.know_faces(property);
        self.know_axes(property);
        Report::collect(property.name(), &elements, |element, exact| {
            Judge { net: self, exact }.outcome(property, element)
        })
    }

    /// By how much each vertex or face misses a property of vertices or faces, for a picture: the
    /// defect of its worst residual, free of units; 0 where the property holds or is undefined, and
    /// at elements that it does not speak of.
    pub fn defects(&self, property: Property) -> Vec<f64> {
        let elements = self.elements(property);
        self.know_faces(property);
        self.know_axes(property);
        let judge = Judge { net: self, exact: false };
        let defect = |&element: &Element| match (element, judge.outcome(property, element)) {
            (Element::Face(f), Outcome::Fails(failure)) => Some((f.index(), failure.defect)),
            (Element::Vertex(v), Outcome::Fails(failure)) => Some((v.index(), failure.defect)),
            _ => None,
        };
        let on_faces = matches!(elements.first(), Some(Element::Face(_)));
        let count =
            if on_faces { self.topology.face_count() } else { self.topology.vertex_count() };
        // Of properties that speak of both, those of the kind that comes first.
        let shown = elements.par_iter().filter(|e| matches!(e, Element::Face(_)) == on_faces);
        let found: Vec<_> = shown.filter_map(defect).collect();
        let mut defects = vec![0.0; count];
        found.into_iter().for_each(|(index, defect)| defects[index] = defect);
        defects
    }

    fn elements(&self, property: Property) -> Vec<Element> {
        let topology = self.topology;
        let faces = || topology.faces().map(Element::Face);
        let interior = || topology.interior_vertices().map(Element::Vertex);
        let edges =
            || topology.edges().map(|h| Element::Edge(topology.origin(h), topology.target(h)));
        match property {
            Property::Planar
            | Property::ICircular
            | Property::Circumscribed
            | Property::Circular => faces().collect(),
            Property::IConical | Property::IMinimal | Property::ANet | Property::Conical => {
                interior().collect()
            }
            Property::IIsothermic if self.radii.is_some() => faces().chain(edges()).collect(),
            Property::IIsothermic | Property::Koenigs => faces().chain(interior()).collect(),
            Property::Inscribed => topology.vertices().map(Element::Vertex).collect(),
            Property::Midscribed => edges().collect(),
            Property::Delaunay => delaunay::elements(topology),
            Property::EdgeOffset => edge_offset::elements(topology),
        }
    }

    /// Whether the mesh is a disc whose boundary winds once in the top view.
    fn is_disc(&self) -> bool {
        *self.disc.get_or_init(|| delaunay::is_disc(self.topology, self.decide))
    }

    /// Finds out about all faces where the property asks for them.
    ///
    /// Not inside of `get_or_init`: a thread that waits for others to finish their share may take
    /// up another task that asks for the same, and would wait for itself.
    fn know_faces(&self, property: Property) {
        let asks = match property {
            Property::Planar
            | Property::ICircular
            | Property::IConical
            | Property::Circumscribed
            | Property::IIsothermic
            | Property::Koenigs
            | Property::IMinimal
            | Property::Circular
            | Property::Conical
            | Property::EdgeOffset => true,
            Property::Inscribed | Property::Midscribed | Property::Delaunay | Property::ANet => {
                false
            }
        };
        if asks && self.shapes.get().is_none() {
            let faces = 0..self.topology.face_count() as u32;
            let shape = |f| self.find_shape(FaceId(f));
            let shapes = faces.into_par_iter().with_min_len(1024).map(shape).collect();
            // Another thread may have been faster; it found the same.
            let _ = self.shapes.set(shapes);
        }
    }

    /// Finds the cones of edges at all vertices, in the same way.
    fn know_axes(&self, property: Property) {
        if property == Property::EdgeOffset && self.axes.get().is_none() {
            let _ = self.axes.set(edge_offset::Axes::find(self.topology, self.decide));
        }
    }

    fn find_shape(&self, face: FaceId) -> FaceShape {
        planar::shape(self.decide, self.topology.face(face))
    }

    /// What is known about a face: planarity and the position of its plane.
    fn shape(&self, face: FaceId) -> FaceShape {
        self.shapes.get().map_or_else(|| self.find_shape(face), |shapes| shapes[face.index()])
    }
}

/// Judges elements, with or without the exact value of what does not vanish.
struct Judge<'a, D> {
    net: &'a Net<'a, D>,
    exact: bool,
}

impl<D: Decide> Judge<'_, D> {
    fn outcome(&self, property: Property, element: Element) -> Outcome<D::Value> {
        match (property, element) {
            (Property::Planar, Element::Face(f)) => planar::outcome(self, f),
            (Property::ICircular, Element::Face(f)) => i_circular::outcome(self, f),
            (Property::IConical, Element::Vertex(v)) => i_conical::outcome(self, v),
            (Property::Inscribed, Element::Vertex(v)) => scribed::inscribed(self, v),
            (Property::Circumscribed, Element::Face(f)) => scribed::circumscribed(self, f),
            (Property::Midscribed, Element::Edge(a, b)) => scribed::midscribed(self, a, b),
            (Property::Delaunay, element) => delaunay::outcome(self, element),
            (Property::IIsothermic, element) => i_isothermic::outcome(self, element),
            (Property::Koenigs, element) => koenigs::outcome(self, element),
            (Property::IMinimal, Element::Vertex(v)) => i_minimal::outcome(self, v),
            (Property::ANet, Element::Vertex(v)) => a_net::outcome(self, v),
            (Property::Circular, Element::Face(f)) => euclidean::circular(self, f),
            (Property::Conical, Element::Vertex(v)) => euclidean::conical(self, v),
            (Property::EdgeOffset, element) => edge_offset::outcome(self, element),
            // `elements` pairs every property with its own kind of element.
            _ => Outcome::Trivial,
        }
    }

    fn topology(&self) -> &Topology {
        self.net.topology
    }

    fn decide(&self) -> &D {
        self.net.decide
    }

    /// Where the radius of a vertex stands, if there are radii.
    fn radius(&self, v: VertexId) -> Option<VertexId> {
        self.net.radii.map(|first| VertexId(first.0 + v.0))
    }

    fn failure<const K: usize>(
        &self,
        condition: &'static str,
        residual: impl Residual<K>,
        at: [VertexId; K],
    ) -> Failure<D::Value> {
        self.net.decide.failure(condition, residual, at, self.exact)
    }

    /// The failure with the largest defect among several points of evaluation.
    fn worst<const K: usize>(
        &self,
        condition: &'static str,
        residual: impl Residual<K>,
        places: impl Iterator<Item = [VertexId; K]>,
    ) -> Failure<D::Value> {
        self.net.decide.worst(condition, residual, places, self.exact)
    }
}
