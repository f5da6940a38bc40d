//! The file of a shard: a line that says what it is, then a line for every block of cases.

use std::fmt;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::run::{Campaign, Tally};
use super::shard::Shard;

/// What a file of a shard says that it is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Header {
    pub schema: String,
    /// Of the program: another one may draw other cases.
    pub version: String,
    pub property: String,
    pub seed: String,
    pub cases: u64,
    pub shard: String,
}

impl Header {
    fn new(campaign: &Campaign, shard: Shard) -> Self {
        Header {
            schema: "isogeo.shard/1".into(),
            version: env!("CARGO_PKG_VERSION").into(),
            property: campaign.property.id().into(),
            seed: campaign.seed.to_string(),
            cases: campaign.cases,
            shard: shard.to_string(),
        }
    }
}

/// Consecutive cases with what they showed: one line of a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Block {
    /// The index of the first case.
    pub first: u64,
    /// How many there are.
    pub cases: u64,
    /// On how many the property holds.
    pub holds: u64,
    /// How many are outside of its hypotheses.
    pub excluded: u64,
    /// The others, by index, with what fails.
    pub failures: Vec<(u64, String)>,
    /// The sum of the hashes, in hexadecimal digits.
    pub digest: String,
}

impl Block {
    /// What cases from this index on showed.
    pub fn new(first: u64, tally: Tally) -> Self {
        let (cases, digest) = (tally.cases(), tally.digest.to_string());
        let Tally { holds, excluded, failures, .. } = tally;
        Block { first, cases, holds, excluded, failures, digest }
    }

    /// The indices; `None` for numbers that cannot be.
    pub fn range(&self) -> Option<Range<u64>> {
        Some(self.first..self.first.checked_add(self.cases)?)
    }

    /// The same as a tally; `None` for numbers that do not add up.
    pub fn tally(&self) -> Option<Tally> {
        let Block { holds, excluded, failures, digest, .. } = self.clone();
        let found = Tally { holds, excluded, failures, digest: digest.parse().ok()? };
        (found.cases() == self.cases).then_some(found)
    }
}

/// Why a file cannot be the one of a shard.
#[derive(Debug)]
pub enum UnfitFile {
    /// The file system says so.
    Io(PathBuf, io::Error),
    /// Another process is writing it.
    Busy(PathBuf),
    /// It belongs to another campaign, by what differs.
    Other(PathBuf, &'static str),
    /// This line is none of ours, or does not follow the one before.
    Line(PathBuf, usize),
}

impl fmt::Display for UnfitFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            UnfitFile::Io(path, error) => write!(f, "{}: {error}", path.display()),
            UnfitFile::Busy(path) => {
                write!(f, "{}: another process is writing this shard", path.display())
            }
            UnfitFile::Other(path, what) => {
                write!(f, "{}: the file is of a campaign with another {what}", path.display())
            }
            UnfitFile::Line(path, line) => {
                write!(f, "{}: line {line} is no block of cases that fits there", path.display())
            }
        }
    }
}

impl std::error::Error for UnfitFile {}

/// What is found in a file.
pub(super) struct Found {
    /// `None` where not even the first line is whole.
    pub header: Option<Header>,
    pub blocks: Vec<Block>,
    /// The bytes of whole lines; what comes after is torn.
    pub whole: usize,
}

/// Reads the whole lines of a file.
pub(super) fn read(path: &Path, text: &[u8]) -> Result<Found, UnfitFile> {
    let whole = text.iter().rposition(|b| *b == b'\n').map_or(0, |last| last + 1);
    let bad = |line| UnfitFile::Line(path.to_owned(), line);
    let mut lines = text[..whole].split_inclusive(|b| *b == b'\n');
    let parse = |line: &[u8]| serde_json::from_slice::<Header>(line);
    let header = lines.next().map(parse).transpose().map_err(|_| bad(1))?;
    let block = |(line, n): (&[u8], usize)| {
        let block: Block = serde_json::from_slice(line).map_err(|_| bad(n))?;
        let fits = block.range().is_some() && block.tally().is_some();
        fits.then_some(block).ok_or(bad(n))
    };
    let blocks = lines.zip(2..).map(block).collect::<Result<_, _>>()?;
    Ok(Found { header, blocks, whole })
}

/// The file of a shard, open at its end.
#[derive(Debug)]
pub struct ShardFile {
    path: PathBuf,
    file: File,
    done: Tally,
    next: u64,
    end: u64,
}

impl ShardFile {
    /// Opens or begins the file `PROPERTY.i-of-n.jsonl` in a folder. What is torn at its end, after a
    /// crash, is cut off.
    ///
    /// # Errors
    /// A file of another campaign, with lines that do not fit, in use, or out of reach.
    pub fn open(folder: &Path, campaign: &Campaign, shard: Shard) -> Result<Self, UnfitFile> {
        let name = shard.to_string().replace('/', "-of-");
        let path = folder.join(format!("{}.{name}.jsonl", campaign.property.id()));
        let io = |error| UnfitFile::Io(path.clone(), error);
        fs::create_dir_all(folder).map_err(io)?;
        let mut options = OpenOptions::new();
        let mut file =
            options.read(true).write(true).create(true).truncate(false).open(&path).map_err(io)?;
        if let Err(fs::TryLockError::WouldBlock) = file.try_lock() {
            return Err(UnfitFile::Busy(path));
        }
        let mut text = Vec::new();
        file.read_to_end(&mut text).map_err(io)?;
        let found = read(&path, &text)?;
        file.set_len(found.whole as u64).map_err(io)?;
        file.seek(SeekFrom::End(0)).map_err(io)?;
        let expected = Header::new(campaign, shard);
        match &found.header {
            Some(header) => same(&path, header, &expected)?,
            None => write_line(&mut file, &expected).map_err(io)?,
        }
        let range = shard.range(campaign.cases);
        let (mut done, mut next) = (Tally::default(), range.start);
        for (block, line) in found.blocks.iter().zip(2..) {
            let unfit = || UnfitFile::Line(path.clone(), line);
            let cases = block.range().ok_or_else(unfit)?;
            if cases.start != next || cases.end > range.end {
                return Err(unfit());
            }
            next = cases.end;
            done.add(block.tally().ok_or_else(unfit)?);
        }
        Ok(ShardFile { path, file, done, next, end: range.end })
    }

    /// The cases that are left.
    pub fn left(&self) -> Range<u64> {
        self.next..self.end
    }

    /// What the cases showed that are there.
    pub fn done(&self) -> &Tally {
        &self.done
    }

    /// Appends the next cases, in one piece.
    ///
    /// # Errors
    /// What the file system says.
    pub fn append(&mut self, tally: Tally) -> Result<(), UnfitFile> {
        let block = Block::new(self.next, tally.clone());
        let written = write_line(&mut self.file, &block);
        written.map_err(|error| UnfitFile::Io(self.path.clone(), error))?;
        self.next += block.cases;
        self.done.add(tally);
        Ok(())
    }
}

fn write_line(file: &mut File, value: &impl Serialize) -> io::Result<()> {
    let mut line = serde_json::to_vec(value)?;
    line.push(b'\n');
    file.write_all(&line)?;
    file.sync_data()
}

/// That a file belongs to the same campaign, and to this shard of it.
fn same(path: &Path, found: &Header, expected: &Header) -> Result<(), UnfitFile> {
    let differs = [
        ("schema", found.schema == expected.schema),
        ("property", found.property == expected.property),
        ("seed", found.seed == expected.seed),
        ("number of cases", found.cases == expected.cases),
        ("shard", found.shard == expected.shard),
        ("version of the program", found.version == expected.version),
    ];
    match differs.into_iter().find(|(_, same)| !same) {
        Some((what, _)) => Err(UnfitFile::Other(path.to_owned(), what)),
        None => Ok(()),
    }
}
