//! Symbols: a record does what the code did, and its normal form is the same function.

use isogeo::scalar::{
    Evaluation, Field, Mutation, NormalForms, Outcome, Polynomial, Program, Rational, Ring, Symbol,
    TooLarge, record,
};
use proptest::array::uniform4;

use super::expression::{Expression, VARIABLES, quotients};
use super::laws::{equal, holds, that};
use super::samples::small_fractions;

fn recorded(formula: &Expression, shadows: &[Rational; VARIABLES]) -> (Option<Symbol>, Program) {
    record(|| formula.rational(&shadows.clone().map(Symbol::unknown)))
}

#[test]
fn a_record_is_the_code_and_so_is_its_normal_form() -> Result<(), String> {
    let points = uniform4(small_fractions::<Rational>());
    holds((quotients(4), points.clone(), points), |(formula, shadows, at)| {
        let (value, program) = recorded(&formula, &shadows);
        equal("defined or not", value.is_some(), formula.rational(&shadows).is_some())?;
        let Some(value) = value else { return Ok(()) };
        let (node, expected) = (value.node(), formula.rational(&at));
        let again = program.evaluate(&at, &[node]).map(|values| values[0].clone());
        equal("the record", &again, &expected)?;
        let forms = match NormalForms::of(&program, &[node]) {
            Ok(forms) => forms,
            // A deep formula may be too large, and the zero function a divisor.
            Err(_) => return Ok(()),
        };
        // Unknowns are numbered as the formula meets them.
        let slice = program.slice(&[node]);
        let met = at.iter().enumerate().filter(|(n, _)| slice[*n]).map(|(_, x)| x.clone());
        let normal = forms.evaluate(node, &met.collect::<Vec<_>>());
        match (normal, expected) {
            (Some(normal), Some(expected)) => equal("the normal form", normal, expected),
            // The normal form is defined wherever the formula is; it may cancel.
            (normal, expected) => that("cancelled", normal.is_some() || expected.is_none()),
        }
    })
}

#[test]
fn the_difference_of_equal_functions_is_zero_and_plus_one_it_is_not() -> Result<(), String> {
    let points = uniform4(small_fractions::<Rational>());
    holds((quotients(3), quotients(3), points), |(f, g, shadows)| {
        let (goals, program) = record(|| {
            let at = shadows.clone().map(Symbol::unknown);
            let (f, g) = (f.rational(&at)?, g.rational(&at)?);
            // (f + g)² = f² + 2fg + g²
            let square = f.square() + Symbol::from_i64(2) * f * g + g.square();
            let zero = (f + g).square() - square;
            Some([zero, zero + Symbol::one()].map(Symbol::node))
        });
        let Some(goals) = goals else { return Ok(()) };
        let Ok(forms) = NormalForms::of(&program, &goals) else { return Ok(()) };
        let zero = goals.map(|goal| forms.quotient(goal).map(|q| q.is_zero()));
        equal("zero, and one", zero, [Some(true), Some(false)])
    })
}

#[test]
fn what_a_comparison_answered_is_recorded() {
    let two = || Rational::from_i64(2);
    let (answers, program) = record(|| {
        let (x, y) = (Symbol::unknown(two()), Symbol::unknown(two()));
        [x == y, x.is_zero(), x > y + Symbol::one(), (x - y).try_inv().is_some()]
    });
    assert_eq!(answers, [true, false, false, false]);
    let outcomes: Vec<Outcome> = program.branches().iter().map(|b| b.outcome).collect();
    let sign = Outcome::Sign(isogeo::scalar::Sign::Negative);
    assert_eq!(outcomes, [Outcome::Zero, Outcome::NotZero, sign, Outcome::Zero]);
    // The operator `>` is the standard library's.
    let here = program.branches().iter().map(|b| b.place.file().ends_with("symbols.rs"));
    assert_eq!(here.collect::<Vec<_>>(), [true, true, false, true]);
}

#[test]
fn division_by_the_zero_function_has_no_normal_form() {
    let (quotient, program) = record(|| {
        let x = Symbol::unknown(Rational::one());
        Symbol::one() / (x - x)
    });
    let forms = NormalForms::of(&program, &[quotient.node()]);
    assert!(matches!(forms, Err(TooLarge::ZeroDivisor(_))));
    assert_eq!(program.evaluate(&[Rational::one()], &[quotient.node()]), None);
}

#[test]
fn what_does_not_fit_is_refused() {
    let (power, program) = record(|| {
        let x = Symbol::unknown(Rational::one());
        (0..8).fold(x, |power, _| power.square())
    });
    assert_eq!(NormalForms::of(&program, &[power.node()]).err(), Some(TooLarge::Exponent));
    let (power, program) = record(|| (0..8).fold(Symbol::from_i64(3), |power, _| power.square()));
    assert_eq!(NormalForms::of(&program, &[power.node()]).err(), Some(TooLarge::Coefficient));
}

#[test]
fn exact_quotients_are_those_that_exist() -> Result<(), TooLarge> {
    let [x, y] = [Polynomial::unknown(0)?, Polynomial::unknown(1)?];
    let one = Polynomial::constant(1);
    let (sum, difference) = (x.plus(&y)?, x.plus(&y.scaled(-1)?)?);
    let product = sum.product(&difference)?;
    assert_eq!(product.to_string(), "x0^2 - x1^2");
    assert_eq!(product.exact_quotient(&sum)?, Some(difference));
    assert_eq!(product.plus(&one)?.exact_quotient(&sum)?, None);
    assert_eq!(product.exact_quotient(&x)?, None);
    assert_eq!(Polynomial::default().exact_quotient(&sum)?, Some(Polynomial::default()));
    assert_eq!(sum.scaled(6)?.exact_quotient(&sum.scaled(4)?)?, None);
    assert_eq!(sum.scaled(6)?.content(), 6);
    assert_eq!(
        product.evaluate(&[Rational::from_i64(5), Rational::from_i64(3)]),
        Rational::from_i64(16)
    );
    Ok(())
}

#[test]
fn a_mutant_computes_something_else() {
    let (sum, program) = record(|| {
        let (x, y) = (Symbol::unknown(Rational::one()), Symbol::unknown(Rational::one()));
        x + y
    });
    let at = [5, 3].map(Rational::from_i64);
    let goals = [sum.node()];
    let evaluation = Evaluation::of(&program, &at, &goals).expect("no division");
    assert_eq!(evaluation.goals(), [Rational::from_i64(8)]);
    let wrong = |mutation| evaluation.mutant(sum.node(), mutation).map(|v| v[0].clone());
    let expected = [2, 6, 16].map(|n| Some(Rational::from_i64(n)));
    assert_eq!([Mutation::Sign, Mutation::Index, Mutation::Factor].map(wrong), expected);
}
