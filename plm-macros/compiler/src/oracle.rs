//! The interpreter of a compiled mechanism: what the emitted code must compute, bit for bit.

use crate::collect::{CollectVec, PushAll};
use std::cell::RefCell;
use std::fmt;

use plm_cas::{Expr, Graph, algebra};

use crate::derive::Equations;
use crate::formulate::{Chart, Function, Program, Reduced};
use crate::model::Model;
use crate::numeric::{add_switches, defaults, run};

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
pub struct Oracle {
    pub(crate) model: Model,
    pub(crate) graph: RefCell<Graph>,
    pub(crate) equations: Equations,
    pub(crate) program: Program,
}

/// Its parts are thousands of expressions, which nobody reads.
impl fmt::Debug for Oracle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Oracle").finish_non_exhaustive()
    }
}

impl Oracle {
    /// Length of the state in absolute coordinates, `[q, v, first-order states]`.
    pub fn states(&self) -> usize {
        2 * self.equations.q.len() + self.equations.x.len()
    }

    /// Length of the state in joint coordinates, `[y, y', first-order states]`; nothing where absolute ones are taken.
    pub fn reduced_states(&self) -> Option<usize> {
        self.program.reduced().map(|reduced| 2 * reduced.freedom() + self.equations.x.len())
    }

    /// `dx`, and with loops Health, in the first chart of joint coordinates; nothing where absolute ones are taken. `x` has
    /// [`Oracle::reduced_states`] values, followed by what is remembered.
    pub fn rate(&self, time: f64, x: &[f64]) -> Option<Vec<f64>> {
        let reduced = self.program.reduced()?;
        let chart = reduced.first()?;
        Some(self.run(&chart.rate, time, &self.state_in(chart, &reduced.memory), x))
    }

    /// The state in each chart of joint coordinates, from one in absolute ones, `x` as in [`Oracle::dynamics`]; nothing where
    /// absolute ones are taken.
    pub fn charts(&self, time: f64, x: &[f64]) -> Vec<InChart> {
        let Some(reduced) = self.program.reduced() else { return Vec::new() };
        reduced.charts.iter().filter_map(|chart| self.in_chart(reduced, chart, time, x)).collect_vec()
    }

    /// Accelerations of all bodies at a state in absolute coordinates, by the joint coordinates of a mechanism without loops.
    pub fn accelerations(&self, time: f64, x: &[f64]) -> Option<Vec<f64>> {
        let chart = self.program.reduced()?.first()?;
        let reactions = chart.reactions.as_ref()?;
        let mut state = self.run(&chart.from_pose, time, &self.state(), x);
        state.extend_from_slice(x.get(2 * self.equations.q.len()..)?);
        let mut accelerations = self.run(reactions, time, &self.state_in(chart, &[]), &state);
        accelerations.truncate(self.equations.q.len());
        Some(accelerations)
    }

    fn in_chart(&self, reduced: &Reduced, chart: &Chart, time: f64, x: &[f64]) -> Option<InChart> {
        let remember_pose =
            chart.remember_pose.as_ref().map(|remember_pose| self.run(remember_pose, time, &self.state(), x));
        let mut remembered = remember_pose.unwrap_or_else(|| vec![1.0]);
        let square = remembered.pop()?;
        let (coordinates, absolute) = (chart.y.len(), 2 * self.equations.q.len());
        let mut state = self.run(&chart.from_pose, time, &self.state(), x);
        state.truncate(2 * coordinates);
        let in_coordinates = state.clone();
        state.extend_from_slice(x.get(absolute..)?);
        state.extend(remembered);
        let symbols = self.state_in(chart, &reduced.memory);
        let mut pose = self.run(&chart.pose, time, &symbols, &state);
        pose.truncate(absolute);
        let mut rate = self.run(&chart.rate, time, &symbols, &state);
        rate.truncate(2 * coordinates);
        let (measure, acceleration) = (square.max(0.0).sqrt(), rate.split_off(coordinates));
        Some(InChart { state: in_coordinates, measure, pose, acceleration })
    }

    /// Number of constraint rows.
    pub fn constraints(&self) -> usize {
        self.equations.phi.len()
    }

    /// `dx`, then `lambda`, then Health, with parameters and inputs as declared. `x` has [`Oracle::states`] values.
    pub fn dynamics(&self, time: f64, x: &[f64]) -> Vec<f64> {
        self.run(&self.program.absolute.dynamics, time, &self.state(), x)
    }

    /// `phi` of all constraint rows, m or rad.
    pub fn phi(&self, time: f64, x: &[f64]) -> Vec<f64> {
        self.run(&self.program.absolute.phi, time, &self.state(), x)
    }

    /// `phi_q v - nu` of all constraint rows, m/s or rad/s.
    pub fn phi_dot(&self, time: f64, x: &[f64]) -> Vec<f64> {
        self.run(&self.program.absolute.phi_dot, time, &self.state(), x)
    }

    /// Symbols of the state in absolute coordinates.
    fn state(&self) -> Vec<Expr> {
        let Equations { q, v, x, .. } = &self.equations;
        [&q[..], v, x].concat()
    }

    /// Symbols of the state in a chart, and of what is remembered.
    fn state_in(&self, chart: &Chart, memory: &[(Expr, String)]) -> Vec<Expr> {
        let memory = memory.iter().map(|(symbol, _)| symbol);
        [&chart.y, &chart.y_dot, &self.equations.x].into_iter().flatten().chain(memory).copied().collect_vec()
    }

    /// The results of a function where some symbols have the values `x`, and what is held its declared values.
    fn run(&self, function: &Function, time: f64, symbols: &[Expr], x: &[f64]) -> Vec<f64> {
        self.graph.borrow_mut().enter(|| {
            let mut values = defaults(&self.model);
            values.retain(|(symbol, _)| *symbol != self.model.time && !self.equations.x.contains(symbol));
            values.push((self.model.time, time));
            values.push_all(symbols.iter().copied().zip(x.iter().copied()));
            add_switches(&self.model, &mut values);
            let mut all = run(&algebra::tape(&function.roots()), &values);
            all.split_off(all.len() - function.results.len())
        })
    }
}
