//! Sequential quadratic programming with a trust region and the exact penalty of violations (R. Fletcher, Practical Methods of
//! Optimization, 2nd ed., 1987, 14.4); the Hessian is that of Gauss and Newton with second derivatives from the steps.

use nalgebra::{DMatrix, DVector};
use plm_runtime::Fault;

use super::curvature::{Curvature, Model};
use super::problem::Transcription;
use super::quadratic;
use super::restore::restored;
use super::values::Values;
use crate::optimise::error::{Error, NotConverged};
use crate::optimise::mechanism::{Integration, Optimisable};

/// Result of the search.
pub(super) struct Found {
    pub(super) z: DVector<f64>,
    pub(super) values: Values,
    /// The largest violation of a constraint.
    pub(super) violation: f64,
    pub(super) iterations: usize,
}

/// Violations below this count as none, in the units of the demands and the typical sizes of states.
const FEASIBLE: f64 = 1e-8;
/// Violations that are left to the rounding of a quadratic program, at a point where its model finds nothing better.
const NEARLY: f64 = 1e-5;
/// A model that predicts less than this fraction of the cost is at its minimum.
const FLAT: f64 = 1e-9;
/// A trust region below this is rounding.
const SMALLEST: f64 = 1e-13;
/// Weight of violations beyond which they cannot be made less.
const LARGEST_WEIGHT: f64 = 1e10;

/// Violations with a sum below this are nearly none.
const NEAR: f64 = 1e-2;
/// So often the weight is lowered: the search ends.
const MOST_LOWERED: usize = 5;
/// So often the search goes on from where rounding has ended it.
const MOST_RESTORED: usize = 3;
/// The trust region with which it goes on.
const AGAIN: f64 = 1e-2;

/// State of the search.
struct Search {
    z: DVector<f64>,
    values: Values,
    curvature: Curvature,
    sizes: Vec<f64>,
    /// Of the trust region, in sizes of the variables.
    radius: f64,
    /// Of violations in the merit function.
    weight: f64,
    /// How often the weight was lowered.
    lowered: usize,
    /// How often violations were removed.
    restored: usize,
    fault: Option<Fault>,
}

/// Result of one iteration.
enum Outcome {
    /// It goes on.
    GoesOn,
    /// The model is at its minimum.
    Converged,
    /// No step makes the violation smaller.
    Stuck,
}

/// Result of trying a step.
enum Attempt {
    /// It is better: ratio of the gain to the predicted one.
    Taken(f64),
    /// It is not better; the values after it.
    Refused(Box<Values>),
    /// A run ends with a fault there.
    Faulted,
}

/// Finds the minimum of a program from a point within its bounds.
///
/// # Errors
/// The fault at that point; a search that does not end at a minimum that satisfies the constraints.
pub(super) fn minimise<M: Optimisable, D: Integration<M>>(
    program: &mut Transcription<M, D>,
    start: DVector<f64>,
    most: usize,
) -> Result<Found, Error> {
    let sizes: Vec<f64> = (0..start.len()).map(|k| program.scale(k)).collect();
    let values =
        program.evaluate(&start).map_err(|fault| Error::AtGuess { experiment: 0, fault: Box::new(fault) })?;
    let weight = first_weight(&values, &sizes);
    let curvature = Curvature::new(&values, &sizes);
    let mut search = Search {
        z: start,
        values,
        curvature,
        sizes,
        radius: 1.0,
        weight,
        lowered: 0,
        restored: 0,
        fault: None,
    };
    for iterations in 1..=most {
        match search.iterate(program)? {
            Outcome::GoesOn => {}
            Outcome::Converged => {
                let violation = violations(&search.values, None).largest;
                return Ok(Found { z: search.z, values: search.values, violation, iterations });
            }
            Outcome::Stuck => return Err(search.ended(program, NotConverged::NoDescent)),
        }
    }
    Err(search.ended(program, NotConverged::Iterations(most)))
}

impl Search {
    fn iterate<M: Optimisable, D: Integration<M>>(
        &mut self,
        program: &mut Transcription<M, D>,
    ) -> Result<Outcome, Error> {
        let boxes = self.boxes(program);
        let model_of_cost = self.curvature.model(&self.values);
        let quadratic::Step { d, multipliers } =
            quadratic::step((&self.values, &model_of_cost), &boxes, &self.sizes, self.weight)?;
        let (before, model) = (violations(&self.values, None), violations(&self.values, Some(&d)));
        let reached =
            d.iter().zip(&self.sizes).fold(0.0, |reached: f64, (d, size)| reached.max(d.abs() / size));
        let is_inside = reached < 0.99 * self.radius;
        let predicted = self.gain(&model_of_cost, &d) + self.weight * (before.sum - model.sum);
        let size = self.values.cost().abs() + self.weight * before.sum;
        if self.radius < SMALLEST {
            // Rounding of violations refuses every step: without it the search goes on.
            if self.restored < MOST_RESTORED && self.restore(program, &before) {
                self.restored += 1;
                self.radius = AGAIN;
                return Ok(Outcome::GoesOn);
            }
            return Ok(Outcome::Stuck);
        }
        if is_inside && (reached < 1e-12 || predicted <= FLAT * size.max(f64::MIN_POSITIVE)) {
            return Ok(self.at_rest(program, &before));
        }
        if is_inside
            && model.largest > FEASIBLE
            && multipliers.largest() > 0.99 * self.weight
            && self.weight < LARGEST_WEIGHT
        {
            // Within the region, and violated all the same: the cost holds against the demands.
            self.weight *= 10.0;
            return Ok(Outcome::GoesOn);
        }
        let ratio = self.moved(program, (&d, predicted), (&model_of_cost, &boxes))?;
        self.curvature.learn(&self.values, &multipliers);
        self.lower_weight(&before, multipliers.largest());
        match ratio {
            Attempt::Taken(ratio) if ratio > 0.75 && !is_inside => self.radius *= 2.0,
            Attempt::Taken(ratio) if ratio < 0.25 => self.radius = 0.5 * reached,
            Attempt::Taken(_) => {}
            Attempt::Refused(_) | Attempt::Faulted => self.radius = 0.25 * reached,
        }
        Ok(Outcome::GoesOn)
    }

    /// The trust region within the bounds.
    fn boxes<M: Optimisable, D: Integration<M>>(&self, program: &Transcription<M, D>) -> Vec<[f64; 2]> {
        let own = |k: usize| {
            let ([least, most], reach) = (program.bounds(k), self.radius * self.sizes[k]);
            [(least - self.z[k]).max(-reach).min(0.0), (most - self.z[k]).min(reach).max(0.0)]
        };
        (0..self.z.len()).map(own).collect()
    }

    /// Tries a step, stores its information on the curvature, and corrects the step if it is refused.
    fn moved<M: Optimisable, D: Integration<M>>(
        &mut self,
        program: &mut Transcription<M, D>,
        (d, predicted): (&DVector<f64>, f64),
        (model, boxes): (&Model, &[[f64; 2]]),
    ) -> Result<Attempt, Error> {
        let from = self.values.clone();
        let first = self.attempt(program, d, (predicted, model.weight));
        match &first {
            Attempt::Taken(_) => self.curvature.remember(&from, &self.values, d),
            Attempt::Refused(next) => self.curvature.remember(&from, next, d),
            Attempt::Faulted => {}
        }
        let Attempt::Refused(next) = &first else { return Ok(first) };
        // Curved demands refuse good steps: a second one from where they are after the first (Fletcher, 14.4).
        let mut corrected = from;
        corrected.equal = &next.equal - &corrected.equal_by * d;
        corrected.within = &next.within - &corrected.within_by * d;
        let second = quadratic::step((&corrected, model), boxes, &self.sizes, self.weight)?;
        Ok(self.attempt(program, &second.d, (predicted, model.weight)))
    }

    /// Lowers the weight of violations near to none: one far above the multipliers makes steps along curved demands short.
    fn lower_weight(&mut self, violations: &Violations, multiplier: f64) {
        let enough = 2.0 * multiplier.max(1.0);
        if violations.sum < NEAR && self.weight > 2.0 * enough && self.lowered < MOST_LOWERED {
            self.weight = enough;
            self.lowered += 1;
        }
    }

    /// By how much the model of the cost falls with a step.
    fn gain(&self, model: &Model, d: &DVector<f64>) -> f64 {
        let Values { squares, squares_by, linear_by, equal, equal_by, .. } = &self.values;
        let slope = 2.0 * squares.dot(&(squares_by * d)) + linear_by.dot(d);
        let scaled = DVector::from_fn(d.len(), |k, _| d[k] / self.sizes[k]);
        let opens = equal + equal_by * d;
        let squares = equal.norm_squared() - opens.norm_squared();
        -slope - 0.5 * scaled.dot(&(&model.hessian * &scaled)) + 0.5 * model.weight * squares
    }

    /// Takes away violations that are the rounding of a quadratic program; says whether there were some and none is left.
    fn restore<M: Optimisable, D: Integration<M>>(
        &mut self,
        program: &mut Transcription<M, D>,
        violations: &Violations,
    ) -> bool {
        if violations.largest <= FEASIBLE || violations.largest > NEARLY {
            return false;
        }
        let holds = |values: &Values| self::violations(values, None).largest <= FEASIBLE;
        let found = restored(program, (&self.z, &self.values), &self.sizes, holds);
        found.is_some_and(|found| {
            (self.z, self.values) = found;
            true
        })
    }

    /// The end of a search whose model finds nothing better.
    fn at_rest<M: Optimisable, D: Integration<M>>(
        &mut self,
        program: &mut Transcription<M, D>,
        violations: &Violations,
    ) -> Outcome {
        if self.fault.is_none() && self.restore(program, violations) {
            return Outcome::Converged;
        }
        if violations.largest <= FEASIBLE && self.fault.is_none() {
            Outcome::Converged
        } else if violations.largest > FEASIBLE && self.weight < LARGEST_WEIGHT {
            self.weight *= 10.0;
            Outcome::GoesOn
        } else {
            Outcome::Stuck
        }
    }

    /// Takes a step if it is better.
    fn attempt<M: Optimisable, D: Integration<M>>(
        &mut self,
        program: &mut Transcription<M, D>,
        d: &DVector<f64>,
        (predicted, weight): (f64, f64),
    ) -> Attempt {
        let trial = &self.z + d;
        let next = match program.evaluate(&trial) {
            Ok(next) => next,
            Err(fault) => {
                self.fault = Some(fault);
                return Attempt::Faulted;
            }
        };
        self.fault = None;
        let (before, after) = (violations(&self.values, None), violations(&next, None));
        let gain = self.values.cost() - next.cost()
            + self.weight * (before.sum - after.sum)
            + 0.5 * weight * (self.values.equal.norm_squared() - next.equal.norm_squared());
        if gain > 1e-4 * predicted {
            (self.z, self.values) = (trial, next);
            return Attempt::Taken(gain / predicted);
        }
        Attempt::Refused(Box::new(next))
    }

    fn ended<M: Optimisable, D: Integration<M>>(
        &self,
        program: &Transcription<M, D>,
        otherwise: NotConverged,
    ) -> Error {
        let violation = violations(&self.values, None).largest;
        let why = match self.fault {
            Some(fault) => NotConverged::Faults(Box::new(fault)),
            None if violation > FEASIBLE && otherwise == NotConverged::NoDescent => {
                NotConverged::Demands { violation }
            }
            None => otherwise,
        };
        let plan = program.plan(self.z.as_slice());
        Error::NotConverged { why, best: Vec::new(), plan, rms: violation }
    }
}

/// The first weight of violations: the largest slope of the cost.
fn first_weight(values: &Values, sizes: &[f64]) -> f64 {
    let gradient = 2.0 * values.squares_by.tr_mul(&values.squares) + &values.linear_by;
    let largest =
        gradient.iter().zip(sizes).fold(0.0, |largest: f64, (slope, size)| largest.max(slope.abs() * size));
    largest.max(1.0)
}

/// Violations of the constraints.
struct Violations {
    sum: f64,
    largest: f64,
}

/// Violations at a point, or those of the linear model after a step.
fn violations(values: &Values, step: Option<&DVector<f64>>) -> Violations {
    let moved = |own: &DVector<f64>, by: &DMatrix<f64>| step.map_or_else(|| own.clone(), |d| own + by * d);
    let equal = moved(&values.equal, &values.equal_by);
    let within = moved(&values.within, &values.within_by);
    let outside = within
        .iter()
        .zip(&values.limits)
        .map(|(value, [least, most])| (least - value).max(value - most).max(0.0));
    let all = equal.iter().map(|open| open.abs()).chain(outside);
    let (sum, largest) =
        all.fold((0.0, 0.0), |(sum, largest): (f64, f64), own| (sum + own, largest.max(own)));
    Violations { sum, largest }
}
