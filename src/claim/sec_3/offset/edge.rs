//! Offsets at constant distance of edges.

use crate::claim::{
    Claim, Control, Counterexample, Evidence, Experiment, Grade, Hypothesis, Identity, Run, Source,
    Stop, Trial,
};

use super::{free_top_view, from_origin, rational_polygon, triangles};
use crate::construct::transfer::{EuclideanImage, edge_offset_image};
use crate::construct::{inverted_packing, koebe_mesh, quad_patch, square_packing};
use crate::mesh::VertexId;
use crate::pair::Parallel;
use crate::scalar::{Field, RationalField, Ring};

pub(in crate::claim) const CLAIMS: &[Claim] = &[Claim {
    id: "offset-edge",
    statement: "The lines of the edges of M + dS have the distance d from those of M iff the \
                    edges of S touch the unit sphere.",
    formula: "dist² = d² |s × e|²/|e|²",
    source: Source::Paper("Sec. 3.1, meshes with offsets (ii)"),
    hypotheses: &[Hypothesis::stated(EDGE_OF_M)],
    said: Grade::Certified,
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
}];

const EDGE_OF_M: &str = "no edge of M has length 0";

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
