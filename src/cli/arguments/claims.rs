//! The command `claims`.

use std::path::PathBuf;

use clap::{Args, Subcommand, ValueEnum};

use crate::claim::Seed;

/// The ledger: what the paper claims, with its evidence
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  isogeo claims list
  isogeo claims show eq-17-18
  isogeo claims verify eq-17-18 thm-1-f --samples 500
  isogeo claims certify --out proofs/coq/recorded")]
pub struct ClaimsOptions {
    #[command(subcommand)]
    pub command: ClaimsCommand,
}

#[derive(Debug, Subcommand)]
pub enum ClaimsCommand {
    /// List the claims: name, source, grade of evidence
    #[command(after_help = "Example:\n  isogeo claims list")]
    List,
    /// Show one claim: formula, hypotheses, an example, the code that it exercises
    #[command(after_help = "Example:\n  isogeo claims show eq-17-18")]
    Show {
        /// The name of the claim
        id: String,
    },
    Verify(VerifyOptions),
    Certify(CertificateOptions),
}

/// Check claims: on random exact instances, for all inputs, and without each hypothesis
#[derive(Debug, Args)]
#[command(after_help = "\
Exit code: 0 every claim holds and shows at least what it says; 1 one does not.
Example:
  isogeo claims verify --samples 1000 --seed 7")]
pub struct VerifyOptions {
    /// The claims by name [default: all]
    pub ids: Vec<String>,
    /// Random instances for each piece of evidence
    #[arg(long, value_name = "N", default_value_t = 60)]
    pub samples: usize,
    /// Where all that is random comes from, as printed by an earlier run [default: a new one]
    #[arg(long, value_name = "S")]
    pub seed: Option<Seed>,
    /// Write the ledger as a page, in Markdown
    #[arg(long, value_name = "FILE")]
    pub ledger: Option<PathBuf>,
}

/// Write what is decided of claims as programs for a checker that is not ours
///
/// For Coq: one file for each claim, with the recorded operations, the hypotheses and the goals, to
/// be checked by `coqc -Q proofs/coq Isogeo FILE`. For Singular: lines that print 1. For Lean 4 with
/// Mathlib: `linear_combination` and `field_simp; ring`; no Lean has checked that syntax. Both leave out
/// what is too long for them.
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  isogeo claims certify --out proofs/coq/recorded
  isogeo claims certify koebe-edge --as singular --out .")]
pub struct CertificateOptions {
    /// The claims by name [default: all that are decided]
    pub ids: Vec<String>,
    /// The system for which the files are
    #[arg(long = "as", value_enum, value_name = "SYSTEM", default_value_t = System::Coq)]
    pub system: System,
    /// The folder for the files
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
}

/// A program that checks algebra.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum System {
    /// Programs with hypotheses and goals for the checker in `proofs/coq/program`
    Coq,
    /// Examples for Lean 4 with Mathlib; syntax not checked by Lean
    Lean,
    /// Input for Singular
    Singular,
}
