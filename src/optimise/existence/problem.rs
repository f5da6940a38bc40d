//! The equations about a mesh, and the centre of the proof near it: the points, moved by little more
//! than their rounding to where the equations hold to some 30 digits.

use rayon::prelude::*;

use super::NoProof;
use crate::mesh::{Topology, VertexId};
use crate::optimise::cholesky::Cholesky;
use crate::optimise::{Goal, Linearisation, Mobility, Polynomial, System};
use crate::scalar::{DoubleDouble, Ring};
use crate::space::{Point, Vector3};

/// The conditions of a goal at the points of a mesh and near them.
pub struct Problem<'a> {
    /// The conditions.
    pub system: System,
    /// Which vertices may move: all, or not at all.
    pub mobility: Vec<Mobility>,
    /// The linearisation at the points. Its gradients are taken as they are, exactly: the matrix J̃.
    pub at: Linearisation,
    points: &'a [Point<f64>],
    /// What leads from the points to the centre.
    pub shifts: Vec<Vector3<f64>>,
    polynomials: Vec<Polynomial>,
}

const ZERO: Vector3<f64> = Vector3 { x: 0.0, y: 0.0, z: 0.0 };

impl<'a> Problem<'a> {
    /// The conditions, with the centre at the points.
    pub fn new(
        topology: &Topology,
        points: &'a [Point<f64>],
        goal: Goal,
        mobility: Vec<Mobility>,
    ) -> Result<Self, NoProof> {
        let system = System::new(goal.conditions(topology, points));
        let at = system.linearise(points, &mobility);
        let mut polynomials = Vec::with_capacity(system.rows());
        for (kind, rows) in system.kinds() {
            let name = kind.name();
            let polynomial = kind.polynomial().ok_or(NoProof::NotPolynomial { name })?;
            if let Some(i) = at.free[rows.clone()].iter().position(|&free| !free) {
                return Err(NoProof::Rigid { name, at: kind.points(i).to_vec() });
            }
            polynomials.extend(rows.map(|_| polynomial));
        }
        let shifts = vec![ZERO; points.len()];
        Ok(Problem { system, mobility, at, points, shifts, polynomials })
    }

    /// The vertices of an equation.
    pub fn places(&self, row: usize) -> &[VertexId] {
        &self.system.places()[self.system.range(row)]
    }

    /// The polynomial of an equation.
    pub fn polynomial(&self, row: usize) -> &Polynomial {
        &self.polynomials[row]
    }

    /// That the conditions depend on each other, this one most.
    pub fn dependent(&self, row: usize, smallest: f64, rounding: f64) -> NoProof {
        NoProof::Dependent {
            name: self.name(row),
            at: self.places(row).to_vec(),
            smallest,
            rounding,
        }
    }

    /// What an equation asks for.
    fn name(&self, row: usize) -> &'static str {
        let kind = self.system.kinds().find(|(_, rows)| rows.contains(&row));
        kind.map_or("", |(kind, _)| kind.name())
    }

    /// Whether a vertex may move.
    pub fn is_free(&self, v: VertexId) -> bool {
        self.mobility[v.index()] != Mobility::Fixed
    }

    /// Coordinates of the centre relative to the first of some points, each made of a difference, which is
    /// exact, and a shift.
    pub fn local<R>(
        &self,
        places: &[VertexId],
        coordinate: impl Fn(DoubleDouble, f64) -> R,
    ) -> Vec<Point<R>> {
        let Some(first) = places.first() else { return Vec::new() };
        let o = &self.points[first.index()];
        let point = |v: &VertexId| {
            let (p, s) = (&self.points[v.index()], &self.shifts[v.index()]);
            let difference = |p: f64, o: f64| DoubleDouble::sum(p, -o);
            Point::new(
                coordinate(difference(p.x, o.x), s.x),
                coordinate(difference(p.y, o.y), s.y),
                coordinate(difference(p.z, o.z), s.z),
            )
        };
        places.iter().map(point).collect()
    }

    /// The value of an equation at the centre.
    pub fn value<R: Ring>(
        &self,
        row: usize,
        coordinate: impl Fn(DoubleDouble, f64) -> R,
    ) -> Option<R> {
        self.polynomials[row].eval(&self.local(self.places(row), coordinate))
    }

    /// A number for each equation, in parallel; `None` where it has another number of points than its
    /// polynomial.
    pub fn rows(
        &self,
        number: impl Fn(usize) -> Option<f64> + Sync + Send,
    ) -> Result<Vec<f64>, NoProof> {
        const CHUNK: usize = 64;
        let rows = (0..self.system.rows()).into_par_iter().with_min_len(CHUNK);
        let numbers: Result<_, usize> = rows.map(|row| number(row).ok_or(row)).collect();
        numbers.map_err(|row| NoProof::NotPolynomial { name: self.name(row) })
    }

    /// Moves the centre by Newton steps with the factor of `J̃ J̃ᵀ`, as long as each halves the residuals.
    pub fn approach(&mut self, factor: &mut Cholesky) -> Result<(), NoProof> {
        let (mut residuals, mut size) = self.residuals()?;
        loop {
            let mut y = residuals;
            factor.solve(&mut y);
            let step = self.system.transposed(&self.at, &y, self.points.len());
            let moved = |(s, d): (&Vector3<f64>, &Vector3<f64>)| {
                Vector3::new(s.x - d.x, s.y - d.y, s.z - d.z)
            };
            let moved = self.shifts.iter().zip(&step).map(moved).collect();
            let before = std::mem::replace(&mut self.shifts, moved);
            let (next, smaller) = self.residuals()?;
            if smaller < size / 2.0 {
                (residuals, size) = (next, smaller);
                continue;
            }
            // What is not a number is not smaller, either.
            if smaller >= size || smaller.is_nan() {
                self.shifts = before;
            }
            return Ok(());
        }
    }

    /// The residuals at the centre over the lengths of the gradients, rounded, and their size.
    fn residuals(&self) -> Result<(Vec<f64>, f64), NoProof> {
        let residuals = self.rows(|row| {
            let value = self.value(row, |difference, shift| difference + DoubleDouble::from(shift));
            Some(value?.high() / self.at.lengths[row])
        })?;
        let size = residuals.iter().map(|r| r * r).sum::<f64>().sqrt();
        Ok((residuals, size))
    }
}
