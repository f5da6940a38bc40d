//! The values of a program at one place, and what one wrong instruction makes of them.

use std::collections::{BTreeSet, HashMap};

use super::{Mutation, NodeId, Program};
use crate::scalar::Field;

/// The values of all nodes that some goals need, at given values of the unknowns.
#[derive(Clone, Debug)]
pub struct Evaluation<'a, T> {
    program: &'a Program,
    unknowns: &'a [T],
    goals: &'a [NodeId],
    values: Vec<Option<T>>,
    /// Who needs a node.
    users: Vec<Vec<NodeId>>,
}

impl<'a, T: Field> Evaluation<'a, T> {
    /// Evaluates once, in linear time; `None` where that divides by zero.
    pub fn of(program: &'a Program, unknowns: &'a [T], goals: &'a [NodeId]) -> Option<Self> {
        let slice = program.slice(goals);
        let mut values: Vec<Option<T>> = Vec::with_capacity(slice.len());
        let mut users = vec![Vec::new(); slice.len()];
        for node in program.nodes() {
            if !slice[node.index()] {
                values.push(None);
                continue;
            }
            let instruction = program.instruction(node);
            let of = |n: NodeId| values[n.index()].clone().unwrap_or_else(T::zero);
            let value = instruction.evaluate(unknowns, of)?;
            values.push(Some(value));
            for operand in instruction.operands() {
                users[operand.index()].push(node);
            }
        }
        Some(Evaluation { program, unknowns, goals, values, users })
    }

    fn value(&self, node: NodeId) -> T {
        self.values[node.index()].clone().unwrap_or_else(T::zero)
    }

    /// The values of the goals.
    pub fn goals(&self) -> Vec<T> {
        self.goals.iter().map(|goal| self.value(*goal)).collect()
    }

    /// The values of the goals if one instruction is wrong; `None` where that divides by zero. Only
    /// what changes is computed anew.
    pub fn mutant(&self, node: NodeId, mutation: Mutation) -> Option<Vec<T>> {
        let mut changed: HashMap<NodeId, T> = HashMap::new();
        let mut waiting = BTreeSet::from([node]);
        while let Some(next) = waiting.pop_first() {
            let instruction = self.program.instruction(next);
            let of = |n: NodeId| changed.get(&n).cloned().unwrap_or_else(|| self.value(n));
            let value = if next == node {
                instruction.mutate(mutation, self.unknowns, of)?
            } else {
                instruction.evaluate(self.unknowns, of)?
            };
            if value != self.value(next) {
                waiting.extend(&self.users[next.index()]);
                changed.insert(next, value);
            }
        }
        let goal = |goal: &NodeId| changed.get(goal).cloned().unwrap_or_else(|| self.value(*goal));
        Some(self.goals.iter().map(goal).collect())
    }
}
