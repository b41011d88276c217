//! Errors of identification and of optimal control.

use std::fmt;

use plm_runtime::Fault;

use crate::optimise::identify::Loss;

/// Why there is no result.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// The mechanism has nothing of this name.
    Unknown {
        /// Kind of the name: `parameter`, `start value`, `input`, `output`.
        what: &'static str,
        /// The name.
        name: String,
        /// The names that there are.
        known: String,
    },
    /// A unit that is neither that of the declaration nor the SI unit.
    Unit {
        /// The quantity.
        name: String,
        /// The unit that was given.
        found: String,
        /// The units that are possible.
        expected: String,
    },
    /// Bounds that are not in order, a guess that is no number, a deviation or a size that is not positive.
    Senseless {
        /// The unknown.
        name: String,
        /// Its guess, SI.
        guess: f64,
        /// Its bounds, SI.
        bounds: [f64; 2],
    },
    /// Times that do not ascend, or values that are not as many as times.
    Readings {
        /// The experiment, from 0.
        experiment: usize,
        /// Description of the problem.
        problem: String,
    },
    /// Nothing is to be found, or nothing was measured.
    Nothing(&'static str),
    /// Fewer readings than unknowns.
    TooFew {
        /// The number of readings and of priors.
        readings: usize,
        /// The number of unknowns.
        unknowns: usize,
    },
    /// The run with the guesses has ended with a fault.
    AtGuess {
        /// The experiment, from 0.
        experiment: usize,
        /// Its fault.
        fault: Box<Fault>,
    },
    /// The search has ended away from a minimum.
    NotConverged {
        /// Why.
        why: NotConverged,
        /// The point at which it has ended: names and values, SI.
        best: Vec<(String, f64)>,
        /// Of an optimal control the inputs where it has ended: of each its value in each interval, SI. A plan for the next moment may do
        /// with it, if the violation is small.
        plan: Vec<Vec<f64>>,
        /// Root mean square of the weighted residuals there.
        rms: f64,
    },
    /// The border of a loss is no positive number.
    Loss(Loss),
    /// The quadratic program of a step has no solution.
    Quadratic(String),
    /// A file of readings that cannot be read.
    File(String),
}

/// Why a search has ended away from a minimum.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum NotConverged {
    /// After so many iterations.
    Iterations(usize),
    /// It was stopped after so many iterations.
    Stopped(usize),
    /// No step makes the residuals smaller, although they have a slope: outputs jump, or derivatives are rougher than the tolerance.
    NoDescent,
    /// Every further step has ended with a fault.
    Faults(Box<Fault>),
    /// Constraints are violated by this much, and no step makes the violation smaller.
    Demands {
        /// The largest violation: of outputs in SI, of continuity in typical sizes of states.
        violation: f64,
    },
}

impl fmt::Display for NotConverged {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Iterations(count) => write!(f, "the search has not ended after {count} iterations"),
            Self::Stopped(count) => write!(f, "the search was stopped after {count} iterations"),
            Self::NoDescent => f.write_str(
                "no step makes the residuals smaller, although they have a slope: outputs jump with an unknown, or the tolerance of the \
                 runs is too coarse",
            ),
            Self::Demands { violation } => {
                write!(f, "no step comes nearer to what is demanded, which is violated by up to {violation:.3e}")
            }
            Self::Faults(fault) => write!(f, "every further step of the search ends with a fault: {fault}"),
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown { what, name, known } if known.is_empty() => {
                write!(f, "there is no {what} `{name}`: the mechanism has none")
            }
            Self::Unknown { what, name, known } => {
                write!(f, "there is no {what} `{name}`; there are {known}")
            }
            Self::Unit { name, found, expected } if found.is_empty() => {
                write!(f, "`{name}` is in {expected}, and no unit is given")
            }
            Self::Unit { name, found, expected } => write!(f, "`{name}` is in {expected}, not in `{found}`"),
            Self::Senseless { name, guess, bounds: [least, most] } => write!(
                f,
                "`{name}` begins at {guess} within {least} and {most}: a guess is a number, bounds ascend, deviations and sizes are \
                 positive"
            ),
            Self::Readings { experiment, problem } => write!(f, "experiment {experiment}: {problem}"),
            Self::Nothing(what) => write!(f, "there is no {what}"),
            Self::TooFew { readings: 1, unknowns } => {
                write!(f, "1 reading does not tell {unknowns} unknowns")
            }
            Self::TooFew { readings, unknowns } => {
                write!(f, "{readings} readings do not tell {unknowns} unknowns")
            }
            Self::AtGuess { experiment, fault } => {
                write!(f, "experiment {experiment} does not run with the guesses: {fault}")
            }
            Self::NotConverged { why, best, rms, .. } => {
                if best.is_empty() {
                    return why.fmt(f);
                }
                write!(f, "{why}; it stands at ")?;
                for (k, (name, value)) in best.iter().enumerate() {
                    write!(f, "{}{name} = {value:.6e}", if k > 0 { ", " } else { "" })?;
                }
                write!(f, ", with weighted residuals of {rms:.3e} (rms)")
            }
            Self::Loss(loss) => write!(f, "{loss:?}: its border is a positive number of deviations"),
            Self::Quadratic(why) => write!(f, "the quadratic program of a step has no solution: {why}"),
            Self::File(why) => f.write_str(why),
        }
    }
}

impl std::error::Error for Error {}

/// The place of a name.
///
/// # Errors
/// [`Error::Unknown`] with all names.
pub(crate) fn place<'a>(
    what: &'static str,
    name: &str,
    names: impl Iterator<Item = &'a str> + Clone,
) -> Result<usize, Error> {
    names.clone().position(|own| own == name).ok_or_else(|| Error::Unknown {
        what,
        name: name.to_owned(),
        known: names.collect::<Vec<_>>().join(", "),
    })
}
