//! Curvature of the Lagrangian beyond the model of Gauss and Newton, segment by segment: the Lagrangian is a sum over the segments, and
//! each part depends on few variables (A. Griewank, P. L. Toint, Partitioned variable metric updates for large structured optimization
//! problems, Numer. Math. 39, 1982). The changes of all slopes over a step are stored, so that multipliers may change after it.

use std::collections::VecDeque;

use nalgebra::{DMatrix, DVector};

use super::values::Values;

/// Multipliers of equality and inequality constraints.
#[derive(Clone, Debug)]
pub(super) struct Multipliers {
    pub(super) equal: DVector<f64>,
    pub(super) within: DVector<f64>,
}

impl Multipliers {
    /// The largest one.
    pub(super) fn largest(&self) -> f64 {
        self.equal.amax().max(self.within.amax())
    }
}

/// The part of a segment.
#[derive(Clone, Debug)]
struct Part {
    /// The variables that it depends on.
    columns: Vec<usize>,
    /// Rows of squares, of equality and of inequality constraints.
    rows: [Vec<usize>; 3],
    /// Part of the Hessian beyond the products of first derivatives, in sizes of the variables.
    second: DMatrix<f64>,
    /// The last steps, the latest one at the end.
    secants: VecDeque<Secant>,
}

/// A step of a part, and the changes of the slopes over it; in sizes of the variables.
#[derive(Clone, Debug)]
struct Secant {
    step: DVector<f64>,
    /// Of squares, of equality and of inequality constraints.
    slopes: [DMatrix<f64>; 3],
    /// Of the rest of the cost.
    linear: DVector<f64>,
}

/// Steps that are remembered for each variable of a part.
const REMEMBERED: usize = 2;

/// The Hessian of the Lagrangian, as far as steps have determined it.
#[derive(Clone, Debug)]
pub(super) struct Curvature {
    parts: Vec<Part>,
    sizes: Vec<f64>,
}

/// Quadratic model of the cost in sizes of the variables, with half the squares of equality constraints times `weight`.
pub(super) struct Model {
    pub(super) hessian: DMatrix<f64>,
    pub(super) weight: f64,
    /// Products of the slopes of equality constraints.
    pub(super) squares: DMatrix<f64>,
}

/// Weights of equality constraints over the largest entry of the Hessian.
const WEIGHTS: [f64; 5] = [0.0, 0.1, 1.0, 10.0, 100.0];

/// A matrix of slopes in sizes of the variables.
fn scaled(of: &DMatrix<f64>, sizes: &[f64]) -> DMatrix<f64> {
    DMatrix::from_fn(of.nrows(), of.ncols(), |i, k| of[(i, k)] * sizes[k])
}

/// A step across the curvature is left out if its information is less than this fraction of the possible one (J. Nocedal, S. J. Wright,
/// Numerical Optimization, 2nd ed., 2006, 6.2).
const LEAST: f64 = 1e-8;

impl Curvature {
    /// No curvature is known.
    pub(super) fn new(values: &Values, sizes: &[f64]) -> Self {
        let part = |(segment, columns): (usize, &Vec<usize>)| Part {
            columns: columns.clone(),
            rows: values
                .owners
                .each_ref()
                .map(|owners| (0..owners.len()).filter(|row| owners[*row] == segment).collect()),
            second: DMatrix::zeros(columns.len(), columns.len()),
            secants: VecDeque::new(),
        };
        Self { parts: values.columns.iter().enumerate().map(part).collect(), sizes: sizes.to_vec() }
    }

    /// A convex model at a point. If the Hessian is not positive definite, squares of equality constraints are added, which change no step
    /// that satisfies them (M. J. D. Powell, 1969; G. Debreu, 1952); if that is not enough, parts lose their negative eigenvalues.
    pub(super) fn model(&self, values: &Values) -> Model {
        let equal_by = scaled(&values.equal_by, &self.sizes);
        let squares = equal_by.tr_mul(&equal_by);
        let hessian = self.assembled(values, false);
        let largest = hessian.amax();
        for weight in WEIGHTS.map(|weight| weight * largest) {
            let own = &hessian + weight * &squares;
            let shifted = &own + DMatrix::identity(own.nrows(), own.nrows()) * (1e-9 * own.amax());
            if shifted.cholesky().is_some() {
                return Model { hessian, weight, squares };
            }
        }
        Model { hessian: self.assembled(values, true), weight: 0.0, squares }
    }

    /// The sum over the parts, each convex or as it is.
    fn assembled(&self, values: &Values, are_convex: bool) -> DMatrix<f64> {
        let mut all = DMatrix::zeros(self.sizes.len(), self.sizes.len());
        for part in &self.parts {
            let own = part.scaled(&values.squares_by, &part.rows[0], &self.sizes);
            let mut own = 2.0 * own.tr_mul(&own) + &part.second;
            // Of what is no number the decomposition does not end.
            if are_convex && own.iter().all(|entry| entry.is_finite()) {
                let mut eigen = own.symmetric_eigen();
                eigen.eigenvalues.apply(|value| *value = value.max(0.0));
                own = eigen.recompose();
            }
            for (a, i) in part.columns.iter().enumerate() {
                for (b, k) in part.columns.iter().enumerate() {
                    all[(*i, *k)] += own[(a, b)];
                }
            }
        }
        all
    }

    /// Remembers the derivatives at both ends of a step.
    pub(super) fn remember(&mut self, from: &Values, to: &Values, step: &DVector<f64>) {
        for part in &mut self.parts {
            let along = part.columns.iter().map(|k| step[*k] / self.sizes[*k]);
            let change = |of: fn(&Values) -> &DMatrix<f64>, rows: usize| {
                let [to, from] =
                    [to, from].map(|values| part.scaled(of(values), &part.rows[rows], &self.sizes));
                to - from
            };
            let linear =
                part.columns.iter().map(|k| (to.linear_by[*k] - from.linear_by[*k]) * self.sizes[*k]);
            let secant = Secant {
                step: DVector::from_iterator(part.columns.len(), along),
                slopes: [
                    change(|of| &of.squares_by, 0),
                    change(|of| &of.equal_by, 1),
                    change(|of| &of.within_by, 2),
                ],
                linear: DVector::from_iterator(part.columns.len(), linear),
            };
            part.secants.push_back(secant);
            if part.secants.len() > REMEMBERED * part.columns.len() {
                part.secants.pop_front();
            }
        }
    }

    /// Makes the second derivatives of the remembered steps, by residuals and multipliers as they are: the symmetric update of rank one.
    pub(super) fn learn(&mut self, at: &Values, by: &Multipliers) {
        for part in &mut self.parts {
            let weights = |of: &DVector<f64>, rows: &[usize], factor: f64| {
                DVector::from_iterator(rows.len(), rows.iter().map(|row| factor * of[*row]))
            };
            let [squares, equal, within] = &part.rows;
            let weights = [
                weights(&at.squares, squares, 2.0),
                weights(&by.equal, equal, 1.0),
                weights(&by.within, within, 1.0),
            ];
            part.second.fill(0.0);
            for Secant { step, slopes, linear } in &part.secants {
                let slopes = slopes.iter().zip(&weights).map(|(slopes, weights)| slopes.tr_mul(weights));
                let miss = slopes.fold(linear - &part.second * step, |sum, own| sum + own);
                let along = miss.dot(step);
                if along.abs() > LEAST * miss.norm() * step.norm() {
                    part.second += &miss * miss.transpose() / along;
                }
            }
        }
    }
}

impl Part {
    /// Rows of a matrix in the own variables, in their sizes.
    fn scaled(&self, of: &DMatrix<f64>, rows: &[usize], sizes: &[f64]) -> DMatrix<f64> {
        DMatrix::from_fn(rows.len(), self.columns.len(), |i, k| {
            of[(rows[i], self.columns[k])] * sizes[self.columns[k]]
        })
    }
}
