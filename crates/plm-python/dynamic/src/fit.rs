//! Result of an identification.

use plm_cli::{Found, with_values};
use plm_dynamic::Dynamic;
use plm_runtime::Fault;
use plm_studies::optimise::{Error, Fit as Fitted, Integration};
use plm_view::{Page, Results};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyByteArray;

use crate::text::Text;
use crate::{Matrix, VALUES, bytes, error};

/// A mechanism whose runs have derivatives.
pub(crate) type Small = Dynamic<f64, 24, 32, 64, 24>;

/// A fit with the method of its runs.
pub(crate) type Shown = Box<dyn Motion + Send + Sync>;

/// A fit whose motion can be drawn.
pub(crate) trait Motion {
    /// The fit.
    fn fit(&self) -> &Fitted<Small>;
    /// Readings, model and residuals as a picture (SVG).
    fn chart(&self) -> Result<String, Fault>;
    /// The motion of each experiment, with readings and residuals.
    fn results(&self) -> Result<Results, Fault>;
}

impl<D: Integration<Small>> Motion for (Fitted<Small>, D) {
    fn fit(&self) -> &Fitted<Small> {
        &self.0
    }

    fn chart(&self) -> Result<String, Fault> {
        self.0.chart(self.1).map(|chart| chart.to_svg())
    }

    fn results(&self) -> Result<Results, Fault> {
        let count = self.0.residuals.iter().map(|own| own.experiment + 1).max().unwrap_or_default();
        let runs = (0..count).map(|k| self.0.recording(k, self.1)).collect::<Result<_, _>>()?;
        Ok(Results { runs, ..Results::default() })
    }
}

/// Result of an identification.
#[pyclass(frozen)]
pub(crate) struct Fit {
    shown: Shown,
    name: &'static str,
}

/// Name, experiment, value, standard error, the bound that it stands at.
type Estimate = (String, Option<usize>, f64, f64, Option<f64>);
/// Experiment, output, unit; times, readings and model.
type Residuals<'py> = (usize, String, String, [Bound<'py, PyByteArray>; 3]);

impl Fit {
    pub(crate) fn new(text: &Text, shown: Shown) -> Self {
        Self { shown, name: text.mechanism.tables().name }
    }
}

#[pymethods]
impl Fit {
    fn estimates(&self) -> Vec<Estimate> {
        let all = self.shown.fit().estimates.iter();
        all.map(|own| (own.name.clone(), own.experiment, own.value, own.standard_error, own.bound)).collect()
    }

    /// Covariance and correlation.
    fn matrices<'py>(&self, py: Python<'py>) -> [Matrix<'py>; 2] {
        let fit = self.shown.fit();
        [&fit.covariance, &fit.correlation()].map(|matrix| {
            let rows = matrix.row_iter().flat_map(|row| row.iter().copied().collect::<Vec<_>>());
            (matrix.nrows(), bytes(py, rows))
        })
    }

    fn undetermined(&self) -> Vec<Vec<(String, f64)>> {
        self.shown.fit().undetermined.iter().map(|own| own.changes.clone()).collect()
    }

    fn residuals<'py>(&self, py: Python<'py>) -> Vec<Residuals<'py>> {
        let all = self.shown.fit().residuals.iter();
        all.map(|own| {
            let columns =
                [&own.times, &own.readings, &own.model].map(|column| bytes(py, column.iter().copied()));
            (own.experiment, own.output.clone(), own.unit.clone(), columns)
        })
        .collect()
    }

    /// Sum of squares, freedoms, iterations, runs.
    fn statistics(&self) -> (f64, usize, usize, usize) {
        let fit = self.shown.fit();
        (fit.chi_squared, fit.freedoms, fit.iterations, fit.runs)
    }

    fn table(&self) -> String {
        self.shown.fit().table()
    }

    fn chart(&self, py: Python<'_>) -> PyResult<String> {
        py.detach(|| self.shown.chart()).map_err(|fault| error(py, fault.into()))
    }

    fn page(&self, py: Python<'_>) -> PyResult<String> {
        let results = py.detach(|| self.shown.results()).map_err(|fault| error(py, fault.into()))?;
        let bytes = results.to_bytes().map_err(|why| PyValueError::new_err(why.to_string()))?;
        Ok(Page::new(&bytes, self.name).to_html())
    }

    /// A declaration with the values that all experiments have in common, and the names that stand nowhere in it.
    fn declaration(&self, file: &str, text: &str) -> (String, Vec<String>) {
        let shared = self.shown.fit().estimates.iter().filter(|own| own.experiment.is_none());
        let found: Vec<Found<'_>> = shared
            .map(|own| Found { name: &own.name, value: own.value / own.factor, unit: own.unit })
            .collect();
        let (text, missing) = with_values(file, text, &found);
        (text, missing.into_iter().map(str::to_owned).collect())
    }
}

/// Why there is no fit, as the exception of the package.
pub(crate) fn failed(py: Python<'_>, why: &Error) -> PyErr {
    let said = why.to_string().replace('`', "'");
    let raised = |module: &str, exception: &str| py.import(module)?.getattr(exception);
    let exception = match why {
        Error::AtGuess { fault, .. } => {
            raised(VALUES, "Fault").and_then(|fails| fails.call1((said, fault.time, fault.part)))
        }
        Error::NotConverged { best, .. } => {
            raised("plm._fit", "NotConverged").and_then(|fails| fails.call1((said, best.clone())))
        }
        _ => return PyValueError::new_err(said),
    };
    exception.map_or_else(|error| error, PyErr::from_value)
}
