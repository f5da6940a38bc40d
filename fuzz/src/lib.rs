//! What is done with arbitrary bytes. A target is one of these functions; a panic is a find.

use isogeo::check::{Decide, Decider, Plain, Report, Verdict};
use isogeo::construct::delaunay;
use isogeo::mesh::file::{
    Coordinates, FileError, Format, Limits, MeshFile, Options, Written, clear_denominators,
    read_bytes, read_bytes_within, read_points_bytes, write_string,
};
use isogeo::mesh::{Mesh, VertexId};
use isogeo::net::{Net, Property, RADIUS};
use isogeo::optimise::existence::Certificate;
use isogeo::pair::{Couple, PairProperty};
use isogeo::scalar::{Approx, Numeral, Rational, ReadAs, Ring};
use isogeo::space::{Expression, Point, TopView};

const READ: [Format; 4] = [Format::Obj, Format::Off, Format::Ply, Format::IsoJson];
const READINGS: [ReadAs; 3] = [ReadAs::Decimal, ReadAs::Rounded, ReadAs::Double];

/// Reads a mesh: it is one, or an error with its place.
pub fn read(format: Format, bytes: &[u8]) {
    match read_bytes("fuzz", format, bytes) {
        Ok(file) => {
            assert_eq!(file.format, format);
            for reading in READINGS {
                if let Err(error) = file.to_exact(reading) {
                    assert_eq!(reading, ReadAs::Double);
                    is_sound(&error, bytes);
                }
            }
        }
        Err(error) => is_sound(&error, bytes),
    }
}

/// An error names its kind, and a place within the file.
fn is_sound(error: &FileError, bytes: &[u8]) {
    assert!(error.code.starts_with("isogeo::"), "{error}");
    assert!(!error.message.is_empty());
    if let Some(place) = &error.place {
        assert!(place.span.start <= place.span.end && place.span.end <= bytes.len(), "{error}");
        assert!(place.line > 0 && place.column > 0, "{error}");
        assert!(place.excerpt_start <= place.span.start, "{error}");
    }
}

/// Reads scattered samples, and triangulates them: the result is proved to be Delaunay.
pub fn points(bytes: &[u8]) {
    const MOST: usize = 200;
    let file = match read_points_bytes("fuzz", bytes) {
        Ok(file) => file,
        Err(error) => return is_sound(&error, bytes),
    };
    let Some(points) = file.points().filter(|points| points.len() <= MOST) else { return };
    let points: Vec<_> = points.iter().map(|point| point.map(Numeral::value)).collect();
    if let Ok(mesh) = delaunay(points) {
        let decider = Decider::of_rationals(&mesh.points);
        let verdict = Net::new(&mesh.topology, &decider).check(Property::Delaunay).verdict();
        assert!(matches!(verdict, Verdict::Proved | Verdict::Vacuous), "{verdict}");
    }
}

/// Reads a formula and evaluates it.
pub fn expression(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    match text.parse::<Expression>() {
        Ok(formula) => {
            let _ = formula.height_at(&TopView::new(Rational::from_i64(2), Rational::from_i64(-1)));
            let _ = formula.to_polynomial();
        }
        Err(error) => {
            assert!(!error.message.is_empty());
            assert!(error.span.start <= error.span.end && error.span.end <= text.len());
            assert!(text.is_char_boundary(error.span.start));
        }
    }
}

/// Checks all properties of a mesh, or of a pair whose second file follows a line `===`.
///
/// The first byte chooses the format and the reading; longer numbers than those of 300 digits are only
/// slow. What the fast way decides is compared with the definition over fractions.
pub fn check(bytes: &[u8]) {
    let Some((&choice, rest)) = bytes.split_first() else { return };
    let format = READ[usize::from(choice) % 4];
    let reading = READINGS[usize::from(choice) / 4 % 3];
    let cut = rest.windows(5).position(|window| window == b"\n===\n");
    let (first, second) = cut.map_or((rest, None), |at| (&rest[..at], Some(&rest[at + 5..])));
    let limits = Limits { digits: 300, ..Limits::default() };
    let read = |bytes| {
        let file = read_bytes_within("fuzz", format, bytes, &limits).ok()?;
        if reading == ReadAs::Double { file.into_doubles().ok() } else { Some(file) }
    };
    let Some(mesh) = read(first) else { return };
    let image = second.and_then(read);
    let files = [Some(&mesh), image.as_ref()];
    let mut decider = decider(&mesh, reading);
    let mut points = Vec::new();
    for file in files.into_iter().flatten() {
        points.extend(exact(file).points);
    }
    if let Some(image) = &image {
        decider = decider.followed_by(self::decider(image, reading));
    }
    let radii = radii(&mesh);
    if let Some(radii) = &radii {
        decider = decider.followed_by(Decider::of_rationals(radii));
    }
    let first_radius = radii.as_ref().map(|_| VertexId(points.len() as u32));
    points.extend(radii.iter().flatten().cloned());
    let fast = verdicts(&mesh, image.as_ref(), first_radius, &decider);
    let plain = verdicts(&mesh, image.as_ref(), first_radius, &Plain(&points));
    let is_rounded =
        reading == ReadAs::Rounded && !matches!(mesh.coordinates, Coordinates::Rationals(_));
    for ((name, fast), (_, plain)) in fast.into_iter().zip(plain) {
        // What boxes prove or refute holds for the printed numbers, which are in the boxes.
        if !is_rounded || matches!(fast, Verdict::Proved | Verdict::Refuted) {
            assert_eq!(fast, plain, "{name}");
        }
    }
    if let Some(claim) = mesh.certificate.as_ref().and_then(|c| c.get(Certificate::NAME)) {
        if let Ok(certificate) = Certificate::read(claim) {
            let mesh = exact(&mesh);
            let _ = certificate.verify(&mesh.topology, &mesh.points);
        }
    }
}

fn decider(file: &MeshFile, reading: ReadAs) -> Decider<'_> {
    match (&file.coordinates, reading) {
        (Coordinates::Rationals(mesh), _) => Decider::of_rationals(&mesh.points),
        (Coordinates::Numerals(mesh), ReadAs::Rounded) => Decider::over_boxes(&mesh.points),
        (Coordinates::Numerals(mesh), _) => Decider::new(&mesh.points),
    }
}

fn exact(file: &MeshFile) -> Mesh<Rational> {
    file.to_exact(ReadAs::Decimal).expect("decimals have no limit")
}

fn radii(file: &MeshFile) -> Option<Vec<Point<Rational>>> {
    let Coordinates::Rationals(mesh) = &file.coordinates else { return None };
    let zero = Rational::zero;
    let radii = mesh.data.vertex.get(RADIUS)?;
    Some(radii.iter().map(|r| Point::new(r.clone(), zero(), zero())).collect())
}

fn verdicts<D: Decide>(
    mesh: &MeshFile,
    image: Option<&MeshFile>,
    first_radius: Option<VertexId>,
    decide: &D,
) -> Vec<(&'static str, Verdict)> {
    let mut net = Net::new(mesh.topology(), decide);
    if let Some(first) = first_radius {
        net = net.with_radii(first);
    }
    let verdict = |report: Report<D::Value>| (report.property, report.verdict());
    let mut found: Vec<_> = Property::ALL.into_iter().map(|p| verdict(net.check(p))).collect();
    let couple = image.and_then(|s| Couple::new(mesh.topology(), s.topology(), decide).ok());
    if let Some(couple) = couple {
        found.extend(PairProperty::ALL.into_iter().map(|p| verdict(couple.check(p))));
    }
    found
}

/// Reads a mesh, writes it in every format, reads that: the same mesh. The first byte chooses the
/// format.
pub fn round_trip(bytes: &[u8]) {
    let Some((&choice, rest)) = bytes.split_first() else { return };
    let Ok(file) = read_bytes("fuzz", READ[usize::from(choice) % 4], rest) else { return };
    let mut options = Options { certificate: file.certificate.clone(), ..Options::default() };
    options.notes = file.notes.clone();
    let mesh = exact(&file);
    same_again(&mesh, &options);
    options.notes.clear();
    options.digits = std::num::NonZero::new(3);
    same_again(&mesh, &options);
    if let Some(cleared) = clear_denominators(&mesh) {
        let options = Options { notes: cleared.notes(), ..Options::default() };
        same_again(&cleared.mesh, &options);
    }
}

fn same_again(mesh: &Mesh<Rational>, options: &Options) {
    for format in Format::ALL {
        let (text, written) = match write_string("fuzz", format, mesh, options) {
            Ok(done) => done,
            Err(error) => {
                assert!(error.code.ends_with("::not-finite") || format == Format::Vtu, "{error}");
                continue;
            }
        };
        if format == Format::Vtu {
            continue;
        }
        let again = match read_bytes("again", format, text.as_bytes()) {
            Ok(file) => file,
            // A file without vertices is a mesh only in our own format.
            Err(_) if mesh.points.is_empty() => continue,
            // Numbers of more digits, or larger exponents, than are read.
            Err(error) if error.code.ends_with("::limit") => continue,
            Err(error) => panic!("{error}\n{text}"),
        };
        assert_eq!(again.topology(), &mesh.topology);
        if format == Format::IsoJson {
            assert_eq!(again.coordinates, Coordinates::Rationals(mesh.clone()));
            assert_eq!(again.certificate, options.certificate);
        } else if written == Written::Exact {
            assert!(again.exact);
            assert_eq!(exact(&again).points, mesh.points);
        } else if options.digits.is_none() {
            let doubles = again.to_exact(ReadAs::Double).expect("doubles were written");
            for (read, given) in doubles.points.iter().zip(&mesh.points) {
                assert_eq!(read.map(Approx::to_f64), given.map(Approx::to_f64));
            }
        }
    }
}
