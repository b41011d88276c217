//! Numbers and their units.

use plm_cas::Number;
use syn::Lit;

use super::expr::{Expr, ExprKind};
use super::input::{Input, Reported, Result};
use crate::diag::Code;
use crate::units::{DisplayUnit, UnitFactor, unit};

/// A number, which stands here, and the unit after it.
pub(super) fn quantity(input: Input) -> Result<Expr> {
    let (span, written) = (input.here(), input.next());
    let (digits, suffix, is_decimal) = match input.parse::<Lit>() {
        Ok(Lit::Int(number)) => {
            let prefix = written.get(..2).unwrap_or_default();
            let is_decimal = !["0x", "0o", "0b"].contains(&prefix);
            (number.base10_digits().to_owned(), number.suffix().to_owned(), is_decimal)
        }
        // `0bar` too: a binary number has a digit.
        Ok(Lit::Float(number)) => (number.base10_digits().to_owned(), number.suffix().to_owned(), true),
        _ => (String::new(), String::new(), true),
    };
    let value = Number::parse_decimal(digits.trim_end_matches('.'));
    let Some(value) = value.filter(|value| value.to_f64().is_finite()) else {
        let message = format!("`{written}` is not a number that can be read");
        input.error(Code::BadNumber, span, message);
        return Err(Reported);
    };
    let number = Expr { kind: ExprKind::Number(value), span };
    if !is_decimal {
        let message = format!("`{written}` is not a decimal number");
        input.error(Code::BadNumber, span, message).help("numbers are decimal");
        return number.with_unit(input);
    }
    if suffix.is_empty() {
        return number.with_unit(input);
    }
    suffixed(input, number, &digits, &suffix)
}

/// `0.5m`, `1.0_f64 kg`: an error, and then what was meant.
fn suffixed(input: Input, number: Expr, digits: &str, suffix: &str) -> Result<Expr> {
    let span = number.span;
    if let Some(found) = unit(suffix) {
        input
            .error(Code::SuffixedNumber, span, format!("the unit `{suffix}` touches its number"))
            .help_with(format!("write `{digits} {suffix}`"), format!("{digits} {suffix}"));
        let unit = DisplayUnit::product(suffix.to_string(), &[UnitFactor { unit: found, exponent: 1 }]);
        return Ok(Expr { kind: ExprKind::Quantity(Box::new(number), unit), span });
    }
    let whole = number.with_unit(input)?;
    let meant = match &whole.kind {
        ExprKind::Quantity(_, unit) => format!("{digits} {}", unit.text),
        _ => digits.to_string(),
    };
    input
        .error(Code::BadNumber, span, format!("a number cannot end in `{suffix}`"))
        .help(format!("numbers are decimal and of one type: write `{meant}`"));
    Ok(whole)
}
