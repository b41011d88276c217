//! Where no guard can come to zero: around a state and for some time, as long as what is held stays as it is.
//!
//! A step of fixed length that stays there changes no side, and none comes and goes within it: its guards need no look. What
//! they can be there is told by interval arithmetic ([`Tube`]), once for many steps.

use crate::method::Path;
use crate::scalar::Real;
use crate::sim::Begun;
use crate::system::{Leg, System};
use crate::tube::{Interval, Tube};
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

/// How far around a state, and how long; the state itself is with what a simulation keeps ([`Begun`]).
#[derive(Clone, Copy, Debug)]
pub(super) struct Calm<S> {
    /// How far from there states may go, over their sizes; where nothing is known, what is to be tried next.
    reach: S,
    /// Until when, s; always past where nothing is known.
    until: S,
    /// Steps until it is tried again.
    wait: u32,
}

impl<S: Real> Calm<S> {
    pub(super) fn new() -> Self {
        Self { reach: S::lit(FIRST), until: -S::INFINITY, wait: 0 }
    }

    /// Nothing is known.
    pub(super) fn forget(&mut self) {
        self.until = -S::INFINITY;
    }

    /// Does a step that begins there stay there, around `centre`?
    #[inline]
    pub(super) fn holds<M: System<S = S>>(&self, centre: &Begun<M>, leg: &Leg<'_, M>) -> bool {
        leg.to.0 <= self.until && *leg.held == centre.held && self.encloses(centre, leg)
    }

    /// Finds out around the end of a step, of which nothing is known yet; whether the whole step is there.
    #[cold]
    pub(super) fn renew<M: System<S = S>>(
        &mut self,
        centre: &mut Option<Begun<M>>,
        leg: &Leg<'_, M>,
    ) -> bool {
        if self.wait > 0 {
            self.wait -= 1;
            return false;
        }
        if self.until > -S::INFINITY {
            self.reach = (self.reach + self.reach).min(S::lit(WIDEST));
        }
        let around = centre.insert(Begun { time: leg.from.0, held: *leg.held, x: *leg.to.1 });
        self.until = leg.to.0 + (leg.to.0 - leg.from.0) * S::lit(LASTING) * self.reach;
        let begins = (0..M::X::LEN).all(|i| self.reaches(leg.system, around, (i, leg.from.1.at(i))));
        let calm = begins && self.encloses(around, leg) && self.is_calm(leg.system, around);
        if !calm {
            self.forget();
            self.reach = S::lit(0.25) * self.reach;
            if self.reach < S::lit(NARROWEST) {
                (self.reach, self.wait) = (S::lit(NARROWEST), WAIT);
            }
        }
        calm
    }

    /// Is the path of a step within reach, that begins there?
    #[inline]
    fn encloses<M: System<S = S>>(&self, centre: &Begun<M>, leg: &Leg<'_, M>) -> bool {
        Path::between_stays(leg.from, leg.to, M::NQ, |i, x| self.reaches(leg.system, centre, (i, x)))
    }

    /// Is a value of a component within reach? False for what is not a number.
    #[inline]
    fn reaches<M: System<S = S>>(&self, system: &M, centre: &Begun<M>, (i, x): (usize, S)) -> bool {
        let middle = centre.x.at(i);
        (x - middle).abs() <= self.reach * (system.typical().at(i) + middle.abs())
    }

    /// Do all guards stay on their sides within reach?
    fn is_calm<M: System<S = S>>(&self, system: &M, centre: &Begun<M>) -> bool {
        let still = |middle, value| Tube { middle, value, slope: Interval::point(S::ZERO) };
        let (typical, reach) = (system.typical(), S::lit(SLACK) * self.reach);
        let around = |i: usize| {
            let middle = centre.x.at(i);
            let radius = reach * (typical.at(i) + middle.abs());
            still(middle, Interval::between(middle - radius, middle + radius))
        };
        let time = still(centre.time, Interval::between(centre.time, self.until));
        let mut calm = true;
        let known = system.guards_within(time, &centre.held, &around, &mut |i, tube: Tube<S>| {
            if i < M::G::LEN {
                // Slopes are those of what does not move: ranges alone tell something.
                calm &= tube.value.low >= -system.band(i) && tube.value.high < S::INFINITY;
            }
        });
        known && calm
    }
}
