//! Circle patterns from combinatorics: orthogonal vertex and face circles of a mesh, in doubles
//! (Sec. 3.4, Fig. 6).
//!
//! The vertex circles touch along the edges, the face circles touch at the same points, and where a
//! vertex circle and a face circle meet they are orthogonal. Lifted to Σ, the vertex circles are the
//! vertices and the face circles the faces of an i-Koebe mesh. The radii are the minimum of a convex
//! function of their logarithms (Bobenko and Springborn, *Variational principles for circle patterns
//! and Koebe's theorem*, 2004); Newton's method finds it, with conjugate gradients that multigrid
//! preconditions, so that the cost grows with the number of circles.

mod angles;
mod conjugate_gradients;
mod envelope;
mod koebe;
mod layout;
mod multigrid;
mod reduced;
mod sparse;

use std::f64::consts::{PI, TAU};
use std::fmt;

use crate::mesh::{HalfEdge, Topology, VertexId, VertexKind};
pub use angles::CircleCondition;
use angles::{Circles, Linearised};
pub use koebe::Koebe;
pub use layout::Layout;
use multigrid::Multigrid;
use reduced::Reduced;

/// The radii of an orthogonal circle pattern, correct up to `defect`.
///
/// ```
/// use std::f64::consts::TAU;
/// use isogeo::construct::{CircleCondition, CirclePattern, quad_patch};
/// use isogeo::mesh::Topology;
/// // Boundary circles of radius 1 around a patch of squares: all others have radius 1, too.
/// let mesh = Topology::new(16, quad_patch(3, 3))?;
/// let pattern = CirclePattern::disc(&mesh, |_| CircleCondition::Radius(1.0));
/// let radii = pattern.map(|p| p.vertex_radii[5]);
/// assert!(radii.is_ok_and(|r| (r - 1.0).abs() < 1.0 / (1u64 << 40) as f64));
/// # Ok::<(), isogeo::mesh::TopologyError>(())
/// ```
#[derive(Clone, Debug)]
pub struct CirclePattern<'a> {
    topology: &'a Topology,
    asked: Vec<CircleCondition>,
    /// The radii of the vertex circles; infinite for lines.
    pub vertex_radii: Vec<f64>,
    /// The radii of the face circles; infinite for lines.
    pub face_radii: Vec<f64>,
    /// The largest amount by which an angle misses what was asked, in radians.
    pub defect: f64,
    /// The Newton steps, and in each the steps of the conjugate gradients.
    pub steps: Vec<usize>,
}

/// Why there is no circle pattern.
#[derive(Clone, Debug, PartialEq)]
pub enum NoPattern {
    /// A radius or an angle that is not positive and finite.
    NotPositive(usize),
    /// Without a given radius, the angles must add up to π for every corner of a face.
    AngleSum {
        /// The angles that were asked for.
        asked: f64,
        /// What they must be.
        possible: f64,
    },
    /// Circles that ask together for at least as much angle as their kites can have: they shrink to
    /// nothing. Vertices, then faces after the last vertex.
    TooMuch(Vec<usize>),
    /// The method stopped without a reason that it can name, at this defect.
    Stopped(f64),
}

impl fmt::Display for NoPattern {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoPattern::NotPositive(circle) => {
                write!(f, "what is asked of circle {circle} is not positive")
            }
            NoPattern::AngleSum { asked, possible } => {
                write!(f, "the angles add up to {asked}, but every pattern has {possible}")
            }
            NoPattern::TooMuch(circles) => {
                let few: Vec<String> = circles.iter().take(8).map(usize::to_string).collect();
                let more = if circles.len() > few.len() { ", ..." } else { "" };
                write!(
                    f,
                    "{} circles ask for more angle than their kites have: {}{more}",
                    circles.len(),
                    few.join(", ")
                )
            }
            NoPattern::Stopped(defect) => {
                write!(f, "no pattern was found: angles are wrong by {defect}")
            }
        }
    }
}

impl std::error::Error for NoPattern {}

impl<'a> CirclePattern<'a> {
    /// The pattern of a disc: circles close at faces and interior vertices, and `boundary` says what
    /// is asked of the others, a radius or an angle.
    ///
    /// # Errors
    /// See [`NoPattern`].
    pub fn disc(
        topology: &'a Topology,
        boundary: impl Fn(VertexId) -> CircleCondition,
    ) -> Result<Self, NoPattern> {
        let vertex = |v| match topology.kind(v) {
            VertexKind::Interior => CircleCondition::Angle(TAU),
            // No kite: any radius will do.
            VertexKind::Isolated => CircleCondition::Radius(1.0),
            VertexKind::Boundary | VertexKind::Pinched => boundary(v),
        };
        let mut asked: Vec<CircleCondition> = topology.vertices().map(vertex).collect();
        asked.extend(topology.faces().map(|_| CircleCondition::Angle(TAU)));
        Self::solve(topology, asked)
    }

    /// The pattern of a closed mesh on the sphere, seen from the point where two vertex circles and
    /// two face circles meet on the edge from `first`: these four are the sides of a rectangle.
    ///
    /// It exists, and is unique up to scale, for the mesh of a convex polyhedron (Koebe).
    ///
    /// # Errors
    /// See [`NoPattern`]; a mesh that is not closed has circles that do not.
    pub fn sphere(topology: &'a Topology, first: VertexId) -> Result<Self, NoPattern> {
        let mut asked =
            vec![CircleCondition::Angle(TAU); topology.vertex_count() + topology.face_count()];
        if let Some(h) = topology.star(first).next()
            && let Some(twin) = topology.twin(h)
        {
            let face = |h| topology.vertex_count() + topology.face_at(h).index();
            for circle in [first.index(), topology.target(h).index(), face(h), face(twin)] {
                asked[circle] = CircleCondition::Line;
            }
        }
        Self::solve(topology, asked)
    }

    /// The pattern with what is asked of every vertex, then of every face.
    ///
    /// # Errors
    /// See [`NoPattern`].
    pub fn solve(
        topology: &'a Topology,
        mut asked: Vec<CircleCondition>,
    ) -> Result<Self, NoPattern> {
        let positive = |circle: &CircleCondition| match circle {
            CircleCondition::Radius(x) | CircleCondition::Angle(x) => x.is_finite() && *x > 0.0,
            CircleCondition::Line => true,
        };
        if let Some(circle) = asked.iter().position(|c| !positive(c)) {
            return Err(NoPattern::NotPositive(circle));
        }
        let mut pinned = None;
        if !asked.iter().any(|c| matches!(c, CircleCondition::Radius(_))) {
            check_angle_sum(topology, &asked)?;
            // The scale is free; the angle of this circle follows from the others.
            if let Some(circle) = asked.iter().position(|c| c.is_free()) {
                pinned = Some((circle, asked[circle]));
                asked[circle] = CircleCondition::Radius(1.0);
            }
        }
        let mut circles = Circles::new(topology, asked);
        // Inside of the thread pool, so that the many small parallel loops do not have to wake it up.
        let Found { x, mut defect, steps } = rayon::scope(|_| newton(&circles))?;
        if let Some((circle, condition)) = pinned {
            circles.asked[circle] = condition;
            defect = largest(&circles.linearise(&x).excess);
        }
        let asked = circles.asked;
        let radius = |(x, asked): (&f64, &CircleCondition)| match asked {
            CircleCondition::Line => f64::INFINITY,
            _ => x.exp(),
        };
        let mut vertex_radii: Vec<f64> = x.iter().zip(&asked).map(radius).collect();
        let face_radii = vertex_radii.split_off(topology.vertex_count());
        let defect = 2.0 * defect;
        Ok(CirclePattern { topology, asked, vertex_radii, face_radii, defect, steps })
    }

    /// The combinatorics.
    pub fn topology(&self) -> &'a Topology {
        self.topology
    }

    /// What was asked of the circles.
    pub fn asked(&self) -> &[CircleCondition] {
        &self.asked
    }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m, x| if x.abs() > m || x.is_nan() { x.abs() } else { m })
}

/// Every kite has the angles `2 arctan(ρ/r)` and `2 arctan(r/ρ)`, together π; beside a line one of
/// them is π, between two lines both are nothing.
fn check_angle_sum(topology: &Topology, asked: &[CircleCondition]) -> Result<(), NoPattern> {
    let mut possible = 0.0;
    for face in topology.faces() {
        let lines = |circle: &CircleCondition| *circle == CircleCondition::Line;
        let own = lines(&asked[topology.vertex_count() + face.index()]);
        let kites = topology.face(face).iter().filter(|v| !(own && lines(&asked[v.index()])));
        possible += PI * kites.count() as f64;
    }
    let sum: f64 = asked
        .iter()
        .filter_map(|c| match c {
            CircleCondition::Angle(angle) => Some(*angle),
            CircleCondition::Radius(_) | CircleCondition::Line => None,
        })
        .sum();
    // What the sums of so many roundings may differ by.
    let rounding = f64::EPSILON * possible.max(1.0) * (asked.len() as f64).sqrt();
    if (sum - possible).abs() > 8.0 * rounding {
        return Err(NoPattern::AngleSum { asked: sum, possible });
    }
    Ok(())
}

/// Where Newton's method ended.
struct Found {
    /// The logarithms of the radii.
    x: Vec<f64>,
    /// The largest excess of a half angle.
    defect: f64,
    steps: Vec<usize>,
}

fn newton(circles: &Circles<'_>) -> Result<Found, NoPattern> {
    const MOST: usize = 60;
    /// A step does not change a radius by more than this factor's logarithm.
    const LONGEST: f64 = 3.0;
    let reduced = Reduced::new(circles);
    let (mut x, mut multigrid) = start(circles, &reduced);
    let mut steps = Vec::new();
    let mut at = circles.linearise(&x);
    let mut defect = largest(&at.excess);
    // What is left of sums of a few angles of size π.
    let rounding = 16.0 * f64::EPSILON * PI;
    let mut arrived = defect <= rounding;
    while !arrived && steps.len() < MOST {
        let (matrix, right) = reduced.system(&at);
        let solver = multigrid.take().unwrap_or_else(|| Multigrid::new(&matrix));
        // No more digits than the step can make use of.
        let tolerance = defect.max(rounding / defect).min(0.02);
        let found = conjugate_gradients::solve(&matrix, &solver, &right, tolerance);
        steps.push(found.steps);
        // That of an earlier step serves as long as it works well.
        let patience = if solver.is_factor() { 6 } else { 30 };
        if found.steps <= patience {
            multigrid = Some(solver);
        }
        let step = reduced.expand(&found.x, &at);
        let length = largest(&step);
        if length.is_nan() {
            return Err(NoPattern::Stopped(2.0 * defect));
        }
        let slope = |at: &Linearised| conjugate_gradients::dot(&at.excess, &step);
        let begin = slope(&at);
        let mut factor = (LONGEST / length).min(1.0);
        let next = loop {
            let trial: Vec<f64> = x.iter().zip(&step).map(|(x, s)| x + factor * s).collect();
            let there = circles.linearise(&trial);
            // The function is convex: far enough where it does not climb steeply again.
            if slope(&there) >= -0.5 * begin || factor * length <= rounding {
                break (trial, there);
            }
            factor /= 2.0;
        };
        let reached = largest(&next.1.excess);
        // Where the angles get no better any more, nothing but rounding is left.
        arrived = reached >= defect && defect <= 1024.0 * rounding;
        if !arrived {
            (x, at) = next;
            defect = reached;
            arrived = defect <= rounding;
        }
    }
    // Angles are met in the limit, too, where radii run away and no kite is left.
    if arrived && reduced.stiffness(&at) > 4096.0 * rounding {
        return Ok(Found { x, defect, steps });
    }
    Err(diverged(circles, &x, 2.0 * defect))
}

/// Logarithms to begin with: those of the given radii, spread as a harmonic function; and what has
/// solved for them. As long as neighbours have similar radii, all systems are near this one.
fn start(circles: &Circles<'_>, reduced: &Reduced<'_>) -> (Vec<f64>, Option<Multigrid>) {
    let given = |asked: &CircleCondition| match asked {
        CircleCondition::Radius(radius) => Some(radius.ln()),
        CircleCondition::Angle(_) | CircleCondition::Line => None,
    };
    let known: Vec<f64> = circles.asked.iter().filter_map(given).collect();
    let mean = known.iter().sum::<f64>() / known.len().max(1) as f64;
    let mut x: Vec<f64> = circles.asked.iter().map(|c| given(c).unwrap_or(mean)).collect();
    if known.iter().all(|&k| k == mean) {
        return (x, None);
    }
    let at = circles.harmonic(&x);
    let (matrix, right) = reduced.system(&at);
    let solver = Multigrid::new(&matrix);
    let found = conjugate_gradients::solve(&matrix, &solver, &right, 0.01);
    let step = reduced.expand(&found.x, &at);
    x.iter_mut().zip(&step).for_each(|(x, s)| *x += s);
    (x, Some(solver))
}

/// The circles that run away towards radius 0 ask for too much: those below the largest gap.
fn diverged(circles: &Circles<'_>, x: &[f64], defect: f64) -> NoPattern {
    let mut order: Vec<usize> =
        (0..x.len()).filter(|&i| circles.asked[i] != CircleCondition::Line).collect();
    order.sort_by(|&a, &b| x[a].total_cmp(&x[b]));
    let gap = |k: &usize| x[order[k + 1]] - x[order[*k]];
    let widest = (0..order.len().saturating_sub(1)).max_by(|a, b| gap(a).total_cmp(&gap(b)));
    let Some(widest) = widest else { return NoPattern::Stopped(defect) };
    let mut small: Vec<usize> = order[..=widest].to_vec();
    let mut is_small = vec![false; x.len()];
    small.iter().for_each(|&i| is_small[i] = true);
    if small.iter().any(|&i| !circles.asked[i].is_free()) {
        return NoPattern::Stopped(defect);
    }
    let asked: f64 = small
        .iter()
        .map(|&i| match circles.asked[i] {
            CircleCondition::Angle(angle) => angle,
            CircleCondition::Radius(_) | CircleCondition::Line => 0.0,
        })
        .sum();
    let kites = (0..circles.topology.corner_count() as u32).filter(|&c| {
        let (v, f) = circles.ends(HalfEdge(c));
        is_small[v] || is_small[f]
    });
    let possible = PI * kites.count() as f64;
    if asked < possible - f64::EPSILON * possible * small.len() as f64 {
        return NoPattern::Stopped(defect);
    }
    small.sort_unstable();
    NoPattern::TooMuch(small)
}
