//! Sec. 4: curvatures of edges.

use super::packing::face_at;
use super::stars::ParallelPolygons;
use super::{
    Claim, Control, Counterexample, Evidence, Grade, Hypothesis, Identity, Run, Source, Trial,
};
use crate::mesh::{FaceId, Mesh};
use crate::pair::{Forms, Parallel};
use crate::scalar::Field;
use crate::space::{Gradient, Plane, Point, TopView};

pub(super) const CLAIMS: &[Claim] = &[Claim {
    id: "edge-curvatures",
    statement: "Areas of parallel faces are sums over their edges and the ratios κ of edges of S to \
                    those of M; for a quad H and K are means of those of two opposite corners, weighted by \
                    their triangles, whichever two are taken. Under duality κ becomes 1/κ.",
    formula: "2 area(F, S) = Σ ½ (κ_i + κ_j) det(e_i, e_j),  2 area(S) = Σ κ_i κ_j det(e_i, e_j),  i < j < k - 1",
    source: Source::Ours,
    hypotheses: &[Hypothesis::stated(EDGES)],
    said: Grade::Certified,
    argument: "For all k: the corner i of a polygon is the sum of its first i edges, and (15), (16) are \
                   bilinear in the corners.",
    evidence: &[Evidence::identity::<EdgeSums>("parallel k-gons in space", K_GONS, &[3, 4, 5, 8])],
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
}];

const K_GONS: &[usize] = &[3, 4, 5, 6, 7, 8];
const EDGES: &str = "no edge of M has length 0";

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
        let forms = Forms::of(&polygons.f, &views(&s));
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
