//! Symbols that the expressions of every mechanism hold, and their total derivatives with respect to time.

use crate::collect::CollectVec;
use crate::sorted::SortedMap;

use plm_cas::{Expr, algebra};

/// Symbols, and how they change with time: `dq/dt = v`, `dv/dt = a`, `dt/dt = 1`, `dx/dt` of a state a symbol that stands for its
/// rate until all rates are known. All others rest.
pub(super) struct Calculus {
    /// The time, s.
    pub(super) time: Expr,
    /// As in [`Model::most_growth`](crate::model::Model::most_growth).
    pub(super) most_growth: Expr,
    /// As in [`Model::agreement`](crate::model::Model::agreement).
    pub(super) agreement: Expr,
    /// As in [`Model::precision`](crate::model::Model::precision).
    pub(super) precision: Expr,
    /// The inputs of the mechanism. They are held over a step: no rate of theirs is known.
    pub(super) held: Vec<Expr>,
    /// Symbols that change, with their derivatives.
    rates: SortedMap<Expr, Expr>,
    /// Derivatives of expressions that have been asked for.
    known: SortedMap<Expr, Expr>,
}

impl Calculus {
    pub(super) fn new() -> Calculus {
        let time = Expr::symbol("t");
        Calculus {
            time,
            most_growth: Expr::symbol("most_growth"),
            agreement: Expr::symbol("agreement"),
            precision: Expr::symbol("precision"),
            held: Vec::new(),
            rates: [(time, Expr::ONE)].into_iter().collect(),
            known: SortedMap::new(),
        }
    }

    /// A symbol changes with time at a rate.
    pub(super) fn changes(&mut self, symbol: Expr, rate: Expr) {
        self.rates.insert(symbol, rate);
    }

    /// `de/dt`, the sum of `de/ds ds/dt` over all symbols `s` that change.
    pub(super) fn total_derivative(&mut self, expr: Expr) -> Expr {
        if let Some(known) = self.known.get(&expr) {
            return *known;
        }
        let symbols = algebra::symbols(&[expr]).into_iter();
        let along: Vec<(Expr, Expr)> =
            symbols.filter_map(|symbol| Some((symbol, *self.rates.get(&symbol)?))).collect_vec();
        let derivative = expr.directional(&along);
        self.known.insert(expr, derivative);
        derivative
    }
    /// The derivative of an order, `e` itself of order 0.
    pub(super) fn derivative(&mut self, expr: Expr, order: u8) -> Expr {
        (0..order).fold(expr, |derivative, _| self.total_derivative(derivative))
    }
}
