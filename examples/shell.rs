//! Makes the meshes that the repository ships: an i-circular shell, exactly, a copy with one spoilt
//! coordinate, and the same shell as a modelling tool would print it.
//!
//! `cargo run --example shell -- meshes` writes `shell.iso.json`, `shell-spoilt.iso.json` and
//! `shell.obj`.

use std::error::Error;
use std::num::NonZeroU16;
use std::path::Path;

use isogeo::construct::{moebius_image, translational_net};
use isogeo::mesh::Mesh;
use isogeo::mesh::file::{Options, write};
use isogeo::scalar::{Field, Rational};
use isogeo::space::{Circle, CylindricalSphere, MoebiusTransformation, TopView};

/// A translational net `z = f(x) + g(y)` over a square grid, which is i-circular, and its image
/// under the inversion `p ↦ c + 36 (p − c)/|p' − c'|²`, which keeps circles of the top view and planes
/// of circles: i-circular again, no longer i-conical.
pub fn shell() -> Result<Mesh<Rational>, Box<dyn Error>> {
    let number = |p, q| Rational::from_ratio(p, q);
    // An arch along x and a wave along y.
    let arch: Vec<_> = (-6..=6).map(|i| (number(i, 2), number(36 - i * i, 24))).collect();
    let wave: Vec<_> = (-8..=8).map(|j| (number(j, 2), number(j * j * j - 48 * j, 480))).collect();
    let net = translational_net(&arch, &wave)?;
    let circle = Circle::new(TopView::new(number(-17, 2), number(3, 1)), number(36, 1));
    let cylinder = CylindricalSphere::new(circle)?;
    let inversion = MoebiusTransformation::inversion_at_cylinder(&cylinder, &number(0, 1));
    Ok(moebius_image(&net, &inversion)?)
}

/// The shell with the height of vertex 100 raised by a millionth.
pub fn spoilt(mut shell: Mesh<Rational>) -> Mesh<Rational> {
    shell.points[100].z += &Rational::from_ratio(1, 1_000_000);
    shell
}

/// Writes the three files into a folder.
pub fn write_all(folder: &Path) -> Result<(), Box<dyn Error>> {
    let shell = shell()?;
    let six = Options { digits: NonZeroU16::new(6), ..Options::default() };
    write(folder.join("shell.iso.json"), &shell, &Options::default())?;
    write(folder.join("shell.obj"), &shell, &six)?;
    write(folder.join("shell-spoilt.iso.json"), &spoilt(shell), &Options::default())?;
    Ok(())
}

#[allow(dead_code, reason = "the tests call `write_all` themselves")]
fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).ok_or("usage: shell FOLDER")?;
    write_all(Path::new(&folder))
}
