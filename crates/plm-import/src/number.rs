//! Numbers as text: as few digits as carry what the file says.

/// Digits of numbers that are worked out.
const DIGITS: usize = 12;

/// A number with up to twelve digits, in the shortest form that has them.
pub(crate) fn short(number: f64) -> String {
    with_digits(number, DIGITS)
}

/// A number with as many digits as it has after a few operations.
pub(crate) fn exact(number: f64) -> String {
    with_digits(if number.abs() < 1e-15 { 0.0 } else { number }, 15)
}

/// A number of a picture, with up to four digits of `size`.
pub(crate) fn coarse(number: f64, size: f64) -> String {
    let step = 10_f64.powi(size.abs().max(1e-300).log10().floor() as i32 - 3);
    short((number / step).round() * step)
}

/// A length or coordinate, m: without what rounding leaves below a picometre.
pub(crate) fn length(number: f64) -> String {
    short(if number.abs() < 1e-12 { 0.0 } else { (number * 1e12).round() / 1e12 })
}

/// A coordinate of a drawing, in its unit, with up to seven digits.
pub(crate) fn drawn(number: f64) -> String {
    with_digits(if number.abs() < 1e-9 { 0.0 } else { number }, 7)
}

/// An angle with its unit: degrees where they are few digits.
pub(crate) fn angle(radians: f64) -> String {
    let degrees = with_digits((radians.to_degrees() * 1e9).round() / 1e9, DIGITS);
    if degrees.trim_start_matches('-').len() <= 6 {
        format!("{degrees} deg")
    } else {
        format!("{} rad", length(radians))
    }
}

fn with_digits(number: f64, digits: usize) -> String {
    let rounded: f64 = format!("{number:.*e}", digits - 1).parse().unwrap_or(number);
    if rounded == 0.0 {
        return "0".to_owned();
    }
    let plain = format!("{rounded}");
    let exponent = format!("{rounded:e}");
    if rounded.abs() < 1e-3 || rounded.abs() >= 1e7 { exponent } else { plain }
}
