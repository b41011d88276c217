//! Numbers as text: reading decimal literals, printing short exact forms.

use core::fmt;

use super::{Number, gcd};

impl Number {
    /// Reads a decimal literal: digits with `_`, one point, an exponent, a sign in front.
    ///
    /// The value is exact ("9.80665" is 980665/100000); if it does not fit, it is the nearest f64. `None` if the
    /// text is not such a literal, or if the value is beyond the range of f64.
    pub fn parse_decimal(text: &str) -> Option<Self> {
        let plain: String = text.chars().filter(|&c| c != '_').collect();
        let literal = Literal::scan(&plain)?;
        if let Some(exact) = literal.exact() {
            return Some(exact);
        }
        let value: f64 = plain.parse().ok()?;
        value.is_finite().then(|| Self::from_f64(value))
    }

    /// Numerator and denominator as text for a product, without the sign: ("3*pi", Some("4")), ("0.15", None).
    pub(crate) fn fraction_text(self) -> (String, Option<String>) {
        let Self::Exact { num, den, pi } = self.abs() else {
            return (float_text(self.abs().to_f64()), None);
        };
        if let (0, Some(decimal)) = (pi, decimal_text(num, den)) {
            return (decimal, None);
        }
        let power = match pi.unsigned_abs() {
            1 => "pi".to_owned(),
            exponent => format!("pi^{exponent}"),
        };
        let above = match pi {
            1.. if num == 1 => power.clone(),
            1.. => format!("{}*{power}", integer_text(num)),
            _ => integer_text(num),
        };
        let below = match (pi, den) {
            (0.., 1) => None,
            (0.., _) => Some(integer_text(den)),
            (_, 1) => Some(power),
            _ => Some(format!("({}*{power})", integer_text(den))),
        };
        (above, below)
    }
}

/// The parts of a literal: `digits * 10^(exponent - point)`.
struct Literal<'a> {
    negative: bool,
    whole: &'a str,
    fraction: &'a str,
    exponent: i32,
}

impl<'a> Literal<'a> {
    fn scan(text: &'a str) -> Option<Self> {
        let (negative, unsigned) = match text.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, text.strip_prefix('+').unwrap_or(text)),
        };
        let (digits, exponent) = match unsigned.split_once(['e', 'E']) {
            Some((digits, exponent)) => (digits, exponent.parse().ok()?),
            None => (unsigned, 0),
        };
        let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
        let all_digits = whole.bytes().chain(fraction.bytes()).all(|b| b.is_ascii_digit());
        (all_digits && whole.len() + fraction.len() > 0).then_some(Self {
            negative,
            whole,
            fraction,
            exponent,
        })
    }

    fn exact(&self) -> Option<Number> {
        // "1.500" and "1.5" are one number, and zeros must not eat up the digits that fit.
        let fraction = self.fraction.trim_end_matches('0');
        let mut digits: i128 = 0;
        for byte in self.whole.bytes().chain(fraction.bytes()) {
            digits = digits.checked_mul(10)?.checked_add(i128::from(byte - b'0'))?;
        }
        if digits == 0 {
            return Some(Number::ZERO);
        }
        let exponent = self.exponent.checked_sub(i32::try_from(fraction.len()).ok()?)?;
        let power = 10_i128.checked_pow(exponent.unsigned_abs())?;
        let signed = if self.negative { -digits } else { digits };
        if exponent < 0 {
            Number::rational(signed, power)
        } else {
            Number::rational(signed.checked_mul(power)?, 1)
        }
    }
}

/// An exact decimal of at most twelve places, if there is one. Both arguments positive (or zero above).
fn decimal_text(num: i128, den: i128) -> Option<String> {
    const PLACES: u32 = 12;
    if den == 1 {
        return Some(integer_text(num));
    }
    let places = (1..=PLACES).find(|&places| gcd(10_i128.pow(places), den) == den)?;
    let unit = 10_i128.pow(places);
    let (whole, rest) = (num / den, num % den * (unit / den));
    Some(format!("{whole}.{rest:0width$}", width = places as usize))
}

/// An integer; one with many zeros at the end in the short form 2.1e11.
fn integer_text(value: i128) -> String {
    const ZEROS: usize = 6;
    let digits = value.to_string();
    let mantissa = digits.trim_end_matches('0');
    if digits.len() - mantissa.len() < ZEROS || mantissa.is_empty() {
        return digits;
    }
    let (first, rest) = mantissa.split_at(1);
    let point = if rest.is_empty() { "" } else { "." };
    format!("{first}{point}{rest}e{}", digits.len() - 1)
}

/// The shortest text that reads back to the same f64.
fn float_text(value: f64) -> String {
    if value != 0.0 && !(1e-5..1e15).contains(&value) && value.is_finite() {
        format!("{value:e}")
    } else {
        format!("{value}")
    }
}

/// "0.15", "1/3", "3*pi/4": the shortest exact form; a float by the digits that read back to it.
impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (above, below) = self.fraction_text();
        if self.is_negative() {
            f.write_str("-")?;
        }
        f.write_str(&above)?;
        match below {
            Some(below) => write!(f, "/{below}"),
            None => Ok(()),
        }
    }
}
