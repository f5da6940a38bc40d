//! What proofs of existence cost, and what they find: `cargo bench --bench existence`; sizes may be given:
//! `-- 30 500`.
//!
//! A net over an i-Enneper surface with noise is brought to planar, i-circular and i-conical in doubles; then a
//! mesh of real numbers is proved to be near. Printed are the number of equations, the seconds of the
//! optimisation and of the proof, and the bounds: the singular value σ, the residual r, the Lipschitz constant
//! L, the number h of Kantorovich, and the radius in lengths of edges.

use std::time::Instant;

use isogeo::construct::quad_patch;
use isogeo::mesh::Mesh;
use isogeo::optimise::existence::{Pinned, prove};
use isogeo::optimise::{Design, Goal, Mobility, mean_edge};
use isogeo::space::Point;

/// `x + iy = ζ^(2/3)`, `z = Re ζ² / 5` with ζ in [1, 2] + i [0.2, 1.2] on `m` by `m` faces, and each
/// coordinate moved by at most 2 % of an edge.
fn noisy_enneper(m: usize) -> Mesh<f64> {
    let point = |k: usize| {
        let (i, j) = (k % (m + 1), k / (m + 1));
        let (a, b) = (1.0 + j as f64 / m as f64, 0.2 + i as f64 / m as f64);
        let (r, angle) = ((a * a + b * b).cbrt(), f64::atan2(b, a) * 2.0 / 3.0);
        let shift = |axis: usize| 0.02 / m as f64 * ((3 * k + axis) as f64 * 2.399).sin();
        let z = 0.2 * (a * a - b * b);
        Point::new(r * angle.cos() + shift(0), r * angle.sin() + shift(1), z + shift(2))
    };
    let points = (0..(m + 1) * (m + 1)).map(point).collect();
    Mesh::new(points, quad_patch(m, m)).expect("a patch is a mesh")
}

fn main() {
    let given: Vec<usize> = std::env::args().filter_map(|size| size.parse().ok()).collect();
    let sizes = if given.is_empty() { vec![10, 30, 50, 100, 200] } else { given };
    println!(
        "goal        pinned   faces equations optimised  proved       σ       r       L       h  radius"
    );
    for m in sizes {
        let mesh = noisy_enneper(m);
        let edge = mean_edge(&mesh.topology, &mesh.points);
        for goal in [Goal::Planar, Goal::ICircular, Goal::IConical] {
            for pinned in [Pinned::Nothing, Pinned::Boundary] {
                let mobility = pinned.mobility(&mesh.topology).expect("a boundary");
                let name = if mobility.contains(&Mobility::Fixed) { "boundary" } else { "nothing" };
                let design = Design { mobility, ..Design::new(goal, mesh.points.len()) };
                let start = Instant::now();
                let found = design.run(&mesh, |_| true).expect("memory suffices");
                let optimised = start.elapsed().as_secs_f64();
                let start = Instant::now();
                let proof = prove(&mesh.topology, &found.points, goal, &pinned);
                let seconds = start.elapsed().as_secs_f64();
                let property = goal.property().name();
                print!("{property:10} {name:>8} {:7} ", mesh.topology.face_count());
                match proof {
                    Ok(p) => println!(
                        "{:9} {optimised:9.3} {seconds:7.3} {:7.1e} {:7.1e} {:7.1e} {:7.1e} {:7.1e}",
                        p.equations,
                        p.singular_value,
                        p.residual,
                        p.lipschitz,
                        p.contraction,
                        p.radius / edge
                    ),
                    Err(why) => {
                        println!("{optimised:19.3} {seconds:7.3} {:?}: {why}", found.ending)
                    }
                }
            }
        }
    }
}
