//! The ledger as a page.

use std::collections::BTreeSet;
use std::fmt::Write;

use super::Grade;
use super::certificate::{Certificate, Script};
use super::verify::Report;

/// The page of all reports, in Markdown: what is said, under which hypotheses, by what evidence.
/// It has no times and no counts of random instances, so that it is the same for every run.
pub fn ledger(reports: &[Report]) -> String {
    let mut page = String::from(HEAD);
    let decided = reports.iter().filter(|r| r.shown() >= Grade::Decided).count();
    let certified = reports.iter().filter(|r| r.shown() == Grade::Certified).count();
    let _ = writeln!(
        page,
        "{} claims, {decided} of them decided for all inputs, {certified} of those certified.\n",
        reports.len()
    );
    page.push_str("| claim | source | shown | verdict |\n| --- | --- | --- | --- |\n");
    for report in reports {
        let claim = report.claim;
        let (id, source) = (claim.id, claim.source);
        let (shown, verdict) = (report.shown().name(), report.verdict().name());
        let _ = writeln!(page, "| [`{id}`](#{id}) | {source} | {shown} | {verdict} |");
    }
    for report in reports {
        entry(&mut page, report);
    }
    page
}

const HEAD: &str = "# The ledger

What the paper claims, said exactly, and what is shown for it. This page is made by
`isogeo claims verify --ledger proofs/README.md` and compared by the tests.

*Instances*: exact, on random rational data. *Decided*: for all inputs; the functions that users call
were run on unknowns, and the result is zero as a rational function. Each division and each test on
the way follows from a hypothesis that is named with it. *Certified*: decided, and Coq has checked the
program that was recorded: [coq/recorded](coq/recorded) has it with its hypotheses and goals,
[coq/program](coq/program) the checker and its proof over every field, `checked.txt` the hashes of the
files that Coq accepted. Each hypothesis has a counterexample to the
claim without it. Hypotheses in *italics* are unsaid in the paper.

";

fn entry(page: &mut String, report: &Report) {
    let claim = report.claim;
    let _ = writeln!(page, "\n## {}\n\n{}", claim.id, claim.statement);
    if !claim.formula.is_empty() {
        let _ = writeln!(page, "\n    {}", claim.formula.replace('\n', "\n    "));
    }
    let _ = writeln!(page);
    for hypothesis in claim.hypotheses {
        let mark = if hypothesis.silent { "*" } else { "" };
        let _ = writeln!(page, "- If {mark}{}{mark}.", hypothesis.says);
        let controls = claim.controls.iter().zip(&report.controls);
        for (control, outcome) in controls.filter(|(c, _)| c.without == hypothesis.says) {
            let fails = outcome.as_deref().unwrap_or("nothing breaks");
            let _ = writeln!(page, "  Without it: {} ({fails}).", control.shows);
        }
    }
    for part in &report.parts {
        let sizes: Vec<String> =
            part.decisions.iter().flatten().map(|d| d.size.to_string()).collect();
        let grade = match sizes.as_slice() {
            [] => "instances".to_string(),
            [one] if one == "1" => "decided".into(),
            sizes => format!("decided for size {}", sizes.join(", ")),
        };
        let _ = write!(page, "- Shown: {} ({grade}).", part.shows);
        let mut conditions: Vec<&str> = part
            .decisions
            .iter()
            .flatten()
            .flat_map(|d| &d.conditions)
            .map(|c| c.hypothesis)
            .collect();
        conditions.sort_unstable();
        conditions.dedup();
        if !conditions.is_empty() {
            let _ = write!(page, " It divides where {}.", conditions.join("; "));
        }
        let _ = writeln!(page);
    }
    if let Some(certificate) = &report.certificate {
        certified(page, certificate);
    }
    if !claim.argument.is_empty() {
        let _ = writeln!(page, "\n{}", claim.argument);
    }
}

/// Over which fields, and under which conditions, Coq has checked it.
fn certified(page: &mut String, certificate: &Certificate) {
    let file = certificate.file_name();
    let _ = write!(page, "- Certified: [{file}](coq/recorded/{file}), over every field");
    let integers: BTreeSet<i64> = certificate.scripts().flat_map(|s| s.integers.clone()).collect();
    if !integers.is_empty() {
        let unequal: Vec<String> = integers.iter().map(|n| format!("{n} != 0")).collect();
        let _ = write!(page, " with {}", unequal.join(", "));
    }
    let hypotheses: BTreeSet<&str> = certificate.scripts().flat_map(Script::hypotheses).collect();
    if !hypotheses.is_empty() {
        let hypotheses: Vec<&str> = hypotheses.into_iter().collect();
        let _ = write!(page, ", if {}", hypotheses.join("; "));
    }
    let _ = writeln!(page, ".");
}
