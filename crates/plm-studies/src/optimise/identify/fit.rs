//! Result of an identification.

use std::fmt;

use nalgebra::DMatrix;

use super::recording::Motion;
use crate::optimise::mechanism::Optimisable;
use crate::optimise::unknown::Place;

/// Estimates of the unknowns, their accuracy, and the residuals.
#[derive(Clone, Debug)]
pub struct Fit<M: Optimisable> {
    /// The estimates: those that experiments have in common, then those of each.
    pub estimates: Vec<Estimate>,
    /// Covariance of the estimates, SI: of the linearised model at the estimates. Infinite on the diagonal where
    /// [`undetermined`](Self::undetermined) has a part, zero at a bound.
    pub covariance: DMatrix<f64>,
    /// Combinations of unknowns that no reading determines.
    pub undetermined: Vec<Combination>,
    /// Readings and residuals of each output of each experiment.
    pub residuals: Vec<Residuals>,
    /// Sum of squares of the residuals, each over the deviation of its reading; of expected values too.
    pub chi_squared: f64,
    /// Number of readings and expected values less that of the unknowns that they determine.
    pub freedoms: usize,
    /// Iterations of the search.
    pub iterations: usize,
    /// Runs of experiments, or of their segments, with all derivatives.
    pub runs: usize,
    pub(crate) mechanism: M,
    pub(crate) places: Vec<Place>,
    pub(crate) motions: Vec<Motion<M>>,
}

/// Estimate of one unknown.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Its name.
    pub name: String,
    /// The experiment that it belongs to, from 0; none where all have it in common.
    pub experiment: Option<usize>,
    /// The value, SI.
    pub value: f64,
    /// Its standard error, SI; infinite if no reading determines it, zero at a bound.
    pub standard_error: f64,
    /// The unit of its declaration.
    pub unit: &'static str,
    /// A value in SI is one in this unit times the factor.
    pub factor: f64,
    /// The bound that it stands at, if it does; SI.
    pub bound: Option<f64>,
}

/// A combination of unknowns along which no reading changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Combination {
    /// Names of unknowns, and by how much each changes, SI, where the first changes by its own size.
    pub changes: Vec<(String, f64)>,
    /// The changes as fractions of the sizes of the unknowns.
    pub fractions: Vec<f64>,
}

/// Readings of one output in one experiment, and what the model has in their place; in the unit that was given.
#[derive(Clone, Debug, PartialEq)]
pub struct Residuals {
    /// The experiment, from 0.
    pub experiment: usize,
    /// Name of the output.
    pub output: String,
    /// Unit of the readings.
    pub unit: String,
    /// Times, s.
    pub times: Vec<f64>,
    /// Readings.
    pub readings: Vec<f64>,
    /// Outputs of the model with the estimates.
    pub model: Vec<f64>,
}

impl Residuals {
    /// Outputs of the model less the readings; not numbers where there is no reading.
    pub fn differences(&self) -> impl Iterator<Item = f64> + '_ {
        self.model.iter().zip(&self.readings).map(|(model, reading)| model - reading)
    }

    /// Root mean square of the residuals.
    pub fn rms(&self) -> f64 {
        let (mut sum, mut count) = (0.0, 0.0);
        for difference in self.differences().filter(|difference| difference.is_finite()) {
            sum += difference * difference;
            count += 1.0;
        }
        f64::sqrt(sum / f64::max(count, 1.0))
    }
}

impl<M: Optimisable> Fit<M> {
    /// The estimate of the first unknown with this name, SI.
    pub fn value(&self, name: &str) -> Option<f64> {
        self.estimates.iter().find(|estimate| estimate.name == name).map(|estimate| estimate.value)
    }

    /// The standard error of the first unknown with this name, SI.
    pub fn standard_error(&self, name: &str) -> Option<f64> {
        self.estimates.iter().find(|estimate| estimate.name == name).map(|estimate| estimate.standard_error)
    }

    /// Correlations of the estimates, 1 on the diagonal; not numbers where a standard error is zero or infinite.
    pub fn correlation(&self) -> DMatrix<f64> {
        let size = self.estimates.len();
        let error = |i: usize| self.covariance[(i, i)].sqrt();
        DMatrix::from_fn(size, size, |i, k| {
            if i == k { 1.0 } else { self.covariance[(i, k)] / (error(i) * error(k)) }
        })
    }

    /// The mechanism with the estimates that experiments have in common.
    pub fn mechanism(&self) -> M {
        let mut mechanism = self.mechanism;
        for (place, estimate) in self.places.iter().zip(&self.estimates) {
            if estimate.experiment.is_none() {
                place.set(&mut mechanism, estimate.value);
            }
        }
        mechanism
    }
}

impl fmt::Display for Estimate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, experiment, value, standard_error, unit, factor, bound } = self;
        write!(f, "{name}")?;
        if let Some(experiment) = experiment {
            write!(f, " (experiment {experiment})")?;
        }
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        write!(f, " = {:.6}{unit}, ", Figure(value / factor))?;
        match bound {
            Some(_) => f.write_str("at its bound"),
            None if standard_error.is_infinite() => f.write_str("which no reading tells by itself"),
            None => write!(f, "standard error {:.3}{unit}", Figure(standard_error / factor)),
        }
    }
}

/// A number with so many digits, with an exponent where it is large or small.
pub(super) struct Figure(pub(super) f64);

impl fmt::Display for Figure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = f.precision().unwrap_or(6);
        let decade = if self.0 == 0.0 { 0 } else { self.0.abs().log10().floor() as i32 };
        if (-4..6).contains(&decade) {
            let places = (digits as i32 - 1 - decade).max(0) as usize;
            write!(f, "{:.places$}", self.0)
        } else {
            write!(f, "{:.*e}", digits - 1, self.0)
        }
    }
}

/// `residuals of arm.angle in experiment 0: 0.264 deg (rms)`.
impl fmt::Display for Residuals {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { experiment, output, unit, .. } = self;
        write!(f, "residuals of {output} in experiment {experiment}: {:.3} {unit} (rms)", Figure(self.rms()))
    }
}

impl fmt::Display for Combination {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("no reading changes with ")?;
        for (k, ((name, _), fraction)) in self.changes.iter().zip(&self.fractions).enumerate() {
            write!(f, "{}{name} by {:+.3} %", if k > 0 { " and " } else { "" }, Figure(*fraction))?;
        }
        if self.changes.len() > 1 { f.write_str(" together") } else { Ok(()) }
    }
}

/// Correlations from this one on are reported.
const STRONG: f64 = 0.95;

impl<M: Optimisable> fmt::Display for Fit<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for estimate in &self.estimates {
            writeln!(f, "{estimate}")?;
        }
        for combination in &self.undetermined {
            writeln!(f, "{combination}")?;
        }
        let correlation = self.correlation();
        for i in 0..self.estimates.len() {
            for k in i + 1..self.estimates.len() {
                if correlation[(i, k)].abs() >= STRONG {
                    let [a, b] = [i, k].map(|i| &self.estimates[i].name);
                    writeln!(f, "{a} and {b} correlate by {:.3}", correlation[(i, k)])?;
                }
            }
        }
        for residuals in &self.residuals {
            writeln!(f, "{residuals}")?;
        }
        self.farthest().map_or(Ok(()), |farthest| writeln!(f, "{farthest}"))
    }
}
