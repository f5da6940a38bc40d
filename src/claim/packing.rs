//! Instances for the chapters on i-minimal meshes: polygons with an incircle, touching circles
//! around a vertex, all of them rational.

use super::{Stop, Trial};
use crate::construct::{koebe_mesh, vertex_circles};
use crate::mesh::{FaceList, Mesh, TopologyError};
use crate::net::RADIUS;
use crate::pair::twice_area;
use crate::scalar::{Field, Rational, Ring};
use crate::space::{OrientedCircle, Point, Rotation, TopView, Vector2};

/// What fails in a counterexample, if its residual is not 0.
pub(super) fn witnessed(what: &str, residual: &Rational) -> Result<String, String> {
    if residual.is_zero() {
        return Err(format!("{what}: 0"));
    }
    Ok(format!("{what}: {residual}"))
}

/// A mesh of one face.
pub(super) fn face_at<T: Field>(corners: Vec<Point<T>>) -> Result<Mesh<T>, TopologyError> {
    let faces = one_face(corners.len());
    Mesh::new(corners, faces)
}

/// One face with n corners.
pub(super) fn one_face(n: usize) -> FaceList {
    let mut faces = FaceList::new();
    faces.push(0..n as u32);
    faces
}

/// The radii that a mesh carries.
pub(super) fn radii_of<T>(mesh: &Mesh<T>) -> &[T] {
    mesh.data.vertex.get(RADIUS).map_or(&[], Vec::as_slice)
}

/// By how much the circles of a mesh miss each other, edge by edge.
pub(super) fn touching<T: Field>(mesh: &Mesh<T>) -> Vec<T> {
    let circles = vertex_circles(mesh).unwrap_or_default();
    let ends = |h| [mesh.topology.origin(h), mesh.topology.target(h)].map(|v| v.index());
    let edges = mesh.topology.edges().map(ends);
    edges.filter_map(|[a, b]| Some(circles.get(a)?.tangency(circles.get(b)?))).collect()
}

/// The corners of a polygon that is circumscribed to the unit circle, as the circles of their
/// tangents: the edge from corner j to corner j + 1 touches at the angle of which `t_j` is half the
/// tangent, `R_j = (t_j − t_{j−1})/(1 + t_j t_{j−1})`.
pub(super) fn tangential<T: Field>(
    trial: &mut Trial<T>,
    n: usize,
    off_circle: &'static str,
) -> Result<Vec<OrientedCircle<T>>, Stop> {
    let t: Vec<T> = (0..n).map(|_| trial.free()).collect();
    let mut corners = Vec::with_capacity(n);
    for j in 0..n {
        let (a, b) = (&t[(j + n - 1) % n], &t[j]);
        let next = &t[(j + 1) % n];
        let cosine = T::one() + a * b;
        trial.nonzero(off_circle, &(b - a))?;
        trial.parameter("consecutive edges are not parallel", &cosine)?;
        trial.parameter("no edge has length 0", &(next - a))?;
        trial.parameter("1 + t² is not 0", &(T::one() + b.square()))?;
        let scale = trial.defined("consecutive edges are not parallel", cosine.try_inv())?;
        let centre = TopView::new((T::one() - a * b) * &scale, (a + b) * &scale);
        corners.push(OrientedCircle { centre, radius: (b - a) * scale });
    }
    Ok(corners)
}

/// The incircle of the two unit spokes u, w of a circle, and the fourth circle of the quad of which
/// the circles `r₁`, `r₂` on the spokes are two more corners.
fn quad<T: Field>(
    trial: Option<&mut Trial<T>>,
    circle: &OrientedCircle<T>,
    [(u, r1), (w, r2)]: [(&Vector2<T>, &T); 2],
) -> Option<OrientedCircle<T>> {
    let r0 = &circle.radius;
    let cosine = T::one() + u.dot(w);
    let product = r0 * r1 + r1 * r2 + r2 * r0;
    let half = r0.square() * u.det(w).square();
    // The equation of Schramm, solved for the fourth radius; ρ = r0 det(u, w)/(1 + u·w).
    let divisor = &half - &product * cosine.square();
    let reach = r1.square() * cosine.square() + &half;
    if let Some(trial) = trial {
        trial.parameter("spokes that follow each other are not opposite", &cosine).ok()?;
        trial.parameter("the fourth corner is not at infinity", &divisor).ok()?;
        trial.parameter("the circle of a face and that of a corner differ", &reach).ok()?;
    }
    let sum = r0 + r1 + r2;
    let r3 = (r0 * r1 * r2 * cosine.square() - &half * sum).try_div(&divisor)?;
    // From the first spoke's end, the other tangent: u turned over at the line to the centre.
    let along = |factor: &T| Vector2::new(&u.x * factor, &u.y * factor);
    let to_centre = (u + w).scaled(&r0.try_div(&cosine)?);
    let to_centre = &to_centre + &along(&-(r0 + r1));
    let turn = (T::from_i64(2) * r1 * cosine.square()).try_div(&reach)?;
    let direction = u + &to_centre.scaled(&turn);
    let first = &circle.centre + &along(&(r0 + r1));
    Some(OrientedCircle { centre: &first + &direction.scaled(&(r1 + &r3)), radius: r3 })
}

/// The Koebe mesh of n quads around vertex 0 with the radii `r_0` of the centre and `r_1, …, r_n` of
/// its neighbours, which follow each other on rays with the half angles `arctan t_j`. Any n touching
/// circles around one and with incircles are of this kind.
pub(super) fn star<T: Field>(
    mut trial: Option<&mut Trial<T>>,
    t: &[T],
    radii: &[T],
) -> Option<Mesh<T>> {
    let (r0, radii) = radii.split_first()?;
    let n = radii.len();
    let centre = OrientedCircle { centre: TopView::new(T::zero(), T::zero()), radius: r0.clone() };
    let rays = t.iter().map(Rotation::from_parameter);
    let rays: Vec<_> = rays
        .map(|ray| ray.map(|ray| Vector2::new(ray.cos().clone(), ray.sin().clone())))
        .collect::<Result<_, _>>()
        .ok()?;
    let mut circles = vec![centre.clone()];
    for (ray, radius) in rays.iter().zip(radii) {
        let at = &centre.centre + &ray.scaled(&(r0 + radius));
        circles.push(OrientedCircle { centre: at, radius: radius.clone() });
    }
    let mut faces = FaceList::new();
    for j in 0..n {
        let next = (j + 1) % n;
        let spokes = [(&rays[j], &radii[j]), (&rays[next], &radii[next])];
        circles.push(quad(trial.as_deref_mut(), &centre, spokes)?);
        faces.push([0, 1 + j, 1 + n + j, 1 + next].map(|v| v as u32));
    }
    koebe_mesh(circles, faces).ok()
}

/// A [`star`] of unknowns.
pub(super) fn free_star<T: Field>(
    trial: &mut Trial<T>,
    n: usize,
    off_circle: &'static str,
) -> Result<Mesh<T>, Stop> {
    let t: Vec<T> = (0..n).map(|_| trial.free()).collect();
    let radii: Vec<T> = (0..=n).map(|_| trial.free()).collect();
    for (j, number) in t.iter().enumerate() {
        let next = &t[(j + 1) % n];
        trial.parameter("1 + t² is not 0", &(T::one() + number.square()))?;
        trial.parameter("spokes that follow each other differ", &(next - number))?;
    }
    for radius in &radii {
        trial.nonzero(off_circle, radius)?;
    }
    let mesh = star(Some(trial), &t, &radii);
    let mesh = trial.defined("the fourth corner is not at infinity", mesh)?;
    for radius in radii_of(&mesh).iter().skip(1 + n) {
        trial.nonzero(off_circle, radius)?;
    }
    for face in mesh.topology.faces() {
        let corners = mesh.topology.face(face).iter().take(3);
        let corners: Vec<_> = corners.map(|v| mesh.points[v.index()].top_view()).collect();
        trial.parameter("no face has three corners on a line", &twice_area(&corners))?;
    }
    Ok(mesh)
}

/// Six quads around a triangle of sides 3, 4, 5 that is no face: one at each side, one at each
/// corner. Their circles touch along all edges.
pub(super) fn around_a_triangle() -> Option<Mesh<Rational>> {
    let number = Rational::from_i64;
    let circle = |(x, y, r): (i64, i64, i64)| OrientedCircle {
        centre: TopView::new(number(x), number(y)),
        radius: number(r),
    };
    let corners = [(0, 0, 1), (3, 0, 2), (0, 4, 3)].map(circle);
    let ray = |from: &OrientedCircle<Rational>, to: &OrientedCircle<Rational>| {
        let length = (&from.radius + &to.radius).try_inv()?;
        Some((&to.centre - &from.centre).scaled(&length))
    };
    // At the side from corner i: one neighbour straight out from it, the other over the next corner.
    let (mut near, mut far) = (Vec::new(), Vec::new());
    for (i, corner) in corners.iter().enumerate() {
        let next = &corners[(i + 1) % 3];
        let side = ray(corner, next)?;
        let (out, radius) = (-&side.turned(), number(1 + i as i64));
        far.push(quad(None, corner, [(&out, &radius), (&side, &next.radius)])?);
        let centre = &corner.centre + &out.scaled(&(&corner.radius + &radius));
        near.push(OrientedCircle { centre, radius });
    }
    let mut outer = Vec::new();
    for (i, corner) in corners.iter().enumerate() {
        let ends = [&far[(i + 2) % 3], &near[i]];
        let [a, b] = ends.map(|end| ray(corner, end));
        outer.push(quad(None, corner, [(&a?, &ends[0].radius), (&b?, &ends[1].radius)])?);
    }
    let mut faces = FaceList::new();
    for i in 0..3 {
        let (next, before) = ((i + 1) % 3, (i + 2) % 3);
        faces.push([i, 3 + i, 6 + i, next]);
        faces.push([i, 6 + before, 9 + i, 3 + i]);
    }
    let circles = corners.into_iter().chain(near).chain(far).chain(outer).collect();
    koebe_mesh(circles, faces).ok()
}
