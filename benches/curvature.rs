//! Curvatures of whole meshes: in doubles against plain C, exactly against rational numbers.
//!
//! `cargo bench --bench curvature` runs all; `-- --vertices 250000` changes the size of the meshes.
//!
//! The C loops (`benches/peers/curvature.c`) are compiled with `cc -O3 -march=native` and run on
//! the same arrays in the same run; they are left out where there is no C compiler.

use std::io::Write as _;
use std::process::Command;
use std::time::Instant;

use isogeo::construct::{inscribed_v_parallel, quad_patch};
use isogeo::mesh::{ExactPoints, FaceId, FaceList, Mesh, VertexId};
use isogeo::pair::{Curvatures, ExactPair, LiftedForms, OffsetResiduals, face_curvatures};
use isogeo::scalar::{BigInt, BigRational, Numeral, Rational, RationalField};
use isogeo::space::{Point, TopView};
use rayon::prelude::*;

fn main() {
    let mut arguments = std::env::args().skip_while(|a| a != "--vertices").skip(1);
    let vertices = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(1_000_000usize);
    let side = vertices.isqrt();
    let peer = Peer::compile();
    println!("doubles, {} vertices: seconds, best of 5", side * side);
    vertices_in_doubles(peer.as_ref(), "vertices, grid order", &jittered_grid(side));
    vertices_in_doubles(peer.as_ref(), "vertices, random order", &shuffled(&jittered_grid(side)));
    faces_in_doubles(peer.as_ref(), side);
    println!("exactly, (15)-(18) on quads at d = 1/3: microseconds a face, one thread");
    let mut random = Random(1);
    let any = quads(|| (random.bits(24), random.bits(24) + 1));
    check_offsets("every coordinate with its own denominator of 24 bits", &any);
    let dyadic = quads(|| (random.bits(24), 1 << 24));
    check_offsets("all over 2^24", &dyadic);
    exact_vertices();
}

/// A stream of 53-bit numbers (splitmix64).
struct Random(u64);

impl Random {
    fn bits(&mut self, n: u32) -> i64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> (64 - n)) as i64
    }

    fn unit(&mut self) -> f64 {
        self.bits(53) as f64 * 2f64.powi(-53)
    }

    fn permutation(&mut self, n: usize) -> Vec<u32> {
        let mut order: Vec<u32> = (0..n as u32).collect();
        for i in (1..n).rev() {
            order.swap(i, self.bits(40) as usize % (i + 1));
        }
        order
    }
}

/// `sin x cos y + x²/10` over a square grid, every vertex moved by up to 0.15 of a cell.
fn jittered_grid(side: usize) -> Mesh<f64> {
    let mut random = Random(1);
    let mut at = |i: usize| (i as f64 + 0.3 * (random.unit() - 0.5)) / side as f64;
    let mut points = Vec::with_capacity(side * side);
    for i in 0..side {
        for j in 0..side {
            let (x, y) = (at(i), at(j));
            points.push(Point::new(x, y, x.sin() * y.cos() + 0.1 * x * x));
        }
    }
    let mut faces = FaceList::new();
    let at = |i: usize, j: usize| (i * side + j) as u32;
    for i in 0..side - 1 {
        for j in 0..side - 1 {
            faces.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
            faces.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    Mesh::new(points, faces).expect("a grid is a mesh")
}

/// The same mesh with vertices and faces in random order.
fn shuffled(mesh: &Mesh<f64>) -> Mesh<f64> {
    let mut random = Random(2);
    let place = random.permutation(mesh.points.len());
    let mut points = mesh.points.clone();
    for (point, &to) in mesh.points.iter().zip(&place) {
        points[to as usize] = *point;
    }
    let mut faces = FaceList::new();
    for f in random.permutation(mesh.topology.face_count()) {
        faces.push(mesh.topology.face(FaceId(f)).iter().map(|v| place[v.index()]));
    }
    Mesh::new(points, faces).expect("relabelled")
}

fn best<R>(mut run: impl FnMut() -> R) -> (f64, R) {
    let mut once = || {
        let start = Instant::now();
        let result = run();
        (start.elapsed().as_secs_f64(), result)
    };
    let mut best = once();
    for _ in 1..5 {
        let next = once();
        best = if next.0 < best.0 { next } else { best };
    }
    best
}

fn vertices_in_doubles(peer: Option<&Peer>, what: &str, mesh: &Mesh<f64>) {
    let topology = &mesh.topology;
    let (ours, curvatures) = best(|| {
        let forms = LiftedForms::new(mesh).expect("triangles");
        let ids = (0..topology.vertex_count() as u32).into_par_iter();
        ids.map(|v| forms.vertex_curvatures(VertexId(v)).ok()).collect::<Vec<_>>()
    });
    let edges: Vec<[u32; 4]> = topology
        .edges()
        .filter_map(|h| {
            let twin = topology.twin(h)?;
            let apex = |h| topology.target(topology.next(h)).0;
            Some([topology.origin(h).0, topology.target(h).0, apex(h), apex(twin)])
        })
        .collect();
    let peer = peer.map(|p| p.run(&mesh.points, &mesh.points, &edges, &[]));
    report(what, ours, &curvatures, peer);
}

fn faces_in_doubles(peer: Option<&Peer>, side: usize) {
    let mut random = Random(3);
    let mut random_points = || -> Vec<Point<f64>> {
        let mut at = |i: usize| i as f64 + 0.5 * random.unit();
        let grid = (0..=side).flat_map(|i| (0..=side).map(move |j| (i, j)));
        grid.map(|(i, j)| Point::new(at(i), at(j), at(0))).collect()
    };
    let (m, s) = (random_points(), random_points());
    let mesh = Mesh::new(m, quad_patch(side, side)).expect("a patch is a mesh");
    let (ours, curvatures) =
        best(|| face_curvatures(&mesh.topology, &mesh.points, &s).expect("a point each"));
    let curvatures: Vec<_> = curvatures.into_iter().map(Result::ok).collect();
    let quads: Vec<[u32; 4]> = mesh
        .topology
        .faces()
        .filter_map(|f| mesh.topology.face(f).try_into().ok())
        .map(|quad: [VertexId; 4]| quad.map(|v| v.0))
        .collect();
    let peer = peer.map(|p| p.run(&mesh.points, &s, &[], &quads));
    report("faces, quads", ours, &curvatures, peer);
}

fn report(
    what: &str,
    ours: f64,
    curvatures: &[Option<Curvatures<f64>>],
    peer: Option<(f64, Vec<f64>)>,
) {
    let Some((time, values)) = peer else {
        println!("  {what:<24} ours {ours:.4}");
        return;
    };
    let (mean, gauss) = values.split_at(curvatures.len());
    let difference = |c: &Curvatures<f64>, h: f64, k: f64| {
        let scale = c.mean.abs() + c.gauss.abs().sqrt();
        ((c.mean - h).abs() / scale).max((c.gauss - k).abs() / scale.powi(2))
    };
    let all = curvatures.iter().zip(mean.iter().zip(gauss));
    let worst =
        all.filter_map(|(c, (&h, &k))| Some(difference(c.as_ref()?, h, k))).fold(0.0, f64::max);
    println!(
        "  {what:<24} ours {ours:.4}   plain C, one thread {time:.4}   largest difference {worst:.1e}"
    );
}

/// The C program, compiled.
struct Peer {
    folder: std::path::PathBuf,
}

impl Peer {
    fn compile() -> Option<Peer> {
        let folder = std::env::temp_dir().join(format!("isogeo-bench-{}", std::process::id()));
        std::fs::create_dir_all(&folder).ok()?;
        let source = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/peers/curvature.c");
        let mut cc = Command::new("cc");
        cc.args(["-O3", "-march=native", "-o"]).arg(folder.join("peer")).arg(source);
        cc.status().ok()?.success().then_some(Peer { folder })
    }

    /// The time, and all H, then all K.
    fn run(
        &self,
        points: &[Point<f64>],
        image: &[Point<f64>],
        edges: &[[u32; 4]],
        quads: &[[u32; 4]],
    ) -> (f64, Vec<f64>) {
        let mut bytes = Vec::new();
        for n in [points.len(), edges.len(), quads.len()] {
            bytes.extend((n as i64).to_le_bytes());
        }
        for p in points.iter().chain(image) {
            p.coordinates().into_iter().for_each(|c| bytes.extend(c.to_le_bytes()));
        }
        edges.iter().chain(quads).flatten().for_each(|i| bytes.extend(i.to_le_bytes()));
        let input = self.folder.join("arrays");
        let written = std::fs::File::create(&input).and_then(|mut f| f.write_all(&bytes));
        written.expect("room for the arrays");
        let (program, values) = (self.folder.join("peer"), self.folder.join("values"));
        let output = Command::new(program).arg(&input).arg(&values).output().expect("it runs");
        let time = String::from_utf8_lossy(&output.stdout).trim().parse().expect("a time");
        let values = std::fs::read(values).expect("the values");
        let words = values.chunks_exact(8).filter_map(|w| w.try_into().ok());
        (time, words.map(f64::from_le_bytes).collect())
    }
}

impl Drop for Peer {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

/// 20 000 quads of their own and their images.
fn quads(mut fraction: impl FnMut() -> (i64, i64)) -> [Mesh<Rational>; 2] {
    const COUNT: u32 = 20_000;
    [(); 2].map(|()| {
        let mut faces = FaceList::new();
        (0..COUNT).for_each(|i| faces.push([4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3]));
        let mut coordinate = || {
            let (p, q) = fraction();
            Rational::from_fraction(BigInt::from(p), BigInt::from(q)).expect("a denominator")
        };
        let mut point = || Point::new(coordinate(), coordinate(), coordinate());
        Mesh::new((0..4 * COUNT).map(|_| point()).collect(), faces).expect("quads")
    })
}

fn check_offsets(what: &str, [m, s]: &[Mesh<Rational>; 2]) {
    println!("  {what}");
    let topology = &m.topology;
    let d = Rational::from_fraction(1.into(), 3.into()).expect("a third");
    let pair = ExactPair::new(
        topology,
        ExactPoints::from(m.points.as_slice()),
        ExactPoints::from(s.points.as_slice()),
    );
    per_element("ours", topology.faces(), |f| {
        pair.offset_residuals(f, &d).is_some_and(|r| r.vanish())
    });
    naive("malachite, the same formulas", [m, s], |q| q.clone());
    naive("num BigRational, the same formulas", [m, s], RationalField::convert::<BigRational>);
}

fn naive<Q: RationalField>(what: &str, [m, s]: [&Mesh<Rational>; 2], convert: fn(&Rational) -> Q) {
    let few = m.topology.faces().take(2000);
    let views = |mesh: &Mesh<Rational>, f| -> Vec<TopView<Q>> {
        let corner = |v: &VertexId| mesh.points[v.index()].map(convert).top_view();
        mesh.topology.face(f).iter().map(corner).collect()
    };
    let polygons: Vec<_> = few.map(|f| (views(m, f), views(s, f))).collect();
    let d = convert(&Rational::from_fraction(1.into(), 3.into()).expect("a third"));
    per_element(what, polygons.iter(), |(f, s)| {
        OffsetResiduals::of(f, s, &d).is_some_and(|r| r.vanish())
    });
}

fn per_element<E>(
    what: &str,
    elements: impl ExactSizeIterator<Item = E>,
    holds: impl Fn(E) -> bool,
) {
    let count = elements.len();
    let start = Instant::now();
    let true_ones = elements.filter_map(|e| holds(e).then_some(())).count();
    let time = start.elapsed().as_secs_f64() * 1e6 / count as f64;
    assert_eq!(true_ones, count, "an identity fails");
    println!("    {what:<36} {time:8.2}");
}

fn exact_vertices() {
    println!("exactly, H and K at vertices of doubles: microseconds a vertex, one thread");
    let mesh = jittered_grid(100);
    let exact = |x: &f64| Numeral::from_f64(*x).expect("finite");
    let numerals = mesh.map(exact);
    let points = ExactPoints::from(numerals.points.as_slice());
    let pair = ExactPair::lifted(&mesh.topology, points);
    let interior: Vec<_> = mesh.topology.interior_vertices().collect();
    per_element("ours, as fractions", interior.iter(), |&v| pair.vertex_curvatures(v).is_ok());
    per_element("ours, in lowest terms", interior.iter(), |&v| {
        pair.vertex_curvatures(v).is_ok_and(|c| c.reduced::<Rational>().is_some())
    });
    // The naive way from the same start: the coordinates as fractions.
    let small = jittered_grid(46).map(exact).map(Numeral::value);
    let interior: Vec<_> = small.topology.interior_vertices().collect();
    let start = Instant::now();
    let naive = inscribed_v_parallel(&small).expect("triangles");
    let planes = start.elapsed().as_secs_f64() * 1e6 / interior.len() as f64;
    per_element("malachite, (22) as it stands", interior.iter(), |&v| {
        naive.vertex_curvatures(v).is_ok()
    });
    println!("    {:<36} {planes:8.2}", "  and its face planes");
    let points = ExactPoints::from(small.points.as_slice());
    let pair = ExactPair::lifted(&small.topology, points);
    per_element("(both agree)", interior.iter(), |&v| {
        let ours = pair.vertex_curvatures(v).ok().and_then(|c| c.reduced::<Rational>());
        ours == naive.vertex_curvatures(v).ok()
    });
}
