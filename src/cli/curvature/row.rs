//! An element in the forms that the outputs need.

use serde_json::{Value, json};

use crate::pair::element::{At, Elements, Found, Undefined, lowest_terms};
use crate::pair::{Curvatures, Forms};
use crate::scalar::{Approx, BigInt, Field, Fraction, Ordered, Rational, Sign};

/// An element in the numbers of a summary.
pub struct Short {
    /// H and K, correctly rounded.
    pub values: [f64; 2],
    /// Their signs, exact.
    pub signs: [Sign; 2],
    /// Whether `H² < K`.
    pub complex: bool,
    /// Whether `D(s)` has the sign that the orientation of the faces does not have.
    pub reversed: bool,
}

impl Short {
    fn of(found: &Found) -> Self {
        let both = [&found.curvatures.mean, &found.curvatures.gauss];
        let sign = |x: &Fraction<BigInt>| x.certain_sign().unwrap_or(Sign::Zero);
        Short {
            values: both.map(Approx::to_f64),
            signs: both.map(sign),
            // The discriminant of the forms has the same sign and smaller numbers.
            complex: sign(&found.forms.discriminant()) == Sign::Negative,
            reversed: found.reversed,
        }
    }
}

/// An element in all forms that are asked for.
pub(super) struct Row {
    /// The numbers of the summary.
    pub found: Result<Short, Undefined>,
    /// The entry for programs.
    pub json: Option<Value>,
    /// H and K in lowest terms.
    pub exact: Option<Curvatures<Rational>>,
}

impl Row {
    /// Keeps of an element what is needed.
    pub fn new(found: Result<Found, Undefined>, json: Option<Value>, exact: bool) -> Self {
        let exact = match &found {
            Ok(found) if exact => found.curvatures.reduced(),
            _ => None,
        };
        Row { found: found.map(|found| Short::of(&found)), json, exact }
    }
}

/// One entry of `values`.
pub(super) fn entry(
    elements: &Elements<'_>,
    index: usize,
    found: &Result<Found, Undefined>,
    integrated: bool,
) -> Value {
    let mut value = elements.json(index, found);
    let Ok(found) = found else { return value };
    value["discriminant"] = json!(lowest_terms(&found.curvatures.discriminant()));
    value["kappa"] = json!(found.curvatures.principal_f64());
    if integrated {
        let names = match elements.at {
            At::Faces => ["area", "mixed_area", "image_area"],
            At::Vertices => ["measure", "mixed_measure", "image_measure"],
        };
        let Forms { first, mixed, second } = &found.forms;
        for (name, form) in names.into_iter().zip([first, mixed, second]) {
            value[name] = json!(lowest_terms(&(form * Fraction::from_ratio(1, 4))));
        }
    }
    value
}
