//! Curvatures at vertices (21), (22), and the readings of the mixed measure.

use isogeo::construct::{inscribed_v_parallel, lift, metric_dual};
use isogeo::mesh::{FaceId, Mesh, VertexId};
use isogeo::pair::*;
use isogeo::scalar::RationalField;
use isogeo::space::*;
use proptest::prelude::*;

use super::*;

laws! {
    weights_are_in_equilibrium_and_the_mixed_measure_is_their_laplacian
    the_lift_measures_circumcentric_area
    vertical_offsets_shift_mean_curvature
    lattice_triangulations_are_exact_for_quadratics
    flips_on_a_circle_keep_mean_curvature
    motions_keep_curvatures_of_vertices
    edge_curvatures_are_ratios_of_weights
}

laws! {
    in 64 cases:
    weights_of_planar_faces_do_the_same
    measures_add_up_to_the_boundary
    measures_have_the_stress_as_their_derivative
    vertex_curvatures_are_face_curvatures_of_the_dual
    lifts_have_cotangent_weights
}

const CENTRE: VertexId = VertexId(0);

fn identities<Q: RationalField>(pair: &VParallel<'_, Q>, v: VertexId) -> Verdict {
    let star = pair.star(v).unwrap();
    let forms = pair.vertex_forms(v).unwrap();
    let two = Q::from_i64(2);
    for which in [0, 1] {
        let zero = Vector2::new(Q::zero(), Q::zero());
        let total =
            star.iter().fold(zero.clone(), |sum, e| &sum + &e.edge.scaled(&e.weight[which]));
        prop_assert_eq!(&total, &zero);
        let own = star.iter().fold(Q::zero(), |sum, e| sum + &e.weight[which] * &e.rise[which]);
        let measure = if which == 0 { forms.measure() } else { forms.image_measure() };
        prop_assert_eq!(own, measure * &two);
    }
    let mixed = forms.mixed_measure() * two;
    prop_assert_eq!(pair.laplacian(v).unwrap(), mixed.clone());
    prop_assert_eq!(pair.load(v).unwrap(), mixed);
    Ok(())
}

fn weights_are_in_equilibrium_and_the_mixed_measure_is_their_laplacian<Q: RationalField>(
    draw: &mut Draw<Q>,
) -> Verdict {
    let m = star(draw);
    let s = with_heights(draw, &m);
    let pair = VParallel::new(&m, &s).unwrap();
    identities(&pair, CENTRE)?;
    // One height disturbed: the mixed measure changes with the weight of that edge in S.
    let mut other = m.clone();
    other.points[1].z += &Q::one();
    let changed = VParallel::new(&other, &s).unwrap().vertex_forms(CENTRE).unwrap();
    let edges = pair.star(CENTRE).unwrap();
    let edge = edges.iter().find(|e| e.target == VertexId(1)).unwrap();
    let before = pair.vertex_forms(CENTRE).unwrap();
    let change = changed.mixed_measure() - before.mixed_measure();
    prop_assert_eq!(change.is_zero(), edge.weight[1].is_zero());
    prop_assert_eq!(change * Q::from_i64(2), edge.weight[1].clone());
    Ok(())
}

fn weights_of_planar_faces_do_the_same<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = circular(draw, 2, 2);
    if !graph_faces(&m) {
        return Ok(());
    }
    let pair = inscribed_v_parallel(&m).unwrap();
    for v in m.topology.interior_vertices() {
        identities(&pair, v)?;
    }
    let mut other = m.clone();
    other.points[4].z += &Q::one();
    prop_assert!(VParallel::new(&other, pair.image()).is_err());
    Ok(())
}

/// A star of four or five points anywhere: obtuse, folded, winding as it likes.
pub fn wild<Q: RationalField>(draw: &mut Draw<Q>) -> Option<Mesh<Q>> {
    let k = 4 + draw.index(2);
    let mesh = fan(draw.point(), (0..k).map(|_| draw.point()).collect());
    graph_faces(&mesh).then_some(mesh)
}

fn cotangents_hold<Q: RationalField>(m: &Mesh<Q>) -> Verdict {
    let pair = inscribed_v_parallel(m).unwrap();
    let star = pair.star(CENTRE).unwrap();
    let mut laplacian = Q::zero();
    for e in &star {
        let cotangent = cotangent_weight(m, e.half_edge).unwrap();
        prop_assert_eq!(&cotangent, &e.weight[1]);
        laplacian += &(cotangent * &e.rise[0]);
    }
    let forms = pair.vertex_forms(CENTRE).unwrap();
    prop_assert_eq!(&laplacian, &(forms.mixed_measure() * Q::from_i64(2)));
    prop_assert_eq!(pair.hinge(CENTRE).unwrap(), forms.four.mixed.clone());
    if let Ok(c) = forms.curvatures() {
        prop_assert_eq!(c.mean * Q::from_i64(2) * forms.image_measure(), laplacian.clone());
    }
    // One height disturbed: the sum changes with the cotangents of that edge.
    let mut other = m.clone();
    other.points[1].z += &Q::one();
    let raised = VParallel::new(&other, pair.image()).unwrap().vertex_forms(CENTRE).unwrap();
    let edge = star.iter().find(|e| e.target == VertexId(1)).unwrap();
    let cotangent = cotangent_weight(m, edge.half_edge).unwrap();
    let same = raised.mixed_measure() * Q::from_i64(2) == laplacian;
    prop_assert_eq!(same, cotangent.is_zero());
    Ok(())
}

/// `eq-22-cotan`
fn lifts_have_cotangent_weights<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    cotangents_hold(&star(draw))?;
    wild(draw).map_or(Ok(()), |m| cotangents_hold(&m))
}

/// The area of the polygon of circumcentres, and a quarter of the sum of weights times lengths.
fn the_lift_measures_circumcentric_area<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let meshes = [Some(star(draw)), wild(draw)];
    for m in meshes.into_iter().flatten() {
        let pair = inscribed_v_parallel(&m).unwrap();
        let centre = |h| {
            let face = m.topology.face(m.topology.face_at(h));
            let [a, b, c] = [0, 1, 2].map(|i| m.points[face[i].index()].top_view());
            Circle::through(&a, &b, &c).unwrap().centre
        };
        let mut centres: Vec<TopView<Q>> = m.topology.star(CENTRE).map(centre).collect();
        let forms = pair.vertex_forms(CENTRE).unwrap();
        prop_assert_eq!(twice_area(&centres) * q::<Q>(1, 2), forms.image_measure());
        let star = pair.star(CENTRE).unwrap();
        let four = star.iter().fold(Q::zero(), |sum, e| sum + &e.weight[1] * e.edge.length2());
        prop_assert_eq!(four, forms.four.second.clone());
        prop_assert_eq!(forms.image_is_reversed(), forms.image_measure() < Q::zero());

        let change = (&centres[2] - &centres[0]).y;
        centres[1].x += &Q::one();
        let same = twice_area(&centres) * q::<Q>(1, 2) == forms.image_measure();
        prop_assert_eq!(same, change.is_zero());
    }
    Ok(())
}

/// Gauss-Bonnet, from the boundary edges and along the loops of outermost faces.
fn measures_add_up_to_the_boundary<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = triangle_patch(draw, 3, 3);
    if !graph_faces(&m) {
        return Ok(());
    }
    let s = with_heights(draw, &m);
    let pair = VParallel::new(&m, &s).unwrap();
    let total = pair.total_forms();
    prop_assert_eq!(&total.interior, &total.boundary);
    let dual = m.topology.dual().unwrap().topology;
    let (mut areas, mut mixed) = (Q::zero(), Q::zero());
    for l in dual.boundary_loops() {
        let [p, r] = [Which::Mesh, Which::Image].map(|which| -> Vec<Gradient<Q>> {
            l.iter().map(|f| pair.gradient(which, FaceId(f.0)).clone()).collect()
        });
        areas += &(twice_area(&p) * Q::from_i64(2));
        mixed += &four_mixed_areas(&p, &r);
    }
    prop_assert_eq!(areas, total.interior.first.clone());
    prop_assert_eq!(mixed, total.interior.mixed.clone());

    // Without one vertex the sum is another, unless that one measures 0.
    let v = m.topology.interior_vertices().next().unwrap();
    let forms = pair.vertex_forms(v).unwrap();
    let without = total.interior.plus(&forms.four.reversed());
    prop_assert_eq!(without == total.boundary, forms.four == Forms::zero());
    Ok(())
}

/// D is quadratic in the heights, so a central difference is exact.
fn measures_have_the_stress_as_their_derivative<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = star(draw);
    let pair = inscribed_v_parallel(&m).unwrap();
    let step = draw.non_zero();
    for (v, derivative) in pair.jacobian_row(CENTRE).unwrap() {
        let measure = |step: &Q| {
            let mut moved = m.clone();
            moved.points[v.index()].z += step;
            let moved = VParallel::new(&moved, pair.image()).unwrap().vertex_forms(CENTRE).unwrap();
            moved.measure()
        };
        let difference = measure(&step) - measure(&-&step);
        prop_assert_eq!(&difference, &(&derivative * Q::from_i64(2) * &step));
        prop_assert_ne!(difference, (derivative + Q::one()) * Q::from_i64(2) * &step);
    }
    Ok(())
}

/// The dual of (18).
fn vertical_offsets_shift_mean_curvature<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = star(draw);
    let s = with_heights(draw, &m);
    let (pair, d) = (VParallel::new(&m, &s).unwrap(), draw.non_zero());
    let Ok(c) = pair.vertex_curvatures(CENTRE) else { return Ok(()) };
    let offset = pair.offset(&d);
    let moved = VParallel::new(&offset, &s).unwrap().vertex_curvatures(CENTRE).unwrap();
    prop_assert_eq!(&moved, &c.v_offset(&d));
    prop_assert_eq!(moved.discriminant(), c.discriminant());
    prop_assert_ne!(moved, c.v_offset(&(d + Q::one())));
    Ok(())
}

/// `eq-21-22-duality`, `duality-f-v`
fn vertex_curvatures_are_face_curvatures_of_the_dual<Q: RationalField>(
    draw: &mut Draw<Q>,
) -> Verdict {
    let m = circular(draw, 2, 2);
    if !graph_faces(&m) {
        return Ok(());
    }
    let pair = inscribed_v_parallel(&m).unwrap();
    let v = m.topology.interior_vertices().next().unwrap();
    let forms = pair.vertex_forms(v).unwrap();
    let (dual, image) = (metric_dual(&m).unwrap(), metric_dual(pair.image()).unwrap());
    prop_assert!(Parallel::new(&dual, &image).is_ok());
    let Ok(f_pair) = FParallel::new(&dual, &image) else { return Ok(()) };
    let dual_forms = f_pair.face_forms(FaceId(0));
    prop_assert_eq!(&dual_forms.four, &forms.four);
    if let (Ok(c), Ok(star)) = (forms.curvatures(), dual_forms.curvatures()) {
        prop_assert_eq!(star.dual(), Some(c.clone()));
        prop_assert_eq!(c.dual(), Some(star.clone()));
        let wrong = Curvatures { gauss: &c.gauss + Q::one(), ..c };
        prop_assert_ne!(star.dual(), Some(wrong));
    }
    Ok(())
}

/// `fig-11-accuracy`: every lattice triangulation with six triangles around a vertex.
fn lattice_triangulations_are_exact_for_quadratics<Q: RationalField>(
    draw: &mut Draw<Q>,
) -> Verdict {
    let (a, b) = (Vector2::new(draw.non_zero(), draw.number()), draw.vector());
    if a.det(&b).is_zero() {
        return Ok(());
    }
    let b = if a.det(&b) < Q::zero() { -&b } else { b };
    let directions = [a.clone(), &a + &b, b.clone()];
    let terms = [(2, 0), (1, 1), (0, 2), (1, 0), (0, 1), (0, 0)];
    let f = Polynomial::new(terms.map(|(i, j)| (i, j, draw.number())));
    let at = draw.top_view();
    let lifted = |at: TopView<Q>| {
        let z = f.value_at(&at);
        at.at_height(z)
    };
    let ring = directions.iter().map(|d| &at + d);
    let ring: Vec<_> = ring.chain(directions.iter().map(|d| &at + &-d)).map(lifted).collect();
    let mut mesh = fan(lifted(at.clone()), ring);
    let jet = f.jet(&at).unwrap();
    let measure = |m: &Mesh<Q>| {
        let pair = inscribed_v_parallel(m).unwrap();
        pair.vertex_curvatures(CENTRE).unwrap()
    };
    let c = measure(&mesh);
    prop_assert_eq!(&c.mean, &jet.mean_curvature());
    prop_assert_eq!(&c.gauss, &jet.curvature());
    mesh.points[0].z += &Q::one();
    prop_assert_ne!(measure(&mesh).mean, c.mean);
    Ok(())
}

/// Two triangles with four points on a circle: H does not see how they are cut, K does unless the
/// points are coplanar.
fn flips_on_a_circle_keep_mean_curvature<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let turn = |t: Q| {
        let r = Rotation::from_parameter(&t).unwrap();
        r.turn(&Vector2::new(Q::from_i64(2), Q::zero()))
    };
    let z = |draw: &mut Draw<Q>, v: Vector2<Q>| Point::new(v.x, v.y, draw.number());
    // 0, A, B, C on a circle through the origin about (2, 0); the others make a star.
    let on_circle = [q(-1, 2), q(0, 1), q(1, 2)].map(|t: Q| {
        let v = turn(t);
        &v + &Vector2::new(Q::from_i64(2), Q::zero())
    });
    let [a, b, c] = on_circle.map(|v| z(draw, v));
    let rest: Vec<Point<Q>> = [(-2, 3), (-3, -2)]
        .map(|(x, y)| z(draw, Vector2::new(Q::from_i64(x), Q::from_i64(y))))
        .to_vec();
    let centre = z(draw, Vector2::new(Q::zero(), Q::zero()));
    let with = [vec![a.clone(), b.clone(), c.clone()], rest.clone()].concat();
    let without = [vec![a.clone(), c.clone()], rest].concat();
    let forms = |ring: Vec<Point<Q>>| {
        let m = fan(centre.clone(), ring);
        inscribed_v_parallel(&m).unwrap().vertex_forms(CENTRE).unwrap()
    };
    let (cut, flipped) = (forms(with), forms(without));
    prop_assert_eq!(&cut.four.mixed, &flipped.four.mixed);
    prop_assert_eq!(&cut.four.second, &flipped.four.second);
    let coplanar = Vector3::det(&(&a - &centre), &(&b - &centre), &(&c - &centre)).is_zero();
    prop_assert_eq!(cut.four.first == flipped.four.first, coplanar);
    Ok(())
}

fn motions_keep_curvatures_of_vertices<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = star(draw);
    let (motion, scaling) = (draw.motion(), draw.scaling());
    let measure = |m: &Mesh<Q>| {
        let pair = inscribed_v_parallel(m).unwrap();
        pair.vertex_curvatures(CENTRE).ok()
    };
    let Some(c) = measure(&m) else { return Ok(()) };
    let moved = measure(&motion.apply(&m)).unwrap();
    prop_assert_eq!(&moved, &c);
    let grown = measure(&scaling.apply(&m)).unwrap();
    let factor = scaling.vertical() / scaling.horizontal().square();
    prop_assert_eq!(grown.mean, &c.mean * &factor);
    prop_assert_eq!(&grown.gauss, &(&c.gauss * factor.square()));
    prop_assert_eq!(grown.gauss == &c.gauss * (factor.square() + Q::one()), c.gauss.is_zero());
    Ok(())
}

/// And the quad relations of the face, in the dual: the measure of a vertex with four faces.
fn edge_curvatures_are_ratios_of_weights<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = star(draw);
    let s = with_heights(draw, &m);
    let pair = VParallel::new(&m, &s).unwrap();
    for e in pair.star(CENTRE).unwrap() {
        let [w, image] = &e.weight;
        match pair.edge_curvature(e.half_edge) {
            Ok(kappa) => {
                prop_assert_eq!(&(&kappa * image), w);
                prop_assert_ne!(&((kappa + Q::one()) * image), w);
            }
            Err(_) => prop_assert!(image.is_zero()),
        }
    }
    prop_assert_eq!(lift(&m).points[1].x.clone(), m.points[1].x.clone());
    Ok(())
}
