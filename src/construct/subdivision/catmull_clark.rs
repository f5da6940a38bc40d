//! The scheme of Catmull and Clark for faces of any size, with boundary, corners and creases.

use std::collections::BTreeSet;
use std::fmt;

use super::{mix, spline};
use crate::mesh::{Data, FaceId, FaceList, HalfEdge, Mesh, Topology, TopologyError};
use crate::mesh::{VertexId, VertexKind};
use crate::scalar::Field;
use crate::space::Point;

/// What stays sharp in a subdivision; by default only the boundary, which is smoothed as a curve.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Sharp {
    /// Edges that are treated as the boundary is, each by its vertices in either order.
    pub creases: BTreeSet<[VertexId; 2]>,
    /// Whether boundary vertices of a single face stay where they are: "Keep Corners" in Blender,
    /// whose default it is, too, to smooth them ("All").
    pub keep_corners: bool,
}

/// Why a mesh is not subdivided.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoSubdivision {
    /// A crease that is no edge of the mesh.
    NoSuchEdge([VertexId; 2]),
    /// The refined mesh cannot be counted with 32 bits.
    Topology(TopologyError),
}

impl fmt::Display for NoSubdivision {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoSubdivision::NoSuchEdge([a, b]) => {
                write!(f, "there is no edge between vertices {} and {}", a.0, b.0)
            }
            NoSubdivision::Topology(error) => write!(f, "the refined mesh is none: {error}"),
        }
    }
}

impl std::error::Error for NoSubdivision {}

impl From<TopologyError> for NoSubdivision {
    fn from(error: TopologyError) -> Self {
        NoSubdivision::Topology(error)
    }
}

/// One step of Catmull and Clark, and what is sharp in the refined mesh.
///
/// - Every face gives the mean `F` of its vertices.
/// - An edge between `a` and `b` gives `(a + b + F₁ + F₂)/4`; a sharp one, of the boundary or a
///   crease, gives `(a + b)/2`.
/// - A vertex `v` in `n` faces goes to `(Q + 2R + (n − 3) v)/n`, with the mean Q of the new points of
///   its faces and the mean R of the midpoints of its edges. With two sharp edges, to `a` and `b`, it
///   goes to `(a + 6v + b)/8`, so that sharp curves are cubic B-splines that nothing beside them
///   moves. With one it follows the first rule (the crease ends there), with more it stays; so do
///   pinched and isolated vertices.
///
/// Vertices: the old ones, then one for every edge in the order of [`Topology::edges`], then one for
/// every face. Faces: a quad for every corner of every face in order; it starts at the old vertex and
/// ends with the edge that comes before. Data on elements are left out.
///
/// ```
/// use isogeo::construct::{quad_patch, subdivision::{Sharp, catmull_clark}};
/// use isogeo::mesh::Mesh;
/// use isogeo::space::Point;
/// let square = [(0.0, 0.0), (0.0, 8.0), (8.0, 0.0), (8.0, 8.0)];
/// let mesh = Mesh::new(square.map(|(x, y)| Point::new(x, y, 1.0)).to_vec(), quad_patch(1, 1))?;
/// let (smooth, _) = catmull_clark(&mesh, &Sharp::default())?;
/// assert_eq!(smooth.points[0], Point::new(1.0, 1.0, 1.0)); // the corner (0, 0) is smoothed
/// let (kept, _) = catmull_clark(&mesh, &Sharp { keep_corners: true, ..Sharp::default() })?;
/// assert_eq!(kept.points[0], mesh.points[0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// A crease that is no edge; more than 32 bits can count. Source: Catmull and Clark (1978), with the
/// usual rules for sharp edges.
pub fn catmull_clark<T: Field>(
    mesh: &Mesh<T>,
    sharp: &Sharp,
) -> Result<(Mesh<T>, Sharp), NoSubdivision> {
    let Mesh { topology, points, .. } = mesh;
    let faces = refined_faces(topology)?;
    let is_crease = creases(topology, sharp)?;
    let at = |v: VertexId| &points[v.index()];

    let face_point = |f: FaceId| {
        let corners = topology.face(f);
        mix(corners.len() as i64, corners.iter().map(|&v| (1, at(v))))
    };
    let face_points: Vec<Point<T>> = topology.faces().map(face_point).collect();
    let beside = |h: HalfEdge| &face_points[topology.face_at(h).index()];

    // The other ends of the sharp edges at every vertex.
    let mut sharp_ends = vec![Vec::new(); points.len()];
    let mut edge_points = Vec::with_capacity(topology.edge_count());
    let mut refined = Sharp { keep_corners: sharp.keep_corners, ..Sharp::default() };
    for (h, crease) in topology.edges().zip(is_crease) {
        let [a, b] = [topology.origin(h), topology.target(h)];
        let middle = VertexId((points.len() + edge_points.len()) as u32);
        edge_points.push(match topology.twin(h) {
            Some(twin) if !crease => {
                mix(4, [(1, at(a)), (1, at(b)), (1, beside(h)), (1, beside(twin))])
            }
            _ => mix(2, [(1, at(a)), (1, at(b))]),
        });
        if crease {
            refined.creases.extend([[a, middle], [middle, b]]);
        }
        if crease || topology.twin(h).is_none() {
            sharp_ends[a.index()].push(b);
            sharp_ends[b.index()].push(a);
        }
    }

    let vertex_point = |v: VertexId| {
        let is_corner = topology.kind(v) == VertexKind::Boundary && topology.star(v).count() == 1;
        match (topology.kind(v), &sharp_ends[v.index()][..]) {
            (VertexKind::Isolated | VertexKind::Pinched, _) => at(v).clone(),
            (_, [_, _]) if is_corner && sharp.keep_corners => at(v).clone(),
            (_, [a, b]) => spline(at(*a), at(v), at(*b)),
            (_, [_, _, _, ..]) => at(v).clone(),
            // 2R = v + the mean of the neighbours.
            (_, [] | [_]) => {
                let n = topology.star(v).count() as i64;
                let around = topology.star(v).flat_map(|h| [beside(h), at(topology.target(h))]);
                mix(n * n, around.map(|p| (1, p)).chain([(n * (n - 2), at(v))]))
            }
        }
    };
    let moved = topology.vertices().map(vertex_point);
    let points = moved.chain(edge_points).chain(face_points.iter().cloned()).collect::<Vec<_>>();
    let topology = Topology::new(points.len(), faces)?;
    Ok((Mesh { topology, points, data: Data::default() }, refined))
}

/// A quad for every half-edge: its origin, its midpoint, the middle of its face, the midpoint before.
fn refined_faces(topology: &Topology) -> Result<FaceList, TopologyError> {
    let (vertices, edges) = (topology.vertex_count(), topology.edge_count());
    let all = vertices + edges + topology.face_count();
    if all.max(4 * topology.corner_count()) >= u32::MAX as usize {
        return Err(TopologyError::TooLarge);
    }
    let mut middles = vec![0u32; topology.corner_count()];
    for (h, middle) in topology.edges().zip(vertices as u32..) {
        middles[h.0 as usize] = middle;
        if let Some(twin) = topology.twin(h) {
            middles[twin.0 as usize] = middle;
        }
    }
    let middle = |h: HalfEdge| middles[h.0 as usize];
    let mut faces = FaceList::new();
    for f in topology.faces() {
        let centre = (vertices + edges) as u32 + f.0;
        for h in topology.half_edges(f) {
            faces.push([topology.origin(h).0, middle(h), centre, middle(topology.prev(h))]);
        }
    }
    Ok(faces)
}

/// For every edge whether it is a crease.
fn creases(topology: &Topology, sharp: &Sharp) -> Result<Vec<bool>, NoSubdivision> {
    let mut missing: BTreeSet<[VertexId; 2]> = sharp.creases.clone();
    let found = topology.edges().map(|h| {
        let [a, b] = [topology.origin(h), topology.target(h)];
        // Not lazily: the edge may be named in both orders.
        missing.remove(&[a, b]) | missing.remove(&[b, a])
    });
    let found = found.collect();
    match missing.pop_first() {
        Some(edge) => Err(NoSubdivision::NoSuchEdge(edge)),
        None => Ok(found),
    }
}
