//! Flips until every edge is locally Delaunay, points added one by one; all signs exact.

use rayon::prelude::*;

use super::sites::Signs;
use super::sphere::{Half, Sphere, next};
use crate::net::i_circular::Concyclic;
use crate::net::planar::ProjectedArea;
use crate::scalar::Sign;

/// A triangulation on its way to be Delaunay, and the signs that decide.
pub(super) struct Lawson<'a> {
    pub sphere: Sphere,
    pub signs: &'a Signs<'a>,
}

/// What is to be done with an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Verdict {
    Keep,
    /// Its two triangles have one circumcircle.
    Tie,
    Flip,
}

/// What is to be done with all edges.
#[derive(Default)]
pub(super) struct Survey {
    pub flips: Vec<Half>,
    pub ties: Vec<Half>,
}

impl Lawson<'_> {
    /// Twice the area: positive for three top views in counter-clockwise order.
    fn turn(&self, at: [u32; 3]) -> Sign {
        self.signs.sign(ProjectedArea::TopView, at)
    }

    /// An edge inside is flipped if the lift to Σ is concave there, an edge of the boundary if its
    /// triangle is degenerate or inverted, an edge to infinity if the boundary is reflex there.
    fn verdict(&self, h: Half) -> Verdict {
        let (sphere, infinity) = (&self.sphere, self.sphere.infinity());
        let t = sphere.twin(h);
        let (a, b, c, d) = (sphere.origin(h), sphere.origin(t), sphere.apex(h), sphere.apex(t));
        let flip_if = |condition| if condition { Verdict::Flip } else { Verdict::Keep };
        if c == infinity {
            flip_if(self.turn([b, a, d]) != Sign::Positive)
        } else if d == infinity {
            flip_if(self.turn([a, b, c]) != Sign::Positive)
        } else if a == infinity {
            flip_if(self.turn([c, b, d]) == Sign::Negative)
        } else if b == infinity {
            flip_if(self.turn([d, a, c]) == Sign::Negative)
        } else {
            match self.signs.sign(Concyclic, [a, b, c, d]) {
                Sign::Positive => Verdict::Flip,
                Sign::Zero => Verdict::Tie,
                Sign::Negative => Verdict::Keep,
            }
        }
    }

    /// Looks at all edges.
    pub fn survey(&self) -> Survey {
        let join = |mut a: Survey, mut b: Survey| {
            a.flips.append(&mut b.flips);
            a.ties.append(&mut b.ties);
            a
        };
        let look = |mut survey: Survey, h: Half| {
            match self.verdict(h) {
                Verdict::Keep => {}
                Verdict::Tie => survey.ties.push(h),
                Verdict::Flip => survey.flips.push(h),
            }
            survey
        };
        let edges = (0..self.sphere.len()).into_par_iter();
        edges
            .filter(|&h| self.sphere.is_first_side(h))
            .fold(Survey::default, look)
            .reduce(Survey::default, join)
    }

    /// Flips these edges and whatever becomes wrong by it; `false` if it takes more than `budget`.
    ///
    /// On a triangulation it ends: every flip lowers the lift to Σ or enlarges the region.
    pub fn settle(&mut self, mut queue: Vec<Half>, mut budget: usize) -> bool {
        while let Some(h) = queue.pop() {
            if self.verdict(h) != Verdict::Flip || !self.sphere.flip(h) {
                continue;
            }
            if budget == 0 {
                return false;
            }
            budget -= 1;
            // The two old diagonals are sides h and its twin now; the new one is prev of both.
            let t = self.sphere.twin(super::sphere::prev(h));
            let other = next(t);
            queue.extend([h, next(h), other, next(other)]);
        }
        true
    }

    /// Whether this is a triangulation of the convex hull of its points, if the survey found no edge to flip.
    ///
    /// All triangles run counter-clockwise, and the boundary, which has no reflex corner then, has
    /// one lowest rank, so it winds once. So every point inside is covered once.
    pub fn covers_its_hull(&self) -> bool {
        let infinity = self.sphere.infinity();
        let triangles = (0..self.sphere.len()).into_par_iter().step_by(3);
        let upright = triangles
            .map(|h| self.sphere.triangle(h))
            .all(|triangle| triangle.contains(&infinity) || self.turn(triangle) == Sign::Positive);
        let boundary: Vec<u32> = self.sphere.neighbours(infinity).collect();
        let n = boundary.len();
        let is_lowest = |&i: &usize| {
            let (before, after) = (boundary[(i + n - 1) % n], boundary[(i + 1) % n]);
            boundary[i] < before && boundary[i] < after
        };
        upright && (0..n).filter(is_lowest).count() == 1
    }

    /// Adds a vertex to a Delaunay triangulation and makes it Delaunay again.
    pub fn insert(&mut self, v: u32, near: Half) {
        let h = self.locate(v, near);
        let sides = self.sphere.split(h, v);
        // On a triangulation that is Delaunay but for the new vertex, every flip adds an edge at it.
        self.settle(sides.into(), usize::MAX);
    }

    /// A half-edge of the triangle that a place lies in or on, found by a walk from another one.
    ///
    /// The walk ends, because triangles of a Delaunay triangulation do not hide each other in a cycle.
    fn locate(&self, v: u32, near: Half) -> Half {
        let (sphere, infinity) = (&self.sphere, self.sphere.infinity());
        let is_outside = |h: Half| sphere.triangle(h).contains(&infinity);
        let mut h = near;
        if is_outside(h) {
            let real =
                [h, next(h), next(next(h))].into_iter().find(|&g| sphere.apex(g) == infinity);
            h = sphere.twin(real.unwrap_or(h));
        }
        loop {
            let sides = [h, next(h), next(next(h))];
            let wrong =
                |&g: &Half| self.turn([sphere.origin(g), sphere.target(g), v]) == Sign::Negative;
            match sides.into_iter().find(wrong) {
                None => return h,
                Some(g) => h = sphere.twin(g),
            }
            if is_outside(h) {
                return h;
            }
        }
    }
}
