//! Logarithmic scales: ranges and ticks, in decimal logarithms.

use super::axis::Tick;
use super::label::power_of_ten;

/// As many labels as an axis holds without crowding.
const MOST_LABELS: i32 = 10;

/// A range of at least this width holds two of the numbers 1, 2 and 5 times a power of ten.
const NARROWEST: f64 = 0.7;

/// From the smallest to the largest of some logarithms, and never too narrow for ticks.
pub(super) fn extent(logarithms: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = logarithms
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    if low > high {
        return (0.0, 1.0);
    }
    let missing = (NARROWEST - (high - low)).max(0.0);
    (low - 0.5 * missing, high + 0.5 * missing)
}

/// Ticks between two logarithms: at decades, labelled as far as there is room; between them at the whole multiples
/// where the range is short, and in a very short one labels at 2 and 5 too.
pub(super) fn ticks(low: f64, high: f64) -> Vec<Tick> {
    let (first, last) = ((low - 1e-9).floor() as i32, (high + 1e-9).ceil() as i32);
    let every = ((high - low) as i32).div_euclid(MOST_LABELS) + 1;
    let labelled: &[i32] = if high - low < 2.0 { &[1, 2, 5] } else { &[1] };
    let multiples = if high - low <= 6.0 { 1..10 } else { 1..2 };
    let plain = low > -3.1 && high < 4.1;

    let mut ticks = Vec::new();
    for exponent in first..=last {
        for digit in multiples.clone() {
            let position = f64::from(exponent) + f64::from(digit).log10();
            let has_label = labelled.contains(&digit) && exponent.rem_euclid(every) == 0;
            let is_inside = low - 1e-9 <= position && position <= high + 1e-9;
            // So many decades that ticks between the labelled ones would be a grey edge.
            let is_crowded = every > 9 && !has_label;
            if !is_inside || is_crowded {
                continue;
            }
            let label = if has_label { label(digit, exponent, plain) } else { String::new() };
            ticks.push(Tick { value: value(digit, exponent), label });
        }
    }
    ticks
}

/// The number nearest to digit · 10^exponent, subnormal ones too.
fn value(digit: i32, exponent: i32) -> f64 {
    format!("{digit}e{exponent}").parse().unwrap_or(f64::NAN)
}

/// `0.02` or `2×10⁻²`.
fn label(digit: i32, exponent: i32, plain: bool) -> String {
    match (plain, exponent) {
        (true, 0..) => format!("{digit}{}", "0".repeat(exponent as usize)),
        (true, _) => format!("0.{}{digit}", "0".repeat((-exponent - 1) as usize)),
        (false, _) if digit == 1 => power_of_ten(exponent),
        (false, _) => format!("{digit}×{}", power_of_ten(exponent)),
    }
}

#[cfg(test)]
mod tests {
    use super::super::table::cases;
    use super::*;

    fn labels(low: f64, high: f64) -> String {
        let labels = ticks(low.log10(), high.log10()).into_iter().map(|tick| tick.label);
        labels.filter(|label| !label.is_empty()).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn labels_stand_at_decades() {
        for (low, high, expected) in cases::<(f64, f64, String)>("decades") {
            assert_eq!(labels(low, high), expected);
        }
    }

    #[test]
    fn ticks_between_labels_stand_at_whole_multiples() {
        for (low, high, expected) in cases::<(f64, f64, String)>("between") {
            let values = ticks(low.log10(), high.log10()).into_iter().map(|tick| tick.value.to_string());
            assert_eq!(values.collect::<Vec<_>>().join(" "), expected);
        }
    }

    #[test]
    fn one_value_gets_room_for_two_ticks() {
        let (low, high) = extent([3.0].into_iter());
        assert!((high - low - NARROWEST).abs() < 1e-12 && low < 3.0 && 3.0 < high);
        assert!(ticks(low, high).iter().filter(|tick| !tick.label.is_empty()).count() >= 2);
    }
}
