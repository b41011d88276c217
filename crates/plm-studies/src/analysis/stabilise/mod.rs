//! Search for static equilibrium, which the manual calls stabilising.
//!
//! Unknown are the coordinates of all bodies, the multipliers of all constraint rows and the first-order states; wanted is
//! that forces balance, phi_q^T lambda = Q, that joints are closed, phi = 0, and that first-order states rest, x' = 0, all
//! at v = 0 and t = 0. Gauss and Newton's iteration on values scaled by their quantities takes, of all steps that solve the
//! linearised equations best, the shortest (A. Bjorck, Numerical Methods for Least Squares Problems, SIAM 1996, 9.2);
//! the order of importance among equations is kept by solving the later ones in the null space of those before.

mod contact;
mod dependent_states;
mod equilibrium;
mod evaluation;
mod rank;
mod report;
mod residuals;
mod scales;

use plm_runtime::{AsMoment, Cause, Fault, Linear, Mechanism, Moment, Statics, System, Vector};

pub use self::contact::Support;
use self::contact::Wrong;
use self::dependent_states::integrate_dependent;
pub use self::equilibrium::Equilibrium;
use self::evaluation::{Evaluation, Task};
use self::report::Found;
pub use self::report::{Change, Freedom, Residual, Unbalanced, What};
use self::residuals::{Point, Residuals, Setting};

/// Steps after which no equilibrium is to be expected any more.
const MOST_STEPS: u32 = 150;
/// How often the search begins again: on the sides that conditions have where it ended, or sent on along the forces.
const MOST_ROUNDS: u32 = 30;
/// How far it is sent on: rad, and parts of the mechanism's size.
const PUSH: f64 = 0.1;
/// Scaled steps below this are rounding: 1e-12 m, 1e-4 Pa.
const RESTS: f64 = 1e-9;
/// Scaled forces and rates below this are balanced.
const BALANCED: f64 = 1e-7;
/// How often a step is halved that does not lead nearer.
const HALVINGS: u32 = 12;
/// The farthest that a body moves in a step: rad, and parts of the mechanism's size.
const FARTHEST: f64 = 0.3;

/// A mechanism that can be brought to rest: generated ones can.
pub trait Stabilise: Statics + Linear<Lifted<1>: Statics> + System<S = f64> {
    /// Looks for an equilibrium near the assembled start: the manual's stabilising run (section 3.1, step 6).
    ///
    /// Locked coordinates and locked states stay as they are; what they would need for rest is said in the result, as is
    /// what nothing balances and what remains free. States whose rate is a multiple of a coordinate's rate are carried
    /// along with the coordinates. The time is zero, and the inputs are those of the declaration: with others, see
    /// [`stabilise`].
    ///
    /// # Errors
    /// When the mechanism cannot be assembled; [`Cause::Singular`] when its equations are not finite there; [`Cause::Slips`] when it would
    /// rest only with more friction than there is.
    fn stabilise(self) -> Result<Equilibrium<Self>, Fault> {
        search(self, Setting { time: 0.0, inputs: None })
    }
}

impl<M> Stabilise for M where M: Statics + Linear<Lifted<1>: Statics> + System<S = f64> {}

/// Looks for an equilibrium near the pose of a simulation, or of a state of a run, at its time and with its inputs, as
/// [`Stabilise::stabilise`] does near the start of a mechanism. Locks are those of the mechanism's starts, and hold what
/// they lock where it is.
///
/// # Errors
/// Those of [`Stabilise::stabilise`].
pub fn stabilise<A, T>(of: &A) -> Result<Equilibrium<T::M>, Fault>
where
    A: AsMoment<State = T>,
    T: Moment<M: Stabilise + Mechanism<State = T>>,
{
    let state = of.as_moment();
    let (mut mechanism, mut full) = (*state.mechanism(), <T::M as Statics>::full(state));
    let coordinates = mechanism.coordinate_names().len();
    for velocity in coordinates..2 * coordinates {
        full.set(velocity, 0.0);
    }
    *mechanism.starts_mut() = mechanism.starts_at(&full);
    search(mechanism, Setting { time: state.time(), inputs: Some(state.held()) })
}

fn search<M: Stabilise>(of: M, setting: Setting<M>) -> Result<Equilibrium<M>, Fault> {
    let mut of = of;
    if of.contact_count() > 0 {
        contact::at_rest(&mut of);
    }
    let singular = Fault::new(setting.time, Cause::Singular { rows: of.row_names().len() });
    let (_, before) = Residuals::at_start(of, &setting, &[])?;
    let (mut mechanism, mut iterations, mut stopped, mut push) = (of, 0, None, PUSH);
    let mut released = Vec::new();
    for round in 1..=MOST_ROUNDS {
        let (residuals, start) = Residuals::at_start(mechanism, &setting, &released)?;
        let mut task = Task::new(residuals, &start).ok_or(singular)?;
        // The last round only evaluates.
        let most = if round < MOST_ROUNDS { MOST_STEPS.saturating_sub(iterations) } else { 0 };
        let (evaluation, steps) = descend(&task, start, most).ok_or(singular)?;
        iterations += steps;
        let slips = contact::slips(&task.residuals, setting.time);
        mechanism = task.residuals.started_at(&evaluation.point);
        if steps > 0 {
            let Some(point) = contact::lifted(&mut task, evaluation.point.clone()) else { break };
            mechanism = task.residuals.started_at(&point);
        }
        // Conditions are on the sides that the start had; where it ended they may be on others.
        if steps > 0 && mechanism.guard_count() > 0 {
            continue;
        }
        let found = Found { task: &task, evaluation: &evaluation, before: &before };
        let mut found = found.equilibrium((mechanism, setting), iterations);
        if evaluation.first <= BALANCED && slips.is_none() {
            match contact::supports((&task, &evaluation), setting.time) {
                Ok(supports) => found.supports = supports,
                Err(Wrong::Slips(fault)) => return Err(fault),
                Err(Wrong::Pulls(row)) => {
                    released.push(row);
                    continue;
                }
            }
            return Ok(found);
        }
        // No step helps where forces have a maximum, as on a pendulum held level. They still show a way.
        match slips {
            Some(fault) => stopped = Some(Err(fault)),
            None => {
                stopped.get_or_insert(Ok(found));
            }
        }
        let point = pushed(&task, &evaluation, push);
        let Some(point) = point.and_then(|point| contact::lifted(&mut task, point)) else { break };
        mechanism = task.residuals.started_at(&point);
        if mechanism.contact_count() > 0 {
            // The floor may be far.
            push *= 2.0;
        }
    }
    stopped.unwrap_or(Err(singular))
}

/// Steps from a start as long as they lead nearer to rest, and their number. None if something is not finite.
fn descend<M: Stabilise>(task: &Task<M>, mut start: Point, most: u32) -> Option<(Evaluation, u32)> {
    task.close(&mut start)?;
    let (mut evaluation, mut steps) = (Evaluation::at(task, start)?, 0);
    while steps < most && evaluation.length > RESTS {
        let Some(next) = improve(task, &evaluation) else { break };
        evaluation = next;
        steps += 1;
    }
    Some((evaluation, steps))
}

/// The point moved on along the forces that nothing balances; none if they move nothing.
fn pushed<M: Stabilise>(task: &Task<M>, evaluation: &Evaluation, push: f64) -> Option<Point> {
    let reach = Some(reach(task, &evaluation.pushed)).filter(|reach| *reach > 0.0)?;
    let mut to = evaluation.point.clone();
    to.q += push / reach * &evaluation.pushed;
    let closed = task.close(&mut to)?;
    integrate_dependent(&task.residuals, &task.follows, &evaluation.point, &mut to);
    closed.then_some(to)
}

/// The step, or as much of it as is an improvement.
fn improve<M: Stabilise>(task: &Task<M>, evaluation: &Evaluation) -> Option<Evaluation> {
    let reach = reach(task, &evaluation.step.0);
    let mut part = if reach > FARTHEST { FARTHEST / reach } else { 1.0 };
    for _ in 0..HALVINGS {
        let mut to = evaluation.point.clone();
        to.q += part * &evaluation.step.0;
        to.x += part * &evaluation.step.1;
        if task.close(&mut to) == Some(true) {
            integrate_dependent(&task.residuals, &task.follows, &evaluation.point, &mut to);
            if let Some(next) = Evaluation::at(task, to).filter(|next| is_better(next, evaluation, part)) {
                return Some(next);
            }
        }
        part *= 0.5;
    }
    None
}

/// Is the more important part nearer to rest, or the other one if that rests already?
fn is_better(next: &Evaluation, evaluation: &Evaluation, part: f64) -> bool {
    let enough = 1.0 - 1e-4 * part;
    let at_rest = |evaluation: &Evaluation| evaluation.first <= 1e-3 * BALANCED;
    if at_rest(evaluation) {
        return at_rest(next)
            && (next.second <= enough * evaluation.second || next.length < evaluation.length);
    }
    next.first <= enough * evaluation.first
}

/// The largest turn, rad, or displacement over the size of the mechanism.
fn reach<M: Stabilise>(task: &Task<M>, moved: &nalgebra::DVector<f64>) -> f64 {
    let size = |k: usize| if k % 3 == 2 { 1.0 } else { task.scales.length };
    (0..moved.len()).map(|k| moved[k].abs() / size(k)).fold(0.0, f64::max)
}
