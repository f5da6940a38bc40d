//! `fuzz`, `merge`, `replay`: what they print, and that nothing is lost when they are killed.

use std::fs;
use std::process::Stdio;
use std::time::Duration;

use insta::assert_snapshot;

use super::shell::Shell;

#[test]
fn help_and_usage() {
    let shell = Shell::new();
    assert_snapshot!(shell.session(&[
        "fuzz --help",
        "merge --help",
        "replay --help",
        "fuzz boxes",
        "fuzz box --seed 1 --cases 10 --out none",
        "fuzz nothing --seed 1 --cases 10 --out none --format json",
        "fuzz boxes --seed 1 --cases 10 --shard 3/2 --out none",
        "merge none",
        "merge .",
        "replay boxes",
        "replay nothing:1:2",
        "replay kite.obj",
    ]));
    assert!(!shell.path("none").exists());
}

#[test]
fn properties_are_listed() {
    let shell = Shell::new();
    let list = shell.line("fuzz --list").out;
    let laws: Vec<&str> = list.lines().filter(|line| line[23..].starts_with("law ")).collect();
    assert_snapshot!(laws.join("\n"));
    assert!(list.lines().any(|line| line.starts_with("eq-17-18 ") && line.contains(" claim ")));
    assert!(!list.contains("control"), "controls are false");
    let json = shell.line("fuzz --list --format json").json();
    assert_eq!(json["properties"].as_array().map(Vec::len), Some(list.lines().count()));
}

#[test]
fn a_campaign_from_shards_to_its_digest() {
    let shell = Shell::new();
    assert_snapshot!(shell.session(&[
        "fuzz broken-faces --seed 1 --cases 100 --shard 1/2 --out campaign",
        "merge campaign",
        "fuzz broken-faces --seed 1 --cases 100 --shard 2/2 --out campaign",
        "fuzz eq-17-18 --seed 1 --cases 40 --out campaign",
        "merge campaign",
        "merge campaign --format json",
        "fuzz broken-faces --seed 2 --cases 100 --shard 2/2 --out campaign",
    ]));
}

#[test]
fn a_counterexample_from_fuzz_to_a_test() {
    let shell = Shell::new();
    let id = "control-meshes-are-planar";
    assert_snapshot!(shell.session(&[
        &format!("fuzz {id} --seed 2 --cases 6 --out found"),
        "merge found",
        &format!("replay found/failures/{id}-0.json"),
        &format!("replay {id}:2:0 --shrink"),
        &format!("check {id}-0.iso.json --is planar"),
        &format!("replay found/failures/{id}-0.json --shrink -o small.iso.json --format json"),
        "replay control-thm-1-v:1:7 --shrink -o kite.iso.json",
        "replay double-dual:1:3",
        "replay eq-17-18:1:0 --format json",
    ]));
}

/// The digest that `merge` finds, with its exit code.
fn digest(shell: &Shell, folder: &str) -> (i32, String) {
    let run = shell.line(&format!("merge {folder} --format json"));
    (run.code, run.json()["digest"].to_string())
}

const CASES: &str = "--seed 5 --cases 12000";

#[test]
fn a_killed_shard_goes_on() {
    let shell = Shell::new();
    for shard in 1..=8 {
        let line = format!("fuzz broken-faces {CASES} --shard {shard}/8 --out eight");
        assert_eq!(shell.line(&line).code, 0);
    }
    let line = format!("fuzz broken-faces {CASES} --out killed");
    let path = shell.path("killed/broken-faces.1-of-1.jsonl");
    let lines = || fs::read_to_string(&path).map_or(0, |text| text.lines().count());
    let mut child =
        shell.command(line.split_whitespace()).stdout(Stdio::null()).spawn().expect("it starts");
    while lines() < 3 && child.try_wait().expect("a child").is_none() {
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().expect("a signal");
    child.wait().expect("it ends");
    let (code, torn) = digest(&shell, "killed");
    // Torn by a crash of the machine, too.
    let text = fs::read(&path).expect("a file");
    fs::write(&path, &text[..text.len() - 9]).expect("a file");
    assert_eq!(shell.line(&line).code, 0);
    assert_eq!(digest(&shell, "killed"), digest(&shell, "eight"));
    assert_eq!(digest(&shell, "killed").0, 0);
    assert!(
        code == 3 && torn != digest(&shell, "eight").1,
        "the child was not killed in the middle"
    );
}

#[cfg(unix)]
#[test]
fn ctrl_c_leaves_what_is_done() {
    let shell = Shell::new();
    let line = "fuzz broken-faces --seed 5 --cases 1000000000 --out stopped";
    let path = shell.path("stopped/broken-faces.1-of-1.jsonl");
    let mut child =
        shell.command(line.split_whitespace()).stdout(Stdio::null()).spawn().expect("it starts");
    while fs::read_to_string(&path).map_or(0, |text| text.lines().count()) < 2 {
        std::thread::sleep(Duration::from_millis(1));
    }
    let signal =
        std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(signal.expect("kill").success());
    assert_eq!(child.wait().expect("it ends").code(), Some(130));
    assert_eq!(digest(&shell, "stopped").0, 3);
}

#[test]
fn the_shard_is_that_of_the_array() {
    let shell = Shell::new();
    let run = |variables: &[(&str, &str)]| {
        let line = "fuzz broken-faces --seed 1 --cases 80 --out array --format json";
        let mut command = shell.command(line.split_whitespace());
        for (name, value) in variables {
            command.env(format!("SLURM_ARRAY_TASK_{name}"), value);
        }
        let output = command.output().expect("it runs");
        let json: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
        (output.status.code(), json["shard"].as_str().map(str::to_owned))
    };
    assert_eq!(run(&[("ID", "3"), ("COUNT", "8")]), (Some(0), Some("3/8".into())));
    assert_eq!(run(&[("ID", "0"), ("MIN", "0"), ("COUNT", "8")]), (Some(0), Some("1/8".into())));
    assert_eq!(run(&[("ID", "9"), ("COUNT", "8")]), (Some(2), None));
    assert_eq!(run(&[]), (Some(0), Some("1/1".into())));
}
