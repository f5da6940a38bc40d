//! Forms of integers over two units, put over one common denominator.

use num_integer::Integer as _;

use super::Forms;
use crate::scalar::{BigInt, Fraction, Ring};

/// The quotient of the unit of M and the unit of S, in lowest terms; powers of two apart, so that
/// most meshes of doubles need no multiplication.
#[derive(Clone, Debug)]
pub(super) struct Units {
    /// `s²`, `ms`, `m²` for the odd parts.
    odd: Option<[BigInt; 3]>,
    /// The exponents of two in m and in s.
    twos: [u64; 2],
}

impl Units {
    pub fn new(mesh: BigInt, image: BigInt) -> Self {
        let common = mesh.gcd(&image);
        let [(m, twos_m), (s, twos_s)] = [mesh / &common, image / common].map(|n| {
            let twos = n.trailing_zeros().unwrap_or(0);
            (n >> twos, twos)
        });
        let squares = [s.square(), &m * &s, m.square()];
        let one = BigInt::one();
        let odd = (m != one || s != one).then_some(squares);
        Units { odd, twos: [twos_m, twos_s] }
    }

    /// `first / scale`, `mixed m / (s scale)`, `second m² / (s² scale)`, where every number is to be
    /// multiplied by a power of two first.
    pub fn apply(
        &self,
        forms: Forms<BigInt>,
        twos: [u32; 3],
        scale: BigInt,
        scale_twos: u32,
    ) -> Forms<Fraction<BigInt>> {
        let [m, s] = self.twos;
        let [first, mixed, second] = twos.map(u64::from);
        let twos = [first + 2 * s, mixed + m + s, second + 2 * m];
        let scale_twos = u64::from(scale_twos) + 2 * s;
        let least = twos.iter().fold(scale_twos, |least, &t| least.min(t));
        let odd = |n: BigInt, i: usize| match &self.odd {
            Some(factors) => n * &factors[i],
            None => n,
        };
        let scale = odd(scale, 0) << (scale_twos - least);
        let fraction =
            |n: BigInt, i: usize| Fraction::new(odd(n, i) << (twos[i] - least), scale.clone());
        Forms {
            first: fraction(forms.first, 0),
            mixed: fraction(forms.mixed, 1),
            second: fraction(forms.second, 2),
        }
    }
}
