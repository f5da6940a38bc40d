//! What optimisation costs: `cargo bench --bench optimise`.
//!
//! An i-Enneper net with 2 % noise is brought to planar, i-circular and i-conical, until distances are
//! those of rounding. `benches/peers/optimise.py` does the same with sparse factorisations from Python.

use std::time::Instant;

use isogeo::mesh::{FaceList, Mesh};
use isogeo::optimise::{Goal, Mobility, Projection, Stage, System};
use isogeo::space::Point;

/// The number in [0, 1) of an index, for a seed.
fn noise(seed: u64, index: u64) -> f64 {
    let mut z = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(index);
    z = z.wrapping_add(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
}

/// A grid of `m` by `m` faces over a function.
fn grid(m: u32, point: impl Fn(f64, f64) -> [f64; 3]) -> Mesh<f64> {
    let at = |i: u32| f64::from(i) / f64::from(m);
    let points = (0..=m).flat_map(|j| (0..=m).map(move |i| (i, j)));
    let points = points.map(|(i, j)| {
        let [x, y, z] = point(at(i), at(j));
        Point::new(x, y, z)
    });
    let points = points.collect();
    let mut faces = FaceList::new();
    for (i, j) in (0..m).flat_map(|j| (0..m).map(move |i| (i, j))) {
        let v = |i: u32, j: u32| j * (m + 1) + i;
        faces.push([v(i, j), v(i + 1, j), v(i + 1, j + 1), v(i, j + 1)]);
    }
    Mesh::new(points, faces).expect("a grid is a mesh")
}

/// `x + iy = ζ^(2/3)`, `z = Re ζ² / 5` with ζ in [1, 2] + i [0.2, 1.2], and each coordinate moved by at
/// most 2 % of the mean edge of the top view.
fn noisy_enneper(m: u32) -> (Mesh<f64>, f64) {
    let mut mesh = grid(m, |u, v| {
        let (a, b) = (1.0 + u, 0.2 + v);
        let (r, angle) = ((a * a + b * b).cbrt(), f64::atan2(b, a) * 2.0 / 3.0);
        [r * angle.cos(), r * angle.sin(), 0.2 * (a * a - b * b)]
    });
    let lengths: Vec<f64> = mesh
        .topology
        .edges()
        .map(|h| {
            let [p, q] =
                [mesh.topology.origin(h), mesh.topology.target(h)].map(|v| &mesh.points[v.index()]);
            p.i_distance2(q).sqrt()
        })
        .collect();
    let edge = lengths.iter().sum::<f64>() / lengths.len() as f64;
    for (i, p) in (0..).zip(&mut mesh.points) {
        let shift = |seed| 0.02 * edge * (2.0 * noise(seed, i) - 1.0);
        *p = Point::new(p.x + shift(11), p.y + shift(12), p.z + shift(13));
    }
    (mesh, edge)
}

fn main() {
    println!("goal         faces    seconds  steps  distance  rms moved (edges)");
    for m in [50, 100, 200] {
        let (mesh, edge) = noisy_enneper(m);
        for goal in [Goal::Planar, Goal::ICircular, Goal::IConical] {
            let mut best = f64::INFINITY;
            let mut line = String::new();
            for _ in 0..3 {
                let start = Instant::now();
                let mut points = mesh.points.clone();
                let system = System::new(goal.conditions(&mesh.topology, &points));
                let mobility = vec![Mobility::Free; points.len()];
                let t0 = start.elapsed().as_secs_f64();
                let mut projection = Projection::new(&system, &mobility).expect("memory");
                let t1 = start.elapsed().as_secs_f64();
                let mut log = Vec::new();
                let ending = projection.run(&mut points, 20, Stage::Projection, |step| {
                    let worst = step.distance();
                    log.push((worst / edge, start.elapsed().as_secs_f64()));
                    true
                });
                let seconds = start.elapsed().as_secs_f64();
                let moved: f64 =
                    points.iter().zip(&mesh.points).map(|(p, q)| (p - q).length2()).sum();
                let rms = (moved / points.len() as f64).sqrt() / edge;
                if seconds < best {
                    best = seconds;
                    line = format!(
                        "{:10} {:8} {seconds:10.4} {:5}  {:8.1e}  {rms:.5}  {ending:?} {t0:.4} {t1:.4} {log:.4?}",
                        goal.property().name(),
                        mesh.topology.face_count(),
                        log.len() - 1,
                        log.last().map_or(0.0, |l| l.0)
                    );
                }
            }
            println!("{line}");
        }
    }
}
