//! Linear scales: ranges and ticks.
//!
//! Ticks stand at the multiples of 1, 2 or 5 times a power of ten: P. S. Heckbert, "Nice numbers for graph
//! labels", Graphics Gems, Academic Press 1990, page 61.

use super::axis::Tick;
use super::label::power_of_ten;

/// How many steps an axis is cut into, about.
const STEPS: f64 = 6.0;

/// From the smallest to the largest value, and never an empty range: a constant gets room around it.
pub(super) fn extent(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    if low > high {
        return (0.0, 1.0);
    }
    let size = low.abs().max(high.abs());
    if can_be_divided(low, high) {
        (low, high)
    } else if size > 1e-300 {
        (low - 0.1 * size, high + 0.1 * size)
    } else {
        (-1.0, 1.0)
    }
}

/// Can the range be divided by ticks? Below that relative width a difference is mostly rounding, and labels would need too many digits.
pub(super) fn can_be_divided(low: f64, high: f64) -> bool {
    high - low > 1e-12 * low.abs().max(high.abs()) && high - low > 1e-300
}

/// The ticks in a range that can be divided, in rising order.
pub(super) fn ticks(low: f64, high: f64) -> Vec<Tick> {
    let step = Step::near((high - low) / STEPS);
    // A hair of the step, so that the ends of a tight range keep their ticks in spite of rounding.
    let first = (low / step.value() - 1e-9).ceil() as i64;
    let last = (high / step.value() + 1e-9).floor() as i64;
    let largest = first.abs().max(last.abs());
    (first..=last).map(|count| Tick { value: step.times(count), label: step.label(count, largest) }).collect()
}

/// A distance between ticks: `digit` · 10^`exponent`, stored in decimal so that labels are exact.
#[derive(Clone, Copy, Debug)]
struct Step {
    digit: i64,
    exponent: i32,
}

impl Step {
    /// The nice number nearest to `width` > 0.
    fn near(width: f64) -> Self {
        let exponent = width.log10().floor() as i32;
        let leading = width / ten_to(exponent);
        match leading {
            ..1.5 => Self { digit: 1, exponent },
            ..3.0 => Self { digit: 2, exponent },
            ..7.0 => Self { digit: 5, exponent },
            _ => Self { digit: 1, exponent: exponent + 1 },
        }
    }

    fn value(self) -> f64 {
        self.times(1)
    }

    /// `count` steps. A negative power is divided by, because 10^n is exact and 10^-n is not.
    fn times(self, count: i64) -> f64 {
        let whole = (count * self.digit) as f64;
        if self.exponent < 0 { whole / ten_to(-self.exponent) } else { whole * ten_to(self.exponent) }
    }

    /// The text of `count` steps on an axis whose largest tick is `largest` steps: plain digits, or with a
    /// power of ten common to the axis where plain digits would be many.
    fn label(self, count: i64, largest: i64) -> String {
        let number = count * self.digit;
        let leading = self.exponent + (largest * self.digit).max(1).ilog10() as i32;
        if number == 0 {
            "0".to_owned()
        } else if leading < 5 && self.exponent > -5 {
            decimal(number, self.exponent)
        } else {
            format!("{}×{}", decimal(number, self.exponent - leading), power_of_ten(leading))
        }
    }
}

/// `number` · 10^`exponent` in plain digits, with a minus sign as long as a plus.
fn decimal(number: i64, exponent: i32) -> String {
    let sign = if number < 0 { "−" } else { "" };
    let digits = number.unsigned_abs().to_string();
    if exponent >= 0 {
        return format!("{sign}{digits}{}", "0".repeat(exponent as usize));
    }
    let places = exponent.unsigned_abs() as usize;
    let digits = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places);
    format!("{sign}{whole}.{fraction}")
}

fn ten_to(exponent: i32) -> f64 {
    10_f64.powi(exponent)
}

#[cfg(test)]
mod tests {
    use super::super::table::cases;
    use super::*;

    fn labels(low: f64, high: f64) -> Vec<String> {
        ticks(low, high).into_iter().map(|tick| tick.label).collect()
    }

    #[test]
    fn ticks_stand_at_nice_numbers() {
        for (low, high, expected) in cases::<(f64, f64, String)>("linear") {
            assert_eq!(labels(low, high).join(" "), expected);
        }
    }

    #[test]
    fn a_constant_gets_room_around_it() {
        for (low, high, least, most) in cases::<(f64, f64, f64, f64)>("linear_extents") {
            let (found_least, found_most) = extent([low, high].into_iter());
            // The table has decimal fractions: one rounding of each product and sum.
            let near = |a: f64, b: f64| (a - b).abs() <= 4.0 * f64::EPSILON * b.abs();
            assert!(
                near(found_least, least) && near(found_most, most),
                "{low:e} {high:e}: {found_least} {found_most}"
            );
        }
    }

    #[test]
    fn ticks_are_the_numbers_that_their_labels_say() {
        for (low, high) in [(0.0, 1.0), (-0.7, 0.2), (3.0, 3.001), (-4.0e4, 9.0e4)] {
            for tick in ticks(low, high) {
                assert_eq!(tick.label.replace('−', "-").parse::<f64>(), Ok(tick.value));
            }
        }
    }
}
