//! Laws: what holds on everything that a strategy makes.

use std::fmt;

use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

use super::instance::{Instance, Parts, Source};
use crate::claim::{Run, Stop, caught};

/// A statement about the program that holds on all that a strategy makes.
#[derive(Clone, Copy)]
pub struct Law {
    /// Its name.
    pub id: &'static str,
    /// What it says, in words.
    pub says: &'static str,
    /// Whether it is false, to see what a failure looks like; it is not listed.
    pub control: bool,
    pub(super) cases: fn() -> Box<dyn Cases>,
}

impl fmt::Debug for Law {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Law").field("id", &self.id).finish_non_exhaustive()
    }
}

/// The cases of a law.
pub(super) trait Cases: Send + Sync {
    /// Runs the case of a seed; appends what it consists of.
    fn run(&self, seed: &[u8; 32], bytes: &mut Vec<u8>) -> Run;

    /// What the case of a seed consists of.
    fn parts(&self, seed: &[u8; 32]) -> Parts;

    /// The parts of a failing case with what fails, the simplest that is found in some attempts.
    fn failure(&self, seed: &[u8; 32], attempts: usize) -> Option<(Parts, String)>;

    /// Runs a case that is given by its parts; `None` where they do not fit.
    fn again(&self, parts: Parts) -> Option<Run>;
}

/// What a strategy makes with what holds on it.
struct Drawn<S: Strategy> {
    strategy: S,
    judge: fn(&S::Value) -> Run,
}

/// The cases that a strategy makes, judged by a function.
pub(super) fn drawn<S>(strategy: S, judge: fn(&S::Value) -> Run) -> Box<dyn Cases>
where
    S: Strategy<Value: Instance> + Send + Sync + 'static,
{
    Box::new(Drawn { strategy, judge })
}

impl<S: Strategy<Value: Instance>> Drawn<S> {
    fn tree(&self, seed: &[u8; 32]) -> Result<S::Tree, Stop> {
        let config = Config { failure_persistence: None, ..Config::default() };
        let rng = TestRng::from_seed(RngAlgorithm::ChaCha, seed);
        let tree = self.strategy.new_tree(&mut TestRunner::new_with_rng(config, rng));
        tree.map_err(|_| Stop::Excluded("the strategy makes nothing"))
    }

    fn judged(&self, value: &S::Value) -> Run {
        caught(|| (self.judge)(value))
    }
}

impl<S> Cases for Drawn<S>
where
    S: Strategy<Value: Instance> + Send + Sync,
{
    fn run(&self, seed: &[u8; 32], bytes: &mut Vec<u8>) -> Run {
        let value = self.tree(seed)?.current();
        parts_of(&value).write(bytes);
        self.judged(&value)
    }

    fn parts(&self, seed: &[u8; 32]) -> Parts {
        self.tree(seed).map_or_else(|_| Parts::default(), |tree| parts_of(&tree.current()))
    }

    fn failure(&self, seed: &[u8; 32], attempts: usize) -> Option<(Parts, String)> {
        let mut tree = self.tree(seed).ok()?;
        let failure = |tree: &S::Tree| {
            let value = tree.current();
            match self.judged(&value) {
                Err(Stop::Failed(why)) => Some((parts_of(&value), why.into_owned())),
                _ => None,
            }
        };
        let mut best = failure(&tree)?;
        let mut simplify = true;
        for _ in 0..attempts {
            if !(if simplify { tree.simplify() } else { tree.complicate() }) {
                break;
            }
            let found = failure(&tree);
            simplify = found.is_some();
            best = found.unwrap_or(best);
        }
        Some(best)
    }

    fn again(&self, parts: Parts) -> Option<Run> {
        let value = S::Value::take(&mut Source::from(parts))?;
        Some(self.judged(&value))
    }
}

fn parts_of(value: &impl Instance) -> Parts {
    let mut parts = Parts::default();
    value.put(&mut parts);
    parts
}
