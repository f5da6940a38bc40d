//! Images of i-isothermic and of Koebe meshes under i-M-transformations (Remarks 2 and 4).

use isogeo::check::{Decider, Verdict};
use isogeo::construct::minimal::{MeshPair, enneper, logarithmoid};
use isogeo::construct::transfer::edge_offset_image;
use isogeo::construct::{
    NoIncircleImage, face_circle, incircle_image, koebe_image, koebe_mesh, moebius_image,
    quad_patch, square_packing, vertex_circles,
};
use isogeo::mesh::{FaceId, Mesh, VertexId};
use isogeo::net::{Net, Property, RADIUS};
use isogeo::scalar::{Field, Rational, Ring};
use isogeo::space::laguerre::{Cone, LaguerreTransformation};
use isogeo::space::{
    Circle, CylindricalSphere, MoebiusSphere, MoebiusTransformation, Point, Rotation, Scaling,
    TopView, Vector3,
};

type Q = Rational;

fn q(p: i64, d: i64) -> Q {
    Q::from_ratio(p, d)
}

fn inversion(x: Q, y: Q) -> MoebiusTransformation<Q> {
    let circle = Circle::new(TopView::new(x, y), q(3, 2));
    let cylinder = CylindricalSphere::new(circle).expect("a radius");
    MoebiusTransformation::inversion_at_cylinder(&cylinder, &q(2, 1))
}

/// The i-minimal meshes, with transformations of both kinds.
fn cases() -> Vec<(Mesh<Q>, MoebiusTransformation<Q>)> {
    let centre = TopView::new(q(-1, 2), q(-3, 2));
    let half = Rotation::new(q(4, 5), q(3, 5)).expect("an angle");
    let own = |pair: MeshPair<Q>| pair.surface;
    let first = own(enneper(4, 3, &centre).expect("a surface"));
    let second = own(logarithmoid(3, 4, &half).expect("a surface"));
    let bent = MoebiusTransformation::inversion_at(&MoebiusSphere::new(
        q(1, 2),
        q(1, 1),
        q(0, 1),
        q(3, 1),
    ));
    let both = inversion(q(1, 7), q(-2, 9)).then(&bent);
    vec![
        (first.clone(), inversion(q(7, 3), q(1, 5))),
        (first, both.clone()),
        (second.clone(), both),
        (second, bent),
    ]
}

fn verdict(mesh: &Mesh<Q>, property: Property) -> Verdict {
    let n = mesh.points.len() as u32;
    let radii = mesh.data.vertex[RADIUS].iter();
    let radii: Vec<_> = radii.map(|r| Point::new(r.clone(), q(0, 1), q(0, 1))).collect();
    let decider = Decider::of_rationals(&mesh.points).followed_by(Decider::of_rationals(&radii));
    Net::new(&mesh.topology, &decider).with_radii(VertexId(n)).check(property).verdict()
}

/// `remark-4`: the inverted incircles are the incircles of an i-isothermic mesh; twice inverted they
/// are where they were.
#[test]
fn inverted_incircles_are_incircles() {
    for (mesh, map) in cases() {
        let image = incircle_image(&mesh, &map).expect("an image");
        assert_eq!(verdict(&image, Property::Planar), Verdict::Proved);
        assert_eq!(verdict(&image, Property::IIsothermic), Verdict::Proved);
        let again = incircle_image(&image, &map.inverse()).expect("an image");
        assert_eq!((again.points, again.data), (mesh.points.clone(), mesh.data.clone()));
        // The control: with the vertices themselves inverted, faces do not stay planar if they are not
        // i-circular, as those of the logarithmoid are.
        let points = moebius_image(&mesh, &map).expect("an image");
        assert_ne!(points.points, image.points);
        let other = Mesh { data: image.data.clone(), ..points };
        let circular = verdict(&mesh, Property::ICircular) == Verdict::Proved;
        assert_eq!(verdict(&other, Property::Planar) == Verdict::Proved, circular);
    }
}

/// `remark-2-moebius`: under τ the image is the Laguerre image of the edge-offset mesh.
#[test]
fn tau_of_the_image_is_the_laguerre_image() {
    for (mesh, map) in cases() {
        let radii = |mesh: &Mesh<Q>| mesh.data.vertex[RADIUS].clone();
        let before = edge_offset_image(&mesh, &radii(&mesh)).expect("an edge-offset mesh");
        let image = incircle_image(&mesh, &map).expect("an image");
        let after = edge_offset_image(&image, &radii(&image)).expect("an edge-offset mesh");
        let laguerre = LaguerreTransformation::from(&map);
        for i in 0..before.mesh.points.len() {
            let cone = |image: &isogeo::construct::transfer::EuclideanImage<Q>| {
                let Point { x, y, z } = image.gauss.points[i].clone();
                Cone { vertex: image.mesh.points[i].clone(), axis: Vector3::new(x, y, z) }
            };
            assert_eq!(laguerre.map_cone(&cone(&before)), Ok(cone(&after)));
        }
    }
}

/// Only a mesh with radii whose circles touch has an image, and a face that is not planar none.
#[test]
fn other_meshes_are_refused() {
    let (mesh, map) = cases().remove(0);
    let mut wrong = mesh.clone();
    wrong.data.vertex.entry(RADIUS.into()).and_modify(|r| r[7] += &q(1, 1000));
    assert!(matches!(incircle_image(&wrong, &map), Err(NoIncircleImage::NotTouching { .. })));
    wrong.data.vertex.remove(RADIUS);
    assert_eq!(incircle_image(&wrong, &map), Err(NoIncircleImage::NoRadii));
    let mut bent = mesh.clone();
    bent.points[7].z += &q(1, 1000);
    assert!(matches!(incircle_image(&bent, &map), Err(NoIncircleImage::Plane(_))));
    // The heights do not enter a Koebe mesh.
    assert!(koebe_image(&bent, &map).is_ok());
    let scaling = Scaling::new(q(2, 1), q(1, 1)).expect("factors");
    let scaled = incircle_image(&mesh, &MoebiusTransformation::from(&scaling));
    assert_eq!(scaled, Err(NoIncircleImage::NotAnIsometry));
    // Radii of other signs: circles that do not touch with them.
    let mut turned = mesh;
    turned.data.vertex.entry(RADIUS.into()).and_modify(|r| r[0] = -&r[0]);
    assert!(matches!(incircle_image(&turned, &map), Err(NoIncircleImage::NotTouching { .. })));
}

/// `koebe-edge`, `thm-3`: Möbius images of the square packing are Koebe meshes, also with a circle that
/// is turned over; circles through the centre have none.
#[test]
fn koebe_meshes_under_inversions() {
    let mesh = koebe_mesh(square_packing::<Q>(4, 4), quad_patch(4, 4)).expect("a grid");
    for (x, y, turned) in [(q(-3, 1), q(1, 2), None), (q(2, 1), q(17, 8), Some(12))] {
        let image = koebe_image(&mesh, &inversion(x, y)).expect("an image");
        for property in [Property::Planar, Property::Midscribed, Property::IIsothermic] {
            assert_eq!(verdict(&image, property), Verdict::Proved, "{}", property.name());
        }
        let radii = &image.data.vertex[RADIUS];
        let negative: Vec<_> = (0..25).filter(|&v| radii[v] < q(0, 1)).collect();
        assert_eq!(negative, Vec::from_iter(turned));
        // One radius without its sign.
        if let Some(v) = turned {
            let mut unsigned = image.clone();
            unsigned.data.vertex.entry(RADIUS.into()).and_modify(|r| r[v] = -&r[v]);
            assert_eq!(verdict(&unsigned, Property::IIsothermic), Verdict::Refuted);
        }
        // Schramm's equation with signs, and face circles orthogonal to vertex circles.
        let circles = vertex_circles(&image).expect("radii");
        for face in image.topology.faces() {
            let circle = face_circle(&image, face).expect("a plane").expect("radii");
            for v in image.topology.face(face) {
                assert!(circle.orthogonality(&circles[v.index()]).is_zero());
            }
        }
    }
    let at_corner = inversion(q(1, 2), q(0, 1));
    assert_eq!(koebe_image(&mesh, &at_corner), Err(NoIncircleImage::Vertex(VertexId(0))));
    // (4/5, 3/5) from the middle of a face with the circle of radius 1/2, off those of its vertices.
    let on_face = inversion(q(1, 2) + q(2, 5), q(1, 2) + q(3, 10));
    assert_eq!(koebe_image(&mesh, &on_face), Err(NoIncircleImage::Face(FaceId(0))));
}

/// `remark-1`: an i-circular mesh whose cross-ratios factorise has images of the same classes, and an
/// inscribed one stays so under the inversion at Σ.
#[test]
fn moebius_images_keep_classes() {
    let half = Rotation::new(q(4, 5), q(3, 5)).expect("an angle");
    let MeshPair { surface, .. } = logarithmoid(3, 4, &half).expect("a surface");
    let verdict = |mesh: &Mesh<Q>, property| {
        let decider = Decider::of_rationals(&mesh.points);
        Net::new(&mesh.topology, &decider).check(property).verdict()
    };
    let sigma = MoebiusTransformation::inversion_at(&MoebiusSphere::new(
        q(1, 1),
        q(0, 1),
        q(0, 1),
        q(0, 1),
    ));
    for map in
        [inversion(q(1, 7), q(-2, 9)), inversion(q(3, 1), q(1, 1)).then(&sigma), sigma.clone()]
    {
        let mut image = moebius_image(&surface, &map).expect("an image");
        use Property::{ICircular, IIsothermic, Koenigs, Planar};
        for property in [Planar, ICircular, IIsothermic, Koenigs] {
            assert_eq!(verdict(&surface, property), Verdict::Proved, "{}", property.name());
            assert_eq!(verdict(&image, property), Verdict::Proved, "{}", property.name());
        }
        image.points[7].x += &q(1, 1000);
        for property in [Planar, ICircular, IIsothermic, Koenigs] {
            assert_eq!(verdict(&image, property), Verdict::Refuted, "{}", property.name());
        }
    }
    let lifted = isogeo::construct::lift(&surface);
    let image = moebius_image(&lifted, &sigma).expect("an image");
    assert_eq!(
        (&image.points, verdict(&image, Property::Inscribed)),
        (&lifted.points, Verdict::Proved)
    );
    let other = moebius_image(&lifted, &inversion(q(3, 1), q(1, 1))).expect("an image");
    assert_eq!(verdict(&other, Property::Inscribed), Verdict::Refuted);
}
