//! `isogeo merge`: what the shards of a campaign found together.

use std::fmt::Write as _;
use std::ops::Range;

use serde_json::{Value, json};

use super::arguments::{Layout, MergeOptions};
use super::failure::Failure;
use super::{Status, output};
use crate::campaign::{Merged, Merging, merge};

/// Adds up the files of a folder.
pub fn run(options: &MergeOptions, layout: Layout) -> Result<Status, Failure> {
    let merging = merge(&options.folder)?;
    if merging.properties.is_empty() {
        let message = format!("{}: there is no shard of a campaign", options.folder.display());
        return Err(Failure::usage(message));
    }
    if layout.is_json() {
        output::print_json(&json(&merging))?;
    } else {
        output::print(&text(&merging))?;
    }
    let fails = merging.properties.iter().any(|p| !p.tally.failures.is_empty());
    let complete = merging.properties.iter().all(Merged::is_complete);
    Ok(match (fails, complete) {
        (true, _) => Status::Refuted,
        (false, true) => Status::Proved,
        (false, false) => Status::Open,
    })
}

fn text(merging: &Merging) -> String {
    const SHOWN: usize = 16;
    let mut text = String::new();
    for Merged { property, seed, cases, tally, gaps, duplicates } in &merging.properties {
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "{property:<22} {} of {cases} cases: {} hold, {} excluded, {} fail; digest {}",
            tally.cases(),
            tally.holds,
            tally.excluded,
            tally.failures.len(),
            tally.digest
        );
        for (what, ranges) in [("GAP", gaps), ("DUPLICATE", duplicates)] {
            for Range { start, end } in ranges.iter().take(SHOWN) {
                let _ = writeln!(text, "  {what}: cases {start} to {}", end - 1);
            }
        }
        for (index, what) in tally.failures.iter().take(SHOWN) {
            let _ = writeln!(text, "  {property}:{seed}:{index} FAILS: {what}");
        }
    }
    for path in &merging.torn {
        let _ = writeln!(text, "{}: the last line is torn and does not count", path.display());
    }
    let cases: u64 = merging.properties.iter().map(|p| p.tally.cases()).sum();
    let _ = writeln!(text, "{cases} cases; digest {}", merging.digest);
    text
}

fn json(merging: &Merging) -> Value {
    let ranges = |ranges: &[Range<u64>]| {
        ranges.iter().map(|r| json!({ "first": r.start, "last": r.end - 1 })).collect::<Vec<_>>()
    };
    let row = |p: &Merged| {
        let failure = |(index, what): &(u64, String)| json!({ "case": format!("{}:{}:{index}", p.property, p.seed), "what": what });
        json!({
            "property": p.property,
            "seed": p.seed,
            "cases": p.cases,
            "found": p.tally.cases(),
            "holds": p.tally.holds,
            "excluded": p.tally.excluded,
            "failures": p.tally.failures.iter().map(failure).collect::<Vec<_>>(),
            "gaps": ranges(&p.gaps),
            "duplicates": ranges(&p.duplicates),
            "digest": p.tally.digest.to_string(),
        })
    };
    json!({
        "schema": "isogeo.merge/1",
        "properties": merging.properties.iter().map(row).collect::<Vec<_>>(),
        "torn": merging.torn.iter().map(|path| path.display().to_string()).collect::<Vec<_>>(),
        "digest": merging.digest.to_string(),
    })
}
