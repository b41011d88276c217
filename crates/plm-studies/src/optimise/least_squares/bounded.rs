//! The damped step within bounds.
//!
//! It makes a convex quadratic function of the step least whose only inequalities are bounds. Which of them hold is found by block
//! principal pivoting (J. J. Júdice, F. M. Pires, A block principal pivoting algorithm for large-scale strictly monotone linear
//! complementarity problems, Computers & Operations Research 21, 1994): all components on a wrong side change it at once, and one by one
//! where that does not make them fewer.

use nalgebra::{DMatrix, DVector};

use super::Evaluation;

/// Position of a component of a step with respect to its bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// Between its bounds.
    Free,
    /// At its least value.
    Least,
    /// At its largest value.
    Most,
}

/// The quadratic function of a step: squares and constraints at a point, with damping.
pub(super) struct Model<'a> {
    pub(super) at: &'a Evaluation,
    /// Scales: a variable is the scaled one over its width.
    pub(super) widths: &'a DVector<f64>,
    pub(super) damping: f64,
    /// Least and largest component of a step.
    pub(super) bounds: &'a [[f64; 2]],
}

/// A step from a point.
pub(super) struct Step {
    pub(super) d: DVector<f64>,
    pub(super) multipliers: DVector<f64>,
    pub(super) sides: Vec<Side>,
}

/// Regularises constraints that depend on each other.
const REGULARISATION: f64 = 1e-14;
/// So often all sides change at once without becoming fewer wrong ones.
const BLOCKS: usize = 10;
/// A slope below this part of the largest that it can have is rounding.
const ROUNDING: f64 = 1e-14;

impl Model<'_> {
    /// The step within the bounds; none where the equations have no solution.
    pub(super) fn step(&self) -> Option<Step> {
        let size = self.bounds.len();
        let slopes = self.at.jacobian.tr_mul(&self.at.residuals);
        let mut sides: Vec<Side> = (0..size).map(|i| self.first_side(i, slopes[i])).collect();
        let (mut fewest, mut blocks) = (usize::MAX, BLOCKS);
        let mut last = None;
        for _ in 0..BLOCKS * (size + 2) {
            let (d, multipliers) = self.solve(&sides)?;
            let slopes = self.slopes(&d, &multipliers);
            let other = |i: usize| self.other_side(i, sides[i], (d[i], slopes[i])).map(|side| (i, side));
            let wrong: Vec<(usize, Side)> = (0..size).filter_map(other).collect();
            last = Some((d, multipliers, sides.clone()));
            let Some(one) = wrong.last().copied() else { break };
            blocks = if wrong.len() < fewest { BLOCKS } else { blocks.saturating_sub(1) };
            fewest = fewest.min(wrong.len());
            let changed = if blocks > 0 { wrong } else { vec![one] };
            for (i, side) in changed {
                sides[i] = side;
            }
        }
        // Where constraints leave no side right the nearest step within the bounds is tried.
        let (d, multipliers, sides) = last?;
        let d = DVector::from_fn(size, |i, _| d[i].max(self.bounds[i][0]).min(self.bounds[i][1]));
        Some(Step { d, multipliers, sides })
    }

    /// A component at a bound stays there first if its slope points out of it.
    fn first_side(&self, i: usize, slope: f64) -> Side {
        let [least, most] = self.bounds[i];
        if least == 0.0 && slope >= 0.0 {
            Side::Least
        } else if most == 0.0 && slope <= 0.0 {
            Side::Most
        } else {
            Side::Free
        }
    }

    /// The side that a component is to be on, if it is on a wrong one.
    fn other_side(&self, i: usize, side: Side, (d, slope): (f64, f64)) -> Option<Side> {
        let [least, most] = self.bounds[i];
        let inward = ROUNDING * self.widths[i] * self.at.residuals.norm();
        match side {
            Side::Free if d < least => Some(Side::Least),
            Side::Free if d > most => Some(Side::Most),
            // A variable with equal bounds is fixed, for every slope.
            Side::Least | Side::Most if least == most => None,
            Side::Least if slope < -inward => Some(Side::Free),
            Side::Most if slope > inward => Some(Side::Free),
            _ => None,
        }
    }

    /// Slopes of the function at a step.
    fn slopes(&self, d: &DVector<f64>, multipliers: &DVector<f64>) -> DVector<f64> {
        let Evaluation { residuals, jacobian, constraints_by, .. } = self.at;
        let mut slopes = jacobian.tr_mul(&(residuals + jacobian * d)) + constraints_by.tr_mul(multipliers);
        for i in 0..d.len() {
            slopes[i] += self.damping * self.widths[i] * self.widths[i] * d[i];
        }
        slopes
    }

    /// The damped equations of the components that are free, in scaled variables; with the multipliers of the constraints.
    fn solve(&self, sides: &[Side]) -> Option<(DVector<f64>, DVector<f64>)> {
        let Evaluation { residuals, jacobian, constraints, constraints_by } = self.at;
        let held = DVector::from_fn(sides.len(), |i, _| match sides[i] {
            Side::Free => 0.0,
            Side::Least => self.bounds[i][0],
            Side::Most => self.bounds[i][1],
        });
        let free: Vec<usize> = (0..sides.len()).filter(|i| sides[*i] == Side::Free).collect();
        let (n, rows) = (free.len(), constraints.len());
        if n == 0 {
            return Some((held, DVector::zeros(rows)));
        }
        let residuals = residuals + jacobian * &held;
        let open = constraints + constraints_by * &held;
        let column = |matrix: &DMatrix<f64>| {
            DMatrix::from_fn(matrix.nrows(), n, |i, k| matrix[(i, free[k])] / self.widths[free[k]])
        };
        let (jacobian, constraints_by) = (column(jacobian), column(constraints_by));
        // In these variables the normal equations have the size of 1, and the rows are made so.
        let sizes = DVector::from_fn(rows, |i, _| constraints_by.row(i).norm().max(f64::MIN_POSITIVE));
        let mut matrix = DMatrix::zeros(n + rows, n + rows);
        matrix.view_mut((0, 0), (n, n)).copy_from(&jacobian.tr_mul(&jacobian));
        for i in 0..n {
            matrix[(i, i)] += self.damping;
        }
        for i in 0..rows {
            for k in 0..n {
                let entry = constraints_by[(i, k)] / sizes[i];
                matrix[(n + i, k)] = entry;
                matrix[(k, n + i)] = entry;
            }
            matrix[(n + i, n + i)] = -REGULARISATION;
        }
        let mut right = DVector::zeros(n + rows);
        right.rows_mut(0, n).copy_from(&-jacobian.tr_mul(&residuals));
        for i in 0..rows {
            right[n + i] = -open[i] / sizes[i];
        }
        let solution =
            if rows == 0 { matrix.cholesky()?.solve(&right) } else { matrix.lu().solve(&right)? };
        let mut d = held;
        for (k, i) in free.iter().enumerate() {
            d[*i] = solution[k] / self.widths[*i];
        }
        let multipliers = DVector::from_fn(rows, |i, _| solution[n + i] / sizes[i]);
        d.iter().all(|d| d.is_finite()).then_some((d, multipliers))
    }
}
