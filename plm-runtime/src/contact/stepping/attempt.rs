//! The contact problem of a time step and its solution, and an impact within the step.
//!
//! The step is made without impacts at first. If gaps close in it with a rate, it is split where the first of them closes: its first
//! part is the motion without these rows, a parabola of each gap; then the impact at the pose of that time; then a step for the rest of the
//! time. So an impact takes place at its own time to the order of the step, and the step is split once: gaps that close in the rest take
//! part in the impact. It takes one evaluation more for the impact, and those of a step for the rest.

use super::impacts::{Blow, impacts, is_fast};
use super::problem::{Problem, first_closing};
use super::solver::Solved;
use super::{Motion, Stride, arrive, drift, predicted, with_forces, with_responses};
use crate::contact::Contacts;
use crate::contact::booked::Struck;
use crate::contact::bounds::look_at_signs;
use crate::contact::modes::{Mode, Modes};
use crate::contact::rows::Law;
use crate::fault::Fault;
use crate::scalar::{Real, Scalar};
use crate::system::Rate;

/// Constants of the rows over a step.
#[derive(Clone, Copy)]
pub(super) struct Setting<S, const N: usize> {
    pub(super) laws: [Law<S>; N],
    pub(super) exists: [bool; N],
    /// Modes before the step.
    pub(super) before: Modes<S, N>,
}

/// A step at its intermediate place, with the forces of the rows.
pub(super) struct Attempt<S: Scalar, X, const N: usize> {
    /// The last evaluation.
    pub(super) motion: Motion<S, X, N>,
    pub(super) problem: Problem<S, N>,
    pub(super) solved: Solved<S, N>,
    /// The state of the last evaluation, if it is not the intermediate place.
    pub(super) place: Option<X>,
    /// The largest residual of impacts, as a rate.
    pub(super) residual: S,
    pub(super) rounds: u32,
    pub(super) evaluations: u32,
    /// Free accelerations of the last evaluation: those of `motion` are over the step.
    free: [S; N],
}

impl<S: Real, X: crate::vector::Vector<S>, const N: usize> Attempt<S, X, N> {
    /// Solves the step with the intermediate place `x`, at which the first evaluation is.
    #[allow(clippy::inline_always, reason = "as the step, of which it is the larger part")]
    #[inline(always)]
    pub(super) fn of<M: Contacts<N> + Rate<S = S, X = X>, const EVALUATIONS: usize>(
        system: &M,
        stride: &Stride<S>,
        (u, x): (&M::U, &X),
        setting: &Setting<S, N>,
        mut motion: Motion<S, X, N>,
    ) -> Result<Self, Fault> {
        let ([ahead, _], Setting { laws, exists, before }) = (stride.parts(), setting);
        look_at_signs(system, stride.t, u, &motion.rows)?;
        let mut free = motion.rows.free;
        let mut problem = Problem::of(stride, (laws, exists), &mut motion.rows, before);
        let mut solved = problem.solve(&motion.rows);
        let (mut place, mut rounds) = (None, solved.rounds);
        for _ in 1..EVALUATIONS {
            let last = place.as_ref().unwrap_or(x);
            with_forces(system, (stride.t + ahead, u, last), &mut motion, &solved.lambda);
            let next = predicted::<M>(ahead, x, &with_responses::<M, N>(&motion, &solved.lambda));
            motion = evaluated_again(&motion, system.motion_at(stride.t + ahead, u, &next));
            look_at_signs(system, stride.t, u, &motion.rows)?;
            let guess = Modes { of: solved.modes, carried: solved.carried, ..*before };
            free = motion.rows.free;
            problem = Problem::of(stride, (laws, exists), &mut motion.rows, &guess);
            solved = problem.solve(&motion.rows);
            rounds += solved.rounds;
            place = Some(next);
        }
        let evaluations = EVALUATIONS as u32;
        Ok(Self { motion, problem, solved, place, residual: S::ZERO, rounds, evaluations, free })
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

    /// Splits the step where the first of the rows closes that strike. `stride` becomes the rest of it, `x` its intermediate place.
    #[cold]
    #[inline(never)]
    pub(super) fn split<M: Contacts<N> + Rate<S = S, X = X>, const EVALUATIONS: usize>(
        &mut self,
        system: &M,
        stride: &mut Stride<S>,
        (u, x): (&M::U, &mut X),
        (setting, strikes): (&Setting<S, N>, &[bool; N]),
    ) -> Result<Struck<S, N>, Fault> {
        let ([ahead, _], whole) = (stride.parts(), *stride);
        self.solve_without::<M, EVALUATIONS>(system, stride, (u, x), (setting, strikes))?;
        let until = self.first_closing(stride, strikes);
        let first = Stride { h: until, ..whole };
        let [own_ahead, own_rest] = first.parts();
        with_forces(
            system,
            (whole.t + ahead, u, self.place.as_ref().unwrap_or(x)),
            &mut self.motion,
            &self.solved.lambda,
        );
        drift::<M>(own_ahead - ahead, x);
        arrive::<M, N>((until, own_rest), &self.motion, (&self.solved.lambda, None), x);

        let rest = Stride { t: whole.t + until, h: whole.h - until, theta: whole.theta };
        let mut motion = system.motion_at(rest.t, u, x);
        look_at_signs(system, rest.t, u, &motion.rows)?;
        let mut blow = Blow { residual: self.residual, rounds: self.rounds };
        let struck = impacts(system, (&rest, whole.h), (setting, u), (&mut motion, x), &mut blow)?;
        let health = self.motion.health.worst(motion.health);

        let [ahead, _] = rest.parts();
        drift::<M>(ahead, x);
        let motion = system.motion_at(rest.t + ahead, u, x);
        let evaluations = self.evaluations + 1;
        *self = Self::of::<M, EVALUATIONS>(system, &rest, (u, x), setting, motion)?;
        self.motion.health = self.motion.health.worst(health);
        self.residual = self.residual.max(blow.residual);
        (self.rounds, self.evaluations) = (self.rounds + blow.rounds, self.evaluations + evaluations);
        *stride = rest;
        Ok(struck)
    }

    /// Becomes the step without rows that strike.
    fn solve_without<M: Contacts<N> + Rate<S = S, X = X>, const EVALUATIONS: usize>(
        &mut self,
        system: &M,
        stride: &Stride<S>,
        (u, x): (&M::U, &X),
        (setting, strikes): (&Setting<S, N>, &[bool; N]),
    ) -> Result<(), Fault> {
        let exists = core::array::from_fn(|i| setting.exists[i] && !strikes[i]);
        let setting = Setting { exists, ..*setting };
        if EVALUATIONS > 1 {
            // The velocity of the further evaluations was that with the forces of these rows.
            let [ahead, _] = stride.parts();
            let motion = system.motion_at(stride.t + ahead, u, x);
            let (rounds, evaluations) = (self.rounds, self.evaluations);
            *self = Self::of::<M, EVALUATIONS>(system, stride, (u, x), &setting, motion)?;
            (self.rounds, self.evaluations) = (self.rounds + rounds, self.evaluations + evaluations);
            return Ok(());
        }
        let Setting { laws, exists, before } = &setting;
        self.motion.rows.free = self.free;
        self.problem = Problem::of(stride, (laws, exists), &mut self.motion.rows, before);
        self.solved = self.problem.solve(&self.motion.rows);
        self.rounds += self.solved.rounds;
        Ok(())
    }

    /// Time after which the first of the rows closes that strike, before the end of the step.
    fn first_closing(&self, stride: &Stride<S>, strikes: &[bool; N]) -> S {
        let latest = stride.h - tail::<S>() * stride.h;
        let closings = strikes.iter().enumerate().filter(|(_, strikes)| **strikes);
        closings.fold(latest, |until, (i, _)| {
            let rate = self.problem.rate_at_end(&self.solved, i);
            first_closing(stride, &self.motion.rows, (i, rate)).map_or(until, |time| time.min(until))
        })
    }
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
