//! Tolerances of contact rows: gaps and rates that count as zero, inequalities, impacts, and the steps of `MoreauJean`.
//!
//! Files are those of `plm-runtime/src/contact/`, unless another folder is named. A row has the gap or displacement z, the free
//! acceleration c, the multiplier lambda, and the entry `D_ii` of the Delassus operator.

super::tolerance::tolerances! {
    // Gaps: `event.rs`.

    /// A part of the mechanism's length. A gap is closed up to it where a run begins and in steps without events, and a gap that is as far
    /// below zero is a penetration: ten times the part up to which assembly closes joints ([`CLOSED`](super::CLOSED)). Read by `sunk.rs`,
    /// `stepping/impacts.rs` and `plm-runtime/src/events/violated.rs` too.
    GAP_CLOSED: f64 = 1e-9;
    /// Units in the last place of the mechanism's length. A gap that closes at the time of an event is off by it: a sum of eight products,
    /// each with the rounding of the state ([`STATE_ROUNDED`](super::STATE_ROUNDED)). With 1e-9 of the length, impacts 3e-11 s apart would
    /// be one, with another outcome. The gap may be larger by its rate times the rounding of the time.
    GAP_ROUNDED: f64 = 64.0;
    /// A part of the mechanism's length. A gap that closes at a located event is led to zero from it: the event is located on dense output,
    /// which is off by some tolerances of a step. From 1e-9 alone, the steps of a stack of blocks would begin with a jump.
    GAP_LED: f64 = 1e-6;
    /// A part of the mechanism's length. A constraint that begins to exist is led back from it: starts have four digits. Read by `sunk.rs`.
    CONSTRAINT_LED: f64 = 1e-4;

    // Rates: `event.rs` and `scales.rs`.

    /// A part of the speed that the free acceleration gives over the length of the mechanism. A friction does not slip below it: its
    /// square, 1e-20, is far below the rounding of the energy.
    NO_SLIP: f64 = 1e-10;
    /// Units in the last place of the largest rate before the impacts of an event. A smaller rate after them is rounding, that of the
    /// system from which their impulses follow.
    RATE_ROUNDED: f64 = 4096.0;
    /// Units in the last place of velocities, from which the rounding of rates follows if bodies move on together: a margin of two over
    /// [`STATE_ROUNDED`](super::STATE_ROUNDED), since impulses are in these velocities. Without it, four masses in a row with impacts by
    /// pairs do not end within [`MOST_PAIRS`](super::MOST_PAIRS).
    VELOCITY_ROUNDED: f64 = 16.0;
    /// A part of the mechanism's length, and of the speed that the free acceleration gives over it. A constraint row that is farther off was
    /// moved by the caller: errors of integration are smaller. Read by `changed.rs`.
    MOVED_BY_CALLER: f64 = 1e-5;

    // Low flights: `flights.rs`.

    /// Units in the last place of the mechanism's length. A lower flight is rounding. The limit of rates that follows is 1e-6 to 1e-5 m/s
    /// for machines of a metre; with 1e-6 m/s a reference is off by 5e-14, with 1e-7 m/s by 2e-10, since lower flights are rounding.
    LOWEST_FLIGHT: f64 = 1000.0;
    /// A part of the row's `D_ii`. Rows with a smaller entry are left out of the search for the largest pull, which counts with the root of
    /// the ratio of both entries: it would count a thousandfold.
    LIGHT: f64 = 1e-6;

    // Frictions whose slip a drive prescribes, or that have no direction: `driven.rs` and `slips.rs`.

    /// s. Acceleration and jerk give the velocity that decides after it: at the end of a motion that comes to rest smoothly the
    /// acceleration is still that of braking, and the jerk, which ends it, outweighs it.
    SHORTLY: f64 = 1e-5;
    /// Units in the last place of the largest of 1 m/s, 1 rad/s and the fastest row. A smaller prescribed velocity is rounding, as
    /// [`GAP_ROUNDED`] of a gap.
    STILL: f64 = 64.0;
    /// Units in the last place of 1 m/s^2 or 1 rad/s^2. A smaller prescribed acceleration is rounding: in absolute coordinates it is the sum
    /// of forces that balance each other.
    UNMOVED: f64 = 4096.0;
    /// m/s^2 or rad/s^2. The largest force of a friction does not change the motion of its row if it gives the row less than this: in a
    /// second a tenth of the 1e-10 m to which joints are closed.
    UNSHAKEN: f64 = 1e-11;
    /// 1/kg or 1/(kg m^2). Entry of D up to which a carried row may be at rest by a drive: that of a body of 1e9 kg.
    SLIGHT: f64 = 1e-9;
    /// m/s or rad/s. A row at rest has left its rest at this speed: the errors of integration of a zero velocity are smaller, ...
    LEFT_REST: f64 = 1e-9;
    /// ... and at least so many units in the last place of 1 m/s, for numbers with fewer digits.
    LEFT_REST_ROUNDED: f64 = 1024.0;
    /// A ratio to that speed. Of rows up to so many times as fast, 1e-5 m/s, errors of integration are removed by projection before it is
    /// decided if they have left their rest.
    SLOW_AT_REST: f64 = 1e4;

    // Rows without direction: `rows.rs`.

    /// A part of the fastest row's speed along its direction. A row at rest is slower; one that turns in its dead centre is not.
    SLOW_ROW: f64 = 1e-3;
    /// A part of the largest `D_ii`, for a length of at least 1 m. A smaller entry is rounding of terms that cancel: 450 units in the last
    /// place. A row that is held although it has no direction has multipliers of 1e18, which satisfy all inequalities to rounding; a
    /// slider-crank with friction in its pins would stop in its dead centre.
    CANCELLED: f64 = 1e-13;

    // The system of the active rows: `multipliers.rs` and `sliding.rs`.

    /// A part of the largest entry of the row. Rows depend on others if their pivot is smaller: multipliers of `f64` have six digits there.
    /// It is not [`ROW_DEPENDENT`], which is relative to the diagonal entry, and at which other rows carry the row.
    PIVOT_DEPENDENT: f64 = 1e-10;
    /// A part of the largest entry of the row. A diagonal entry of at least this is a pivot without a search for a larger one, if all rows
    /// slip: no entry of the row is more than twice its pivot.
    PIVOT_LARGE: f64 = 0.5;
    /// Change of the unit vectors of reactions. Newton's method has converged below it: the error of a size is of second order in that of
    /// its unit vector, here 1e-16.
    UNIT_VECTOR_FOUND: f64 = 1e-8;
    /// Units in the last place of the largest force, or acceleration. Sweeps end at smaller changes: the rounding of a sum of two.
    SWEPT_ROUNDED: f64 = 2.0;
    /// A ratio of the changes of two successive sweeps. At a larger one sweeps gain less than a binary digit each, and are given up.
    SWEPT: f64 = 0.5;
    /// A part of the width of an interval of unit vectors, by which it is widened if it does not contain its image. Read by `enclosed.rs`.
    WIDER: f64 = 0.5;
    /// Least widening of such an interval, 450 units in the last place, so that rounding does not leave it. Read by `enclosed.rs`.
    WIDER_LEAST: f64 = 1e-13;

    // Inequalities of a combination of modes: `candidates.rs`, `enumerate.rs` and `marginal.rs`.

    /// A part of the terms. An inequality is marginal below it: rounding of forces is smaller as long as pivots are above 1e-6. Read by
    /// `choose.rs`, `impact.rs` and `signs.rs` too.
    MARGINAL: f64 = 1e-9;
    /// Units in the last place of the largest acceleration. Every acceleration has this error: that of a row that rests is rounding of those
    /// of others. With its own terms alone a stack of blocks finds no modes. Accelerations and multipliers that are smaller than it become
    /// zero in the rate (`forces.rs`): so a block that rests on two corners takes 14 steps an hour at every tolerance.
    ACCELERATION_ROUNDED: f64 = 32.0;
    /// Units in the last place of the terms of its equation. A force has this error. For a row with almost no direction these terms are far
    /// larger than its force: compared with them its margin would count as marginal, and a slider-crank would stop in a dead centre.
    FORCE_ROUNDED: f64 = 4.0;
    /// A part of the row's diagonal entry. A row whose own part of D, or whose pivot beside the other rows, is smaller depends on them, and
    /// they carry it. Read by `stepping/solver.rs` too.
    ROW_DEPENDENT: f64 = 1e-9;
    /// A part of the largest terms of all rows. Accelerations that differ by less are equal: the terms of a row may be nothing but rounding
    /// of the others, of which 1e-12 is 4500 units in the last place.
    SAME_ACCELERATION: f64 = 1e-12;
    /// s. A margin or a bound that comes to zero within it counts as zero: the accuracy of the times of events. Read by `bounds.rs` too.
    AT_ONCE: f64 = 1e-10;
    /// A part of the terms. Largest marginal value near a pose at which a row has no direction: rates have no bound there.
    MOST_MARGINAL: f64 = 1e-4;
    /// s. Such a pose is near if the diagonal entry of D changes by its own size within it. Elsewhere terms may be small because large
    /// ones cancel, as for a point that leaves a sphere.
    TURNS_WITHIN: f64 = 1e-6;
    /// A part of the terms. A smaller rate of a margin is zero, as a smaller value is ([`MARGINAL`]).
    NO_RATE: f64 = 1e-9;
    /// A part of the largest number of the tableau. Numbers that differ by less are equal, and pivots are larger: rounding of many
    /// exchanges, 45 000 units in the last place. Read by `pivots.rs`.
    LEMKE_EQUAL: f64 = 1e-11;

    // Margins over a step: `margins.rs` and `guards.rs`.

    /// A part of the determinant with which the modes were chosen. A slip may lead to it; nearer to zero forces are 1e8 times as large, and
    /// half of their digits are rounding. Read by `paradox.rs` too.
    UNIQUE: f64 = 1e-8;
    /// 1/N or 1/(N m). A friction without a force gets one if its bound exceeds the inverse, 1e-12 N.
    NO_BOUND: f64 = 1e12;
    /// A ratio to the second difference of a guard over half of a step. A guard that is larger keeps its sign: a parabola falls by an eighth
    /// of that between two places, ...
    BENT: f64 = 2.0;
    /// ... and it is larger than this part of its change.
    CHANGED: f64 = 0.125;
    /// Determinant of slipping rows: 1 if none bounds another one, 0 if they lock each other. Below half of the way it is checked over the
    /// step.
    COUPLED: f64 = 0.5;
    /// A part of the force that would hold the row; a number for coefficients of friction. A bound that is less below zero is rounding, as
    /// forces are at [`MARGINAL`]. Read by `bounds.rs`.
    BOUND_ROUNDED: f64 = 1e-9;

    // Impacts: `booked.rs`.

    /// A part of the energy that impulses and rates turn over, `sum |Lambda_i| (|g_i-| + |g_i+|)/2`. A smaller gain is rounding: the balance
    /// of impulses and rates holds to 1e-15 of it. Newton's law gains energy in 31 of 2000 random contacts with friction.
    IMPACT_GAINS: f64 = 1e-9;

    // Time steps without events: `stepping/`.

    /// A part of the change of rates by accelerations in a step. A friction with a smaller rate is assumed to stick at first, and rounds
    /// correct that. [`NO_SLIP`] is smaller, since nothing corrects the modes after an event. Read by `stepping/problem.rs`.
    STICKS_AT_FIRST: f64 = 1e-9;
    /// Units in the last place of the row's own terms. A law with a smaller error is satisfied. It is not [`ACCELERATION_ROUNDED`], which is
    /// relative to the largest row. Read by `stepping/solver.rs`.
    LAW_MET: f64 = 64.0;
    /// A part of the terms, for a row that others carry: its rate follows from theirs with an error of rounding over [`ROW_DEPENDENT`],
    /// 2e-7. Read by `stepping/solver.rs`.
    CARRIED: f64 = 1e-6;
}

/// The part of the terms of two motions up to which these are equal: either may be off by [`MARGINAL`] to both sides.
#[inline]
pub(crate) fn same_motion() -> f64 {
    4.0 * MARGINAL.get()
}

/// Speed, m/s or rad/s, at which a row at rest has left its rest, for numbers with this unit in the last place.
#[inline]
pub(crate) fn left_rest(precision: f64) -> f64 {
    (LEFT_REST_ROUNDED.get() * precision).max(LEFT_REST.get())
}
