//! Gauss images, Christoffel duals, images in Euclidean space, Delaunay triangulations: what is made
//! from random meshes is what it is said to be.

use proptest::prelude::*;

use super::decider::decided;
use super::{accepted, check, fails, given};
use crate::campaign::law::{Law, drawn};
use crate::check::Verdict;
use crate::claim::{Run, Stop};
use crate::construct::gauss_image::NoGaussImage;
use crate::construct::transfer::{
    circular_image, conical_image, edge_offset_image, isothermic_image, stored_axes, stored_planes,
};
use crate::construct::{
    christoffel_by_radii, circumscribed_f_parallel, circumscribed_v_parallel, delaunay,
    inscribed_f_parallel, inscribed_v_parallel,
};
use crate::mesh::{FaceId, Mesh, VertexId};
use crate::net::{Property, RADIUS};
use crate::scalar::Rational;
use crate::space::{Point, TopView};
use crate::strategy::{
    circular, conical, delaunay_graph, jittered, koebe, lattice, number, relabelled, small,
};

fn proved(mesh: &Mesh<Rational>, property: Property) -> Run {
    let verdict = decided(mesh, property).verdict();
    check(verdict == Verdict::Proved, || format!("{} is {verdict}", property.name()))
}

/// No edge has length 0 in the top view.
fn has_directions(mesh: &Mesh<Rational>) -> bool {
    let topology = &mesh.topology;
    topology.edges().all(|h| {
        let [a, b] = [topology.origin(h), topology.target(h)].map(|v| &mesh.points[v.index()]);
        !a.is_parallel_to(b)
    })
}

type Start = (Mesh<Rational>, Rational, Rational);

fn inscribed((mesh, x, y): &Start) -> Run {
    if !has_directions(mesh) {
        return Err(Stop::Excluded("no vertical edge"));
    }
    let start = TopView::new(x.clone(), y.clone());
    let pair = accepted("f-parallel", inscribed_f_parallel(mesh, VertexId(0), &start))?;
    proved(pair.image(), Property::Inscribed)?;
    let pair = accepted("v-parallel", inscribed_v_parallel(mesh))?;
    proved(pair.image(), Property::Inscribed)
}

fn circumscribed((mesh, x, y): &Start) -> Run {
    match circumscribed_f_parallel(mesh) {
        Ok(image) => proved(image.pair.image(), Property::Circumscribed)?,
        Err(NoGaussImage::AtInfinity(_)) => {}
        Err(why) => return Err(fails(format!("f-parallel: {why}"))),
    }
    if !has_directions(mesh) {
        return Err(Stop::Excluded("no vertical edge"));
    }
    let topology = &mesh.topology;
    let plane = |face| mesh.face_plane(face);
    let folded = topology.edges().all(|h| match topology.twin(h) {
        Some(twin) => plane(topology.face_at(h)) != plane(topology.face_at(twin)),
        None => true,
    });
    if !folded {
        return Err(Stop::Excluded("no coplanar faces at an edge"));
    }
    let start = TopView::new(x.clone(), y.clone());
    let pair = accepted("v-parallel", circumscribed_v_parallel(mesh, FaceId(0), &start))?;
    proved(pair.image(), Property::Circumscribed)
}

/// The dual of the dual, with the inverse radii, is the mesh again, moved.
fn christoffel(mesh: &Mesh<Rational>) -> Run {
    let radii = mesh.data.vertex.get(RADIUS).ok_or(Stop::Excluded("radii"))?;
    let dual = accepted("a dual", christoffel_by_radii(mesh, radii))?;
    proved(&dual.mesh, Property::Planar)?;
    let again = accepted("the dual of the dual", christoffel_by_radii(&dual.mesh, &dual.factors))?;
    let step = |points: &[Point<Rational>], v: usize| &points[v] - &points[0];
    let same = (0..mesh.points.len()).all(|v| step(&again.mesh.points, v) == step(&mesh.points, v));
    check(same && again.factors == *radii, || "the dual of the dual is another mesh".into())
}

/// The interior of an i-circular mesh comes back from its conical image.
fn conical_and_back(mesh: &Mesh<Rational>) -> Run {
    let image = given("no circle stands for a great circle", conical_image(mesh))?.mesh;
    let planes = stored_planes(&image).ok_or_else(|| fails("no planes are stored"))?;
    let planes = accepted("unit normals", planes)?;
    let back = given("dual combinatorics", circular_image(&image, &planes))?;
    same_interior(mesh, &back)
}

/// The same for an i-isothermic mesh and its edge-offset image.
fn edge_offset_and_back(mesh: &Mesh<Rational>) -> Run {
    let radii = mesh.data.vertex.get(RADIUS).ok_or(Stop::Excluded("radii"))?;
    let image = given("no circle stands for a great circle", edge_offset_image(mesh, radii))?.mesh;
    let axes = stored_axes(&image).ok_or_else(|| fails("no axes are stored"))?;
    let back = given("dual combinatorics", isothermic_image(&image, &axes))?;
    same_interior(mesh, &back)
}

fn same_interior(mesh: &Mesh<Rational>, back: &Mesh<Rational>) -> Run {
    let inside = mesh.topology.interior_vertices().map(|v| &mesh.points[v.index()]);
    if back.points.is_empty() {
        return Err(Stop::Excluded("an interior vertex"));
    }
    check(inside.eq(&back.points), || "another mesh comes back".into())
}

/// The triangulation is proved to be Delaunay, and does not depend on the order of the points.
fn triangulation((mesh, seed): &(Mesh<Rational>, u32)) -> Run {
    let again = accepted("a triangulation", delaunay(mesh.points.clone()))?;
    // One triangle has no edge to look at.
    if again.topology.face_count() > 1 {
        proved(&again, Property::Delaunay)?;
    }
    let other = relabelled(&again, (*seed).into());
    let other = accepted("a triangulation", delaunay(other.points))?;
    let triangles = |mesh: &Mesh<Rational>| {
        let corners =
            |face| mesh.topology.face(face).iter().map(|v| mesh.points[v.index()].clone());
        mesh.topology.faces().map(|face| corners(face).collect()).collect::<Vec<Vec<_>>>()
    };
    check(triangles(&again) == triangles(&other), || "the order of the points matters".into())
}

pub(super) const LAWS: &[Law] = &[
    Law {
        id: "inscribed-images",
        says: "an i-circular mesh has an inscribed f-parallel image for every start, and a v-parallel one",
        control: false,
        cases: || drawn((circular(), small(), number()), inscribed),
    },
    Law {
        id: "circumscribed-images",
        says: "an i-conical mesh has a circumscribed f-parallel image, and a v-parallel one for every start",
        control: false,
        cases: || drawn((conical(), small(), number()), circumscribed),
    },
    Law {
        id: "christoffel-twice",
        says: "the Christoffel dual of the dual of an i-Koebe mesh is the mesh",
        control: false,
        cases: || drawn(koebe(), christoffel),
    },
    Law {
        id: "tau-conical",
        says: "an i-circular mesh comes back from its conical image in Euclidean space",
        control: false,
        cases: || drawn(circular(), conical_and_back),
    },
    Law {
        id: "tau-edge-offset",
        says: "an i-Koebe mesh comes back from its edge-offset image in Euclidean space",
        control: false,
        cases: || drawn(koebe(), edge_offset_and_back),
    },
    Law {
        id: "delaunay",
        says: "the triangulation of random points is proved to be Delaunay, whatever their order",
        control: false,
        cases: || {
            drawn(
                (prop_oneof![delaunay_graph(), jittered(), lattice()], any::<u32>()),
                triangulation,
            )
        },
    },
];
