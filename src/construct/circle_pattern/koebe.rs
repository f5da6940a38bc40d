//! i-Koebe meshes over circle patterns: every edge touches Σ (Sec. 3.4).

use super::{CirclePattern, Layout, NoPattern};
use crate::construct::koebe::poles;
use crate::mesh::{FaceId, Mesh, Topology, VertexId};
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
            mesh: poles(self.topology().clone(), circles.collect()),
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
        let pole = beside(&pattern, &layout, outer);
        // The inversion at a point of the outer face circle that lies in no vertex circle.
        let nothing = NoPattern::Stopped(pattern.defect);
        let inverted = |centre: TopView<f64>, radius: f64| {
            OrientedCircle { centre, radius }.inverted(&pole).ok_or(nothing.clone())
        };
        let rim = inverted(layout.faces[outer.index()], pattern.face_radius(outer))?;
        let unit = rim.radius.abs().recip();
        let circle = |v: VertexId| {
            let image = match layout.lines.get(&v) {
                None => inverted(layout.vertices[v.index()], pattern.vertex_radius(v))?,
                Some(line) => of_line(line, &pole),
            };
            let centre = (&image.centre - &rim.centre).scaled(&unit);
            let centre = TopView::new(centre.x, centre.y);
            Ok(OrientedCircle { centre, radius: image.radius * unit })
        };
        let circles = topology.vertices().map(circle).collect::<Result<_, NoPattern>>()?;
        Ok(Koebe {
            mesh: poles(topology.clone(), circles),
            defect: pattern.defect,
            gap: layout.gap,
        })
    }
}

/// The image of the line through two points under the inversion at a point beside it: the circle
/// through this point.
fn of_line([a, b]: &[TopView<f64>; 2], at: &TopView<f64>) -> OrientedCircle<f64> {
    let along = b - a;
    let factor = (at - a).dot(&along) / along.length2();
    let foot = &(a + &along.scaled(&factor)) - at;
    let diameter = foot.length2().sqrt().recip();
    let centre = at + &foot.scaled(&(diameter * diameter / 2.0));
    OrientedCircle { centre, radius: diameter / 2.0 }
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
