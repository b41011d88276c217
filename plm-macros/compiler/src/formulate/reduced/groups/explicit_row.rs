//! A row that is explicit in one unknown: it gives that one as a function of others.

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, Rotation, Vec2, algebra};

use crate::formulate::reduced::joints::coordinates::{Coordinates, Unknown};
use crate::formulate::reduced::motion::Motion;

/// A row that is solved for one unknown.
#[derive(Clone, Copy)]
pub(crate) struct ExplicitRow {
    /// Place of the row in [`Coordinates::rows`].
    pub(crate) row: usize,
    pub(crate) unknown: usize,
}

impl ExplicitRow {
    /// If the row can be solved for the unknown.
    pub(crate) fn of(coordinates: &Coordinates, row: usize, unknown: usize) -> Option<ExplicitRow> {
        coordinates.rows[row].coefficient(unknown).map(|_| ExplicitRow { row, unknown })
    }

    /// The derivatives of the row by the unknowns that it holds.
    pub(crate) fn slopes(&self, motion: &Motion) -> Vec<(usize, Expr)> {
        let row = &motion.coordinates.rows[self.row];
        let slopes: Vec<Expr> = row.held.iter().map(|&(_, symbol)| row.phi.diff(symbol)).collect_vec();
        let slopes = algebra::substitute(&slopes, &known(motion, &row.held));
        row.held.iter().map(|held| held.0).zip(slopes).collect_vec()
    }

    /// Writes the unknown, its coefficients and rate into `motion`.
    pub(crate) fn solve(&self, motion: &mut Motion) {
        let row = &motion.coordinates.rows[self.row];
        let Some(own) = row.coefficient(self.unknown) else { return };
        let others = row.held.iter().copied().filter(|(of, _)| *of != self.unknown);
        let others: Vec<(usize, Expr)> = others.collect_vec();
        let symbol = row.held.iter().find(|(of, _)| *of == self.unknown);
        let symbol = symbol.map_or(motion.time, |found| found.1);
        let rest = algebra::substitute(&[row.phi], &[(symbol, Expr::ZERO)])[0];
        let slopes: Vec<Expr> = others.iter().map(|&(_, symbol)| rest.diff(symbol)).collect_vec();
        // Along the motion, but for the second derivatives of the other unknowns.
        let rates = others.iter().map(|&(of, _)| Expr::symbol(format!("u_rate_{of}")));
        let rates: Vec<Expr> = rates.collect_vec();
        let mut flow: Vec<(Expr, Expr)> =
            others.iter().zip(&rates).map(|(&(_, symbol), &rate)| (symbol, rate)).collect_vec();
        flow.push((motion.time, Expr::ONE));
        let rate = rest.directional(&flow);
        let curvature = rate.directional(&flow);
        let by_time = rest.diff(motion.time);

        let mut pairs = known(motion, &others);
        pairs.push_all(others.iter().zip(&rates).map(|(&(of, _), &rate)| (rate, motion.rate_over_pace(of))));
        let mut roots = vec![rest, by_time, curvature];
        roots.extend(&slopes);
        let roots = algebra::substitute(&roots, &pairs);
        let (&[rest, by_time, curvature], slopes) = roots.split_at(3) else { return };
        // `c u + rest = 0`, and its derivatives.
        let solved = |start: Expr, of: &dyn Fn(usize) -> Expr| {
            let carried = others.iter().zip(slopes).map(|(&(other, _), &slope)| slope * of(other));
            let sum: Expr = [start].into_iter().chain(carried).sum();
            -sum / own
        };
        let value = -rest / own;
        let time_rate = solved(by_time, &|other| motion.time_rate[other]);
        let bias = solved(curvature, &|other| motion.bias[other]);
        for coordinate in 0..motion.independent.len() {
            let coefficient = solved(Expr::ZERO, &|other| motion.coefficient[other][coordinate]);
            motion.coefficient[self.unknown][coordinate] = coefficient;
        }
        let value = motion.set_value(self.unknown, value);
        (motion.time_rate[self.unknown], motion.bias[self.unknown]) = (time_rate, bias);
        if let Unknown::Angle { orientation, .. } = motion.coordinates.unknowns[self.unknown] {
            motion.rotation[orientation] = Rotation::by(value);
        }
        motion.set_rate(self.unknown);
    }
}

/// Values for the symbols of unknowns that are known.
fn known(motion: &Motion, others: &[(usize, Expr)]) -> Vec<(Expr, Expr)> {
    let mut pairs = Vec::new();
    for &(unknown, symbol) in others {
        if let Unknown::Angle { orientation, .. } = motion.coordinates.unknowns[unknown] {
            let axis = motion.turned(orientation, Vec2::X);
            pairs.push_all([(symbol.cos(), axis.x), (symbol.sin(), axis.y)]);
        }
        pairs.push((symbol, motion.value[unknown]));
    }
    pairs
}
