//! A triangulated sphere that can be changed: the triangulation of a plane region and, around
//! it, triangles that join the boundary to a vertex at infinity.
//!
//! With that vertex every edge has two triangles, and to cut a triangle off the boundary, to fill a
//! reflex corner of it, and to exchange a diagonal are one and the same flip.

/// The index of a half-edge: `3 t + i` is the one from corner `i` of triangle `t`.
pub(super) type Half = u32;

const NONE: u32 = u32::MAX;

/// Triangles over the vertices `0..n` and the vertex `n` at infinity.
#[derive(Clone, Debug)]
pub(super) struct Sphere {
    corners: Vec<u32>,
    twins: Vec<Half>,
    /// A half-edge from each vertex, `NONE` for a vertex that is not in yet.
    outgoing: Vec<Half>,
}

#[inline]
pub(super) fn next(h: Half) -> Half {
    if h % 3 == 2 { h - 2 } else { h + 1 }
}

#[inline]
pub(super) fn prev(h: Half) -> Half {
    if h.is_multiple_of(3) { h + 2 } else { h - 1 }
}

impl Sphere {
    /// No triangle yet, room for `n` vertices.
    pub fn empty(n: usize) -> Sphere {
        Sphere {
            corners: Vec::with_capacity(6 * n),
            twins: Vec::with_capacity(6 * n),
            outgoing: vec![NONE; n + 1],
        }
    }

    /// The triangle `abc` in counter-clockwise order, and what lies outside of it.
    pub fn of_triangle(n: usize, [a, b, c]: [u32; 3]) -> Sphere {
        let mut sphere = Sphere::empty(n);
        let infinity = sphere.infinity();
        let inside = sphere.push([a, b, c]);
        let outside = [(b, a), (c, b), (a, c)].map(|(u, v)| sphere.push([u, v, infinity]));
        for i in 0..3 {
            sphere.join(inside + i as u32, outside[i]);
            // Behind the edge bc, the side from c leaves for infinity where that of ab comes back.
            sphere.join(next(outside[i]), prev(outside[(i + 2) % 3]));
        }
        sphere
    }

    /// The vertex at infinity.
    pub fn infinity(&self) -> u32 {
        self.outgoing.len() as u32 - 1
    }

    /// Appends a triangle without neighbours and gives its first half-edge.
    pub fn push(&mut self, triangle: [u32; 3]) -> Half {
        let first = self.corners.len() as u32;
        for (i, v) in triangle.into_iter().enumerate() {
            self.corners.push(v);
            self.twins.push(NONE);
            self.outgoing[v as usize] = first + i as u32;
        }
        first
    }

    /// Makes two half-edges the two sides of one edge.
    pub fn join(&mut self, g: Half, h: Half) {
        self.twins[g as usize] = h;
        self.twins[h as usize] = g;
    }

    /// The number of half-edges.
    pub fn len(&self) -> u32 {
        self.corners.len() as u32
    }

    /// The vertex that a half-edge starts from.
    #[inline]
    pub fn origin(&self, h: Half) -> u32 {
        self.corners[h as usize]
    }

    /// The vertex that a half-edge goes to.
    #[inline]
    pub fn target(&self, h: Half) -> u32 {
        self.origin(next(h))
    }

    /// The third vertex of the triangle on the left.
    #[inline]
    pub fn apex(&self, h: Half) -> u32 {
        self.origin(prev(h))
    }

    /// The other side of an edge.
    #[inline]
    pub fn twin(&self, h: Half) -> Half {
        self.twins[h as usize]
    }

    /// Whether this side stands for its edge: one of the two does.
    pub fn is_first_side(&self, h: Half) -> bool {
        h < self.twin(h)
    }

    /// The triangle that starts with a half-edge.
    pub fn triangle(&self, h: Half) -> [u32; 3] {
        [self.origin(h), self.target(h), self.apex(h)]
    }

    /// Whether a vertex is in a triangle.
    pub fn contains(&self, v: u32) -> bool {
        self.outgoing[v as usize] != NONE
    }

    /// A half-edge from a vertex that is in a triangle.
    pub fn outgoing(&self, v: u32) -> Half {
        self.outgoing[v as usize]
    }

    /// The neighbours of a vertex in counter-clockwise order; the boundary in clockwise order for
    /// the vertex at infinity.
    pub fn neighbours(&self, v: u32) -> impl Iterator<Item = u32> + '_ {
        let first = self.outgoing[v as usize];
        let turn = move |&h: &Half| Some(self.twin(prev(h))).filter(|&h| h != first);
        let start = (first != NONE).then_some(first);
        std::iter::successors(start, turn).map(|h| self.target(h))
    }

    /// Replaces the edge of two triangles by the other diagonal of their union; `false`, and nothing
    /// is done, where that diagonal is an edge elsewhere.
    pub fn flip(&mut self, h: Half) -> bool {
        let t = self.twin(h);
        let (a, b, c, d) = (self.origin(h), self.origin(t), self.apex(h), self.apex(t));
        // The vertex at infinity has many neighbours, so the other one is asked.
        let (from, to) = if c == self.infinity() { (d, c) } else { (c, d) };
        if self.neighbours(from).any(|v| v == to) {
            return false;
        }
        let (beyond_db, beyond_ca) = (self.twin(prev(t)), self.twin(prev(h)));
        self.corners[h as usize] = d;
        self.corners[t as usize] = c;
        self.join(h, beyond_db);
        self.join(t, beyond_ca);
        self.join(prev(h), prev(t));
        self.outgoing[a as usize] = next(t);
        self.outgoing[b as usize] = next(h);
        true
    }

    /// Joins a new vertex to the corners of the triangle of `h`; gives the sides of that triangle.
    pub fn split(&mut self, h: Half, v: u32) -> [Half; 3] {
        let sides = [h, next(h), prev(h)];
        let [a, b, c] = self.triangle(h);
        let (beyond_bc, beyond_ca) = (self.twin(sides[1]), self.twin(sides[2]));
        let second = self.push([b, c, v]);
        let third = self.push([c, a, v]);
        self.corners[sides[2] as usize] = v;
        self.join(second, beyond_bc);
        self.join(third, beyond_ca);
        self.join(sides[1], prev(second));
        self.join(next(second), prev(third));
        self.join(next(third), sides[2]);
        self.outgoing[a as usize] = h;
        self.outgoing[v as usize] = sides[2];
        [h, second, third]
    }
}
