//! Gauss images with their face planes tangent to the unit i-sphere Σ (Theorem 2).

use std::collections::VecDeque;

use super::NoGaussImage;
use super::spread::{Neighbours, joined_faces, joined_vertices, spread};
use crate::mesh::{Data, FaceId, Mesh, VertexId, VertexKind};
use crate::pair::{FParallel, VParallel};
use crate::scalar::Field;
use crate::space::{Dual, ParabolicSphere, Plane, Point, TopView};

/// The circumscribed Gauss image of an i-conical mesh, and what its planes leave open.
#[derive(Clone, Debug)]
pub struct Circumscribed<'a, T: Field> {
    /// The mesh with its image.
    pub pair: FParallel<'a, T>,
    /// The vertices that were placed freely, in this order. The vertices that depend on them, and
    /// the curvatures of their faces, are those of one choice among many.
    pub free: Vec<VertexId>,
    /// Whether M determines the image of a vertex, whatever was chosen elsewhere.
    pub determined: Vec<bool>,
}

/// The circumscribed Gauss image of an i-conical mesh: the face planes are `z = p·x' − |p|²/2`, with
/// the gradients p of the faces of M (Theorem 2).
///
/// Three planes with gradients that are not collinear determine a vertex, which lies over the centre
/// of the circle of the gradients. Vertices of fewer planes, at the boundary or where M is flat, are
/// placed so that edges stay parallel; where this leaves a freedom (one for each side of a patch of
/// quads), a vertex is put over the mean of its gradients, or as near to that as its edges permit.
///
/// # Errors
/// A face that is not planar; a vertex that is not i-conical, with the residual; a vertex with
/// different gradients on a line.
pub fn circumscribed_f_parallel<T: Field>(
    mesh: &Mesh<T>,
) -> Result<Circumscribed<'_, T>, NoGaussImage<T>> {
    NoGaussImage::of_input(mesh, 0, 1)?;
    let topology = &mesh.topology;
    let mut planes: Vec<Vec<Plane<T>>> = vec![Vec::new(); topology.vertex_count()];
    for face in topology.faces() {
        let gradient = mesh.face_plane(face)?.gradient;
        let plane = ParabolicSphere::unit().tangent_plane(&gradient.dual());
        for v in topology.face(face) {
            let around = &mut planes[v.index()];
            if !around.contains(&plane) {
                around.push(plane.clone());
            }
        }
    }
    let neighbours = joined_vertices(topology);
    let mut placing = Placing { mesh, planes, neighbours, image: Vec::new() };
    for v in topology.vertices() {
        let point = placing.common_point(v)?;
        placing.image.push(point);
    }
    placing.place_determined((0..mesh.points.len()).collect());
    let determined = placing.image.iter().map(Option::is_some).collect();
    let free = placing.place_the_rest();
    let lone = mesh.points.iter().map(|p| ParabolicSphere::unit().contact_at(&p.top_view()).point);
    let points = placing.image.into_iter().zip(lone).map(|(s, lone)| s.unwrap_or(lone)).collect();
    let image = Mesh { topology: topology.clone(), points, data: Data::default() };
    Ok(Circumscribed { pair: FParallel::owning(mesh, image)?, free, determined })
}

struct Placing<'a, T> {
    mesh: &'a Mesh<T>,
    /// The different planes at each vertex.
    planes: Vec<Vec<Plane<T>>>,
    neighbours: Neighbours,
    image: Vec<Option<Point<T>>>,
}

impl<T: Field> Placing<'_, T> {
    /// The common point of the planes at a vertex, if they determine one: the dual of the plane
    /// through their poles.
    fn common_point(&self, vertex: VertexId) -> Result<Option<Point<T>>, NoGaussImage<T>> {
        let [a, b, rest @ ..] = self.planes[vertex.index()].as_slice() else {
            return Ok(None);
        };
        let (first, second) = (a.dual(), b.dual());
        let spanned = rest.iter().find_map(|c| Plane::through(&first, &second, &c.dual()).ok());
        let Some(spanned) = spanned else {
            return if rest.is_empty() { Ok(None) } else { Err(NoGaussImage::AtInfinity(vertex)) };
        };
        let point = spanned.dual();
        match rest.iter().map(|c| c.residual(&point)).find(|r| !r.is_zero()) {
            None => Ok(Some(point)),
            Some(residual) => Err(NoGaussImage::NotConical { vertex, residual }),
        }
    }

    /// Places the vertices that their neighbours determine, from those of the queue on.
    fn place_determined(&mut self, mut queue: VecDeque<usize>) {
        while let Some(v) = queue.pop_front() {
            if self.image[v].is_none() {
                self.image[v] = self.determined(v);
                if self.image[v].is_some() {
                    queue.extend(self.neighbours[v].iter().map(|&(w, _)| w));
                }
            }
        }
    }

    /// Places all vertices that are left, one of them freely wherever nothing is determined; returns
    /// these.
    fn place_the_rest(&mut self) -> Vec<VertexId> {
        let count = self.image.len();
        let mut free = Vec::new();
        // Vertices on a line of two planes, then those in one plane.
        let order = |k: usize| (0..count).map(move |v| (k, v));
        let mut choices: VecDeque<(usize, usize)> = order(2).chain(order(1)).collect();
        loop {
            let open =
                |&(k, v): &(usize, usize)| self.image[v].is_none() && self.planes[v].len() == k;
            let Some(next) = choices.iter().position(open) else {
                return free;
            };
            let (_, v) = choices[next];
            choices.drain(..=next);
            self.image[v] = self.chosen(v);
            free.push(VertexId(v as u32));
            self.place_determined(self.neighbours[v].iter().map(|&(w, _)| w).collect());
        }
    }

    /// The point of a vertex from its planes and the directions to neighbours that are placed.
    fn determined(&self, v: usize) -> Option<Point<T>> {
        let lines = || {
            self.neighbours[v].iter().filter_map(move |&(u, _)| {
                Some((self.image[u].as_ref()?, &self.mesh.points[v] - &self.mesh.points[u]))
            })
        };
        match self.planes[v].as_slice() {
            [plane] => {
                let (s, d) = lines().next()?;
                lines().find_map(|(other, e)| {
                    let between = &other.top_view() - &s.top_view();
                    let e = e.top_view();
                    let factor = between.det(&e).try_div(&d.top_view().det(&e))?;
                    Some(plane.point_at(&(&s.top_view() + &d.top_view().scaled(&factor))))
                })
            }
            planes => lines().find_map(|(s, d)| {
                planes.iter().find_map(|plane| {
                    let rate = &d.z - plane.gradient.along(&d.top_view());
                    let factor = (-plane.residual(s)).try_div(&rate)?;
                    let at = &s.top_view() + &d.top_view().scaled(&factor);
                    Some(plane.point_at(&at))
                })
            }),
        }
    }

    /// A point on the planes of a vertex near the mean of their points of contact.
    fn chosen(&self, v: usize) -> Option<Point<T>> {
        match self.planes[v].as_slice() {
            [plane] => {
                let contact = plane.gradient.dual();
                let line = self.neighbours[v].iter().find_map(|&(u, _)| {
                    let d = (&self.mesh.points[v] - &self.mesh.points[u]).top_view();
                    let s = self.image[u].as_ref()?.top_view();
                    let factor = (&contact - &s).dot(&d).try_div(&d.length2())?;
                    Some(&s + &d.scaled(&factor))
                });
                Some(plane.point_at(&line.unwrap_or(contact)))
            }
            [plane, other] => {
                let to_other = &other.gradient - &plane.gradient;
                let middle = &plane.gradient.dual() + &to_other.scaled(&T::from_ratio(1, 2));
                Some(plane.point_at(&middle))
            }
            _ => None,
        }
    }
}

/// A circumscribed Gauss image with the same top view (Theorem 2).
///
/// The face `face` touches Σ over `start`. Two planes that touch Σ and meet over a line of the top
/// view have contact points that are mirror images at that line; so one contact point determines
/// all. The plane through `x'` then gives the heights.
///
/// A planar mesh whose interior vertices are i-conical of even valence, without coplanar faces at
/// an edge, has one for every start, if it is simply connected: this is
/// [`inscribed_f_parallel`](super::inscribed_f_parallel()) for the dual. The heights of M do not
/// enter.
///
/// # Errors
/// A vertex that does not close, with the gap; a cycle of faces around a hole that does not close; a
/// vertical edge; a face of M that is not planar.
pub fn circumscribed_v_parallel<'a, T: Field>(
    mesh: &'a Mesh<T>,
    face: FaceId,
    start: &TopView<T>,
) -> Result<VParallel<'a, T>, NoGaussImage<T>> {
    let topology = &mesh.topology;
    NoGaussImage::of_input(mesh, face.0, topology.face_count())?;
    let mirror = |contact: &TopView<T>, h| {
        let (v, w) = (topology.origin(h), topology.target(h));
        let [a, b] = [v, w].map(|v| mesh.points[v.index()].top_view());
        reflected(contact, &a, &b).ok_or(NoGaussImage::VerticalEdge(v, w))
    };
    let found = spread(&joined_faces(topology), face.index(), start, |contact, _, _, h| {
        mirror(contact, h)
    })?;
    let at = |f: FaceId| &found.values[f.index()];
    for vertex in topology.vertices().filter(|&v| topology.kind(v) == VertexKind::Interior) {
        let star: Vec<_> = topology.star(vertex).collect();
        let Some(&first) = star.first() else { continue };
        let first = at(topology.face_at(first));
        let mut contact = first.clone();
        for &h in star.iter().skip(1).chain(star.first()) {
            contact = mirror(&contact, h)?;
        }
        if contact != *first {
            return Err(NoGaussImage::VertexOpen { vertex, residual: &contact - first });
        }
    }
    for h in topology.edges() {
        let Some(twin) = topology.twin(h) else { continue };
        let (f, g) = (topology.face_at(h), topology.face_at(twin));
        if mirror(at(f), h)? != *at(g) {
            let cycle = found.cycle(f.index(), g.index());
            let cycle = cycle.into_iter().map(|i| FaceId(i as u32)).collect();
            return Err(NoGaussImage::FaceCycleOpen(cycle));
        }
    }
    let sigma = ParabolicSphere::unit();
    let mut points: Vec<Point<T>> =
        mesh.points.iter().map(|p| sigma.contact_at(&p.top_view()).point).collect();
    for f in topology.faces() {
        let plane = sigma.tangent_plane(at(f));
        for v in topology.face(f) {
            points[v.index()] = plane.point_at(&mesh.points[v.index()].top_view());
        }
    }
    let image = Mesh { topology: topology.clone(), points, data: Data::default() };
    Ok(VParallel::owning(mesh, image)?)
}

/// The mirror image at the line through two points; `None` if they agree.
fn reflected<T: Field>(at: &TopView<T>, a: &TopView<T>, b: &TopView<T>) -> Option<TopView<T>> {
    let normal = (b - a).turned();
    let factor = (T::from_i64(2) * normal.dot(&(a - at))).try_div(&normal.length2())?;
    Some(at + &normal.scaled(&factor))
}
