//! A part of the cases of a campaign.

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

/// Part `number` of `count`, counted from 1: a range of consecutive cases.
///
/// ```
/// use isogeo::campaign::Shard;
/// let shard: Shard = "2/3".parse()?;
/// assert_eq!(shard.range(10), 3..6);
/// assert!("0/3".parse::<Shard>().is_err() && "4/3".parse::<Shard>().is_err());
/// # Ok::<(), isogeo::campaign::NoShard>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    number: u64,
    count: u64,
}

impl Shard {
    /// Everything.
    pub const WHOLE: Shard = Shard { number: 1, count: 1 };

    /// Part `number` of `count`; `None` unless `1 ≤ number ≤ count`.
    pub fn new(number: u64, count: u64) -> Option<Self> {
        (1..=count).contains(&number).then_some(Shard { number, count })
    }

    /// The cases of this part, of so many.
    pub fn range(self, cases: u64) -> Range<u64> {
        let end = |n: u64| {
            let end = u128::from(cases) * u128::from(n) / u128::from(self.count);
            // Not above the number of cases, since n ≤ count.
            end as u64
        };
        end(self.number - 1)..end(self.number)
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.count)
    }
}

/// The text is no part `i/n` with `1 ≤ i ≤ n`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoShard;

impl fmt::Display for NoShard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a shard is i/n with 1 <= i <= n")
    }
}

impl std::error::Error for NoShard {}

impl FromStr for Shard {
    type Err = NoShard;

    fn from_str(text: &str) -> Result<Self, NoShard> {
        let (number, count) = text.split_once('/').ok_or(NoShard)?;
        let parse = |text: &str| text.parse().map_err(|_| NoShard);
        Shard::new(parse(number)?, parse(count)?).ok_or(NoShard)
    }
}
