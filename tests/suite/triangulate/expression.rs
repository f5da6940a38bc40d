//! Formulas: exact, with errors that name their place.

use isogeo::scalar::{Field, Rational};
use isogeo::space::{Expression, Graph, Jet2, Polynomial, TopView};
use proptest::prelude::*;

fn ratio(p: i64, q: i64) -> Rational {
    Rational::from_ratio(p, q)
}

fn parse(text: &str) -> Expression {
    text.parse().unwrap_or_else(|e| panic!("{text}: {e}"))
}

#[test]
fn operators_bind_as_usual() {
    let at = TopView::new(ratio(3, 1), ratio(2, 1));
    for (text, value) in [
        ("1 + 2*3", ratio(7, 1)),
        ("x - y - 1", ratio(0, 1)),
        ("x / y / 2", ratio(3, 4)),
        ("-x^2", ratio(-9, 1)),
        ("(-x)^2", ratio(9, 1)),
        ("2^-3", ratio(1, 8)),
        ("x*-y", ratio(-6, 1)),
        ("0.1", ratio(1, 10)),
        ("1e-2 * x", ratio(3, 100)),
        ("1 / (1 + x^2)", ratio(1, 10)),
        ("--x", ratio(3, 1)),
        ("x^0", ratio(1, 1)),
        (".5", ratio(1, 2)),
    ] {
        assert_eq!(parse(text).height_at(&at), Some(value), "{text}");
    }
}

#[test]
fn what_is_not_defined_has_no_height() {
    let origin = TopView::new(ratio(0, 1), ratio(0, 1));
    for text in ["1/x", "x^-1", "log(x)", "sqrt(x - 1)", "exp(10000)", "1/sin(x)"] {
        assert_eq!(parse(text).height_at(&origin), None, "{text}");
    }
    assert_eq!(parse("sqrt(x)").height_at(&origin), Some(ratio(0, 1)));
}

#[test]
fn errors_name_their_place() {
    let mut report = String::new();
    for text in [
        "",
        "x +",
        "x y",
        "2x",
        "x^y",
        "x^1.5",
        "x^2^3",
        "(x",
        "x)",
        "sin x",
        "tan(x)",
        "x + $",
        "1.2.3",
        "x^2000",
        "(x^100)^100",
        "(x",
        "1 ** 2",
        "é",
    ] {
        let error = text.parse::<Expression>().expect_err(text);
        report += &format!("{text:?}: {:?} {}\n", error.span, error.message);
    }
    let deep = "(".repeat(100_000) + "x";
    let error = deep.parse::<Expression>().expect_err("deep");
    report += &format!("(((...: {:?} {}\n", error.span, error.message);
    insta::assert_snapshot!("expression_errors", report);
}

#[test]
fn a_long_formula_is_no_deep_one() {
    let long = "x".to_owned() + &"+x*y".repeat(20_000);
    let at = TopView::new(ratio(1, 2), ratio(3, 1));
    assert_eq!(parse(&long).height_at(&at), Some(ratio(1, 2) + ratio(30_000, 1)));
}

#[test]
fn functions_have_their_derivatives() {
    let surface = parse("sin(x*y) + cos(x)*exp(y) + sqrt(1 + x^2) / log(2 + y^2)");
    assert!(!surface.is_rational() && surface.to_polynomial().is_none());
    let jet = |x: f64, y: f64| -> Jet2<f64> { surface.jet(&TopView::new(x, y)).expect("defined") };
    let h = 1.0 / 4096.0;
    let (x, y) = (0.7, 0.4);
    let by_x = |f: &dyn Fn(Jet2<f64>) -> f64| (f(jet(x + h, y)) - f(jet(x - h, y))) / (2.0 * h);
    let by_y = |f: &dyn Fn(Jet2<f64>) -> f64| (f(jet(x, y + h)) - f(jet(x, y - h))) / (2.0 * h);
    let here = jet(x, y);
    for (exact, difference) in [
        (here.contact.gradient.x, by_x(&|j| j.contact.point.z)),
        (here.contact.gradient.y, by_y(&|j| j.contact.point.z)),
        (here.hessian.xx, by_x(&|j| j.contact.gradient.x)),
        (here.hessian.xy, by_x(&|j| j.contact.gradient.y)),
        (here.hessian.yy, by_y(&|j| j.contact.gradient.y)),
    ] {
        assert!((exact - difference).abs() < 1.0 / 65536.0, "{exact} {difference}");
    }
    let no: Option<Jet2<Rational>> = surface.jet(&TopView::new(ratio(1, 1), ratio(1, 1)));
    assert_eq!(no, None);
}

proptest! {
    #[test]
    fn polynomials_have_their_jets(
        a in prop::collection::vec((0u32..4, 0u32..4, -9i64..9, 1i64..9), 1..6),
        x in -9i64..9, y in -9i64..9,
    ) {
        let text: Vec<String> = a.iter().map(|(i, j, p, q)| format!("{p}/{q}*x^{i}*y^{j}")).collect();
        let surface = parse(&text.join(" + "));
        let polynomial = Polynomial::new(a.iter().map(|&(i, j, p, q)| (i, j, ratio(p, q))));
        prop_assert_eq!(surface.to_polynomial(), Some(polynomial.clone()));
        let at = TopView::new(ratio(x, 3), ratio(y, 2));
        prop_assert_eq!(surface.height_at(&at), Some(polynomial.value_at(&at)));
        prop_assert_eq!(surface.jet(&at), polynomial.jet(&at));
    }

    #[test]
    fn no_text_panics(text in "[-+*/^()xy0-9.e sincolgqrtp]{0,30}") {
        let _ = text.parse::<Expression>();
    }
}
