//! Time steps with contact after J. J. Moreau and M. Jean: impulses of all rows over a step of fixed length, without events.
//!
//! With an intermediate place `q_m = q + (1 - theta) h v` at `t_m = t + (1 - theta) h`, at which everything is evaluated once,
//!
//! ```text
//! (1)  v' = v + h (a_0 + sum_j a_j lambda_j)
//! (2)  q' = q_m + theta h v'
//! (3)  z_i' = w_i v' + r_i + theta h zeta_i,  the rate of row i at the end of the step
//! ```
//!
//! (J. J. Moreau, Unilateral contact and dry friction in finite freedom dynamics, 1988, with theta = 1/2; M. Jean, The non-smooth contact
//! dynamics method, Computer Methods in Applied Mechanics and Engineering 177, 1999; V. Acary, B. Brogliato, Numerical Methods for
//! Nonsmooth Dynamical Systems, 2008, chapter 10). A gap that the step would close has `z' >= -z/(theta h)`, complementary to its contact
//! force, so that it closes at the end of the step and does not become negative; a friction has `z' = 0` or the force of its limit. A row
//! with restitution that closes so splits the step ([`attempt`]). A negative gap that (2) leaves, and a displacement of a sticking friction
//! from its place, are corrected by the constraint rows in positions alone: velocities, and so the kinetic energy, are unaffected
//! (V. Acary, Projected event-capturing time-stepping schemes for nonsmooth mechanical systems with unilateral contact and Coulomb's
//! friction, Computer Methods in Applied Mechanics and Engineering 256, 2013).
//!
//! With more evaluations than one, each but the first is at the velocity `v_m = v + (1 - theta) h (a_0 + sum_j a_j lambda_j)` that the one
//! before predicts for `t_m`, first-order states likewise: a predictor and correctors, as in C. Runge's midpoint rule (E. Hairer,
//! S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, 1993, section II.1).

mod attempt;
mod impacts;
mod packed;
mod problem;
mod smooth;
mod solver;

pub(super) use self::attempt::tail;
use self::attempt::{Attempt, Landed, Setting, split};
pub use self::packed::{Proposed, packed_steps};
pub(super) use self::problem::NO_SLIP;
use self::problem::Problem;
pub use self::smooth::{smooth_step, smooth_stride};
use self::solver::Solved;
pub(super) use self::solver::{CARRIED, DEPENDENT, ROUNDING};
use super::booked::Struck;
use super::modes::{Change, Mode, Modes};
use super::outcome::Outcome;
use super::{Contacts, Modal};
use crate::fault::Fault;
use crate::scalar::{Real, Scalar};
use crate::system::{Health, Rate};
use crate::vector::Vector;

/// A time step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stride<S> {
    /// Time at its beginning, s.
    pub t: S,
    /// Its length, s.
    pub h: S,
    /// Weight of the velocity at its end in the change of positions, 1/2 to 1.
    pub theta: S,
}

impl<S: Scalar> Stride<S> {
    /// Times from its beginning to the intermediate place and from there to its end, s.
    fn parts(&self) -> [S; 2] {
        let behind = self.theta * self.h;
        [self.h - behind, behind]
    }
}

/// Diagnostics of a step that was made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution<S> {
    /// Largest rate, m/s or rad/s, by which a law of contact is violated: rounding if the contact problem was solved.
    pub residual: S,
    /// Number of systems of equations that were solved for the modes.
    pub rounds: u32,
    /// Number of evaluations of the equations of motion.
    pub evaluations: u32,
    /// The health of the equations of motion.
    pub health: Health<S>,
}

/// Motion and rows at a state, in one pass.
#[derive(Clone, Copy, Debug)]
pub struct Motion<S, X, const N: usize> {
    /// The rate without contact forces.
    pub rate: X,
    /// Changes of the rate by unit multipliers.
    pub responses: [X; N],
    /// The rows.
    pub rows: super::Rows<S, N>,
    /// The health of the equations.
    pub health: Health<S>,
}

/// Makes a step with so many evaluations of the equations of motion; `x` becomes the state at its end, and `u` gets the modes that have led
/// there. `after` then checks or continues both; if it fails, the modes before the step are restored.
///
/// # Errors
/// Those of [`Contacts::project_joints`] and of `after`; [`Cause::ImpactGains`](crate::Cause::ImpactGains) and
/// [`Cause::NotAllowed`](crate::Cause::NotAllowed) as at events. `x` is invalid then, and `u` is unchanged.
pub fn step<M: Contacts<N>, const N: usize, const EVALUATIONS: usize>(
    system: &M,
    stride: &Stride<M::S>,
    u: &mut M::U,
    x: &mut M::X,
    after: impl FnOnce(&mut M::U, &mut M::X, &Solution<M::S>) -> Result<(), Fault>,
) -> Result<Solution<M::S>, Fault> {
    step_by::<M, N, EVALUATIONS>(system, stride, (u, x), |t, u, x| system.motion_at(t, u, x), after)
}

/// Makes a step as [`step`] does; `motion` gives the first evaluation, at the intermediate place, for its time, discrete state and state.
#[allow(
    clippy::inline_always,
    reason = "a step has one caller, on targets whose registers hold a part of it"
)]
#[inline(always)]
fn step_by<M: Contacts<N>, const N: usize, const EVALUATIONS: usize>(
    system: &M,
    stride: &Stride<M::S>,
    (u, x): (&mut M::U, &mut M::X),
    motion: impl FnOnce(M::S, &M::U, &M::X) -> Motion<M::S, M::X, N>,
    finish: impl FnOnce(&mut M::U, &mut M::X, &Solution<M::S>) -> Result<(), Fault>,
) -> Result<Solution<M::S>, Fault> {
    let ([ahead, _], end) = (stride.parts(), stride.t + stride.h);
    drift::<M>(ahead, x);
    let mut motion = motion(stride.t + ahead, u, x);
    super::bounds::look_at_signs(system, stride.t, u, &motion.rows)?;
    let setting = Setting::of(system, u);
    let mut attempt = Attempt::of(stride, &setting, &mut motion);
    for _ in 1..EVALUATIONS {
        attempt.again(system, stride, (u, x), &setting)?;
    }
    let (before, mut impact) = (&setting.before, None);
    let strikes = attempt.strikes(stride.h, &setting);
    let Landed { modes: after, solution } = if strikes.contains(&true) {
        let split = split::<M, N, EVALUATIONS>(system, *stride, (u, *x), strikes)?;
        impact = Some((split.time, split.struck));
        *x = split.x;
        split.landed
    } else {
        attempt.land(system, stride, (u, x), (before, EVALUATIONS as u32))
    };
    if !(solution.health.is_good() && x.is_finite()) {
        return finish(u, x, &solution).map(|()| solution);
    }
    super::project::joints_after_step(system, end, u, x)?;
    *u.modes_mut() = after;
    if let Err(fault) = finish(u, x, &solution) {
        *u.modes_mut() = *before;
        return Err(fault);
    }
    count(u, impact.as_ref(), before, &after);
    Ok(solution)
}

/// Replaces the rates of first-order states by those with the forces of rows, if these are not affine in the forces.
#[inline]
fn with_forces<M: Contacts<N>, const N: usize>(
    system: &M,
    (t, u, x): (M::S, &M::U, &M::X),
    motion: &mut Motion<M::S, M::X, N>,
    lambda: &[M::S; N],
) {
    if let Some(rate) = system.rate_with_forces(t, u, x, lambda) {
        for i in 2 * M::NQ..M::X::LEN {
            motion.rate.set(i, rate.at(i));
        }
    }
}

/// Rate of velocities and of first-order states with the forces of rows.
fn with_responses<M: Rate, const N: usize>(motion: &Motion<M::S, M::X, N>, lambda: &[M::S; N]) -> M::X {
    let mut rate = motion.rate;
    for i in M::NQ..2 * M::NQ {
        rate.set(i, forced(motion, i, rate.at(i), lambda));
    }
    rate
}

/// The state at the intermediate place `x`, with the velocities and first-order states that their rate gives in a time.
fn predicted<M: Rate>(time: M::S, x: &M::X, rate: &M::X) -> M::X {
    let mut place = *x;
    for i in M::NQ..M::X::LEN {
        place.set(i, time.mul_add(rate.at(i), x.at(i)));
    }
    place
}

/// Counts the changes of modes in a step, and records its impacts with their time.
fn count<S: Real, U: Modal<S, N>, const N: usize>(
    u: &mut U,
    impact: Option<&(S, Struck<S, N>)>,
    before: &Modes<S, N>,
    after: &Modes<S, N>,
) {
    let impacts = impact.map_or(0, |(_, struck)| struck.count);
    if after.of == before.of && impacts == 0 {
        return;
    }
    let mut outcome = Outcome { impacts, ..Outcome::default() };
    outcome.compare(before, after);
    outcome.is_undetermined = after.are_undetermined() && !before.are_undetermined();
    u.count(&outcome, false);
    if let (Some((time, struck)), Some(booked)) = (impact, u.booked()) {
        booked.book(time.to_f64(), struck);
    }
}

/// Advances positions with the velocities for a time.
fn drift<M: Rate>(time: M::S, x: &mut M::X) {
    for i in 0..M::NQ {
        x.set(i, time.mul_add(x.at(M::NQ + i), x.at(i)));
    }
}

/// Equations (1) and (2), from the intermediate place; positions with corrections.
fn arrive<M: Rate, const N: usize>(
    (h, behind): (M::S, M::S),
    motion: &Motion<M::S, M::X, N>,
    (lambda, corrections): (&[M::S; N], Option<&[M::S; N]>),
    x: &mut M::X,
) {
    for i in M::NQ..M::X::LEN {
        let rate = motion.rate.at(i);
        let rate = if i < 2 * M::NQ { forced(motion, i, rate, lambda) } else { rate };
        x.set(i, h.mul_add(rate, x.at(i)));
    }
    for i in 0..M::NQ {
        let v = M::NQ + i;
        let place = corrections.map_or(x.at(i), |corrections| forced(motion, v, x.at(i), corrections));
        x.set(i, behind.mul_add(x.at(v), place));
    }
}

/// A number plus the responses times their factors.
fn forced<S: Scalar, X: Vector<S>, const N: usize>(
    motion: &Motion<S, X, N>,
    i: usize,
    number: S,
    factors: &[S; N],
) -> S {
    let terms = motion.responses.iter().zip(factors);
    terms.fold(number, |sum, (response, factor)| response.at(i).mul_add(*factor, sum))
}

/// Modes after a step, and places at which frictions began to stick.
fn modes<S: Real, const N: usize>(
    rows: &super::Rows<S, N>,
    (stride, problem): (&Stride<S>, &Problem<S, N>),
    solved: &Solved<S, N>,
    before: &Modes<S, N>,
) -> Modes<S, N> {
    let sticks = |i: usize| solved.modes[i] == Mode::Sticks && before.of[i] != Mode::Sticks;
    let place = Vector::from_fn(|i| {
        if sticks(i) {
            problem::end(stride, rows, i, problem.rate_at_end(solved, i))
        } else {
            before.place[i]
        }
    });
    let Solved { modes: of, carried, negative, .. } = *solved;
    Modes { of, carried, place, orientation: S::lit(1.0), negative, change: Change::InSteps }
}
