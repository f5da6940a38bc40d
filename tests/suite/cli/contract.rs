//! What other programs rely on: exit codes, fields of JSON, behaviour of streams and names.

use std::process::Stdio;

use serde_json::Value;

use super::shell::Shell;

#[test]
fn exit_codes() {
    let shell = Shell::new();
    for (code, line) in [
        (0, "check sigma.iso.json --is planar,i-circular,i-conical,inscribed,delaunay"),
        (0, "check twisted.iso.json"),
        (0, "info pinched.obj"),
        (0, "dual sigma.iso.json -o dual.off"),
        (0, "--version"),
        (0, "help check"),
        (1, "check twisted.iso.json --is planar"),
        (1, "check twisted.iso.json --is i-conical,planar"),
        (1, "check binary.off --is planar --read-as double"),
        (1, "dual twisted.iso.json -o dual.off"),
        (1, "dual bent.obj -o dual.off"),
        (2, ""),
        (2, "check"),
        (2, "check missing.obj"),
        (2, "check sigma.iso.json --is flat"),
        (2, "move kite.obj --rotate 1,1 -o moved.obj"),
        (2, "convert kite.obj missing/kite.obj"),
        (3, "check printed.obj --is planar"),
        (3, "check bent.obj --is planar --tolerance 1"),
        (3, "check vertical.obj --is planar,circumscribed"),
        (3, "check triangle.ply --is planar"),
        (3, "dual vertical.obj -o dual.off"),
        (3, "dual printed.obj -o dual.off"),
    ] {
        assert_eq!(shell.line(line).code, code, "isogeo {line}");
    }
    assert!(!shell.path("moved.obj").exists());
}

#[test]
fn fields_of_check() {
    let shell = Shell::new();
    let count = |value: &Value, key: &str| value[key].as_u64().unwrap_or_else(|| panic!("{key}"));
    for file in ["sigma.iso.json", "twisted.iso.json", "printed.obj", "pyramid.off", "vertical.obj"]
    {
        let run = shell.run(&["check", file, "--format", "json"]);
        let report = run.json();
        assert_eq!(report["schema"], "isogeo.check/1");
        assert_eq!(report["file"], file);
        let mesh = &report["mesh"];
        ["vertices", "faces", "interior_vertices"].iter().for_each(|key| {
            count(mesh, key);
        });
        assert!(
            ["decimal", "rounded", "double"].contains(&mesh["read_as"].as_str().expect("text"))
        );
        let properties = report["properties"].as_array().expect("a list");
        assert_eq!(properties.len(), isogeo::net::Property::ALL.len());
        for property in properties {
            let checked = count(property, "checked");
            let [failed, undefined, undecided] =
                ["failed", "undefined", "undecided"].map(|key| count(property, key));
            assert!(failed + undecided <= checked);
            let verdict = match () {
                _ if failed > 0 => "refuted",
                _ if undefined > 0 => "undecided",
                _ if undecided > 0 => "consistent",
                _ if checked > 0 => "proved",
                _ => "vacuous",
            };
            assert_eq!(property["verdict"], verdict, "{file}: {property}");
            witness(&property["worst"], failed > 0);
        }
    }
}

/// An exact residual that is not zero as text, a defect as a number, and one element.
fn witness(worst: &Value, failed: bool) {
    assert_eq!(worst.is_object(), failed, "{worst}");
    if !failed {
        assert!(worst.is_null());
        return;
    }
    let residual = worst["residual"].as_str();
    if let Some(text) = residual {
        let digits = text.trim_start_matches('-').chars();
        assert!(digits.clone().all(|c| c.is_ascii_digit() || c == '/') && text != "0", "{text}");
    } else {
        assert!(worst["residual"].is_null());
    }
    assert!(worst["defect"].as_f64().is_some_and(|d| d > 0.0 && d.is_finite()));
    let elements = ["face", "vertex", "edge"].iter().filter(|e| worst.get(e).is_some());
    assert_eq!(elements.count(), 1);
}

#[test]
fn errors_are_json_if_asked_for() {
    let shell = Shell::new();
    for line in
        ["check missing.obj --format json", "--format=json check", "info x.obj --bad --format json"]
    {
        let run = shell.line(line);
        let error = run.json();
        assert_eq!((run.code, run.err.as_str()), (2, ""), "{line}");
        assert_eq!(error["schema"], "isogeo.error/1");
        assert!(error["message"].as_str().is_some_and(|m| !m.is_empty()));
        assert!(error["code"].as_str().is_some_and(|c| c.starts_with("isogeo::")));
    }
}

#[test]
fn completions_and_manual() {
    let shell = Shell::new();
    for name in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let run = shell.run(&["completions", name]);
        assert_eq!(run.code, 0);
        assert!(run.out.contains("clear-denominators"), "{name}");
    }
    let manual = shell.run(&["man"]);
    assert_eq!(manual.code, 0);
    for command in
        ["check", "info", "convert", "dual", "gauss", "offset", "move", "invert", "transfer"]
    {
        assert!(manual.out.contains(&format!("isogeo\\-{command}")), "{command}");
    }
}

#[test]
fn names_of_files() {
    let shell = Shell::new();
    let text = shell.cat("kite.obj");
    for name in ["two words.obj", "Fläche ∑.obj", "KITE.OBJ", "-.obj", "a.b.obj"] {
        shell.file(name, &text);
        let name = format!("./{name}");
        let run = shell.run(&["check", &name, "--is", "planar"]);
        assert_eq!(run.code, 0, "{}", run.err);
        assert!(run.out.starts_with(&format!("{name}: 4 vertices")));
        let output = format!("{name} 2.iso.json");
        assert_eq!(shell.run(&["convert", &name, &output]).code, 0);
        assert!(shell.path(&output).exists());
    }
}

#[test]
fn a_mesh_may_be_written_onto_itself() {
    let shell = Shell::new();
    assert_eq!(shell.line("move kite.obj --translate 1,0,0 -o kite.obj").code, 0);
    assert_eq!(shell.line("move kite.obj --translate -1,0,0 -o kite.obj").code, 0);
    assert!(shell.cat("kite.obj").ends_with("v 0 0 0\nv 2 0 2\nv 2 2 4\nv 0 1 1\nf 1 2 3 4\n"));
}

/// As in `isogeo ... | head -0`.
#[test]
fn closed_streams_are_no_panic() {
    let shell = Shell::new();
    for (code, line) in [
        (0, "check sigma.iso.json"),
        (1, "check twisted.iso.json --is planar --format json"),
        (0, "man"),
        (0, "completions bash"),
        (0, "--help"),
        (2, "check missing.obj"),
        (2, "check missing.obj --format json"),
        (2, "check --format json"),
        (2, ""),
        (2, "chek"),
    ] {
        let mut command = shell.command(line.split_whitespace());
        let mut child = command
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        drop(child.stdout.take());
        drop(child.stderr.take());
        let status = child.wait().expect("it ends");
        assert_eq!(status.code(), Some(code), "isogeo {line}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_report_that_is_lost_is_an_error() {
    let shell = Shell::new();
    for line in ["check sigma.iso.json --is planar", "info kite.obj --format json", "man", "--help"]
    {
        let full = std::fs::File::options().write(true).open("/dev/full").expect("a device");
        let output = shell.command(line.split_whitespace()).stdout(full).output().expect("a run");
        assert_eq!(output.status.code(), Some(2), "isogeo {line}");
        assert!(String::from_utf8_lossy(&output.stderr).contains("cannot be printed"));
    }
}

#[test]
fn converting_a_rounded_file_does_not_make_it_exact() {
    // Found by converting a real mesh: `consistent` became `refuted` on the way through OBJ.
    let shell = Shell::new();
    shell.file("a.obj", "v 0.33 0 0\nv 1 0 0\nv 1 1 0\nv 0.67 1.01 0.01\nf 1 2 3 4\n");
    assert_eq!(shell.line("check a.obj --is planar").code, 3);
    for out in ["b.obj", "b.off", "b.ply"] {
        assert_eq!(shell.line(&format!("convert a.obj {out}")).code, 0);
        assert_eq!(shell.line(&format!("check {out} --is planar")).code, 3, "{out}");
        assert!(!shell.cat(out).contains("coords=exact"), "{out}");
        assert_eq!(shell.line(&format!("convert a.obj {out} --read-as decimal")).code, 0);
        assert_eq!(shell.line(&format!("check {out} --is planar")).code, 1, "{out}");
        assert!(shell.cat(out).contains("coords=exact"), "{out}");
    }
}
