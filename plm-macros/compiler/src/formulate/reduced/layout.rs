//! Layout of the functions of all charts.

use crate::collect::CollectVec;
use plm_cas::{Expr, algebra};

use crate::derive::Equations;
use crate::formulate::reduced::joints::coordinates::Coordinates;
use crate::formulate::reduced::motion::Motion;
use crate::formulate::reduced::motion::memory::Memory;
use crate::formulate::{Function, Reads};
use crate::model::Model;

/// Data that all charts share.
pub(crate) struct Layout<'a> {
    pub(crate) model: &'a Model,
    pub(crate) equations: &'a Equations,
    pub(crate) coordinates: &'a Coordinates,
    pub(crate) memory: &'a Memory,
    pub(crate) length: Expr,
    /// Multipliers of the joints in absolute coordinates.
    pub(crate) lambda: &'a [Expr],
}

/// Applied forces and torques at each G, without gravity, as functions of the coordinates.
pub(crate) fn loads(model: &Model, motion: &Motion) -> Vec<[Expr; 3]> {
    let mut terms: Vec<[Vec<Expr>; 3]> = vec![Default::default(); model.bodies.len()];
    for load in &model.loads {
        for (sum, &component) in terms[load.body].iter_mut().zip(&load.force) {
            sum.push(component);
        }
    }
    let sums: Vec<Expr> = terms.iter().flatten().map(|sum| algebra::sum(sum)).collect_vec();
    let sums = algebra::substitute(&sums, &motion.substitution);
    sums.chunks_exact(3).map(|sum| [sum[0], sum[1], sum[2]]).collect_vec()
}

impl Layout<'_> {
    /// Reads of a rate among the state.
    pub(super) fn reads(&self, motion: &Motion, rate: &Function) -> Reads {
        let [y, y_dot] = [&motion.value, &motion.rate].map(|of| motion.of_independent(of));
        Reads::of(rate, [&y, &y_dot, &self.equations.x])
    }
}
