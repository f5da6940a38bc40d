//! Meshes with something degenerate, or almost.

use proptest::prelude::*;
use proptest::sample::Index;

use crate::mesh::{FaceId, Mesh, VertexId};
use crate::scalar::{Numeral, RationalField};
use crate::space::Point;

/// What is done to a mesh; each names vertices or a face by numbers that are taken modulo their count.
#[derive(Clone, Debug)]
enum Change {
    /// All coordinates are rounded to doubles.
    Doubles,
    /// A coordinate is rounded to a double, then moved on to the next.
    UnitInTheLastPlace(Index, Index, bool),
    /// A vertex moves into the middle between its neighbours in a face.
    Collinear(Index, Index),
    /// A vertex gets the top view of its neighbour in a face.
    SameTopView(Index, Index),
    /// A vertex moves onto its neighbour in a face.
    SamePoint(Index, Index),
    /// All corners of a face get the same x-coordinate: its plane becomes vertical, its area 0.
    Vertical(Index),
    /// All corners of a face move onto the line of the first two.
    ZeroArea(Index),
}

fn change() -> impl Strategy<Value = Change> {
    let index = any::<Index>;
    prop_oneof![
        Just(Change::Doubles),
        (index(), index(), any::<bool>())
            .prop_map(|(v, c, up)| Change::UnitInTheLastPlace(v, c, up)),
        (index(), index()).prop_map(|(f, i)| Change::Collinear(f, i)),
        (index(), index()).prop_map(|(f, i)| Change::SameTopView(f, i)),
        (index(), index()).prop_map(|(f, i)| Change::SamePoint(f, i)),
        index().prop_map(Change::Vertical),
        index().prop_map(Change::ZeroArea),
    ]
}

/// Meshes from a strategy with up to two things made degenerate, or almost: coordinates rounded to
/// doubles, or one unit in the last place off; collinear corners, equal top views, equal points,
/// vertical faces, faces of area 0.
///
/// Residuals are then 0 where nobody expects it, or as small as doubles get without being 0.
pub fn near_degenerate<Q: RationalField>(
    meshes: impl Strategy<Value = Mesh<Q>>,
) -> impl Strategy<Value = Mesh<Q>> {
    (meshes, prop::collection::vec(change(), 0..=2)).prop_map(|(mut mesh, changes)| {
        changes.iter().for_each(|change| change.apply(&mut mesh));
        mesh
    })
}

impl Change {
    fn apply<Q: RationalField>(&self, mesh: &mut Mesh<Q>) {
        if mesh.topology.face_count() == 0 {
            return;
        }
        let (topology, points) = (&mesh.topology, &mut mesh.points);
        let face = |index: &Index| topology.face(FaceId(index.index(topology.face_count()) as u32));
        // A corner of a face with the one before and the one after it.
        let corner = |face: &[VertexId], index: &Index| {
            let (k, i) = (face.len(), index.index(face.len()));
            [(i + k - 1) % k, i, (i + 1) % k].map(|i| face[i].index())
        };
        match self {
            Change::Doubles => {
                points.iter_mut().for_each(|p| *p = p.map(|c| double(c, 0)));
            }
            Change::UnitInTheLastPlace(v, coordinate, up) => {
                let v = v.index(points.len());
                let [x, y, z] = points[v].coordinates().map(Q::clone);
                let mut moved = [x, y, z];
                let c = &mut moved[coordinate.index(3)];
                *c = double(c, if *up { 1 } else { -1 });
                let [x, y, z] = moved;
                points[v] = Point::new(x, y, z);
            }
            Change::Collinear(f, i) => {
                let [before, at, after] = corner(face(f), i);
                let half = (&points[after] - &points[before]).scaled(&Q::from_ratio(1, 2));
                points[at] = &points[before] + &half;
            }
            Change::SameTopView(f, i) => {
                let [before, at, _] = corner(face(f), i);
                points[at] = points[before].top_view().at_height(points[at].z.clone());
            }
            Change::SamePoint(f, i) => {
                let [before, at, _] = corner(face(f), i);
                points[at] = points[before].clone();
            }
            Change::Vertical(f) => {
                let corners = face(f);
                let x = points[corners[0].index()].x.clone();
                corners.iter().for_each(|v| points[v.index()].x = x.clone());
            }
            Change::ZeroArea(f) => {
                let corners = face(f);
                let (a, b) =
                    (points[corners[0].index()].clone(), points[corners[1].index()].clone());
                for (v, n) in corners.iter().zip(0..) {
                    points[v.index()] = &a + &(&b - &a).scaled(&Q::from_i64(n));
                }
            }
        }
    }
}

/// The double nearest to a number, or the one after or before it; a number beyond the range of
/// doubles is what it is.
fn double<Q: RationalField>(value: &Q, step: i64) -> Q {
    let near = value.to_f64();
    let near = match step {
        0 => near,
        1 => near.next_up(),
        _ => near.next_down(),
    };
    Numeral::from_f64(near).map_or_else(|| value.clone(), |numeral| numeral.value())
}
