//! Small meshes, one for each kind of answer.

/// Names and contents of the files in every directory of a test.
pub const ALL: [(&str, &str); 13] = [
    ("sigma.iso.json", SIGMA),
    ("twisted.iso.json", TWISTED),
    ("printed.obj", PRINTED),
    ("bent.obj", BENT),
    ("binary.off", BINARY),
    ("vertical.obj", VERTICAL),
    ("triangle.ply", TRIANGLE),
    ("pyramid.off", PYRAMID),
    ("pinched.obj", PINCHED),
    ("cloud.obj", CLOUD),
    ("kite.obj", KITE),
    ("huge.obj", HUGE),
    ("third.iso.json", THIRD),
];

/// Four quads on the unit i-sphere, above a square grid.
pub const SIGMA: &str = r#"{"format":"isogeo-mesh","version":1,"field":"QQ",
"vertices":[["-1","-1","1"],["0","-1","1/2"],["1","-1","1"],
["-1","0","1/2"],["0","0","0"],["1","0","1/2"],
["-1","1","1"],["0","1","1/2"],["1","1","1"]],
"faces":[[0,1,4,3],[1,2,5,4],[3,4,7,6],[4,5,8,7]]}
"#;

/// The same, with one corner lifted by 1/3 and another shifted.
const TWISTED: &str = r#"{"format":"isogeo-mesh","version":1,"field":"QQ",
"vertices":[["-1","-1","4/3"],["0","-1","1/2"],["1","-1","1"],
["-1","0","1/2"],["0","0","0"],["1","0","1/2"],
["-1","1","1"],["0","1","1/2"],["9/8","9/8","5/4"]],
"faces":[[0,1,4,3],[1,2,5,4],[3,4,7,6],[4,5,8,7]]}
"#;

/// One planar quad, printed with three digits.
const PRINTED: &str = "# printed\nv 0.000 0.000 0.000\nv 1.000 0.000 0.333\n\
    v 1.000 1.000 0.667\nv 0.000 1.000 0.333\nf 1 2 3 4\n";

/// A quad that is planar for no digits.
const BENT: &str = "v 0.0 0.0 0.0\nv 1.0 0.0 0.0\nv 1.0 1.0 0.5\nv 0.0 1.0 0.0\nf 1 2 3 4\n";

/// Planar for the printed decimals, not for the nearest doubles.
const BINARY: &str = "OFF\n4 1 0\n0.1 0.1 0.1\n0.3 0.1 0.3\n0.3 0.7 0.9\n0.1 0.7 0.7\n4 0 1 2 3\n";

/// A face whose top view is a segment, and a horizontal one.
const VERTICAL: &str = "# isogeo: coords=exact\nv 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\n\
    v 1 1 0\nv 0 1 0\nf 1 4 3 2\nf 1 2 5 6\n";

const TRIANGLE: &str = "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n\
    property double y\nproperty double z\nelement face 1\n\
    property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0.25\n0 1 0.5\n3 0 1 2\n";

/// Closed: a square and four triangles.
const PYRAMID: &str = "OFF\n5 5 8\n-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n0 0 1\n\
    4 3 2 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";

/// Two triangles with a common corner, an isolated vertex, and another at the same place.
const PINCHED: &str =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv -1 0 0\nv -1 -1 0\nv 5 5 5\nv 5 5 5\nf 1 2 3\nf 1 4 5\n";

const CLOUD: &str = "v 0 0 0\nv 1.5 0 0\nv 1 1 1e1\n";

/// A quad around the circle of the other three points: exact, planar, not i-circular.
const KITE: &str = "# isogeo: coords=exact\nv 0 0 0\nv 2 0 2\nv 2 2 4\nv 0 1 1\nf 1 2 3 4\n";

/// Beyond the doubles.
const HUGE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 1e400\nf 1 2 3\n";

/// Fractions that are no finite decimals.
const THIRD: &str = r#"{"format":"isogeo-mesh","version":1,"field":"QQ",
"vertices":[["0","0","0"],["1/3","0","2/7"],["1/3","1/5","-1/9"]],"faces":[[0,1,2]],
"data":{"face":{"K":["-4/3"]}}}
"#;
