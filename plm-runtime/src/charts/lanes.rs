//! Checks of several states side by side: is a check due, and checks that update continuation data alone.

use super::revolutions::first_places;
use super::{Charted, ContinuationData, OfLoops, Reach, square};
use crate::scalar::Scalar;
use crate::tolerances::{BOXES, FAR, FARTHEST, FLAT, LONG, SURELY, tight};
use crate::turns::are_near;
use crate::vector::Vector;

/// 1 in the lanes where [`update`](super::update) has nothing to check yet, by the discrete state of the loops, 0 elsewhere; `typical` has
/// the typical size of each number of the state.
#[inline]
pub fn are_calm<M: Charted, T: Scalar, X: Vector<T>>(
    typical: &X,
    t: T,
    of_loops: &OfLoops<impl ContinuationData<T>, impl Sized>,
    x: &X,
) -> T {
    let (zero, one) = (T::lit(0.0), T::lit(1.0));
    let OfLoops::InChart { chart, continuation } = of_loops else { return zero };
    if !M::CHARTS.iterated.is_empty() {
        return zero;
    }
    let holds = |calm: T, at: Reach<T>, value: T| T::select((value - at.last).abs().lt(at.reach), calm, zero);
    let coordinates = continuation.coordinates().iter().enumerate();
    let calm = coordinates.fold(one, |calm, (k, &at)| {
        let ample = T::lit(BOXES.get() * tight() / M::NQ as f64) * typical.at(k);
        let reach = T::select(at.reach.lt(ample), at.reach, BOXES.of::<T>() * at.reach);
        holds(calm, Reach { reach, ..at }, x.at(k))
    });
    let calm = holds(calm, continuation.time(), t);
    if !M::CHARTS.is_loose {
        return calm;
    }
    let count = first_places(const { &M::CHARTS }, *chart).map(|k| are_near(x.at(k)));
    count.fold(calm, T::min)
}

/// 1 in the lanes where a step between two states is surely short compared with the turn next to a flat pose ([`crossed`](super::crossed)),
/// 0 elsewhere; `typical` has the typical size of each number of the state.
#[inline]
pub fn are_short<M: Charted, T: Scalar, X: Vector<T>>(
    typical: &X,
    of_loops: &OfLoops<impl ContinuationData<T>, impl Sized>,
    [before, x]: [&X; 2],
) -> T {
    let (zero, one) = (T::lit(0.0), T::lit(1.0));
    let OfLoops::InChart { continuation, .. } = of_loops else { return zero };
    continuation.coordinates().iter().enumerate().fold(one, |short, (k, &Reach { reach, .. })| {
        let moved = (x.at(k) - before.at(k)).abs();
        let if_tight = T::select(moved.lt(T::lit(SURELY.get() * LONG.get()) * reach), short, zero);
        // A coordinate that turns back is left to the check of its lane alone.
        let if_tight = T::select((before.at(M::NQ + k) * x.at(M::NQ + k)).lt(zero), zero, if_tight);
        T::select(reach.lt(T::lit(tight() / M::NQ as f64) * typical.at(k)), if_tight, short)
    })
}

/// Checks the states of the lanes in which a check is `due` (1, else 0), by their continuation data and the squares of the measures. 1 in
/// the lanes where [`update`](super::update) would do no more than store that data, which is done; 0 elsewhere.
#[inline]
pub fn look<M: Charted, T: Scalar, Y: ContinuationData<T>>(
    of_loops: &mut OfLoops<Y, impl Sized>,
    x: &impl Vector<T>,
    (after, measure): (&Y, T),
    due: T,
) -> T {
    let (zero, one) = (T::lit(0.0), T::lit(1.0));
    let OfLoops::InChart { chart, continuation: before } = of_loops else { return zero };
    let mut plain = due;
    let mut hold = |condition: T::Mask| plain = T::select(condition, plain, zero);
    // False for NaN, here and in all that follows.
    hold(square::<T>(FLAT.get()).lt(measure));
    // Zero times a number that is none is none.
    hold(after.fold(zero, |sum, number| number.mul_add(zero, sum)).lt(one));
    let far = |at: &Reach<T>| FAR.of::<T>() * at.reach.abs();
    for (before, after) in before.coordinates().iter().zip(after.coordinates()) {
        hold((after.last - before.last).abs().lt(far(before).max(far(after))));
    }
    let (since, now) = (before.time(), after.time());
    hold((now.last - since.last).abs().lt(far(&since).min(far(&now))));
    for &k in M::CHARTS.found.get(*chart).copied().unwrap_or_default() {
        if let (Some(before), Some(after)) = (before.angles().get(k), after.angles().get(k)) {
            hold((after.angle - before.angle).abs().lt(FARTHEST.of::<T>()));
        }
    }
    for count in M::CHARTS.revolutions {
        let own = count.coordinates.get(*chart).and_then(|places| places.first()).map(|&k| x.at(k));
        let angles = || after.angles().get(*count.angles.first()?).map(|turn| turn.angle);
        if let Some(angle) = own.or_else(angles) {
            hold(zero.lt(are_near(angle)));
        }
    }
    let looked = zero.lt(plain);
    before.put(after, |own, new| *own = T::select(looked, new, *own));
    plain
}
