//! The space of v-parallel meshes, by heights over a fixed top view.

use super::{add, with_points};
use crate::mesh::{FaceId, Mesh, VertexId};
use crate::scalar::{LinearSystem, RationalField};
use crate::space::{Point, TopView};

/// The meshes with planar faces over the top view of a mesh: same combinatorics, same `x` and `y`
/// of every vertex (Sec. 3.1).
///
/// A linear subspace of `R^N` for `N` vertices, the heights; see [`v_parallel_space`].
#[derive(Clone, Debug)]
pub struct VParallelSpace<'a, T> {
    mesh: &'a Mesh<T>,
    system: LinearSystem,
    nullity: usize,
}

/// The meshes with planar faces over the top view of `mesh`, whose own heights do not matter.
///
/// The unknowns are the heights. With three vertices `a`, `b`, `c` of a face whose top views are
/// not collinear, each other vertex `d` lies in their plane:
/// `z_a [bcd] − z_b [acd] + z_c [abd] − z_d [abc] = 0`, where `[·]` is the signed area of the top
/// view. A face whose top view is on a line is planar with any heights. The space contains the
/// affine functions, and the lift `z = |x'|² / 2` wherever the top views of faces are concyclic.
///
/// ```
/// use isogeo::mesh::{FaceList, Mesh};
/// use isogeo::pair::linear_space::v_parallel_space;
/// use isogeo::scalar::{Rational, Ring};
/// use isogeo::space::Point;
/// let q = |n| Rational::from_i64(n);
/// let square = [(0, 0), (1, 0), (1, 1), (0, 1)];
/// let points = square.map(|(x, y)| Point::new(q(x), q(y), q(0))).to_vec();
/// let mut faces = FaceList::new();
/// faces.push([0, 1, 2, 3]);
/// let mesh = Mesh::new(points, faces)?;
/// assert_eq!(v_parallel_space(&mesh).dimension(), 3); // the affine functions
/// # Ok::<(), isogeo::mesh::TopologyError>(())
/// ```
pub fn v_parallel_space<T: RationalField>(mesh: &Mesh<T>) -> VParallelSpace<'_, T> {
    let mut system = LinearSystem::new(mesh.points.len());
    let top: Vec<TopView<T>> = mesh.points.iter().map(Point::top_view).collect();
    let area = |a: VertexId, b: VertexId, c: VertexId| {
        let [a, b, c] = [a, b, c].map(|v| &top[v.index()]);
        (b - a).det(&(c - a))
    };
    for f in mesh.topology.faces() {
        let Some([a, b, c]) = triangle(mesh, f, area) else { continue };
        for &d in mesh.topology.face(f).iter().filter(|d| ![a, b, c].contains(d)) {
            let entries = [
                (a.index(), area(b, c, d)),
                (b.index(), -area(a, c, d)),
                (c.index(), area(a, b, d)),
                (d.index(), -area(a, b, c)),
            ];
            add(&mut system, entries);
        }
    }
    let nullity = system.eliminate().nullity();
    VParallelSpace { mesh, system, nullity }
}

/// Three vertices of a face whose top views are not collinear.
fn triangle<T: RationalField>(
    mesh: &Mesh<T>,
    face: FaceId,
    area: impl Fn(VertexId, VertexId, VertexId) -> T,
) -> Option<[VertexId; 3]> {
    let (&a, rest) = mesh.topology.face(face).split_first()?;
    let differs = |v: &&VertexId| !mesh.points[v.index()].is_parallel_to(&mesh.points[a.index()]);
    let b = *rest.iter().find(differs)?;
    let c = *rest.iter().find(|&&c| !area(a, b, c).is_zero())?;
    Some([a, b, c])
}

impl<T: RationalField> VParallelSpace<'_, T> {
    /// The dimension as a subspace of `R^N`: affine functions of all components included.
    pub fn dimension(&self) -> usize {
        self.nullity
    }

    /// Whether these heights, in the order of the vertices, give planar faces.
    pub fn contains(&self, heights: &[T]) -> bool {
        heights.len() == self.mesh.points.len() && self.system.is_solved_by(heights)
    }

    /// The vertices whose heights may be chosen: those of all others follow.
    pub fn free_vertices(&self) -> Vec<VertexId> {
        let echelon = self.system.eliminate();
        echelon.free_unknowns().iter().map(|&v| VertexId(v as u32)).collect()
    }

    /// A basis: the height is 1 at one of the [free vertices](Self::free_vertices) and 0 at the
    /// other free ones, in their order.
    ///
    /// Over a general top view the number of digits of a height grows with the number of faces
    /// between it and the free vertices, so that a basis is long where the patch is large; see
    /// [`Echelon::kernel`](crate::scalar::Echelon::kernel).
    pub fn basis(&self) -> Vec<Mesh<T>> {
        let lifted = |heights: Vec<T>| {
            let lift = |(p, z): (&Point<T>, T)| Point::new(p.x.clone(), p.y.clone(), z);
            with_points(self.mesh, self.mesh.points.iter().zip(heights).map(lift).collect())
        };
        self.system.eliminate().kernel().into_iter().map(lifted).collect()
    }
}
