//! What the scalars cost: the mixed area of two polygons of 64 corners in every instance, and
//! single multiplications.
//!
//! `generic::<f64>` beside `by_hand` shows the price of writing formulas once: none.
//!
//! `cargo bench --bench scalar`

use divan::{Bencher, black_box};
use isogeo::scalar::{
    Ball, BigInt, BigRational, Dual, Field, Prime61, Quadratic, Rational, Residue, Ring,
};

const CORNERS: usize = 64;
type Polygon<T> = Vec<[T; 2]>;

fn main() {
    divan::main();
}

/// Four times the mixed area, in any ring.
fn mixed_area<T: Ring>(p: &[[T; 2]], q: &[[T; 2]]) -> T {
    let mut sum = T::zero();
    for i in 0..p.len() {
        let j = if i + 1 < p.len() { i + 1 } else { 0 };
        sum += &T::det2(&p[i][0], &p[i][1], &q[j][0], &q[j][1]);
        sum += &T::det2(&q[i][0], &q[i][1], &p[j][0], &p[j][1]);
    }
    sum
}

/// The same, written for doubles.
fn mixed_area_by_hand(p: &[[f64; 2]], q: &[[f64; 2]]) -> f64 {
    let mut sum = 0.0;
    for i in 0..p.len() {
        let j = if i + 1 < p.len() { i + 1 } else { 0 };
        sum += p[i][0] * q[j][1] - p[i][1] * q[j][0];
        sum += q[i][0] * p[j][1] - q[i][1] * p[j][0];
    }
    sum
}

/// Numbers of three digits, the same in every run.
fn digits() -> impl FnMut() -> i64 {
    let mut state = 1u64;
    move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as i64 % 1000 - 500
    }
}

fn polygons<T>(mut number: impl FnMut() -> T) -> [Polygon<T>; 2] {
    let mut polygon = || (0..CORNERS).map(|_| [number(), number()]).collect();
    [polygon(), polygon()]
}

fn run<T: Ring>(bencher: Bencher, number: impl FnMut() -> T) {
    let [p, q] = polygons(number);
    bencher.bench(|| mixed_area(black_box(&p), black_box(&q)));
}

/// Coordinates with the common denominator 1000.
fn thousandths<T: Field>(bencher: Bencher) {
    let mut digit = digits();
    run(bencher, || T::from_ratio(digit(), 1000));
}

mod mixed_area_of_64_corners {
    use super::*;

    #[divan::bench]
    fn by_hand(bencher: Bencher) {
        let mut digit = digits();
        let [p, q] = polygons(|| f64::from_ratio(digit(), 1000));
        bencher.bench(|| mixed_area_by_hand(black_box(&p), black_box(&q)));
    }

    #[divan::bench(types = [f64, Prime61, Rational, BigRational])]
    fn generic<T: Field>(bencher: Bencher) {
        thousandths::<T>(bencher);
    }

    #[divan::bench(types = [f64, Rational])]
    fn dual_of_2<T: Field>(bencher: Bencher) {
        let mut digit = digits();
        let mut number = move || T::from_ratio(digit(), 1000);
        run(bencher, || Dual { value: number(), partials: [number(), number()] });
    }

    #[divan::bench(types = [f64, Rational])]
    fn quadratic<T: Field>(bencher: Bencher) {
        let mut digit = digits();
        let mut number = move || T::from_ratio(digit(), 1000);
        run(bencher, || Quadratic::<T, 3>::new(number(), number()));
    }

    #[divan::bench(types = [BigInt, Residue<2>, Residue<4>, Ball<f64>])]
    fn of_integers<T: Ring>(bencher: Bencher) {
        let mut digit = digits();
        run(bencher, || T::from_i64(digit()));
    }
}

/// 64 independent products.
#[divan::bench(types = [f64, Prime61, Residue<2>, Residue<3>, Residue<4>, Ball<f64>], consts = [64])]
fn multiplications<T: Ring, const N: usize>(bencher: Bencher) {
    let mut digit = digits();
    let mut number = || (0..13).fold(T::one(), |x, _| x * T::from_i64(digit() | 1));
    let factors: [(T, T); N] = std::array::from_fn(|_| (number(), number()));
    bencher.bench(|| {
        for (a, b) in black_box(&factors) {
            black_box(a * b);
        }
    });
}

/// 64 inverses in the prime field.
#[divan::bench]
fn inverses_in_the_prime_field(bencher: Bencher) {
    let mut digit = digits();
    let numbers: [Prime61; 64] = std::array::from_fn(|_| Prime61::from_ratio(digit() | 1, 999));
    bencher.bench(|| {
        for x in black_box(&numbers) {
            black_box(x.try_inv());
        }
    });
}
