//! Sec. 3.4, Theorem 3: i-isothermic meshes.

use std::array;

use super::instance::{
    circles, contact, free_circle, free_plane, free_top_view, polygon_about, with_radii,
};
use super::{
    Claim, Control, Counterexample, Evidence, Experiment, Grade, Hypothesis, Identity, Run, Source,
    Stop, Trial,
};
use crate::check::Residual;
use crate::construct::{
    face_circle, inverted_packing, koebe_mesh, polar_packing, quad_patch, schramm_residual,
    vertex_circles,
};
use crate::mesh::{FaceId, FaceList, Mesh, NoPlane};
use crate::net::i_isothermic::{CoplanarPoles, TouchingCircles};
use crate::net::scribed::{EdgeTouchesSigma, OnSigma};
use crate::scalar::{Field, Rational, RationalField, Ring};
use crate::space::{Dual, OrientedCircle, ParabolicSphere, Plane, Rotation, TopView, Vector2};

pub(super) const CLAIMS: &[Claim] = &[Claim {
    id: "thm-3",
    statement: "An edge of a planar mesh touches Σ iff its top view touches the circle over which the \
                    face plane cuts Σ: the faces of the top view of a midscribed mesh have incircles. \
                    Those of two faces touch their edge at one point; the contacts around a vertex lie \
                    on a circle orthogonal to the incircles. Conversely such circles lift to a midscribed \
                    mesh, their radii at a quad satisfy Schramm's equation, and a mesh with its top view \
                    is i-isothermic.",
    formula: "ρ² (r₁ + r₂ + r₃ + r₄) = r₁ r₂ r₃ + r₂ r₃ r₄ + r₃ r₄ r₁ + r₄ r₁ r₂",
    source: Source::Paper("Sec. 3.4, Theorem 3"),
    hypotheses: &[
        Hypothesis::stated(INCIRCLE),
        Hypothesis::stated(ONE_CONTACT),
        Hypothesis::silent(VALENCE),
    ],
    said: Grade::Certified,
    argument: "All polygons with an incircle arise from its contacts, as k parameters of a circle. A \
                   mesh is made of faces, edges and vertices, and each statement is about one of them: \
                   with one contact for each edge, the radii of a vertex, its tangent lengths, are the \
                   same for all its faces. Valence 4 is that of the quads, and of interior vertices, \
                   whose circles take the place of the incircles.",
    evidence: &[
        Evidence::identity::<EdgeInFace>("edges, faces and vertices", &[1], &[1]),
        Evidence::identity::<TangentialFace>(
            "a face with k contacts",
            &[3, 4, 5, 6, 7, 8],
            &[4, 3, 5, 8],
        ),
        Evidence::experiment::<KoebeNet>("inverted packings", &[2, 3]),
    ],
    controls: &[
        Control {
            without: INCIRCLE,
            shows: "over a rectangle that is no square no four circles touch and lift",
            counterexample: Counterexample::Witness(rectangle),
        },
        Control {
            without: ONE_CONTACT,
            shows: "two circles that touch an edge at two points: their planes do not meet over it",
            counterexample: Counterexample::Witness(two_contacts),
        },
        Control {
            without: VALENCE,
            shows: "four of the five circles about a pentagon",
            counterexample: Counterexample::Witness(pentagon),
        },
    ],
}];

const INCIRCLE: &str = "every face of the top view has an incircle";
const ONE_CONTACT: &str = "the incircles touch at one point of every edge";
const VALENCE: &str = "Schramm's equation: four circles touch the face, or the vertex, circle";

struct EdgeInFace;

impl Identity for EdgeInFace {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (plane, a, b) = (free_plane(trial), free_top_view(trial), free_top_view(trial));
        let fold = trial.free();
        let (edge, ends) = (&b - &a, [plane.point_at(&a), plane.point_at(&b)]);
        let other = &plane.gradient + &edge.turned().scaled(&fold);
        let other = Plane::through_point(&ends[0], other);
        trial.zero("the second face has the edge, too", other.residual(&ends[1]));
        let touches = EdgeTouchesSigma.eval(&ends, &T::one());
        let sections = [&plane, &other].map(|p| ParabolicSphere::unit().section(p).top_view);
        for circle in &sections {
            let distance = edge.det(&(&circle.centre - &a));
            let missed = &circle.radius2 * edge.length2() - distance.square();
            trial.equal("the top view touches the incircle", &missed, &touches);
            for end in &ends {
                let tangent2 = circle.power(&end.top_view());
                let above = OnSigma.eval(array::from_ref(end), &T::one());
                trial.equal("the circle of the contacts at a vertex", &tangent2, &-above);
            }
        }
        let between = &sections[1].centre - &sections[0].centre;
        trial.zero("one contact for both faces", between.dot(&edge));
        Ok(())
    }
}

struct TangentialFace;

impl Identity for TangentialFace {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (k, circle) = (trial.size(), free_circle(trial));
        trial.parameter("the incircle is no point", &circle.radius)?;
        let parameters: Vec<T> = (0..k).map(|_| trial.free()).collect();
        for (j, t) in parameters.iter().enumerate() {
            trial.parameter("1 + t² is not 0", &(T::one() + t.square()))?;
            let next = &parameters[(j + 1) % k];
            trial.parameter("consecutive tangents meet", &(T::one() + t * next))?;
            for s in &parameters[..j] {
                trial.parameter("different contacts", &(t - s))?;
            }
        }
        let corners =
            trial.accepted("a polygon", polygon_about(&circle, &parameters).ok_or("none"))?;
        let corners: Vec<_> = corners
            .into_iter()
            .map(|corner| {
                let at = trial.made_vector2(corner.centre.position());
                let radius = trial.made(corner.radius);
                OrientedCircle { centre: TopView::new(at.x, at.y), radius }
            })
            .collect();
        let mut faces = FaceList::new();
        faces.push(0..k as u32);
        let s = trial.accepted("the lift", koebe_mesh(corners.clone(), faces))?;
        let found = trial.accepted("a face plane", face_circle(&s, FaceId(0)))?;
        let found = trial.accepted("a face circle", found.ok_or("none"))?;
        trial.equal("centre of the incircle", &found.centre.x, &circle.centre.x);
        trial.equal("centre of the incircle", &found.centre.y, &circle.centre.y);
        trial.equal("radius of the incircle", &found.radius, &circle.radius);
        for (j, parameter) in parameters.iter().enumerate() {
            let [one, next] = [j, (j + 1) % k].map(|j| &corners[j]);
            let residual = TouchingCircles.eval(&with_radii(&[one, next]), &T::one());
            trial.zero("the circles of an edge touch", residual);
            let ends = [j, (j + 1) % k].map(|j| s.points[j].clone());
            trial.zero("the edge touches Σ", EdgeTouchesSigma.eval(&ends, &T::one()));
            trial.zero("orthogonal to the incircle", one.orthogonality(&circle));
            let ray = trial.accepted("a direction", Rotation::from_parameter(parameter))?;
            let ray = Vector2::new(ray.cos() * &circle.radius, ray.sin() * &circle.radius);
            let expected = &circle.centre + &ray;
            let t = trial.accepted("a contact", contact(one, next).ok_or("none"))?;
            trial.equal("the contact", &t.x, &expected.x);
            trial.equal("the contact", &t.y, &expected.y);
        }
        if let [a, b, c, d] = corners.as_slice() {
            let poles = CoplanarPoles.eval(&with_radii(&[a, b, c, d]), &T::one());
            trial.zero("coplanar poles", poles);
            let radii = [&a.radius, &b.radius, &c.radius, &d.radius];
            trial.zero("Schramm's equation", schramm_residual(&circle.radius, radii));
        }
        trial.exhibit("S", &s);
        Ok(())
    }
}

/// A Koebe mesh over an inverted packing of circles on rays, a free sector apart, with the circles
/// of its faces.
pub(super) fn koebe_net<T: RationalField>(
    trial: &mut Trial<T>,
) -> Result<(Mesh<T>, Vec<OrientedCircle<T>>), Stop> {
    let n = trial.size();
    let parameter = trial.free();
    let half = trial.accepted("half a sector", Rotation::from_parameter(&parameter))?;
    let Some(packing) = polar_packing(n, n, &half) else {
        return Err(Stop::Excluded("rays that differ"));
    };
    let centre = free_top_view(trial);
    let Ok(packing) = inverted_packing(&packing, &centre) else {
        return Err(Stop::Excluded("no circle passes through the centre"));
    };
    let s = trial.accepted("the lift", koebe_mesh(packing, quad_patch(n, n)))?;
    let mut circles = Vec::new();
    for face in s.topology.faces() {
        match face_circle(&s, face) {
            Ok(Some(circle)) => circles.push(circle),
            Err(NoPlane::NotPlanar { residual, .. }) => {
                return Err(Stop::Failed(format!("a face is not planar: {residual}").into()));
            }
            _ => return Err(Stop::Excluded("no circle passes through the centre")),
        }
    }
    Ok((s, circles))
}

struct KoebeNet;

impl Experiment for KoebeNet {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        let (s, incircles) = koebe_net(trial)?;
        let circles = trial.accepted("vertex circles", vertex_circles(&s).ok_or("none"))?;
        let t = &s.topology;
        for h in t.edges() {
            let ends = [t.origin(h), t.target(h)].map(|v| v.index());
            let points = ends.map(|v| s.points[v].clone());
            trial.zero("the edge touches Σ", EdgeTouchesSigma.eval(&points, &T::one()));
            trial.zero("touching", circles[ends[0]].tangency(&circles[ends[1]]));
            if let Some(twin) = t.twin(h) {
                let [a, b] = [h, twin].map(|h| &incircles[t.face_at(h).index()]);
                trial.zero("touching incircles", a.tangency(b));
            }
        }
        for (face, incircle) in t.faces().zip(&incircles) {
            let around: Vec<_> = t.face(face).iter().map(|v| &circles[v.index()]).collect();
            for circle in &around {
                trial.zero("orthogonal", circle.orthogonality(incircle));
            }
            if let [a, b, c, d] = around.as_slice() {
                let radii = [&a.radius, &b.radius, &c.radius, &d.radius];
                trial.zero("Schramm's equation", schramm_residual(&incircle.radius, radii));
            }
        }
        for v in t.interior_vertices() {
            let around: Vec<_> =
                t.star(v).map(|h| &incircles[t.face_at(h).index()].radius).collect();
            if let [a, b, c, d] = around.as_slice() {
                let residual = schramm_residual(&circles[v.index()].radius, [a, b, c, d]);
                trial.zero("Schramm's equation at a vertex", residual);
            }
        }
        trial.exhibit("S", &s);
        Ok(())
    }
}

fn rectangle() -> Result<String, String> {
    // Whatever the first radius is, those of a circuit of touching circles follow.
    let [a, b, c, d] = circles([[0, 0, 1], [4, 0, 3], [4, 2, -1], [0, 2, 5]], 2);
    let touch = [(&a, &b), (&b, &c), (&c, &d)].iter().all(|(a, b)| a.tangency(b).is_zero());
    let last = d.tangency(&a);
    if !touch || last.is_zero() {
        return Err("they touch".into());
    }
    Ok(format!("tangency of the last and the first circle: {last}"))
}

fn two_contacts() -> Result<String, String> {
    // Both touch the line x = 2, at the heights 1 and 1/2.
    let [a, b] = circles([[2, 2, 2], [6, 1, 2]], 2).map(|circle| circle.pole().dual());
    let corner = TopView::new(Rational::from_i64(2), Rational::zero());
    let gap = a.height_at(&corner) - b.height_at(&corner);
    if gap.is_zero() { Err("they meet".into()) } else { Ok(format!("gap of the planes: {gap}")) }
}

fn pentagon() -> Result<String, String> {
    let [circle] = circles([[0, 0, 1]], 1);
    let parameters =
        [(0, 1), (1, 2), (2, 1), (-3, 1), (-1, 2)].map(|(p, q)| Rational::from_ratio(p, q));
    let corners = polygon_about(&circle, &parameters).ok_or("no polygon")?;
    let [a, b, c, d] = [0, 1, 2, 3].map(|j| &corners[j].radius);
    let residual = schramm_residual(&circle.radius, [a, b, c, d]);
    if residual.is_zero() { Err("it holds".into()) } else { Ok(format!("residual {residual}")) }
}
