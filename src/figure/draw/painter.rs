//! The painter's order: what is nearer is painted later, whatever the model.
//!
//! Pieces that cover each other in no circle are painted whole. In the other groups the planes of faces
//! cut space in two, again and again (a binary space partition); pieces on the side of the viewer are
//! painted after those on the other. This is right also for meshes that go through each other, since
//! faces are cut where they have to be.

use super::order::groups;
use super::view::dot;
use super::{Item, Model, Paint, Piece, Scene, Stroke, View};

/// The pieces of a model as items of a scene, in the order in which they have to be painted.
pub fn painted(model: &Model, view: &View) -> Vec<Item> {
    let size = model.points().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
    let pieces = groups(&model.pieces, view, size).into_iter().flat_map(|group| {
        let parts = group.iter().map(|&i| Part::whole(model.pieces[i].clone()));
        partition(parts.collect(), view, size)
    });
    pieces.flat_map(|part| items(&part.piece, view)).collect()
}

/// The parts of a group in the order in which they have to be painted.
fn partition(parts: Vec<Part>, view: &View, size: f64) -> Vec<Part> {
    let mut ordered = Vec::with_capacity(parts.len());
    // What remains to be ordered, the farthest last; a set that is in order is marked.
    let mut stack = vec![(parts, false)];
    while let Some((set, ordered_already)) = stack.pop() {
        let splitter = if ordered_already { None } else { splitter(&set, size) };
        let Some(plane) = splitter else {
            ordered.extend(set);
            continue;
        };
        let [mut behind, mut on, mut before] = [const { Vec::new() }; 3];
        for part in set {
            plane.sort(part, size, [&mut behind, &mut on, &mut before]);
        }
        // Lines lie over the faces of their plane.
        on.sort_by_key(|part| matches!(part.piece, Piece::Segment { .. }));
        let towards = view.sees(plane.normal);
        let (far, near) = if towards { (behind, before) } else { (before, behind) };
        stack.push((near, false));
        stack.push((on, true));
        stack.push((far, false));
    }
    ordered
}

fn points(piece: &Piece) -> Vec<[f64; 3]> {
    match piece {
        Piece::Face { corners, .. } => corners.clone(),
        Piece::Segment { ends, .. } => ends.to_vec(),
    }
}

/// A piece or what cuts have left of it, with the plane of the whole face: that of a thin part would
/// be far from it.
#[derive(Clone, Debug)]
struct Part {
    piece: Piece,
    plane: Option<Plane>,
}

impl Part {
    fn whole(piece: Piece) -> Part {
        Part { plane: Plane::of(&piece), piece }
    }
}

/// An oriented plane `normal · x = offset`.
#[derive(Clone, Debug)]
struct Plane {
    normal: [f64; 3],
    offset: f64,
}

/// The area vector of a polygon (Newell).
fn normal(corners: &[[f64; 3]]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (i, p) in corners.iter().enumerate() {
        let q = corners[(i + 1) % corners.len()];
        for (k, s) in sum.iter_mut().enumerate() {
            let (a, b) = ((k + 1) % 3, (k + 2) % 3);
            *s += (p[a] - q[a]) * (p[b] + q[b]);
        }
    }
    sum
}

impl Plane {
    fn of(piece: &Piece) -> Option<Plane> {
        let Piece::Face { corners, .. } = piece else { return None };
        let area = normal(corners);
        let length = dot(area, area).sqrt();
        if !(length > 0.0 && length.is_finite()) {
            return None;
        }
        let normal = area.map(|x| x / length);
        let offset = corners.iter().map(|p| dot(normal, *p)).sum::<f64>() / corners.len() as f64;
        Some(Plane { normal, offset })
    }

    /// On which side a point lies; what is nearer than the roundings of the planes of small faces
    /// lies on the plane.
    fn side(&self, p: [f64; 3], size: f64) -> f64 {
        let distance = dot(self.normal, p) - self.offset;
        if distance.abs() <= f64::from(1 << 20) * f64::EPSILON * size { 0.0 } else { distance }
    }

    /// Puts a piece behind, on or before the plane, or its parts.
    fn sort(&self, part: Part, size: f64, [behind, on, before]: [&mut Vec<Part>; 3]) {
        let sides: Vec<f64> = points(&part.piece).iter().map(|p| self.side(*p, size)).collect();
        let (below, above) = reach(&sides);
        match (below > 0.0, above > 0.0) {
            (false, false) => on.push(part),
            (true, false) => behind.push(part),
            (false, true) => before.push(part),
            // Nobody sees by how little it reaches over.
            (true, true) if below.min(above) <= size / UNSEEN => {
                if above > below {
                    before.push(part)
                } else {
                    behind.push(part)
                }
            }
            (true, true) => {
                for (sign, side) in [(-1.0, behind), (1.0, before)] {
                    let piece = cut(&part.piece, &sides, sign);
                    side.extend(piece.map(|piece| Part { piece, plane: part.plane.clone() }));
                }
            }
        }
    }
}

/// What is this part of the model's size in front of something else or behind it, is not seen.
pub(super) const UNSEEN: f64 = 4096.0;

/// How far points with these signed distances reach to both sides.
fn reach(sides: &[f64]) -> (f64, f64) {
    sides.iter().fold((0.0, 0.0), |(below, above): (f64, f64), s| (below.max(-s), above.max(*s)))
}

/// The plane of a face that cuts few others, out of a few.
fn splitter(set: &[Part], size: f64) -> Option<Plane> {
    const CANDIDATES: usize = 64;
    const WITNESSES: usize = 512;
    let faces: Vec<&Plane> = set.iter().filter_map(|part| part.plane.as_ref()).collect();
    if set.len() < 2 {
        return None;
    }
    let spread = |count: usize, of: usize| (0..count.min(of)).map(move |i| i * of / count.min(of));
    let planes = spread(CANDIDATES, faces.len()).map(|i| faces[i]);
    let cost = |plane: &&Plane| {
        let (mut cuts, mut sides) = (0, [0_i64; 2]);
        for i in spread(WITNESSES, set.len()) {
            let side = points(&set[i].piece).into_iter().map(|p| plane.side(p, size));
            let (below, above) = reach(&side.collect::<Vec<_>>());
            cuts += i64::from(below.min(above) > size / UNSEEN);
            sides[0] += i64::from(below > 0.0);
            sides[1] += i64::from(above > 0.0);
        }
        64 * cuts + (sides[0] - sides[1]).abs()
    };
    planes.min_by_key(cost).cloned()
}

/// The part of a piece on one side, with cuts that are not drawn.
fn cut(piece: &Piece, sides: &[f64], sign: f64) -> Option<Piece> {
    let between = |p: [f64; 3], q: [f64; 3], s: f64, t: f64| {
        let k = s / (s - t);
        [0, 1, 2].map(|i| p[i] + k * (q[i] - p[i]))
    };
    match piece {
        Piece::Segment { ends: [p, q], stroke } => {
            let cut = between(*p, *q, sides[0], sides[1]);
            let ends = if sides[0] * sign > 0.0 { [*p, cut] } else { [cut, *q] };
            Some(Piece::Segment { ends, stroke: *stroke })
        }
        Piece::Face { corners, drawn, paint, stroke } => {
            let (mut kept, mut edges) = (Vec::new(), Vec::new());
            for i in 0..corners.len() {
                let j = (i + 1) % corners.len();
                let (s, t) = (sides[i] * sign, sides[j] * sign);
                if s >= 0.0 {
                    kept.push(corners[i]);
                    // An edge that leaves goes on to the cut; one along the cut is an edge, too.
                    edges.push(drawn[i] && (s > 0.0 || t >= 0.0));
                }
                if s * t < 0.0 {
                    kept.push(between(corners[i], corners[j], s, t));
                    edges.push(drawn[i] && t > 0.0);
                }
            }
            let face = Piece::Face { corners: kept, drawn: edges, paint: *paint, stroke: *stroke };
            matches!(&face, Piece::Face { corners, .. } if corners.len() > 2).then_some(face)
        }
    }
}

fn items(piece: &Piece, view: &View) -> Vec<Item> {
    let (corners, drawn, paint, stroke) = match piece {
        Piece::Segment { ends, stroke } => {
            let points = ends.map(|p| view.project(p)).to_vec();
            return vec![Item::Polyline { points, stroke: *stroke }];
        }
        Piece::Face { corners, drawn, paint, stroke } => (corners, drawn, paint, stroke),
    };
    let flat: Vec<[f64; 2]> = corners.iter().map(|p| view.project(*p)).collect();
    let normal = normal(corners);
    let up = if normal[2] < 0.0 { normal.map(|x| -x) } else { normal };
    let fill = match paint {
        Paint::Sides([front, back]) => {
            let side = if view.sees(up) { front } else { back };
            Some(side.lit(view.light(normal)))
        }
        Paint::Flat(color) => Some(*color),
        Paint::Wire => None,
    };
    if drawn.iter().all(|d| *d) {
        return vec![Item::Polygon { corners: flat, fill, stroke: Some(*stroke) }];
    }
    let mut items = Vec::new();
    if let Some(color) = fill {
        // A hair of its own colour closes the seams between neighbours.
        let stroke = Some(Stroke::new(color, Scene::HAIR));
        items.push(Item::Polygon { corners: flat.clone(), fill, stroke });
    }
    let runs = drawn.iter().enumerate().filter(|(_, drawn)| **drawn);
    items.extend(runs.map(|(i, _)| {
        let points = vec![flat[i], flat[(i + 1) % flat.len()]];
        Item::Polyline { points, stroke: *stroke }
    }));
    items
}
