//! Progress of a search, and its observer.

use std::fmt;
use std::sync::Arc;

/// Progress of a search after an iteration.
#[derive(Clone, Debug, PartialEq)]
pub struct Progress {
    /// Iterations so far.
    pub iteration: usize,
    /// Root mean square of the weighted residuals.
    pub rms: f64,
    /// Names and values, SI, of the unknowns.
    pub values: Vec<(String, f64)>,
}

/// A function that is called after each iteration.
#[derive(Clone)]
pub(crate) struct Watch(pub(crate) Arc<dyn Fn(&Progress) + Send + Sync>);

impl fmt::Debug for Watch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Watch")
    }
}

/// `iteration 12: residuals of 0.0123 (rms), k = 49.88, c = 3.01`.
impl fmt::Display for Progress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { iteration, rms, values } = self;
        write!(f, "iteration {iteration}: weighted residuals of {rms:.3e} (rms)")?;
        values.iter().try_for_each(|(name, value)| write!(f, ", {name} = {value:.5e}"))
    }
}
