//! Which pieces have to be painted after which.
//!
//! Where a line of one piece runs over the inside of another, one of them is nearer. Pieces that lie
//! over each other in a circle, as those that go through each other, form a group; the groups are put
//! in an order in which nothing is painted before what it covers. Pieces of which nobody sees that they
//! overlap stand in the order of their depths.

use super::painter::UNSEEN;
use super::{Paint, Piece, View};

/// The numbers of the pieces in groups, the farthest first; `size` is that of the model.
pub(super) fn groups(pieces: &[Piece], view: &View, size: f64) -> Vec<Vec<usize>> {
    let shades: Vec<Shade> = pieces.iter().map(|piece| Shade::of(piece, view)).collect();
    let mut below: Vec<Vec<usize>> = vec![Vec::new(); shades.len()];
    let mut by_left: Vec<usize> = (0..shades.len()).collect();
    by_left.sort_by(|&i, &j| shades[i].low[0].total_cmp(&shades[j].low[0]));
    for (k, &i) in by_left.iter().enumerate() {
        for &j in &by_left[k + 1..] {
            if shades[j].low[0] > shades[i].high[0] {
                break;
            }
            if shades[j].low[1] > shades[i].high[1] || shades[i].low[1] > shades[j].high[1] {
                continue;
            }
            let [over, under] = shades[i].lies(&shades[j], size / UNSEEN);
            if over {
                below[i].push(j);
            }
            if under {
                below[j].push(i);
            }
        }
    }
    let mut by_depth: Vec<usize> = (0..shades.len()).collect();
    by_depth.sort_by(|&i, &j| shades[i].depth().total_cmp(&shades[j].depth()));
    circles(&below, by_depth)
}

/// A piece as the viewer sees it: points of the picture with their depths; greater is nearer.
struct Shade {
    /// The outline of a face, closed; or a segment.
    line: Vec<[f64; 3]>,
    /// Triangles that cover a face with an inside.
    inside: Vec<[[f64; 3]; 3]>,
    low: [f64; 2],
    high: [f64; 2],
}

impl Shade {
    fn of(piece: &Piece, view: &View) -> Shade {
        let seen = |p: &[f64; 3]| {
            let [x, y] = view.project(*p);
            [x, y, view.depth(*p)]
        };
        let (line, inside) = match piece {
            Piece::Segment { ends, .. } => (ends.iter().map(seen).collect(), Vec::new()),
            Piece::Face { corners, paint, .. } => {
                let mut line: Vec<_> = corners.iter().map(seen).collect();
                let inside = if *paint == Paint::Wire { Vec::new() } else { fan(&line) };
                line.extend(line.first().copied());
                (line, inside)
            }
        };
        let [mut low, mut high] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for p in &line {
            for i in 0..2 {
                (low[i], high[i]) = (low[i].min(p[i]), high[i].max(p[i]));
            }
        }
        Shade { line, inside, low, high }
    }

    fn depth(&self) -> f64 {
        self.line.iter().map(|p| p[2]).sum::<f64>() / self.line.len() as f64
    }

    /// Whether this piece lies over another, and under it, by more than what nobody sees. A line on a
    /// face lies over it.
    fn lies(&self, other: &Shade, unseen: f64) -> [bool; 2] {
        let [mut over, mut under] = [false; 2];
        for (one, two, sign) in [(self, other, 1.0), (other, self, -1.0)] {
            let (lift, rim) =
                if one.inside.is_empty() { (2.0 * unseen, 1.0 / UNSEEN) } else { (0.0, 0.0) };
            for ends in one.line.windows(2) {
                for triangle in &two.inside {
                    for rise in rises([ends[0], ends[1]], triangle, rim).into_iter().flatten() {
                        let rise = (rise + lift) * sign;
                        over |= rise > unseen;
                        under |= rise < -unseen;
                    }
                }
            }
        }
        [over, under]
    }
}

/// Twice the signed area of a triangle of the picture.
fn area([a, b, c]: [[f64; 3]; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Triangles from a corner that cover a polygon: from one that sees all of it, if there is one.
fn fan(corners: &[[f64; 3]]) -> Vec<[[f64; 3]; 3]> {
    let n = corners.len();
    let from = |apex: usize| {
        let corner = move |i: usize| corners[(apex + i) % n];
        (1..n.saturating_sub(1)).map(move |i| [corner(0), corner(i), corner(i + 1)])
    };
    let one_way = |apex: &usize| {
        let areas = || from(*apex).map(area);
        areas().all(|a| a >= 0.0) || areas().all(|a| a <= 0.0)
    };
    from((0..n).find(one_way).unwrap_or(0)).filter(|triangle| area(*triangle) != 0.0).collect()
}

/// By how much a segment lies over a triangle, at both ends of what lies inside it in the picture, or in
/// a rim of this part of its height around it; `None` where nothing does.
fn rises([p, q]: [[f64; 3]; 2], triangle: &[[f64; 3]; 3], rim: f64) -> Option<[f64; 2]> {
    let whole = area(*triangle);
    let weights = |p: [f64; 3]| {
        let [a, b, c] = *triangle;
        [[p, b, c], [a, p, c], [a, b, p]].map(|part| area(part) / whole)
    };
    let (at_p, at_q) = (weights(p), weights(q));
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for (s, t) in at_p.into_iter().zip(at_q) {
        let (s, t) = (s + rim, t + rim);
        match (s < 0.0, t < 0.0) {
            (true, true) => return None,
            (true, false) => from = from.max(s / (s - t)),
            (false, true) => to = to.min(s / (s - t)),
            (false, false) => {}
        }
    }
    let height = |p: [f64; 3], weights: [f64; 3]| {
        p[2] - (0..3).map(|i| weights[i] * triangle[i][2]).sum::<f64>()
    };
    let (first, last) = (height(p, at_p), height(q, at_q));
    (from < to).then(|| [from, to].map(|t| first + t * (last - first)))
}

/// The circles of a relation, and what is in none alone: what lies below comes first (Tarjan).
/// Otherwise the given order is kept.
fn circles(below: &[Vec<usize>], order: Vec<usize>) -> Vec<Vec<usize>> {
    const NEW: usize = usize::MAX;
    let mut found = vec![NEW; below.len()];
    let mut lowest = vec![NEW; below.len()];
    let (mut open, mut done) = (Vec::new(), Vec::new());
    let mut count = 0;
    for root in order {
        // A path, with how many of each one's successors have been looked at.
        let mut path: Vec<(usize, usize)> = Vec::new();
        if found[root] == NEW {
            path.push((root, 0));
        }
        while let Some((i, next)) = path.pop() {
            if next == 0 {
                (found[i], lowest[i]) = (count, count);
                count += 1;
                open.push(i);
            } else {
                lowest[i] = lowest[i].min(lowest[below[i][next - 1]]);
            }
            match below[i].get(next) {
                Some(&j) => {
                    path.push((i, next + 1));
                    if found[j] == NEW {
                        path.push((j, 0));
                    }
                }
                None if lowest[i] == found[i] => {
                    let at = open.iter().rposition(|&j| j == i).unwrap_or(0);
                    let group = open.split_off(at);
                    group.iter().for_each(|&j| lowest[j] = NEW);
                    done.push(group);
                }
                None => {}
            }
        }
    }
    done
}
