//! Graphs given by a formula in x and y.

mod parse;
mod taylor;

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

use super::{ContactElement, Gradient, Graph, Hessian, Jet2, Polynomial, TopView};
use crate::scalar::{Approx, Field, Numeral, Rational, Ring};
use taylor::Taylor;

/// The graph `z = f(x, y)` of a formula: rational numbers, x, y, `+ - * /`, powers with whole
/// exponents, and `sin`, `cos`, `exp`, `sqrt`, `log`.
///
/// A formula without functions is evaluated exactly; with functions in doubles, and then its
/// values are rounded.
///
/// ```
/// use isogeo::scalar::{Field, Rational, Ring};
/// use isogeo::space::{Expression, TopView};
/// let saddle: Expression = "x^2/2 - 0.1*x*y".parse()?;
/// let at = TopView::new(Rational::from_i64(2), Rational::from_i64(1));
/// assert_eq!(saddle.height_at(&at), Some(Rational::from_ratio(9, 5)));
/// assert_eq!(saddle.to_polynomial().unwrap().terms().count(), 2);
/// let error = "x + (2".parse::<Expression>().unwrap_err();
/// assert_eq!((error.span, error.message.as_str()), (6..6, "the parenthesis is not closed"));
/// # Ok::<(), isogeo::space::ExpressionError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Expression {
    /// What a machine with a stack does, so that nothing recurs however long the formula is.
    steps: Vec<Step>,
}

/// One step of the machine: operations take their operands from the stack.
#[derive(Clone, Debug, PartialEq)]
enum Step {
    Number(Rational),
    X,
    Y,
    Negate,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power(i32),
    Call(Function),
}

/// A function that is evaluated in doubles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Function {
    Sin,
    Cos,
    Exp,
    Sqrt,
    Log,
}

/// Why a text is no formula, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExpressionError {
    /// The bytes in question.
    pub span: Range<usize>,
    /// What is wrong there.
    pub message: String,
}

impl fmt::Display for ExpressionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "at character {}: {}", self.span.start + 1, self.message)
    }
}

impl std::error::Error for ExpressionError {}

impl FromStr for Expression {
    type Err = ExpressionError;

    fn from_str(text: &str) -> Result<Self, ExpressionError> {
        parse::parse(text).map(|steps| Expression { steps })
    }
}

/// What a formula can be evaluated in.
trait Value: Clone {
    fn number(number: &Rational) -> Self;
    fn plus(&self, other: &Self) -> Self;
    fn times(&self, other: &Self) -> Self;
    fn negative(&self) -> Self;
    fn over(&self, other: &Self) -> Option<Self>;
    fn call(&self, function: Function) -> Option<Self>;
}

/// The numbers of coordinates: with value and two derivatives of a function, where it has them.
trait Number: Field {
    fn of(number: &Rational) -> Self;
    fn function(&self, function: Function) -> Option<[Self; 3]>;
}

impl Number for Rational {
    fn of(number: &Rational) -> Self {
        number.clone()
    }

    fn function(&self, _: Function) -> Option<[Self; 3]> {
        None
    }
}

impl Number for f64 {
    fn of(number: &Rational) -> Self {
        number.to_f64()
    }

    fn function(&self, function: Function) -> Option<[Self; 3]> {
        let x = *self;
        Some(match function {
            Function::Sin => [x.sin(), x.cos(), -x.sin()],
            Function::Cos => [x.cos(), -x.sin(), -x.cos()],
            Function::Exp => [x.exp(); 3],
            Function::Sqrt => [x.sqrt(), 0.5 / x.sqrt(), -0.25 / (x * x.sqrt())],
            Function::Log => [x.ln(), 1.0 / x, -1.0 / (x * x)],
        })
    }
}

impl<T: Number> Value for T {
    fn number(number: &Rational) -> Self {
        T::of(number)
    }

    fn plus(&self, other: &Self) -> Self {
        self + other
    }

    fn times(&self, other: &Self) -> Self {
        self * other
    }

    fn negative(&self) -> Self {
        -self
    }

    fn over(&self, other: &Self) -> Option<Self> {
        self.try_div(other)
    }

    fn call(&self, function: Function) -> Option<Self> {
        self.function(function).map(|[value, ..]| value)
    }
}

impl Value for Polynomial<Rational> {
    fn number(number: &Rational) -> Self {
        Polynomial::constant(number)
    }

    fn plus(&self, other: &Self) -> Self {
        self + other
    }

    fn times(&self, other: &Self) -> Self {
        self * other
    }

    fn negative(&self) -> Self {
        -self
    }

    /// By a constant that is not 0.
    fn over(&self, other: &Self) -> Option<Self> {
        match other.terms().collect::<Vec<_>>().as_slice() {
            [(0, 0, a)] => a.try_inv().map(|inverse| self * Polynomial::constant(&inverse)),
            _ => None,
        }
    }

    fn call(&self, _: Function) -> Option<Self> {
        None
    }
}

fn power<V: Value>(base: &V, exponent: i32) -> Option<V> {
    let mut product = V::number(&Rational::one());
    let mut square = base.clone();
    let mut left = exponent.unsigned_abs();
    while left > 0 {
        if left & 1 == 1 {
            product = product.times(&square);
        }
        left >>= 1;
        if left > 0 {
            square = square.times(&square);
        }
    }
    if exponent < 0 { V::number(&Rational::one()).over(&product) } else { Some(product) }
}

impl Expression {
    /// Whether there is no function in it, so that every value is exact.
    pub fn is_rational(&self) -> bool {
        !self.steps.iter().any(|step| matches!(step, Step::Call(_)))
    }

    /// The polynomial that the formula is if it calls no function and divides by constants only.
    pub fn to_polynomial(&self) -> Option<Polynomial<Rational>> {
        self.run(&Polynomial::x(), &Polynomial::y())
    }

    /// The height over a top view: exactly, or where the formula has functions, a double.
    ///
    /// `None` where it is not defined (or infinite in doubles).
    pub fn height_at(&self, at: &TopView<Rational>) -> Option<Rational> {
        if self.is_rational() {
            return self.run(&at.x, &at.y);
        }
        let height: f64 = self.run(&at.x.to_f64(), &at.y.to_f64())?;
        Numeral::from_f64(height).map(|double| double.value())
    }

    fn run<V: Value>(&self, x: &V, y: &V) -> Option<V> {
        let mut stack: Vec<V> = Vec::new();
        for step in &self.steps {
            let value = match step {
                Step::Number(number) => V::number(number),
                Step::X => x.clone(),
                Step::Y => y.clone(),
                Step::Negate => stack.pop()?.negative(),
                Step::Power(exponent) => power(&stack.pop()?, *exponent)?,
                Step::Call(function) => stack.pop()?.call(*function)?,
                Step::Add | Step::Subtract | Step::Multiply | Step::Divide => {
                    let (b, a) = (stack.pop()?, stack.pop()?);
                    match step {
                        Step::Add => a.plus(&b),
                        Step::Subtract => a.plus(&b.negative()),
                        Step::Multiply => a.times(&b),
                        _ => a.over(&b)?,
                    }
                }
            };
            stack.push(value);
        }
        stack.pop()
    }

    fn jet_in<T: Number>(&self, at: &TopView<T>) -> Option<Jet2<T>> {
        let jet = self.run(&Taylor::x(&at.x), &Taylor::y(&at.y))?;
        Some(Jet2 {
            contact: ContactElement::new(at.at_height(jet.value), Gradient::new(jet.x, jet.y)),
            hessian: Hessian { xx: jet.xx, xy: jet.xy, yy: jet.yy },
        })
    }
}

impl Graph<Rational> for Expression {
    /// Not defined anywhere if there is a function in the formula.
    fn jet(&self, at: &TopView<Rational>) -> Option<Jet2<Rational>> {
        self.jet_in(at)
    }
}

impl Graph<f64> for Expression {
    fn jet(&self, at: &TopView<f64>) -> Option<Jet2<f64>> {
        let jet = self.jet_in(at)?;
        let Hessian { xx, xy, yy } = jet.hessian;
        [jet.contact.point.z, xx, xy, yy].iter().all(|c| c.is_finite()).then_some(jet)
    }
}
