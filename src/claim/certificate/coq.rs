//! Scripts as Coq files, one for each claim.

use std::fmt::Write as _;

use super::super::{Claim, Grade};
use super::{Script, Step};
use crate::scalar::{Instruction, NodeId};

/// The scripts of a claim, as a file for Coq.
#[derive(Clone, Debug)]
pub struct Certificate {
    /// The claim.
    pub claim: &'static Claim,
    /// Its parts, in the order of the evidence.
    pub parts: Vec<Part>,
}

/// One piece of evidence at one size.
#[derive(Clone, Debug)]
pub struct Part {
    /// The number of the evidence.
    pub evidence: usize,
    /// The size.
    pub size: usize,
    /// The script, or why there is none.
    pub script: Result<Script, String>,
}

/// The certificate of a claim; `None` where nothing of it is decided.
pub fn certificate(claim: &'static Claim) -> Option<Certificate> {
    if claim.said < Grade::Decided {
        return None;
    }
    let mut parts = Vec::new();
    for (evidence, part) in claim.evidence.iter().enumerate() {
        for &size in part.decided {
            let script = Script::of(part, size).map_err(|why| why.to_string());
            parts.push(Part { evidence, size, script });
        }
    }
    parts.iter().any(|part| part.script.is_ok()).then_some(Certificate { claim, parts })
}

impl Part {
    /// Its name in the file.
    pub fn name(&self) -> String {
        format!("part_{}_size_{}", self.evidence + 1, self.size)
    }
}

/// Text that may stand in a comment: Coq reads the strings and comments in it.
fn comment(text: &str) -> String {
    text.replace("*)", "* )").replace("(*", "( *").replace('"', "'")
}

impl Certificate {
    /// The name of its file, as in `eq_17_18.v`.
    pub fn file_name(&self) -> String {
        format!("{}.v", self.claim.id.replace('-', "_"))
    }

    /// The file.
    pub fn coq(&self) -> String {
        let claim = self.claim;
        let mut text = format!("(** {} ({})\n\n", claim.id, comment(&claim.source.to_string()));
        text.push_str(&wrapped(&comment(claim.statement), "    "));
        for line in claim.formula.lines() {
            let _ = writeln!(text, "\n        {}", comment(line));
        }
        text.push_str(HEAD);
        for part in &self.parts {
            let shows = comment(claim.evidence[part.evidence].shows);
            let _ = writeln!(text, "\n(** {shows}; size {}.", part.size);
            match &part.script {
                Ok(script) => {
                    text.push_str(&wrapped(&format!("Code: {}", script.files.join(", ")), "    "));
                    text.truncate(text.trim_end().len());
                    let name = part.name();
                    let _ = writeln!(text, " *)\nDefinition {name} : list step := [");
                    steps(&mut text, script);
                    let _ = writeln!(text, "].\n\nTheorem {name}_valid : valid {name}.");
                    text.push_str("Proof. apply accepted. vm_cast_no_check (eq_refl true). Qed.\n");
                }
                Err(why) => {
                    let _ = writeln!(text, "    Left out: {}. *)", comment(why));
                }
            }
        }
        text
    }

    /// Whether it has a script for this piece of evidence at this size.
    pub fn covers(&self, evidence: usize, size: usize) -> bool {
        let same = |part: &&Part| part.evidence == evidence && part.size == size;
        self.parts.iter().find(same).is_some_and(|part| part.script.is_ok())
    }

    /// Its scripts.
    pub fn scripts(&self) -> impl Iterator<Item = &Script> {
        self.parts.iter().filter_map(|part| part.script.as_ref().ok())
    }
}

const HEAD: &str = "
    Recorded from the library by `isogeo claims certify`, not written by hand. What the theorems
    say is defined in [program/Script.v]. *)

Require Import ZArith List.
Require Import Isogeo.program.Script Isogeo.program.Checker.
Import ListNotations.
";

/// Words in lines of a width.
fn wrapped(text: &str, indent: &str) -> String {
    let mut lines = String::new();
    let mut line = String::from(indent);
    for word in text.split_whitespace() {
        if line.chars().count() + word.chars().count() >= 100 && line != indent {
            let _ = writeln!(lines, "{}", line.trim_end());
            line = indent.into();
        }
        line.push_str(word);
        line.push(' ');
    }
    let _ = writeln!(lines, "{}", line.trim_end());
    lines
}

/// The steps, computations in full lines, hypotheses and goals in lines of their own.
fn steps(text: &mut String, script: &Script) {
    let mut line = String::new();
    let mut nodes = 0;
    let last = script.steps.len().saturating_sub(1);
    for (n, step) in script.steps.iter().enumerate() {
        let back = |node: &NodeId| nodes - 1 - node.index();
        let end = if n == last { "" } else { ";" };
        let (name, node, says) = match step {
            Step::Compute(instruction) => {
                let item = format!("{}{end}", computation(*instruction, nodes));
                nodes += 1;
                if line.len() + item.len() > 96 {
                    let _ = writeln!(text, "  {}", line.trim_end());
                    line.clear();
                }
                line.push_str(&item);
                line.push(' ');
                continue;
            }
            Step::Nonzero(node, says) => ("Nonzero", node, says),
            Step::Zero(node, says) => ("Zero", node, says),
            Step::ShowNonzero(node, says) => ("ShowNonzero", node, says),
            Step::ShowZero(node, says) => ("ShowZero", node, says),
        };
        if !line.is_empty() {
            let _ = writeln!(text, "  {}", line.trim_end());
            line.clear();
        }
        let _ = writeln!(text, "  {name} {}{end} (* {} *)", back(node), comment(says));
    }
    if !line.is_empty() {
        let _ = writeln!(text, "  {}", line.trim_end());
    }
}

fn computation(instruction: Instruction, nodes: usize) -> String {
    use Instruction::*;
    let back = |node: NodeId| nodes - 1 - node.index();
    match instruction {
        Unknown(n) => format!("Unknown {n}"),
        Constant(n) if n < 0 => format!("Constant ({n})"),
        Constant(n) => format!("Constant {n}"),
        Add(a, b) => format!("Add {} {}", back(a), back(b)),
        Sub(a, b) => format!("Sub {} {}", back(a), back(b)),
        Mul(a, b) => format!("Mul {} {}", back(a), back(b)),
        Div(a, b) => format!("Div {} {}", back(a), back(b)),
        Neg(a) => format!("Neg {}", back(a)),
    }
}
