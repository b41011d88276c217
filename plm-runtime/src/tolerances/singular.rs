//! Of the near-singular method: when it takes over, how it finds the pose ahead, and when it has crossed it.

use super::ByPrecision;
use crate::scalar::Real;

super::tolerances! {
    // Whether a step has come near to a singular pose.

    /// rad. A pose that is nearer to a singular one is ill-conditioned, and the near-singular method takes over: its pivot ratio is about
    /// the square, relative to that of other poses. In absolute coordinates rounding grows with the inverse of that, to 1e-14.
    ILL_CONDITIONED: f64 = 0.1;
    /// A ratio of pivot ratios. The near-singular method is left where they are so many times what makes
    /// a pose ill-conditioned: twice as far from the pose.
    CLEAR: f64 = 4.0;
    /// A pivot ratio. Below it a step is compared with other poses: ten times as large as what makes a pose
    /// ill-conditioned, three times as far from the singular one.
    LOW: f64 = 0.1;
    /// rad. Other poses are away by up to so much in each coordinate, by no simple ratios, so that one of them is regular.
    REFERENCE_POSES: [f64; 4] = [2.0, 7.0, 13.0, 19.0];
    /// A pivot ratio. Above it a turn is at least as wide as [`WIDE_TURN`], unless a step is long.
    REGULAR: f64 = 0.3;
    /// A pivot ratio. Above it there is no turn at all: a parabola through it that doubles within a radian exceeds 1.
    NO_TURN: f64 = 0.5;
    /// rad over the root of a pivot ratio. A step that is shorter is a hundredth of the shortest turn, half that root, and needs no more
    /// attention.
    SLOW: f64 = 0.005;
    /// rad. Steps follow turns that are narrower; wider ones are those of regular poses.
    WIDE_TURN: f64 = 0.3;
    /// rad. How sharp a turn is, poses so far to both sides tell: a parabola has an error of its square there, and a rounding of a unit
    /// over it.
    TURN_APART: f64 = 0.01;

    // How long a step is beside a turn.

    /// A number of boxes. A step by itself that crosses so many is left to the near-singular method, ...
    SHARP: f64 = 1.0;
    /// ... and another one is split if it crosses so many: a fiftieth of the turn, on which a formula of order 4 errs by 1e-7 of the turn.
    LONG: f64 = 0.2;
    /// A factor. In single precision steps may be longer by its inverse: their errors are about a unit in the last place then, of which
    /// shorter ones would add up more.
    FAST: f64 = 0.3;

    // The pose ahead.

    /// rad. Poses so far to both sides of a state give the first parabola of its pivot ratio; what needs less to turn back is slow.
    APART: f64 = 0.02;
    /// A part of `v^2/a`. A pose is reached before the motion turns at a half of that; half of the half is left for the error of the
    /// parabola.
    BEFORE_TURNING: f64 = 0.25;
    /// A part of the present pivot ratio. A parabola that falls below may come to zero: three pivots to three digits tell no more.
    VANISHES: f64 = 0.05;
    /// Roots of a unit in the last place, rad. A narrower parabola is made of rounding: lengths that differ by a unit make one of the root.
    NARROWEST: f64 = 1e-3;
    /// A part of the parabola's scale. A step spans it at most: the pivot changes by a sixth, its root by a twelfth.
    FOLLOWS: f64 = 0.4;

    // What the lengths say about it.

    /// A part of the largest singular value. Smaller ones vanish together at the singular pose: they are about its distance in rad.
    SMALL: f64 = 1e-3;
    /// Units in the last place of the largest singular value. Rows of which less is left repeat others at every pose.
    REPEATED: f64 = 1e3;
    /// A ratio of singular values. Those up to so many times the smallest vanish together with it; if no pose is found so, it alone does.
    TOGETHER: f64 = 8.0;
    /// rad. From a pose that is farther away Newton's iteration may find another one.
    SEARCHED: f64 = 0.5;
    /// Roots of a unit in the last place. Newton's iteration has found a pose where a step is shorter: the next would be its square.
    CONVERGED: f64 = 1e-2;
    /// A part of the largest curvature, squared. Less is rounding of the difference quotients: the square of their error.
    CURVED: f64 = 1e-8;
    /// rad. The step of a difference quotient: the third root of a unit in the last place, as a power of two, where rounding and the
    /// error of the quotient are equal.
    DIFFERENCE: ByPrecision = ByPrecision { double: 1.0 / 131_072.0, single: 1.0 / 256.0 };
    /// Units in the last place of each length. One that was read from decimals is off by a half, one that was multiplied by a unit or a
    /// count before by a quarter more at most.
    ROUNDED_LENGTH: f64 = 0.75;
    /// rad. So near to a pose rounded lengths turn the motion by `EPSILON` over its square, so that the parabola is not asked: the fourth
    /// root of a unit in the last place.
    UNCERTAIN: f64 = 1e-4;
    /// rad and parts of lengths. A pose that is found without the parabola is not farther away, and an assembled one is not moved more.
    NEARBY: f64 = 1e-3;
    /// A pivot ratio over that of other poses. An assembled pose is closed anew below it, at a hundredth of a radian: gaps of rounding are
    /// turns there that reach the tenth digit.
    STARTS_NEAR: f64 = 1e-4;
    /// A ratio of Newton steps. What shrinks by less converges to a double root: halves, with a margin.
    HALVED: f64 = 0.4;
    /// Units in the last place. Nodes and times are found where they move by less: the rounding of a sum of sixteen terms.
    FOUND: f64 = 16.0;
    /// A part of the time that is left. A lock-up is found so exactly.
    TIME_FOUND: f64 = 1e-9;

    // States on the constraints.

    /// A part of typical sizes. An accepted pose is so near to the constraints; a farther one is on others, of lengths that disagree.
    POSE_MOVED: f64 = 1e-6;
    /// A part of typical speeds. Its velocity is so near to their tangent: a pose that is rounded at the distance d from a singular one
    /// turns the tangent by `EPSILON / d`, and takes the square of that, here 1e-6, from the energy.
    VELOCITY_MOVED: f64 = 1e-3;
    /// Lengths a radian. An angle of four radians is rounded by as much as places of its ports are.
    ANGLE_ROUNDED: f64 = 0.25;

    // Steps over a pose and around it.

    /// A relative error. Steps around a pose have it: a hundredth of the tolerance that users ask for.
    TOLERANCE: ByPrecision = ByPrecision { double: 1e-11, single: 1e-6 };
    /// Distances to the pose. A crossing spans one of these, in the order of trial. None of the nodes lies near the pose for more than one
    /// of them.
    SPANS: [f64; 5] = [2.4, 2.0, 2.9, 1.7, 3.5];
    /// rad. A step away from a singular pose spans one of these: at 0.1 the polynomial of degree 16 has all digits; shorter ones follow
    /// faster forces.
    AWAY: [f64; 5] = [0.1, 0.05, 0.02, 0.01, 0.005];
    /// Units in the last place of the time. A pose that is reached within is where the motion is.
    BARELY: f64 = 64.0;
    /// rad. Nearer to a pose the state's rounding is a tenth of a billionth of the distance: distances from the pose are known better.
    AT_POSE: f64 = 1e-6;
    /// A ratio of distances. A pose over which no step leads is tried again from so much nearer.
    NEARER: f64 = 0.2;
    /// A part of typical sizes. Nodes that do not come nearer any more are found within: a thousand units, the rounding of their rates.
    STAGNATED: f64 = 1e-12;
    /// Units in the last place of the mechanism's size. Joints that open by less on the way over a pose are closed, ...
    CLOSED_ON_THE_WAY: f64 = 32.0;
    /// ... of so many rows; more rows have more rounding.
    FEW_ROWS: f64 = 8.0;
    /// The same units. Up to so many it cannot be told whether joints are closed.
    UNDECIDED: f64 = 450.0;
    /// The same units. Joints that repeat others disagree near a flat pose by what they do elsewhere over the distance to it. Up to so many
    /// that may be rounding; ...
    DISAGREE_BY_ROUNDING: f64 = 1e4;
    /// ... the joints open by so many times as much in a step.
    SPREAD: f64 = 10.0;
    /// A part of the state. The rate at the ends of a crossing may be off by it, over the step.
    AGREES: f64 = 1e-10;
}

/// The pivot ratio, relative to that of other poses, below which a pose is ill-conditioned.
#[inline]
pub(crate) fn ill_conditioned() -> f64 {
    ILL_CONDITIONED.get() * ILL_CONDITIONED.get()
}

/// The length of a step, rad, whose stages may miss a singular pose between them: four stages are as far apart as a pose is ill-conditioned.
#[inline]
pub(crate) fn long_step() -> f64 {
    4.0 * ILL_CONDITIONED.get()
}

/// The distance of the poses of a step that are compared, rad: half of that at which a pose is ill-conditioned.
#[inline]
pub(crate) fn compared_apart() -> f64 {
    0.5 * ILL_CONDITIONED.get()
}

/// The part of the largest singular value to which those that are [`SMALL`] have vanished at the pose: the square, as the last but one
/// Newton step leaves them.
#[inline]
pub(crate) fn vanished() -> f64 {
    SMALL.get() * SMALL.get()
}

/// The number of boxes that the parts of a step which is split cross: half of what is too long.
pub(crate) fn short() -> f64 {
    0.5 * LONG.get()
}

/// A part of typical sizes by which joints may move; of half of the digits, if that is more.
pub(crate) fn half_of_digits<S: Real>(tolerance: Tolerance) -> S {
    tolerance.of::<S>().max(S::EPSILON.sqrt())
}
