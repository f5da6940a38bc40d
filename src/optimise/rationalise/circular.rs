//! i-circular meshes of quads, from a direction for every vertex.
//!
//! In the top view, with complex numbers: the vertices of a quad lie on a circle if and only if there are
//! `z` with `v_b − v_a = l_ab z_a z_b` and real `l` for its edges, because then the cross-ratio is
//! `l_ab l_cd/(l_bc l_da)`. (On the unit circle `z_a` is half as far around as `v_a`, times `√i`.) Here the
//! directions `z` are Gaussian integers of few bits. When the last vertex of a quad is placed, its `z_d` is
//! chosen so that `v_d` comes near to where it shall be on the circle through a, b and c, and `l` of its two
//! edges follows from those of the others, times numbers with the denominator `|z_d|² im(z̄_a z_c)`. So every
//! quad adds a factor of few bits to the denominators, once.
//!
//! The heights are `h_b − h_a = l_ab k_ab`, with slopes that satisfy `k_ab = g·(z_a z_b)` for the gradient g
//! of the quad. They behave as the `l` do, with the denominator `|z_b|² im(z̄_a z_c)`.

use std::f64::consts::PI;

use super::direction::{Gaussian, whole};
use super::dyadic::{exponent, rounded, rounded_point};
use super::march::{Step, march};
use super::{Inside, NoExactMesh, Obstacle, Options, Rationalised, bits};
use crate::mesh::{HalfEdge, Mesh, Topology, VertexId};
use crate::scalar::{Approx, Field, Rational, Ring};
use crate::space::{Gradient, Plane, Point, TopView, Vector2};

/// An exact i-circular mesh near a mesh of quads, with vertices of any valence.
///
/// Vertices are taken away from convex corners of the boundary on, until nothing is left; the reverse is the
/// order of placing. So it is a mesh of simply connected pieces, and a boundary without corners, as that of
/// rings of quads, is excluded. Circles are those of the top view; where quads are collinear there, nothing
/// is determined.
///
/// # Errors
/// A coordinate that is no number; a face that is no quad; no order; vertices or directions that
/// coincide; numbers that become too long.
pub fn i_circular(mesh: &Mesh<f64>, options: &Options) -> Result<Rationalised, NoExactMesh> {
    let steps = march(&mesh.topology)?;
    let inside = Inside::of(&mesh.points)?;
    super::nearest(mesh, options, |bits| {
        let net = CircularNet::near(&mesh.topology, &inside.points, &steps, bits, options)?;
        Ok(net.points.iter().map(|p| inside.back(p)).collect())
    })
}

/// An exact i-circular mesh with what it was made from.
pub(super) struct CircularNet<'a> {
    topology: &'a Topology,
    pub points: Vec<Point<Rational>>,
    /// The planes of the faces.
    pub planes: Vec<Plane<Rational>>,
    directions: Vec<Gaussian>,
    /// By half-edges; of two twins one has it.
    edges: Vec<Option<Edge>>,
    near: Vec<TopView<f64>>,
}

/// Of an edge from a to b, `l` and `k` with `v_b − v_a = l z_a z_b` and `h_b − h_a = l k`.
#[derive(Clone, Debug)]
struct Edge {
    length: Rational,
    slope: Rational,
}

impl Edge {
    fn reversed(&self) -> Edge {
        Edge { length: -&self.length, slope: self.slope.clone() }
    }

    /// The end of the edge from a point, in the direction `z_a z_b`.
    fn end(&self, from: &Point<Rational>, direction: Gaussian) -> Point<Rational> {
        let step = direction.vector().scaled(&self.length);
        (&from.top_view() + &step).at_height(&from.z + &self.length * &self.slope)
    }
}

impl<'a> CircularNet<'a> {
    /// Places the vertices near these points.
    pub fn near(
        topology: &'a Topology,
        targets: &[Point<f64>],
        steps: &[Step],
        rounding: i32,
        options: &Options,
    ) -> Result<Self, NoExactMesh> {
        let n = topology.vertex_count();
        let origin = TopView::new(Rational::zero(), Rational::zero());
        let level = Gradient::new(Rational::zero(), Rational::zero());
        let mut net = CircularNet {
            topology,
            points: vec![origin.at_height(Rational::zero()); n],
            planes: vec![Plane::new(level, Rational::zero()); topology.face_count()],
            directions: vec![Gaussian::ONE; n],
            edges: vec![None; topology.corner_count()],
            near: vec![TopView::new(0.0, 0.0); n],
        };
        for step in steps {
            let v = match *step {
                Step::Free(v) | Step::Along(v, _) => v,
                Step::Close(h) => topology.origin(h),
            };
            let target = &targets[v.index()];
            let point = match *step {
                Step::Free(_) => rounded_point(target, rounding),
                Step::Along(_, from) => net.along(from, v, target, rounding),
                Step::Close(h) => net.close(h, target, rounding),
            };
            let point = point.ok_or(Obstacle::Degenerate.at_vertex(v))?;
            if bits(&point) > options.most_bits {
                return Err(Obstacle::TooManyBits.at_vertex(v));
            }
            net.near[v.index()] = TopView::new(point.x.to_f64(), point.y.to_f64());
            net.points[v.index()] = point;
        }
        Ok(net)
    }

    /// Of the top view of the line that is dual to an edge, `u·x = k`, the normal u and k.
    pub fn dual_line(&self, a: VertexId, b: VertexId) -> Option<(Vector2<Rational>, Rational)> {
        let edge = self.edge(self.topology.edge(a, b)?)?;
        let direction = self.directions[a.index()].times(self.directions[b.index()]);
        Some((direction.vector(), edge.slope))
    }

    /// The edge from the origin of a half-edge to its target.
    fn edge(&self, h: HalfEdge) -> Option<Edge> {
        let there = |h: HalfEdge| self.edges[h.0 as usize].as_ref();
        there(h).cloned().or_else(|| Some(there(self.topology.twin(h)?)?.reversed()))
    }

    /// Places b at the end of an edge from a.
    fn along(
        &mut self,
        a: VertexId,
        b: VertexId,
        target: &Point<f64>,
        rounding: i32,
    ) -> Option<Point<Rational>> {
        let h = self.topology.edge(a, b)?;
        let step = &target.top_view() - &self.near[a.index()];
        let z = self.directions[a.index()];
        let tolerance = 2f64.powi(-rounding) / step.x.hypot(step.y);
        self.directions[b.index()] = Gaussian::near(angle(&step) - z.angle(), tolerance)?;
        let direction = z.times(self.directions[b.index()]);
        let size = direction.length();
        let along = (step.x * direction.re as f64 + step.y * direction.im as f64) / size;
        let length = rounded(along / size, rounding + exponent(size))?;
        let from = &self.points[a.index()];
        let run = length.to_f64();
        let slope = rounded((target.z - from.z.to_f64()) / run, rounding + exponent(run))?;
        let edge = Edge { length, slope };
        let end = edge.end(from, direction);
        let is_forward = self.topology.origin(h) == a;
        self.edges[h.0 as usize] = Some(if is_forward { edge } else { edge.reversed() });
        Some(end)
    }

    /// Places the origin d of a half-edge as the last vertex of its face.
    fn close(
        &mut self,
        dc: HalfEdge,
        target: &Point<f64>,
        rounding: i32,
    ) -> Option<Point<Rational>> {
        let topology = self.topology;
        let cb = topology.next(dc);
        let ba = topology.next(cb);
        let ad = topology.next(ba);
        let [a, b, c, d] = [ad, ba, cb, dc].map(|h| topology.origin(h));
        let [za, zb, zc] = [a, b, c].map(|v| self.directions[v.index()]);
        let zd = self.closing_direction([a, c], target, rounding)?;

        let (ab, cb) = (self.edge(ba)?.reversed(), self.edge(cb)?);
        let (na, nb, nc, nd) = (za.norm(), zb.norm(), zc.norm(), zd.norm());
        let det = za.conjugate().times(zc).im;
        let g = zb.times(zd.conjugate());
        let ac = g.times(za).times(zc.conjugate()).im;
        let ca = g.times(zc).times(za.conjugate()).im;
        // (p x + q y)/(det n)
        let mix = |x: &Rational, p: i128, y: &Rational, q: i128, n: i128| {
            let scale = whole(det * n).try_inv()?;
            Some(Rational::dot([x, y], [&whole(p), &whole(q)]) * scale)
        };
        let ad_edge = Edge {
            length: mix(&ab.length, -ac, &cb.length, nc * g.im, nd)?,
            slope: mix(&ab.slope, ca, &cb.slope, -na * g.im, nb)?,
        };
        let cd_edge = Edge {
            length: mix(&ab.length, -na * g.im, &cb.length, ca, nd)?,
            slope: mix(&ab.slope, nc * g.im, &cb.slope, -ac, nb)?,
        };
        let (azb, czb) = (za.times(zb), zc.times(zb));
        let gradient = Gradient {
            x: mix(&ab.slope, czb.im, &cb.slope, -azb.im, nb)?,
            y: mix(&ab.slope, -czb.re, &cb.slope, azb.re, nb)?,
        };
        let from = &self.points[a.index()];
        let end = ad_edge.end(from, za.times(zd));
        self.planes[topology.face_at(dc).index()] = Plane::through_point(from, gradient);
        self.directions[d.index()] = zd;
        self.edges[ad.0 as usize] = Some(ad_edge);
        self.edges[dc.0 as usize] = Some(cd_edge.reversed());
        Some(end)
    }

    /// A direction for the vertex between a and c that brings it near to its target on the circle.
    fn closing_direction(
        &self,
        [a, c]: [VertexId; 2],
        target: &Point<f64>,
        rounding: i32,
    ) -> Option<Gaussian> {
        let [za, zc] = [a, c].map(|v| self.directions[v.index()].angle());
        let [va, vc] = [a, c].map(|v| &self.near[v.index()]);
        let target = target.top_view();
        let (from_a, from_c) = (&target - va, &target - vc);
        // Seen from a and from c, modulo π; the longer way counts more.
        let (seen_a, seen_c) = (angle(&from_a) - za, angle(&from_c) - zc);
        let apart = (seen_c - seen_a + PI / 2.0).rem_euclid(PI) - PI / 2.0;
        let part = from_c.length2() / (from_a.length2() + from_c.length2());
        // The point runs around the circle by its diameter times the change of the angle.
        let diameter = va.distance2(vc).sqrt() / (za - zc).sin().abs();
        Gaussian::near(seen_a + apart * part, 2f64.powi(-rounding) / diameter)
    }
}

fn angle(v: &Vector2<f64>) -> f64 {
    v.y.atan2(v.x)
}
