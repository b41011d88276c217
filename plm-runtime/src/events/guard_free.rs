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

/// Reach of the region about its centre, relative to the sizes of states: at first, ...
const FIRST: f64 = 1.0 / 16.0;
/// ... at most, while guards are far, ...
const WIDEST: f64 = 0.5;
/// ... and at least. If guards are nearer, they are evaluated in every step, ...
const NARROWEST: f64 = 1.0 / 1024.0;
/// ... so many times before this reach is tried again.
const WAIT: u32 = 64;
/// Duration of the region in steps, for a reach of 1: guards may depend on time alone.
const LASTING: f64 = 4096.0;
/// Factor of the reach within which guards are enclosed, for the rounding of the difference.
const SLACK: f64 = 1.0 + 1.0 / 256.0;

/// Size of the region and its end in time; its centre is in the history of a run ([`Beginning`]).
#[derive(Clone, Copy, Debug)]
pub(super) struct GuardFree<S> {
    /// Largest distance of states from the centre, relative to their sizes; without a region, the value to be tried next.
    reach: S,
    /// End of the region, s; in the past without a region.
    until: S,
    /// Steps until a region is tried again.
    wait: u32,
}

impl<S: Real> GuardFree<S> {
    pub(super) fn new() -> Self {
        Self { reach: S::lit(FIRST), until: -S::INFINITY, wait: 0 }
    }

    /// Forgets the region.
    pub(super) fn forget(&mut self) {
        self.until = -S::INFINITY;
    }

    /// True if a step that begins in the region around `centre` stays in it.
    #[inline]
    pub(super) fn holds<M: System<S = S>>(&self, centre: &Beginning<M>, step: &Step<'_, M>) -> bool {
        step.to.0 <= self.until && *step.held == centre.held && self.encloses(centre, step)
    }

    /// Determines the region around the end of a step, if there is one. Returns true if the whole step is in it.
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

    /// True if the path of a step that begins within reach stays within reach.
    #[inline]
    fn encloses<M: System<S = S>>(&self, centre: &Beginning<M>, step: &Step<'_, M>) -> bool {
        let within = |i, x| self.reaches(step.system, centre, (i, x));
        let (coordinates, states) = (step.system.coordinates(), step.system.states());
        if states < M::X::LEN {
            // Components that there is only room for are zero, at the centre too.
            let first_order = 2 * M::NQ..2 * M::NQ + states - 2 * coordinates;
            let all = [0..coordinates, M::NQ..M::NQ + coordinates, first_order];
            return Path::between_stays(step.from, step.to, (M::NQ, coordinates, all), within);
        }
        Path::between_stays(step.from, step.to, (M::NQ, M::NQ, [0..M::X::LEN, 0..0, 0..0]), within)
    }

    /// True if a value of a component is within reach; false for NaN.
    #[inline]
    fn reaches<M: System<S = S>>(&self, system: &M, centre: &Beginning<M>, (i, x): (usize, S)) -> bool {
        let middle = centre.x.at(i);
        (x - middle).abs() <= self.reach * (system.typical_at(i) + middle.abs())
    }

    /// True if all guards stay on their sides within reach.
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
                // Slopes are those of constants: only the ranges have a meaning.
                guard_free &= guard.value.low >= -system.band(i) && guard.value.high < S::INFINITY;
            }
        });
        known && guard_free
    }
}
