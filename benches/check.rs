//! What an exact verdict costs: one quad, and a mesh of a million faces.
//!
//! `cargo bench --bench check` runs both; `-- --faces 250000` changes the size of the mesh.
//!
//! The quads are *true* cases (coplanar, concyclic), where no floating-point filter can help. The
//! naive ways evaluate the same determinants on rational numbers.

use std::fmt::Write as _;
use std::hint::black_box;
use std::time::Instant;

use isogeo::check::{Decide, Decider, Plain};
use isogeo::mesh::file::{Coordinates, Format, read_bytes};
use isogeo::mesh::{FaceList, Mesh, VertexId};
use isogeo::net::i_circular::Concyclic;
use isogeo::net::planar::Coplanar;
use isogeo::net::{Net, Property};
use isogeo::scalar::{BigRational, Numeral, Rational};
use isogeo::space::Point;

fn main() {
    let mut arguments = std::env::args().skip_while(|a| a != "--faces").skip(1);
    let faces = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(1_000_000usize);
    one_quad();
    let side = (faces as f64).sqrt().round() as usize;
    for (moved, what) in [(false, "all three properties true"), (true, "one vertex moved")] {
        let obj = as_obj(&translational_net(side, moved));
        million(&obj, what);
    }
}

/// A stream of 53-bit numbers (splitmix64).
fn random(seed: u64) -> impl Iterator<Item = u64> {
    (1..).map(move |i: u64| {
        let mut z = seed.wrapping_add(i.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) >> 11
    })
}

/// The net z = f(x) + g(y) over a rectangular grid: planar, i-circular and i-conical. Steps of x
/// and y are random multiples of 2^-43, heights of 2^-42, so that all coordinates are doubles.
fn translational_net(side: usize, moved: bool) -> Mesh<Numeral> {
    let axis = |seed| {
        let steps = random(seed).map(|n| (n >> 10) as f64 * 2f64.powi(-43));
        let sums = steps.scan(0.0, |at, step| {
            *at += step;
            Some(*at)
        });
        sums.take(side + 1).collect::<Vec<f64>>()
    };
    let heights = |seed| {
        random(seed).map(|n| (n >> 1) as f64 * 2f64.powi(-42)).take(side + 1).collect::<Vec<f64>>()
    };
    let (x, y, f, g) = (axis(1), axis(2), heights(3), heights(4));
    let mut points = Vec::new();
    for i in 0..=side {
        for j in 0..=side {
            points.push(Point::new(x[i], y[j], f[i] + g[j]));
        }
    }
    if moved {
        let middle = points.len() / 2;
        points[middle].z = points[middle].z.next_up();
    }
    let mut faces = FaceList::new();
    let at = |i: usize, j: usize| (i * (side + 1) + j) as u32;
    for i in 0..side {
        for j in 0..side {
            faces.push([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    let exact = |x: &f64| Numeral::from_f64(*x).expect("finite");
    let points = points.iter().map(|p: &Point<f64>| p.map(exact)).collect();
    Mesh::new(points, faces).expect("a grid is a mesh")
}

fn one_quad() {
    let mesh = translational_net(1, false);
    let at = [0, 2, 3, 1].map(VertexId);
    let fast = Decider::new(&mesh.points);
    let malachite: Vec<Point<Rational>> =
        mesh.points.iter().map(|p| p.map(Numeral::value)).collect();
    let num: Vec<Point<BigRational>> = mesh.points.iter().map(|p| p.map(Numeral::value)).collect();
    println!("zero test of one quad with 53-bit coordinates, true case (microseconds)");
    println!("{:<22}{:>10}{:>12}", "", "planar", "concyclic");
    row("isogeo", &fast, at, 2_000_000);
    row("malachite Rational", &Plain(&malachite), at, 50_000);
    row("num BigRational", &Plain(&num), at, 5_000);
}

fn row(name: &str, decide: &impl Decide, at: [VertexId; 4], runs: usize) {
    let time = |f: &dyn Fn()| {
        let best = (0..5).map(|_| {
            let start = Instant::now();
            (0..runs).for_each(|_| f());
            start.elapsed().as_secs_f64() * 1e6 / runs as f64
        });
        best.fold(f64::INFINITY, f64::min)
    };
    let planar = time(&|| {
        black_box(decide.decide(Coplanar, black_box(at)));
    });
    let concyclic = time(&|| {
        black_box(decide.decide(Concyclic, black_box(at)));
    });
    println!("{name:<22}{planar:>10.3}{concyclic:>12.3}");
}

/// The mesh as an OBJ file with the shortest decimals that give back its doubles.
fn as_obj(mesh: &Mesh<Numeral>) -> Vec<u8> {
    let mut text = String::new();
    for p in &mesh.points {
        let p = p.map(Numeral::nearest_f64);
        let _ = writeln!(text, "v {} {} {}", p.x, p.y, p.z);
    }
    for f in mesh.topology.faces() {
        text.push('f');
        for v in mesh.topology.face(f) {
            let _ = write!(text, " {}", v.0 + 1);
        }
        text.push('\n');
    }
    text.into_bytes()
}

fn million(obj: &[u8], what: &str) {
    println!("\nOBJ of {} MB, {what}, read as doubles (seconds)", obj.len() / 1_000_000);
    let show = |name: &str, start: Instant, note: String| {
        println!("{name:<14}{:>8.3}  {note}", start.elapsed().as_secs_f64());
    };
    let start = Instant::now();
    let file = read_bytes("net.obj", Format::Obj, obj).expect("an OBJ file");
    let Coordinates::Numerals(mesh) = file.into_doubles().expect("doubles").coordinates else {
        unreachable!("OBJ files hold decimals");
    };
    show("reading", start, format!("{} faces", mesh.topology.face_count()));
    let all = Instant::now();
    let decider = Decider::new(&mesh.points);
    let net = Net::new(&mesh.topology, &decider);
    show("denominators", all, String::new());
    for property in [Property::Planar, Property::ICircular, Property::IConical] {
        let start = Instant::now();
        let report = net.check(property);
        let note = format!("{} ({} failed)", report.verdict(), report.failures.len());
        show(property.name(), start, note);
    }
    show("deciding", all, "the four above".into());
    if let Some(peak) = peak_memory() {
        println!("{:<14}{peak:>8} MB so far, the text of the file included", "peak memory");
    }
}

/// The peak resident memory of this process, where the system tells.
fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:"))?;
    line.split_whitespace().nth(1)?.parse::<u64>().ok().map(|kb| kb / 1024)
}
