//! i-circular meshes.

use proptest::prelude::*;

use super::number::{fraction, nonzero, proper, small};
use super::planar::is_graph;
use crate::construct::minimal::{MeshPair, Weierstrass, WeierstrassData};
use crate::construct::{circular_net, translational_net};
use crate::mesh::Mesh;
use crate::scalar::Field;
use crate::space::{Point, Vector2};

/// Translational nets up to 4 × 4: planar, i-circular and i-conical, with rectangles as top views.
pub fn translational<Q: Field>() -> impl Strategy<Value = Mesh<Q>> {
    let profile = || {
        prop::collection::vec(((1i64..=40, 1i64..=9), fraction::<Q>()), 5).prop_map(|steps| {
            let mut x = Q::zero();
            let place = |((p, q), z): ((i64, i64), Q)| {
                x = &x + Q::from_ratio(p, q);
                (x.clone(), z)
            };
            steps.into_iter().map(place).collect::<Vec<_>>()
        })
    };
    (1usize..=4, 1usize..=4, profile(), profile())
        .prop_filter_map("a grid is a mesh", |(m, n, f, g)| {
            translational_net(&f[..=m], &g[..=n]).ok()
        })
}

/// The most rows, and the most columns, of a net whose numbers grow along the diagonal.
const SIDE: usize = 3;

/// i-circular nets up to 3 × 3 from random Cauchy data near a square grid: embedded, with convex
/// faces where the data are not too wild.
pub fn cauchy<Q: Field>() -> impl Strategy<Value = Mesh<Q>> {
    cauchy_from(1)
}

/// The same with at least as many rows and columns.
pub(super) fn cauchy_from<Q: Field>(least: usize) -> impl Strategy<Value = Mesh<Q>> {
    let jitter = || prop::collection::vec((-9i64..=9, -9i64..=9, -50i64..=50), SIDE);
    let ratios = prop::collection::vec(proper::<Q>(), SIDE * SIDE);
    (least..=SIDE, least..=SIDE, jitter(), jitter(), ratios).prop_filter_map(
        "degenerate Cauchy data",
        |(m, n, rows, columns, ratios)| {
            let line = |jitter: &[(i64, i64, i64)], [along, across]: [i64; 2]| {
                let near = |i: i64, &(a, b, z): &(i64, i64, i64)| {
                    let at = |unit: i64, d: i64| Q::from_ratio(40 * unit * i + d, 40);
                    Point::new(at(along, a), at(across, b), Q::from_ratio(z, 10))
                };
                let origin = near(0, &(0, 0, 0));
                let rest = jitter.iter().zip(1..).map(|(jitter, i)| near(i, jitter));
                std::iter::once(origin).chain(rest).collect::<Vec<_>>()
            };
            let (rows, columns) = (line(&rows[..m], [1, 0]), line(&columns[..n], [0, 1]));
            circular_net(&rows, &columns, |i, j| ratios[i * SIDE + j].clone())?.ok()
        },
    )
}

/// i-minimal circular nets up to 3 × 3 with their Gauss images inscribed to Σ: [`Weierstrass`] data
/// of a random discrete holomorphic function, whose cross-ratios factorise.
pub fn i_minimal<Q: Field>() -> impl Strategy<Value = MeshPair<Q>> {
    weierstrass().prop_filter_map("a patch is a mesh", |data| data.minimal().ok())
}

/// i-circular nets whose top views are circle patterns with factorised cross-ratios: those with
/// `H = 0` and with another constant H.
pub fn factorised<Q: Field>() -> impl Strategy<Value = Mesh<Q>> {
    (weierstrass(), small()).prop_filter_map("a vertical face", |(data, mean)| {
        data.constant_mean(&mean).ok().map(|pair| pair.surface).filter(is_graph)
    })
}

fn weierstrass<Q: Field>() -> impl Strategy<Value = Weierstrass<Q>> {
    let jitter = |count| prop::collection::vec((-9i64..=9, -9i64..=9), count);
    let labels = || prop::collection::vec(nonzero::<Q>(), SIDE);
    (1..=SIDE, 1..=SIDE, jitter(SIDE + 1), jitter(SIDE), labels(), labels()).prop_filter_map(
        "a singular holomorphic function",
        |(m, n, rows, columns, alpha, beta)| {
            let near = |x: i64, y: i64, (a, b): (i64, i64)| {
                Vector2::new(Q::from_ratio(20 * x + a, 20), Q::from_ratio(20 * y + b, 20))
            };
            let rows = rows.into_iter().zip(0..).map(|(jitter, i)| near(i, 0, jitter));
            let columns = columns.into_iter().zip(1..).map(|(jitter, j)| near(0, j, jitter));
            Weierstrass::new(&WeierstrassData {
                rows: rows.take(m + 1).collect(),
                columns: columns.take(n).collect(),
                alpha: alpha.into_iter().take(m).collect(),
                beta: beta.into_iter().take(n).collect(),
            })
            .ok()
        },
    )
}

/// i-circular meshes of all these kinds.
pub fn circular<Q: Field>() -> impl Strategy<Value = Mesh<Q>> {
    prop_oneof![cauchy(), translational(), factorised()]
}
