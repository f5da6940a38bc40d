//! Sec. 4: curvatures at vertices, their duality with those at faces, the cotangent Laplacian.

use super::stars::{
    DUAL_EDGES, IMAGE_MEASURE, NOT_VERTICAL, ParallelPolygons, at_heights, not_vertical, star_of,
    triangles,
};
use super::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Trial,
};
use crate::construct::{lift, metric_dual};
use crate::mesh::{FaceId, Mesh, VertexId};
use crate::pair::{FParallel, VParallel, cotangent_weight, twice_area};
use crate::scalar::Field;
use crate::space::{Circle, TopView};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-21-22-duality",
        statement: "The measures of a vertex of a v-parallel pair (M, S) are the areas of the dual face of the \
                    f-parallel pair (M*, S*), so its curvatures are those of that face combined by (11).",
        formula: "D(v) = area(v*),  D(v, s) = area(v*, s*),  H(v) = H(v*)/K(v*),  K(v) = 1/K(v*)",
        source: Source::Paper("Sec. 4, (21), (22)"),
        hypotheses: &[Hypothesis::silent(MEASURES)],
        said: Grade::Certified,
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
        said: Grade::Certified,
        argument: "For all k: both sides are sums of terms that belong to two consecutive triangles, \
                   and such a term knows nothing of k.",
        evidence: &[
            Evidence::identity::<Cotangents>("a star of k triangles", &[3], &[3, 4, 5, 6, 8]),
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
];

const K_GONS: &[usize] = &[3, 4, 5, 6, 7, 8];
const MEASURES: &str = "D(v) != 0 and D(s) != 0";

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
