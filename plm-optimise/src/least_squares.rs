//! Nonlinear least squares with bounds and equality constraints.
//!
//! The method is that of Levenberg and Marquardt with the scaling by J. J. Moré (The Levenberg-Marquardt algorithm: implementation and
//! theory, Lecture Notes in Mathematics 630, 1978) and the damping by H. B. Nielsen (Damping parameter in Marquardt's method, IMM-REP-1999-05,
//! Technical University of Denmark). A component that a step would take over its bound is held there while the others are solved for anew.
//! Constraints enter the damped normal equations with multipliers, and the merit function by their sum (H. G. Bock, Recent advances in
//! parameter identification techniques for O.D.E., 1983; J. Nocedal, S. J. Wright, Numerical Optimization, 2nd ed., 2006, 18.3).

use nalgebra::{DMatrix, DVector};
use plm_runtime::Fault;

/// Residuals and constraints at a point, with their derivatives by rows.
#[derive(Clone, Debug)]
pub(crate) struct Evaluation {
    pub(crate) residuals: DVector<f64>,
    pub(crate) jacobian: DMatrix<f64>,
    /// What must vanish.
    pub(crate) constraints: DVector<f64>,
    pub(crate) constraints_by: DMatrix<f64>,
}

/// A function to be made small, with the bounds of its variables.
pub(crate) trait Problem {
    /// Residuals, constraints and their derivatives.
    fn evaluate(&mut self, z: &DVector<f64>) -> Result<Evaluation, Fault>;
    /// Least and largest value of a variable.
    fn bounds(&self, variable: usize) -> [f64; 2];
    /// Typical size of a variable.
    fn scale(&self, variable: usize) -> f64;
    /// Is the search to end where it is?
    fn is_stopped(&self) -> bool;
}

/// When to stop.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    pub(crate) iterations: usize,
    /// Steps, relative to the variables and their typical sizes.
    pub(crate) step: f64,
    /// Largest cosine of the angle between the residuals and a column of the Jacobian.
    pub(crate) cosine: f64,
    /// Constraints, absolute.
    pub(crate) constraint: f64,
    /// First damping, as a fraction of the scaled normal equations.
    pub(crate) damping: f64,
}

/// How the search has ended.
#[derive(Clone, Debug)]
pub(crate) enum End {
    /// At a minimum.
    Converged,
    /// After so many iterations.
    Iterations,
    /// The problem has stopped it.
    Stopped,
    /// No step is shorter than the last one that was tried and makes the residuals smaller.
    NoDescent,
    /// Every further step has ended with such a fault.
    Faults(Fault),
}

/// Where the search has ended.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    pub(crate) z: DVector<f64>,
    pub(crate) at: Evaluation,
    pub(crate) end: End,
    pub(crate) iterations: usize,
}

/// First damping far from a minimum.
pub(crate) const FIRST_DAMPING: f64 = 1e-3;
/// First damping near a minimum.
pub(crate) const FIRST_DAMPING_NEAR: f64 = 1e-8;
/// Damping at which a step is below every rounding.
const LARGEST_DAMPING: f64 = 1e20;

/// Damping beyond which steps with constraints are the shortest ones to these.
const LARGEST_WITH_CONSTRAINTS: f64 = 1e3;
/// Regularises constraints that depend on each other.
const REGULARISATION: f64 = 1e-14;

/// Minimises half the sum of squares of the residuals, from a point within the bounds.
///
/// # Errors
/// The fault at that point.
pub(crate) fn minimise(
    problem: &mut impl Problem,
    start: &DVector<f64>,
    limits: &Limits,
) -> Result<Found, Fault> {
    let mut search = Search::new(problem, start, limits.damping)?;
    let end = loop {
        if search.iterations == limits.iterations {
            break End::Iterations;
        }
        if problem.is_stopped() {
            break End::Stopped;
        }
        search.iterations += 1;
        if let Some(end) = search.iterate(problem, limits) {
            break end;
        }
    };
    let Search { z, at, iterations, .. } = search;
    Ok(Found { z, at, end, iterations })
}

/// A problem whose constraints are residuals of this weight.
struct Relaxed<'a, P> {
    problem: &'a mut P,
    weight: f64,
}

impl<P: Problem> Problem for Relaxed<'_, P> {
    fn evaluate(&mut self, z: &DVector<f64>) -> Result<Evaluation, Fault> {
        let Evaluation { residuals, jacobian, constraints, constraints_by } = self.problem.evaluate(z)?;
        let (rows, open) = (residuals.len(), constraints.len());
        let mut all = residuals.resize_vertically(rows + open, 0.0);
        all.rows_mut(rows, open).copy_from(&(constraints * self.weight));
        let mut by = jacobian.resize_vertically(rows + open, 0.0);
        by.rows_mut(rows, open).copy_from(&(constraints_by * self.weight));
        let none = DMatrix::zeros(0, z.len());
        Ok(Evaluation { residuals: all, jacobian: by, constraints: DVector::zeros(0), constraints_by: none })
    }

    fn bounds(&self, variable: usize) -> [f64; 2] {
        self.problem.bounds(variable)
    }

    fn scale(&self, variable: usize) -> f64 {
        self.problem.scale(variable)
    }

    fn is_stopped(&self) -> bool {
        self.problem.is_stopped()
    }
}

/// A point near the minimum with constraints, from one that is far from these: they are residuals whose weight grows (Nocedal and Wright,
/// 17.1).
///
/// # Errors
/// The fault at the first point.
pub(crate) fn approach(problem: &mut impl Problem, start: &DVector<f64>) -> Result<DVector<f64>, Fault> {
    let mut limits =
        Limits { iterations: 60, step: 1e-4, cosine: 1e-4, constraint: 0.0, damping: FIRST_DAMPING };
    let mut z = start.clone();
    for weight in [1e-2, 1.0, 1e2] {
        z = minimise(&mut Relaxed { problem, weight }, &z, &limits)?.z;
        limits.damping = FIRST_DAMPING_NEAR;
    }
    Ok(z)
}

/// State of the search.
struct Search {
    z: DVector<f64>,
    at: Evaluation,
    /// Largest norm so far of each column of the Jacobian.
    widths: DVector<f64>,
    damping: f64,
    growth: f64,
    /// Share of a step that is made where there are constraints.
    share: f64,
    /// Weight of the constraints in the merit function.
    weight: f64,
    iterations: usize,
}

/// A step from a point.
struct Step {
    d: DVector<f64>,
    multipliers: DVector<f64>,
    /// Components that are held at a bound.
    held: Vec<bool>,
}

impl Search {
    fn new(problem: &mut impl Problem, start: &DVector<f64>, damping: f64) -> Result<Self, Fault> {
        let z = DVector::from_fn(start.len(), |i, _| {
            let [least, most] = problem.bounds(i);
            start[i].max(least).min(most)
        });
        let at = problem.evaluate(&z)?;
        let widths = DVector::zeros(z.len());
        Ok(Self { z, at, widths, damping, growth: 2.0, share: 1.0, weight: 0.0, iterations: 0 })
    }

    /// Makes one step that is better, by trying ever shorter ones; says when the search ends.
    fn iterate(&mut self, problem: &mut impl Problem, limits: &Limits) -> Option<End> {
        for (i, column) in self.at.jacobian.column_iter().enumerate() {
            // A column that vanishes leaves the damping to the size of its variable.
            let floor = f64::MIN_POSITIVE.max(1e-12 * self.at.residuals.norm()) / problem.scale(i);
            self.widths[i] = self.widths[i].max(column.norm()).max(floor);
        }
        let mut fault = None;
        loop {
            let Some(mut step) = self.step(problem) else { return Some(End::NoDescent) };
            let short = self.is_short(problem, &step.d, limits.step);
            if self.is_stationary(&step, limits) || (short && fault.is_none() && self.is_feasible(limits)) {
                return Some(End::Converged);
            }
            step.d *= self.share;
            if self.is_short(problem, &step.d, limits.step) || self.damping > LARGEST_DAMPING {
                return Some(fault.map_or(End::NoDescent, End::Faults));
            }
            let predicted = self.predicted(&step);
            let trial = &self.z + &step.d;
            match problem.evaluate(&trial) {
                Ok(next) => {
                    fault = None;
                    let gain = (self.merit(&self.at) - self.merit(&next)) / predicted;
                    if gain > 1e-4 && predicted > 0.0 {
                        self.accept(trial, next, gain);
                        return None;
                    }
                }
                Err(why) => fault = Some(why),
            }
            self.damping *= self.growth;
            self.growth *= 2.0;
            if !self.at.constraints.is_empty() {
                // The constraints decide a step whatever the damping is: a part of it descends.
                self.share *= 0.5;
                self.damping = self.damping.min(LARGEST_WITH_CONSTRAINTS);
            }
        }
    }

    fn accept(&mut self, z: DVector<f64>, at: Evaluation, gain: f64) {
        (self.z, self.at) = (z, at);
        self.damping = (self.damping * (1.0 - (2.0 * gain - 1.0).powi(3)).max(1.0 / 3.0)).max(1e-15);
        self.growth = 2.0;
        self.share = (2.0 * self.share).min(1.0);
    }

    fn merit(&self, at: &Evaluation) -> f64 {
        0.5 * at.residuals.norm_squared() + self.weight * at.constraints.lp_norm(1)
    }

    /// By how much a step makes the merit function smaller, to first order of what it is made of. The weight is larger than every
    /// multiplier, so that the step descends (Nocedal and Wright, 18.3).
    fn predicted(&mut self, step: &Step) -> f64 {
        let Evaluation { residuals, jacobian, constraints, constraints_by } = &self.at;
        let squares = 0.5 * (residuals.norm_squared() - (residuals + jacobian * &step.d).norm_squared());
        if constraints.is_empty() {
            return squares;
        }
        let least = 1.1 * step.multipliers.amax();
        self.weight = least.max(0.5 * (self.weight + least));
        let open = constraints.lp_norm(1) - (constraints + constraints_by * &step.d).lp_norm(1);
        squares + self.weight * open
    }

    fn is_feasible(&self, limits: &Limits) -> bool {
        self.at.constraints.iter().all(|open| open.abs() <= limits.constraint)
    }

    fn is_short(&self, problem: &impl Problem, d: &DVector<f64>, limit: f64) -> bool {
        d.iter().enumerate().all(|(i, d)| d.abs() <= limit * (self.z[i].abs() + problem.scale(i)))
    }

    /// Are the residuals at right angles to every column that is not held at a bound?
    fn is_stationary(&self, step: &Step, limits: &Limits) -> bool {
        let Evaluation { residuals, jacobian, constraints_by, .. } = &self.at;
        let gradient = jacobian.tr_mul(residuals) + constraints_by.tr_mul(&step.multipliers);
        let size = residuals.norm();
        let cosine = |i: usize| gradient[i].abs() <= limits.cosine * self.widths[i] * size;
        self.is_feasible(limits) && (0..self.z.len()).all(|i| step.held[i] || cosine(i))
    }

    /// The step within the bounds; none where the equations have no solution.
    fn step(&self, problem: &impl Problem) -> Option<Step> {
        let size = self.z.len();
        let mut fixed = DVector::from_element(size, f64::NAN);
        // Each round holds at least one more component.
        for _ in 0..=size {
            let (d, multipliers) = self.solve(&fixed)?;
            let mut is_within = true;
            for i in (0..size).filter(|i| fixed[*i].is_nan()).collect::<Vec<_>>() {
                let [least, most] = problem.bounds(i);
                let inside = (self.z[i] + d[i]).max(least).min(most);
                if inside != self.z[i] + d[i] {
                    fixed[i] = inside - self.z[i];
                    is_within = false;
                }
            }
            if is_within {
                let held = fixed.iter().map(|fixed| !fixed.is_nan()).collect();
                return Some(Step { d, multipliers, held });
            }
        }
        None
    }

    /// The damped equations with the components of `fixed` that are numbers, in scaled variables.
    fn solve(&self, fixed: &DVector<f64>) -> Option<(DVector<f64>, DVector<f64>)> {
        let Evaluation { residuals, jacobian, constraints, constraints_by } = &self.at;
        let held = fixed.map(|fixed| if fixed.is_nan() { 0.0 } else { fixed });
        let free: Vec<usize> = (0..fixed.len()).filter(|i| fixed[*i].is_nan()).collect();
        let (n, rows) = (free.len(), constraints.len());
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
