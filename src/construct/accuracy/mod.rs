//! How near (22) comes to the curvatures of a smooth surface, by class of triangulation.
//!
//! Samples are exact, and so are the discrete curvatures; where the surface is a rational
//! expression the errors are exact too. An error of 0 in a table is 0.

mod class;

use rayon::prelude::*;

pub use class::Class;
use class::Sample;

use super::NoTriangulation;
use super::star::gradients;
use crate::mesh::{Mesh, VertexId};
use crate::pair::Forms;
use crate::scalar::{Approx, Field, Numeral, Ordered, Rational, Ring, Sign};
use crate::space::{Expression, Gradient, Graph, Jet2, ParabolicSphere, TopView};

/// The errors of one curvature at the inner vertices of one triangulation.
#[derive(Clone, Debug, PartialEq)]
pub struct Errors {
    /// The largest error in size.
    pub largest: Rational,
    /// The root of the mean square.
    pub root_mean_square: f64,
    /// The mean, each vertex weighted by its area `D(s)`: what remains in integrals.
    pub mean: f64,
}

/// What was found on one triangulation.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The mesh size is `1/n`.
    pub n: u32,
    /// How many vertices were looked at.
    pub vertices: usize,
    /// How many more have no curvature, since `D(s)` is not positive or the surface is not defined there.
    pub undefined: usize,
    /// The errors of H against `Δf/2`.
    pub mean_curvature: Errors,
    /// The errors of K against `det ∇²f`.
    pub curvature: Errors,
}

/// What was found on one class of triangulation.
#[derive(Clone, Debug, PartialEq)]
pub struct Accuracy {
    /// The class.
    pub class: Class,
    /// Whether H is exact for *all* quadratic polynomials at the inner vertices of the coarsest mesh, and K.
    pub exact_for_quadratics: [bool; 2],
    /// From coarse to fine.
    pub rows: Vec<Row>,
}

/// How errors behave where the mesh is refined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Trend {
    /// All errors are exactly 0.
    Exact,
    /// The largest error falls about like this power of the mesh size: at least the first, in the
    /// last refinement and from the coarsest to the finest.
    Order(f64),
    /// It does not.
    NoConvergence,
    /// There is no refinement to tell it from.
    Unknown,
}

/// The observed order between two triangulations: `log(error / finer error) / log(finer n / n)`;
/// `None` where an error is 0.
pub fn order(coarse: (u32, &Rational), fine: (u32, &Rational)) -> Option<f64> {
    let errors = coarse.1.to_f64() / fine.1.to_f64();
    let order = errors.ln() / (f64::from(fine.0) / f64::from(coarse.0)).ln();
    order.is_finite().then_some(order)
}

impl Trend {
    /// From orders, that of the last refinement first.
    fn observed(orders: &[Option<f64>]) -> Trend {
        match orders.first() {
            Some(&Some(last)) if orders.iter().all(|o| o.is_some_and(|order| order >= 1.0)) => {
                Trend::Order(last)
            }
            _ => Trend::NoConvergence,
        }
    }
}

impl Accuracy {
    /// How the errors that `of` picks from a row behave in the last refinement.
    pub fn trend(&self, of: impl Fn(&Row) -> &Errors) -> Trend {
        let between = |a: &Row, b: &Row| order((a.n, &of(a).largest), (b.n, &of(b).largest));
        if self.rows.iter().all(|row| of(row).largest.is_zero()) {
            return Trend::Exact;
        }
        let [first, .., before, last] = self.rows.as_slice() else {
            return match self.rows.as_slice() {
                [first, last] => Trend::observed(&[between(first, last)]),
                _ => Trend::Unknown,
            };
        };
        Trend::observed(&[between(before, last), between(first, last)])
    }
}

/// Samples a surface on triangulations of the unit square (or its image under the map of the
/// class) with mesh sizes `1/n` and compares (22) with its curvatures, at the vertices in the inner quarter.
///
/// # Errors
/// Where random points cannot be triangulated: two fell together, or they are fewer than three.
pub fn accuracy(
    surface: &Expression,
    class: Class,
    sizes: &[u32],
    seed: u64,
) -> Result<Accuracy, NoTriangulation> {
    let mut exact_for_quadratics = None;
    let mut rows = Vec::new();
    for &n in sizes {
        let sample = class.sample(n, seed)?;
        exact_for_quadratics.get_or_insert_with(|| exact_on_quadratics(&sample));
        rows.push(row(surface, n, &sample));
    }
    let exact_for_quadratics = exact_for_quadratics.unwrap_or([false; 2]);
    Ok(Accuracy { class, exact_for_quadratics, rows })
}

impl Sample {
    fn inner_vertices(&self) -> Vec<VertexId> {
        let inner = self.topology.interior_vertices();
        inner.filter(|v| self.inner[v.index()]).collect()
    }

    /// The gradients around a vertex of the graph of `height` over the samples.
    fn ring(
        &self,
        v: VertexId,
        height: impl Fn(VertexId) -> Option<Rational>,
    ) -> Option<Vec<Gradient<Rational>>> {
        let around = self.topology.star(v).map(|h| self.topology.target(h));
        if !around.chain([v]).all(|u| height(u).is_some()) {
            return None;
        }
        let point = |u: VertexId| {
            self.top_views[u.index()].at_height(height(u).unwrap_or_else(Rational::zero))
        };
        gradients(&self.topology, v, point)
    }

    fn lift(&self, v: VertexId) -> Rational {
        self.top_views[v.index()].norm2() * Rational::from_ratio(1, 2)
    }
}

/// H and K of (22), if the area is positive.
fn curvatures<T: Field + Ordered>(forms: &Forms<T>) -> Option<[T; 2]> {
    let positive = forms.second.certain_sign() == Some(Sign::Positive);
    let area = forms.second.try_inv().filter(|_| positive)?;
    Some([&forms.mixed * &area, &forms.first * &area])
}

/// The curvatures `[H, K]` of (22) of a triangle mesh at a vertex, with its lift to Σ as Gauss image.
///
/// `None` at a vertex that is not interior, next to a vertical face or one of more than three
/// corners, and where the area `D(s)` is not positive, which does not occur in Delaunay meshes.
pub fn vertex_curvatures<T: Field + Ordered>(mesh: &Mesh<T>, v: VertexId) -> Option<[T; 2]> {
    let sigma = ParabolicSphere::unit();
    let point = |u: VertexId| mesh.points[u.index()].clone();
    let lift = |u: VertexId| sigma.contact_at(&mesh.points[u.index()].top_view()).point;
    let ring = gradients(&mesh.topology, v, point)?;
    curvatures(&Forms::of(&ring, &gradients(&mesh.topology, v, lift)?))
}

fn row(surface: &Expression, n: u32, sample: &Sample) -> Row {
    let heights: Vec<Option<Rational>> =
        sample.top_views.par_iter().map(|at| surface.height_at(at)).collect();
    let error_at = |&v: &VertexId| {
        let ring = sample.ring(v, |u| heights[u.index()].clone())?;
        let sigma = sample.ring(v, |u| Some(sample.lift(u)))?;
        let forms = Forms::of(&ring, &sigma);
        let [h, k] = curvatures(&forms)?;
        let [smooth_h, smooth_k] = smooth_curvatures(surface, &sample.top_views[v.index()])?;
        Some(([h - smooth_h, k - smooth_k], forms.second.to_f64()))
    };
    let vertices = sample.inner_vertices();
    let all: Vec<_> = vertices.par_iter().map(error_at).collect();
    let found: Vec<_> = all.iter().flatten().collect();
    let errors = |i: usize| {
        let sizes = found.iter().map(|(e, _)| e[i].magnitude());
        let rounded = || found.iter().map(|(e, area)| (e[i].to_f64(), area));
        let square: f64 = rounded().map(|(e, _)| e * e).sum();
        let area: f64 = rounded().map(|(_, area)| area).sum();
        let weighted: f64 = rounded().map(|(e, area)| e * area).sum();
        Errors {
            largest: sizes.fold(Rational::zero(), |a, b| if b > a { b } else { a }),
            root_mean_square: if found.is_empty() {
                0.0
            } else {
                (square / found.len() as f64).sqrt()
            },
            mean: if found.is_empty() { 0.0 } else { weighted / area },
        }
    };
    Row {
        n,
        vertices: found.len(),
        undefined: vertices.len() - found.len(),
        mean_curvature: errors(0),
        curvature: errors(1),
    }
}

/// H and K of the surface: exactly, or from doubles.
fn smooth_curvatures(surface: &Expression, at: &TopView<Rational>) -> Option<[Rational; 2]> {
    if surface.is_rational() {
        let jet: Jet2<Rational> = surface.jet(at)?;
        return Some([jet.mean_curvature(), jet.curvature()]);
    }
    let jet: Jet2<f64> = surface.jet(&TopView::new(at.x.to_f64(), at.y.to_f64()))?;
    let exact = |x: f64| Numeral::from_f64(x).map(|double| double.value());
    Some([exact(jet.mean_curvature())?, exact(jet.curvature())?])
}

/// Whether H and K of (22) are those of the smooth surface for all quadratic polynomials.
///
/// H is linear and K quadratic in the polynomial, so a basis and its pairs decide.
fn exact_on_quadratics(sample: &Sample) -> [bool; 2] {
    let verdict = |&v: &VertexId| quadratics_at(sample, v).unwrap_or([false; 2]);
    let vertices = sample.inner_vertices();
    if vertices.is_empty() {
        return [false; 2];
    }
    vertices.par_iter().map(verdict).reduce(|| [true; 2], |a, b| [a[0] && b[0], a[1] && b[1]])
}

fn quadratics_at(sample: &Sample, v: VertexId) -> Option<[bool; 2]> {
    let basis: [fn(&Rational, &Rational) -> Rational; 3] =
        [|x, _| x.square(), |x, y| x * y, |_, y| y.square()];
    let ring = |f: fn(&Rational, &Rational) -> Rational| {
        let height = |u: VertexId| {
            let at = &sample.top_views[u.index()];
            Some(f(&at.x, &at.y))
        };
        sample.ring(v, height)
    };
    let [xx, xy, yy] = basis.map(ring);
    let rings = [xx?, xy?, yy?];
    let sigma = sample.ring(v, |u| Some(sample.lift(u)))?;
    let area = Forms::of(&sigma, &sigma).second;
    // Δ/2 of x², xy, y², and the polar form of the determinant of the Hessian on their pairs.
    let half_laplacian = [1, 0, 1];
    let mean = (0..3).all(|i| {
        Forms::of(&rings[i], &sigma).mixed == &area * Rational::from_i64(half_laplacian[i])
    });
    let polar = [[0, 0, 2], [0, -1, 0], [2, 0, 0]];
    let gauss = (0..3).all(|i| {
        (i..3).all(|j| {
            let value = Forms::of(&rings[i], &rings[j]).mixed;
            value == &area * Rational::from_i64(polar[i][j])
        })
    });
    Some([mean, gauss])
}
