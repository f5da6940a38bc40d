//! What shards found together.

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use super::digest::Digest;
use super::file::{Header, UnfitFile, read};
use super::run::Tally;

/// What the shards of one property found.
#[derive(Clone, Debug)]
pub struct Merged {
    /// The name of the property.
    pub property: String,
    /// The seed.
    pub seed: String,
    /// How many cases were asked for.
    pub cases: u64,
    /// What the cases showed that are there; duplicates count twice.
    pub tally: Tally,
    /// Cases that are not there.
    pub gaps: Vec<Range<u64>>,
    /// Cases that are there more than once.
    pub duplicates: Vec<Range<u64>>,
}

impl Merged {
    /// Whether every case is there exactly once.
    pub fn is_complete(&self) -> bool {
        self.gaps.is_empty() && self.duplicates.is_empty()
    }
}

/// What all files of a folder hold.
#[derive(Clone, Debug)]
pub struct Merging {
    /// The properties, by name.
    pub properties: Vec<Merged>,
    /// Files that end in a torn line; the line is not counted.
    pub torn: Vec<PathBuf>,
    /// The sum of the hashes of the properties, each with its own digest.
    pub digest: Digest,
}

/// Reads all files of shards in a folder, however many machines wrote them, and adds them up.
///
/// # Errors
/// Files that cannot be read, hold lines that are none of ours, or belong to different campaigns.
pub fn merge(folder: &Path) -> Result<Merging, UnfitFile> {
    let io = |path: &Path| {
        let path = path.to_owned();
        move |error| UnfitFile::Io(path, error)
    };
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder).map_err(io(folder))? {
        let path = entry.map_err(io(folder))?.path();
        if path.extension().is_some_and(|extension| extension == "jsonl") {
            paths.push(path);
        }
    }
    paths.sort();
    let (mut properties, mut torn) = (Vec::<Shards>::new(), Vec::new());
    for path in paths {
        let text = fs::read(&path).map_err(io(&path))?;
        let found = read(&path, &text)?;
        if found.whole < text.len() {
            torn.push(path.clone());
        }
        let Some(header) = found.header else { continue };
        let known = properties.iter().position(|p| p.header.property == header.property);
        let at = known.unwrap_or(properties.len());
        if known.is_none() {
            let header = header.clone();
            properties.push(Shards { header, blocks: Vec::new(), tally: Tally::default() });
        }
        let shards = &mut properties[at];
        shards.fits(&path, &header)?;
        for (block, line) in found.blocks.iter().zip(2..) {
            let unfit = || UnfitFile::Line(path.clone(), line);
            shards.blocks.push(block.range().ok_or_else(unfit)?);
            shards.tally.add(block.tally().ok_or_else(unfit)?);
        }
    }
    let mut properties: Vec<Merged> = properties.into_iter().map(Shards::merged).collect();
    properties.sort_by(|a, b| a.property.cmp(&b.property));
    let mut digest = Digest::default();
    for merged in &properties {
        let line = format!("{} {}", merged.property, merged.tally.digest);
        digest.add(&Digest::of(line.as_bytes()));
    }
    Ok(Merging { properties, torn, digest })
}

/// The files of one property.
struct Shards {
    header: Header,
    blocks: Vec<Range<u64>>,
    tally: Tally,
}

impl Shards {
    fn fits(&self, path: &Path, header: &Header) -> Result<(), UnfitFile> {
        let other = |what| Err(UnfitFile::Other(path.to_owned(), what));
        match header {
            header if header.seed != self.header.seed => other("seed"),
            header if header.cases != self.header.cases => other("number of cases"),
            header if header.version != self.header.version => other("version of the program"),
            _ => Ok(()),
        }
    }

    fn merged(mut self) -> Merged {
        self.blocks.sort_unstable_by_key(|block| (block.start, block.end));
        let (mut gaps, mut duplicates, mut next) = (Vec::new(), Vec::new(), 0);
        for block in self.blocks {
            if block.start > next {
                gaps.push(next..block.start);
            } else if block.start < next.min(block.end) {
                duplicates.push(block.start..next.min(block.end));
            }
            next = next.max(block.end);
        }
        let Header { property, seed, cases, .. } = self.header;
        if next < cases {
            gaps.push(next..cases);
        } else if next > cases {
            // Cases that nobody asked for are not those of this campaign.
            duplicates.push(cases..next);
        }
        self.tally.failures.sort_unstable();
        Merged { property, seed, cases, tally: self.tally, gaps, duplicates }
    }
}
