//! Linear quadratic regulators and Kalman filters, by names.

use std::error::Error;
use std::fmt;

use nalgebra::{Complex, DMatrix, DVector};

use super::lacking::Lacking;
use super::riccati::{Cost, continuous_riccati, discrete_riccati};
use super::{Sampled, System, Time, eigenvalues, index_of};
use crate::analysis::Linearisation;

/// A linear quadratic regulator: u = -gains x is added to the inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct Regulator {
    /// A row for each input, SI, a column for each direction of the state.
    pub gains: DMatrix<f64>,
    /// The cost from a state x on is x^T cost x.
    pub cost: DMatrix<f64>,
    /// Names of the inputs, the rows of the gains.
    pub inputs: Vec<&'static str>,
    /// Eigenvalues of the controlled system, small ones first.
    pub poles: Vec<Complex<f64>>,
    /// The directions of the state in columns, in coordinates, velocities and first-order states.
    pub basis: DMatrix<f64>,
    /// The state at which the mechanism was linearised: a number for each row of `basis`.
    pub point: Vec<f64>,
}

/// A stationary Kalman filter: gains (y - C x) corrects the state x.
///
/// Of a continuous system that is a rate, x' = A x + B u + gains (y - C x - D u). At samples it corrects x at once, before the next step.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimator {
    /// A row for each direction of the state, a column for each output.
    pub gains: DMatrix<f64>,
    /// The covariance of x; at samples that before the correction.
    pub covariance: DMatrix<f64>,
    /// Names of the outputs, the columns of the gains.
    pub outputs: Vec<&'static str>,
    /// Eigenvalues of the error's motion, small ones first.
    pub poles: Vec<Complex<f64>>,
}

/// Why there is no gain.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum NoGain {
    /// There is no input of this name.
    Input(String),
    /// There is no output of this name.
    Output(String),
    /// The weight, or the intensity of the noise, is not positive; of what may be left out it may be zero.
    Weight(String, f64),
    /// A mode that does not decay is reached by none of the inputs: a regulator cannot make it decay, and noise does not excite it so that a
    /// filter would follow it.
    NotReached(Lacking),
    /// A mode that does not decay is shown by none of the outputs: a cost of these has no least value, and a filter does not see it.
    NotShown(Lacking),
    /// The equation has no solution in these numbers.
    NotSolved,
}

impl fmt::Display for NoGain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(name) => write!(f, "there is no input `{name}`"),
            Self::Output(name) => write!(f, "there is no output `{name}`"),
            Self::Weight(name, weight) => {
                write!(f, "the weight of `{name}` must be positive, found {weight}")
            }
            Self::NotReached(lacking) => {
                write!(f, "no input reaches the mode {lacking}, which does not decay by itself")
            }
            Self::NotShown(lacking) => {
                write!(f, "no output shows the mode {lacking}, which does not decay by itself")
            }
            Self::NotSolved => f.write_str("Riccati's equation has no solution in these numbers"),
        }
    }
}

impl Error for NoGain {}

impl Regulator {
    /// Corrections of the inputs in a state of a simulation, in the order of their names, to be added to the inputs at which the
    /// mechanism was linearised: -gains times the change of the state from `point` along `basis`.
    ///
    /// `x` has the numbers of the state as `states` of the linearisation names them; those that are missing are those of `point`.
    pub fn inputs_at(&self, x: &[f64]) -> Vec<f64> {
        let change = |k: usize| x.get(k).map_or(0.0, |x| x - self.point[k]);
        let along = self.basis.tr_mul(&DVector::from_fn(self.point.len(), |k, _| change(k)));
        (-(&self.gains * along)).iter().copied().collect()
    }
}

macro_rules! has_gains {
    ($system:ident, $sum:literal) => {
        impl $system {
            #[doc = concat!("The regulator for the least ", $sum, " of weight y^2 over the named outputs, in their units, and weight u^2 over the named")]
            /// inputs, in SI. Inputs that are not named are none of its drives, outputs that are not named weigh nothing.
            ///
            /// # Errors
            /// [`NoGain`]: with the mode that cannot be controlled, or that the outputs do not show.
            pub fn regulator(
                &self,
                outputs: &[(&str, f64)],
                inputs: &[(&str, f64)],
            ) -> Result<Regulator, NoGain> {
                self.system().regulator(outputs, inputs)
            }

            /// The Kalman filter for white noise: that of the named inputs has these intensities, in SI, that of the named outputs these, in
            /// their units; at samples they are variances. Outputs that are not named are not measured.
            ///
            /// # Errors
            /// [`NoGain`]: with the mode that the outputs do not show, or that no noise excites.
            pub fn estimator(
                &self,
                inputs: &[(&str, f64)],
                outputs: &[(&str, f64)],
            ) -> Result<Estimator, NoGain> {
                self.system().estimator(inputs, outputs)
            }

            /// Modes that none of all the inputs reaches: the system is controllable if there are none.
            pub fn not_reached(&self) -> Vec<Lacking> {
                self.system().not_reached(&self.b)
            }

            /// Modes that none of all the outputs shows: the system is observable if there are none.
            pub fn not_shown(&self) -> Vec<Lacking> {
                self.system().not_shown(&self.c)
            }
        }
    };
}

has_gains!(Linearisation, "integral");
has_gains!(Sampled, "sum over the samples");

/// Numbers of names with their weights.
struct Named {
    numbers: Vec<usize>,
    weights: DMatrix<f64>,
}

impl System<'_> {
    fn named_inputs(&self, all: &[(&str, f64)]) -> Result<Named, NoGain> {
        named(all, self.inputs, NoGain::Input)
    }

    fn named_outputs(&self, all: &[(&str, f64)]) -> Result<Named, NoGain> {
        named(all, self.outputs, NoGain::Output)
    }

    fn regulator(&self, outputs: &[(&str, f64)], inputs: &[(&str, f64)]) -> Result<Regulator, NoGain> {
        let (outputs, inputs) = (self.named_outputs(outputs)?, self.named_inputs(inputs)?);
        positive(&inputs, |k| self.inputs[k].0)?;
        let b = self.b.select_columns(&inputs.numbers);
        let weighed: Vec<usize> =
            (0..outputs.numbers.len()).filter(|k| outputs.weights[(*k, *k)] > 0.0).collect();
        let rows: Vec<usize> = weighed.iter().map(|k| outputs.numbers[*k]).collect();
        let weights = outputs.weights.select_rows(&weighed).select_columns(&weighed);
        let c = self.c.select_rows(&rows);
        let d = self.d.select_rows(&rows).select_columns(&inputs.numbers);
        self.stays(self.not_reached(&b)).map_or(Ok(()), |lacking| Err(NoGain::NotReached(lacking)))?;
        self.is_marginal(self.not_shown(&c)).map_or(Ok(()), |lacking| Err(NoGain::NotShown(lacking)))?;
        let cost = Cost {
            q: c.transpose() * &weights * &c,
            r: inputs.weights + d.transpose() * &weights * &d,
            n: c.transpose() * &weights * &d,
        };
        let x = self.riccati(self.a, &b, &cost)?;
        let bx = b.transpose() * &x;
        let gains = match self.time {
            Time::Continuous => cost.r.clone().lu().solve(&(&bx + cost.n.transpose())),
            Time::Sampled(_) => (&cost.r + &bx * &b).lu().solve(&(&bx * self.a + cost.n.transpose())),
        };
        let gains = gains.ok_or(NoGain::NotSolved)?;
        let poles = eigenvalues(&(self.a - &b * &gains));
        let inputs = inputs.numbers.iter().map(|k| self.inputs[*k].0).collect();
        Ok(Regulator { gains, cost: x, inputs, poles, basis: self.basis.clone(), point: self.point.to_vec() })
    }

    /// Kalman filter by duality: the Riccati equation of a regulator with A^T in the place of A and C^T in that of B.
    fn estimator(&self, inputs: &[(&str, f64)], outputs: &[(&str, f64)]) -> Result<Estimator, NoGain> {
        let (outputs, inputs) = (self.named_outputs(outputs)?, self.named_inputs(inputs)?);
        positive(&outputs, |k| self.outputs[k].0)?;
        let b = self.b.select_columns(&inputs.numbers);
        let c = self.c.select_rows(&outputs.numbers);
        let d = self.d.select_rows(&outputs.numbers).select_columns(&inputs.numbers);
        self.stays(self.not_shown(&c)).map_or(Ok(()), |lacking| Err(NoGain::NotShown(lacking)))?;
        self.is_marginal(self.not_reached(&b)).map_or(Ok(()), |lacking| Err(NoGain::NotReached(lacking)))?;
        let noise = &b * &inputs.weights;
        let cost = Cost {
            q: &noise * b.transpose(),
            r: outputs.weights + &d * &inputs.weights * d.transpose(),
            n: &noise * d.transpose(),
        };
        let x = self.riccati(&self.a.transpose(), &c.transpose(), &cost)?;
        let cx = &c * &x;
        let (gains, step) = match self.time {
            Time::Continuous => {
                let gains = cost.r.clone().lu().solve(&(&cx + cost.n.transpose()));
                (gains.clone(), gains)
            }
            Time::Sampled(_) => {
                let lu = (&cost.r + &cx * c.transpose()).lu();
                (lu.solve(&cx), lu.solve(&(&cx * self.a.transpose() + cost.n.transpose())))
            }
        };
        let (gains, step) = gains.zip(step).ok_or(NoGain::NotSolved)?;
        let poles = eigenvalues(&(self.a - step.transpose() * &c));
        let outputs = outputs.numbers.iter().map(|k| self.outputs[*k].0).collect();
        Ok(Estimator { gains: gains.transpose(), covariance: x, outputs, poles })
    }

    fn riccati(&self, a: &DMatrix<f64>, b: &DMatrix<f64>, cost: &Cost) -> Result<DMatrix<f64>, NoGain> {
        match self.time {
            Time::Continuous => continuous_riccati(a, b, cost),
            Time::Sampled(_) => discrete_riccati(a, b, cost),
        }
        .ok_or(NoGain::NotSolved)
    }

    /// The first of some modes that does not decay.
    fn stays(&self, modes: Vec<Lacking>) -> Option<Lacking> {
        modes.into_iter().find(|lacking| self.time.stays(self.eigenvalue(lacking), self.a.norm()))
    }

    fn is_marginal(&self, modes: Vec<Lacking>) -> Option<Lacking> {
        modes.into_iter().find(|lacking| self.time.is_marginal(self.eigenvalue(lacking), self.a.norm()))
    }

    fn eigenvalue(&self, of: &Lacking) -> Complex<f64> {
        match self.time {
            Time::Continuous => of.mode.eigenvalue,
            Time::Sampled(period) => (of.mode.eigenvalue * period).exp(),
        }
    }
}

/// Looks up names, and whether their weights are numbers that are not negative.
fn named(
    all: &[(&str, f64)],
    among: &[(&'static str, &'static str)],
    unknown: impl Fn(String) -> NoGain,
) -> Result<Named, NoGain> {
    let (mut numbers, mut weights) = (Vec::new(), Vec::new());
    for (name, weight) in all {
        numbers.push(index_of(name, among).ok_or_else(|| unknown((*name).to_owned()))?);
        if !(weight.is_finite() && *weight >= 0.0) {
            return Err(NoGain::Weight((*name).to_owned(), *weight));
        }
        weights.push(*weight);
    }
    Ok(Named { numbers, weights: DMatrix::from_diagonal(&DVector::from_vec(weights)) })
}

/// # Errors
/// A weight that is zero.
fn positive(named: &Named, name: impl Fn(usize) -> &'static str) -> Result<(), NoGain> {
    let mut all = named.numbers.iter().enumerate();
    let zero = all.find(|(place, _)| named.weights[(*place, *place)] == 0.0);
    zero.map_or(Ok(()), |(_, number)| Err(NoGain::Weight(name(*number).to_owned(), 0.0)))
}
