//! The Christoffel dual of a planar quad mesh, by the ratios of its diagonals (Koenigs nets).

use super::{ChristoffelDual, NoChristoffelDual, cycle, integrated};
use crate::construct::spread::{Neighbours, spread};
use crate::mesh::{FaceId, HalfEdge, Mesh, NoPlane, Topology, VertexId};
use crate::scalar::Field;

/// `ν(v₂)/ν(v₀)` of the diagonal from the origin `v₀` of a half-edge of a quad `v₀ v₁ v₂ v₃`: the ratio
/// of the signed distances of `v₂` and `v₀` from the other diagonal; negative for convex quads.
///
/// `None` at faces that are no quads, or where one of the two corners lies on the other diagonal in
/// the top view.
pub fn diagonal_ratio<T: Field>(mesh: &Mesh<T>, h: HalfEdge) -> Option<T> {
    let topology = &mesh.topology;
    let corners = [h, topology.next(h), topology.next(topology.next(h)), topology.prev(h)];
    if topology.face(topology.face_at(h)).len() != 4 {
        return None;
    }
    let [a, b, c, d] = corners.map(|h| mesh.points[topology.origin(h).index()].top_view());
    let other = &d - &b;
    let (near, far) = ((&a - &b).det(&other), (&c - &b).det(&other));
    if far.is_zero() { None } else { far.try_div(&near) }
}

/// The Christoffel dual of a planar quad mesh with the edges `(v_j − v_i)/(ν_i ν_j)`, with ν = 1 at the
/// first vertex of every component of the diagonals.
///
/// It exists iff the product of the ratios of diagonals around every interior vertex is 1, and
/// around every hole and handle.
///
/// ```
/// use isogeo::construct::{christoffel_by_diagonals, translational_net};
/// use isogeo::scalar::{Rational, Ring};
/// let at = |x: i64| (Rational::from_i64(x), Rational::from_i64(x * x));
/// let net = translational_net(&[at(0), at(1), at(3)], &[at(0), at(1), at(2)])?;
/// let dual = christoffel_by_diagonals(&net).map(|dual| dual.mesh);
/// let twice = dual.and_then(|dual| christoffel_by_diagonals(&dual));
/// // Up to translation.
/// let first = net.points[8].clone();
/// assert_eq!(twice.map(|dual| dual.mesh.points[8].clone()), Ok(first));
/// # Ok::<(), isogeo::mesh::TopologyError>(())
/// ```
///
/// # Errors
/// See [`NoChristoffelDual`].
pub fn christoffel_by_diagonals<T: Field>(
    mesh: &Mesh<T>,
) -> Result<ChristoffelDual<T>, NoChristoffelDual<T>> {
    let topology = &mesh.topology;
    if mesh.points.len() != topology.vertex_count() {
        return Err(NoChristoffelDual::Counts);
    }
    for face in topology.faces() {
        if topology.face(face).len() != 4 {
            return Err(NoChristoffelDual::NoQuad(face));
        }
        match mesh.face_plane(face) {
            Err(NoPlane::NotPlanar { face, residual }) if T::EXACT => {
                return Err(NoChristoffelDual::NotPlanar { face, residual });
            }
            Err(NoPlane::NotAGraph(face)) => return Err(NoChristoffelDual::Degenerate(face)),
            _ => {}
        }
    }
    let ratio = |h: HalfEdge| {
        diagonal_ratio(mesh, h).ok_or(NoChristoffelDual::Degenerate(topology.face_at(h)))
    };
    let found = spread(&joined_by_diagonals(topology), 0, &T::one(), |factor, from, _, h| {
        let ratio = ratio(h)?;
        let forward = topology.origin(h).index() == from;
        let next = if forward { Some(factor * &ratio) } else { factor.try_div(&ratio) };
        next.ok_or(NoChristoffelDual::Degenerate(topology.face_at(h)))
    })?;
    let factors = found.values.as_slice();
    if T::EXACT {
        for vertex in topology.interior_vertices() {
            let product = topology.star(vertex).try_fold(T::one(), |product, h| {
                // The diagonal from the target of h to the next neighbour.
                Ok(product * ratio(topology.next(h))?)
            })?;
            if product != T::one() {
                return Err(NoChristoffelDual::VertexOpen { vertex, product });
            }
        }
        for h in topology.faces().flat_map(|f| diagonals(topology, f)) {
            let (a, b) = ends(topology, h);
            if &factors[a] * ratio(h)? != factors[b] {
                return Err(NoChristoffelDual::VertexCycle(cycle(found.cycle(a, b))));
            }
        }
    }
    let inverse = |(i, factor): (usize, &T)| {
        factor.try_inv().ok_or(NoChristoffelDual::ZeroRadius(VertexId(i as u32)))
    };
    let factors: Vec<T> = factors.iter().enumerate().map(inverse).collect::<Result<_, _>>()?;
    let dual = integrated(mesh, |h| {
        &factors[topology.origin(h).index()] * &factors[topology.target(h).index()]
    })?;
    Ok(ChristoffelDual { mesh: dual, factors })
}

/// The half-edges that the two diagonals of a quad start with.
fn diagonals(topology: &Topology, face: FaceId) -> impl Iterator<Item = HalfEdge> + use<> {
    topology.half_edges(face).take(2)
}

/// The ends of the diagonal from the origin of a half-edge of a quad.
fn ends(topology: &Topology, h: HalfEdge) -> (usize, usize) {
    (topology.origin(h).index(), topology.target(topology.next(h)).index())
}

/// The vertices joined by diagonals, each with the half-edge that the diagonal starts with.
fn joined_by_diagonals(topology: &Topology) -> Neighbours {
    let mut neighbours = vec![Vec::new(); topology.vertex_count()];
    for h in topology.faces().flat_map(|f| diagonals(topology, f)) {
        let (a, b) = ends(topology, h);
        neighbours[a].push((b, h));
        neighbours[b].push((a, h));
    }
    neighbours
}
