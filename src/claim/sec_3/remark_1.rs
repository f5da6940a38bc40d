//! Sec. 3.2, Remark 1: conical meshes in Euclidean space, and i-M-transformations.

use super::instance::{CORNERS, free_plane, free_top_view, generators, net, on_circle, one_face};
use super::{
    Claim, Control, Counterexample, Evidence, Experiment, Grade, Hypothesis, Identity, Run, Source,
    Stop, Trial,
};
use crate::check::Residual;
use crate::construct::moebius_image;
use crate::construct::transfer::{NoTransfer, circular_image, conical_image, stored_planes};
use crate::mesh::{FaceList, Mesh};
use crate::net::i_circular::Concyclic;
use crate::net::planar::Coplanar;
use crate::scalar::{Field, Rational, RationalField, Ring};
use crate::space::laguerre::{Cone, LaguerreTransformation, OrientedPlane};
use crate::space::{Circle, CylindricalSphere, ICircle, MoebiusTransformation, Point, TopView};

pub(super) const CLAIMS: &[Claim] = &[Claim {
    id: "remark-1",
    statement: "The map τ of (12) sends an i-circular mesh to a conical mesh with unit normals in the \
                field: the corners of a face become oriented planes that touch the cone of its circle. \
                i-M-transformations map i-circular meshes to such, circle to circle; seen through τ \
                they are L-transformations, cone to cone.",
    formula: "",
    source: Source::Paper("Sec. 3.2, Remark 1"),
    hypotheses: &[
        Hypothesis::stated(CIRCULAR),
        Hypothesis::silent(GREAT),
        Hypothesis::silent(VERTEX_AT_CENTRE),
        Hypothesis::silent(CIRCLE_THROUGH_CENTRE),
    ],
    said: Grade::Certified,
    argument: "Vertices of M are faces of its image and conversely, and planes through the vertex of one \
               cone are all that a conical vertex asks for. The inversion at the unit cylinder, \
               those at i-M-spheres and additions of these generate, with i-motions and \
               similarities, which keep i-circles obviously, all i-M-transformations. For larger faces \
               each corner is compared with the circle of three.",
    evidence: &[
        Evidence::identity::<ConeOfFace>("a face and its cone", &[4], &[4, 6]),
        Evidence::identity::<MappedFace>("a face and its image", &[4], &[4]),
        Evidence::identity::<MappedCone>("L-transformations of the cone", &[1], &[1]),
        Evidence::experiment::<ConicalNet>("nets", &[3]),
    ],
    controls: &[
        Control {
            without: CIRCULAR,
            shows: "the plane of the fourth corner of a kite misses the cone of the other three",
            counterexample: Counterexample::Unknowns {
                evidence: 0,
                size: 4,
                unknowns: &["0", "0", "1", "0", "0", "1", "0", "0", "1", "1", "2"],
                constrained: &["3", "3"],
            },
        },
        Control {
            without: GREAT,
            shows: "the unit circle stands for a great circle: the four planes envelop a cylinder",
            counterexample: Counterexample::Witness(great_circle),
        },
        Control {
            without: VERTEX_AT_CENTRE,
            shows: "a corner over the centre has no image",
            counterexample: Counterexample::Witness(vertex_at_centre),
        },
        Control {
            without: CIRCLE_THROUGH_CENTRE,
            shows: "the image of a face whose circle passes through the centre is vertical",
            counterexample: Counterexample::Witness(circle_through_centre),
        },
    ],
}];

const CIRCULAR: &str = "M is i-circular";
const GREAT: &str = "no face circle is the image of a great circle";
const VERTEX_AT_CENTRE: &str = "no vertex lies over the centre";
const CIRCLE_THROUGH_CENTRE: &str = "no face circle passes through the centre";

/// A face with concyclic corners, and its circle.
fn circular_face<T: Field>(trial: &mut Trial<T>) -> Result<(Mesh<T>, ICircle<T>), Stop> {
    let plane = free_plane(trial);
    let mut at = vec![free_top_view(trial), free_top_view(trial), free_top_view(trial)];
    trial.parameter(CORNERS, &(&at[1] - &at[0]).det(&(&at[2] - &at[0])))?;
    while at.len() < trial.size().max(3) {
        at.push(on_circle(trial, CIRCULAR, [&at[0], &at[1], &at[2]])?);
    }
    let top_view = trial.accepted("a circle", Circle::through(&at[0], &at[1], &at[2]))?;
    let m = one_face(trial, at.iter().map(|x| plane.point_at(x)).collect())?;
    Ok((m, ICircle { plane, top_view }))
}

struct ConeOfFace;

impl Identity for ConeOfFace {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (m, circle) = circular_face(trial)?;
        let power = circle.top_view.centre.norm2() - &circle.top_view.radius2;
        trial.nonzero(GREAT, &(T::one() + power))?;
        let cone = trial.defined(GREAT, Cone::of_isotropic(&circle).ok())?;
        for p in &m.points {
            trial.parameter("1 + |x'|² is not 0", &(T::one() + p.top_view().norm2()))?;
            let plane = OrientedPlane::of_isotropic(p);
            trial.equal("unit normal", &plane.normal().length2(), &T::one());
            let [through, angle] = cone.tangency(&plane);
            trial.zero("through the vertex of the cone", through);
            trial.zero("touches the cone", angle);
        }
        Ok(())
    }
}

struct MappedFace;

impl Identity for MappedFace {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let (m, circle) = circular_face(trial)?;
        let map = generators(trial)?;
        for p in &m.points {
            trial.nonzero(VERTEX_AT_CENTRE, &p.top_view().norm2())?;
        }
        let power = circle.top_view.centre.norm2() - &circle.top_view.radius2;
        trial.nonzero(CIRCLE_THROUGH_CENTRE, &power)?;
        let image = trial.accepted("the image", moebius_image(&m, &map))?;
        let image = trial.made_mesh(image);
        let circle = trial.accepted("the image of the circle", map.map_circle(&circle))?;
        for p in &image.points {
            let [plane, power] = circle.residuals(p);
            trial.zero("in the plane of the image of the circle", plane);
            trial.zero("on the image of the circle", power);
        }
        let corners = std::array::from_fn(|i| image.points[i].clone());
        trial.zero("planar", Coplanar.eval(&corners, &T::one()));
        trial.zero("i-circular", Concyclic.eval(&corners, &T::one()));
        trial.exhibit("M", &m);
        trial.exhibit("its image", &image);
        Ok(())
    }
}

struct MappedCone;

impl Identity for MappedCone {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let top_view = Circle::new(free_top_view(trial), trial.free());
        let circle = ICircle { plane: free_plane(trial), top_view };
        let map = generators(trial)?;
        let power = circle.top_view.centre.norm2() - &circle.top_view.radius2;
        trial.nonzero(CIRCLE_THROUGH_CENTRE, &power)?;
        trial.nonzero(GREAT, &(T::one() + power))?;
        let image = trial.accepted("the image of the circle", map.map_circle(&circle))?;
        let power = image.top_view.centre.norm2() - &image.top_view.radius2;
        trial.nonzero(GREAT, &(T::one() + power))?;
        let [cone, expected] = [&circle, &image].map(Cone::of_isotropic);
        let cone = trial.accepted("a cone", cone)?;
        let expected = trial.accepted("a cone", expected)?;
        let image = LaguerreTransformation::from(&map).map_cone(&cone);
        let image = trial.accepted("the image of the cone", image)?;
        trial.equal_points("vertex of the cone", &image.vertex, &expected.vertex);
        let [a, b] = [image, expected].map(|cone| cone.axis);
        trial.equal("axis of the cone", &a.x, &b.x);
        trial.equal("axis of the cone", &a.y, &b.y);
        trial.equal("axis of the cone", &a.z, &b.z);
        Ok(())
    }
}

struct ConicalNet;

impl Experiment for ConicalNet {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        let m = net(trial)?;
        let n = match conical_image(&m) {
            Err(NoTransfer::Cylinder(_)) => return Err(Stop::Excluded(GREAT)),
            n => trial.accepted("the conical image", n)?.mesh,
        };
        let planes = trial.accepted("planes", stored_planes(&n).ok_or("none"))?;
        let planes = trial.accepted("unit normals", planes)?;
        for (face, plane) in n.topology.faces().zip(&planes) {
            for v in n.topology.face(face) {
                trial.zero("in the plane of the face", plane.distance(&n.points[v.index()]));
            }
        }
        // Back again, where conical vertices are asked for.
        let back = trial.accepted("the circular image", circular_image(&n, &planes))?;
        for (v, p) in m.topology.interior_vertices().zip(&back.points) {
            trial.equal_points("there and back", &m.points[v.index()], p);
        }
        trial.exhibit("M", &m);
        trial.exhibit("N", &n);
        Ok(())
    }
}

/// A flat face over corners of the top view.
fn flat(corners: [[i64; 2]; 4]) -> Result<Mesh<Rational>, String> {
    let (q, mut faces) = (Rational::from_i64, FaceList::new());
    faces.push(0..4);
    let points = corners.map(|[x, y]| Point::new(q(x), q(y), q(0)));
    Mesh::new(points.to_vec(), faces).map_err(|error| error.to_string())
}

fn great_circle() -> Result<String, String> {
    let m = flat([[1, 0], [0, 1], [-1, 0], [0, -1]])?;
    conical_image(&m).map_or_else(|error| Ok(error.to_string()), |_| Err("it has an image".into()))
}

/// The image under the inversion at the unit cylinder.
fn inverted(m: &Mesh<Rational>) -> Result<Result<Mesh<Rational>, String>, String> {
    let (zero, one) = (Rational::zero(), Rational::one());
    let unit = Circle::new(TopView::new(zero.clone(), zero.clone()), one);
    let unit = CylindricalSphere::new(unit).map_err(|error| error.to_string())?;
    let map = MoebiusTransformation::inversion_at_cylinder(&unit, &zero);
    Ok(moebius_image(m, &map).map_err(|error| error.to_string()))
}

fn vertex_at_centre() -> Result<String, String> {
    match inverted(&flat([[0, 0], [1, 0], [1, 1], [0, 1]])?)? {
        Err(error) => Ok(error),
        Ok(_) => Err("it has an image".into()),
    }
}

fn circle_through_centre() -> Result<String, String> {
    // On the circle about (5, 0) through the origin.
    let image = inverted(&flat([[10, 0], [9, 3], [8, -4], [5, -5]])?)??;
    let [a, b, c] = [0, 1, 2].map(|i| image.points[i].top_view());
    if !(&b - &a).det(&(&c - &a)).is_zero() {
        return Err("it is not vertical".into());
    }
    Ok("the top view of the image lies on a line: its area is 0".into())
}
