//! i-minimal surfaces, Koebe meshes and Christoffel duals (Sec. 3.4, 4): laws, values, closed forms.

use isogeo::check::{Decider, Plain, Verdict as Answer};
use isogeo::construct::hexagonal::HexagonalRings;
use isogeo::construct::minimal::*;
use isogeo::construct::rotational::*;
use isogeo::construct::*;
use isogeo::mesh::{FaceId, FaceList, Mesh, VertexId};
use isogeo::net::{Net, Property, RADIUS};
use isogeo::pair::*;
use isogeo::scalar::{Field, Quadratic, Rational, RationalField, Ring};
use isogeo::space::*;

use super::*;

/// The verdict on a mesh, with its radii if it has them.
fn verdict<Q: RationalField>(mesh: &Mesh<Q>, property: Property) -> Answer {
    let radii = mesh.data.vertex.get(RADIUS).into_iter().flatten();
    let radii = radii.map(|r| Point::new(r.clone(), Q::zero(), Q::zero()));
    let points: Vec<Point<Q>> = mesh.points.iter().cloned().chain(radii).collect();
    let decide = Plain(&points);
    let mut net = Net::new(&mesh.topology, &decide);
    if points.len() > mesh.points.len() {
        net = net.with_radii(VertexId(mesh.points.len() as u32));
    }
    net.check(property).verdict()
}

pub fn pair_verdict<Q: RationalField>(m: &Mesh<Q>, s: &Mesh<Q>, property: PairProperty) -> Answer {
    let points = [m.points.as_slice(), &s.points].concat();
    Couple::new(&m.topology, &s.topology, &Plain(&points)).unwrap().check(property).verdict()
}

/// What all pairs of Koebe meshes and their duals are.
fn is_koebe_pair<Q: RationalField>(MeshPair { surface, gauss }: &MeshPair<Q>) {
    use Property::*;
    for property in [Planar, Midscribed, IIsothermic, Koenigs] {
        assert_eq!(verdict(gauss, property), Answer::Proved, "{property:?}");
    }
    for property in [Planar, IIsothermic, Koenigs, IMinimal] {
        assert_eq!(verdict(surface, property), Answer::Proved, "{property:?}");
    }
    use PairProperty as P;
    for property in [P::Parallel, P::FParallel, P::ChristoffelDual, P::IMinimal] {
        assert_eq!(pair_verdict(surface, gauss, property), Answer::Proved, "{property:?}");
    }
    // The face circles are a second packing, orthogonal to the first.
    for mesh in [surface, gauss] {
        let lifted = koebe_mesh_of(mesh);
        let circles = vertex_circles(mesh).unwrap();
        let faces: Vec<_> =
            mesh.topology.faces().map(|f| face_circle(&lifted, f).unwrap().unwrap()).collect();
        for f in mesh.topology.faces() {
            let corners = mesh.topology.face(f);
            let own = &faces[f.index()];
            assert!(corners.iter().all(|v| own.orthogonality(&circles[v.index()]).is_zero()));
            let radii = [0, 1, 2, 3].map(|i| &circles[corners[i].index()].radius);
            assert!(schramm_residual(&own.radius, radii).is_zero());
        }
        for h in mesh.topology.edges() {
            if let Some(twin) = mesh.topology.twin(h) {
                let [f, g] = [h, twin].map(|h| &faces[mesh.topology.face_at(h).index()]);
                assert!(f.tangency(g).is_zero());
            }
        }
        for v in mesh.topology.interior_vertices() {
            let around: Vec<_> = mesh
                .topology
                .star(v)
                .map(|h| &faces[mesh.topology.face_at(h).index()].radius)
                .collect();
            let [a, b, c, d] = around[..] else { continue };
            assert!(schramm_residual(&circles[v.index()].radius, [a, b, c, d]).is_zero());
        }
    }
}

/// The Koebe mesh over the circles of a mesh.
fn koebe_mesh_of<Q: RationalField>(mesh: &Mesh<Q>) -> Mesh<Q> {
    let mut faces = FaceList::new();
    mesh.topology.faces().for_each(|f| faces.push(mesh.topology.face(f).iter().map(|v| v.0)));
    koebe_mesh(vertex_circles(mesh).unwrap(), faces).unwrap()
}

fn half_sector<Q: RationalField>(draw: &mut Draw<Q>) -> Rotation<Q> {
    let [p, d] = [(1, 3), (1, 2), (2, 3), (1, 5)][draw.index(4)].into();
    Rotation::from_parameter(&q(p, d)).unwrap()
}

laws! { in 12 cases: enneper_is_the_dual_of_its_gauss_image bonnet_is_minimal_in_both_senses
weierstrass_nets christoffel_duals_are_unique koebe_meshes_keep_touching_under_inversions
rotational_first_integrals hexagonal_first_integrals the_metric_dual_is_minimal_at_vertices }

fn enneper_is_the_dual_of_its_gauss_image<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let centre = TopView::new(draw.number(), draw.number());
    let Ok(pair) = enneper(3, 2, &centre) else { return Ok(()) };
    is_koebe_pair(&pair);
    // The closed form is the dual, scaled by 1/4, and moved.
    let dual = christoffel_by_radii(&pair.gauss, &pair.gauss.data.vertex[RADIUS]).unwrap();
    let first = &pair.surface.points[0];
    for (p, m) in dual.mesh.points.iter().zip(&pair.surface.points) {
        let v = m - first;
        assert_eq!(p.map(|c| c * q::<Q>(1, 4)), Point::new(v.x, v.y, v.z));
    }
    for (r, dual) in pair.surface.data.vertex[RADIUS].iter().zip(&dual.factors) {
        assert_eq!(r.clone(), dual * q::<Q>(1, 4));
    }
    // K(F) = −1/∏N, K(v) = −∏ρ of M.
    let forms = FParallel::new(&pair.surface, &pair.gauss).unwrap();
    let radii = &pair.gauss.data.vertex[RADIUS];
    for f in pair.surface.topology.faces() {
        let product = pair.surface.topology.face(f).iter();
        let product = product.fold(-Q::from_i64(16), |k, v| k * &radii[v.index()]);
        let Ok(curvatures) = forms.face_curvatures(f) else { continue };
        assert_eq!((curvatures.mean, curvatures.gauss), (Q::zero(), product));
    }
    // Negative controls: a vertex moved within its plane, a radius with the other sign.
    let mut wrong = pair.clone();
    wrong.surface.points[5].x += &q::<Q>(1, 1000);
    assert_eq!(verdict(&wrong.surface, Property::IIsothermic), Answer::Refuted);
    assert_eq!(verdict(&wrong.surface, Property::Koenigs), Answer::Refuted);
    assert_eq!(verdict(&wrong.surface, Property::IMinimal), Answer::Refuted);
    let mut wrong = pair.gauss.clone();
    let radii = wrong.data.vertex.get_mut(RADIUS).unwrap();
    radii[4] = -&radii[4];
    assert_eq!(verdict(&wrong, Property::IIsothermic), Answer::Refuted);
    let turned = christoffel_by_radii(&wrong, &wrong.data.vertex[RADIUS]);
    assert!(matches!(turned, Err(NoChristoffelDual::FaceOpen { .. })));
    Ok(())
}

fn bonnet_is_minimal_in_both_senses<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let half = half_sector(draw);
    is_koebe_pair(&logarithmoid(2, 3, &half).unwrap());
    let centre = TopView::new(draw.number(), draw.number());
    let Ok(pair) = bonnet(2, 3, &half, &centre) else { return Ok(()) };
    is_koebe_pair(&pair);
    // Rows and columns lie in planes.
    for mesh in [&pair.surface, &pair.gauss] {
        let at = |i: usize, j: usize| &mesh.points[4 * i + j];
        for i in 0..3 {
            let [a, b, c] = [1, 2, 3].map(|j| at(i, j) - at(i, 0));
            assert!(Vector3::det(&a, &b, &c).is_zero());
        }
    }
    Ok(())
}

/// Weierstrass data near the square grid.
fn weierstrass<Q: RationalField>(draw: &mut Draw<Q>, n: usize) -> WeierstrassData<Q> {
    let mut near = |x: usize, y: usize| {
        let mut jitter = |n: usize| Q::from_i64(n as i64) + draw.number() * q::<Q>(1, 40);
        Vector2::new(jitter(x), jitter(y))
    };
    let rows = (0..=n).map(|i| near(i, 0)).collect();
    let columns = (1..=n).map(|j| near(0, j)).collect();
    let alpha = (0..n).map(|i| q([1, 3, 2][i % 3], [1, 4, 3][i % 3])).collect();
    let beta = (0..n).map(|j| q([-1, -4, -2][j % 3], [1, 3, 3][j % 3])).collect();
    WeierstrassData { rows, columns, alpha, beta }
}

fn weierstrass_nets<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let Ok(data) = Weierstrass::new(&weierstrass(draw, 3)) else { return Ok(()) };
    let MeshPair { surface, gauss } = data.minimal().unwrap();
    for property in [Property::ICircular, Property::IIsothermic, Property::Koenigs] {
        assert_eq!(verdict(&surface, property), Answer::Proved, "{property:?}");
    }
    assert_eq!(verdict(&gauss, Property::Inscribed), Answer::Proved);
    for property in [PairProperty::FParallel, PairProperty::IMinimal, PairProperty::ChristoffelDual]
    {
        assert_eq!(pair_verdict(&surface, &gauss, property), Answer::Proved);
    }
    let conjugate = data.conjugate().unwrap();
    assert_eq!(verdict(&conjugate, Property::ANet), Answer::Proved);
    assert_eq!(verdict(&conjugate, Property::Planar), Answer::Refuted);
    let mut wrong = conjugate;
    wrong.points[5].z += &q::<Q>(1, 1000);
    assert_eq!(verdict(&wrong, Property::ANet), Answer::Refuted);
    // Constant mean curvature, and the offset of constant curvature 4H².
    let mean = q::<Q>(3, 7);
    let cmc = data.constant_mean(&mean).unwrap();
    let pair = FParallel::new(&cmc.surface, &cmc.gauss).unwrap();
    for f in cmc.surface.topology.faces() {
        let Ok(curvatures) = pair.face_curvatures(f) else { continue };
        assert_eq!(curvatures.mean, mean);
        if let Some(offset) = curvatures.offset(&q(-7, 6)) {
            assert_eq!(offset.gauss, q(36, 49));
        }
    }
    // One value of g moved: the net of w no longer closes to a circular one.
    let mut wrong = surface;
    wrong.points[5].x += &q::<Q>(1, 1000);
    assert_eq!(verdict(&wrong, Property::IIsothermic), Answer::Refuted);
    assert_eq!(pair_verdict(&wrong, &gauss, PairProperty::IMinimal), Answer::Refuted);
    Ok(())
}

fn christoffel_duals_are_unique<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let centre = TopView::new(draw.number(), draw.number());
    let Ok(MeshPair { gauss, .. }) = enneper(2, 2, &centre) else { return Ok(()) };
    let radii = &gauss.data.vertex[RADIUS];
    let by_radii = christoffel_by_radii(&gauss, radii).unwrap();
    let by_diagonals = christoffel_by_diagonals(&gauss).unwrap();
    // Up to scale and translation, which starts at the origin in both.
    let (p, r) = (&by_radii.mesh.points[1], &by_diagonals.mesh.points[1]);
    let scale = if r.x.is_zero() { &p.y / &r.y } else { &p.x / &r.x };
    for (p, r) in by_radii.mesh.points.iter().zip(&by_diagonals.mesh.points) {
        assert_eq!(p.clone(), r.map(|c| c * &scale));
    }
    // The dual of the dual is the mesh.
    let twice = [
        christoffel_by_radii(&by_radii.mesh, &by_radii.factors).unwrap(),
        christoffel_by_diagonals(&by_diagonals.mesh).unwrap(),
    ];
    for dual in &twice[..1] {
        for (p, m) in dual.mesh.points.iter().zip(&gauss.points) {
            let v = m - &gauss.points[0];
            assert_eq!(p.clone(), Point::new(v.x, v.y, v.z));
        }
    }
    // area(F)/area(S) = −R R R R for the dual S of F with edges ΔF/(R R).
    let pair = FParallel::new(&gauss, &by_radii.mesh).unwrap();
    for f in gauss.topology.faces() {
        let forms = pair.face_forms(f);
        let product = gauss.topology.face(f).iter().fold(-Q::one(), |k, v| k * &radii[v.index()]);
        assert_eq!(forms.area(), product * forms.image_area());
    }
    // One vertex moved within the plane of its only face: the mesh is no Koenigs net any more.
    let Ok(net) = christoffel_by_diagonals(&translational(draw, 2, 2)) else { return Ok(()) };
    let mut wrong = net.mesh;
    let step = &wrong.points[1] - &wrong.points[0];
    wrong.points[0] = &wrong.points[0]
        + &Vector3::new(step.x * q::<Q>(1, 3), step.y * q::<Q>(1, 3), step.z * q::<Q>(1, 3));
    assert!(matches!(
        christoffel_by_diagonals(&wrong),
        Err(NoChristoffelDual::VertexOpen { vertex: VertexId(4), .. })
    ));
    Ok(())
}

fn koebe_meshes_keep_touching_under_inversions<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let mut circles = square_packing::<Q>(2, 2);
    for _ in 0..2 {
        let centre = TopView::new(draw.number() + q::<Q>(1, 7), draw.number());
        let Ok(images) = inverted_packing(&circles, &centre) else { return Ok(()) };
        circles = images;
    }
    let mesh = koebe_mesh(circles, quad_patch(2, 2)).unwrap();
    if !graph_faces(&mesh) {
        return Ok(());
    }
    for property in [Property::Midscribed, Property::IIsothermic] {
        assert_eq!(verdict(&mesh, property), Answer::Proved);
    }
    Ok(())
}

fn rotational_first_integrals<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let half = half_sector(draw);
    let (mean, integral) = (draw.number(), draw.non_zero());
    let radii: Vec<Q> = (2..6).map(|k| q(k, 2)).collect();
    let rings = constant_mean_rings(&radii, &mean, &integral).unwrap();
    let cmc = rotational_pair(&rings, &half, 2).unwrap();
    let root = draw.non_zero();
    let parameters: Vec<Q> = (2..6).map(|k| q(k, 7)).collect();
    let positive = positive_curvature_rings(&parameters, &root, &integral).unwrap();
    let negative = negative_curvature_rings(&parameters, &root, &integral).unwrap();
    let each = [(positive, root.square()), (negative, -root.square())];
    for (rings, gauss) in each {
        let MeshPair { surface, gauss: image } = rotational_pair(&rings, &half, 2).unwrap();
        let Ok(pair) = FParallel::new(&surface, &image) else { continue };
        for f in surface.topology.faces() {
            assert!(pair.face_curvatures(f).is_ok_and(|c| c.gauss == gauss));
        }
    }
    assert_eq!(verdict(&cmc.gauss, Property::Inscribed), Answer::Proved);
    let pair = FParallel::new(&cmc.surface, &cmc.gauss).unwrap();
    for f in cmc.surface.topology.faces() {
        assert_eq!(pair.face_curvatures(f).unwrap().mean, mean);
    }
    let mut wrong = rings;
    wrong[1].image += &q::<Q>(1, 100);
    let wrong = rotational_pair(&wrong, &half, 2).unwrap();
    assert_eq!(pair_verdict(&wrong.surface, &wrong.gauss, PairProperty::Cmc), Answer::Refuted);
    Ok(())
}

fn hexagonal_first_integrals<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (mean, integral, root) = (draw.number(), draw.non_zero(), draw.non_zero());
    let half = Rotation::from_parameter(&q(1, 3)).unwrap();
    let slopes = [1, 2, 4, 9, 18].map(|n| q::<Q>(n, 3)).to_vec();
    let rings = HexagonalRings::new(half, slopes).unwrap();
    let image = rings.circumscribed();
    let steps = rings.minimal(&image, &integral).unwrap();
    let free: Vec<Q> = (0..4).map(|k| q(k * k + 2, 3)).collect();
    let (m, s) = rings.constant_gauss(&free, &root, &integral).unwrap();
    let s_of_cmc = rings.constant_mean(&free, &mean, &integral).unwrap();
    let curvatures = |pair: MeshPair<Q>| {
        let checked = FParallel::new(&pair.surface, &pair.gauss).unwrap();
        let all = pair.surface.topology.faces().filter_map(|f| checked.face_curvatures(f).ok());
        all.collect::<Vec<_>>()
    };
    let pair = rings.pair(&steps, &image, 3).unwrap();
    assert_eq!(verdict(&pair.gauss, Property::Circumscribed), Answer::Proved);
    let mut wrong = steps.clone();
    wrong[1] += &q::<Q>(1, 100);
    assert!(curvatures(pair).iter().all(|c| c.mean.is_zero()));
    let wrong = curvatures(rings.pair(&wrong, &image, 3).unwrap());
    assert!(!wrong.iter().all(|c| c.mean.is_zero()));
    let cmc = curvatures(rings.pair(&free, &s_of_cmc, 3).unwrap());
    assert!(cmc.iter().all(|c| c.mean == mean));
    if m.iter().chain(&s).all(|step| !step.is_zero()) {
        let all = curvatures(rings.pair(&m, &s, 3).unwrap());
        assert!(all.iter().all(|c| c.gauss == root.square()));
    }
    Ok(())
}

fn the_metric_dual_is_minimal_at_vertices<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let half = half_sector(draw);
    let MeshPair { surface, gauss } = logarithmoid(3, 3, &half).unwrap();
    let (m, s) = (metric_dual(&surface).unwrap(), metric_dual(&gauss).unwrap());
    let pair = VParallel::new(&m, &s).unwrap();
    for v in m.topology.interior_vertices() {
        assert!(pair.vertex_forms(v).unwrap().mixed_measure().is_zero());
    }
    Ok(())
}

/// Rows and columns of vertices lie in planes (Fig. 8); dually, the planes of the dual along a row or
/// a column of faces pass through one point (Fig. 9).
#[test]
fn parameter_lines_of_enneper_and_bonnet_are_planar() {
    let half = Rotation::new(q::<Rational>(4, 5), q(3, 5)).unwrap();
    let centre = TopView::new(q::<Rational>(1, 3), q(1, 5));
    let pairs = [enneper(5, 5, &centre).unwrap(), bonnet(5, 5, &half, &centre).unwrap()];
    for MeshPair { surface, .. } in pairs {
        let at = |i: usize, j: usize| &surface.points[6 * i + j];
        let volume = |p: [&Point<Rational>; 4]| {
            let [a, b, c] = [1, 2, 3].map(|k| p[k] - p[0]);
            Vector3::det(&a, &b, &c)
        };
        for i in 0..6 {
            for k in 3..6 {
                assert!(volume([at(i, 0), at(i, 1), at(i, 2), at(i, k)]).is_zero(), "row {i}");
                assert!(volume([at(0, i), at(1, i), at(2, i), at(k, i)]).is_zero(), "column {i}");
            }
        }
        // The control: other lines of vertices do not lie in planes.
        assert!(!volume([at(0, 0), at(1, 1), at(2, 2), at(3, 3)]).is_zero());
    }
}

#[test]
fn hexagons_with_a_rational_angle() {
    let r = |p, d| q::<Rational>(p, d);
    let half = Rotation::new(r(4, 5), r(3, 5)).unwrap();
    let slopes = (0..6).map(|k| r(3i64.pow(k), 2i64.pow(k))).collect();
    let rings = HexagonalRings::new(half, slopes).unwrap();
    let image = rings.circumscribed();
    let steps = rings.minimal(&image, &r(7, 3)).unwrap();
    let pair = rings.pair(&steps, &image, 3).unwrap();
    assert_eq!(pair.surface.topology.face_count(), 12);
    assert_eq!(verdict(&pair.gauss, Property::Circumscribed), Answer::Proved);
    assert_eq!(pair_verdict(&pair.surface, &pair.gauss, PairProperty::IMinimal), Answer::Proved);
}

/// Six hexagons in a ring close in ℚ(√3); a closed ring of circles needs no more than its radii.
#[test]
fn a_closed_ring_of_touching_circles() {
    type K = Quadratic<Rational, 3>;
    // Twelve circles about the corners of regular hexagons: rings q apart, (c, s) = (√3/2, 1/2).
    let half = Rotation::new(K::sqrt_d() * K::from_ratio(1, 2), K::from_ratio(1, 2)).unwrap();
    let circles = polar_packing(1, 5, &half).unwrap();
    let mut faces = FaceList::new();
    (0..6u32).for_each(|j| faces.push([j, 6 + j, 6 + (j + 1) % 6, (j + 1) % 6]));
    let mesh = koebe_mesh(circles, faces).unwrap();
    let dual = christoffel_by_radii(&mesh, &mesh.data.vertex[RADIUS]).unwrap();
    // The logarithmoid closes: the ring is a circle of equal height.
    assert!((0..6).all(|j| dual.mesh.points[j].z == dual.mesh.points[0].z));
    assert_eq!(christoffel_by_diagonals(&mesh).map(|_| ()), Ok(()));
}

#[test]
fn cycles_that_do_not_close_are_named() {
    let r = |p, d| q::<Rational>(p, d);
    // A ring of three quads has no interior vertex, but a hole.
    let at = |x: i64, y: i64| Point::new(r(x, 1), r(y, 1), r(0, 1));
    let ring = vec![at(1, 0), at(-1, 1), at(-1, -1), at(4, 1), at(-3, 3), at(-3, -3)];
    let mut faces = FaceList::new();
    (0..3u32).for_each(|j| faces.push([j, 3 + j, 3 + (j + 1) % 3, (j + 1) % 3]));
    let annulus = Mesh::new(ring, faces).unwrap();
    let refused = christoffel_by_diagonals(&annulus).map(|_| ()).unwrap_err();
    assert!(refused.cycle().is_some_and(|cycle| cycle.len() >= 3), "{refused}");
    assert!(!refused.is_undefined());
    // A rhombus: four equal circles touch in a cycle, but their poles are not coplanar.
    let corners = [(0, 0), (5, 0), (8, 4), (3, 4)];
    let mut faces = FaceList::new();
    faces.push(0..4);
    let mut mesh = Mesh::new(corners.map(|(x, y)| at(x, y)).to_vec(), faces).unwrap();
    mesh.data.vertex.insert(RADIUS.into(), vec![r(5, 2); 4]);
    assert_eq!(verdict(&mesh, Property::IIsothermic), Answer::Refuted);
    assert_eq!(verdict(&koebe_mesh_of(&mesh), Property::Midscribed), Answer::Proved);
    assert_eq!(verdict(&koebe_mesh_of(&mesh), Property::Planar), Answer::Refuted);
    // An odd face, an odd vertex, a radius 0.
    let tetrahedron = fan(at(0, 0), vec![at(1, 0), at(0, 1), at(-1, -1)]);
    let odd = christoffel_by_radii(&tetrahedron, &[r(1, 1), r(1, 1), r(1, 1), r(1, 1)]);
    assert_eq!(odd, Err(NoChristoffelDual::OddFace(FaceId(0))));
    assert_eq!(christoffel_by_diagonals(&tetrahedron), Err(NoChristoffelDual::NoQuad(FaceId(0))));
    let zero = christoffel_by_radii(&mesh, &[r(1, 1), r(0, 1), r(1, 1), r(1, 1)]);
    assert_eq!(zero, Err(NoChristoffelDual::ZeroRadius(VertexId(1))));
}

#[test]
fn circles_through_the_centre_are_rejected_by_name() {
    let at = |p, d| TopView::new(q::<Rational>(p, d), q(0, 1));
    let refused = enneper(2, 2, &at(1, 2)).unwrap_err();
    assert_eq!(refused, NoSurface::ThroughCentre(ThroughCentre::Vertex(VertexId(0))));
    let half = TopView::new(q::<Rational>(1, 2), q(0, 1));
    assert!(inverted_packing(&square_packing::<Rational>(1, 1), &half).is_err());
    // The circle of face 0 about (1/2, 1/2) with radius 1/2 passes through (0, 1/2), as vertex 0 does.
    let off = TopView::new(q::<Rational>(4, 5), q(9, 10));
    assert_eq!(
        enneper(1, 1, &off).unwrap_err(),
        NoSurface::ThroughCentre(ThroughCentre::Face(FaceId(0)))
    );
}

#[test]
fn doubles_see_the_same_surfaces() {
    let [exact, rounded] = [
        enneper(4, 4, &TopView::new(q::<Rational>(2, 1), q(2, 1)))
            .unwrap()
            .surface
            .map(isogeo::scalar::Approx::to_f64),
        enneper(4, 4, &TopView::new(2.0, 2.0)).unwrap().surface,
    ];
    for (p, r) in exact.points.iter().zip(&rounded.points) {
        assert!(p.i_distance2(r) < 1.0 / (1u64 << 40) as f64);
    }
    let gauss = enneper(4, 4, &TopView::new(2.0, 2.0)).unwrap().gauss;
    let dual = christoffel_by_radii(&gauss, &gauss.data.vertex[RADIUS]).unwrap().mesh;
    let shift = &rounded.points[0];
    for (p, r) in dual.points.iter().zip(&rounded.points) {
        let v = r - shift;
        let gap = p.map(|c| c / 4.0).i_distance2(&Point::new(v.x, v.y, v.z));
        assert!(gap < 1.0 / (1u64 << 40) as f64);
    }
}

/// Inversion and dual of n rings cost O(log n) bits each, in closed form.
#[test]
fn enneper_has_short_numbers() {
    let pair = enneper(20, 20, &TopView::new(q::<Rational>(-1, 2), q(-1, 2))).unwrap();
    let bits = |mesh: &Mesh<Rational>| {
        let all = mesh.points.iter().flat_map(|p| p.coordinates());
        all.map(|c| c.denominator().bits()).max().unwrap_or(0)
    };
    assert_eq!((bits(&pair.surface), bits(&pair.gauss)), (4, 14));
    let decider = Decider::of_rationals(&pair.surface.points);
    let koenigs = Net::new(&pair.surface.topology, &decider).check(Property::Koenigs);
    assert_eq!(koenigs.verdict(), Answer::Proved);
}

#[test]
fn the_saddle_and_the_helicoid() {
    is_koebe_pair(&saddle::<Rational>(3, 2).unwrap());
    let half = Rotation::new(q::<Rational>(4, 5), q(3, 5)).unwrap();
    let net = helicoid(3, 4, &half).unwrap();
    assert_eq!(verdict(&net, Property::ANet), Answer::Proved);
    // The conjugate of the circular logarithmoid, from g = qᵏ e_j.
    let circles = polar_packing(3, 4, &half).unwrap();
    let g = |i: usize| circles[i].centre.position();
    let data = WeierstrassData {
        rows: (0..4).map(|k| g(5 * k)).collect(),
        columns: (1..5).map(g).collect(),
        alpha: vec![q(1, 1); 3],
        beta: vec![-(q::<Rational>(16, 25)); 4],
    };
    let from_data = Weierstrass::new(&data).and_then(|data| data.conjugate()).unwrap();
    let scale = &net.points[5].x - &net.points[0].x;
    let scale = scale / (&from_data.points[5].x - &from_data.points[0].x);
    for (p, r) in net.points.iter().zip(&from_data.points) {
        let v = p - &net.points[0];
        assert_eq!((v.x, v.y), (&r.x * &scale, &r.y * &scale));
        assert_eq!(v.z, &r.z * &scale);
    }
}
