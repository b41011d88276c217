//! Bodies without mass: which accelerations and reactions would need their masses.
//!
//! The equations of motion are a linear system for the accelerations `a` and the multipliers `lambda`:
//!
//! ```text
//! M a + phi_q^T lambda = Q
//! phi_q a              = gamma
//! ```
//!
//! A mass stands in the rows of its body alone, those of the first line. Where constraints determine the motion of a body, its
//! accelerations follow from the second line, and its own rows are what determines multipliers.

use crate::collect::{CollectVec, PushAll};
use crate::sorted::{SortedMap, SortedSet};
use plm_cas::{Expr, algebra};

use super::Equations;
use crate::model::{Model, Output};
use crate::topology::{Equation, Influence, structural_rank};

/// Bodies without mass, and what depends on their masses.
pub(crate) struct Massless {
    /// Indices of the bodies.
    pub(crate) bodies: Vec<usize>,
    /// The accelerations and multipliers, and their numbers as unknowns.
    unknowns: SortedMap<Expr, usize>,
    influence: Influence,
    coordinates: usize,
    /// Degrees of freedom, for almost all dimensions.
    pub(crate) freedom: usize,
    /// Do dimensions make rows repeat others? Each reaction depends on all masses then.
    pub(crate) repeats: bool,
}

impl Massless {
    /// The bodies without mass; `None` if each body has one.
    pub(crate) fn new(model: &Model, equations: &Equations) -> Option<Massless> {
        let bodies: Vec<usize> = (0..model.bodies.len()).filter(|&k| !model.bodies[k].has_mass).collect_vec();
        if bodies.is_empty() {
            return None;
        }
        let nq = equations.q.len();
        let symbols = model.bodies.iter().flat_map(|body| body.a).chain(equations.lambda.iter().copied());
        let unknowns: SortedMap<Expr, usize> = symbols.enumerate().map(|(k, symbol)| (symbol, k)).collect();
        let rows = equations.phi_q.iter().map(|row| row.iter().map(|&(column, _)| column).collect_vec());
        let rows = rows.map(|unknowns| Equation { unknowns, rows: 1 }).collect_vec();
        let mut all = balances(model, &rows, &unknowns);
        all.push_all(rows.iter().cloned());
        let sources = bodies.iter().map(|&body| (3 * body..3 * body + 3).collect_vec()).collect_vec();
        let influence = Influence::new(nq + rows.len(), &all, &sources);
        let freedom = nq - structural_rank(nq, &rows);
        Some(Massless { bodies, unknowns, influence, coordinates: nq, freedom, repeats: false })
    }

    /// The bodies whose missing masses expressions depend on, ascending.
    pub(crate) fn needed_by(&self, roots: &[Expr]) -> Vec<usize> {
        let read = algebra::symbols(roots);
        let unknowns = || read.iter().filter_map(|symbol| self.unknowns.get(symbol).copied());
        if self.repeats && unknowns().any(|unknown| unknown >= self.coordinates) {
            return self.bodies.clone();
        }
        let needed: SortedSet<usize> =
            unknowns().flat_map(|unknown| self.influence.sources(unknown)).collect();
        needed.iter().map(|&source| self.bodies[source]).collect_vec()
    }

    /// The bodies without mass whose own motion depends on their mass: those that move freely.
    pub(crate) fn free(&self, model: &Model) -> Vec<usize> {
        let moves_by_itself = |&&body: &&usize| self.needed_by(&model.bodies[body].a).contains(&body);
        self.bodies.iter().filter(moves_by_itself).copied().collect_vec()
    }

    /// Leaves out what is observed and depends on masses that are missing.
    pub(crate) fn without_forces(&self, observed: Vec<Output>) -> Vec<Output> {
        observed.into_iter().filter(|output| self.needed_by(&output.components).is_empty()).collect_vec()
    }
}

/// Unknowns in the rows of `M a + phi_q^T lambda = Q`, one row by coordinate.
fn balances(model: &Model, rows: &[Equation], unknowns: &SortedMap<Expr, usize>) -> Vec<Equation> {
    let nq = 3 * model.bodies.len();
    let mut held: Vec<SortedSet<usize>> = (0..nq).map(|k| [k].into_iter().collect()).collect_vec();
    for (row, equation) in rows.iter().enumerate() {
        for &column in &equation.unknowns {
            held[column].insert(nq + row);
        }
    }
    for load in &model.loads {
        for (k, &force) in load.force.iter().enumerate() {
            let read = algebra::symbols(&[force]);
            let read = read.iter().filter_map(|symbol| unknowns.get(symbol).copied());
            held[3 * load.body + k].extend(read);
        }
    }
    held.iter().map(|held| Equation { unknowns: held.iter().copied().collect_vec(), rows: 1 }).collect_vec()
}
