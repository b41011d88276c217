//! The method that takes over near singular poses.

use super::collocation::Polynomial;
use super::conditioning::{is_ill_conditioned, is_regular, turned};
use super::crossing::{Refused, cross};
use super::distance::SingularityDistance;
use super::equations::Equations;
use super::here::Here;
use super::meeting::Meeting;
use super::{ExtendedPrecision, Nearness, Rescue};
use crate::absolute::{disagreement, split};
use crate::double_double::DoubleDouble;
use crate::fault::{Cause, Fault};
use crate::method::{
    Context, DenseOutput, DormandPrince853, Embedded, ErrorControl, FixedLength, Length, Method,
};
use crate::scalar::{Real, Scalar};
use crate::system::{Drift, Step};
use crate::tolerances::{
    AT_POSE, AWAY, BARELY, BOX, CREEPS, FAST, LONG, MOST_CREEPING, MOST_PARTS, NEARER, SHARP, SPANS,
    TOLERANCE, TRIALS, is_double, short,
};
use crate::vector::Vector;

/// Steps in absolute coordinates, in numbers of twice the precision: by error control around singular poses, by collocation
/// over them.
#[derive(Clone, Copy, Debug)]
pub struct NearSingular<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize> {
    around: Embedded<Equations<M, NQ, NC, NX>, DormandPrince853>,
    /// Its relative tolerance where the state is not rounded by more.
    tolerance: M::S,
    /// The last step, if it was one by collocation: its beginning, and the solution over it and beyond.
    over: Option<(M::S, Polynomial<M::S, NX>)>,
    /// The part that closes the loop which went through a flat pose in the last step.
    passed: Option<&'static str>,
    /// The length of the last step, if it was one around.
    followed: Option<M::S>,
    /// Distance below which a step over the pose ahead is tried.
    tried: M::S,
    /// How often rounding would have decided.
    undecided: u32,
    /// By how much joints would have opened in the last step over the pose ahead that was tried.
    opens: M::S,
    /// Steps one after the other that lead next to nowhere.
    creeping: u32,
    /// The time until the end of a prescribed motion, by the growth of its speed, when this end was looked for last, s.
    left: M::S,
    /// Gaps of the joints in the last step, with which the mechanism reaches the singular pose.
    open: [DoubleDouble<M::S>; NC],
}

/// How much of an interval about a coordinate a step crosses next to a flat pose: of a tenth of the turn there.
#[inline]
fn crossed<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize>(
    step: &Step<'_, M>,
) -> M::S {
    if step.system.is_charted() { M::crossed(step) } else { M::S::lit(1.0 / BOX.get()) * turned(step) }
}

impl<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize>
    NearSingular<M, NQ, NC, NX>
{
    /// The equations of the last step.
    fn equations(&self, system: &M) -> Equations<M, NQ, NC, NX> {
        Equations { system: *system, open: self.open }
    }

    /// A step around a pose: one that follows its turn.
    fn step_around(
        &mut self,
        context: &mut Context<'_, M>,
        here: &Here<M, NQ, NC, NX>,
        (longest, scale): (M::S, M::S),
    ) -> Result<(), Fault> {
        let equations = &here.equations;
        self.around.longest_step = longest;
        // The rounding error of a state turns the motion by as many radians as it is parts of the turn's length.
        self.around.rtol = self.tolerance.max(M::S::EPSILON / scale);
        let (held, time, end) = (context.held, context.time, context.end);
        let told = (&mut *context.stats, &mut *context.longest_step);
        let mut inner = Context::new((equations, held), (time, here.full), end, told);
        self.around.begin(&mut inner)?;
        self.around.advance(&mut inner)?;
        let (time, mut full) = (inner.time, inner.x);
        match equations.evaluate(time, &context.held, &full) {
            Some(evaluated) if equations.is_beside(&full, &evaluated) => full = evaluated.x,
            _ => return Err(self.fault(context, here, Refused::NotFound)),
        }
        let creeps = M::S::lit(CREEPS) * (time - context.time) < end - context.time;
        self.creeping = if creeps { self.creeping + 1 } else { 0 };
        (self.over, self.followed) = (None, Some(time - context.time));
        Self::arrive(context, time, &full);
        Ok(())
    }

    /// A step over a pose, of one of some distances; why there is none otherwise.
    fn step_over(
        &mut self,
        context: &mut Context<'_, M>,
        here: &Here<M, NQ, NC, NX>,
        (times, flat): (impl Iterator<Item = M::S>, Option<M::S>),
    ) -> Result<(), Refused<M::S>> {
        let mut refused = Refused::NotFound;
        for h in times {
            let rate = here.evaluated.as_ref().map(|evaluated| &evaluated.dx);
            let (at, state) = ((context.time, &context.held), (&here.full, rate));
            match cross(&here.equations, at, state, (h, &mut context.stats.evaluations)) {
                Ok(polynomial) => {
                    let from = context.time;
                    let time = (from + h).min(context.end);
                    let full = polynomial.at((time - from) / h);
                    let passed = flat.filter(|flat| from + *flat <= time);
                    if passed.is_some() && matches!(here.meeting, Meeting::ReachedByChance) {
                        return Err(Refused::HasNoDerivative);
                    }
                    self.passed = passed.map(|_| context.system.flat_part(from, &here.full));
                    self.over = Some((from, polynomial));
                    (self.undecided, self.creeping) = (0, 0);
                    self.around.restart();
                    context.stats.steps += 1;
                    *context.longest_step = context.longest_step.max(time - from);
                    Self::arrive(context, time, &full);
                    return Ok(());
                }
                Err(Refused::NotFound) => {}
                Err(told) => refused = told,
            }
        }
        Err(refused)
    }

    fn arrive(context: &mut Context<'_, M>, time: M::S, full: &[M::S; NX]) {
        context.time = time;
        context.system.hold(&mut context.held, &mut context.x, full);
        if context.rescued.is_some_and(|until| until <= time) && is_regular(context.system, time, full) {
            context.rescued = None;
        }
    }

    /// A step over the pose that is so far ahead.
    fn meet(
        &mut self,
        context: &mut Context<'_, M>,
        here: &Here<M, NQ, NC, NX>,
        (singularity, distance): (&SingularityDistance<M::S>, M::S),
    ) -> Result<(), Refused<M::S>> {
        let flat = singularity.time_to(distance);
        // At the pose itself, to the resolution of the time, and next to it, the best known distances are those from it.
        let at = flat < BARELY.of::<M::S>() * M::S::EPSILON * context.time.abs();
        let spans = SPANS.all().into_iter().filter(|_| !at).map(|span| M::S::lit(span) * distance);
        let away = AWAY.all().into_iter().map(M::S::lit).filter(|_| distance < AT_POSE.of::<M::S>());
        let times = spans.chain(away).map(|span| singularity.time_to(span));
        self.step_over(context, here, (times, Some(flat)))
    }

    /// A state from which nothing is known but its pose and velocity.
    fn leave(&mut self, context: &mut Context<'_, M>, here: &Here<M, NQ, NC, NX>) -> Result<(), Fault> {
        let speed = (0..NQ).fold(M::S::ZERO, |most: M::S, i| {
            most.max((here.full.at(NQ + i) / here.equations.typical_of(i)).abs())
        });
        let times = AWAY.all().into_iter().map(|distance| M::S::lit(distance) / speed);
        let times = times.filter(|h| h.is_finite());
        self.step_over(context, here, (times, None)).map_err(|refused| self.fault(context, here, refused))
    }

    /// The fault that ends a run at a singular pose.
    fn fault(&self, context: &Context<'_, M>, here: &Here<M, NQ, NC, NX>, refused: Refused<M::S>) -> Fault {
        let (q, _) = split::<_, NX, NQ>(&here.full);
        if let Some(fault) = disagreement(context.system, context.time, &q) {
            return fault;
        }
        let rest = |i: usize| M::S::EPSILON * here.equations.typical_of(i - NQ);
        let moves = (NQ..2 * NQ).any(|i| here.full.at(i).abs() > rest(i));
        let cause = match refused {
            Refused::Undecided(gap) | Refused::Opens(gap) => Cause::Undecided { gap: gap.to_f64() },
            Refused::NotFound if moves => Cause::Undecided {
                gap: self.opens.max(here.equations.gap(context.time, &here.full)).to_f64(),
            },
            Refused::NotFound => Cause::Flat,
            Refused::HasNoDerivative => Cause::ChangePoint,
        };
        Fault::of_part(context.time.to_f64(), context.system.flat_part(context.time, &here.full), cause)
    }
}

impl<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize> Method<M>
    for NearSingular<M, NQ, NC, NX>
{
    #[inline]
    fn length(&self) -> Length {
        Length::NearSingular
    }

    fn advance(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        (self.passed, self.followed) = (None, None);
        context.stats.near_singular += 1;
        let mut here = Here::before(context)?;
        self.open = here.equations.open;
        let Some(singularity) = here.singularity else {
            if matches!(here.meeting, Meeting::ReachedByChance) {
                return Err(self.fault(context, &here, Refused::HasNoDerivative));
            }
            return self.leave(context, &here);
        };
        // Rounding of the pose makes steps so short, not the turn.
        if !here.follow() || self.creeping > MOST_CREEPING {
            return Err(self.fault(context, &here, Refused::NotFound));
        }
        let meeting = here.meeting;
        if !meeting.is_reached() {
            let within = M::S::lit(0.5) * self.left;
            self.left = here.left_until_lock(context, within)?.unwrap_or(self.left);
        }
        let (longest, rest) = (singularity.longest_step(), context.end - context.time);
        match singularity.distance_ahead().filter(|_| rest > longest && !matches!(meeting, Meeting::Missed)) {
            None => self.tried = M::S::INFINITY,
            Some(distance) if distance < NEARER.of::<M::S>() * self.tried => {
                match self.meet(context, &here, (&singularity, distance)) {
                    Ok(()) => return Ok(()),
                    Err(refused @ Refused::HasNoDerivative) => {
                        return Err(self.fault(context, &here, refused));
                    }
                    Err(refused @ Refused::Undecided(_)) if self.undecided == TRIALS => {
                        return Err(self.fault(context, &here, refused));
                    }
                    Err(refused) => {
                        if let Refused::Opens(gap) = refused {
                            self.opens = gap;
                        }
                        self.tried = distance;
                        self.undecided += u32::from(matches!(refused, Refused::Undecided(_)));
                    }
                }
            }
            Some(_) => {}
        }
        self.step_around(context, &here, (longest, singularity.scale())).map_err(|failed| {
            match (failed.cause, meeting) {
                (Cause::StepTooSmall { .. } | Cause::NotFinite, Meeting::Unknown) => {
                    self.fault(context, &here, Refused::NotFound)
                }
                _ => failed,
            }
        })
    }

    fn restart(&mut self) {
        self.around.restart();
        self.over = None;
        self.tried = M::S::INFINITY;
    }

    fn fresh(&self) -> Self {
        Rescue::new()
    }

    fn drift_limit(&self, _system: &M) -> Drift<M::S> {
        Drift { phi: M::S::INFINITY, phi_dot: M::S::INFINITY }
    }
}

impl<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize> DenseOutput<M>
    for NearSingular<M, NQ, NC, NX>
{
    #[inline]
    fn is_dense(&self) -> bool {
        true
    }

    fn densify(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        if self.over.is_some() {
            return Ok(());
        }
        let equations = self.equations(context.system);
        let x = context.system.full(context.time, &context.held, &context.x);
        let (held, time, end) = (context.held, context.time, context.end);
        let told = (&mut *context.stats, &mut *context.longest_step);
        let mut inner = Context::new((&equations, held), (time, x), end, told);
        self.around.densify(&mut inner)
    }

    fn moment(&self, context: &Context<'_, M>, time: M::S) -> (M::U, M::X) {
        let full = if let Some((from, polynomial)) = &self.over {
            polynomial.at((time - *from) / polynomial.h)
        } else {
            let full = self.around.interpolate(time);
            let equations = self.equations(context.system);
            equations.evaluate(time, &context.held, &full).map_or(full, |evaluated| evaluated.x)
        };
        let (mut held, mut x) = (context.held, context.x);
        context.system.hold(&mut held, &mut x, &full);
        (held, x)
    }
}

impl<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize> ErrorControl<M>
    for NearSingular<M, NQ, NC, NX>
{
    fn shorten(&mut self, h: M::S) -> bool {
        self.over = None;
        self.around.shorten(h)
    }
}

impl<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize> FixedLength<M>
    for NearSingular<M, NQ, NC, NX>
{
}

impl<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize> Rescue<M>
    for NearSingular<M, NQ, NC, NX>
{
    const POSSIBLE: bool = true;

    fn new() -> Self {
        let tolerance = TOLERANCE.of::<M::S>();
        Self {
            around: Embedded::new(tolerance),
            tolerance,
            over: None,
            passed: None,
            followed: None,
            tried: M::S::INFINITY,
            undecided: 0,
            opens: M::S::ZERO,
            creeping: 0,
            left: M::S::INFINITY,
            open: [DoubleDouble::ZERO; NC],
        }
    }

    #[inline]
    fn holds(context: &Context<'_, M>) -> bool {
        let (system, held) = (context.system, &context.held);
        let is_near = if system.is_charted() { M::is_near(held) } else { context.rescued.is_some() };
        is_near && system.may_be_singular()
    }

    #[inline]
    fn nearness(step: &Step<'_, M>, length: Length) -> Nearness {
        let charted = step.system.is_charted();
        if !step.system.may_be_singular() {
            return Nearness::Regular;
        }
        let is_singular = match length {
            Length::NearSingular => false,
            Length::Error => !charted && is_ill_conditioned(step),
            Length::Alone if charted => crossed(step) > SHARP.of::<M::S>(),
            Length::Alone => is_ill_conditioned(step),
            Length::Fixed { caution } => {
                let caution = if is_double::<M::S>() { caution } else { FAST.get() * caution };
                let crossed = M::S::lit(caution) * crossed(step);
                if crossed > LONG.of::<M::S>() {
                    return Nearness::Turn { parts: 1 + (crossed.to_f64() / short()).min(MOST_PARTS) as u32 };
                }
                !charted && is_ill_conditioned(step)
            }
        };
        if is_singular { Nearness::Singular } else { Nearness::Regular }
    }

    fn take(context: &mut Context<'_, M>) -> bool {
        if !context.system.may_be_singular() {
            return false;
        }
        let full = context.system.full(context.time, &context.held, &context.x);
        if !full.is_finite() {
            return false;
        }
        context.system.hold(&mut context.held, &mut context.x, &full);
        context.rescued = (!context.system.is_charted()).then_some(context.time);
        true
    }

    fn passed(&self) -> Option<&'static str> {
        self.passed
    }

    fn followed(&self) -> Option<M::S> {
        self.followed
    }
}
