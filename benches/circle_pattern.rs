//! Circle patterns of an N × N grid of quads, and closed ones.
//!
//! `cargo bench --bench circle_pattern`; `-- 50 100` for other sizes. The vertex circles of the unit
//! square grid are inverted at a point outside, and the pattern is found again from its boundary
//! radii, so the exact answer is known.

use std::time::Instant;

use isogeo::construct::{CircleCondition, CirclePattern, quad_patch};
use isogeo::mesh::{FaceList, Topology, VertexId};

fn main() {
    let sizes: Vec<usize> = std::env::args().filter_map(|a| a.parse().ok()).collect();
    let sizes = if sizes.is_empty() { vec![50, 100, 200, 1000] } else { sizes };
    println!("  N      seconds  layout   largest defect  error of radii  gap      steps");
    sizes.into_iter().for_each(grid);
    for (rings, sectors) in [(12, 60), (36, 83), (100, 500)] {
        closed(rings, sectors);
    }
}

fn grid(n: usize) {
    let topology = Topology::new((n + 1) * (n + 1), quad_patch(n, n)).expect("a patch");
    let radius = |v: VertexId| {
        let (i, j) = (v.index() / (n + 1), v.index() % (n + 1));
        let (x, y) = (i as f64 + n as f64 / 3.0, j as f64 + n as f64 / 4.0);
        0.5 / (x * x + y * y - 0.25)
    };
    let mut best = f64::INFINITY;
    let mut found = None;
    for _ in 0..if n > 500 { 1 } else { 5 } {
        let start = Instant::now();
        let pattern = CirclePattern::disc(&topology, |v| CircleCondition::Radius(radius(v)));
        best = best.min(start.elapsed().as_secs_f64());
        found = pattern.ok();
    }
    let pattern = found.expect("a pattern");
    let error = topology.vertices().map(|v| (pattern.vertex_radius(v) / radius(v) - 1.0).abs());
    let error = error.fold(0.0, f64::max);
    let start = Instant::now();
    let layout = pattern.layout();
    let time = start.elapsed().as_secs_f64();
    println!(
        "{n:>5}  {best:9.4}  {time:7.4}  {:14.1e}  {error:14.1e}  {:.1e}  {:?}",
        pattern.defect, layout.gap, pattern.steps
    );
}

/// Rings of quads closed by a fan of triangles at each end.
fn closed(rings: usize, sectors: usize) {
    let mut faces = FaceList::new();
    let at = |i: usize, j: usize| (1 + i * sectors + j % sectors) as u32;
    let last = (1 + rings * sectors) as u32;
    for j in 0..sectors {
        faces.push([0, at(0, j), at(0, j + 1)]);
        for i in 0..rings - 1 {
            faces.push([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
        faces.push([at(rings - 1, j), last, at(rings - 1, j + 1)]);
    }
    let topology = Topology::new(last as usize + 1, faces).expect("a sphere");
    let start = Instant::now();
    let pattern = CirclePattern::sphere(&topology, VertexId(1));
    let time = start.elapsed().as_secs_f64();
    match pattern {
        Ok(pattern) => println!(
            "closed, {} edges: {time:.4} s, defect {:.1e}, gap {:.1e}, steps {:?}",
            topology.edge_count(),
            pattern.defect,
            pattern.layout().gap,
            pattern.steps
        ),
        Err(reason) => println!("closed, {} edges: {reason}", topology.edge_count()),
    }
}
