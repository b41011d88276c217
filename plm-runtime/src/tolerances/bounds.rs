//! Bounds of work. None is a tolerance: what needs more of it is given up, or made shorter.

/// Poses to each side of a state that are compared until they lie within the parabola's own scale; each is half of that scale away, so
/// that a scale of `2^-12` of the first distance is reached.
pub(crate) const REFINEMENTS: usize = 12;
/// Newton steps to a singular pose: from half a radian away quadratic convergence takes six, linear convergence by halves the rest.
pub(crate) const CRITICAL_STEPS: usize = 16;
/// Iterations for the nodes of a collocation step; each gains at least a digit of sixteen where the step is short enough.
pub(crate) const COLLOCATION_STEPS: usize = 40;
/// Newton steps in the time towards the moment where a prescribed motion ends: by halves, all digits of a number.
pub(crate) const LOCK_STEPS: usize = 40;
/// Newton steps from a stage of a step onto the constraints: numbers of twice the precision have 32 digits, which are gained by
/// doubling, and near a singular pose by halves at first.
pub(crate) const CLOSING_STEPS: usize = 16;
/// Newton steps from a pose to one nearby, where nothing singles a pose out.
pub(crate) const NEIGHBOUR_STEPS: u32 = 16;
/// A step's pivots are compared at least in so many places, ...
pub(crate) const LOOKS: usize = 4;
/// ... and at most in so many.
pub(crate) const MOST_LOOKS: usize = 64;
/// A low pivot between them is followed down by so many parabolas.
pub(crate) const DESCENTS: usize = 8;
/// A step is split into at most so many parts; what is still too long is split again.
pub(crate) const MOST_PARTS: f64 = 64.0;
/// Where rounding would decide, a crossing is tried so often from nearer to the pose: a kink within a longer one, or too few nodes,
/// open the joints too.
pub(crate) const TRIALS: u32 = 4;
