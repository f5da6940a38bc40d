//! The proofs in Coq, as far as a text shows them; `proofs/check` has Coq look at them.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

fn proofs() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("proofs")
}

fn read(path: &str) -> String {
    fs::read_to_string(proofs().join(path)).unwrap_or_else(|e| panic!("proofs/{path}: {e}"))
}

/// What stands between backticks.
fn quoted(cell: &str) -> Vec<&str> {
    cell.split('`').skip(1).step_by(2).collect()
}

/// The rows of the table of theorems: a claim, a file, theorems.
fn rows(page: &str) -> Vec<(&str, &str, Vec<&str>)> {
    let cells = |line| -> Vec<&str> { str::split(line, '|').collect() };
    let row = |c: &[&'_ str]| c.len() == 6 && c[1].contains('`');
    let lines = page.lines().filter(|l| l.starts_with("| `")).map(cells).filter(|c| row(c));
    lines.map(|c| (quoted(c[1])[0], quoted(c[3])[0], quoted(c[4]))).collect()
}

fn states(code: &str, theorem: &str) -> bool {
    code.lines().any(|line| {
        let mut words = line.split(|c: char| !c.is_alphanumeric() && c != '_');
        words.next() == Some("Theorem") && words.next() == Some(theorem)
    })
}

#[test]
fn every_theorem_of_the_table_is_stated_in_its_file() {
    let (page, ledger) = (read("coq/README.md"), read("README.md"));
    let table = rows(&page);
    assert!(table.len() > 40, "{} rows", table.len());
    for (claim, file, theorems) in table {
        assert!(ledger.contains(&format!("\n## {claim}\n")), "{claim} is not in the ledger");
        let code = read(&format!("coq/theory/{file}"));
        for theorem in theorems {
            assert!(states(&code, theorem), "{file} has no theorem {theorem}");
        }
    }
}

#[test]
fn every_theorem_is_in_the_table() {
    let page = read("coq/README.md");
    let named: BTreeSet<_> =
        rows(&page).into_iter().flat_map(|(_, _, theorems)| theorems).collect();
    for entry in fs::read_dir(proofs().join("coq/theory")).expect("the theory").flatten() {
        let path = entry.path();
        if path.extension().is_none_or(|e| e != "v") {
            continue;
        }
        let code = fs::read_to_string(&path).expect("a file of proofs");
        for line in code.lines().filter_map(|l| l.strip_prefix("Theorem ")) {
            let name = line.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or("");
            assert!(named.contains(name), "{}: {name} has no row", path.display());
        }
        assert!(!code.contains("Admitted"), "{} is not proved", path.display());
        assert!(code.lines().count() < 300, "{} is long", path.display());
        assert!(code.starts_with("(** * "), "{} has no title", path.display());
    }
}

#[test]
fn the_table_is_read() {
    let page = "| claim | paper |\n| `a-b` | (1) | `A.v` | `a_b`, `a_c` |\n";
    assert_eq!(rows(page), [("a-b", "A.v", vec!["a_b", "a_c"])]);
    assert!(states("Theorem a_b x :", "a_b"));
    assert!(!states("Theorem a_bc x :\n(* Theorem a_b *)", "a_b"));
}
