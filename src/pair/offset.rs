//! Offsets M + dS, and their curvatures as functions of d (18).

use super::{Curvatures, FParallel, Forms, Parallel, Roots, VParallel};
use crate::mesh::{Data, Mesh};
use crate::scalar::{Field, RationalField, Ring};
use crate::space::{Point, TopView};

/// H and K of the offset faces `F + dS`, seen with the same S, as rational functions of d (18).
///
/// Numerators and denominator are polynomials in d, given by ascending coefficients and four times
/// as large as the areas:
///
/// ```math
/// H(Fᵈ) = (area(F, S) + d area(S)) / (area(F) + 2d area(F, S) + d² area(S)),
/// K(Fᵈ) = area(S) / (area(F) + 2d area(F, S) + d² area(S)).
/// ```
///
/// This holds for every k-gon, also where `area(F) = 0` and H, K of F itself are not defined.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OffsetLaw<T> {
    four: Forms<T>,
}

impl<T: Ring> OffsetLaw<T> {
    pub(super) const fn new(four: Forms<T>) -> Self {
        OffsetLaw { four }
    }

    /// The numerator of H, of degree 1.
    pub fn mean_numerator(&self) -> [T; 2] {
        [self.four.mixed.clone(), self.four.second.clone()]
    }

    /// The numerator of K, a constant.
    pub fn gauss_numerator(&self) -> &T {
        &self.four.second
    }

    /// The common denominator, of degree 2: four times the area of the offset face.
    pub fn denominator(&self) -> [T; 3] {
        let Forms { first, mixed, second } = &self.four;
        [first.clone(), mixed * T::from_i64(2), second.clone()]
    }
}

impl<T: Field> OffsetLaw<T> {
    /// H and K at a distance, from the formula; `None` at a critical one.
    pub fn at(&self, d: &T) -> Option<Curvatures<T>> {
        self.four.offset(d).at_face()
    }
}

impl<T: RationalField> OffsetLaw<T> {
    /// The critical distances, at which the area of the offset face vanishes: `−1/κ` for the
    /// principal curvatures κ that are not 0.
    pub fn critical(&self) -> Roots<T> {
        Roots::of(&self.four.second, &self.four.mixed, &self.four.first)
    }
}

/// What (15)–(18) leave over on two polygons: everything about `F + dS` is computed from its
/// corners and compared with what the formulas say from F and S. All three are 0.
#[derive(Clone, Debug, PartialEq)]
pub struct OffsetResiduals<T> {
    /// `4 area(F + dS)` less the polynomial in d.
    pub area: T,
    /// H of `F + dS` by (17) less what (18) says.
    pub mean: T,
    /// K of `F + dS` by (17) less what (18) says.
    pub gauss: T,
}

impl<T: Field> OffsetResiduals<T> {
    /// The residuals of two polygons with the same number of corners, of any shape; `None` where F
    /// or `F + dS` has area 0.
    ///
    /// ```
    /// use isogeo::pair::OffsetResiduals;
    /// use isogeo::scalar::{Field, Rational, Ring};
    /// use isogeo::space::TopView;
    /// let at = |x, y| TopView::new(Rational::from_i64(x), Rational::from_i64(y));
    /// let (f, s) = ([at(0, 0), at(3, 1), at(1, 2)], [at(5, 0), at(0, 1), at(1, 7)]);
    /// let zero = Rational::zero();
    /// let none = OffsetResiduals { area: zero.clone(), mean: zero.clone(), gauss: zero };
    /// assert_eq!(OffsetResiduals::of(&f, &s, &Rational::from_ratio(1, 2)), Some(none));
    /// ```
    pub fn of(f: &[TopView<T>], s: &[TopView<T>], d: &T) -> Option<Self> {
        let moved: Vec<_> = f.iter().zip(s).map(|(v, w)| v + &w.position().scaled(d)).collect();
        Self::of_forms(&Forms::of(f, s), Forms::of(&moved, s), d)
    }

    /// The residuals from the forms of F, S and of `F + dS`, S.
    pub(super) fn of_forms(base: &Forms<T>, offset: Forms<T>, d: &T) -> Option<Self> {
        let (expected, found) = (base.at_face()?.offset(d)?, offset.at_face()?);
        Some(OffsetResiduals {
            area: offset.first - base.offset(d).first,
            mean: found.mean - expected.mean,
            gauss: found.gauss - expected.gauss,
        })
    }

    /// Whether all are 0.
    pub fn vanish(&self) -> bool {
        [&self.area, &self.mean, &self.gauss].into_iter().all(T::is_zero)
    }
}

impl<T: Ring> Parallel<'_, T> {
    /// The offset `M + dS`, vertex by vertex: parallel to M and to S.
    pub fn offset(&self, d: &T) -> Mesh<T> {
        sum(self.mesh(), self.image(), d)
    }
}

impl<T: Field> FParallel<'_, T> {
    /// The offset `M + dS`, vertex by vertex: its faces are parallel to those of M and of S, but
    /// for critical d they may degenerate.
    pub fn offset(&self, d: &T) -> Mesh<T> {
        sum(self.mesh(), self.image(), d)
    }
}

impl<T: Field> VParallel<'_, T> {
    /// The offset in the vertical sense: the points `(m', z_m + d z_s)`, v-parallel to M and to S.
    pub fn offset(&self, d: &T) -> Mesh<T> {
        combined(self.mesh(), self.image(), |m, s| {
            Point::new(m.x.clone(), m.y.clone(), &m.z + d * &s.z)
        })
    }
}

fn sum<T: Ring>(mesh: &Mesh<T>, image: &Mesh<T>, d: &T) -> Mesh<T> {
    combined(mesh, image, |m, s| Point::new(&m.x + d * &s.x, &m.y + d * &s.y, &m.z + d * &s.z))
}

fn combined<T: Clone>(
    mesh: &Mesh<T>,
    image: &Mesh<T>,
    point: impl Fn(&Point<T>, &Point<T>) -> Point<T>,
) -> Mesh<T> {
    let points = mesh.points.iter().zip(&image.points).map(|(m, s)| point(m, s)).collect();
    Mesh { topology: mesh.topology.clone(), points, data: Data::default() }
}
