//! How much is read at most.

use std::io::{self, Read};
use std::path::Path;

use super::FileError;
use crate::scalar::Numeral;

/// Bounds of what is read from a file, so that none exhausts time or memory by surprise.
///
/// ```
/// use isogeo::mesh::file::{Format, Limits, read_bytes, read_bytes_within};
/// let short = Limits { digits: 3, ..Limits::default() };
/// let read = |text: &[u8]| read_bytes_within("m.obj", Format::Obj, text, &short);
/// assert!(read(b"v 0 0 -.125").is_ok());
/// assert_eq!(&*read(b"v 0 0 0.125").unwrap_err().code, "isogeo::obj::limit");
/// assert_eq!(&*read(b"v 0 0 1e4").unwrap_err().code, "isogeo::obj::limit");
/// assert!(read_bytes("m.obj", Format::Obj, b"v 0 0 1e4").is_ok());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// The most digits of a number or of a part of a fraction, and the largest size of a decimal
    /// exponent; not above [`Numeral::MOST_DIGITS`].
    pub digits: usize,
    /// The most bytes of a file.
    pub bytes: u64,
}

impl Default for Limits {
    /// 10,000 digits; files of any size.
    fn default() -> Self {
        Limits { digits: Numeral::MAX_DIGITS, bytes: u64::MAX }
    }
}

/// The advice where a number is beyond the limit.
pub(super) const MORE_DIGITS: &str = "--max-digits N raises the limit";

impl Limits {
    /// The bytes of a file, or of what a pipe gives.
    pub(super) fn read(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        let name = path.display().to_string();
        let failed = |e: io::Error| {
            FileError::new("io", "file", &name, format!("the file cannot be read: {e}"))
        };
        let too_large = |size: String| {
            let message = format!("{size}, at most {} are read", words(self.bytes));
            FileError::new("limit", "file", &name, message)
                .help("--max-input SIZE raises the limit, such as --max-input 4G")
        };
        let file = std::fs::File::open(path).map_err(failed)?;
        let size = file.metadata().map_err(failed)?.len();
        if size > self.bytes {
            return Err(too_large(format!("the file has {}", words(size))));
        }
        let mut bytes = Vec::new();
        bytes.try_reserve_exact(size as usize).map_err(|e| failed(e.into()))?;
        file.take(self.bytes.saturating_add(1)).read_to_end(&mut bytes).map_err(failed)?;
        if bytes.len() as u64 > self.bytes {
            return Err(too_large("the file does not end".to_owned()));
        }
        Ok(bytes)
    }
}

fn words(bytes: u64) -> String {
    match bytes {
        0..1_000_000 => format!("{bytes} bytes"),
        _ => format!("{}.{} MB", bytes / 1_000_000, bytes / 100_000 % 10),
    }
}
