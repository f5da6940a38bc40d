//! What a check answers.

use std::fmt;

/// The answer of a check; never a bare yes or no.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// Every residual is exactly zero, and at least one was looked at.
    Proved,
    /// At least one residual is not zero, whatever the unprinted digits were.
    Refuted,
    /// Not exactly zero as printed, but for every element by itself zero cannot be excluded for
    /// the box of numbers that the printed digits stand for.
    Consistent,
    /// A stored certificate was verified again: an exact mesh with the property lies within the
    /// stated distance of this one.
    Exists,
    /// Nothing refuted, but something could not be decided, or only within a tolerance.
    Undecided,
    /// There was nothing to check.
    Vacuous,
}

impl Verdict {
    /// The word in reports and JSON.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Proved => "proved",
            Verdict::Refuted => "refuted",
            Verdict::Consistent => "consistent",
            Verdict::Exists => "exists",
            Verdict::Undecided => "undecided",
            Verdict::Vacuous => "vacuous",
        }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}
