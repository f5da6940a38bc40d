//! `isogeo claims`: the ledger.

use std::fmt::Write as _;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use serde_json::{Value, json};

use super::arguments::{
    CertificateOptions, ClaimsCommand, ClaimsOptions, Layout, System, VerifyOptions,
};
use super::failure::Failure;
use super::{Status, output, words};
use crate::claim::{
    self, Claim, Options, Report, Script, Seed, Verdict, certificate, example, ledger, verify,
};
use crate::mesh::file::write_whole;

/// Lists, shows or verifies claims.
pub fn run(options: &ClaimsOptions, layout: Layout) -> Result<Status, Failure> {
    match &options.command {
        ClaimsCommand::List => list(layout),
        ClaimsCommand::Show { id } => show(claim(id)?, layout),
        ClaimsCommand::Verify(options) => check(options, layout),
        ClaimsCommand::Certify(options) => certify(options, layout),
    }
}

fn claim(id: &str) -> Result<&'static Claim, Failure> {
    claim::claim(id).ok_or_else(|| {
        let near = |c: &&Claim| c.id.contains(id) || id.contains(c.id);
        let names: Vec<&str> = claim::claims().filter(near).map(|c| c.id).collect();
        let help = if names.is_empty() {
            "`isogeo claims list` names them all".into()
        } else {
            format!("there are {}", names.join(", "))
        };
        Failure::with_help(format!("'{id}' is no claim"), help)
    })
}

/// The claims of these names; all where none is given.
fn claims_of(ids: &[String]) -> Result<Vec<&'static Claim>, Failure> {
    if ids.is_empty() {
        return Ok(claim::claims().collect());
    }
    ids.iter().map(|id| claim(id)).collect()
}

fn list(layout: Layout) -> Result<Status, Failure> {
    if layout.is_json() {
        let claims: Vec<Value> = claim::claims().map(facts).collect();
        output::print_json(&json!({ "schema": "isogeo.claims-list/1", "claims": claims }))?;
        return Ok(Status::Proved);
    }
    let mut text = String::new();
    for claim in claim::claims() {
        // Writing to a string does not fail.
        let _ = writeln!(text, "{:<22} {:<10} {}", claim.id, claim.said, claim.source);
    }
    output::print(&text)?;
    Ok(Status::Proved)
}

/// What is known of a claim without running anything.
fn facts(claim: &Claim) -> Value {
    let hypotheses = claim.hypotheses.iter();
    json!({
        "id": claim.id,
        "statement": claim.statement,
        "formula": claim.formula,
        "source": claim.source.to_string(),
        "hypotheses": hypotheses.map(|h| json!({ "says": h.says, "silent": h.silent }))
            .collect::<Vec<_>>(),
        "said": claim.said.name(),
        "argument": claim.argument,
    })
}

fn show(claim: &'static Claim, layout: Layout) -> Result<Status, Failure> {
    let options = Options { samples: 8, seed: Seed::of(1) };
    let reports = verify(&[claim], &options, &|_| {});
    if layout.is_json() {
        let mut value = facts(claim);
        value["schema"] = "isogeo.claim/1".into();
        value["shown"] = reports.first().map_or(Value::Null, |r| r.shown().name().into());
        output::print_json(&value)?;
        return Ok(Status::Proved);
    }
    let mut text = format!("{} ({})\n\n{}\n", claim.id, claim.source, claim.statement);
    if !claim.formula.is_empty() {
        let _ = writeln!(text, "\n    {}", claim.formula.replace('\n', "\n    "));
    }
    if !claim.hypotheses.is_empty() {
        text.push_str("\nIf\n");
    }
    for hypothesis in claim.hypotheses {
        let silent = if hypothesis.silent { " (unsaid in the paper)" } else { "" };
        let _ = writeln!(text, "  {}{silent}", hypothesis.says);
    }
    for report in &reports {
        push_evidence(&mut text, report);
    }
    for part in claim.evidence {
        let Some(example) = example(part) else { continue };
        if example.values.is_empty() && example.meshes.is_empty() {
            continue;
        }
        let _ = writeln!(text, "\nExample ({})", part.shows);
        for (name, value) in &example.values {
            let _ = writeln!(text, "  {name} = {value}");
        }
        for (name, mesh) in &example.meshes {
            let _ = writeln!(text, "  {name}, faces and vertices:");
            for face in mesh.topology.faces().take(12) {
                let corners = mesh.topology.face(face).iter().map(|v| {
                    let p = &mesh.points[v.index()];
                    format!("({}, {}, {})", p.x, p.y, p.z)
                });
                let _ = writeln!(text, "    {}", corners.collect::<Vec<_>>().join(" "));
            }
        }
    }
    if !claim.argument.is_empty() {
        let _ = writeln!(text, "\n{}", claim.argument);
    }
    output::print(&text)?;
    Ok(Status::Proved)
}

fn push_evidence(text: &mut String, report: &Report) {
    let _ = writeln!(text, "\nShown: {} ({})", report.shown(), report.verdict().name());
    for part in &report.parts {
        let _ = writeln!(text, "  {}", part.shows);
        for decision in part.decisions.iter().flatten() {
            let (size, unknowns) = (decision.size, decision.unknowns);
            let (goals, steps) = (decision.goals, decision.instructions);
            let _ = writeln!(
                text,
                "    size {size}: {goals} functions of {unknowns} unknowns vanish, {steps} operations, {:.1} ms",
                decision.time.as_secs_f64() * 1e3
            );
        }
        if let Some(decision) = part.decisions.iter().flatten().last() {
            for condition in &decision.conditions {
                let _ =
                    writeln!(text, "    for {} ({} times)", condition.hypothesis, condition.uses);
            }
            let _ = writeln!(text, "    code: {}", decision.files.join(", "));
        }
    }
    for (control, outcome) in report.claim.controls.iter().zip(&report.controls) {
        let (Ok(says) | Err(says)) = outcome;
        let _ = writeln!(text, "  without \"{}\": {}: {says}", control.without, control.shows);
    }
    for failure in report.failures() {
        let _ = writeln!(text, "  FAILS {failure}");
    }
}

fn check(options: &VerifyOptions, layout: Layout) -> Result<Status, Failure> {
    let claims = claims_of(&options.ids)?;
    let seed = options.seed.unwrap_or_else(Seed::fresh);
    let bar = output::slow_steps(claims.len(), "claims");
    let finished = AtomicUsize::new(0);
    let done = |_: &Report| bar.set_position(finished.fetch_add(1, Ordering::Relaxed) as u64 + 1);
    let reports = verify(&claims, &Options { samples: options.samples, seed }, &done);
    bar.finish_and_clear();
    if let Some(path) = &options.ledger {
        write_whole(path, ledger(&reports).as_bytes())?;
    }
    if layout.is_json() {
        let claims: Vec<Value> = reports.iter().map(report_json).collect();
        output::print_json(&json!({
            "schema": "isogeo.claims/1",
            "seed": seed.to_string(),
            "claims": claims,
        }))?;
    } else {
        output::print(&table(&reports, seed))?;
    }
    let holds = reports.iter().all(|report| report.verdict() == Verdict::Holds);
    Ok(if holds { Status::Proved } else { Status::Refuted })
}

fn certify(options: &CertificateOptions, layout: Layout) -> Result<Status, Failure> {
    let claims = claims_of(&options.ids)?;
    let certificates: Vec<_> = claims.par_iter().map(|claim| certificate(claim)).collect();
    let folder = &options.out;
    std::fs::create_dir_all(folder)
        .map_err(|e| Failure::io(format!("{}: {e}", folder.display())))?;
    let mut values = Vec::new();
    let mut text = String::new();
    for (claim, certificate) in claims.iter().zip(&certificates) {
        let Some(certificate) = certificate else {
            // Writing to a string does not fail.
            let _ = writeln!(text, "{:<22} left out: it is not decided", claim.id);
            continue;
        };
        let (ending, content) = match options.system {
            System::Coq => ("v", certificate.coq()),
            System::Lean => ("lean", certificate.lean()),
            System::Singular => ("sing", certificate.singular()),
        };
        let path = folder.join(certificate.file_name()).with_extension(ending);
        write_whole(&path, content.as_bytes())?;
        let file = path.display().to_string();
        let programs = certificate.scripts().count();
        let operations: usize = certificate.scripts().map(Script::nodes).sum();
        let checked = certificate.is_checked();
        let not = if checked { "" } else { "not " };
        let _ = writeln!(
            text,
            "{:<22} {file}: {}, {}, {not}checked by Coq",
            claim.id,
            words::count(programs, "program"),
            words::count(operations, "operation"),
        );
        let left_out = certificate.parts.iter().filter_map(|part| part.script.as_ref().err());
        values.push(json!({
            "id": claim.id,
            "file": file,
            "programs": programs,
            "operations": operations,
            "left_out": left_out.collect::<Vec<_>>(),
            "checked_by_coq": checked,
        }));
    }
    if layout.is_json() {
        output::print_json(&json!({ "schema": "isogeo.certificates/1", "certificates": values }))?;
    } else {
        output::print(&text)?;
    }
    Ok(Status::Proved)
}

fn table(reports: &[Report], seed: Seed) -> String {
    let mut text = String::new();
    let _ = writeln!(
        text,
        "{:<22} {:<10} {:<8} {:>9} {:>8} {:>8}",
        "claim", "shown", "verdict", "instances", "controls", "seconds"
    );
    for report in reports {
        let verdict = match report.verdict() {
            Verdict::Holds => "holds",
            Verdict::Fails => "FAILS",
            Verdict::Vacuous => "VACUOUS",
        };
        let _ = writeln!(
            text,
            "{:<22} {:<10} {verdict:<8} {:>9} {:>8} {:>8.2}",
            report.claim.id,
            report.shown(),
            report.instances(),
            report.controls(),
            report.seconds
        );
        for failure in report.failures() {
            let _ = writeln!(text, "  {failure}");
        }
        for part in &report.parts {
            for (name, mesh) in part.sampling.failure.iter().flat_map(|f| &f.meshes) {
                let _ = writeln!(text, "  {name}: {mesh}");
            }
        }
    }
    let count = |verdict| reports.iter().filter(|r| r.verdict() == verdict).count();
    let _ = writeln!(
        text,
        "{} claims: {} hold, {} fail, {} vacuous; seed {seed}",
        reports.len(),
        count(Verdict::Holds),
        count(Verdict::Fails),
        count(Verdict::Vacuous)
    );
    text
}

fn report_json(report: &Report) -> Value {
    let parts: Vec<Value> = report
        .parts
        .iter()
        .map(|part| {
            let sampling = &part.sampling;
            let seconds = sampling.time.as_secs_f64();
            let decisions: Vec<Value> = part
                .decisions
                .iter()
                .map(|decision| match decision {
                    Ok(d) => json!({
                        "size": d.size,
                        "grade": d.grade.name(),
                        "goals": d.goals,
                        "unknowns": d.unknowns,
                        "operations": d.instructions,
                        "error_log2": d.error,
                        "conditions": d.conditions.iter().map(|c| c.hypothesis).collect::<Vec<_>>(),
                        "code": d.files,
                        "seconds": d.time.as_secs_f64(),
                    }),
                    Err(why) => json!({ "undecided": why.to_string() }),
                })
                .collect();
            json!({
                "shows": part.shows,
                "decisions": decisions,
                "instances": sampling.instances,
                "excluded": sampling.excluded,
                "instances_per_second": if seconds > 0.0 { sampling.instances as f64 / seconds } else { 0.0 },
                "failure": sampling.failure.as_ref().map(|f| json!({
                    "size": f.size,
                    "unknowns": f.unknowns,
                    "what": f.what,
                    "meshes": f.meshes.iter().map(|(name, mesh)| json!({ "name": name, "mesh": mesh })).collect::<Vec<_>>(),
                })),
            })
        })
        .collect();
    json!({
        "id": report.claim.id,
        "said": report.claim.said.name(),
        "shown": report.shown().name(),
        "verdict": report.verdict().name(),
        "instances": report.instances(),
        "controls": report.controls(),
        "seconds": report.seconds,
        "failures": report.failures(),
        "evidence": parts,
    })
}
