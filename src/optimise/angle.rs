//! Conditions as angles, for doubles: far from where they hold they do not vanish as edges shrink, and in flat
//! meshes they keep digits that determinants lose.

use std::array::from_fn;

use super::gradient::Differentiable;
use crate::space::{Point, Vector2, Vector3};

/// `ω₁ − ω₂ + ω₃ − ω₄` with the angles in space between consecutive edges from the first point to the others:
/// zero iff the four planes touch a cone of revolution, where they do not fold.
///
/// The Euclidean counterpart of (14) for doubles (Y. Liu et al., *Geometric modeling with conical meshes
/// and developable surfaces*, 2006): in flat meshes it keeps digits that determinants of normals lose.
#[derive(Clone, Copy, Debug)]
pub struct AnglesInSpace;

impl Differentiable<5> for AnglesInSpace {
    fn value(self, points: &[Point<f64>; 5]) -> f64 {
        self.gradient(points).0
    }

    fn scale(self, _: &[Point<f64>; 5]) -> f64 {
        std::f64::consts::TAU
    }

    /// An angle grows by `−t / |e|` if its side e moves, with the unit vector t at a right angle to e
    /// towards the other side.
    fn gradient(self, [v, x @ ..]: &[Point<f64>; 5]) -> (f64, [Vector3<f64>; 5]) {
        let e: [Vector3<f64>; 4] = from_fn(|i| &x[i] - v);
        let mut slopes = [Vector3::new(0.0, 0.0, 0.0); 5];
        let mut value = 0.0;
        for i in 0..4 {
            let (j, sign) = ((i + 1) % 4, if i % 2 == 0 { 1.0 } else { -1.0 });
            let normal = e[i].cross(&e[j]);
            let sine = normal.length2().sqrt();
            value += sign * sine.atan2(e[i].dot(&e[j]));
            // n × e points from e to the other side, if n is the normal of both.
            let towards = |e: &Vector3<f64>, n: &Vector3<f64>, sign: f64| {
                let scale = -sign / (sine * e.length2());
                if scale.is_finite() {
                    n.cross(e).scaled(&scale)
                } else {
                    Vector3::new(0.0, 0.0, 0.0)
                }
            };
            let moved = [(i, towards(&e[i], &normal, sign)), (j, towards(&e[j], &normal, -sign))];
            for (k, slope) in moved {
                slopes[1 + k] = &slopes[1 + k] + &slope;
                slopes[0] = &slopes[0] - &slope;
            }
        }
        (value, slopes)
    }
}

/// The angle of `−f₀ f₂ / (f₁ f₃)` for the top views `f_j` of the edges of a quad: 0 iff opposite angles
/// sum to π (13), for convex quads of either orientation.
#[derive(Clone, Copy, Debug)]
pub struct OppositeAngles;

impl Differentiable<4> for OppositeAngles {
    fn value(self, points: &[Point<f64>; 4]) -> f64 {
        self.gradient(points).0
    }

    fn scale(self, _: &[Point<f64>; 4]) -> f64 {
        std::f64::consts::TAU
    }

    fn gradient(self, p: &[Point<f64>; 4]) -> (f64, [Vector3<f64>; 4]) {
        let edges = from_fn(|j| (&p[(j + 1) % 4] - &p[j]).top_view());
        let (value, by_edge) = alternating(&edges);
        (value, from_fn(|j| raised(&(&by_edge[(j + 3) % 4] + &-&by_edge[j]))))
    }
}

/// The angle of `−e₀ e₂ / (e₁ e₃)` for the top views `e_j` of the edges from the first point to the others in
/// cyclic order: 0 iff opposite angles between them sum to π (14).
#[derive(Clone, Copy, Debug)]
pub struct AnglesAround;

impl Differentiable<5> for AnglesAround {
    fn value(self, points: &[Point<f64>; 5]) -> f64 {
        self.gradient(points).0
    }

    fn scale(self, _: &[Point<f64>; 5]) -> f64 {
        std::f64::consts::TAU
    }

    fn gradient(self, [v, x @ ..]: &[Point<f64>; 5]) -> (f64, [Vector3<f64>; 5]) {
        let edges = from_fn(|j| (&x[j] - v).top_view());
        let (value, [a, b, c, d]) = alternating(&edges);
        let own = -&(&(&a + &b) + &(&c + &d));
        (value, [own, a, b, c, d].map(|slope| raised(&slope)))
    }
}

/// The angle of `−e₀ e₂ / (e₁ e₃)` in (−π, π], and its derivatives by the edges: `±J e / |e|²`, and 0 for an
/// edge that is seen as a point.
fn alternating(e: &[Vector2<f64>; 4]) -> (f64, [Vector2<f64>; 4]) {
    let times = |a: &Vector2<f64>, b: &Vector2<f64>| Vector2 {
        x: a.x * b.x - a.y * b.y,
        y: a.x * b.y + a.y * b.x,
    };
    let (even, odd) = (times(&e[0], &e[2]), times(&e[1], &e[3]));
    let value = (-odd.det(&even)).atan2(-odd.dot(&even));
    let slopes = from_fn(|j| {
        let scale = if j % 2 == 0 { 1.0 } else { -1.0 } / e[j].length2();
        if scale.is_finite() { e[j].turned().scaled(&scale) } else { Vector2 { x: 0.0, y: 0.0 } }
    });
    (value, slopes)
}

fn raised(v: &Vector2<f64>) -> Vector3<f64> {
    Vector3::new(v.x, v.y, 0.0)
}
