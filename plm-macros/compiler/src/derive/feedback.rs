//! Forces that read accelerations and reactions, the unknowns of the equations of motion.
//!
//! Each unknown that is read is a signal. Where the forces are affine in the signals, `Q = Q_0 + sum_j G_j s_j`, the
//! signals enter the linear system that gives the unknowns, and the solution is exact.

use crate::collect::CollectVec;
use plm_cas::{Expr, algebra};

use super::{SparseRow, forcing_terms};
use crate::model::Model;

/// An unknown that forces read.
#[derive(Clone)]
pub(crate) struct Signal {
    /// The symbol of the unknown.
    pub(crate) symbol: Expr,
    /// Derivative of `Q` by the unknown: (coordinate, gain).
    pub(crate) gain: SparseRow,
}

/// Takes the signals out of the applied forces: `G_j = dQ/ds_j`, and `force` becomes `Q_0`, which is `Q` at `s = 0`.
pub(super) fn signals(model: &Model, force: &mut [Expr]) -> Vec<Signal> {
    let held = algebra::symbols(force).into_iter();
    let symbols: Vec<Expr> = held.filter(|held| unknowns(model).any(|symbol| symbol == *held)).collect_vec();
    let gain = |symbol: Expr| -> SparseRow {
        let entries: Vec<Expr> = force.iter().map(|of| of.diff(symbol)).collect_vec();
        entries.into_iter().enumerate().filter(|(_, entry)| !entry.is_zero()).collect_vec()
    };
    let signals = symbols.iter().map(|&symbol| Signal { symbol, gain: gain(symbol) }).collect_vec();
    let without: Vec<(Expr, Expr)> = symbols.into_iter().map(|symbol| (symbol, Expr::ZERO)).collect_vec();
    if !without.is_empty() {
        force.copy_from_slice(&algebra::substitute(force, &without));
    }
    signals
}

/// Does a force or a rate read an acceleration or a reaction?
pub(crate) fn feeds_back(model: &Model) -> bool {
    let roots: Vec<Expr> = forcing_terms(model).map(|term| term.value).collect_vec();
    let held = algebra::symbols(&roots);
    unknowns(model).any(|symbol| held.contains(&symbol))
}

/// Symbols of the accelerations and multipliers.
fn unknowns(model: &Model) -> impl Iterator<Item = Expr> {
    let accelerations = model.bodies.iter().flat_map(|body| body.a);
    accelerations.chain(model.rows.iter().map(|row| row.lambda))
}
