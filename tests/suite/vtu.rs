//! VTU files are read by the programs that they are for.

use std::fs;
use std::path::Path;
use std::process::Command;

use isogeo::figure::{Exhibit, Figure, Kind};
use isogeo::mesh::Data;
use isogeo::scalar::{Approx, Field, Rational};
use serde_json::{Value, json};

/// What a reader finds in files: points, faces and arrays, as one line of JSON each; doubles by their
/// bits.
const MESHIO: &str = r#"
import json, sys, meshio, numpy
bits = lambda values: numpy.asarray(values).view("uint64").tolist()
for name in sys.argv[1:]:
    mesh = meshio.read(name)
    faces = [face.tolist() for block in mesh.cells for face in block.data]
    vertex = {name: bits(values) for name, values in mesh.point_data.items()}
    face = {name: bits(numpy.concatenate(blocks)) for name, blocks in mesh.cell_data.items()}
    print(json.dumps([bits(mesh.points), faces, vertex, face]))
"#;
const PYVISTA: &str = r#"
import json, sys, pyvista, numpy
bits = lambda values: numpy.asarray(values).view("uint64").tolist()
for name in sys.argv[1:]:
    mesh = pyvista.read(name)
    faces = [mesh.get_cell(i).point_ids for i in range(mesh.n_cells)]
    vertex, face = [{name: bits(data[name]) for name in data.keys()} for data in (mesh.point_data, mesh.cell_data)]
    print(json.dumps([bits(mesh.points), faces, vertex, face]))
"#;

/// What it has to find.
fn expected(exhibit: &Exhibit) -> Value {
    let mesh = &exhibit.mesh;
    let bits = |x: &Rational| x.to_f64().to_bits();
    let points = mesh.points.iter().map(|p| p.coordinates().map(bits));
    let corners = |f| mesh.topology.face(f).iter().map(|v| v.0).collect::<Vec<_>>();
    let named = |data: &Data<Rational>| {
        [&data.vertex, &data.face].map(|arrays| {
            let pairs = arrays
                .iter()
                .map(|(name, values)| (name.clone(), values.iter().map(bits).collect::<Value>()));
            pairs.collect::<serde_json::Map<String, Value>>()
        })
    };
    let [vertex, face] = named(&mesh.data);
    let faces: Vec<_> = mesh.topology.faces().map(corners).collect();
    json!([points.collect::<Vec<_>>(), faces, vertex, face])
}

#[test]
fn python_reads_the_meshes_of_all_figures() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("vtu");
    let (mut names, mut meshes) = (Vec::new(), Vec::new());
    for figure in &Figure::ALL {
        let mut plate = figure.plate().expect("a plate");
        for mesh in plate.exhibits.iter_mut().map(|exhibit| &mut exhibit.mesh) {
            let thirds = (0..mesh.topology.face_count() as i64).map(|n| Rational::from_ratio(n, 3));
            mesh.data.face.insert("a < b".into(), thirds.collect());
        }
        let folder = folder.join(figure.folder());
        fs::create_dir_all(&folder).expect("a folder");
        for (name, text) in figure.files(&plate, Kind::Vtu).expect("files") {
            fs::write(folder.join(&name), text).expect("a file");
            names.push(folder.join(name));
        }
        meshes.extend(plate.exhibits.iter().map(expected));
    }
    for (reader, probe) in [("meshio", MESHIO), ("pyvista", PYVISTA)] {
        let python = |code: &str| Command::new("python3").args(["-c", code]).args(&names).output();
        if !python(&format!("import {reader}")).is_ok_and(|output| output.status.success()) {
            eprintln!("no {reader} here: it does not read the VTU files");
            continue;
        }
        let output = python(probe).expect("a run");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let text = String::from_utf8(output.stdout).expect("text");
        let found: Vec<Value> =
            text.lines().map(|l| serde_json::from_str(l).expect("JSON")).collect();
        assert_eq!(found.len(), meshes.len());
        for ((name, found), mesh) in names.iter().zip(&found).zip(&meshes) {
            assert!(found == mesh, "{reader} reads another mesh in {}", name.display());
        }
        // Two meshes of one shape are told from each other.
        assert!(found[0] != meshes[1] && meshes[0][1] == meshes[1][1]);
    }
}
