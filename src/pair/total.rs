//! The sum of the measures of all vertices: Gauss-Bonnet.

use super::{Forms, VParallel, Which};
use crate::mesh::VertexKind;
use crate::scalar::{Field, Ring};
use crate::space::Gradient;

/// The forms of all interior vertices together, computed twice.
///
/// The polygons of gradients around the interior vertices are the faces of the dual mesh; their
/// areas add up to what its boundary encloses. So both values agree:
///
/// ```math
/// Σ D(v) = ½ Σ det(p_j, p_{j+1})  along the loops of outermost faces,
/// ```
///
/// and likewise for `D(v, s)` and `D(s)`. A mesh without boundary has the total 0.
#[derive(Clone, Debug, PartialEq)]
pub struct TotalForms<T> {
    /// The sum over the interior vertices.
    pub interior: Forms<T>,
    /// The sum along the boundary of the dual mesh: over the edges from an interior vertex to one
    /// that is not.
    pub boundary: Forms<T>,
}

impl<T: Field> VParallel<'_, T> {
    /// The total of the forms, from the vertices and from the boundary.
    pub fn total_forms(&self) -> TotalForms<T> {
        let topology = &self.mesh().topology;
        let (mut interior, mut boundary) = (Forms::zero(), Forms::zero());
        for v in topology.interior_vertices() {
            if let Ok(forms) = self.vertex_forms(v) {
                interior = interior.plus(&forms.four);
            }
            let outwards = |h: &_| topology.kind(topology.target(*h)) != VertexKind::Interior;
            for h in topology.star(v).filter(outwards) {
                if let Some(twin) = topology.twin(h) {
                    let [right, left] = [twin, h].map(|h| {
                        let face = topology.face_at(h);
                        [Which::Mesh, Which::Image].map(|m| self.gradient(m, face))
                    });
                    boundary = boundary.plus(&segment(right, left));
                }
            }
        }
        TotalForms { interior, boundary }
    }
}

/// What one side of the two polygons, from the origin, adds to the forms.
fn segment<T: Ring>([p, q]: [&Gradient<T>; 2], [next_p, next_q]: [&Gradient<T>; 2]) -> Forms<T> {
    let det = |a: &Gradient<T>, b: &Gradient<T>| T::det2(&a.x, &a.y, &b.x, &b.y);
    let two = T::from_i64(2);
    Forms {
        first: det(p, next_p) * &two,
        mixed: det(p, next_q) + det(q, next_p),
        second: det(q, next_q) * two,
    }
}
