//! i-circular meshes with fixed directions of edges: vertices and gradients solve linear systems.

use std::collections::VecDeque;

use super::circular::{CircularNet, angle};
use super::direction::Gaussian;
use super::dyadic::finite;
use super::linear::{Rows, solution_near};
use super::{NoExactMesh, Obstacle};
use crate::mesh::{HalfEdge, Topology, VertexId};
use crate::scalar::{Rational, Ring};
use crate::space::{Gradient, Plane, Point, TopView, Vector2};

impl<'a> CircularNet<'a> {
    /// Places vertices near these points, with edges in directions `z_a z_b` that are all chosen before.
    ///
    /// Edges are parallel to `z_a z_b`: that is linear in the vertices. Gradients of neighbouring faces
    /// differ by a vector orthogonal to it: that is linear in the gradients, and where there are holes the
    /// heights must close around them.
    ///
    /// # Errors
    /// A face without a plane, an angle that takes too many bits, not enough memory.
    pub fn with_parallel_edges(
        topology: &'a Topology,
        targets: &[Point<f64>],
        bits: i32,
    ) -> Result<Self, NoExactMesh> {
        let mut net = CircularNet::empty(topology);
        net.directions = directions(topology, targets, bits)?;
        let direction = |h: HalfEdge| {
            let [a, b] = [topology.origin(h), topology.target(h)].map(VertexId::index);
            net.directions[a].times(net.directions[b]).vector()
        };

        let mut rows = Rows::new();
        for h in topology.edges() {
            let [a, b] = [topology.origin(h), topology.target(h)].map(|v| 2 * v.index());
            let Vector2 { x, y } = direction(h);
            rows.push(vec![(a, y.clone()), (a + 1, -&x), (b, -y), (b + 1, x)]);
        }
        let near: Vec<f64> = targets.iter().flat_map(|p| [p.x, p.y]).collect();
        let out_of_memory = |_| Obstacle::OutOfMemory.at_vertex(VertexId(0));
        let solved = solution_near(&near, &rows).map_err(out_of_memory)?;
        let tops: Vec<_> = pairs(solved).map(|[x, y]| TopView { x, y }).collect();

        let mut near = Vec::new();
        for f in topology.faces() {
            let corners: Vec<_> = topology.face(f).iter().map(|v| &targets[v.index()]).collect();
            let plane = Plane::nearest(&corners).ok_or(Obstacle::Degenerate.at_face(f))?;
            near.extend([plane.gradient.x, plane.gradient.y]);
        }
        let face = |h: HalfEdge| 2 * topology.face_at(h).index();
        let mut rows = Rows::new();
        for h in topology.edges() {
            if let Some(twin) = topology.twin(h) {
                let ([f, g], Vector2 { x, y }) = ([h, twin].map(face), direction(h));
                rows.push(vec![(f, x.clone()), (f + 1, y.clone()), (g, -x), (g + 1, -y)]);
            }
        }
        let forest = Forest::new(topology);
        let step =
            |h: HalfEdge| &tops[topology.target(h).index()] - &tops[topology.origin(h).index()];
        for around in forest.holes(topology) {
            let mut row = BTreeMap::new();
            for (h, sign) in around {
                let Vector2 { x, y } = step(h).scaled(&Rational::from_i64(sign));
                *row.entry(face(h)).or_insert_with(Rational::zero) += &x;
                *row.entry(face(h) + 1).or_insert_with(Rational::zero) += &y;
            }
            rows.push(row.into_iter().collect());
        }
        let solved = solution_near(&near, &rows).map_err(out_of_memory)?;
        let gradients: Vec<_> = pairs(solved).map(|[x, y]| Gradient { x, y }).collect();

        let rise = |h: HalfEdge| gradients[face(h) / 2].along(&step(h));
        let mut heights = vec![Rational::zero(); targets.len()];
        for &v in &forest.order {
            heights[v.index()] = match forest.towards[v.index()] {
                None => finite(targets[v.index()].z),
                Some((h, 1)) => &heights[topology.origin(h).index()] + rise(h),
                Some((h, _)) => &heights[topology.target(h).index()] - rise(h),
            };
        }
        net.points = tops.iter().zip(heights).map(|(top, z)| top.clone().at_height(z)).collect();
        for h in topology.edges() {
            let direction = direction(h);
            let length = step(h).dot(&direction).try_div(&direction.length2());
            let slope = gradients[face(h) / 2].along(&direction);
            net.edges[h.0 as usize] = length.map(|length| Edge { length, slope });
        }
        for (f, gradient) in topology.faces().zip(gradients) {
            let corner = topology.face(f)[0];
            net.planes[f.index()] = Plane::through_point(&net.points[corner.index()], gradient);
        }
        Ok(net)
    }
}

fn pairs(values: Vec<Rational>) -> impl Iterator<Item = [Rational; 2]> {
    let mut values = values.into_iter();
    std::iter::from_fn(move || Some([values.next()?, values.next()?]))
}

/// For every vertex a direction such that edges are near to `z_a z_b`.
fn directions(
    topology: &Topology,
    targets: &[Point<f64>],
    bits: i32,
) -> Result<Vec<Gaussian>, NoExactMesh> {
    let mut angles = vec![None; targets.len()];
    let mut found = vec![Gaussian::ONE; targets.len()];
    let step = |v: VertexId, w: VertexId| {
        &targets[w.index()].top_view() - &targets[v.index()].top_view()
    };
    for root in topology.vertices() {
        if angles[root.index()].is_some() {
            continue;
        }
        // Each angle is ±c and a number; c is free unless a cycle is odd.
        angles[root.index()] = Some((1.0, 0.0));
        let (mut component, mut next, mut c) = (vec![root], 0, None);
        while let Some(&v) = component.get(next) {
            next += 1;
            let Some((sign, own)) = angles[v.index()] else { continue };
            for w in topology.neighbours(v) {
                let other = angle(&step(v, w)) - own;
                match angles[w.index()] {
                    None => {
                        angles[w.index()] = Some((-sign, other));
                        component.push(w);
                    }
                    Some((same, known)) if same == sign && c.is_none() => {
                        c = Some(sign * (other - known) / 2.0);
                    }
                    Some(_) => {}
                }
            }
        }
        for v in component {
            let lengths = topology.neighbours(v).into_iter().map(|w| step(v, w).length2());
            let longest = lengths.fold(0.0, f64::max).sqrt();
            let (sign, own) = angles[v.index()].unwrap_or((0.0, 0.0));
            let near = own + sign * c.unwrap_or(0.0);
            let direction = Gaussian::near(near, 2f64.powi(-bits) / longest);
            found[v.index()] = direction.ok_or(Obstacle::Degenerate.at_vertex(v))?;
        }
    }
    Ok(found)
}

/// A half-edge and 1 or −1: along it or against it.
type Way = (HalfEdge, i64);

/// A tree of edges for every component.
struct Forest {
    /// The vertices, each after the one before it on its way from the root.
    order: Vec<VertexId>,
    /// The last edge on that way; none at a root.
    towards: Vec<Option<Way>>,
}

impl Forest {
    fn new(topology: &Topology) -> Self {
        let mut forest = Forest { order: Vec::new(), towards: vec![None; topology.vertex_count()] };
        let mut seen = vec![false; topology.vertex_count()];
        let mut next = 0;
        for root in topology.vertices() {
            if std::mem::replace(&mut seen[root.index()], true) {
                continue;
            }
            forest.order.push(root);
            while let Some(&v) = forest.order.get(next) {
                next += 1;
                for w in topology.neighbours(v) {
                    if let Some(h) = topology.edge(v, w)
                        && !std::mem::replace(&mut seen[w.index()], true)
                    {
                        let sign = if topology.origin(h) == v { 1 } else { -1 };
                        forest.towards[w.index()] = Some((h, sign));
                        forest.order.push(w);
                    }
                }
            }
        }
        forest
    }

    /// The edges from a vertex back to the root.
    fn back(&self, topology: &Topology, v: VertexId) -> impl Iterator<Item = Way> {
        let before = move |(h, sign): Way| {
            let v = if sign == 1 { topology.origin(h) } else { topology.target(h) };
            self.towards[v.index()]
        };
        std::iter::successors(self.towards[v.index()], move |&way| before(way))
    }

    /// Closed ways that together with the faces generate all closed ways.
    fn holes(&self, topology: &Topology) -> Vec<Vec<Way>> {
        let mut is_open = vec![false; topology.corner_count()];
        let mut open = vec![0; topology.face_count()];
        let sides = |h: HalfEdge| std::iter::once(h).chain(topology.twin(h));
        let in_tree = |h: HalfEdge| {
            let ends = [topology.origin(h), topology.target(h)];
            let is_last = |v: VertexId| self.towards[v.index()].map(|way| way.0);
            ends.into_iter().filter_map(is_last).any(|last| sides(h).any(|side| side == last))
        };
        for h in topology.edges().filter(|&h| !in_tree(h)) {
            for side in sides(h) {
                is_open[side.0 as usize] = true;
                open[topology.face_at(side).index()] += 1;
            }
        }
        let mut holes = Vec::new();
        let mut closing: Vec<HalfEdge> = Vec::new();
        let last = |open: &[usize], is_open: &[bool], side: HalfEdge| {
            let face = topology.face_at(side);
            let mut rest = topology.half_edges(face).filter(|h| is_open[h.0 as usize]);
            if open[face.index()] == 1 { rest.next() } else { None }
        };
        for f in topology.faces() {
            closing.extend(last(&open, &is_open, topology.half_edges(f).next().unwrap_or(HalfEdge(0))));
        }
        holes
    }
}
