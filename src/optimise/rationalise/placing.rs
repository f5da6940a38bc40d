//! Points and planes, placed one after the other.

use super::dyadic::{exponent, rounded, rounded_point};
use super::incidence::Placement;
use crate::mesh::{FaceId, Topology};
use crate::scalar::{Approx, Field, Rational, Ring, det3};
use crate::space::{Point, Vector3};

/// The plane `n·x = d`, vertical ones included.
#[derive(Clone, Debug)]
pub(super) struct Sheet<T> {
    pub normal: Vector3<T>,
    pub offset: T,
}

/// What is placed, exactly and as doubles.
#[derive(Clone, Debug)]
struct Placed<E, N> {
    exact: E,
    near: N,
}

type PlacedPoint = Placed<Point<Rational>, Point<f64>>;
type PlacedSheet = Placed<Sheet<Rational>, Sheet<f64>>;

impl PlacedPoint {
    fn new(exact: Point<Rational>) -> Self {
        let near = exact.map(Approx::to_f64);
        Placed { exact, near }
    }
}

impl PlacedSheet {
    fn new(exact: Sheet<Rational>) -> Self {
        let Vector3 { x, y, z } = &exact.normal;
        let normal = Vector3::new(x.to_f64(), y.to_f64(), z.to_f64());
        let near = Sheet { normal, offset: exact.offset.to_f64() };
        Placed { exact, near }
    }
}

/// The vertices and faces that have been placed.
pub(super) struct Placing<'a> {
    topology: &'a Topology,
    targets: &'a [Point<f64>],
    /// Parameters are rounded so that points move by about `2^−bits`.
    bits: i32,
    points: Vec<Option<PlacedPoint>>,
    sheets: Vec<Option<PlacedSheet>>,
    /// The three nodes that a node was placed on, if there were three.
    supports: Vec<Option<[usize; 3]>>,
}

impl<'a> Placing<'a> {
    pub fn new(topology: &'a Topology, targets: &'a [Point<f64>], bits: i32) -> Self {
        let (vertices, faces) = (topology.vertex_count(), topology.face_count());
        Placing {
            topology,
            targets,
            bits,
            points: vec![None; vertices],
            sheets: vec![None; faces],
            supports: vec![None; vertices + faces],
        }
    }

    /// The points of the vertices that are placed.
    pub fn into_points(self) -> Vec<Point<Rational>> {
        self.points.into_iter().flatten().map(|p| p.exact).collect()
    }

    /// Places a plane as it is.
    pub fn put_sheet(&mut self, face: usize, sheet: Sheet<Rational>) {
        self.sheets[face] = Some(PlacedSheet::new(sheet));
    }

    /// Places a node. `None` where it is not determined.
    pub fn place(&mut self, placement: &Placement) -> Option<()> {
        let &Placement { node, ref on } = placement;
        if let [a, b, c] = on[..] {
            self.supports[node] = Some([a, b, c]);
        }
        let Some(face) = node.checked_sub(self.points.len()) else {
            self.points[node] = Some(PlacedPoint::new(self.point(node, on)?));
            return Some(());
        };
        // A plane on three points waits until its equation is asked for.
        if on.len() < 3 && self.topology.face(FaceId(face as u32)).len() > 3 {
            let sheet = self.sheet(FaceId(face as u32), on)?;
            self.put_sheet(face, sheet);
        }
        Some(())
    }

    /// The point of a node, if it is a vertex that has been placed.
    pub fn at(&self, node: usize) -> Option<&Point<Rational>> {
        self.placed_point(node).map(|p| &p.exact)
    }

    fn placed_point(&self, node: usize) -> Option<&PlacedPoint> {
        self.points.get(node)?.as_ref()
    }

    fn placed_sheet(&self, node: usize) -> Option<&PlacedSheet> {
        self.sheets.get(node.checked_sub(self.points.len())?)?.as_ref()
    }

    /// Finds the equation of a plane on three points.
    fn solve(&mut self, node: usize) -> Option<()> {
        if self.placed_sheet(node).is_none() {
            let [a, b, c] = self.supports[node]?.map(|m| self.placed_point(m));
            let (a, b, c) = (&a?.exact, &b?.exact, &c?.exact);
            let normal = (b - a).cross(&(c - a));
            let offset = product(&normal, a);
            let face = node - self.points.len();
            self.put_sheet(face, Sheet { normal, offset });
        }
        Some(())
    }

    fn point(&mut self, node: usize, on: &[usize]) -> Option<Point<Rational>> {
        let target = self.targets[node];
        match *on {
            [] => rounded_point(&target, self.bits),
            [plane] => match self.supports[plane] {
                Some(support) => self.affine_combination(support, &target),
                None => self.on_sheet(plane, &target),
            },
            [a, b] => {
                self.solve(a)?;
                self.solve(b)?;
                self.on_line(a, b, &target)
            }
            [a, b, c] => {
                [a, b, c].iter().try_for_each(|&m| self.solve(m))?;
                self.meet([a, b, c])
            }
            _ => None,
        }
    }

    /// `p + s (q − p) + t (r − p)`, with rounded s and t: no more than these bits are added.
    fn affine_combination(
        &self,
        support: [usize; 3],
        target: &Point<f64>,
    ) -> Option<Point<Rational>> {
        let [p, q, r] = support.map(|m| self.placed_point(m));
        let (p, q, r) = (p?, q?, r?);
        let (e, f, x) = (&q.near - &p.near, &r.near - &p.near, target - &p.near);
        let [ee, ef, ff] = [e.length2(), e.dot(&f), f.length2()];
        let [xe, xf] = [x.dot(&e), x.dot(&f)];
        let scale = 1.0 / f64::det2(&ee, &ef, &ef, &ff);
        let parameter =
            |value: f64, length2: f64| rounded(value * scale, self.bits + exponent(length2.sqrt()));
        let s = parameter(f64::det2(&xe, &ef, &xf, &ff), ee)?;
        let t = parameter(f64::det2(&ee, &xe, &ef, &xf), ff)?;
        let rest = Rational::one() - &s - &t;
        let mix =
            |p: &Rational, q: &Rational, r: &Rational| Rational::dot([p, q, r], [&rest, &s, &t]);
        let (p, q, r) = (&p.exact, &q.exact, &r.exact);
        Some(Point::new(mix(&p.x, &q.x, &r.x), mix(&p.y, &q.y, &r.y), mix(&p.z, &q.z, &r.z)))
    }

    /// The point of a plane with two rounded coordinates.
    fn on_sheet(&self, plane: usize, target: &Point<f64>) -> Option<Point<Rational>> {
        let Placed { exact, near } = self.placed_sheet(plane)?;
        let n = &near.normal;
        let off = (near.offset - product(n, target)) / n.length2();
        let foot = target + &n.scaled(&off);
        let k = longest(n);
        let [_, xi, xj] = from(k, coordinates(&foot)).map(|c| rounded(c, self.bits));
        let (xi, xj) = (xi?, xj?);
        let [ck, ci, cj] = from(k, parts(&exact.normal));
        let xk = (&exact.offset - Rational::dot([ci, cj], [&xi, &xj])).try_div(ck)?;
        Some(point_from(k, [xk, xi, xj]))
    }

    /// The point of the line in two planes with a rounded coordinate.
    fn on_line(&self, a: usize, b: usize, target: &Point<f64>) -> Option<Point<Rational>> {
        let (a, b) = (self.placed_sheet(a)?, self.placed_sheet(b)?);
        let (m, n) = (&a.near.normal, &b.near.normal);
        let direction = m.cross(n);
        let off = [&a.near, &b.near].map(|s| s.offset - product(&s.normal, target));
        let [mm, mn, nn] = [m.length2(), m.dot(n), n.length2()];
        let scale = 1.0 / direction.length2();
        let along_m = f64::det2(&off[0], &mn, &off[1], &nn) * scale;
        let along_n = f64::det2(&mm, &off[0], &mn, &off[1]) * scale;
        let foot = &(target + &m.scaled(&along_m)) + &n.scaled(&along_n);
        let k = longest(&direction);
        let xk = rounded(from(k, coordinates(&foot))[0], self.bits)?;
        let [ck, ci, cj] = from(k, parts(&a.exact.normal));
        let [dk, di, dj] = from(k, parts(&b.exact.normal));
        let (r, s) = (&a.exact.offset - ck * &xk, &b.exact.offset - dk * &xk);
        let scale = Rational::det2(ci, cj, di, dj).try_inv()?;
        let xi = Rational::det2(&r, cj, &s, dj) * &scale;
        let xj = Rational::det2(ci, &r, di, &s) * &scale;
        Some(point_from(k, [xk, xi, xj]))
    }

    /// The point in three planes.
    fn meet(&self, planes: [usize; 3]) -> Option<Point<Rational>> {
        let [a, b, c] = planes.map(|m| self.placed_sheet(m));
        let sheets = [&a?.exact, &b?.exact, &c?.exact];
        let [x, y, z] = [0, 1, 2].map(|k| sheets.map(|s| parts(&s.normal)[k]));
        let d = sheets.map(|s| &s.offset);
        let scale = det3(x, y, z).try_inv()?;
        Some(Point::new(det3(d, y, z) * &scale, det3(x, d, z) * &scale, det3(x, y, d) * &scale))
    }

    fn sheet(&self, face: FaceId, on: &[usize]) -> Option<Sheet<Rational>> {
        let target = self.target_sheet(face);
        match *on {
            [] => {
                let normal = self.rounded_vector(&target.normal)?;
                Some(Sheet { normal, offset: rounded(target.offset, self.bits)? })
            }
            [v] => match self.supports[v] {
                Some(support) => self.combination(support, &target.normal),
                None => {
                    let normal = self.rounded_vector(&target.normal)?;
                    let offset = product(&normal, &self.placed_point(v)?.exact);
                    Some(Sheet { normal, offset })
                }
            },
            [v, w] => self.through_two(v, w, &target.normal),
            _ => None,
        }
    }

    /// The plane of the targets of a face, with 1 or −1 as its largest coefficient.
    pub fn target_sheet(&self, face: FaceId) -> Sheet<f64> {
        let corners = self.topology.face(face);
        let at = |i: usize| &self.targets[corners[i % corners.len()].index()];
        let origin = Point::new(0.0, 0.0, 0.0);
        let zero = Vector3::new(0.0, 0.0, 0.0);
        let add = |a: Vector3<f64>, b: Vector3<f64>| Vector3::new(a.x + b.x, a.y + b.y, a.z + b.z);
        let sum = (0..corners.len()).map(|i| at(i) - &origin).fold(zero, add);
        let mean = &origin + &sum.scaled(&(1.0 / corners.len() as f64));
        let turns = (0..corners.len()).map(|i| (at(i) - &mean).cross(&(at(i + 1) - &mean)));
        let normal = turns.fold(zero, add);
        let size = parts(&normal)[longest(&normal)].abs();
        let normal = normal.scaled(&(1.0 / size));
        let offset = product(&normal, &mean);
        Sheet { normal, offset }
    }

    /// The vector with each part rounded.
    pub fn rounded_vector(&self, v: &Vector3<f64>) -> Option<Vector3<Rational>> {
        let [x, y, z] = parts(v).map(|&c| rounded(c, self.bits));
        Some(Vector3 { x: x?, y: y?, z: z? })
    }

    /// The combination of three planes with this normal, but for rounding; it contains their common point.
    fn combination(&self, support: [usize; 3], normal: &Vector3<f64>) -> Option<Sheet<Rational>> {
        let [a, b, c] = support.map(|m| self.placed_sheet(m));
        let sheets = [a?, b?, c?];
        let [a, b, c] = sheets.map(|s| &s.near.normal);
        let det = Vector3::det(a, b, c);
        let weight = |part: f64, n: &Vector3<f64>| {
            rounded(part / det, self.bits + exponent(n.length2().sqrt()))
        };
        let p = weight(Vector3::det(normal, b, c), a)?;
        let q = weight(Vector3::det(a, normal, c), b)?;
        let r = weight(Vector3::det(a, b, normal), c)?;
        let mix = |of: fn(&Sheet<Rational>) -> &Rational| {
            Rational::dot([&p, &q, &r], sheets.map(|s| of(&s.exact)))
        };
        let normal = Vector3::new(mix(|s| &s.normal.x), mix(|s| &s.normal.y), mix(|s| &s.normal.z));
        Some(Sheet { normal, offset: mix(|s| &s.offset) })
    }

    /// The plane through two points near a normal, with two rounded coefficients.
    fn through_two(&self, v: usize, w: usize, normal: &Vector3<f64>) -> Option<Sheet<Rational>> {
        let (v, w) = (self.placed_point(v)?, self.placed_point(w)?);
        let edge = &w.near - &v.near;
        let off = normal.dot(&edge) / edge.length2();
        let k = longest(&edge);
        let [_, ni, nj] = from(k, parts(normal));
        let [_, ei, ej] = from(k, parts(&edge));
        let (ni, nj) = (rounded(ni - off * ei, self.bits)?, rounded(nj - off * ej, self.bits)?);
        let edge = &w.exact - &v.exact;
        let [ek, ei, ej] = from(k, parts(&edge));
        let nk = -Rational::dot([&ni, &nj], [ei, ej]);
        let Point { x, y, z } = point_from(k, [nk, ni * ek, nj * ek]);
        let normal = Vector3 { x, y, z };
        let offset = product(&normal, &v.exact);
        Some(Sheet { normal, offset })
    }
}

/// `n·x` with the position vector of a point.
fn product<T: Ring>(n: &Vector3<T>, x: &Point<T>) -> T {
    T::dot(parts(n), x.coordinates())
}

fn parts<T>(v: &Vector3<T>) -> [&T; 3] {
    [&v.x, &v.y, &v.z]
}

fn coordinates(p: &Point<f64>) -> [f64; 3] {
    [p.x, p.y, p.z]
}

/// The place of the longest part.
fn longest(v: &Vector3<f64>) -> usize {
    let sizes = parts(v).map(|c| c.abs());
    (1..3).fold(0, |k, i| if sizes[i] > sizes[k] { i } else { k })
}

/// Three parts from one on, in a cycle.
fn from<T>(k: usize, mut parts: [T; 3]) -> [T; 3] {
    parts.rotate_left(k);
    parts
}

/// The point with these coordinates from one on.
fn point_from(k: usize, mut parts: [Rational; 3]) -> Point<Rational> {
    parts.rotate_right(k);
    let [x, y, z] = parts;
    Point { x, y, z }
}
