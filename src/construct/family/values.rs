//! The values of parameters, as they are given and as numbers.

use std::collections::BTreeMap;
use std::fmt;

use super::Family;
use crate::mesh::file::parse_fraction;
use crate::scalar::{Numeral, Rational, Ring};
use crate::space::{Rotation, TopView};

/// The parameters of a member of a family: those that were given, and else the defaults.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    texts: BTreeMap<&'static str, String>,
}

/// A parameter that is not there, or has no such value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BadValue {
    /// The family has no parameter of that name; those that it has.
    NoSuchParameter(String, Vec<&'static str>),
    /// A text that is no value of the parameter; what is.
    NoValue(&'static str, String, &'static str),
}

impl fmt::Display for BadValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BadValue::NoSuchParameter(name, known) if known.is_empty() => {
                write!(f, "there is no parameter '{name}': the family has none")
            }
            BadValue::NoSuchParameter(name, known) => {
                write!(f, "there is no parameter '{name}': there are {}", known.join(", "))
            }
            BadValue::NoValue(name, text, expected) => {
                write!(f, "{name} takes {expected}, not '{text}'")
            }
        }
    }
}

impl std::error::Error for BadValue {}

impl Values {
    /// The given values of a family, by name.
    ///
    /// # Errors
    /// A name that is none of its parameters.
    pub fn new(family: Family, given: &[(String, String)]) -> Result<Self, BadValue> {
        let parameters = family.parameters();
        let mut texts: BTreeMap<_, _> =
            parameters.iter().map(|p| (p.name, p.default.to_owned())).collect();
        for (name, text) in given {
            let slot = texts.iter_mut().find(|(known, _)| **known == name.as_str());
            match slot {
                Some((_, value)) => *value = text.clone(),
                None => {
                    let known = parameters.iter().map(|p| p.name).collect();
                    return Err(BadValue::NoSuchParameter(name.clone(), known));
                }
            }
        }
        Ok(Values { texts })
    }

    /// The text of a parameter.
    pub(super) fn text(&self, name: &'static str) -> &str {
        self.texts.get(name).map_or("", String::as_str)
    }

    pub(super) fn bad(&self, name: &'static str, expected: &'static str) -> BadValue {
        BadValue::NoValue(name, self.text(name).to_owned(), expected)
    }

    fn numbers<const N: usize>(&self, name: &'static str) -> Option<[Rational; N]> {
        let number = |part: &str| {
            let decimal = part.parse::<Numeral>().ok().map(|n| n.value());
            decimal.or_else(|| parse_fraction(part).ok())
        };
        let numbers: Option<Vec<_>> =
            self.text(name).split(',').map(|p| number(p.trim())).collect();
        numbers?.try_into().ok()
    }

    pub(super) fn number(&self, name: &'static str) -> Result<Rational, BadValue> {
        let one = self.numbers(name).map(|[number]| number);
        one.ok_or_else(|| self.bad(name, "one number such as -3/5"))
    }

    pub(super) fn non_zero(&self, name: &'static str) -> Result<Rational, BadValue> {
        let number = self.number(name)?;
        if number.is_zero() { Err(self.bad(name, "a number that is not 0")) } else { Ok(number) }
    }

    pub(super) fn pair(&self, name: &'static str) -> Result<[Rational; 2], BadValue> {
        self.numbers(name).ok_or_else(|| self.bad(name, "two numbers such as 1/2,-3"))
    }

    pub(super) fn top_view(&self, name: &'static str) -> Result<TopView<Rational>, BadValue> {
        self.pair(name).map(|[x, y]| TopView::new(x, y))
    }

    pub(super) fn seed(&self, name: &'static str) -> Result<u64, BadValue> {
        self.text(name).parse().map_err(|_| self.bad(name, "a whole number from 0"))
    }

    /// The number of bits of an enclosure.
    pub(super) fn bits(&self, name: &'static str) -> Result<u32, BadValue> {
        const MOST: u32 = 4096;
        let bits = self.text(name).parse().ok().filter(|bits| (1..=MOST).contains(bits));
        bits.ok_or_else(|| self.bad(name, "a whole number from 1 to 4096"))
    }

    pub(super) fn half_angle(&self) -> Result<Rotation<Rational>, BadValue> {
        let name = "half-angle";
        let [c, s] = self.pair(name)?;
        let proper = !c.is_zero() && !s.is_zero();
        let rotation = Rotation::new(c, s).ok().filter(|_| proper);
        rotation.ok_or_else(|| self.bad(name, "c,s with c² + s² = 1 that are not 0"))
    }
}
