//! The ledger on the command line.

use insta::assert_snapshot;
use serde_json::Value;

use super::shell::Shell;

#[test]
fn claims_are_listed_and_shown() {
    let shell = Shell::new();
    let run = shell.line("claims show cmc-offset");
    let times = |line: &&str| !line.contains(" ms");
    let text: Vec<&str> = run.out.lines().filter(times).collect();
    assert_snapshot!("claims_show", text.join("\n"));
    let run = shell.line("claims list");
    assert!(
        run.out.lines().any(|line| line.starts_with("eq-17-18 ") && line.contains("certified"))
    );
    let run = shell.line("claims show eq-17");
    assert_eq!(run.code, 2);
    assert!(run.err.contains("eq-17-18"), "{}", run.err);
}

#[test]
fn certificates_are_written_for_three_systems() {
    let shell = Shell::new();
    for (system, file) in
        [("coq", "cmc_offset.v"), ("singular", "cmc_offset.sing"), ("lean", "cmc_offset.lean")]
    {
        let run =
            shell.line(&format!("claims certify cmc-offset --as {system} --out new/{system}"));
        assert_eq!(run.code, 0, "{}", run.err);
        assert!(run.out.ends_with("1 program, 15 operations, checked by Coq\n"), "{}", run.out);
        assert_snapshot!(
            format!("certificate_{system}"),
            shell.cat(&format!("new/{system}/{file}"))
        );
    }
    let run = shell.line("claims certify delaunay-lift cmc-offset --out . --format json");
    let report = run.json();
    assert_eq!(report["schema"], "isogeo.certificates/1");
    assert_eq!(report["certificates"].as_array().map(Vec::len), Some(1));
    assert_eq!(report["certificates"][0]["checked_by_coq"], true);
}

#[test]
fn a_seed_repeats_a_run() {
    let shell = Shell::new();
    let counts = |seed: &str| {
        let line = format!("claims verify cgc-offset minkowski --samples 20 {seed} --format json");
        let run = shell.line(&line);
        assert_eq!(run.code, 0, "{}", run.err);
        let mut report: Value = serde_json::from_str(&run.out).expect("JSON");
        let seed = report["seed"].as_str().expect("a seed").to_string();
        let claims = report["claims"].take();
        let fields = ["id", "said", "shown", "verdict", "instances", "controls"];
        let row = |claim: &Value| fields.map(|field| claim[field].to_string()).join(" ");
        let claims = claims.as_array().expect("claims").iter().map(row).collect::<Vec<_>>();
        (seed, claims)
    };
    let (seed, first) = counts("");
    assert_eq!(seed.len(), 64);
    assert_eq!(counts(&format!("--seed {seed}")).1, first);
    assert_eq!(counts("--seed 5").0, "5");
    assert!(
        first[0].starts_with("\"cgc-offset\" \"certified\" \"certified\" \"holds\""),
        "{first:?}"
    );
    let run = shell.line("claims verify cgc-offset --seed five");
    assert_eq!(run.code, 2);
    assert!(run.err.contains("64 hexadecimal digits"), "{}", run.err);
}
