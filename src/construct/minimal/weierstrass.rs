//! Discrete Weierstrass data: i-minimal circular nets, their conjugate A-nets, and nets of constant
//! mean curvature, from a discrete holomorphic function.
//!
//! Bobenko and Pinkall, *Discrete isothermic surfaces* (1996); the isotropic version is rational.

use super::complex::{difference, over_conjugate, product, quotient};
use super::{MeshPair, NoSurface};
use crate::construct::packing::grid;
use crate::construct::quad_patch;
use crate::mesh::Mesh;
use crate::scalar::Field;
use crate::space::{ParabolicSphere, Point, TopView, Vector2};

/// Cauchy data of a discrete holomorphic function g on a patch of the square grid: its values on two
/// axes, as complex numbers, and a number for every step along them.
#[derive(Clone, Debug, PartialEq)]
pub struct WeierstrassData<T> {
    /// The values of g along the rows, `g(i, 0)`; the first is the common corner.
    pub rows: Vec<Vector2<T>>,
    /// The values along the columns, `g(0, j)`, from `j = 1` on.
    pub columns: Vec<Vector2<T>>,
    /// `α_i`: one for every step along the rows.
    pub alpha: Vec<T>,
    /// `β_j`: one for every step along the columns; `αβ < 0` for embedded quads.
    pub beta: Vec<T>,
}

/// A discrete holomorphic function g with factorised cross-ratios
/// `(g₁ − g)(g₂ − g₁₂) / ((g₁₂ − g₁)(g − g₂)) = α_i/β_j`, and its Christoffel dual w:
/// `Δw = α_i / conj(Δg)` along rows and `β_j / conj(Δg)` along columns.
///
/// | net | is |
/// | --- | --- |
/// | [`minimal`](Self::minimal) | an i-circular net with `H = 0` at faces |
/// | [`conjugate`](Self::conjugate) | an A-net |
/// | [`constant_mean`](Self::constant_mean) | an i-circular net with constant H |
///
/// Numbers of digits grow exponentially along the diagonal of g: small nets only.
///
/// ```
/// use isogeo::construct::minimal::{Weierstrass, WeierstrassData};
/// use isogeo::space::Vector2;
/// let at = |x: f64, y: f64| Vector2::new(x, y);
/// let data = WeierstrassData {
///     rows: vec![at(0.0, 0.0), at(1.0, 0.0)],
///     columns: vec![at(0.0, 1.0)],
///     alpha: vec![1.0],
///     beta: vec![-1.0],
/// };
/// let saddle = Weierstrass::new(&data).and_then(|data| data.minimal());
/// assert!(saddle.is_ok_and(|pair| pair.surface.points[3].coordinates() == [&1.0, &-1.0, &0.0]));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Weierstrass<T> {
    size: [usize; 2],
    g: Vec<Vector2<T>>,
    w: Vec<Vector2<T>>,
}

impl<T: Field> Weierstrass<T> {
    /// Propagates g from its data and integrates w.
    ///
    /// # Errors
    /// [`NoSurface::Singular`] where neighbouring values of g agree, a value lies at infinity, or
    /// lists have not the lengths of a patch.
    pub fn new(data: &WeierstrassData<T>) -> Result<Self, NoSurface<T>> {
        let size = [data.alpha.len(), data.beta.len()];
        if data.rows.len() != size[0] + 1 || data.columns.len() != size[1] {
            return Err(NoSurface::Singular(data.rows.len(), data.columns.len()));
        }
        let width = size[1] + 1;
        let mut g: Vec<Vector2<T>> = Vec::with_capacity((size[0] + 1) * width);
        let mut w: Vec<Vector2<T>> = Vec::with_capacity((size[0] + 1) * width);
        for (i, j) in grid(size[0], size[1]) {
            let singular = NoSurface::Singular(i, j);
            let value = match (i, j) {
                (_, 0) => data.rows[i].clone(),
                (0, _) => data.columns[j - 1].clone(),
                _ => {
                    let known = [
                        &g[(i - 1) * width + j - 1],
                        &g[i * width + j - 1],
                        &g[(i - 1) * width + j],
                    ];
                    let ratio = data.alpha[i - 1].try_div(&data.beta[j - 1]);
                    match ratio.and_then(|ratio| fourth(known, &ratio)) {
                        Some(value) => value,
                        None => return Err(singular),
                    }
                }
            };
            g.push(value);
            let (from, factor) = match (i, j) {
                (0, 0) => {
                    w.push(Vector2::new(T::zero(), T::zero()));
                    continue;
                }
                (_, 0) => ((i - 1) * width, &data.alpha[i - 1]),
                _ => (i * width + j - 1, &data.beta[j - 1]),
            };
            let step = difference(&g[i * width + j], &g[from]);
            let Some(step) = over_conjugate(factor, &step) else { return Err(singular) };
            let next = &w[from] + &step;
            w.push(next);
        }
        Ok(Weierstrass { size, g, w })
    }

    /// The i-minimal circular net `(w, z)` with `Δz = Re(½ (ḡ_i + ḡ_j) Δw)`, and its Gauss image
    /// `S = (g, |g|²/2)` inscribed to Σ.
    ///
    /// # Errors
    /// Where there are too many faces to count.
    pub fn minimal(&self) -> Result<MeshPair<T>, NoSurface<T>> {
        Ok(MeshPair {
            surface: self.mesh(&self.w, self.heights(Vector2::dot))?,
            gauss: self.inscribed(&self.g)?,
        })
    }

    /// The conjugate `(w, zᶜ)` with `Δzᶜ = Im(½ (ḡ_i + ḡ_j) Δw)`: an A-net, whose plane at a vertex has the
    /// gradient `(−Im g, Re g)`.
    ///
    /// # Errors
    /// Where there are too many faces to count.
    pub fn conjugate(&self) -> Result<Mesh<T>, NoSurface<T>> {
        self.mesh(&self.w, self.heights(Vector2::det))
    }

    /// The net `(w, z + H|w|²/2)` of constant mean curvature H, and its Gauss image, the lift of
    /// `g + Hw` to Σ.
    ///
    /// ```math
    /// area(F, S) = H area(F)   for all faces; the offset at the distance −1/(2H) has K = 4H².
    /// ```
    ///
    /// # Errors
    /// Where there are too many faces to count.
    pub fn constant_mean(&self, mean: &T) -> Result<MeshPair<T>, NoSurface<T>> {
        let half = mean * T::from_ratio(1, 2);
        let heights = self.heights(Vector2::dot);
        let heights = heights.into_iter().zip(&self.w).map(|(z, w)| z + &half * w.length2());
        let image: Vec<_> = self.g.iter().zip(&self.w).map(|(g, w)| g + &w.scaled(mean)).collect();
        Ok(MeshPair {
            surface: self.mesh(&self.w, heights.collect())?,
            gauss: self.inscribed(&image)?,
        })
    }

    /// The sums of `form(½ (g_i + g_j), Δw)` along rows and columns.
    fn heights(&self, form: impl Fn(&Vector2<T>, &Vector2<T>) -> T) -> Vec<T> {
        let width = self.size[1] + 1;
        let mut heights: Vec<T> = Vec::with_capacity(self.w.len());
        for (i, j) in grid(self.size[0], self.size[1]) {
            let here = i * width + j;
            let from = match (i, j) {
                (0, 0) => {
                    heights.push(T::zero());
                    continue;
                }
                (_, 0) => here - width,
                _ => here - 1,
            };
            let mean = (&self.g[from] + &self.g[here]).scaled(&T::from_ratio(1, 2));
            let next = &heights[from] + form(&mean, &difference(&self.w[here], &self.w[from]));
            heights.push(next);
        }
        heights
    }

    fn inscribed(&self, values: &[Vector2<T>]) -> Result<Mesh<T>, NoSurface<T>> {
        let sigma = ParabolicSphere::unit();
        let height = |v: &Vector2<T>| sigma.height_at(&TopView::new(v.x.clone(), v.y.clone()));
        self.mesh(values, values.iter().map(height).collect())
    }

    fn mesh(&self, values: &[Vector2<T>], heights: Vec<T>) -> Result<Mesh<T>, NoSurface<T>> {
        let point = |(v, z): (&Vector2<T>, T)| Point::new(v.x.clone(), v.y.clone(), z);
        let points = values.iter().zip(heights).map(point).collect();
        Ok(Mesh::new(points, quad_patch(self.size[0], self.size[1]))?)
    }
}

/// The value `g₁₂` of a quad from `g, g₁, g₂` and the cross-ratio.
fn fourth<T: Field>([a, b, c]: [&Vector2<T>; 3], ratio: &T) -> Option<Vector2<T>> {
    let along = difference(b, a);
    let across = difference(a, c).scaled(ratio);
    quotient(&(&product(&along, c) + &product(&across, b)), &(&along + &across))
}
