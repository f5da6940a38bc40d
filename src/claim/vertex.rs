//! Sec. 4, curvatures at vertices: duality with faces, edges, offsets, the cotangent Laplacian.

use super::packing::face_at;
use super::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Stop, Trial,
};
use crate::construct::{lift, metric_dual};
use crate::mesh::{FaceId, FaceList, Mesh, TopologyError, VertexId};
use crate::pair::{FParallel, Parallel, Ray, VParallel, cotangent_weight, star_forms, twice_area};
use crate::scalar::Field;
use crate::space::{Circle, Gradient, Plane, Point, TopView, Vector2};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-21-22-duality",
        statement: "The measures of a vertex of a v-parallel pair (M, S) are the areas of the dual face of the \
                    f-parallel pair (M*, S*), so its curvatures are those of that face combined by (11).",
        formula: "D(v) = area(v*),  D(v, s) = area(v*, s*),  H(v) = H(v*)/K(v*),  K(v) = 1/K(v*)",
        source: Source::Paper("Sec. 4, (21), (22)"),
        hypotheses: &[Hypothesis::silent(MEASURES)],
        said: Grade::Decided,
        argument: "For all k: the gradients around the vertex are the top views of the corners of the \
                   dual face, one by one, and both sides are the same form of them. The faces around the \
                   vertex are given by their planes; their other corners do not enter.",
        evidence: &[Evidence::identity::<DualForms>(
            "a vertex of k faces and the face dual to it, by metric duality",
            K_GONS,
            &[3, 4, 5, 8],
        )],
        controls: &[Control {
            without: MEASURES,
            shows: "where the gradients form a bow-tie there are no curvatures",
            counterexample: Counterexample::Unknowns {
                evidence: 0,
                size: 4,
                unknowns: &["0", "0", "1", "1", "1", "0", "0", "1", "1", "1", "1", "1", "1", "1"],
                constrained: &[],
            },
        }],
    },
    Claim {
        id: "eq-22-cotan",
        statement: "With the lift to Σ as Gauss image, the mixed measure of a vertex of a triangle mesh is the \
                    cotangent Laplacian of the heights, and the measure of its image is the signed area of \
                    the polygon of circumcentres: 2H is the cotangent Laplacian over that area, on obtuse \
                    and non-Delaunay stars, too.",
        formula: "2 D(v, s) = Σ ½ (cot α_j + cot β_j) (f_j - f_v),  D(s) = area of the circumcentres",
        source: Source::Paper("Sec. 4, (22), Fig. 11"),
        hypotheses: &[Hypothesis::silent(NOT_VERTICAL), Hypothesis::silent(IMAGE_MEASURE)],
        said: Grade::Decided,
        argument: "For all k: both sides are sums of terms that belong to two consecutive triangles, \
                   and such a term knows nothing of k.",
        evidence: &[
            Evidence::identity::<Cotangents>("a star of k triangles", &[3, 4], &[3, 4, 5, 6, 8]),
            Evidence::identity::<CentredCotangents>(
                "a star given by its circumcentres",
                K_GONS,
                &[3, 4, 5, 8],
            ),
        ],
        controls: &[
            Control {
                without: NOT_VERTICAL,
                shows: "a triangle over a segment",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 3,
                    unknowns: &["0", "0", "0", "1", "0", "0", "2", "0", "1", "0", "1", "0"],
                    constrained: &[],
                },
            },
            Control {
                without: IMAGE_MEASURE,
                shows: "a vertex on one circle with its neighbours has D(s) = 0",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 3,
                    unknowns: &["1", "0", "0", "0", "1", "0", "-1", "0", "1", "0", "-1", "0"],
                    constrained: &[],
                },
            },
        ],
    },
    Claim {
        id: "vertex-stress",
        statement: "The weights of the edges at a vertex of a v-parallel pair (jump of the gradient over \
                    length) are in equilibrium; the mixed measure is the Laplacian of the heights of one \
                    mesh with the weights of the other; and the weights are the derivatives of the measure \
                    by the heights.",
        formula: "Σ w_j e_j = 0,  2 D(v, s) = Σ w_j(f) (g_j - g_v) = Σ w_j(g) (f_j - f_v),  ∂D(v)/∂f_j = w_j",
        source: Source::Ours,
        hypotheses: &[Hypothesis::stated(NOT_VERTICAL)],
        said: Grade::Decided,
        argument: "For all k as in eq-22-cotan; the measure is quadratic in the heights, so that its central \
                   difference is its derivative at any step.",
        evidence: &[
            Evidence::identity::<Stress>("any two v-parallel stars", &[3, 4], &[3, 4, 5, 6, 8]),
            Evidence::identity::<DualStress>("two stars given by gradients", K_GONS, &[3, 4, 5, 8]),
        ],
        controls: &[Control {
            without: NOT_VERTICAL,
            shows: "a triangle over a segment",
            counterexample: Counterexample::Unknowns {
                evidence: 0,
                size: 3,
                unknowns: &["0", "0", "0", "1", "0", "0", "2", "0", "1", "0", "1", "0"],
                constrained: &[],
            },
        }],
    },
    Claim {
        id: "v-offset",
        statement: "Moving the vertices of M by d times the heights of a v-parallel S changes the curvatures \
                    at vertices polynomially; with constant H, 2dH + K is that of a mesh with constant K.",
        formula: "H(v^d) = H + d,  K(v^d) = K + 2dH + d²",
        source: Source::Ours,
        hypotheses: &[Hypothesis::stated(NOT_VERTICAL), Hypothesis::stated(IMAGE_MEASURE)],
        said: Grade::Decided,
        argument: "For all k: gradients are linear in the heights, and by eq-15-16-form the measures of the sum \
                   are D(v) + 2d D(v, s) + d² D(s).",
        evidence: &[
            Evidence::identity::<VOffset>("any two v-parallel stars", &[3, 4], &[3, 4, 5, 6, 8]),
            Evidence::identity::<DualVOffset>(
                "two stars given by gradients",
                K_GONS,
                &[3, 4, 5, 8],
            ),
        ],
        controls: &[
            Control {
                without: NOT_VERTICAL,
                shows: "a triangle over a segment",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 3,
                    unknowns: &["0", "0", "0", "1", "0", "0", "2", "0", "1", "0", "1", "0"],
                    constrained: &[],
                },
            },
            Control {
                without: IMAGE_MEASURE,
                shows: "over a plane there are no curvatures",
                counterexample: Counterexample::Unknowns {
                    evidence: 0,
                    size: 3,
                    unknowns: &["0", "0", "0", "1", "0", "0", "0", "1", "1", "-1", "-1", "1"],
                    constrained: &[],
                },
            },
        ],
    },
    Claim {
        id: "edge-curvatures",
        statement: "Areas of parallel faces are sums over their edges and the ratios κ of edges of S to \
                    those of M; for a quad H and K are means of those of two opposite corners, weighted by \
                    their triangles, whichever two are taken. Under duality κ becomes 1/κ.",
        formula: "2 area(F, S) = Σ ½ (κ_i + κ_j) det(e_i, e_j),  2 area(S) = Σ κ_i κ_j det(e_i, e_j),  i < j < k - 1",
        source: Source::Ours,
        hypotheses: &[Hypothesis::stated(EDGES)],
        said: Grade::Decided,
        argument: "For all k: the corner i of a polygon is the sum of its first i edges, and (15), (16) are \
                   bilinear in the corners.",
        evidence: &[Evidence::identity::<EdgeSums>(
            "parallel k-gons in space",
            K_GONS,
            &[3, 4, 5, 8],
        )],
        controls: &[Control {
            without: EDGES,
            shows: "an edge of length 0 has no curvature",
            counterexample: Counterexample::Unknowns {
                evidence: 0,
                size: 4,
                unknowns: &["0", "0", "0", "0", "1", "0", "0", "1", "1", "1"],
                constrained: &[],
            },
        }],
    },
];

const K_GONS: &[usize] = &[3, 4, 5, 6, 7, 8];
const DUAL_EDGES: &str = "consecutive faces around the vertex are not coplanar, in M and in S";
const MEASURES: &str = "D(v) != 0 and D(s) != 0";
const NOT_VERTICAL: &str = "no face of the star is vertical";
const IMAGE_MEASURE: &str = "D(s) != 0";
const EDGES: &str = "no edge of M has length 0";
const CLOSING: &str = "the last two edges are not parallel";

/// A star of k triangles around vertex 0, with the top views and heights of M free.
fn triangles<T: Field>(trial: &mut Trial<T>) -> Result<Mesh<T>, Stop> {
    let k = trial.size();
    let mut points: Vec<Point<T>> = vec![trial.free_point()];
    points.extend((0..k).map(|_| trial.free_point()));
    let mut faces = FaceList::new();
    for j in 0..k {
        faces.push([0, 1 + j, 1 + (j + 1) % k].map(|v| v as u32));
    }
    let mesh = trial.accepted("a star", Mesh::new(points, faces))?;
    not_vertical(trial, &mesh)?;
    trial.exhibit("M", &mesh);
    Ok(mesh)
}

/// The same top views with other heights.
fn at_heights<T: Field>(mesh: &Mesh<T>, height: impl Fn(usize) -> T) -> Mesh<T> {
    let points = mesh.points.iter().enumerate();
    let points = points.map(|(n, p)| p.top_view().at_height(height(n))).collect();
    Mesh { points, ..mesh.clone() }
}

struct Cotangents;

impl Identity for Cotangents {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let mesh = triangles(trial)?;
        cotangents(trial, &mesh)
    }
}

struct CentredCotangents;

impl Identity for CentredCotangents {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let k = trial.size();
        let polygons = ParallelPolygons::free(trial)?;
        let centres = &polygons.f;
        let mut reach = Vec::new();
        for j in 0..k {
            let (a, b) = (centres[j].position(), centres[(j + 1) % k].position());
            let length2 = (&b + &-&a).length2();
            trial.parameter("consecutive circumcentres differ", &length2)?;
            let factor = (T::from_i64(2) * a.det(&b)).try_div(&length2);
            let factor = trial.defined("consecutive circumcentres differ", factor)?;
            trial.parameter("the neighbours are not over the vertex", &factor)?;
            // The neighbour is the vertex, reflected at the line of the centres.
            reach.push(-factor);
        }
        let star = star_of(&polygons.s, centres, &reach);
        let mesh = trial.accepted("a star", star)?;
        not_vertical(trial, &mesh)?;
        let image = trial.accepted("a star", star_of(centres, centres, &reach))?;
        for (p, q) in lift(&mesh).points.iter().zip(&image.points) {
            trial.equal_points("the lift", p, q);
        }
        cotangents(trial, &mesh)
    }
}

fn not_vertical<T: Field>(trial: &mut Trial<T>, mesh: &Mesh<T>) -> Run {
    let k = mesh.points.len() - 1;
    let view = |j: usize| &mesh.points[1 + j % k].top_view() - &mesh.points[0].top_view();
    for j in 0..k {
        trial.nonzero(NOT_VERTICAL, &view(j).det(&view(j + 1)))?;
        trial.parameter("no edge of the star has length 0", &view(j).length2())?;
    }
    Ok(())
}

/// The star over its vertex at the origin that has these gradients: neighbour j lies over the line
/// where the faces j and j + 1 meet, which is that of all stars with parallel polygons of gradients.
fn star_of<T: Field>(
    gradients: &[TopView<T>],
    polygon: &[TopView<T>],
    reach: &[T],
) -> Result<Mesh<T>, TopologyError> {
    let k = gradients.len();
    let mut points = vec![Point::new(T::zero(), T::zero(), T::zero())];
    for j in 0..k {
        let at = (&polygon[(j + 1) % k] - &polygon[j]).turned().scaled(&reach[j]);
        let p = Gradient::new(gradients[j].x.clone(), gradients[j].y.clone());
        points.push(Point::new(at.x.clone(), at.y.clone(), p.along(&at)));
    }
    let mut faces = FaceList::new();
    for j in 0..k {
        faces.push([0, 1 + (j + k - 1) % k, 1 + j].map(|v| v as u32));
    }
    Mesh::new(points, faces)
}

/// Two v-parallel stars with parallel polygons of gradients.
fn dual_stars<T: Field>(trial: &mut Trial<T>) -> Result<[Mesh<T>; 2], Stop> {
    let k = trial.size();
    let polygons = ParallelPolygons::free(trial)?;
    let reach: Vec<T> = (0..k).map(|_| trial.free()).collect();
    let edge = |j: usize| &polygons.f[(j + 1) % k] - &polygons.f[j];
    for (j, factor) in reach.iter().enumerate() {
        trial.parameter("the neighbours are not over the vertex", factor)?;
        trial.parameter(DUAL_EDGES, &edge(j).length2())?;
        trial.parameter(DUAL_EDGES, &polygons.factors[j])?;
        trial.parameter(DUAL_EDGES, &edge((j + k - 1) % k).det(&edge(j)))?;
    }
    let m = trial.accepted("M", star_of(&polygons.f, &polygons.f, &reach))?;
    let s = trial.accepted("S", star_of(&polygons.s, &polygons.f, &reach))?;
    not_vertical(trial, &m)?;
    Ok([m, s])
}

fn cotangents<T: Field>(trial: &mut Trial<T>, mesh: &Mesh<T>) -> Run {
    let image = lift(mesh);
    let heights: Vec<T> = image.points.iter().map(|p| trial.made(p.z.clone())).collect();
    let image = at_heights(&image, |n| heights[n].clone());
    let pair = trial.defined(NOT_VERTICAL, VParallel::new(mesh, &image).ok())?;
    let v = VertexId(0);
    let forms = trial.accepted("interior", pair.vertex_forms(v))?;
    let twice = forms.mixed_measure() * T::from_i64(2);
    let star = trial.accepted("a star", pair.star(v))?;
    let mut laplacian = T::zero();
    for edge in &star {
        let weight = cotangent_weight(mesh, edge.half_edge);
        let weight = trial.defined(NOT_VERTICAL, weight)?;
        trial.equal("½ (cot α + cot β)", &edge.weight[1], &weight);
        laplacian += &(weight * &edge.rise[0]);
    }
    trial.show("2 D(v, s)", &twice);
    trial.equal("cotangent Laplacian", &laplacian, &twice);
    let found = trial.accepted("a star", pair.laplacian(v))?;
    trial.equal("Laplacian", &found, &twice);
    let hinge = trial.accepted("a star", pair.hinge(v))?;
    trial.equal("hinges", &hinge, &(&twice * T::from_i64(2)));
    let mut centres = Vec::new();
    for face in mesh.topology.star(v).map(|h| mesh.topology.face_at(h)) {
        let corners = mesh.topology.face(face).iter();
        let views: Vec<_> = corners.map(|v| mesh.points[v.index()].top_view()).collect();
        let circle = Circle::through(&views[0], &views[1], &views[2]).ok();
        centres.push(trial.defined(NOT_VERTICAL, circle)?.centre);
    }
    let area = forms.image_measure();
    trial.show("D(s)", &area);
    trial.equal("area of the circumcentres", &twice_area(&centres), &(&area * T::from_i64(2)));
    trial.nonzero(IMAGE_MEASURE, &area)?;
    let curvatures = trial.defined(IMAGE_MEASURE, pair.vertex_curvatures(v).ok())?;
    trial.equal("2H", &(curvatures.mean * area * T::from_i64(2)), &laplacian);
    Ok(())
}

struct Stress;

impl Identity for Stress {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let mesh = triangles(trial)?;
        let other: Vec<T> = mesh.points.iter().map(|_| trial.free()).collect();
        let image = at_heights(&mesh, |n| other[n].clone());
        stress(trial, &mesh, &image)?;
        derivatives(trial, &mesh, &image)
    }
}

struct DualStress;

impl Identity for DualStress {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let [mesh, image] = dual_stars(trial)?;
        stress(trial, &mesh, &image)
    }
}

fn stress<T: Field>(trial: &mut Trial<T>, mesh: &Mesh<T>, image: &Mesh<T>) -> Run {
    let pair = trial.defined(NOT_VERTICAL, VParallel::new(mesh, image).ok())?;
    let v = VertexId(0);
    let forms = trial.accepted("interior", pair.vertex_forms(v))?;
    let twice = forms.mixed_measure() * T::from_i64(2);
    let load = trial.accepted("a star", pair.load(v))?;
    trial.equal("load", &load, &twice);
    let laplacian = trial.accepted("a star", pair.laplacian(v))?;
    trial.equal("Laplacian", &laplacian, &twice);
    let star = trial.accepted("a star", pair.star(v))?;
    for which in [0, 1] {
        let sum = star.iter().fold(Vector2::new(T::zero(), T::zero()), |sum, edge| {
            &sum + &edge.edge.scaled(&edge.weight[which])
        });
        trial.zero("equilibrium", sum.x);
        trial.zero("equilibrium", sum.y);
    }
    Ok(())
}

/// The forms without a division, and the derivatives of the measure.
fn derivatives<T: Field>(trial: &mut Trial<T>, mesh: &Mesh<T>, image: &Mesh<T>) -> Run {
    let pair = trial.defined(NOT_VERTICAL, VParallel::new(mesh, image).ok())?;
    let v = VertexId(0);
    let forms = trial.accepted("interior", pair.vertex_forms(v))?;
    let star = trial.accepted("a star", pair.star(v))?;
    let rays: Vec<_> =
        star.iter().map(|e| Ray { edge: e.edge.clone(), rise: e.rise.clone() }).collect();
    let (cleared, divisor) = trial.defined(NOT_VERTICAL, star_forms(&rays))?;
    trial.equal("4 D(v)", &cleared.first, &(&forms.four.first * &divisor));
    trial.equal("4 D(v, s)", &cleared.mixed, &(&forms.four.mixed * &divisor));
    trial.equal("4 D(s)", &cleared.second, &(&forms.four.second * &divisor));
    // Moving the vertex itself, and one neighbour.
    for (moved, weight) in trial.accepted("a star", pair.jacobian_row(v))?.into_iter().take(2) {
        let step = |by: &T| {
            at_heights(mesh, |n| {
                let z = mesh.points[n].z.clone();
                if n == moved.index() { z + by } else { z }
            })
        };
        let (up, down) = (step(&T::one()), step(&T::from_i64(-1)));
        let [up, down] = [&up, &down].map(|m| VParallel::new(m, image).ok());
        let up = trial.defined(NOT_VERTICAL, up)?.vertex_forms(v);
        let down = trial.defined(NOT_VERTICAL, down)?.vertex_forms(v);
        let (up, down) = (trial.accepted("interior", up)?, trial.accepted("interior", down)?);
        let difference = up.measure() - down.measure();
        trial.equal("derivative of D(v)", &difference, &(weight * T::from_i64(2)));
    }
    Ok(())
}

struct VOffset;

impl Identity for VOffset {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let mesh = triangles(trial)?;
        let other: Vec<T> = mesh.points.iter().map(|_| trial.free()).collect();
        let image = at_heights(&mesh, |n| other[n].clone());
        v_offset(trial, &mesh, &image)
    }
}

struct DualVOffset;

impl Identity for DualVOffset {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let [mesh, image] = dual_stars(trial)?;
        v_offset(trial, &mesh, &image)
    }
}

fn v_offset<T: Field>(trial: &mut Trial<T>, mesh: &Mesh<T>, image: &Mesh<T>) -> Run {
    let d = trial.free();
    let pair = trial.defined(NOT_VERTICAL, VParallel::new(mesh, image).ok())?;
    let v = VertexId(0);
    let forms = trial.accepted("interior", pair.vertex_forms(v))?;
    trial.nonzero(IMAGE_MEASURE, &forms.image_measure())?;
    let curvatures = trial.defined(IMAGE_MEASURE, pair.vertex_curvatures(v).ok())?;
    let offset = trial.made_mesh(pair.offset(&d));
    let moved = trial.accepted("v-parallel", VParallel::new(&offset, image))?;
    let found = trial.defined(IMAGE_MEASURE, moved.vertex_curvatures(v).ok())?;
    trial.show("H", &found.mean);
    trial.show("K", &found.gauss);
    let law = curvatures.v_offset(&d);
    trial.equal("H", &found.mean, &law.mean);
    trial.equal("K", &found.gauss, &law.gauss);
    trial.equal("H + d", &found.mean, &(&curvatures.mean + &d));
    let gauss = &curvatures.gauss + T::from_i64(2) * &d * &curvatures.mean + d.square();
    trial.equal("K + 2dH + d²", &found.gauss, &gauss);
    Ok(())
}

/// Corners of a polygon F in the plane, and the factors of its edges in a parallel polygon S.
struct ParallelPolygons<T> {
    f: Vec<TopView<T>>,
    s: Vec<TopView<T>>,
    factors: Vec<T>,
}

impl<T: Field> ParallelPolygons<T> {
    fn free(trial: &mut Trial<T>) -> Result<Self, Stop> {
        let k = trial.size();
        let f: Vec<_> = (0..k).map(|_| TopView::new(trial.free(), trial.free())).collect();
        let edge = |j: usize| &f[(j + 1) % k] - &f[j];
        let mut factors: Vec<T> = (0..k - 2).map(|_| trial.free()).collect();
        let mut s = vec![TopView::new(T::zero(), T::zero())];
        for (j, factor) in factors.iter().enumerate() {
            s.push(&s[j] + &edge(j).scaled(factor));
        }
        if k == 3 {
            // Triangles are parallel iff they are similar.
            factors = vec![factors[0].clone(); 3];
            s.push(&s[1] + &edge(1).scaled(&factors[1]));
            return Ok(ParallelPolygons { f, s, factors });
        }
        let (last, back) = (edge(k - 2), edge(k - 1));
        let sine = last.det(&back);
        trial.parameter(CLOSING, &sine)?;
        let gap = &s[0] - &s[k - 2];
        for factor in [gap.det(&back).try_div(&sine), last.det(&gap).try_div(&sine)] {
            factors.push(trial.defined(CLOSING, factor)?);
        }
        s.push(&s[k - 2] + &last.scaled(&factors[k - 2]));
        Ok(ParallelPolygons { f, s, factors })
    }
}

struct EdgeSums;

impl Identity for EdgeSums {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let k = trial.size();
        let polygons = ParallelPolygons::free(trial)?;
        let plane = Plane::new(Gradient::new(trial.free(), trial.free()), T::zero());
        let edge = |j: usize| &polygons.f[(j + 1) % k] - &polygons.f[j];
        for j in 0..k {
            let e = edge(j);
            let length2 = e.length2() + plane.gradient.along(&e).square();
            trial.nonzero(EDGES, &length2)?;
        }
        let mesh =
            |views: &[TopView<T>]| face_at(views.iter().map(|v| plane.point_at(v)).collect());
        let m = trial.accepted("F", mesh(&polygons.f))?;
        let s = trial.accepted("S", mesh(&polygons.s))?;
        trial.exhibit("F", &m);
        trial.exhibit("S", &s);
        let s = trial.made_mesh(s);
        let pair = trial.accepted("parallel", Parallel::new(&m, &s))?;
        let mut curvatures = Vec::new();
        for (h, factor) in m.topology.half_edges(FaceId(0)).zip(&polygons.factors) {
            let curvature = trial.defined(EDGES, pair.edge_curvature(h).ok())?;
            trial.equal("κ", &curvature, factor);
            curvatures.push(curvature);
        }
        let (mut first, mut mixed, mut second) = (T::zero(), T::zero(), T::zero());
        for j in 1..k - 1 {
            for i in 0..j {
                let area = edge(i).det(&edge(j));
                let (a, b) = (&curvatures[i], &curvatures[j]);
                first += &area;
                mixed += &(&area * (a + b) * T::from_ratio(1, 2));
                second += &(area * a * b);
            }
        }
        let forms = crate::pair::Forms::of(&polygons.f, &views(&s));
        let half = T::from_ratio(1, 2);
        trial.equal("2 area(F)", &first, &(&forms.first * &half));
        trial.equal("2 area(F, S)", &mixed, &(&forms.mixed * &half));
        trial.equal("2 area(S)", &second, &(&forms.second * &half));
        if k == 4 {
            for start in [1, 2] {
                let (mut mean, mut gauss) = (T::zero(), T::zero());
                for corner in [start, (start + 2) % 4] {
                    let h = m.topology.half_edges(FaceId(0)).nth(corner);
                    let h = trial.defined(EDGES, h)?;
                    let at = trial.defined(EDGES, pair.corner_curvatures(h).ok())?;
                    let area = edge((corner + 3) % 4).det(&edge(corner));
                    mean += &(&area * at.mean);
                    gauss += &(area * at.gauss);
                }
                trial.equal("H of two corners", &mean, &(&forms.mixed * &half));
                trial.equal("K of two corners", &gauss, &(&forms.second * &half));
            }
        }
        Ok(())
    }
}

fn views<T: Clone>(mesh: &Mesh<T>) -> Vec<TopView<T>> {
    mesh.points.iter().map(Point::top_view).collect()
}

struct DualForms;

impl Identity for DualForms {
    fn run<T: Field>(trial: &mut Trial<T>) -> Run {
        let k = trial.size();
        // The gradients around the vertex are the corners of two polygons; since faces of M and S
        // meet over the same lines, their edges are parallel.
        let polygons = ParallelPolygons::free(trial)?;
        let (f, s) = (&polygons.f, &polygons.s);
        let reach: Vec<T> = (0..k).map(|_| trial.free()).collect();
        let edge = |p: &[TopView<T>], j: usize| &p[(j + 1) % k] - &p[j];
        for (j, factor) in reach.iter().enumerate() {
            trial.parameter("the neighbours are not over the vertex", factor)?;
            trial.parameter(DUAL_EDGES, &edge(f, j).length2())?;
            trial.parameter(DUAL_EDGES, &polygons.factors[j])?;
            let before = (j + k - 1) % k;
            trial.parameter(DUAL_EDGES, &edge(f, before).det(&edge(f, j)))?;
        }
        let m = trial.accepted("M", star_of(f, f, &reach))?;
        let image = trial.accepted("S", star_of(s, f, &reach))?;
        trial.exhibit("M", &m);
        trial.exhibit("S", &image);
        let v_pair = trial.accepted("v-parallel", VParallel::new(&m, &image))?;
        let at_vertex = trial.accepted("interior", v_pair.vertex_forms(VertexId(0)))?;
        let dual = trial.accepted("M*", metric_dual(&m))?;
        let dual_image = trial.accepted("S*", metric_dual(&image))?;
        trial.exhibit("M*", &dual);
        let (dual, dual_image) = (trial.made_mesh(dual), trial.made_mesh(dual_image));
        let f_pair = trial.accepted("f-parallel", FParallel::new(&dual, &dual_image))?;
        let at_face = f_pair.face_forms(FaceId(0));
        trial.equal("D(v)", &at_vertex.measure(), &at_face.area());
        trial.equal("D(v, s)", &at_vertex.mixed_measure(), &at_face.mixed_area());
        trial.equal("D(s)", &at_vertex.image_measure(), &at_face.image_area());
        for j in 0..k {
            trial.equal("gradient", &dual.points[j].x, &f[j].x);
            trial.equal("gradient", &dual.points[j].y, &f[j].y);
            trial.equal("gradient", &dual_image.points[j].x, &s[j].x);
            trial.equal("gradient", &dual_image.points[j].y, &s[j].y);
        }
        // κ of the edge between two faces is inverse to that of the dual edge.
        let parallel = trial.accepted("parallel", f_pair.parallel())?;
        let spokes: Vec<_> = m.topology.star(VertexId(0)).collect();
        for h in spokes {
            let (left, right) = (m.topology.face_at(h), m.topology.twin(h));
            let right = right.map(|t| m.topology.face_at(t));
            let Some(right) = right else { continue };
            let ends = [right, left].map(|face| VertexId(face.0));
            let along = dual.topology.edge(ends[0], ends[1]);
            let along = trial.defined(DUAL_EDGES, along)?;
            let one = trial.defined(DUAL_EDGES, v_pair.edge_curvature(h).ok())?;
            let other = trial.defined(DUAL_EDGES, parallel.edge_curvature(along).ok())?;
            trial.equal("κ κ*", &(one * other), &T::one());
        }
        trial.nonzero(MEASURES, &at_vertex.measure())?;
        trial.nonzero(MEASURES, &at_vertex.image_measure())?;
        let curvatures = trial.defined(MEASURES, v_pair.vertex_curvatures(VertexId(0)).ok())?;
        let face = trial.defined(MEASURES, f_pair.face_curvatures(FaceId(0)).ok())?;
        let combined = trial.defined(MEASURES, face.dual())?;
        trial.show("H(v)", &curvatures.mean);
        trial.show("K(v)", &curvatures.gauss);
        trial.equal("H(v)", &curvatures.mean, &combined.mean);
        trial.equal("K(v)", &curvatures.gauss, &combined.gauss);
        Ok(())
    }
}
