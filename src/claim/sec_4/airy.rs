//! Sec. 4, Remark 4: inversions of i-minimal surfaces, and their Laguerre images.

use super::lines::free_enneper;
use super::packing::{has_circles, radii_of, witnessed};
use super::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Trial,
};
use crate::construct::transfer::edge_offset_image;
use crate::construct::{face_circle, vertex_circles};
use crate::mesh::Mesh;
use crate::net::RADIUS;
use crate::pair::Parallel;
use crate::scalar::{Dual, Field, Rational, Ring};
use crate::space::laguerre::Cone;
use crate::space::{
    Circle, CylindricalSphere, Gradient, ICircle, MoebiusTransformation, OrientedCircle, Plane,
    Point, TopView, Vector3,
};

pub(super) const CLAIMS: &[Claim] = &[Claim {
    id: "remark-4",
    statement: "An i-M-inversion of the graph of a harmonic function is that of a biharmonic one; the \
                inverted incircles of an i-isothermic mesh, of an i-minimal one in particular, are the incircles of \
                one again, whose vertices lie in the planes of these circles; and τ maps it to an edge-offset mesh.",
    formula: "Δ²(|x|² f(x/|x|²)) = 0,  v -> v/N,  r -> r/N,  N = |v'|² - r²",
    source: Source::Paper("Sec. 4, Remark 4"),
    hypotheses: &[
        Hypothesis::stated(HARMONIC),
        Hypothesis::silent(OFF_CENTRE),
        Hypothesis::silent(GREAT_CIRCLE),
    ],
    said: Grade::Certified,
    argument: "Δ² at a point sees the 4-jet there, and those of harmonic functions are those of harmonic \
               polynomials of degree 4; constants give |x|², linear functions stay. A plane through a vertex with a circle orthogonal to that of the vertex \
               is all that the image of a vertex depends on; so for any number of faces the planes of \
               the images meet over the centre of the image of its circle. Other i-M-inversions differ by \
               motions, scalings, and z -> 2s - z, which keep Δ² f = 0. The edge offsets are those of \
               remark-2-edge-offset, here on the inverted Enneper surface.",
    evidence: &[
        Evidence::identity::<Biharmonic>("harmonic functions of degree n", &[2, 3, 4], &[2, 3, 4]),
        Evidence::identity::<OneFace>("a face at a vertex of any i-isothermic mesh", &[1], &[1]),
        Evidence::identity::<InvertedEnneper>(
            "the inverted Enneper surface and its image under τ",
            &[2],
            &[2, 3],
        ),
    ],
    controls: &[
        Control {
            without: HARMONIC,
            shows: "f = x⁴",
            counterexample: Counterexample::Unknowns {
                evidence: 0,
                size: 2,
                unknowns: &["1", "2"],
                constrained: &["1"],
            },
        },
        Control {
            without: OFF_CENTRE,
            shows: "a circle of a vertex through the centre",
            counterexample: Counterexample::Unknowns {
                evidence: 1,
                size: 1,
                unknowns: &["1", "0", "1", "1", "3", "2", "1", "1"],
                constrained: &[],
            },
        },
        Control {
            without: GREAT_CIRCLE,
            shows: "the circle |x'|² = 1 is the image of a great circle: its planes envelop a cylinder",
            counterexample: Counterexample::Witness(|| {
                let [zero, one] = [0, 1].map(Rational::from_i64);
                let plane = Plane::new(Gradient::new(one.clone(), zero.clone()), one.clone());
                let top_view = Circle::new(TopView::new(zero.clone(), zero), one);
                let power = top_view.centre.norm2() - &top_view.radius2;
                match Cone::of_isotropic(&ICircle { plane, top_view }) {
                    Err(error) => witnessed(&format!("{error}; N"), &power),
                    Ok(cone) => Err(format!("{cone:?}")),
                }
            }),
        },
    ],
}];

const HARMONIC: &str = "f is harmonic";
const OFF_CENTRE: &str =
    "no vertex circle and no incircle passes through the centre of the inversion";
const GREAT_CIRCLE: &str = "no incircle is the image of a great circle: 1 + N != 0";

/// The inversion at the unit cylinder.
fn inversion<T: Field>() -> Option<MoebiusTransformation<T>> {
    let unit = Circle::new(TopView::new(T::zero(), T::zero()), T::one());
    let cylinder = CylindricalSphere::new(unit).ok()?;
    Some(MoebiusTransformation::inversion_at_cylinder(&cylinder, &T::zero()))
}

type Jet<T> = Dual<Dual<Dual<Dual<T, 1>, 1>, 1>, 1>;

/// A coordinate that varies along some of four directions.
fn coordinate<T: Ring>(value: T, varies: [bool; 4]) -> Jet<T> {
    fn next<R: Ring>(value: R, varies: bool) -> Dual<R, 1> {
        if varies { Dual::variable(value, 0) } else { Dual::constant(value) }
    }
    let [a, b, c, d] = varies;
    next(next(next(next(value, a), b), c), d)
}

struct Biharmonic;

impl Identity for Biharmonic {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (x, y) = (trial.free(), trial.free());
        let length2 = x.square() + y.square();
        trial.nonzero(OFF_CENTRE, &length2)?;
        let (a, b) = (trial.free(), trial.free());
        // What is not harmonic, and not of the form g + |x|² h with harmonic g, h either.
        let other = trial.constrained(T::zero());
        trial.relation(HARMONIC, other.clone())?;
        // The map, on numbers.
        let from = TopView::new(x.clone(), y.clone()).at_height(a.clone());
        let map = trial.defined(OFF_CENTRE, inversion::<T>())?;
        let found = trial.defined(OFF_CENTRE, map.map_point(&from).ok())?;
        let scale = trial.defined(OFF_CENTRE, length2.try_inv())?;
        let expected = [&from.x * &scale, &from.y * &scale, &from.z * &scale];
        let [u, v, w] = expected;
        trial.equal_points("the inverse of a point", &found, &Point::new(u, v, w));
        let degree = trial.size();
        // The fourth derivative along x or y, twice each.
        let derivative = |first: bool, second: bool| {
            let along = [first, first, second, second];
            let (x, y) = (coordinate(x.clone(), along), coordinate(y.clone(), along.map(|d| !d)));
            let constant = |value: &T| coordinate(value.clone(), [false; 4]);
            let length2 = &x * &x + &y * &y;
            let scale = length2.try_inv()?;
            let (u, v) = (x * &scale, y * &scale);
            let (mut re, mut im) = (u.clone(), v.clone());
            for _ in 1..degree {
                (re, im) = (&u * &re - &v * &im, &u * &im + &v * &re);
            }
            let u2 = &u * &u;
            let value = re * constant(&a) + im * constant(&b) + &u2 * &u2 * constant(&other);
            let [third] = (value * length2).partials;
            let [second] = third.partials;
            let [first] = second.partials;
            let [value] = first.partials;
            Some(value)
        };
        let all = [(true, true), (true, false), (false, false)].map(|(a, b)| derivative(a, b));
        let [xxxx, xxyy, yyyy] = all;
        let (xxxx, yyyy) = (trial.defined(OFF_CENTRE, xxxx)?, trial.defined(OFF_CENTRE, yyyy)?);
        let xxyy = trial.defined(OFF_CENTRE, xxyy)?;
        trial.zero("Δ²", xxxx + xxyy * T::from_i64(2) + yyyy);
        Ok(())
    }
}

struct OneFace;

impl Identity for OneFace {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let vertex = trial.free_point();
        let circle = OrientedCircle { centre: vertex.top_view(), radius: trial.free() };
        let origin = TopView::new(T::zero(), T::zero());
        let power = circle.circle().power(&origin);
        trial.nonzero(OFF_CENTRE, &power)?;
        // A plane through the vertex, and in it a circle orthogonal to that of the vertex.
        let centre = TopView::new(trial.free(), trial.free());
        let plane = Plane::through_point(&vertex, Gradient::new(trial.free(), trial.free()));
        let radius2 = circle.circle().power(&centre);
        let incircle = ICircle { plane, top_view: Circle::new(centre, radius2) };
        trial.nonzero(OFF_CENTRE, &incircle.top_view.power(&origin))?;
        let map = trial.defined(OFF_CENTRE, inversion::<T>())?;
        let image = trial.defined(OFF_CENTRE, map.map_circle(&incircle).ok())?;
        let moved = trial.defined(OFF_CENTRE, circle.inverted(&origin))?;
        let height = trial.defined(OFF_CENTRE, vertex.z.try_div(&power))?;
        let at = trial.made_point(moved.centre.at_height(height));
        trial.zero("the plane meets the vertex", image.plane.residual(&at));
        let orthogonal = image.top_view.power(&at.top_view()) - moved.radius.square();
        trial.zero("orthogonal to the circle of the vertex", orthogonal);
        Ok(())
    }
}

struct InvertedEnneper;

impl Identity for InvertedEnneper {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let n = trial.size();
        let surface = free_enneper(trial, n, n, None)?.surface;
        trial.exhibit("M", &surface);
        let circles = trial.defined(OFF_CENTRE, vertex_circles(&surface))?;
        let origin = TopView::new(T::zero(), T::zero());
        let (mut points, mut radii) = (Vec::new(), Vec::new());
        for (circle, point) in circles.iter().zip(&surface.points) {
            let power = circle.circle().power(&origin);
            trial.nonzero(OFF_CENTRE, &power)?;
            let moved = trial.defined(OFF_CENTRE, circle.inverted(&origin))?;
            let height = trial.defined(OFF_CENTRE, point.z.try_div(&power))?;
            points.push(moved.centre.at_height(height));
            radii.push(moved.radius);
        }
        let mut image = trial.made_mesh(Mesh { points, ..surface.clone() });
        image.data.vertex.insert(RADIUS.to_owned(), radii);
        trial.exhibit("the inverse", &image);
        // The images of the incircles belong to the faces of the image.
        let lifted = Mesh { points: circles.iter().map(|c| c.pole()).collect(), ..surface.clone() };
        let map = trial.defined(OFF_CENTRE, inversion::<T>())?;
        for face in surface.topology.faces() {
            let plane = trial.accepted("a plane", surface.face_plane(face))?;
            let sum = {
                let corners = surface.topology.face(face);
                &radii_of(&surface)[corners[0].index()] + &radii_of(&surface)[corners[1].index()]
            };
            trial.parameter("no edge has length 0", &sum)?;
            let incircle = face_circle(&lifted, face).ok().flatten();
            let incircle = trial.defined(OFF_CENTRE, incircle)?.circle();
            trial.nonzero(OFF_CENTRE, &incircle.power(&origin))?;
            let circle = map.map_circle(&ICircle { plane, top_view: incircle }).ok();
            let circle = trial.defined(OFF_CENTRE, circle)?;
            trial.nonzero(GREAT_CIRCLE, &(circle.top_view.power(&origin) + T::one()))?;
            for v in surface.topology.face(face) {
                let point = &image.points[v.index()];
                trial.zero("in the plane of the circle", circle.plane.residual(point));
                let radius2 = radii_of(&image)[v.index()].square();
                let power = circle.top_view.power(&point.top_view());
                trial.equal("orthogonal", &power, &radius2);
            }
        }
        has_circles(trial, &image);
        let euclidean = edge_offset_image(&image, radii_of(&image)).ok();
        let euclidean = trial.defined(GREAT_CIRCLE, euclidean)?;
        trial.exhibit("N", &euclidean.mesh);
        trial.accepted("parallel", Parallel::new(&euclidean.mesh, &euclidean.gauss))?;
        for h in euclidean.gauss.topology.edges() {
            let ends = [euclidean.gauss.topology.origin(h), euclidean.gauss.topology.target(h)];
            let [a, b] = ends.map(|v| &euclidean.gauss.points[v.index()]);
            let (edge, from) = (b - a, Vector3::new(a.x.clone(), a.y.clone(), a.z.clone()));
            let moment = from.cross(&edge).length2();
            trial.equal("an edge at distance 1", &moment, &edge.length2());
        }
        Ok(())
    }
}
