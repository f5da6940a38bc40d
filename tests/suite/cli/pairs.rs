//! Pairs of meshes on the command line: `check --with`, `gauss`, `offset`.

use insta::assert_snapshot;
use serde_json::Value;

use super::shell::Shell;

/// The samples, and Gauss images of the four quads on the unit i-sphere.
fn shell() -> Shell {
    let shell = Shell::new();
    for line in [
        "gauss sigma.iso.json --kind inscribed --start 1/3,1/7 -o image.iso.json",
        "gauss sigma.iso.json --kind lift -o lift.iso.json",
        "move image.iso.json --shear 1/1000000,0 -o sheared.iso.json",
        "convert image.iso.json image.obj --digits 4",
        "convert sigma.iso.json sigma.obj",
    ] {
        assert_eq!(shell.line(line).code, 0, "{line}");
    }
    shell.file("fewer.obj", "v 0 0 0\nv 1 0 0\nv 1 1 1\nf 1 2 3\n");
    // The faces of kite.obj and of printed.obj from another corner.
    shell.file("turned.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 2 3 4 1\n");
    shell
}

#[test]
fn check_with() {
    assert_snapshot!(shell().session(&[
        "check sigma.iso.json --with image.iso.json --is parallel,f-parallel,cmc,planar",
        "check sigma.iso.json --with lift.iso.json",
        "check sigma.iso.json --with sheared.iso.json --is f-parallel,parallel,i-minimal",
        "check sigma.iso.json --with image.obj --is f-parallel,constant-k",
        "check sigma.obj --with image.obj --is f-parallel --read-as decimal",
        "check vertical.obj --with vertical.obj --is cmc",
        "check pinched.obj --with pinched.obj --is v-parallel,christoffel-dual",
        "check cloud.obj --with cloud.obj --is parallel",
        "check sigma.iso.json --with sheared.iso.json --is f-parallel,v-parallel --format json",
        "check sigma.iso.json --is parallel",
        "check sigma.iso.json --is i-minimal",
        "check sigma.iso.json --with lift.iso.json --is flat",
        "check sigma.iso.json --with fewer.obj --is parallel",
        "check kite.obj --with turned.obj --is parallel",
        "check kite.obj --with turned.obj --is parallel --format json",
        "check kite.obj --with missing.obj",
    ]));
}

#[test]
fn gauss() {
    assert_snapshot!(shell().session(&[
        "gauss sigma.iso.json --kind lift -o s.iso.json",
        "gauss sigma.iso.json --kind delaunay -o s.iso.json",
        "gauss sigma.iso.json --kind inscribed -o s.iso.json",
        "gauss sigma.iso.json --kind inscribed --start -1/2,0.25 --at 8 -o s.iso.json",
        "cat s.iso.json",
        "check s.iso.json --is inscribed",
        "gauss sigma.iso.json --kind circumscribed -o s.obj --format json",
        "check s.obj --is circumscribed,planar",
        "gauss sigma.iso.json --kind circumscribed --start 0,2 --at 3 -o s.iso.json",
        "check sigma.iso.json --with s.iso.json --is v-parallel",
        "gauss triangle.ply --kind delaunay -o s.iso.json",
        "gauss twisted.iso.json --kind lift -o none.obj",
        "gauss kite.obj --kind inscribed --start 0,0 -o none.obj",
        "gauss kite.obj --kind inscribed --start 0,0 -o none.obj --format json",
        "gauss kite.obj --kind lift -o none.obj",
        "gauss kite.obj --kind delaunay -o none.obj",
        "gauss printed.obj --kind lift -o none.obj",
        "gauss printed.obj --kind inscribed --start 1/3,1 -o none.obj",
        "gauss vertical.obj --kind lift -o none.obj",
        "gauss pyramid.off --kind delaunay -o none.obj",
        "gauss cloud.obj --kind inscribed -o s.obj",
        "gauss sigma.iso.json --kind inscribed --start 0,0 --at 9 -o none.obj",
        "gauss sigma.iso.json --kind inscribed --start 0 -o none.obj",
        "gauss sigma.iso.json --kind lift --start 0,0 -o none.obj",
        "gauss sigma.iso.json --kind circumscribed --at 0 -o none.obj",
    ]));
}

#[test]
fn offset() {
    let shell = shell();
    shell.file(
        "third-image.iso.json",
        shell.cat("third.iso.json").replace("2/7", "5/7").replace("-1/9", "1/9"),
    );
    assert_snapshot!(shell.session(&[
        "offset sigma.iso.json --gauss image.iso.json -d -1/2 -o o.iso.json",
        "cat o.iso.json",
        "check sigma.iso.json --with o.iso.json --is f-parallel,parallel",
        "offset sigma.iso.json --gauss lift.iso.json -d 0.5 --vertical -o o.obj --format json",
        "check sigma.iso.json --with o.obj --is v-parallel",
        "offset vertical.obj --gauss vertical.obj -d 1 -o o.obj",
        "offset third.iso.json --gauss third-image.iso.json -d 2 --vertical -o o.iso.json",
        "offset third.iso.json --gauss third-image.iso.json -d 2 --vertical -o o.iso.json --format json",
        "offset sigma.iso.json --gauss sheared.iso.json -d 1 -o none.obj",
        "offset sigma.iso.json --gauss image.iso.json -d 1 --vertical -o none.obj --format json",
        "offset sigma.iso.json --gauss image.obj -d 1 -o none.obj",
        "offset printed.obj --gauss printed.obj -d 1/2 -o o.obj",
        "cat o.obj",
        "offset sigma.iso.json --gauss fewer.obj -d 1 -o none.obj",
        "offset sigma.iso.json --gauss image.iso.json -d half -o none.obj",
    ]));
    assert!(!shell.path("none.obj").exists());
}

#[test]
fn exit_codes() {
    let shell = shell();
    for (code, line) in [
        (0, "check sigma.iso.json --with image.iso.json"),
        (0, "check sigma.iso.json --with image.iso.json --is planar,parallel"),
        (1, "check sigma.iso.json --with sheared.iso.json --is planar,parallel"),
        (2, "check sigma.iso.json --is f-parallel"),
        (2, "check sigma.iso.json --with fewer.obj --is planar"),
        (3, "check sigma.iso.json --with image.obj --is parallel"),
        (3, "check vertical.obj --with vertical.obj --is f-parallel"),
        (0, "gauss sigma.iso.json --kind lift -o s.obj"),
        (1, "gauss kite.obj --kind lift -o none.obj"),
        (2, "gauss kite.obj --kind lift --at 0 -o none.obj"),
        (2, "gauss kite.obj --kind sphere -o none.obj"),
        (3, "gauss vertical.obj --kind lift -o none.obj"),
        (0, "offset sigma.iso.json --gauss image.iso.json -d 1e1 -o s.obj"),
        (1, "offset sigma.iso.json --gauss sheared.iso.json -d 1 -o none.obj"),
        (2, "offset sigma.iso.json --gauss image.iso.json -d 1/0 -o none.obj"),
        (3, "offset sigma.iso.json --gauss image.obj -d 1 -o none.obj"),
    ] {
        assert_eq!(shell.line(line).code, code, "isogeo {line}");
    }
    assert!(!shell.path("none.obj").exists());
}

/// The law of offsets (18) seen from outside: H = K = 1 for the sphere itself.
#[test]
fn the_sphere_is_its_own_gauss_image() {
    let shell = shell();
    for d in ["1/2", "-3", "2.5e-1"] {
        let line = format!("offset sigma.iso.json --gauss sigma.iso.json -d {d} -o o.iso.json");
        assert_eq!(shell.line(&line).code, 0);
        let check = "check o.iso.json --with sigma.iso.json --is f-parallel,cmc,constant-k";
        assert_eq!(shell.line(check).code, 0, "{d}");
    }
    let report = shell.line("check sigma.iso.json --with lift.iso.json --format json").json();
    assert_eq!(report["with"], "lift.iso.json");
    assert_eq!(report["with_read_as"], "decimal");
    let names = report["properties"].as_array().expect("a list").iter();
    let names: Vec<&Value> = names.map(|p| &p["property"]).collect();
    let pairs = isogeo::pair::PairProperty::ALL.map(|p| p.name());
    assert_eq!(names[names.len() - pairs.len()..], pairs);
}
