//! Gauss images with their vertices on the unit i-sphere Σ (Theorem 1).

use super::NoGaussImage;
use super::spread::{joined_vertices, spread};
use crate::mesh::{Data, FaceId, Mesh, NoPlane, VertexId};
use crate::pair::{FParallel, Misfit, VParallel};
use crate::scalar::Field;
use crate::space::{Dual, ParabolicSphere, Point, TopView, Vector3};

/// The lift to Σ: the same top views, with the heights `|x'|²/2`.
///
/// Every mesh has one. Its faces are planar iff the faces of the mesh have concyclic top views.
pub fn lift<T: Field>(mesh: &Mesh<T>) -> Mesh<T> {
    let points = mesh.points.iter().map(|p| on_sigma(&p.top_view())).collect();
    Mesh { topology: mesh.topology.clone(), points, data: Data::default() }
}

/// The inscribed Gauss image with the same top view: the [`lift`], as a checked pair.
///
/// It exists for planar i-circular meshes and for all triangle meshes without vertical faces, and
/// is unique (Theorem 1).
///
/// # Errors
/// [`Misfit::Plane`] with the first face of M or of the lift that has no plane.
pub fn inscribed_v_parallel<T: Field>(mesh: &Mesh<T>) -> Result<VParallel<'_, T>, Misfit<T>> {
    VParallel::owning(mesh, lift(mesh))
}

/// An inscribed Gauss image with parallel edges and face planes (Theorem 1).
///
/// The image of one vertex is the point of Σ over `start`. From a point `s` the line in the
/// direction `d` of an edge meets Σ a second time in `s + λ d` with `λ = 2 (d₃ − s'·d')/|d'|²`, which
/// is rational; so the image of one vertex determines all.
///
/// In the top view such a step is the reflection at the line through the gradient of the face,
/// across the edge; around a face with an odd number of sides they make up a reflection again, and
/// only starts over its line close.
///
/// A planar i-circular mesh whose faces have an even number of sides has one for every start, if it
/// is simply connected. With the start over the gradient of a face that face becomes a point. Meshes
/// of several components start anew, from the first vertex of each and the same point.
///
/// # Errors
/// A face that does not close, with the gap; a cycle around a hole that does not close; a vertical
/// edge; a face of M that is not planar.
///
/// ```
/// use isogeo::construct::{inscribed_f_parallel, translational_net};
/// use isogeo::mesh::VertexId;
/// use isogeo::scalar::{Rational, Ring};
/// use isogeo::space::TopView;
/// let q = |n: i64| Rational::from_i64(n);
/// let m = translational_net(&[(q(0), q(0)), (q(1), q(3))], &[(q(0), q(0)), (q(1), q(5))])?;
/// let pair = inscribed_f_parallel(&m, VertexId(0), &TopView::new(q(1), q(1)));
/// let corners: Vec<_> = pair.iter().flat_map(|p| &p.image().points).map(|p| p.top_view()).collect();
/// // A rectangle around the gradient (3, 5).
/// assert_eq!(corners[3], TopView::new(q(5), q(9)));
/// # Ok::<(), isogeo::mesh::TopologyError>(())
/// ```
pub fn inscribed_f_parallel<'a, T: Field>(
    mesh: &'a Mesh<T>,
    vertex: VertexId,
    start: &TopView<T>,
) -> Result<FParallel<'a, T>, NoGaussImage<T>> {
    let topology = &mesh.topology;
    NoGaussImage::of_input(mesh, vertex.0, topology.vertex_count())?;
    let step = |s: &Point<T>, from: VertexId, to: VertexId| {
        let direction = &mesh.points[to.index()] - &mesh.points[from.index()];
        second_intersection(s, &direction).ok_or(NoGaussImage::VerticalEdge(from, to))
    };
    let found =
        spread(&joined_vertices(topology), vertex.index(), &on_sigma(start), |s, a, b, _| {
            step(s, VertexId(a as u32), VertexId(b as u32))
        })?;
    let at = |v: VertexId| &found.values[v.index()];
    let turn = |face: FaceId| {
        let mut edges = topology.half_edges(face).map(|h| (topology.origin(h), topology.target(h)));
        let first = topology.face(face).first().map(|&v| at(v))?;
        let end = edges.try_fold(first.clone(), |s, (v, w)| step(&s, v, w).ok())?;
        Some(&end - first)
    };
    let open = topology.faces().find_map(|face| {
        let residual = turn(face)?;
        let closed = [&residual.x, &residual.y, &residual.z].into_iter().all(T::is_zero);
        (!closed).then_some(NoGaussImage::FaceOpen { face, residual })
    });
    if let Some(error) = open {
        return Err(error);
    }
    for h in topology.edges() {
        let (v, w) = (topology.origin(h), topology.target(h));
        if step(at(v), v, w)? != *at(w) {
            let cycle = found.cycle(v.index(), w.index());
            let cycle = cycle.into_iter().map(|i| VertexId(i as u32)).collect();
            return Err(NoGaussImage::VertexCycleOpen(cycle));
        }
    }
    let image = Mesh { topology: topology.clone(), points: found.values, data: Data::default() };
    Ok(FParallel::owning(mesh, image)?)
}

/// A start for [`inscribed_f_parallel`]: the dual of the mean of the gradients of the faces at a
/// vertex.
///
/// The image of a vertex lies near the gradients around it. At a vertex of one face, or of parallel
/// ones, the mean is their own gradient, and these faces become points: another vertex is a better
/// one to start from.
///
/// # Errors
/// A face at the vertex without a plane; `None` at a vertex of no face.
///
/// ```
/// use isogeo::construct::{mean_gradient, translational_net};
/// use isogeo::mesh::VertexId;
/// use isogeo::space::TopView;
/// let wave = [(-1.0, 1.0), (0.0, 0.0), (3.0, 6.0)]; // slopes −1 and 2
/// let m = translational_net(&wave, &wave)?;
/// assert_eq!(mean_gradient(&m, VertexId(4)), Ok(Some(TopView::new(0.5, 0.5))));
/// # Ok::<(), isogeo::mesh::TopologyError>(())
/// ```
pub fn mean_gradient<T: Field>(
    mesh: &Mesh<T>,
    vertex: VertexId,
) -> Result<Option<TopView<T>>, NoPlane<T>> {
    let at_vertex = |&f: &FaceId| mesh.topology.face(f).contains(&vertex);
    let mut sum = TopView::new(T::zero(), T::zero());
    let mut count = 0;
    for face in mesh.topology.faces().filter(at_vertex) {
        sum = &sum + &mesh.face_plane(face)?.gradient.dual().position();
        count += 1;
    }
    let mean = |c: T| c.try_div(&T::from_i64(count));
    Ok(mean(sum.x).zip(mean(sum.y)).map(|(x, y)| TopView::new(x, y)))
}

/// The point of Σ over a top view.
fn on_sigma<T: Field>(at: &TopView<T>) -> Point<T> {
    at.at_height(ParabolicSphere::unit().height_at(at))
}

/// The other point of Σ on the line through one in a direction, the same for a tangent and for the
/// direction zero; `None` for an isotropic line.
fn second_intersection<T: Field>(s: &Point<T>, d: &Vector3<T>) -> Option<Point<T>> {
    let top_view = d.top_view();
    let Some(inverse) = top_view.length2().try_inv() else {
        return d.z.is_zero().then(|| s.clone());
    };
    let rise = &d.z - s.top_view().position().dot(&top_view);
    let factor = rise * inverse * T::from_i64(2);
    let step = Vector3::new(&factor * &d.x, &factor * &d.y, &factor * &d.z);
    Some(s + &step)
}
