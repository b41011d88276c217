//! Sampling at equal intervals, with inputs that are held between samples.

use nalgebra::{Complex, DMatrix};

use super::{System, Time, eigenvalues};
use crate::analysis::{Linearisation, Mode};

/// A linear system at samples: x becomes A x + B u after a period, y = C x + D u at its beginning.
#[derive(Clone, Debug, PartialEq)]
pub struct Sampled {
    /// Time between two samples, s.
    pub period: f64,
    /// Change of the next state by the state.
    pub a: DMatrix<f64>,
    /// Change of the next state by the inputs, in SI units.
    pub b: DMatrix<f64>,
    /// Change of the outputs, in their units, by the state.
    pub c: DMatrix<f64>,
    /// Change of the outputs, in their units, by the inputs.
    pub d: DMatrix<f64>,
    /// The directions of the state in columns, in coordinates, velocities and first-order states.
    pub basis: DMatrix<f64>,
    /// Names of the rows of `basis`.
    pub states: Vec<&'static str>,
    /// The state from which its changes count: a number for each row of `basis`.
    pub point: Vec<f64>,
    /// Names and units of the inputs.
    pub inputs: &'static [(&'static str, &'static str)],
    /// Names and units of the outputs.
    pub outputs: &'static [(&'static str, &'static str)],
}

impl Linearisation {
    /// The system at samples with a period, s, exactly: inputs are held between them, as a converter holds its voltage. It is one matrix
    /// exponential (C. F. Van Loan, IEEE Trans. Automatic Control 23, 1978). With a period that is no number, or far beyond what the system takes, its entries are none.
    pub fn sampled(&self, period: f64) -> Sampled {
        let (n, m) = self.b.shape();
        let mut both = DMatrix::zeros(n + m, n + m);
        both.view_mut((0, 0), (n, n)).copy_from(&(&self.a * period));
        both.view_mut((0, n), (n, m)).copy_from(&(&self.b * period));
        // The exponential of what is no number has no end.
        let is_finite = both.iter().all(|entry: &f64| entry.abs() < super::LARGE);
        let both =
            if both.is_empty() || !is_finite { both.map(|entry| entry * f64::NAN) } else { both.exp() };
        Sampled {
            period,
            a: both.view((0, 0), (n, n)).into_owned(),
            b: both.view((0, n), (n, m)).into_owned(),
            c: self.c.clone(),
            d: self.d.clone(),
            basis: self.basis.clone(),
            states: self.states.clone(),
            point: self.point.clone(),
            inputs: self.inputs,
            outputs: self.outputs,
        }
    }

    /// Eigenvalues of A, 1/s, those of small size first.
    pub fn poles(&self) -> Vec<Complex<f64>> {
        eigenvalues(&self.a)
    }

    pub(super) fn system(&self) -> System<'_> {
        let Self { a, b, c, d, basis, states, point, inputs, outputs, .. } = self;
        System { time: Time::Continuous, a, b, c, d, basis, states, point, inputs, outputs }
    }
}

impl Sampled {
    /// Eigenvalues of A, those of small size first. Those inside of the unit circle decay.
    pub fn poles(&self) -> Vec<Complex<f64>> {
        eigenvalues(&self.a)
    }

    /// The modes of a continuous system that has these poles at the samples, slow ones first.
    pub fn modes(&self) -> Vec<Mode> {
        let system = self.system();
        let mut modes: Vec<_> = self.poles().into_iter().map(|pole| system.mode(pole)).collect();
        modes.sort_by(|a, b| a.frequency.total_cmp(&b.frequency));
        modes
    }

    pub(super) fn system(&self) -> System<'_> {
        let Self { period, a, b, c, d, basis, states, point, inputs, outputs } = self;
        System { time: Time::Sampled(*period), a, b, c, d, basis, states, point, inputs, outputs }
    }
}
