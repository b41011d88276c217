//! Tolerances of the near-singular method: for its takeover, the search for the pose ahead, and the crossing of that pose.

use super::ByPrecision;
use crate::scalar::Real;

super::tolerances! {
    // Nearness of a step to a singular pose.

    /// rad. A pose that is nearer to a singular one is ill-conditioned, and the near-singular method takes over: its pivot ratio is about
    /// the square, relative to that of other poses. In absolute coordinates rounding grows with the inverse of that, to 1e-14.
    ILL_CONDITIONED: f64 = 0.1;
    /// A ratio of pivot ratios. The near-singular method ends where the pivot ratio is so many times the bound of ill-conditioned poses:
    /// twice as far from the pose.
    CLEAR: f64 = 4.0;
    /// A pivot ratio. A step with a smaller one is compared with other poses: ten times the bound of ill-conditioned poses, three times as
    /// far from the singular one.
    LOW: f64 = 0.1;
    /// rad. Largest distances of the reference poses in each coordinate: in no simple ratios, so that one of the poses is regular.
    REFERENCE_POSES: [f64; 4] = [2.0, 7.0, 13.0, 19.0];
    /// A pivot ratio. Above it a turn is at least as wide as [`WIDE_TURN`], unless a step is long.
    REGULAR: f64 = 0.3;
    /// A pivot ratio. Above it there is no turn at all: a parabola through it that doubles within a radian exceeds 1.
    NO_TURN: f64 = 0.5;
    /// rad over the root of a pivot ratio. A shorter step is less than a hundredth of the shortest turn, which is half that root, and needs
    /// no further check.
    SLOW: f64 = 0.005;
    /// rad. Steps follow turns that are narrower; wider ones are those of regular poses.
    WIDE_TURN: f64 = 0.3;
    /// rad. Distance of the poses to both sides of a state that determine how sharp a turn is: a parabola has an error of its square there,
    /// and a rounding of a unit over it.
    TURN_APART: f64 = 0.01;

    // Length of a step relative to a turn.

    /// A number of intervals about a coordinate. A single step that crosses more is left to the near-singular method, ...
    SHARP: f64 = 1.0;
    /// ... and a step of fixed length that crosses more is split: a fiftieth of the turn, on which a formula of order 4 errs by 1e-7 of it.
    LONG: f64 = 0.2;
    /// A factor. In single precision steps may be longer by its inverse: their errors are about a unit in the last place then, and shorter
    /// steps would add up more of these.
    FAST: f64 = 0.3;

    // The pose ahead.

    /// rad. Distance of the poses to both sides of a state that give the first parabola of its pivot ratio; a motion that needs less to
    /// reverse is slow.
    APART: f64 = 0.02;
    /// A part of `v^2/a`. The motion reverses at half of it; a pose within a quarter of it is reached, and the other quarter is left for
    /// the error of the parabola.
    BEFORE_TURNING: f64 = 0.25;
    /// A part of the present pivot ratio. A parabola that falls below may come to zero: three pivots to three digits do not tell more.
    VANISHES: f64 = 0.05;
    /// Roots of a unit in the last place, rad. A narrower parabola is rounding: lengths that differ by a unit give one as wide as the root.
    NARROWEST: f64 = 1e-3;
    /// A part of the parabola's scale. Longest step along it: the pivot changes by a sixth, its root by a twelfth.
    FOLLOWS: f64 = 0.4;

    // The pose according to the lengths.

    /// A part of the largest singular value. Smaller ones vanish together at the singular pose: they are about its distance in rad.
    SMALL: f64 = 1e-3;
    /// Units in the last place of the largest singular value. Rows with a smaller singular value repeat others at every pose.
    REPEATED: f64 = 1e3;
    /// A ratio of singular values. Those up to so many times the smallest vanish together with it; if no such pose is found, it vanishes
    /// alone.
    TOGETHER: f64 = 8.0;
    /// rad. From a pose that is farther away Newton's iteration may find another one.
    SEARCHED: f64 = 0.5;
    /// Roots of a unit in the last place. Newton's iteration has converged to a pose if its step is shorter: the next one would be its
    /// square.
    CONVERGED: f64 = 1e-2;
    /// A part of the largest curvature, squared. A smaller one is rounding of the difference quotients: the square of their error.
    CURVED: f64 = 1e-8;
    /// rad. The step of a difference quotient: the third root of a unit in the last place, as a power of two, where rounding and the
    /// error of the quotient are equal.
    DIFFERENCE: ByPrecision = ByPrecision { double: 1.0 / 131_072.0, single: 1.0 / 256.0 };
    /// Units in the last place of each length. A length that was read from decimals is off by a half; one that was multiplied by a unit or
    /// a count before is off by a quarter more at most.
    ROUNDED_LENGTH: f64 = 0.75;
    /// rad. Nearer to a pose, rounded lengths turn the motion by `EPSILON` over the square of the distance, so that the parabola is not
    /// used: the fourth root of a unit in the last place.
    UNCERTAIN: f64 = 1e-4;
    /// rad and parts of lengths. Largest distance of a pose that is found without the parabola, and largest change of an assembled one.
    NEARBY: f64 = 1e-3;
    /// A pivot ratio over that of other poses. An assembled pose with a smaller one, a hundredth of a radian from a singular pose, is
    /// closed again: gaps of rounding there are angles that reach the tenth digit.
    STARTS_NEAR: f64 = 1e-4;
    /// A ratio of successive Newton steps. A larger one means convergence to a double root: one half, with a margin.
    HALVED: f64 = 0.4;
    /// Units in the last place. Nodes and times are found if they move by less: the rounding of a sum of sixteen terms.
    FOUND: f64 = 16.0;
    /// A part of the remaining time. Accuracy of the time of a lock-up.
    TIME_FOUND: f64 = 1e-9;
    /// A ratio of gaps. Joints are closed at a lock-up if they are open by at most so many times what a prescribed motion changes within the
    /// resolution of the time: the rate of other rows may be larger by a digit.
    CLOSES: f64 = 10.0;
    /// A part of the distance and of the time to the end of a prescribed motion by its speed. Nearer to it the law gains digits with each
    /// step; a motion that passes a pose by is off by all of them.
    ON_THE_WAY: f64 = 0.5;
    /// A part of the time to that end. A law that has held down to it holds to the end, if the time that is left is at most the inverse of
    /// it times what rounding leaves undecided.
    HELD: f64 = 1e-4;

    // States on the constraints.

    /// A part of typical sizes. Largest distance of an accepted pose from the constraints; a farther one is on others, of lengths that
    /// disagree.
    POSE_MOVED: f64 = 1e-6;
    /// A part of typical speeds. Largest distance of its velocity from their tangent: a pose that is rounded at the distance d from a
    /// singular one turns the tangent by `EPSILON / d`, and takes the square of that, here 1e-6, from the energy.
    VELOCITY_MOVED: f64 = 1e-3;
    /// Lengths per radian. An angle of four radians is rounded by as much as the places of its ports.
    ANGLE_ROUNDED: f64 = 0.25;

    // Steps over a pose and around it.

    /// A relative error, that of steps around a pose: a hundredth of the tolerance that users ask for.
    TOLERANCE: ByPrecision = ByPrecision { double: 1e-11, single: 1e-6 };
    /// Distances to the pose. Lengths of a crossing, in the order of trial. For at most one of them a node lies near the pose.
    SPANS: [f64; 5] = [2.4, 2.0, 2.9, 1.7, 3.5];
    /// rad. Lengths of a step away from a singular pose: at 0.1 the polynomial of degree 16 has all digits; shorter ones follow faster
    /// forces.
    AWAY: [f64; 5] = [0.1, 0.05, 0.02, 0.01, 0.005];
    /// Units in the last place of the time. A pose that is reached within this time is the present one.
    BARELY: f64 = 64.0;
    /// rad. Nearer to a pose the state's rounding is at least 1e-10 of the distance: the distance from the pose itself is known better.
    AT_POSE: f64 = 1e-6;
    /// A ratio of distances. If no step crosses a pose, the crossing is tried again from a distance that is smaller by this factor.
    NEARER: f64 = 0.2;
    /// A part of typical sizes. Nodes that come no nearer any more are found within it: a thousand units, the rounding of their rates.
    STAGNATED: f64 = 1e-12;
    /// Units in the last place of the mechanism's size. Joints that open by less while a pose is crossed are closed, ...
    CLOSED_ON_THE_WAY: f64 = 32.0;
    /// ... with so many rows; more rows have more rounding.
    FEW_ROWS: f64 = 8.0;
    /// Units in the last place of that size. Up to so many it is undecided if joints are closed.
    UNDECIDED: f64 = 450.0;
    /// Units in the last place of that size. Joints that repeat others disagree near a flat pose by their disagreement elsewhere over the
    /// distance to it. Up to so many units that may be rounding; ...
    DISAGREE_BY_ROUNDING: f64 = 1e4;
    /// ... a step opens the joints by so many times as much.
    SPREAD: f64 = 10.0;
    /// A part of the state. Largest error of the rate at the ends of a crossing, times the length of the step.
    AGREES: f64 = 1e-10;
}

/// The pivot ratio, relative to that of other poses, below which a pose is ill-conditioned.
#[inline]
pub(crate) fn ill_conditioned() -> f64 {
    ILL_CONDITIONED.get() * ILL_CONDITIONED.get()
}

/// Length of a step, rad, above which its stages may miss a singular pose between them: four times the distance at which a pose is
/// ill-conditioned.
#[inline]
pub(crate) fn long_step() -> f64 {
    4.0 * ILL_CONDITIONED.get()
}

/// Distance, rad, of the poses of a step that are compared: half of the distance at which a pose is ill-conditioned.
#[inline]
pub(crate) fn compared_apart() -> f64 {
    0.5 * ILL_CONDITIONED.get()
}

/// The part of the largest singular value below which a [`SMALL`] one counts as zero at the pose: the square, as the last but one Newton
/// step leaves it.
#[inline]
pub(crate) fn vanished() -> f64 {
    SMALL.get() * SMALL.get()
}

/// Number of intervals about a coordinate that each part of a split step crosses: half of [`LONG`].
pub(crate) fn short() -> f64 {
    0.5 * LONG.get()
}

/// A part of typical sizes by which joints may move; half of the digits of the scalar, if that is more.
pub(crate) fn half_of_digits<S: Real>(tolerance: Tolerance) -> S {
    tolerance.of::<S>().max(S::EPSILON.sqrt())
}
