//! Guard-free region: a box of states and a time span in which no event can occur while the discrete state is unchanged.
//!
//! A fixed step inside the region cannot trigger an event, so its guards are not evaluated. Interval arithmetic ([`Enclosed`]) bounds every
//! guard over the region once; later steps reuse the bound.

use super::Beginning;
use crate::enclosure::{Enclosed, Interval};
use crate::method::Path;
use crate::scalar::Real;
use crate::system::{Step, System};
use crate::vector::Vector;

/// How far states may go from where they are, over their sizes: at first, ...
const FIRST: f64 = 1.0 / 16.0;
/// ... where guards are far, ...
const WIDEST: f64 = 0.5;
/// ... and where they are near; nearer ones are looked at in every step, ...
const NARROWEST: f64 = 1.0 / 1024.0;
/// ... so many times, and then this is tried again.
const WAIT: u32 = 64;
/// How long that lasts, in steps, over the reach: guards may depend on the time alone.
const LASTING: f64 = 4096.0;
/// Guards are enclosed a little farther than states may go, for what rounding makes of the difference.
const SLACK: f64 = 1.0 + 1.0 / 256.0;

/// The size of the region and its end in time; its centre is with the history of a run ([`Beginning`]).
#[derive(Clone, Copy, Debug)]
pub(super) struct GuardFree<S> {
    /// How far from there states may go, over their sizes; where nothing is known, what is to be tried next.
    reach: S,
    /// Until when, s; always past where nothing is known.
    until: S,
    /// Steps until it is tried again.
    wait: u32,
}

impl<S: Real> GuardFree<S> {
    pub(super) fn new() -> Self {
        Self { reach: S::lit(FIRST), until: -S::INFINITY, wait: 0 }
    }

    /// Nothing is known.
    pub(super) fn forget(&mut self) {
        self.until = -S::INFINITY;
    }

    /// Does a step that begins there stay there, around `centre`?
    #[inline]
    pub(super) fn holds<M: System<S = S>>(&self, centre: &Beginning<M>, step: &Step<'_, M>) -> bool {
        step.to.0 <= self.until && *step.held == centre.held && self.encloses(centre, step)
    }

    /// Finds out around the end of a step, of which nothing is known yet; whether the whole step is there.
    #[cold]
    pub(super) fn renew<M: System<S = S>>(
        &mut self,
        centre: &mut Option<Beginning<M>>,
        step: &Step<'_, M>,
    ) -> bool {
        if self.wait > 0 {
            self.wait -= 1;
            return false;
        }
        if self.until > -S::INFINITY {
            self.reach = (self.reach + self.reach).min(S::lit(WIDEST));
        }
        let around = centre.insert(Beginning { time: step.from.0, held: *step.held, x: *step.to.1 });
        self.until = step.to.0 + (step.to.0 - step.from.0) * S::lit(LASTING) * self.reach;
        let begins = (0..M::X::LEN).all(|i| self.reaches(step.system, around, (i, step.from.1.at(i))));
        let guard_free = begins && self.encloses(around, step) && self.excludes_events(step.system, around);
        if !guard_free {
            self.forget();
            self.reach = S::lit(0.25) * self.reach;
            if self.reach < S::lit(NARROWEST) {
                (self.reach, self.wait) = (S::lit(NARROWEST), WAIT);
            }
        }
        guard_free
    }

    /// Is the path of a step within reach, that begins there?
    #[inline]
    fn encloses<M: System<S = S>>(&self, centre: &Beginning<M>, step: &Step<'_, M>) -> bool {
        let within = |i, x| self.reaches(step.system, centre, (i, x));
        let (coordinates, states) = (step.system.coordinates(), step.system.states());
        if states < M::X::LEN {
            // What there is only room for is zero, at the centre too.
            let first_order = 2 * M::NQ..2 * M::NQ + states - 2 * coordinates;
            let all = [0..coordinates, M::NQ..M::NQ + coordinates, first_order];
            return Path::between_stays(step.from, step.to, (M::NQ, coordinates, all), within);
        }
        Path::between_stays(step.from, step.to, (M::NQ, M::NQ, [0..M::X::LEN, 0..0, 0..0]), within)
    }

    /// Is a value of a component within reach? False for what is not a number.
    #[inline]
    fn reaches<M: System<S = S>>(&self, system: &M, centre: &Beginning<M>, (i, x): (usize, S)) -> bool {
        let middle = centre.x.at(i);
        (x - middle).abs() <= self.reach * (system.typical_at(i) + middle.abs())
    }

    /// Do all guards stay on their sides within reach?
    fn excludes_events<M: System<S = S>>(&self, system: &M, centre: &Beginning<M>) -> bool {
        let enclosure = |middle, value| Enclosed { middle, value, slope: Interval::point(S::ZERO) };
        let (typical, reach) = (system.typical(), S::lit(SLACK) * self.reach);
        let around = |i: usize| {
            let middle = centre.x.at(i);
            let radius = reach * (typical.at(i) + middle.abs());
            enclosure(middle, Interval::between(middle - radius, middle + radius))
        };
        let time = enclosure(centre.time, Interval::between(centre.time, self.until));
        let mut guard_free = true;
        let known = system.guards_within(time, &centre.held, &around, &mut |i, guard: Enclosed<S>| {
            if i < M::G::LEN {
                // Slopes are those of what does not move: ranges alone tell something.
                guard_free &= guard.value.low >= -system.band(i) && guard.value.high < S::INFINITY;
            }
        });
        known && guard_free
    }
}
