//! The scheme of Catmull and Clark on the planes of faces, by way of the metric dual.

use std::fmt;

use super::{NoSubdivision, Sharp, catmull_clark, mix, spline};
use crate::mesh::{Data, FaceId, FaceList, HalfEdge, Mesh, Topology, TopologyError};
use crate::mesh::{VertexId, VertexKind};
use crate::scalar::Field;
use crate::space::{Dual, Plane, Point};

/// Why the planes of a mesh are not subdivided.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoPlaneSubdivision {
    /// A vertical face, or one with collinear points.
    Vertical(FaceId),
    /// The four new planes about a corner determine no point: their gradients are collinear. So it
    /// is where K = 0.
    NoPoint {
        /// The vertex.
        vertex: VertexId,
        /// The face with this corner.
        face: FaceId,
    },
    /// The dual combinatorics form no mesh; faces are interior vertices of the mesh here.
    Dual(TopologyError),
    /// The dual, or the refined mesh, cannot be counted with 32 bits.
    Refinement(NoSubdivision),
}

impl fmt::Display for NoPlaneSubdivision {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoPlaneSubdivision::Vertical(face) => {
                write!(f, "face {} is vertical or collinear, so its plane has no pole", face.0)
            }
            NoPlaneSubdivision::NoPoint { vertex, face } => write!(
                f,
                "the new planes at vertex {} of face {} determine no point: K = 0 there",
                vertex.0, face.0
            ),
            NoPlaneSubdivision::Dual(error) => {
                write!(f, "the dual combinatorics form no mesh: {error}")
            }
            NoPlaneSubdivision::Refinement(reason) => reason.fmt(f),
        }
    }
}

impl std::error::Error for NoPlaneSubdivision {}

impl From<NoSubdivision> for NoPlaneSubdivision {
    fn from(reason: NoSubdivision) -> Self {
        NoPlaneSubdivision::Refinement(reason)
    }
}

/// One step of Catmull and Clark on the planes of faces: where i-conical meshes with `K ≠ 0` are
/// refined, as [`catmull_clark`] refines i-circular ones.
///
/// The poles of the face planes are the vertices of the metric dual; that is refined, and its quads
/// lead back: each stands for four planes about a corner of the mesh, a new one for the face, the edge,
/// the vertex and the other edge. The corner goes to their common point. Where planes do not meet,
/// it goes to the point with the least sum of squared vertical distances from them; in the same sense a
/// face that is not planar has the plane nearest to its points. In translational nets
/// `z = f(x) + g(y)` the planes do meet, and the new faces inside are planar.
///
/// The dual has no faces for vertices of the boundary. There points are refined instead, by the scheme
/// that belongs to these combinatorics (Doo and Sabin): a corner at a boundary edge from `v` to `w`
/// goes to `(3v + w)/4`, so that the boundary becomes a quadratic B-spline; a corner of a single face
/// stays if `keep_corners`, else it goes to `(a + 6v + b)/8`; other corners at the boundary go to
/// `(3v + m)/4` with the mean m of their face.
///
/// Vertices: one for every corner of every face, in order. Faces: the old ones, then a quad for every
/// interior edge in the order of [`Topology::edges`], then a face for every vertex with three faces or
/// more, with one corner in each of them; a pinched vertex has none. Data on elements are left out.
///
/// ```
/// use isogeo::construct::{subdivision::subdivide_planes, translational_net};
/// let profile: Vec<_> = (0..6).map(|i| (f64::from(i), f64::from(i * i))).collect();
/// let mesh = translational_net(&profile, &profile)?;
/// let fine = subdivide_planes(&mesh, false)?; // 5 × 5 faces, 2 · 4 · 5 interior edges, 4 × 4 vertices
/// assert_eq!(fine.topology.face_count(), 9 * 9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// See [`NoPlaneSubdivision`].
pub fn subdivide_planes<T: Field>(
    mesh: &Mesh<T>,
    keep_corners: bool,
) -> Result<Mesh<T>, NoPlaneSubdivision> {
    let Mesh { topology, points, .. } = mesh;
    let pole = |f: FaceId| {
        let corners: Vec<_> = topology.face(f).iter().map(|v| &points[v.index()]).collect();
        Ok(Plane::nearest(&corners).ok_or(NoPlaneSubdivision::Vertical(f))?.dual())
    };
    let poles = topology.faces().map(pole).collect::<Result<_, NoPlaneSubdivision>>()?;
    let dual = topology.dual().map_err(NoPlaneSubdivision::Dual)?.topology;
    let dual = Mesh { topology: dual, points: poles, data: Data::default() };
    let (fine, _) = catmull_clark(&dual, &Sharp::default())?;

    let all = topology.faces().flat_map(|f| topology.half_edges(f));
    let mut corners: Vec<Point<T>> =
        all.map(|h| boundary_corner(topology, points, h, keep_corners)).collect();
    // The quads stand in the order of the corners of the dual: one interior vertex after the other.
    let inside = topology.interior_vertices().flat_map(|v| topology.star(v));
    for (h, quad) in inside.zip(fine.topology.faces()) {
        let poles = fine.topology.face(quad).iter().map(|pole| &fine.points[pole.index()]);
        let plane =
            Plane::nearest(&poles.collect::<Vec<_>>()).ok_or(NoPlaneSubdivision::NoPoint {
                vertex: topology.origin(h),
                face: topology.face_at(h),
            })?;
        corners[h.0 as usize] = plane.dual();
    }
    let faces = refined_faces(topology);
    let topology = Topology::new(corners.len(), faces).map_err(NoSubdivision::from)?;
    Ok(Mesh { topology, points: corners, data: Data::default() })
}

/// Where a corner at the boundary goes.
fn boundary_corner<T: Field>(
    topology: &Topology,
    points: &[Point<T>],
    h: HalfEdge,
    keep: bool,
) -> Point<T> {
    let before = topology.prev(h);
    let at = |v: VertexId| &points[v.index()];
    let [a, v, b] = [topology.origin(before), topology.origin(h), topology.target(h)].map(at);
    match (topology.twin(before), topology.twin(h)) {
        (None, None) if keep => v.clone(),
        (None, None) => spline(a, v, b),
        (None, Some(_)) => mix(4, [(3, v), (1, a)]),
        (Some(_), None) => mix(4, [(3, v), (1, b)]),
        (Some(_), Some(_)) => {
            let face = topology.face(topology.face_at(h));
            let n = face.len() as i64;
            mix(4 * n, face.iter().map(|&w| (1, at(w))).chain([(3 * n, v)]))
        }
    }
}

/// The faces of Doo and Sabin: of old faces, of interior edges, of vertices.
fn refined_faces(topology: &Topology) -> FaceList {
    let mut faces = FaceList::new();
    for f in topology.faces() {
        faces.push(topology.half_edges(f).map(|h| h.0));
    }
    for h in topology.edges() {
        if let Some(twin) = topology.twin(h) {
            faces.push([topology.next(h).0, h.0, topology.next(twin).0, twin.0]);
        }
    }
    for v in topology.vertices() {
        let star: Vec<u32> = topology.star(v).map(|h| h.0).collect();
        if topology.kind(v) != VertexKind::Pinched && star.len() >= 3 {
            faces.push(star);
        }
    }
    faces
}
