//! Sec. 3.4: Koebe meshes and i-isothermic meshes.

use super::instance::{free_plane, free_top_view, incircle, polygon_about};
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
use crate::space::{
    Circle, Dual, OrientedCircle, ParabolicSphere, Plane, Point, Rotation, TopView, Vector2,
};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "koebe-edge",
        statement: "Two touching circles, with signed radii: the planes that cut Σ over them meet over \
                    their common tangent, in a line that touches Σ over the point of contact; and so \
                    does the line of their poles, along the centres.",
        formula: "height over Σ along the tangent = -|x - t|²/2",
        source: Source::Paper("Sec. 3.4"),
        hypotheses: &[Hypothesis::stated(TOUCHING), Hypothesis::silent(SUM)],
        said: Grade::Decided,
        argument: "",
        evidence: &[Evidence::identity::<TouchingPair>("two circles", &[1], &[1])],
        controls: &[
            Control {
                without: TOUCHING,
                shows: "circles at a distance: the line of the poles misses Σ",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &["0", "0", "1", "1", "0", "1"],
                    constrained: &["3", "0"],
                },
            },
            Control {
                without: SUM,
                shows: "a circle and itself, turned over, have no point of contact",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &["0", "0", "1", "-1", "0", "1"],
                    constrained: &["0", "0"],
                },
            },
        ],
    },
    Claim {
        id: "koebe-vertex",
        statement: "The planes of circles meet in a point v iff their poles are coplanar, that is, iff a \
                    circle orthogonal to all exists; its centre is v', its squared radius |v'|² - 2 v₃. \
                    Circles that touch in a cycle of four have concyclic contacts; that does not suffice.",
        formula: "ρ² = |v'|² - 2 v₃",
        source: Source::Paper("Sec. 3.4"),
        hypotheses: &[Hypothesis::silent(ORTHOGONAL), Hypothesis::silent(NOT_COLLINEAR)],
        said: Grade::Decided,
        argument: "For k circles: three with centres that are not collinear have one orthogonal circle, \
                   and each other one is orthogonal to it iff its plane passes through v. A cycle of four \
                   touching circles arises, up to i-motions, from three radii and two directions: the \
                   fourth radius is then the solution of a linear equation.",
        evidence: &[
            Evidence::identity::<OrthogonalCircle>("four circles", &[1], &[1]),
            Evidence::identity::<CycleOfFour>("a cycle of four", &[1], &[1]),
        ],
        controls: &[
            Control {
                without: ORTHOGONAL,
                shows: "unit circles on a rhombus touch in a cycle",
                counterexample: Counterexample::Witness(rhombus),
            },
            Control {
                without: NOT_COLLINEAR,
                shows: "three circles in a row: their planes are parallel to a line",
                counterexample: Counterexample::Witness(row),
            },
        ],
    },
    Claim {
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
        said: Grade::Decided,
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
    },
];

const TOUCHING: &str = "the circles touch, with their signs";
const SUM: &str = "r₁ + r₂ != 0";
const ORTHOGONAL: &str = "a circle is orthogonal to all";
const NOT_COLLINEAR: &str = "the centres are not collinear";
const INCIRCLE: &str = "every face of the top view has an incircle";
const ONE_CONTACT: &str = "the incircles touch at one point of every edge";
const VALENCE: &str = "Schramm's equation: four circles touch the face, or the vertex, circle";

fn free_circle<T: Field>(trial: &mut Trial<T>) -> OrientedCircle<T> {
    OrientedCircle { centre: free_top_view(trial), radius: trial.free() }
}

/// The point where two touching circles touch.
fn contact<T: Field>(a: &OrientedCircle<T>, b: &OrientedCircle<T>) -> Option<TopView<T>> {
    let factor = a.radius.try_div(&(&a.radius + &b.radius))?;
    Some(&a.centre + &(&b.centre - &a.centre).scaled(&factor))
}

/// The points of residuals that take radii as x-coordinates.
fn with_radii<T: Field, const N: usize>(circles: &[&OrientedCircle<T>]) -> [Point<T>; N] {
    let half = N / 2;
    std::array::from_fn(|i| {
        let OrientedCircle { centre, radius } = circles[i % half];
        let top_view =
            if i < half { centre.clone() } else { TopView::new(radius.clone(), T::zero()) };
        top_view.at_height(T::zero())
    })
}

struct TouchingPair;

impl Identity for TouchingPair {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let first = free_circle(trial);
        let (radius, parameter, along) = (trial.free(), trial.free(), trial.free());
        let ray = trial.accepted("a direction", Rotation::from_parameter(&parameter))?;
        let distance = &first.radius + &radius;
        trial.nonzero(SUM, &distance)?;
        let between = Vector2::new(ray.cos() * &distance, ray.sin() * &distance);
        let centre = trial.constrained_vector2((&first.centre + &between).position());
        let second = OrientedCircle { centre: TopView::new(centre.x, centre.y), radius };
        trial.relation(TOUCHING, first.tangency(&second))?;
        let residual = TouchingCircles.eval(&with_radii(&[&first, &second]), &T::one());
        trial.zero("touching", residual);

        let t = trial.defined(SUM, contact(&first, &second))?;
        let poles = [first.pole(), second.pole()];
        trial.zero("the line of the poles touches Σ", EdgeTouchesSigma.eval(&poles, &T::one()));
        let factor = &first.radius / distance;
        let on_line = |a: &T, b: &T| a + &factor * (b - a);
        let height = on_line(&poles[0].z, &poles[1].z);
        trial.zero("over the contact", OnSigma.eval(&[t.at_height(height)], &T::one()));

        // A point of the common tangent, and the planes there.
        let across = (&second.centre - &first.centre).turned().scaled(&along);
        let at = &t + &across;
        let [a, b] = poles.each_ref().map(|pole| pole.dual().point_at(&at));
        trial.equal("the planes meet over the tangent", &a.z, &b.z);
        let over = OnSigma.eval(&[a.clone()], &T::one());
        trial.equal("their line touches Σ", &over, &-across.length2());
        let ends = [a, poles[0].dual().point_at(&t)];
        trial.zero("their line as an edge", EdgeTouchesSigma.eval(&ends, &T::one()));
        Ok(())
    }
}

struct OrthogonalCircle;

impl Identity for OrthogonalCircle {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let circles = [(); 4].map(|()| free_circle(trial));
        let [a, b, c, d] = &circles;
        let det = (&b.centre - &a.centre).det(&(&c.centre - &a.centre));
        trial.nonzero(NOT_COLLINEAR, &det)?;
        let spanned = Plane::through(&a.pole(), &b.pole(), &c.pole());
        let v = trial.defined(NOT_COLLINEAR, spanned.ok())?.dual();
        let v = trial.made_point(v);
        for circle in [a, b, c] {
            trial.zero("in the plane of a circle", circle.pole().dual().residual(&v));
        }
        let radius2 = v.top_view().norm2() - T::from_i64(2) * &v.z;
        let orthogonal = Circle::new(v.top_view(), radius2);
        for circle in [a, b, c] {
            let power = orthogonal.power(&circle.centre);
            trial.equal("orthogonal", &power, &circle.radius.square());
        }
        // For the fourth both miss by the same, and so do the four poles.
        let miss = d.pole().dual().residual(&v);
        let power = orthogonal.power(&d.centre) - d.radius.square();
        trial.equal("the fourth plane", &(T::from_i64(2) * &miss), &power);
        let poles = CoplanarPoles.eval(&with_radii(&[a, b, c, d]), &T::one());
        trial.equal("four poles", &poles, &(power * det));
        let same = OrientedCircle { centre: v.top_view(), radius: T::zero() };
        trial.equal("by the pair", &a.orthogonality(&same), &orthogonal.radius2);
        Ok(())
    }
}

struct CycleOfFour;

impl Identity for CycleOfFour {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let [a, b, d] = [(); 3].map(|()| trial.free());
        let parameters = [trial.free(), trial.free()];
        let mut rays = Vec::new();
        for parameter in &parameters {
            let ray = trial.accepted("a direction", Rotation::from_parameter(parameter))?;
            trial.parameter("a direction", &(T::one() + parameter.square()))?;
            rays.push(Vector2::new(ray.cos().clone(), ray.sin().clone()));
        }
        let ab = &a + &b;
        let second = TopView::new(ab.clone(), T::zero());
        let fourth = TopView::new(T::zero(), T::zero());
        let fourth = &fourth + &rays[0].scaled(&(&a + &d));
        // |second + (b + c) ray - fourth| = c + d is linear in c.
        let from = &(&second - &fourth) + &rays[1].scaled(&b);
        let slope = (from.dot(&rays[1]) - &d) * T::from_i64(2);
        trial.parameter("the fourth circle is no line", &slope)?;
        let c = (d.square() - from.length2()) / slope;
        let third = &second + &rays[1].scaled(&(&b + &c));
        let origin = TopView::new(T::zero(), T::zero());
        let circles = [(origin, a), (second, b), (third, c), (fourth, d)]
            .map(|(centre, radius)| OrientedCircle { centre, radius });
        let mut contacts = Vec::new();
        for j in 0..4 {
            let (one, next) = (&circles[j], &circles[(j + 1) % 4]);
            trial.zero("touching", one.tangency(next));
            trial.parameter("r₁ + r₂ is not 0", &(&one.radius + &next.radius))?;
            let contact = trial.accepted("a contact", contact(one, next).ok_or("none"))?;
            let at = trial.made_vector2(contact.position());
            contacts.push(TopView::new(at.x, at.y));
        }
        let [a, b, c, d] = [0, 1, 2, 3].map(|j| &contacts[j]);
        trial.zero("the contacts are concyclic", incircle([a, b, c, d]));
        Ok(())
    }
}

fn circles<const N: usize>(of: [[i64; 3]; N], unit: i64) -> [OrientedCircle<Rational>; N] {
    of.map(|[x, y, r]| {
        let [x, y, radius] = [x, y, r].map(|n| Rational::from_ratio(n, unit));
        OrientedCircle { centre: TopView::new(x, y), radius }
    })
}

fn rhombus() -> Result<String, String> {
    let circles = circles([[10, 0, 13], [0, 24, 13], [-10, 0, 13], [0, -24, 13]], 13);
    let touch = (0..4).all(|j| circles[j].tangency(&circles[(j + 1) % 4]).is_zero());
    let poles = CoplanarPoles.eval(&with_radii(&circles.each_ref()), &Rational::one());
    if !touch || poles.is_zero() {
        return Err("a circle is orthogonal to all".into());
    }
    Ok(format!("determinant of the poles: {poles}"))
}

fn row() -> Result<String, String> {
    let [a, b, c] = circles([[0, 0, 1], [2, 0, 1], [6, 0, 3]], 1).map(|circle| circle.pole());
    let plane = Plane::through(&a, &b, &c);
    plane.map_or_else(|error| Ok(error.to_string()), |_| Err("they meet in a point".into()))
}

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
                let above = OnSigma.eval(&[end.clone()], &T::one());
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
        for j in 0..k {
            let [one, next] = [j, (j + 1) % k].map(|j| &corners[j]);
            let residual = TouchingCircles.eval(&with_radii(&[one, next]), &T::one());
            trial.zero("the circles of an edge touch", residual);
            let ends = [j, (j + 1) % k].map(|j| s.points[j].clone());
            trial.zero("the edge touches Σ", EdgeTouchesSigma.eval(&ends, &T::one()));
            trial.zero("orthogonal to the incircle", one.orthogonality(&circle));
            let ray = trial.accepted("a direction", Rotation::from_parameter(&parameters[j]))?;
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
