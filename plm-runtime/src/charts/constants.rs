//! The numbers by which charts are followed, for code that follows them without this crate.

use crate::scalar::Real;
use crate::tolerances::{
    BETTER, BOX, BOXES, FAR, FARTHEST, FARTHEST_ITERATED, FLAT, NARROWEST_BOX, NOTICED, OPEN, PROBE, SHARP,
    narrowest_square, regular_chart, tight,
};

/// The tolerances of charts in a scalar type; the book's chapter on near-singular poses derives them.
#[derive(Clone, Copy, Debug)]
pub struct Constants<S> {
    /// Square of the measure below which other charts are compared.
    pub flat: S,
    /// Square of the ratio of measures by which another chart has to be better.
    pub better: S,
    /// Square of the measure above which a chart is good.
    pub regular: S,
    /// Least square of a measure of loops that are closed.
    pub open: S,
    /// Part of the measure that is an interval.
    pub interval: S,
    /// Number of intervals that a coordinate may cross far from flat poses.
    pub intervals: S,
    /// Part of an interval by which a new chart is probed.
    pub probe: S,
    /// Most intervals between two checked states.
    pub far: S,
    /// Most that a body may turn between these, rad.
    pub farthest: S,
    /// Square of the part of the measure by which an unknown of an iteration may be off.
    pub farthest_iterated: S,
    /// Least square of a measure that counts for that.
    pub narrowest_square: S,
    /// Part of a measure that is not rounding.
    pub noticed: S,
    /// Least factor by which intervals become narrower at once.
    pub narrowest: S,
    /// Most part of an interval that a step by itself may cross near a flat pose.
    pub sharp: S,
}

impl<S: Real> Constants<S> {
    /// Those of the type.
    pub fn new() -> Self {
        let square = |value: f64| S::lit(value * value);
        Self {
            flat: square(FLAT.get()),
            better: square(BETTER.get()),
            regular: regular_chart(),
            open: S::lit(-OPEN.get()).min(S::lit(-64.0) * S::EPSILON),
            interval: BOX.of(),
            intervals: BOXES.of(),
            probe: PROBE.of(),
            far: FAR.of(),
            farthest: FARTHEST.of(),
            farthest_iterated: square(FARTHEST_ITERATED.get()),
            narrowest_square: narrowest_square(),
            noticed: NOTICED.of(),
            narrowest: NARROWEST_BOX.of(),
            sharp: SHARP.of(),
        }
    }

    /// Interval of a coordinate below which it is near a flat pose, of a typical size of one, among so many coordinates.
    pub fn tight(coordinates: usize) -> S {
        S::lit(tight() / coordinates as f64)
    }

    /// Interval of a coordinate above which it may cross several, likewise.
    pub fn ample(coordinates: usize) -> S {
        S::lit(BOXES.get() * tight() / coordinates as f64)
    }
}

impl<S: Real> Default for Constants<S> {
    fn default() -> Self {
        Self::new()
    }
}
