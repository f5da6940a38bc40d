//! Random formulas, evaluated in any scalar by the same code.

use isogeo::scalar::{Field, Ring};
use proptest::prelude::*;

/// How many variables a formula has.
pub const VARIABLES: usize = 4;

/// A formula in `VARIABLES` variables.
#[derive(Clone, Debug)]
pub enum Expression {
    Variable(usize),
    Constant(i64),
    Sum(Box<[Expression; 2]>),
    Difference(Box<[Expression; 2]>),
    Product(Box<[Expression; 2]>),
    Quotient(Box<[Expression; 2]>),
    Opposite(Box<Expression>),
    Square(Box<Expression>),
    Det2(Box<[Expression; 4]>),
    Dot(Box<[Expression; 4]>),
}
use Expression::*;

impl Expression {
    /// The value of a formula without quotients.
    pub fn polynomial<T: Ring>(&self, at: &[T; VARIABLES]) -> T {
        self.evaluate(at, &|_, _| None).expect("a polynomial has no quotient")
    }

    /// The value, or `None` where it divides by 0.
    pub fn rational<T: Field>(&self, at: &[T; VARIABLES]) -> Option<T> {
        self.evaluate(at, &T::try_div)
    }

    fn evaluate<T: Ring>(
        &self,
        at: &[T; VARIABLES],
        divide: &dyn Fn(&T, &T) -> Option<T>,
    ) -> Option<T> {
        let value = |e: &Expression| e.evaluate(at, divide);
        Some(match self {
            Variable(i) => at[*i].clone(),
            Constant(n) => T::from_i64(*n),
            Sum(e) => value(&e[0])? + value(&e[1])?,
            Difference(e) => value(&e[0])? - &value(&e[1])?,
            Product(e) => value(&e[0])? * &value(&e[1])?,
            Quotient(e) => divide(&value(&e[0])?, &value(&e[1])?)?,
            Opposite(e) => -value(e)?,
            Square(e) => value(e)?.square(),
            Det2(e) => T::det2(&value(&e[0])?, &value(&e[1])?, &value(&e[2])?, &value(&e[3])?),
            Dot(e) => T::dot([&value(&e[0])?, &value(&e[1])?], [&value(&e[2])?, &value(&e[3])?]),
        })
    }
}

/// Formulas of the given depth, without quotients.
pub fn polynomials(depth: u32) -> BoxedStrategy<Expression> {
    formulas(depth, false)
}

/// Formulas of the given depth, with quotients.
pub fn quotients(depth: u32) -> BoxedStrategy<Expression> {
    formulas(depth, true)
}

fn formulas(depth: u32, quotients: bool) -> BoxedStrategy<Expression> {
    let leaf =
        prop_oneof![4 => (0..VARIABLES).prop_map(Variable), 1 => (-3i64..=3).prop_map(Constant)];
    leaf.prop_recursive(depth, 32, 4, move |inner| {
        let two = (inner.clone(), inner.clone()).prop_map(|(a, b)| Box::new([a, b]));
        let four = (two.clone(), two.clone()).prop_map(|(e, f)| {
            let ([a, b], [c, d]) = (*e, *f);
            Box::new([a, b, c, d])
        });
        prop_oneof![
            2 => two.clone().prop_map(Sum),
            2 => two.clone().prop_map(Difference),
            2 => two.clone().prop_map(Product),
            1 => two.prop_map(move |e| if quotients { Quotient(e) } else { Product(e) }),
            1 => inner.clone().prop_map(|e| Opposite(Box::new(e))),
            1 => inner.prop_map(|e| Square(Box::new(e))),
            1 => four.clone().prop_map(Det2),
            1 => four.prop_map(Dot),
        ]
    })
    .boxed()
}
