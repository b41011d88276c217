//! Of loops in closed form: when a chart is left, and how far a state may be from the last one that was checked.

use super::ByPrecision;
use crate::scalar::{Real, Scalar};

super::tolerances! {
    /// A measure. Below it other charts are compared: rounding in accelerations, which grows with the third power of the inverse
    /// measure, is 37 units in the last place there.
    FLAT: f64 = 0.3;
    /// A ratio of measures. Another chart is taken where it is so many times as good: rounding falls eightfold, by about a digit, so
    /// that two charts do not alternate.
    BETTER: f64 = 2.0;
    /// A measure. Below it no chart is good: rounding in accelerations is 1e-11 there (1e-5 in single precision), the third power of
    /// the inverse times a unit in the last place.
    REGULAR_CHART: ByPrecision = ByPrecision { double: 0.03, single: 0.2 };
    /// A ratio of measures. A chart must be better than a poor one by it, where the mechanism comes back: rounding is less than half.
    BACK: f64 = 1.3;
    /// A measure, squared. What is below zero by more is a loop that cannot be closed; what is nearer may be a flat pose and rounding of
    /// the lengths, `1e-5` rad from it.
    OPEN: f64 = 1e-10;
    /// A part of the measure by which it changes on a box, and so the box as a part of the turn next to a flat pose. Generated code makes
    /// boxes of it.
    BOX: f64 = 0.1;
    /// A number of boxes. Where a box is at least so many times as wide as that of [`FLAT`], a coordinate may go as many boxes far until
    /// the next check.
    ///
    /// With M the square of a dyad's measure sin theta, and g = cos theta as a function of the coordinate, a box is at most
    /// 0.1 M / |g'| and 0.1 sqrt(M). On n boxes g changes by at most (0.1 n + 0.005 n^2 |g''|) M, and the loop is flat where it has
    /// changed by M / 2: not on two boxes as long as |g''| < 15, which is about the length of a crank over that of the dyad's bars. M
    /// keeps 0.6 of its value if g'' is small, so that a box at the end of the way is not tight where the first was twice as wide.
    BOXES: f64 = 2.0;
    /// A part of a box. In a new chart the second state is so far ahead: the difference of two measures has half of all digits.
    PROBE: f64 = 0.01;
    /// A number of boxes. A state may be so far from the last one that was checked: at 10 a loop could be flat between.
    FAR: f64 = 7.0;
    /// rad. So far a body may turn between two checks: its angle is known but for whole turns, which half a turn would confuse.
    FARTHEST: f64 = 1.0;
    /// A part of the measure. So far an unknown of an iteration may be from where its rates take it: other solutions are at least about
    /// twice the measure away.
    FARTHEST_ITERATED: f64 = 0.25;
    /// A part of a measure. A smaller change of it may be rounding, and such a step is short beside every turn.
    NOTICED: f64 = 1e-4;
    /// A factor. Boxes of iterated groups are not narrowed more at once.
    NARROWEST_BOX: f64 = 0.01;
    /// rad. An iteration that does not converge has no solution if its unknowns should have moved by less; else the step was too long.
    UNREACHED: f64 = 0.1;
    /// A factor. Lanes take a step together if it is shorter than this part of what each may take: comparisons in other roundings.
    SURELY: f64 = 0.999;
}

/// The part of a typical coordinate below which a box is that of a measure below [`FLAT`].
#[inline]
pub(crate) fn tight() -> f64 {
    BOX.get() * FLAT.get()
}

/// The square of the measure above which a chart is good.
#[inline]
pub(crate) fn regular_chart<S: Real>() -> S {
    let measure = REGULAR_CHART.get::<S>();
    S::lit(measure * measure)
}

/// The square of the measure below which it is not used to narrow how far unknowns may be: boxes are not narrower either.
#[inline]
pub(crate) fn narrowest_square<S: Scalar>() -> S {
    S::lit(NARROWEST_BOX.get() * NARROWEST_BOX.get())
}
