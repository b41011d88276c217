//! Stabilising: a start at which the mechanism is in equilibrium.
//!
//! Unknown are the coordinates of all bodies, the multipliers of all constraint rows and the first-order states; wanted is
//! that forces balance, phi_q^T lambda = Q, that joints are closed, phi = 0, and that first-order states rest, x' = 0, all
//! at v = 0 and t = 0. Gauss and Newton's iteration on values scaled by their quantities takes, of all steps that solve the
//! linearised equations best, the shortest (A. Bjorck, Numerical Methods for Least Squares Problems, SIAM 1996, 9.2);
//! the order of importance among equations is kept by solving the later ones in the null space of those before.

mod invariant;
mod look;
mod rank;
mod report;
mod rest;
mod scales;

use std::vec::Vec;

use plm_runtime::{Cause, Fault, Linear, Sim, Statics, System, Vector};

use self::invariant::carry;
use self::look::{Look, Task};
use self::report::Found;
pub use self::report::{Change, Freedom, Residual, Unbalanced, What};
use self::rest::{Point, Rest};

/// Steps after which no equilibrium is to be expected any more.
const MOST_STEPS: u32 = 100;
/// How often a search that ended where nothing balances is sent on along the forces.
const MOST_PUSHES: u32 = 20;
/// How often conditions may change their sides.
const MOST_SIDES: u32 = 10;
/// Scaled steps below this are rounding: 1e-12 m, 1e-4 Pa.
const RESTS: f64 = 1e-9;
/// Scaled forces and rates below this are balanced.
const BALANCED: f64 = 1e-7;
/// The farthest that a body moves in a step: rad, and parts of the mechanism's size.
const FARTHEST: f64 = 0.3;

/// A mechanism that can be brought to rest: generated ones can.
pub trait Stabilise: Statics + Linear<Lifted<1>: Statics> + System<S = f64> {
    /// Looks for an equilibrium near the assembled start: the manual's stabilising run (section 3.1, step 6).
    ///
    /// Locked coordinates and locked states stay as they are; what they would need for rest is said in the result, as is
    /// what nothing balances and what remains free. States whose rate is a multiple of a coordinate's rate are carried
    /// along with the coordinates. Inputs are those of the declaration.
    ///
    /// # Errors
    /// When the mechanism cannot be assembled; [`Cause::Singular`] when its equations are not finite there.
    fn stabilise(self) -> Result<Equilibrium<Self>, Fault> {
        let (mut mechanism, mut iterations) = (self, 0);
        let (_, before) = Rest::at_start(self)?;
        for _ in 0..MOST_SIDES {
            let (rest, start) = Rest::at_start(mechanism)?;
            let singular = Fault::new(0.0, Cause::Singular { rows: Rest::<Self>::NC });
            let task = Task::new(rest, &start).ok_or(singular)?;
            let (look, steps) = search(&task, start).ok_or(singular)?;
            iterations += steps;
            mechanism = task.rest.started_at(&look.point);
            // Conditions are on the sides that the start had; at the equilibrium they may be on others.
            if steps == 0 || <Self::G as Vector<f64>>::LEN == 0 {
                return Ok(
                    Found { task: &task, look: &look, before: &before }.equilibrium(mechanism, iterations)
                );
            }
        }
        Err(Fault::new(0.0, Cause::NotConverged { step: 0.0 }))
    }
}

impl<M> Stabilise for M where M: Statics + Linear<Lifted<1>: Statics> + System<S = f64> {}

/// What a search for an equilibrium has found.
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibrium<M> {
    /// The mechanism with the equilibrium as its start; locks are those that it had.
    pub mechanism: M,
    /// What is not at rest, and what it would need.
    pub residuals: Vec<Residual>,
    /// What could be elsewhere and would rest as well; it was left as near to its start as it could be.
    pub free: Vec<Freedom>,
    /// Coordinates and states, and how far they are from where they started.
    pub values: Vec<Change>,
    /// Steps of the iteration.
    pub iterations: u32,
}

impl<M: Stabilise> Equilibrium<M> {
    /// Starts a run from here, balanced or not: the manual's "stabilising + dynamic". Locks hold at the start alone.
    ///
    /// # Errors
    /// As those of `start`.
    pub fn start(self) -> Result<Sim<M>, Fault> {
        self.mechanism.start()
    }

    /// Itself, if everything is at rest.
    ///
    /// # Errors
    /// What is not.
    pub fn balanced(self) -> Result<Self, Unbalanced> {
        if self.residuals.is_empty() { Ok(self) } else { Err(Unbalanced { residuals: self.residuals }) }
    }
}

/// From a start to where no step leads further: the last look, and the number of steps. None if something is not finite.
fn search<M: Stabilise>(task: &Task<M>, mut start: Point) -> Option<(Look, u32)> {
    task.close(&mut start)?;
    let (first, mut steps) = descend(task, Look::at(task, start)?, 0);
    if first.first <= BALANCED {
        return Some((first, steps));
    }
    // No step helps where forces have a maximum, as on a pendulum held level. They still show a way.
    let (mut point, stopped) = (first.point.clone(), steps);
    let mut pushed = first.pushed.clone();
    for _ in 0..MOST_PUSHES {
        let mut to = point.clone();
        to.q += 0.3 * FARTHEST / scaled_reach(task, &pushed).max(f64::MIN_POSITIVE) * &pushed;
        if !task.close(&mut to)? {
            break;
        }
        carry(&task.rest, &task.follows, &point, &mut to);
        let (look, all) = descend(task, Look::at(task, to)?, steps);
        steps = all;
        if look.first <= BALANCED {
            return Some((look, steps));
        }
        (point, pushed) = (look.point, look.pushed);
    }
    Some((first, stopped))
}

/// Steps as long as they lead nearer to rest.
fn descend<M: Stabilise>(task: &Task<M>, mut look: Look, mut steps: u32) -> (Look, u32) {
    while steps < MOST_STEPS && look.length > RESTS {
        let Some(next) = improve(task, &look) else { break };
        look = next;
        steps += 1;
    }
    (look, steps)
}

/// The step, or as much of it as is an improvement.
fn improve<M: Stabilise>(task: &Task<M>, look: &Look) -> Option<Look> {
    let reach = scaled_reach(task, &look.step.0);
    let mut part = if reach > FARTHEST { FARTHEST / reach } else { 1.0 };
    for _ in 0..30 {
        let mut to = look.point.clone();
        to.q += part * &look.step.0;
        to.x += part * &look.step.1;
        if task.close(&mut to) == Some(true) {
            carry(&task.rest, &task.follows, &look.point, &mut to);
            if let Some(next) = Look::at(task, to).filter(|next| is_better(next, look, part)) {
                return Some(next);
            }
        }
        part *= 0.5;
    }
    None
}

/// Is the more important part nearer to rest, or the other one if that rests already?
fn is_better(next: &Look, look: &Look, part: f64) -> bool {
    let enough = 1.0 - 1e-4 * part;
    let at_rest = |look: &Look| look.first <= 1e-3 * BALANCED;
    if at_rest(look) {
        return at_rest(next) && (next.second <= enough * look.second || next.length < look.length);
    }
    next.first <= enough * look.first
}

/// The largest turn, rad, or displacement over the size of the mechanism.
fn scaled_reach<M: Stabilise>(task: &Task<M>, moved: &nalgebra::DVector<f64>) -> f64 {
    let size = |k: usize| if k % 3 == 2 { 1.0 } else { task.scales.length };
    (0..moved.len()).map(|k| moved[k].abs() / size(k)).fold(0.0, f64::max)
}
