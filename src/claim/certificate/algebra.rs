//! Certificates for systems of algebra: Singular, Lean.
//!
//! What vanishes by itself is written as it was computed; what vanishes by a relation as
//! `numerator = cofactor · relation`.

use std::fmt::Write as _;

use super::{Certificate, Combination, Part, Script, Step};
use crate::scalar::{Instruction, NodeId, Polynomial};

/// Longer terms are left out: they are for people and small systems.
const LONGEST: usize = 20_000;

/// The polynomial with `*` between factors, as both systems want it.
fn term(polynomial: &Polynomial) -> String {
    let text = polynomial.to_string();
    text.replace(" + ", "+").replace(" - ", "-").replace(' ', "*")
}

fn unknowns(script: &Script) -> Vec<String> {
    (0..script.unknowns().max(1)).map(|n| format!("x{n}")).collect()
}

/// What vanishes by itself.
fn identities<'a>(
    script: &'a Script,
    by_relation: &'a [Combination],
) -> impl Iterator<Item = (NodeId, &'a str)> {
    let own = move |says: &str| by_relation.iter().all(|c| c.says != says);
    script.steps.iter().filter_map(move |step| match step {
        Step::ShowZero(node, says) if own(says) => Some((*node, says.as_str())),
        _ => None,
    })
}

impl Certificate {
    /// The file for Singular: every line that it prints has to be 1.
    pub fn singular(&self) -> String {
        let mut text = format!("// {}: each line that is printed has to be 1.\n", self.claim.id);
        for part in &self.parts {
            let Ok(script) = &part.script else { continue };
            let _ = writeln!(text, "\n// {}", self.title(part));
            singular(&mut text, script, &part.name());
        }
        text
    }

    /// The file for Lean 4 with Mathlib.
    pub fn lean(&self) -> String {
        let (id, statement) = (self.claim.id, self.claim.statement);
        let mut text = format!("import Mathlib.Tactic\n\n/-! # {id}\n\n{statement}\n-/\n");
        for part in &self.parts {
            let Ok(script) = &part.script else { continue };
            let _ = writeln!(text, "\n/-! {} -/", self.title(part));
            lean(&mut text, script);
        }
        text
    }

    fn title(&self, part: &Part) -> String {
        format!("{}; size {}", self.claim.evidence[part.evidence].shows, part.size)
    }
}

fn singular(text: &mut String, script: &Script, name: &str) {
    let Ok(findings) = script.check() else { return };
    let unknowns = unknowns(script).join(",");
    // The field of rational functions.
    let _ = writeln!(text, "ring {name} = (0,{unknowns}),t,dp;");
    let mut nodes = 0;
    for step in &script.steps {
        if let Step::Compute(instruction) = step {
            let _ = writeln!(text, "number n{nodes} = {};", operation(*instruction));
            nodes += 1;
        }
    }
    for (node, says) in identities(script, &findings.combinations) {
        let _ = writeln!(text, "n{} == 0; // {says}", node.index());
    }
    if findings.combinations.is_empty() {
        return;
    }
    let _ = writeln!(text, "ring {name}_relations = 0,({unknowns}),dp;");
    for (n, relation) in findings.relations.iter().enumerate() {
        let _ = writeln!(text, "poly r{n} = {};", term(relation));
    }
    for Combination { says, numerator, relation, cofactor } in &findings.combinations {
        let (goal, cofactor) = (term(numerator), term(cofactor));
        if goal.len() + cofactor.len() > LONGEST {
            let _ = writeln!(text, "// left out, {} terms: {says}", numerator.len());
            continue;
        }
        let _ = writeln!(text, "{goal} == ({cofactor})*r{relation}; // {says}");
        let _ = writeln!(text, "reduce({goal}, std(ideal(r{relation}))) == 0;");
    }
}

fn operation(instruction: Instruction) -> String {
    use Instruction::*;
    let n = |node: NodeId| format!("n{}", node.index());
    match instruction {
        Unknown(n) => format!("x{n}"),
        Constant(n) => n.to_string(),
        Add(a, b) => format!("{}+{}", n(a), n(b)),
        Sub(a, b) => format!("{}-{}", n(a), n(b)),
        Mul(a, b) => format!("{}*{}", n(a), n(b)),
        Div(a, b) => format!("{}/{}", n(a), n(b)),
        Neg(a) => format!("-{}", n(a)),
    }
}

fn lean(text: &mut String, script: &Script) {
    let Ok(findings) = script.check() else { return };
    let terms = written_out(script);
    let unknowns = unknowns(script).join(" ");
    let term_of = |node: &NodeId| terms.get(node.index()).cloned().flatten();
    let conditions = script.steps.iter().filter_map(|step| match step {
        Step::Nonzero(node, _) => term_of(node),
        _ => None,
    });
    let conditions: Vec<String> =
        conditions.enumerate().map(|(n, value)| format!(" (h{n} : {value} ≠ 0)")).collect();
    let conditions = conditions.concat();
    for (node, says) in identities(script, &findings.combinations) {
        match term_of(&node) {
            Some(goal) if goal.len() + conditions.len() <= LONGEST => {
                let _ = writeln!(text, "\n-- {says}");
                let _ = writeln!(
                    text,
                    "example {{K : Type*}} [Field K] ({unknowns} : K){conditions} :\n    {goal} = 0 := by\n  field_simp\n  ring"
                );
            }
            _ => {
                let _ = writeln!(text, "\n-- left out, too long: {says}");
            }
        }
    }
    for Combination { says, numerator, relation, cofactor } in &findings.combinations {
        let (goal, cofactor) = (term(numerator), term(cofactor));
        let relation = findings.relations.get(*relation).map(term).unwrap_or_default();
        if goal.len() + cofactor.len() > LONGEST {
            let _ = writeln!(text, "\n-- left out, {} terms: {says}", numerator.len());
            continue;
        }
        let _ = writeln!(text, "\n-- the numerator of: {says}");
        let _ = writeln!(
            text,
            "example {{K : Type*}} [Field K] ({unknowns} : K) (h : {relation} = 0) :\n    {goal} = 0 := by\n  linear_combination ({cofactor}) * h"
        );
    }
}

/// Every node written out in the unknowns; `None` where that is too long.
fn written_out(script: &Script) -> Vec<Option<String>> {
    use Instruction::*;
    let mut terms: Vec<Option<String>> = Vec::new();
    for step in &script.steps {
        let Step::Compute(instruction) = step else { continue };
        let of = |node: NodeId| terms.get(node.index()).cloned().flatten();
        let binary = |a: NodeId, sign: &str, b: NodeId| {
            let text = format!("({} {sign} {})", of(a)?, of(b)?);
            (text.len() <= LONGEST).then_some(text)
        };
        let term = match *instruction {
            Unknown(n) => Some(format!("x{n}")),
            Constant(n) => Some(format!("({n} : K)")),
            Add(a, b) => binary(a, "+", b),
            Sub(a, b) => binary(a, "-", b),
            Mul(a, b) => binary(a, "*", b),
            Div(a, b) => binary(a, "/", b),
            Neg(a) => of(a).map(|a| format!("(-{a})")),
        };
        terms.push(term);
    }
    terms
}
