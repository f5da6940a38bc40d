//! Classes of triangulation, one mesh of each for every fineness.

use crate::construct::{NoTriangulation, delaunay};
use crate::mesh::{FaceList, Topology, TopologyError};
use crate::scalar::{Field, Rational, Ring};
use crate::space::{Point, TopView};

/// A class of triangulations of the plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Class {
    /// The oblique lattice of the vectors `(1, −1/5) h` and `(1/3, 1) h`: valence 6 everywhere.
    Lattice,
    /// The square lattice with all diagonals in direction `(1, 1)`.
    RightAngled,
    /// The combinatorics of a lattice under the smooth map
    /// `(u, v) ↦ (u + uv/10 + v²/6, v + u²/8)`.
    Mapped,
    /// The square lattice with alternating diagonals: valences 8 and 4.
    UnionJack,
    /// The Delaunay triangulation of independent uniform points.
    Delaunay,
}

/// A triangulation of one class whose inner part is looked at.
pub(super) struct Sample {
    pub topology: Topology,
    pub top_views: Vec<TopView<Rational>>,
    /// Whether a vertex is one to look at: not near the boundary.
    pub inner: Vec<bool>,
}

impl Class {
    /// All classes, in the order of reports.
    pub const ALL: [Class; 5] =
        [Class::Lattice, Class::RightAngled, Class::Mapped, Class::UnionJack, Class::Delaunay];

    /// The name on the command line and in reports.
    pub fn name(self) -> &'static str {
        match self {
            Class::Lattice => "lattice",
            Class::RightAngled => "right-angled",
            Class::Mapped => "mapped",
            Class::UnionJack => "union-jack",
            Class::Delaunay => "delaunay",
        }
    }

    /// The class of that name.
    pub fn from_name(name: &str) -> Option<Class> {
        Class::ALL.into_iter().find(|class| class.name() == name)
    }

    /// What theory says about (22) on the class.
    pub fn theory(self) -> &'static str {
        match self {
            Class::Lattice | Class::RightAngled => {
                "translation-invariant: exact for all quadratics, second order"
            }
            Class::Mapped => "regular, valence 6: second order",
            Class::UnionJack => {
                "H second order; K tends to det + f_xy² at valence 4 and to det - f_xy² at \
                 valence 8: only its average converges"
            }
            Class::Delaunay => {
                "neither H nor K converges pointwise: exact only for planes and i-spheres"
            }
        }
    }

    /// Whether H and K converge pointwise on this class for all smooth surfaces, by theory.
    pub fn converges(self) -> [bool; 2] {
        match self {
            Class::Lattice | Class::RightAngled | Class::Mapped => [true, true],
            Class::UnionJack => [true, false],
            Class::Delaunay => [false, false],
        }
    }

    /// The triangulation with mesh size `1/n`.
    pub(super) fn sample(self, n: u32, seed: u64) -> Result<Sample, NoTriangulation> {
        match self {
            Class::Delaunay => scattered(n, seed),
            _ => self.grid(n).map_err(|_| NoTriangulation::TooMany),
        }
    }

    fn grid(self, n: u32) -> Result<Sample, TopologyError> {
        let at = |i: u32, j: u32| i * (n + 1) + j;
        let mut faces = FaceList::new();
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            if self == Class::UnionJack && (i + j) % 2 == 1 {
                faces.push([a, b, d]);
                faces.push([b, c, d]);
            } else {
                faces.push([a, b, c]);
                faces.push([a, c, d]);
            }
        }
        let parameters = (0..=n).flat_map(|i| (0..=n).map(move |j| (i, j)));
        let ratio = |i: u32| Rational::from_ratio(i.into(), n.into());
        let place = |(i, j): (u32, u32)| self.place(&ratio(i), &ratio(j));
        let inner = |(i, j): (u32, u32)| [i, j].iter().all(|&k| 4 * k >= n && 4 * k <= 3 * n);
        let top_views: Vec<_> = parameters.clone().map(place).collect();
        let topology = Topology::new(top_views.len(), faces)?;
        Ok(Sample { topology, top_views, inner: parameters.map(inner).collect() })
    }

    fn place(self, u: &Rational, v: &Rational) -> TopView<Rational> {
        let over = |x: &Rational, q: i64| x * Rational::from_ratio(1, q);
        match self {
            Class::Lattice => TopView::new(u + over(v, 3), v - over(u, 5)),
            Class::Mapped => TopView::new(
                u + over(&(u * v), 10) + over(&v.square(), 6),
                v + over(&u.square(), 8),
            ),
            _ => TopView::new(u.clone(), v.clone()),
        }
    }
}

/// `n²` points with coordinates `k / 2^31` in the unit square.
fn scattered(n: u32, seed: u64) -> Result<Sample, NoTriangulation> {
    let mut state = seed;
    let mut coordinate = || Rational::from_ratio((splitmix(&mut state) >> 33) as i64, 1 << 31);
    let mut point = || Point::new(coordinate(), coordinate(), Rational::zero());
    let mesh = delaunay((0..n * n).map(|_| point()).collect())?;
    let (low, high) = (Rational::from_ratio(1, 4), Rational::from_ratio(3, 4));
    let inner = |p: &Point<Rational>| [&p.x, &p.y].into_iter().all(|c| *c >= low && *c <= high);
    Ok(Sample {
        inner: mesh.points.iter().map(inner).collect(),
        top_views: mesh.points.iter().map(Point::top_view).collect(),
        topology: mesh.topology,
    })
}

/// The next number of the generator splitmix64.
fn splitmix(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
