//! `isogeo triangulate` and `isogeo accuracy` as users see them.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use isogeo::mesh::file::{self, read_points_bytes};

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("triangulate").join(name);
    fs::create_dir_all(&folder).expect("a folder for the test");
    folder
}

/// Output, errors and exit code of the program.
fn run(folder: &Path, arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_isogeo"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .expect("the program runs");
    format!(
        "$ isogeo {}\n{}{}exit {}\n\n",
        arguments.join(" "),
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr),
        output.status.code().unwrap_or(-1),
    )
}

const SURVEY: &str = "\
# a survey\r
east; north; height\r
0; 0; 1.5\r
1; 0; 0.1\r
1; 1; 2e-1\r
0; 1; 0\r
0.5; 2; 1 # the top\r
";

#[test]
fn samples_become_meshes() {
    let folder = folder("samples");
    fs::write(folder.join("survey.csv"), SURVEY).unwrap();
    fs::write(folder.join("places.txt"), "0 0\n2 0\n\n0 2 77\n".replace(" 77", "")).unwrap();
    let mut report = String::new();
    for arguments in [
        &["triangulate", "survey.csv", "-o", "survey.iso.json"][..],
        &["check", "survey.iso.json", "--is", "delaunay"],
        &[
            "triangulate",
            "survey.csv",
            "--read-as",
            "double",
            "-o",
            "doubles.iso.json",
            "--format",
            "json",
        ],
        &["triangulate", "--sample", "x^2/3 - y", "--at", "places.txt", "-o", "graph.iso.json"],
        &["triangulate", "--sample", "-sin(x)", "--at", "survey.csv", "-o", "wave.iso.json"],
        &[
            "triangulate",
            "--sample",
            "exp(x)",
            "--at",
            "survey.csv",
            "-o",
            "e.obj",
            "--format",
            "json",
        ],
    ] {
        report += &run(&folder, arguments);
    }
    insta::assert_snapshot!("triangulated", report);
    let written = |name: &str| fs::read_to_string(folder.join(name)).unwrap();
    insta::assert_snapshot!("survey", written("survey.iso.json"));
    assert!(written("graph.iso.json").contains("\"4/3\""));
    let third = "3602879701896397/36028797018963968";
    assert!(written("doubles.iso.json").contains(third), "0.1 as a double");
    assert!(file::read(folder.join("wave.iso.json")).is_ok());
}

#[test]
fn bad_input_is_explained() {
    let folder = folder("bad");
    for (name, text) in [
        ("twice.txt", "0 0 1\n1 0 1\n0 1 1\n1 0 2\n"),
        ("line.txt", "0 0 1\n1 1 1\n2 2 1\n"),
        ("two.txt", "0 0 1\n1 1 1\n"),
        ("flat.txt", "0 0\n1 1\n0 1\n"),
        ("word.csv", "0,0,1\n1,zero,1\n"),
        ("four.txt", "0 0 1 4\n"),
        ("mixed.txt", "0 0 1\n1 1\n"),
        ("empty.txt", "# nothing\n"),
    ] {
        fs::write(folder.join(name), text).unwrap();
    }
    let mut report = String::new();
    for name in [
        "twice.txt",
        "line.txt",
        "two.txt",
        "flat.txt",
        "word.csv",
        "four.txt",
        "mixed.txt",
        "empty.txt",
    ] {
        report += &run(&folder, &["triangulate", name, "-o", "out.obj"]);
    }
    for arguments in [
        &["triangulate", "--sample", "x + (y", "--at", "flat.txt", "-o", "out.obj"][..],
        &["triangulate", "--sample", "1/x", "--at", "flat.txt", "-o", "out.obj"],
        &["triangulate", "flat.txt", "--read-as", "rounded", "-o", "out.obj"],
        &["accuracy", "x*z"],
        &["accuracy", "x*y", "--class", "regular"],
        &["accuracy", "x*y", "--sizes", "2"],
        &["triangulate", "word.csv", "-o", "out.obj", "--format", "json"],
    ] {
        report += &run(&folder, arguments);
    }
    insta::assert_snapshot!("refused", report);
    assert!(!folder.join("out.obj").exists());
}

#[test]
fn accuracy_is_a_table() {
    let folder = folder("accuracy");
    let text = run(&folder, &["accuracy", "x^4/12 + y^2/2 + x*y^3/6", "--sizes", "4,8,16"]);
    insta::assert_snapshot!("accuracy", text);
    let json = run(
        &folder,
        &["accuracy", "x*y", "--class", "union-jack", "--sizes", "4,8", "--format", "json"],
    );
    insta::assert_snapshot!("accuracy_json", json);
}

#[test]
fn point_files_of_all_kinds_are_read() {
    for text in [
        "0 0 1\n2 1 5\n",
        "\u{feff}x,y,z\r\n0,0,1\r\n2,1,5",
        "0\t0\t1\r2\t1\t5\r",
        "# a\n\n 0;0 ; 1\n2 1 5 # b",
    ] {
        let file =
            read_points_bytes("p", text.as_bytes()).unwrap_or_else(|e| panic!("{text:?}: {e}"));
        let points = file.points().expect("heights");
        let values: Vec<f64> =
            points.iter().flat_map(|p| [&p.x, &p.y, &p.z]).map(|c| c.nearest_f64()).collect();
        assert_eq!(values, [0.0, 0.0, 1.0, 2.0, 1.0, 5.0], "{text:?}");
    }
    // A header only before the first number, and not where one word is a number.
    assert!(read_points_bytes("p", b"0 0 1\nx y z\n").is_err());
    assert!(read_points_bytes("p", b"x 1 z\n0 0 1\n").is_err());
}
