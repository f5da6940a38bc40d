//! `certify`, and how `check` verifies certificates.

use insta::assert_snapshot;

use super::shell::Shell;

/// A square, of which one corner is lifted by a millionth.
const LIFTED: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0.000001\nv 0 1 0\nf 1 2 3 4\n";

#[test]
fn certificates_are_made_and_verified() {
    let shell = Shell::new();
    shell.file("lifted.obj", LIFTED);
    assert_snapshot!(shell.session(&[
        "certify --help",
        "certify lifted.obj --is planar -o lifted.iso.json",
        "cat lifted.iso.json",
        "check lifted.iso.json --is planar",
        "check lifted.iso.json --is planar,inscribed",
        "check lifted.obj --is planar",
        "certify lifted.obj --is i-circular --fix corners -o fixed.iso.json",
        "certify lifted.obj --is i-circular --fix 0,1,3 -o fixed.iso.json",
        "check fixed.iso.json --is i-circular,planar",
        "certify lifted.obj --is i-conical -o none.iso.json",
        "certify lifted.obj --is planar -o lifted.obj",
        "certify lifted.obj --is planar --fix 4 -o none.iso.json",
        "certify lifted.obj --is inscribed -o none.iso.json",
    ]));
    assert!(!shell.path("none.iso.json").exists());
}

#[test]
fn certificates_in_json() {
    let shell = Shell::new();
    shell.file("lifted.obj", LIFTED);
    let made = shell.line("certify lifted.obj --is planar --fix 1 -o m.iso.json --format json");
    assert_eq!(made.code, 0);
    let report = made.json();
    assert_eq!(report["schema"], "isogeo.written/1");
    let existence = &report["existence"];
    assert_eq!(existence["property"], "planar");
    assert_eq!(existence["pinned"], serde_json::json!([1]));
    assert_eq!(existence["equations"], 1);
    assert!(existence["contraction"].as_f64().is_some_and(|h| h <= 0.5));
    let run = shell.line("check m.iso.json --is planar --format json");
    assert_eq!(run.code, 3);
    let property = &run.json()["properties"][0];
    assert_eq!((&property["verdict"], &property["failed"]), (&"exists".into(), &1.into()));
    assert_eq!(property["radius"], existence["radius"]);
    let none = shell.line("certify lifted.obj --is i-conical -o none.iso.json --format json");
    assert_eq!((none.code, &none.json()["schema"]), (3, &"isogeo.no-proof/1".into()));
}

/// What is changed in the file, and what is said.
#[test]
fn false_certificates_are_found_out() {
    let shell = Shell::new();
    shell.file("lifted.obj", LIFTED);
    shell.line("certify lifted.obj --is planar -o true.iso.json");
    let file = shell.cat("true.iso.json");
    let radius = file.split(r#""radius":""#).nth(1).and_then(|rest| rest.split('"').next());
    let radius = radius.expect("a radius").to_owned();
    for (old, new, why) in [
        (radius.as_str(), "1/10000000", "only within 2.5e-7"),
        ("lifted", "\"1/1024\"", "only within 2.4e-4"),
        ("lifted", "\"1/3\"", "vertex 2 are no doubles"),
        ("\"planar\"", "\"i-conical\"", "asks for nothing"),
        ("\"planar\"", "\"conical\"", "asks for nothing"),
        ("\"planar\"", "\"flat\"", "names no property"),
        ("\"radius\"", "\"pinned\":[0,1,2,3],\"radius\"", "no movement"),
        ("\"radius\"", "\"pinned\":[0,7],\"radius\"", "no vertex 7"),
        (radius.as_str(), "1e-6", "no radius"),
    ] {
        let old = if old == "lifted" { lifted(&file) } else { old.to_owned() };
        let changed = file.replacen(&old, new, 1);
        assert_ne!(changed, file, "{old}");
        shell.file("false.iso.json", changed);
        let run = shell.line("check false.iso.json --is planar");
        assert_eq!(run.code, 1, "{new}: {}", run.out);
        assert!(run.out.contains("REFUTED"), "{new}: {}", run.out);
        assert!(run.out.contains("the certificate is not verified: "), "{new}: {}", run.out);
        assert!(run.out.contains(why), "{new}: {}", run.out);
        let json = shell.line("check false.iso.json --is planar --format json").json();
        assert!(json["properties"][0]["not_verified"].as_str().is_some_and(|w| w.contains(why)));
    }
    // It says nothing of other properties.
    let run = shell.line("check true.iso.json --is i-circular");
    assert_eq!(run.code, 1);
    assert!(!run.out.contains("certificate"), "{}", run.out);
}

/// The height of the lifted corner, as it stands in the file.
fn lifted(file: &str) -> String {
    let vertex = file.split("[\"1\",\"1\",").nth(1).expect("the corner");
    vertex.split(']').next().expect("its height").to_owned()
}
