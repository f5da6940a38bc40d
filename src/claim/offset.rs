//! Sec. 3.1: offsets of meshes in Euclidean space.

use super::{
    Claim, Control, Counterexample, Evidence, Experiment, Grade, Hypothesis, Identity, Run, Source,
    Stop, Trial,
};
use crate::check::{Residual, RootSum};
use crate::construct::transfer::{EuclideanImage, conical_image, edge_offset_image};
use crate::construct::{
    circular_net, inscribed_f_parallel, inverted_packing, koebe_mesh, quad_patch, square_packing,
};
use crate::mesh::{FaceList, Mesh, VertexId};
use crate::net::euclidean::ConcyclicNormals;
use crate::net::i_circular::Concyclic;
use crate::pair::Parallel;
use crate::scalar::{Field, Rational, RationalField, Ring};
use crate::space::laguerre::{Cone, LaguerreTransformation, OrientedPlane};
use crate::space::{ICircle, Point, TopView, Transform, Vector3};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "offset-vertex",
        statement: "The vertices of M + dS have the distance d from those of M iff S is inscribed to \
                    the unit sphere. Such an S exists, for every start, iff the faces of M have \
                    circumcircles.",
        formula: "|m_i' − m_i|² = d² |s_i|²",
        source: Source::Paper("Sec. 3.1, meshes with offsets (i)"),
        hypotheses: &[
            Hypothesis::stated(QUADS),
            Hypothesis::stated(EDGES),
            Hypothesis::silent(SIMPLY_CONNECTED),
        ],
        said: Grade::Decided,
        argument: "A face of S lies in a plane, which cuts the sphere in a circle; turned so that the \
                   plane is horizontal, it is a circle around the gradient of the face, as for Σ. From \
                   a point of the circle the direction of an edge leads to one other; which one \
                   depends on the edge alone, so in a simply connected mesh nothing is asked but that \
                   faces close.",
        evidence: &[
            Evidence::identity::<VertexDistance>("distances of vertices", &[1], &[1]),
            Evidence::identity::<Circular>("faces parallel to a concyclic quad", &[1], &[1]),
            Evidence::identity::<Closing>("circular faces close", &[1], &[1]),
        ],
        controls: &[
            Control {
                without: QUADS,
                shows: "every triangle has a circumcircle, and does not close",
                counterexample: Counterexample::Witness(triangle_opens),
            },
            Control {
                without: EDGES,
                shows: "one point of the sphere is inscribed and parallel to a kite",
                counterexample: Counterexample::Witness(one_point),
            },
            Control {
                without: SIMPLY_CONNECTED,
                shows: "three trapezoids between two triangles do not close around the hole",
                counterexample: Counterexample::Witness(annulus_opens),
            },
        ],
    },
    Claim {
        id: "offset-edge",
        statement: "The lines of the edges of M + dS have the distance d from those of M iff the \
                    edges of S touch the unit sphere.",
        formula: "dist² = d² |s × e|²/|e|²",
        source: Source::Paper("Sec. 3.1, meshes with offsets (ii)"),
        hypotheses: &[Hypothesis::stated(EDGE_OF_M)],
        said: Grade::Decided,
        argument: "The distance concerns one edge at a time; a line in the direction e through s \
                   touches the unit sphere iff |s × e|² = |e|². That there are such meshes is seen on \
                   images of circle packings.",
        evidence: &[
            Evidence::identity::<EdgeDistance>("distances of lines", &[1], &[1]),
            Evidence::experiment::<EdgeOffsets>("offsets of edge-offset meshes", &[1, 2]),
        ],
        controls: &[Control {
            without: EDGE_OF_M,
            shows: "an edge of length 0 has no line: the residual vanishes for every S",
            counterexample: Counterexample::Witness(no_line),
        }],
    },
    Claim {
        id: "offset-face",
        statement: "The planes of the faces of M + dS have the distance d from those of M iff the \
                    planes of S touch the unit sphere. Around a vertex such an S exists iff the planes \
                    touch a cone of revolution.",
        formula: "n·(v + ds) + h = d n·s",
        source: Source::Paper("Sec. 3.1, meshes with offsets (iii)"),
        hypotheses: &[Hypothesis::silent(FINITE)],
        said: Grade::Decided,
        argument: "The distance concerns one face at a time. Planes with n·s = 1 make equal angles \
                   with s, which is a cone of revolution; four unit normals admit an s iff they lie in \
                   a plane that misses the centre. Where it passes through the centre, the circle is a \
                   great one and the planes at a vertex pass through one line.",
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
    },
];

const QUADS: &str = "faces are quads";
const EDGES: &str = "no edge of S has length 0";
const SIMPLY_CONNECTED: &str = "M is simply connected";
const EDGE_OF_M: &str = "no edge of M has length 0";
const FINITE: &str = "the unit normals at a vertex do not lie on a great circle";
const STRAIGHT: &str = "a corner of the face is not straight, as on a circle";

fn polygon<T: Ring>(corners: Vec<Point<T>>) -> Result<Mesh<T>, String> {
    let mut faces = FaceList::new();
    faces.push(0..corners.len() as u32);
    Mesh::new(corners, faces).map_err(|e| e.to_string())
}

fn horizontal<T: Ring>(at: &TopView<T>) -> Point<T> {
    at.at_height(T::zero())
}

fn free_top_view<T: Field>(trial: &mut Trial<T>) -> TopView<T> {
    TopView::new(trial.free(), trial.free())
}

/// A triangle, its image in a parallel one, and the offset.
fn triangles<T: Field>(trial: &mut Trial<T>) -> Result<([Mesh<T>; 3], T), Stop> {
    let corners = vec![trial.free_point(), trial.free_point(), trial.free_point()];
    let (scale, at) = (trial.free(), trial.free_point());
    let image = |p: &Point<T>| &at + &Vector3::new(&scale * &p.x, &scale * &p.y, &scale * &p.z);
    let s = polygon(corners.iter().map(image).collect());
    let (m, s) = (trial.accepted("no mesh", polygon(corners))?, trial.accepted("no mesh", s)?);
    let d = trial.free();
    let offset = trial.accepted("not parallel", Parallel::new(&m, &s))?.offset(&d);
    let offset = trial.made_mesh(offset);
    Ok(([m, s, offset], d))
}

fn from_origin<T: Ring>(p: &Point<T>) -> Vector3<T> {
    Vector3::new(p.x.clone(), p.y.clone(), p.z.clone())
}

struct VertexDistance;

impl Identity for VertexDistance {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let ([m, s, offset], d) = triangles(trial)?;
        for ((p, q), s) in m.points.iter().zip(&offset.points).zip(&s.points) {
            let expected = d.square() * from_origin(s).length2();
            trial.equal("distance", &(q - p).length2(), &expected);
        }
        Ok(())
    }
}

/// Four concyclic top views: three are free, the last is on their circle.
fn concyclic<T: Field>(trial: &mut Trial<T>) -> Result<[TopView<T>; 4], Stop> {
    let [a, b, c] = [(); 3].map(|()| free_top_view(trial));
    let ratio = trial.free();
    let sides = [[&a, &b], [&a, &c]].map(|side| side.map(horizontal));
    let net = circular_net(&sides[0], &sides[1], |_, _| ratio.clone());
    let net = net.ok_or(Stop::Excluded("three corners span a circle"))?;
    let net = trial.accepted("no mesh", net)?;
    let d = net.points.last().map(Point::top_view);
    let d = trial.accepted("no fourth corner", d.ok_or(()))?;
    let d = TopView::new(trial.constrained(d.x), trial.constrained(d.y));
    let corners = [a, b, d, c];
    let residual = Concyclic.eval(&corners.each_ref().map(horizontal), &T::one());
    trial.relation("four corners are concyclic", residual)?;
    Ok(corners)
}

struct Circular;

impl Identity for Circular {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let s = concyclic(trial)?;
        let edges: [_; 4] = std::array::from_fn(|i| &s[(i + 1) % 4] - &s[i]);
        // Two factors are free, two are such that the quad closes.
        let start = TopView::new(T::zero(), T::zero());
        let first = &start + &edges[0].scaled(&trial.free());
        let second = &first + &edges[1].scaled(&trial.free());
        let straight = edges[2].det(&edges[3]);
        trial.parameter(STRAIGHT, &straight)?;
        let factor = -second.position().det(&edges[3]);
        let factor = trial.accepted("straight", factor.try_div(&straight).ok_or(()))?;
        let last = &second + &edges[2].scaled(&factor);
        let f = [start, first, second, last].each_ref().map(horizontal);
        let (m, s) = (polygon(f.to_vec()), polygon(s.each_ref().map(horizontal).to_vec()));
        let (m, s) = (trial.accepted("no mesh", m)?, trial.accepted("no mesh", s)?);
        trial.accepted("not parallel", Parallel::new(&m, &s).map(|_| ()))?;
        trial.exhibit("F", &m);
        trial.zero("concyclic", Concyclic.eval(&f, &T::one()));
        Ok(())
    }
}

struct Closing;

impl Identity for Closing {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let corners = concyclic(trial)?;
        let start = free_top_view(trial);
        for i in 0..4 {
            let edge = &corners[(i + 1) % 4] - &corners[i];
            trial.parameter("edges have a length", &edge.length2())?;
        }
        let straight = (&corners[1] - &corners[0]).det(&(&corners[2] - &corners[0]));
        trial.parameter(STRAIGHT, &straight)?;
        let mesh = polygon(corners.each_ref().map(horizontal).to_vec());
        let mesh = trial.accepted("no mesh", mesh)?;
        trial.exhibit("F", &mesh);
        let pair = inscribed_f_parallel(&mesh, VertexId(0), &start);
        let pair = trial.accepted("it does not close", pair)?;
        for s in &pair.image().points {
            trial.equal("a circle around the gradient", &s.top_view().norm2(), &start.norm2());
        }
        let edge = &pair.image().points[0] - &pair.image().points[3];
        let along = &mesh.points[0] - &mesh.points[3];
        trial.zero("the last edge", edge.top_view().det(&along.top_view()));
        Ok(())
    }
}

fn rational_polygon(corners: &[[i64; 2]]) -> Result<Mesh<Rational>, String> {
    let at = |&[x, y]: &[i64; 2]| {
        horizontal(&TopView::new(Rational::from_i64(x), Rational::from_i64(y)))
    };
    polygon(corners.iter().map(at).collect())
}

fn triangle_opens() -> Result<String, String> {
    let mesh = rational_polygon(&[[0, 0], [2, 0], [0, 2]])?;
    let start = TopView::new(Rational::from_i64(1), Rational::from_i64(3));
    match inscribed_f_parallel(&mesh, VertexId(0), &start) {
        Ok(_) => Err("it closes".into()),
        Err(error) => Ok(error.to_string()),
    }
}

/// Trapezoids between a triangle inscribed to a circle and the same of half the size: an odd number
/// of reflections, which move whatever is not on their common axis.
fn annulus_opens() -> Result<String, String> {
    let corners = [[5, 0], [-3, 4], [-3, -4]];
    let place = |[x, y]: [i64; 2], size: i64| {
        let [x, y] = [x, y].map(|c| Rational::from_i64(size * c));
        horizontal(&TopView::new(x, y))
    };
    let points: Vec<_> = [2, 1].iter().flat_map(|&k| corners.map(|p| place(p, k))).collect();
    let mut faces = FaceList::new();
    for [i, j] in [[0, 1], [1, 2], [2, 0]] {
        faces.push([i, j, j + 3, i + 3]);
        let [a, b, c, d] = [i, j, j + 3, i + 3].map(|v| points[v as usize].clone());
        if !Concyclic.eval(&[a, b, c, d], &Rational::one()).is_zero() {
            return Err("a face without a circumcircle".into());
        }
    }
    let mesh = Mesh::new(points, faces).map_err(|e| e.to_string())?;
    let start = TopView::new(Rational::from_i64(1), Rational::from_i64(3));
    match inscribed_f_parallel(&mesh, VertexId(0), &start) {
        Ok(_) => Err("it closes".into()),
        Err(error) => Ok(error.to_string()),
    }
}

fn one_point() -> Result<String, String> {
    let kite = rational_polygon(&[[0, 0], [1, -1], [3, 0], [1, 1]])?;
    let s = polygon(vec![horizontal(&TopView::new(Rational::one(), Rational::zero())); 4])?;
    Parallel::new(&kite, &s).map_err(|e| e.to_string())?;
    let on_sphere = s.points.iter().all(|p| from_origin(p).length2() == Rational::one());
    let [a, b, c, d] = kite.points.as_slice() else { return Err("no quad".into()) };
    let residual = Concyclic.eval(&[a, b, c, d].map(Point::clone), &Rational::one());
    if !on_sphere || residual.is_zero() {
        return Err("the kite is circular".into());
    }
    Ok(format!("concyclic: {residual}"))
}

struct EdgeDistance;

impl Identity for EdgeDistance {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let ([m, s, offset], d) = triangles(trial)?;
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            let edge = &m.points[j] - &m.points[i];
            trial.nonzero(EDGE_OF_M, &edge.length2())?;
            // The squared distance of parallel lines, times |e|².
            for (from, to) in [(i, i), (i, j)] {
                let across = (&offset.points[to] - &m.points[from]).cross(&edge);
                let expected = d.square() * from_origin(&s.points[i]).cross(&edge).length2();
                trial.equal("distance", &across.length2(), &expected);
            }
        }
        Ok(())
    }
}

/// `dist² |e|² − d² |e|²` vanishes with the edge, whatever S is.
fn no_line() -> Result<String, String> {
    let m = rational_polygon(&[[0, 0], [0, 0], [1, 0], [0, 1]])?;
    let s = rational_polygon(&[[5, 0], [2, 1], [6, 1], [5, 2]])?;
    Parallel::new(&m, &s).map_err(|e| e.to_string())?;
    let edge = &m.points[1] - &m.points[0];
    let residual = from_origin(&s.points[0]).cross(&edge).length2() - edge.length2();
    let own = &s.points[1] - &s.points[0];
    let touching = from_origin(&s.points[0]).cross(&own).length2() - own.length2();
    if residual.is_zero() && !touching.is_zero() {
        return Ok(format!("the residual is 0, but the edge of S misses the sphere: {touching}"));
    }
    Err("nothing breaks".into())
}

struct EdgeOffsets;

impl Experiment for EdgeOffsets {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        let n = trial.size() + 1;
        let centre = free_top_view(trial);
        let circles = inverted_packing(&square_packing(n, n), &centre);
        let circles = circles.or(Err(Stop::Excluded("no circle passes through the centre")))?;
        let radii: Vec<T> = circles.iter().map(|c| c.radius.clone()).collect();
        let koebe = trial.accepted("no mesh", koebe_mesh(circles, quad_patch(n, n)))?;
        // A face circle through the centre, or one that is the image of a great circle.
        let image = edge_offset_image(&koebe, &radii);
        let image = image.or(Err(Stop::Excluded("all vertices are finite")))?;
        let d = trial.free();
        let EuclideanImage { mesh, gauss } = image.clone();
        let offset = trial.made_mesh(image.offset(&d).mesh);
        trial.exhibit("N", &mesh);
        for h in mesh.topology.edges() {
            let [v, w] = [mesh.topology.origin(h), mesh.topology.target(h)].map(VertexId::index);
            let edge = &mesh.points[w] - &mesh.points[v];
            trial.parameter(EDGE_OF_M, &edge.length2())?;
            for end in [v, w] {
                let across = (&offset.points[end] - &mesh.points[v]).cross(&edge);
                let expected = d.square() * edge.length2();
                trial.equal("distance", &across.length2(), &expected);
            }
            let touching = from_origin(&gauss.points[v]).cross(&edge).length2() - edge.length2();
            trial.zero("S touches the unit sphere", touching);
        }
        Ok(())
    }
}

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
