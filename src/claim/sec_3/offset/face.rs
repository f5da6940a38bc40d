//! Offsets at constant distance of faces: conical meshes.

use crate::claim::{
    Claim, Control, Counterexample, Evidence, Experiment, Grade, Hypothesis, Identity, Run, Source,
    Stop, Trial,
};

use super::{STRAIGHT, concyclic, free_top_view, from_origin, horizontal};
use crate::check::RootSum;
use crate::construct::circular_net;
use crate::construct::transfer::{EuclideanImage, conical_image};
use crate::net::euclidean::ConcyclicNormals;
use crate::scalar::{Field, Rational, RationalField, Ring};
use crate::space::laguerre::{Cone, LaguerreTransformation, OrientedPlane};
use crate::space::{ICircle, Point, TopView, Transform, Vector3};

pub(in crate::claim) const CLAIMS: &[Claim] = &[Claim {
    id: "offset-face",
    statement: "The planes of the faces of M + dS have the distance d from those of M iff the \
                    planes of S touch the unit sphere. Around a vertex such an S exists iff the planes \
                    touch a cone of revolution.",
    formula: "n·(v + ds) + h = d n·s",
    source: Source::Paper("Sec. 3.1, meshes with offsets (iii)"),
    hypotheses: &[Hypothesis::silent(FINITE)],
    said: Grade::Certified,
    argument: "The distance concerns one face at a time. Planes with n·s = 1 make equal angles \
               with s, which is a cone of revolution. The unit normals at a vertex admit an s iff \
               each lies in the plane that the first three span, if that misses the centre; where \
               it passes through the centre, the planes at a vertex pass through one line.",
    evidence: &[
        Evidence::identity::<FaceDistance>("distances of planes", &[1], &[1]),
        Evidence::identity::<Conical>("four planes at a vertex", &[1], &[1]),
        Evidence::identity::<UnitNormals>("their unit normals", &[1], &[1]),
        Evidence::experiment::<FaceOffsets>("offsets of conical meshes", &[2, 3]),
    ],
    controls: &[Control {
        without: FINITE,
        shows: "normals on a great circle: no cone, but all planes contain an axis",
        counterexample: Counterexample::Witness(great_circle),
    }],
}];

const FINITE: &str = "the unit normals at a vertex do not lie on a great circle";

/// The plane of a point of the isotropic model that is moved up or down until its plane contains v.
fn plane_through<T: Field>(
    trial: &mut Trial<T>,
    at: &TopView<T>,
    v: &Point<T>,
) -> Result<(Point<T>, OrientedPlane<T>), Stop> {
    let larger = T::one() + at.norm2();
    trial.parameter("1 + |x'|² is not 0, as in ordered fields", &larger)?;
    let beside = OrientedPlane::of_isotropic(&horizontal(at)).distance(v);
    let point = at.at_height(-(beside * larger) * T::from_ratio(1, 2));
    let plane = OrientedPlane::of_isotropic(&point);
    Ok((point, plane))
}

struct FaceDistance;

impl Identity for FaceDistance {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (at, v) = (free_top_view(trial), trial.free_point());
        let (_, plane) = plane_through(trial, &at, &v)?;
        let (s, d) = (trial.free_vector3(), trial.free());
        let moved = &v + &Vector3::new(&d * &s.x, &d * &s.y, &d * &s.z);
        let moved = trial.made_point(moved);
        trial.zero("the plane passes through v", plane.distance(&v));
        trial.equal("distance", &plane.distance(&moved), &(&d * plane.normal().dot(&s)));
        // The plane at distance d is that of the offset by L-transformations.
        let offset = LaguerreTransformation::offset(-&d).apply(&plane);
        let [_, touching] = Cone { vertex: v, axis: s }.tangency(&plane);
        trial.equal("offset planes", &offset.distance(&moved), &(d * touching));
        Ok(())
    }
}

struct Conical;

impl Identity for Conical {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let corners = concyclic(trial)?;
        let v = trial.free_point();
        let mut found = Vec::new();
        for at in &corners {
            found.push(plane_through(trial, at, &v)?);
        }
        let [first, second, third, _] = found.as_slice() else { return Ok(()) };
        let area = (&corners[1] - &corners[0]).det(&(&corners[2] - &corners[0]));
        trial.parameter(STRAIGHT, &area)?;
        let circle = ICircle::through(&first.0, &second.0, &third.0);
        let circle = trial.accepted("three parallel planes", circle)?;
        let power = circle.top_view.power(&TopView::new(T::zero(), T::zero()));
        trial.nonzero(FINITE, &(T::one() + power))?;
        let cone = trial.defined(FINITE, Cone::of_isotropic(&circle).ok())?;
        let axis = &cone.axis;
        let axis = Vector3::new(
            trial.made(axis.x.clone()),
            trial.made(axis.y.clone()),
            trial.made(axis.z.clone()),
        );
        trial.equal_points("the vertex of the cone", &cone.vertex, &v);
        let cone = Cone { vertex: v, axis };
        for (_, plane) in &found {
            let [beside, turned] = cone.tangency(plane);
            trial.zero("a plane through the vertex", beside);
            trial.zero("a plane that touches the cone", turned);
        }
        Ok(())
    }
}

struct UnitNormals;

impl Identity for UnitNormals {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let corners = concyclic(trial)?;
        let mut points = Vec::new();
        let mut lengths = Vec::new();
        for at in &corners {
            let origin = Point::new(T::zero(), T::zero(), T::zero());
            let (_, plane) = plane_through(trial, at, &origin)?;
            let Vector3 { x, y, z } = plane.normal().clone();
            // n × e₁ and n × e₂ span the plane; their product is n₃ n.
            points.push(origin);
            points.push(Point::new(T::zero(), z.clone(), -y));
            points.push(Point::new(-&z, T::zero(), x));
            lengths.push(z);
        }
        let points: [Point<T>; 12] = trial.accepted("four planes", points.try_into())?;
        let terms = ConcyclicNormals.eval(&points);
        let mut sum = T::zero();
        for ((coefficient, length2), length) in terms.into_iter().zip(lengths) {
            trial.equal("length of a normal", &length2, &length.square());
            sum = sum + coefficient * length;
        }
        trial.zero("concyclic normals", sum);
        Ok(())
    }
}

struct FaceOffsets;

impl Experiment for FaceOffsets {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        let n = trial.size();
        let mut side = |along: [i64; 2]| -> Vec<Point<T>> {
            let place = |i: i64| {
                let [x, y] = along.map(|a| T::from_i64(5 * a * i));
                Point::new(x + trial.free(), y + trial.free(), trial.free())
            };
            (0..=n as i64).map(place).collect()
        };
        let (rows, mut columns) = (side([1, 0]), side([0, 1]));
        columns[0] = rows[0].clone();
        let ratio = T::from_ratio(1, 2) + trial.free();
        let net = circular_net(&rows, &columns, |_, _| ratio.clone());
        let net = net.ok_or(Stop::Excluded("faces are not degenerate"))?;
        let net = trial.accepted("no mesh", net)?;
        let image = conical_image(&net).or(Err(Stop::Excluded(FINITE)))?;
        let d = trial.free();
        let EuclideanImage { mesh, gauss } = image.clone();
        let offset = trial.made_mesh(image.offset(&d).mesh);
        trial.exhibit("N", &mesh);
        for (face, v) in mesh.topology.faces().zip(net.topology.interior_vertices()) {
            let plane = OrientedPlane::of_isotropic(&net.points[v.index()]);
            for corner in mesh.topology.face(face) {
                let at = corner.index();
                trial.zero("a face of N", plane.distance(&mesh.points[at]));
                trial.equal("distance", &plane.distance(&offset.points[at]), &d);
                let touching = plane.normal().dot(&from_origin(&gauss.points[at]));
                trial.equal("S touches the unit sphere", &touching, &T::one());
            }
        }
        Ok(())
    }
}

/// Four points of the unit circle, the images of normals in the plane z = 0, and v = (1, 2, 3).
fn great_circle() -> Result<String, String> {
    let at = |x: i64, y: i64| TopView::new(Rational::from_ratio(x, 5), Rational::from_ratio(y, 5));
    let [x, y, z] = [1, 2, 3].map(Rational::from_i64);
    let v = Point::new(x, y, z);
    let mut points = Vec::new();
    for at in [at(5, 0), at(3, 4), at(-4, 3)] {
        // On the unit circle n = (x', 0), and h is the height of the point.
        let height = -(&at.x * &v.x + &at.y * &v.y);
        let point = at.at_height(height);
        let plane = OrientedPlane::of_isotropic(&point);
        if !plane.distance(&v).is_zero() || !plane.normal().z.is_zero() {
            return Err("not a plane through v".into());
        }
        points.push(point);
    }
    let [a, b, c] = points.as_slice() else { return Err("three points".into()) };
    let circle = ICircle::through(a, b, c).map_err(|e| e.to_string())?;
    match Cone::of_isotropic(&circle) {
        Ok(cone) => Err(format!("a cone with the axis {:?}", cone.axis)),
        Err(error) => Ok(format!("the vertex of the cone: {error}")),
    }
}
