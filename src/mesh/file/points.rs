//! Scattered points: lines of two or three numbers, as text or CSV.

use std::ops::Range;
use std::path::Path;

use super::FileError;
use super::error::Place;
use super::limits::{Limits, MORE_DIGITS};
use crate::scalar::{Numeral, NumeralError};
use crate::space::{Point, TopView};

/// The numbers of a point file, one or more columns on every line.
#[derive(Clone, Debug, PartialEq)]
pub struct PointFile {
    /// The top views: the first two columns.
    pub top_views: Vec<TopView<Numeral>>,
    /// The third column, if every line has one.
    pub heights: Option<Vec<Numeral>>,
}

impl PointFile {
    /// The points, if there are heights.
    pub fn points(&self) -> Option<Vec<Point<Numeral>>> {
        let heights = self.heights.as_ref()?;
        let point = |(at, z): (&TopView<Numeral>, &Numeral)| {
            Point::new(at.x.clone(), at.y.clone(), z.clone())
        };
        Some(self.top_views.iter().zip(heights).map(point).collect())
    }
}

/// Reads points from a file.
///
/// Numbers are separated by blanks, commas or semicolons; `#` starts a comment; lines before the
/// first number that hold none are a header; a third column must be there on all lines or on none.
///
/// # Errors
/// A file that cannot be read, a word that is no number, a line with fewer than two or
/// more than three, no line at all.
pub fn read_points(path: impl AsRef<Path>) -> Result<PointFile, FileError> {
    read_points_within(path, &Limits::default())
}

/// Reads points from a file that is not larger than some limits.
///
/// # Errors
/// As for [`read_points`]; what is beyond the limits has the code `isogeo::file::limit` or
/// `isogeo::points::limit`.
pub fn read_points_within(path: impl AsRef<Path>, limits: &Limits) -> Result<PointFile, FileError> {
    let path = path.as_ref();
    parse(&path.display().to_string(), &limits.read(path)?, limits.digits)
}

/// Reads points from the bytes of a file; `name` is for error messages.
///
/// ```
/// use isogeo::mesh::file::read_points_bytes;
/// let file = read_points_bytes("p.csv", b"x,y,z\n0,0,0.5 # a corner\n1.0, 0 ,-2e-3\n")?;
/// assert_eq!(file.points().unwrap()[1].z, "-2e-3".parse().unwrap());
/// let error = read_points_bytes("p.txt", b"0 0 0\n1 O 0\n").unwrap_err();
/// assert_eq!(error.to_string(), "p.txt:2:3: cannot read 'O' as a number: expected a decimal number");
/// # Ok::<(), isogeo::mesh::file::FileError>(())
/// ```
///
/// # Errors
/// As for [`read_points`].
pub fn read_points_bytes(name: &str, bytes: &[u8]) -> Result<PointFile, FileError> {
    parse(name, bytes, Limits::default().digits)
}

fn parse(name: &str, bytes: &[u8], digits: usize) -> Result<PointFile, FileError> {
    let text = Text { name, bytes, digits };
    let mut top_views = Vec::new();
    let mut heights = Vec::new();
    let start = if bytes.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 };
    for line in lines(bytes, start) {
        let words = words(bytes, line.clone());
        if words.is_empty() {
            continue;
        }
        let is_number = |w: &Range<usize>| text.number(w.clone()).is_ok();
        if top_views.is_empty() && !words.iter().any(is_number) {
            continue;
        }
        let numbers =
            words.iter().map(|w| text.number(w.clone())).collect::<Result<Vec<_>, _>>()?;
        let [x, y, z @ ..] = numbers.as_slice() else {
            return Err(text.error("coordinates", line, "a point needs at least two numbers"));
        };
        let expected =
            if top_views.is_empty() { z.len() } else { usize::from(!heights.is_empty()) };
        match z {
            _ if z.len() > 1 => {
                let surplus = words[3].start..line.end;
                return Err(text.error("coordinates", surplus, "a point has two or three numbers"));
            }
            _ if z.len() != expected => {
                let message = format!(
                    "this line has {} numbers, the lines before have {}",
                    2 + z.len(),
                    2 + expected
                );
                return Err(text.error("coordinates", line, message));
            }
            _ => heights.extend(z.iter().cloned()),
        }
        top_views.push(TopView::new(x.clone(), y.clone()));
    }
    if top_views.is_empty() {
        return Err(FileError::new("empty", "points", name, "there is no point in the file"));
    }
    let heights = (!heights.is_empty()).then_some(heights);
    Ok(PointFile { top_views, heights })
}

struct Text<'a> {
    name: &'a str,
    bytes: &'a [u8],
    digits: usize,
}

impl Text<'_> {
    fn error(&self, kind: &str, span: Range<usize>, message: impl Into<String>) -> FileError {
        FileError {
            place: Some(Box::new(Place::new(self.bytes, span))),
            ..FileError::new(kind, "points", self.name, message)
        }
    }

    fn number(&self, span: Range<usize>) -> Result<Numeral, FileError> {
        let word = &self.bytes[span.clone()];
        let text = std::str::from_utf8(word).map_err(|_| NumeralError::Syntax);
        text.and_then(|text| Numeral::parse(text, self.digits)).map_err(|error| {
            const LONGEST: usize = 40;
            let shown = String::from_utf8_lossy(&word[..word.len().min(LONGEST)]);
            let message = format!("cannot read '{}' as a number", shown.escape_debug());
            match error {
                NumeralError::Syntax => {
                    let label = "expected a decimal number".to_owned();
                    FileError { label, ..self.error("number", span, message) }
                }
                error => {
                    let label = format!("{error} is not read");
                    FileError { label, ..self.error("limit", span, message) }.help(MORE_DIGITS)
                }
            }
        })
    }
}

/// The lines without their comments and ends: LF, CR LF or CR.
fn lines(bytes: &[u8], start: usize) -> impl Iterator<Item = Range<usize>> + '_ {
    let mut at = start;
    std::iter::from_fn(move || {
        if at >= bytes.len() {
            return None;
        }
        let begin = at;
        let length = bytes[at..].iter().position(|b| matches!(b, b'\n' | b'\r'));
        let end = length.map_or(bytes.len(), |n| begin + n);
        at = end + 1;
        let comment = bytes[begin..end].iter().position(|&b| b == b'#');
        Some(begin..comment.map_or(end, |n| begin + n))
    })
}

fn words(bytes: &[u8], line: Range<usize>) -> Vec<Range<usize>> {
    let is_gap = |b: &u8| b.is_ascii_whitespace() || matches!(b, b',' | b';' | 0x0b);
    let mut words = Vec::new();
    let mut at = line.start;
    while at < line.end {
        let length = bytes[at..line.end].iter().take_while(|b| !is_gap(b)).count();
        if length > 0 {
            words.push(at..at + length);
        }
        at += length + 1;
    }
    words
}
