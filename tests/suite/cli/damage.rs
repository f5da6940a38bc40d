//! Damaged files: a clear error with its place, or a verdict; never a panic.

use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::{Duration, Instant};

use isogeo::check::Decider;
use isogeo::mesh::file::{Coordinates, Format, read_bytes};
use isogeo::net::{Net, Property};
use isogeo::pair::{Couple, PairProperty};
use isogeo::scalar::ReadAs;

use super::samples;

const SEED: u64 = 0x1507;
const COPIES: u64 = 200;

/// Numbers that look random, the same in every run (splitmix64).
struct Dice(u64);

impl Dice {
    fn roll(&mut self, sides: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((x ^ (x >> 31)) % sides.max(1) as u64) as usize
    }

    fn pick<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.roll(of.len())]
    }
}

/// A copy of the file with one to three injuries.
fn damaged(file: &[u8], dice: &mut Dice) -> Vec<u8> {
    let mut bytes = file.to_vec();
    for _ in 0..=dice.roll(3) {
        injure(&mut bytes, dice);
    }
    bytes
}

fn injure(bytes: &mut Vec<u8>, dice: &mut Dice) {
    let at = dice.roll(bytes.len());
    match dice.roll(11) {
        0 => bytes.truncate(at),
        1 => bytes.iter_mut().skip(at).take(1).for_each(|b| *b ^= 1 << dice.roll(8)),
        2 => lines(bytes, |lines| drop(lines.remove(at % lines.len()))),
        3 => lines(bytes, |lines| lines.insert(at % lines.len(), lines[at % lines.len()].clone())),
        4 => {
            let other = dice.roll(bytes.len());
            lines(bytes, |lines| {
                let n = lines.len();
                lines.swap(at % n, other % n);
            });
        }
        5 => bytes
            .iter_mut()
            .skip(at)
            .find(|b| b.is_ascii_digit())
            .into_iter()
            .for_each(|b| *b = b'x'),
        6 => number(bytes, at, dice.pick(&["0", "-1", "99", "-99", "4294967296", "1.5"])),
        7 => number(bytes, at, dice.pick(&HUGE)),
        8 => lines(bytes, |lines| lines.iter_mut().for_each(|line| line.push(b'\r'))),
        9 => bytes.insert(at, 0),
        _ => drop(bytes.splice(0..0, *b"\xef\xbb\xbf")),
    }
}

const HUGE: [&str; 8] = [
    "1e400",
    "-1e-400",
    "1e999999999",
    "1e99999999999999999999",
    "123456789012345678901234567890123456789012345678901234567890",
    "0.000000000000000000000000000000000000000000000000000000000001",
    "nan",
    "-inf",
];

fn lines(bytes: &mut Vec<u8>, change: impl FnOnce(&mut Vec<Vec<u8>>)) {
    let mut lines: Vec<Vec<u8>> = bytes.split(|&b| b == b'\n').map(<[u8]>::to_vec).collect();
    change(&mut lines);
    *bytes = lines.join(&b'\n');
}

/// Puts a text in the place of the first number from a place on.
fn number(bytes: &mut Vec<u8>, from: usize, text: &str) {
    let is_part = |b: &u8| b.is_ascii_digit() || b"+-.eE/".contains(b);
    if let Some(start) = (from..bytes.len()).find(|&i| bytes[i].is_ascii_digit()) {
        let length = bytes[start..].iter().take_while(|b| is_part(b)).count();
        bytes.splice(start..start + length, text.bytes());
    }
}

/// What became of damaged copies.
#[derive(Default)]
struct Tally {
    errors: usize,
    verdicts: usize,
    panics: usize,
    slowest: Duration,
    slowest_copy: u64,
    complaints: Vec<String>,
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Tally { errors, verdicts, panics, slowest, slowest_copy, .. } = self;
        write!(
            f,
            "{errors} errors, {verdicts} verdicts, {panics} panics, slowest {slowest:.1?} (copy {slowest_copy})"
        )
    }
}

fn campaign(name: &str, format: Format, file: &[u8]) -> Tally {
    let mut tally = Tally::default();
    for copy in 0..COPIES {
        let bytes = damaged(file, &mut Dice(SEED ^ (copy << 20)));
        let start = Instant::now();
        let result = catch_unwind(AssertUnwindSafe(|| judge(name, format, &bytes)));
        let time = start.elapsed();
        if time > tally.slowest {
            (tally.slowest, tally.slowest_copy) = (time, copy);
        }
        match result {
            Ok(Ok(())) => tally.verdicts += 1,
            Ok(Err(None)) => tally.errors += 1,
            Ok(Err(Some(unclear))) => {
                tally.errors += 1;
                tally.complaints.push(format!("copy {copy}: {unclear}"));
            }
            Err(_) => {
                tally.panics += 1;
                tally.complaints.push(format!("copy {copy}: panic"));
            }
        }
    }
    println!("{name}, seed {SEED:#x}: {tally}");
    tally
}

/// Reads and checks in the default reading; of an error what is unclear about it.
fn judge(name: &str, format: Format, bytes: &[u8]) -> Result<(), Option<String>> {
    let file = read_bytes(name, format, bytes).map_err(|error| {
        let is_text = !bytes.windows(6).any(|w| w == b"binary");
        let unplaced = is_text && error.place.as_deref().is_none_or(|p| p.line == 0);
        let unclear = unplaced || error.message.is_empty() || !error.code.starts_with("isogeo::");
        unclear.then(|| error.to_string())
    })?;
    let decider = match (&file.coordinates, file.default_reading()) {
        (Coordinates::Rationals(mesh), _) => Decider::of_rationals(&mesh.points),
        (Coordinates::Numerals(mesh), ReadAs::Rounded) => Decider::over_boxes(&mesh.points),
        (Coordinates::Numerals(mesh), _) => Decider::new(&mesh.points),
    };
    let net = Net::new(file.topology(), &decider);
    // A pair with the same points in the opposite order, as they are printed.
    let exact = file.to_exact(ReadAs::Decimal).ok();
    let reversed: Vec<_> =
        exact.iter().flat_map(|mesh| mesh.points.iter().rev().cloned()).collect();
    let both = decider.clone().followed_by(Decider::of_rationals(&reversed));
    let couple = Couple::new(file.topology(), file.topology(), &both).expect("the same faces");
    let mesh = Property::ALL.map(|property| net.check(property));
    let pair = PairProperty::ALL.map(|property| couple.check(property));
    for report in mesh.into_iter().chain(pair) {
        assert_eq!(report.worst.is_some(), !report.failures.is_empty());
        let defect = report.worst.map(|w| w.failure.defect);
        assert!(defect.is_none_or(|d| d.is_finite() && d > 0.0), "defect {defect:?}");
    }
    Ok(())
}

fn sample(name: &str) -> &'static [u8] {
    samples::ALL.iter().find(|(n, _)| *n == name).map_or(&[], |(_, text)| text.as_bytes())
}

/// The pyramid as PLY with little-endian doubles.
fn binary_ply() -> Vec<u8> {
    let header = "ply\nformat binary_little_endian 1.0\nelement vertex 5\nproperty double x\n\
        property double y\nproperty double z\nelement face 5\n\
        property list uchar int vertex_indices\nend_header\n";
    let points = [[-1., -1., 0.], [1., -1., 0.], [1., 1., 0.], [-1., 1., 0.], [0., 0., 1.]];
    let faces: [&[i32]; 5] = [&[3, 2, 1, 0], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]];
    let mut bytes = header.as_bytes().to_vec();
    points.iter().flatten().for_each(|x: &f64| bytes.extend(x.to_le_bytes()));
    for face in faces {
        bytes.push(face.len() as u8);
        face.iter().for_each(|v| bytes.extend(v.to_le_bytes()));
    }
    bytes
}

#[test]
fn damaged_files_are_errors_or_meshes() {
    let binary = binary_ply();
    for (name, format, bytes) in [
        ("pinched.obj", Format::Obj, sample("pinched.obj")),
        ("printed.obj", Format::Obj, sample("printed.obj")),
        ("pyramid.off", Format::Off, sample("pyramid.off")),
        ("triangle.ply", Format::Ply, sample("triangle.ply")),
        ("binary.ply", Format::Ply, &binary),
        ("sigma.iso.json", Format::IsoJson, sample("sigma.iso.json")),
    ] {
        assert!(judge(name, format, bytes).is_ok(), "{name} is a mesh");
        let tally = campaign(name, format, bytes);
        assert!(tally.errors > 0 && tally.verdicts > 0, "{name}: {tally}");
        assert!(tally.complaints.is_empty(), "{name}: {tally}\n{}", tally.complaints.join("\n"));
        assert!(tally.slowest < Duration::from_secs(5), "{name}: {tally}");
    }
}

/// The same for files of one's own, named by the variable `ISOGEO_DAMAGE`, separated as in `PATH`:
/// `ISOGEO_DAMAGE=a.obj:b.off cargo test --test suite damage -- --nocapture`. Without it there is
/// nothing to damage here.
#[test]
fn damaged_files_of_others() {
    let files = std::env::var_os("ISOGEO_DAMAGE").unwrap_or_default();
    let mut complaints = Vec::new();
    for path in std::env::split_paths(&files).filter(|p| p != Path::new("")) {
        let name = path.display().to_string();
        let format = Format::from_path(&path).expect("a mesh file");
        let bytes = std::fs::read(&path).expect("a file that can be read");
        let tally = campaign(&name, format, &bytes);
        complaints.extend(tally.complaints.into_iter().map(|c| format!("{name}: {c}")));
    }
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
}
