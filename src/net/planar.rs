//! Planar meshes: all points of a face lie in one plane (Sec. 3.1).

use super::Judge;
use crate::check::{Answer, Decide, Failure, Outcome, Reason, Residual};
use crate::mesh::{FaceId, VertexId};
use crate::scalar::{Ring, Sign};
use crate::space::{Point, Vector3};

/// `det(p₁ − p₀, p₂ − p₀, p₃ − p₀)`: six times the volume of a tetrahedron, 0 iff the four points
/// are coplanar.
#[derive(Clone, Copy, Debug)]
pub struct Coplanar;

impl Residual<4> for Coplanar {
    const TRANSLATES: bool = true;

    #[inline]
    fn eval<R: Ring>(self, [p, a, b, c]: &[Point<R>; 4], _: &R) -> R {
        Vector3::det(&(a - p), &(b - p), &(c - p))
    }
}

/// Twice the signed area of a triangle, projected along an axis; along z it is that of the top
/// view, positive if counter-clockwise.
#[derive(Clone, Copy, Debug)]
pub enum ProjectedArea {
    /// Seen along x.
    AlongX,
    /// Seen along y.
    AlongY,
    /// Seen along z, in the top view.
    TopView,
}

impl ProjectedArea {
    pub(super) const ALL: [ProjectedArea; 3] =
        [ProjectedArea::TopView, ProjectedArea::AlongX, ProjectedArea::AlongY];

    /// The coordinates that are seen.
    fn axes(self) -> [usize; 2] {
        match self {
            ProjectedArea::AlongX => [1, 2],
            ProjectedArea::AlongY => [2, 0],
            ProjectedArea::TopView => [0, 1],
        }
    }
}

impl Residual<3> for ProjectedArea {
    const TRANSLATES: bool = true;

    #[inline]
    fn eval<R: Ring>(self, [p, a, b]: &[Point<R>; 3], _: &R) -> R {
        let (a, b) = (a - p, b - p);
        match self {
            ProjectedArea::AlongX => R::det2(&a.y, &a.z, &b.y, &b.z),
            ProjectedArea::AlongY => R::det2(&a.z, &a.x, &b.z, &b.x),
            ProjectedArea::TopView => R::det2(&a.x, &a.y, &b.x, &b.y),
        }
    }
}

/// A difference of coordinates: x, y or z by number.
#[derive(Clone, Copy, Debug)]
pub struct Difference(pub usize);

impl Residual<2> for Difference {
    const TRANSLATES: bool = true;

    fn eval<R: Ring>(self, [a, b]: &[Point<R>; 2], _: &R) -> R {
        b.coordinates()[self.0] - a.coordinates()[self.0]
    }
}

/// What a face is, before any class is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FaceShape {
    /// Whether its points lie in a plane.
    pub planar: Answer,
    /// How it is seen from above.
    pub position: Position,
}

/// How a face lies in isotropic space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Position {
    /// Its top view has three points that are not collinear.
    Graph,
    /// Its plane is isotropic: the top view lies on a line.
    Vertical,
    /// All its points lie on a line.
    Collinear,
}

/// Planarity and position of a face, given by its corners.
pub fn shape<D: Decide>(decide: &D, face: &[VertexId]) -> FaceShape {
    let position = if triangle(decide, ProjectedArea::TopView, face).is_some() {
        Position::Graph
    } else if spanning_triangle(decide, face).is_some() {
        Position::Vertical
    } else {
        Position::Collinear
    };
    let planar = match position {
        Position::Graph => places(decide, face)
            .into_iter()
            .flatten()
            .map(|at| decide.decide(Coplanar, at))
            .max()
            .unwrap_or(Answer::Zero),
        // A top view on a line is the top view of a plane.
        Position::Vertical | Position::Collinear => Answer::Zero,
    };
    FaceShape { planar, position }
}

/// The quadruples of points to test: a quad itself, or a triangle of the face with each other
/// point. `None` if the points are collinear.
pub fn places<D: Decide>(
    decide: &D,
    face: &[VertexId],
) -> Option<impl Iterator<Item = [VertexId; 4]> + Clone> {
    let [a, b, c] = match *face {
        // Three points and one more: whatever the three are, the determinant decides.
        [a, b, c, _] => [a, b, c],
        _ => spanning_triangle(decide, face)?.1,
    };
    let others = face.iter().filter(move |&&v| v != a && v != b && v != c);
    let places: Vec<_> = others.map(|&v| [a, b, c, v]).collect();
    Some(places.into_iter())
}

/// Three points of the face that are not collinear in a projection, in the order of the face.
pub fn triangle<D: Decide>(
    decide: &D,
    projection: ProjectedArea,
    face: &[VertexId],
) -> Option<[VertexId; 3]> {
    let spans = |at: &[VertexId; 3]| decide.sign(projection, *at).0 != Sign::Zero;
    let corners = (2..face.len()).map(|i| [face[i - 2], face[i - 1], face[i]]);
    if let Some(corner) = corners.into_iter().find(spans) {
        return Some(corner);
    }
    // All corners are straight or folded or repeat a point: any line through two different points
    // will do.
    let (a, axes) = (face[0], projection.axes());
    let differs = |b| axes.iter().any(|&i| decide.sign(Difference(i), [a, b]).0 != Sign::Zero);
    let j = (1..face.len()).find(|&j| differs(face[j]))?;
    (j + 1..face.len()).map(|k| [a, face[j], face[k]]).find(spans)
}

/// Three points of the face that are not collinear, and a projection that shows it.
pub(super) fn spanning_triangle<D: Decide>(
    decide: &D,
    face: &[VertexId],
) -> Option<(ProjectedArea, [VertexId; 3])> {
    ProjectedArea::ALL.into_iter().find_map(|p| Some((p, triangle(decide, p, face)?)))
}

pub(super) fn outcome<D: Decide>(judge: &Judge<'_, D>, face: FaceId) -> Outcome<D::Value> {
    if judge.topology().face(face).len() == 3 {
        return Outcome::Trivial;
    }
    Outcome::of(judge.net.shape(face).planar, || failure(judge, face))
}

/// What is to be said of a face that is not planar, or whose plane is isotropic or not determined.
pub(super) fn no_graph<D: Decide>(judge: &Judge<'_, D>, face: FaceId) -> Option<Outcome<D::Value>> {
    let shape = judge.net.shape(face);
    match shape.position {
        _ if shape.planar == Answer::Nonzero => Some(Outcome::Fails(failure(judge, face))),
        Position::Vertical => Some(Outcome::Undefined(Reason::VerticalFace(face))),
        Position::Collinear => Some(Outcome::Undefined(Reason::CollinearFace(face))),
        Position::Graph => None,
    }
}

/// The worst residual of a face that is not planar.
pub(super) fn failure<D: Decide>(judge: &Judge<'_, D>, face: FaceId) -> Failure<D::Value> {
    let places = places(judge.decide(), judge.topology().face(face));
    judge.worst("planar", Coplanar, places.into_iter().flatten())
}
