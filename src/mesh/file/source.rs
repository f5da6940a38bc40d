//! The bytes of a text file, cut into lines and words; words into numbers.

use std::ops::Range;

use super::{FileError, Format, error::Place, limits::MORE_DIGITS};
use crate::scalar::{Numeral, NumeralError};

/// A file in memory: everything that an error message needs.
pub(super) struct Source<'a> {
    pub name: &'a str,
    pub format: Format,
    pub bytes: &'a [u8],
    /// The most digits of a number.
    pub digits: usize,
}

/// A word and where it stands.
#[derive(Clone, Copy)]
pub(super) struct Token<'a> {
    pub bytes: &'a [u8],
    pub start: usize,
}

impl Token<'_> {
    pub fn span(&self) -> Range<usize> {
        self.start..self.start + self.bytes.len()
    }

    /// The word as it can be printed: one line, not too long.
    pub fn show(&self) -> String {
        const LONGEST: usize = 40;
        let cut = &self.bytes[..self.bytes.len().min(LONGEST)];
        let dots = if cut.len() < self.bytes.len() { "…" } else { "" };
        format!("'{}{dots}'", String::from_utf8_lossy(cut).escape_debug())
    }
}

impl Source<'_> {
    /// An error about a span of the text.
    #[cold]
    pub fn error(
        &self,
        kind: &str,
        span: Range<usize>,
        message: impl Into<String>,
        label: impl Into<String>,
    ) -> FileError {
        FileError {
            place: Some(Box::new(Place::new(self.bytes, span))),
            label: label.into(),
            ..self.error_without_place(kind, message)
        }
    }

    /// An error about the file as a whole, or about bytes that are no text.
    #[cold]
    pub fn error_without_place(&self, kind: &str, message: impl Into<String>) -> FileError {
        FileError::new(kind, self.format.name(), self.name, message)
    }

    /// The number that a word is.
    #[inline]
    pub fn numeral(&self, token: Token<'_>) -> Result<Numeral, FileError> {
        std::str::from_utf8(token.bytes)
            .map_err(|_| NumeralError::Syntax)
            .and_then(|text| Numeral::parse(text, self.digits))
            .map_err(|e| self.bad_number(token, e))
    }

    #[cold]
    fn bad_number(&self, token: Token<'_>, error: NumeralError) -> FileError {
        let text = String::from_utf8_lossy(token.bytes).to_ascii_lowercase();
        let (kind, label) = match error {
            NumeralError::Syntax => ("number", "expected a decimal number".to_owned()),
            error => ("limit", format!("{error} is not read")),
        };
        let error = self.error(
            kind,
            token.span(),
            format!("cannot read {} as a number", token.show()),
            label,
        );
        if kind == "limit" {
            error.help(MORE_DIGITS)
        } else if text.contains('/') {
            error.help(
                "coordinates are decimals (1, -0.25, 3e-2); for p/q use a .iso.json file, \
                 because other tools silently misread '1/3' as 1",
            )
        } else if text.contains("nan") || text.contains("inf") {
            error.help("NaN and infinities are no coordinates")
        } else if text.contains(',') {
            error.help("decimals are written with a point, and numbers are separated by blanks")
        } else {
            error
        }
    }

    /// The whole number that a word is; `what` says what it is for.
    #[inline]
    pub fn integer(&self, token: Token<'_>, what: &str) -> Result<i64, FileError> {
        integer(token.bytes).ok_or_else(|| {
            let message = format!("cannot read {} as a whole number", token.show());
            self.error("integer", token.span(), message, format!("expected {what}"))
        })
    }

    /// An index that counts from 0.
    #[inline]
    pub fn index(&self, token: Token<'_>) -> Result<u32, FileError> {
        let index = self.integer(token, "the index of a vertex")?;
        u32::try_from(index).map_err(|_| {
            let message = format!("{index} is not the index of a vertex");
            self.error("index", token.span(), message, "expected an index that counts from 0")
        })
    }

    /// A number of elements that a header announces.
    pub fn count(&self, token: Token<'_>, what: &str) -> Result<usize, FileError> {
        let count = self.integer(token, what)?;
        usize::try_from(count).map_err(|_| {
            let message = format!("{count} is less than 0");
            self.error("integer", token.span(), message, format!("expected {what}"))
        })
    }

    /// The first digits in a row that are more than a number may have.
    pub fn long_number(&self) -> Option<Range<usize>> {
        let is_end = |byte: &u8| !byte.is_ascii_digit();
        // So many digits in a row cover one of these places.
        let mut places = (self.digits..self.bytes.len()).step_by(self.digits.saturating_add(1));
        places.find_map(|at| {
            let (before, after) = self.bytes.split_at(at);
            let start = before.iter().rposition(is_end).map_or(0, |end| end + 1);
            let end = at + after.iter().position(is_end).unwrap_or(after.len());
            (end - start > self.digits).then_some(start..end)
        })
    }

    /// The span from `start` to the end of that line, without the blanks at its end.
    pub fn rest_of_line(&self, start: usize) -> Range<usize> {
        let line = self.bytes[start..].split(|b| matches!(b, b'\n' | b'\r')).next();
        start..start + line.unwrap_or_default().trim_ascii_end().len()
    }
}

/// `[sign] digits` within 18 digits.
#[inline]
pub(super) fn integer(bytes: &[u8]) -> Option<i64> {
    let (negative, digits) = match bytes {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        _ => (false, bytes),
    };
    if digits.is_empty() || digits.len() > 18 {
        return None;
    }
    let mut n = 0i64;
    for byte in digits {
        if !byte.is_ascii_digit() {
            return None;
        }
        n = n * 10 + i64::from(byte - b'0');
    }
    Some(if negative { -n } else { n })
}

/// Walks through a text word by word and line by line.
///
/// A line ends with LF, CR LF or CR; words are separated by blanks; a word that starts with `#`
/// starts a comment (if the format has them).
pub(super) struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
    comments: bool,
    continuations: bool,
}

impl<'a> Cursor<'a> {
    /// At the start of the text, after a byte order mark.
    pub fn new(bytes: &'a [u8]) -> Self {
        let at = if bytes.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 };
        Cursor { bytes, at, comments: true, continuations: false }
    }

    /// `#` is a letter like any other.
    pub fn without_comments(mut self) -> Self {
        self.comments = false;
        self
    }

    /// A `\` at the end of a line joins it with the next.
    pub fn with_continuations(mut self) -> Self {
        self.continuations = true;
        self
    }

    /// The same rules from another place on.
    pub fn at(mut self, at: usize) -> Self {
        self.at = at;
        self
    }

    /// The place in the bytes.
    pub fn position(&self) -> usize {
        self.at
    }

    /// The next word of this line.
    #[inline]
    pub fn token(&mut self) -> Option<Token<'a>> {
        self.skip_blanks();
        let start = self.at;
        if self.comments && self.bytes.get(start) == Some(&b'#') {
            return None;
        }
        while let Some(byte) = self.bytes.get(self.at) {
            match byte {
                b' ' | b'\t' | b'\n' | b'\r' | 0x0b | 0x0c => break,
                b'\\' if self.continuation().is_some() => break,
                _ => self.at += 1,
            }
        }
        (start < self.at).then(|| Token { bytes: &self.bytes[start..self.at], start })
    }

    #[inline]
    fn skip_blanks(&mut self) {
        while let Some(byte) = self.bytes.get(self.at) {
            match byte {
                b' ' | b'\t' | 0x0b | 0x0c => self.at += 1,
                b'\\' => match self.continuation() {
                    Some(length) => self.at += length,
                    None => break,
                },
                _ => break,
            }
        }
    }

    /// The length of `\` and the end of line after it.
    #[cold]
    fn continuation(&self) -> Option<usize> {
        match &self.bytes[self.at + 1..] {
            _ if !self.continuations => None,
            [b'\r', b'\n', ..] => Some(3),
            [b'\r' | b'\n', ..] => Some(2),
            _ => None,
        }
    }

    /// The comment that the rest of this line is, without its `#`.
    pub fn comment(&mut self) -> Option<&'a [u8]> {
        self.skip_blanks();
        let rest = self.bytes[self.at..].strip_prefix(b"#").filter(|_| self.comments)?;
        rest.split(|b| matches!(b, b'\n' | b'\r')).next()
    }

    /// Goes to the next line; `false` at the end of the file.
    #[inline]
    pub fn next_line(&mut self) -> bool {
        while let Some(byte) = self.bytes.get(self.at) {
            self.at += 1;
            match byte {
                b'\n' => return true,
                b'\r' => {
                    self.at += usize::from(self.bytes.get(self.at) == Some(&b'\n'));
                    return true;
                }
                _ => {}
            }
        }
        false
    }
}
