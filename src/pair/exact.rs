//! Forms and curvatures of exact pairs, fast: cleared of denominators, computed in integers.
//!
//! The functions are those of the other files ([`Forms::of`], [`star_forms`]), run over
//! [`Wide`] integers. Nothing is reduced, so the result is an unreduced [`Fraction`]; its sign and
//! its nearest double cost little, lowest terms are made on demand.

use super::cleared::{Cleared, cleared};
use super::units::Units;
use super::{
    Curvatures, FaceForms, Forms, OffsetResiduals, Ray, VertexForms, VertexUndefined, ZeroArea,
    star_forms, star_forms_widened, twice_area,
};
use crate::mesh::{ExactPoints, FaceId, Lattice, Topology, VertexId, VertexKind, spanning_plane};
use crate::scalar::{
    BigInt, Bounded, Field, Fraction, Narrow, Ordered, Rational, RationalField, Ring, Sign, Wide,
};
use crate::space::{Point, TopView, Vector2};

/// A mesh M and its image S in exact numbers.
///
/// Nothing is asked of S but the combinatorics of M: that the meshes are f-parallel or v-parallel
/// is for [`FParallel`](super::FParallel) and [`VParallel`](super::VParallel) to check. For others
/// the forms at faces are areas of top views all the same; at vertices S has the top view of M.
///
/// ```
/// use isogeo::mesh::{ExactPoints, FaceList, Mesh, VertexId};
/// use isogeo::pair::ExactPair;
/// use isogeo::scalar::{Rational, Ring};
/// use isogeo::space::Point;
/// // A pyramid of height 3 over the square (±1, ±1); that of its lift has height 1.
/// let mut faces = FaceList::new();
/// (0..4).for_each(|i| faces.push([0, 1 + i, 1 + (i + 1) % 4]));
/// let at = |x, y, z| Point::new(x, y, z).map(|&n| Rational::from_i64(n));
/// let points = vec![at(0, 0, 0), at(1, 1, 3), at(-1, 1, 3), at(-1, -1, 3), at(1, -1, 3)];
/// let mesh = Mesh::new(points, faces)?;
/// let pair = ExactPair::lifted(&mesh.topology, ExactPoints::from(&mesh.points[..]));
/// let curvatures = pair.vertex_curvatures(VertexId(0)).map(|c| c.reduced::<Rational>());
/// assert_eq!(curvatures.map(|c| c.map(|c| c.mean)), Ok(Some(Rational::from_i64(3))));
/// # Ok::<(), isogeo::mesh::TopologyError>(())
/// ```
#[derive(Clone, Debug)]
pub struct ExactPair<'a> {
    topology: &'a Topology,
    mesh: ExactPoints<'a>,
    image: Image<'a>,
    units: Units,
}

#[derive(Clone, Debug)]
enum Image<'a> {
    /// The lift of M to Σ.
    Lift,
    Points(ExactPoints<'a>),
}

/// Words for what one face at a vertex adds, with coordinates of 50 bits.
const CORNER: usize = 6;
/// Words for a star of six edges with such coordinates.
const STAR: usize = 14;
/// Words for the forms of a quad with a different denominator of 24 bits in each coordinate.
const FACE: usize = 8;

impl<'a> ExactPair<'a> {
    /// The pair of two meshes with the same combinatorics.
    pub fn new(topology: &'a Topology, mesh: ExactPoints<'a>, image: ExactPoints<'a>) -> Self {
        let units = match (&mesh, &image) {
            (ExactPoints::Lattice(m), ExactPoints::Lattice(s)) => {
                Units::new(m.unit.into(), s.unit.into())
            }
            _ => Units::new(BigInt::one(), BigInt::one()),
        };
        ExactPair { topology, mesh, image: Image::Points(image), units }
    }

    /// The pair of a mesh and its lift to Σ: the canonical one for i-circular and triangle meshes.
    pub fn lifted(topology: &'a Topology, mesh: ExactPoints<'a>) -> Self {
        let units = match &mesh {
            // The heights of the lift are counted in halves of the squared unit.
            ExactPoints::Lattice(m) => Units::new(m.unit.into(), BigInt::from(m.unit).square() * 2),
            ExactPoints::Rationals(_) => Units::new(BigInt::one(), BigInt::one()),
        };
        ExactPair { topology, mesh, image: Image::Lift, units }
    }

    /// The combinatorics of both meshes.
    pub fn topology(&self) -> &'a Topology {
        self.topology
    }

    /// The forms of a face (15), (16).
    pub fn face_forms(&self, face: FaceId) -> FaceForms<Fraction<BigInt>> {
        let corners = self.topology.face(face);
        let four = self.face_in::<Narrow>(corners).or_else(|| self.face_in::<Wide<FACE>>(corners));
        let four = four.unwrap_or_else(|| {
            let [f, s] = self.polygons(corners);
            fractions(&Forms::of(&f, &s))
        });
        FaceForms { face, four }
    }

    fn face_in<R: Bounded>(&self, corners: &[VertexId]) -> Option<Forms<Fraction<BigInt>>> {
        let Cleared { f, s, scale } = self.cleared::<R>(corners)?;
        let forms = Forms::of(&f, &s).try_map(R::to_big)?;
        Some(self.units.apply(forms, [0; 3], scale.to_big()?, 0))
    }

    /// H and K of a face (17).
    ///
    /// # Errors
    /// Where the signed area of the face is 0.
    pub fn face_curvatures(&self, face: FaceId) -> Result<Curvatures<Fraction<BigInt>>, ZeroArea> {
        self.face_forms(face).curvatures()
    }

    /// What (15)–(18) leave over at a face; `None` where the face or its offset has area 0.
    pub fn offset_residuals(
        &self,
        face: FaceId,
        d: &Rational,
    ) -> Option<OffsetResiduals<Rational>> {
        let corners = self.topology.face(face);
        let holds = self.offset_holds::<Narrow, 5>(corners, d);
        let holds = holds.or_else(|| self.offset_holds::<Wide<FACE>, { 2 * FACE + 1 }>(corners, d));
        if holds == Some(true) {
            let [area, mean, gauss] = [(); 3].map(|()| Rational::zero());
            return Some(OffsetResiduals { area, mean, gauss });
        }
        let [f, s] = self.polygons(corners);
        OffsetResiduals::of(&f, &s, d)
    }

    /// The same with areas in R, compared in integers of so many words; `None` if they do not
    /// suffice, or if there is a division by 0.
    ///
    /// M is scaled by the denominator of d and S by the numerator, so that their sum is the offset.
    fn offset_holds<R: Bounded, const W: usize>(
        &self,
        corners: &[VertexId],
        d: &Rational,
    ) -> Option<bool> {
        let (p, q) = d.small_fraction()?;
        let (p, q) = (i128::from(p), i128::from(q));
        let Cleared { mut f, mut s, .. } = self.cleared::<R>(corners)?;
        // M is over its own unit, S over another.
        let (p, q) = match (&self.mesh, &self.image) {
            (ExactPoints::Lattice(m), Image::Points(ExactPoints::Lattice(s)))
                if m.unit != s.unit =>
            {
                (p.checked_mul(m.unit)?, q.checked_mul(s.unit)?)
            }
            _ => (p, q),
        };
        scale(&mut f, q);
        scale(&mut s, p);
        let moved: Vec<_> = f.iter().zip(&s).map(|(v, w)| v + &w.position()).collect();
        let whole = |n: &R| Fraction::whole(n.to_wide::<W>());
        let forms = [Forms::of(&f, &s), Forms::of(&moved, &s)];
        let [base, offset] = forms.map(|forms| forms.map(whole));
        let found = OffsetResiduals::of_forms(&base, offset, &Fraction::one())?;
        let OffsetResiduals { area, mean, gauss } = &found;
        let lost = [area, mean, gauss].into_iter().any(|n| n.numerator.is_overflown());
        (!lost).then(|| found.vanish())
    }

    /// The measures of a vertex and its image (21). Faces that are not planar count with the
    /// triangles between consecutive edges at the vertex.
    ///
    /// # Errors
    /// Where the faces around the vertex form no closed cycle, or one is vertical.
    pub fn vertex_forms(
        &self,
        vertex: VertexId,
    ) -> Result<VertexForms<Fraction<BigInt>>, VertexUndefined> {
        match self.topology.kind(vertex) {
            VertexKind::Interior => {}
            kind => return Err(VertexUndefined::NotInterior(vertex, kind)),
        }
        let four = match (&self.mesh, &self.image) {
            (ExactPoints::Lattice(m), Image::Lift) => self.lattice_star(vertex, m, None),
            (ExactPoints::Lattice(m), Image::Points(ExactPoints::Lattice(s))) => {
                self.lattice_star(vertex, m, Some(s))
            }
            _ => None,
        };
        let four = four.map_or_else(|| self.rational_star(vertex), Ok)?;
        Ok(VertexForms { vertex, four })
    }

    /// The sign of the area that the star of a vertex has in the top view: positive if its faces run
    /// counter-clockwise. Where `D(s)` has the opposite sign, the image is turned over, and H and K
    /// say nothing about the shape.
    pub fn star_orientation(&self, vertex: VertexId) -> Sign {
        if self.topology.kind(vertex) != VertexKind::Interior {
            return Sign::Zero;
        }
        let ring: Vec<_> = self.topology.star(vertex).map(|h| self.topology.target(h)).collect();
        let small = match &self.mesh {
            ExactPoints::Lattice(m) => twice_area(&lattice_views::<Wide<FACE>>(m, &ring)),
            ExactPoints::Rationals(_) => return self.rational_orientation(&ring),
        };
        small.certain_sign().unwrap_or_else(|| self.rational_orientation(&ring))
    }

    fn rational_orientation(&self, ring: &[VertexId]) -> Sign {
        let ring: Vec<_> = ring.iter().map(|&v| self.mesh.point(v).top_view()).collect();
        twice_area(&ring).certain_sign().unwrap_or(Sign::Zero)
    }

    /// H and K at a vertex (22).
    ///
    /// # Errors
    /// As for [`vertex_forms`](Self::vertex_forms), or `D(s) = 0`.
    pub fn vertex_curvatures(
        &self,
        vertex: VertexId,
    ) -> Result<Curvatures<Fraction<BigInt>>, VertexUndefined> {
        self.vertex_forms(vertex)?.curvatures()
    }

    fn image_point(&self, v: VertexId) -> Point<Rational> {
        match &self.image {
            Image::Points(points) => points.point(v),
            Image::Lift => {
                let top_view = self.mesh.point(v).top_view();
                let height = top_view.norm2() * Rational::from_ratio(1, 2);
                top_view.at_height(height)
            }
        }
    }

    fn polygons(&self, corners: &[VertexId]) -> [Vec<TopView<Rational>>; 2] {
        let of = |point: &dyn Fn(VertexId) -> Point<Rational>| {
            corners.iter().map(|&v| point(v).top_view()).collect()
        };
        [of(&|v| self.mesh.point(v)), of(&|v| self.image_point(v))]
    }

    /// The polygons of a face cleared of denominators; `None` where that is too large for R.
    ///
    /// On lattices M and S are over their own units; otherwise both over the same.
    fn cleared<R: Bounded>(&self, corners: &[VertexId]) -> Option<Cleared<R>> {
        let found = match (&self.mesh, &self.image) {
            (ExactPoints::Lattice(m), Image::Points(ExactPoints::Lattice(s))) => Cleared {
                f: lattice_views(m, corners),
                s: lattice_views(s, corners),
                scale: R::from(m.unit) * R::from(m.unit),
            },
            (ExactPoints::Rationals(m), Image::Points(ExactPoints::Rationals(s))) => {
                let [m, s]: [&[Point<Rational>]; 2] = [m, s];
                cleared(
                    corners.iter().map(|v| &m[v.index()]),
                    corners.iter().map(|v| &s[v.index()]),
                )?
            }
            (_, Image::Points(image)) => {
                let m: Vec<_> = corners.iter().map(|&v| self.mesh.point(v)).collect();
                let s: Vec<_> = corners.iter().map(|&v| image.point(v)).collect();
                cleared(m.iter(), s.iter())?
            }
            (_, Image::Lift) => return None,
        };
        (!found.scale.is_overflown()).then_some(found)
    }

    /// The forms of a star in fractions: as in integers, and where an edge runs straight on from the
    /// gradients of the faces.
    fn rational_star(&self, vertex: VertexId) -> Result<Forms<Fraction<BigInt>>, VertexUndefined> {
        let (m, s) = (self.mesh.point(vertex), self.image_point(vertex));
        let targets = self.topology.star(vertex).map(|h| self.topology.target(h));
        let rays = targets.map(|v| {
            let e = &self.mesh.point(v) - &m;
            let rise = self.image_point(v).z - &s.z;
            Ray { edge: e.top_view(), rise: [e.z, rise] }
        });
        if let Some((forms, scale)) = star_forms(&rays.collect::<Vec<_>>()) {
            return Ok(fractions(&forms.map(|n| n / &scale)));
        }
        let gradients = |point: &dyn Fn(VertexId) -> Point<Rational>| {
            let faces = self.topology.star(vertex).map(|h| self.topology.face_at(h));
            let gradient = |face| {
                let corners: Vec<_> = self.topology.face(face).iter().map(|&v| point(v)).collect();
                let plane = spanning_plane(&corners.iter().collect::<Vec<_>>());
                plane.map(|p| p.gradient).ok_or(VertexUndefined::NotAGraph(vertex, face))
            };
            faces.map(gradient).collect::<Result<Vec<_>, _>>()
        };
        let p = gradients(&|v| self.mesh.point(v))?;
        let q = gradients(&|v| self.image_point(v))?;
        Ok(fractions(&Forms::of(&p, &q)))
    }

    /// The forms of a star in integers; `None` where an edge runs straight on.
    fn lattice_star(
        &self,
        vertex: VertexId,
        m: &Lattice,
        s: Option<&Lattice>,
    ) -> Option<Forms<Fraction<BigInt>>> {
        let rises = |l: &Lattice, v: VertexId| l.points[v.index()].z - l.points[vertex.index()].z;
        let at = &m.points[vertex.index()];
        let targets = self.topology.star(vertex).map(|h| self.topology.target(h));
        let rays = targets.map(|v| {
            let p = &m.points[v.index()];
            [p.x - at.x, p.y - at.y, rises(m, v), s.map_or(0, |s| rises(s, v))]
        });
        let star = IntegerStar::new(rays.collect(), s.is_none());
        let (forms, scale) = star
            .in_words::<CORNER, STAR>()
            .or_else(|| star.in_words::<{ CORNER + 2 }, { 2 * STAR }>())
            .or_else(|| star.forms(BigInt::clone))?;
        let [flat, own, image] = star.twos;
        Some(self.units.apply(forms, [2 * own, own + image, 2 * image], scale, 2 * flat))
    }
}

/// The edges of a star in integers: x, y, the rises in M and in S.
///
/// Neighbours are often doubles of like size; the powers of two that they share are taken out.
struct IntegerStar {
    rays: Vec<[i128; 4]>,
    lifted: bool,
    /// The exponents taken out of the top view, the rises in M, and the rises in S.
    twos: [u32; 3],
}

impl IntegerStar {
    /// With `lifted`, the rise in S is the square of the length instead.
    fn new(mut rays: Vec<[i128; 4]>, lifted: bool) -> Self {
        let twos = |of: fn(&[i128; 4]) -> i128| {
            rays.iter().fold(0, |all, ray| all | of(ray)).trailing_zeros() % i128::BITS
        };
        let (flat, own) = (twos(|r| r[0] | r[1]), twos(|r| r[2]));
        let image = if lifted { 2 * flat } else { twos(|r| r[3]) };
        for [x, y, f, g] in &mut rays {
            (*x, *y, *f) = (*x >> flat, *y >> flat, *f >> own);
            if !lifted {
                *g >>= image;
            }
        }
        IntegerStar { rays, lifted, twos: [flat, own, image] }
    }

    fn in_words<const N: usize, const W: usize>(&self) -> Option<(Forms<BigInt>, BigInt)> {
        let (forms, scale) = self.forms(Wide::<N>::to_wide::<W>)?;
        Some((forms.try_map(Wide::to_big)?, scale.to_big()?))
    }

    fn forms<N: Bounded, R: Ring>(&self, widen: impl Fn(&N) -> R) -> Option<(Forms<R>, R)> {
        let ray = |&[x, y, f, g]: &[i128; 4]| {
            let edge = Vector2::new(N::from(x), N::from(y));
            let image = if self.lifted { edge.length2() } else { N::from(g) };
            Ray { edge, rise: [N::from(f), image] }
        };
        star_forms_widened(&self.rays.iter().map(ray).collect::<Vec<_>>(), widen)
    }
}

fn lattice_views<R: Bounded>(lattice: &Lattice, corners: &[VertexId]) -> Vec<TopView<R>> {
    let view = |v: &VertexId| {
        let p = &lattice.points[v.index()];
        TopView::new(p.x.into(), p.y.into())
    };
    corners.iter().map(view).collect()
}

fn scale<R: Bounded>(polygon: &mut [TopView<R>], factor: i128) {
    if factor != 1 {
        let factor = R::from(factor);
        polygon.iter_mut().for_each(|v| *v = TopView::new(&v.x * &factor, &v.y * &factor));
    }
}

fn fractions(forms: &Forms<Rational>) -> Forms<Fraction<BigInt>> {
    forms.map(|n| Fraction::new(n.numerator(), n.denominator()))
}
