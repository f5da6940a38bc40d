//! Meshes of doubles that are near exact ones, for tests and benches.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use isogeo::construct::{moebius_image, translational_net};
use isogeo::mesh::{Data, FaceList, Mesh};
use isogeo::space::{
    Circle, CylindricalSphere, Dual, MoebiusTransformation, Plane, Point, TopView,
};

/// Numbers between −1 and 1 that look random, the same in every run.
fn noise() -> impl FnMut() -> f64 {
    let mut state = 0x1507u64;
    move || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// The mesh with noise of this size on all coordinates.
pub fn with_noise(mesh: &Mesh<f64>, size: f64) -> Mesh<f64> {
    let mut noise = noise();
    let mut mesh = mesh.clone();
    for p in &mut mesh.points {
        *p = Point::new(p.x + size * noise(), p.y + size * noise(), p.z + size * noise());
    }
    mesh
}

/// An inversion of a translational net with `n × n` faces, of size about 1: planar and i-circular.
pub fn inverted(n: i32) -> Mesh<f64> {
    let at = |i: i32| f64::from(2 * i - n) / f64::from(2 * n);
    let f: Vec<_> = (0..=n).map(at).map(|x| (x + 0.1 * x * x, x * x + 0.3 * x * x * x)).collect();
    let g: Vec<_> = (0..=n).map(at).map(|y| (1.2 * y, 0.1 * y - 0.5 * y * y)).collect();
    let circle = Circle::new(TopView::new(1.0, 1.3), 1.0);
    let cylinder = CylindricalSphere::new(circle).expect("a radius");
    let inversion = MoebiusTransformation::inversion_at_cylinder(&cylinder, &0.2);
    let net = translational_net(&f, &g).expect("a grid");
    moebius_image(&net, &inversion).expect("off the centre")
}

/// The dual of such a net, but for rounding: i-conical, with `n × n` faces.
pub fn dual(n: i32) -> Mesh<f64> {
    let mesh = inverted(n + 1);
    let pole = |f| {
        let corners: Vec<_> =
            mesh.topology.face(f).iter().map(|v| &mesh.points[v.index()]).collect();
        Plane::nearest(&corners).expect("no vertical face").dual()
    };
    let points = mesh.topology.faces().map(pole).collect();
    let topology = mesh.topology.dual().expect("a grid").topology;
    Mesh { topology, points, data: Data::default() }
}

/// A collineation of `n` rings of quads on a surface of revolution: it keeps planes.
pub fn rings(n: u32, sectors: u32, step: f64) -> Mesh<f64> {
    let places = |n: u32| (0..n).flat_map(move |k| (0..sectors).map(move |j| (k, j)));
    let points = places(n + 1).map(|(k, j)| {
        let (r, angle) = (1.0 + f64::from(k) * step, TAU * f64::from(j) / f64::from(sectors));
        let (x, y, z) = (r * angle.cos(), r * angle.sin(), (r * r + 1.0).sqrt());
        let w = 1.0 + 0.1 * x + 0.05 * z;
        Point::new(x / w, y / w, z / w)
    });
    let at = |k: u32, j: u32| k * sectors + j % sectors;
    let mut faces = FaceList::new();
    for (k, j) in places(n) {
        faces.push([at(k, j), at(k + 1, j), at(k + 1, j + 1), at(k, j + 1)]);
    }
    Mesh::new(points.collect(), faces).expect("rings")
}

/// Sums of `n` vectors in a cycle: a closed mesh of `n (n − 1)` parallelograms.
pub fn zonohedron(n: u32) -> Mesh<f64> {
    let vector = |k: u32| {
        let angle = TAU * f64::from(k % n) / f64::from(n);
        [angle.cos() + 0.1 * (3.0 * angle).sin(), angle.sin(), 0.7]
    };
    let (mut names, mut points) = (BTreeMap::new(), Vec::new());
    let mut sum = |from: u32, count: u32| {
        let key = if count.is_multiple_of(n) { (0, count) } else { (from % n, count) };
        *names.entry(key).or_insert_with(|| {
            let parts = (from..from + count).map(vector);
            let [x, y, z] = parts.fold([0.0; 3], |s, v| [s[0] + v[0], s[1] + v[1], s[2] + v[2]]);
            points.push(Point::new(x, y, z));
            points.len() as u32 - 1
        })
    };
    let mut faces = FaceList::new();
    for (i, k) in (0..n).flat_map(|i| (0..n - 1).map(move |k| (i, k))) {
        let corners = [(i + 1, k), (i, k + 1), (i, k + 2), (i + 1, k + 1)];
        faces.push(corners.map(|(from, count)| sum(from, count)));
    }
    Mesh::new(points, faces).expect("closed")
}
