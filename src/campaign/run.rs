//! Running cases on all cores.

use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use rayon::ThreadPoolBuilder;

use super::Property;
use super::digest::Digest;
use super::instance::write_small;
use super::law::Cases;
use crate::claim::{self, Claim, Run, Seed, Stop};

/// So many cases of a property, from a seed.
#[derive(Clone, Copy, Debug)]
pub struct Campaign {
    /// What is looked at.
    pub property: Property,
    /// Where all that is random comes from.
    pub seed: Seed,
    /// The number of cases.
    pub cases: u64,
}

/// What some cases showed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Cases on which the property holds.
    pub holds: u64,
    /// Cases outside of its hypotheses.
    pub excluded: u64,
    /// Cases on which it fails, with what fails, by index.
    pub failures: Vec<(u64, String)>,
    /// The sum of the hashes of all cases with their outcomes.
    pub digest: Digest,
}

impl Tally {
    /// The number of cases.
    pub fn cases(&self) -> u64 {
        self.holds + self.excluded + self.failures.len() as u64
    }

    /// Adds what other cases showed.
    pub fn add(&mut self, other: Tally) {
        self.holds += other.holds;
        self.excluded += other.excluded;
        self.failures.extend(other.failures);
        self.digest.add(&other.digest);
    }
}

/// What one thread keeps from case to case.
pub(super) enum Runner {
    Claim(&'static Claim),
    Law(&'static str, Box<dyn Cases>),
}

impl Runner {
    pub fn new(property: Property) -> Self {
        match property {
            Property::Claim(claim) => Runner::Claim(claim),
            Property::Law(law) => Runner::Law(law.id, (law.cases)()),
        }
    }

    /// Runs one case; appends what it consists of.
    pub fn run(&self, seed: Seed, index: u64, bytes: &mut Vec<u8>) -> Run {
        match self {
            Runner::Claim(claim) => {
                let instance = claim::Instance::new(claim, seed, index);
                let instance = instance.ok_or(Stop::Excluded("there are no instances"))?;
                instance.run(|number| write_small(bytes, number.unwrap_or_default()))
            }
            Runner::Law(id, cases) => cases.run(&seed.bytes(id, index), bytes),
        }
    }
}

impl Campaign {
    /// Runs the cases of these indices on all cores; `None` where `stop` said so in between.
    ///
    /// The tally does not depend on the number of threads.
    pub fn tally(&self, indices: Range<u64>, stop: &(dyn Fn() -> bool + Sync)) -> Option<Tally> {
        /// Cases that a thread takes at once.
        const SHARE: u64 = 16;
        let next = AtomicU64::new(indices.start);
        let total = Mutex::new(Tally::default());
        let work = || {
            let (runner, mut own) = (Runner::new(self.property), Tally::default());
            let mut bytes = Vec::new();
            loop {
                let start = next.fetch_add(SHARE, Ordering::Relaxed);
                if start >= indices.end || stop() {
                    break;
                }
                for index in start..indices.end.min(start + SHARE) {
                    self.case(&runner, index, &mut bytes, &mut own);
                }
            }
            // A thread that panics has no share, so that the count below shows it.
            if let Ok(mut total) = total.lock() {
                total.add(own);
            }
        };
        let threads = rayon::current_num_threads();
        thread::scope(|scope| {
            for _ in 0..threads {
                // Inside of a pool of one thread, what the code under test does in parallel stays there.
                let pool = ThreadPoolBuilder::new().num_threads(1).build();
                scope.spawn(|| match pool {
                    Ok(pool) => pool.install(work),
                    Err(_) => work(),
                });
            }
        });
        let mut tally = total.into_inner().ok()?;
        tally.failures.sort_unstable();
        (tally.cases() == indices.end - indices.start).then_some(tally)
    }

    fn case(&self, runner: &Runner, index: u64, bytes: &mut Vec<u8>, tally: &mut Tally) {
        bytes.clear();
        bytes.extend_from_slice(&index.to_le_bytes());
        let outcome = match runner.run(self.seed, index, bytes) {
            Ok(()) => {
                tally.holds += 1;
                0
            }
            Err(Stop::Excluded(_)) => {
                tally.excluded += 1;
                1
            }
            Err(Stop::Failed(why)) => {
                tally.failures.push((index, why.into_owned()));
                2
            }
        };
        bytes.push(outcome);
        tally.digest.add(&Digest::of(bytes));
    }
}
