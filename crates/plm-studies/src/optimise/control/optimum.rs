//! Result of an optimal control.

use plm_view::{Axis, Chart, Series};

/// Inputs of least cost.
#[derive(Clone, Debug, PartialEq)]
pub struct Optimum {
    /// Times at which intervals begin, and the end, s.
    pub times: Vec<f64>,
    /// For each input its value in each interval, SI.
    pub inputs: Vec<Vec<f64>>,
    /// Duration, s.
    pub duration: f64,
    /// The cost.
    pub cost: f64,
    /// The largest violation of a constraint: of outputs in SI, of continuity in typical sizes of states.
    pub violation: f64,
    /// Iterations of the search.
    pub iterations: usize,
    /// Runs of segments with all derivatives.
    pub runs: usize,
    /// Name, unit and factor of each input.
    pub(crate) names: Vec<(String, &'static str, f64)>,
}

impl Optimum {
    /// The value of an input, by its number among those that were found, at a time, s; SI.
    pub fn input(&self, number: usize, time: f64) -> Option<f64> {
        let values = self.inputs.get(number)?;
        let interval = self.times.partition_point(|begins| *begins <= time).saturating_sub(1);
        values.get(interval.min(values.len().saturating_sub(1))).copied()
    }

    /// The inputs over time, in their units.
    pub fn chart(&self) -> Chart {
        self.inputs.iter().zip(&self.names).fold(
            Chart::rows(Axis::linear("time", "s").tight()),
            |chart, (values, name)| {
                let (name, unit, factor) = name;
                let ends = self.times.windows(2).zip(values);
                let steps =
                    ends.flat_map(|(ends, value)| ends.iter().map(move |time| (*time, value / factor)));
                chart.below(Axis::linear(name, unit)).with(Series::new(name.clone(), steps))
            },
        )
    }
}
