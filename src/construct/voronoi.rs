//! Voronoi cells of a Delaunay mesh: where they are finite for sure, their areas are D(s).

use rayon::prelude::*;

use super::star::gradients;
use crate::mesh::Mesh;
use crate::pair::Forms;
use crate::scalar::Field;
use crate::space::{ParabolicSphere, Point};

/// The areas of the Voronoi cells of the interior vertices, in the order of the vertices; `None` at
/// the others, whose cells leave the hull or are infinite.
///
/// The area is `D(s)` of (22): the gradients of the lifted triangles around a vertex are their
/// circumcentres, the corners of its cell. That needs a Delaunay mesh. On other triangle meshes
/// the value is the signed circumcentric area, which may be negative.
///
/// ```
/// use isogeo::construct::{delaunay, voronoi_areas};
/// use isogeo::scalar::{Rational, Ring};
/// use isogeo::space::Point;
/// let corners = [(0, 0), (2, 0), (0, 2), (-2, 0), (0, -2)];
/// let points = corners.map(|(x, y)| Point::new(x, y, 0).map(|&c| Rational::from_i64(c)));
/// let areas = voronoi_areas(&delaunay(points.into())?);
/// assert_eq!(areas[0], Some(Rational::from_i64(4))); // the square |x|, |y| ≤ 1
/// assert_eq!(areas[1], None);
/// # Ok::<(), isogeo::construct::NoTriangulation>(())
/// ```
pub fn voronoi_areas<T: Field>(mesh: &Mesh<T>) -> Vec<Option<T>> {
    let quarter = T::from_ratio(1, 4);
    let sigma = ParabolicSphere::unit();
    let lift = |p: &Point<T>| sigma.contact_at(&p.top_view()).point;
    let points: Vec<Point<T>> = mesh.points.par_iter().map(lift).collect();
    let vertices: Vec<_> = mesh.topology.vertices().collect();
    let area = |&v: &_| {
        let ring = gradients(&mesh.topology, v, |u| points[u.index()].clone())?;
        Some(Forms::of(&ring, &ring).second * &quarter)
    };
    vertices.par_iter().map(area).collect()
}
