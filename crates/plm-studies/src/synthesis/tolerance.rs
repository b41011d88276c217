//! Tolerances: how far a quantity is off when dimensions are, in the worst case and statistically.

use plm_runtime::{Dual, Real};
use rayon::prelude::*;

use crate::synthesis::random::Random;

/// Dimension with a symmetric tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dimension {
    /// Name of the dimension.
    pub name: &'static str,
    /// Nominal value.
    pub nominal: f64,
    /// Largest deviation, in the unit of the value.
    pub tolerance: f64,
    /// Distribution of the deviation.
    pub distribution: Distribution,
}

/// Distribution of a deviation within its tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Distribution {
    /// Normal, with the tolerance as three standard deviations; larger deviations are sorted out.
    Normal,
    /// Every deviation alike.
    Uniform,
    /// Symmetric triangle.
    Triangular,
}

impl Distribution {
    /// Standard deviation for a tolerance of 1. Of the normal distribution cut off at three standard deviations it is
    /// `(1/3) sqrt(1 - 6 phi(3) / (2 Phi(3) - 1))`.
    pub fn deviation(self) -> f64 {
        match self {
            Self::Normal => 0.986_578_392_558_108_6 / 3.0,
            Self::Uniform => 1.0 / 3_f64.sqrt(),
            Self::Triangular => 1.0 / 6_f64.sqrt(),
        }
    }

    fn sample(self, random: &mut Random) -> f64 {
        match self {
            Self::Normal => loop {
                let deviation = random.normal() / 3.0;
                if deviation.abs() <= 1.0 {
                    return deviation;
                }
            },
            Self::Uniform => random.between(-1.0, 1.0),
            Self::Triangular => 0.5 * (random.between(-1.0, 1.0) + random.between(-1.0, 1.0)),
        }
    }
}

/// Quantity of dimensions, on numbers of any kind: a closed form, or the result of a run of a mechanism.
pub trait Quantity<const N: usize>: Sync {
    /// The quantity at dimensions. `None` where it has no value, as where a loop does not close.
    fn value<S: Real>(&self, dimensions: [S; N]) -> Option<S>;
}

/// Share of a dimension in the deviation of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contribution {
    /// Name of the dimension.
    pub name: &'static str,
    /// Derivative of the quantity by the dimension.
    pub derivative: f64,
    /// Deviation of the quantity at the limit of this tolerance alone, to first order.
    pub worst: f64,
    /// Share of the variance, 0 to 1.
    pub share: f64,
}

/// Deviation of a quantity by tolerances, from its gradient.
#[derive(Clone, Debug, PartialEq)]
pub struct Stack {
    /// Nominal value.
    pub nominal: f64,
    /// Worst case to first order: the sum of all contributions.
    pub worst: f64,
    /// Least and largest value over the corners of the tolerances. `None` with more than 16 dimensions, or where a corner has no value.
    pub corners: Option<[f64; 2]>,
    /// Standard deviation to first order: the root of the sum of squares.
    pub deviation: f64,
    /// Contributions, the largest share first: the order of a Pareto chart.
    pub contributions: Vec<Contribution>,
}

/// Deviation of a quantity by the tolerances of its dimensions, with exact derivatives. `None` where the quantity has no value at the
/// nominal dimensions.
pub fn stack<const N: usize>(quantity: &impl Quantity<N>, dimensions: &[Dimension; N]) -> Option<Stack> {
    let at: [Dual<f64, N>; N] = std::array::from_fn(|k| Dual::variable(dimensions[k].nominal, k));
    let Dual { value, tangents } = quantity.value(at)?;
    let variance = |k: usize| {
        let Dimension { tolerance, distribution, .. } = dimensions[k];
        (tangents[k] * tolerance * distribution.deviation()).powi(2)
    };
    let sum: f64 = (0..N).map(variance).sum();
    let contribution = |k: usize| Contribution {
        name: dimensions[k].name,
        derivative: tangents[k],
        worst: (tangents[k] * dimensions[k].tolerance).abs(),
        share: if sum > 0.0 { variance(k) / sum } else { 0.0 },
    };
    let mut contributions: Vec<Contribution> = (0..N).map(contribution).collect();
    contributions.sort_by(|a, b| b.share.total_cmp(&a.share).then(a.name.cmp(b.name)));
    Some(Stack {
        nominal: value,
        worst: contributions.iter().map(|c| c.worst).sum(),
        corners: corners(quantity, dimensions),
        deviation: sum.sqrt(),
        contributions,
    })
}

/// Least and largest value over all corners.
fn corners<const N: usize>(quantity: &impl Quantity<N>, dimensions: &[Dimension; N]) -> Option<[f64; 2]> {
    if N > 16 {
        return None;
    }
    let corner = |number: usize| {
        quantity.value(std::array::from_fn(|k| {
            let sign = if number >> k & 1 == 0 { -1.0 } else { 1.0 };
            dimensions[k].nominal + sign * dimensions[k].tolerance
        }))
    };
    let values = (0..1_usize << N).map(corner).collect::<Option<Vec<f64>>>()?;
    Some([
        values.iter().copied().fold(f64::INFINITY, f64::min),
        values.into_iter().fold(f64::NEG_INFINITY, f64::max),
    ])
}

/// Result of random assemblies.
#[derive(Clone, Debug, PartialEq)]
pub struct MonteCarlo {
    /// Values in ascending order.
    pub values: Vec<f64>,
    /// Assemblies in which the quantity has no value.
    pub without_value: u64,
    /// Mean.
    pub mean: f64,
    /// Standard deviation of the sample.
    pub deviation: f64,
}

impl MonteCarlo {
    /// Value below which a fraction of all values lies, 0 to 1.
    pub fn quantile(&self, fraction: f64) -> Option<f64> {
        let last = self.values.len().checked_sub(1)?;
        self.values.get((fraction.clamp(0.0, 1.0) * last as f64).round() as usize).copied()
    }

    /// Fraction of the assemblies whose value lies between two limits; those without a value count as outside.
    pub fn within(&self, least: f64, most: f64) -> f64 {
        let inside = self.values.iter().filter(|value| (least..=most).contains(*value)).count();
        inside as f64 / (self.values.len() as u64 + self.without_value) as f64
    }
}

/// So many assemblies with random deviations. Each has its own sequence of random numbers, so that the result depends on the seed alone,
/// and not on the number of threads.
pub fn monte_carlo<const N: usize>(
    quantity: &impl Quantity<N>,
    dimensions: &[Dimension; N],
    assemblies: u64,
    seed: u64,
) -> MonteCarlo {
    let value = |number: u64| {
        let mut random = Random::new(seed, number);
        quantity.value(dimensions.map(|d| d.nominal + d.tolerance * d.distribution.sample(&mut random)))
    };
    let mut values: Vec<f64> = (0..assemblies).into_par_iter().filter_map(value).collect();
    values.sort_by(f64::total_cmp);
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    let deviation = (squares / (count - 1.0).max(1.0)).sqrt();
    MonteCarlo { without_value: assemblies - values.len() as u64, values, mean, deviation }
}
