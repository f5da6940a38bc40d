//! A straight-line program: what a generic function did, operation by operation.

use std::panic::Location;

use super::Evaluation;
use crate::scalar::{Field, Rational, Ring, Sign};

/// A node of a [`Program`]: the result of one instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(u32);

impl NodeId {
    /// Its place in the program, from 0.
    pub fn index(self) -> usize {
        self.0 as usize
    }

    /// The node at a place.
    pub(crate) fn at(index: usize) -> Self {
        NodeId(index as u32)
    }
}

/// One instruction; its operands stand before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Instruction {
    /// The unknown of this number.
    Unknown(u32),
    /// An integer.
    Constant(i64),
    /// A sum.
    Add(NodeId, NodeId),
    /// A difference.
    Sub(NodeId, NodeId),
    /// A product.
    Mul(NodeId, NodeId),
    /// A quotient.
    Div(NodeId, NodeId),
    /// The opposite.
    Neg(NodeId),
}

impl Instruction {
    /// Its operands.
    pub fn operands(self) -> impl Iterator<Item = NodeId> {
        use Instruction::*;
        let (a, b) = match self {
            Unknown(_) | Constant(_) => (None, None),
            Neg(a) => (Some(a), None),
            Add(a, b) | Sub(a, b) | Mul(a, b) | Div(a, b) => (Some(a), Some(b)),
        };
        a.into_iter().chain(b)
    }

    /// The same with other operands.
    pub(crate) fn renamed(self, of: impl Fn(NodeId) -> NodeId) -> Self {
        use Instruction::*;
        match self {
            Unknown(_) | Constant(_) => self,
            Add(a, b) => Add(of(a), of(b)),
            Sub(a, b) => Sub(of(a), of(b)),
            Mul(a, b) => Mul(of(a), of(b)),
            Div(a, b) => Div(of(a), of(b)),
            Neg(a) => Neg(of(a)),
        }
    }

    /// Its value, where those of its operands are given; `None` for a division by zero.
    pub(super) fn evaluate<T: Field>(self, unknowns: &[T], of: impl Fn(NodeId) -> T) -> Option<T> {
        use Instruction::*;
        Some(match self {
            Unknown(n) => unknowns.get(n as usize)?.clone(),
            Constant(n) => T::from_i64(n),
            Add(a, b) => of(a) + of(b),
            Sub(a, b) => of(a) - of(b),
            Mul(a, b) => of(a) * of(b),
            Div(a, b) => of(a).try_div(&of(b))?,
            Neg(a) => -of(a),
        })
    }

    /// Its value with a mistake.
    pub(super) fn mutate<T: Field>(
        self,
        mutation: Mutation,
        unknowns: &[T],
        of: impl Fn(NodeId) -> T,
    ) -> Option<T> {
        use Instruction::*;
        let wrong = match (mutation, self) {
            (Mutation::Sign, Add(a, b)) => Sub(a, b),
            (Mutation::Sign, Sub(a, b)) => Add(a, b),
            (Mutation::Sign, _) => return Some(-self.evaluate(unknowns, of)?),
            (Mutation::Index, Add(_, b)) => Add(b, b),
            (Mutation::Index, Sub(_, b)) => Sub(b, b),
            (Mutation::Index, Mul(_, b)) => Mul(b, b),
            (Mutation::Index, Div(_, b)) => Div(b, b),
            (Mutation::Index | Mutation::Factor, _) => {
                let value = self.evaluate(unknowns, of)?;
                return Some(&value + &value);
            }
        };
        wrong.evaluate(unknowns, of)
    }
}

/// What one wrong instruction does: see [`Evaluation::mutant`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mutation {
    /// `+` becomes `−` and back; any other result changes its sign.
    Sign,
    /// The second operand is taken for the first, too: a wrong index.
    Index,
    /// The result is taken twice.
    Factor,
}

/// What a comparison answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// The node was taken for zero.
    Zero,
    /// The node was taken for different from zero.
    NotZero,
    /// The node was taken to have this sign, which is not zero.
    Sign(Sign),
}

/// A comparison with zero that the recorded code made, and its answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Branch {
    /// What was compared with zero.
    pub node: NodeId,
    /// The answer.
    pub outcome: Outcome,
    /// Who asked.
    pub place: &'static Location<'static>,
}

/// Bounds of the degrees of numerator and denominator of a node, as a quotient of polynomials in
/// the unknowns, and the degree of all that was divided by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Degrees {
    /// Of the numerator.
    pub numerator: f64,
    /// Of the denominator.
    pub denominator: f64,
}

/// A straight-line program: instructions in order, the unknowns' shadows, and the comparisons.
#[derive(Clone, Debug, Default)]
pub struct Program {
    instructions: Vec<Instruction>,
    places: Vec<&'static Location<'static>>,
    shadows: Vec<Rational>,
    branches: Vec<Branch>,
    unknowns: u32,
}

impl Program {
    pub(super) fn push_unknown(
        &mut self,
        shadow: Rational,
        place: &'static Location<'static>,
    ) -> NodeId {
        self.unknowns += 1;
        self.append(Instruction::Unknown(self.unknowns - 1), shadow, place)
    }

    /// Appends an instruction that is not an unknown. Whoever divides by a shadow that is zero
    /// gets the shadow zero, and the division is found among the [divisors](Self::divisors).
    pub(super) fn push(
        &mut self,
        instruction: Instruction,
        place: &'static Location<'static>,
    ) -> NodeId {
        let shadow = instruction.evaluate(&[], |n| self.shadows[n.index()].clone());
        self.append(instruction, shadow.unwrap_or_else(Rational::zero), place)
    }

    fn append(
        &mut self,
        instruction: Instruction,
        shadow: Rational,
        place: &'static Location<'static>,
    ) -> NodeId {
        self.instructions.push(instruction);
        self.shadows.push(shadow);
        self.places.push(place);
        NodeId(self.instructions.len() as u32 - 1)
    }

    pub(super) fn push_branch(&mut self, branch: Branch) {
        self.branches.push(branch);
    }

    pub(super) fn shadow(&self, node: NodeId) -> &Rational {
        &self.shadows[node.index()]
    }

    /// The instruction of a node.
    pub fn instruction(&self, node: NodeId) -> Instruction {
        self.instructions[node.index()]
    }

    /// The shadows of the unknowns, in order.
    pub fn unknown_shadows(&self) -> impl Iterator<Item = &Rational> {
        let unknown = |(i, _): &(&Instruction, &Rational)| matches!(i, Instruction::Unknown(_));
        self.instructions.iter().zip(&self.shadows).filter(unknown).map(|(_, shadow)| shadow)
    }

    /// How many unknowns there are.
    pub fn unknowns(&self) -> usize {
        self.unknowns as usize
    }

    /// The comparisons with zero that were made on the way.
    pub fn branches(&self) -> &[Branch] {
        &self.branches
    }

    /// Where in the source an instruction stands.
    pub fn place(&self, node: NodeId) -> &'static Location<'static> {
        self.places[node.index()]
    }

    /// All nodes in order.
    pub fn nodes(&self) -> impl Iterator<Item = NodeId> + use<> {
        (0..self.instructions.len() as u32).map(NodeId)
    }

    /// Which instructions the goals need, by index.
    pub fn slice(&self, goals: &[NodeId]) -> Vec<bool> {
        let mut needed = vec![false; self.instructions.len()];
        for goal in goals {
            needed[goal.index()] = true;
        }
        for (n, instruction) in self.instructions.iter().enumerate().rev() {
            if needed[n] {
                for operand in instruction.operands() {
                    needed[operand.index()] = true;
                }
            }
        }
        needed
    }

    /// The divisors of a slice, each with the division.
    pub fn divisors(&self, slice: &[bool]) -> Vec<(NodeId, NodeId)> {
        let division = |n: NodeId| match self.instructions[n.index()] {
            Instruction::Div(_, divisor) if slice[n.index()] => Some((divisor, n)),
            _ => None,
        };
        self.nodes().filter_map(division).collect()
    }

    /// The values of the goals at given values of the unknowns; `None` where that divides by zero.
    pub fn evaluate<T: Field>(&self, unknowns: &[T], goals: &[NodeId]) -> Option<Vec<T>> {
        Some(Evaluation::of(self, unknowns, goals)?.goals())
    }

    /// Degrees in the unknowns, with no cancellation assumed: upper bounds for every node.
    pub fn degrees(&self) -> Vec<Degrees> {
        use Instruction::*;
        let mut all: Vec<Degrees> = Vec::with_capacity(self.instructions.len());
        for &instruction in &self.instructions {
            let of = |n: NodeId| all[n.index()];
            let degrees = |numerator, denominator| Degrees { numerator, denominator };
            all.push(match instruction {
                Unknown(_) => degrees(1.0, 0.0),
                Constant(_) => degrees(0.0, 0.0),
                Neg(a) => of(a),
                Add(a, b) | Sub(a, b) => {
                    let (a, b) = (of(a), of(b));
                    let numerator = (a.numerator + b.denominator).max(b.numerator + a.denominator);
                    degrees(numerator, a.denominator + b.denominator)
                }
                Mul(a, b) => {
                    let (a, b) = (of(a), of(b));
                    degrees(a.numerator + b.numerator, a.denominator + b.denominator)
                }
                Div(a, b) => {
                    let (a, b) = (of(a), of(b));
                    degrees(a.numerator + b.denominator, a.denominator + b.numerator)
                }
            });
        }
        all
    }
}
