//! The examples run, and what they made is what the repository holds.

#[path = "../../examples/delaunay_gauss_image.rs"]
mod delaunay_gauss_image;
#[path = "../../examples/shell.rs"]
mod shell;
#[path = "../../examples/your_identity.rs"]
mod your_identity;

use std::fs;
use std::path::Path;

#[test]
fn the_shipped_meshes_are_those_that_the_example_makes() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("shell");
    fs::create_dir_all(&folder).expect("a folder for the test");
    shell::write_all(&folder).expect("the example runs");
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("meshes");
    for name in ["shell.iso.json", "shell-spoilt.iso.json", "shell.obj"] {
        let read = |folder: &Path| fs::read_to_string(folder.join(name)).expect(name);
        assert!(read(&folder) == read(&shipped), "{name}: cargo run --example shell -- meshes");
    }
}

#[test]
fn samples_become_curvatures() {
    let report = delaunay_gauss_image::report().expect("the example runs");
    insta::assert_snapshot!(report);
}

#[test]
fn an_identity_of_your_own_holds() {
    your_identity::holds();
}
