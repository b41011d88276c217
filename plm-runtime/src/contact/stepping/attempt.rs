//! The contact problem of a time step and its solution, and an impact within the step.
//!
//! The step is made without impacts at first. If gaps close in it with a rate, it is split where the first of them closes: its first
//! part is the motion without these rows, a parabola of each gap; then the impact at the pose of that time; then a step for the rest of the
//! time. So an impact takes place at its own time to the order of the step, and the step is split once: gaps that close in the rest take
//! part in the impact.

use super::impacts::{Blow, impacts, is_fast};
use super::problem::{Problem, away, first_closing, lead_back};
use super::solver::Solved;
use super::{Motion, Solution, Stride, arrive, drift, modes, predicted, with_forces, with_responses};
use crate::contact::booked::Struck;
use crate::contact::bounds::look_at_signs;
use crate::contact::modes::{Mode, Modes};
use crate::contact::project::joints_after_step;
use crate::contact::rows::Law;
use crate::contact::{Contacts, Modal};
use crate::fault::Fault;
use crate::scalar::{Real, Scalar};
use crate::system::Rate;
use crate::vector::Vector;

/// Constants of the rows over a step.
#[derive(Clone, Copy)]
pub(super) struct Setting<S, const N: usize> {
    pub(super) laws: [Law<S>; N],
    pub(super) exists: [bool; N],
    /// Modes before the step.
    pub(super) before: Modes<S, N>,
}

impl<S: Real, const N: usize> Setting<S, N> {
    /// Of a step from a discrete state.
    #[inline]
    pub(super) fn of<M: Contacts<N> + Rate<S = S>>(system: &M, u: &M::U) -> Self {
        Self {
            laws: core::array::from_fn(|row| system.law(row)),
            exists: core::array::from_fn(|row| system.exists(u, row)),
            before: *u.modes(),
        }
    }
}

/// A step at its intermediate place, with the forces of the rows. It has the motion of its caller: a copy would cost more than the step.
pub(super) struct Attempt<'m, S: Scalar, X, const N: usize> {
    /// The last evaluation.
    motion: &'m mut Motion<S, X, N>,
    problem: Problem<S, N>,
    solved: Solved<S, N>,
    /// The state of the last evaluation, if it is not the intermediate place.
    place: Option<X>,
    rounds: u32,
    /// Free accelerations of the last evaluation: those of `motion` are over the step.
    free: [S; N],
}

/// Modes and diagnostics at the end of a step.
pub(super) struct Landed<S, const N: usize> {
    pub(super) modes: Modes<S, N>,
    pub(super) solution: Solution<S>,
}

/// A step that was split at an impact.
pub(super) struct Split<S, X, const N: usize> {
    /// The state at its end.
    pub(super) x: X,
    pub(super) landed: Landed<S, N>,
    /// The time of the impact, s.
    pub(super) time: S,
    pub(super) struck: Struck<S, N>,
}

impl<'m, S: Real, X: Vector<S>, const N: usize> Attempt<'m, S, X, N> {
    /// Solves the step whose first evaluation is `motion`.
    #[allow(clippy::inline_always, reason = "as the step, of which it is the larger part")]
    #[inline(always)]
    pub(super) fn of(
        stride: &Stride<S>,
        Setting { laws, exists, before }: &Setting<S, N>,
        motion: &'m mut Motion<S, X, N>,
    ) -> Self {
        let free = motion.rows.free;
        let problem = Problem::of(stride, (laws, exists), &mut motion.rows, before);
        let solved = problem.solve(&motion.rows);
        let rounds = solved.rounds;
        Self { motion, problem, solved, place: None, rounds, free }
    }

    /// Evaluates and solves the step again, at the state that the forces predict for the intermediate place `x`.
    #[inline]
    pub(super) fn again<M: Contacts<N> + Rate<S = S, X = X>>(
        &mut self,
        system: &M,
        stride: &Stride<S>,
        (u, x): (&M::U, &X),
        Setting { laws, exists, before }: &Setting<S, N>,
    ) -> Result<(), Fault> {
        let [ahead, _] = stride.parts();
        self.with_forces(system, stride, (u, x));
        let Self { motion, problem, solved, place, rounds, free } = self;
        let next = predicted::<M>(ahead, x, &with_responses::<M, N>(motion, &solved.lambda));
        **motion = evaluated_again(motion, system.motion_at(stride.t + ahead, u, &next));
        look_at_signs(system, stride.t, u, &motion.rows)?;
        let guess = Modes { of: solved.modes, carried: solved.carried, ..*before };
        *free = motion.rows.free;
        *problem = Problem::of(stride, (laws, exists), &mut motion.rows, &guess);
        *solved = problem.solve(&motion.rows);
        *rounds += solved.rounds;
        *place = Some(next);
        Ok(())
    }

    /// Gives first-order states the rates that they have with the forces, at the state of the last evaluation.
    #[inline]
    fn with_forces<M: Contacts<N> + Rate<S = S, X = X>>(
        &mut self,
        system: &M,
        stride: &Stride<S>,
        (u, x): (&M::U, &X),
    ) {
        let [ahead, _] = stride.parts();
        let at = (stride.t + ahead, u, self.place.as_ref().unwrap_or(x));
        with_forces(system, at, self.motion, &self.solved.lambda);
    }

    /// Rows that strike: the step closes their gap, and they come faster than accelerations make them in a step of `h`.
    #[inline]
    pub(super) fn strikes(&self, h: S, Setting { laws, exists, .. }: &Setting<S, N>) -> [bool; N] {
        let Self { motion, solved, free, .. } = self;
        core::array::from_fn(|i| {
            let approaches = exists[i] && laws[i].is_unilateral() && motion.rows.rate[i] < S::ZERO;
            let closes = solved.modes[i] == Mode::Closed || solved.carried[i];
            approaches && closes && is_fast(h, (laws, free), &motion.rows, (i, motion.rows.rate[i]))
        })
    }

    /// Moves `x`, the intermediate place, to the end of the step.
    #[allow(clippy::inline_always, reason = "as the step, of which it is the end")]
    #[inline(always)]
    pub(super) fn land<M: Contacts<N> + Rate<S = S, X = X>>(
        &mut self,
        system: &M,
        stride: &Stride<S>,
        (u, x): (&M::U, &mut X),
        (before, evaluations): (&Modes<S, N>, u32),
    ) -> Landed<S, N> {
        let modes = modes(&self.motion.rows, (stride, &self.problem), &self.solved, before);
        self.with_forces(system, stride, (u, x));
        let Self { motion, solved, rounds, .. } = self;
        let away = away(stride, &motion.rows, solved, before);
        let corrections = lead_back(&mut motion.rows, &solved.modes, &away);
        let [_, rest] = stride.parts();
        arrive::<M, N>((stride.h, rest), motion, (&solved.lambda, corrections.as_ref()), x);
        let residual = solved.residual * stride.h;
        Landed { modes, solution: Solution { residual, rounds: *rounds, evaluations, health: motion.health } }
    }

    /// Time after which the first of the rows closes that strike, before the end of the step.
    fn first_closing(&self, stride: &Stride<S>, strikes: &[bool; N]) -> S {
        let mut until = stride.h - tail::<S>() * stride.h;
        for i in 0..N {
            if strikes[i] {
                let rate = self.problem.rate_at_end(&self.solved, i);
                if let Some(time) = first_closing(stride, &self.motion.rows, (i, rate)) {
                    until = time.min(until);
                }
            }
        }
        until
    }
}

/// Makes a step with the intermediate place `x` that is split where the first of the rows closes that strike. It evaluates the step anew,
/// without these rows, and takes copies: what it would share with a step without impacts would have to stand in memory in every step.
#[cold]
#[inline(never)]
pub(super) fn split<M: Contacts<N>, const N: usize, const EVALUATIONS: usize>(
    system: &M,
    whole: Stride<M::S>,
    (u, mut x): (&M::U, M::X),
    strikes: [bool; N],
) -> Result<Split<M::S, M::X, N>, Fault> {
    let (setting, whole) = (&Setting::of(system, u), &whole);
    let [ahead, _] = whole.parts();
    let others = Setting { exists: core::array::from_fn(|i| setting.exists[i] && !strikes[i]), ..*setting };
    let mut motion = system.motion_at(whole.t + ahead, u, &x);
    let mut attempt = Attempt::of(whole, &others, &mut motion);
    for _ in 1..EVALUATIONS {
        attempt.again(system, whole, (u, &x), &others)?;
    }
    let until = attempt.first_closing(whole, &strikes);
    let [own_ahead, own_rest] = Stride { h: until, ..*whole }.parts();
    attempt.with_forces(system, whole, (u, &x));
    drift::<M>(own_ahead - ahead, &mut x);
    arrive::<M, N>((until, own_rest), attempt.motion, (&attempt.solved.lambda, None), &mut x);
    let mut blow = Blow { residual: M::S::ZERO, rounds: attempt.rounds };
    let rest = Stride { t: whole.t + until, h: whole.h - until, theta: whole.theta };
    joints_after_step(system, rest.t, u, &mut x)?;

    let mut at_impact = system.motion_at(rest.t, u, &x);
    look_at_signs(system, rest.t, u, &at_impact.rows)?;
    let struck = impacts(system, (&rest, whole.h), (setting, u), (&mut at_impact, &mut x), &mut blow)?;
    let health = motion.health.worst(at_impact.health);

    let [ahead, _] = rest.parts();
    drift::<M>(ahead, &mut x);
    motion = system.motion_at(rest.t + ahead, u, &x);
    look_at_signs(system, rest.t, u, &motion.rows)?;
    motion.health = motion.health.worst(health);
    let mut attempt = Attempt::of(&rest, setting, &mut motion);
    for _ in 1..EVALUATIONS {
        attempt.again(system, &rest, (u, &x), setting)?;
    }
    let evaluations = 3 * EVALUATIONS as u32 + 1;
    let mut landed = attempt.land(system, &rest, (u, &mut x), (&setting.before, evaluations));
    landed.solution.residual = blow.residual.max(landed.solution.residual);
    landed.solution.rounds += blow.rounds;
    Ok(Split { x, landed, time: rest.t, struck })
}

/// Shortest rest of a step after an impact, as a fraction of the step: a rest of rounding would be no step.
pub(in crate::contact) fn tail<S: Real>() -> S {
    S::EPSILON.sqrt()
}

/// The `next` evaluation of a step, with the rates of the rows for the velocity at the beginning of the step: those of `last`.
fn evaluated_again<S: Real, X, const N: usize>(
    last: &Motion<S, X, N>,
    mut next: Motion<S, X, N>,
) -> Motion<S, X, N> {
    next.rows.rate = last.rows.rate;
    next.health = next.health.worst(last.health);
    next
}
