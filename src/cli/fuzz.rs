//! `isogeo fuzz`: campaigns.

use std::env;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use serde_json::json;

use super::arguments::{FuzzOptions, Layout};
use super::failure::Failure;
use super::interruption::interruption;
use super::{Status, output};
use crate::campaign::{
    Campaign, Case, Property, Shard, ShardFile, Tally, UnfitFile, properties, property,
};
use crate::mesh::file::write_whole;

/// So many failing cases of a shard are written.
const WRITTEN: usize = 16;

/// Runs what is left of a shard.
pub fn run(options: &FuzzOptions, layout: Layout) -> Result<Status, Failure> {
    let (Some(id), Some(seed), Some(cases), Some(out)) =
        (&options.property, options.seed, options.cases, &options.out)
    else {
        return list(layout);
    };
    let chosen: Vec<Property> = match id.as_str() {
        "all" => properties().collect(),
        id => vec![property(id).ok_or_else(|| unknown(id))?],
    };
    let shard = options.shard.map_or_else(of_the_array, Ok)?;
    // A panic is a failing case, and is reported as that.
    std::panic::set_hook(Box::new(|_| {}));
    let interrupted = interruption();
    let (mut text, mut rows, mut status) = (String::new(), Vec::new(), Status::Proved);
    for property in chosen {
        let campaign = Campaign { property, seed, cases };
        let mut file = ShardFile::open(out, &campaign, shard)?;
        let start = Instant::now();
        let finished = work(&campaign, &mut file, out, &interrupted)?;
        let (done, seconds) = (file.done(), start.elapsed().as_secs_f64());
        push_row(&mut text, property, done);
        rows.push(json!({
            "property": property.id(),
            "cases": done.cases(),
            "holds": done.holds,
            "excluded": done.excluded,
            "failed": done.failures.len(),
            "failures": done.failures.iter().map(|(index, what)| json!({ "index": index, "what": what })).collect::<Vec<_>>(),
            "digest": done.digest.to_string(),
            "seconds": seconds,
        }));
        if !done.failures.is_empty() {
            status = Status::Refuted;
        }
        if !finished {
            status = Status::Interrupted;
            break;
        }
    }
    if layout.is_json() {
        output::print_json(&json!({
            "schema": "isogeo.fuzz/1",
            "seed": seed.to_string(),
            "shard": shard.to_string(),
            "properties": rows,
        }))?;
    } else {
        output::print(&text)?;
    }
    Ok(status)
}

impl From<UnfitFile> for Failure {
    fn from(error: UnfitFile) -> Failure {
        match error {
            UnfitFile::Io(..) => Failure::io(error.to_string()),
            _ => Failure::with_help(error.to_string(), "take another folder for another campaign"),
        }
    }
}

/// Runs block after block, each about as long as a file may lag behind.
fn work(
    campaign: &Campaign,
    file: &mut ShardFile,
    out: &Path,
    interrupted: &AtomicBool,
) -> Result<bool, Failure> {
    const LAG: Duration = Duration::from_secs(1);
    let bar = output::slow_steps(file.left().count(), campaign.property.id());
    let mut size = 64;
    while !file.left().is_empty() {
        let left = file.left();
        let block = left.start..left.end.min(left.start + size);
        let start = Instant::now();
        let stop = || interrupted.load(Ordering::Relaxed);
        let Some(tally) = campaign.tally(block.clone(), &stop) else {
            bar.finish_and_clear();
            return Ok(false);
        };
        write_failures(campaign, file.done().failures.len(), &tally, out)?;
        file.append(tally)?;
        bar.inc(block.end - block.start);
        size = if start.elapsed() < LAG { size * 2 } else { (size / 2).max(16) };
    }
    bar.finish_and_clear();
    Ok(true)
}

/// The first failing cases become files of their own.
fn write_failures(
    campaign: &Campaign,
    known: usize,
    tally: &Tally,
    out: &Path,
) -> Result<(), Failure> {
    for (index, _) in tally.failures.iter().take(WRITTEN.saturating_sub(known)) {
        let case = Case { property: campaign.property, seed: campaign.seed, index: *index };
        let Some(failure) = case.failure(false) else { continue };
        let folder = out.join("failures");
        fs::create_dir_all(&folder)
            .map_err(|e| Failure::io(format!("{}: {e}", folder.display())))?;
        let path = folder.join(format!("{}-{index}.json", campaign.property.id()));
        write_whole(&path, format!("{:#}\n", failure.to_json()).as_bytes())?;
    }
    Ok(())
}

/// The shard that a job array of Slurm asks for; everything elsewhere.
fn of_the_array() -> Result<Shard, Failure> {
    let variable = |name: &str| env::var(format!("SLURM_ARRAY_TASK_{name}")).ok();
    let Some(id) = variable("ID") else { return Ok(Shard::WHOLE) };
    // Arrays may start anywhere: the first task is part 1.
    let number = |text: &str| text.parse::<u64>().ok();
    let first = variable("MIN").map_or(Some(1), |text| number(&text));
    let count = variable("COUNT").and_then(|text| number(&text));
    let shard = number(&id)
        .zip(first)
        .zip(count)
        .and_then(|((id, first), count)| Shard::new(id.checked_sub(first)?.checked_add(1)?, count));
    shard.ok_or_else(|| {
        Failure::with_help(
            "SLURM_ARRAY_TASK_ID, _MIN and _COUNT name no shard",
            "number the tasks of the array one by one, or say --shard i/n",
        )
    })
}

fn unknown(id: &str) -> Failure {
    let near =
        properties().map(Property::id).filter(|known| known.contains(id) || id.contains(known));
    let near: Vec<&str> = near.take(4).collect();
    let help = if near.is_empty() {
        "isogeo fuzz --list lists the properties".into()
    } else {
        format!("there is {}", near.join(", "))
    };
    Failure::with_help(format!("there is no property '{id}'"), help)
}

fn list(layout: Layout) -> Result<Status, Failure> {
    let kind = |property| match property {
        Property::Claim(_) => "claim",
        Property::Law(_) => "law",
    };
    if layout.is_json() {
        let row = |p: Property| json!({ "id": p.id(), "kind": kind(p), "says": p.says() });
        output::print_json(&json!({
            "schema": "isogeo.properties/1",
            "properties": properties().map(row).collect::<Vec<_>>(),
        }))?;
        return Ok(Status::Proved);
    }
    let mut text = String::new();
    for p in properties() {
        let says: String = p.says().chars().take(96).collect();
        let more = if says.len() < p.says().len() { "..." } else { "" };
        // Writing to a string does not fail.
        let _ = writeln!(text, "{:<22} {:<5} {says}{more}", p.id(), kind(p));
    }
    output::print(&text)?;
    Ok(Status::Proved)
}

fn push_row(text: &mut String, property: Property, tally: &Tally) {
    let Tally { holds, excluded, failures, digest } = tally;
    let _ = writeln!(
        text,
        "{:<22} {} cases: {holds} hold, {excluded} excluded, {} fail; digest {digest}",
        property.id(),
        tally.cases(),
        failures.len()
    );
    for (index, what) in failures.iter().take(WRITTEN) {
        let _ = writeln!(text, "  case {index}: {what}");
    }
}
