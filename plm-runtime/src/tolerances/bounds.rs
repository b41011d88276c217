//! Bounds of work. None is a tolerance: a computation that needs more work is given up or made shorter.

/// Times that the two poses beside a state, through which a parabola is drawn, are moved nearer until they lie within the parabola's
/// own scale. Each new distance is half of the scale found, so that a scale of `2^-12` of the first distance is reached.
pub(crate) const REFINEMENTS: usize = 12;
/// Newton steps to a singular pose: from half a radian away quadratic convergence takes six, linear convergence by halves the others.
pub(crate) const CRITICAL_STEPS: usize = 16;
/// Iterations for the nodes of a collocation step; each gains at least a digit of sixteen where the step is short enough.
pub(crate) const COLLOCATION_STEPS: usize = 40;
/// Newton steps in time towards the moment at which a prescribed motion ends: by halves, all digits of a number.
pub(crate) const LOCK_STEPS: usize = 40;
/// Steps one after the other near a singular pose of which more than a thousand millions would be needed to the end of the interval. A turn
/// whose lengths miss the pose by a unit in the last place takes two hundred steps, which become shorter and longer by a quarter.
pub(crate) const MOST_CREEPING: u32 = 300;
/// Steps that no run makes.
pub(crate) const CREEPS: f64 = 1e9;
/// Steps to the end of a prescribed motion by its speed: each leaves a tenth of the time, so that ten reach its part of 1e-9; three times
/// as many at less.
pub(crate) const LIMIT_STEPS: usize = 30;
/// Parts of the time that is left until the speed of a prescribed motion has no bound, in the order of trial: after the first its speed is
/// three times as large; the shorter ones serve where the law of its end does not hold yet.
pub(crate) const LIMIT_PARTS: [f64; 3] = [0.9, 0.6, 0.3];
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
/// Most parts into which a step is split; a part that is still too long for a turn is split again, one that has a fault is left to the
/// near-singular method.
pub(crate) const MOST_PARTS: f64 = 64.0;
/// Trials of a crossing, each from nearer to the pose, if rounding would decide it: a kink within a longer crossing, or too few nodes,
/// open the joints as well.
pub(crate) const TRIALS: u32 = 4;
