//! `isogeo move`: isotropic motions.

use super::arguments::{Layout, MoveOptions};
use super::failure::Failure;
use super::{Status, input, output};
use crate::mesh::file::{Options, parse_fraction};
use crate::scalar::{Numeral, Rational};
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
    let write = Options { rounded: input.is_rounded(), ..Options::default() };
    output::write(&options.output.output, &moved, &write, layout)?;
    Ok(Status::Proved)
}

/// As many numbers as there are places: integers, decimals or fractions.
fn numbers<const N: usize>(option: &str, text: &str) -> Result<[Rational; N], Failure> {
    let number = |part: &str| {
        let decimal = part.parse::<Numeral>().ok().map(|n| n.value());
        decimal.or_else(|| parse_fraction(part).ok())
    };
    let numbers: Option<Vec<Rational>> = text.split(',').map(|p| number(p.trim())).collect();
    numbers.and_then(|n| n.try_into().ok()).ok_or_else(|| {
        Failure::with_help(
            format!("{option} takes {N} numbers separated by commas, not '{text}'"),
            "a number is an integer, a decimal or a fraction such as -3/5",
        )
    })
}
