//! Notices of a fit beside its numbers.

use std::fmt;

use super::fit::{Combination, Estimate, Figure, Fit, Residuals};
use crate::optimise::mechanism::Optimisable;

/// A reason to look before estimates are used.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Notice {
    /// An unknown ends at its bound, which may be why it ends there.
    AtBound(Estimate),
    /// A combination of unknowns that no reading determines.
    Untold(Combination),
    /// The model does not follow the readings of an output: the search has ended in a valley beside the right one, or the mechanism is
    /// another one.
    NotFollowed {
        /// The experiment, from 0.
        experiment: usize,
        /// Name of the output.
        output: String,
        /// The root mean square of the residuals as a fraction of the standard deviation of the readings.
        left: f64,
    },
}

/// The reading that is farthest from the model, by the residuals of its output.
#[derive(Clone, Debug, PartialEq)]
pub struct Farthest {
    /// The experiment, from 0.
    pub experiment: usize,
    /// Name of the output.
    pub output: String,
    /// Its time, s.
    pub time: f64,
    /// The output of the model less the reading, in the unit of the readings.
    pub difference: f64,
    /// The unit of the readings.
    pub unit: String,
    /// The difference over the root mean square of the residuals of the output.
    pub ratio: f64,
}

/// Residuals of this fraction of what readings vary by are none that noise explains if they have an order.
const LEFT: f64 = 0.1;
/// Residuals of this fraction of what readings vary by: a constant would follow them as well.
const ALL_LEFT: f64 = 0.9;
/// So many standard deviations fewer changes of the sign than by chance are an order.
const ORDERED: f64 = 3.0;

impl<M: Optimisable> Fit<M> {
    /// Reasons to check the estimates before they are used: unknowns at bounds, combinations that no reading determines, and outputs that
    /// the model does not follow. A search finds the minimum next to the guess; beside it there may be a deeper one.
    pub fn notices(&self) -> Vec<Notice> {
        let bounds = self.estimates.iter().filter(|own| own.bound.is_some()).cloned().map(Notice::AtBound);
        let untold = self.undetermined.iter().cloned().map(Notice::Untold);
        let not_followed = self.residuals.iter().filter_map(Residuals::not_followed);
        bounds.chain(untold).chain(not_followed).collect()
    }

    /// The reading that is farthest from the model; none where all are met.
    pub fn farthest(&self) -> Option<Farthest> {
        let of = |own: &Residuals| {
            let rms = own.rms();
            let worst = own.differences().enumerate().filter(|(_, difference)| difference.is_finite());
            let (at, difference) = worst.max_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()))?;
            (rms > 0.0).then(|| Farthest {
                experiment: own.experiment,
                output: own.output.clone(),
                time: own.times[at],
                difference,
                unit: own.unit.clone(),
                ratio: difference.abs() / rms,
            })
        };
        self.residuals.iter().filter_map(of).max_by(|a, b| a.ratio.total_cmp(&b.ratio))
    }
}

impl Residuals {
    /// Says that the model does not follow the readings, if residuals are large beside what readings vary by and have an order.
    fn not_followed(&self) -> Option<Notice> {
        let own: Vec<f64> = self.differences().filter(|difference| difference.is_finite()).collect();
        let readings = self.readings.iter().zip(self.differences()).filter(|(_, own)| own.is_finite());
        let readings: Vec<f64> = readings.map(|(reading, _)| *reading).collect();
        let count = own.len() as f64;
        let mean = readings.iter().sum::<f64>() / count;
        let spread = (readings.iter().map(|own| (own - mean).powi(2)).sum::<f64>() / count).sqrt();
        let left = self.rms() / spread;
        let is_left = left >= ALL_LEFT || (left >= LEFT && disorder(&own) < -ORDERED);
        (own.len() > 2 && spread > 0.0 && is_left).then(|| Notice::NotFollowed {
            experiment: self.experiment,
            output: self.output.clone(),
            left,
        })
    }
}

/// By how many standard deviations the runs of one sign are more than by chance (A. Wald, J. Wolfowitz, Annals of Mathematical Statistics
/// 11, 1940); 0 if there are too few residuals.
fn disorder(residuals: &[f64]) -> f64 {
    let signs: Vec<bool> = residuals.iter().filter(|own| **own != 0.0).map(|own| *own > 0.0).collect();
    let above = signs.iter().filter(|is_above| **is_above).count() as f64;
    let (all, below) = (signs.len() as f64, signs.len() as f64 - above);
    let runs = 1.0 + signs.windows(2).filter(|pair| pair[0] != pair[1]).count() as f64;
    let product = 2.0 * above * below;
    let variance = product * (product - all) / (all * all * (all - 1.0));
    if signs.len() < 8 || variance <= 0.0 {
        // All on one side: a constant is left over, which is an order whatever their number is.
        return if signs.len() >= 4 && product == 0.0 { f64::NEG_INFINITY } else { 0.0 };
    }
    (runs - product / all - 1.0) / variance.sqrt()
}

impl fmt::Display for Notice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::AtBound(Estimate { name, experiment, value, unit, factor, .. }) => {
                let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
                let of = experiment.map_or(String::new(), |number| format!(" of experiment {number}"));
                write!(
                    f,
                    "{name}{of} ends at its bound, {:.6}{unit}: the bound may be what holds it",
                    Figure(value / factor)
                )
            }
            Self::Untold(combination) => combination.fmt(f),
            Self::NotFollowed { experiment, output, left } => write!(
                f,
                "the model does not follow {output} in experiment {experiment}: {:.2} % of what its readings vary by is left; another \
                 guess may end in a deeper valley, or the mechanism is another one",
                Figure(100.0 * left)
            ),
        }
    }
}

/// `the farthest reading is b.x at 0.45 s of experiment 0: off by 0.0123 m, 5.31 times the rms`.
impl fmt::Display for Farthest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { experiment, output, time, difference, unit, ratio } = self;
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        // 0.2 s times 7 is 1.4 s but for its last digit.
        let time = (time * 1e9).round() / 1e9;
        write!(
            f,
            "the farthest reading is {output} at {time} s of experiment {experiment}: off by {:.3}{unit}, {:.3} times the rms",
            Figure(difference.abs()),
            Figure(*ratio)
        )
    }
}
