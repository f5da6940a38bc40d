//! i-conical meshes, by the metric dual.

use super::circular::CircularNet;
use super::dyadic::{rounded, rounded_point};
use super::march::march;
use super::{Element, Inside, NoExactMesh, Obstacle, Options, Rationalised};
use crate::mesh::{FaceId, Mesh, Topology, VertexId, VertexKind};
use crate::scalar::{Approx, Field, Rational, Ring};
use crate::space::{Dual, Plane, Point, TopView, Vector2};

/// An exact i-conical mesh near a mesh in which four faces meet at every interior vertex.
///
/// The [metric dual](crate::construct::metric_dual) is made exactly i-circular, as [`i_circular`] does: its
/// vertices are the poles of faces, and an interior vertex is the pole of a dual face. A vertex at the boundary
/// goes to the nearest point of its planes, of which there are one to three. Where K = 0 the dual
/// degenerates: parallel neighbouring faces are excluded.
///
/// # Errors
/// A coordinate that is no number; an interior vertex of another valence; a vertical face; a dual that
/// is no mesh, or has no order; planes that coincide; a vertex at the boundary in more than three planes that
/// do not meet by themselves; numbers that become too long.
///
/// [`i_circular`]: super::i_circular()
pub fn i_conical(mesh: &Mesh<f64>, options: &Options) -> Result<Rationalised, NoExactMesh> {
    let topology = &mesh.topology;
    if let Some(v) = topology.interior_vertices().find(|&v| topology.star(v).count() != 4) {
        return Err(Obstacle::NotRegular.at_vertex(v));
    }
    let inside = Inside::of(&mesh.points)?;
    let pole = |f: FaceId| {
        let corners: Vec<_> = topology.face(f).iter().map(|v| &mesh.points[v.index()]).collect();
        Ok(Plane::nearest(&corners).ok_or(Obstacle::Degenerate.at_face(f))?.dual())
    };
    let poles = topology.faces().map(pole).collect::<Result<Vec<_>, _>>()?;
    let around = Inside::of(&poles).map_err(|reason| in_mesh(reason, &[]))?;
    let inner: Vec<_> = topology.interior_vertices().collect();
    let dual = topology.dual().map_err(|error| {
        let v = error.face().and_then(|f| inner.get(f.index())).copied();
        Obstacle::NoDual.at_vertex(v.unwrap_or(VertexId(0)))
    })?;
    let dual = dual.topology;
    let steps = march(&dual).map_err(|reason| in_mesh(reason, &inner))?;
    let faces = faces_around(topology);
    super::nearest(mesh, options, |bits| {
        let net = CircularNet::near(&dual, &around.points, &steps, bits, options)
            .map_err(|reason| in_mesh(reason, &inner))?;
        let planes: Vec<_> = net.points.iter().map(|p| around.back(p).dual()).collect();
        let mut points = vec![None; mesh.points.len()];
        for (v, plane) in inner.iter().zip(&net.planes) {
            points[v.index()] = Some(around.plane_back(plane).dual());
        }
        topology
            .vertices()
            .map(|v| match points[v.index()].take() {
                Some(point) => Ok(point),
                None => {
                    let rim = Rim { net: &net, planes: &planes, inside: &inside, bits };
                    rim.place(v, &faces[v.index()])
                }
            })
            .collect()
    })
}

/// What stops the dual, as an element of the mesh.
fn in_mesh(reason: NoExactMesh, inner: &[VertexId]) -> NoExactMesh {
    let at = match reason.at {
        Element::Vertex(v) => Element::Face(FaceId(v.0)),
        Element::Face(f) => inner.get(f.index()).map_or(reason.at, |&v| Element::Vertex(v)),
    };
    NoExactMesh { at, ..reason }
}

/// The faces at every vertex, in their order around it where there is one.
fn faces_around(topology: &Topology) -> Vec<Vec<FaceId>> {
    let mut faces = vec![Vec::new(); topology.vertex_count()];
    for f in topology.faces() {
        for v in topology.face(f).iter().filter(|&&v| topology.kind(v) == VertexKind::Pinched) {
            faces[v.index()].push(f);
        }
    }
    for v in topology.vertices().filter(|&v| topology.kind(v) == VertexKind::Boundary) {
        faces[v.index()] = topology.star(v).map(|h| topology.face_at(h)).collect();
    }
    faces
}

/// Vertices at the boundary, in planes that are there.
struct Rim<'a> {
    net: &'a CircularNet<'a>,
    planes: &'a [Plane<Rational>],
    inside: &'a Inside,
    bits: i32,
}

impl Rim<'_> {
    /// The point nearest to its target in the planes of these faces, as far as it may be chosen.
    fn place(&self, v: VertexId, faces: &[FaceId]) -> Result<Point<Rational>, NoExactMesh> {
        let degenerate = Obstacle::Degenerate.at_vertex(v);
        let target = &self.inside.points[v.index()];
        let Some(&first) = faces.first() else {
            let point = rounded_point(target, self.bits).ok_or(degenerate)?;
            return Ok(self.inside.back(&point));
        };
        let top_view = match *faces {
            [f, g] => on_line(self.line(f, g), target, self.bits),
            [f, g, h, ..] => meet(self.line(f, g), self.line(g, h)),
            _ => rounded_point(target, self.bits).map(|p| p.top_view()),
        };
        let in_frame = top_view.ok_or(degenerate)?.at_height(Rational::zero());
        let top_view = self.inside.back(&in_frame).top_view();
        let point = self.planes[first.index()].point_at(&top_view);
        let is_on = |f: &FaceId| self.planes[f.index()].contains(&point);
        if faces.len() > 3 && !faces.iter().all(is_on) {
            return Err(Obstacle::TooManyPlanes.at_vertex(v));
        }
        Ok(point)
    }

    /// The line `u·x = k` over which the planes of two faces meet, in the frame.
    fn line(&self, f: FaceId, g: FaceId) -> Line {
        let (u, k) = self.net.dual_line(VertexId(f.0), VertexId(g.0)).unwrap_or_else(|| {
            let (f, g) = (&self.planes[f.index()], &self.planes[g.index()]);
            (&g.gradient - &f.gradient, &f.height - &g.height)
        });
        let Inside { middle, unit, .. } = self.inside;
        let k = (k - u.dot(&middle.top_view())) / unit;
        (u, k)
    }
}

type Line = (Vector2<Rational>, Rational);

/// The point of a line near a target, one coordinate rounded.
fn on_line((u, k): Line, target: &Point<f64>, bits: i32) -> Option<TopView<Rational>> {
    let near = Vector2::new(u.x.to_f64(), u.y.to_f64());
    let off = (k.to_f64() - near.dot(&target.top_view().position())) / near.length2();
    let foot = &target.top_view() + &near.scaled(&off);
    if near.x.abs() < near.y.abs() {
        let x = rounded(foot.x, bits)?;
        let y = (k - &u.x * &x).try_div(&u.y)?;
        Some(TopView { x, y })
    } else {
        let y = rounded(foot.y, bits)?;
        let x = (k - &u.y * &y).try_div(&u.x)?;
        Some(TopView { x, y })
    }
}

/// Where two lines meet.
fn meet((u, k): Line, (w, l): Line) -> Option<TopView<Rational>> {
    let scale = u.det(&w).try_inv()?;
    let x = Rational::det2(&k, &u.y, &l, &w.y) * &scale;
    let y = Rational::det2(&u.x, &k, &w.x, &l) * &scale;
    Some(TopView { x, y })
}
