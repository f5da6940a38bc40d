//! Delaunay meshes of uniform random points: spade's doubles alone, and the exact, canonical mesh.
//!
//! `cargo bench --bench triangulate`

use divan::Bencher;
use isogeo::construct::delaunay;
use isogeo::scalar::{Approx, Field, Rational, Ring};
use isogeo::space::Point;
use spade::{DelaunayTriangulation, Point2, Triangulation};

fn main() {
    divan::main();
}

/// Coordinates `k / 2^53` from splitmix64.
fn uniform(n: usize) -> Vec<Point<Rational>> {
    let mut state = 1u64;
    let mut coordinate = || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        Rational::from_ratio(((z ^ (z >> 31)) >> 11) as i64, 1 << 53)
    };
    (0..n).map(|_| Point::new(coordinate(), coordinate(), Rational::zero())).collect()
}

/// A square grid of tenths: every square is a tie, and no double is exact.
fn grid(n: usize) -> Vec<Point<Rational>> {
    let side = n.isqrt() as i64;
    let tenth = |k: i64| Rational::from_ratio(k, 10);
    (0..side * side)
        .map(|k| Point::new(tenth(k / side), tenth(k % side), Rational::zero()))
        .collect()
}

#[divan::bench(args = [100_000, 1_000_000], sample_count = 3)]
fn spade_alone(bencher: Bencher<'_, '_>, n: usize) {
    let places: Vec<Point2<f64>> =
        uniform(n).iter().map(|p| Point2::new(p.x.to_f64(), p.y.to_f64())).collect();
    bencher.with_inputs(|| places.clone()).bench_values(|places| {
        DelaunayTriangulation::<Point2<f64>>::bulk_load(places).map(|t| t.num_inner_faces())
    });
}

#[divan::bench(args = [100_000, 1_000_000], sample_count = 3)]
fn exact_uniform(bencher: Bencher<'_, '_>, n: usize) {
    let points = uniform(n);
    bencher.with_inputs(|| points.clone()).bench_values(delaunay);
}

#[divan::bench(args = [250_000], sample_count = 3)]
fn exact_grid(bencher: Bencher<'_, '_>, n: usize) {
    let points = grid(n);
    bencher.with_inputs(|| points.clone()).bench_values(delaunay);
}
