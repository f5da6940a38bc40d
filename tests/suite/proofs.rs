//! What Coq checks is what runs: the recorded programs, and the checker once more.

use std::collections::BTreeSet;
use std::fs;

use isogeo::claim::{Certificate, Script, Step, certificate, claim, claims};
use isogeo::scalar::Instruction;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

const FOLDER: &str = "proofs/coq/recorded";

fn all() -> Vec<Certificate> {
    claims().collect::<Vec<_>>().into_par_iter().filter_map(certificate).collect()
}

#[test]
fn the_recorded_programs_are_those_that_coq_has_checked() {
    let certificates = all();
    let mut names = BTreeSet::new();
    for certificate in &certificates {
        let name = certificate.file_name();
        let file = fs::read_to_string(format!("{FOLDER}/{name}")).unwrap_or_default();
        assert!(
            file == certificate.coq(),
            "{name} is old: isogeo claims certify --out {FOLDER}, then proofs/check"
        );
        assert!(certificate.is_checked(), "Coq has not checked {name}: proofs/check");
        assert!(certificate.parts.iter().all(|part| part.script.is_ok()), "{name} is not whole");
        names.insert(name);
    }
    let files = fs::read_dir(FOLDER).expect("the folder").flatten();
    let files: BTreeSet<String> = files
        .filter_map(|f| f.file_name().into_string().ok())
        .filter(|f| f.ends_with(".v"))
        .collect();
    assert_eq!(files, names);
    // Nothing is certified by a manifest in which one digit differs.
    let manifest = fs::read_to_string("proofs/checked.txt").expect("the manifest");
    let certificate = &certificates[0];
    let hash = certificate.hash();
    assert!(certificate.is_checked_by(&manifest));
    assert!(!certificate.is_checked_by(&manifest.replace(&hash, &hash.replace('7', "8"))));
    assert!(!certificate.is_checked_by(&manifest.replace("Checker.v", "Checked.v")));
}

/// The script with `+` for `−`, or `−` for `+`, in one instruction.
fn flipped(script: &Script, at: usize) -> Option<Script> {
    let mut wrong = script.clone();
    let step = wrong.steps.get_mut(at)?;
    *step = Step::Compute(match step {
        Step::Compute(Instruction::Add(a, b)) => Instruction::Sub(*a, *b),
        Step::Compute(Instruction::Sub(a, b)) => Instruction::Add(*a, *b),
        _ => return None,
    });
    Some(wrong)
}

/// In these every sum belongs to a formula, none to the choice of the instance.
const FORMULAS: [&str; 7] = [
    "duality-incidence",
    "eq-10-dual-surface",
    "eq-12-spheres",
    "eq-17-18",
    "eq-20-one-diagonal",
    "cmc-offset",
    "cgc-offset",
];

#[test]
fn a_flipped_instruction_is_refused() {
    for id in FORMULAS {
        let certificate = certificate(claim(id).expect("a claim")).expect("a certificate");
        let script = certificate.scripts().next().expect("a script");
        assert!(script.is_accepted(), "{id}");
        let wrong: Vec<Script> =
            (0..script.steps.len()).filter_map(|at| flipped(script, at)).collect();
        assert!(wrong.len() > 3, "{id}");
        assert!(wrong.iter().all(|script| !script.is_accepted()), "{id}");
    }
}
