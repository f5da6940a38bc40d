//! A recorded run in the order of a proof: hypotheses first, then what is shown.

use std::collections::{BTreeSet, HashMap, HashSet};

use super::super::Evidence;
use super::super::decide::{Record, Undecided, is_library, place};
use crate::scalar::{Instruction, NodeId, Outcome};

/// One step of a [`Script`]. Nodes are numbered in the order of the computations.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// Computes the next node.
    Compute(Instruction),
    /// A hypothesis: the node is not zero.
    Nonzero(NodeId, String),
    /// A hypothesis: the node is zero.
    Zero(NodeId, String),
    /// What is shown: the node is not zero.
    ShowNonzero(NodeId, String),
    /// What is shown: the node is zero.
    ShowZero(NodeId, String),
}

/// A statement over every field: if the hypotheses hold, then no divisor is zero, and what is shown
/// is so.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Script {
    /// The steps.
    pub steps: Vec<Step>,
    /// The primes that are assumed not to vanish in the field.
    pub integers: BTreeSet<i64>,
    /// The files of the library whose operations were recorded.
    pub files: Vec<String>,
}

/// Puts the nodes of a record in order, equal instructions once.
struct Writer<'a> {
    record: &'a Record,
    steps: Vec<Step>,
    nodes: usize,
    unknowns: u32,
    places: HashMap<NodeId, NodeId>,
    known: HashMap<Instruction, NodeId>,
}

impl Writer<'_> {
    fn push(&mut self, instruction: Instruction) -> NodeId {
        if let Some(node) = self.known.get(&instruction) {
            return *node;
        }
        let node = NodeId::at(self.nodes);
        self.nodes += 1;
        self.known.insert(instruction, node);
        self.steps.push(Step::Compute(instruction));
        node
    }

    /// Writes what a node needs; gives its new number.
    fn node(&mut self, node: NodeId) -> NodeId {
        if let Some(written) = self.places.get(&node) {
            return *written;
        }
        let program = &self.record.program;
        let slice = program.slice(&[node]);
        for n in program.nodes().take_while(|n| *n <= node).filter(|n| slice[n.index()]) {
            if self.places.contains_key(&n) {
                continue;
            }
            let instruction = match program.instruction(n) {
                Instruction::Unknown(_) => {
                    self.unknowns += 1;
                    Instruction::Unknown(self.unknowns - 1)
                }
                // Operands stand before it, and are written.
                other => other.renamed(|m| self.places.get(&m).copied().unwrap_or(m)),
            };
            let written = self.push(instruction);
            self.places.insert(n, written);
        }
        self.places.get(&node).copied().unwrap_or(node)
    }
}

/// What a test says of itself: lines of the source move, its files hardly do.
fn asked_by(file: &str) -> String {
    let file = file.replace('\\', "/");
    if is_library(&file) { format!("as {file} finds") } else { "as a test finds".into() }
}

impl Script {
    /// The script of a piece of evidence at one size, with the hypotheses that are needed.
    ///
    /// # Errors
    /// See [`Undecided`].
    pub fn of(evidence: &Evidence, size: usize) -> Result<Self, Undecided> {
        let record = Record::of(evidence, size)?;
        let all: BTreeSet<usize> = (0..record.conditions.len()).collect();
        let script = Script::write(&record, &BTreeSet::new(), &all)?;
        let findings = script.check()?;
        Script::write(&record, &findings.integers, &findings.used)
    }

    fn write(
        record: &Record,
        integers: &BTreeSet<i64>,
        used: &BTreeSet<usize>,
    ) -> Result<Self, Undecided> {
        let mut writer = Writer {
            record,
            steps: Vec::new(),
            nodes: 0,
            unknowns: 0,
            places: HashMap::new(),
            known: HashMap::new(),
        };
        for &n in integers {
            let node = writer.push(Instruction::Constant(n));
            writer.steps.push(Step::Nonzero(node, format!("{n} != 0 in the field")));
        }
        for (n, condition) in record.conditions.iter().enumerate() {
            if used.contains(&n) {
                let node = writer.node(condition.value);
                writer.steps.push(Step::Nonzero(node, condition.says.into()));
            }
        }
        for (says, relation) in &record.relations {
            let node = writer.node(*relation);
            writer.steps.push(Step::Zero(node, (*says).into()));
        }
        // The tests of the hypotheses themselves are no part of the claim.
        let hypotheses = record.conditions.iter().map(|c| c.value);
        let mut shown: BTreeSet<NodeId> =
            hypotheses.chain(record.relations.iter().map(|r| r.1)).collect();
        let mut obligations = Vec::new();
        for branch in record.program.branches() {
            if matches!(branch.outcome, Outcome::Sign(_)) {
                return Err(Undecided::Order(place(branch.place)));
            }
            if shown.insert(branch.node) {
                let zero = branch.outcome == Outcome::Zero;
                obligations.push((branch.node, zero, asked_by(branch.place.file())));
            }
        }
        let goals = record.goals.iter().map(|(name, node)| (*node, true, name.clone()));
        obligations.extend(goals);
        let mut written = HashSet::new();
        for (node, zero, says) in obligations {
            let node = writer.node(node);
            if written.insert((node, zero, says.clone())) {
                let step = if zero { Step::ShowZero } else { Step::ShowNonzero };
                writer.steps.push(step(node, says));
            }
        }
        let nodes: Vec<NodeId> = writer.places.keys().copied().collect();
        let files = record.files(&nodes);
        Ok(Script { steps: writer.steps, integers: integers.clone(), files })
    }

    /// Its hypotheses in words, those on integers aside.
    pub fn hypotheses(&self) -> impl Iterator<Item = &str> {
        let assumed = self.steps.iter().filter_map(|step| match step {
            Step::Nonzero(_, says) | Step::Zero(_, says) => Some(says.as_str()),
            _ => None,
        });
        assumed.skip(self.integers.len())
    }

    /// How many nodes are computed.
    pub fn nodes(&self) -> usize {
        self.steps.iter().filter(|step| matches!(step, Step::Compute(_))).count()
    }

    /// How many unknowns there are.
    pub fn unknowns(&self) -> usize {
        let unknown = |step: &&Step| matches!(step, Step::Compute(Instruction::Unknown(_)));
        self.steps.iter().filter(unknown).count()
    }
}
