//! Charts of an identification.

use plm_view::{Axis, Chart, Series};

use super::fit::{Fit, Residuals};
use crate::mechanism::Optimisable;

impl<M: Optimisable> Fit<M> {
    /// The readings beside the model, and below them the residuals, for each output and each experiment.
    pub fn chart(&self) -> Chart {
        self.residuals.iter().fold(Chart::rows(Axis::linear("time", "s").tight()), |chart, residuals| {
            let Residuals { experiment, output, unit, times, readings, model } = residuals;
            let points =
                |values: &[f64]| times.iter().copied().zip(values.iter().copied()).collect::<Vec<_>>();
            let are_several = self.residuals.iter().any(|other| other.experiment != *experiment);
            let name =
                if are_several { format!("{output}, experiment {experiment}") } else { output.clone() };
            let differences: Vec<f64> = residuals.differences().collect();
            chart
                .below(Axis::linear(&name, unit))
                .with(Series::new("readings", points(readings)).muted(0).marked())
                .with(Series::new("model", points(model)))
                .below(Axis::linear("residual", unit))
                .with(Series::new("model - reading", points(&differences)).marked())
        })
    }
}
