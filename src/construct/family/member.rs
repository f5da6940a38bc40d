//! One mesh of a family, with its Gauss image.

use std::error::Error;
use std::fmt;

use super::enclosed::{enclosed_hexagonal, enclosed_rotational};
use super::{BadValue, Family, Values};
use crate::construct::Enclosed;
use crate::construct::hexagonal::HexagonalRings;
use crate::construct::minimal::{
    MeshPair, Weierstrass, WeierstrassData, bonnet, enneper, helicoid, logarithmoid, saddle,
};
use crate::construct::rotational::{
    constant_mean_rings, negative_curvature_rings, positive_curvature_rings, rotational_pair,
};
use crate::construct::{
    circular_net, circumscribed_f_parallel, inscribed_f_parallel, lift, mean_gradient, metric_dual,
    quad_patch, translational_net,
};
use crate::mesh::{Data, FaceList, Mesh, VertexId};
use crate::net::Property;
use crate::pair::PairProperty;
use crate::scalar::{Approx, Ball, Field, Ordered, Rational, RationalField, Ring, Sign};
use crate::space::{Expression, Point, TopView, Vector2};

type Q = Rational;

/// A mesh of a family, and the mesh that stands for its Gauss image where there is one.
#[derive(Clone, Debug, PartialEq)]
pub struct Member {
    /// The mesh M.
    pub surface: Mesh<Q>,
    /// The mesh S.
    pub gauss: Option<Mesh<Q>>,
    /// Where M is not the mesh that was asked for, but encloses it: how.
    pub enclosure: Option<Enclosure>,
}

/// A mesh of constant K that is enclosed by a written one.
#[derive(Clone, Debug, PartialEq)]
pub struct Enclosure {
    /// The curvature K of the enclosed mesh.
    pub gauss: Q,
    /// The roots that its coordinates are linear in, from ring to ring.
    pub roots: Vec<Ball<Q>>,
    /// What no coordinate of a vertex is farther from the written one than.
    pub radius: Q,
    /// The least and the greatest K of the faces of the written mesh, where it is defined.
    pub written_gauss: Option<[Q; 2]>,
}

impl Member {
    pub(super) fn exact(surface: Mesh<Q>, gauss: Option<Mesh<Q>>) -> Self {
        Member { surface, gauss, enclosure: None }
    }

    /// Exact where all roots turned out to be rational.
    pub(super) fn enclosed(enclosed: Enclosed<Q>, gauss: Q) -> Self {
        let (radius, written_gauss) = (enclosed.radius(), enclosed.written_gauss());
        let Enclosed { mut pair, roots } = enclosed;
        if radius.is_zero() {
            pair.surface.data = Data::default();
            return Member::exact(pair.surface, Some(pair.gauss));
        }
        Member {
            surface: pair.surface,
            gauss: Some(pair.gauss),
            enclosure: Some(Enclosure { gauss, roots, radius, written_gauss }),
        }
    }

    /// What `check` proves of this member of the family, and of the pair: less than of the others
    /// where the mesh is enclosed.
    pub fn proves(&self, family: Family) -> (Vec<Property>, Vec<PairProperty>) {
        let (alone, pair) = family.proves();
        let exact = |p: &PairProperty| self.enclosure.is_none() || *p != PairProperty::ConstantK;
        (alone.to_vec(), pair.iter().copied().filter(exact).collect())
    }
}

/// Why a family has no such member.
#[derive(Debug)]
pub enum NoMember {
    /// A parameter without such a value.
    Value(BadValue),
    /// The construction does not go through with these values.
    Construction(Box<dyn Error + Send + Sync>),
}

impl fmt::Display for NoMember {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoMember::Value(reason) => reason.fmt(f),
            NoMember::Construction(reason) => reason.fmt(f),
        }
    }
}

impl Error for NoMember {}

impl From<BadValue> for NoMember {
    fn from(reason: BadValue) -> Self {
        NoMember::Value(reason)
    }
}

/// Whatever a construction says.
pub(super) fn no<E: Into<Box<dyn Error + Send + Sync>>>(reason: E) -> NoMember {
    NoMember::Construction(reason.into())
}

impl Family {
    /// The member with these rows and columns, or rings and sectors, and these values.
    ///
    /// ```
    /// use isogeo::construct::family::{Family, Values};
    /// let family = Family::from_name("logarithmoid").unwrap_or(Family::Saddle);
    /// let given = [("half-angle".to_owned(), "4/5,3/5".to_owned())];
    /// let member = Values::new(family, &given).ok().and_then(|v| family.member([2, 3], &v).ok());
    /// assert_eq!(member.map(|m| m.surface.points[8].z.to_string()), Some("12/5".to_owned()));
    /// ```
    ///
    /// # Errors
    /// A value that is none, or with which the construction meets something singular.
    pub fn member(self, [m, n]: [usize; 2], values: &Values) -> Result<Member, NoMember> {
        match self {
            Family::Paraboloid => paraboloid([m, n], values),
            Family::Saddle => whole(saddle(m, n)),
            Family::Enneper => whole(enneper(m, n, &values.top_view("center")?)),
            Family::Logarithmoid => whole(logarithmoid(m, n, &values.half_angle()?)),
            Family::Helicoid => {
                let surface = helicoid(m, n, &values.half_angle()?).map_err(no)?;
                Ok(Member::exact(surface, None))
            }
            Family::Bonnet => {
                whole(bonnet(m, n, &values.half_angle()?, &values.top_view("center")?))
            }
            Family::Weierstrass => {
                small([m, n], 6)?;
                let mean = values.number("mean")?;
                let data = holomorphic_data([m, n], values.seed("seed")?);
                whole(Weierstrass::new(&data).and_then(|data| data.constant_mean(&mean)))
            }
            Family::CircularNet => {
                small([m, n], 6)?;
                let surface = random_circular_net([m, n], values.seed("seed")?)?;
                let start = VertexId((m / 2 * (n + 1) + n / 2) as u32);
                let mean = mean_gradient(&surface, start).map_err(no)?;
                let mean = mean.ok_or_else(|| no("there is no face"))?;
                let pair = inscribed_f_parallel(&surface, start, &mean).map_err(no)?;
                let gauss = Some(pair.into_image());
                Ok(Member::exact(surface, gauss))
            }
            Family::ConicalNet => {
                small([m, n], 4)?;
                let net = random_circular_net([m + 1, n + 1], values.seed("seed")?)?;
                let surface = metric_dual(&net).map_err(no)?;
                let pair = circumscribed_f_parallel(&surface).map_err(no)?.pair;
                let gauss = Some(pair.into_image());
                Ok(Member::exact(surface, gauss))
            }
            Family::TriangleGraph => triangle_graph([m, n], values),
            Family::RotationalCmc => {
                let half_angle = values.half_angle()?;
                let radii: Vec<Q> = (0..=m).map(|k| ratio(k + 4, 8)).collect();
                let (mean, integral) = (values.number("mean")?, values.non_zero("integral")?);
                let rings = constant_mean_rings(&radii, &mean, &integral);
                let rings = rings.ok_or_else(|| no("a radius is 0"))?;
                whole(rotational_pair(&rings, &half_angle.then(&half_angle), n))
            }
            Family::RotationalConstantK => rotational_constant_gauss([m, n], values),
            Family::HexMinimal | Family::HexCmc | Family::HexConstantK => {
                hexagonal(self, [m, n], values)
            }
        }
    }
}

/// Refuses nets whose numbers would have too many digits to be read again.
fn small(size: [usize; 2], most: usize) -> Result<(), NoMember> {
    if size.iter().all(|&n| n <= most) {
        return Ok(());
    }
    Err(no(format!("digits grow exponentially with the size: at most {most}x{most} faces")))
}

fn integer(n: usize) -> Q {
    Q::from_i64(n as i64)
}

pub(super) fn ratio(p: usize, q: usize) -> Q {
    Q::from_ratio(p as i64, q as i64)
}

fn whole<E: Into<Box<dyn Error + Send + Sync>>>(
    pair: Result<MeshPair<Q>, E>,
) -> Result<Member, NoMember> {
    let MeshPair { surface, gauss } = pair.map_err(no)?;
    Ok(Member::exact(surface, Some(gauss)))
}

/// Positions from −1 to 1.
fn positions(steps: usize) -> impl Iterator<Item = Q> {
    (0..=steps).map(move |i| Q::from_ratio(2 * i as i64 - steps as i64, steps.max(1) as i64))
}

fn paraboloid([m, n]: [usize; 2], values: &Values) -> Result<Member, NoMember> {
    let half = Q::from_ratio(1, 2);
    let [a, b] = values.pair("curvatures")?;
    let profile = |steps, curvature: &Q| -> Vec<(Q, Q)> {
        positions(steps).map(|x| (x.clone(), x.square() * &half * curvature)).collect()
    };
    let image = |profile: &[(Q, Q)], curvature: &Q| -> Vec<(Q, Q)> {
        profile.iter().map(|(x, f)| (x * curvature, f * curvature)).collect()
    };
    let (f, g) = (profile(m, &a), profile(n, &b));
    let surface = translational_net(&f, &g).map_err(no)?;
    let gauss = translational_net(&image(&f, &a), &image(&g, &b)).map_err(no)?;
    Ok(Member::exact(surface, Some(gauss)))
}

fn triangle_graph([m, n]: [usize; 2], values: &Values) -> Result<Member, NoMember> {
    let formula: Result<Expression, _> = values.text("formula").parse();
    let formula = formula.ok().filter(Expression::is_rational);
    let formula =
        formula.ok_or_else(|| values.bad("formula", "a formula of + - * / ^ in x and y"))?;
    let step = values.non_zero("step")?;
    let half = Q::from_ratio(1, 2);
    let along = |i: usize, steps: usize| (integer(i) - integer(steps) * &half) * &step;
    let mut points = Vec::new();
    for i in 0..=m {
        for j in 0..=n {
            let at = TopView::new(along(i, m), along(j, n));
            let height = formula.height_at(&at);
            let height = height.ok_or_else(|| no("the formula has no value at a vertex"))?;
            points.push(at.at_height(height));
        }
    }
    let quads = Mesh::new(points, quad_patch(m, n)).map_err(no)?;
    let mut faces = FaceList::new();
    for face in quads.topology.faces() {
        if let [a, b, c, d] = *quads.topology.face(face) {
            faces.push([a.0, b.0, c.0]);
            faces.push([a.0, c.0, d.0]);
        }
    }
    let surface = Mesh::new(quads.points, faces).map_err(no)?;
    let gauss = Some(lift(&surface));
    Ok(Member::exact(surface, gauss))
}

/// Exact where the square roots of |K|, and for negative K of C, are rational.
fn rotational_constant_gauss([m, n]: [usize; 2], values: &Values) -> Result<Member, NoMember> {
    let half_angle = values.half_angle()?;
    let (gauss, integral) = (values.non_zero("curvature")?, values.non_zero("integral")?);
    let sector = half_angle.then(&half_angle);
    let Some(root) = gauss.magnitude().root() else {
        return enclosed_rotational([m, n], values, &sector);
    };
    let rings = if gauss.certain_sign() == Some(Sign::Negative) {
        let Some(amplitude) = integral.root() else {
            return enclosed_rotational([m, n], values, &sector);
        };
        let parameters: Vec<Q> = (0..=m).map(|k| ratio(m + 1 - k, m + 2)).collect();
        negative_curvature_rings(&parameters, &root, &(amplitude * &root))
    } else {
        let parameters: Vec<Q> = (0..=m).map(|k| ratio(k + 9, 8) * &root).collect();
        positive_curvature_rings(&parameters, &root, &(integral * gauss))
    };
    let rings = rings.ok_or_else(|| no("a radius is not defined"))?;
    whole(rotational_pair(&rings, &sector, n))
}

/// Hexagons whose slopes grow by 3/2 from ring to ring.
fn hexagonal(family: Family, [m, n]: [usize; 2], values: &Values) -> Result<Member, NoMember> {
    let grow = Q::from_ratio(3, 2);
    let slopes = std::iter::successors(Some(Q::one()), |slope| Some(slope * &grow));
    let rings =
        HexagonalRings::new(values.half_angle()?, slopes.take(m + 2).collect()).map_err(no)?;
    let integral = values.non_zero("integral")?;
    let round = rings.circumscribed();
    let products = rings.products().iter().map(|product| product * &integral);
    let singular = || no("a step is 0");
    let (steps, image) = match family {
        Family::HexCmc => {
            let mean = values.non_zero("mean")?;
            // The larger root of H δ² − δ̂ δ + C AB = 0, rounded: then δ̂ moves a little.
            let step = |(d, product): (&Q, Q)| {
                let h = mean.to_f64();
                let root = (d.to_f64() * d.to_f64() - 4.0 * h * product.to_f64()).sqrt();
                rounded((d.to_f64() + root) / (2.0 * h))
            };
            let steps = round.iter().zip(products).map(step).collect::<Result<Vec<_>, _>>()?;
            let image = rings.constant_mean(&steps, &mean, &integral).ok_or_else(singular)?;
            (steps, image)
        }
        Family::HexConstantK => {
            let Some(root) = values.non_zero("curvature")?.root() else {
                return enclosed_hexagonal(n, values, &rings);
            };
            // q − p = 2 δ̂/k and pq = C AB, rounded.
            let factor = |(d, product): (&Q, Q)| {
                let d = d.to_f64() / root.to_f64();
                rounded((d * d + product.to_f64()).sqrt() - d)
            };
            let factors = round.iter().zip(products).map(factor).collect::<Result<Vec<_>, _>>()?;
            rings.constant_gauss(&factors, &root, &integral).ok_or_else(singular)?
        }
        _ => (rings.minimal(&round, &integral).ok_or_else(singular)?, round),
    };
    whole(rings.pair(&steps, &image, n))
}

/// A fraction near a number that is not rational.
fn rounded(number: f64) -> Result<Q, NoMember> {
    const PARTS: i64 = 4096;
    let parts = (number * PARTS as f64).round();
    if parts == 0.0 || parts.is_nan() || parts.abs() > (1u64 << 53) as f64 {
        return Err(no("with these parameters a step is no real number of moderate size"));
    }
    Ok(Q::from_ratio(parts as i64, PARTS))
}

/// Small fractions that look random: the same for the same seed.
struct Chance(u64);

impl Chance {
    /// A whole number from −range to range.
    fn within(&mut self, range: i64) -> i64 {
        // The generator of Steele, Lea and Flood (SplitMix64).
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % (2 * range as u64 + 1)) as i64 - range
    }

    fn near(&mut self, n: usize, parts: i64) -> Q {
        integer(n) + Q::from_ratio(self.within(1), parts)
    }
}

fn holomorphic_data([m, n]: [usize; 2], seed: u64) -> WeierstrassData<Q> {
    let mut chance = Chance(seed);
    let mut near = |i, j| Vector2::new(chance.near(i, 128), chance.near(j, 128));
    let rows = (0..=m).map(|i| near(i, 0)).collect();
    let columns = (1..=n).map(|j| near(0, j)).collect();
    let mut factor = |sign: i64| Q::from_ratio(sign * (64 + chance.within(1)), 64);
    let alpha = (0..m).map(|_| factor(1)).collect();
    let beta = (0..n).map(|_| factor(-1)).collect();
    WeierstrassData { rows, columns, alpha, beta }
}

fn random_circular_net([m, n]: [usize; 2], seed: u64) -> Result<Mesh<Q>, NoMember> {
    let mut chance = Chance(seed);
    let mut near = |i: usize, j: usize| {
        let (x, y) = (chance.near(i, 128), chance.near(j, 128));
        let bowl = integer(i * i + 2 * j * j) * Q::from_ratio(1, 8);
        let z = bowl + Q::from_ratio(chance.within(1), 128);
        Point::new(x, y, z)
    };
    let rows: Vec<_> = (0..=m).map(|i| near(i, 0)).collect();
    let corner = rows[0].clone();
    let columns: Vec<_> = std::iter::once(corner).chain((1..=n).map(|j| near(0, j))).collect();
    let factors: Vec<i64> = (0..m * n).map(|_| 64 + chance.within(1)).collect();
    let net = circular_net(&rows, &columns, |i, j| Q::from_ratio(factors[i * n + j], 128));
    let net = net.ok_or_else(|| no("the net meets a degenerate face: another seed may do"))?;
    let mesh = net.map_err(no)?;
    Ok(Mesh { data: Data::default(), ..mesh })
}
