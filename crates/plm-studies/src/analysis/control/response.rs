//! Frequency response of an output to an input: magnitude and phase, as Bode draws them.

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::fmt;

use nalgebra::{Complex, DMatrix};

use super::{Sampled, System, Time, complex, index_of};
use crate::analysis::Linearisation;

/// The response of an output to an input over frequencies.
#[derive(Clone, Debug, PartialEq)]
pub struct Bode {
    /// Name and unit of the input; the response is in SI units of it.
    pub input: (&'static str, &'static str),
    /// Name and unit of the output, in which the response is.
    pub output: (&'static str, &'static str),
    /// Frequencies, rad/s.
    pub frequencies: Vec<f64>,
    /// Ratio of the amplitudes of output and input.
    pub magnitude: Vec<f64>,
    /// By how much the output leads, rad. Of the first, whole turns are those of a system of minimum phase with the slope of the magnitude there;
    /// each other one is next to the one before.
    pub phase: Vec<f64>,
}

/// Why there is no response.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum NoResponse {
    /// There is no input of this name.
    Input(String),
    /// There is no output of this name.
    Output(String),
    /// An undamped mode has this frequency, rad/s.
    Undamped(f64),
}

impl fmt::Display for NoResponse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(name) => write!(f, "there is no input `{name}`"),
            Self::Output(name) => write!(f, "there is no output `{name}`"),
            Self::Undamped(frequency) => {
                write!(f, "an undamped mode has the frequency {frequency} rad/s: it has no bounded response")
            }
        }
    }
}

impl Error for NoResponse {}

/// Frequencies from one to another at equal ratios, so many of a decade; none where these, or their ratio, are no positive, finite numbers.
pub fn frequencies(from: f64, to: f64, of_a_decade: usize) -> Vec<f64> {
    let is_sensible = |end: f64| end > 0.0 && end.is_finite();
    if !is_sensible(from) || !is_sensible(to) || !is_sensible(to / from) {
        return Vec::new();
    }
    let decades = (to / from).log10();
    let count = (decades * of_a_decade as f64).ceil().max(1.0);
    (0..=count as usize).map(|k| from * (to / from).powf(k as f64 / count)).collect()
}

macro_rules! responds {
    ($system:ident) => {
        impl $system {
            /// The response of an output, in its unit, to an input, in SI, at a frequency, rad/s.
            ///
            /// # Errors
            /// [`NoResponse`].
            pub fn response(
                &self,
                input: &str,
                output: &str,
                frequency: f64,
            ) -> Result<Complex<f64>, NoResponse> {
                let system = self.system();
                system.at(system.pair(input, output)?, frequency)
            }

            /// Magnitude and phase over frequencies that ascend, rad/s.
            ///
            /// # Errors
            /// [`NoResponse`].
            pub fn bode(&self, input: &str, output: &str, frequencies: &[f64]) -> Result<Bode, NoResponse> {
                self.system().bode(input, output, frequencies)
            }
        }
    };
}

responds!(Linearisation);
responds!(Sampled);

impl System<'_> {
    /// Numbers of an input and an output.
    pub(super) fn pair(&self, input: &str, output: &str) -> Result<[usize; 2], NoResponse> {
        let input = index_of(input, self.inputs).ok_or_else(|| NoResponse::Input(input.to_owned()))?;
        let output = index_of(output, self.outputs).ok_or_else(|| NoResponse::Output(output.to_owned()))?;
        Ok([input, output])
    }

    /// C (s - A)^-1 B + D, where s = i w, at samples exp(i w T).
    fn at(&self, [input, output]: [usize; 2], frequency: f64) -> Result<Complex<f64>, NoResponse> {
        let s = match self.time {
            Time::Continuous => Complex::new(0.0, frequency),
            Time::Sampled(period) => Complex::new(0.0, frequency * period).exp(),
        };
        let n = self.a.nrows();
        let shifted = DMatrix::identity(n, n) * s - complex(self.a);
        let right = complex(&self.b.columns(input, 1).into_owned());
        let decomposed = shifted.clone().lu();
        let mut states = decomposed.solve(&right).ok_or(NoResponse::Undamped(frequency))?;
        // Small states beside large ones need a step of refinement (R. D. Skeel, Math. Comp. 35, 1980).
        let rest = &right - shifted * &states;
        states += decomposed.solve(&rest).unwrap_or(rest * Complex::new(0.0, 0.0));
        let sum: Complex<f64> = self.c.row(output).iter().zip(states.iter()).map(|(c, x)| x * *c).sum();
        let response = sum + self.d[(output, input)];
        if response.norm().is_finite() { Ok(response) } else { Err(NoResponse::Undamped(frequency)) }
    }

    fn bode(&self, input: &str, output: &str, frequencies: &[f64]) -> Result<Bode, NoResponse> {
        let pair = self.pair(input, output)?;
        let all = frequencies.iter().map(|frequency| self.at(pair, *frequency));
        let all = all.collect::<Result<Vec<_>, _>>()?;
        let magnitude: Vec<f64> = all.iter().map(|response| response.norm()).collect();
        let mut last = first_phase(frequencies, &magnitude);
        let phase = all.iter().map(|response| {
            let angle = response.arg();
            last = angle + TAU * ((last - angle) / TAU).round();
            last
        });
        let phase = phase.collect();
        let [input, output] = [self.inputs[pair[0]], self.outputs[pair[1]]];
        Ok(Bode { input, output, frequencies: frequencies.to_vec(), magnitude, phase })
    }
}

/// The phase that belongs to the slope of the magnitude at the first frequency, if that is of s^p: p pi/2 (H. W. Bode, Network Analysis and Feedback
/// Amplifier Design, 1945, 14). A little less, so that what moves against that follows it.
fn first_phase(frequencies: &[f64], magnitude: &[f64]) -> f64 {
    let ([w, next, ..], [from, to, ..]) = (frequencies, magnitude) else { return -ROUNDED };
    let power = (to / from).ln() / (next / w).ln();
    if power.is_finite() { power.round() * FRAC_PI_2 - ROUNDED } else { -ROUNDED }
}

/// More than rounding of a phase, rad.
const ROUNDED: f64 = 1e-3;
