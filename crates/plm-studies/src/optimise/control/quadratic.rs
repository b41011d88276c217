//! Quadratic program of a step, by the interior-point method of Clarabel (P. J. Goulart, Y. Chen, Clarabel: an interior-point solver for
//! conic programs with quadratic objectives, 2024).

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT};
use nalgebra::{DMatrix, DVector};

use super::curvature::{Model, Multipliers};
use super::values::Values;
use crate::optimise::error::Error;

/// A step, and the multipliers of the constraints.
pub(super) struct Step {
    pub(super) d: DVector<f64>,
    pub(super) multipliers: Multipliers,
}

/// Rows of a sparse matrix by columns, and its right-hand side.
struct Inequalities {
    /// Row and entry of each column.
    columns: Vec<Vec<(usize, f64)>>,
    right: Vec<f64>,
}

impl Inequalities {
    fn push(&mut self, entries: impl Iterator<Item = (usize, f64)>, right: f64) {
        let row = self.right.len();
        for (column, entry) in entries.filter(|(_, entry)| *entry != 0.0) {
            self.columns[column].push((row, entry));
        }
        self.right.push(right);
    }
}

/// The step within `boxes` that makes the model of cost and of `weight` times the sum of violations least (R. Fletcher, Practical
/// Methods of Optimization, 2nd ed., 1987, 14.4).
///
/// # Errors
/// [`Error::Quadratic`].
pub(super) fn step(
    (values, model): (&Values, &Model),
    boxes: &[[f64; 2]],
    sizes: &[f64],
    weight: f64,
) -> Result<Step, Error> {
    let Values { squares, squares_by, linear_by, equal, equal_by, within, within_by, limits, .. } = values;
    let n = boxes.len();
    let slacks = equal.len() + within.len();
    let mut rows = Inequalities { columns: vec![Vec::new(); n + slacks], right: Vec::new() };
    let entries = |matrix: &DMatrix<f64>, row: usize, sign: f64, slack: usize| {
        let own: Vec<(usize, f64)> = (0..n).map(|k| (k, sign * matrix[(row, k)] * sizes[k])).collect();
        own.into_iter().chain([(n + slack, -1.0)])
    };
    for row in 0..equal.len() {
        rows.push(entries(equal_by, row, 1.0, row), -equal[row]);
        rows.push(entries(equal_by, row, -1.0, row), equal[row]);
    }
    // Rows of each bound, with the sign of its multiplier.
    let mut bounds: Vec<Vec<(usize, f64)>> = vec![Vec::new(); within.len()];
    for row in 0..within.len() {
        let slack = equal.len() + row;
        let [least, most] = limits[row];
        if most.is_finite() {
            bounds[row].push((rows.right.len(), 1.0));
            rows.push(entries(within_by, row, 1.0, slack), most - within[row]);
        }
        if least.is_finite() {
            bounds[row].push((rows.right.len(), -1.0));
            rows.push(entries(within_by, row, -1.0, slack), within[row] - least);
        }
        rows.push([(n + slack, -1.0)].into_iter(), 0.0);
    }
    for (k, [least, most]) in boxes.iter().enumerate() {
        rows.push([(k, 1.0)].into_iter(), most / sizes[k]);
        rows.push([(k, -1.0)].into_iter(), -least / sizes[k]);
    }
    let gradient = 2.0 * squares_by.tr_mul(squares) + linear_by + model.weight * equal_by.tr_mul(equal);
    let mut cost: Vec<f64> = (0..n).map(|k| gradient[k] * sizes[k]).collect();
    cost.resize(n + slacks, weight);
    let (x, duals) =
        solve(&upper(&(&model.hessian + model.weight * &model.squares), n + slacks), &cost, rows)?;
    let multipliers = Multipliers {
        equal: DVector::from_fn(equal.len(), |row, _| duals[2 * row] - duals[2 * row + 1]),
        within: DVector::from_iterator(
            within.len(),
            bounds.iter().map(|rows| rows.iter().map(|(row, sign)| sign * duals[*row]).sum()),
        ),
    };
    let d = DVector::from_fn(n, |k, _| (x[k] * sizes[k]).max(boxes[k][0]).min(boxes[k][1]));
    Ok(Step { d, multipliers })
}

/// The upper triangle of the Hessian.
fn upper(of: &DMatrix<f64>, size: usize) -> CscMatrix<f64> {
    let column = |k: usize| {
        (0..=k).filter(move |i| k < of.ncols() && of[(*i, k)] != 0.0).map(move |i| (i, of[(i, k)]))
    };
    csc(size, (0..size).map(|k| column(k).collect()).collect())
}

fn csc(rows: usize, columns: Vec<Vec<(usize, f64)>>) -> CscMatrix<f64> {
    let count = columns.len();
    let (mut starts, mut indices, mut entries) = (vec![0], Vec::new(), Vec::new());
    for column in columns {
        for (row, entry) in column {
            indices.push(row);
            entries.push(entry);
        }
        starts.push(indices.len());
    }
    CscMatrix::new(rows, count, starts, indices, entries)
}

fn solve(hessian: &CscMatrix<f64>, cost: &[f64], rows: Inequalities) -> Result<(Vec<f64>, Vec<f64>), Error> {
    let count = rows.right.len();
    let matrix = csc(count, rows.columns);
    let settings = DefaultSettings {
        verbose: false,
        tol_gap_abs: 1e-12,
        tol_gap_rel: 1e-12,
        tol_feas: 1e-12,
        ..DefaultSettings::default()
    };
    let cones = [SupportedConeT::NonnegativeConeT(count)];
    let failed = |why: String| Error::Quadratic(why);
    let mut solver = DefaultSolver::new(hessian, cost, &matrix, &rows.right, &cones, settings)
        .map_err(|error| failed(error.to_string()))?;
    solver.solve();
    match solver.solution.status {
        SolverStatus::Solved | SolverStatus::AlmostSolved | SolverStatus::InsufficientProgress => {
            Ok((solver.solution.x.clone(), solver.solution.z.clone()))
        }
        status => Err(failed(format!("{status:?}"))),
    }
}
