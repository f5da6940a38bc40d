//! What is wrong with a file: one error, with its place and what was expected there.

use std::fmt;
use std::ops::Range;

/// Why a file could not be read or written.
///
/// It prints as `name:line:column: message: what was expected`. All fields are public, so that a
/// program can show the place in its own way.
///
/// Codes are stable. They read `isogeo::FORMAT::KIND`, where `FORMAT` is `file` or the
/// [name](super::Format::name) of a format and `KIND` is one of
///
/// | kind | meaning |
/// | --- | --- |
/// | `io` | the file cannot be opened, read or written |
/// | `format` | the format is unknown, or not one that can be read or written |
/// | `feature` | support for this format was not compiled in |
/// | `header` | the file does not start as the format does |
/// | `variant` | a variant of the format that is not read |
/// | `statement` | a keyword that is not known |
/// | `number`, `integer`, `index` | a number, whole number, index of a vertex that is none |
/// | `limit` | a file or a number larger than [`Limits`](super::Limits) allow |
/// | `not-finite` | a coordinate that is NaN, infinite, or beyond the range of doubles |
/// | `coordinates` | too few or too many coordinates |
/// | `truncated`, `trailing` | less or more than the file announces |
/// | `empty` | no vertices |
/// | `face-size`, `repeated-vertex`, `orientation`, `non-manifold`, `too-large` | the faces form no mesh |
/// | `syntax`, `data` | JSON that is malformed; an array that does not fit the mesh |
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileError {
    /// The stable name of the error, such as `isogeo::obj::number`.
    pub code: Box<str>,
    /// What is wrong, in words.
    pub message: String,
    /// The name of the file.
    pub file: String,
    /// Where; `None` where no place in a text can be named (I/O, binary data).
    pub place: Option<Box<Place>>,
    /// What was expected at that place; may be empty.
    pub label: String,
    /// What to do about it.
    pub help: Option<String>,
}

/// A place in a text file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The bytes in question, counted from 0.
    pub span: Range<usize>,
    /// The line, counted from 1.
    pub line: usize,
    /// The column in characters, counted from 1.
    pub column: usize,
    /// The line itself, or the part of a long line around the place; bytes that are no text are
    /// replaced.
    pub excerpt: String,
    /// The byte of the file that the excerpt starts with.
    pub excerpt_start: usize,
}

impl Place {
    /// Finds line and column of a span; a span beyond the end is moved to the end.
    pub(super) fn new(bytes: &[u8], span: Range<usize>) -> Place {
        const BEFORE: usize = 120;
        const AFTER: usize = 200;
        let start = span.start.min(bytes.len());
        let end = span.end.clamp(start, bytes.len());
        let (before, after) = bytes.split_at(start);
        let is_end = |b: &u8| matches!(b, b'\n' | b'\r');
        let line_start = before.iter().rposition(is_end).map_or(0, |i| i + 1);
        let ends = before.iter().filter(|b| is_end(b)).count();
        let pairs = before.windows(2).filter(|pair| pair == b"\r\n").count();
        let column = before[line_start..].iter().filter(|b| **b & 0xc0 != 0x80).count();
        let line_end = start + after.iter().position(is_end).unwrap_or(after.len());
        let excerpt_start = line_start.max(start.saturating_sub(BEFORE));
        let excerpt = &bytes[excerpt_start..line_end.min(start + AFTER)];
        Place {
            span: start..end,
            line: ends - pairs + 1,
            column: column + 1,
            excerpt: String::from_utf8_lossy(excerpt).into_owned(),
            excerpt_start,
        }
    }
}

impl FileError {
    /// An error without a place in a text.
    pub(crate) fn new(kind: &str, format: &str, file: &str, message: impl Into<String>) -> Self {
        FileError {
            code: format!("isogeo::{format}::{kind}").into(),
            message: message.into(),
            file: file.to_owned(),
            place: None,
            label: String::new(),
            help: None,
        }
    }

    /// The same error with advice.
    pub(crate) fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:", self.file)?;
        if let Some(place) = &self.place {
            write!(f, "{}:{}:", place.line, place.column)?;
        }
        write!(f, " {}", self.message)?;
        if !self.label.is_empty() {
            write!(f, ": {}", self.label)?;
        }
        Ok(())
    }
}

impl std::error::Error for FileError {}
