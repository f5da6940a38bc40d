//! Curvatures on the command line: triangles, quads, hexagons, mixed faces, and what is undefined.

use insta::assert_snapshot;
use isogeo::mesh::file::parse_fraction;
use isogeo::scalar::{Rational, Ring};
use serde_json::Value;

use super::shell::Shell;

/// The samples; a graph over a lattice of triangles with its lift, the dual hexagons with theirs;
/// an inscribed image of the quads; and a mesh of a quad, triangles and a pentagon.
fn shell() -> Shell {
    let shell = Shell::new();
    let lattice = (0..5).flat_map(|i| (0..5).map(move |j| format!("{} {}\n", 2 * i + j, 2 * j)));
    shell.file("lattice.txt", lattice.collect::<String>());
    // Vertices 0..3 of the square are boundary, 4 and 5 lie inside; face 5 runs straight at 4.
    shell.file(
        "mixed.obj",
        "# isogeo: coords=exact\nv 0 0 0\nv 6 0 1\nv 6 4 0\nv 0 4 2\nv 2 2 1\nv 4 2 3\n\
         f 1 2 6 5\nf 2 3 6\nf 3 4 5 6\nf 4 1 5\n",
    );
    for line in [
        "triangulate --sample x^2/2-x*y+y^3/9 --at lattice.txt -o graph.iso.json",
        "gauss graph.iso.json --kind lift -o lift.iso.json",
        "dual graph.iso.json -o hexagons.iso.json",
        "dual lift.iso.json -o tangent.iso.json",
        "gauss sigma.iso.json --kind inscribed --start 1/3,1/7 -o image.iso.json",
    ] {
        assert_eq!(shell.line(line).code, 0, "{line}");
    }
    shell
}

#[test]
fn curvature() {
    assert_snapshot!(shell().session(&[
        "curvature graph.iso.json --at vertices",
        "curvature graph.iso.json --at vertices --gauss lift.iso.json",
        "curvature hexagons.iso.json --at faces --gauss tangent.iso.json",
        "curvature sigma.iso.json --at faces --gauss image.iso.json",
        "curvature sigma.iso.json --at vertices --format json --integrated",
        "curvature sigma.iso.json --at faces",
        "curvature mixed.obj --at vertices",
        "curvature mixed.obj --at vertices --format json",
        "curvature mixed.obj --at faces --format json",
        "curvature pyramid.off --at vertices",
        "curvature pinched.obj --at vertices",
        "curvature cloud.obj --at faces",
        "curvature vertical.obj --at faces --gauss vertical.obj",
        "curvature twisted.iso.json --at faces --gauss sigma.iso.json",
        "curvature huge.obj --at vertices",
        "curvature kite.obj --at vertices -o kite.obj",
        "curvature kite.obj --at faces --gauss lift.iso.json",
        "curvature graph.iso.json",
    ]));
}

#[test]
fn curvatures_in_files() {
    assert_snapshot!(shell().session(&[
        "curvature mixed.obj --at vertices -o mixed.vtu",
        "cat mixed.vtu",
        "curvature sigma.iso.json --at faces --gauss image.iso.json -o curved.iso.json",
        "cat curved.iso.json",
        "curvature sigma.iso.json --at vertices -o curved.vtu --format json",
    ]));
}

/// What is printed is what the pair of duals says by (11): H* = H/K and K* = 1/K.
#[test]
fn hexagons_have_the_dual_curvatures() {
    let shell = shell();
    let values = |line: &str| -> Vec<Value> {
        shell.line(line).json()["values"].as_array().expect("a list").clone()
    };
    let vertices = values("curvature graph.iso.json --at vertices --format json");
    let faces =
        values("curvature hexagons.iso.json --at faces --gauss tangent.iso.json --format json");
    // Face i of the dual is the i-th interior vertex.
    let defined: Vec<_> = vertices.iter().filter(|v| v["H"].is_string()).collect();
    assert_eq!((defined.len(), faces.len()), (9, 9));
    let number = |v: &Value| -> Rational {
        parse_fraction(v.as_str().expect("a fraction")).expect("a fraction")
    };
    for (vertex, face) in defined.iter().zip(&faces) {
        let (h, k) = (number(&vertex["H"]), number(&vertex["K"]));
        assert_eq!(number(&face["K"]) * &k, Rational::from_i64(1));
        assert_eq!(number(&face["H"]) * &k, h);
    }
}
