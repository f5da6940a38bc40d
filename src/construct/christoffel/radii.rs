//! The Christoffel dual of a mesh with touching vertex circles.

use super::labels::Labels;
use super::{ChristoffelDual, NoChristoffelDual, integrated};
use crate::mesh::{Mesh, VertexId};
use crate::net::RADIUS;
use crate::scalar::Field;

/// The Christoffel dual with the edges `±(v_j − v_i)/(R_i R_j)`, where R are the signed radii of
/// circles that touch along the edges; the radii `1/R` are those of the dual.
///
/// The first edge of the first face has the sign `+`; around a face the signs alternate, so that in
/// a patch of quads the rows have `+` and the columns `−`. Faces may have any even number of sides.
/// For the dual F of a quad S with an incircle `area(S)/area(F) = −R₀ R₁ R₂ R₃`.
///
/// The dual of a Koebe mesh is an i-minimal i-isothermic mesh.
///
/// ```
/// use isogeo::construct::{christoffel_by_radii, koebe_mesh, quad_patch, square_packing};
/// use isogeo::scalar::{Rational, Ring};
/// use isogeo::space::Point;
/// let mesh = koebe_mesh(square_packing::<Rational>(2, 2), quad_patch(2, 2))?;
/// let radii = &mesh.data.vertex["radius"];
/// let saddle = christoffel_by_radii(&mesh, radii).map(|dual| dual.mesh.points[8].clone());
/// // 4 (x, −y, (x² − y²)/2) at (2, 2)
/// assert_eq!(saddle, Ok(Point::new(8, -8, 0).map(|&c| Rational::from_i64(c))));
/// # Ok::<(), isogeo::mesh::TopologyError>(())
/// ```
///
/// # Errors
/// See [`NoChristoffelDual`]; a list of radii that is too short or too long is one.
pub fn christoffel_by_radii<T: Field>(
    mesh: &Mesh<T>,
    radii: &[T],
) -> Result<ChristoffelDual<T>, NoChristoffelDual<T>> {
    if radii.len() != mesh.points.len() || mesh.points.len() != mesh.topology.vertex_count() {
        return Err(NoChristoffelDual::Counts);
    }
    let inverse = |(i, radius): (usize, &T)| {
        radius.try_inv().ok_or(NoChristoffelDual::ZeroRadius(VertexId(i as u32)))
    };
    let factors: Vec<T> = radii.iter().enumerate().map(inverse).collect::<Result<_, _>>()?;
    let topology = &mesh.topology;
    let labels = Labels::new(topology)?;
    let mut dual = integrated(mesh, |h| {
        let factor = &factors[topology.origin(h).index()] * &factors[topology.target(h).index()];
        if labels.is_positive(h) { factor } else { -factor }
    })?;
    dual.data.vertex.insert(RADIUS.to_owned(), factors.clone());
    Ok(ChristoffelDual { mesh: dual, factors })
}
