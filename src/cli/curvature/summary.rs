//! Statistics of one number per element, for people.

use std::fmt::Write as _;

use crate::scalar::Sign;

/// Values with their exact signs.
#[derive(Default)]
pub struct Summary {
    values: Vec<f64>,
    positive: usize,
    zero: usize,
    negative: usize,
}

impl Summary {
    /// Adds the value of one more element.
    pub fn add(&mut self, value: f64, sign: Sign) {
        self.values.push(value);
        match sign {
            Sign::Positive => self.positive += 1,
            Sign::Zero => self.zero += 1,
            Sign::Negative => self.negative += 1,
        }
    }

    /// "-1.25 … 3   quartiles -0.5, 0, 1.25   12 positive, 1 zero, 3 negative"; `None` without
    /// values.
    pub fn line(mut self) -> Option<String> {
        self.values.sort_unstable_by(f64::total_cmp);
        let last = self.values.len().checked_sub(1)?;
        // The value at a fraction of the way, without interpolation.
        let at = |quarters: usize| short(self.values[(last * quarters + 2) / 4]);
        let mut line = match (at(0), at(4)) {
            (low, high) if low == high => low,
            (low, high) => {
                format!("{low} … {high}   quartiles {}, {}, {}", at(1), at(2), at(3))
            }
        };
        let signs = [(self.positive, "positive"), (self.zero, "zero"), (self.negative, "negative")];
        let signs = signs.iter().filter(|(n, _)| *n > 0).map(|(n, name)| format!("{n} {name}"));
        let _ = write!(line, "   {}", signs.collect::<Vec<_>>().join(", "));
        Some(line)
    }
}

/// Six digits, and a power of ten where that is shorter.
fn short(x: f64) -> String {
    if x == 0.0 {
        return "0".into();
    }
    let rounded: f64 = format!("{x:.5e}").parse().unwrap_or(x);
    match rounded.abs().log10().floor() as i32 {
        -4..6 => rounded.to_string(),
        _ => format!("{rounded:e}"),
    }
}
