//! The Delaunay triangulation of scattered points, exactly and canonically.
//!
//! A fast triangulation of rounded places says who may be joined to whom; it is taken as a guess.
//! Then every sign is decided again on the exact points, by the residuals of
//! [`net::delaunay`](crate::net::delaunay): edges are flipped until the lift to Σ is convex,
//! triangles that were inverted by rounding are repaired, points that fell together are
//! added. Where the guess cannot be repaired, the points are added one by one to an empty plane.

#[cfg(feature = "delaunay")]
mod guess;
mod lawson;
mod sites;
mod sphere;
mod ties;

use std::fmt;

use lawson::{Lawson, Survey};
use sites::{Signs, Sites};
use sphere::Sphere;

use crate::mesh::{FaceList, Mesh, TopologyError, VertexId};
use crate::net::planar::ProjectedArea;
use crate::scalar::{Rational, Sign};
use crate::space::Point;

/// Why points have no Delaunay triangulation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoTriangulation {
    /// Fewer than three points.
    TooFew {
        /// How many there are.
        found: usize,
    },
    /// Two points with the same top view: no graph goes through both.
    SameTopView(VertexId, VertexId),
    /// All top views lie on one line.
    Collinear,
    /// More than 32 bits can count.
    TooMany,
}

impl fmt::Display for NoTriangulation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoTriangulation::TooFew { found } => {
                write!(f, "a triangulation needs at least 3 points, there are {found}")
            }
            NoTriangulation::SameTopView(a, b) => {
                write!(f, "points {} and {} have the same top view", a.0, b.0)
            }
            NoTriangulation::Collinear => write!(f, "the top views of all points lie on one line"),
            NoTriangulation::TooMany => write!(f, "too many points"),
        }
    }
}

impl std::error::Error for NoTriangulation {}

/// The Delaunay triangulation of the top views: a triangle mesh over their convex hull that has no
/// vertex inside a circumcircle.
///
/// Vertices keep the order of the points. Faces run counter-clockwise, each from its
/// lexicographically lowest top view, and are sorted by these; points on one empty circle are
/// joined to the lowest of them. So the mesh depends on the set of points alone. Heights play no
/// part, and points on an edge of the hull are vertices of it.
///
/// Near-linear in time for well spread points: `O(n log n)`, with a big-number evaluation only
/// where doubles cannot tell a sign.
///
/// ```
/// use isogeo::construct::delaunay;
/// use isogeo::mesh::{FaceId, VertexId};
/// use isogeo::scalar::{Rational, Ring};
/// use isogeo::space::Point;
/// let point = |x, y, z| Point::new(x, y, z).map(|&c| Rational::from_i64(c));
/// // The four corners of a square lie on a circle: the lowest, vertex 2, decides.
/// let mesh = delaunay(vec![point(1, 0, 5), point(1, 1, 0), point(0, 0, 0), point(0, 1, 7)])?;
/// assert_eq!(mesh.topology.face(FaceId(0)), [2, 0, 1].map(VertexId));
/// assert_eq!(mesh.topology.face(FaceId(1)), [2, 1, 3].map(VertexId));
/// # Ok::<(), isogeo::construct::NoTriangulation>(())
/// ```
///
/// # Errors
/// See [`NoTriangulation`].
pub fn delaunay(points: Vec<Point<Rational>>) -> Result<Mesh<Rational>, NoTriangulation> {
    let sites = Sites::new(&points)?;
    let signs = sites.signs();
    #[cfg(feature = "delaunay")]
    let guess = guess::triangulation(sites.near());
    #[cfg(not(feature = "delaunay"))]
    let guess = None;
    let mut faces = FaceList::new();
    for triangle in triangulate(guess, &sites, &signs)? {
        faces.push(triangle.map(|rank| sites.order[rank as usize]));
    }
    Mesh::new(points, faces).map_err(|error| match error {
        TopologyError::TooLarge => NoTriangulation::TooMany,
        // Triangles of a triangulated region are an oriented mesh, so nothing else can come.
        _ => NoTriangulation::Collinear,
    })
}

/// The triangles by rank, from a guess or from nothing.
fn triangulate(
    guess: Option<Sphere>,
    sites: &Sites,
    signs: &Signs<'_>,
) -> Result<Vec<[u32; 3]>, NoTriangulation> {
    let n = sites.near().len();
    let repaired = guess.and_then(|sphere| repaired(sphere, signs));
    let (mut lawson, survey) = match repaired {
        Some((lawson, survey)) => (lawson, Some(survey)),
        None => (Lawson { sphere: first_triangle(n, signs)?, signs }, None),
    };
    let missing: Vec<u32> = (0..n as u32).filter(|&v| !lawson.sphere.contains(v)).collect();
    let survey = survey.filter(|_| missing.is_empty());
    let mut near = 0;
    for v in along_a_curve(missing, sites.near()) {
        lawson.insert(v, near);
        near = lawson.sphere.outgoing(v);
    }
    let survey = survey.unwrap_or_else(|| lawson.survey());
    Ok(ties::canonical_faces(&lawson.sphere, &survey.ties))
}

/// The guess made Delaunay by flips, with nothing left to flip; `None` where it is too far from it.
fn repaired<'a>(sphere: Sphere, signs: &'a Signs<'a>) -> Option<(Lawson<'a>, Survey)> {
    let mut lawson = Lawson { sphere, signs };
    let mut survey = lawson.survey();
    if !survey.flips.is_empty() {
        // A guess that is worth repairing is nearly right.
        let budget = lawson.sphere.len() as usize;
        if !lawson.settle(survey.flips, budget) {
            return None;
        }
        survey = lawson.survey();
    }
    (survey.flips.is_empty() && lawson.covers_its_hull()).then_some((lawson, survey))
}

/// The triangle of the first two places and the first that is not on their line.
fn first_triangle(n: usize, signs: &Signs<'_>) -> Result<Sphere, NoTriangulation> {
    let turn = |v: u32| signs.sign(ProjectedArea::TopView, [0, 1, v]);
    for v in 2..n as u32 {
        match turn(v) {
            Sign::Positive => return Ok(Sphere::of_triangle(n, [0, 1, v])),
            Sign::Negative => return Ok(Sphere::of_triangle(n, [0, v, 1])),
            Sign::Zero => {}
        }
    }
    Err(NoTriangulation::Collinear)
}

/// The places in the order of a curve that fills the unit square, so that walks are short.
fn along_a_curve(mut ranks: Vec<u32>, near: &[[f64; 2]]) -> Vec<u32> {
    let key = |&v: &u32| {
        let [x, y] = near[v as usize].map(|c| (c * f64::from(1u32 << 31)) as u32);
        (0..32).fold(0u64, |key, bit| {
            key | u64::from(x >> bit & 1) << (2 * bit) | u64::from(y >> bit & 1) << (2 * bit + 1)
        })
    };
    ranks.sort_by_cached_key(key);
    ranks
}
