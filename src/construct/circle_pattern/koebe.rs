//! i-Koebe meshes over circle patterns: every edge touches Σ (Sec. 3.4).

use super::{CirclePattern, Layout, NoPattern};
use crate::mesh::{Data, FaceId, Mesh, Topology, VertexId};
use crate::net::RADIUS;
use crate::space::{OrientedCircle, TopView};

/// An i-Koebe mesh in doubles, with the radii of its vertex circles as data `radius`.
#[derive(Clone, Debug)]
pub struct Koebe {
    /// The mesh.
    pub mesh: Mesh<f64>,
    /// The largest error of an angle of its circle pattern, in radians.
    pub defect: f64,
    /// How well its layout closes: see [`Layout`](super::Layout).
    pub gap: f64,
}

impl CirclePattern<'_> {
    /// The i-Koebe mesh of the pattern of a disc: the vertices are the poles of the planes of their
    /// circles, `z = (|x'|² − r²)/2`.
    pub fn koebe(&self) -> Koebe {
        let layout = self.layout();
        let circles = layout.vertices.iter().zip(&self.vertex_radii);
        let circles = circles.map(|(&centre, &radius)| OrientedCircle { centre, radius });
        Koebe {
            mesh: poles(self.topology(), circles.collect()),
            defect: self.defect,
            gap: layout.gap,
        }
    }
}

impl Koebe {
    /// The i-Koebe mesh of a closed mesh: it exists for the mesh of a convex polyhedron, which then
    /// is one with edges that touch Σ (Koebe).
    ///
    /// The circle of the face `outer` is the unit circle, and all others lie in it; its own plane
    /// closes the mesh from above.
    ///
    /// # Errors
    /// See [`NoPattern`].
    pub fn closed(topology: &Topology, outer: FaceId) -> Result<Koebe, NoPattern> {
        let pattern = CirclePattern::sphere(topology, far_from(topology, outer))?;
        let layout = pattern.layout();
        let (centre, radius) = (layout.faces[outer.index()], pattern.face_radius(outer));
        let pole = beside(&pattern, &layout, outer);
        // The inversion at a point of the outer face circle that lies in no vertex circle.
        let power = |c: &TopView<f64>, r: f64| (c - &pole).length2() - r * r;
        let inverted = |v: VertexId| match layout.lines.get(&v) {
            None => {
                let (c, r) = (layout.vertices[v.index()], pattern.vertex_radius(v));
                let power = power(&c, r);
                (&pole + &(&c - &pole).scaled(&power.recip()), r / power)
            }
            Some([a, b]) => {
                let along = b - a;
                let factor = (&pole - a).dot(&along) / along.length2();
                let foot = &(a + &along.scaled(&factor)) - &pole;
                let diameter = foot.length2().sqrt().recip();
                (&pole + &foot.scaled(&(diameter * diameter / 2.0)), diameter / 2.0)
            }
        };
        let power = power(&centre, radius);
        let middle = &pole + &(&centre - &pole).scaled(&power.recip());
        let unit = (power / radius).abs();
        let circle = |v: VertexId| {
            let (c, r) = inverted(v);
            let c = (&c - &middle).scaled(&unit);
            OrientedCircle { centre: TopView::new(c.x, c.y), radius: r * unit }
        };
        let mesh = poles(topology, topology.vertices().map(circle).collect());
        Ok(Koebe { mesh, defect: pattern.defect, gap: layout.gap })
    }
}

/// A vertex with an edge that is not one of the face, as far as there is one: there lines are put.
fn far_from(topology: &Topology, outer: FaceId) -> VertexId {
    let corners = topology.face(outer);
    let away = |&v: &VertexId| {
        let sides = topology.star(v).next().map(|h| [Some(h), topology.twin(h)]);
        let faces = sides.into_iter().flatten().flatten().map(|h| topology.face_at(h));
        !faces.into_iter().any(|f| f == outer)
    };
    let clear = topology.vertices().filter(|v| !corners.contains(v)).find(away);
    clear.or_else(|| topology.vertices().find(away)).unwrap_or(VertexId(0))
}

/// The centre of a face circle, or, where one of its vertex circles is a line through it, a point
/// beside it that lies in no vertex circle.
fn beside(pattern: &CirclePattern<'_>, layout: &Layout, face: FaceId) -> TopView<f64> {
    let corners = pattern.topology().face(face);
    let Some([centre, touch]) = corners.iter().find_map(|v| layout.lines.get(v)) else {
        return layout.faces[face.index()];
    };
    let finite = corners.iter().map(|v| layout.vertices[v.index()]);
    let finite: Vec<_> = finite.filter(|c| c.x.is_finite()).collect();
    let farthest = finite.iter().map(|c| (c - centre).length2()).fold(0.0, f64::max).sqrt();
    let normal = (touch - centre).turned();
    let side = finite.first().map_or(1.0, |c| (c - centre).dot(&normal).signum());
    let radius = pattern.face_radius(face);
    let length = radius * radius / (4.0 * farthest);
    centre + &normal.scaled(&(side * length / normal.length2().sqrt()))
}

/// The mesh of the poles of vertex circles, with their radii.
fn poles(topology: &Topology, circles: Vec<OrientedCircle<f64>>) -> Mesh<f64> {
    let points = circles.iter().map(OrientedCircle::pole).collect();
    let mut data = Data::default();
    data.vertex.insert(RADIUS.into(), circles.into_iter().map(|c| c.radius).collect());
    Mesh { topology: topology.clone(), points, data }
}
