//! Mutants: every instruction of a recorded run made wrong, one at a time; the claims must fall.

use std::collections::BTreeMap;

use super::decide::{Record, is_library};
use super::{Claim, Evidence};
use crate::scalar::{Evaluation, Instruction, Mutation, NodeId, Prime61, Rational};

/// What became of the mutants of one line of the source.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct MutantTally {
    /// Wrong instructions that made a goal fail, or a division by zero.
    pub killed: usize,
    /// Wrong instructions that no goal noticed.
    pub survived: usize,
    /// The claims that noticed one.
    pub claims: Vec<&'static str>,
}

const MUTATIONS: [Mutation; 3] = [Mutation::Sign, Mutation::Index, Mutation::Factor];

/// All mutants of all instructions that the goals of the claims need, by file and line of the
/// source that asked for the instruction.
///
/// A mutant is evaluated at one point modulo 2^61 − 1. It is wrong everywhere or nearly nowhere,
/// but for the instructions that make the instance: there another instance comes out, and the
/// claim holds for it, too.
pub fn mutants(
    claims: impl IntoIterator<Item = &'static Claim>,
) -> BTreeMap<(String, u32), MutantTally> {
    let mut tallies = BTreeMap::new();
    for claim in claims {
        for evidence in claim.evidence {
            for &size in evidence.decided {
                tally(claim, evidence, size, &mut tallies);
            }
        }
    }
    tallies
}

fn tally(
    claim: &'static Claim,
    evidence: &Evidence,
    size: usize,
    tallies: &mut BTreeMap<(String, u32), MutantTally>,
) {
    let Ok(record) = Record::of(evidence, size) else { return };
    let program = &record.program;
    let goals: Vec<NodeId> = record.goals.iter().map(|goal| goal.1).collect();
    // On the shadows: there the relations hold.
    let point: Vec<Prime61> =
        program.unknown_shadows().filter_map(Prime61::reduce::<Rational>).collect();
    if point.len() < program.unknowns() {
        return;
    }
    let Some(evaluation) = Evaluation::of(program, &point, &goals) else { return };
    let slice = program.slice(&goals);
    let zero = Instruction::Constant(0);
    let wrongable = |n: &NodeId| slice[n.index()] && program.instruction(*n) != zero;
    for node in program.nodes().filter(wrongable) {
        let place = program.place(node);
        let file = place.file().replace('\\', "/");
        if !is_library(&file) {
            continue;
        }
        let tally: &mut MutantTally = tallies.entry((file, place.line())).or_default();
        for mutation in MUTATIONS {
            let values = evaluation.mutant(node, mutation);
            let noticed = values.is_none_or(|v| v.iter().any(|x| *x != Prime61::from_u64(0)));
            if !noticed {
                tally.survived += 1;
                continue;
            }
            tally.killed += 1;
            if !tally.claims.contains(&claim.id) {
                tally.claims.push(claim.id);
            }
        }
    }
}
