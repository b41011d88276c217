//! Radau IIA of order 5 with step control and dense output, for stiff equations.

mod control;
mod dense;
mod newton;
mod tableau;
mod words;

use core::fmt;

use self::control::Control;
use self::dense::Dense;
use self::newton::{Convergence, Factors, Outcome, iterate};
use self::tableau::{C, ERROR};
use super::adaptive::{Steady, builders, next_step, rate_here};
use super::projection::{PROJECTED_ABOVE, Projection};
use super::{Context, DenseOutput, ErrorControl, FixedLength, Method, Path, drift_of_size, larger};
use crate::fault::Fault;
use crate::linalg::Derivatives as _;
use crate::linear::Linear;
use crate::scalar::{Real, Scalar};
use crate::system::Drift;
use crate::vector::Vector;

/// Radau IIA of order 5 with three stages: L-stable, with error control, dense output of order 3.
///
/// Algorithm of the program RADAU5 (E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, IV.8): simplified Newton iteration
/// that reuses the derivatives while it converges fast, one real and one complex decomposition, an error estimate of order 3.
/// Its norm is the root mean square of error_i / (rtol' (typical_i + |x_i|)) with rtol' = 0.1 rtol^(2/3), which makes the error
/// of the solution about rtol. A state that drifted by a tenth of rtol is projected, and the dense output ends there.
#[derive(Clone)]
pub struct RadauIia5<M: Linear> {
    /// Relative tolerance; the absolute one of each state is this times its typical size.
    pub rtol: M::S,
    /// Longest step, s.
    pub longest_step: M::S,
    /// Most accepted and rejected steps in one interval.
    pub most_steps: u64,
    /// Proposal for the next step, s; `None` before the first.
    proposal: Option<M::S>,
    control: Control<M::S>,
    steady: Steady<<M::S as Real>::Plain>,
    convergence: Convergence<M::S>,
    /// Rate at the current state; `None` after a change of the state.
    rate: Option<M::X>,
    /// Derivatives of the rate, at the current state or an earlier one, if they are known. They and the factors are large, and
    /// written in place.
    by_x: M::Derivatives,
    by_x_known: bool,
    /// True if the derivatives are those at the current state.
    by_x_here: bool,
    factors: Factors<M>,
    dense: Option<Dense<M::S, M::X>>,
    projection: Projection<M::S>,
    /// Component with the largest error in the last step that was tried.
    worst: usize,
    /// True if that error decided the length of the last step.
    by_error: bool,
}

/// Shows the options only.
impl<M: Linear<S: fmt::Debug>> fmt::Debug for RadauIia5<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rtol, longest_step, most_steps, .. } = self;
        let mut method = f.debug_struct("RadauIia5");
        method.field("rtol", rtol).field("longest_step", longest_step);
        method.field("most_steps", most_steps).finish_non_exhaustive()
    }
}

/// A step that may be accepted.
struct Trial<X> {
    /// Stages less the state at the beginning.
    z: [X; 3],
    /// State at its end.
    x: X,
    iterations: usize,
}

/// Power of the step with which the estimate of the error grows.
const ORDER: u32 = 4;
/// Ratio of corrections below which derivatives are reused. With a larger ratio fewer of them are computed, but the error that
/// iterations leave shows in the order of the method.
const FAST: f64 = 1e-3;
/// Factor below which a longer proposal is not used, so that the decomposition can be reused.
const WORTH_IT: f64 = 1.2;

impl<M: Linear> Default for RadauIia5<M> {
    fn default() -> Self {
        Self::new(M::S::lit(1e-8))
    }
}

builders!([M: Linear] RadauIia5<M>);

impl<M: Linear> RadauIia5<M> {
    /// The method with the relative tolerance `rtol` (at least the resolution of the scalar).
    pub fn new(rtol: M::S) -> Self {
        let by_x = M::Derivatives::zeros();
        Self {
            rtol,
            longest_step: M::S::INFINITY,
            most_steps: 1_000_000,
            proposal: None,
            control: Control::new(),
            steady: Steady::new(),
            convergence: Convergence::new(),
            rate: None,
            factors: Factors::room(&by_x),
            by_x,
            by_x_known: false,
            by_x_here: false,
            dense: None,
            projection: Projection::new(),
            worst: 0,
            by_error: false,
        }
    }

    /// Tolerance of the error estimate, which is of order 3 and not of 5.
    fn inner_tolerance(&self) -> M::S {
        M::S::lit(0.1) * (self.tolerance().ln() * M::S::lit(2.0 / 3.0)).exp()
    }

    /// Tolerance of the iteration.
    fn newton_tolerance(&self) -> M::S {
        let inner = self.inner_tolerance();
        (M::S::lit(10.0) * M::S::EPSILON / inner).max(inner.sqrt().min(M::S::lit(0.03)))
    }

    /// Weights of the errors of the components.
    fn weights(&self, context: &Context<'_, M>) -> M::X {
        let (rtol, one) = (self.inner_tolerance(), M::S::lit(1.0));
        context.system.typical().map2(&context.x, |typical, x| one / (rtol * (typical + x.abs())))
    }

    /// Solves the stages of a step of `h`, or gives the factor of a shorter one.
    fn trial(
        &mut self,
        context: &mut Context<'_, M>,
        h: M::S,
        weights: &M::X,
    ) -> Result<Result<Trial<M::X>, f64>, Fault> {
        let wanted = (weights, self.newton_tolerance());
        let Self { by_x, factors, .. } = self;
        if !self.by_x_known {
            context.differentiate(by_x, None)?;
            (self.by_x_known, self.by_x_here) = (true, true);
            factors.forget();
        }
        if !factors.are_of(h) && !factors.decompose(context, by_x, h) {
            return Ok(Err(0.5));
        }
        let mut z = [M::X::fill(M::S::ZERO); 3];
        if let Some(dense) = &self.dense {
            let ratio = h / dense.h();
            z = C.map(|c| dense.change(M::S::lit(c) * ratio));
        }
        Ok(match iterate(context, by_x, factors, z, wanted, &mut self.convergence) {
            Outcome::Failed(factor) => Err(factor),
            Outcome::Found(z, iterations) => {
                Ok(Trial { x: context.x.map2(&z[2], |x, z| x + z), z, iterations })
            }
        })
    }

    /// Error of a trial step over the tolerance (Hairer and Wanner II, IV.8, eqs. (8.19) and (8.20)): filtered a second time if
    /// the first estimate would reject and the beginning may be a fast transient.
    fn error(
        &mut self,
        context: &mut Context<'_, M>,
        trial: &Trial<M::X>,
        rate: &M::X,
        weights: &M::X,
    ) -> M::S {
        let (by_x, factors) = (&self.by_x, &self.factors);
        let over_h = ERROR.map(|weight| M::S::lit(weight) / factors.h);
        let [z1, z2, z3] = &trial.z;
        let mut sum = M::X::fill(M::S::ZERO);
        sum.add([(over_h[0], z1), (over_h[1], z2), (over_h[2], z3)]);
        let estimate = |rate: &M::X| factors.solve(by_x, &sum.map2(rate, |sum, rate| sum + rate));
        let first = estimate(rate);
        let count = context.system.states();
        let error = norm(&first, weights, count);
        self.worst = largest(&first, weights);
        if !(error >= M::S::lit(1.0) && (self.control.is_first() || self.control.rejected)) {
            return error;
        }
        let (mut again, near) = (*rate, context.x.map2(&first, |x, error| x + error));
        if context.rate(context.time, &near, &mut again).is_err() {
            return error;
        }
        norm(&estimate(&again), weights, count)
    }

    /// Drift of a state over the tolerance, less the part that projection cannot remove.
    fn drift_ratio(&self, context: &Context<'_, M>, t: M::S, x: &M::X) -> M::S {
        self.projection.drift((context.system, &context.held), self.tolerance(), (t, x))
    }

    /// Moves the context to the end of an accepted step, projected if its drift is above `limit`.
    fn arrive(
        &mut self,
        context: &mut Context<'_, M>,
        (time, h): (M::S, M::S),
        trial: &Trial<M::X>,
        limit: M::S,
    ) -> Result<(), Fault> {
        let mut x = trial.x;
        if self.drift_ratio(context, time, &x) > limit {
            let tolerance = self.tolerance();
            self.projection.project(context, tolerance, (time, &mut x))?;
        }
        self.dense = Some(Dense::new(time, h, trial.x, x, &trial.z));
        self.rate = None;
        self.by_x_here = false;
        if self.convergence.theta > M::S::lit(FAST) {
            self.by_x_known = false;
        }
        context.reach(time, h, x);
        Ok(())
    }

    /// Proposes the step after an accepted one. A step that was cut to reach the end tells little about the next one, and a
    /// little longer one is not worth a decomposition.
    fn propose(&mut self, proposal: M::S, h: M::S, factor: M::S) {
        let next = h * factor;
        let keep = self.by_x_known && (M::S::lit(1.0)..M::S::lit(WORTH_IT)).contains(&factor);
        self.proposal = Some(if h < proposal {
            next.max(proposal)
        } else if keep {
            h
        } else {
            next
        });
    }

    /// Forgets derivatives that are not those at the current state.
    fn renew(&mut self) {
        if !self.by_x_here {
            self.by_x_known = false;
        }
    }
}

impl<M: Linear + Copy> Method<M> for RadauIia5<M> {
    #[inline]
    fn name(&self) -> &'static str {
        "RadauIia5"
    }

    fn advance(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        let rate = rate_here(&mut self.rate, context)?;
        let weights = self.weights(context);
        let mut proposal = self.proposal.unwrap_or_else(|| first_step(context, &rate, &weights));
        loop {
            proposal = proposal.min(self.longest_step);
            let (h, last) = next_step(self.most_steps, context, proposal)
                .map_err(|fault| Fault { part: context.system.part_of_state(self.worst), ..fault })?;
            let time = if last { context.end } else { context.time + h };
            let by_rank = context.stats.by_rank;
            match self.trial(context, h, &weights)? {
                Err(factor) => {
                    self.control.rejected = true;
                    self.convergence = Convergence::new();
                    self.renew();
                    proposal = h * M::S::lit(factor);
                }
                Ok(trial) => {
                    let estimate = self.error(context, &trial, &rate, &weights);
                    let error = M::S::of_plain(self.steady.error(h.plain(), estimate.plain(), ORDER));
                    let drift = self.drift_ratio(context, time, &trial.x);
                    let worst = larger(error, drift);
                    if worst <= M::S::lit(1.0) {
                        let went_by_rank = context.stats.by_rank > by_rank;
                        let limit = if went_by_rank { 0.0 } else { PROJECTED_ABOVE };
                        self.arrive(context, (time, h), &trial, M::S::lit(limit))?;
                        self.by_error = !last && h < self.longest_step && drift <= error;
                        if h >= proposal {
                            self.steady.accept(h.plain(), estimate.plain(), ORDER);
                        }
                        let factor = self.control.accept(h, worst, trial.iterations);
                        let factor = factor.min(self.convergence.growth(trial.iterations));
                        self.propose(proposal, h, factor);
                        return Ok(());
                    }
                    proposal = h * self.control.reject(worst, trial.iterations);
                    self.renew();
                }
            }
            context.stats.rejected += 1;
        }
    }

    fn restart(&mut self) {
        (self.rate, self.by_x_known, self.dense) = (None, false, None);
        self.factors.forget();
        self.projection = Projection::new();
    }

    fn fresh(&self) -> Self {
        let Self { rtol, longest_step, most_steps, .. } = *self;
        Self { longest_step, most_steps, ..Self::new(rtol) }
    }

    fn drift_limit(&self, system: &M) -> Drift<M::S> {
        drift_of_size(system, self.tolerance() * M::S::lit(PROJECTED_ABOVE))
    }
}

impl<M: Linear + Copy> DenseOutput<M> for RadauIia5<M> {
    #[inline]
    fn is_dense(&self) -> bool {
        true
    }

    fn interpolate(&self, time: M::S) -> M::X {
        self.dense.map_or(M::X::fill(M::S::ZERO), |dense| dense.at(time))
    }

    fn path(&self) -> Option<Path<M::S, M::X>> {
        self.dense.as_ref().map(Dense::path)
    }
}

impl<M: Linear + Copy> ErrorControl<M> for RadauIia5<M> {
    fn shorten(&mut self, h: M::S) -> bool {
        self.restart();
        self.control.rejected = true;
        self.proposal = Some(M::S::lit(0.5) * h);
        true
    }

    fn limited_by(&self, _system: &M) -> Option<usize> {
        self.by_error.then_some(self.worst)
    }

    fn most_steps(&self) -> u64 {
        self.most_steps
    }

    fn tolerance(&self) -> Option<M::S> {
        Some(RadauIia5::tolerance(self))
    }
}

impl<M: Linear + Copy> FixedLength<M> for RadauIia5<M> {}

/// Index of the largest component, each by its weight.
fn largest<S: Real, X: Vector<S>>(v: &X, weights: &X) -> usize {
    let parts = v.map2(weights, |v, weight| (v * weight).abs());
    (0..X::LEN).fold(0, |most, i| if parts.at(i) > parts.at(most) { i } else { most })
}

/// Root mean square of so many components, each by its weight; NaN if one of them is.
fn norm<S: Real, X: Vector<S>>(v: &X, weights: &X, count: usize) -> S {
    let parts = v.map2(weights, |v, weight| v * weight);
    let sum = parts.fold(S::ZERO, |sum, part| part.mul_add(part, sum));
    (sum / S::lit(count.max(1) as f64)).sqrt()
}

/// First step: a hundredth of the time in which the rate would change the state by its size, but at least a fraction of the
/// interval above its rounding. A fast transient is damped, and steps grow fast from there.
fn first_step<M: Linear>(context: &Context<'_, M>, rate: &M::X, weights: &M::X) -> M::S {
    let span = context.end - context.time;
    let typical = context.system.typical();
    let count = context.system.states();
    let size = |i: usize| typical.at(i) + context.x.at(i).abs();
    let sizes = M::X::from_fn(|i| if context.system.has_number(i) { size(i) } else { M::S::ZERO });
    let time = norm(&sizes, weights, count) / norm(rate, weights, count);
    (M::S::lit(0.01) * time).max(M::S::EPSILON.sqrt() * span).min(span)
}
