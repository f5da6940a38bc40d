//! From edge-offset meshes of Euclidean space back to i-isothermic ones: cones to incircles.

use super::{AXIS_DATA, NoTransfer};
use crate::construct::spread::{joined_vertices, spread};
use crate::mesh::{Data, FaceId, Mesh, NoPlane, VertexId};
use crate::net::RADIUS;
use crate::scalar::{Field, RationalField};
use crate::space::laguerre::Cone;
use crate::space::{ICircle, OrientedCircle, Plane, Point, Vector3};

/// The i-isothermic mesh M with τ(M) = N, of an edge-offset mesh N with the axes of the cones at its
/// vertices: faces of N become vertices with the signed radii of their circles as data, interior
/// vertices of N become faces.
///
/// Cones become i-circles with the centre c, `N = |c|² − ρ²` and the height g₃ (see
/// [`Cone::to_isotropic`]). Around a face of N all are orthogonal to the circle of the vertex v:
/// `N = 2 v'·c − n` with `n = |v'|² − r²`, which determines v' and n; and they lie in planes through v, so
/// `2v₁g₁ + 2v₂g₂ + (1 − n)g₃ + 2v₃ = 0` for the vertices g of the face. The points of N alone determine the
/// axes only up to finitely many choices, see [`edge_offset`](crate::net::edge_offset), and in general
/// not in fractions; so they are asked for.
///
/// Radii are known up to a common sign in each component; that of its first vertex is not negative.
///
/// # Errors
/// A face of N or of its Gauss image that is not planar, or the two not parallel; circles that do not
/// touch; a radius that is no fraction; a plane with the normal (0, 0, −1); dual combinatorics that are
/// no mesh.
pub fn isothermic_image<Q: RationalField>(
    mesh: &Mesh<Q>,
    axes: &[Vector3<Q>],
) -> Result<Mesh<Q>, NoTransfer<Q>> {
    if axes.len() != mesh.points.len() {
        return Err(NoTransfer::NoAxes);
    }
    let half = Q::from_ratio(1, 2);
    let pole = |v: VertexId| {
        let cone = Cone { vertex: mesh.points[v.index()].clone(), axis: axes[v.index()].clone() };
        let ICircle { top_view, .. } = cone.to_isotropic().map_err(|_| NoTransfer::SouthCone(v))?;
        let height = (top_view.centre.norm2() - top_view.radius2) * &half;
        Ok(top_view.centre.at_height(height))
    };
    let poles = mesh.topology.vertices().map(pole).collect::<Result<Vec<_>, NoTransfer<Q>>>()?;
    let poles = Mesh { topology: mesh.topology.clone(), points: poles, data: Data::default() };
    let found = mesh.topology.faces().map(|face| centre(mesh, &poles, face));
    let (points, radii2): (Vec<_>, Vec<_>) =
        found.collect::<Result<Vec<_>, NoTransfer<Q>>>()?.into_iter().unzip();
    let image = Mesh { topology: mesh.topology.dual()?.topology, points, data: Data::default() };
    signed(image, &radii2)
}

/// The vertex of M that belongs to a face of N, and its squared radius.
fn centre<Q: RationalField>(
    mesh: &Mesh<Q>,
    poles: &Mesh<Q>,
    face: FaceId,
) -> Result<(Point<Q>, Q), NoTransfer<Q>> {
    let (two, half) = (Q::from_i64(2), Q::from_ratio(1, 2));
    // N/2 = v'·c − n/2.
    let Plane { gradient, height } = poles.face_plane(face).map_err(|reason| match reason {
        NoPlane::NotPlanar { face, residual } => NoTransfer::NotEdgeOffset { face, residual },
        reason => reason.into(),
    })?;
    let n = -(height * &two);
    let level = |v: &VertexId| {
        let Point { x, y, z } = &mesh.points[v.index()];
        let along = Q::dot([&gradient.x, &gradient.y], [x, y]);
        -(along + (Q::one() - &n) * z * &half)
    };
    let mut levels = mesh.topology.face(face).iter().map(level);
    let height = levels.next().unwrap_or_else(Q::zero);
    if let Some(residual) = levels.map(|z| z - &height).find(|gap| !gap.is_zero()) {
        return Err(NoTransfer::NotEdgeOffset { face, residual });
    }
    let radius2 = Q::dot([&gradient.x, &gradient.y], [&gradient.x, &gradient.y]) - n;
    Ok((Point::new(gradient.x, gradient.y, height), radius2))
}

/// The mesh with radii whose circles touch along its edges.
fn signed<Q: RationalField>(mut mesh: Mesh<Q>, radii2: &[Q]) -> Result<Mesh<Q>, NoTransfer<Q>> {
    let root = |(i, radius2): (usize, &Q)| {
        radius2.root().ok_or(NoTransfer::IrrationalRadius {
            face: FaceId(i as u32),
            radius2: radius2.clone(),
        })
    };
    let sizes = radii2.iter().enumerate().map(root).collect::<Result<Vec<_>, _>>()?;
    let circle = |v: usize, radius| OrientedCircle { centre: mesh.points[v].top_view(), radius };
    let residual = |a: (usize, &Q), b: (usize, &Q)| {
        circle(a.0, a.1.clone()).tangency(&circle(b.0, b.1.clone()))
    };
    let turned = |turn: bool, v: usize| if turn { -&sizes[v] } else { sizes[v].clone() };
    let touch = |&turn: &bool, a: usize, b: usize, _| {
        let radius = turned(turn, a);
        let fits = |&other: &bool| residual((a, &radius), (b, &turned(other, b))).is_zero();
        [turn, !turn].into_iter().find(fits).ok_or_else(|| NoTransfer::NotTouching {
            edge: [VertexId(a as u32), VertexId(b as u32)],
            residual: residual((a, &radius), (b, &turned(turn, b))),
        })
    };
    let signs = spread(&joined_vertices(&mesh.topology), 0, &false, touch)?.values;
    let radii: Vec<Q> = signs.iter().enumerate().map(|(v, &turn)| turned(turn, v)).collect();
    for h in mesh.topology.edges() {
        let edge = [mesh.topology.origin(h), mesh.topology.target(h)];
        let [a, b] = edge.map(|v| (v.index(), &radii[v.index()]));
        let residual = residual(a, b);
        if !residual.is_zero() {
            return Err(NoTransfer::NotTouching { edge, residual });
        }
    }
    mesh.data.vertex.insert(RADIUS.to_owned(), radii);
    Ok(mesh)
}

/// The axes of the cones that stand in the data of a mesh, or `None` if there are none.
pub fn stored_axes<T: Field>(mesh: &Mesh<T>) -> Option<Vec<Vector3<T>>> {
    let [x, y, z] = AXIS_DATA.map(|name| mesh.data.vertex.get(name));
    let columns = x?.iter().zip(y?).zip(z?);
    Some(columns.map(|((x, y), z)| Vector3::new(x.clone(), y.clone(), z.clone())).collect())
}
