//! Poses so flat that rounding would rule: what is needed there, interpolated from the motion before and after.
//!
//! Near a flat pose a dyad's accelerations are lost to rounding as `eps / sin^3`. They are smooth functions of the time
//! all the same, so those at four moments around are taken, at a distance where they are worth having:
//! `f(0) = (4 (f(-h) + f(h)) - (f(-2h) + f(2h))) / 6`, wrong by a sixth of the fourth derivative times `h^4`.

use super::{Charted, is_open, locked};
use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};
use crate::vector::Vector;

/// The measure that the nearer moments should have.
const ASIDE: f64 = 0.02;
/// How often the accelerations by which the state is carried to those moments are corrected.
const ROUNDS: usize = 2;

/// Pose and velocity of all bodies, also where a loop lies flat.
pub fn pose<M: Charted>(system: &M, t: M::S, held: &M::U, x: &M::X) -> (M::Q, M::Q) {
    let (q, v, measure) = system.place(t, held, x);
    if M::S::lit(M::S::HEALTHY).lt(measure) {
        return (q, v);
    }
    let Ok((beside, rate)) = Beside::new(system, t, held, x) else { return (q, v) };
    let interpolated = beside.interpolate(x, &rate, |t, x| system.place(t, held, x).1);
    (q, if interpolated.is_finite() { interpolated } else { v })
}

/// The rate of the state where a loop lies flat.
///
/// # Errors
/// Where a loop cannot be closed, or rests.
pub fn rate_beside<M: Charted>(
    system: &M,
    t: M::S,
    held: &M::U,
    x: &M::X,
    dx: &mut M::X,
) -> Result<(), Fault> {
    let health = system.rate(t, held, x, dx);
    if !M::FOLLOWED.is_empty() && is_open(health.0) {
        // An iteration that did not converge: moments around are no nearer to where it starts.
        return Err(fault(system, t, held, x, Cause::Locked));
    }
    if !health.is_good() {
        *dx = Beside::new(system, t, held, x)?.1;
    }
    Ok(())
}

/// Moments around one.
struct Beside<S> {
    t: S,
    h: S,
    /// Number of coordinates.
    nq: usize,
}

impl<S: Real> Beside<S> {
    /// Moments at which the loops are away from flat, and the rate between them.
    fn new<M: Charted<S = S>>(system: &M, t: S, held: &M::U, x: &M::X) -> Result<(Self, M::X), Fault> {
        let velocity = |i: usize| if i < M::NQ { x.at(M::NQ + i) } else { S::lit(0.0) };
        let mut rate = M::X::from_fn(velocity);
        let typical = system.typical();
        let speed = (0..M::NQ).fold(S::lit(0.0), |speed: S, i| speed.max((rate.at(i) / typical.at(i)).abs()));
        if !S::lit(0.0).lt(speed) {
            return Err(fault(system, t, held, x, Cause::Flat));
        }
        let mut beside = Self { t, h: S::lit(ASIDE) / speed, nq: M::NQ };
        // The measure grows in proportion to the distance: one correction hits it.
        let there = beside.at(S::lit(1.0), x, &rate);
        let mut dx = rate;
        let measure = system.rate(t + beside.h, held, &there, &mut dx).0;
        if S::lit(0.0).lt(measure) {
            let factor = S::lit(ASIDE) / measure.sqrt();
            beside.h = beside.h * factor.min(S::lit(20.0)).max(S::lit(0.05));
        }
        for _ in 0..ROUNDS {
            let mut good = true;
            rate = beside.interpolate(x, &rate, |t, x| {
                let mut dx = *x;
                good &= system.rate(t, held, x, &mut dx).is_good();
                dx
            });
            if !(good && rate.is_finite()) {
                return Err(fault(system, t, held, x, Cause::Locked));
            }
            for i in 0..M::NQ {
                rate.set(i, x.at(M::NQ + i));
            }
        }
        Ok((beside, rate))
    }

    /// The state `factor h` later, by a rate: coordinates to second order.
    fn at<X: Vector<S>>(&self, factor: S, x: &X, rate: &X) -> X {
        let h = factor * self.h;
        let half = S::lit(0.5) * h * h;
        X::from_fn(|i| {
            let curved = if i < self.nq { half * rate.at(self.nq + i) } else { S::lit(0.0) };
            x.at(i) + h * rate.at(i) + curved
        })
    }

    /// A function of the motion, between those at the four moments.
    fn interpolate<X: Vector<S>, Y: Vector<S>>(&self, x: &X, rate: &X, mut f: impl FnMut(S, &X) -> Y) -> Y {
        let mut at = |factor: f64| f(self.t + S::lit(factor) * self.h, &self.at(S::lit(factor), x, rate));
        let near = at(-1.0).map2(&at(1.0), |a, b| a + b);
        let far = at(-2.0).map2(&at(2.0), |a, b| a + b);
        near.map2(&far, |near, far| (S::lit(4.0) * near - far) / S::lit(6.0))
    }
}

/// The fault of the dyad that lies flat.
fn fault<M: Charted>(system: &M, t: M::S, held: &M::U, x: &M::X, cause: Cause) -> Fault {
    let (memory, _) = system.look(t, held, x);
    let fault = locked::<M>(t, held, &memory);
    Fault { cause: if fault.cause == Cause::Locked { cause } else { fault.cause }, ..fault }
}
