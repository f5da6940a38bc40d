//! Small instances that several chapters make: faces, stars and pyramids in general position.

use super::{Run, Stop, Trial};
use crate::check::Residual;
use crate::construct::circular_net;
use crate::mesh::{FaceId, FaceList, Mesh};
use crate::net::i_circular::Concyclic;
use crate::scalar::{Field, Ordered, Rational, RationalField, Ring, Sign};
use crate::space::{
    Circle, CylindricalSphere, Dual, Gradient, MoebiusSphere, MoebiusTransformation,
    OrientedCircle, Plane, Point, TopView, Vector2,
};

/// Where an instance is drawn so that consecutive edges of a face span its plane.
pub(super) const CORNERS: &str = "consecutive edges are not collinear in the top view";

/// A mesh of one face.
pub(super) fn one_face<T: Field>(
    trial: &mut Trial<T>,
    points: Vec<Point<T>>,
) -> Result<Mesh<T>, Stop> {
    let mut faces = FaceList::new();
    faces.push(0..points.len() as u32);
    trial.accepted("one face", Mesh::new(points, faces))
}

/// Triangles between the first point and the others, which form a closed ring.
pub(super) fn star<T: Field>(trial: &mut Trial<T>, points: Vec<Point<T>>) -> Result<Mesh<T>, Stop> {
    let n = points.len() as u32 - 1;
    let mut faces = FaceList::new();
    (0..n).for_each(|j| faces.push([0, 1 + j, 1 + (j + 1) % n]));
    trial.accepted("a star", Mesh::new(points, faces))
}

/// A free plane.
pub(super) fn free_plane<T: Field>(trial: &mut Trial<T>) -> Plane<T> {
    Plane::new(Gradient::new(trial.free(), trial.free()), trial.free())
}

/// A free top view.
pub(super) fn free_top_view<T: Field>(trial: &mut Trial<T>) -> TopView<T> {
    TopView::new(trial.free(), trial.free())
}

/// A top view on the circle through three others, which are not collinear: the second point of the
/// line in a free direction through the first.
pub(super) fn on_circle<T: Field>(
    trial: &mut Trial<T>,
    hypothesis: &'static str,
    [a, b, c]: [&TopView<T>; 3],
) -> Result<TopView<T>, Stop> {
    let direction = trial.free_vector2();
    trial.parameter("a direction of the line to the next point", &direction.length2())?;
    let at = match Circle::through(a, b, c) {
        Ok(circle) => {
            let twice = (&circle.centre - a).dot(&direction) * T::from_i64(2);
            a + &direction.scaled(&(twice / direction.length2()))
        }
        Err(_) => a.clone(),
    };
    let at = trial.constrained_vector2(at.position());
    let at = TopView::new(at.x, at.y);
    trial.relation(hypothesis, incircle([a, b, c, &at]))?;
    Ok(at)
}

/// The in-circle determinant of [`Concyclic`] for top views.
pub(super) fn incircle<T: Field>(at: [&TopView<T>; 4]) -> T {
    residual_at_zero(at.map(|x| x.clone()))
}

/// The same for gradients.
pub(super) fn gradient_incircle<T: Field>(gradients: [&Gradient<T>; 4]) -> T {
    residual_at_zero(gradients.map(Dual::dual))
}

fn residual_at_zero<T: Field>(at: [TopView<T>; 4]) -> T {
    Concyclic.eval(&at.map(|x| x.at_height(T::zero())), &T::one())
}

/// The gradient of a face.
pub(super) fn gradient<T: Field>(
    trial: &mut Trial<T>,
    mesh: &Mesh<T>,
    face: usize,
) -> Result<Gradient<T>, Stop> {
    Ok(trial.accepted("a face plane", mesh.face_plane(FaceId(face as u32)))?.gradient)
}

/// A closed pyramid with an apex over the origin and the base `z = 0`, by the gradients of its four
/// sides: the apex is vertex 0; side `j` is face `j` and has the corners `1 + j` and the next.
///
/// Up to an i-motion every pyramid is one of these.
pub(super) fn pyramid<T: Field>(
    trial: &mut Trial<T>,
    height: &T,
    sides: &[Gradient<T>; 4],
) -> Result<Mesh<T>, Stop> {
    trial.parameter("the apex is not in the base", height)?;
    let zero = Gradient::new(T::zero(), T::zero());
    let mut points = vec![Point::new(T::zero(), T::zero(), height.clone())];
    for j in 0..4 {
        let (left, right) = (&sides[(j + 3) % 4], &sides[j]);
        let det = (left - &zero).det(&(right - &zero));
        trial.parameter("the base meets the edges of the apex", &det)?;
        let corner = (right - left).turned().scaled(&(height / &det));
        points.push(Point::new(corner.x, corner.y, T::zero()));
    }
    let mut faces = FaceList::new();
    (0..4).for_each(|j| faces.push([0, 1 + j, 1 + (j + 1) % 4]));
    faces.push([4, 3, 2, 1]);
    trial.accepted("a pyramid", Mesh::new(points, faces))
}

/// States that no two numbers are equal, one condition for every pair.
pub(super) fn all_different<T: Field>(
    trial: &mut Trial<T>,
    says: &'static str,
    numbers: &[&T],
) -> Run {
    for (n, a) in numbers.iter().enumerate() {
        for b in &numbers[n + 1..] {
            trial.parameter(says, &(*a - *b))?;
        }
    }
    Ok(())
}

/// Cosine and sine, times the lengths, of the angle from one vector to another.
pub(super) fn turn<T: Field>(a: &Vector2<T>, b: &Vector2<T>) -> Vector2<T> {
    Vector2::new(a.dot(b), a.det(b))
}

/// Cosine and sine of the sum of two angles.
pub(super) fn sum<T: Field>(a: &Vector2<T>, b: &Vector2<T>) -> Vector2<T> {
    Vector2::new(&a.x * &b.x - &a.y * &b.y, &a.y * &b.x + &a.x * &b.y)
}

/// 0 if the sign of a number is the expected one, for goals about the order.
pub(super) fn unless<T: Field + Ordered>(expected: Sign, value: &T) -> T {
    T::from_i64(i64::from(value.certain_sign() != Some(expected)))
}

/// The corners of the polygon about a circle with the contacts at these parameters, each with the
/// signed length of its tangents as radius.
pub(super) fn polygon_about<T: Field>(
    circle: &OrientedCircle<T>,
    parameters: &[T],
) -> Option<Vec<OrientedCircle<T>>> {
    let corner = |j: usize| {
        let (s, t) = (&parameters[(j + parameters.len() - 1) % parameters.len()], &parameters[j]);
        let scale = circle.radius.try_div(&(T::one() + s * t))?;
        let corner = Vector2::new((T::one() - s * t) * &scale, (s + t) * &scale);
        Some(OrientedCircle { centre: &circle.centre + &corner, radius: (t - s) * scale })
    };
    (0..parameters.len()).map(corner).collect()
}

/// The inversion at the unit cylinder, that at a free i-M-sphere, and the addition of this sphere:
/// with what obviously keeps i-circles they generate the i-M-transformations.
pub(super) fn generators<T: Field>(trial: &mut Trial<T>) -> Result<MoebiusTransformation<T>, Stop> {
    let sphere = MoebiusSphere::from([(); 4].map(|()| trial.free()));
    let unit = Circle::new(TopView::new(T::zero(), T::zero()), T::one());
    let unit = trial.accepted("a cylinder", CylindricalSphere::new(unit))?;
    let inversion = MoebiusTransformation::inversion_at_cylinder(&unit, &T::zero());
    let other = MoebiusTransformation::inversion_at(&sphere);
    Ok(inversion.then(&other).then(&MoebiusTransformation::addition(&sphere)))
}

/// Top views on a circle.
pub(super) fn concyclic<T: Field>(
    trial: &mut Trial<T>,
    hypothesis: &'static str,
) -> Result<Vec<TopView<T>>, Stop> {
    let mut at = vec![free_top_view(trial), free_top_view(trial), free_top_view(trial)];
    trial.parameter(CORNERS, &(&at[1] - &at[0]).det(&(&at[2] - &at[0])))?;
    while at.len() < trial.size().max(4) {
        at.push(on_circle(trial, hypothesis, [&at[0], &at[1], &at[2]])?);
    }
    Ok(at)
}

/// The points of a plane over top views.
pub(super) fn over<T: Field>(plane: &Plane<T>, at: &[TopView<T>]) -> Vec<Point<T>> {
    at.iter().map(|x| plane.point_at(x)).collect()
}

/// An i-circular net over a free square grid, with a free ratio in every face.
pub(super) fn net<T: RationalField>(trial: &mut Trial<T>) -> Result<Mesh<T>, Stop> {
    let n = trial.size();
    let side = |trial: &mut Trial<T>, first: Point<T>| {
        let mut side = vec![first];
        side.extend((0..n).map(|_| trial.free_point()));
        side
    };
    let corner = trial.free_point();
    let (rows, columns) = (side(trial, corner.clone()), side(trial, corner));
    // Between 1/3 and 1: then no edge has length 0 in the top view.
    let ratio = |t: T| {
        let square = t.square();
        (&square + T::one()) / (square + T::from_i64(3))
    };
    let ratios: Vec<T> = (0..n * n).map(|_| ratio(trial.free())).collect();
    let net = circular_net(&rows, &columns, |i, j| ratios[i * n + j].clone());
    let Some(net) = net else { return Err(Stop::Excluded(CORNERS)) };
    trial.accepted("a net", net)
}

/// A mesh of small integers, for counterexamples.
pub(super) fn mesh_of(points: &[[i64; 3]], faces: &[&[u32]]) -> Result<Mesh<Rational>, String> {
    let mut list = FaceList::new();
    faces.iter().for_each(|face| list.push(face.iter().copied()));
    let q = Rational::from_i64;
    let points = points.iter().map(|&[x, y, z]| Point::new(q(x), q(y), q(z))).collect();
    Mesh::new(points, list).map_err(|error| error.to_string())
}

/// The point where two touching circles touch.
pub(super) fn contact<T: Field>(
    a: &OrientedCircle<T>,
    b: &OrientedCircle<T>,
) -> Option<TopView<T>> {
    let factor = a.radius.try_div(&(&a.radius + &b.radius))?;
    Some(&a.centre + &(&b.centre - &a.centre).scaled(&factor))
}

/// The points of residuals that take radii as x-coordinates.
pub(super) fn with_radii<T: Field, const N: usize>(
    circles: &[&OrientedCircle<T>],
) -> [Point<T>; N] {
    let half = N / 2;
    std::array::from_fn(|i| {
        let OrientedCircle { centre, radius } = circles[i % half];
        let top_view =
            if i < half { centre.clone() } else { TopView::new(radius.clone(), T::zero()) };
        top_view.at_height(T::zero())
    })
}

/// Circles with a common denominator.
pub(super) fn circles<const N: usize>(
    of: [[i64; 3]; N],
    unit: i64,
) -> [OrientedCircle<Rational>; N] {
    of.map(|[x, y, r]| {
        let [x, y, radius] = [x, y, r].map(|n| Rational::from_ratio(n, unit));
        OrientedCircle { centre: TopView::new(x, y), radius }
    })
}

/// A free circle with a sign.
pub(super) fn free_circle<T: Field>(trial: &mut Trial<T>) -> OrientedCircle<T> {
    OrientedCircle { centre: free_top_view(trial), radius: trial.free() }
}
