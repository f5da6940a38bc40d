//! Sec. 4: Delaunay triangulations, and how near (22) comes to the curvatures of a surface (Fig. 11).

use super::packing::witnessed;
use super::{
    Claim, Control, Counterexample, Evidence, Experiment, Grade, Hypothesis, Identity, Run, Source,
    Stop, Trial,
};
use crate::check::Residual;
use crate::construct::{delaunay, lift};
use crate::mesh::{FaceList, HalfEdge, Mesh, VertexId};
use crate::net::i_circular::Concyclic;
use crate::pair::{Curvatures, VParallel, cotangent_weight, twice_area};
use crate::scalar::{Field, Rational, RationalField, Ring};
use crate::space::{Hessian, Point, TopView, Vector2};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "delaunay-lift",
        statement: "The lift of a triangulation to Σ is weakly convex along all interior edges iff its top \
                    view is a Delaunay triangulation; then D(s) of an interior vertex is the area of its Voronoi \
                    cell, and positive.",
        formula: "w_e(s) >= 0 for all interior edges  <=>  all circumcircles are empty",
        source: Source::Paper("Sec. 3.2 and 4, Fig. 11"),
        hypotheses: &[Hypothesis::silent(HULL)],
        said: Grade::Instances,
        argument: "A statement with signs: for instances. The other way round an edge is flipped, and the \
                   lift is not convex along it.",
        evidence: &[Evidence::experiment::<Lifted>("random points", &[6, 7, 8, 10])],
        controls: &[Control {
            without: HULL,
            shows: "three triangles around a boundary vertex, locally Delaunay, the third in the circle of the \
                    first",
            counterexample: Counterexample::Witness(|| {
                let points = [(0, 0), (10, 0), (5, 1), (-3, 1), (-2, -2)].map(|(x, y)| at(x, y));
                let mut faces = FaceList::new();
                (1..4).for_each(|j| faces.push([0, j, j + 1]));
                let mesh = Mesh::new(points.to_vec(), faces).map_err(|e| e.to_string())?;
                let weights = interior_edges(&mesh).map(|h| cotangent_weight(&mesh, h));
                if weights.into_iter().any(|w| w.is_none_or(|w| w < Rational::zero())) {
                    return Err("an edge is not locally Delaunay".into());
                }
                let [a, b, c, _, e] = points;
                let inside = Concyclic.eval(&[a, b, c, e], &Rational::one());
                if inside <= Rational::zero() {
                    return Err(format!("outside of the circle: {inside}"));
                }
                witnessed("all edges are convex, but a vertex lies in a circle", &inside)
            }),
        }],
    },
    Claim {
        id: "fig-11-accuracy",
        statement: "On a triangulation that is invariant under a lattice (22) is exact for quadratic \
                    functions and of second order for others; on the union-jack grid H is exact for them, and K is \
                    off by f_xy², up at valence 4 and down at valence 8.",
        formula: "K_h = K + h² (4 a02 a40 + 4 a04 a20 - 2 a11 (a13 + a22 + a31) - a12² - 2 a12 a21 - a21²) + O(h⁴)",
        source: Source::Paper("Sec. 4, Fig. 11"),
        hypotheses: &[Hypothesis::silent(SPANS), Hypothesis::silent(LATTICE)],
        said: Grade::Certified,
        argument: "Any lattice triangulation has the edges ±a, ±b, ±(a + b) for some basis. Curvatures at a \
                   vertex see finitely many samples, so the Taylor coefficients of their errors are those \
                   of polynomials: up to h² those of a quartic. At other stars nothing converges: see the control, \
                   which is the same at every scale.",
        evidence: &[
            Evidence::identity::<Lattice>("quadratics on any lattice", &[1], &[1]),
            Evidence::identity::<SecondOrder>("quartics on the square lattice", &[1], &[1]),
            Evidence::identity::<UnionJack>("quadratics on the union-jack grid", &[4, 8], &[4, 8]),
            Evidence::identity::<AnyScale>("one star that is no lattice star", &[1], &[1]),
        ],
        controls: &[
            Control {
                without: SPANS,
                shows: "a lattice of one direction",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 1,
                    unknowns: &["0", "0", "1", "0", "2", "0"],
                    constrained: &[],
                },
            },
            Control {
                without: LATTICE,
                shows: "the star (2, 0), (1, 1), (-1, 1), (-2, -1), (1, -2) with z = x², K = 0",
                counterexample: Counterexample::Witness(|| {
                    let ring = IRREGULAR
                        .map(|(x, y)| Vector2::new(Rational::from_i64(x), Rational::from_i64(y)));
                    let centre = TopView::new(Rational::zero(), Rational::zero());
                    let mesh =
                        star(&centre, &ring, |at| at.x.square()).map_err(|e| e.to_string())?;
                    let image = lift(&mesh);
                    let pair = VParallel::new(&mesh, &image).map_err(|e| format!("{e:?}"))?;
                    let found = pair.vertex_curvatures(VertexId(0)).map_err(|e| e.to_string())?;
                    let twice = found.mean * Rational::from_i64(2);
                    if twice == Rational::from_i64(2) {
                        return Err("2H = 2".into());
                    }
                    witnessed(&format!("2H = {twice} in place of 2, and K"), &found.gauss)
                }),
            },
        ],
    },
];

const HULL: &str = "the triangulation covers the convex hull of its points";
const SPANS: &str = "the lattice vectors are not parallel";
const LATTICE: &str = "the triangulation is invariant under a lattice";
const IRREGULAR: [(i64, i64); 5] = [(2, 0), (1, 1), (-1, 1), (-2, -1), (1, -2)];

fn at(x: i64, y: i64) -> Point<Rational> {
    Point::new(x, y, 0).map(|&c| Rational::from_i64(c))
}

fn interior_edges<T>(mesh: &Mesh<T>) -> impl Iterator<Item = HalfEdge> {
    mesh.topology.edges().filter(|&h| mesh.topology.twin(h).is_some())
}

/// The star of triangles around a point, over these neighbours, on a graph.
fn star<T: Field>(
    centre: &TopView<T>,
    ring: &[Vector2<T>],
    height: impl Fn(&TopView<T>) -> T,
) -> Result<Mesh<T>, crate::mesh::TopologyError> {
    let neighbours = ring.iter().map(|edge| centre + edge);
    let views = std::iter::once(centre.clone()).chain(neighbours);
    let points = views.map(|view| view.at_height(height(&view))).collect();
    let k = ring.len();
    let mut faces = FaceList::new();
    for j in 0..k {
        faces.push([0, 1 + j, 1 + (j + 1) % k].map(|v| v as u32));
    }
    Mesh::new(points, faces)
}

/// (22) on a star whose image is its lift, where the triangles are none over segments.
fn curvatures<T: Field>(
    trial: &mut Trial<T>,
    mesh: &Mesh<T>,
    spans: &'static str,
) -> Result<Curvatures<T>, Stop> {
    trial.exhibit("M", mesh);
    let image = lift(mesh);
    let pair = trial.defined(spans, VParallel::new(mesh, &image).ok())?;
    trial.defined(spans, pair.vertex_curvatures(VertexId(0)).ok())
}

/// A polynomial with free coefficients `a_ij` of degree n.
struct Free<T> {
    terms: Vec<(usize, usize, T)>,
}

impl<T: Field> Free<T> {
    fn of_degree(trial: &mut Trial<T>, n: usize) -> Self {
        let exponents = (0..=n).flat_map(|i| (0..=n - i).map(move |j| (i, j)));
        Free { terms: exponents.map(|(i, j)| (i, j, trial.free())).collect() }
    }

    fn coefficient(&self, i: usize, j: usize) -> &T {
        let found = self.terms.iter().find(|term| (term.0, term.1) == (i, j));
        // All up to the degree are there.
        &found.unwrap_or(&self.terms[0]).2
    }

    fn at(&self, at: &TopView<T>) -> T {
        let power = |x: &T, n: usize| (0..n).fold(T::one(), |product, _| product * x);
        self.terms
            .iter()
            .fold(T::zero(), |sum, (i, j, a)| sum + a * power(&at.x, *i) * power(&at.y, *j))
    }

    /// The second derivatives of a quadratic polynomial.
    fn hessian(&self) -> Hessian<T> {
        let twice = |i, j| self.coefficient(i, j) * T::from_i64(2);
        Hessian { xx: twice(2, 0), xy: self.coefficient(1, 1).clone(), yy: twice(0, 2) }
    }
}

struct Lattice;

impl Identity for Lattice {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let centre = TopView::new(trial.free(), trial.free());
        let (a, b) = (trial.free_vector2(), trial.free_vector2());
        trial.nonzero(SPANS, &a.det(&b))?;
        let f = Free::of_degree(trial, 2);
        let c = &a + &b;
        let ring = [a.clone(), c.clone(), b.clone(), -&a, -&c, -&b];
        let mesh = trial.accepted("a star", star(&centre, &ring, |at| f.at(at)))?;
        let found = curvatures(trial, &mesh, SPANS)?;
        trial.show("H", &found.mean);
        trial.show("K", &found.gauss);
        let hessian = f.hessian();
        trial.equal("2H = Δf", &(found.mean * T::from_i64(2)), &hessian.trace());
        trial.equal("K = det", &found.gauss, &hessian.det());
        Ok(())
    }
}

struct SecondOrder;

impl Identity for SecondOrder {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let h = trial.free();
        trial.parameter("the mesh size is not 0", &h)?;
        let f = Free::of_degree(trial, 4);
        let origin = TopView::new(T::zero(), T::zero());
        let mut at_scale = |h: &T| {
            let ring = [(1, 0), (1, 1), (0, 1), (-1, 0), (-1, -1), (0, -1)];
            let ring = ring.map(|(x, y)| Vector2::new(T::from_i64(x) * h, T::from_i64(y) * h));
            let mesh = trial.accepted("a star", star(&origin, &ring, |at| f.at(at)))?;
            curvatures(trial, &mesh, SPANS)
        };
        let (found, unit) = (at_scale(&h)?, at_scale(&T::one())?);
        let a = |i, j| f.coefficient(i, j);
        let (two, four, h2) = (T::from_i64(2), T::from_i64(4), h.square());
        let mean = a(2, 0) + a(0, 2) + (a(4, 0) + a(0, 4)) * &h2;
        trial.equal("H", &found.mean, &mean);
        let limit = &four * a(2, 0) * a(0, 2) - a(1, 1).square();
        let second = &four * a(0, 2) * a(4, 0) + &four * a(0, 4) * a(2, 0)
            - &two * a(1, 1) * (a(1, 3) + a(2, 2) + a(3, 1))
            - a(1, 2).square()
            - &two * a(1, 2) * a(2, 1)
            - a(2, 1).square();
        // What is left at h = 1 is the coefficient of h⁴.
        let fourth = unit.gauss - &limit - &second;
        trial.equal("K", &found.gauss, &(limit + second * &h2 + fourth * h2.square()));
        Ok(())
    }
}

struct UnionJack;

impl Identity for UnionJack {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let h = trial.free();
        trial.parameter("the mesh size is not 0", &h)?;
        let centre = TopView::new(trial.free(), trial.free());
        let f = Free::of_degree(trial, 2);
        let all = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)];
        let valence = trial.size();
        let ring = all.into_iter().step_by(8 / valence.clamp(1, 8));
        let ring: Vec<_> =
            ring.map(|(x, y)| Vector2::new(T::from_i64(x) * &h, T::from_i64(y) * &h)).collect();
        let mesh = trial.accepted("a star", star(&centre, &ring, |at| f.at(at)))?;
        let found = curvatures(trial, &mesh, SPANS)?;
        let hessian = f.hessian();
        trial.equal("2H = Δf", &(found.mean * T::from_i64(2)), &hessian.trace());
        let error = if valence == 4 { hessian.xy.square() } else { -hessian.xy.square() };
        trial.show("error of K", &error);
        trial.equal("K is off by f_xy²", &found.gauss, &(hessian.det() + error));
        Ok(())
    }
}

struct AnyScale;

impl Identity for AnyScale {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let h = trial.free();
        trial.parameter("the mesh size is not 0", &h)?;
        let ring = IRREGULAR.map(|(x, y)| Vector2::new(T::from_i64(x) * &h, T::from_i64(y) * &h));
        let origin = TopView::new(T::zero(), T::zero());
        let mesh = trial.accepted("a star", star(&origin, &ring, |at| at.x.square()))?;
        let found = curvatures(trial, &mesh, SPANS)?;
        trial.equal("2H", &(found.mean * T::from_i64(2)), &T::from_ratio(68, 31));
        trial.equal("K", &found.gauss, &T::from_ratio(412, 775));
        Ok(())
    }
}

struct Lifted;

/// 0 where something holds.
fn unless<T: Ring>(holds: bool) -> T {
    if holds { T::zero() } else { T::one() }
}

impl Experiment for Lifted {
    fn run<T: RationalField>(trial: &mut Trial<T>) -> Run {
        let points: Vec<Point<T>> = (0..trial.size())
            .map(|_| TopView::new(trial.free(), trial.free()).at_height(T::zero()))
            .collect();
        // Equal points, and points on a line, have no triangulation.
        let plain = points.iter().map(|p| p.map(T::convert::<Rational>));
        let found = delaunay(plain.collect()).ok();
        let found = trial.defined(HULL, found)?;
        let mesh = Mesh { topology: found.topology, points, data: Default::default() };
        trial.exhibit("M", &mesh);
        let weight = |mesh: &Mesh<T>, h| cotangent_weight(mesh, h).filter(|w| *w >= T::zero());
        for h in interior_edges(&mesh) {
            trial.zero("convex along an edge", unless(weight(&mesh, h).is_some()));
            let corners = |h| mesh.topology.half_edges(mesh.topology.face_at(h));
            for face in [Some(h), mesh.topology.twin(h)].into_iter().flatten() {
                let [a, b, c] = std::array::from_fn(|n| {
                    let corner = corners(face).nth(n).unwrap_or(face);
                    mesh.points[mesh.topology.origin(corner).index()].clone()
                });
                let empty = mesh.points.iter().all(|p| {
                    let at = [a.clone(), b.clone(), c.clone(), p.clone()];
                    Concyclic.eval(&at, &T::one()) <= T::zero()
                });
                trial.zero("an empty circle", unless(empty));
            }
        }
        // With an edge flipped, of which the circles are not the same, neither holds.
        for h in interior_edges(&mesh) {
            let Some(flipped) = flipped(&mesh, h) else { continue };
            let same = cotangent_weight(&mesh, h).is_none_or(|w| w.is_zero());
            let convex = interior_edges(&flipped).all(|h| weight(&flipped, h).is_some());
            trial.zero("a flipped edge", unless(same || !convex));
        }
        let image = lift(&mesh);
        let pair = trial.accepted("v-parallel", VParallel::new(&mesh, &image))?;
        for v in mesh.topology.interior_vertices() {
            let area = trial.accepted("interior", pair.vertex_forms(v))?.image_measure();
            trial.show("D(s)", &area);
            trial.zero("D(s) > 0", unless(area > T::zero()));
            trial.equal("the area of the Voronoi cell", &area, &voronoi_area(&mesh, v));
        }
        Ok(())
    }
}

/// The mesh with the other diagonal of the two triangles at an edge, where they form a convex quad.
fn flipped<T: RationalField>(mesh: &Mesh<T>, h: HalfEdge) -> Option<Mesh<T>> {
    let topology = &mesh.topology;
    let twin = topology.twin(h)?;
    let apex = |h| topology.target(topology.next(h));
    let [a, b] = [topology.origin(h), topology.target(h)];
    let [left, right] = [apex(h), apex(twin)];
    let triangles = [[left, right, b], [right, left, a]];
    let area = |t: &[VertexId; 3]| twice_area(&t.map(|v| mesh.points[v.index()].top_view()));
    if triangles.iter().any(|t| area(t) <= T::zero()) {
        return None;
    }
    let mut faces = FaceList::new();
    let others = [topology.face_at(h), topology.face_at(twin)];
    for face in topology.faces().filter(|face| !others.contains(face)) {
        faces.push(topology.face(face).iter().map(|v| v.0));
    }
    triangles.into_iter().for_each(|t| faces.push(t.map(|v| v.0)));
    Mesh::new(mesh.points.clone(), faces).ok()
}

/// The area of the points that are not nearer to another point: a square around all, cut off by one
/// bisector after the other. Cells of interior vertices are bounded, and lie in a square of
/// some size.
fn voronoi_area<T: RationalField>(mesh: &Mesh<T>, v: VertexId) -> T {
    let site = mesh.points[v.index()].top_view();
    // Larger than the circles of all triangles.
    let size = T::from_i64(1 << 62);
    let square = [(-1, -1), (1, -1), (1, 1), (-1, 1)];
    let corner = |(x, y): (i64, i64)| TopView::new(T::from_i64(x) * &size, T::from_i64(y) * &size);
    let mut cell: Vec<TopView<T>> = square.map(corner).to_vec();
    for point in &mesh.points {
        let other = point.top_view();
        // Positive on the side of the site.
        let side = |p: &TopView<T>| p.distance2(&other) - p.distance2(&site);
        let mut rest = Vec::new();
        for (n, p) in cell.iter().enumerate() {
            let q = &cell[(n + 1) % cell.len()];
            let (at, next) = (side(p), side(q));
            if at >= T::zero() {
                rest.push(p.clone());
            }
            if (at > T::zero() && next < T::zero()) || (at < T::zero() && next > T::zero()) {
                let along = at.try_div(&(&at - &next)).unwrap_or_else(T::zero);
                rest.push(p + &(q - p).scaled(&along));
            }
        }
        cell = rest;
    }
    twice_area(&cell) * T::from_ratio(1, 2)
}
