//! Deciding: the evidence is recorded on symbols, and its goals vanish as rational functions.

use std::collections::BTreeSet;
use std::fmt;
use std::panic::Location;
use std::time::{Duration, Instant};

use super::draw::Seed;
use super::trial::{Assumption, Stop, Trial};
use super::{Claim, Evidence, Grade};
use crate::scalar::{
    BigRational, NodeId, NormalForms, Outcome, Polynomial, Program, Ring, Symbol, TooLarge, record,
};

/// The shadows are no evidence; any seed does.
const SHADOWS: u64 = 1;

/// How often the shadows are drawn anew where they fall on an exception.
const ATTEMPTS: u64 = 4;

/// A piece of evidence, recorded.
#[derive(Debug)]
pub(super) struct Record {
    pub(super) program: Program,
    pub(super) goals: Vec<(String, NodeId)>,
    pub(super) relations: Vec<(&'static str, NodeId)>,
    pub(super) conditions: Vec<Assumption<NodeId>>,
}

/// A condition under which the recorded code does what it did.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Condition {
    /// The hypotheses from which it follows.
    pub hypothesis: &'static str,
    /// How many divisions and comparisons needed it.
    pub uses: usize,
}

/// What was decided of one piece of evidence, at one size.
#[derive(Clone, Debug)]
pub struct Decision {
    /// The size.
    pub size: usize,
    /// [`Grade::DecidedUpTo`] or [`Grade::Decided`]; [`Grade::Certified`] where Coq agrees.
    pub grade: Grade,
    /// The number of goals, obligations of zero tests included.
    pub goals: usize,
    /// The unknowns.
    pub unknowns: usize,
    /// The instructions that the goals need.
    pub instructions: usize,
    /// The bound of the probability of error is 2 to this power; `None` where there is no error.
    pub error: Option<i64>,
    /// The side conditions.
    pub conditions: Vec<Condition>,
    /// The source files whose code it ran.
    pub files: Vec<String>,
    /// How long it took.
    pub time: Duration,
}

/// Why a claim is not decided.
#[derive(Clone, Debug, PartialEq)]
pub enum Undecided {
    /// The evidence has no identity, or none at this size.
    Nothing,
    /// The run ended before its goals.
    Stopped(Stop),
    /// This goal is not zero.
    Goal(String),
    /// Code took this for zero, and it is not.
    Branch(String),
    /// Code divides by this, or takes it for non-zero, and no hypothesis says so.
    Condition {
        /// The function, where it is small.
        function: String,
        /// Where it is used.
        place: String,
    },
    /// Code asked for a sign there: a claim over any field cannot.
    Order(String),
    /// There is no normal form.
    TooLarge(TooLarge),
}

impl fmt::Display for Undecided {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Undecided::Nothing => write!(f, "nothing to decide"),
            Undecided::Stopped(Stop::Excluded(hypothesis)) => {
                write!(f, "it never holds that {hypothesis}")
            }
            Undecided::Stopped(Stop::Failed(why)) => write!(f, "{why}"),
            Undecided::Goal(goal) => write!(f, "not zero: {goal}"),
            Undecided::Branch(place) => write!(f, "taken for zero, but is not: {place}"),
            Undecided::Condition { function, place } => {
                write!(f, "no hypothesis says {function} != 0, which {place} needs")
            }
            Undecided::Order(place) => write!(f, "{place} asks for a sign"),
            Undecided::TooLarge(why) => write!(f, "no normal form: {why}"),
        }
    }
}

impl From<TooLarge> for Undecided {
    fn from(why: TooLarge) -> Self {
        Undecided::TooLarge(why)
    }
}

pub(super) fn place(at: &Location<'_>) -> String {
    format!("{}:{}", at.file(), at.line())
}

impl Record {
    /// Runs the evidence on symbols.
    pub(super) fn of(evidence: &Evidence, size: usize) -> Result<Self, Undecided> {
        let run = evidence.runs.symbol.ok_or(Undecided::Nothing)?;
        let mut last = Undecided::Nothing;
        for attempt in 0..ATTEMPTS {
            let mut shadows = Seed::of(SHADOWS).source(evidence.shows, attempt);
            let ((stopped, trial), program) = record(|| {
                let draw = move || Symbol::unknown(shadows.shadow());
                let mut trial = Trial::new(size, draw).forgetting(|value| value.forgotten());
                let stopped = run(&mut trial).err();
                (stopped, trial)
            });
            match stopped {
                None => {
                    let goals =
                        trial.goals.iter().map(|(name, goal)| (name.to_string(), goal.node()));
                    return Ok(Record {
                        program,
                        goals: goals.collect(),
                        relations: trial
                            .relations
                            .iter()
                            .map(|(says, r)| (*says, r.node()))
                            .collect(),
                        conditions: {
                            let known = trial.conditions.into_iter();
                            known.map(|c| c.map(Symbol::node)).collect()
                        },
                    });
                }
                Some(stop @ Stop::Failed(_)) => return Err(Undecided::Stopped(stop)),
                Some(stop) => last = Undecided::Stopped(stop),
            }
        }
        Err(last)
    }

    /// The files of the library whose operations the nodes need, from `src` on.
    pub(super) fn files(&self, nodes: &[NodeId]) -> Vec<String> {
        let slice = self.program.slice(nodes);
        let nodes = self.program.nodes().filter(|n| slice[n.index()]);
        let files: BTreeSet<String> =
            nodes.map(|n| self.program.place(n).file().replace('\\', "/")).collect();
        files.into_iter().filter(|file| is_library(file)).collect()
    }
}

/// Whether a source file is code that claims are about: neither theirs nor that of the recorder.
pub(super) fn is_library(file: &str) -> bool {
    let of_claims = ["src/claim/", "src/scalar/symbol/"];
    file.starts_with("src/") && !of_claims.iter().any(|folder| file.starts_with(folder))
}

/// Decides a piece of evidence of a claim at one size.
///
/// # Errors
/// See [`Undecided`].
pub(super) fn decide(
    claim: &Claim,
    evidence: &Evidence,
    size: usize,
    seed: Seed,
) -> Result<Decision, Undecided> {
    let start = Instant::now();
    let record = Record::of(evidence, size)?;
    if record.goals.is_empty() {
        return Err(Undecided::Nothing);
    }
    let program = &record.program;
    // What has to vanish: the goals, and whatever a comparison took for zero.
    let mut vanishing = record.goals.clone();
    for branch in program.branches() {
        match branch.outcome {
            Outcome::Zero => vanishing.push((place(branch.place), branch.node)),
            Outcome::Sign(_) => return Err(Undecided::Order(place(branch.place))),
            Outcome::NotZero => {}
        }
    }
    let nodes: Vec<NodeId> = vanishing.iter().map(|v| v.1).collect();
    let slice = program.slice(&nodes);
    let decision = |grade, error, conditions| Decision {
        size,
        grade,
        goals: nodes.len(),
        unknowns: program.unknowns(),
        instructions: slice.iter().filter(|needed| **needed).count(),
        error,
        conditions,
        files: record.files(&nodes),
        time: start.elapsed(),
    };
    // What must not vanish: divisors, and whatever a comparison took for different from zero.
    // The hypotheses have to be defined, too.
    let mut needed = nodes.clone();
    needed.extend(record.relations.iter().map(|r| r.1));
    needed.extend(record.conditions.iter().map(|c| c.value));
    let divisors = program.divisors(&program.slice(&needed)).into_iter();
    let mut excluded: Vec<(NodeId, String)> =
        divisors.map(|(divisor, at)| (divisor, place(program.place(at)))).collect();
    let compared = program.branches().iter().filter(|b| b.outcome == Outcome::NotZero);
    excluded.extend(compared.map(|b| (b.node, place(b.place))));

    let mut asked = needed;
    asked.extend(excluded.iter().map(|e| e.0));
    let forms = match NormalForms::of(program, &asked) {
        Ok(forms) => forms,
        Err(why @ TooLarge::ZeroDivisor(_)) => return Err(why.into()),
        Err(why) if !record.relations.is_empty() => return Err(why.into()),
        Err(_) => {
            let error = at_a_random_point(program, &vanishing, seed)?;
            let uses = excluded.len();
            let uncompared = Condition { hypothesis: "conditions not compared", uses };
            return Ok(decision(Grade::DecidedUpTo, Some(error), vec![uncompared]));
        }
    };
    let numerator = |node| forms.quotient(node).map(|q| q.numerator().clone()).unwrap_or_default();
    let relations: Vec<Polynomial> = record.relations.iter().map(|r| numerator(r.1)).collect();
    for (n, (name, node)) in vanishing.iter().enumerate() {
        if !vanishes(&numerator(*node), &relations)? {
            let known = n < record.goals.len();
            return Err(if known { Undecided::Goal } else { Undecided::Branch }(name.clone()));
        }
    }
    let stated: Vec<(&'static str, Polynomial)> =
        record.conditions.iter().map(|c| (c.says, numerator(c.value))).collect();
    let mut conditions: Vec<Condition> = Vec::new();
    for (node, place) in excluded {
        let function = numerator(node);
        let Some(hypotheses) = follows(function.clone(), &stated)? else {
            let small = function.len() <= 12;
            let function = if small {
                function.to_string()
            } else {
                format!("a function of {} terms", function.len())
            };
            return Err(Undecided::Condition { function, place });
        };
        for hypothesis in hypotheses {
            match conditions.iter_mut().find(|c| c.hypothesis == hypothesis) {
                Some(condition) => condition.uses += 1,
                None => conditions.push(Condition { hypothesis, uses: 1 }),
            }
        }
    }
    let known = |name: &str| claim.hypotheses.iter().any(|h| h.says == name);
    if let Some(unknown) = record.conditions.iter().find(|c| c.hypothesis && !known(c.says)) {
        let function = unknown.says.into();
        return Err(Undecided::Condition { function, place: "the evidence".into() });
    }
    Ok(decision(Grade::Decided, None, conditions))
}

/// Whether a polynomial is zero or a multiple of a relation.
fn vanishes(numerator: &Polynomial, relations: &[Polynomial]) -> Result<bool, TooLarge> {
    if numerator.is_zero() {
        return Ok(true);
    }
    for relation in relations {
        if !relation.is_zero() && numerator.exact_quotient(relation)?.is_some() {
            return Ok(true);
        }
    }
    Ok(false)
}

/// The hypotheses by which a function is not zero: it is a constant, or made of factors of
/// functions that are stated to be non-zero. `None` where it does not follow.
fn follows(
    mut function: Polynomial,
    stated: &[(&'static str, Polynomial)],
) -> Result<Option<Vec<&'static str>>, TooLarge> {
    let mut used = Vec::new();
    while function.as_constant().is_none() {
        function = function.clone().divided(function.content());
        let mut rest = None;
        for (name, condition) in stated {
            if condition.as_constant().is_some() {
                continue;
            }
            let primitive = condition.clone().divided(condition.content());
            if primitive.exact_quotient(&function)?.is_some() {
                rest = Some((*name, Polynomial::constant(1)));
                break;
            }
            if let Some(quotient) = function.exact_quotient(&primitive)? {
                rest = Some((*name, quotient));
                break;
            }
        }
        let Some((name, quotient)) = rest else { return Ok(None) };
        used.push(name);
        function = quotient;
    }
    Ok((!function.is_zero()).then_some(used))
}

/// Evaluates at random integers of 256 bits; gives the power of two above the probability that a
/// function which is not zero vanishes there (Schwartz, Zippel).
fn at_a_random_point(
    program: &Program,
    vanishing: &[(String, NodeId)],
    seed: Seed,
) -> Result<i64, Undecided> {
    let mut source = seed.source("a random point", 0);
    let point: Vec<BigRational> = (0..program.unknowns()).map(|_| source.wide()).collect();
    let nodes: Vec<NodeId> = vanishing.iter().map(|v| v.1).collect();
    let values = program.evaluate(&point, &nodes).ok_or(Undecided::Nothing)?;
    if let Some(n) = values.iter().position(|value| !Ring::is_zero(value)) {
        return Err(Undecided::Goal(vanishing[n].0.clone()));
    }
    let degrees = program.degrees();
    let worst = nodes.iter().map(|n| degrees[n.index()].numerator).fold(0.0, f64::max);
    let bits = (worst * nodes.len() as f64).log2().ceil() as i64 - 256;
    if bits <= -128 { Ok(bits) } else { Err(Undecided::TooLarge(TooLarge::Exponent)) }
}
