//! Charts of an identification.

use plm_runtime::Fault;
use plm_view::{Axis, Chart, Recording, Series};

use super::fit::Fit;
use crate::optimise::mechanism::{Integration, Optimisable};

impl<M: Optimisable> Fit<M> {
    /// For each output and each experiment the readings as points on the curve of the motion, and below them the residuals, with an axis
    /// of their own.
    ///
    /// # Errors
    /// The fault of a run by this method, as for [`recording`](Self::recording).
    pub fn chart(&self, integration: impl Integration<M>) -> Result<Chart, Fault> {
        let mut chart = Chart::rows(Axis::linear("time", "s").tight());
        for (number, motion) in self.motions.iter().enumerate() {
            let (recording, outputs) = motion.recorded(number, &integration)?;
            let name = if self.motions.len() > 1 { format!(", experiment {number}") } else { String::new() };
            for columns in outputs {
                chart = below(chart, (&recording, &name), columns);
            }
        }
        Ok(chart)
    }
}

/// Adds the panels of an output, by its columns: motion, readings, residuals.
fn below(
    chart: Chart,
    (recording, experiment): (&Recording, &str),
    [model, reading, residual]: [usize; 3],
) -> Chart {
    let Some(column) = recording.columns().get(model) else { return chart };
    let series = |name: &str, index: usize| {
        let values = recording.rows().map(move |row| row.get(index).copied().unwrap_or(f64::NAN));
        Series::new(name, recording.times().iter().copied().zip(values))
    };
    chart
        .below(Axis::linear(&format!("{}{experiment}", column.name), &column.unit))
        .with(series("model", model))
        // Points stand over the curve.
        .with(series("readings", reading).as_points())
        .below(Axis::linear("residual", &column.unit))
        .with(series("model - reading", residual).of_family(1, 0).as_points())
}
