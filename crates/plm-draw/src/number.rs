//! Numbers of a text, and how a new one is written: in the unit that stands there, no finer than it is known.

use std::ops::Range;

use plm_compiler::syntax::ast::{Expr, ExprKind};
use plm_compiler::units::DisplayUnit;

/// More digits behind the point say nothing of a drawing.
const MOST_DIGITS: i32 = 12;

/// A number that stands in the text.
#[derive(Clone, Debug, PartialEq)]
pub struct Literal {
    /// The number, with its sign.
    pub range: Range<usize>,
    /// With its unit, where it has one of its own.
    pub whole: Range<usize>,
    /// In its unit.
    pub value: f64,
    /// Its unit.
    pub unit: DisplayUnit,
    /// Is the unit written, at the number or at its pair? A zero needs none.
    pub has_unit: bool,
    /// Is it the value of a name, so that no hand moves it?
    pub is_locked: bool,
}

impl Literal {
    /// The literal that an expression is, if it is one. A pair hands its unit down; a zero without any takes `other`.
    pub(crate) fn of(
        expr: &Expr,
        shared: Option<&DisplayUnit>,
        other: &DisplayUnit,
        range: &impl Fn(&Expr) -> Range<usize>,
    ) -> Option<Literal> {
        let whole = range(expr);
        match &expr.kind {
            ExprKind::Number(number) => {
                let value = number.to_f64();
                // Without a unit a number is a mistake, but for zero.
                let unit = shared.or((value == 0.0).then_some(other))?.clone();
                Some(Literal {
                    range: whole.clone(),
                    whole,
                    value,
                    unit,
                    has_unit: shared.is_some(),
                    is_locked: false,
                })
            }
            ExprKind::Quantity(inner, unit) if !matches!(inner.kind, ExprKind::Pair(..)) => {
                Some(Literal { whole, ..Literal::of(inner, Some(unit), other, range)? })
            }
            ExprKind::Neg(inner) => {
                let inner = Literal::of(inner, shared, other, range)?;
                Some(Literal { range: whole.start..inner.range.end, whole, value: -inner.value, ..inner })
            }
            _ => None,
        }
    }

    /// One of its unit, SI.
    pub fn factor(&self) -> f64 {
        self.unit.factor.to_f64()
    }

    /// Its value, SI.
    pub fn si(&self) -> f64 {
        self.value * self.factor()
    }

    /// Its value for the tests of the rules: a zero is structure.
    pub(crate) fn is_zero(&self) -> bool {
        self.value == 0.0
    }
}

/// A number with the value that a gesture gives it.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// The number as it stands.
    pub literal: Literal,
    /// Its new value in its unit, as it is written.
    pub value: f64,
    /// The new token, with a unit where none was written.
    pub text: String,
}

impl Change {
    /// A number that is to be `si`, known to `step`, SI both. Where that is what stands there, the token stays.
    pub(crate) fn new(literal: &Literal, si: f64, step: f64) -> Change {
        let (factor, step) = (literal.factor(), step / literal.factor());
        let stays = (si / factor - literal.value).abs() <= 1e-6 * step;
        let number = if stays { None } else { Some(rounded(si / factor, step)) };
        Change::written(literal, number)
    }

    /// A number with a token that was typed; `None` leaves it as it stands.
    pub(crate) fn written(literal: &Literal, number: Option<String>) -> Change {
        let value = number.as_deref().and_then(|text| text.parse().ok()).unwrap_or(literal.value);
        let unit =
            if literal.has_unit || value == 0.0 { String::new() } else { format!(" {}", literal.unit.text) };
        Change {
            literal: literal.clone(),
            value,
            text: number.map(|number| number + &unit).unwrap_or_default(),
        }
    }

    /// Does another token stand there?
    pub fn is_new(&self) -> bool {
        !self.text.is_empty() && self.value != self.literal.value
    }

    /// The new value, SI.
    pub fn si(&self) -> f64 {
        self.value * self.literal.factor()
    }
}

/// An angle in degrees, to a thousandth.
pub(crate) fn degrees(angle: f64) -> String {
    rounded(angle.to_degrees(), 1e-3)
}

/// A number to the decimals of a step, without zeros at its end.
pub(crate) fn rounded(value: f64, step: f64) -> String {
    let digits = (-step.log10()).ceil().clamp(0.0, f64::from(MOST_DIGITS)) as usize;
    let text = format!("{value:.digits$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// The step of the decimals that `rounded` writes of a value in a unit of this factor, SI.
pub fn decimal_step(step: f64, factor: f64) -> f64 {
    let digits = (-(step / factor).log10()).ceil().clamp(0.0, f64::from(MOST_DIGITS));
    factor * 10_f64.powf(-digits)
}

#[cfg(test)]
mod tests {
    use super::{decimal_step, rounded};

    #[test]
    fn numbers_are_short() {
        let cases = [(0.1 + 0.2, 0.1, "0.3"), (-0.0, 1.0, "0"), (-0.04, 0.1, "0"), (12.3456, 0.01, "12.35")];
        for (value, step, expected) in cases {
            assert_eq!(rounded(value, step), expected);
        }
        assert_eq!(
            [rounded(1234.0, 100.0), rounded(100.0, 1.0), rounded(7.5, 0.002)],
            ["1234", "100", "7.5"]
        );
    }

    #[test]
    fn a_step_is_that_of_the_digits() {
        // Half of a millimetre in centimetres is written in hundredths of them.
        assert!((decimal_step(5e-4, 1e-2) - 1e-4).abs() < 1e-18);
        assert!((decimal_step(2.0, 1.0) - 1.0).abs() < 1e-15);
    }
}
