//! `make koebe`: doubles, so that numbers are compared with a tolerance and not kept as snapshots.

use super::shell::Shell;

#[test]
fn koebe_meshes_touch_the_sphere_within_a_tolerance() {
    let shell = Shell::new();
    for (mesh, parameters) in [
        ("pyramid.off", "mesh=pyramid.off"),
        ("pyramid.off", "mesh=pyramid.off,outer=3"),
        ("sigma.iso.json", "mesh=sigma.iso.json"),
    ] {
        let made = shell.run(&["make", "koebe", "-p", parameters, "-o", "k", "--format", "json"]);
        assert_eq!(made.code, 0, "{mesh}: {} {}", made.out, made.err);
        let observed = &made.json()["observed"];
        for what in ["angle_defect", "gap"] {
            assert!(observed[what].as_f64().unwrap() < 1e-12, "{mesh}: {what}");
        }
        let line = "check k/surface.iso.json --is midscribed --tolerance 1e-11 --format json";
        let property = &shell.line(line).json()["properties"][0];
        assert_eq!(property["failed"], 0, "{mesh}: {property}");
        assert_ne!(property["checked"], 0);
        // The control: without the tolerance something is found, as doubles round.
        if mesh == "pyramid.off" {
            assert_eq!(shell.line("check k/surface.iso.json --is midscribed").code, 1);
        }
    }
}

#[test]
fn koebe_refuses_in_words() {
    let shell = Shell::new();
    // Vertex 4 lies inside and has two faces only.
    shell.file("thin.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 1 2 0\nv 1 1 0\nf 1 2 5 4\nf 2 3 4 5\n");
    let run = shell.run(&["make", "koebe", "-p", "mesh=thin.obj", "-o", "k"]);
    assert_eq!(run.code, 1);
    assert!(run.out.contains("1 circles ask for more angle"), "{}", run.out);
    // A ring of quads: with any radii its circles need not close.
    shell.file(
        "ring.obj",
        "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\n\
         f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n",
    );
    let run = shell.run(&["make", "koebe", "-p", "mesh=ring.obj", "-o", "k"]);
    assert_eq!(run.code, 3);
    assert!(run.out.contains("not simply connected"), "{}", run.out);
    let run = shell.run(&["make", "koebe", "-p", "mesh=pinched.obj", "-o", "k"]);
    assert_eq!(run.code, 3);
    assert!(run.out.contains("pinched at a vertex"), "{}", run.out);
    for (parameters, words) in [
        ("outer=3", "which mesh"),
        ("mesh=pyramid.off,outer=9", "no such face"),
        ("mesh=sigma.iso.json,outer=0", "not closed"),
        ("mesh=pyramid.off,inner=0", "no parameter 'inner'"),
        ("mesh=missing.obj", "cannot be read"),
    ] {
        let run = shell.run(&["make", "koebe", "-p", parameters, "-o", "k"]);
        assert_eq!(run.code, 2, "{parameters}");
        assert!(run.err.contains(words), "{parameters}: {}", run.err);
    }
}
