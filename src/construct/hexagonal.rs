//! Rotational meshes of hexagons with H = 0, H constant or K constant at faces (Fig. 10).
//!
//! The faces of ring k lie in the planes `z = R_k e·x' + τ_k`, with unit vectors e at the angles
//! `(k + 2j) φ`; rings are staggered, and every hexagon has two vertices on its meridian. With
//! `c = cos φ`, `s = sin φ`, `δ_k = τ_k − τ_{k+1}`, `A_k = R_{k+1} − c R_k`, `B_k = c R_{k+1} − R_k` there lie
//!
//! - `U_k` at the radius `δ_k/A_k` on the rays of ring k + 1, with two faces of ring k,
//! - `L_k` at the radius `δ_k/B_k` on the rays of ring k, with two faces of ring k + 1.
//!
//! Meshes with the same `R` are f-parallel. With `P_k = 1/(A_k B_k)` the areas are differences,
//! `area(F) = s (P_k δ_k² − P_{k−1} δ_{k−1}²)` and `area(F, S) = s (P_k δ_k δ̂_k − P_{k−1} δ_{k−1} δ̂_{k−1})`, so
//!
//! ```math
//! H = 0: δ δ̂ = C AB,    H constant: δ δ̂ − H δ² = C AB,    K constant: δ² − δ̂²/K = C AB.
//! ```
//!
//! Where steps are square roots, they are enclosed: see
//! [`enclosed_constant_gauss`](HexagonalRings::enclosed_constant_gauss).

use std::collections::{BTreeMap, BTreeSet};

use super::enclosure::{Enclosed, bound, first_integral};
use super::minimal::{MeshPair, NoSurface};
use super::packing::rays;
use crate::mesh::{FaceList, Mesh};
use crate::scalar::{Ball, Field, RationalField, Ring};
use crate::space::{Point, Rotation};

/// The slopes of the face planes ring by ring, and half the angle between the faces of a ring.
#[derive(Clone, Debug, PartialEq)]
pub struct HexagonalRings<T> {
    half_sector: Rotation<T>,
    slopes: Vec<T>,
    /// `A_k B_k`.
    products: Vec<T>,
}

/// A corner by its step, its kind (0 for L, 1 for U) and the multiple of φ, moved to be positive.
type Corner = (usize, u8, usize);

/// The corners of hexagon j of ring k, counter-clockwise.
fn corners(k: usize, j: usize) -> [Corner; 6] {
    let m = 1 + k % 2 + 2 * j;
    [(k - 1, 1, m), (k - 1, 0, m - 1), (k, 1, m - 1), (k, 0, m), (k, 1, m + 1), (k - 1, 0, m + 1)]
}

impl<T: Field> HexagonalRings<T> {
    /// The rings with slopes `R_0, …, R_{m+1}`: m of them have hexagons, the first and the last only
    /// cut them off.
    ///
    /// # Errors
    /// [`NoSurface::NoSector`] where an `A_k` or `B_k` is 0, or there are fewer than three slopes.
    pub fn new(half_sector: Rotation<T>, slopes: Vec<T>) -> Result<Self, NoSurface<T>> {
        let cosine = half_sector.cos();
        let products: Vec<T> = slopes
            .windows(2)
            .map(|r| (&r[1] - cosine * &r[0]) * (cosine * &r[1] - &r[0]))
            .collect();
        if products.len() < 2 || products.iter().any(T::is_zero) || half_sector.sin().is_zero() {
            return Err(NoSurface::NoSector);
        }
        Ok(HexagonalRings { half_sector, slopes, products })
    }

    /// The steps `δ̂_k = (R_{k+1}² − R_k²)/2` of the mesh that is circumscribed to Σ.
    pub fn circumscribed(&self) -> Vec<T> {
        let half = T::from_ratio(1, 2);
        self.slopes.windows(2).map(|r| (r[1].square() - r[0].square()) * &half).collect()
    }

    /// The products `A_k B_k`, one for every step.
    pub fn products(&self) -> &[T] {
        &self.products
    }

    /// The steps `δ = C AB/δ̂` of an i-minimal M with the given S.
    ///
    /// `None` where a step of S is 0.
    pub fn minimal(&self, image: &[T], integral: &T) -> Option<Vec<T>> {
        let step = |(product, step): (&T, &T)| (integral * product).try_div(step);
        self.products.iter().zip(image).map(step).collect()
    }

    /// The steps `δ̂ = H δ + C AB/δ` of an S with which a given M has the constant mean curvature H; as
    /// M is free, S approximates Σ only as well as M is chosen.
    ///
    /// `None` where a step of M is 0.
    pub fn constant_mean(&self, mesh: &[T], mean: &T, integral: &T) -> Option<Vec<T>> {
        let other = self.minimal(mesh, integral)?;
        Some(mesh.iter().zip(other).map(|(step, other)| mean * step + other).collect())
    }

    /// The steps `δ = (p + q)/2` of M and `δ̂ = k (q − p)/2` of S with `pq = C AB`, for given factors p:
    /// constant curvature `K = k²`.
    ///
    /// `None` where a factor is 0.
    pub fn constant_gauss(
        &self,
        factors: &[T],
        root: &T,
        integral: &T,
    ) -> Option<(Vec<T>, Vec<T>)> {
        let half = T::from_ratio(1, 2);
        let others = self.minimal(factors, integral)?;
        let steps = factors.iter().zip(others);
        Some(steps.map(|(p, q)| ((p + &q) * &half, root * (q - p) * &half)).unzip())
    }

    /// The mesh with the steps `δ_k`, and `hexagons` faces in every ring; `τ_0 = 0`.
    ///
    /// # Errors
    /// [`NoSurface::NoSector`] where there are not as many steps as products.
    pub fn mesh(&self, steps: &[T], hexagons: usize) -> Result<Mesh<T>, NoSurface<T>> {
        if steps.len() != self.products.len() {
            return Err(NoSurface::NoSector);
        }
        let mut names: BTreeMap<Corner, u32> = self.corners(hexagons).map(|c| (c, 0)).collect();
        let rays = rays(&self.half_sector, 2 * hexagons + 2);
        let mut points = Vec::with_capacity(names.len());
        let meridian = self.meridian(steps, T::clone).ok_or(NoSurface::NoSector)?;
        for (index, (&(k, kind, m), id)) in names.iter_mut().enumerate() {
            *id = index as u32;
            let ([radius, height], ray) = (&meridian[k][usize::from(kind)], &rays[m]);
            points.push(Point::new(radius * &ray.x, radius * &ray.y, height.clone()));
        }
        let mut list = FaceList::new();
        for (k, j) in self.faces(hexagons) {
            list.push(corners(k, j).iter().filter_map(|name| names.get(name)).copied());
        }
        Ok(Mesh::new(points, list)?)
    }

    /// Ring and place of every hexagon.
    fn faces(&self, hexagons: usize) -> impl Iterator<Item = (usize, usize)> {
        (1..self.slopes.len() - 1).flat_map(move |k| (0..hexagons).map(move |j| (k, j)))
    }

    /// The corners of all hexagons, in the order of the vertices.
    fn corners(&self, hexagons: usize) -> impl Iterator<Item = Corner> + use<T> {
        let all: BTreeSet<Corner> = self.faces(hexagons).flat_map(|(k, j)| corners(k, j)).collect();
        all.into_iter()
    }

    /// The pair of the meshes with these steps.
    ///
    /// # Errors
    /// As for [`mesh`](Self::mesh).
    pub fn pair(
        &self,
        steps: &[T],
        image: &[T],
        hexagons: usize,
    ) -> Result<MeshPair<T>, NoSurface<T>> {
        let (surface, gauss) = (self.mesh(steps, hexagons)?, self.mesh(image, hexagons)?);
        // The circumscribed image has τ̂ = −R²/2.
        let drop = self.slopes[0].square() * T::from_ratio(-1, 2);
        let points = gauss.points.iter().map(|p| Point { z: &p.z + &drop, ..p.clone() }).collect();
        Ok(MeshPair { surface, gauss: Mesh { points, ..gauss } })
    }

    /// Radius and height of `L_k` and of `U_k`, step by step; linear in the steps, which may be of
    /// another kind than the slopes. `None` where a divisor is 0.
    fn meridian<R: Ring>(
        &self,
        steps: &[R],
        constant: impl Fn(&T) -> R,
    ) -> Option<Vec<[[R; 2]; 2]>> {
        let cosine = self.half_sector.cos();
        let mut outer_offset = R::zero();
        let point = |(k, step): (usize, &R)| {
            let (inner, outer) = (&self.slopes[k], &self.slopes[k + 1]);
            let inner_offset = outer_offset.clone();
            outer_offset -= step;
            let on = |divisor: T, slope: &T, offset: &R| {
                let radius = constant(&divisor.try_inv()?) * step;
                let height = constant(slope) * &radius + offset;
                Some([radius, height])
            };
            Some([
                on(cosine * outer - inner, inner, &inner_offset)?,
                on(outer - cosine * inner, outer, &outer_offset)?,
            ])
        };
        steps.iter().enumerate().map(point).collect()
    }
}

impl<Q: RationalField> HexagonalRings<Q> {
    /// The steps `δ = √(δ̂²/K + C AB)` of M, not negative, for the steps of a given S: constant
    /// curvature K. Each is enclosed to `2^−bits`, and exact where it is rational.
    ///
    /// `None` for `K = 0`, or where a root is not real.
    pub fn enclosed_constant_gauss(
        &self,
        image: &[Q],
        gauss: &Q,
        integral: &Q,
        bits: u32,
    ) -> Option<Vec<Ball<Q>>> {
        let step =
            |(image, product): (&Q, &Q)| first_integral(image, gauss, &(integral * product), bits);
        image.iter().zip(&self.products).map(step).collect()
    }

    /// The pair of meshes for steps of M that are enclosed. What is written is again f-parallel to S;
    /// only K is that of the enclosed mesh.
    ///
    /// # Errors
    /// As for [`mesh`](Self::mesh).
    pub fn enclosed_pair(
        &self,
        steps: Vec<Ball<Q>>,
        image: &[Q],
        hexagons: usize,
    ) -> Result<Enclosed<Q>, NoSurface<Q>> {
        let middle: Vec<Q> = steps.iter().map(|step| step.mid.clone()).collect();
        let pair = self.pair(&middle, image, hexagons)?;
        let meridian = self.meridian(&steps, |x| Ball::new(x.clone(), Q::zero()));
        let meridian = meridian.ok_or(NoSurface::NoSector)?;
        // Rays are unit vectors.
        let bounds = self
            .corners(hexagons)
            .map(|(k, kind, _)| {
                let [radius, height] = &meridian[k][usize::from(kind)];
                bound([radius, height])
            })
            .collect();
        Ok(Enclosed::new(pair, steps, bounds))
    }
}
