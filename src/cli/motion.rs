//! `isogeo move`: isotropic motions.

use super::arguments::{Layout, MoveOptions};
use super::failure::Failure;
use super::numbers::numbers;
use super::{Status, input, output};
use crate::mesh::file::Options;
use crate::scalar::Rational;
use crate::space::{Motion, Rotation, Transform, Vector2, Vector3};

/// Moves the mesh and writes it.
pub fn run(options: &MoveOptions, layout: Layout) -> Result<Status, Failure> {
    let mut motion = Motion::<Rational>::identity();
    if let Some(text) = &options.rotate {
        let [c, s] = numbers("--rotate", text)?;
        motion.rotation = Rotation::new(c, s).map_err(|error| {
            Failure::with_help(
                format!("--rotate {text}: {error}"),
                "give the cosine and sine exactly, such as 3/5,4/5 or 0,1",
            )
        })?;
    }
    if let Some(text) = &options.shear {
        let [x, y] = numbers("--shear", text)?;
        motion.shear = Vector2 { x, y };
    }
    if let Some(text) = &options.translate {
        let [x, y, z] = numbers("--translate", text)?;
        motion.translation = Vector3 { x, y, z };
    }
    let input = input::read(&options.input)?;
    let moved = motion.apply(&input.exact());
    let write = Options { rounded: input.is_inexact(), ..Options::default() };
    output::write(&options.output.output, &moved, &write, layout)?;
    Ok(Status::Proved)
}
