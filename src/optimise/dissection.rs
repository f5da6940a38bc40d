//! The order of elimination: nested dissection by where conditions are.

use std::cmp::Ordering;

use rayon::prelude::*;

use super::system::System;
use crate::space::Point;

/// Sets of at most so many conditions are not cut any further.
const SMALL: usize = 16;

/// Sets of more conditions are cut across each direction, and the cut that meets the fewest counts.
const LARGE: usize = 512;

/// The directions across which sets are cut: the axes, and the diagonals of the top view.
const DIRECTIONS: usize = 5;

/// From where to where a condition reaches, along each direction.
type Extent = [(f64, f64); DIRECTIONS];

/// An order in which to eliminate the rows of `J Jᵀ`: row `order[0]` first.
///
/// A plane cuts a set of conditions. Those with all points on one side share no point with those on the
/// other, so they are not coupled; those that it meets separate them and come last. The parts are cut in the
/// same way. For `n` conditions spread out like a surface the factor then has O(n log n) entries. Costs
/// O(n log n). Where the points are matters for speed only.
pub fn dissect(system: &System, points: &[Point<f64>]) -> Vec<u32> {
    let extent = |row| {
        let mut extent = [(f64::INFINITY, f64::NEG_INFINITY); DIRECTIONS];
        for v in &system.places()[system.range(row)] {
            let Point { x, y, z } = points[v.index()];
            for ((low, high), at) in extent.iter_mut().zip([x, y, z, x + y, x - y]) {
                (*low, *high) = (low.min(at), high.max(at));
            }
        }
        extent
    };
    let extents: Vec<Extent> = (0..system.rows()).into_par_iter().map(extent).collect();
    let mut order: Vec<u32> = (0..system.rows() as u32).collect();
    arrange(&mut order, &extents);
    order
}

fn arrange(rows: &mut [u32], extents: &[Extent]) {
    if rows.len() <= SMALL {
        return;
    }
    let cut = if rows.len() > LARGE {
        let cuts = (0..DIRECTIONS).map(|k| Cut::halving(rows, extents, k));
        let costs = cuts.filter_map(|cut| Some((cut.cost(rows, extents)?, cut)));
        costs.min_by_key(|(cost, _)| *cost).map(|(_, cut)| cut)
    } else {
        Cut::widest(rows, extents)
    };
    let Some(cut) = cut else { return };
    let (below, above) = cut.part(rows, extents);
    let (low, rest) = rows.split_at_mut(below);
    let (high, _) = rest.split_at_mut(above);
    if low.is_empty() || high.is_empty() {
        return;
    }
    if low.len() > LARGE {
        rayon::join(|| arrange(low, extents), || arrange(high, extents));
    } else {
        arrange(low, extents);
        arrange(high, extents);
    }
}

/// A plane across one of the directions.
#[derive(Clone, Copy, Debug)]
struct Cut {
    direction: usize,
    at: f64,
}

impl Cut {
    /// With half of the middles of the conditions on either side.
    fn halving(rows: &[u32], extents: &[Extent], direction: usize) -> Self {
        let middle = |row: &u32| {
            let (low, high) = extents[*row as usize][direction];
            0.5 * (low + high)
        };
        let mut middles: Vec<f64> = rows.iter().map(middle).collect();
        let half = middles.len() / 2;
        let (_, at, _) = middles.select_nth_unstable_by(half, f64::total_cmp);
        Cut { direction, at: *at }
    }

    /// Across the direction along which the conditions reach farthest.
    fn widest(rows: &[u32], extents: &[Extent]) -> Option<Self> {
        let reach = |k: &usize| {
            let ends = rows.iter().map(|row| extents[*row as usize][*k]);
            let (low, high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), end| {
                (low.min(end.0), high.max(end.1))
            });
            // The diagonals are longer by a root of two.
            if *k < 3 { high - low } else { (high - low) * std::f64::consts::FRAC_1_SQRT_2 }
        };
        let widest = (0..DIRECTIONS).max_by(|a, b| reach(a).total_cmp(&reach(b)))?;
        Some(Cut::halving(rows, extents, widest))
    }

    fn side(&self, extent: &Extent) -> Ordering {
        let (low, high) = extent[self.direction];
        if high < self.at {
            Ordering::Less
        } else if low >= self.at {
            Ordering::Greater
        } else {
            Ordering::Equal
        }
    }

    /// How many conditions it meets; `None` where it has nearly all others on one side.
    fn cost(&self, rows: &[u32], extents: &[Extent]) -> Option<usize> {
        let mut counts = [0; 3];
        for row in rows {
            counts[(self.side(&extents[*row as usize]) as i8 + 1) as usize] += 1;
        }
        let [below, met, above] = counts;
        (below.min(above) > rows.len() / 8).then_some(met)
    }

    /// Brings those below to the front and those that it meets to the end; the numbers of those below and above.
    fn part(&self, rows: &mut [u32], extents: &[Extent]) -> (usize, usize) {
        let (mut below, mut next, mut end) = (0, 0, rows.len());
        while next < end {
            match self.side(&extents[rows[next] as usize]) {
                Ordering::Less => {
                    rows.swap(below, next);
                    (below, next) = (below + 1, next + 1);
                }
                Ordering::Greater => next += 1,
                Ordering::Equal => {
                    end -= 1;
                    rows.swap(next, end);
                }
            }
        }
        (below, end - below)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::construct::quad_patch;
    use crate::mesh::Mesh;
    use crate::optimise::cholesky::Cholesky;
    use crate::optimise::normal::NormalMatrix;
    use crate::optimise::{Goal, System};

    /// The system of an `n` by `n` patch, with its points moved by a function.
    fn system(n: usize, at: impl Fn(f64, f64) -> Point<f64>) -> (System, Vec<Point<f64>>) {
        let places = (0..(n + 1) * (n + 1)).map(|i| ((i % (n + 1)) as f64, (i / (n + 1)) as f64));
        let points: Vec<_> = places.map(|(x, y)| at(x, y)).collect();
        let mesh = Mesh::new(points, quad_patch(n, n)).expect("a patch is a mesh");
        (System::new(Goal::IConical.conditions(&mesh.topology, &mesh.points)), mesh.points)
    }

    #[test]
    fn each_row_comes_once_wherever_the_points_are() {
        let flat = |x, y| Point::new(x, y, 0.0);
        let coincident = |_, _| Point::new(1.0, 1.0, 1.0);
        let undefined =
            |x: f64, y| Point::new(if x > 3.0 { f64::NAN } else { x }, y, f64::INFINITY);
        for (system, points) in [system(30, flat), system(30, coincident), system(30, undefined)] {
            let mut order = dissect(&system, &points);
            order.sort_unstable();
            assert!(order.into_iter().eq(0..system.rows() as u32));
        }
    }

    #[test]
    fn what_separates_comes_last_and_saves_entries() {
        let (system, points) = system(96, |x, y| Point::new(x, y + 0.1 * x, 0.0));
        let matrix = NormalMatrix::new(&system, points.len());
        let entries = |order: &[u32]| {
            let factor = Cholesky::analyse(&matrix.starts, &matrix.rows, Some(order));
            factor.expect("memory suffices").entries()
        };
        let dissected = entries(&dissect(&system, &points));
        let as_they_come = entries(&(0..system.rows() as u32).collect::<Vec<_>>());
        assert!(3 * dissected < as_they_come, "{dissected} of {as_they_come} entries");
        let reversed: Vec<u32> = dissect(&system, &points).into_iter().rev().collect();
        assert!(3 * dissected < entries(&reversed), "{dissected} entries");
    }
}
