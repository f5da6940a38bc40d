//! Verdicts and exit codes belong to the surface, not to its labels, place or scale.

use isogeo::mesh::file::{Options, read, write};
use isogeo::mesh::{FaceList, Mesh};
use isogeo::scalar::{Field, Rational, ReadAs};
use isogeo::space::Point;
use serde_json::Value;

use super::shell::Shell;

const PROPERTIES: [&str; 4] = ["planar", "i-circular", "i-conical", "delaunay"];

/// Exit codes, and of every property the verdict with its counts.
fn verdicts(shell: &Shell, file: &str, options: &[&str]) -> (i32, Vec<[Value; 5]>) {
    let names = PROPERTIES.join(",");
    let arguments = [&["check", file, "--is", &names, "--format", "json"], options].concat();
    let run = shell.run(&arguments);
    let report = run.json();
    let properties = report["properties"].as_array().expect("a report").iter();
    let keys = ["property", "verdict", "checked", "failed", "undefined"];
    (run.code, properties.map(|p| keys.map(|key| p[key].clone())).collect())
}

const SAMPLES: [&str; 6] =
    ["sigma.iso.json", "twisted.iso.json", "kite.obj", "vertical.obj", "pyramid.off", "bent.obj"];

#[test]
fn moved() {
    let shell = Shell::new();
    for file in SAMPLES {
        let before = verdicts(&shell, file, &["--read-as", "decimal"]);
        for motion in [
            ["--rotate", "-3/5,4/5", "--translate", "1/7,-2,1000001"],
            ["--shear", "-22/7,1e-3", "--rotate", "0,-1"],
            ["--translate", "1e9,-1e9,0.001", "--shear", "0,5"],
        ] {
            let arguments = [&["move", file, "-o", "moved.iso.json"], &motion[..]].concat();
            assert_eq!(shell.run(&arguments).code, 0);
            assert_eq!(verdicts(&shell, "moved.iso.json", &[]), before, "{file} {motion:?}");
        }
    }
}

#[test]
fn relabelled_turned_scaled() {
    let shell = Shell::new();
    for file in SAMPLES {
        let before = verdicts(&shell, file, &["--read-as", "decimal"]);
        let mesh: Mesh<Rational> = read(shell.path(file))
            .and_then(|file| file.to_exact(ReadAs::Decimal))
            .expect("a sample");
        for (what, mesh) in [
            ("relabelled", relabelled(&mesh)),
            ("turned", turned(&mesh)),
            ("scaled", scaled(&mesh, (3, 2), (5, 7))),
            ("reflected in z", scaled(&mesh, (1, 9), (-1, 1))),
        ] {
            write(shell.path("same.iso.json"), &mesh, &Options::default()).expect("a file");
            assert_eq!(verdicts(&shell, "same.iso.json", &[]), before, "{file} {what}");
        }
        let cleared = ["convert", file, "same.obj", "--clear-denominators"];
        assert_eq!(shell.run(&cleared).code, 0);
        assert_eq!(verdicts(&shell, "same.obj", &[]), before, "{file} cleared");
        assert_eq!(
            verdicts(&shell, "same.obj", &["--read-as", "double"]),
            before,
            "{file} cleared"
        );
    }
}

fn with_faces(
    points: Vec<Point<Rational>>,
    faces: impl Iterator<Item = Vec<u32>>,
) -> Mesh<Rational> {
    let mut list = FaceList::new();
    faces.for_each(|face| list.push(face));
    Mesh::new(points, list).expect("the same mesh")
}

fn faces(mesh: &Mesh<Rational>) -> impl DoubleEndedIterator<Item = Vec<u32>> {
    let ids: Vec<_> = mesh.topology.faces().collect();
    ids.into_iter().map(|f| mesh.topology.face(f).iter().map(|v| v.0).collect())
}

/// Vertices and faces in the opposite order.
fn relabelled(mesh: &Mesh<Rational>) -> Mesh<Rational> {
    let last = mesh.points.len() as u32 - 1;
    let renamed = |face: Vec<u32>| face.into_iter().map(|v| last - v).collect();
    with_faces(mesh.points.iter().rev().cloned().collect(), faces(mesh).rev().map(renamed))
}

/// Every face with another first corner.
fn turned(mesh: &Mesh<Rational>) -> Mesh<Rational> {
    let turn = |(i, mut face): (usize, Vec<u32>)| {
        let n = face.len();
        face.rotate_left((i + 1) % n);
        face
    };
    with_faces(mesh.points.clone(), faces(mesh).enumerate().map(turn))
}

fn scaled(mesh: &Mesh<Rational>, xy: (i64, i64), z: (i64, i64)) -> Mesh<Rational> {
    let [xy, z] = [xy, z].map(|(p, q)| Rational::from_ratio(p, q));
    let scale = |p: &Point<Rational>| Point::new(&p.x * &xy, &p.y * &xy, &p.z * &z);
    with_faces(mesh.points.iter().map(scale).collect(), faces(mesh))
}
