//! Rotational meshes of quads with constant H or constant K at faces.
//!
//! Rings of M and S with the radii `r_k` and `r̂_k` make trapezoids with
//! `area(F) = ½ sin θ (r_{k+1}² − r_k²)` and `area(F, S) = ½ sin θ (r_{k+1} r̂_{k+1} − r_k r̂_k)`. So sums telescope,
//! and there are first integrals:
//!
//! ```math
//! H constant:   r r̂ − H r² = C,      K constant:   r² = r̂²/K + C.
//! ```
//!
//! Where the radii are square roots, they are enclosed: see [`enclosed_curvature_rings`].

use super::enclosure::{Enclosed, bound, first_integral};
use super::minimal::{MeshPair, NoSurface};
use super::packing::{grid, rays};
use super::quad_patch;
use crate::mesh::Mesh;
use crate::scalar::{Ball, Field, RationalField, Ring};
use crate::space::{Point, Rotation};

/// The radii of a ring of M and of the ring of S that belongs to it.
#[derive(Clone, Debug, PartialEq)]
pub struct RingRadii<T> {
    /// The radius in M.
    pub radius: T,
    /// The radius in S.
    pub image: T,
}

/// The rings with `r r̂ − H r² = C` for radii of M that are given: constant mean curvature H, and for
/// `H = 0` i-minimal.
///
/// `None` for a radius 0.
pub fn constant_mean_rings<T: Field>(
    radii: &[T],
    mean: &T,
    integral: &T,
) -> Option<Vec<RingRadii<T>>> {
    let ring = |radius: &T| {
        let image = mean * radius + integral.try_div(radius)?;
        Some(RingRadii { radius: radius.clone(), image })
    };
    radii.iter().map(ring).collect()
}

/// The rings with `r = (t + c/t)/(2k)`, `r̂ = (t − c/t)/2` for given parameters t: constant curvature
/// `K = k²`, as `k² r² − r̂² = c`.
///
/// `None` for `k = 0` or a parameter 0.
///
/// ```
/// use isogeo::construct::rotational::positive_curvature_rings;
/// let rings = positive_curvature_rings(&[2.0, 4.0], &1.0, &1.0);
/// let radii = rings.map(|rings| rings.iter().map(|ring| (ring.radius, ring.image)).collect::<Vec<_>>());
/// assert_eq!(radii, Some(vec![(1.25, 0.75), (2.125, 1.875)]));
/// ```
pub fn positive_curvature_rings<T: Field>(
    parameters: &[T],
    root: &T,
    integral: &T,
) -> Option<Vec<RingRadii<T>>> {
    let half = T::from_ratio(1, 2);
    let ring = |t: &T| {
        let other = integral.try_div(t)?;
        let radius = ((t + &other) * &half).try_div(root)?;
        Some(RingRadii { radius, image: (t - other) * &half })
    };
    parameters.iter().map(ring).collect()
}

/// The rings with `k r = a (1 − u²)/(1 + u²)`, `r̂ = 2au/(1 + u²)` for given parameters u: constant
/// curvature `K = −k²`, as `k² r² + r̂² = a²`.
///
/// `None` for `k = 0`.
pub fn negative_curvature_rings<T: Field>(
    parameters: &[T],
    root: &T,
    amplitude: &T,
) -> Option<Vec<RingRadii<T>>> {
    let ring = |u: &T| {
        let turn = Rotation::from_parameter(u).ok()?;
        Some(RingRadii {
            radius: (amplitude * turn.cos()).try_div(root)?,
            image: amplitude * turn.sin(),
        })
    };
    parameters.iter().map(ring).collect()
}

/// The radii `r = √(r̂²/K + C)` of M, not negative, for given radii of S: constant curvature K. Each
/// is enclosed to `2^−bits`, and exact where it is rational.
///
/// `None` for `K = 0`, or where a root is not real.
pub fn enclosed_curvature_rings<Q: RationalField>(
    images: &[Q],
    gauss: &Q,
    integral: &Q,
    bits: u32,
) -> Option<Vec<Ball<Q>>> {
    images.iter().map(|image| first_integral(image, gauss, integral, bits)).collect()
}

/// The mesh of [`rotational_pair`] for radii of M that are enclosed. What is written is again
/// f-parallel to S, and both are i-circular and i-conical; only K is that of the enclosed mesh.
///
/// # Errors
/// As for [`rotational_pair`].
pub fn enclosed_rotational_pair<Q: RationalField>(
    radii: Vec<Ball<Q>>,
    images: &[Q],
    sector: &Rotation<Q>,
    sectors: usize,
) -> Result<Enclosed<Q>, NoSurface<Q>> {
    let ring = |(radius, image): (&Ball<Q>, &Q)| RingRadii {
        radius: radius.mid.clone(),
        image: image.clone(),
    };
    let rings: Vec<_> = radii.iter().zip(images).map(ring).collect();
    let pair = rotational_pair(&rings, sector, sectors)?;
    let heights = heights(&radii, images, |slope| Ball::new(slope.clone(), Q::zero()));
    // Rays are unit vectors.
    let bounds: Vec<Q> = radii.iter().zip(&heights).map(|(r, z)| bound([r, z])).collect();
    let bounds = grid(rings.len() - 1, sectors).map(|(k, _)| bounds[k].clone()).collect();
    Ok(Enclosed::new(pair, radii, bounds))
}

/// The heights of the rings from 0: `Δz = ½ (r̂_k + r̂_{k+1}) Δr`.
fn heights<T: Field, R: Ring>(radii: &[R], images: &[T], constant: impl Fn(&T) -> R) -> Vec<R> {
    let half = T::from_ratio(1, 2);
    let mut height = R::zero();
    let mut heights = vec![height.clone()];
    for (radii, images) in radii.windows(2).zip(images.windows(2)) {
        let slope = (&images[0] + &images[1]) * &half;
        height += &(constant(&slope) * (&radii[1] - &radii[0]));
        heights.push(height.clone());
    }
    heights
}

/// The rotational mesh M with these rings on the rays of angle `jθ`, and its Gauss image S inscribed to
/// Σ: `ẑ = r̂²/2`, and `Δz = ½ (r̂_k + r̂_{k+1}) Δr`. Ring k is row k, ray j is column j; the first ring
/// of M has height 0.
///
/// ```
/// use isogeo::construct::rotational::{RingRadii, rotational_pair};
/// use isogeo::space::Rotation;
/// let ring = |radius, image| RingRadii { radius, image };
/// let quarter = Rotation::new(0.0, 1.0)?;
/// let pair = rotational_pair(&[ring(1.0, 2.0), ring(2.0, 1.0)], &quarter, 1);
/// assert!(pair.is_ok_and(|pair| pair.surface.points[3].coordinates() == [&0.0, &2.0, &1.5]));
/// # Ok::<(), isogeo::space::SpaceError>(())
/// ```
///
/// # Errors
/// Fewer than two rings are no mesh: [`NoSurface::NoSector`], as is a sector of sine 0.
pub fn rotational_pair<T: Field>(
    rings: &[RingRadii<T>],
    sector: &Rotation<T>,
    sectors: usize,
) -> Result<MeshPair<T>, NoSurface<T>> {
    if rings.len() < 2 || sector.sin().is_zero() {
        return Err(NoSurface::NoSector);
    }
    let half = T::from_ratio(1, 2);
    let rays = rays(sector, sectors);
    let radii: Vec<T> = rings.iter().map(|ring| ring.radius.clone()).collect();
    let images: Vec<T> = rings.iter().map(|ring| ring.image.clone()).collect();
    let heights = heights(&radii, &images, T::clone);
    let last = rings.len() - 1;
    let mesh = |radius: &dyn Fn(usize) -> T, height: &dyn Fn(usize) -> T| {
        let point = |(k, j): (usize, usize)| {
            let radius = radius(k);
            Point::new(&radius * &rays[j].x, &radius * &rays[j].y, height(k))
        };
        Mesh::new(grid(last, sectors).map(point).collect(), quad_patch(last, sectors))
    };
    Ok(MeshPair {
        surface: mesh(&|k| rings[k].radius.clone(), &|k| heights[k].clone())?,
        gauss: mesh(&|k| rings[k].image.clone(), &|k| rings[k].image.square() * &half)?,
    })
}
