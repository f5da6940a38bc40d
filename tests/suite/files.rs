//! Files: what is read, what is written, what is refused and how.

use std::fmt::Write as _;

use isogeo::mesh::file::{
    Coordinates, FileError, Format, Limits, MeshFile, Options, Written, clear_denominators, read,
    read_bytes, read_bytes_within, read_points_bytes, write, write_string,
};
use isogeo::mesh::{FaceList, Mesh};
use isogeo::scalar::{Approx, Field, Rational, RationalField, ReadAs};
use isogeo::space::Point;
use proptest::prelude::*;

fn q(p: i64, q: i64) -> Rational {
    Rational::from_ratio(p, q)
}

fn parse(format: Format, text: &str) -> Result<MeshFile, FileError> {
    read_bytes("test", format, text.as_bytes())
}

fn exact(format: Format, text: &str) -> Mesh<Rational> {
    let file = parse(format, text).unwrap_or_else(|e| panic!("{e}\n{text}"));
    file.to_exact(ReadAs::Decimal).expect("decimals have no limit")
}

/// A triangle, a quadrilateral and a pentagon, and an isolated vertex.
fn mixed(scale: &Rational) -> Mesh<Rational> {
    let points = [(0, 0), (4, 0), (4, 4), (0, 4), (8, 2), (2, 8), (-2, 6), (9, 9)];
    let points = points.iter().enumerate().map(|(i, &(x, y))| {
        Point::new(q(x, 1), q(y, 1), q(i as i64 * x - y, 1)).map(|c| c * scale)
    });
    let mut faces = FaceList::new();
    faces.push([0, 1, 2, 3]);
    faces.push([1, 4, 2]);
    faces.push([5, 6, 3, 2, 4]);
    Mesh::new(points.collect(), faces).expect("a mesh")
}

fn faces<T>(mesh: &Mesh<T>) -> Vec<Vec<u32>> {
    let topology = &mesh.topology;
    topology.faces().map(|f| topology.face(f).iter().map(|v| v.0).collect()).collect()
}

fn report(error: &FileError) -> String {
    let mut out = format!("{error}\n  code: {}\n", error.code);
    if let Some(place) = &error.place {
        let from = place.span.start - place.excerpt_start;
        let shown = place.excerpt.escape_debug();
        writeln!(out, "  text: {shown} [{from}..+{}]", place.span.len()).unwrap();
    }
    if let Some(help) = &error.help {
        writeln!(out, "  help: {help}").unwrap();
    }
    out
}

fn refused(format: Format, texts: &[&str]) -> String {
    let mut out = String::new();
    for text in texts {
        let error = match parse(format, text) {
            Err(error) => error,
            Ok(_) => panic!("{text:?} was read"),
        };
        writeln!(out, "{:?}\n{}", text, report(&error)).unwrap();
    }
    out
}

const TEXT_FORMATS: [Format; 3] = [Format::Obj, Format::Off, Format::Ply];

#[test]
fn what_is_written_reads_back_as_the_same_mesh() {
    for scale in [q(1, 1), q(-1, 8), q(7, 1000), q(12_345_678_901, 1_000_000)] {
        let mesh = mixed(&scale);
        for format in [Format::Obj, Format::Off, Format::Ply, Format::IsoJson] {
            let (text, written) =
                write_string("test", format, &mesh, &Options::default()).expect("written");
            assert_eq!(written, Written::Exact, "{format:?} {scale}");
            let file = parse(format, &text).unwrap_or_else(|e| panic!("{e}"));
            assert!(file.exact, "{format:?}");
            assert_eq!(file.default_reading(), ReadAs::Decimal);
            assert_eq!(file.to_exact(ReadAs::Decimal).unwrap(), mesh, "{format:?} {scale}");
        }
    }
}

#[test]
fn thirds_are_rounded_in_decimals_and_kept_in_fractions() {
    let mesh = mixed(&q(1, 3));
    for format in TEXT_FORMATS {
        let (text, written) = write_string("test", format, &mesh, &Options::default()).unwrap();
        assert_eq!(written, Written::Rounded);
        let file = parse(format, &text).unwrap();
        assert!(!file.exact);
        let read = file.to_exact(ReadAs::Double).unwrap();
        assert_eq!(faces(&read), faces(&mesh));
        for (a, b) in read.points.iter().zip(&mesh.points) {
            assert_eq!(a.map(Approx::to_f64), b.map(Approx::to_f64), "{format:?}");
        }
    }
    let (text, _) = write_string("test", Format::IsoJson, &mesh, &Options::default()).unwrap();
    assert_eq!(exact(Format::IsoJson, &text), mesh);
}

#[test]
fn data_and_certificate_survive_in_iso_json() {
    let mut mesh = mixed(&q(2, 7));
    mesh.data.face.insert("K \"x\" ≤".into(), vec![q(-4, 1), q(1, 3), q(0, 1)]);
    mesh.data.vertex.insert("radius".into(), (1..=8).map(|i| q(1, i)).collect());
    let certificate = serde_json::json!({"b": ["1/2", null], "a": {"c": true}});
    let options = Options { certificate: Some(certificate.clone()), ..Options::default() };
    let (text, _) = write_string("test", Format::IsoJson, &mesh, &options).unwrap();
    let file = parse(Format::IsoJson, &text).unwrap();
    assert_eq!(file.certificate, Some(certificate));
    assert_eq!(file.coordinates, Coordinates::Rationals(mesh));
}

#[test]
fn an_empty_mesh_is_a_mesh_in_iso_json() {
    let mesh = Mesh::<Rational>::new(Vec::new(), FaceList::new()).unwrap();
    let (text, _) = write_string("test", Format::IsoJson, &mesh, &Options::default()).unwrap();
    assert_eq!(exact(Format::IsoJson, &text), mesh);
}

#[test]
fn the_written_texts() {
    let mut mesh = mixed(&q(1, 4));
    mesh.data.face.insert("K<1>".into(), vec![q(-4, 1), q(1, 3), q(0, 1)]);
    mesh.data.vertex.insert("H".into(), vec![q(1, 2); 8]);
    for format in Format::ALL {
        let (text, written) =
            write_string("test", format, &mesh, &Options::default()).expect("written");
        let name = format!("written_{}", format.name());
        insta::assert_snapshot!(name, format!("{text}--\n{written:?}\n"));
    }
}

#[test]
fn a_tenth_is_a_tenth_or_the_nearest_double() {
    let obj = parse(Format::Obj, "v 0.1 0 0\n").unwrap();
    let x = |read_as| obj.to_exact(read_as).unwrap().points[0].x.clone();
    assert_eq!(x(ReadAs::Decimal), q(1, 10));
    assert_eq!(x(ReadAs::Rounded), q(1, 10));
    assert_eq!(x(ReadAs::Double), q(3_602_879_701_896_397, 36_028_797_018_963_968));
}

#[test]
fn beyond_the_doubles() {
    let obj = parse(Format::Obj, "v 0 0 0\nv 0 1e400 0\n").unwrap();
    insta::assert_snapshot!(
        "beyond_the_doubles",
        report(&obj.to_exact(ReadAs::Double).unwrap_err())
    );
    let mesh = obj.to_exact(ReadAs::Decimal).unwrap();
    assert!(write_string("test", Format::IsoJson, &mesh, &Options::default()).is_ok());
    for format in [Format::Obj, Format::Vtu] {
        let error = write_string("test", format, &mesh, &Options::default()).unwrap_err();
        assert!(error.code.ends_with("::not-finite"), "{error}");
    }
}

#[test]
fn oddities_of_obj() {
    let plain = exact(Format::Obj, "v 0 0 0.0509\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 4 3\n");
    let corners = [
        "f 1 2 4 3",
        "f 1// 2// 4// 3//",
        "f 1//7 2//7 4//7 3//7",
        "f 1/1/2 2/1/2 4/1/2 3/1/2",
        "f 1/1 2/-1 4/1 3/1",
        "f -4 -3 -1 -2",
        "f\t1  2 4 3 \t",
        "f 1 2 \\\n4 3",
        "f 1 2\\\r\n 4 3",
    ];
    let vertices = [
        "v 0 0 5.09e-002\nv 1 0 0\nv 0 1 0\nv 1 1 0",
        "  v   0 0 0.0509 0.5 0.5 0.5\nv 1 0 0 1 1 1 1\nv 0 1 0\nv 1 1 0 # said",
        "v 0 0 +.0509\r\nv 1. 0 -0\r\nv 0 1 0 \r\nv 1 1 0",
        "# \u{fffd}\nmtllib a\\b\\\nvn 0 0 1\nvt 0 \\\n 0\ng a b\ns off\no C:\\x\\\nv 0 0 50.9E-3\rv 1 0 0\rv 0 1 0\rv 1 1 0\rl 1 2\np 1\n",
    ];
    for (v, f) in vertices.iter().flat_map(|v| corners.iter().map(move |f| (v, f))) {
        let text = format!("{v}\n{f}");
        assert_eq!(exact(Format::Obj, &text), plain, "{text}");
    }
    let latin = b"# caf\xe9 \xff\no \xfe\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    assert!(read_bytes("latin", Format::Obj, latin).is_ok());
    let late = "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
    assert_eq!(faces(&exact(Format::Obj, late)), [[0, 1, 2]]);
    assert!(parse(Format::Obj, "#isogeo:  coords=exact \r\nv 0 0 0").unwrap().exact);
    assert!(!parse(Format::Obj, "# isogeo: coords=exactly\nv 0 0 0").unwrap().exact);
}

#[test]
fn oddities_of_off() {
    let plain = exact(Format::Off, "OFF\n3 1 0\n0 0 0.5\n1 0 0\n0 1 0\n3 0 1 2\n");
    for text in [
        "OFF 3 1 3\n0 0 5e-001\n1 0 0\n0 1 0\n3 0 1 2",
        "# a\n\nOFF # b\n# c\n3 1\n\n0 0 .5 # d\n#e\n1 0 0 \n0 1 0\n3  0 1 2  255 0 0\n# end\n",
        "\u{feff}OFF\r\n3 1 0\r\n0 0 0.5\r\n1 0 0\r\n0 1 0\r\n3 0 1 2 0.1 0.2 0.3 1.0\r\n\r\n",
    ] {
        assert_eq!(exact(Format::Off, text), plain, "{text}");
    }
}

const PLY: &str = "ply\nformat ascii 1.0\ncomment made by hand\nobj_info x\nelement vertex 3\n\
    property float z\nproperty list uchar int tags\nproperty double x\nproperty uchar red\n\
    property double y\nelement edge 1\nproperty int a\nelement face 1\n\
    property uchar red\nproperty list uchar int vertex_index\nend_header\n\
    0.5 2 7 7 0 255 0\n0 0 1 255 0\n0 1 9 0 255 1\n0\n9 3 0 1 2\n";

#[test]
fn oddities_of_ply() {
    let mesh = exact(Format::Ply, PLY);
    let plain = exact(Format::Off, "OFF\n3 1 0\n0 0 0.5\n1 0 0\n0 1 0\n3 0 1 2\n");
    assert_eq!(mesh, plain);
    assert_eq!(exact(Format::Ply, &PLY.replace('\n', "\r\n")), plain);
    assert!(
        parse(Format::Ply, &PLY.replace("made by hand", "isogeo: coords=exact")).unwrap().exact
    );
}

/// The triangle of [`PLY`] with doubles, floats and integers for the coordinates.
fn binary_ply(little: bool) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat binary_{}_endian 1.0\ncomment \u{e9}\nelement vertex 3\nproperty double z\n\
         property float x\nproperty short y\nproperty list uchar ushort tags\nelement none 7\n\
         element face 1\nproperty list uint int vertex_indices\nend_header\n",
        if little { "little" } else { "big" }
    )
    .into_bytes();
    let comment = bytes.windows(2).position(|w| w == "\u{e9}".as_bytes()).expect("the comment");
    bytes.splice(comment..comment + 2, [0xe9]); // Latin-1
    let mut push = |big: &[u8]| {
        let start = bytes.len();
        bytes.extend_from_slice(big);
        if little {
            bytes[start..].reverse();
        }
    };
    for (x, y, z) in [(0f32, 0i16, 0.1f64), (0.1, 0, 0.0), (0.0, -1, 0.0)] {
        push(&z.to_be_bytes());
        push(&x.to_be_bytes());
        push(&y.to_be_bytes());
        push(&[1]);
        push(&7u16.to_be_bytes());
    }
    push(&3u32.to_be_bytes());
    for corner in [0i32, 2, 1] {
        push(&corner.to_be_bytes());
    }
    bytes
}

#[cfg(feature = "ply")]
#[test]
fn binary_ply_is_taken_exactly() {
    for little in [true, false] {
        let file = read_bytes("test", Format::Ply, &binary_ply(little)).unwrap();
        let mesh = file.to_exact(ReadAs::Decimal).unwrap();
        assert_eq!(mesh.points[0].z, q(3_602_879_701_896_397, 36_028_797_018_963_968));
        assert_eq!(mesh.points[1].x, q(13_421_773, 134_217_728));
        assert_eq!(mesh.points[2].y, q(-1, 1));
        assert_eq!(faces(&mesh), [[0, 2, 1]]);
    }
}

#[cfg(feature = "ply")]
#[test]
fn refused_binary_ply() {
    let whole = binary_ply(true);
    let data = whole.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
    let with = |at: usize, new: &[u8]| {
        let mut bytes = whole.clone();
        bytes[at..at + new.len()].copy_from_slice(new);
        bytes
    };
    let header = |from: &str, to: &str| {
        let text = String::from_utf8_lossy(&whole[..data]).replace(from, to);
        [text.as_bytes(), &whole[data..]].concat()
    };
    let cases = [
        ("NaN", with(data, &f64::NAN.to_le_bytes())),
        ("infinite", with(data + 17 + 8, &f32::INFINITY.to_le_bytes())),
        ("cut", whole[..whole.len() - 3].to_vec()),
        ("longer", [&whole[..], b"\n"].concat()),
        ("many vertices", header("vertex 3", "vertex 4000000000")),
        ("very many vertices", header("vertex 3", "vertex 400000000000000000")),
        ("many corners", with(whole.len() - 16, &[255; 4])),
        ("negative index", with(whole.len() - 4, &[255; 4])),
        ("high index", with(whole.len() - 4, &[9, 0, 0, 0])),
        ("float index", header("uint int vertex", "uint float vertex")),
    ];
    let mut out = String::new();
    for (name, bytes) in cases {
        let error = read_bytes("test", Format::Ply, &bytes).expect_err(name);
        writeln!(out, "{name}\n{}", report(&error)).unwrap();
    }
    insta::assert_snapshot!("refused_binary_ply", out);
}

#[test]
fn refused_obj() {
    let long = format!("v 0 0 {}", "1".repeat(10_001));
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    let on_square = |faces: &str| format!("{square}{faces}");
    let texts = [
        "",
        "# nothing\n",
        "<html>",
        "v 1 0 1/3",
        "v 1 0 nan",
        "v 1,5 0 0",
        "v 1 0",
        "v 1 0 0 1",
        "v 1 0 0 1 2",
        "v 1 0 0 1 1 x",
        "v 0 0 1e99999",
        &long,
        "v 0 0 0\ncurv 0 1 1 2",
        "v 0 0 \u{e9}\u{e9}",
        "# \u{e9}\r\nv 0 0 0\r\n\u{e9} 0x10",
        "v 0 0 1#x",
    ]
    .map(str::to_owned)
    .into_iter()
    .chain(
        [
            "f 1 2 0",
            "f 1 2 5 ",
            "f 1 2 -5",
            "f 1 2 x",
            "f 1 2 3/1/1/1",
            "f 1 2 3/x",
            "f 1 2",
            "f",
            "f 1 2 3 1",
            "f 1 2 3\nf 1 2 4",
            "f 1 2 3\nf 2 1 4\nf 1 2 4 # third",
            "f 1 2 99999999999999999999",
            "f 1 2 4294967296",
        ]
        .map(on_square),
    )
    .collect::<Vec<_>>();
    let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
    let out = refused(Format::Obj, &texts);
    insta::assert_snapshot!("refused_obj", out.replace(&"1".repeat(10_001), "1…1"));
}

#[test]
fn refused_off() {
    insta::assert_snapshot!(
        "refused_off",
        refused(
            Format::Off,
            &[
                "",
                "3 1 0",
                "COFF\n3 1 0",
                "4OFF\n",
                "OFF BINARY\n",
                "OFF\n",
                "OFF\n3\n",
                "OFF\n3 x 0",
                "OFF\n-3 1 0",
                "OFF\n3 1 0 7\n",
                "OFF\n3 1 0\n0 0 0\n1 0 0\n",
                "OFF\n3 1 0\n0 0 0\n1 0 0\n3 0 1 2\n",
                "OFF\n2 1 0\n0 0 0\n1 0 0\n0.5 1 0\n3 0 1 2\n",
                "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n",
                "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n3 0 1 2\n",
                "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n",
                "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -2\n",
                "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1 1 1 1 1\n",
                "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 red\n",
                "OFF\n400000000000000000 1 0\n0 0 0\n",
            ]
        )
    );
}

#[test]
fn refused_ply() {
    let header = |from: &str, to: &str| PLY.replacen(from, to, 1);
    let texts = [
        String::new(),
        "ply".into(),
        "plyx\n".into(),
        header("ascii 1.0", "ascii 2.0"),
        header("format ascii 1.0\n", ""),
        header("comment made", "made"),
        header("obj_info x", ""),
        header("element vertex 3", "element vertex -3"),
        header("element vertex 3", "element vertex 3 3"),
        header("element edge", "element vertex"),
        header("double x", "float128 x"),
        header("double x", "double y"),
        header("double x", "double X"),
        header("list uchar int tags", "list float int tags"),
        header("list uchar int vertex_index", "int vertex_index"),
        header("element edge 1", "element tristrips 1"),
        header("element vertex 3\n", ""),
        header("element vertex 3", "element point 3"),
        header("vertex 3", "vertex 4"),
        header("vertex 3", "vertex 2"),
        header("9 3 0 1 2", "9 3 0 1"),
        header("9 3 0 1 2", "9 3 0 1 2 0"),
        header("9 3 0 1 2", "9 3 0 1 3"),
        header("9 3 0 1 2", "9 3 0 1 1"),
        header("9 3 0 1 2", "9 -3 0 1 1"),
        header("0.5 2 7", "inf 2 7"),
        header("0.5 2 7", "0.5 4000000000 7"),
        header("9 3 0 1 2", "9 3 0 1 2\n9"),
        header("face 1", "face 2"),
    ];
    let mut out = String::new();
    for text in &texts {
        let error = parse(Format::Ply, text).expect_err(text);
        writeln!(out, "{}", report(&error)).unwrap();
    }
    insta::assert_snapshot!("refused_ply", out);
}

#[test]
fn refused_iso_json() {
    let start = r#"{"format":"isogeo-mesh","version":1,"field":"QQ","#;
    let points = r#""vertices":[["0","0","0"],["1","0","0"],["0","1","0"]]"#;
    let with_z = |z: &str| format!("{start}\n\"vertices\":[[\"0\",\"0\",{z}]],\"faces\":[]}}");
    let with = |rest: &str| format!("{start}\n{points},\n{rest}}}");
    let mut texts = vec![
        String::new(),
        "[]".into(),
        "{}".into(),
        "{\"type\":\"FeatureCollection\"}".into(),
        start.replace("isogeo-mesh", "other"),
        start.replace(":1", ":2"),
        start.replace("QQ", "QQ(sqrt 2)"),
        format!("{start}\n{points}}}"),
        with("\"faces\":[],\"faces\":[]"),
        with("\"faces\":[],\"colour\":1"),
        with("\"faces\":[[0,1,2],\n [0,1,3]]"),
        with("\"faces\":[[0,1,-2]]"),
        with("\"faces\":[[0,1]]"),
        with("\"faces\":[[0,1,2],\n [1,2,0]]"),
        with("\"faces\":[[0,1,2]],\n\"data\":{\"face\":{\"K\":[\"1\",\"2\"]}}"),
        with("\"faces\":[],\"data\":{\"vertex\":{\"K\":[],\"K\":[]}}"),
        with("\"faces\":[],\"data\":{\"edge\":{}}"),
        with("\"faces\":[],\"data\":[{},{}]"),
        with("\"faces\":[],\"data\":{\"face\":{},\"face\":{}}"),
        " [\"isogeo-mesh\",1,\"QQ\",[],[]]".into(),
        with("\"faces\":[]}"),
        with("\"faces\":[").trim_end_matches('}').to_owned(),
    ];
    let numbers = [
        "0.5",
        "1",
        "\"1/0\"",
        "\"0.5\"",
        "\"1/-2\"",
        "\"+1\"",
        "\" 1\"",
        "\"\"",
        "\"/2\"",
        "\"1/2/3\"",
        "\"0\",\"0\"",
        "\"1\",]",
    ];
    texts.extend(numbers.map(with_z));
    texts.push(with_z("\"0\"").replacen(",\"0\"]", "]", 1));
    texts.push(with_z(&format!("\"1/{}\"", "3".repeat(10_001))));
    let mut out = String::new();
    for text in &texts {
        let error = parse(Format::IsoJson, text).expect_err(text);
        writeln!(out, "{}", report(&error).replace(&"3".repeat(100), "3…")).unwrap();
    }
    insta::assert_snapshot!("refused_iso_json", out);
}

#[test]
fn deep_json_is_an_error() {
    let deep = "[".repeat(1_000_000);
    let text = format!(r#"{{"format":"isogeo-mesh","certificate":{deep}"#);
    assert_eq!(&*parse(Format::IsoJson, &text).unwrap_err().code, "isogeo::json::syntax");
    // The limit is where it is stated; the document itself is the first of the brackets.
    let nested = |depth: usize| {
        let [open, close] = ["[", "]"].map(|bracket| bracket.repeat(depth - 1));
        let start = r#"{"format":"isogeo-mesh","version":1,"field":"QQ","vertices":[],"faces":[]"#;
        parse(Format::IsoJson, &format!("{start},\"certificate\":{open}{close}}}"))
    };
    assert!(nested(127).is_ok());
    let error = nested(128).unwrap_err();
    assert_eq!(error.help.as_deref(), Some("brackets may be nested 127 deep"));
}

#[test]
fn numbers_beyond_the_limits_are_refused_and_read_if_asked_for() {
    let start = r#"{"format":"isogeo-mesh","version":1,"field":"QQ","#;
    let ply = "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty double y\n\
        property double z\nend_header\n";
    let long = "7".repeat(1_000_000);
    let texts = [
        (Format::Obj, "v 0 0 1e999999999".to_owned()),
        (Format::Obj, "v 0 0 1\nv 0 1e-999999999 2".to_owned()),
        (Format::Off, format!("OFF\n1 0 0\n0 {long} 0\n")),
        (Format::Ply, format!("{ply}0 0.{long} 0\n")),
        (
            Format::IsoJson,
            format!("{start}\n\"vertices\":[[\"0\",\"{long}/3\",\"0\"]],\"faces\":[]}}"),
        ),
        (
            Format::IsoJson,
            format!("{start}\n\"vertices\":[[\"0\",\"1/{long}\",\"0\"]],\"faces\":[]}}"),
        ),
        (
            Format::IsoJson,
            format!("{start}\n\"vertices\":[],\"faces\":[],\"certificate\":{long}}}"),
        ),
        (Format::IsoJson, format!("{start}\n\"vertices\":[],\"faces\":[[{long}]]}}")),
    ];
    let mut out = String::new();
    for (format, text) in &texts {
        let error = parse(*format, text).expect_err(text);
        assert_eq!(&*error.code, format!("isogeo::{}::limit", format.name()));
        writeln!(out, "{}", report(&error).replace(&"7".repeat(100), "7…")).unwrap();
    }
    let error = read_points_bytes("test", b"0 0 0\n0 0 1e-10001\n").unwrap_err();
    writeln!(out, "{}", report(&error)).unwrap();
    insta::assert_snapshot!("beyond_the_limits", out);

    // With the zero before the point.
    let limits = Limits { digits: 1_000_001, ..Limits::default() };
    for (format, text) in &texts[2..6] {
        let file = read_bytes_within("test", *format, text.as_bytes(), &limits).expect("within");
        let mesh = file.to_exact(ReadAs::Decimal).unwrap();
        let y = &mesh.points[0].y;
        assert!(y.numerator().bits() > 3_000_000 || y.denominator().bits() > 3_000_000);
        let fewer = Limits { digits: 999_999, ..limits };
        assert!(read_bytes_within("test", *format, text.as_bytes(), &fewer).is_err());
    }
}

#[test]
fn words_that_fit_no_header_line_are_no_notes() {
    // A file with such a comment could be read, but not be converted.
    let text = b"# isogeo: co\x9crds=exact a=b c=\xc3\xa9 d=\x01 =e f=\n\
        v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let file = read_bytes("test", Format::Obj, text).unwrap();
    assert_eq!(file.notes, [("a".to_owned(), "b".to_owned())].into());
    let mesh = file.to_exact(ReadAs::Decimal).unwrap();
    let options = Options { notes: file.notes, ..Options::default() };
    assert!(write_string("test", Format::Obj, &mesh, &options).is_ok());
}

#[test]
fn formats_by_name() {
    for (name, format) in [
        ("a.obj", Some(Format::Obj)),
        ("b/A.OBJ", Some(Format::Obj)),
        ("x.Off", Some(Format::Off)),
        ("x.ply", Some(Format::Ply)),
        ("x.iso.json", Some(Format::IsoJson)),
        ("x.JSON", Some(Format::IsoJson)),
        ("x.vtu", Some(Format::Vtu)),
        ("x.stl", None),
        ("obj", None),
        ("", None),
    ] {
        assert_eq!(Format::from_path(name), format, "{name}");
    }
    assert_eq!(&*read("x.stl").unwrap_err().code, "isogeo::file::format");
    assert_eq!(&*read("no/such/file.obj").unwrap_err().code, "isogeo::file::io");
    assert_eq!(&*parse(Format::Vtu, "").unwrap_err().code, "isogeo::vtu::format");
}

#[test]
fn a_file_appears_whole_or_not_at_all() {
    let folder = std::env::temp_dir().join(format!("isogeo-files-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("mesh.obj");
    let mesh = mixed(&q(1, 2));
    for _ in 0..2 {
        assert_eq!(write(&path, &mesh, &Options::default()).unwrap(), Written::Exact);
    }
    assert_eq!(read(&path).unwrap().to_exact(ReadAs::Decimal).unwrap(), mesh);
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 1, "no temporary file is left");
    let longest = folder.join("m".repeat(251) + ".obj");
    assert_eq!(write(longest, &mesh, &Options::default()).unwrap(), Written::Exact);
    let error = write(folder.join("no/such.obj"), &mesh, &Options::default()).unwrap_err();
    assert_eq!(&*error.code, "isogeo::file::io");
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn cleared_denominators_keep_the_unit_sphere() {
    // 1155 = 3·5·7·11; z needs 2 · 3², a half of which is 2 · 3.
    let point = |x, y, z| Point::new(x, y, z);
    let points = vec![
        point(q(1, 7), q(2, 11), q(5, 18)),
        point(q(1, 5), q(0, 1), q(1, 49)),
        point(q(1, 1), q(-3, 5), q(1, 125)),
    ];
    let mut faces = FaceList::new();
    faces.push([0, 1, 2]);
    let mesh = Mesh::new(points, faces).unwrap();
    let cleared = clear_denominators(&mesh).unwrap();
    // 7 · 11 for x and y; 2 · 3 for 18; 5² for 125.
    assert_eq!(cleared.xy_scale.to_string(), (7 * 11 * 6 * 25).to_string());
    assert_eq!(&cleared.xy_scale * &cleared.xy_scale, cleared.z_scale);
    for (p, c) in mesh.points.iter().zip(&cleared.mesh.points) {
        let back = |c: &Rational, scale: &isogeo::scalar::BigInt| {
            assert_eq!(c.denominator(), 1.into());
            c / Rational::from_fraction(scale.clone(), 1.into()).unwrap()
        };
        let (xy, z) = (&cleared.xy_scale, &cleared.z_scale);
        assert_eq!(*p, Point::new(back(&c.x, xy), back(&c.y, xy), back(&c.z, z)));
    }
    let options = Options { notes: cleared.notes(), ..Options::default() };
    let (text, written) = write_string("test", Format::Obj, &cleared.mesh, &options).unwrap();
    assert_eq!(written, Written::Exact);
    let header = "# isogeo: coords=exact xy_scale=11550 z_scale=133402500\n";
    assert!(text.starts_with(header), "{text}");
    let file = parse(Format::Obj, &text).unwrap();
    assert_eq!(file.to_exact(ReadAs::Decimal).unwrap(), cleared.mesh);
    assert_eq!(file.notes["z_scale"], "133402500");
}

#[test]
fn large_primes_are_cleared_too() {
    let p = 1_000_003;
    let mesh = |z| Mesh::new(vec![Point::new(q(1, 2), q(0, 1), z)], FaceList::new()).unwrap();
    for (z, scale) in [(q(1, p * p), 2 * p), (q(1, p), 2 * p), (q(1, p * p * p), 2 * p * p)] {
        assert_eq!(clear_denominators(&mesh(z)).unwrap().xy_scale, scale.into());
    }
}

#[test]
fn digits() {
    let numbers = [
        q(0, 1),
        q(1, 3),
        q(-2, 3),
        q(1, 2),
        q(999_999, 1000),
        q(123_456_789, 1),
        q(1, 123_456_789_000),
        q(12_345, 1),
        q(1_000_015, 10),
        q(1_000_025, 10),
        q(-5, 1),
        q(99_999_950_001, 100_000),
    ];
    let mut out = String::new();
    for x in numbers {
        let mesh =
            Mesh::new(vec![Point::new(x.clone(), q(0, 1), q(0, 1))], FaceList::new()).unwrap();
        let options = Options { digits: std::num::NonZero::new(6), ..Options::default() };
        let (text, written) = write_string("test", Format::Obj, &mesh, &options).unwrap();
        assert_eq!(text.contains("coords=exact"), written == Written::Exact);
        let line = text.lines().last().unwrap();
        writeln!(out, "{x} -> {line} {written:?}").unwrap();
    }
    insta::assert_snapshot!("digits", out);
}

#[test]
fn notes_must_fit_their_line() {
    let mesh = mixed(&q(1, 1));
    for (key, value) in [("a b", "c"), ("a", "b\nv 0 0 0"), ("a=b", "c"), ("", "c")] {
        let notes = [(key.to_owned(), value.to_owned())].into();
        let options = Options { notes, ..Options::default() };
        let error = write_string("test", Format::Obj, &mesh, &options).unwrap_err();
        assert_eq!(&*error.code, "isogeo::obj::data", "{error}");
    }
}

/// Small valid files of every format that is read.
fn seeds() -> Vec<(Format, Vec<u8>)> {
    let mut mesh = mixed(&q(1, 8));
    mesh.data.face.insert("K".into(), vec![q(1, 3); 3]);
    let mut seeds: Vec<_> = [Format::Obj, Format::Off, Format::Ply, Format::IsoJson]
        .map(|format| {
            let (text, _) = write_string("seed", format, &mesh, &Options::default()).unwrap();
            (format, text.into_bytes())
        })
        .into();
    seeds.push((Format::Ply, PLY.into()));
    seeds.push((Format::Ply, binary_ply(true)));
    seeds.push((Format::Ply, binary_ply(false)));
    seeds
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn no_bytes_make_a_reader_panic(
        seed in 0..7usize,
        cut in any::<prop::sample::Index>(),
        whole in any::<bool>(),
        changes in prop::collection::vec(
            (any::<prop::sample::Index>(), 0..3u8, prop_oneof![any::<u8>(), prop::sample::select(&b" \n\r\\#/\"-.e0951[]{},"[..])]),
            0..6,
        ),
    ) {
        let (format, mut bytes) = seeds().swap_remove(seed);
        if !whole {
            bytes.truncate(cut.index(bytes.len() + 1));
        }
        for (at, change, byte) in changes {
            let at = at.index(bytes.len() + 1);
            match change {
                0 => bytes.insert(at, byte),
                1 if at < bytes.len() => bytes[at] = byte,
                _ if at < bytes.len() => { bytes.remove(at); }
                _ => {}
            }
        }
        match read_bytes("mutated", format, &bytes) {
            Ok(file) => { let _ = file.to_exact(ReadAs::Double); }
            Err(error) => {
                prop_assert!(error.code.starts_with("isogeo::"));
                if let Some(place) = &error.place {
                    prop_assert!(place.span.end <= bytes.len() && place.line > 0 && place.column > 0);
                }
            }
        }
    }
}
