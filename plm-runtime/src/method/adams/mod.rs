//! Adams' formulas of variable order and step: prediction, evaluation, correction, evaluation.

mod between;
mod coefficients;
mod differences;
mod order;
mod words;

use self::coefficients::Coefficients;
use self::differences::Differences;
use self::order::{Errors, Next};
use super::adaptive::{builders, ensure_moves, next_step};
use super::embedded::{Span, first_step};
use super::projection::{PROJECTED_ABOVE, Projection};
use super::{Context, DenseOutput, ErrorControl, FixedLength, Method, Path, drift_of_size, not_finite};
use crate::fault::Fault;
use crate::scalar::{Real, Scalar};
use crate::system::{Drift, System};
use crate::vector::Vector;

/// Highest order of a prediction; a correction has one more.
const MOST: usize = 12;

/// Adams' formulas of order 1 to 13, with order and steps chosen by the errors: two evaluations a step, for long smooth runs of large
/// mechanisms (L. F. Shampine, M. K. Gordon, Computer Solution of Ordinary Differential Equations, 1975).
///
/// Accelerations are integrated twice for coordinates (F. T. Krogh, SIAM J. Numer. Anal. 5, 1968), so that only they and the rates of
/// first-order states are stored. A run begins with order 1, and so it does again wherever rates jump. The error norm and the
/// treatment of drift are those of [`Embedded`](super::Embedded).
#[derive(Clone, Copy, Debug)]
pub struct Adams<M: System> {
    /// Relative tolerance; the absolute one of each state is this times its typical size.
    pub rtol: M::S,
    /// Longest step, s.
    pub longest_step: M::S,
    /// Most accepted and rejected steps in one interval.
    pub most_steps: u64,
    /// Data of the earlier rates.
    past: Past<M>,
    /// True if there are none: at the beginning and after a change.
    forgotten: bool,
    /// Last step; `None` if its angles differ by revolutions from those of the state.
    span: Option<Span<M::S, M::X>>,
    path: Option<Path<M::S, M::X>>,
    projection: Projection<M::S>,
    /// True if the error decided the length of the last step.
    by_error: bool,
}

/// History of a run.
#[derive(Clone, Copy, Debug)]
struct Past<M: System> {
    differences: Differences<M>,
    coefficients: Coefficients<M::S>,
    /// Order of the last step.
    made: usize,
    /// Order and length of the next step.
    next: Next<M::S>,
    /// True while order and step still grow from the first ones.
    begins: bool,
    /// Rejections since the last accepted step.
    rejected: u32,
}

/// A step that may be accepted.
struct Trial<M: System> {
    /// State at its end.
    x: M::X,
    errors: Errors<M::S>,
    weight: M::X,
    /// Number of its velocities and first-order states.
    count: M::S,
    drift: M::S,
}

impl<M: System<S: Real>> Default for Adams<M> {
    fn default() -> Self {
        Self::new(M::S::lit(1e-9))
    }
}

builders!([M: System<S: Real>] Adams<M>);

impl<M: System<S: Real>> Adams<M> {
    /// Adams' formulas with the relative tolerance `rtol` (at least the resolution of the scalar).
    pub fn new(rtol: M::S) -> Self {
        Self {
            rtol,
            longest_step: M::S::INFINITY,
            most_steps: 1_000_000,
            past: Past::new(M::X::fill(M::S::ZERO), M::S::ZERO),
            forgotten: true,
            span: None,
            path: None,
            projection: Projection::new(),
            by_error: false,
        }
    }

    /// Order of the formula that corrected the last step; `None` before the first.
    pub fn order(&self) -> Option<usize> {
        (self.past.made > 0).then_some(self.past.made + 1)
    }

    /// Starts the history at the state reached.
    #[cold]
    fn begin_anew(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        let x = context.x;
        let mut rate = x;
        context.rate(context.time, &x, &mut rate)?;
        if !(x.is_finite() && rate.is_finite()) {
            return Err(not_finite(context.system, context.time, &rate));
        }
        // The error of order 1 grows with the square of the step.
        let h = first_step(context, &rate, self.tolerance(), 2)?;
        (self.past, self.forgotten) = (Past::new(rate, h), false);
        Ok(())
    }

    /// Makes one step without a decision.
    fn trial(&mut self, context: &mut Context<'_, M>, h: M::S) -> Result<Trial<M>, Fault> {
        let tolerance = self.tolerance();
        let Past { differences, coefficients: by, next: Next { order: k, .. }, .. } = &mut self.past;
        let (k, time) = (*k, context.time + h);
        by.prepare(h, k);
        let mut x = differences.predict((&context.x, h), k, by);
        let mut rate = x;
        context.rate(time, &x, &mut rate)?;
        let surprise = differences.surprise(&rate);
        let (once, twice) = (h * by.once.at(k + 1), h * h * by.twice.at(k + 1));
        for i in 0..M::X::LEN {
            let change = if i < M::NQ { twice * surprise.at(M::NQ + i) } else { once * surprise.at(i) };
            x.set(i, x.at(i) + change);
        }
        let weight = weight(context, tolerance, h);
        let moving = (context.system.states() - context.system.coordinates()).max(1);
        let count = M::S::lit(moving as f64);
        let mean = |sum: M::S| (sum / count).sqrt();
        let errors = Errors::new(h, differences.sizes(&surprise, &weight, k).map(mean), k, by);
        let drift = self.projection.drift((context.system, &context.held), tolerance, (time, &x));
        Ok(Trial { x, errors, weight, count, drift })
    }

    /// State and rate at the end of an accepted step, projected if it has drifted or the step went by rank.
    fn arrive(
        &mut self,
        context: &mut Context<'_, M>,
        time: M::S,
        trial: &Trial<M>,
        by_rank: bool,
    ) -> Result<(M::X, M::X), Fault> {
        let mut x = trial.x;
        if by_rank || trial.drift > M::S::lit(PROJECTED_ABOVE) {
            let tolerance = self.tolerance();
            self.projection.project(context, tolerance, (time, &mut x))?;
        }
        let mut rate = x;
        context.rate(time, &x, &mut rate)?;
        Ok((x, rate))
    }

    /// Stores an accepted step of `h`, which might have been as long as `wanted`, and plans the next one.
    fn partition(&mut self, trial: &Trial<M>, rate: &M::X, (h, wanted): (M::S, M::S)) {
        let Past { differences, coefficients: by, next, begins, .. } = &mut self.past;
        let k = next.order;
        differences.accept(rate, k);
        let one_more = (k < by.equal).then(|| {
            let mean = differences.next_size(&trial.weight, k) / trial.count;
            Errors::one_more(h, mean.sqrt(), k)
        });
        *next = order::next(&trial.errors, one_more, (k, h), begins, by.equal);
        // A step that was cut to reach the end tells little about the next one; but none grows by more than twice.
        next.h = if h < wanted { next.h.max(wanted.min(h + h)) } else { next.h };
        (self.past.made, self.past.rejected) = (k, 0);
    }

    /// State with the largest error, each relative to its size, which is at least typical.
    #[cold]
    fn largest_error(&self, system: &M, x: &M::X) -> Option<usize> {
        let typical = system.typical();
        let error = |i: usize| self.past.differences.last.at(i).abs() / (typical.at(i) + x.at(i).abs());
        (M::NQ..M::X::LEN)
            .fold((None, M::S::ZERO), |most, i| if error(i) > most.1 { (Some(i), error(i)) } else { most })
            .0
    }

    /// The fault, with the part of the state with the largest error if it names none.
    #[cold]
    fn named(&self, context: &Context<'_, M>, fault: Fault) -> Fault {
        let worst =
            self.largest_error(context.system, &context.x).map_or("", |i| context.system.part_of_state(i));
        if fault.part.is_empty() { Fault { part: worst, ..fault } } else { fault }
    }
}

impl<M: System<S: Real>> Past<M> {
    fn new(rate: M::X, h: M::S) -> Self {
        Self {
            differences: Differences::new(rate),
            coefficients: Coefficients::new(),
            made: 0,
            next: Next { order: 1, h },
            begins: true,
            rejected: 0,
        }
    }

    /// Takes back the last prediction.
    fn take_back(&mut self, order: usize, h: M::S) {
        self.differences.take_back(order, &self.coefficients);
        self.coefficients.take_back(h);
        self.begins = false;
    }

    /// Takes back a step of `h` and plans a shorter one, after repeated failures with order 1.
    fn reject(&mut self, h: M::S, errors: Option<&Errors<M::S>>) {
        let order = self.next.order;
        self.take_back(order, h);
        self.rejected += 1;
        let less = errors.is_some_and(|errors| errors.asks_for_less(order));
        self.next.order = match self.rejected {
            0..=2 => order - usize::from(less),
            _ => 1,
        };
        self.next.h = M::S::lit(0.5) * h;
    }
}

impl<M: System<S: Real> + Copy> Method<M> for Adams<M> {
    #[inline]
    fn name(&self) -> &'static str {
        "Adams"
    }

    fn advance(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        if self.forgotten {
            self.begin_anew(context)?;
        }
        (self.span, self.path) = (None, None);
        self.accepted(context).map_err(|fault| self.named(context, fault))
    }

    fn restart(&mut self) {
        (self.forgotten, self.span, self.path) = (true, None, None);
        self.projection = Projection::new();
    }

    fn turned(&mut self) {
        (self.span, self.path) = (None, None);
    }

    fn fresh(&self) -> Self {
        let Self { rtol, longest_step, most_steps, .. } = *self;
        Self { longest_step, most_steps, ..Self::new(rtol) }
    }

    fn drift_limit(&self, system: &M) -> Drift<M::S> {
        drift_of_size(system, self.tolerance() * M::S::lit(PROJECTED_ABOVE))
    }
}

impl<M: System<S: Real> + Copy> DenseOutput<M> for Adams<M> {
    #[inline]
    fn is_dense(&self) -> bool {
        true
    }

    fn densify(&mut self, _context: &mut Context<'_, M>) -> Result<(), Fault> {
        if let (Some(span), None) = (&self.span, &self.path) {
            let Past { differences, coefficients, made, .. } = &self.past;
            self.path = Some(between::path(span, differences, coefficients, *made));
        }
        Ok(())
    }

    fn interpolate(&self, time: M::S) -> M::X {
        match (&self.path, &self.span) {
            (Some(path), _) => path.at((time - path.start) / path.h),
            (None, Some(span)) => span.at(time, &[]),
            _ => M::X::fill(M::S::ZERO),
        }
    }

    fn path(&self) -> Option<Path<M::S, M::X>> {
        self.path.or_else(|| self.span.as_ref().map(|span| span.path(&[])))
    }
}

impl<M: System<S: Real> + Copy> ErrorControl<M> for Adams<M> {
    fn shorten(&mut self, h: M::S) -> bool {
        (self.span, self.path) = (None, None);
        self.projection = Projection::new();
        if !self.forgotten {
            self.past.take_back(self.past.made, h);
            self.past.next = Next { order: self.past.made.max(1), h: M::S::lit(0.5) * h };
        }
        true
    }

    fn limited_by(&self, system: &M) -> Option<usize> {
        self.span.as_ref().filter(|_| self.by_error).and_then(|span| self.largest_error(system, &span.to))
    }

    fn most_steps(&self) -> u64 {
        self.most_steps
    }

    fn tolerance(&self) -> Option<M::S> {
        Some(Adams::tolerance(self))
    }
}

impl<M: System<S: Real> + Copy> FixedLength<M> for Adams<M> {}

impl<M: System<S: Real> + Copy> Adams<M> {
    /// Makes steps until one is accepted.
    fn accepted(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        let (from, start) = (context.x, self.past.differences.at(1));
        let rate_from = M::X::from_fn(|i| if i < M::NQ { from.at(M::NQ + i) } else { start.at(i) });
        loop {
            let wanted = self.past.next.h.min(self.longest_step);
            let (h, last) = next_step(self.most_steps, context, wanted)?;
            let (before, one) = (context.stats.by_rank, M::S::lit(1.0));
            let attempt = self.trial(context, h);
            let mut failed = None;
            // NaN is not below.
            if let Some(trial) =
                attempt.as_ref().ok().filter(|trial| trial.errors.made <= one && trial.drift <= one)
            {
                let time = if last { context.end } else { context.time + h };
                match self.arrive(context, time, trial, context.stats.by_rank > before) {
                    Ok((to, rate_to)) => {
                        self.span = Some(Span { time: context.time, h, from, to, rate_from, rate_to });
                        self.partition(trial, &rate_to, (h, wanted));
                        self.by_error = !last && h < self.longest_step && trial.drift <= trial.errors.made;
                        context.reach(time, h, to);
                        return Ok(());
                    }
                    Err(fault) => failed = Some(fault),
                }
            }
            context.stats.rejected += 1;
            self.past.reject(h, attempt.as_ref().ok().map(|trial| &trial.errors));
            let tried = failed.map_or_else(|| attempt.map(|trial| trial.x), Err);
            ensure_moves(context, self.past.next.h, tried)?;
        }
    }
}

/// Weight of an error in each rate over a step of `h`, by its effect on velocities or on coordinates.
fn weight<M: System<S: Real>>(context: &Context<'_, M>, rtol: M::S, h: M::S) -> M::X {
    let (typical, x) = (context.system.typical(), &context.x);
    let size = |i: usize| rtol * (typical.at(i) + x.at(i).abs());
    let mut weight = M::X::fill(M::S::ZERO);
    for i in M::NQ..M::X::LEN {
        let least = if i < 2 * M::NQ { size(i).min(size(i - M::NQ) / h) } else { size(i) };
        weight.set(i, M::S::lit(1.0) / least);
    }
    weight
}
