//! Meshes of given mean curvature, and pairs.

use isogeo::construct::quad_patch;
use isogeo::mesh::{FaceList, Mesh};
use isogeo::optimise::{
    Ending, Goal, Mobility, Projection, Stage, System, f_parallel, face_means, vertex_means,
};
use isogeo::space::Point;

/// A grid of `n` by `n` squares over the unit square, each cut into two triangles.
fn right_triangles(n: u32, height: impl Fn(f64, f64) -> f64) -> Mesh<f64> {
    let at = |i: u32| f64::from(i) / f64::from(n);
    let vertices = (0..=n).flat_map(|j| (0..=n).map(move |i| (i, j)));
    let points = vertices.map(|(i, j)| Point::new(at(i), at(j), height(at(i), at(j)))).collect();
    let mut faces = FaceList::new();
    for (i, j) in (0..n).flat_map(|j| (0..n).map(move |i| (i, j))) {
        let v = |i: u32, j: u32| j * (n + 1) + i;
        faces.push([v(i, j), v(i + 1, j), v(i + 1, j + 1)]);
        faces.push([v(i, j), v(i + 1, j + 1), v(i, j + 1)]);
    }
    Mesh::new(points, faces).expect("a grid is a mesh")
}

/// The i-Plateau problem: given a boundary, H = 0 at all interior vertices. Heights enter linearly: one step.
#[test]
fn the_i_plateau_problem_converges_to_second_order() {
    // Re w^4 on the unit square; expected errors from the five-point scheme.
    let exact = |x: f64, y: f64| x.powi(4) - 6.0 * x * x * y * y + y.powi(4);
    for (n, expected) in [(8, 4.54891e-3), (16, 1.14759e-3)] {
        let mesh = right_triangles(n, exact);
        let mut points = mesh.points.clone();
        let mut mobility = vec![Mobility::Vertical; points.len()];
        for v in mesh.topology.boundary_loops().concat() {
            mobility[v.index()] = Mobility::Fixed;
        }
        for v in mesh.topology.interior_vertices() {
            points[v.index()].z = 0.0;
        }
        let system = System::new(vertex_means(&mesh.topology, |_| 0.0));
        let mut steps = 0;
        let mut projection = Projection::new(&system, &mobility, &points).expect("memory suffices");
        let ending = projection.run(&mut points, 10, Stage::Projection, |step| {
            steps = step.number;
            true
        });
        assert_eq!(ending, Ending::Converged);
        assert!(steps <= 3, "{steps}");
        let error = points.iter().map(|p| (p.z - exact(p.x, p.y)).abs()).fold(0.0, f64::max);
        assert!((error / expected - 1.0).abs() < 1e-5, "n = {n}: {error:e}");
    }
}

/// Where the boundary lies on z = (3/7) |x|²/2 and H = 3/7, so does everything; with another H it does not.
#[test]
fn an_i_sphere_is_found_from_its_mean_curvature() {
    let sphere = |x: f64, y: f64| 3.0 / 14.0 * (x * x + y * y);
    for (mean, agrees) in [(3.0 / 7.0, true), (2.0 / 7.0, false)] {
        let mesh = right_triangles(6, sphere);
        let mut points = mesh.points.clone();
        let mut mobility = vec![Mobility::Vertical; points.len()];
        for v in mesh.topology.boundary_loops().concat() {
            mobility[v.index()] = Mobility::Fixed;
        }
        for v in mesh.topology.interior_vertices() {
            points[v.index()].z += 0.1;
        }
        let system = System::new(vertex_means(&mesh.topology, |_| mean));
        let mut projection = Projection::new(&system, &mobility, &points).expect("memory suffices");
        let ending = projection.run(&mut points, 10, Stage::Projection, |_| true);
        assert_eq!(ending, Ending::Converged);
        let error = points.iter().map(|p| (p.z - sphere(p.x, p.y)).abs()).fold(0.0, f64::max);
        assert_eq!(error < 1e-14, agrees, "H = {mean}: {error:e}");
    }
}

/// M and S are moved together until they are a planar, f-parallel pair with H = 1/3 at every face.
#[test]
fn a_pair_of_constant_mean_curvature() {
    let n = 4;
    let at = |i: usize| i as f64 / n as f64 - 0.4;
    let vertices = || (0..=n).flat_map(|i| (0..=n).map(move |j| (i, j)));
    let m = vertices().map(|(i, j)| {
        let (x, y) = (at(i), at(j));
        Point::new(x, y, 0.3 * x * x + 0.1 * y * y + 0.05 * x * y)
    });
    // A Gauss image near by: the gradients of a surface like that.
    let s = vertices().map(|(i, j)| {
        let (x, y) = (at(i), at(j));
        let (p, q) = (0.6 * x + 0.05 * y, 0.2 * y + 0.05 * x);
        Point::new(p, q, 0.5 * (p * p + q * q))
    });
    let mut points: Vec<Point<f64>> = m.chain(s).collect();
    let count = points.len() / 2;
    let mesh = Mesh::new(points[..count].to_vec(), quad_patch(n, n)).expect("a patch is a mesh");
    let mut kinds = Goal::Planar.conditions(&mesh.topology, &points);
    kinds.push(f_parallel(&mesh.topology));
    kinds.extend(face_means(&mesh.topology, |_| 1.0 / 3.0));
    let system = System::new(kinds);
    let mobility = vec![Mobility::Free; points.len()];
    let mut projection = Projection::new(&system, &mobility, &points).expect("memory suffices");
    let ending = projection.run(&mut points, 50, Stage::Projection, |_| true);
    assert_eq!(ending, Ending::Converged);
    let means = isogeo::pair::face_curvatures(&mesh.topology, &points[..count], &points[count..]);
    let means = means.expect("as many points as vertices");
    for (face, curvature) in means.iter().enumerate() {
        let curvature = curvature.as_ref().expect("a face with area");
        assert!((curvature.mean - 1.0 / 3.0).abs() < 1e-10, "face {face}: {curvature:?}");
    }
}
