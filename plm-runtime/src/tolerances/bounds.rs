//! Bounds of work. None is a tolerance: a computation that needs more work is given up or made shorter.

use crate::scalar::Real;

// Poses: `plm-runtime/src/singular/` and `plm-runtime/src/absolute/`.

/// Times that the two poses beside a state, through which a parabola is drawn, are moved nearer until they lie within the parabola's
/// own scale. Each new distance is half of the scale found, so that a scale of `2^-12` of the first distance is reached.
pub(crate) const REFINEMENTS: usize = 12;
/// Newton steps to a singular pose: from half a radian away quadratic convergence takes six, linear convergence by halves the others.
pub(crate) const CRITICAL_STEPS: usize = 16;
/// Iterations for the nodes of a collocation step; each gains at least a digit of sixteen where the step is short enough.
pub(crate) const COLLOCATION_STEPS: usize = 40;
/// Newton steps in time towards the moment at which a prescribed motion ends: by halves, all digits of a number.
pub(crate) const LOCK_STEPS: usize = 40;
/// Newton steps from a stage of a step onto the constraints: numbers of twice the precision have 32 digits; each step doubles the
/// correct ones, and near a singular pose halves the distance at first.
pub(crate) const CLOSING_STEPS: usize = 16;
/// Newton steps from a pose to a nearby one that closes the joints and is not singular.
pub(crate) const NEIGHBOUR_STEPS: u32 = 16;
/// Least number of places in a step at which pivots are compared.
pub(crate) const LOOKS: usize = 4;
/// Largest number of these places.
pub(crate) const MOST_LOOKS: usize = 64;
/// Parabolas by which a low pivot between these places is followed to its minimum.
pub(crate) const DESCENTS: usize = 8;
/// Most parts into which a step is split; a part that is still too long is split again.
pub(crate) const MOST_PARTS: f64 = 64.0;
/// Trials of a crossing, each from nearer to the pose, if rounding would decide it: a kink within a longer crossing, or too few nodes,
/// open the joints as well.
pub(crate) const TRIALS: u32 = 4;

// Contact: `plm-runtime/src/contact/`.

/// Most combinations of modes that are enumerated; if there are more, they are searched by pivots. It is seven frictions that may have
/// four modes each, or fourteen gaps.
pub(crate) const MOST_COMBINATIONS: u32 = 1 << 14;
/// Most searches by pivots, each on another path.
pub(crate) const WALKS: u32 = 5;
/// Most combinations after pivots, for each row that may have several modes.
pub(crate) const WALK_STEPS: usize = 3;
/// Most exchanges of Lemke's method for each pair.
pub(crate) const MOST_EXCHANGES: usize = 20;
/// Most corrections of the directions of reactions in the plane in Lemke's method.
pub(crate) const MOST_DIRECTIONS: u32 = 4;
/// Most changes of single signs, for each reaction along a line.
pub(crate) const MOST_TURNS: usize = 2;
/// Most reactions along lines for which all combinations of signs are tried: 1024 combinations.
pub(crate) const MOST_SIGNS: usize = 10;
/// Most Newton steps for reactions in the plane; from a cold start three or four are needed.
pub(crate) const FORCE_STEPS: u32 = 12;
/// Newton steps after the values have converged, for derivatives.
pub(crate) const FORCE_STEPS_BEHIND: u32 = 2;
/// Sweeps before the Newton steps: with a friction of a hundredth of that which would lock a joint, one Newton step is left.
pub(crate) const FIRST_SWEEPS: u32 = 4;
/// Most sweeps of generated code. With a friction of a hundredth of that which would lock a joint five are needed.
pub(crate) const MOST_SWEEPS: u32 = 30;
/// Most trials of intervals of unit vectors.
pub(crate) const ENCLOSURE_TRIALS: u32 = 5;
/// Most Newton steps that return constraint rows to their places.
pub(crate) const ROW_STEPS: u32 = 4;
/// Most successive impacts of an event.
pub(crate) const MOST_IMPACTS: u32 = 30;
/// Most successive impacts of an event if they are those of pairs.
pub(crate) const MOST_PAIRS: u32 = 1000;
/// Most successive impacts of pairs in one step without events.
pub(crate) const PAIRS_IN_STEP: u32 = 16;
/// Sweeps in a step without events after rounds that have not converged.
pub(crate) const STEP_SWEEPS: u32 = 32;

// Events: `plm-runtime/src/events/`.

/// Most repetitions of a step that has to end where a requirement is no longer satisfied.
pub(crate) const REPEATED_STEPS: u32 = 4;
/// Most rounds in which events follow each other at once.
pub(crate) const MOST_ROUNDS: u32 = 100;
/// Most switches of conditions within a short time; more end the run. A saved run has seven bits for their number.
pub(crate) const MOST_SWITCHES: u32 = 100;
/// Number of such switches after which flights accumulate, if conditions have thrown the state back: only rounding lets the next one pass,
/// and the run ends there.
pub(crate) const MOST_FLIGHTS: u32 = 8;
/// Corrections of the time of an event by its derivatives: slopes of guards that are difference quotients have half of all digits, so that
/// one is not enough.
pub(crate) const TIME_CORRECTIONS: usize = 2;
/// Steps before a guard-free region is tried again.
pub(crate) const REGION_WAIT: u32 = 64;
/// Most halvings of a step: 2^-22 of it is a quarter of a millionth.
pub(crate) const FINEST: u32 = 22;
/// Halvings that are always made if a system cannot enclose its guards.
pub(crate) const ROUGHEST: u32 = 2;
/// Halvings after which nothing more is learnt without enclosures.
pub(crate) const FINEST_OF_POINTS: u32 = 6;
/// Halvings after which rounding is evaluated at the interval, and not at the beginning of the step.
pub(crate) const LOCAL: u32 = 10;
/// Most intervals of a step that are examined; the remainder is left for the next step.
pub(crate) const MOST_INTERVALS: u32 = 4000;
/// Most pieces at which bisection ends without a decision on a guard; after more, the guard counts as undecided.
pub(crate) const MOST_UNDECIDED: u32 = 1000;
/// Halvings after which guards that are still open are judged by their values.
pub(crate) const BY_VALUES: u32 = 3;
/// Pieces of a step after which values decide even where a guard has no enclosure that shows it to be smooth.
pub(crate) const MANY_PIECES: u32 = 256;
/// Halvings of a step that begins with a violated guard, in search of a time at which the guard is satisfied before it leaves its side.
pub(crate) const RETURN_HALVINGS: u32 = 10;
/// Most halvings of a step in which guards bend, if it is sampled.
pub(crate) const BENT_HALVINGS: u32 = 6;
/// Most halvings of a step in search of a kink.
pub(crate) const KINK_HALVINGS: u32 = 12;
/// Most intervals of a step in which kinks are searched.
pub(crate) const KINK_INTERVALS: u32 = 64;
/// Most kinks that are followed in a step.
pub(crate) const KINKS_FOLLOWED: usize = 8;

/// Shortest interval of a search, as a fraction of the step.
pub(crate) fn finest<S: Real>() -> S {
    (0..FINEST).fold(S::lit(1.0), |width, _| S::lit(0.5) * width)
}
