//! The points of a study: each is a function of its number.

use super::log::checksum;
use super::{Quantity, random};

/// Values of P parameters for every point. Point number i follows from i alone.
#[derive(Clone, Debug)]
pub struct Points<const P: usize> {
    pub(super) quantities: [Quantity; P],
    rule: Rule<P>,
}

#[derive(Clone, Debug)]
enum Rule<const P: usize> {
    Grid([Vec<f64>; P]),
    List(Vec<[f64; P]>),
    MonteCarlo { seed: u64, count: usize, spreads: [Spread; P] },
}

/// How a parameter is distributed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spread {
    /// Every value between the two alike.
    Uniform {
        /// The smallest.
        from: f64,
        /// Upper bound, exclusive.
        to: f64,
    },
    /// The normal distribution.
    Normal {
        /// Its mean.
        mean: f64,
        /// Its standard deviation.
        deviation: f64,
    },
}

/// So many values at equal distances, the ends among them.
pub fn linear(from: f64, to: f64, count: usize) -> Vec<f64> {
    let share = |k: usize| if count > 1 { k as f64 / (count - 1) as f64 } else { 0.0 };
    (0..count).map(|k| from * (1.0 - share(k)) + to * share(k)).collect()
}

impl<const P: usize> Points<P> {
    /// All combinations of the values of parameters, (name, unit, values); the last varies fastest.
    pub fn grid(axes: [(&str, &str, Vec<f64>); P]) -> Self {
        let quantities = axes.each_ref().map(|(name, unit, _)| Quantity::from((*name, *unit)));
        Self { quantities, rule: Rule::Grid(axes.map(|(_, _, values)| values)) }
    }

    /// These points, of parameters (name, unit).
    pub fn list(parameters: [(&str, &str); P], points: impl IntoIterator<Item = [f64; P]>) -> Self {
        Self { quantities: parameters.map(Quantity::from), rule: Rule::List(points.into_iter().collect()) }
    }

    /// So many points by chance, of parameters (name, unit, distribution), independent of each other. The same seed gives the
    /// same points on every machine, and more of them leave the first ones as they are.
    pub fn monte_carlo(seed: u64, count: usize, parameters: [(&str, &str, Spread); P]) -> Self {
        let quantities = parameters.map(|(name, unit, _)| Quantity::from((name, unit)));
        let spreads = parameters.map(|(_, _, spread)| spread);
        Self { quantities, rule: Rule::MonteCarlo { seed, count, spreads } }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        match &self.rule {
            Rule::Grid(axes) => axes.iter().map(Vec::len).product(),
            Rule::List(points) => points.len(),
            Rule::MonteCarlo { count, .. } => *count,
        }
    }

    /// Is there none?
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Point number `index`, counted from 0; none after the last.
    pub fn at(&self, index: usize) -> Option<[f64; P]> {
        if index >= self.len() {
            return None;
        }
        Some(match &self.rule {
            Rule::Grid(axes) => combination(axes, index),
            Rule::List(points) => points[index],
            Rule::MonteCarlo { seed, spreads, .. } => {
                core::array::from_fn(|k| spreads[k].draw(*seed, index as u64, k as u32))
            }
        })
    }

    /// Text of a point: `arm 30 deg, forearm 90 deg`.
    pub(super) fn words(&self, index: usize) -> String {
        let values = self.at(index).into_iter().flatten();
        let words = values.zip(&self.quantities).map(|(value, Quantity { name, unit })| {
            if unit.is_empty() { format!("{name} {value}") } else { format!("{name} {value} {unit}") }
        });
        words.collect::<Vec<_>>().join(", ")
    }

    /// A line for each parameter, and what else decides what the points are.
    pub(super) fn description(&self) -> String {
        let of = |values: &mut dyn Iterator<Item = f64>| {
            let bytes: Vec<u8> = values.flat_map(f64::to_le_bytes).collect();
            format!("{} values, checksum {:016x}", bytes.len() / size_of::<f64>(), checksum(&bytes))
        };
        let rules: [String; P] = match &self.rule {
            Rule::Grid(axes) => {
                axes.each_ref().map(|axis| format!("grid, {}", of(&mut axis.iter().copied())))
            }
            Rule::List(points) => {
                core::array::from_fn(|k| format!("list, {}", of(&mut points.iter().map(|point| point[k]))))
            }
            Rule::MonteCarlo { seed, spreads, .. } => {
                spreads.map(|spread| format!("Monte Carlo, seed {seed}, {spread:?}"))
            }
        };
        let lines = self.quantities.iter().zip(rules);
        lines.map(|(quantity, rule)| format!("parameter {quantity}: {rule}\n")).collect::<Vec<_>>().concat()
    }
}

/// The last axis varies fastest.
fn combination<const P: usize>(axes: &[Vec<f64>; P], index: usize) -> [f64; P] {
    let (mut rest, mut point) = (index, [0.0; P]);
    for (value, axis) in point.iter_mut().zip(axes).rev() {
        *value = axis[rest % axis.len()];
        rest /= axis.len();
    }
    point
}

impl Spread {
    /// The value of a parameter, by its number, at a point.
    fn draw(self, seed: u64, point: u64, parameter: u32) -> f64 {
        match self {
            Spread::Uniform { from, to } => from + (to - from) * random::uniform(seed, point, parameter),
            Spread::Normal { mean, deviation } => mean + deviation * random::normal(seed, point, parameter),
        }
    }
}
