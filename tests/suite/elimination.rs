//! Sparse elimination over ℚ against plain Gauss on fractions.

use isogeo::scalar::{
    BigRational, Echelon, Field, LinearSystem, NoSuchUnknown, Rational, RationalField, Ring,
};
use proptest::prelude::*;

type Q = BigRational;
type Matrix<T> = Vec<Vec<T>>;

/// Gauss on fractions, first pivot that is not 0: the reduced rows and their pivot columns.
pub fn gauss<T: Field>(mut rows: Matrix<T>) -> (Matrix<T>, Vec<usize>) {
    let columns = rows.first().map_or(0, Vec::len);
    let mut pivots = Vec::new();
    for c in 0..columns {
        let rank = pivots.len();
        let Some(r) = (rank..rows.len()).find(|&r| !rows[r][c].is_zero()) else { continue };
        rows.swap(rank, r);
        let inverse = rows[rank][c].try_inv().expect("not 0");
        rows[rank].iter_mut().for_each(|a| *a = &*a * &inverse);
        let pivot = rows[rank].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(r, _)| *r != rank) {
            let factor = row[c].clone();
            if !factor.is_zero() {
                row.iter_mut().zip(&pivot).for_each(|(a, p)| *a -= &(&factor * p));
            }
        }
        pivots.push(c);
    }
    rows.truncate(pivots.len());
    (rows, pivots)
}

fn rank<T: Field>(rows: &Matrix<T>) -> usize {
    gauss(rows.clone()).1.len()
}

fn system<T: RationalField>(unknowns: usize, rows: &Matrix<T>) -> LinearSystem {
    let mut system = LinearSystem::new(unknowns);
    for row in rows {
        system.push(row.iter().cloned().enumerate()).expect("indices in range");
    }
    system
}

fn times<T: Ring>(rows: &Matrix<T>, x: &[T]) -> Vec<T> {
    let product = |row: &Vec<T>| row.iter().zip(x).fold(T::zero(), |s, (a, x)| s + a * x);
    rows.iter().map(product).collect()
}

/// Everything that must hold for the kernel of a matrix.
fn kernel_is_right<T: RationalField>(unknowns: usize, rows: &Matrix<T>, solved: &Echelon<'_>) {
    assert_eq!(solved.rank(), rank(rows), "the rank of {rows:?}");
    assert_eq!(solved.rank() + solved.nullity(), unknowns);
    let (kernel, free): (Matrix<T>, _) = (solved.kernel(), solved.free_unknowns());
    assert_eq!(kernel.len(), solved.nullity());
    for (k, vector) in kernel.iter().enumerate() {
        assert!(times(rows, vector).iter().all(Ring::is_zero), "vector {k} of {rows:?}");
        assert_eq!(&solved.kernel_vector::<T>(k).expect("k below the nullity"), vector);
        for (j, &c) in free.iter().enumerate() {
            assert_eq!(vector[c], T::from_i64(i64::from(j == k)), "vector {k} at {c}");
        }
    }
    for (_, c) in solved.pivots() {
        assert!(!free.contains(&c), "unknown {c} is both free and determined");
    }
}

/// Sparse matrices with repeated and combined rows, so that ranks fall.
fn matrices() -> impl Strategy<Value = (usize, Matrix<Q>)> {
    let entry = prop_oneof![
        3 => Just((0i64, 1i64)),
        3 => (-3i64..=3, 1i64..=3),
        1 => (any::<i64>(), 1i64..=i64::MAX),
    ];
    (0usize..=7, 0usize..=6)
        .prop_flat_map(move |(columns, rows)| {
            let row = prop::collection::vec(entry.clone(), columns);
            let mixes = prop::collection::vec((0usize..8, 0usize..8, -2i64..=2), 0..=4);
            (Just(columns), prop::collection::vec(row, rows), mixes)
        })
        .prop_map(|(columns, rows, mixes)| {
            let fraction = |(p, q)| Q::from_ratio(p, q);
            let mut rows: Matrix<Q> =
                rows.into_iter().map(|row| row.into_iter().map(fraction).collect()).collect();
            for (a, b, factor) in mixes {
                if let (Some(a), Some(b)) = (rows.get(a).cloned(), rows.get(b)) {
                    let factor = Q::from_i64(factor);
                    rows.push(a.iter().zip(b).map(|(a, b)| a + &factor * b).collect());
                }
            }
            (columns, rows)
        })
}

fn convert<T: RationalField>(rows: &Matrix<Q>) -> Matrix<T> {
    rows.iter().map(|row| row.iter().map(RationalField::convert).collect()).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn ranks_and_kernels_are_those_of_gauss((columns, rows) in matrices()) {
        kernel_is_right::<Q>(columns, &rows, &system(columns, &rows).eliminate());
        let rows = convert::<Rational>(&rows);
        kernel_is_right::<Rational>(columns, &rows, &system(columns, &rows).eliminate());
    }

    #[test]
    fn solutions_solve_and_refusals_are_right(
        (columns, rows) in matrices(),
        x in prop::collection::vec((-5i64..=5, 1i64..=4), 7),
        moved in (0usize..10, 0i64..=1),
    ) {
        let x: Vec<Q> = x[..columns].iter().map(|&(p, q)| Q::from_ratio(p, q)).collect();
        let mut b = times(&rows, &x);
        if let Some(value) = b.get_mut(moved.0) {
            *value += &Q::from_i64(moved.1);
        }
        let system = system(columns, &rows);
        let solution = system.eliminate().solve(&b).expect("a value for every equation");
        let extended: Matrix<Q> =
            rows.iter().zip(&b).map(|(row, b)| [&row[..], std::slice::from_ref(b)].concat()).collect();
        prop_assert_eq!(solution.is_some(), rank(&extended) == rank(&rows));
        if let Some(solution) = solution {
            prop_assert_eq!(times(&rows, &solution), b);
        }
    }
}

#[test]
fn nothing_is_no_trouble() {
    let empty = LinearSystem::new(0);
    assert_eq!((empty.eliminate().rank(), empty.eliminate().nullity()), (0, 0));
    assert_eq!(empty.eliminate().solve::<Q>(&[]), Ok(Some(vec![])));
    let mut zeros = LinearSystem::new(3);
    zeros.push::<Q>([]).expect("no index");
    zeros.push([(1, Q::from_i64(2)), (1, Q::from_i64(-2))]).expect("index 1 of 3");
    let solved = zeros.eliminate();
    assert_eq!((solved.rank(), solved.nullity(), zeros.equations()), (0, 3, 2));
    kernel_is_right(3, &vec![vec![Q::from_i64(0); 3]; 2], &solved);
    assert_eq!(solved.solve(&[Q::from_i64(0), Q::from_i64(1)]), Ok(None), "0 = 1");
    assert_eq!(solved.kernel_vector::<Q>(3), Err(NoSuchUnknown { index: 3, limit: 3 }));
    assert_eq!(solved.solve::<Q>(&[]), Err(NoSuchUnknown { index: 0, limit: 2 }));
    let before = zeros.clone().push([(0, Q::from_i64(1)), (3, Q::from_i64(1))]);
    assert_eq!(before, Err(NoSuchUnknown { index: 3, limit: 3 }));
}

/// The first primes that are used: where they divide minors, the answer must not change.
const PRIMES: [i64; 3] = [(1 << 62) - 57, (1 << 62) - 87, (1 << 62) - 117];

#[test]
fn unlucky_primes_do_not_lower_the_rank() {
    let product = PRIMES.iter().fold(Q::from_i64(1), |p, n| p * Q::from_i64(*n));
    let one = Q::from_i64(1);
    // The determinant is the product of the primes; modulo any of them the rank is 2 of 3.
    let rows = vec![
        vec![one.clone(), one.clone(), Q::from_i64(0)],
        vec![one.clone(), &one + &product, Q::from_i64(0)],
        vec![Q::from_i64(0), Q::from_i64(0), Q::from_i64(5)],
    ];
    kernel_is_right(3, &rows, &system(3, &rows).eliminate());
    // The same with a dependent row, an unknown too many, and an entry that vanishes.
    let rows = vec![
        vec![one.clone(), one.clone(), product.clone(), one.clone()],
        vec![one.clone(), &one + &product, Q::from_i64(0), one.clone()],
        vec![Q::from_i64(2), &one + &one + &product, product, Q::from_i64(2)],
    ];
    kernel_is_right(4, &rows, &system(4, &rows).eliminate());
    let fractions: Matrix<Q> =
        rows.iter().map(|r| r.iter().map(|a| a / Q::from_i64(PRIMES[1])).collect()).collect();
    kernel_is_right(4, &fractions, &system(4, &fractions).eliminate());
}

#[test]
fn long_numbers_are_reconstructed() {
    // x[i + 1] = (p / q) x[i]: the last is a fraction of 61 · 25 bits above and below.
    let (p, q) = (Q::from_i64((1 << 61) - 1), Q::from_i64(3i64.pow(38)));
    let mut chain = LinearSystem::new(26);
    for i in 0..25 {
        chain.push([(i, p.clone()), (i + 1, -&q)]).expect("26 unknowns");
    }
    let kernel: Matrix<Q> = chain.eliminate().kernel();
    assert_eq!(kernel.len(), 1);
    let ratio = (0..25).fold(Q::from_i64(1), |r, _| r * &p / &q);
    assert_eq!(&kernel[0][25] / &kernel[0][0], ratio);
}

/// The Hilbert matrix is regular, and its last rows are a classic for what elimination loses.
#[test]
fn hilbert_has_full_rank_and_an_integer_inverse() {
    let n = 12;
    let entry = |i: usize, j: usize| Q::from_ratio(1, (i + j + 1) as i64);
    let rows: Matrix<Q> = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
    let system = system(n, &rows);
    assert_eq!(system.eliminate().rank(), n);
    let mut b = vec![Q::from_i64(0); n];
    b[0] = Q::from_i64(1);
    let x = system.eliminate().solve(&b).expect("n values").expect("regular");
    assert_eq!(x[0], Q::from_i64((n * n) as i64), "the first entry of the inverse is n²");
    // Negative control: with the last row replaced by the sum of two others the rank falls.
    let mut singular = rows;
    singular[n - 1] = singular[0].iter().zip(&singular[1]).map(|(a, b)| a + b).collect();
    kernel_is_right(n, &singular, &self::system(n, &singular).eliminate());
    assert_eq!(rank(&singular), n - 1);
}
