//! Instances for the chapters on i-minimal meshes: polygons with an incircle, touching circles
//! around a vertex, all of them rational.

use super::{Stop, Trial};
use crate::check::Residual;
use crate::construct::{koebe_mesh, vertex_circles};
use crate::mesh::{FaceList, Mesh, TopologyError, VertexId};
use crate::net::RADIUS;
use crate::net::i_isothermic::{CoplanarPoles, TouchingCircles};
use crate::pair::{four_mixed_areas, twice_area};
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
        faces.push([1 + next, 0, 1 + j, 1 + n + j].map(|v| v as u32));
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

/// The circles, moved.
pub(super) fn translated<T: Field>(
    circles: Vec<OrientedCircle<T>>,
    by: &Vector2<T>,
) -> Vec<OrientedCircle<T>> {
    let moved = |c: OrientedCircle<T>| OrientedCircle { centre: &c.centre + by, radius: c.radius };
    circles.into_iter().map(moved).collect()
}

/// Goals: the circles of a mesh touch along its edges, and those of a face have a common orthogonal
/// circle.
pub(super) fn has_circles<T: Field>(trial: &mut Trial<T>, mesh: &Mesh<T>) {
    let radii = radii_of(mesh);
    let number = |v: VertexId| Point::new(radii[v.index()].clone(), T::zero(), T::zero());
    let point = |v: VertexId| mesh.points[v.index()].clone();
    for h in mesh.topology.edges() {
        let [a, b] = [mesh.topology.origin(h), mesh.topology.target(h)];
        let points = [point(a), point(b), number(a), number(b)];
        trial.zero("touching circles", TouchingCircles.eval(&points, &T::one()));
    }
    for face in mesh.topology.faces() {
        let corners = mesh.topology.face(face);
        for &last in corners.iter().skip(3) {
            let at = [corners[0], corners[1], corners[2], last];
            let points =
                std::array::from_fn(|i| if i < 4 { point(at[i]) } else { number(at[i - 4]) });
            trial.zero("coplanar poles", CoplanarPoles.eval(&points, &T::one()));
        }
    }
}

/// Two parallel polygons F and S with k corners and mixed area 0, in the plane z = 0, each with a
/// ring of quads around it in planes that are parallel to those of the other.
pub(super) fn ring_around<T: Field>(
    trial: &mut Trial<T>,
    minimal: &'static str,
) -> Result<[Mesh<T>; 2], Stop> {
    const SPANNED: &str = "consecutive edges are not parallel";
    const SLOPE: &str = "faces of the ring are not horizontal";
    const SOLVED: &str = "the last factor decides over the mixed area";
    let k = trial.size();
    let f: Vec<_> = (0..k).map(|_| TopView::new(trial.free(), trial.free())).collect();
    let slopes: Vec<T> = (0..k).map(|_| trial.free()).collect();
    let mut factors: Vec<T> = (0..k - 3).map(|_| trial.free()).collect();
    let edge = |j: usize| &f[(j + 1) % k] - &f[j % k];
    for (j, slope) in slopes.iter().enumerate() {
        trial.parameter(SPANNED, &edge(j + k - 1).det(&edge(j)))?;
        trial.parameter(SLOPE, slope)?;
    }
    let closed = |factors: &[T], solved: &T| {
        let mut s = vec![TopView::new(T::zero(), T::zero())];
        for (j, factor) in factors.iter().chain([solved]).enumerate() {
            s.push(&s[j] + &edge(j).scaled(factor));
        }
        let (last, back) = (edge(k - 2), edge(k - 1));
        let gap = &s[0] - &s[k - 2];
        let step = gap.det(&back).try_div(&last.det(&back))?;
        s.push(&s[k - 2] + &last.scaled(&step));
        Some(s)
    };
    // The mixed area is linear in the last factor.
    let [at_zero, at_one] = [0, 1].map(|n| closed(&factors, &T::from_i64(n)));
    let at_zero = four_mixed_areas(&f, &trial.defined(SPANNED, at_zero)?);
    let slope = four_mixed_areas(&f, &trial.defined(SPANNED, at_one)?) - &at_zero;
    trial.parameter(SOLVED, &slope)?;
    let solved = trial.defined(SOLVED, (-&at_zero).try_div(&slope))?;
    let solved = trial.constrained(solved);
    trial.relation(minimal, (at_zero + &slope * &solved) * T::from_ratio(1, 4))?;
    let s = trial.defined(SPANNED, closed(&factors, &solved))?;
    factors.push(solved);
    for factor in &factors {
        trial.parameter("no edge of S has length 0", factor)?;
    }
    for j in 0..k {
        trial.parameter("no edge of S has length 0", &{
            let image = &s[(j + 1) % k] - &s[j];
            image.det(&edge(j + 1))
        })?;
    }
    let mesh = |corners: &[TopView<T>]| {
        let mut points: Vec<_> = corners.iter().map(|v| v.at_height(T::zero())).collect();
        for (j, corner) in corners.iter().enumerate() {
            // Along the line of the faces j − 1 and j, which have the gradients μ J e.
            let before = edge(j + k - 1).scaled(&slopes[(j + k - 1) % k]);
            let after = edge(j).scaled(&slopes[j]);
            let along = &before + &-&after;
            points.push((corner + &along).at_height(after.turned().dot(&along)));
        }
        let mut faces = one_face(k);
        for j in 0..k {
            let next = (j + 1) % k;
            faces.push([next, j, k + j, k + next].map(|v| v as u32));
        }
        Mesh::new(points, faces)
    };
    let meshes = [trial.accepted("M", mesh(&f))?, trial.accepted("S", mesh(&s))?];
    Ok(meshes)
}
