//! Curvatures of pairs: offsets, motions, and the fast path.

use super::{accepted, check};
use crate::campaign::law::{Law, drawn};
use crate::claim::{Run, Stop};
use crate::construct::minimal::MeshPair;
use crate::mesh::{ExactPoints, Mesh};
use crate::pair::{Curvatures, ExactPair, FParallel, VParallel};
use crate::scalar::{Rational, Ring};
use crate::space::{Motion, Transform, Vector3};
use crate::strategy::{f_parallel, motion, number, v_parallel};

/// (18): H and K of the faces of the offset are those that the formula says.
fn offsets((pair, d): &(MeshPair<Rational>, Rational)) -> Run {
    let pair = accepted("f-parallel", FParallel::new(&pair.surface, &pair.gauss))?;
    let offset = pair.offset(d);
    let mut seen = false;
    for face in offset.topology.faces() {
        let law = pair.face_forms(face).offset_law();
        let corners = |mesh: &Mesh<Rational>| {
            let corners = mesh.topology.face(face).iter();
            corners.map(|v| mesh.points[v.index()].top_view()).collect::<Vec<_>>()
        };
        let forms = crate::pair::Forms::of(&corners(&offset), &corners(pair.image()));
        let found = forms.at_face();
        seen |= found.is_some();
        check(found == law.at(d), || {
            format!("face {}: {found:?}, by (18) {:?}", face.0, law.at(d))
        })?;
    }
    if seen { Ok(()) } else { Err(Stop::Excluded("a face of the offset with an area")) }
}

/// The linear part of a motion: what it does to a Gauss image.
fn linear(motion: &Motion<Rational>) -> Motion<Rational> {
    let zero = Rational::zero;
    Motion { translation: Vector3::new(zero(), zero(), zero()), ..motion.clone() }
}

fn faces_moved((pair, motion): &(MeshPair<Rational>, Motion<Rational>)) -> Run {
    let MeshPair { surface, gauss } = pair;
    let (m, s) = (motion.apply(surface), linear(motion).apply(gauss));
    let here = accepted("f-parallel", FParallel::new(surface, gauss))?;
    let there = accepted("f-parallel, moved", FParallel::new(&m, &s))?;
    surface.topology.faces().try_for_each(|face| {
        let [a, b] = [&here, &there].map(|pair| pair.face_curvatures(face));
        check(a == b, || format!("face {}: {a:?}, moved {b:?}", face.0))
    })
}

/// At vertices both meshes move alike.
fn vertices_moved((pair, motion): &(MeshPair<Rational>, Motion<Rational>)) -> Run {
    let MeshPair { surface, gauss } = pair;
    let (m, s) = (motion.apply(surface), motion.apply(gauss));
    let here = accepted("v-parallel", VParallel::new(surface, gauss))?;
    let there = accepted("v-parallel, moved", VParallel::new(&m, &s))?;
    let mut seen = false;
    for v in surface.topology.interior_vertices() {
        let [a, b] = [&here, &there].map(|pair| pair.vertex_curvatures(v));
        seen |= a.is_ok();
        check(a == b, || format!("vertex {}: {a:?}, moved {b:?}", v.0))?;
    }
    if seen { Ok(()) } else { Err(Stop::Excluded("a vertex with curvatures")) }
}

/// The fast path over integers gives the values of the definition.
fn fast_faces(pair: &MeshPair<Rational>) -> Run {
    let MeshPair { surface, gauss } = pair;
    let slow = accepted("f-parallel", FParallel::new(surface, gauss))?;
    let fast = exact(pair);
    surface.topology.faces().try_for_each(|face| {
        let (a, b) = (slow.face_curvatures(face), fast.face_curvatures(face));
        let b = b.map(|c| c.reduced::<Rational>());
        let same = a.as_ref().ok() == b.as_ref().ok().and_then(Option::as_ref);
        check(same, || format!("face {}: {a:?}, fast {b:?}", face.0))
    })
}

fn fast_vertices(pair: &MeshPair<Rational>) -> Run {
    let MeshPair { surface, gauss } = pair;
    let slow = accepted("v-parallel", VParallel::new(surface, gauss))?;
    let fast = exact(pair);
    let mut seen = false;
    for v in surface.topology.interior_vertices() {
        let (a, b) = (slow.vertex_curvatures(v), fast.vertex_curvatures(v));
        let b: Result<Option<Curvatures<Rational>>, _> = b.map(|c| c.reduced());
        seen |= a.is_ok();
        let same = a.as_ref().ok() == b.as_ref().ok().and_then(Option::as_ref);
        check(same, || format!("vertex {}: {a:?}, fast {b:?}", v.0))?;
    }
    if seen { Ok(()) } else { Err(Stop::Excluded("a vertex with curvatures")) }
}

fn exact(pair: &MeshPair<Rational>) -> ExactPair<'_> {
    let [m, s] = [&pair.surface, &pair.gauss].map(|mesh| ExactPoints::from(&mesh.points[..]));
    ExactPair::new(&pair.surface.topology, m, s)
}

pub(super) const LAWS: &[Law] = &[
    Law {
        id: "offset-curvatures",
        says: "the curvatures of offsets are those of (18)",
        control: false,
        cases: || drawn((f_parallel(), number()), offsets),
    },
    Law {
        id: "moved-faces",
        says: "i-motions keep H and K of faces",
        control: false,
        cases: || drawn((f_parallel(), motion()), faces_moved),
    },
    Law {
        id: "moved-vertices",
        says: "i-motions keep H and K of vertices",
        control: false,
        cases: || drawn((v_parallel(), motion()), vertices_moved),
    },
    Law {
        id: "fast-faces",
        says: "the fast path for H and K of faces gives the values of the definition",
        control: false,
        cases: || drawn(f_parallel(), fast_faces),
    },
    Law {
        id: "fast-vertices",
        says: "the fast path for H and K of vertices gives the values of the definition",
        control: false,
        cases: || drawn(v_parallel(), fast_vertices),
    },
];
