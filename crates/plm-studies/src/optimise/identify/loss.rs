//! How residuals count.

use plm_runtime::Fault;

use nalgebra::DVector;

use super::problem::Readings;
use crate::optimise::least_squares::{Found, Limits, Problem, minimise};
use crate::optimise::mechanism::{Integration, Optimisable};

/// How the residuals of readings count.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub enum Loss {
    /// By their squares.
    #[default]
    Squares,
    /// By their squares up to so many deviations, beyond by their size: a few wrong readings pull little (P. J. Huber, Annals of Mathematical
    /// Statistics 35, 1964). With 1.345 estimates have 95 % of the efficiency of squares where errors are normal.
    Huber(f64),
}

impl Loss {
    /// Replacement of a residual, half of whose square is the loss, with its derivative by the residual.
    pub(crate) fn of(self, residual: f64) -> (f64, f64) {
        match self {
            Self::Huber(border) if residual.abs() > border => {
                let root = (border * (2.0 * residual.abs() - border)).sqrt();
                (root.copysign(residual), border / root)
            }
            _ => (residual, 1.0),
        }
    }

    /// The derivative of the loss, and its derivative.
    fn slopes(self, residual: f64) -> (f64, f64) {
        match self {
            Self::Huber(border) if residual.abs() > border => (border.copysign(residual), 0.0),
            _ => (residual, 1.0),
        }
    }

    /// Is it one whose border is a positive number?
    pub(crate) fn is_sensible(self) -> bool {
        match self {
            Self::Squares => true,
            Self::Huber(border) => border > 0.0 && border.is_finite(),
        }
    }

    /// By what the inverse of the normal equations is multiplied to be the covariance (P. J. Huber, Robust Statistics, 1981, 7.6).
    pub(crate) fn variance(self, residuals: &DVector<f64>, freedoms: usize) -> f64 {
        let slopes = residuals.iter().map(|residual| self.slopes(*residual));
        let (square, second) =
            slopes.fold((0.0, 0.0), |(a, b), (slope, second)| (a + slope * slope, b + second));
        let mean: f64 = second / residuals.len().max(1) as f64;
        square / freedoms as f64 / (mean * mean)
    }
}

/// The deviation is estimated anew so often at most: each time the wrong readings pull less.
const ROUNDS: usize = 10;
/// Deviations that change by less are found.
const SETTLED: f64 = 1e-4;

/// Searches again with the loss, from where squares have ended. Deviations that are not given are those of the middle half of the residuals:
/// 1.4826 times their median (F. R. Hampel, J. Am. Statistical Association 69, 1974).
///
/// # Errors
/// The fault at the point.
pub(super) fn settled<M: Optimisable, D: Integration<M>>(
    problem: &mut Readings<M, D>,
    first: Found,
    limits: &Limits,
) -> Result<Found, Fault> {
    let loss = problem.loss;
    let mut found = first;
    for _ in 0..ROUNDS {
        problem.loss = Loss::Squares;
        let plain = problem.evaluate(&found.z)?;
        let change = problem.spread(&plain.residuals);
        problem.loss = loss;
        let iterations = found.iterations;
        found = minimise(problem, &found.z, limits)?;
        found.iterations += iterations;
        if change < SETTLED {
            break;
        }
    }
    // Plain residuals compare readings and model.
    problem.loss = Loss::Squares;
    found.at = problem.evaluate(&found.z)?;
    problem.loss = loss;
    Ok(found)
}

/// The median of sizes; none of none.
pub(super) fn median(mut sizes: Vec<f64>) -> Option<f64> {
    sizes.sort_by(f64::total_cmp);
    let middle = sizes.get(sizes.len() / 2)?;
    let below = sizes.get(sizes.len().saturating_sub(1) / 2)?;
    Some(0.5 * (middle + below))
}
