//! Nonlinear least squares with bounds and equality constraints.
//!
//! The method is that of Levenberg and Marquardt with the scaling by J. J. Moré (The Levenberg-Marquardt algorithm: implementation and
//! theory, Lecture Notes in Mathematics 630, 1978) and the damping by H. B. Nielsen (Damping parameter in Marquardt's method, IMM-REP-1999-05,
//! Technical University of Denmark). A step ends within the bounds, where the damped squares are least ([`bounded`]); the search ends at a
//! bound only where the residuals rise from it inwards.
//! Constraints enter the damped normal equations with multipliers, and the merit function by their sum (H. G. Bock, Recent advances in
//! parameter identification techniques for O.D.E., 1983; J. Nocedal, S. J. Wright, Numerical Optimization, 2nd ed., 2006, 18.3).

mod bounded;

use nalgebra::{DMatrix, DVector};
use plm_runtime::Fault;

use self::bounded::{Model, Side, Step};

/// Residuals and constraints at a point, with their derivatives by rows.
#[derive(Clone, Debug)]
pub(crate) struct Evaluation {
    pub(crate) residuals: DVector<f64>,
    pub(crate) jacobian: DMatrix<f64>,
    /// Values of equality constraints.
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
    /// The search has come to a point by so many iterations.
    fn reached(&self, _iterations: usize, _z: &DVector<f64>, _at: &Evaluation) {}
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
    NoDescent(Left),
    /// Every further step has ended with such a fault.
    Faults(Fault),
}

/// Model and noise of the last point, from which no step makes the residuals smaller.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Left {
    /// By how much a step without damping would make half the sum of squares smaller, were the residuals linear.
    pub(crate) promised: f64,
    /// How far the residuals of the shortest step that was tried are from their linear model: their noise, or a jump.
    pub(crate) noise: f64,
}

/// Result of the search.
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
/// Damping with which a short step says that a minimum is near, rather than that the damping is strong.
const WEAK_DAMPING: f64 = 1.0;
/// Damping that keeps equations solvable and leaves a step as it is.
const NO_DAMPING: f64 = 1e-15;

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
        problem.reached(search.iterations, &search.z, &search.at);
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
        self.widen(problem);
        let (mut fault, mut noise) = (None, None);
        loop {
            let Some(mut step) = self.step(problem, self.damping) else {
                return Some(self.without_descent(problem, noise));
            };
            // A trial that is refused makes the next step shorter, which says nothing of a minimum.
            let is_first = fault.is_none() && noise.is_none() && self.damping <= WEAK_DAMPING;
            let is_short = is_first && self.is_short(problem, &step.d, limits.step);
            if self.is_stationary(problem, &step, limits) || (is_short && self.is_feasible(limits)) {
                return Some(End::Converged);
            }
            step.d *= self.share;
            if self.is_short(problem, &step.d, limits.step) || self.damping > LARGEST_DAMPING {
                return Some(fault.map_or_else(|| self.without_descent(problem, noise), End::Faults));
            }
            let predicted = self.predicted(&step);
            let trial = self.trial(problem, &step);
            match problem.evaluate(&trial) {
                Ok(next) => {
                    fault = None;
                    let gain = (self.merit(&self.at) - self.merit(&next)) / predicted;
                    if gain > 1e-4 && predicted > 0.0 {
                        self.accept(trial, next, gain);
                        return None;
                    }
                    let linear = &self.at.residuals + &self.at.jacobian * &step.d;
                    noise = Some((next.residuals - linear).norm());
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

    /// Takes the norms of the columns into the scaling.
    fn widen(&mut self, problem: &impl Problem) {
        for (i, column) in self.at.jacobian.column_iter().enumerate() {
            // A column that vanishes leaves the damping to the size of its variable.
            let floor = f64::MIN_POSITIVE.max(1e-12 * self.at.residuals.norm()) / problem.scale(i);
            self.widths[i] = self.widths[i].max(column.norm()).max(floor);
        }
    }

    /// The point after a step: at a bound exactly where the step ends there.
    fn trial(&self, problem: &impl Problem, step: &Step) -> DVector<f64> {
        DVector::from_fn(self.z.len(), |i, _| {
            let [least, most] = problem.bounds(i);
            match step.sides[i] {
                Side::Least if self.share == 1.0 => least,
                Side::Most if self.share == 1.0 => most,
                _ => (self.z[i] + step.d[i]).max(least).min(most),
            }
        })
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
        let Evaluation { constraints, constraints_by, .. } = &self.at;
        let squares = self.at.gain(&step.d);
        if constraints.is_empty() {
            return squares;
        }
        let least = 1.1 * step.multipliers.amax();
        self.weight = least.max(0.5 * (self.weight + least));
        let open = constraints.lp_norm(1) - (constraints + constraints_by * &step.d).lp_norm(1);
        squares + self.weight * open
    }

    /// The end where nothing that was tried is better.
    fn without_descent(&self, problem: &impl Problem, noise: Option<f64>) -> End {
        let step = self.step(problem, NO_DAMPING);
        let promised = step.map_or(f64::INFINITY, |step| self.at.gain(&step.d));
        End::NoDescent(Left { promised, noise: noise.unwrap_or(0.0) })
    }

    fn is_feasible(&self, limits: &Limits) -> bool {
        self.at.constraints.iter().all(|open| open.abs() <= limits.constraint)
    }

    fn is_short(&self, problem: &impl Problem, d: &DVector<f64>, limit: f64) -> bool {
        d.iter().enumerate().all(|(i, d)| d.abs() <= limit * (self.z[i].abs() + problem.scale(i)))
    }

    /// Are the residuals at right angles to every column, or do they rise from the bound that the point is at?
    fn is_stationary(&self, problem: &impl Problem, step: &Step, limits: &Limits) -> bool {
        let Evaluation { residuals, jacobian, constraints_by, .. } = &self.at;
        let gradient = jacobian.tr_mul(residuals) + constraints_by.tr_mul(&step.multipliers);
        let size = residuals.norm();
        let rests = |i: usize| {
            let [least, most] = problem.bounds(i);
            gradient[i].abs() <= limits.cosine * self.widths[i] * size
                || (self.z[i] <= least && gradient[i] > 0.0)
                || (self.z[i] >= most && gradient[i] < 0.0)
        };
        self.is_feasible(limits) && (0..self.z.len()).all(rests)
    }

    /// The step within the bounds; none where the equations have no solution.
    fn step(&self, problem: &impl Problem, damping: f64) -> Option<Step> {
        let own = |i: usize| problem.bounds(i).map(|bound| bound - self.z[i]);
        let bounds: Vec<[f64; 2]> = (0..self.z.len()).map(own).collect();
        Model { at: &self.at, widths: &self.widths, damping, bounds: &bounds }.step()
    }
}

impl Evaluation {
    /// By how much a step makes half the sum of squares smaller, were the residuals linear.
    fn gain(&self, d: &DVector<f64>) -> f64 {
        let along = &self.jacobian * d;
        // Not the difference of the squares, which cancels near a minimum.
        -along.dot(&self.residuals) - 0.5 * along.norm_squared()
    }
}
