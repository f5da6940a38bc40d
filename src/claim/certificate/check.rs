//! The checker of `proofs/coq/program/Checker.v` once more: what it accepts, step by step.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use super::super::decide::Undecided;
use super::{Script, Step};
use crate::scalar::{Instruction, NodeId, Polynomial, Quotient, Quotients, TooLarge};

/// Something that vanishes since a relation does: `numerator = cofactor · relation`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Combination {
    /// What vanishes.
    pub says: String,
    /// Its numerator.
    pub numerator: Polynomial,
    /// The number of the relation.
    pub relation: usize,
    /// The quotient of both.
    pub cofactor: Polynomial,
}

/// What a script needs beyond its steps.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Findings {
    /// The hypotheses `≠ 0` that were needed, by their number among those.
    pub used: BTreeSet<usize>,
    /// The primes that must not vanish in the field, of which no needed hypothesis says so in time.
    pub integers: BTreeSet<i64>,
    /// The same, where all hypotheses are kept.
    pub missing: BTreeSet<i64>,
    /// The numerators of the relations.
    pub relations: Vec<Polynomial>,
    /// What vanishes by a relation.
    pub combinations: Vec<Combination>,
}

/// Why a script is not accepted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refused {
    /// This is not zero, or no hypothesis says so.
    NotZero(String),
    /// No hypothesis says that this is not zero, or that the divisor at this node is not.
    NotExcluded(String),
    /// A polynomial is too large.
    TooLarge(TooLarge),
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refused::NotZero(what) => write!(f, "not zero: {what}"),
            Refused::NotExcluded(what) => {
                write!(f, "no hypothesis says that it is not zero: {what}")
            }
            Refused::TooLarge(why) => write!(f, "{why}"),
        }
    }
}

impl From<TooLarge> for Refused {
    fn from(why: TooLarge) -> Self {
        Refused::TooLarge(why)
    }
}

impl From<Refused> for Undecided {
    fn from(why: Refused) -> Self {
        match why {
            Refused::NotZero(what) => Undecided::Goal(what),
            Refused::NotExcluded(place) => {
                Undecided::Condition { function: "a function".into(), place }
            }
            Refused::TooLarge(why) => Undecided::TooLarge(why),
        }
    }
}

#[derive(Default)]
struct Checker {
    quotients: Quotients,
    values: Vec<Quotient>,
    /// Numerators that are not zero, with their contents.
    stated: Vec<(i128, Polynomial)>,
    relations: Vec<Polynomial>,
    combinations: Vec<Combination>,
    used: BTreeSet<usize>,
    /// The primes that must not vanish, and how many hypotheses there were when one was needed first.
    primes: BTreeMap<i64, usize>,
}

impl Checker {
    fn numerator(&self, node: NodeId) -> Polynomial {
        self.values.get(node.index()).map(|q| q.numerator().clone()).unwrap_or_default()
    }

    /// Whether a function is not zero since it is made of divisors of what is stated.
    fn nonzero(&mut self, mut function: Polynomial) -> Result<bool, TooLarge> {
        loop {
            let content = function.content();
            if content == 0 {
                return Ok(false);
            }
            for prime in primes(content) {
                self.primes.entry(prime).or_insert(self.stated.len());
            }
            function = function.divided(content);
            if function.as_constant().is_some() {
                return Ok(true);
            }
            let mut rest = None;
            for (n, (_, stated)) in self.stated.iter().enumerate() {
                if stated.as_constant().is_none() && stated.exact_quotient(&function)?.is_some() {
                    rest = Some((n, Polynomial::constant(1)));
                    break;
                }
            }
            for (n, (_, stated)) in self.stated.iter().enumerate() {
                if rest.is_none()
                    && stated.as_constant().is_none()
                    && let Some(quotient) = function.exact_quotient(stated)?
                {
                    rest = Some((n, quotient));
                }
            }
            let Some((n, quotient)) = rest else { return Ok(false) };
            self.used.insert(n);
            function = quotient;
        }
    }

    /// Whether a function is zero or a multiple of a relation.
    fn vanishes(&mut self, numerator: &Polynomial, says: &str) -> Result<bool, TooLarge> {
        if numerator.is_zero() {
            return Ok(true);
        }
        for (n, relation) in self.relations.iter().enumerate() {
            if !relation.is_zero()
                && let Some(cofactor) = numerator.exact_quotient(relation)?
            {
                let (says, numerator) = (says.to_string(), numerator.clone());
                self.combinations.push(Combination { says, numerator, relation: n, cofactor });
                return Ok(true);
            }
        }
        Ok(false)
    }

    fn step(&mut self, step: &Step) -> Result<(), Refused> {
        match step {
            Step::Compute(instruction) => {
                if let Instruction::Div(_, divisor) = instruction
                    && !self.nonzero(self.numerator(*divisor))?
                {
                    let at = format!("the divisor at node {}", divisor.index());
                    return Err(Refused::NotExcluded(at));
                }
                let of = |n: NodeId| self.values.get(n.index()).cloned().unwrap_or_default();
                let value = self.quotients.step(*instruction, of)?;
                self.values.push(value);
            }
            Step::Nonzero(node, _) => {
                let numerator = self.numerator(*node);
                let content = numerator.content();
                // What is assumed of 0 is of no use.
                let content = if content == 0 { 1 } else { content };
                self.stated.push((content, numerator.divided(content)));
            }
            Step::Zero(node, _) => self.relations.push(self.numerator(*node)),
            Step::ShowNonzero(node, says) => {
                if !self.nonzero(self.numerator(*node))? {
                    return Err(Refused::NotExcluded(says.clone()));
                }
            }
            Step::ShowZero(node, says) => {
                if !self.vanishes(&self.numerator(*node), says)? {
                    return Err(Refused::NotZero(says.clone()));
                }
            }
        }
        Ok(())
    }
}

/// The prime factors of an integer; a large rest counts as one.
fn primes(n: i128) -> impl Iterator<Item = i64> {
    let mut rest = n.abs();
    let mut factors = BTreeSet::new();
    let mut candidate = 2;
    while rest > 1 && candidate < 1 << 12 {
        if rest % candidate == 0 {
            factors.insert(candidate);
            rest /= candidate;
        } else {
            candidate += 1;
        }
    }
    if rest > 1 {
        factors.insert(rest);
    }
    factors.into_iter().filter_map(|p| i64::try_from(p).ok())
}

impl Script {
    /// Decides the script, each value once.
    ///
    /// # Errors
    /// Where something that is shown does not follow, or a polynomial is too large.
    pub fn check(&self) -> Result<Findings, Refused> {
        let mut checker = Checker::default();
        for step in &self.steps {
            checker.step(step)?;
        }
        let Checker { stated, used, primes, relations, combinations, .. } = checker;
        let unsaid = |kept: &dyn Fn(usize) -> bool| {
            let says = |n: usize, prime: i64| kept(n) && stated[n].0 % i128::from(prime) == 0;
            let unsaid = primes.iter().filter(|(p, before)| !(0..**before).any(|n| says(n, **p)));
            unsaid.map(|(prime, _)| *prime).collect()
        };
        let (integers, missing) = (unsaid(&|n| used.contains(&n)), unsaid(&|_| true));
        Ok(Findings { used, integers, missing, relations, combinations })
    }

    /// Whether the checker accepts it as it stands.
    pub fn is_accepted(&self) -> bool {
        self.check().is_ok_and(|findings| findings.missing.is_empty())
    }
}
