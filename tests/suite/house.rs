//! The rules of the house: floors, invariants that a text can show, generated files.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Modules from below. Those of one row do not know each other.
const FLOORS: [&[&str]; 11] = [
    &["scalar"],
    &["space"],
    &["mesh"],
    &["check"],
    &["net"],
    &["pair"],
    &["construct"],
    &["optimise", "strategy"],
    &["claim"],
    &["figure", "campaign"],
    &["cli"],
];

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder of the project").flatten() {
        let path = entry.path();
        if path.is_dir() {
            files.extend(sources(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// The source without comments.
fn code(path: &Path) -> String {
    let text = fs::read_to_string(path).expect("a source file");
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or(""));
    lines.collect::<Vec<_>>().join("\n")
}

fn floor(module: &str) -> Option<usize> {
    FLOORS.iter().position(|row| row.contains(&module))
}

/// The modules that a source imports by `crate::`.
fn imports(code: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for (start, _) in code.match_indices("crate::") {
        let rest = &code[start + "crate::".len()..];
        let names = match rest.strip_prefix('{') {
            Some(list) => list.split('}').next().unwrap_or("").split(',').collect(),
            None => vec![rest],
        };
        for name in names {
            let name = name.trim().chars().take_while(|c| c.is_alphanumeric() || *c == '_');
            found.insert(name.collect());
        }
    }
    found
}

/// What a file of `module` may not import.
fn violations(module: &str, code: &str) -> Vec<String> {
    let own = floor(module).expect("a module with a floor");
    let above = |name: &String| name != module && floor(name).is_some_and(|f| f >= own);
    imports(code).into_iter().filter(above).collect()
}

#[test]
fn a_file_imports_only_from_floors_below() {
    let src = root().join("src");
    for path in sources(&src) {
        let inside = path.strip_prefix(&src).expect("inside src");
        let module = inside.iter().next().and_then(|c| c.to_str()).expect("a name");
        let module = module.trim_end_matches(".rs");
        if module == "lib" || module == "main" {
            continue;
        }
        assert!(floor(module).is_some(), "{module} has no floor: see ARCHITECTURE.md");
        assert_eq!(violations(module, &code(&path)), Vec::<String>::new(), "{}", inside.display());
    }
}

#[test]
fn the_rule_of_floors_can_fail() {
    assert_eq!(violations("mesh", "use crate::net::Property;"), ["net"]);
    assert_eq!(violations("mesh", "use crate::{scalar, check::Report};"), ["check"]);
    assert_eq!(violations("mesh", "use crate::scalar::Ring;\nlet x = crate::mesh::f();"), [""; 0]);
}

#[test]
fn topology_sees_no_coordinate() {
    for file in ["topology.rs", "topology_error.rs", "dual.rs"] {
        let code = code(&root().join("src/mesh").join(file));
        for word in ["Point", "scalar", "space", "f64"] {
            assert!(!code.contains(word), "{file} speaks of {word}");
        }
    }
}

#[test]
fn no_epsilon_and_no_unsafe() {
    for path in sources(&root().join("src")) {
        let code: String = code(&path).split('"').step_by(2).collect();
        assert!(!code.contains("unsafe "), "{}", path.display());
        let small = code.match_indices("e-").any(|(i, _)| {
            let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
            digit(code[..i].chars().next_back()) && digit(code[i + 2..].chars().next())
        });
        assert!(!small, "{} has a small constant", path.display());
    }
}

#[test]
fn every_equation_has_its_row() {
    let page = fs::read_to_string(root().join("docs/notation.md")).expect("docs/notation.md");
    for equation in 1..=22 {
        let rows = page.lines().filter(|l| l.starts_with(&format!("| ({equation}) |"))).count();
        assert_eq!(rows, 1, "equation ({equation})");
    }
    let ghost = page.lines().any(|l| l.starts_with("| (23) |"));
    assert!(!ghost, "the paper ends with (22)");
}

#[test]
#[cfg(feature = "cli")]
fn the_readme_shows_what_the_program_prints() {
    let page = fs::read_to_string(root().join("README.md")).expect("README.md");
    let (_, block) = page.split_once("```console\n$ cargo run --release -- ").expect("a session");
    let (command, rest) = block.split_once('\n').expect("a command");
    let shown = rest.split("```").next().expect("the end of the block");
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_isogeo"))
        .args(command.split_whitespace())
        .current_dir(root())
        .output()
        .expect("the program runs");
    assert_eq!(String::from_utf8_lossy(&output.stdout), shown);
    assert_eq!(output.status.code(), Some(1));
}

#[test]
#[cfg(feature = "cli")]
fn the_readme_shows_the_first_claims() {
    let page = fs::read_to_string(root().join("README.md")).expect("README.md");
    let (_, block) = page.split_once("```console\n$ isogeo claims list\n").expect("a session");
    let (shown, _) = block.split_once("...\n```").expect("the end of the block");
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_isogeo"))
        .args(["claims", "list"])
        .output()
        .expect("the program runs");
    assert!(String::from_utf8_lossy(&output.stdout).starts_with(shown), "{shown}");
    assert_eq!(shown.lines().count(), 8);
}

#[test]
fn documents_name_what_is_there() {
    let page = fs::read_to_string(root().join("README.md")).expect("README.md");
    let folders = page.lines().filter_map(|l| l.strip_prefix("| `")?.split('`').next());
    for place in folders.filter(|p| p.contains('/') || ["benches", "meshes"].contains(p)) {
        assert!(root().join(place).exists(), "README.md names {place}");
    }
}
