//! Closed forms of derivatives against dual numbers, and those against exact differences.

use isogeo::check::Residual;
use isogeo::net::i_circular::Concyclic;
use isogeo::net::i_conical::{Balance, ConcyclicGradients};
use isogeo::net::planar::Coplanar;
use isogeo::optimise::{AnglesInSpace, Differentiable, by_dual_numbers};
use isogeo::scalar::{Dual, Ring};
use isogeo::space::Point;
use proptest::prelude::*;

/// Points with whole coordinates: every product of a residual of low degree is exact in doubles.
fn points<const K: usize>() -> impl Strategy<Value = [Point<f64>; K]> {
    let coordinate = || (-60i32..=60).prop_map(f64::from);
    let point =
        (coordinate(), coordinate(), coordinate()).prop_map(|(x, y, z)| Point::new(x, y, z));
    proptest::collection::vec(point, K).prop_map(|list| std::array::from_fn(|i| list[i]))
}

/// Closed form and dual numbers, to the last bit where all numbers are whole.
fn agree<R, const K: usize>(residual: R, at: &[Point<f64>; K]) -> Result<(), TestCaseError>
where
    R: Differentiable<K> + Residual<K>,
{
    let expected = by_dual_numbers(at, |p| residual.eval(p, &Dual::one()));
    prop_assert_eq!(residual.gradient(at), expected);
    prop_assert_eq!(Differentiable::value(residual, at), expected.0);
    Ok(())
}

proptest! {
    #[test]
    fn the_volume_has_its_cofactors(at in points()) {
        agree(Coplanar, &at)?;
    }

    #[test]
    fn the_in_circle_determinant_has_its_derivatives(at in points()) {
        agree(Concyclic, &at)?;
    }

    #[test]
    fn the_balance_has_its_derivatives(at in points()) {
        agree(Balance, &at)?;
    }

    /// In each coordinate the volume is linear: a difference is the derivative. So a wrong sign in a
    /// closed form would be seen without dual numbers, too.
    #[test]
    fn a_difference_of_volumes_is_the_derivative(at in points::<4>(), i in 0usize..4) {
        let (value, slopes) = Coplanar.gradient(&at);
        let mut moved = at;
        moved[i].z += 1.0;
        prop_assert_eq!(Differentiable::value(Coplanar, &moved) - value, slopes[i].z);
        moved[i].z += 1.0;
        prop_assert_ne!(Differentiable::value(Coplanar, &moved) - value, slopes[i].z + if slopes[i].z == 0.0 { 1.0 } else { 0.0 });
    }

    /// Euler's identity: the degree times the value is the derivative along the position.
    #[test]
    fn gradients_of_concyclic_gradients_are_homogeneous(at in points::<12>()) {
        let (value, slopes) = ConcyclicGradients.gradient(&at);
        let along: f64 = slopes.iter().zip(&at).map(|(s, p)| s.x * p.x + s.y * p.y + s.z * p.z).sum();
        let scale: f64 = slopes.iter().zip(&at)
            .map(|(s, p)| (s.x * p.x).abs() + (s.y * p.y).abs() + (s.z * p.z).abs()).sum();
        prop_assert!((along - 16.0 * value).abs() <= 256.0 * f64::EPSILON * (scale + value.abs()));
    }

    /// The derivative of the angles against differences of twice the step: they agree to second order.
    #[test]
    fn angles_in_space_have_their_derivatives(at in points::<5>(), i in 0usize..5, axis in 0usize..3) {
        let edges = (1..5).map(|k| &at[k] - &at[0]);
        let edges: Vec<_> = edges.collect();
        prop_assume!((0..4).all(|k| edges[k].cross(&edges[(k + 1) % 4]).length2() >= 1e4));
        let slope = AnglesInSpace.gradient(&at).1[i];
        let slope = [slope.x, slope.y, slope.z][axis];
        let difference = |h: f64| {
            let at = |sign: f64| {
                let mut moved = at;
                let [x, y, z] = [0, 1, 2].map(|k| if k == axis { sign * h } else { 0.0 });
                moved[i] = Point::new(at[i].x + x, at[i].y + y, at[i].z + z);
                AnglesInSpace.value(&moved)
            };
            (at(1.0) - at(-1.0)) / (2.0 * h)
        };
        prop_assert!((difference(1e-3) - slope).abs() < 1e-6, "{slope} {}", difference(1e-3));
        prop_assert!((difference(1e-3) + slope).abs() > 1e-6 || slope.abs() < 1e-6);
    }
}
