//! Starts at change points: poses at which constraints depend on each other that are independent beside, so that two motions leave. The
//! compiler's `numeric/change_point.rs` is its twin.

use super::Absolute;
use super::assemble::newton;
use crate::scalar::Real;
use crate::vector::Vector;

/// Steps along the velocities, as a part of the size of the mechanism.
const STEP: f64 = 1e-3;
/// A step that is led back by more than this part of it is no motion.
const LED_BACK: f64 = 0.1;

/// Is there a motion with these velocities through a change point? A step along them is closed by what is small of second order then.
/// Without velocities there is no saying.
#[cold]
#[inline(never)]
pub(super) fn moves<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    (q, v): (&[S; NQ], &[S; NQ]),
) -> bool {
    let (one, length) = (S::lit(1.0), m.length());
    let unit = |k: usize| if k % 3 == 2 { one } else { length };
    let most = |of: &dyn Fn(usize) -> S| (0..NQ).fold(S::ZERO, |most, k| most.max(of(k).abs() / unit(k)));
    let speed = most(&|k| v.at(k));
    if speed == S::ZERO {
        return true;
    }
    let time = S::lit(STEP) / speed;
    let ahead = Vector::from_fn(|k| time.mul_add(v.at(k), q.at(k)));
    let closed = newton(m, t + time, &ahead, &[one; NQ]);
    closed.is_closed(m) && most(&|k| closed.q.at(k) - ahead.at(k)) <= S::lit(LED_BACK * STEP)
}
