//! Verdicts do not depend on names, nor on where a mesh lies in isotropic space.

use proptest::prelude::*;

use super::decider::decided;
use super::{check, given};
use crate::campaign::law::{Law, drawn};
use crate::check::{Element, Verdict};
use crate::claim::{Run, Stop};
use crate::construct::{metric_dual, moebius_image};
use crate::mesh::{Mesh, VertexKind};
use crate::net::Property;
use crate::scalar::Rational;
use crate::space::{MoebiusTransformation, Motion, Scaling, Transform};
use crate::strategy::{
    any_mesh, cauchy, circular, conical, jittered, koebe, moebius, motion, near_degenerate, number,
    quad_patches, relabelled, scaling, small, translational,
};

fn meshes() -> impl Strategy<Value = Mesh<Rational>> {
    let any = prop_oneof![any_mesh(small()), any_mesh(number())];
    near_degenerate(prop_oneof![any, quad_patches(), circular(), conical(), koebe(), jittered()])
}

fn names((mesh, seed): &(Mesh<Rational>, u32)) -> Run {
    let other = relabelled(mesh, u64::from(*seed) << 7 | 5);
    Property::ALL.into_iter().try_for_each(|property| {
        let (a, b) = (decided(mesh, property), decided(&other, property));
        let same = a.verdict() == b.verdict() && a.failures.len() == b.failures.len();
        check(same, || {
            format!("{}: {}, after renaming {}", property.name(), a.verdict(), b.verdict())
        })
    })
}

fn similarities(
    (mesh, motion, scaling): &(Mesh<Rational>, Motion<Rational>, Scaling<Rational>),
) -> Run {
    const INVARIANT: [Property; 6] = [
        Property::Planar,
        Property::ICircular,
        Property::IConical,
        Property::IIsothermic,
        Property::Koenigs,
        Property::Delaunay,
    ];
    let moved = scaling.apply(&motion.apply(mesh));
    INVARIANT.into_iter().try_for_each(|property| {
        let (a, b) = (decided(mesh, property), decided(&moved, property));
        let same = a.verdict() == b.verdict()
            && a.failures == b.failures
            && a.undefined == b.undefined
            && (a.checked, a.trivial) == (b.checked, b.trivial);
        check(same, || format!("{}: {}, moved {}", property.name(), a.verdict(), b.verdict()))
    })
}

fn inversions((mesh, map): &(Mesh<Rational>, MoebiusTransformation<Rational>)) -> Run {
    let image = given("no vertex over the centre", moebius_image(mesh, map))?;
    let verdict = decided(&image, Property::ICircular).verdict();
    if verdict == Verdict::Undecided {
        return Err(Stop::Excluded("no face circle through the centre"));
    }
    check(verdict == Verdict::Proved, || format!("the image is {verdict}"))
}

/// A face whose vertices are all interior is i-circular iff the dual vertex is i-conical.
fn duals(mesh: &Mesh<Rational>) -> Run {
    let dual = given("planar, without vertical faces", metric_dual(mesh))?;
    let (here, there) = (decided(mesh, Property::ICircular), decided(&dual, Property::IConical));
    let mut seen = false;
    for (face, vertex) in mesh.topology.faces().zip(dual.topology.vertices()) {
        let (face, vertex) = (Element::Face(face), (vertex, Element::Vertex(vertex)));
        let undefined = here.undefined.iter().any(|(element, _)| *element == face)
            || there.undefined.iter().any(|(element, _)| *element == vertex.1);
        if dual.topology.kind(vertex.0) != VertexKind::Interior || undefined {
            continue;
        }
        seen = true;
        let [a, b] = [here.failures.contains(&face), there.failures.contains(&vertex.1)];
        check(a == b, || format!("{face} fails: {a}, its dual fails: {b}"))?;
    }
    if seen { Ok(()) } else { Err(Stop::Excluded("a face of interior vertices")) }
}

pub(super) const LAWS: &[Law] = &[
    Law {
        id: "relabelling",
        says: "no verdict depends on the names of vertices and faces",
        control: false,
        cases: || drawn((meshes(), any::<u32>()), names),
    },
    Law {
        id: "i-similarities",
        says: "verdicts of isotropic classes are those of i-similarities",
        control: false,
        cases: || drawn((meshes(), motion(), scaling()), similarities),
    },
    Law {
        id: "i-m-transformations",
        says: "i-M-transformations keep i-circular meshes",
        control: false,
        cases: || drawn((circular(), moebius()), inversions),
    },
    Law {
        id: "dual-verdicts",
        says: "a face is i-circular iff its dual vertex is i-conical",
        control: false,
        cases: || {
            // Faces of interior vertices need three rows and three columns.
            let planar = prop_oneof![quad_patches(), cauchy(), translational()]
                .prop_filter("no face of interior vertices", |mesh: &Mesh<Rational>| {
                    mesh.topology.interior_vertices().nth(3).is_some()
                });
            drawn(planar, duals)
        },
    },
];
