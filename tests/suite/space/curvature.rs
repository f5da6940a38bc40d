//! Curvatures of smooth surfaces and of their duals (4)–(11).

use isogeo::scalar::{BigRational, Rational, RationalField, Ring};
use isogeo::space::*;
use proptest::prelude::*;

use super::{Draw, Verdict, laws};

laws! {
    tangent_planes_are_parallel_at_the_gauss_image
    motions_keep_curvatures
    scalings_multiply_curvatures
    the_shape_operator_is_the_derivative_of_the_gauss_image
    principal_directions_are_conjugate_and_orthogonal
    the_dual_surface_has_the_inverse_hessian
    the_double_dual_is_the_surface
    the_dual_of_a_quadric_is_the_inverse_quadric
    the_dual_of_an_i_minimal_surface_is_i_minimal
    polynomials_are_a_ring_with_derivations
    spheres_are_the_graphs_of_their_polynomials
}

fn jet<Q: RationalField>(f: &Polynomial<Q>, at: &TopView<Q>) -> Jet2<Q> {
    f.jet(at).unwrap()
}

/// `eq-6-gauss`
fn tangent_planes_are_parallel_at_the_gauss_image<Q: RationalField>(d: &mut Draw<Q>) -> Verdict {
    let sigma = ParabolicSphere::unit();
    let jet = jet(&d.polynomial(), &d.top_view());
    let mut image = jet.gauss_image();
    prop_assert!(sigma.contains(&image));
    prop_assert!(sigma.tangent_plane(&image.top_view()).is_parallel_to(&jet.tangent_plane()));
    image.z += &Q::one();
    prop_assert!(!sigma.contains(&image));
    image.x += &Q::one();
    prop_assert!(!sigma.tangent_plane(&image.top_view()).is_parallel_to(&jet.tangent_plane()));
    Ok(())
}

/// The graph is moved as a whole, by substitution, and as a jet.
fn motions_keep_curvatures<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (motion, f, at) = (draw.motion(), draw.polynomial(), draw.top_view());
    let before = jet(&f, &at);
    let mut moved = motion.apply(&f);
    let after = jet(&moved, &motion.apply(&at));
    prop_assert_eq!(&after, &motion.apply(&before));
    prop_assert_eq!(after.mean_curvature(), before.mean_curvature());
    prop_assert_eq!(after.curvature(), before.curvature());

    moved += &Polynomial::x().square();
    let wrong = jet(&moved, &motion.apply(&at));
    prop_assert_eq!(wrong.mean_curvature(), before.mean_curvature() + Q::one());
    Ok(())
}

fn scalings_multiply_curvatures<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (scaling, f, at) = (draw.scaling(), draw.polynomial(), draw.top_view());
    let shrink = |x| x * Polynomial::constant(scaling.inverse().horizontal());
    let stretched = f.compose(&shrink(Polynomial::x()), &shrink(Polynomial::y()));
    let image = stretched * Polynomial::constant(scaling.vertical());
    let (before, after) = (jet(&f, &at), jet(&image, &scaling.apply(&at)));
    prop_assert_eq!(&after, &scaling.apply(&before));

    let factor = scaling.vertical() / scaling.horizontal().square();
    prop_assert_eq!(after.mean_curvature(), before.mean_curvature() * &factor);
    prop_assert_eq!(after.curvature(), before.curvature() * factor.square());
    let wrong = factor + Q::one();
    let flat = before.mean_curvature().is_zero();
    prop_assert_eq!(after.mean_curvature() == before.mean_curvature() * wrong, flat);
    Ok(())
}

/// (7): for a quadratic f the Gauss image changes by exactly `∇²f v` along `v`.
fn the_shape_operator_is_the_derivative_of_the_gauss_image<Q: RationalField>(
    draw: &mut Draw<Q>,
) -> Verdict {
    let terms = [(2, 0), (1, 1), (0, 2), (1, 0)].map(|(i, j)| (i, j, draw.number()));
    let f = Polynomial::new(terms);
    let (at, v) = (draw.top_view(), draw.vector());
    let (here, there) = (jet(&f, &at), jet(&f, &(&at + &v)));
    let change = |there: &Jet2<Q>| &there.gauss_image().top_view() - &here.gauss_image().top_view();
    prop_assert_eq!(change(&there), here.hessian.apply(&v));
    let x = Polynomial::x();
    let wrong = jet(&(f + &x * &x * &x + &x), &(&at + &v));
    prop_assert_ne!(change(&wrong), here.hessian.apply(&v));
    Ok(())
}

/// With a Hessian made from its eigenvectors `v` and `Jv`.
fn principal_directions_are_conjugate_and_orthogonal<Q: RationalField>(
    draw: &mut Draw<Q>,
) -> Verdict {
    let rotation = draw.rotation();
    let (k1, k2) = (draw.number(), draw.number());
    let spin = Motion { rotation, ..Motion::identity() };
    let hessian = spin.apply(&Hessian { xx: k1.clone(), xy: Q::zero(), yy: k2.clone() });
    let v = spin.apply(&Vector2::new(Q::one(), Q::zero()));
    prop_assert_eq!(hessian.apply(&v), v.scaled(&k1));
    prop_assert!(hessian.principality(&v).is_zero() && hessian.principality(&v.turned()).is_zero());
    prop_assert!(hessian.form(&v, &v.turned()).is_zero());
    prop_assert_eq!(hessian.trace(), &k1 + &k2);
    prop_assert_eq!(hessian.det(), &k1 * &k2);
    let diagonal = &v + &v.turned();
    prop_assert_eq!(hessian.principality(&diagonal).is_zero(), k1 == k2);
    Ok(())
}

/// `eq-10-dual-surface`, `eq-11-curvatures`: the surface (10) is differentiated by itself, knowing
/// nothing of the duality of contact elements.
fn the_dual_surface_has_the_inverse_hessian<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (f, at) = (draw.polynomial(), draw.top_view());
    let surface = jet(&f, &at);
    let dual_surface = ParametricSurface::dual_of(&f);
    prop_assert_eq!(dual_surface.point_at(&at), surface.tangent_plane().dual());
    let (h, k) = (surface.mean_curvature(), surface.curvature());
    let Some(dual) = dual_surface.jet(&at) else {
        prop_assert!(k.is_zero() && surface.dual().is_none());
        return Ok(());
    };
    prop_assert_eq!(Some(dual.clone()), surface.dual());
    prop_assert_eq!(dual.mean_curvature(), &h / &k);
    prop_assert_eq!(dual.curvature(), Q::one() / &k);

    let mut wrong = surface.clone();
    wrong.hessian.xx += &Q::one();
    prop_assert_ne!(Some(dual), wrong.dual());
    Ok(())
}

fn the_double_dual_is_the_surface<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let surface = jet(&draw.polynomial(), &draw.top_view());
    let Some(mut dual) = surface.dual() else {
        prop_assert!(surface.curvature().is_zero());
        return Ok(());
    };
    prop_assert_eq!(dual.dual(), Some(surface.clone()));
    dual.contact.gradient.x += &Q::one();
    prop_assert_ne!(dual.dual(), Some(surface));
    Ok(())
}

/// The dual of `z = (ax² + 2bxy + cy²)/2` is the same with the inverse matrix: as identity of
/// polynomials, the dual surface lies on that graph.
fn the_dual_of_a_quadric_is_the_inverse_quadric<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let quadric = |h: &Hessian<Q>| {
        let half = Q::from_ratio(1, 2);
        Polynomial::new([(2, 0, &h.xx * &half), (1, 1, h.xy.clone()), (0, 2, &h.yy * &half)])
    };
    let hessian = Hessian { xx: draw.number(), xy: draw.number(), yy: draw.number() };
    let Some(mut inverse) = hessian.inverse() else {
        prop_assert!(hessian.det().is_zero());
        return Ok(());
    };
    let ParametricSurface(dual) = ParametricSurface::dual_of(&quadric(&hessian));
    prop_assert_eq!(&quadric(&inverse).compose(&dual.x, &dual.y), &dual.z);
    inverse.yy += &Q::one();
    prop_assert_ne!(&quadric(&inverse).compose(&dual.x, &dual.y), &dual.z);
    Ok(())
}

fn the_dual_of_an_i_minimal_surface_is_i_minimal<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (mut f, at) = (draw.harmonic(), draw.top_view());
    prop_assert!(jet(&f, &at).mean_curvature().is_zero());
    let Some(dual) = ParametricSurface::dual_of(&f).jet(&at) else {
        prop_assert!(jet(&f, &at).curvature().is_zero());
        return Ok(());
    };
    prop_assert!(dual.mean_curvature().is_zero() && dual.curvature() < Q::zero());
    f += &Polynomial::x().square();
    let wrong = ParametricSurface::dual_of(&f).jet(&at);
    prop_assert!(wrong.is_none_or(|dual| !dual.mean_curvature().is_zero()));
    Ok(())
}

fn polynomials_are_a_ring_with_derivations<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (f, g, at) = (draw.polynomial(), draw.polynomial(), draw.top_view());
    let value = |f: &Polynomial<Q>| f.value_at(&at);
    prop_assert_eq!(value(&(&f + &g)), value(&f) + value(&g));
    prop_assert_eq!(value(&(&f - &g)), value(&f) - value(&g));
    prop_assert_eq!(value(&(&f * &g)), value(&f) * value(&g));
    prop_assert_eq!(&(&(&f - &g) + &g), &f);
    prop_assert_eq!(&f * Polynomial::one(), f.clone());
    prop_assert!((&f + -&f).is_zero());
    prop_assert_eq!((&f * &g).dx(), f.dx() * &g + &f * g.dx());
    prop_assert_eq!((&f * &g).dy(), f.dy() * &g + &f * g.dy());
    prop_assert_eq!(f.dx().dy(), f.dy().dx());
    let inner = TopView::new(value(&f), value(&g));
    prop_assert_eq!(value(&f.compose(&f, &g)), f.value_at(&inner));
    prop_assert_eq!((&f + Polynomial::x()).dx(), f.dx() + Polynomial::one());
    prop_assert_ne!((&f + Polynomial::y()).dy(), f.dy());
    Ok(())
}

fn spheres_are_the_graphs_of_their_polynomials<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (sphere, at) = (draw.sphere(), draw.top_view());
    let half = &sphere.a * Q::from_ratio(1, 2);
    let Plane { gradient, height } = sphere.plane.clone();
    let terms = [(2, 0, half.clone()), (0, 2, half), (1, 0, gradient.x), (0, 1, gradient.y)];
    let f = Polynomial::new(terms) + Polynomial::constant(&height);
    prop_assert_eq!(sphere.jet(&at).unwrap(), jet(&f, &at));
    prop_assert_eq!(
        sphere.jet(&at).unwrap().dual(),
        sphere.dual().jet(&jet(&f, &at).contact.gradient.dual())
    );
    prop_assert_ne!(sphere.jet(&at).unwrap(), jet(&(f + Polynomial::one()), &at));
    Ok(())
}

/// `eq-8-9-curvatures`: `f, H, K` as polynomials, so that the entry holds at every point.
fn table<Q: RationalField>() -> Vec<(&'static str, [Polynomial<Q>; 3])> {
    let (x, y) = (&Polynomial::<Q>::x(), &Polynomial::<Q>::y());
    let n = |p: i64, q: i64| Polynomial::constant(&Q::from_ratio(p, q));
    let (x2, y2) = (&x.square(), &y.square());
    let r2 = &(x2 + y2);
    vec![
        ("i-sphere, A = 3", [n(3, 2) * r2 + x - y, n(3, 1), n(9, 1)]),
        ("xy", [x * y, n(0, 1), n(-1, 1)]),
        ("(x² − y²)/2", [n(1, 2) * (x2 - y2), n(0, 1), n(-1, 1)]),
        ("(5x² + 7y²)/2", [n(1, 2) * (n(5, 1) * x2 + n(7, 1) * y2), n(6, 1), n(35, 1)]),
        ("Re w³", [x * (x2 - n(3, 1) * y2), n(0, 1), n(-36, 1) * r2]),
        ("Re w⁴", [x2 * x2 - n(6, 1) * x2 * y2 + y2 * y2, n(0, 1), n(-144, 1) * r2 * r2]),
        ("x⁴ − y⁴", [x2 * x2 - y2 * y2, n(6, 1) * (x2 - y2), n(-144, 1) * x2 * y2]),
        // z = r^(1+a) with a = 3: κ₁/κ₂ = 3
        ("r⁴", [r2 * r2, n(8, 1) * r2, n(48, 1) * r2 * r2]),
    ]
}

fn the_table_of_curvatures_holds<Q: RationalField>() {
    for (name, [f, h, k]) in table::<Q>() {
        let (fx, fy) = (f.dx(), f.dy());
        let hessian = Hessian { xx: fx.dx(), xy: fx.dy(), yy: fy.dy() };
        assert_eq!(hessian.trace(), Polynomial::from_i64(2) * &h, "H of {name}");
        assert_eq!(hessian.det(), k, "K of {name}");
        let at = TopView::new(Q::from_ratio(2, 3), Q::from_ratio(-5, 7));
        let jet = jet(&f, &at);
        assert_eq!(jet.mean_curvature(), h.value_at(&at), "H of {name} at {at:?}");
        assert_eq!(jet.curvature(), k.value_at(&at), "K of {name} at {at:?}");
    }
}

/// `w = −ζ³/3, z = −Re ζ²/2`: `H = 0`, `K = −|ζ|⁻⁸`; the dual is `z = (x² − y²)/(6r⁴)`.
fn the_i_minimal_surface_of_enneper<Q: RationalField>() {
    let (u, v) = (&Polynomial::<Q>::x(), &Polynomial::<Q>::y());
    let n = |p: i64, q: i64| Polynomial::constant(&Q::from_ratio(p, q));
    let (u2, v2) = (&u.square(), &v.square());
    let surface = ParametricSurface(Point::new(
        n(-1, 3) * u * u2 + u * v2,
        n(1, 3) * v * v2 - u2 * v,
        n(1, 2) * (v2 - u2),
    ));
    for (u, v) in [(1, 0), (2, 1), (-3, 2), (1, -5)] {
        let (u, v) = (Q::from_ratio(u, 2), Q::from_ratio(v, 3));
        let jet = surface.jet(&TopView::new(u.clone(), v.clone())).unwrap();
        let r8 = (u.square() + v.square()).square().square();
        assert!(jet.mean_curvature().is_zero());
        assert_eq!(jet.curvature(), -(Q::one() / &r8));
        let dual = jet.dual().unwrap();
        let Point { x, y, z } = &dual.contact.point;
        let r4 = (x.square() + y.square()).square();
        assert_eq!(z * &r4 * Q::from_i64(6), x.square() - y.square());
        assert_eq!(dual.curvature(), -(Q::one() / r4.square()));
    }
    let branch = TopView::new(Q::zero(), Q::zero());
    assert_eq!(surface.jet(&branch), None, "the branching point has no tangent plane");
}

fn parabolic_points_have_no_dual<Q: RationalField>() {
    let cylinder = Polynomial::<Q>::x().square();
    let at = TopView::new(Q::one(), Q::one());
    assert_eq!(jet(&cylinder, &at).dual(), None);
    assert_eq!(ParametricSurface::dual_of(&cylinder).jet(&at), None);
}

#[test]
fn values_over_both_scalars() {
    the_table_of_curvatures_holds::<Rational>();
    the_table_of_curvatures_holds::<BigRational>();
    the_i_minimal_surface_of_enneper::<Rational>();
    the_i_minimal_surface_of_enneper::<BigRational>();
    parabolic_points_have_no_dual::<Rational>();
    parabolic_points_have_no_dual::<BigRational>();
}
