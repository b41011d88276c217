//! Tolerances of the detection of events: rounding of guards, times of events, kinks, chattering, guard-free regions.
//!
//! Files are those of `plm-runtime/src/events/`, unless another folder is named. A guard is positive while its condition keeps its side.

super::tolerance::tolerances! {
    // Guards at a state: `rounding.rs`.

    /// Units in the last place of a state and of the time. The rounding of a guard follows from it, by its slopes: a step adds some terms to
    /// a state, and its time is a sum. Read by `passing.rs`, `piece.rs`, `touch.rs` and `plm-runtime/src/contact/event.rs` too.
    STATE_ROUNDED: f64 = 8.0;
    /// A ratio to the rounding of the guard. A guard that is farther from zero is not zero, whatever its rate, and the rate need not be
    /// evaluated. Read by `boundary.rs`.
    FAR_FROM_ZERO: f64 = 1e6;
    /// A ratio to the rounding of the guard. For numbers with derivatives, a guard or its change counts as zero up to it, and a motion
    /// touches a boundary within it. Read by `derived.rs` and `touch.rs`.
    ON_BOUNDARY: f64 = 1e3;
    /// A ratio to the rounding of the guard. A guard that goes beyond its boundary by less touches it. Read by `derived.rs`.
    GRAZES: f64 = 8.0;
    /// Units in the last place of a state and its typical size. An event that has moved the state by less has moved it by rounding alone, as
    /// impulses do that satisfy joints again. Read by `sets.rs`.
    SET_ROUNDED: f64 = 1024.0;

    // Steps, and times in a step: `mod.rs`.

    /// Units in the last place of the time. A shorter step counts as none. Read by `kinks.rs` too.
    NO_STEP: f64 = 32.0;
    /// Units in the last place of a step. The root of a kink, or of the slope of a guard, is found to it. Read by `kinks.rs` and `touch.rs`.
    ROOT_FOUND: f64 = 16.0;
    /// A part of the step. Its end is moved to the zero of a guard by no more: the midpoint rule errs by 1e-9 of the step there. Read by
    /// `boundary.rs`.
    END_MOVED: f64 = 1e-3;
    /// A part of the step before its end, at which a second slope gives the second derivative of a guard. Read by `derived.rs`.
    BEND_APART: f64 = 1e-3;
    /// A part of the derivatives of the times of two events. If they differ by less these events coincide on either side. Read by
    /// `derived.rs` and `plm-runtime/src/contact/marginal.rs`.
    SAME_TIME: f64 = 1e-6;
    /// The unit of the derivative. A distance from a boundary with a smaller derivative does not move. Read by `touch.rs`.
    NO_DERIVATIVE: f64 = 1e-12;
    /// s, and a part of the time. A step that fails so shortly before a pole or the end of a domain fails because of it. Read by `jumps.rs`.
    SOON: f64 = 1e-6;
    /// Square roots of the rounding of 1 s plus the time. The event of a state at rest is tried so far ahead: as little as lets the guard
    /// change by more than its rounding. Read by `thrown.rs`.
    AHEAD_OF_REST: f64 = 64.0;
    /// A part of the depth to which dense output dips. If the rate at the beginning of the step gives a smaller fall, it contradicts the dip:
    /// a true one begins with the rate. Read by `dips.rs`.
    DIP_CONTRADICTED: f64 = 0.125;

    // The search over a step: `search.rs`, `piece.rs` and `quartic.rs`.

    /// A ratio to the variation of a guard over an interval. Its parabola is accepted if it is at least so many times as far from the edge: a
    /// force that swings while nothing moves may go through more than one period in a step, ...
    FAR_FROM_EDGE: f64 = 2.0;
    /// ... or if it bends by no more than this part of half of its change. Further halvings are a third of the instructions of a
    /// slider-crank with friction in its pins.
    STRAIGHT: f64 = 0.25;
    /// A part of the step that is accepted as searched: four times the part that [`MOST_INTERVALS`](super::MOST_INTERVALS) cover if all stay
    /// open.
    SEARCHED_LEAST: f64 = 0.002;
    /// Sizes of the terms of a guard. If its second derivative over the whole step is smaller, nothing hides between values.
    SMOOTH: f64 = 16.0;
    /// A ratio to the largest difference of the quartic from four values between its own. It bounds the error of the quartic, which is 1.11
    /// times that difference if the fifth derivative is constant.
    QUARTIC_OFF: f64 = 4.0;
    /// A ratio to the rounding of the values. A coefficient of the quartic has this error: the sum of the sizes of its weights.
    COEFFICIENT_ROUNDED: f64 = 16.0;
    /// A part of the change of a guard. It falls throughout if the error of the quartic is at most that.
    STEADY: f64 = 0.125;

    // Kinks: `kinks.rs`, and `passing.rs` for numbers with derivatives.

    /// A part of a step after a kink, at the end of which its sign has changed, and nothing else yet: a narrow hat of a table would be over
    /// after a thousandth of the step. Signs are evaluated so far after the beginning of a step too, which may be a kink, ...
    BESIDE_KINK: f64 = 1e-9;
    /// ... and at least so many units in the last place after it.
    BESIDE_KINK_ROUNDED: f64 = 64.0;
    /// Tolerances of a step. A kink that contributes less to its error does not matter: the derivative of the dense output is several times
    /// less accurate than the step itself.
    KINK_MATTERS: f64 = 1.0;
    /// A part of the distance to a kink that a step leaves if the distance is long, so that its stages stay on their side, ...
    LEFT_BY_LONG: f64 = 1.0 / 16.0;
    /// ... and if it is short: the error of the stages of a step is a power of its length.
    LEFT_BY_SHORT: f64 = 1.0 / 1024.0;
    /// A part of the proposed step. A distance below it is short.
    SHORT_OF_KINK: f64 = 1.0 / 64.0;
    /// A part of the proposed step that the last step before a kink leaves, and by which the step over it goes beyond, ...
    PASSED_BY: f64 = 1.0 / (1_u64 << 34) as f64;
    /// ... at least so many times the longest step that counts as none.
    PASSED_STEPS: f64 = 2.0;
    /// A ratio to the rounding of a kink function. After the crossing it is at least so far from zero.
    BEYOND_KINK: f64 = 4.0;

    // Chattering: `chattering.rs`.

    /// A part of the longest step so far. Switches within it are in a short time, ...
    CHATTERING: f64 = 1e-6;
    /// ... which is at least so many units in the last place of the time.
    CHATTERING_ROUNDED: f64 = 1000.0;
    /// A ratio to the rounding of the guard, for each switch. Switches between which the guard moves less count however long they take: a
    /// ball at the end of its bounces flies no higher, ...
    UNSEEN: f64 = 1e3;
    /// ... up to this part of the longest step, or of the time to the end of the interval if that is longer.
    UNSEEN_FOR: f64 = 0.01;

    // Guard-free regions of steps of fixed length: `guard_free.rs`. Sizes are parts of the sizes of states.

    /// A part of the sizes of states. A region reaches so far about its centre at first, ...
    REACH_FIRST: f64 = 1.0 / 16.0;
    /// ... so far at most, while guards are far, ...
    REACH_WIDEST: f64 = 0.5;
    /// ... and so far at least. If guards are nearer they are evaluated in every step, which costs less than regions of a few steps.
    REACH_NARROWEST: f64 = 1.0 / 1024.0;
    /// Steps that a region of the reach 1 lasts: guards may depend on time alone.
    REGION_LASTS: f64 = 4096.0;
    /// A ratio to the reach, within which guards are enclosed: the difference of a state from the centre is rounded.
    REGION_SLACK: f64 = 1.0 + 1.0 / 256.0;
}
