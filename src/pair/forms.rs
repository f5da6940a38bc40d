//! The three values of the area form on a pair of polygons.

use super::{Corner, Curvatures};
use crate::scalar::{Field, Ring};
use crate::space::Vector2;

/// `4 area(F)`, `4 area(F, S)` and `4 area(S)`: the area form and its polar form on a pair, four
/// times as large, so that no division is needed.
///
/// Faces put their top views in (15)–(17), vertices the gradients of their faces (21)–(22).
///
/// ```
/// use isogeo::pair::Forms;
/// use isogeo::space::Gradient;
/// let ring = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)].map(|(x, y)| Gradient::new(x, y));
/// let twice = ring.map(|p| Gradient::new(2.0 * p.x, 2.0 * p.y));
/// assert_eq!(Forms::of(&twice, &ring), Forms { first: 32.0, mixed: 16.0, second: 8.0 });
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Forms<T> {
    /// `4 area(F)`, of the polygon that belongs to M.
    pub first: T,
    /// `4 area(F, S)`.
    pub mixed: T,
    /// `4 area(S)`, of the polygon that belongs to S.
    pub second: T,
}

impl<T> Forms<T> {
    /// The forms in other numbers.
    pub fn map<S>(&self, f: impl Fn(&T) -> S) -> Forms<S> {
        Forms { first: f(&self.first), mixed: f(&self.mixed), second: f(&self.second) }
    }

    /// The forms in other numbers, if all of them are such.
    pub fn try_map<S>(&self, f: impl Fn(&T) -> Option<S>) -> Option<Forms<S>> {
        Some(Forms { first: f(&self.first)?, mixed: f(&self.mixed)?, second: f(&self.second)? })
    }
}

impl<T: Ring> Forms<T> {
    /// The forms of two polygons with the same number of corners.
    pub fn of<P: Corner<T>>(f: &[P], s: &[P]) -> Self {
        let (Some((first_f, f)), Some((first_s, s))) = (f.split_first(), s.split_first()) else {
            return Forms::zero();
        };
        Self::of_fan(f.iter().zip(s).map(|(v, w)| (v.seen_from(first_f), w.seen_from(first_s))))
    }

    /// The forms of two polygons from their corners after the first, each seen from the first.
    #[inline]
    pub fn of_fan(mut corners: impl Iterator<Item = (Vector2<T>, Vector2<T>)>) -> Self {
        let Some((mut v, mut w)) = corners.next() else {
            return Forms::zero();
        };
        let mut sum = Forms::zero();
        for (next_v, next_w) in corners {
            sum.first += &v.det(&next_v);
            sum.mixed += &(v.det(&next_w) + w.det(&next_v));
            sum.second += &w.det(&next_w);
            (v, w) = (next_v, next_w);
        }
        let two = T::from_i64(2);
        Forms { first: sum.first * &two, mixed: sum.mixed, second: sum.second * two }
    }

    /// `16 (area(F, S)² − area(F) area(S))`: has the sign of `H² − K`, for faces and for vertices.
    ///
    /// Never negative for convex polygons with parallel edges (Minkowski); without convexity it
    /// may be.
    pub fn discriminant(&self) -> T {
        self.mixed.square() - &self.first * &self.second
    }

    /// The forms of the polygons `F + dS` and `S`, by the polar identity.
    pub fn offset(&self, d: &T) -> Self {
        let mixed = &self.mixed + d * &self.second;
        let first = &self.first + d * (&self.mixed + &mixed);
        Forms { first, mixed, second: self.second.clone() }
    }

    /// `H = mixed/first`, `K = second/first`: the curvatures of a face (17); `None` if `first` is 0.
    pub fn at_face(&self) -> Option<Curvatures<T>>
    where
        T: Field,
    {
        let scale = self.first.try_inv()?;
        Some(Curvatures { mean: &self.mixed * &scale, gauss: &self.second * scale })
    }

    /// `H = mixed/second`, `K = first/second`: the curvatures of a vertex (22); `None` if `second`
    /// is 0.
    pub fn at_vertex(&self) -> Option<Curvatures<T>>
    where
        T: Field,
    {
        let scale = self.second.try_inv()?;
        Some(Curvatures { mean: &self.mixed * &scale, gauss: &self.first * scale })
    }

    /// All values with the opposite sign: the forms seen from the other side.
    pub fn reversed(&self) -> Self {
        Forms { first: -&self.first, mixed: -&self.mixed, second: -&self.second }
    }

    /// The sum, value by value.
    pub fn plus(&self, other: &Self) -> Self {
        Forms {
            first: &self.first + &other.first,
            mixed: &self.mixed + &other.mixed,
            second: &self.second + &other.second,
        }
    }

    /// The forms of empty polygons.
    pub fn zero() -> Self {
        Forms { first: T::zero(), mixed: T::zero(), second: T::zero() }
    }
}
