//! Normal forms: every node of a program as a quotient of polynomials.
//!
//! Denominators are kept as products of the factors that the program divided by. After each
//! operation the factors that divide the numerator are cancelled by trial; no greatest common
//! divisor of polynomials is ever needed, and the zero function has the numerator 0 whatever was
//! not cancelled.

use std::collections::{BTreeMap, HashMap};

use num_integer::Integer;

use super::polynomial::integer;
use super::{Instruction, NodeId, Polynomial, Program, TooLarge};
use crate::scalar::Field;

/// A quotient `numerator / (integer · Π factorᵢ^eᵢ)` of polynomials in the unknowns of a slice,
/// which are numbered in the order in which the program meets them.
#[derive(Clone, Debug)]
pub struct Quotient {
    numerator: Polynomial,
    integer: i128,
    denominator: Powers,
}

/// Factors by number, with their powers.
type Powers = BTreeMap<usize, u32>;

impl Quotient {
    /// Whether it is the zero function.
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// The numerator.
    pub fn numerator(&self) -> &Polynomial {
        &self.numerator
    }
}

/// Zero.
impl Default for Quotient {
    fn default() -> Self {
        Polynomial::default().into()
    }
}

impl From<Polynomial> for Quotient {
    fn from(numerator: Polynomial) -> Self {
        Quotient { numerator, integer: 1, denominator: Powers::new() }
    }
}

/// The field of quotients, with the factors that were divided by so far.
#[derive(Debug, Default)]
pub(crate) struct Quotients {
    factors: Vec<Polynomial>,
}

/// The normal forms of the goals of a program.
#[derive(Debug, Default)]
pub struct NormalForms {
    quotients: Quotients,
    by_node: HashMap<NodeId, Quotient>,
}

impl NormalForms {
    /// Those of the goals.
    ///
    /// # Errors
    /// Where a polynomial grows beyond the bounds of [`TooLarge`], or a divisor is zero.
    pub fn of(program: &Program, goals: &[NodeId]) -> Result<Self, TooLarge> {
        let slice = program.slice(goals);
        let mut last_use: HashMap<NodeId, NodeId> = HashMap::new();
        for node in program.nodes().filter(|n| slice[n.index()]) {
            let operands = program.instruction(node).operands();
            last_use.extend(operands.map(|operand| (operand, node)));
        }
        for goal in goals {
            last_use.remove(goal);
        }
        let mut forms = NormalForms::default();
        let mut unknowns = 0;
        for node in program.nodes().filter(|n| slice[n.index()]) {
            let instruction = program.instruction(node);
            if let Instruction::Unknown(_) = instruction {
                unknowns += 1;
            }
            let form = forms.step(instruction, unknowns)?;
            forms.by_node.insert(node, form);
            for operand in instruction.operands() {
                if last_use.get(&operand) == Some(&node) {
                    forms.by_node.remove(&operand);
                }
            }
        }
        Ok(forms)
    }

    /// The normal form of a goal; `None` for other nodes.
    pub fn quotient(&self, goal: NodeId) -> Option<&Quotient> {
        self.by_node.get(&goal)
    }

    /// The value of the normal form of a goal; `None` for other nodes, and where its denominator
    /// vanishes.
    pub fn evaluate<T: Field>(&self, goal: NodeId, unknowns: &[T]) -> Option<T> {
        let form = self.quotient(goal)?;
        let mut denominator = integer(form.integer);
        for (&factor, &power) in &form.denominator {
            let value: T = self.quotients.factors[factor].evaluate(unknowns);
            denominator = (0..power).fold(denominator, |product, _| product * &value);
        }
        form.numerator.evaluate(unknowns).try_div(&denominator)
    }

    fn step(&mut self, instruction: Instruction, unknowns: usize) -> Result<Quotient, TooLarge> {
        if let Instruction::Unknown(_) = instruction {
            return Ok(Polynomial::unknown(unknowns - 1)?.into());
        }
        let operand = |node| self.by_node.get(&node).cloned().unwrap_or_default();
        match instruction {
            Instruction::Div(_, divisor) if operand(divisor).is_zero() => {
                Err(TooLarge::ZeroDivisor(divisor))
            }
            instruction => self.quotients.step(instruction, operand),
        }
    }
}

impl Quotients {
    /// The result of an instruction, where those of its operands are given; no divisor is 0.
    ///
    /// # Errors
    /// Where a polynomial grows beyond the bounds of [`TooLarge`].
    pub(crate) fn step(
        &mut self,
        instruction: Instruction,
        of: impl Fn(NodeId) -> Quotient,
    ) -> Result<Quotient, TooLarge> {
        Ok(match instruction {
            Instruction::Unknown(n) => Polynomial::unknown(n as usize)?.into(),
            Instruction::Constant(n) => Polynomial::constant(n.into()).into(),
            Instruction::Add(a, b) => self.sum(&of(a), &of(b))?,
            Instruction::Sub(a, b) => self.sum(&of(a), &opposite(of(b))?)?,
            Instruction::Neg(a) => opposite(of(a))?,
            Instruction::Mul(a, b) => self.product(of(a), of(b))?,
            Instruction::Div(a, b) => self.ratio(of(a), &of(b))?,
        })
    }

    fn sum(&self, a: &Quotient, b: &Quotient) -> Result<Quotient, TooLarge> {
        let integer = a.integer.lcm(&b.integer);
        let mut denominator = a.denominator.clone();
        for (&factor, &power) in &b.denominator {
            let greater = denominator.entry(factor).or_insert(power);
            *greater = power.max(*greater);
        }
        let over = |q: &Quotient| {
            let mut numerator = q.numerator.scaled(integer / q.integer)?;
            for (&factor, &power) in &denominator {
                let missing = power - q.denominator.get(&factor).unwrap_or(&0);
                numerator = self.times_power(numerator, factor, missing)?;
            }
            Ok::<_, TooLarge>(numerator)
        };
        let numerator = over(a)?.plus(&over(b)?)?;
        let mut sum = Quotient { numerator, integer, denominator };
        // Only a factor of both, in the same power, may divide the sum.
        let shared = |(f, p): (&usize, &u32)| (b.denominator.get(f) == Some(p)).then_some(*f);
        for factor in a.denominator.iter().filter_map(shared) {
            self.cancel(&mut sum.numerator, &mut sum.denominator, factor)?;
        }
        Ok(sum.reduced())
    }

    fn product(&self, mut a: Quotient, mut b: Quotient) -> Result<Quotient, TooLarge> {
        for factor in b.denominator.keys().copied().collect::<Vec<_>>() {
            self.cancel(&mut a.numerator, &mut b.denominator, factor)?;
        }
        for factor in a.denominator.keys().copied().collect::<Vec<_>>() {
            self.cancel(&mut b.numerator, &mut a.denominator, factor)?;
        }
        let (shorter, longer) = if a.numerator.len() < b.numerator.len() {
            (&a.numerator, &b.numerator)
        } else {
            (&b.numerator, &a.numerator)
        };
        let numerator = longer.product(shorter)?;
        let integer = a.integer.checked_mul(b.integer).ok_or(TooLarge::Coefficient)?;
        let mut denominator = a.denominator;
        for (factor, power) in b.denominator {
            *denominator.entry(factor).or_insert(0) += power;
        }
        Ok(Quotient { numerator, integer, denominator }.reduced())
    }

    /// `a / b` for `b` not zero: the numerator of `b` is split into factors.
    fn ratio(&mut self, mut a: Quotient, b: &Quotient) -> Result<Quotient, TooLarge> {
        let (content, powers) = self.split(b.numerator.clone())?;
        let mut above = b.denominator.clone();
        for (factor, power) in &mut above {
            let below = a.denominator.entry(*factor).or_insert(0);
            let common = (*below).min(*power);
            *below -= common;
            *power -= common;
        }
        for (factor, power) in powers {
            *a.denominator.entry(factor).or_insert(0) += power;
            self.cancel(&mut a.numerator, &mut a.denominator, factor)?;
        }
        for (factor, power) in above {
            a.numerator = self.times_power(a.numerator, factor, power)?;
        }
        a.denominator.retain(|_, power| *power > 0);
        let sign = content.signum();
        a.numerator =
            a.numerator.scaled(sign.checked_mul(b.integer).ok_or(TooLarge::Coefficient)?)?;
        a.integer = a.integer.checked_mul(content * sign).ok_or(TooLarge::Coefficient)?;
        Ok(a.reduced())
    }

    /// A polynomial, not 0, as its content times powers of factors; what no known factor divides
    /// becomes a new one.
    fn split(&mut self, polynomial: Polynomial) -> Result<(i128, Powers), TooLarge> {
        let content = polynomial.content();
        let mut rest = polynomial.divided(content);
        for unknown in rest.common_unknowns() {
            if !self.factors.contains(&unknown) {
                self.factors.push(unknown);
            }
        }
        let mut powers = Powers::new();
        for (n, factor) in self.factors.iter().enumerate() {
            while rest.as_constant().is_none()
                && let Some(quotient) = rest.exact_quotient(factor)?
            {
                rest = quotient;
                *powers.entry(n).or_insert(0) += 1;
            }
        }
        let sign = rest.as_constant().unwrap_or(1);
        if rest.as_constant().is_none() {
            powers.insert(self.factors.len(), 1);
            self.factors.push(rest);
        }
        Ok((content * sign, powers))
    }

    /// Cancels a factor of the denominator as often as it divides the numerator.
    fn cancel(
        &self,
        numerator: &mut Polynomial,
        denominator: &mut Powers,
        factor: usize,
    ) -> Result<(), TooLarge> {
        if let Some(power) = denominator.get_mut(&factor) {
            while *power > 0
                && let Some(quotient) = numerator.exact_quotient(&self.factors[factor])?
            {
                *numerator = quotient;
                *power -= 1;
            }
            if *power == 0 {
                denominator.remove(&factor);
            }
        }
        Ok(())
    }

    fn times_power(
        &self,
        mut polynomial: Polynomial,
        factor: usize,
        power: u32,
    ) -> Result<Polynomial, TooLarge> {
        for _ in 0..power {
            polynomial = polynomial.product(&self.factors[factor])?;
        }
        Ok(polynomial)
    }
}

impl Quotient {
    /// Without the common factor of the integers; zero is 0 / 1.
    fn reduced(self) -> Self {
        if self.is_zero() {
            return Polynomial::default().into();
        }
        let common = self.numerator.content().gcd(&self.integer);
        let integer = self.integer / common;
        Quotient { numerator: self.numerator.divided(common), integer, ..self }
    }
}

fn opposite(q: Quotient) -> Result<Quotient, TooLarge> {
    Ok(Quotient { numerator: q.numerator.scaled(-1)?, ..q })
}
