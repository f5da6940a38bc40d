//! i-circular nets of several figures: translational nets and their images under inversions.

use super::{NoFigure, Surface};
use crate::construct::{moebius_image, translational_net};
use crate::scalar::{Field, Rational, Ring};
use crate::space::{Circle, CylindricalSphere, MoebiusTransformation, Point};

/// The samples `(x, f(x))` at the positions `(2i − n) step/2`, `0 ≤ i ≤ n`.
pub(super) fn profile(
    n: i64,
    step: &Rational,
    f: impl Fn(&Rational) -> Rational,
) -> Vec<(Rational, Rational)> {
    let position = |i: i64| Rational::from_ratio(2 * i - n, 2) * step;
    (0..=n).map(|i| (position(i), f(&position(i)))).collect()
}

/// The polynomial `Σ cᵢ xⁱ`, each coefficient as numerator and denominator.
pub(super) fn polynomial(coefficients: &'static [(i64, i64)]) -> impl Fn(&Rational) -> Rational {
    move |x| {
        let add = |sum: Rational, (p, q): &(i64, i64)| sum * x + Rational::from_ratio(*p, *q);
        coefficients.iter().rev().fold(Rational::zero(), add)
    }
}

/// A mesh after the inversion `x ↦ c + r² (x − c)/|x' − c'|²`.
pub(super) fn inverted(
    mesh: &Surface,
    [x, y, z]: [(i64, i64); 3],
    radius2: i64,
) -> Result<Surface, NoFigure> {
    let [x, y, z] = [x, y, z].map(|(p, q)| Rational::from_ratio(p, q));
    let centre = Point::new(x, y, z);
    let circle = Circle::new(centre.top_view(), Rational::from_i64(radius2));
    let sphere = CylindricalSphere::new(circle).map_err(NoFigure::of)?;
    let inversion = MoebiusTransformation::inversion_at_cylinder(&sphere, &centre.z);
    moebius_image(mesh, &inversion).map_err(NoFigure::of)
}

/// The inversion of the net `z = f(x) + g(y)` over a grid.
pub(super) fn inverted_net(
    f: &[(Rational, Rational)],
    g: &[(Rational, Rational)],
    centre: [(i64, i64); 3],
    radius2: i64,
) -> Result<Surface, NoFigure> {
    inverted(&translational_net(f, g)?, centre, radius2)
}
