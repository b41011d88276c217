//! The end of a prescribed motion by its speed, which exceeds every bound there.
//!
//! Before a fold at the time `t*` a motion is `q* - c sqrt(t* - t)` (W. J. F. Govaerts, Numerical Methods for Bifurcations of Dynamical
//! Equilibria, SIAM 2000, 4.1), however many loops become flat there. The square of its inverse speed falls linearly to zero: Newton's
//! step to that zero is `v.v / (2 v.a)`. A motion that passes a pose by leaves this law before.

use super::ExtendedPrecision;
use super::critical::Rows;
use super::equations::Evaluated;
use super::here::Here;
use super::lock::resolution;
use crate::absolute::split;
use crate::double_double::DoubleDouble;
use crate::fault::Fault;
use crate::linalg::largest;
use crate::method::Context;
use crate::scalar::{Real, Scalar};
use crate::tolerances::{HELD, LIMIT_PARTS, LIMIT_STEPS, ON_THE_WAY, UNDECIDED};
use crate::vector::Vector;

/// A moment on the way to the end. Next to the end a rounded pose has few digits of its velocity.
struct Moment<S, const NX: usize> {
    time: S,
    x: [DoubleDouble<S>; NX],
    /// The time that is left.
    left: S,
}

impl<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize>
    Here<M, NQ, NC, NX>
{
    /// The time that is left until a prescribed motion would end by the growth of its speed, s; none if it is not less than `within`, or
    /// longer than the interval.
    ///
    /// # Errors
    /// [`Cause::LockedAt`](crate::Cause::LockedAt) if it ends within the interval.
    pub(super) fn left_until_lock(
        &self,
        context: &mut Context<'_, M>,
        within: M::S,
    ) -> Result<Option<M::S>, Fault> {
        let Some(left) = self.evaluated.as_ref().and_then(|here| self.left(here)) else { return Ok(None) };
        if left < within && context.time + left < context.end {
            self.speeds_without_bound(context, left)?;
            return Ok(Some(left));
        }
        Ok(None)
    }

    #[cold]
    #[inline(never)]
    fn speeds_without_bound(&self, context: &mut Context<'_, M>, left: M::S) -> Result<(), Fault> {
        let (system, time) = (context.system, context.time);
        let (extended, _) = system.extended_with_inputs(&context.held);
        let (q, _) = split::<_, NX, NQ>(&self.full);
        let at = Vector::from_fn(|i| DoubleDouble::of(q[i]));
        let Some(rows) = Rows::<M, NQ, NC, NX>::at(system, &extended, time, &at) else { return Ok(()) };
        let rate = largest(&rows.driven(time, &q));
        if rate <= M::S::ZERO {
            return Ok(());
        }
        let x = Vector::from_fn(|i| DoubleDouble::of(self.full[i]));
        let undecided = UNDECIDED.of::<M::S>() * M::S::EPSILON * system.length() / rate;
        let Some(last) = self.follow_to_end(context, Moment { time, x, left }, undecided) else {
            return Ok(());
        };
        let end = last.time + last.left;
        if end - resolution((time, end)) > context.end {
            return Ok(());
        }
        let way = DoubleDouble::of(last.left + last.left);
        let q: [M::S; NQ] = Vector::from_fn(|i| (last.x.at(i) + way * last.x.at(NQ + i)).rounded());
        Err(rows.locked_at((end, system.flat_part(time, &self.full)), &q))
    }

    /// Newton's step to the time at which the speed has no bound; none where the motion does not become faster.
    fn left(&self, of: &Evaluated<M::S, NX>) -> Option<M::S> {
        let (mut square, mut grows) = (M::S::ZERO, M::S::ZERO);
        for i in NQ..2 * NQ {
            let unit = self.equations.typical_of(i);
            let (v, a) = (of.x.at(i) / unit, of.dx.at(i) / unit);
            (square, grows) = (v.mul_add(v, square), v.mul_add(a, grows));
        }
        let left = square / (grows + grows);
        (grows > M::S::ZERO && left.is_finite()).then_some(left)
    }

    /// Goes on by most of the time that is left, again and again, to the last moment that has a resolution: that of the time, or the time
    /// in which the motion takes up so little that rounding decides if joints are closed.
    fn follow_to_end(
        &self,
        context: &mut Context<'_, M>,
        first: Moment<M::S, NX>,
        undecided: M::S,
    ) -> Option<Moment<M::S, NX>> {
        let (begin, all, mut at) = (first.time, first.left, first);
        for _ in 0..LIMIT_STEPS {
            let enough = resolution((begin, at.time + at.left)).max(undecided);
            if at.left <= enough {
                return Some(at);
            }
            let next = LIMIT_PARTS.into_iter().find_map(|part| self.nearer(context, &at, M::S::lit(part)));
            let Some(next) = next else {
                // Of several loops that are nearly flat, rounding leaves less than of one.
                let held = HELD.of::<M::S>();
                let by_rounding = at.left <= held * all && held * at.left <= enough;
                return by_rounding.then_some(at);
            };
            at = next;
        }
        None
    }

    /// The moment after a part of the time that is left, if the motion comes there as it would before its end.
    fn nearer(
        &self,
        context: &mut Context<'_, M>,
        at: &Moment<M::S, NX>,
        part: M::S,
    ) -> Option<Moment<M::S, NX>> {
        let one = M::S::lit(1.0);
        let (rest, twice) = ((one - part).sqrt(), at.left + at.left);
        let way = DoubleDouble::of(twice * (one - rest));
        let x: [DoubleDouble<M::S>; NX] = Vector::from_fn(|i| {
            let moved = if i < NQ { way * at.x.at(NQ + i) } else { DoubleDouble::ZERO };
            at.x.at(i) + moved
        });
        let time = at.time + part * at.left;
        context.stats.evaluations += 1;
        let exact = self.equations.exact(time, &context.held, &x)?;
        let (mut off, mut to_go) = (M::S::ZERO, M::S::ZERO);
        for i in 0..NQ {
            let unit = self.equations.typical_of(i);
            off = off.max(((exact.x.at(i) - x.at(i)).rounded() / unit).abs());
            to_go = to_go.max((twice * rest * at.x.at(NQ + i).rounded() / unit).abs());
        }
        let left = self.left(&exact.rounded())?;
        let expected = (one - part) * at.left;
        let by = ON_THE_WAY.of::<M::S>();
        let holds = off < by * to_go && (left - expected).abs() < by * expected;
        holds.then_some(Moment { time, x: exact.x, left })
    }
}
