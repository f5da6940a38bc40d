//! `optimize`: what is reached, written and said.

use std::fmt::Write as _;

use insta::assert_snapshot;
use serde_json::Value;

use super::shell::Shell;

/// A patch of `n` by `n` quads over a surface that is no translational one, with four decimals.
fn patch(n: u32) -> String {
    let mut text = String::new();
    for (i, j) in (0..=n).flat_map(|i| (0..=n).map(move |j| (i, j))) {
        let (x, y) = (f64::from(i) / f64::from(n), f64::from(j) / f64::from(n));
        let z = 0.5 * x * x + 0.3 * y * y + 0.05 * x * y * (x - y);
        writeln!(text, "v {:.4} {:.4} {z:.4}", x + 0.02 * y * y, y).expect("a string");
    }
    for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
        let v = |i: u32, j: u32| 1 + i * (n + 1) + j;
        writeln!(text, "f {} {} {} {}", v(i, j), v(i + 1, j), v(i + 1, j + 1), v(i, j + 1))
            .expect("a string");
    }
    text
}

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("{key} in {value}"))
}

#[test]
fn usage() {
    let shell = Shell::new();
    shell.file("patch.obj", patch(2));
    assert_snapshot!(shell.session(&[
        "optimize --help",
        "optimize patch.obj -o none.obj",
        "optimize patch.obj --to flat -o none.obj",
        "optimize patch.obj --to planar --fix 9 -o none.obj",
        "optimize patch.obj --to planar --fix edge -o none.obj",
        "optimize patch.obj --to planar --fairness -1 -o none.obj",
        "optimize patch.obj --to planar --certify -o none.obj",
        "optimize patch.obj --to conical --rationalize -o none.iso.json",
        "optimize patch.obj --to planar --within 1 -o none.obj",
        "optimize huge.obj --to planar --read-as decimal -o none.obj",
    ]));
    assert!(!shell.path("none.obj").exists());
}

#[test]
fn every_goal_is_reached_and_observed() {
    let shell = Shell::new();
    shell.file("patch.obj", patch(4));
    for goal in ["planar", "i-circular", "i-conical", "circular", "conical"] {
        let before = shell.line(&format!("check patch.obj --is {goal} --read-as decimal"));
        assert_eq!(before.code, 1, "{goal} is no test");
        let run = shell.line(&format!("optimize patch.obj --to {goal} -o out.obj --format json"));
        assert_eq!(run.code, 3, "{goal}: {}", run.err);
        let report = &run.json()["optimize"];
        assert_eq!(report["ending"], "converged", "{goal}");
        assert!(number(report, "defect") < 1e-12, "{goal}: {report}");
        assert!(number(report, "movement_largest") < 0.1, "{goal}");
        let rounds = report["rounds"].as_array().expect("rounds");
        assert_eq!(rounds.len(), 1);
        // What is written is what was found: within a tolerance it is undecided, not refuted.
        let after = format!("check out.obj --is {goal} --read-as double --tolerance 1e-9");
        assert!([0, 3].contains(&shell.line(&after).code), "{goal}");
    }
}

#[test]
fn exact_meshes_are_proved() {
    let shell = Shell::new();
    shell.file("patch.obj", patch(4));
    for goal in ["planar", "i-circular", "i-conical"] {
        let line =
            format!("optimize patch.obj --to {goal} --rationalize -o out.iso.json --format json");
        let run = shell.line(&line);
        assert_eq!(run.code, 0, "{goal}: {}{}", run.out, run.err);
        let exact = &run.json()["optimize"]["rationalized"];
        assert_eq!(exact["verdict"], "proved", "{goal}");
        assert!(number(exact, "movement_largest") < 1e-5, "{goal}: {exact}");
        assert_eq!(shell.line(&format!("check out.iso.json --is {goal}")).code, 0, "{goal}");
        // The same file with a disturbed coordinate is refuted.
        let mut mesh: Value = serde_json::from_str(&shell.cat("out.iso.json")).expect("JSON");
        mesh["vertices"][12][2] = "1/7".into();
        shell.file("spoilt.iso.json", mesh.to_string());
        assert_eq!(shell.line(&format!("check spoilt.iso.json --is {goal}")).code, 1, "{goal}");
    }
}

#[test]
fn existence_is_certified_and_verified() {
    let shell = Shell::new();
    shell.file("patch.obj", patch(4));
    let line =
        "optimize patch.obj --to i-circular --fix corners --certify -o out.iso.json --format json";
    let run = shell.line(line);
    assert_eq!(run.code, 3, "{}", run.err);
    assert_eq!(run.json()["optimize"]["existence"]["property"], "i-circular");
    let check = shell.line("check out.iso.json --is i-circular,planar --format json");
    assert_eq!(check.code, 3);
    for property in check.json()["properties"].as_array().expect("a list") {
        assert_eq!(property["verdict"], "exists", "{property}");
    }
}

#[test]
fn rounds_refine_and_pictures_show_them() {
    let shell = Shell::new();
    shell.file("patch.obj", patch(3));
    shell.file("near.obj", patch(8));
    let run = shell.line(
        "optimize patch.obj --to i-conical --subdivide 2 --near near.obj --fairness 0.1 --fix 0,3 \
         -o out.obj --picture out.svg --format json",
    );
    assert_eq!(run.code, 3, "{}", run.err);
    let report = run.json();
    let faces: Vec<_> = report["optimize"]["rounds"]
        .as_array()
        .expect("rounds")
        .iter()
        .map(|round| round["faces"].as_u64())
        .collect();
    assert_eq!(faces, [Some(9), Some(36), Some(144)]);
    let energies = report["optimize"]["rounds"][0]["steps"].as_array().expect("steps");
    assert!(energies.iter().any(|step| step["energy"].is_number()));
    // The vertices that were named are where they were.
    let vertex = |name: &str, v: usize| {
        shell.cat(name).lines().filter(|l| l.starts_with("v ")).nth(v).map(|l| {
            l.split_whitespace()
                .skip(1)
                .map(|c| c.parse::<f64>().expect("a number"))
                .collect::<Vec<_>>()
        })
    };
    for v in [0, 3] {
        assert_eq!(vertex("out.obj", v), vertex("patch.obj", v));
    }
    assert_ne!(vertex("out.obj", 5), vertex("patch.obj", 5));
    assert!(shell.cat("out.svg").contains("before and after"));
}

#[test]
fn what_is_not_reached_is_said() {
    let shell = Shell::new();
    shell.file("patch.obj", patch(2));
    let all = "0,1,2,3,4,5,6,7,8";
    let run = shell.line(&format!("optimize patch.obj --to planar --fix {all} -o out.obj"));
    assert_eq!(run.code, 3);
    assert!(run.out.contains("stuck after 0 steps"), "{}", run.out);
}
