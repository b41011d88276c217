//! The interpreter of a compiled mechanism: what the emitted code must compute, bit for bit.

use plm_cas::{Expr, Graph, Tape};

use crate::derive::Equations;
use crate::formulate::{Absolute, Chart, Function, Reduced};
use crate::model::Model;

/// A state in a chart.
#[derive(Clone, Debug)]
pub struct InChart {
    /// Coordinates and their rates, `[y, y']`.
    pub state: Vec<f64>,
    /// How far from flat its loops are: 1 at best, 0 where the coordinates determine nothing.
    pub measure: f64,
    /// `[q, v]` of all bodies as the chart works them out.
    pub pose: Vec<f64>,
    /// Second derivatives of the coordinates.
    pub acceleration: Vec<f64>,
}

/// A compiled mechanism that can be evaluated without rustc.
#[derive(Debug)]
pub struct Oracle {
    pub(crate) model: Model,
    pub(crate) graph: Graph,
    pub(crate) equations: Equations,
    pub(crate) program: Absolute,
    pub(crate) reduced: Option<Reduced>,
}

impl Oracle {
    /// Length of the state in absolute coordinates, `[q, v, first-order states]`.
    pub fn states(&self) -> usize {
        2 * self.equations.q.len() + self.equations.x.len()
    }

    /// Length of the state on the rung that was taken, `[y, y', first-order states]`.
    pub fn reduced_states(&self) -> Option<usize> {
        self.reduced.as_ref().map(|reduced| 2 * reduced.freedom() + self.equations.x.len())
    }

    /// `dx`, and with loops Health, in the first chart of the rung that was taken, if that is above 5; `x` has
    /// [`Oracle::reduced_states`] values, followed by what is remembered.
    pub fn rate(&self, time: f64, x: &[f64]) -> Option<Vec<f64>> {
        let reduced = self.reduced.as_ref()?;
        let chart = reduced.first()?;
        let state = chart.y.iter().chain(&chart.y_dot).chain(&self.equations.x);
        let symbols: Vec<Expr> = state.chain(&reduced.memory).copied().collect();
        Some(self.run_at(&chart.rate, time, &symbols, x))
    }

    /// What each chart of the rung that was taken makes of a state in absolute coordinates, `x` as in
    /// [`Oracle::dynamics`]; nothing on rung 5.
    pub fn charts(&self, time: f64, x: &[f64]) -> Vec<InChart> {
        let Some(reduced) = &self.reduced else { return Vec::new() };
        reduced.charts.iter().filter_map(|chart| self.in_chart(reduced, chart, time, x)).collect()
    }

    /// Accelerations of all bodies at a state in absolute coordinates, by the joint coordinates of a mechanism without loops.
    pub fn accelerations(&self, time: f64, x: &[f64]) -> Option<Vec<f64>> {
        let chart = self.reduced.as_ref()?.first()?;
        let reactions = chart.reactions.as_ref()?;
        let mut state = self.run(&chart.project, time, x);
        state.extend_from_slice(x.get(2 * self.equations.q.len()..)?);
        let symbols: Vec<Expr> =
            chart.y.iter().chain(&chart.y_dot).chain(&self.equations.x).copied().collect();
        let mut accelerations = self.run_at(reactions, time, &symbols, &state);
        accelerations.truncate(self.equations.q.len());
        Some(accelerations)
    }

    fn in_chart(&self, reduced: &Reduced, chart: &Chart, time: f64, x: &[f64]) -> Option<InChart> {
        let survey = chart.survey.as_ref().map(|survey| self.run(survey, time, x));
        let mut remembered = survey.unwrap_or_else(|| vec![1.0]);
        let square = remembered.pop()?;
        if let Some(precision) = remembered.last_mut().filter(|_| reduced.iterates()) {
            *precision = f64::EPSILON;
        }
        let absolute = 2 * self.equations.q.len();
        let mut state = self.run(&chart.project, time, x);
        state.truncate(2 * chart.y.len());
        let in_coordinates = state.clone();
        state.extend_from_slice(x.get(absolute..)?);
        state.extend(remembered);
        let symbols: Vec<Expr> =
            chart.y.iter().chain(&chart.y_dot).chain(&self.equations.x).copied().collect();
        let symbols: Vec<Expr> = symbols.into_iter().chain(reduced.memory.iter().copied()).collect();
        let mut pose = self.run_at(&chart.pose, time, &symbols, &state);
        pose.truncate(absolute);
        let mut rate = self.run_at(&chart.rate, time, &symbols, &state);
        rate.truncate(in_coordinates.len());
        let acceleration = rate.split_off(in_coordinates.len() / 2);
        Some(InChart { state: in_coordinates, measure: square.max(0.0).sqrt(), pose, acceleration })
    }

    /// Number of constraint rows.
    pub fn constraints(&self) -> usize {
        self.equations.phi.len()
    }

    /// `dx`, then `lambda`, then Health, with parameters and inputs as declared. `x` has [`Oracle::states`] values.
    pub fn dynamics(&self, time: f64, x: &[f64]) -> Vec<f64> {
        self.run(&self.program.dynamics, time, x)
    }

    /// Residuals of the constraints.
    pub fn phi(&self, time: f64, x: &[f64]) -> Vec<f64> {
        self.run(&self.program.phi, time, x)
    }

    /// Rates of the residuals.
    pub fn phi_dot(&self, time: f64, x: &[f64]) -> Vec<f64> {
        self.run(&self.program.phi_dot, time, x)
    }

    fn run(&self, function: &Function, time: f64, x: &[f64]) -> Vec<f64> {
        let Equations { q, v, x: first_order, .. } = &self.equations;
        let symbols: Vec<Expr> = q.iter().chain(v).chain(first_order).copied().collect();
        self.run_at(function, time, &symbols, x)
    }

    fn run_at(&self, function: &Function, time: f64, symbols: &[Expr], x: &[f64]) -> Vec<f64> {
        let mut values: Vec<(Expr, f64)> = crate::check::defaults(&self.model, &self.graph);
        values.retain(|(symbol, _)| *symbol != self.model.time && !self.equations.x.contains(symbol));
        values.push((self.model.time, time));
        values.extend(symbols.iter().copied().zip(x.iter().copied()));
        crate::check::add_sides(&self.model, &self.graph, &mut values);
        let results: Vec<Expr> = function.roots();
        let tape = Tape::new(&self.graph, &results);
        let mut all = crate::check::run(&tape, &values);
        all.split_off(all.len() - function.results.len())
    }
}
