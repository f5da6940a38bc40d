//! Pairs of meshes (Sec. 3.1, 4): laws over both exact scalars, each with its negative control, and
//! the named values.

mod areas;
mod centres;
mod double_duals;
mod enclosures;
mod exact;
mod faces;
mod graph_sums;
mod images;
mod minimal;
mod properties;
mod readings;
mod refusals;
mod values;
mod vertices;

use isogeo::construct::{circular_net, metric_dual, quad_patch, translational_net};
use isogeo::mesh::{FaceList, Mesh};
use isogeo::scalar::RationalField;
use isogeo::space::*;

use crate::space::{Draw, Verdict, laws};

pub fn q<Q: RationalField>(p: i64, q: i64) -> Q {
    Q::from_ratio(p, q)
}

/// A fan of triangles around vertex 0, which lies over the origin of the ring.
pub fn fan<Q: RationalField>(centre: Point<Q>, ring: Vec<Point<Q>>) -> Mesh<Q> {
    let mut faces = FaceList::new();
    let k = ring.len() as u32;
    (0..k).for_each(|i| faces.push([0, 1 + i, 1 + (i + 1) % k]));
    let points = std::iter::once(centre).chain(ring).collect();
    Mesh::new(points, faces).unwrap()
}

/// A fan over the origin with the graph of a function.
pub fn sampled<Q: RationalField>(ring: &[(i64, i64)], f: impl Fn(&Q, &Q) -> Q) -> Mesh<Q> {
    let at = |x: i64, y: i64| {
        let (x, y) = (Q::from_i64(x), Q::from_i64(y));
        let z = f(&x, &y);
        Point::new(x, y, z)
    };
    fan(at(0, 0), ring.iter().map(|&(x, y)| at(x, y)).collect())
}

/// A corner near a regular polygon with radius 8.
fn near_circle<Q: RationalField>(draw: &mut Draw<Q>, i: usize, k: usize) -> TopView<Q> {
    let angle = std::f64::consts::TAU * i as f64 / k as f64;
    let near = |c: f64, jitter: Q| q::<Q>((c * 80.0) as i64, 10) + jitter * q::<Q>(1, 6);
    TopView::new(near(angle.cos(), draw.number()), near(angle.sin(), draw.number()))
}

/// A fan with 3 to 8 triangles, embedded, with any heights.
pub fn star<Q: RationalField>(draw: &mut Draw<Q>) -> Mesh<Q> {
    let k = 3 + draw.index(6);
    let centre = draw.point();
    let centre = Point { x: centre.x * q::<Q>(1, 6), y: centre.y * q::<Q>(1, 6), ..centre };
    let ring = (0..k).map(|i| near_circle(draw, i, k).at_height(draw.number())).collect();
    fan(centre, ring)
}

/// A planar polygon with 3 to 8 corners near a circle, as a mesh of one face.
pub fn polygon<Q: RationalField>(draw: &mut Draw<Q>) -> Mesh<Q> {
    let (k, plane) = (3 + draw.index(6), draw.plane());
    let points = (0..k).map(|i| plane.point_at(&near_circle(draw, i, k))).collect();
    let mut faces = FaceList::new();
    faces.push(0..k as u32);
    Mesh::new(points, faces).unwrap()
}

/// A polygon with edges parallel to those of another, anywhere; all but two factors are free.
pub fn parallel_polygon<Q: RationalField>(draw: &mut Draw<Q>, mesh: &Mesh<Q>) -> Mesh<Q> {
    let m = &mesh.points;
    let k = m.len();
    let edge = |j: usize| &m[(j + 1) % k] - &m[j];
    let scaled = |v: Vector3<Q>, f: &Q| Vector3::new(v.x * f, v.y * f, v.z * f);
    let mut points = vec![draw.point()];
    for j in 0..k - 2 {
        let next = &points[j] + &scaled(edge(j), &draw.number());
        points.push(next);
    }
    // The last corner lies on the lines through its neighbours.
    let (a, b) = (edge(k - 2), edge(k - 1));
    let gap = (&points[0] - &points[k - 2]).top_view();
    let factor = gap.det(&b.top_view()) / a.top_view().det(&b.top_view());
    let last = &points[k - 2] + &scaled(a, &factor);
    points.push(last);
    Mesh { points, ..mesh.clone() }
}

/// An i-circular net of `m × n` faces near a square grid.
pub fn circular<Q: RationalField>(draw: &mut Draw<Q>, m: i64, n: i64) -> Mesh<Q> {
    loop {
        let mut near = |i: i64, j: i64| {
            let jitter = |a: Q| a * q::<Q>(1, 40);
            let (x, y) = (jitter(draw.number()), jitter(draw.number()));
            Point::new(Q::from_i64(i) + x, Q::from_i64(j) + y, draw.number())
        };
        let rows: Vec<_> = (0..=m).map(|i| near(i, 0)).collect();
        let columns: Vec<_> =
            (0..=n).map(|j| if j == 0 { rows[0].clone() } else { near(0, j) }).collect();
        let ratios: [Q; 4] = [q(1, 2), q(2, 5), q(3, 5), q(5, 9)];
        let ratio = |i: usize, j: usize| ratios[(i + 2 * j) % 4].clone();
        if let Some(Ok(net)) = circular_net::<Q>(&rows, &columns, ratio) {
            return net;
        }
    }
}

/// A translational net of `m × n` faces.
pub fn translational<Q: RationalField>(draw: &mut Draw<Q>, m: i64, n: i64) -> Mesh<Q> {
    let mut profile = |count: i64| -> Vec<(Q, Q)> {
        let at = |i: i64| Q::from_i64(3 * i) + draw.number() * q::<Q>(1, 9);
        (0..=count).map(at).collect::<Vec<_>>().into_iter().map(|x| (x, draw.number())).collect()
    };
    let (f, g) = (profile(m), profile(n));
    translational_net(&f, &g).unwrap()
}

/// A planar mesh with an i-conical interior vertex: the dual of a circular net or a translational net.
pub fn conical<Q: RationalField>(draw: &mut Draw<Q>) -> Option<Mesh<Q>> {
    let dual = metric_dual(&circular(draw, 3, 3)).ok()?;
    graph_faces(&dual).then_some(dual)
}

/// Whether all faces have planes.
pub fn graph_faces<Q: RationalField>(mesh: &Mesh<Q>) -> bool {
    mesh.topology.faces().all(|f| mesh.face_plane(f).is_ok())
}

/// The mesh with its top view sheared: planar as before, circles become ellipses.
pub fn sheared<Q: RationalField>(mesh: &Mesh<Q>) -> Mesh<Q> {
    let shear = |p: &Point<Q>| Point::new(&p.x + &p.y * q::<Q>(1, 3), p.y.clone(), p.z.clone());
    Mesh { points: mesh.points.iter().map(shear).collect(), ..mesh.clone() }
}

/// A patch of `m × n` quads, each cut into two triangles, near a square grid with any heights.
pub fn triangle_patch<Q: RationalField>(draw: &mut Draw<Q>, m: usize, n: usize) -> Mesh<Q> {
    let quads = Mesh::new(
        (0..=m)
            .flat_map(|i| (0..=n).map(move |j| (i as i64, j as i64)))
            .map(|(i, j)| {
                let near = |n: i64, a: Q| Q::from_i64(n) + a * q::<Q>(1, 40);
                Point::new(near(i, draw.number()), near(j, draw.number()), draw.number())
            })
            .collect(),
        quad_patch(m, n),
    )
    .unwrap();
    let mut faces = FaceList::new();
    for f in quads.topology.faces() {
        if let [a, b, c, d] = *quads.topology.face(f) {
            let cuts =
                if draw.index(2) == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
            cuts.iter().for_each(|t| faces.push(t.map(|v| v.0)));
        }
    }
    Mesh::new(quads.points, faces).unwrap()
}

/// The same mesh with other heights.
pub fn with_heights<Q: RationalField>(draw: &mut Draw<Q>, mesh: &Mesh<Q>) -> Mesh<Q> {
    let points = mesh.points.iter().map(|p| p.top_view().at_height(draw.number())).collect();
    Mesh { points, ..mesh.clone() }
}
