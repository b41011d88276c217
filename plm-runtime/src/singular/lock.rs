//! The end of a prescribed motion that can go no further.
//!
//! The value of `lambda^T phi` at the singular pose next to a motion changes with the time if a row is prescribed. At its zero the two
//! images of a loop meet, and there is no pose beyond: a fold of the motion over the time (W. J. F. Govaerts, Numerical Methods for
//! Bifurcations of Dynamical Equilibria, SIAM 2000, 4.1).

use super::ExtendedPrecision;
use super::combined::Combined;
use super::critical::{Critical, Rows};
use crate::double_double::DoubleDouble;
use crate::fault::{Cause, Fault};
use crate::linalg::{add, dot};
use crate::scalar::{Real, Scalar};
use crate::tolerances::{CLOSES, FOUND, HALVED, LOCK_STEPS, TIME_FOUND, TOGETHER};

/// How the singular pose next to a prescribed motion changes with the time.
pub(super) enum Ends<S, const NQ: usize, const NC: usize> {
    /// Nothing is prescribed, or the motion does not come to an end at the pose.
    Never(Critical<S, NQ, NC>),
    /// The motion ends at this time, s, at this pose.
    At(S, Critical<S, NQ, NC>),
    /// It comes to this pose and goes on.
    Touches(Critical<S, NQ, NC>),
}

/// The value of `lambda^T phi` at the singular pose at a time, m, and its rate, m/s.
struct Value<S, const NQ: usize, const NC: usize> {
    time: S,
    critical: Critical<S, NQ, NC>,
    open: S,
    rate: S,
}

impl<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize>
    Rows<'_, M, NQ, NC, NX>
{
    /// How a prescribed motion that is next to a singular pose at the time `t` goes on.
    #[inline(never)]
    pub(super) fn ends(&self, t: M::S, critical: Critical<M::S, NQ, NC>) -> Ends<M::S, NQ, NC> {
        let first = self.value(t, critical, None);
        if first.rate == M::S::ZERO || !self.is_definite(t, &first.critical) {
            return Ends::Never(critical);
        }
        self.fold(&first).unwrap_or(Ends::Never(critical))
    }

    /// Follows the value to its zero, or to its extremum.
    fn fold(&self, first: &Value<M::S, NQ, NC>) -> Option<Ends<M::S, NQ, NC>> {
        let (mut at, mut last) = (self.after(first, first.newton())?, first.newton());
        for _ in 0..LOCK_STEPS {
            let step = at.newton();
            if is_found(step, (first.time, at.time)) {
                // What has been or is now is left behind.
                let ends = at.time > first.time && at.closes(first);
                return ends.then_some(Ends::At(at.time, at.critical));
            }
            if step.abs() > HALVED.of::<M::S>() * last.abs() {
                return self.extremum(first, at);
            }
            (at, last) = (self.after(&at, step)?, step);
        }
        None
    }

    /// Follows the rate of the value to its zero.
    fn extremum(
        &self,
        first: &Value<M::S, NQ, NC>,
        second: Value<M::S, NQ, NC>,
    ) -> Option<Ends<M::S, NQ, NC>> {
        let (mut before, mut rate) = (first.time, first.rate);
        let mut at = second;
        for _ in 0..LOCK_STEPS {
            let step = -at.rate * (at.time - before) / (at.rate - rate);
            if at.critical.is_reached() && is_found(step, (first.time, at.time)) {
                return Some(Ends::Touches(at.critical));
            }
            if at.rate == M::S::ZERO || is_found(step, (first.time, at.time)) {
                break;
            }
            (before, rate) = (at.time, at.rate);
            at = self.after(&at, step)?;
        }
        let parts = at.open * first.open < M::S::ZERO && at.time > first.time;
        if parts { self.between(first, at) } else { None }
    }

    /// The zero of the value between two times of different sign: Newton's steps, halves where these leave the interval.
    fn between(&self, first: &Value<M::S, NQ, NC>, last: Value<M::S, NQ, NC>) -> Option<Ends<M::S, NQ, NC>> {
        let (mut low, mut high, mut at) = (first.time, last.time, last);
        for _ in 0..2 * LOCK_STEPS {
            if at.open * first.open < M::S::ZERO {
                high = at.time;
            } else {
                low = at.time;
            }
            let half = M::S::lit(0.5) * (low + high) - at.time;
            let newton = at.newton();
            let inside = at.time + newton > low && at.time + newton < high;
            let step = if inside { newton } else { half };
            if is_found(step, (first.time, at.time)) {
                return at.closes(first).then_some(Ends::At(at.time, at.critical));
            }
            at = self.after(&at, step)?;
        }
        None
    }

    /// The value a time later.
    fn after(&self, from: &Value<M::S, NQ, NC>, step: M::S) -> Option<Value<M::S, NQ, NC>> {
        let time = from.time + step;
        let critical = self.critical(time, &from.critical.q)?;
        Some(self.value(time, critical, Some(&from.critical.combination)))
    }

    fn value(
        &self,
        time: M::S,
        mut critical: Critical<M::S, NQ, NC>,
        like: Option<&[M::S; NC]>,
    ) -> Value<M::S, NQ, NC> {
        if like.is_some_and(|like| dot(like, &critical.combination) < M::S::ZERO) {
            critical.combination = critical.combination.map(|entry| -entry);
        }
        let rate = dot(&critical.combination, &self.driven(time, &critical.q.map(DoubleDouble::rounded)));
        let open = dot(&critical.combination, &self.in_metres(&critical.open));
        Value { time, critical, open, rate }
    }

    /// The fault of a motion that ends at a singular pose.
    #[cold]
    #[inline(never)]
    pub(super) fn locked(&self, at: (M::S, &'static str), critical: &Critical<M::S, NQ, NC>) -> Fault {
        self.locked_by(at, &critical.q.map(DoubleDouble::rounded), &critical.combination)
    }

    /// The fault of a motion that ends at a pose at which several combinations of rows may vanish: those of prescribed motions count by
    /// their shares in all of them.
    #[cold]
    #[inline(never)]
    pub(super) fn locked_at(&self, at: (M::S, &'static str), q: &[M::S; NQ]) -> Fault {
        let rate = self.driven(at.0, q);
        let (mut combined, mut taken) = (Combined::nothing(), rate);
        if self.combined(at.0, q, &mut combined).is_some() {
            combined.part(TOGETHER.of::<M::S>());
            taken = [M::S::ZERO; NC];
            for (lambda, _) in combined.vanishing() {
                add(&mut taken, dot(lambda, &rate), lambda);
            }
        }
        self.locked_by(at, q, &taken)
    }

    fn locked_by(&self, (t, part): (M::S, &'static str), q: &[M::S; NQ], combination: &[M::S; NC]) -> Fault {
        let (driven, mut row, mut most) = (self.driven(t, q), 0, M::S::ZERO);
        for (r, rate) in driven.iter().enumerate() {
            let share = (combination[r] * *rate).abs();
            if share > most {
                (row, most) = (r, share);
            }
        }
        let cause = Cause::LockedAt {
            row: self.system.layout().rows.get(row).copied().unwrap_or_default(),
            value: self.held_value(t, q, row).to_f64(),
            angular: self.system.layout().is_angular(row),
        };
        Fault::of_part(t.to_f64(), part, cause)
    }
}

impl<S: Real, const NQ: usize, const NC: usize> Value<S, NQ, NC> {
    fn newton(&self) -> S {
        -self.open / self.rate
    }

    /// Are all joints closed there, to the resolution of the time? Else other loops become flat at other times next to it, and the
    /// motion has ended before.
    fn closes(&self, first: &Self) -> bool {
        let by = self.rate.abs() * resolution((first.time, self.time));
        self.critical.is_closed(CLOSES.of::<S>() * by)
    }
}

/// Is a step in the time nothing beside rounding and beside the way so far?
fn is_found<S: Real>(step: S, times: (S, S)) -> bool {
    step.abs() <= resolution(times)
}

/// The resolution of a time that is looked for from a first one on.
pub(super) fn resolution<S: Real>((first, at): (S, S)) -> S {
    FOUND.of::<S>() * S::EPSILON * (at.abs() + first.abs()) + TIME_FOUND.of::<S>() * (at - first).abs()
}
