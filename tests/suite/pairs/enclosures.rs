//! Meshes of constant K with irrational coordinates: the enclosures hold the exact mesh.

use isogeo::construct::hexagonal::HexagonalRings;
use isogeo::construct::minimal::MeshPair;
use isogeo::construct::rotational::*;
use isogeo::construct::{ENCLOSURE, Enclosed};
use isogeo::pair::FParallel;
use isogeo::scalar::{Ball, BigRational, Ordered, Quadratic, Rational, RationalField, Ring, Sign};
use isogeo::space::Rotation;

use super::q;

type Root2<Q> = Quadratic<Q, 2>;

fn lifted<Q: RationalField>(x: &Q) -> Root2<Q> {
    Quadratic::new(x.clone(), Q::zero())
}

/// How many coordinates of the exact mesh lie beyond the bounds of their vertices.
fn missed<Q: RationalField>(enclosed: &Enclosed<Q>, exact: &MeshPair<Root2<Q>>) -> usize {
    let surface = &enclosed.pair.surface;
    let vertices = surface.points.iter().zip(&exact.surface.points);
    let beyond = |((p, x), bound): ((&_, &_), &Q)| {
        let (p, x): (&isogeo::space::Point<Q>, &isogeo::space::Point<Root2<Q>>) = (p, x);
        let far = |(a, b): (&Q, &Root2<Q>)| {
            let distance = (lifted(a) - b).magnitude();
            (lifted(bound) - distance).certain_sign() == Some(Sign::Negative)
        };
        p.coordinates().into_iter().zip(x.coordinates()).filter(|&pair| far(pair)).count()
    };
    vertices.zip(&surface.data.vertex[ENCLOSURE]).map(beyond).sum()
}

/// Every face of the exact mesh has K = 2.
fn has_curvature_2<Q: RationalField>(exact: &MeshPair<Root2<Q>>) {
    let pair = FParallel::new(&exact.surface, &exact.gauss).unwrap();
    for f in exact.surface.topology.faces() {
        assert_eq!(pair.face_curvatures(f).unwrap().gauss, lifted(&q(2, 1)));
    }
}

fn half_sector<Q: RationalField>() -> Rotation<Q> {
    Rotation::new(q(40, 41), q(9, 41)).unwrap()
}

fn over<Q: RationalField>(rotation: &Rotation<Q>) -> Rotation<Root2<Q>> {
    Rotation::new(lifted(rotation.cos()), lifted(rotation.sin())).unwrap()
}

/// With K = 2, `r = (t + c/t)/(2√2)` and `r̂ = (t − c/t)/2` are in ℚ(√2) and ℚ.
fn rotational<Q: RationalField>() {
    let (gauss, integral) = (q::<Q>(2, 1), q::<Q>(3, 7));
    let parameters: Vec<Q> = (2..7).map(|k| q(k, 2)).collect();
    let constant = &integral * &gauss;
    let parameters: Vec<_> = parameters.iter().map(lifted).collect();
    let rings =
        positive_curvature_rings(&parameters, &Quadratic::sqrt_d(), &lifted(&constant)).unwrap();
    let sector = half_sector::<Q>();
    let exact = rotational_pair(&rings, &over(&sector), 3).unwrap();
    has_curvature_2(&exact);
    let images: Vec<Q> = rings.iter().map(|ring| ring.image.parts().0.clone()).collect();
    let enclosed = |integral: &Q, bits: u32| {
        let radii = enclosed_curvature_rings(&images, &gauss, integral, bits).unwrap();
        enclosed_rotational_pair(radii, &images, &sector, 3).unwrap()
    };
    holds(&exact, |bits| enclosed(&integral, bits));
    // Another first integral: what it encloses is another mesh.
    let wrong = enclosed(&(&integral + q::<Q>(1, 1 << 20)), 40);
    assert!(missed(&wrong, &exact) > 0);
}

/// With K = 2 and factors `√2 a`, the steps are `δ = √2 (a + w/2a)/2` and `δ̂ = w/2a − a` for `w = C AB`.
fn hexagonal<Q: RationalField>() {
    let (gauss, integral) = (q::<Q>(2, 1), q::<Q>(7, 3));
    let slopes: Vec<Q> = [1, 2, 4, 9, 18].map(|n| q(n, 3)).to_vec();
    let half = half_sector::<Q>();
    let rings = HexagonalRings::new(half.clone(), slopes.clone()).unwrap();
    let fine = HexagonalRings::new(over(&half), slopes.iter().map(lifted).collect()).unwrap();
    let factors: Vec<Root2<Q>> =
        (1..5).map(|k| Quadratic::new(Q::zero(), q(k * k + 1, 5))).collect();
    let (steps, image) =
        fine.constant_gauss(&factors, &Quadratic::sqrt_d(), &lifted(&integral)).unwrap();
    let exact = fine.pair(&steps, &image, 3).unwrap();
    has_curvature_2(&exact);
    let image: Vec<Q> = image.iter().map(|step| step.parts().0.clone()).collect();
    let enclosed = |integral: &Q, bits: u32| {
        let steps = rings.enclosed_constant_gauss(&image, &gauss, integral, bits).unwrap();
        rings.enclosed_pair(steps, &image, 3).unwrap()
    };
    holds(&exact, |bits| enclosed(&integral, bits));
    let wrong = enclosed(&(&integral + q::<Q>(1, 1 << 20)), 40);
    assert!(missed(&wrong, &exact) > 0);
}

/// The exact mesh is enclosed, and the better the more bits there are; what is written is f-parallel
/// to S, and its curvatures come together.
fn holds<Q: RationalField>(exact: &MeshPair<Root2<Q>>, enclosed: impl Fn(u32) -> Enclosed<Q>) {
    let coarse = enclosed(12);
    let mut before = coarse.radius();
    for bits in [12, 20, 64, 300] {
        let fine = enclosed(bits);
        assert_eq!(missed(&fine, exact), 0, "{bits} bits");
        let radius = fine.radius();
        assert!(radius <= before && !radius.is_zero(), "{bits} bits");
        assert!(FParallel::new(&fine.pair.surface, &fine.pair.gauss).is_ok());
        assert_eq!(fine.pair.gauss, coarse.pair.gauss);
        let [low, high] = fine.written_gauss().unwrap();
        assert!(low < high);
        let two = q::<Q>(2, 1);
        assert!((&low - &two).magnitude() < q(1, 1 << 6) && (&high - &two).magnitude() < q(1, 64));
        before = radius * q::<Q>(1, 1 << 7);
    }
    // A vertex moved by a thousandth is none of those that are enclosed.
    let mut wrong = enclosed(20);
    wrong.pair.surface.points[2].z += &q::<Q>(1, 1000);
    assert!(missed(&wrong, exact) > 0);
}

#[test]
fn rotational_meshes_are_enclosed() {
    rotational::<Rational>();
    rotational::<BigRational>();
}

#[test]
fn hexagonal_meshes_are_enclosed() {
    hexagonal::<Rational>();
    hexagonal::<BigRational>();
}

#[test]
fn roots_are_enclosed() {
    for (p, d) in [(2, 1), (1, 3), (5, 1_000_000_007), (1_000_000_007, 5), (4, 1), (9, 49), (0, 1)]
    {
        let number = q::<Rational>(p, d);
        for bits in [0, 1, 9, 64, 257] {
            let root = Ball::root(&number, bits).unwrap();
            let (low, high) = (&root.mid - &root.radius, &root.mid + &root.radius);
            assert!(low.square() <= number && number <= high.square(), "{number} {bits}");
            assert!(low.certain_sign() != Some(Sign::Negative));
            match number.root() {
                Some(exact) => assert_eq!((root.mid, root.radius), (exact, q(0, 1))),
                None => assert_eq!((&high - &low).denominator().bits(), u64::from(bits) + 1),
            }
        }
    }
    assert_eq!(Ball::root(&q::<Rational>(-1, 4), 8), None);
    // No real radius, no curvature 0.
    let one = [q::<Rational>(1, 1)];
    assert_eq!(enclosed_curvature_rings(&one, &q(2, 1), &q(-1, 1), 8), None);
    assert_eq!(enclosed_curvature_rings(&one, &q(0, 1), &q(1, 1), 8), None);
}
