//! Sec. 3.4, Remark 2: the incircles of an i-isothermic mesh under i-M-transformations and under τ.

use super::instance::{CORNERS, free_top_view, generators, polygon_about};
use super::isothermic::koebe_net;
use super::{
    Claim, Control, Counterexample, Evidence, Experiment, Grade, Hypothesis, Identity, Run, Source,
    Stop, Trial,
};
use crate::check::Residual;
use crate::construct::transfer::{EuclideanImage, NoTransfer, edge_offset_image};
use crate::construct::{inverted_packing, koebe_mesh, quad_patch, square_packing};
use crate::mesh::Mesh;
use crate::net::RADIUS;
use crate::net::planar::Coplanar;
use crate::scalar::{Field, Rational, RationalField, Ring};
use crate::space::laguerre::Cone;
use crate::space::{
    Circle, CylindricalSphere, Gradient, ICircle, MoebiusTransformation, OrientedCircle, Plane,
    Point, Rotation, TopView, Vector2, Vector3,
};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "remark-2-moebius",
        statement: "An i-M-transformation maps the i-circles inscribed to the faces of an i-isothermic mesh \
                    to those of another: at every edge the images touch in one point, their planes meet \
                    over the common tangent, and around every vertex they meet in one point, over the \
                    centre of the image of the vertex circle.",
        formula: "",
        source: Source::Paper("Sec. 3.4, Remark 2"),
        hypotheses: &[
            Hypothesis::stated(ONE_CONTACT),
            Hypothesis::silent(INCIRCLES),
            Hypothesis::silent(VERTEX_CIRCLES),
        ],
        said: Grade::Certified,
        argument: "The incircles around a vertex of valence k arise from k contacts on its circle and k + 1 \
                   heights; a mesh is i-isothermic iff this holds around its vertices. For larger k each \
                   face is compared with the first. The inversion at the unit cylinder, those at \
                   i-M-spheres and additions of these generate, with what keeps i-circles \
                   obviously, all i-M-transformations.",
        evidence: &[Evidence::identity::<MappedIncircles>(
            "the incircles around a vertex",
            &[3, 4],
            &[4, 3, 6],
        )],
        controls: &[
            Control {
                without: ONE_CONTACT,
                shows: "the images of two circles that touch a line at two points",
                counterexample: Counterexample::Witness(two_contacts),
            },
            Control {
                without: INCIRCLES,
                shows: "an incircle through the centre goes to infinity",
                counterexample: Counterexample::Witness(incircle_through_centre),
            },
            Control {
                without: VERTEX_CIRCLES,
                shows: "so does a vertex circle, and the images of its contacts lie on a line",
                counterexample: Counterexample::Witness(vertex_circle_through_centre),
            },
        ],
    },
    Claim {
        id: "remark-2-edge-offset",
        statement: "The map τ sends the incircles of an i-isothermic mesh to cones of revolution whose \
                    vertices form a mesh N with planar faces. The axes of the cones form a mesh parallel \
                    to N with edges that touch the unit sphere: so edges of N and of its offsets are at \
                    constant distance, and the edges at a vertex of N lie on a cone about its axis.",
        formula: "(e·s)² = |e|² (|s|² - 1)",
        source: Source::Paper("Sec. 3.4, Remark 2"),
        hypotheses: &[Hypothesis::stated(ONE_CONTACT), Hypothesis::silent(GREAT)],
        said: Grade::Certified,
        argument: "Faces of N belong to vertices of M, edges to edges: the star of a vertex of valence k has \
                   them all. With N parallel to a mesh whose edges touch the unit sphere, N + dS has \
                   edges at the distance d.",
        evidence: &[
            Evidence::identity::<ConesAroundVertex>(
                "the cones around a vertex",
                &[3, 4],
                &[4, 3, 6],
            ),
            Evidence::identity::<OffsetPatch>("a patch over an inverted packing", &[1], &[1]),
            Evidence::experiment::<OffsetNet>("nets", &[2, 3]),
        ],
        controls: &[
            Control {
                without: ONE_CONTACT,
                shows: "circles that do not touch",
                counterexample: Counterexample::Witness(not_touching),
            },
            Control {
                without: GREAT,
                shows: "the incircle is the unit circle: the planes envelop a cylinder",
                counterexample: Counterexample::Witness(great_circle),
            },
        ],
    },
];

const ONE_CONTACT: &str = "the incircles of two faces touch their edge at one point";
const INCIRCLES: &str = "no incircle passes through the centre";
const VERTEX_CIRCLES: &str = "no vertex circle passes through the centre";
const GREAT: &str = "no incircle is the image of a great circle";

/// The i-circles inscribed to the faces around a vertex.
struct Around<T> {
    vertex: Point<T>,
    circle: OrientedCircle<T>,
    /// The contact of each edge.
    contacts: Vec<Point<T>>,
    /// The i-circle between each edge and the one before it.
    incircles: Vec<ICircle<T>>,
}

impl<T: Field> Around<T> {
    fn free(trial: &mut Trial<T>) -> Result<Self, Stop> {
        let k = trial.size();
        let circle = OrientedCircle { centre: free_top_view(trial), radius: trial.free() };
        trial.parameter("the vertex circle is no point", &circle.radius)?;
        let parameters: Vec<T> = (0..k).map(|_| trial.free()).collect();
        let vertex = circle.centre.at_height(trial.free());
        let mut contacts = Vec::new();
        for (j, t) in parameters.iter().enumerate() {
            let next = &parameters[(j + 1) % k];
            trial.parameter("1 + t² is not 0", &(T::one() + t.square()))?;
            trial.parameter("no edges are opposite", &(T::one() + t * next))?;
            trial.parameter("no edges agree", &(t - next))?;
            let ray = trial.accepted("a direction", Rotation::from_parameter(t))?;
            let ray = Vector2::new(ray.cos() * &circle.radius, ray.sin() * &circle.radius);
            contacts.push((&circle.centre + &ray).at_height(trial.free()));
        }
        let polygon = polygon_about(&circle, &parameters);
        let polygon = trial.accepted("incircles", polygon.ok_or("none"))?;
        let mut incircles = Vec::new();
        for (j, incircle) in polygon.iter().enumerate() {
            let ends = [&contacts[(j + k - 1) % k], &contacts[j]];
            let plane = trial.accepted("a face", Plane::through(&vertex, ends[0], ends[1]))?;
            let circle = ICircle { plane, top_view: incircle.circle() };
            for end in ends {
                let [plane, power] = circle.residuals(end);
                trial.zero("the contact is in the face", plane);
                trial.zero("the contact is on the incircle", power);
            }
            incircles.push(circle);
        }
        Ok(Around { vertex, circle, contacts, incircles })
    }
}

fn power<T: Field>(circle: &Circle<T>) -> T {
    circle.centre.norm2() - &circle.radius2
}

struct MappedIncircles;

impl Identity for MappedIncircles {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let around = Around::free(trial)?;
        let (map, k) = (generators(trial)?, around.contacts.len());
        trial.nonzero(VERTEX_CIRCLES, &power(&around.circle.circle()))?;
        let origin = TopView::new(T::zero(), T::zero());
        let vertex = trial.defined(VERTEX_CIRCLES, around.circle.inverted(&origin))?;
        let (mut images, mut contacts) = (Vec::new(), Vec::new());
        for (circle, contact) in around.incircles.iter().zip(&around.contacts) {
            trial.nonzero(INCIRCLES, &power(&circle.top_view))?;
            trial.nonzero(INCIRCLES, &contact.top_view().norm2())?;
            images.push(trial.accepted("an incircle", map.map_circle(circle))?);
            let contact = trial.accepted("a contact", map.map_point(contact))?;
            contacts.push(trial.made_point(contact));
        }
        let height = images[0].plane.height_at(&vertex.centre);
        for (j, t) in contacts.iter().enumerate() {
            let (left, right) = (&images[j], &images[(j + 1) % k]);
            for circle in [left, right] {
                let [plane, power] = circle.residuals(t);
                trial.zero("the contact is in the image of the plane", plane);
                trial.zero("the contact is on the image of the incircle", power);
            }
            let at = t.top_view();
            let radii = [left, right].map(|circle| &circle.top_view.centre - &at);
            trial.zero("the images touch", radii[0].det(&radii[1]));
            let jump = &right.plane.gradient - &left.plane.gradient;
            trial.zero("over the common tangent", jump.det(&radii[0]));
            trial.equal("through one point", &left.plane.height_at(&vertex.centre), &height);
            let distance2 = at.distance2(&vertex.centre);
            trial.equal("on the vertex circle", &distance2, &vertex.radius.square());
        }
        trial.show("height of the new vertex", &height);
        trial.show("height of the vertex", &around.vertex.z);
        Ok(())
    }
}

fn scaled<T: Field>(v: &Vector3<T>, by: &T) -> Vector3<T> {
    Vector3::new(&v.x * by, &v.y * by, &v.z * by)
}

/// What an edge of N with the axes at its ends has to satisfy.
fn edge_offset<T: Field>(trial: &mut Trial<T>, ends: [&Point<T>; 2], axes: [&Vector3<T>; 2]) {
    let edge = ends[1] - ends[0];
    let minus = scaled(axes[0], &-T::one());
    let (a, b) = (&minus, axes[1]);
    let image = Vector3::new(&a.x + &b.x, &a.y + &b.y, &a.z + &b.z);
    let cross = edge.cross(&image);
    trial.zero("the axes are parallel to N", cross.x);
    trial.zero("the axes are parallel to N", cross.y);
    trial.zero("the axes are parallel to N", cross.z);
    let moment = axes[0].cross(axes[1]);
    trial.equal("their edge touches the unit sphere", &moment.length2(), &image.length2());
    for axis in axes {
        let expected = image.length2() * (axis.length2() - T::one());
        trial.equal("the edge is on a cone about the axis", &image.dot(axis).square(), &expected);
    }
}

struct ConesAroundVertex;

impl Identity for ConesAroundVertex {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let around = Around::free(trial)?;
        let mut cones = Vec::new();
        for circle in &around.incircles {
            trial.nonzero(GREAT, &(T::one() + power(&circle.top_view)))?;
            let cone = trial.defined(GREAT, Cone::of_isotropic(circle).ok())?;
            cones.push(Cone { vertex: trial.made_point(cone.vertex), axis: cone.axis });
        }
        for (j, cone) in cones.iter().enumerate() {
            let next = &cones[(j + 1) % cones.len()];
            edge_offset(trial, [&cone.vertex, &next.vertex], [&cone.axis, &next.axis]);
        }
        // The plane of the face, known from the vertex and its circle.
        let n = power(&around.circle.circle());
        let [x, y, z] = around.vertex.coordinates();
        let two = T::from_i64(2);
        for cone in &cones {
            let g = &cone.vertex;
            let sum = &two * (x * &g.x + y * &g.y + z) + (T::one() - &n) * &g.z;
            trial.zero("2 v₁ x + 2 v₂ y + (1 - n) z + 2 v₃ = 0", sum);
        }
        Ok(())
    }
}

/// What the edges and faces of an image have to satisfy.
fn edge_offsets<T: Field>(trial: &mut Trial<T>, image: &EuclideanImage<T>) {
    let EuclideanImage { mesh, gauss } = image;
    for h in mesh.topology.edges() {
        let ends = [mesh.topology.origin(h), mesh.topology.target(h)].map(|v| v.index());
        let axes = ends.map(|v| {
            let p = &gauss.points[v];
            Vector3::new(p.x.clone(), p.y.clone(), p.z.clone())
        });
        edge_offset(trial, ends.map(|v| &mesh.points[v]), [&axes[0], &axes[1]]);
    }
    for face in mesh.topology.faces() {
        let corners = mesh.topology.face(face);
        let at = std::array::from_fn(|i| mesh.points[corners[i].index()].clone());
        trial.zero("a planar face", Coplanar.eval(&at, &T::one()));
    }
}

struct OffsetPatch;

impl Identity for OffsetPatch {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let centre = free_top_view(trial);
        let packing = square_packing(2, 2);
        for circle in &packing {
            trial.parameter(
                "no circle passes through the centre",
                &circle.circle().power(&centre),
            )?;
        }
        let packing = trial.accepted("a packing", inverted_packing(&packing, &centre))?;
        let mut m = trial.accepted("a Koebe mesh", koebe_mesh(packing, quad_patch(2, 2)))?;
        // Heights of the first row and column are free, the others follow from planar faces; planes
        // are added by translations of N, so three vanish.
        for i in 0..3 {
            for j in 0..3 {
                let [at, left, below, corner] = [(0, 0), (0, 1), (1, 0), (1, 1)]
                    .map(|(di, dj)| (3 * i + j) as usize - if i * j > 0 { 3 * di + dj } else { 0 });
                m.points[at].z = if i + j < 2 {
                    T::zero()
                } else if i * j == 0 {
                    trial.free()
                } else {
                    let [a, b, c] = [corner, below, left].map(|v| &m.points[v]);
                    let det = (b - a).top_view().det(&(c - a).top_view());
                    trial.parameter(CORNERS, &det)?;
                    let plane = trial.accepted("a face", Plane::through(a, b, c))?;
                    plane.height_at(&m.points[at].top_view())
                };
            }
        }
        for face in m.topology.faces() {
            let corners = m.topology.face(face);
            let [a, b, c] = [0, 1, 2].map(|i| &m.points[corners[i].index()]);
            trial.parameter(CORNERS, &(b - a).top_view().det(&(c - a).top_view()))?;
        }
        let radii = trial.accepted("radii", m.data.vertex.remove(RADIUS).ok_or("none"))?;
        for i in 0..2 {
            for j in 0..2 {
                // The incircle, inverted as well.
                let at = |n: usize| T::from_ratio(2 * n as i64 + 1, 2);
                let incircle = OrientedCircle {
                    centre: TopView::new(at(i), at(j)),
                    radius: T::from_ratio(1, 2),
                };
                let before = incircle.circle().power(&centre);
                trial.parameter("no circle passes through the centre", &before)?;
                let incircle =
                    trial.accepted("incircle", incircle.inverted(&centre).ok_or("none"))?;
                trial.nonzero(GREAT, &(T::one() + power(&incircle.circle())))?;
            }
        }
        let image = trial.accepted("the edge-offset image", edge_offset_image(&m, &radii))?;
        edge_offsets(trial, &image);
        trial.exhibit("M", &m);
        trial.exhibit("N", &image.mesh);
        Ok(())
    }
}

struct OffsetNet;

impl Experiment for OffsetNet {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        let (mut m, _) = koebe_net(trial)?;
        // Another mesh with the same top view: a multiple, and a shear.
        let (factor, plane) = (trial.free(), Gradient::new(trial.free(), trial.free()));
        for p in &mut m.points {
            p.z = &p.z * &factor + plane.along(&p.top_view().position());
        }
        let radii = trial.accepted("radii", m.data.vertex.remove(RADIUS).ok_or("none"))?;
        let image = match edge_offset_image(&m, &radii) {
            Err(NoTransfer::Cylinder(_)) => return Err(Stop::Excluded(GREAT)),
            image => trial.accepted("the edge-offset image", image)?,
        };
        edge_offsets(trial, &image);
        let image = image.offset(&trial.free());
        edge_offsets(trial, &image);
        trial.exhibit("M", &m);
        trial.exhibit("N", &image.mesh);
        Ok(())
    }
}

/// The inversion at the unit cylinder.
fn inversion() -> Result<MoebiusTransformation<Rational>, String> {
    let (zero, one) = (Rational::zero(), Rational::one());
    let unit = Circle::new(TopView::new(zero.clone(), zero.clone()), one);
    let unit = CylindricalSphere::new(unit).map_err(|error| error.to_string())?;
    Ok(MoebiusTransformation::inversion_at_cylinder(&unit, &zero))
}

/// A circle with the radius 1 in the plane z = 1.
fn level(x: i64, y: i64) -> ICircle<Rational> {
    let [x, y, one, zero] = [x, y, 1, 0].map(Rational::from_i64);
    let plane = Plane::new(Gradient::new(zero.clone(), zero), one.clone());
    ICircle { plane, top_view: Circle::new(TopView::new(x, y), one) }
}

fn two_contacts() -> Result<String, String> {
    // Above and below the x-axis.
    let (map, circles) = (inversion()?, [level(3, 1), level(5, -1)]);
    let image = |circle| map.map_circle(circle).map_err(|error| error.to_string());
    let [a, b] = [image(&circles[0])?, image(&circles[1])?];
    // Whether the line in which the planes meet touches the first image.
    let jump = &b.plane.gradient - &a.plane.gradient;
    let at = &a.top_view.centre;
    let rise = b.plane.height_at(at) - a.plane.height_at(at);
    let missed = rise.square() - &a.top_view.radius2 * jump.length2();
    if missed.is_zero() { Err("it touches".into()) } else { Ok(format!("tangency: {missed}")) }
}

fn incircle_through_centre() -> Result<String, String> {
    let image = inversion()?.map_circle(&level(1, 0));
    image.map_or_else(|error| Ok(error.to_string()), |_| Err("it has an image".into()))
}

fn vertex_circle_through_centre() -> Result<String, String> {
    // Contacts on the circle about (5, 0) through the origin.
    let (map, q) = (inversion()?, Rational::from_i64);
    let image = |x, y| map.map_top_view(&TopView::new(q(x), q(y))).map_err(|e| e.to_string());
    let [a, b, c] = [image(10, 0)?, image(9, 3)?, image(8, -4)?];
    if !(&b - &a).det(&(&c - &a)).is_zero() {
        return Err("the contacts have a circle".into());
    }
    Ok("the images of the contacts lie on a line".into())
}

/// Why a flat quad with these radii has no edge-offset image.
fn refusal(corners: [[i64; 2]; 4], radii: [i64; 4]) -> Result<String, String> {
    let q = Rational::from_i64;
    let points = corners.map(|[x, y]| Point::new(q(x), q(y), q(0)));
    let m = Mesh::new(points.to_vec(), quad_patch(1, 1)).map_err(|error| error.to_string())?;
    let image = edge_offset_image(&m, &radii.map(q));
    image.map_or_else(|error| Ok(error.to_string()), |_| Err("it has an image".into()))
}

fn not_touching() -> Result<String, String> {
    refusal([[0, 0], [0, 2], [4, 0], [4, 2]], [1; 4])
}

fn great_circle() -> Result<String, String> {
    refusal([[-1, -1], [-1, 1], [1, -1], [1, 1]], [1; 4])
}
