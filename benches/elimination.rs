//! What the spaces of parallel and v-parallel meshes cost: ours beside Gauss on fractions.
//!
//! `cargo bench --bench elimination` runs both on patches of 10 × 10 to 60 × 60 quads;
//! `-- --naive 20` sets the largest side for Gauss, `-- --basis 60` the largest side for which the
//! basis over a *general* top view is computed: its numbers grow with the patch.

use std::time::Instant;

use isogeo::construct::{quad_patch, translational_net};
use isogeo::mesh::Mesh;
use isogeo::pair::linear_space::{parallel_space, v_parallel_space};
use isogeo::scalar::{Field, Rational, RationalField, Ring};
use isogeo::space::Point;

fn main() {
    let option = |name: &str, default: usize| {
        let mut arguments = std::env::args().skip_while(|a| a != name).skip(1);
        arguments.next().and_then(|n| n.parse().ok()).unwrap_or(default)
    };
    let (naive, basis) = (option("--naive", 20), option("--basis", 60));
    for (what, net) in [
        ("translational nets, heights and steps p / q below 10", translational as fn(usize) -> _),
        ("general top views: a grid of step 10, each vertex moved by up to 3", general),
    ] {
        println!("\n{what} (seconds; bits of the longest number)");
        println!(
            "{:>5}{:>12}{:>12}{:>14}{:>8}{:>14}{:>12}{:>14}",
            "side", "v-parallel", "dimension", "basis", "bits", "Gauss", "parallel", "dimension"
        );
        for side in [10, 20, 40, 60] {
            let mesh: Mesh<Rational> = net(side);
            let (space, dimension_time) = timed(|| v_parallel_space(&mesh));
            let short = what.starts_with("trans") || side <= basis;
            let all = short.then(|| timed(|| space.basis()));
            let bits = all.as_ref().map(|(basis, _)| longest(basis));
            let gauss = (side <= naive).then(|| {
                let (nullity, time) = timed(|| gauss(&mesh));
                assert_eq!(nullity, space.dimension(), "both agree");
                time
            });
            let (parallel, parallel_time) = timed(|| parallel_space(&mesh));
            println!(
                "{side:>5}{:>12}{dimension_time:>12.4}{:>14}{:>8}{:>14}{:>12}{parallel_time:>14.4}",
                space.dimension(),
                show(all.map(|(_, time)| format!("{time:.4}"))),
                show(bits),
                show(gauss.map(|time| format!("{time:.4}"))),
                parallel.dimension_modulo_translations(),
            );
        }
    }
}

fn show(value: Option<impl ToString>) -> String {
    value.map_or_else(|| "-".into(), |v| v.to_string())
}

fn timed<R>(f: impl FnOnce() -> R) -> (R, f64) {
    let start = Instant::now();
    let result = f();
    (result, start.elapsed().as_secs_f64())
}

fn longest(basis: &[Mesh<Rational>]) -> u64 {
    let heights = basis.iter().flat_map(|mesh| &mesh.points).map(|p| &p.z);
    heights.map(|z| z.numerator().bits().max(z.denominator().bits())).max().unwrap_or(0)
}

/// A stream of integers from 0 to `below − 1` (splitmix64).
fn random(seed: u64, below: u64) -> impl Iterator<Item = i64> {
    (1..).map(move |i: u64| {
        let mut z = seed.wrapping_add(i.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (((z ^ (z >> 31)) >> 11) % below) as i64
    })
}

fn translational(side: usize) -> Mesh<Rational> {
    let profile = |seed| {
        let numbers = random(seed, 9).zip(random(seed + 1, 9)).zip(random(seed + 2, 9));
        let points = numbers.enumerate().map(|(i, ((p, q), z))| {
            let x = Rational::from_i64(i as i64) + Rational::from_ratio(p, 9 + q);
            (x, Rational::from_ratio(z, 1 + q))
        });
        points.take(side + 1).collect::<Vec<_>>()
    };
    translational_net(&profile(1), &profile(4)).expect("a grid is a mesh")
}

fn general(side: usize) -> Mesh<Rational> {
    let moves = random(9, 7).zip(random(10, 7)).enumerate().take((side + 1) * (side + 1));
    let at = |i: usize, moved: i64| Rational::from_i64(10 * i as i64 + moved - 3);
    let place = |(k, (a, b))| {
        Point::new(at(k / (side + 1), a), at(k % (side + 1), b), Rational::from_i64(0))
    };
    Mesh::new(moves.map(place).collect(), quad_patch(side, side)).expect("a grid is a mesh")
}

/// Gauss and Jordan on fractions, row by row, for the heights of v-parallel meshes: the nullity
/// and, in the reduced rows, the basis.
fn gauss(mesh: &Mesh<Rational>) -> usize {
    let mut rows: Vec<Vec<Rational>> = Vec::new();
    for f in mesh.topology.faces() {
        let at = [0, 1, 2, 3].map(|i| mesh.topology.face(f)[i].index());
        let area = |i: usize, j: usize, k: usize| {
            let [a, b, c] = [i, j, k].map(|i| mesh.points[at[i]].top_view());
            (&b - &a).det(&(&c - &a))
        };
        let mut row = vec![Rational::zero(); mesh.points.len()];
        row[at[0]] = area(1, 2, 3);
        row[at[1]] = -area(0, 2, 3);
        row[at[2]] = area(0, 1, 3);
        row[at[3]] = -area(0, 1, 2);
        rows.push(row);
    }
    let mut rank = 0;
    for column in 0..mesh.points.len() {
        let Some(r) = (rank..rows.len()).find(|&r| !rows[r][column].is_zero()) else { continue };
        rows.swap(rank, r);
        let mut pivot = std::mem::take(&mut rows[rank]);
        let inverse = Rational::one() / &pivot[column];
        pivot.iter_mut().filter(|a| !a.is_zero()).for_each(|a| *a = &*a * &inverse);
        for row in rows.iter_mut().filter(|row| !row.is_empty() && !row[column].is_zero()) {
            let factor = row[column].clone();
            let entries = row.iter_mut().zip(&pivot).filter(|(_, p)| !p.is_zero());
            entries.for_each(|(a, p)| *a -= &(&factor * p));
        }
        rows[rank] = pivot;
        rank += 1;
    }
    mesh.points.len() - rank
}
