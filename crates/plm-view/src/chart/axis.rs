//! An axis as it is asked for, and the ruler that it becomes once the values along it are known.

use super::decimation::drawable;
use super::label::with_unit;
use super::{linear_scale, log_scale};

/// Quantity and scale of an axis.
///
/// The range comes from the drawing, the curves and the reference lines, unless it is given.
#[derive(Clone, Debug)]
pub struct Axis {
    /// Quantity and unit.
    pub(super) label: String,
    scale: Scale,
    falling: bool,
    tight: bool,
    extra: Vec<f64>,
    fixed: Option<[f64; 2]>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Scale {
    Linear,
    Log,
}

impl Axis {
    /// Equal distances for equal differences; the unit is written as in declarations (`N*m`, `m/s^2`), empty for
    /// a pure number.
    pub fn linear(quantity: &str, unit: &str) -> Self {
        Self {
            label: with_unit(quantity, unit),
            scale: Scale::Linear,
            falling: false,
            tight: false,
            extra: Vec::new(),
            fixed: None,
        }
    }

    /// Equal distances for equal ratios, with ticks at decades. Values that are not positive have no place on it.
    pub fn log(quantity: &str, unit: &str) -> Self {
        Self { scale: Scale::Log, ..Self::linear(quantity, unit) }
    }

    /// Reverses the axis: large values on the left, or at the bottom.
    #[must_use]
    pub fn falling(self) -> Self {
        Self { falling: true, ..self }
    }

    /// Takes away the room beyond the smallest and the largest value.
    #[must_use]
    pub fn tight(self) -> Self {
        Self { tight: true, ..self }
    }

    /// Extends the axis to `value` at least.
    #[must_use]
    pub fn including(mut self, value: f64) -> Self {
        self.extra.push(value);
        self
    }

    /// Sets the range from `low` to `high`, whatever is drawn; values beyond are left out. A range that is narrower than 1e-12 of
    /// its values or than 1e-300, or has no place on the axis, is not taken.
    #[must_use]
    pub fn range(self, low: f64, high: f64) -> Self {
        let has_place = drawable(low) && drawable(high) && (self.scale == Scale::Linear || low > 0.0);
        let has_ticks = has_place && linear_scale::can_be_divided(low, high);
        Self { fixed: has_ticks.then_some([low, high]), ..self }
    }

    /// The ruler for these values.
    pub(super) fn ruler(&self, values: impl Iterator<Item = f64>) -> Ruler {
        if let Some(fixed) = self.fixed {
            let [low, high] = if self.scale == Scale::Log { fixed.map(f64::log10) } else { fixed };
            return Ruler { scale: self.scale, falling: self.falling, low, high, is_fixed: true };
        }
        let values = values.chain(self.extra.iter().copied());
        let (low, high) = match self.scale {
            Scale::Linear => linear_scale::extent(values.filter(|&value| drawable(value))),
            Scale::Log => {
                log_scale::extent(values.filter(|&value| drawable(value) && value > 0.0).map(f64::log10))
            }
        };
        // A little room, so that no curve runs along the frame.
        let padding = if self.tight { 0.0 } else { self.scale.padding() * (high - low) };
        Ruler {
            scale: self.scale,
            falling: self.falling,
            low: low - padding,
            high: high + padding,
            is_fixed: false,
        }
    }
}

impl Scale {
    /// Room beyond the values, as a fraction of their range.
    fn padding(self) -> f64 {
        match self {
            Self::Linear => 0.06,
            Self::Log => 0.04,
        }
    }
}

/// A range of numbers along an edge of a frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ruler {
    scale: Scale,
    falling: bool,
    /// On a logarithmic scale the decimal logarithm of the range's ends.
    low: f64,
    high: f64,
    /// Values beyond a range that was given have no place.
    is_fixed: bool,
}

/// A mark on an axis; without a label between the labelled ones of a logarithmic scale.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tick {
    pub(super) value: f64,
    pub(super) label: String,
}

impl Ruler {
    /// True if a value has a place.
    pub(super) fn holds(&self, value: f64) -> bool {
        drawable(value) && (self.scale == Scale::Linear || value > 0.0) && self.reaches(value)
    }

    /// True if a value lies in the range, as far as the range was given; with a hair, so that rounding cuts off no end.
    fn reaches(&self, value: f64) -> bool {
        let hair = 1e-9 * (self.high - self.low);
        let at = self.along(value);
        !self.is_fixed || (self.low - hair <= at && at <= self.high + hair)
    }

    fn along(&self, value: f64) -> f64 {
        if self.scale == Scale::Log { value.log10() } else { value }
    }

    /// Position of `value` between the pixels `from` (the beginning of the axis) and `to` (its end).
    pub(super) fn place(&self, value: f64, from: f64, to: f64) -> f64 {
        let share = (self.along(value) - self.low) / (self.high - self.low);
        let share = if self.falling { 1.0 - share } else { share };
        from + share * (to - from)
    }

    /// The ticks in the range, in rising order.
    pub(super) fn ticks(&self) -> Vec<Tick> {
        match self.scale {
            Scale::Linear => linear_scale::ticks(self.low, self.high),
            Scale::Log => log_scale::ticks(self.low, self.high),
        }
    }

    /// True if the tick at zero deserves a stronger line.
    pub(super) fn has_zero_line(&self) -> bool {
        self.scale == Scale::Linear
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_numbers_give_a_range_with_ticks() {
        let extremes = [0.0, 1.0, -1.0, 1e-310, 1e-290, 1e299, -1e299, 1e308, f64::NAN, f64::INFINITY, 7e15];
        for axis in [Axis::linear("x", "m"), Axis::log("x", "m"), Axis::log("x", "m").falling()] {
            for (low, high) in [(0.0, 5e-324), (1.0, 1.0 + f64::EPSILON)] {
                assert!(axis.clone().range(low, high).ruler([1.0].into_iter()).ticks().len() < 20);
            }
            for low in extremes {
                for high in extremes {
                    let ruler = axis.ruler([low, high].into_iter());
                    let ticks = ruler.ticks();
                    let labels = ticks.iter().filter(|tick| !tick.label.is_empty()).count();
                    assert!((2..=13).contains(&labels), "{low:e} to {high:e}: {ticks:?}");
                    assert!(ticks.is_sorted_by(|a, b| a.value < b.value), "{low:e} to {high:e}: {ticks:?}");
                    for value in [low, high].into_iter().filter(|&value| ruler.holds(value)) {
                        assert!(
                            (0.0..=1000.0).contains(&ruler.place(value, 0.0, 1000.0)),
                            "{low:e} to {high:e}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn the_ends_of_a_range_stand_at_its_ends() {
        let ruler = Axis::linear("x", "m").tight().ruler([-2.0, 6.0].into_iter());
        assert_eq!(
            [-2.0, 0.0, 6.0].map(|value| ruler.place(value, 500.0, 100.0).round()),
            [500.0, 400.0, 100.0]
        );
        let ruler = Axis::log("x", "m").tight().ruler([1e-8, 1.0].into_iter());
        assert_eq!(
            [1e-8, 1e-6, 1.0].map(|value| ruler.place(value, 0.0, 400.0).round()),
            [0.0, 100.0, 400.0]
        );
        let ruler = Axis::log("x", "m").tight().falling().ruler([1e-8, 1.0].into_iter());
        assert_eq!(
            [1e-8, 1e-6, 1.0].map(|value| ruler.place(value, 0.0, 400.0).round()),
            [400.0, 300.0, 0.0]
        );
    }

    #[test]
    fn a_range_reaches_to_what_it_has_to_include() {
        let ruler = Axis::linear("x", "m").tight().including(10.0).ruler([0.0, 5.0].into_iter());
        assert_eq!(ruler.place(10.0, 0.0, 100.0), 100.0);
    }

    #[test]
    fn a_range_that_is_given_holds_whatever_is_drawn() {
        let ruler = Axis::linear("x", "m").range(0.0, 10.0).ruler([-5.0, 3.0, 20.0].into_iter());
        assert_eq!([0.0, 5.0, 10.0].map(|value| ruler.place(value, 0.0, 100.0).round()), [0.0, 50.0, 100.0]);
        assert_eq!([-0.1, 0.0, 10.0, 10.1].map(|value| ruler.holds(value)), [false, true, true, false]);
        let ruler = Axis::log("x", "m").range(1e-4, 1.0).ruler([1e-9].into_iter());
        assert_eq!([1e-4, 1e-2, 1.0].map(|value| ruler.place(value, 0.0, 100.0).round()), [0.0, 50.0, 100.0]);
        assert_eq!([1e-9, 1e-4, 2.0].map(|value| ruler.holds(value)), [false, true, false]);
    }

    #[test]
    fn a_range_without_a_place_is_not_taken() {
        for axis in [
            Axis::linear("x", "m").range(1.0, 1.0),
            Axis::linear("x", "m").range(f64::NAN, 1.0),
            Axis::log("x", "m").range(0.0, 1.0),
        ] {
            let ruler = axis.tight().ruler([2.0, 20.0].into_iter());
            assert_eq!([2.0, 20.0].map(|value| ruler.place(value, 0.0, 100.0).round()), [0.0, 100.0]);
        }
    }
}
