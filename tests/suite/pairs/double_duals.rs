//! The Christoffel dual of the Christoffel dual: the mesh itself, up to scale and translation.

use isogeo::construct::family::{Family, Values};
use isogeo::construct::{christoffel_by_diagonals, christoffel_by_radii};
use isogeo::mesh::Mesh;
use isogeo::net::RADIUS;
use isogeo::scalar::{Rational, Ring};
use isogeo::space::Vector3;

use super::q;

/// The factor by which a mesh is larger than another that is its image under a scaling and a
/// translation; `None` where it is none.
fn scale(mesh: &Mesh<Rational>, other: &Mesh<Rational>) -> Option<Rational> {
    let steps = |mesh: &Mesh<Rational>| -> Vec<Vector3<Rational>> {
        mesh.points.iter().map(|p| p - &mesh.points[0]).collect()
    };
    let (all, others) = (steps(mesh), steps(other));
    let coordinates = |v: &Vector3<Rational>| [v.x.clone(), v.y.clone(), v.z.clone()];
    let pairs = all.iter().zip(&others);
    let pairs: Vec<_> =
        pairs.flat_map(|(a, b)| coordinates(a).into_iter().zip(coordinates(b))).collect();
    let (a, b) = pairs.iter().find(|(_, b)| !b.is_zero())?;
    let factor = a / b;
    (!factor.is_zero() && pairs.iter().all(|(a, b)| *a == b * &factor)).then_some(factor)
}

#[test]
fn double_duals_of_all_families_are_the_meshes() {
    let mut with_dual = Vec::new();
    for family in Family::ALL {
        let values = Values::new(family, &[]).unwrap();
        let member = family.member([3, 4], &values).unwrap();
        let meshes = [Some(member.surface), member.gauss];
        for (mesh, which) in meshes.into_iter().flatten().zip(["M", "S"]) {
            let Ok(dual) = christoffel_by_diagonals(&mesh) else { continue };
            let dual = dual.mesh;
            with_dual.push(format!("{} {which}", family.name()));
            let twice = christoffel_by_diagonals(&dual).unwrap().mesh;
            assert!(scale(&twice, &mesh).is_some(), "{}", family.name());
            // The dual itself is another mesh, and a vertex moved is seen.
            assert_eq!(scale(&dual, &mesh), None, "{}", family.name());
            let mut wrong = twice;
            wrong.points[7].x += &q::<Rational>(1, 1000);
            assert_eq!(scale(&wrong, &mesh), None, "{}", family.name());
            // By radii, where there are some: scaled by exactly 1.
            if let Some(radii) = mesh.data.vertex.get(RADIUS) {
                let dual = christoffel_by_radii(&mesh, radii).unwrap();
                let twice = christoffel_by_radii(&dual.mesh, &dual.factors).unwrap().mesh;
                assert_eq!(scale(&twice, &mesh), Some(q(1, 1)), "{}", family.name());
            }
        }
    }
    let expected = "paraboloid M, paraboloid S, saddle M, saddle S, enneper M, enneper S, \
         logarithmoid M, logarithmoid S, bonnet M, bonnet S, weierstrass M, weierstrass S, \
         rotational-cmc M, rotational-cmc S, rotational-constant-k M, rotational-constant-k S";
    assert_eq!(with_dual.join(", "), expected);
}
