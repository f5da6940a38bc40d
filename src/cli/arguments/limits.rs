//! How much is read at most.

use clap::Args;

use crate::cli::memory;
use crate::mesh::file::Limits;
use crate::scalar::Numeral;

const LIMITS: &str = "Limits";

#[derive(Debug, Args)]
pub struct LimitOptions {
    /// Read numbers of at most N digits, with exponents of at most that size
    #[arg(long, value_name = "N", default_value_t = Numeral::MAX_DIGITS as u32, value_parser = digits(), help_heading = LIMITS)]
    pub max_digits: u32,
    /// Read files of at most SIZE, such as 500M or 4G [default: what the memory suffices for]
    #[arg(long, value_name = "SIZE", value_parser = size, help_heading = LIMITS)]
    pub max_input: Option<u64>,
}

impl LimitOptions {
    /// What is read at most.
    pub fn limits(&self) -> Limits {
        let bytes = self.max_input.or_else(memory::largest_input).unwrap_or(u64::MAX);
        Limits { digits: self.max_digits as usize, bytes }
    }
}

fn digits() -> clap::builder::RangedI64ValueParser<u32> {
    clap::value_parser!(u32).range(1..=Numeral::MOST_DIGITS as i64)
}

/// Bytes, thousands (k), millions (M) or billions (G) of them.
fn size(text: &str) -> Result<u64, &'static str> {
    let units = [("k", 1_000), ("M", 1_000_000), ("G", 1_000_000_000)];
    let unit = units.into_iter().find_map(|(end, unit)| Some((text.strip_suffix(end)?, unit)));
    let (number, unit) = unit.unwrap_or((text, 1));
    let size = number.parse::<u64>().ok().and_then(|n| n.checked_mul(unit));
    size.ok_or("expected a whole number of bytes, such as 2000000, 500M or 4G")
}
