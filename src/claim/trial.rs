//! One run of a piece of evidence: its unknowns, its hypotheses and what has to vanish.

use std::borrow::Cow;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::mesh::Mesh;
use crate::scalar::Field;
use crate::space::{Point, Vector2, Vector3};

/// Why a run ended before its goals.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The drawn numbers do not satisfy this hypothesis.
    Excluded(&'static str),
    /// The code that is tested refused an instance that satisfies the hypotheses.
    Failed(Cow<'static, str>),
}

/// The result of a run.
pub type Run = Result<(), Stop>;

/// Runs something; a panic is a failure.
///
/// # Errors
/// As the run, and where it panics.
pub fn caught(run: impl FnOnce() -> Run) -> Run {
    catch_unwind(AssertUnwindSafe(run)).unwrap_or_else(|cause| {
        let text = cause.downcast_ref::<String>().map(String::as_str);
        let text = text.or(cause.downcast_ref::<&str>().copied()).unwrap_or("of unknown cause");
        Err(Stop::Failed(format!("a panic: {text}").into()))
    })
}

/// A value that a run assumes not to be zero.
#[derive(Clone, Debug)]
pub(super) struct Assumption<T> {
    pub(super) says: &'static str,
    /// Whether it is a hypothesis of the claim, or belongs to the way an instance is made.
    pub(super) hypothesis: bool,
    pub(super) value: T,
}

impl<T> Assumption<T> {
    pub(super) fn map<S>(self, f: impl Fn(T) -> S) -> Assumption<S> {
        Assumption { says: self.says, hypothesis: self.hypothesis, value: f(self.value) }
    }
}

/// Numbers in, goals out: see [`Identity`](super::Identity).
pub struct Trial<T> {
    size: usize,
    draw: Box<dyn FnMut() -> T>,
    forget: Box<dyn FnMut(T) -> T>,
    moved: Option<usize>,
    ignored: Option<&'static str>,
    pub(super) made: usize,
    pub(super) unknowns: Vec<T>,
    pub(super) conditions: Vec<Assumption<T>>,
    pub(super) relations: Vec<(&'static str, T)>,
    pub(super) goals: Vec<(Cow<'static, str>, T)>,
    pub(super) values: Vec<(Cow<'static, str>, T)>,
    pub(super) meshes: Vec<(&'static str, Mesh<T>)>,
}

impl<T> fmt::Debug for Trial<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Trial").field("size", &self.size).finish_non_exhaustive()
    }
}

impl<T: Field> Trial<T> {
    /// A trial of this size with a source of unknowns.
    pub fn new(size: usize, draw: impl FnMut() -> T + 'static) -> Self {
        Trial {
            size,
            draw: Box::new(draw),
            forget: Box::new(|value| value),
            moved: None,
            ignored: None,
            made: 0,
            unknowns: Vec::new(),
            conditions: Vec::new(),
            relations: Vec::new(),
            goals: Vec::new(),
            values: Vec::new(),
            meshes: Vec::new(),
        }
    }

    /// The same with given unknowns, then zeros.
    pub fn given(size: usize, unknowns: Vec<T>) -> Self {
        let mut unknowns = unknowns.into_iter();
        Trial::new(size, move || unknowns.next().unwrap_or_else(T::zero))
    }

    /// The same where numbers under a relation are replaced by what `forget` makes of them.
    pub fn forgetting(self, forget: impl FnMut(T) -> T + 'static) -> Self {
        Trial { forget: Box::new(forget), ..self }
    }

    /// The same with the `n`-th number that was [made](Self::made) moved by 1/7.
    pub fn moving(self, n: usize) -> Self {
        Trial { moved: Some(n), ..self }
    }

    /// The same without one hypothesis.
    pub fn ignoring(self, hypothesis: &'static str) -> Self {
        Trial { ignored: Some(hypothesis), ..self }
    }

    /// The size of the instance: corners of a face, faces of a row.
    pub fn size(&self) -> usize {
        self.size
    }

    /// A new unknown.
    pub fn free(&mut self) -> T {
        let value = (self.draw)();
        self.unknowns.push(value.clone());
        value
    }

    /// Two unknowns.
    pub fn free_vector2(&mut self) -> Vector2<T> {
        Vector2::new(self.free(), self.free())
    }

    /// Three unknowns.
    pub fn free_vector3(&mut self) -> Vector3<T> {
        Vector3::new(self.free(), self.free(), self.free())
    }

    /// Three unknowns.
    pub fn free_point(&mut self) -> Point<T> {
        Point::new(self.free(), self.free(), self.free())
    }

    /// A number that was constructed and on which the goals depend: a control moves each of them
    /// in turn, and the goals have to notice.
    pub fn made(&mut self, value: T) -> T {
        self.made += 1;
        match self.moved {
            Some(n) if n + 1 == self.made => value + T::from_ratio(1, 7),
            _ => value,
        }
    }

    /// A point that was [made](Self::made).
    pub fn made_point(&mut self, p: Point<T>) -> Point<T> {
        Point::new(self.made(p.x), self.made(p.y), self.made(p.z))
    }

    /// A vector that was [made](Self::made).
    pub fn made_vector2(&mut self, v: Vector2<T>) -> Vector2<T> {
        Vector2::new(self.made(v.x), self.made(v.y))
    }

    /// A mesh that was [made](Self::made).
    pub fn made_mesh(&mut self, mut mesh: Mesh<T>) -> Mesh<T> {
        mesh.points = mesh.points.into_iter().map(|p| self.made_point(p)).collect();
        mesh
    }

    /// A number that was computed so that a [relation](Self::relation) holds. Where a claim is
    /// decided it becomes an unknown of its own, of which the relation is all that is known.
    pub fn constrained(&mut self, value: T) -> T {
        let value = self.made(value);
        (self.forget)(value)
    }

    /// The same for two numbers.
    pub fn constrained_vector2(&mut self, v: Vector2<T>) -> Vector2<T> {
        Vector2::new(self.constrained(v.x), self.constrained(v.y))
    }

    /// A hypothesis `value = 0` on numbers that are [constrained](Self::constrained).
    ///
    /// # Errors
    /// [`Stop::Failed`] where the construction does not satisfy it.
    pub fn relation(&mut self, hypothesis: &'static str, value: T) -> Run {
        let holds = value.is_zero();
        self.relations.push((hypothesis, value));
        if holds || self.moved.is_some() || self.ignored.is_some() {
            return Ok(());
        }
        Err(Stop::Failed(format!("the instance is not made so that {hypothesis}").into()))
    }

    /// A hypothesis `value ≠ 0`.
    ///
    /// # Errors
    /// [`Stop::Excluded`] where it does not hold, unless it is ignored.
    pub fn nonzero(&mut self, hypothesis: &'static str, value: &T) -> Run {
        self.assume(hypothesis, true, value)
    }

    /// A condition `value ≠ 0` of the way in which the instance is made, not of the claim: the
    /// instances that it leaves out are reached otherwise, or are not worth a word.
    ///
    /// # Errors
    /// [`Stop::Excluded`] where it does not hold.
    pub fn parameter(&mut self, says: &'static str, value: &T) -> Run {
        self.assume(says, false, value)
    }

    fn assume(&mut self, says: &'static str, hypothesis: bool, value: &T) -> Run {
        self.conditions.push(Assumption { says, hypothesis, value: value.clone() });
        if value.is_zero() && self.ignored != Some(says) {
            return Err(Stop::Excluded(says));
        }
        Ok(())
    }

    /// A value that the code defines where the hypothesis holds.
    ///
    /// # Errors
    /// [`Stop::Excluded`] where there is none; [`Stop::Failed`] where the hypothesis is ignored.
    pub fn defined<V>(&mut self, hypothesis: &'static str, value: Option<V>) -> Result<V, Stop> {
        value.ok_or(if self.ignored == Some(hypothesis) {
            Stop::Failed(format!("nothing is defined without: {hypothesis}").into())
        } else {
            Stop::Excluded(hypothesis)
        })
    }

    /// A result that the code must not refuse.
    ///
    /// # Errors
    /// [`Stop::Failed`] where it does.
    pub fn accepted<V, E: fmt::Debug>(
        &mut self,
        what: &'static str,
        result: Result<V, E>,
    ) -> Result<V, Stop> {
        result.map_err(|error| Stop::Failed(format!("{what}: {error:?}").into()))
    }

    /// A goal: the value has to vanish.
    pub fn zero(&mut self, what: impl Into<Cow<'static, str>>, value: T) {
        self.goals.push((what.into(), value));
    }

    /// A goal: the two values have to be equal.
    pub fn equal(&mut self, what: impl Into<Cow<'static, str>>, a: &T, b: &T) {
        self.zero(what, a - b);
    }

    /// Goals: the points have to be equal.
    pub fn equal_points(&mut self, what: &'static str, a: &Point<T>, b: &Point<T>) {
        self.equal(what, &a.x, &b.x);
        self.equal(what, &a.y, &b.y);
        self.equal(what, &a.z, &b.z);
    }

    /// Names a value, for the example of the claim.
    pub fn show(&mut self, name: impl Into<Cow<'static, str>>, value: &T) {
        self.values.push((name.into(), value.clone()));
    }

    /// Names a mesh: it is written where the claim fails.
    pub fn exhibit(&mut self, name: &'static str, mesh: &Mesh<T>) {
        self.meshes.push((name, mesh.clone()));
    }

    /// The first goal that does not vanish.
    pub fn broken(&self) -> Option<&(Cow<'static, str>, T)> {
        self.goals.iter().find(|(_, value)| !value.is_zero())
    }
}
