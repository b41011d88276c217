//! Tolerances for loops in closed form: for the change of charts, and for the distance of a state from the last checked one.

use super::ByPrecision;
use crate::scalar::{Real, Scalar};

super::tolerances! {
    /// A measure. Below it other charts are compared: rounding in accelerations, which grows with the third power of the inverse measure,
    /// is 37 units in the last place there.
    FLAT: f64 = 0.3;
    /// A ratio of measures. Another chart is chosen if it is better by this factor: rounding falls eightfold, by about a digit, so that
    /// two charts do not alternate.
    BETTER: f64 = 2.0;
    /// A measure. Below it no chart is good: rounding in accelerations is 1e-11 there (1e-5 in single precision), the third power of
    /// the inverse times a unit in the last place.
    REGULAR_CHART: ByPrecision = ByPrecision { double: 0.03, single: 0.2 };
    /// A ratio of measures. Near a singular pose a chart is used again only if its measure exceeds [`REGULAR_CHART`] by this factor:
    /// rounding is less than half then.
    BACK: f64 = 1.3;
    /// A measure, squared. A square that is more negative means a loop that cannot be closed; one that is nearer to zero may be a flat
    /// pose with rounding of the lengths, `1e-5` rad from it.
    OPEN: f64 = 1e-10;
    /// A part of the measure: its largest change within the intervals about the coordinates, and so the width of an interval as a part of
    /// the turn next to a flat pose. Generated code makes these intervals with it.
    BOX: f64 = 0.1;
    /// A number of intervals. If the interval of a coordinate is at least so many times as wide as that of [`FLAT`], the coordinate may
    /// move by as many intervals until the next check.
    ///
    /// With M the square of a dyad's measure sin theta, and g = cos theta as a function of the coordinate, an interval is at most
    /// 0.1 M / |g'| and 0.1 sqrt(M). On n intervals g changes by at most (0.1 n + 0.005 n^2 |g''|) M, and the loop is flat if it has
    /// changed by M / 2: not on two intervals as long as |g''| < 15, which is about the length of a crank over that of the dyad's bars. M
    /// keeps 0.6 of its value if g'' is small, so that an interval at the end of the way is not tight if the first was twice as wide.
    BOXES: f64 = 2.0;
    /// A part of an interval. The second state in a new chart is ahead by it: the difference of two measures has half of all digits.
    PROBE: f64 = 0.01;
    /// A number of intervals. Largest distance of a state from the last checked one: at 10 a loop could be flat between them.
    FAR: f64 = 7.0;
    /// rad. Largest angle by which a body may turn between two checks: its angle is known up to whole revolutions, which half a
    /// revolution would confuse.
    FARTHEST: f64 = 1.0;
    /// A part of the measure. Largest distance of an unknown of an iteration from the value that its rates predict: other solutions are
    /// at least about twice the measure away.
    FARTHEST_ITERATED: f64 = 0.25;
    /// A part of a measure. A smaller change of it may be rounding, and such a step is short in comparison with every turn.
    NOTICED: f64 = 1e-4;
    /// A factor. Intervals of iterated groups are not narrowed by more at once.
    NARROWEST_BOX: f64 = 0.01;
    /// rad. An iteration that does not converge has no solution if its unknowns should have moved by less; otherwise the step was too
    /// long.
    UNREACHED: f64 = 0.1;
    /// A factor. Lanes take a step together if it is shorter than this part of the longest step of each: comparisons in other roundings.
    SURELY: f64 = 0.999;
}

/// The part of a typical coordinate below which an interval is that of a measure below [`FLAT`].
#[inline]
pub(crate) fn tight() -> f64 {
    BOX.get() * FLAT.get()
}

/// Square of the measure above which a chart is good.
#[inline]
pub(crate) fn regular_chart<S: Real>() -> S {
    let measure = REGULAR_CHART.get::<S>();
    S::lit(measure * measure)
}

/// Square of the measure below which the measure no longer narrows the distance that unknowns may have: intervals are not narrower
/// either.
#[inline]
pub(crate) fn narrowest_square<S: Scalar>() -> S {
    S::lit(NARROWEST_BOX.get() * NARROWEST_BOX.get())
}
