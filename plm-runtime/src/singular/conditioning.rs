//! Poses that are far more singular than others, and whether a step in absolute coordinates has led over one.

use super::ExtendedPrecision;
use crate::absolute::{beside, smallest_pivot, split};
use crate::mechanism::Mechanism;
use crate::method::Path;
use crate::scalar::{Real, Scalar};
use crate::system::{Health, Step};
use crate::tolerances::{
    CLEAR, DESCENTS, LOOKS, LOW, MOST_LOOKS, NO_TURN, REFERENCE_POSES, REGULAR, SLOW, TURN_APART, WIDE_TURN,
    compared_apart, ill_conditioned, long_step,
};
use crate::vector::Vector;

/// The smallest pivot ratio at poses that nothing singles out, the best of some: what it is where the mechanism is regular.
fn reference_conditioning<
    M: ExtendedPrecision<NQ, NC, NX>,
    const NQ: usize,
    const NC: usize,
    const NX: usize,
>(
    system: &M,
    t: M::S,
    q: &[M::S; NQ],
) -> M::S {
    let pivot = |turns: &f64| {
        let far = beside(q, &[M::S::lit(*turns); NQ], system.length());
        smallest_pivot(system, t, &far)
    };
    REFERENCE_POSES.all().iter().map(pivot).fold(M::S::ZERO, M::S::max)
}

/// The smallest pivot ratio over a step beside that of other poses; 1 where rows always depend on each other.
#[cold]
fn relative_conditioning<
    M: ExtendedPrecision<NQ, NC, NX>,
    const NQ: usize,
    const NC: usize,
    const NX: usize,
>(
    step: &Step<'_, M>,
) -> M::S {
    let full = step.system.full(step.to.0, step.held, step.to.1);
    let reference = reference_conditioning(step.system, step.to.0, &split::<_, NX, NQ>(&full).0);
    if Health(reference).is_good() {
        lowest(step, LOW.of::<M::S>() * reference) / reference
    } else {
        M::S::lit(1.0)
    }
}

/// Has a step come to poses that are far more singular than others?
pub(super) fn is_ill_conditioned<
    M: ExtendedPrecision<NQ, NC, NX>,
    const NQ: usize,
    const NC: usize,
    const NX: usize,
>(
    step: &Step<'_, M>,
) -> bool {
    is_doubtful(step) && relative_conditioning(step) < M::S::lit(ill_conditioned())
}

/// How long a step without error control is beside the turn next to a nearly singular pose; zero where there is no such turn, and
/// where the pose is so nearly singular that the step is not to be trusted at all.
///
/// A turn takes place over the length on which the root of the pivot ratio changes by its own size. Along the motion the pivot
/// ratio is `c + k s^2`: that length is `2p/p'` on the way to the pose, `sqrt(2p/p'')` beside it.
pub(super) fn turned<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize>(
    step: &Step<'_, M>,
) -> M::S {
    let travel = travel(step);
    let regular = step.health > REGULAR.of::<M::S>() && travel < M::S::lit(long_step());
    if regular || travel < SLOW.of::<M::S>() * step.health.sqrt() {
        return M::S::ZERO;
    }
    let turn = shortest_turn(step, travel);
    if turn < WIDE_TURN.of::<M::S>() && !is_ill_conditioned(step) { travel / turn } else { M::S::ZERO }
}

/// The length of a turn where a step ends, rad; infinite where rows always depend on each other, and where the pivot ratio is so
/// large that there is none.
#[cold]
fn shortest_turn<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize>(
    step: &Step<'_, M>,
    travel: M::S,
) -> M::S {
    let (q, v) = split::<_, NX, NQ>(&step.system.full(step.to.0, step.held, step.to.1));
    let pivot = |after: M::S| {
        let q = Vector::from_fn(|i| after.mul_add(v.at(i), q.at(i)));
        smallest_pivot(step.system, step.to.0, &q)
    };
    let (half, two) = (M::S::lit(0.5), M::S::lit(2.0));
    let apart = TURN_APART.of::<M::S>().max(half * travel);
    let time = apart * (step.to.0 - step.from.0) / travel;
    let here = pivot(M::S::ZERO);
    if !Health(here).is_good() || here > NO_TURN.of::<M::S>() {
        return M::S::INFINITY;
    }
    let [behind, ahead] = [-time, time].map(pivot);
    let slope = half * (ahead - behind).abs() / apart;
    let bend = (ahead + behind - two * here).max(M::S::ZERO) / (apart * apart);
    (two * here / slope).min((two * here / bend).sqrt())
}

/// The smallest pivot ratio over a step; not the very smallest where none is below `low`.
fn lowest<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize>(
    step: &Step<'_, M>,
    low: M::S,
) -> M::S {
    let path = Path::between(step.from, step.to, M::NQ);
    let pivot = |part: M::S| {
        let full = step.system.full(path.time(part), step.held, &path.at(part));
        smallest_pivot(step.system, path.time(part), &split::<_, NX, NQ>(&full).0)
    };
    let looks = (travel(step) / M::S::lit(compared_apart())).to_f64() as usize;
    let looks = looks.clamp(LOOKS, MOST_LOOKS);
    let (mut place, mut least) = (M::S::ZERO, M::S::INFINITY);
    for k in 0..=looks {
        let part = M::S::lit(k as f64 / looks as f64);
        let here = pivot(part);
        if here < least {
            (place, least) = (part, here);
        }
    }
    if least >= low {
        return least;
    }
    // Near a singular pose it is a parabola: three places give its lowest.
    let mut apart = M::S::lit(0.25 / looks as f64);
    for _ in 0..DESCENTS {
        let [behind, ahead] = [place - apart, place + apart].map(pivot);
        let bend = ahead + behind - (least + least);
        let way = if bend > M::S::ZERO { M::S::lit(0.5) * (behind - ahead) / bend } else { M::S::ZERO };
        let next = (place + apart * way.max(M::S::lit(-4.0)).min(M::S::lit(4.0)))
            .max(M::S::ZERO)
            .min(M::S::lit(1.0));
        let here = pivot(next);
        if here < least {
            (place, least) = (next, here);
        }
        apart = M::S::lit(0.5) * apart;
    }
    least
}

/// How far a step leads, rad.
#[inline]
fn travel<M: Mechanism>(step: &Step<'_, M>) -> M::S {
    let typical = step.system.typical();
    let speed = (0..M::NQ).fold(M::S::ZERO, |most: M::S, i| {
        let of = |x: &M::X| x.at(M::NQ + i).abs();
        most.max(of(step.from.1).max(of(step.to.1)) / typical.at(i))
    });
    (step.to.0 - step.from.0) * speed
}

/// Is a pose so near to a singular one that its pivot is below this part of that at other poses?
pub(super) fn is_near<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize>(
    system: &M,
    t: M::S,
    q: &[M::S; NQ],
    part: M::S,
) -> bool {
    let here = smallest_pivot(system, t, q);
    here < part && here < part * reference_conditioning(system, t, q)
}

/// Is a state away from singular poses?
pub(super) fn is_regular<
    M: ExtendedPrecision<NQ, NC, NX>,
    const NQ: usize,
    const NC: usize,
    const NX: usize,
>(
    system: &M,
    t: M::S,
    full: &[M::S; NX],
) -> bool {
    let (q, _) = split::<_, NX, NQ>(full);
    smallest_pivot(system, t, &q)
        > M::S::lit(CLEAR.get() * ill_conditioned()) * reference_conditioning(system, t, &q)
}

/// May a step have led over poses that are nearly singular?
#[inline]
fn is_doubtful<M: Mechanism>(step: &Step<'_, M>) -> bool {
    step.health < LOW.of::<M::S>() || travel(step) > M::S::lit(long_step())
}
