//! What optimisation costs: `cargo bench --bench optimise`.
//!
//! An i-Enneper net with 2 % noise is brought to planar, i-circular and i-conical, until distances are
//! those of rounding; sizes may be given: `-- 50 1000`. `benches/peers/optimise.py` does the same with sparse
//! factorisations from Python, and planarises the patch with other programs.

use std::time::Instant;

use isogeo::mesh::{FaceList, Mesh};
use isogeo::optimise::{Design, Goal, Method, Movement, mean_edge};
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
fn noisy_enneper(m: u32) -> Mesh<f64> {
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
    mesh
}

/// The height field of 32 by 32 faces on which planarisers are compared.
fn patch() -> Mesh<f64> {
    grid(32, |u, v| {
        let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
        [x, y, 0.3 * (1.7 * x + 0.3).sin() * (1.3 * y - 0.2).cos() + 0.2 * x * y]
    })
}

/// The best of some runs.
fn measure(name: &str, design: &Design, mesh: &Mesh<f64>, runs: usize) {
    let (mut best, mut line) = (f64::INFINITY, String::new());
    for _ in 0..runs {
        let start = Instant::now();
        let found = design.run(mesh, |_| true).expect("memory suffices");
        let seconds = start.elapsed().as_secs_f64();
        if seconds < best {
            best = seconds;
            let edge = mean_edge(&mesh.topology, &mesh.points);
            let movement = Movement::between(&mesh.points, &found.points);
            let distance = found.steps.last().map_or(0.0, |step| step.distance());
            line = format!(
                "{name:<22} {:>8} {seconds:>9.4} {:>6} {:>9.1e} {:>9.4} {:>9.3}  {}",
                mesh.topology.face_count(),
                found.steps.len() - 1,
                distance / edge,
                movement.rms / edge,
                movement.largest / edge,
                found.ending.name(),
            );
        }
    }
    println!("{line}");
}

fn main() {
    let sizes: Vec<u32> = std::env::args().filter_map(|a| a.parse().ok()).collect();
    let sizes = if sizes.is_empty() { vec![50, 100, 200] } else { sizes };
    println!("lengths are in mean edges; threads: {}", rayon::current_num_threads());
    println!(
        "{:<22} {:>8} {:>9} {:>6} {:>9} {:>9} {:>9}",
        "goal", "faces", "seconds", "steps", "distance", "rms", "largest"
    );
    let goals = [Goal::Planar, Goal::ICircular, Goal::IConical];
    for m in sizes {
        let mesh = noisy_enneper(m);
        for goal in goals {
            let runs = if m > 300 { 1 } else { 5 };
            measure(goal.property().name(), &Design::new(goal, mesh.points.len()), &mesh, runs);
        }
        for goal in &goals[1..] {
            let design =
                Design { method: Method::TwoStage, ..Design::new(*goal, mesh.points.len()) };
            let name = format!("{}, two stages", goal.property().name());
            measure(&name, &design, &mesh, if m > 300 { 1 } else { 3 });
        }
    }
    println!("the patch of 1024 faces");
    let mesh = patch();
    measure("planar", &Design::new(Goal::Planar, mesh.points.len()), &mesh, 5);
}
