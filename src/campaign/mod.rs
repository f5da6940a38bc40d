//! Floor 9: campaigns — a property on millions of random cases, in shards (feature `campaigns`).
//!
//! A [`Property`] is a claim of the ledger or a [`Law`]. What a case is follows from the property, a
//! seed and an index alone: so cases may be run anywhere, in any order, and again.
//!
//! | file | holds |
//! | --- | --- |
//! | [`Campaign`] | cases of a property, run on all cores |
//! | [`Shard`] | its part of the cases, and its file: resumed where it ends, whole lines only |
//! | [`merge`] | what the shards found together: gaps, duplicates, an order-independent digest |
//! | [`Failure`], [`Case`] | a failing case, made small, as a file that says it again without the generator |
//!
//! ```
//! use isogeo::campaign::{Campaign, property};
//! use isogeo::claim::Seed;
//! let law = property("double-dual").ok_or("no such law")?;
//! let campaign = Campaign { property: law, seed: Seed::of(1), cases: 20 };
//! let all = campaign.tally(0..20, &|| false).ok_or("stopped")?;
//! assert!(all.failures.is_empty() && all.holds > 0);
//! // In two parts, the digest is the same.
//! let parts = [0..7, 7..20].map(|part| campaign.tally(part, &|| false).map(|t| t.digest));
//! let [Some(mut first), Some(second)] = parts else { return Err("stopped") };
//! first.add(&second);
//! assert_eq!(first, all.digest);
//! # Ok::<(), &str>(())
//! ```

mod case;
mod digest;
mod file;
mod instance;
mod law;
mod laws;
mod merge;
mod run;
mod shard;

pub use case::{Case, Failure, NoCase, holds};
pub use digest::Digest;
pub use file::{Block, ShardFile, UnfitFile};
pub use instance::{Instance, Parts, Source};
pub use law::Law;
pub use merge::{Merged, Merging, merge};
pub use run::{Campaign, Tally};
pub use shard::{NoShard, Shard};

use crate::claim::{self, Claim};

/// What a campaign is about.
#[derive(Clone, Copy, Debug)]
pub enum Property {
    /// A claim of the ledger: its evidence on random instances, over both exact scalars.
    Claim(&'static Claim),
    /// A law of the program.
    Law(&'static Law),
}

impl Property {
    /// Its name.
    pub fn id(self) -> &'static str {
        match self {
            Property::Claim(claim) => claim.id,
            Property::Law(law) => law.id,
        }
    }

    /// What it says, in words.
    pub fn says(self) -> &'static str {
        match self {
            Property::Claim(claim) => claim.statement,
            Property::Law(law) => law.says,
        }
    }
}

/// All properties: the claims of the ledger that have instances, then the laws.
pub fn properties() -> impl Iterator<Item = Property> {
    let sampled = |claim: &&Claim| claim.evidence.iter().any(|part| !part.sampled.is_empty());
    let laws = laws::all().filter(|law| !law.control);
    claim::claims().filter(sampled).map(Property::Claim).chain(laws.map(Property::Law))
}

/// The property of this name; also a control, which is false and is not listed.
pub fn property(id: &str) -> Option<Property> {
    let claims = claim::claims().map(Property::Claim);
    claims.chain(laws::all().map(Property::Law)).find(|property| property.id() == id)
}
