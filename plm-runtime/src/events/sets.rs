//! Events that set states: items `when` of a declaration.
//!
//! An event changes a side of a condition, or the modes of contact. Every condition of an item that becomes true by it sets states, which
//! may make others true; this ends when none becomes true.

use super::guards;
use crate::absolute::{self, Absolute};
use crate::fault::{Cause, Fault, Names};
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Most rounds in which events follow each other at once.
const MOST_ROUNDS: u32 = 100;
/// Units in the last place that count as rounding.
const MANY: f64 = 1024.0;

/// A mechanism with `W` events that set states; implemented by generated code.
pub trait Sets<const W: usize>: System<S: Real> {
    /// Number of conditions of the state: their guards and their sides come first.
    const CONDITIONS: usize;

    /// Number of these conditions: `CONDITIONS`, or fewer of a system that has its size from a program.
    #[inline]
    fn condition_count(&self) -> usize {
        Self::CONDITIONS
    }

    /// Sides of all conditions in the discrete state.
    fn sides(u: &mut Self::U) -> &mut [Self::S];

    /// True for each event whose condition is satisfied, by the sides in the discrete state.
    fn holds(&self, u: &Self::U) -> [bool; W];

    /// Sets the states of the event `index`, each to a value computed from the state before.
    ///
    /// # Errors
    /// When joints do not allow the velocities.
    fn set(&self, t: Self::S, u: &mut Self::U, x: &mut Self::X, index: usize) -> Result<(), Fault>;

    /// Finds the modes of contacts again, if something was set since the discrete state was `before`.
    ///
    /// # Errors
    /// When contacts have no mode.
    fn settle(&self, t: Self::S, before: &Self::U, u: &mut Self::U, x: &mut Self::X) -> Result<(), Fault> {
        let _ = (t, before, u, x);
        Ok(())
    }
}

/// Commits a `change` of sides or modes, then the events that become true by it.
///
/// # Errors
/// Those of the change and of [`Sets`]; [`Cause::Zeno`] if events follow each other without end.
pub fn change<M: Sets<W>, const W: usize>(
    system: &M,
    t: M::S,
    u: &mut M::U,
    x: &mut M::X,
    change: impl FnOnce(&mut M::U, &mut M::X) -> Result<(), Fault>,
) -> Result<(), Fault> {
    let (mut beginning, start) = (*u, *x);
    let mut held = system.holds(u);
    let mut before = differences(system, t, u, x);
    change(u, x)?;
    // If a mode of contact has changed, as of a row that sticks, a difference becomes zero, which is a jump however small.
    if is_rounding(system, &start, x) && M::contacts(&beginning).has_modes_of(&M::contacts(u)) {
        let here = differences(system, t, u, x);
        keep_changed(&mut before, (M::sides(&mut beginning), M::sides(u)), &here);
    }
    let mut is_settled = true;
    for _ in 0..MOST_ROUNDS {
        let (has_followed, here) = follow(system, t, u, x, &before);
        is_settled &= !has_followed;
        let now = system.holds(u);
        let due: [bool; W] = core::array::from_fn(|k| now[k] && !held[k]);
        (held, before) = (now, here);
        if due.contains(&true) {
            for k in (0..W).filter(|k| due[*k]) {
                system.set(t, u, x, k)?;
            }
            is_settled = false;
        } else if is_settled {
            return Ok(());
        } else {
            // Contacts read the sides that follow from the new states.
            system.settle(t, &beginning, u, x)?;
            is_settled = true;
        }
    }
    let after = differences(system, t, u, x);
    let marks: [bool; 64] =
        core::array::from_fn(|k| k < system.condition_count() && changed(&before, &after, k));
    let conditions = Names::marked(system.conditions(), &marks);
    let first = marks.iter().position(|due| *due).unwrap_or(0);
    let cause = Cause::Zeno { events: MOST_ROUNDS, within: 0.0, conditions };
    Err(Fault::of_part(t.to_f64(), system.guard_name(first), cause))
}

/// Takes the sides of all conditions of the state at the start of a run, without the events of conditions that become true.
pub fn begin<M: Sets<W>, const W: usize>(system: &M, t: M::S, u: &mut M::U, x: &M::X) {
    take_sides(system, t, u, x, (system.condition_count(), M::sides));
}

/// Takes the sides of conditions as [`begin`] does, for systems without events that set states: `sides` gives the sides of all
/// conditions, the first `conditions` of which are of the state.
pub fn take_sides<M: System<S: Real>>(
    system: &M,
    t: M::S,
    u: &mut M::U,
    x: &M::X,
    (conditions, sides): (usize, impl Fn(&mut M::U) -> &mut [M::S]),
) {
    // The side of one may change the value that another compares.
    for _ in 0..=conditions {
        let here = guards(system, t, u, x);
        let mut any = false;
        for k in (0..conditions).filter(|k| here.at(*k) < M::S::ZERO && !system.must_hold(*k)) {
            if let Some(side) = sides(u).get_mut(k) {
                *side = -*side;
                any = true;
            }
        }
        if !any {
            return;
        }
    }
}

/// Values that the conditions of the state compare: below zero if the condition is true.
fn differences<M: Sets<W>, const W: usize>(system: &M, t: M::S, u: &M::U, x: &M::X) -> M::G {
    let (guards, mut held) = (guards(system, t, u, x), *u);
    let sides = M::sides(&mut held);
    M::G::from_fn(|k| match sides.get(k) {
        Some(side) if k < system.condition_count() => *side * guards.at(k),
        _ => M::S::ZERO,
    })
}

fn changed<G: Vector<S>, S: Real>(before: &G, after: &G, k: usize) -> bool {
    before.at(k) != after.at(k)
}

/// True if a change has moved the state by no more than rounding, as impulses do that satisfy joints again.
fn is_rounding<M: System<S: Real>>(system: &M, before: &M::X, x: &M::X) -> bool {
    let least = M::S::lit(MANY) * M::S::EPSILON;
    let typical = system.typical();
    (0..M::X::LEN).all(|i| (x.at(i) - before.at(i)).abs() <= least * (typical.at(i) + x.at(i).abs()))
}

/// Replaces the values of conditions to which a change has given other sides by those after it: they are rounding, of either sign.
fn keep_changed<G: Vector<S>, S: Real>(before: &mut G, (old, new): (&[S], &[S]), here: &G) {
    for (k, _) in old.iter().zip(new).enumerate().filter(|(_, (old, new))| old != new) {
        before.set(k, here.at(k));
    }
}

/// Gives conditions whose values have jumped the sides of the new values. Returns true if a side has changed, and the values then. The
/// condition of the event itself has not jumped: its value is rounding.
fn follow<M: Sets<W>, const W: usize>(
    system: &M,
    t: M::S,
    u: &mut M::U,
    x: &M::X,
    before: &M::G,
) -> (bool, M::G) {
    let mut has_followed = false;
    for _ in 0..=system.condition_count() {
        let after = differences(system, t, u, x);
        let mut any = false;
        for k in
            (0..system.condition_count()).filter(|k| changed(before, &after, *k) && !system.must_hold(*k))
        {
            let side = M::S::lit(if after.at(k) < M::S::ZERO { -1.0 } else { 1.0 });
            if let Some(held) = M::sides(u).get_mut(k).filter(|held| **held != side) {
                *held = side;
                any = true;
            }
        }
        has_followed |= any;
        if !any {
            return (has_followed, after);
        }
    }
    (has_followed, differences(system, t, u, x))
}

/// Velocities of all bodies after some have been set, by number. The joints require changes of the others, which are the least in the
/// metric of the masses, as those by impulses.
///
/// # Errors
/// [`Cause::VelocityOpen`] if joints do not allow them.
pub fn with_velocities<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    (q, v): (&[S; NQ], &[S; NQ]),
    set: &[(usize, S)],
) -> Result<[S; NQ], Fault> {
    let (mut v, mut weights) = (*v, m.inverse_mass());
    for (k, value) in set {
        v.set(*k, *value);
        weights.set(*k, S::ZERO);
    }
    absolute::allow(m, t, q, &mut v, &weights)?;
    Ok(v)
}
