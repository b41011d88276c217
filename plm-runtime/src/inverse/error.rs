//! Errors of inverse dynamics.

use core::fmt;

use crate::fault::Fault;

/// The mechanism has nothing of this name.
///
/// Its `Debug` reads like its `Display`, since a `main` that returns it, and `unwrap`, show that one.
#[derive(Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum NotNamed<'a> {
    /// No body has such a coordinate.
    Coordinate(&'a str),
    /// No quantity of this name is observed: outputs are, and others with `observe all`.
    Observed(&'a str),
    /// There is no such input.
    Input(&'a str),
}

/// Why no inputs were found.
///
/// Its `Debug` reads like its `Display`, since a `main` that returns it, and `unwrap`, show that one.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Unsolved<'a> {
    /// The accelerations are not determined there.
    Fault(Fault),
    /// No drive moves the target: its acceleration, or its value, depends on none of the inputs at this moment.
    Unmoved {
        /// s.
        time: f64,
        /// Its name.
        target: &'a str,
    },
    /// The drives cannot move the target independently of those before it, and what these give it is not what is wanted.
    Dependent {
        /// s.
        time: f64,
        /// Its name.
        target: &'a str,
        /// By how much its wanted acceleration is larger than that which follows from the others, SI.
        misses: f64,
    },
    /// A target depends on the inputs otherwise than by sums, and Newton's method found no solution.
    NotConverged {
        /// s.
        time: f64,
        /// The target that misses most.
        target: &'a str,
        /// By how much, SI.
        misses: f64,
    },
    /// With these inputs a mode would end at once: a gap that is closed would have to pull, a friction that sticks would slip.
    Mode {
        /// s.
        time: f64,
        /// The condition, or the row of contact.
        condition: &'static str,
    },
    /// No pose of the mechanism near the one before has the wanted places.
    NotReached {
        /// s.
        time: f64,
        /// The target that misses most; empty where it is a joint.
        target: &'a str,
        /// By how much, SI.
        misses: f64,
    },
    /// The targets leave freedoms, whose motion is not known without a simulation.
    Free {
        /// s.
        time: f64,
        /// How many.
        freedoms: usize,
    },
}

impl fmt::Display for NotNamed<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Coordinate(name) => {
                write!(
                    f,
                    "no body has a coordinate `{name}`: expected as `crank.x`, `crank.y` or `crank.angle`"
                )
            }
            Self::Observed(name) => {
                write!(f, "no quantity `{name}` is observed: declare it as an output, or `observe all;`")
            }
            Self::Input(name) => write!(f, "there is no input `{name}`"),
        }
    }
}

impl fmt::Display for Unsolved<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fault(fault) => fault.fmt(f),
            Self::Unmoved { time, target } => {
                write!(
                    f,
                    "t = {time} s: no drive moves `{target}`: it depends on none of the inputs in this pose and these modes"
                )
            }
            Self::Dependent { time, target, misses } => write!(
                f,
                "t = {time} s: the drives cannot move `{target}` independently of the targets before it: what is wanted differs by \
                 {misses:e} from what follows from these"
            ),
            Self::NotConverged { time, target, misses } => {
                write!(
                    f,
                    "t = {time} s: no inputs were found that give `{target}` what is wanted: it misses by {misses:e}"
                )
            }
            Self::Mode { time, condition } => {
                write!(f, "t = {time} s: with the inputs that are needed, `{condition}` changes at once")
            }
            Self::NotReached { time, target: "", misses } => {
                write!(
                    f,
                    "t = {time} s: the joints cannot be closed where the targets are wanted: {misses:e} remains"
                )
            }
            Self::NotReached { time, target, misses } => {
                write!(
                    f,
                    "t = {time} s: `{target}` does not reach the place or the velocity that is wanted: it misses by {misses:e}"
                )
            }
            Self::Free { time, freedoms } => write!(
                f,
                "t = {time} s: the targets leave {freedoms} freedom{}, whose motion has to be simulated",
                if *freedoms == 1 { "" } else { "s" }
            ),
        }
    }
}

/// Accelerations are not determined, or a pose is no continuation of the one before.
impl From<Fault> for Unsolved<'_> {
    fn from(fault: Fault) -> Self {
        Self::Fault(fault)
    }
}

impl fmt::Debug for NotNamed<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Debug for Unsolved<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl core::error::Error for NotNamed<'_> {}

impl core::error::Error for Unsolved<'_> {}
