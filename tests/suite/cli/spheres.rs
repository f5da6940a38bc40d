//! Sphere transformations on the command line: `invert`, `transfer`.

use insta::assert_snapshot;
use isogeo::construct::translational_net;
use isogeo::mesh::file::{Options, write};
use isogeo::scalar::{Field, Rational};
use serde_json::Value;

use super::shell::Shell;
use crate::transfer::enneper;

/// The samples, and an i-circular and an i-isothermic mesh with interior vertices.
fn shell() -> Shell {
    let shell = Shell::new();
    let number = Rational::from_ratio;
    let profile =
        |k| (-2..=2).map(move |i| (number(i, 4), number(k * i * i, 32))).collect::<Vec<_>>();
    let bowl = translational_net(&profile(1), &profile(2)).expect("a grid");
    write(shell.path("bowl.iso.json"), &bowl, &Options::default()).expect("a file");
    let (mut isothermic, radii) = enneper(4, 3);
    isothermic.data.vertex.insert("radius".into(), radii);
    write(shell.path("enneper.iso.json"), &isothermic, &Options::default()).expect("a file");
    isothermic.data.vertex.entry("radius".into()).and_modify(|r| r[5] = number(7, 1));
    write(shell.path("wrong-radius.iso.json"), &isothermic, &Options::default()).expect("a file");
    shell
}

#[test]
fn invert() {
    let shell = shell();
    assert_snapshot!(shell.session(&[
        "invert sigma.iso.json --at -1/2,3 -o i.iso.json",
        "cat i.iso.json",
        "check i.iso.json --is planar,i-circular",
        "invert i.iso.json --at -0.5,3 -o again.iso.json",
        "check sigma.iso.json --with again.iso.json --is v-parallel",
        "invert sigma.iso.json --sphere 1,0,0,1/2 -o i.obj --format json",
        "cat i.obj",
        "invert kite.obj --at 1,-1 --radius2=-2 -o i.obj",
        "check i.obj --is planar",
        "invert printed.obj --at 3,4 --radius2 25 -o i.off",
        "invert printed.obj --sphere 0,0,0,1 -o i.off",
        "invert third.iso.json --at 1,1 -o i.obj",
        "invert third.iso.json --at 1,1 -o i.iso.json --format json",
        "invert enneper.iso.json --at 1,2 --by incircles -o i.iso.json",
        "check i.iso.json --is planar,i-isothermic",
        "invert enneper.iso.json --at 1,2 --by incircles -o i.obj --format json",
        "invert wrong-radius.iso.json --at 1,2 --by incircles -o none.obj",
        "invert wrong-radius.iso.json --at 1,2 --by incircles -o none.obj --format json",
        "invert sigma.iso.json --at 1,2 --by incircles -o none.obj",
        "invert sigma.iso.json --at 0,0 -o none.obj",
        "invert sigma.iso.json --at 0,0 -o none.obj --format json",
        "invert sigma.iso.json --at 1 -o none.obj",
        "invert sigma.iso.json --at 1,2 --radius2 0 -o none.obj",
        "invert sigma.iso.json --at 1,2 --sphere 1,0,0,0 -o none.obj",
        "invert sigma.iso.json --sphere 1,0,0 -o none.obj",
        "invert sigma.iso.json -o none.obj",
    ]));
    assert!(!shell.path("none.obj").exists());
}

#[test]
fn transfer() {
    let shell = shell();
    shell.file("moved.iso.json", shell.cat("bowl.iso.json").replace("\"1/16\"", "\"1/15\""));
    // Stored planes that do not fit.
    shell.line("transfer bowl.iso.json --to euclidean -o n.iso.json");
    let (mesh, data) = shell
        .cat("n.iso.json")
        .split_once("\"h\":[")
        .map_or_else(|| panic!("heights"), |(mesh, data)| (mesh.to_owned(), data.to_owned()));
    let heights = data.replacen('"', "\"9", 1);
    shell.file("higher.iso.json", format!("{mesh}\"h\":[{heights}"));
    let normals = data.replace("\"n1\":[\"-", "\"n1\":[\"-9");
    shell.file("longer.iso.json", format!("{mesh}\"h\":[{normals}"));
    assert_snapshot!(shell.session(&[
        "transfer bowl.iso.json --to euclidean -o n.iso.json --gauss s.iso.json",
        "check n.iso.json --is planar,conical",
        "check n.iso.json --with s.iso.json --is parallel",
        "transfer n.iso.json --to isotropic -o back.iso.json",
        "cat back.iso.json",
        "transfer longer.iso.json --to isotropic -o none.obj",
        "transfer higher.iso.json --to isotropic -o none.obj",
        "transfer bowl.iso.json --to euclidean -o n.obj --format json -d 2",
        "check n.obj --is conical",
        "transfer n.obj --to isotropic -o none.obj",
        "transfer bowl.iso.json --to euclidean -o turned.iso.json -d 1/2",
        "transfer enneper.iso.json --to euclidean -o eo.iso.json -d -1 --gauss s.iso.json",
        "check eo.iso.json --is planar,edge-offset",
        "transfer eo.iso.json --to isotropic -o back.iso.json --format json",
        "check back.iso.json --is planar,i-isothermic",
        "check eo.iso.json --with s.iso.json --is parallel",
        "transfer enneper.iso.json --to euclidean --by circumcircles -o none.obj",
        "transfer wrong-radius.iso.json --to euclidean -o none.obj",
        "transfer bowl.iso.json --to euclidean --by incircles -o none.obj",
        "transfer moved.iso.json --to euclidean -o none.obj",
        "transfer kite.obj --to euclidean -o none.obj",
        "transfer kite.obj --to euclidean -o none.obj --format json",
        "transfer printed.obj --to euclidean -o none.obj",
        "transfer vertical.obj --to euclidean -o none.obj",
        "transfer vertical.obj --to isotropic -o i.obj",
        "transfer kite.obj --to isotropic -o none.obj",
        "transfer pyramid.off --to isotropic -o none.obj --format json",
        "transfer bent.obj --to isotropic -o none.obj",
        "transfer bowl.iso.json --to isotropic -d 1 -o none.obj",
        "transfer bowl.iso.json -o none.obj",
    ]));
    assert!(!shell.path("none.obj").exists());
}

/// Offsets of the image at a constant face distance are those that its Gauss image makes.
#[test]
fn an_offset_is_an_offset() {
    let shell = shell();
    for line in [
        "transfer bowl.iso.json --to euclidean -o n.iso.json --gauss s.iso.json",
        "offset n.iso.json --gauss s.iso.json -d 3/7 -o offset.iso.json",
        "transfer bowl.iso.json --to euclidean -o d.iso.json -d 3/7",
        "check offset.iso.json --is conical,planar",
        "check d.iso.json --is conical,planar",
    ] {
        assert_eq!(shell.line(line).code, 0, "{line}");
    }
    let json = |name| serde_json::from_str::<Value>(&shell.cat(name)).expect("JSON");
    let (offset, d) = (json("offset.iso.json"), json("d.iso.json"));
    assert_eq!(offset["vertices"], d["vertices"]);
    let before = json("n.iso.json");
    assert_eq!(before["data"]["face"]["n1"], d["data"]["face"]["n1"]);
    assert_ne!(before["data"]["face"]["h"], d["data"]["face"]["h"]);
}

#[test]
fn exit_codes() {
    let shell = shell();
    for (code, line) in [
        (0, "invert kite.obj --at 5,5 -o i.obj"),
        (2, "invert kite.obj --at 2,0 -o none.obj"),
        (2, "invert kite.obj --at 5,5 --radius2 x -o none.obj"),
        (0, "transfer bowl.iso.json --to euclidean -o n.iso.json"),
        (1, "transfer kite.obj --to euclidean -o none.obj"),
        (1, "transfer twisted.iso.json --to euclidean -o none.obj"),
        (1, "transfer wrong-radius.iso.json --to euclidean -o none.obj"),
        (2, "transfer kite.obj --to euclidean --by incircles -o none.obj"),
        (2, "transfer kite.obj --to nowhere -o none.obj"),
        (3, "transfer vertical.obj --to euclidean -o none.obj"),
        (3, "transfer kite.obj --to isotropic -o none.obj"),
        (3, "transfer bowl.iso.json --to euclidean -d 1/2 -o turned.iso.json"),
    ] {
        assert_eq!(shell.line(line).code, code, "isogeo {line}");
    }
    assert!(!shell.path("none.obj").exists());
}

/// That four points lie on an i-circle does not change under i-M-transformations.
#[test]
fn inversions_keep_circular_faces() {
    let shell = shell();
    let failed = |file: &str| {
        let report = shell.run(&["check", file, "--is", "i-circular", "--format", "json"]).json();
        let found = &report["properties"][0];
        (found["verdict"].clone(), found["failed"].clone(), found["checked"].clone())
    };
    for file in
        ["sigma.iso.json", "twisted.iso.json", "kite.obj", "bowl.iso.json", "enneper.iso.json"]
    {
        let before = failed(file);
        for how in ["--at=-7/3,8/5", "--at=9,1/7", "--sphere=3,1/2,-1,5", "--sphere=0,2,1,0"] {
            let run = shell.run(&["invert", file, how, "-o", "i.iso.json"]);
            assert_eq!(run.code, 0, "{}", run.err);
            assert_eq!(failed("i.iso.json"), before, "{file} {how}");
        }
    }
}

/// What cannot be seen in the digits is not denied.
#[test]
fn rounded_meshes_are_not_refuted() {
    let shell = shell();
    for line in [
        "invert bowl.iso.json --at 9,7 --radius2 100 -o i.iso.json",
        "convert i.iso.json printed-bowl.obj --digits 6",
    ] {
        assert_eq!(shell.line(line).code, 0, "{line}");
    }
    let run = shell.line("transfer printed-bowl.obj --to euclidean -o none.obj");
    assert_eq!(run.code, 3, "{}", run.out);
    assert!(run.out.contains("within the digits"), "{}", run.out);
    let run = shell.line("transfer printed-bowl.obj --to euclidean -o none.obj --read-as decimal");
    assert_eq!(run.code, 1, "{}", run.out);
}
