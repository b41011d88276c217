//! Embedded pairs with step control, dense output, and projection if the constraints drift.

mod at_once;
mod control;
mod dense;
mod elsewhere;
mod output;
mod pace;
mod pair;
mod stages;
mod start;
pub(super) mod tableau;
mod words;

pub use self::pair::{Limits, Pair};
pub(super) use self::stages::{Rows, stages};

use self::at_once::Known;
pub(crate) use self::dense::Span;
pub(crate) use self::elsewhere::Going;
pub(crate) use self::pace::Pace;
pub(super) use self::start::first_step;
pub(super) use self::tableau::pair;
use super::adaptive::{builders, ensure_moves, next_step, rate_here};
use super::projection::{PROJECTED_ABOVE, Projection};
use super::{Context, ErrorControl, Evaluated, FixedLength, Method, drift_of_size, larger};
use crate::fault::Fault;
use crate::scalar::{Real, Scalar};
use crate::system::{Drift, System};
use crate::vector::Vector;

/// A pair of Runge-Kutta formulas: steps chosen by the error, dense output.
///
/// The error norm is the pair's, of error_i / (rtol typical_i + rtol max|x_i|), or the drift of the new state over rtol times the typical
/// coordinate (velocity), whichever is larger. If the drift is above a tenth of that tolerance, the new state is projected, and the dense
/// output ends at the projected state and its rate. The health of the stages is checked once a step; an unhealthy step is repeated, by rank
/// where needed, and so are the following ones until one is healthy.
#[derive(Clone, Copy, Debug)]
pub struct Embedded<M: System<S: Real>, P: Pair> {
    /// Relative tolerance; the absolute one of each state is this times its typical size.
    pub rtol: M::S,
    /// Longest step, s.
    pub longest_step: M::S,
    /// Most accepted and rejected steps in one interval.
    pub most_steps: u64,
    /// The next step. It has no derivatives, since it only decides.
    pace: Pace<<M::S as Real>::Plain>,
    /// Rate at the current state; `None` after a change of the state.
    rate: Option<M::X>,
    /// Last step, for the dense output, and its stages.
    span: Option<Span<M::S, M::X>>,
    stages: Option<P::Stages<M::X>>,
    bends: Option<P::Bends<M::X>>,
    /// Content of the dense output of the last step.
    known: Known,
    /// True if the last step went by rank.
    was_unhealthy: bool,
    projection: Projection<M::S>,
    /// True if the error decided the length of the last step.
    by_error: bool,
}

/// A step that may be accepted.
struct Trial<X> {
    /// State at its end.
    x: X,
    /// True if some stage was evaluated by rank.
    by_rank: bool,
}

impl<M: System<S: Real>, P: Pair> Default for Embedded<M, P> {
    fn default() -> Self {
        Self::new(M::S::lit(P::RTOL))
    }
}

builders!([M: System<S: Real>, P: Pair] Embedded<M, P>);

impl<M: System<S: Real>, P: Pair> Embedded<M, P> {
    /// The method with the relative tolerance `rtol` (at least the resolution of the scalar).
    pub fn new(rtol: M::S) -> Self {
        Self {
            rtol,
            longest_step: M::S::INFINITY,
            most_steps: 1_000_000,
            pace: Pace::new(),
            rate: None,
            span: None,
            stages: None,
            bends: None,
            known: Known::Values,
            was_unhealthy: false,
            projection: Projection::new(),
            by_error: false,
        }
    }

    /// Makes one step without a decision; by rank if needed.
    fn trial(
        &mut self,
        context: &mut Context<'_, M>,
        rate: &M::X,
        h: M::S,
        k: &mut P::Stages<M::X>,
    ) -> Result<Trial<M::X>, Fault> {
        let (t, x) = (context.time, context.x);
        if !self.was_unhealthy {
            let (end, worst) = if M::S::AT_ONCE.has_steps() {
                Self::computed::<true>((context, t, &x), rate, h, k)
            } else {
                let mut rates = Evaluated::new(context.system, &context.held);
                let end = P::step::<M>(t, h, &x, rate, k, &mut rates);
                (end, rates.worst)
            };
            context.stats.evaluations += P::EVALUATIONS;
            context.health = context.health.min(worst.0);
            if worst.is_good() {
                return Ok(Trial { x: end, by_rank: false });
            }
        }
        self.trial_by_rank(context, rate, h, k)
    }

    #[cold]
    fn trial_by_rank(
        &mut self,
        context: &mut Context<'_, M>,
        rate: &M::X,
        h: M::S,
        k: &mut P::Stages<M::X>,
    ) -> Result<Trial<M::X>, Fault> {
        let (t, x, mut first) = (context.time, context.x, *rate);
        if M::S::AT_ONCE.has_steps() {
            context.rate(t, &x, &mut first)?;
        }
        let (before, mut outcome) = (context.stats.by_rank, Ok(()));
        let end = P::step::<M>(t, h, &x, &first, k, |t: M::S, x: &M::X, dx: &mut M::X| {
            if outcome.is_ok() {
                outcome = context.rate(t, x, dx);
            }
        });
        self.was_unhealthy = context.stats.by_rank > before;
        outcome.map(|()| Trial { x: end, by_rank: self.was_unhealthy })
    }

    /// Error and drift of a trial step, as multiples of the tolerance; between them the least value that the error is taken for.
    fn judge(
        &self,
        context: &Context<'_, M>,
        h: <M::S as Real>::Plain,
        k: &P::Stages<M::X>,
        (time, end): (M::S, &M::X),
    ) -> (<M::S as Real>::Plain, <M::S as Real>::Plain, M::S) {
        let (rtol, typical, from) = (self.tolerance().plain(), context.system.typical(), context.x);
        let weight = M::X::from_fn(|i| {
            let ends = [from.at(i).plain(), end.at(i).plain()];
            M::S::of_plain(weight(rtol, typical.at(i).plain(), ends))
        });
        let by = (&weight, context.system.states());
        let error = P::error_of_values(h, k, by);
        // If forces bend sharply within a step, estimates are no powers of its length, and a combined one may vanish by chance: the error
        // was 1000 times the tolerance then. After the first step the last one predicts the error; before, the estimate of lower order
        // bounds it alone.
        let is_first = context.system.may_bend() && self.pace.is_new();
        let least = if is_first { P::plain_error(h, k, by) } else { <M::S as Real>::Plain::ZERO };
        (error, least, self.drift_ratio(context, (time, end)))
    }

    /// State with the largest error, each relative to its size, which is at least typical.
    #[cold]
    fn largest_error(system: &M, k: &P::Stages<M::X>, size: impl Fn(usize) -> M::S) -> Option<usize> {
        let typical = system.typical();
        let mut most = (None, <M::S as Real>::Plain::ZERO);
        for i in 0..M::X::LEN {
            let mut weight = M::X::fill(M::S::ZERO);
            weight.set(i, M::S::lit(1.0) / (typical.at(i) + size(i)));
            let one = <M::S as Real>::Plain::lit(1.0);
            let error = P::error_of_values(one, k, (&weight, system.states()));
            if error > most.1 {
                most = (Some(i), error);
            }
        }
        most.0
    }

    /// Part to which the state with the largest error belongs.
    #[cold]
    fn worst(context: &Context<'_, M>, k: &P::Stages<M::X>) -> &'static str {
        let worst = Self::largest_error(context.system, k, |i| context.x.at(i).abs());
        worst.map_or("", |i| context.system.part_of_state(i))
    }

    /// Drift of a state over the tolerance, less the part that projection cannot remove.
    fn drift_ratio(&self, context: &Context<'_, M>, at: (M::S, &M::X)) -> M::S {
        self.projection.drift((context.system, &context.held), self.tolerance(), at)
    }

    /// State and rate at the end of an accepted step, projected if it has drifted or the step went by rank.
    fn arrive(
        &mut self,
        context: &mut Context<'_, M>,
        time: M::S,
        (trial, k): (&Trial<M::X>, &P::Stages<M::X>),
        drift: M::S,
    ) -> Result<(M::X, M::X), Fault> {
        let limit = if trial.by_rank { M::S::lit(0.0) } else { M::S::lit(PROJECTED_ABOVE) };
        let (mut x, projects) = (trial.x, drift > limit);
        if let (false, Some(rate)) = (projects, P::rate_at_end(k)) {
            return Ok((x, *rate));
        }
        if projects {
            let tolerance = self.tolerance();
            self.projection.project(context, tolerance, (time, &mut x))?;
        }
        let mut rate = x;
        context.rate_value(time, &x, &mut rate)?;
        Ok((x, rate))
    }
}

/// Weight of the error of a state in a step between two values of it.
#[inline]
pub(crate) fn weight<T: Scalar>(rtol: T, typical: T, [from, to]: [T; 2]) -> T {
    T::lit(1.0) / (rtol * (typical + from.abs().max(to.abs())))
}

impl<M: System<S: Real> + Copy, P: Pair> Method<M> for Embedded<M, P> {
    #[inline]
    fn name(&self) -> &'static str {
        P::NAME
    }

    fn advance(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        if self.rate.is_none() && context.system.may_bend() {
            self.pace.forget();
        }
        let rate = rate_here(&mut self.rate, context)?;
        let mut proposal = M::S::of_plain(self.pace.proposal);
        if proposal == M::S::ZERO {
            proposal = first_step(context, &rate, self.tolerance(), P::ORDER)?;
        }
        (self.span, self.bends, self.known) = (None, None, Known::Values);
        let mut k = self.stages.unwrap_or_else(|| P::blank(rate));
        loop {
            proposal = proposal.min(self.longest_step);
            let (h, last) = next_step(self.most_steps, context, proposal)
                .map_err(|fault| Fault { part: Self::worst(context, &k), ..fault })?;
            let mut attempt = self.trial(context, &rate, h, &mut k);
            let (estimate, least, drift) = match &attempt {
                Ok(trial) => self.judge(context, h.plain(), &k, (context.time + h, &trial.x)),
                Err(_) => (Real::INFINITY, Scalar::ZERO, M::S::INFINITY),
            };
            let error = M::S::of_plain(larger(self.pace.error::<P>(h.plain(), estimate), least));
            let mut worst = larger(error, drift);
            if let (Ok(trial), true) = (&attempt, worst <= M::S::lit(1.0)) {
                let time = if last { context.end } else { context.time + h };
                match self.arrive(context, time, (trial, &k), drift) {
                    Ok((to, rate_to)) => {
                        self.span = Some(Span {
                            time: context.time,
                            h,
                            from: context.x,
                            to,
                            rate_from: rate,
                            rate_to,
                        });
                        (self.stages, self.rate) = (Some(k), Some(rate_to));
                        // Drift that was not projected comes from earlier steps as well: a shorter step would not reduce it.
                        let projects = drift > M::S::lit(PROJECTED_ABOVE);
                        let error_of_pace = if projects { worst } else { error }.plain();
                        self.pace.accept::<P>(proposal.plain(), h.plain(), (error_of_pace, estimate));
                        self.by_error = !last && h < self.longest_step && drift <= error;
                        context.reach(time, h, to);
                        return Ok(());
                    }
                    Err(fault) => (attempt, worst) = (Err(fault), M::S::INFINITY),
                }
            }
            context.stats.rejected += 1;
            proposal = M::S::of_plain(self.pace.reject::<P>(h.plain(), worst.plain()));
            ensure_moves(context, proposal, attempt.map(|trial| trial.x)).map_err(|fault| {
                if fault.part.is_empty() { Fault { part: Self::worst(context, &k), ..fault } } else { fault }
            })?;
        }
    }

    fn restart(&mut self) {
        self.rate = None;
        self.span = None;
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

impl<M: System<S: Real> + Copy, P: Pair> ErrorControl<M> for Embedded<M, P> {
    fn shorten(&mut self, h: M::S) -> bool {
        self.restart();
        self.pace.refuse(h.plain());
        true
    }

    fn limited_by(&self, system: &M) -> Option<usize> {
        let (Some(step), Some(k), true) = (&self.span, &self.stages, self.by_error) else { return None };
        Self::largest_error(system, k, |i| step.from.at(i).abs().max(step.to.at(i).abs()))
    }

    fn most_steps(&self) -> u64 {
        self.most_steps
    }

    fn tolerance(&self) -> Option<M::S> {
        Some(Embedded::tolerance(self))
    }
}

impl<M: System<S: Real> + Copy, P: Pair> FixedLength<M> for Embedded<M, P> {}
