//! The program, run as its users run it: what every command prints, kept as snapshots.

#[cfg(feature = "campaigns")]
mod campaigns;
#[cfg(feature = "optimise")]
mod certify;
mod claims;
mod contract;
mod curvature;
mod damage;
#[cfg(unix)]
mod faults;
mod invariance;
mod koebe;
mod make;
#[cfg(feature = "optimise")]
mod optimize;
mod pairs;
mod png;
mod samples;
mod shell;
mod spheres;
mod subdivide;

use insta::assert_snapshot;

use shell::Shell;

#[test]
fn first_steps() {
    assert_snapshot!(Shell::new().session(&["", "--help", "-h"]));
}

#[test]
fn help_has_an_example() {
    let shell = Shell::new();
    let commands = [
        "check",
        "info",
        "convert",
        "dual",
        "curvature",
        "gauss",
        "offset",
        "christoffel",
        "make",
        "move",
        "invert",
        "transfer",
        "subdivide",
        "completions",
        "man",
    ];
    for command in commands {
        let run = shell.run(&[command, "--help"]);
        assert_eq!(run.code, 0);
        let (_, example) = run.out.split_once("Example").expect("an example");
        assert!(example.contains(":\n  isogeo "), "{command} has no example");
    }
    assert_snapshot!(
        shell.session(&commands.map(|c| format!("{c} --help")).each_ref().map(|c| c.as_str()))
    );
}

#[test]
fn check_text() {
    assert_snapshot!(Shell::new().session(&[
        "check sigma.iso.json",
        "check sigma.iso.json --is planar,i-circular,i-conical,inscribed,delaunay",
        "check twisted.iso.json --is planar,i-circular,delaunay",
        "check printed.obj --is planar",
        "check printed.obj --is planar --read-as decimal",
        "check bent.obj --is planar,i-circular,planar",
        "check bent.obj --is planar --tolerance 1",
        "check binary.off --is planar --read-as decimal",
        "check binary.off --is planar --read-as double",
        "check binary.off --is planar --read-as rounded",
        "check vertical.obj --is planar,circumscribed",
        "check kite.obj --is planar,i-circular",
        "check triangle.ply --is planar,i-conical",
        "check cloud.obj --is planar",
        "check pyramid.off",
        "check pinched.obj",
        "check huge.obj --is circumscribed --read-as decimal",
    ]));
}

#[test]
fn check_json() {
    assert_snapshot!(Shell::new().session(&[
        "check sigma.iso.json --is planar --format json",
        "check twisted.iso.json --is planar,delaunay --format json",
        "check bent.obj --is planar --tolerance 1e0 --format json",
        "check printed.obj --is planar --format json",
        "check vertical.obj --is circumscribed --format json",
        "check triangle.ply --is planar --format json",
    ]));
}

#[test]
fn info() {
    assert_snapshot!(Shell::new().session(&[
        "info sigma.iso.json",
        "info pyramid.off",
        "info pinched.obj",
        "info cloud.obj",
        "info triangle.ply --read-as double",
        "info huge.obj",
        "info pinched.obj --format json",
        "info third.iso.json --format json",
    ]));
}

#[test]
fn dual() {
    assert_snapshot!(Shell::new().session(&[
        "dual sigma.iso.json -o dual.iso.json",
        "cat dual.iso.json",
        "check dual.iso.json --is i-conical,planar",
        "dual twisted.iso.json -o none.iso.json",
        "dual twisted.iso.json -o none.iso.json --format json",
        "dual bent.obj -o none.iso.json",
        "dual printed.obj -o none.iso.json",
        "dual vertical.obj -o none.iso.json",
        "dual vertical.obj -o none.iso.json --format json",
    ]));
}

#[test]
fn motions() {
    assert_snapshot!(Shell::new().session(&[
        "move kite.obj --rotate 3/5,4/5 -o rotated.obj",
        "cat rotated.obj",
        "move kite.obj --rotate 5/13,-12/13 -o rotated.obj",
        "move kite.obj --shear -1/2,0.25 -o sheared.obj",
        "cat sheared.obj",
        "move kite.obj --translate=-1,2e1,1/3 -o translated.iso.json --format json",
        "cat translated.iso.json",
        "move kite.obj -o unmoved.obj",
        "move kite.obj --rotate 1,1 -o bad.obj",
        "move kite.obj --rotate 1 -o bad.obj",
        "move kite.obj --shear 1,x -o bad.obj",
        "move kite.obj --shear 1/0,1 -o bad.obj --format json",
    ]));
}

#[test]
fn convert() {
    assert_snapshot!(Shell::new().session(&[
        "convert third.iso.json third.obj",
        "cat third.obj",
        "convert third.iso.json third.off --digits 3",
        "cat third.off",
        "convert third.iso.json third.ply --clear-denominators",
        "cat third.ply",
        "convert third.iso.json third.vtu",
        "cat third.vtu",
        "convert kite.obj kite.iso.json",
        "cat kite.iso.json",
        "convert kite.obj kite.OFF --format json",
        "convert third.iso.json x.obj --clear-denominators --digits 3",
        "convert third.iso.json x.obj --digits 0",
        "convert third.iso.json x.stl",
        "convert huge.obj x.vtu",
    ]));
}

#[test]
fn errors_text() {
    let shell = Shell::new();
    broken(&shell);
    assert_snapshot!(shell.session(&ERRORS));
}

#[test]
fn errors_json() {
    let shell = Shell::new();
    broken(&shell);
    let lines = ERRORS.map(|line| format!("{line} --format json"));
    assert_snapshot!(shell.session(&lines.each_ref().map(|l| l.as_str())));
}

fn broken(shell: &Shell) {
    shell.file("fraction.obj", "v 0 0 0\nv 1 0 0\nv 1 1 1/3\nf 1 2 3\n");
    shell.file("index.obj", "v 0 0 0\nv 1 0 0\nv 1 1 1\n\nf 1 2 7\n");
    shell.file("one-based.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n");
    shell.file("cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\n");
    shell.file("cut.iso.json", "{\"format\":\"isogeo-mesh\",\n\"version\":1,");
    shell.file("empty.obj", "");
    shell.file("moebius.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 1 2 4\n");
    shell.file("grid.vtu", "");
}

const ERRORS: [&str; 21] = [
    "check fraction.obj",
    "check index.obj",
    "info one-based.off",
    "info cut.ply",
    "info cut.iso.json",
    "info empty.obj",
    "info moebius.obj",
    "info grid.vtu",
    "info mesh.stl",
    "info huge.obj --read-as double",
    "check kite.obj --is flat",
    "check kite.obj --is planar,",
    "check kite.obj --is edge-offset,constant-k",
    "check kite.obj --is constant-k",
    "check kite.obj --tolerance -1",
    "check kite.obj --tolerance inf",
    "check kite.obj --tolerance little",
    "check kite.obj --read-as float",
    "check",
    "chek kite.obj",
    "dual kite.obj",
];
