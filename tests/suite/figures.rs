//! Figures: the painter's order against a z-buffer, files against what is committed.

use isogeo::figure::draw::{
    Color, Item, Model, Paint, Piece, Scene, Stroke, View, painted, svg, tikz,
};
use isogeo::figure::{Figure, Kind, Plate};
use isogeo::mesh::VertexId;
use isogeo::net::Property;
use isogeo::pair::{Curvatures, FParallel, PairProperty, VParallel};
use isogeo::scalar::{Rational, Ring};
use serde_json::{Value, json};

const INK: Stroke = Stroke::new(Color::INK, 0.1);

fn triangle(corners: [[f64; 3]; 3], color: u8) -> Piece {
    let paint = Paint::Flat(Color([color, 0, 0]));
    Piece::Face { corners: corners.to_vec(), drawn: vec![true; 3], paint, stroke: INK }
}

/// Numbers in 0..1 that repeat.
fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as f64 / (1u64 << 31) as f64
    }
}

fn inside(corners: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let side = |i: usize| {
        let ([a, b], [c, d]) = (corners[i], corners[(i + 1) % corners.len()]);
        (c - a) * (y - b) - (d - b) * (x - a)
    };
    let sides: Vec<f64> = (0..corners.len()).map(side).collect();
    sides.iter().all(|s| *s > 0.0) || sides.iter().all(|s| *s < 0.0)
}

/// The colour that is painted last over a place.
fn on_top(items: &[Item], at: [f64; 2]) -> Option<u8> {
    items.iter().rev().find_map(|item| match item {
        Item::Polygon { corners, fill: Some(color), .. } if inside(corners, at) => Some(color.0[0]),
        _ => None,
    })
}

/// The colour of the nearest triangle over a place, and by how much it is nearer than the next.
fn nearest(model: &Model, view: &View, at: [f64; 2]) -> Option<(u8, f64)> {
    let mut hits: Vec<(f64, u8)> = Vec::new();
    for piece in &model.pieces {
        let Piece::Face { corners, paint: Paint::Flat(color), .. } = piece else { continue };
        let flat: Vec<[f64; 2]> = corners.iter().map(|p| view.project(*p)).collect();
        if !inside(&flat, at) {
            continue;
        }
        let [a, b, c] = [flat[0], flat[1], flat[2]];
        let area = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
            (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
        };
        let whole = area(a, b, c);
        let weights = [area(at, b, c) / whole, area(a, at, c) / whole, area(a, b, at) / whole];
        let depth: f64 = (0..3).map(|i| weights[i] * view.depth(corners[i])).sum();
        hits.push((depth, color.0[0]));
    }
    hits.sort_by(|a, b| b.0.total_cmp(&a.0));
    let second = hits.get(1).map_or(f64::INFINITY, |hit| hits[0].0 - hit.0);
    hits.first().map(|hit| (hit.1, second))
}

/// Compares picture and z-buffer on a raster; gives how many places were looked at.
fn compare(model: &Model, view: &View, items: &[Item]) -> Result<usize, String> {
    let mut seen = 0;
    for i in 0..60 {
        for j in 0..60 {
            let at = [(f64::from(i) + 0.37) / 20.0 - 1.5, (f64::from(j) + 0.41) / 20.0 - 1.5];
            let Some((color, gap)) = nearest(model, view, at) else { continue };
            // Where two sheets meet, either may be on top.
            if gap < 1.0 / 1024.0 {
                continue;
            }
            seen += 1;
            if on_top(items, at) != Some(color) {
                return Err(format!(
                    "{at:?}: {color} is nearest, {:?} is on top",
                    on_top(items, at)
                ));
            }
        }
    }
    Ok(seen)
}

fn pierced(seed: u64) -> Model {
    let mut next = numbers(seed);
    let mut point = || [(); 3].map(|()| 2.0 * next() - 1.0);
    let triangles = (0..40).map(|n| triangle([point(), point(), point()], n));
    Model { pieces: triangles.collect() }
}

#[test]
fn what_is_nearer_is_painted_later() -> Result<(), String> {
    for seed in 0..12 {
        let model = pierced(seed);
        let view = View::from([3.0, -5.0, 3.0]);
        let seen = compare(&model, &view, &painted(&model, &view))
            .map_err(|why| format!("seed {seed}: {why}"))?;
        assert!(seen > 500, "seed {seed}: {seen} places");
    }
    Ok(())
}

/// The graph of a wave that hides itself, its highest line marked.
fn wave() -> Model {
    let at = |i: i32, j: i32| {
        let (x, y) = (f64::from(i) / 5.0 - 1.1, f64::from(j) / 5.0 - 1.1);
        [x, y, (1.0 - 3.0 * y * y) * y * y * 2.0 + x / 4.0]
    };
    let mut model = Model::default();
    for (i, j) in (0..11).flat_map(|i| (0..11).map(move |j| (i, j))) {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        for corners in [[a, b, c], [a, c, d]] {
            model.pieces.push(triangle(corners, model.pieces.len() as u8));
        }
    }
    model.add_line((0..12).map(|i| at(i, 3)), INK);
    model
}

#[test]
fn what_goes_through_nothing_is_painted_whole() -> Result<(), String> {
    for viewer in [[3.0, -5.0, 3.0], [1.0, -5.0, 1.0], [-1.0, 4.0, 2.0], [0.0, -1.0, 4.0]] {
        let (model, view) = (wave(), View::from(viewer));
        let items = painted(&model, &view);
        assert_eq!(items.len(), model.pieces.len());
        assert!(compare(&model, &view, &items)? > 300);
        // No face that has an edge on the marked line is painted after it.
        for (number, item) in items.iter().enumerate() {
            let Item::Polyline { points, .. } = item else { continue };
            let covers = |item: &Item| {
                matches!(item, Item::Polygon { corners, .. }
                if points.iter().all(|p| corners.contains(p)))
            };
            let places = items.iter().enumerate().filter(|(_, item)| covers(item));
            assert_eq!(places.clone().count(), 2);
            assert!(places.map(|(place, _)| place).max() < Some(number), "{viewer:?}");
        }
    }
    Ok(())
}

#[test]
fn the_raster_notices_a_wrong_order() {
    let model = pierced(1);
    let view = View::from([3.0, -5.0, 3.0]);
    let mut items = painted(&model, &view);
    items.reverse();
    assert!(compare(&model, &view, &items).is_err());
}

#[test]
fn a_scene_is_the_same_picture_in_every_format() {
    let mut scene = Scene::new(40.0, 20.0);
    let circle = Item::Circle { center: [0.0, 0.0], radius: 1.0, fill: None, stroke: Some(INK) };
    let corners = vec![[-1.0, -1.0], [1.0, -1.0], [0.0, 1.0]];
    let polygon = Item::Polygon { corners, fill: Some(Color::FRONT), stroke: None };
    assert_eq!(scene.place(vec![polygon, circle], [1.0, 1.0], [38.0, 18.0]), 9.0);
    scene.text([20.0, 1.0], 3.0, isogeo::figure::draw::Anchor::Middle, "2H² & K < 0_1");
    insta::assert_snapshot!(format!("{}\n{}", svg(&scene, "a < b"), tikz(&scene)));
}

#[test]
fn a_figure_that_says_something_false_is_refused() {
    for figure in &Figure::ALL {
        let plate = figure.plate().unwrap_or_else(|why| panic!("figure {}: {why}", figure.number));
        for exhibit in &plate.exhibits {
            let says = exhibit.holds.len() + exhibit.with.len() + exhibit.shown.len();
            let topology = &exhibit.mesh.topology;
            let vertex = topology.interior_vertices().next().unwrap_or(VertexId(0));
            let mut wrong = exhibit.clone();
            wrong.mesh.points[vertex.index()].z += &Rational::from_i64(1);
            let verdict = wrong.check(&plate.exhibits);
            assert_eq!(verdict.is_err(), says > 0, "figure {}, {}", figure.number, exhibit.name);
        }
    }
}

#[test]
fn the_refusal_names_what_is_wrong() {
    let plate = Figure::ALL.iter().find(|f| f.number == 8).and_then(|f| f.plate().ok());
    let plate = plate.expect("figure 8");
    let bent = plate.exhibits[0].clone().is(&[Property::Inscribed]);
    let found = bent.check(&plate.exhibits).map_err(|what| what.to_string());
    assert_eq!(found, Err("enneper: inscribed is refuted".into()));
    let alone = plate.exhibits[0].clone().with("nobody", &[PairProperty::Parallel]);
    let found = alone.check(&plate.exhibits).map_err(|what| what.to_string());
    assert_eq!(found, Err("enneper: parallel is vacuous".into()));
    let flat = plate.exhibits[0].clone().shows("flat", |m| m.points.iter().all(|p| p.z.is_zero()));
    let found = flat.check(&plate.exhibits).map_err(|what| what.to_string());
    assert_eq!(found, Err("enneper: flat is refuted".into()));
}

/// The facts of a figure, as they are written.
fn facts(number: u8) -> (Plate, Value) {
    let figure = Figure::ALL.iter().find(|f| f.number == number).expect("a figure");
    let plate = figure.plate().expect("a plate");
    let (_, text) = figure.files(&plate, Kind::Json).expect("files").pop().expect("the facts");
    (plate, serde_json::from_slice(&text).expect("JSON"))
}

#[test]
fn facts_give_the_curvatures_of_pairs() {
    let mut found = Vec::new();
    for number in 1..=11 {
        let (plate, facts) = facts(number);
        for (exhibit, facts) in
            plate.exhibits.iter().zip(facts["meshes"].as_array().expect("meshes"))
        {
            let list = &facts["curvatures"];
            assert_eq!(exhibit.gauss.is_some(), list.is_object(), "{}", exhibit.name);
            let Some(gauss) = exhibit.gauss else { continue };
            let image = plate.exhibits.iter().find(|e| e.name == gauss).expect("an image");
            let (mesh, image, at) =
                (&exhibit.mesh, &image.mesh, list["at"].as_str().expect("a place"));
            // By the definitions, on a pair that checks itself.
            let expected: Vec<_> = if at == "faces" {
                let pair = FParallel::new(mesh, image).expect("a pair");
                let all = mesh
                    .topology
                    .faces()
                    .map(|f| pair.face_curvatures(f).map_err(|e| e.to_string()));
                all.collect()
            } else {
                let pair = VParallel::new(mesh, image).expect("a pair");
                let all = (0..mesh.points.len() as u32).map(VertexId);
                all.map(|v| pair.vertex_curvatures(v).map_err(|e| e.to_string())).collect()
            };
            let values = list["values"].as_array().expect("values");
            assert_eq!(values.len(), expected.len());
            for (value, expected) in values.iter().zip(&expected) {
                match expected {
                    Ok(Curvatures { mean, gauss }) => {
                        assert_eq!(
                            (&value["H"], &value["K"]),
                            (&json!(mean.to_string()), &json!(gauss.to_string()))
                        );
                    }
                    Err(reason) => assert_eq!(value["undefined"], json!(reason)),
                }
            }
            let defined = values.iter().filter(|v| v["H"].is_string()).count();
            found.push(format!("{number} {} {at} {defined}/{}", exhibit.name, values.len()));
        }
    }
    insta::assert_snapshot!(found.join("\n"));
}

#[test]
fn the_diagrams_of_figure_11_show_its_facts() {
    let (plate, facts) = facts(11);
    let values = facts["meshes"][0]["curvatures"]["values"].as_array().expect("values");
    for (name, key) in [("mean-curvature", "H"), ("curvature", "K")] {
        let diagram = &plate.exhibits.iter().find(|e| e.name == name).expect("a diagram").mesh;
        let heights: Vec<String> = diagram.points.iter().map(|p| p.z.to_string()).collect();
        let listed: Vec<&str> = values.iter().filter_map(|v| v[key].as_str()).collect();
        assert_eq!(heights, listed);
    }
}

#[test]
fn figures_come_in_the_order_of_the_paper() {
    let numbers: Vec<u8> = Figure::ALL.iter().map(|figure| figure.number).collect();
    assert_eq!(numbers, (1..=11).collect::<Vec<u8>>());
    let unknown = |id: &&str| isogeo::claim::claim(id).is_none();
    for figure in &Figure::ALL {
        assert!(!figure.claims.is_empty(), "figure {} illustrates nothing", figure.number);
        let ghosts: Vec<&str> = figure.claims.iter().copied().filter(unknown).collect();
        assert_eq!(ghosts, [""; 0], "figure {}", figure.number);
    }
}

#[test]
fn few_faces_are_cut() {
    // Of these 154 hexagons only those at the gap of the left mesh go through each other.
    let plate = Figure::ALL.iter().find(|f| f.number == 10).and_then(|f| f.plate().ok());
    let items = plate.expect("figure 10").scene.items;
    let pieces = items.iter().filter(|item| matches!(item, Item::Polygon { .. })).count();
    assert!((154..200).contains(&pieces), "{pieces} pieces");
}

#[test]
#[cfg(feature = "cli")]
fn no_figure_drifts() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let run = |out: &std::path::Path| {
        let output = std::process::Command::new(env!("CARGO_BIN_EXE_isogeo"))
            .args(["figure", "all", "--check", "--as", "json,svg", "--out"])
            .arg(out)
            .output()
            .expect("the program runs");
        (output.status.code(), String::from_utf8_lossy(&output.stdout).into_owned())
    };
    let (code, text) = run(&root.join("paper_figures"));
    assert_eq!(code, Some(0), "{text}");
    let (code, text) = run(&std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("no-figures"));
    assert_eq!(code, Some(1));
    assert!(text.contains("fig-08.svg: is not there"), "{text}");
}
