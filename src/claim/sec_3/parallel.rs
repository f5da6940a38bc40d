//! Sec. 3.1: parallel meshes, f-parallel and v-parallel pairs, relative normals.

use super::{
    Claim, Control, Counterexample, Evidence, Experiment, Grade, Hypothesis, Identity, Run, Source,
    Stop, Trial,
};
use crate::check::Residual;
use crate::construct::{metric_dual, quad_patch};
use crate::mesh::{FaceList, Mesh};
use crate::net::planar::Coplanar;
use crate::net::scribed::{EdgeTouchesSigma, OnSigma, TouchesSigma};
use crate::pair::linear_space::{parallel_space, v_parallel_space};
use crate::pair::{FParallel, Parallel, VParallel};
use crate::scalar::{Field, Rational, RationalField, Ring};
use crate::space::{Dual, Gradient, Plane, Point, TopView, Vector3};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "parallel-linear",
        statement: "The meshes parallel to a planar mesh form a linear space, and so do those \
                    v-parallel to it. For a patch of m × n quads their dimensions are m + n + 3, \
                    translations included, and m + n + 1.",
        formula: "",
        source: Source::Paper("Sec. 3.1, mesh parallelism"),
        hypotheses: &[Hypothesis::silent(NO_STRAIGHT_CORNER)],
        said: Grade::Instances,
        argument: "The conditions are linear. The factors of the edges of two sides of a patch, or \
                   the heights of its vertices, determine quad by quad all others.",
        evidence: &[
            Evidence::experiment::<ParallelMeshes>("exact ranks, combinations", &[1, 2, 3]),
            Evidence::experiment::<VParallelMeshes>("the same of heights", &[1, 2, 3]),
        ],
        controls: &[Control {
            without: NO_STRAIGHT_CORNER,
            shows: "2 × 2 quads in a square whose corners are straight have one dimension more",
            counterexample: Counterexample::Witness(straight_corners),
        }],
    },
    Claim {
        id: "duality-f-v",
        statement: "Metric duality maps f-parallel pairs to v-parallel pairs with the dual \
                    combinatorics. The dual of an inscribed mesh is circumscribed, that of a \
                    circumscribed one inscribed, that of a midscribed one midscribed.",
        formula: "∇M_i = ∇S_i ⇔ (m_i*)' = (s_i*)'",
        source: Source::Paper("Sec. 3.1, mesh parallelism in isotropic space"),
        hypotheses: &[Hypothesis::stated(NO_VERTICAL_FACE), Hypothesis::silent(NO_VERTICAL_DUAL)],
        said: Grade::Certified,
        argument: "Two meshes are paired face by face and vertex by vertex, and one inner vertex with \
                   its four faces has all kinds of both. More faces at a vertex are as many more \
                   poles in its polar plane. The residuals of vertex and dual face, of face and dual \
                   vertex, of edge and dual edge are multiples of each other, and duality is an \
                   involution.",
        evidence: &[
            Evidence::identity::<DualPairs>("an inner vertex with its faces", &[1], &[1]),
            Evidence::identity::<Scribed>("residuals at Σ", &[1], &[1]),
        ],
        controls: &[
            Control {
                without: NO_VERTICAL_FACE,
                shows: "a face over a line has no plane z = p·x' + t",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &[
                        "0", "0", "1", "0", "0", "1", "1", "2", "0", "0", "0", "0", "1", "1", "1",
                        "2", "0", "3", "4", "5", "6", "7", "8",
                    ],
                    constrained: &[],
                },
            },
            Control {
                without: NO_VERTICAL_DUAL,
                shows: "gradients on a line: the dual faces are vertical",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &[
                        "0", "0", "1", "0", "3", "0", "4", "0", "0", "0", "0", "1", "1", "2", "-1",
                        "1", "7", "2", "-5", "-4", "1", "-3", "-9", "0", "0", "0", "1", "1", "2",
                        "-1", "1", "7", "2", "-5", "-4", "1", "-3", "-9",
                    ],
                    constrained: &[],
                },
            },
        ],
    },
    Claim {
        id: "r-normals-coplanar",
        statement: "The relative normals at the ends of an edge lie in a plane, with the edges of all \
                    offsets.",
        formula: "det(m_j − m_i, s_i, s_j) = 0",
        source: Source::Paper("Sec. 3.1, relative Gauss mapping"),
        hypotheses: &[Hypothesis::stated(PARALLEL_EDGES)],
        said: Grade::Certified,
        argument: "An edge of M, its image in S and the two normals are linear combinations of two \
                   vectors; an edge is parallel to its image where two planes meet in it that are \
                   not parallel.",
        evidence: &[Evidence::identity::<RelativeNormals>(
            "inner edges of f-parallel meshes",
            &[1],
            &[1],
        )],
        controls: &[Control {
            without: PARALLEL_EDGES,
            shows: "two triangles in horizontal planes, with different angles",
            counterexample: Counterexample::Witness(skew_normals),
        }],
    },
];

const NO_STRAIGHT_CORNER: &str = "no corner of a face is straight in the top view";
const NO_VERTICAL_FACE: &str = "no face is vertical";
const NO_VERTICAL_DUAL: &str = "the gradients at no vertex are collinear: no dual face is vertical";
const PARALLEL_EDGES: &str = "corresponding edges are parallel";

/// A square of 2 × 2 quads whose corners lie on the lines between the neighbours.
fn straight_corners() -> Result<String, String> {
    let half = Rational::from_ratio(1, 2);
    let at = |x: i64, y: i64| {
        let [x, y] = [x, y].map(|n| Rational::from_i64(n) * &half);
        Point::new(x, y, Rational::zero())
    };
    let rows = [-1, 0, 1].map(|i: i64| {
        [-1, 0, 1].map(|j: i64| {
            let stretch = 2 - (i * j).abs();
            at(i * stretch, j * stretch)
        })
    });
    let mesh = Mesh::new(rows.into_iter().flatten().collect(), quad_patch(2, 2));
    let mesh = mesh.map_err(|e| e.to_string())?;
    match parallel_space(&mesh).dimension() {
        7 => Err("the dimension is m + n + 3".into()),
        dimension => Ok(format!("dimension {dimension} instead of 7")),
    }
}

/// A patch of planar quads over any top views: heights are free along two sides.
fn patch<T: RationalField>(
    trial: &mut Trial<T>,
    rows: usize,
    columns: usize,
) -> Result<Mesh<T>, Stop> {
    let mut points: Vec<Point<T>> = Vec::new();
    for i in 0..=rows {
        for j in 0..=columns {
            let [x, y] = [i, j].map(|n| T::from_i64(n as i64 * 7) + trial.free());
            let at = TopView::new(x, y);
            if i == 0 || j == 0 {
                points.push(at.at_height(trial.free()));
                continue;
            }
            let k = i * (columns + 1) + j;
            let [a, b, c] = [k - columns - 2, k - columns - 1, k - 1].map(|n| points[n].clone());
            let corner = |o: &Point<T>, p: &TopView<T>, q: &TopView<T>| {
                (p - &o.top_view()).det(&(q - &o.top_view()))
            };
            let (near_b, near_c) = (b.top_view(), c.top_view());
            let here = at.at_height(T::zero());
            trial.nonzero(NO_STRAIGHT_CORNER, &corner(&a, &near_b, &near_c))?;
            trial.nonzero(NO_STRAIGHT_CORNER, &corner(&here, &near_b, &near_c))?;
            trial.nonzero(NO_STRAIGHT_CORNER, &corner(&b, &a.top_view(), &at))?;
            trial.nonzero(NO_STRAIGHT_CORNER, &corner(&c, &a.top_view(), &at))?;
            let plane = trial.accepted("a vertical face", Plane::through(&a, &b, &c))?;
            points.push(plane.point_at(&at));
        }
    }
    trial.accepted("no mesh", Mesh::new(points, quad_patch(rows, columns)))
}

/// A combination of meshes with the same vertices.
fn combination<T: RationalField>(
    trial: &mut Trial<T>,
    mesh: &Mesh<T>,
    basis: &[Mesh<T>],
) -> Mesh<T> {
    let mut sum = mesh.clone();
    for term in basis {
        let a = trial.free();
        for (p, q) in sum.points.iter_mut().zip(&term.points) {
            *p = &*p + &Vector3::new(&a * &q.x, &a * &q.y, &a * &q.z);
        }
    }
    trial.made_mesh(sum)
}

struct ParallelMeshes;

impl Experiment for ParallelMeshes {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        let (m, n) = (trial.size(), 2);
        let mesh = patch(trial, m, n)?;
        trial.exhibit("M", &mesh);
        let space = parallel_space(&mesh);
        let number = |n: usize| T::from_i64(n as i64);
        trial.equal("dimension", &number(space.dimension()), &number(m + n + 3));
        let basis = [space.basis(), space.translations()].concat();
        trial.equal("basis", &number(basis.len()), &number(m + n + 3));
        let sum = combination(trial, &mesh, &basis);
        // Translations are parallel whatever they are, so a moved vertex shows at its edges.
        for h in mesh.topology.edges() {
            let ends = [mesh.topology.origin(h), mesh.topology.target(h)].map(|v| v.index());
            let along = |mesh: &Mesh<T>| &mesh.points[ends[1]] - &mesh.points[ends[0]];
            let Vector3 { x, y, z } = along(&mesh).cross(&along(&sum));
            [x, y, z].into_iter().for_each(|residual| trial.zero("parallel edges", residual));
        }
        trial.accepted("not parallel", Parallel::new(&mesh, &sum).map(|_| ()))
    }
}

struct VParallelMeshes;

impl Experiment for VParallelMeshes {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        let (m, n) = (trial.size(), 2);
        let mesh = patch(trial, m, n)?;
        trial.exhibit("M", &mesh);
        let space = v_parallel_space(&mesh);
        let number = |n: usize| T::from_i64(n as i64);
        trial.equal("dimension", &number(space.dimension()), &number(m + n + 1));
        let basis = space.basis();
        trial.equal("basis", &number(basis.len()), &number(m + n + 1));
        let flat = |mesh: &Mesh<T>| {
            let mut flat = mesh.clone();
            flat.points.iter_mut().for_each(|p| (p.x, p.y) = (T::zero(), T::zero()));
            flat
        };
        let heights: Vec<Mesh<T>> = basis.iter().map(flat).collect();
        let sum = combination(trial, &mesh, &heights);
        trial.accepted("not v-parallel", VParallel::new(&mesh, &sum).map(|_| ()))
    }
}

/// A mesh of four quads around a vertex with these gradients of its faces.
fn around_a_vertex<T: Field>(
    trial: &mut Trial<T>,
    assume: Assume<T>,
    gradients: &[Gradient<T>; 4],
) -> Result<Mesh<T>, Stop> {
    let centre = trial.free_point();
    let planes = gradients.clone().map(|p| Plane::through_point(&centre, p));
    let mut points = vec![centre.clone(); 9];
    // The edges between two planes, then the corners in one.
    for (vertex, [f, g]) in [(1, [0, 1]), (3, [0, 2]), (5, [1, 3]), (7, [2, 3])] {
        let along = (&gradients[f] - &gradients[g]).turned().scaled(&trial.free());
        points[vertex] = planes[f].point_at(&(&centre.top_view() + &along));
    }
    for (face, vertex) in [0, 2, 6, 8].into_iter().enumerate() {
        let at = TopView::new(trial.free(), trial.free());
        points[vertex] = planes[face].point_at(&at);
    }
    let mesh = trial.accepted("no mesh", Mesh::new(points, quad_patch(2, 2)))?;
    no_vertical_face(trial, assume, NO_VERTICAL_FACE, &mesh)?;
    Ok(mesh)
}

/// How a condition is stated: as a hypothesis, or as one of the instance.
type Assume<T> = fn(&mut Trial<T>, &'static str, &T) -> Run;

/// Three corners in a row of each face are not collinear in the top view.
fn no_vertical_face<T: Field>(
    trial: &mut Trial<T>,
    assume: Assume<T>,
    says: &'static str,
    mesh: &Mesh<T>,
) -> Run {
    for face in mesh.topology.faces() {
        let corners = mesh.topology.face(face).iter();
        let corners: Vec<_> = corners.map(|v| mesh.points[v.index()].top_view()).collect();
        let area = |p: &[TopView<T>]| (&p[1] - &p[0]).det(&(&p[2] - &p[0]));
        let found = corners.windows(3).map(area).find(|area| !area.is_zero());
        assume(trial, says, &found.unwrap_or_else(T::zero))?;
    }
    Ok(())
}

fn gradients<T: Field>(trial: &mut Trial<T>) -> [Gradient<T>; 4] {
    std::array::from_fn(|_| Gradient::new(trial.free(), trial.free()))
}

struct DualPairs;

impl Identity for DualPairs {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let gradients = gradients(trial);
        let m = around_a_vertex(trial, Trial::nonzero, &gradients)?;
        let s = around_a_vertex(trial, Trial::nonzero, &gradients)?;
        trial.exhibit("M", &m);
        trial.exhibit("S", &s);
        trial.accepted("not f-parallel", FParallel::new(&m, &s).map(|_| ()))?;
        let [m, s] = [m, s].map(|mesh| metric_dual(&mesh));
        let (m, s) = (trial.accepted("no dual", m)?, trial.accepted("no dual", s)?);
        let m = trial.made_mesh(m);
        no_vertical_face(trial, Trial::nonzero, NO_VERTICAL_DUAL, &m)?;
        for (p, q) in m.points.iter().zip(&s.points) {
            trial.zero("parallel points", p.i_distance2(q));
        }
        trial.accepted("not v-parallel", VParallel::new(&m, &s).map(|_| ()))
    }
}

fn value<T: Ring, const K: usize>(residual: impl Residual<K>, points: &[Point<T>; K]) -> T {
    residual.eval(points, &T::one())
}

struct Scribed;

impl Identity for Scribed {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let area = |p: &[TopView<T>; 3]| (&p[1] - &p[0]).det(&(&p[2] - &p[0]));
        // A vertex and three planes through it.
        let vertex = trial.free_point();
        let [a, b, c, _] = gradients(trial);
        let poles = [a, b, c].map(|g| Plane::through_point(&vertex, g).dual());
        let square = area(&poles.each_ref().map(Point::top_view)).square();
        let on_sigma = value(OnSigma, &[vertex]) * square;
        trial.zero("vertex and dual face", value(TouchesSigma, &poles) + on_sigma);
        // A face.
        let corners: [Point<T>; 3] = std::array::from_fn(|_| trial.free_point());
        let area = area(&corners.each_ref().map(Point::top_view));
        trial.nonzero(NO_VERTICAL_FACE, &area)?;
        let [a, b, c] = &corners;
        let plane = trial.defined(NO_VERTICAL_FACE, Plane::through(a, b, c).ok())?;
        let pole = trial.made_point(plane.dual());
        let on_sigma = value(OnSigma, std::array::from_ref(&pole)) * area.square();
        trial.zero("face and dual vertex", value(TouchesSigma, &corners) + on_sigma);
        // An edge, and another plane through it.
        let d = trial.free_point();
        let across = (&b.top_view() - &a.top_view()).det(&(&d.top_view() - &a.top_view()));
        trial.nonzero(NO_VERTICAL_FACE, &across)?;
        let other = trial.defined(NO_VERTICAL_FACE, Plane::through(a, b, &d).ok())?;
        let dual = [pole, other.dual()];
        let edge = [a.clone(), b.clone()];
        let first = value(EdgeTouchesSigma, &dual) * a.i_distance2(b);
        let second = value(EdgeTouchesSigma, &edge) * dual[0].i_distance2(&dual[1]);
        trial.zero("edge and dual edge", first + second);
        Ok(())
    }
}

struct RelativeNormals;

impl Identity for RelativeNormals {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let gradients = gradients(trial);
        let m = around_a_vertex(trial, Trial::parameter, &gradients)?;
        let s = around_a_vertex(trial, Trial::parameter, &gradients)?;
        let d = trial.free();
        let offset = trial.accepted("not f-parallel", FParallel::new(&m, &s))?.offset(&d);
        let from_origin = |p: &Point<T>| Vector3::new(p.x.clone(), p.y.clone(), p.z.clone());
        for end in [1, 3, 5, 7] {
            let [p, q] = [&m.points[4], &m.points[end]].map(Point::clone);
            let [r, t] = [&offset.points[4], &offset.points[end]].map(Point::clone);
            let t = trial.made_point(t);
            let [first, second] = [&s.points[4], &s.points[end]].map(from_origin);
            trial.zero("coplanar normals", Vector3::det(&(&q - &p), &first, &second));
            trial.zero("an edge and its offset", value(Coplanar, &[p, q, r, t]));
        }
        Ok(())
    }
}

/// Two triangles in horizontal planes: f-parallel, without parallel edges.
fn skew_normals() -> Result<String, String> {
    let triangle = |corners: [[i64; 3]; 3]| {
        let mut faces = FaceList::new();
        faces.push([0, 1, 2]);
        let point = |p: [i64; 3]| {
            let [x, y, z] = p.map(Rational::from_i64);
            Point::new(x, y, z)
        };
        Mesh::new(corners.map(point).to_vec(), faces).map_err(|e| e.to_string())
    };
    let m = triangle([[0, 0, 0], [1, 0, 0], [0, 1, 0]])?;
    let s = triangle([[0, 0, 1], [1, 1, 1], [0, 1, 1]])?;
    let offset = FParallel::new(&m, &s).map_err(|e| e.to_string())?.offset(&Rational::one());
    let [p, q, r, t] = [&m.points[0], &m.points[1], &offset.points[0], &offset.points[1]];
    let residual = value(Coplanar, &[p, q, r, t].map(Point::clone));
    if residual.is_zero() {
        Err("they are coplanar".into())
    } else {
        Ok(format!("volume: {residual}"))
    }
}
