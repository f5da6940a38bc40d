//! An i-minimal surface and H times a paraboloid over the same top view: constant H, at faces and at
//! vertices.

use isogeo::check::Verdict as Answer;
use isogeo::construct::minimal::*;
use isogeo::construct::{koebe_mesh, vertex_circles};
use isogeo::mesh::{FaceList, Mesh};
use isogeo::pair::*;
use isogeo::scalar::{BigRational, Rational, RationalField};
use isogeo::space::*;

use super::minimal::pair_verdict;
use super::q;

/// i-minimal surfaces with their Koebe meshes.
fn surfaces<Q: RationalField>() -> Vec<(&'static str, MeshPair<Q>)> {
    let half = Rotation::new(q::<Q>(4, 5), q(3, 5)).unwrap();
    let at = |x: Q, y: Q| TopView::new(x, y);
    vec![
        ("saddle", saddle(3, 4).unwrap()),
        ("enneper", enneper(3, 3, &at(q(-1, 2), q(-3, 4))).unwrap()),
        ("logarithmoid", logarithmoid(3, 3, &half).unwrap()),
        ("bonnet", bonnet(3, 3, &half, &at(q(2, 1), q(1, 5))).unwrap()),
    ]
}

/// The v-parallel Koebe mesh over the vertex circles of M: what stands for the paraboloid Σ.
fn paraboloid<Q: RationalField>(mesh: &Mesh<Q>) -> Mesh<Q> {
    let mut faces = FaceList::new();
    mesh.topology.faces().for_each(|f| faces.push(mesh.topology.face(f).iter().map(|v| v.0)));
    koebe_mesh(vertex_circles(mesh).unwrap(), faces).unwrap()
}

/// The mesh that is f-parallel to another over a top view with parallel edges; heights follow from
/// face to face.
fn f_parallel<Q: RationalField>(mesh: &Mesh<Q>, top_view: &[TopView<Q>]) -> Mesh<Q> {
    let mut heights: Vec<Option<Q>> = vec![None; top_view.len()];
    heights[0] = Some(Q::zero());
    while heights.contains(&None) {
        for f in mesh.topology.faces() {
            let gradient = mesh.face_plane(f).unwrap().gradient;
            let corners = mesh.topology.face(f);
            let Some(known) = corners.iter().find(|v| heights[v.index()].is_some()) else {
                continue;
            };
            for v in corners {
                let step = &top_view[v.index()] - &top_view[known.index()];
                let rise = Q::dot([&gradient.x, &gradient.y], [&step.x, &step.y]);
                let height = heights[known.index()].clone().map(|z| z + rise);
                heights[v.index()] = heights[v.index()].take().or(height);
            }
        }
    }
    let point = |(p, z): (&TopView<Q>, Option<Q>)| p.clone().at_height(z.unwrap());
    Mesh { points: top_view.iter().zip(heights).map(point).collect(), ..mesh.clone() }
}

/// M + H Σ, and the top view S' + H M' of its Gauss image.
fn sums<Q: RationalField>(
    MeshPair { surface, gauss }: &MeshPair<Q>,
    mean: &Q,
) -> (Mesh<Q>, Vec<TopView<Q>>) {
    let sigma = paraboloid(surface);
    let raised =
        |(p, s): (&Point<Q>, &Point<Q>)| Point::new(p.x.clone(), p.y.clone(), &p.z + mean * &s.z);
    let points = surface.points.iter().zip(&sigma.points).map(raised).collect();
    let over =
        |(p, s): (&Point<Q>, &Point<Q>)| TopView::new(&s.x + mean * &p.x, &s.y + mean * &p.y);
    let top_view = surface.points.iter().zip(&gauss.points).map(over).collect();
    (Mesh { points, ..surface.clone() }, top_view)
}

fn constant_mean_curvature<Q: RationalField>() {
    for (name, pair) in surfaces::<Q>() {
        let mean = q::<Q>(3, 7);
        let (sum, top_view) = sums(&pair, &mean);
        // At faces: area(M, S' + H M') = H area(M).
        let image = f_parallel(&sum, &top_view);
        for property in [PairProperty::FParallel, PairProperty::Cmc] {
            assert_eq!(pair_verdict(&sum, &image, property), Answer::Proved, "{name}");
        }
        let at_faces = FParallel::new(&sum, &image).unwrap();
        for f in sum.topology.faces() {
            let Ok(curvatures) = at_faces.face_curvatures(f) else { continue };
            assert_eq!(curvatures.mean, mean, "{name}");
            // K is not constant, that of the offset at −1/(2H) is 4H².
            if let Some(offset) = curvatures.offset(&q(-7, 6)) {
                assert_eq!(offset.gauss, q(36, 49), "{name}");
            }
        }
        // At vertices, for the paraboloid itself as the Gauss image.
        let sigma = paraboloid(&pair.surface);
        let at_vertices = VParallel::new(&sum, &sigma).unwrap();
        for v in sum.topology.interior_vertices() {
            let curvatures = at_vertices.vertex_curvatures(v).unwrap();
            assert_eq!(curvatures.mean, mean, "{name}");
        }
        // Negative controls: another H, another Gauss image, a vertex moved.
        let (other, _) = sums(&pair, &q(1, 2));
        assert!(FParallel::new(&other, &image).is_err(), "{name}");
        let at_vertices = VParallel::new(&other, &sigma).unwrap();
        for v in other.topology.interior_vertices() {
            assert_eq!(at_vertices.vertex_curvatures(v).unwrap().mean, q(1, 2), "{name}");
        }
        let (_, top_view) = sums(&pair, &(&mean + &mean));
        let image = f_parallel(&sum, &top_view);
        let at_faces = FParallel::new(&sum, &image).unwrap();
        let mut means = sum.topology.faces().filter_map(|f| at_faces.face_curvatures(f).ok());
        assert!(means.all(|c| c.mean == &mean + &mean), "{name}");
        let mut wrong = sum.clone();
        wrong.points[5].z += &q::<Q>(1, 1000);
        assert_eq!(pair_verdict(&wrong, &image, PairProperty::Cmc), Answer::Refuted, "{name}");
    }
}

#[test]
fn graph_sums_have_constant_mean_curvature() {
    constant_mean_curvature::<Rational>();
    constant_mean_curvature::<BigRational>();
}
