//! What the way back to exact meshes costs: `cargo bench --bench rationalise`.
//!
//! Inversions of translational nets (i-circular) and their metric duals (i-conical, up to rounding), n × n
//! quads of a mesh of size about 1 with noise of 10⁻¹²; rings of 40 quads around a hole; rings of hexagons;
//! closed meshes of parallelograms. `moved` is the largest distance of a vertex from where it was, of at most
//! 10⁻⁶ where that is reached; the seconds are those of all attempts, then of deciding the property exactly.

use std::time::Instant;

use isogeo::check::{Decider, Verdict};
use isogeo::construct::hexagonal::HexagonalRings;
use isogeo::mesh::Mesh;
use isogeo::net::{Net, Property};
use isogeo::optimise::rationalise::{NoExactMesh, Options, Rationalised};
use isogeo::optimise::rationalise::{i_circular, i_conical, planar};
use isogeo::scalar::{Approx, Field, Rational};
use isogeo::space::Rotation;

#[path = "../tests/suite/optimise/shapes.rs"]
mod shapes;

use shapes::{dual, inverted, rings, with_noise, zonohedron};

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
        row("planar", "rings", &rings(n, 40, 1.0 / 8.0), Property::Planar, planar);
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
    let mesh = with_noise(mesh, 1e-12);
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

fn hexagons() -> Mesh<f64> {
    let rotation = Rotation::new(Rational::from_ratio(60, 61), Rational::from_ratio(11, 61));
    let slopes = (0..14).map(|k| Rational::from_ratio(3i64.pow(k), 2i64.pow(k))).collect();
    let rings = HexagonalRings::new(rotation.expect("a rotation"), slopes).expect("rings");
    rings.mesh(&rings.circumscribed(), 30).expect("hexagons").map(Approx::to_f64)
}
