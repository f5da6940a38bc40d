//! What the way back to exact meshes costs: `cargo bench --bench rationalise`.
//!
//! Inversions of translational nets (i-circular) and their metric duals (i-conical, up to rounding), n × n
//! quads of a mesh of size about 1 with noise of 10⁻¹²; rings of 40 quads around a hole; rings of hexagons;
//! closed meshes of parallelograms. `moved` is the largest distance of a vertex from where it was, of at most
//! 10⁻⁶ where that is reached; the seconds are those of all attempts, then of deciding the property exactly.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::time::Instant;

use isogeo::check::{Decider, Verdict};
use isogeo::construct::hexagonal::HexagonalRings;
use isogeo::construct::{moebius_image, translational_net};
use isogeo::mesh::{Data, FaceList, Mesh};
use isogeo::net::{Net, Property};
use isogeo::optimise::rationalise::{NoExactMesh, Options, Rationalised};
use isogeo::optimise::rationalise::{i_circular, i_conical, planar};
use isogeo::scalar::{Approx, Field, Rational};
use isogeo::space::{
    Circle, CylindricalSphere, Dual, MoebiusTransformation, Plane, Point, Rotation, TopView,
};

fn main() {
    println!("class       mesh          faces     bits    moved  seconds  deciding");
    for n in [10, 20, 30, 40, 100] {
        row("planar", "inverted", &inverted(n), Property::Planar, planar);
    }
    for n in [10, 20, 30, 40] {
        row("i-circular", "inverted", &inverted(n), Property::ICircular, i_circular);
    }
    for n in [10, 20, 30, 40] {
        row("i-conical", "dual", &dual(n), Property::IConical, i_conical);
    }
    row("planar", "hexagons", &hexagons(), Property::Planar, planar);
    for n in [4, 8, 12] {
        row("planar", "rings", &rings(n), Property::Planar, planar);
    }
    for n in [5, 10, 15] {
        row("planar", "zonohedron", &zonohedron(n), Property::Planar, planar);
    }
}

fn row(
    class: &str,
    name: &str,
    mesh: &Mesh<f64>,
    property: Property,
    method: impl Fn(&Mesh<f64>, &Options) -> Result<Rationalised, NoExactMesh>,
) {
    let mesh = with_noise(mesh);
    let options = Options { within: 1e-6, ..Options::of(&mesh.points) };
    let start = Instant::now();
    let found = method(&mesh, &options).expect("an exact mesh");
    let making = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let decider = Decider::of_rationals(&found.mesh.points);
    let report = Net::new(&found.mesh.topology, &decider).check(property);
    assert_eq!(report.verdict(), Verdict::Proved);
    let deciding = start.elapsed().as_secs_f64();
    let (faces, moved) = (mesh.topology.face_count(), found.movement.largest);
    println!(
        "{class:<11} {name:<11} {faces:>7} {:>8} {moved:>8.1e} {making:>8.3} {deciding:>9.3}",
        found.bits
    );
}

fn with_noise(mesh: &Mesh<f64>) -> Mesh<f64> {
    let mut state = 7u64;
    let mut noise = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        1e-12 * ((state >> 11) as f64 / (1u64 << 52) as f64 - 1.0)
    };
    let mut mesh = mesh.clone();
    for p in &mut mesh.points {
        *p = Point::new(p.x + noise(), p.y + noise(), p.z + noise());
    }
    mesh
}

fn inverted(n: i32) -> Mesh<f64> {
    let at = |i: i32| f64::from(2 * i - n) / f64::from(2 * n);
    let f: Vec<_> = (0..=n).map(at).map(|x| (x + 0.1 * x * x, x * x + 0.3 * x * x * x)).collect();
    let g: Vec<_> = (0..=n).map(at).map(|y| (1.2 * y, 0.1 * y - 0.5 * y * y)).collect();
    let circle = Circle::new(TopView::new(1.0, 1.3), 1.0);
    let cylinder = CylindricalSphere::new(circle).expect("a radius");
    let inversion = MoebiusTransformation::inversion_at_cylinder(&cylinder, &0.2);
    moebius_image(&translational_net(&f, &g).expect("a grid"), &inversion).expect("off the centre")
}

fn dual(n: i32) -> Mesh<f64> {
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

fn hexagons() -> Mesh<f64> {
    let rotation = Rotation::new(Rational::from_ratio(60, 61), Rational::from_ratio(11, 61));
    let slopes = (0..14).map(|k| Rational::from_ratio(3i64.pow(k), 2i64.pow(k))).collect();
    let rings = HexagonalRings::new(rotation.expect("a rotation"), slopes).expect("rings");
    rings.mesh(&rings.circumscribed(), 30).expect("hexagons").map(Approx::to_f64)
}

/// A collineation of rings of quads on a surface of revolution.
fn rings(n: u32) -> Mesh<f64> {
    const SECTORS: u32 = 40;
    let places = |n: u32| (0..n).flat_map(|k| (0..SECTORS).map(move |j| (k, j)));
    let points = places(n + 1).map(|(k, j)| {
        let (r, angle) = (1.0 + f64::from(k) / 8.0, TAU * f64::from(j) / f64::from(SECTORS));
        let (x, y, z) = (r * angle.cos(), r * angle.sin(), (r * r + 1.0).sqrt());
        let w = 1.0 + 0.1 * x + 0.05 * z;
        Point::new(x / w, y / w, z / w)
    });
    let at = |k: u32, j: u32| k * SECTORS + j % SECTORS;
    let mut faces = FaceList::new();
    for (k, j) in places(n) {
        faces.push([at(k, j), at(k + 1, j), at(k + 1, j + 1), at(k, j + 1)]);
    }
    Mesh::new(points.collect(), faces).expect("rings")
}

/// Sums of n vectors in a cycle: n (n − 1) parallelograms.
fn zonohedron(n: u32) -> Mesh<f64> {
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
