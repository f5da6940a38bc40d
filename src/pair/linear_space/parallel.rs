//! The space of parallel meshes, by factors on edges that close around faces and cycles.

use super::cycles::{Forest, Step};
use super::{add, with_points};
use crate::mesh::{HalfEdge, Mesh, VertexId};
use crate::scalar::{LinearSystem, RationalField};
use crate::space::{Point, Vector3};

/// The meshes `M'` parallel to a mesh `M`: same combinatorics, and `e × e' = 0` for corresponding
/// edges, so that an edge of length 0 is parallel to every vector (Sec. 3.1).
///
/// A linear subspace of `R^(3 N)` for `N` vertices; see [`parallel_space`].
#[derive(Clone, Debug)]
pub struct ParallelSpace<'a, T> {
    mesh: &'a Mesh<T>,
    forest: Forest,
    factors: Factors<T>,
    system: LinearSystem,
    nullity: usize,
}

/// The unknowns: factors of vectors along edges.
#[derive(Clone, Debug)]
struct Factors<T> {
    /// The range of unknowns of each half-edge, empty for the second one of an edge.
    ranges: Vec<std::ops::Range<usize>>,
    /// The vector that each unknown multiplies.
    along: Vec<Vector3<T>>,
}

/// The meshes parallel to `mesh`, translations included.
///
/// Unknown is a factor `λ` for every edge, `e' = λ e`; an edge of length 0 has three unknowns, the
/// coordinates of `e'`. The equations: edges close around every face (two equations where it is
/// planar), and around every cycle that faces do not fill: handles, holes, pinched vertices. The
/// alternative, `3 N` unknown coordinates with `e × e' = 0`, has three times as many unknowns and
/// equations that depend on each other; here those of a patch are independent in general, so that
/// one elimination modulo one prime proves the dimension.
///
/// Faces need not be planar; the space contains `M` itself in any case, and a triangle mesh has
/// nothing else: dimension 1 + 3. Where faces have edges of length 0, or consecutive edges on a
/// line, corresponding faces need not be planar.
///
/// ```
/// use isogeo::mesh::{FaceList, Mesh};
/// use isogeo::pair::linear_space::parallel_space;
/// use isogeo::scalar::{Rational, Ring};
/// use isogeo::space::Point;
/// let q = |n| Rational::from_i64(n);
/// let square = [(0, 0), (1, 0), (1, 1), (0, 1)];
/// let points = square.map(|(x, y)| Point::new(q(x), q(y), q(0))).to_vec();
/// let mut faces = FaceList::new();
/// faces.push([0, 1, 2, 3]);
/// let mesh = Mesh::new(points, faces)?;
/// let rectangles = parallel_space(&mesh);
/// assert_eq!(rectangles.dimension_modulo_translations(), 2); // width and height
/// assert_eq!(rectangles.dimension(), 5);
/// # Ok::<(), isogeo::mesh::TopologyError>(())
/// ```
pub fn parallel_space<T: RationalField>(mesh: &Mesh<T>) -> ParallelSpace<'_, T> {
    let topology = &mesh.topology;
    let forest = Forest::new(topology);
    let factors = Factors::new(mesh);
    let mut system = LinearSystem::new(factors.along.len());
    for f in topology.faces() {
        let edges: Vec<Vector3<T>> = topology.half_edges(f).map(|h| edge(mesh, h)).collect();
        let around: Vec<Step> = topology
            .half_edges(f)
            .map(|h| match topology.twin(h) {
                Some(twin) if factors.ranges[h.0 as usize].is_empty() => (twin, true),
                _ => (h, false),
            })
            .collect();
        for axis in axes(&edges) {
            add(&mut system, factors.sum(&around, axis));
        }
    }
    for cycle in forest.unfilled_cycles(topology) {
        for axis in 0..3 {
            add(&mut system, factors.sum(&cycle, axis));
        }
    }
    let nullity = system.eliminate().nullity();
    ParallelSpace { mesh, forest, factors, system, nullity }
}

impl<T: RationalField> ParallelSpace<'_, T> {
    /// The dimension as a subspace of `R^(3 N)`: translations of every component included.
    pub fn dimension(&self) -> usize {
        self.nullity + 3 * self.component_count()
    }

    /// The dimension where meshes count as one if they differ by translations of components.
    pub fn dimension_modulo_translations(&self) -> usize {
        self.nullity
    }

    /// The number of components, isolated vertices counted: each is translated by itself.
    pub fn component_count(&self) -> usize {
        self.roots().count()
    }

    /// A basis modulo translations: meshes whose first vertex, in every component, is the origin.
    ///
    /// The number of digits may grow with the number of faces, see
    /// [`Echelon::kernel`](crate::scalar::Echelon::kernel).
    pub fn basis(&self) -> Vec<Mesh<T>> {
        self.system.eliminate().kernel().iter().map(|factors| self.integrate(factors)).collect()
    }

    /// The translations: for every component, its vertices at the end of the unit vector along x,
    /// y or z, all others at the origin. With [`basis`](Self::basis) a basis of the whole space.
    pub fn translations(&self) -> Vec<Mesh<T>> {
        let moved = |root: VertexId| {
            (0..3).map(move |axis| {
                let place = |&r: &VertexId| &origin() + &unit(if r == root { axis } else { 3 });
                with_points(self.mesh, self.forest.roots.iter().map(place).collect())
            })
        };
        self.roots().flat_map(moved).collect()
    }

    fn roots(&self) -> impl Iterator<Item = VertexId> + '_ {
        self.mesh.topology.vertices().filter(|v| self.forest.roots[v.index()] == *v)
    }

    /// The mesh with these edges, from the origin in every component.
    fn integrate(&self, factors: &[T]) -> Mesh<T> {
        let mut points = vec![origin(); self.mesh.points.len()];
        for &v in &self.forest.order {
            let Some((parent, (h, backwards))) = self.forest.parent(&self.mesh.topology, v) else {
                continue;
            };
            let mut point = points[parent.index()].clone();
            for i in self.factors.ranges[h.0 as usize].clone() {
                let factor = if backwards { -&factors[i] } else { factors[i].clone() };
                let [x, y, z] = coordinates(&self.factors.along[i]).map(|c| c * &factor);
                point = &point + &Vector3 { x, y, z };
            }
            points[v.index()] = point;
        }
        with_points(self.mesh, points)
    }
}

impl<T: RationalField> Factors<T> {
    fn new(mesh: &Mesh<T>) -> Self {
        let mut ranges = vec![0..0; mesh.topology.corner_count()];
        let mut along = Vec::new();
        for h in mesh.topology.edges() {
            let start = along.len();
            match edge(mesh, h) {
                e if is_zero(&e) => along.extend((0..3).map(unit)),
                e => along.push(e),
            }
            ranges[h.0 as usize] = start..along.len();
        }
        Factors { ranges, along }
    }

    /// `Σ λ e` along a chain, in one coordinate: the entries of an equation.
    fn sum<'b>(&'b self, chain: &'b [Step], axis: usize) -> impl Iterator<Item = (usize, T)> + 'b {
        chain.iter().flat_map(move |&(h, backwards)| {
            let entry = move |i: usize| {
                let length = coordinates(&self.along[i])[axis];
                (i, if backwards { -length } else { length.clone() })
            };
            self.ranges[h.0 as usize].clone().map(entry)
        })
    }
}

/// The coordinates in which a face must close; in the others it then does by itself.
fn axes<T: RationalField>(edges: &[Vector3<T>]) -> Vec<usize> {
    let all = vec![0, 1, 2];
    if edges.iter().any(is_zero) {
        return all;
    }
    let seen = |v: &Vector3<T>| coordinates(v).iter().position(|c| !c.is_zero());
    let Some((first, others)) = edges.split_first() else { return Vec::new() };
    match others.iter().map(|e| first.cross(e)).find(|n| !is_zero(n)) {
        // All edges on one line: the coordinate in which it is not a point.
        None => seen(first).into_iter().collect(),
        // Two coordinates in which the plane is not a line.
        Some(normal) if edges.iter().all(|e| normal.dot(e).is_zero()) => {
            all.into_iter().filter(|axis| seen(&normal) != Some(*axis)).collect()
        }
        Some(_) => all,
    }
}

fn edge<T: RationalField>(mesh: &Mesh<T>, h: HalfEdge) -> Vector3<T> {
    let point = |v: VertexId| &mesh.points[v.index()];
    point(mesh.topology.target(h)) - point(mesh.topology.origin(h))
}

fn coordinates<T>(v: &Vector3<T>) -> [&T; 3] {
    [&v.x, &v.y, &v.z]
}

fn is_zero<T: RationalField>(v: &Vector3<T>) -> bool {
    coordinates(v).iter().all(|c| c.is_zero())
}

fn origin<T: RationalField>() -> Point<T> {
    Point::new(T::zero(), T::zero(), T::zero())
}

/// The unit vector along x, y or z; zero for another number.
fn unit<T: RationalField>(axis: usize) -> Vector3<T> {
    let [x, y, z] = [0, 1, 2].map(|i| T::from_i64(i64::from(i == axis)));
    Vector3 { x, y, z }
}
