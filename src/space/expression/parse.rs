//! From text to steps: recursive descent.

use std::ops::Range;

use super::{ExpressionError, Function, Step};
use crate::scalar::Numeral;

/// How deep parentheses and signs may be nested.
const DEEPEST: usize = 100;
/// The largest degree, numbers counted like x and y: a bound for the digits of exact values.
const LARGEST_DEGREE: u32 = 1000;

pub(super) fn parse(text: &str) -> Result<Vec<Step>, ExpressionError> {
    let mut parser = Parser { text, at: 0, depth: 0, steps: Vec::new() };
    parser.sum()?;
    parser.blanks();
    match parser.rest().chars().next() {
        None => Ok(parser.steps),
        Some(')') => Err(parser.error_here("this parenthesis was not opened")),
        Some(_) => Err(parser.error_here("expected an operator + - * / ^ or the end")),
    }
}

struct Parser<'a> {
    text: &'a str,
    at: usize,
    depth: usize,
    steps: Vec<Step>,
}

/// The degree of what was parsed.
type Degree = u32;

impl<'a> Parser<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn blanks(&mut self) {
        self.at = self.text.len() - self.rest().trim_start().len();
    }

    fn error(&self, span: Range<usize>, message: impl Into<String>) -> ExpressionError {
        ExpressionError { span, message: message.into() }
    }

    /// An error about the next character, or the end.
    fn error_here(&self, message: &str) -> ExpressionError {
        let length = self.rest().chars().next().map_or(0, char::len_utf8);
        self.error(self.at..self.at + length, message)
    }

    /// Takes one of the characters, after blanks.
    fn take(&mut self, wanted: &[char]) -> Option<char> {
        self.blanks();
        let found = self.rest().chars().next().filter(|c| wanted.contains(c))?;
        self.at += found.len_utf8();
        Some(found)
    }

    fn limit(&self, degree: Degree, start: usize) -> Result<Degree, ExpressionError> {
        if degree <= LARGEST_DEGREE {
            return Ok(degree);
        }
        let message = format!("the degree is more than {LARGEST_DEGREE} (numbers count as x)");
        Err(self.error(start..self.at, message))
    }

    fn sum(&mut self) -> Result<Degree, ExpressionError> {
        let mut degree = self.product()?;
        while let Some(operator) = self.take(&['+', '-', '−']) {
            degree = degree.max(self.product()?);
            self.steps.push(if operator == '+' { Step::Add } else { Step::Subtract });
        }
        Ok(degree)
    }

    fn product(&mut self) -> Result<Degree, ExpressionError> {
        self.blanks();
        let start = self.at;
        let mut degree = self.signed()?;
        while let Some(operator) = self.take(&['*', '·', '/']) {
            let factor = self.signed()?;
            degree = self.limit(degree + factor, start)?;
            self.steps.push(if operator == '/' { Step::Divide } else { Step::Multiply });
        }
        Ok(degree)
    }

    /// A sign binds less than a power: `-x^2` is `-(x^2)`.
    fn signed(&mut self) -> Result<Degree, ExpressionError> {
        match self.take(&['+', '-', '−']) {
            None => self.power(),
            Some(sign) => {
                let degree = self.nested(Self::signed)?;
                if sign != '+' {
                    self.steps.push(Step::Negate);
                }
                Ok(degree)
            }
        }
    }

    fn nested(
        &mut self,
        inner: fn(&mut Self) -> Result<Degree, ExpressionError>,
    ) -> Result<Degree, ExpressionError> {
        if self.depth == DEEPEST {
            return Err(self.error_here("nested too deep"));
        }
        self.depth += 1;
        let degree = inner(self)?;
        self.depth -= 1;
        Ok(degree)
    }

    fn power(&mut self) -> Result<Degree, ExpressionError> {
        self.blanks();
        let start = self.at;
        let degree = self.atom()?;
        if self.take(&['^']).is_none() {
            return Ok(degree);
        }
        let exponent = self.exponent()?;
        if self.take(&['^']).is_some() {
            self.at -= 1;
            return Err(self.error_here("a power of a power wants parentheses"));
        }
        self.steps.push(Step::Power(exponent));
        self.limit(degree.saturating_mul(exponent.unsigned_abs()), start)
    }

    fn exponent(&mut self) -> Result<i32, ExpressionError> {
        self.blanks();
        let start = self.at;
        let negative = self.take(&['-', '−']).is_some();
        let digits = self.rest().bytes().take_while(u8::is_ascii_digit).count();
        self.at += digits;
        let number = self.text[self.at - digits..self.at].parse::<i32>();
        match number {
            Ok(n) if !self.rest().starts_with('.') => Ok(if negative { -n } else { n }),
            _ => {
                let next = self.rest().chars().next().map_or(0, char::len_utf8);
                Err(self.error(start..self.at + next, "expected a whole number as exponent"))
            }
        }
    }

    fn atom(&mut self) -> Result<Degree, ExpressionError> {
        if self.take(&['(']).is_some() {
            return self.parenthesis();
        }
        let word = |c: char| c.is_alphanumeric() || c == '_';
        match self.rest().chars().next() {
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if word(c) => {
                let length = self.rest().find(|c| !word(c)).unwrap_or(self.rest().len());
                let start = self.at;
                self.at += length;
                self.name(start..self.at)
            }
            _ => Err(self.error_here("expected a number, x, y, a function or a parenthesis")),
        }
    }

    fn parenthesis(&mut self) -> Result<Degree, ExpressionError> {
        let degree = self.nested(Self::sum)?;
        match self.take(&[')']) {
            Some(_) => Ok(degree),
            None if self.rest().is_empty() => Err(self.error_here("the parenthesis is not closed")),
            None => Err(self.error_here("expected an operator + - * / ^ or a parenthesis")),
        }
    }

    fn number(&mut self) -> Result<Degree, ExpressionError> {
        let bytes = self.rest().as_bytes();
        let is_digit = |i: usize| bytes.get(i).is_some_and(u8::is_ascii_digit);
        let mut length = bytes.iter().take_while(|b| b.is_ascii_digit() || **b == b'.').count();
        if matches!(bytes.get(length), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(bytes.get(length + 1), Some(b'+' | b'-')));
            if is_digit(length + 1 + sign) {
                length += 1 + sign;
                length += bytes[length..].iter().take_while(|b| b.is_ascii_digit()).count();
            }
        }
        let start = self.at;
        self.at += length;
        let number = self.text[start..self.at].parse::<Numeral>();
        let number = number.map_err(|_| self.error(start..self.at, "expected a number"))?;
        self.steps.push(Step::Number(number.value()));
        Ok(1)
    }

    fn name(&mut self, span: Range<usize>) -> Result<Degree, ExpressionError> {
        let function = match &self.text[span.clone()] {
            "x" => return self.variable(Step::X),
            "y" => return self.variable(Step::Y),
            "sin" => Function::Sin,
            "cos" => Function::Cos,
            "exp" => Function::Exp,
            "sqrt" => Function::Sqrt,
            "log" | "ln" => Function::Log,
            name => {
                let message =
                    format!("'{name}' is not known; there are x, y, sin, cos, exp, sqrt, log");
                return Err(self.error(span, message));
            }
        };
        if self.take(&['(']).is_none() {
            return Err(self.error_here("expected '(' after the name of a function"));
        }
        self.parenthesis()?;
        self.steps.push(Step::Call(function));
        Ok(1)
    }

    fn variable(&mut self, step: Step) -> Result<Degree, ExpressionError> {
        self.steps.push(step);
        Ok(1)
    }
}
