//! Options of campaigns.

use std::path::PathBuf;

use clap::Args;

use crate::campaign::Shard;
use crate::claim::Seed;

/// Run a property on many random cases, in shards that are resumed
#[derive(Debug, Args)]
#[command(after_help = "\
PROPERTY is a claim of the ledger, a law of the program, or 'all' (so many cases for each); --list
lists them. What a case is follows from the property, the seed and its index alone. DIR holds a file
for each property and shard. After Ctrl-C (exit code 130) or a crash the same command goes on where
the file ends; a torn last line is dropped. Failing cases are written to DIR/failures, the first 16.
Exit code: 0 the property holds on all cases; 1 there is a counterexample.
Examples:
  isogeo fuzz --list
  isogeo fuzz decider-any --seed 1 --cases 100000 --out campaign
  isogeo fuzz eq-17-18 --seed 1 --cases 1000000 --shard 3/8 --out campaign")]
pub struct FuzzOptions {
    /// The property, or all
    #[arg(required_unless_present = "list")]
    pub property: Option<String>,
    /// List the properties
    #[arg(long, conflicts_with_all = ["property", "seed", "cases", "shard", "out"])]
    pub list: bool,
    /// Where all that is random comes from
    #[arg(long, value_name = "S", required_unless_present = "list")]
    pub seed: Option<Seed>,
    /// The number of cases in all shards together
    #[arg(long, value_name = "N", required_unless_present = "list")]
    pub cases: Option<u64>,
    /// The part of them to run [default: from SLURM_ARRAY_TASK_ID and _COUNT, else all]
    #[arg(long, value_name = "I/N")]
    pub shard: Option<Shard>,
    /// The folder for what is found
    #[arg(long, value_name = "DIR", required_unless_present = "list")]
    pub out: Option<PathBuf>,
}

/// Add up the shards of a campaign: gaps, duplicates, failures, a digest
#[derive(Debug, Args)]
#[command(after_help = "\
The digest is the sum of the SHA-256 hashes of all cases with their outcomes, so it does not depend
on how they were cut into shards, nor on their order.
Exit code: 0 every case is there once and the properties hold; 1 there is a counterexample;
           3 there are gaps or duplicates.
Example:
  isogeo merge campaign")]
pub struct MergeOptions {
    /// The folder of the campaign
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
}

/// Run one case of a campaign again, and make it small
#[derive(Debug, Args)]
#[command(after_help = "\
CASE is property:seed:index, as 'merge' prints it, or a file of DIR/failures, which holds its numbers
and meshes. --shrink looks for the smallest case that fails in the same way, writes its mesh, and
prints a test for it.
Exit code: 0 the property holds on it; 1 it fails; 3 the case is outside of the hypotheses.
Examples:
  isogeo replay decider-any:1:4711
  isogeo replay control-meshes-are-planar:2:0 --shrink -o smallest.iso.json")]
pub struct ReplayOptions {
    /// The case: property:seed:index, or a file
    pub case: String,
    /// Make it small, and print a test
    #[arg(long)]
    pub shrink: bool,
    /// Write its mesh [default with --shrink: PROPERTY-INDEX.iso.json]; more go to OUT-2 and so on
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}
