//! How many meshes are parallel, and v-parallel, to those in files: the dimensions of the two linear
//! spaces, exactly.
//!
//! `cargo run --example parallel_meshes -- meshes/shell.iso.json` prints the name of each file, the
//! dimension of its parallel meshes, translations included, and that of the v-parallel ones.

use std::error::Error;

use isogeo::mesh::file::read;
use isogeo::pair::linear_space::{parallel_space, v_parallel_space};
use isogeo::scalar::ReadAs;

fn main() -> Result<(), Box<dyn Error>> {
    for path in std::env::args().skip(1) {
        let mesh = read(&path)?.to_exact(ReadAs::Decimal)?;
        let [parallel, v_parallel] =
            [parallel_space(&mesh).dimension(), v_parallel_space(&mesh).dimension()];
        println!("{path} {parallel} {v_parallel}");
    }
    Ok(())
}
