//! Following loops along the way of an external solver.
//!
//! An external solver evaluates the mechanism at any state, which may be farther from the last check than a loop can be followed. So the
//! way from there is checked in between, on the cubic through places and velocities at both ends; if a loop cannot be followed from one
//! check to the next, the distance is halved. This changes the continuation data of the loops, and no number of the solver.

use plm_runtime::{Events, Fault, Rate, Updated, Vector};

use super::Exchanged;

/// Least distance of two checks, as a part of the way.
const NEAREST: f64 = 1.0 / 4096.0;

/// Has it loops that are followed? Those of kinematics, dyads and iterations are.
pub(super) fn has_loops<M: Exchanged>(declared: &M) -> bool {
    matches!(declared.tables().report.rung, 1 | 3 | 4)
}

/// How many event indicators there are: those of conditions, and one of the loops.
pub(super) fn indicators<M: Exchanged>(declared: &M) -> usize {
    <M as Events>::G::LEN + usize::from(has_loops(declared))
}

/// A way from the last check to where a solver is: time and state.
pub(super) struct Way<'a, M: Exchanged> {
    pub(super) system: &'a M,
    pub(super) from: (f64, M::X),
    pub(super) to: (f64, M::X),
}

/// Result of following a way.
pub(super) struct Reached<M: Exchanged> {
    pub(super) held: M::U,
    /// The time of the last check.
    pub(super) time: f64,
    pub(super) x: M::X,
    /// The loops need other coordinates from there on.
    pub(super) leaves: bool,
}

impl<M: Exchanged> Way<'_, M> {
    /// Follows to the end, with the changes after a step: the state is reduced by whole revolutions, and other coordinates are chosen at
    /// the end.
    ///
    /// # Errors
    /// A fault if a loop cannot be followed, or would need other coordinates on the way.
    pub(super) fn arrive(&self, held: M::U) -> Result<Reached<M>, Fault> {
        let (mut reached, mut shift, mut part) = (self.begin(held), M::X::fill(0.0), 1.0);
        let (mut at, mut too_far) = (0.0, None);
        loop {
            let next = f64::min(at + part, 1.0);
            let (time, point) = self.at(next);
            let point = point.map2(&shift, |x, by| x + by);
            let (mut held, mut x) = (reached.held, point);
            let outcome = self.system.update(time, &mut held, &mut x);
            match (outcome, too_far) {
                // Numbers of the solver have no meaning in other coordinates.
                (Ok(Updated { moved: true, .. }), Some(fault)) if next < 1.0 => return Err(fault),
                (Ok(Updated { moved: leaves, .. }), _) => {
                    reached = Reached { held, time, x, leaves };
                    if next >= 1.0 {
                        return Ok(reached);
                    }
                    shift = shift.map2(&x.map2(&point, |x, before| x - before), |shift, by| shift + by);
                    (at, part) = (next, 2.0 * part);
                }
                (Err(fault), _) if part <= NEAREST => return Err(fault),
                (Err(fault), _) => (part, too_far) = (0.5 * part, too_far.or(Some(fault))),
            }
        }
    }

    /// Follows as far as possible in the coordinates of the solver, without reducing angles by revolutions.
    ///
    /// # Errors
    /// A fault if a loop cannot be followed.
    pub(super) fn follow(&self, held: M::U) -> Result<Reached<M>, Fault> {
        let (mut reached, mut at, mut part) = (self.begin(held), 0.0, 1.0);
        loop {
            let next = f64::min(at + part, 1.0);
            let (time, point) = self.at(next);
            let (mut held, mut x) = (reached.held, point);
            match self.system.update(time, &mut held, &mut x) {
                Ok(Updated { moved, turned, .. }) if moved || turned => {
                    return Ok(Reached { leaves: moved, ..reached });
                }
                Ok(_) => {
                    reached = Reached { held, time, x: point, leaves: false };
                    if next >= 1.0 {
                        return Ok(reached);
                    }
                    (at, part) = (next, 2.0 * part);
                }
                Err(fault) if part <= NEAREST => return Err(fault),
                Err(_) => part *= 0.5,
            }
        }
    }

    fn begin(&self, held: M::U) -> Reached<M> {
        Reached { held, time: self.from.0, x: self.from.1, leaves: false }
    }

    /// Time and state at a part of the way. First-order states move evenly.
    fn at(&self, part: f64) -> (f64, M::X) {
        if part >= 1.0 {
            return self.to;
        }
        let ((start, from), (end, to)) = (&self.from, &self.to);
        let (h, rest, n) = (end - start, 1.0 - part, <M as Rate>::NQ);
        let even = |i: usize| rest * from.at(i) + part * to.at(i);
        let place = |i: usize| {
            let turn = rest * from.at(i + n) - part * to.at(i + n);
            let bend = (rest - part) * (to.at(i) - from.at(i));
            even(i) + part * rest * (h * turn - bend)
        };
        let speed = |i: usize| {
            let mean = (to.at(i - n) - from.at(i - n)) / h;
            even(i) + 3.0 * part * rest * (2.0 * mean - from.at(i) - to.at(i))
        };
        let x = M::X::from_fn(|i| match i {
            _ if i < n => place(i),
            // A state that is set at one moment has no speed of its own.
            _ if i < 2 * n && h != 0.0 => speed(i),
            _ => even(i),
        });
        (start + part * h, x)
    }
}
