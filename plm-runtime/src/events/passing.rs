//! Kinks in steps of numbers with derivatives.
//!
//! At a kink the derivatives of the rate jump, but not the rate itself. A step over it, with stages on both sides, has values that its
//! error control has checked, and derivatives that are off by the length of the step. Therefore steps end at kinks, even if the values do
//! not require it. A step to the kink itself would not suffice: stages are less accurate than its end, and some would lie beyond. Steps
//! approach the kink, each so far that its stages stay on their side, and a very short one crosses it.

use super::kinks::{Kinks, bit};
use crate::enclosure::{Enclosed, Interval};
use crate::fault::Fault;
use crate::method::{Context, Method, Path};
use crate::scalar::{Real, Scalar};
use crate::system::{Question, System, value};
use crate::tolerances::{
    BEYOND_KINK, LEFT_BY_LONG, LEFT_BY_SHORT, PASSED_BY, PASSED_STEPS, SHORT_OF_KINK, STATE_ROUNDED,
};
use crate::vector::Vector;

/// End of a step because of a kink, as a fraction of the step or as a time.
#[derive(Clone, Copy, Debug)]
pub(super) enum Pass<S> {
    /// Before the kink.
    To(S),
    /// Just beyond the kink.
    Over(S),
}

impl<S> Pass<S> {
    /// The end.
    pub(super) fn end(self) -> S {
        let (Self::To(end) | Self::Over(end)) = self;
        end
    }
}

/// Time at which the last step, as proposed, has to end because of its first kink; `None` if it need not. A step is longer than `least`, s.
pub(super) fn pass<M: System<S: Real>, I: Method<M>>(
    method: &mut I,
    context: &mut Context<'_, M>,
    (relevant, least): (u128, M::S),
) -> Result<Option<Pass<M::S>>, Fault> {
    if context.system.guard_count() == 0 {
        method.densify(context)?;
    }
    let Some(path) = method.path() else { return Ok(None) };
    let asked = OnTheWay { path: &path, relevant, least };
    Ok(context.system.ask(&context.held, asked).map(|pass| match pass {
        Pass::To(theta) => Pass::To(path.time(theta)),
        Pass::Over(theta) => Pass::Over(path.time(theta)),
    }))
}

/// Asks for the end of a step because of its first kink.
struct OnTheWay<'a, S, X> {
    path: &'a Path<S, X>,
    /// Kinks that are examined, one bit each.
    relevant: u128,
    least: S,
}

impl<S: Real, X: Vector<S>> Question<S> for OnTheWay<'_, S, X> {
    type Answer = Option<Pass<S>>;

    fn of<N: System<S: Real<Plain = S::Plain>>>(self, system: &N, held: &N::U) -> Self::Answer {
        let kinks = Kinks { system, held: *held, path: self.path.in_values(), relevant: self.relevant };
        let least = PASSED_STEPS.of::<N::S>() * value::<S, N::S>(self.least) / kinks.path.h;
        kinks.pass(PASSED_BY.of::<N::S>().max(least)).map(|pass| match pass {
            Pass::To(theta) => Pass::To(value(theta)),
            Pass::Over(theta) => Pass::Over(value(theta)),
        })
    }
}

impl<M: System<S: Real>> Kinks<'_, M> {
    /// End of the step because of the first kink, as a fraction of it; `nothing` is a negligible part of it.
    fn pass(mut self, nothing: M::S) -> Option<Pass<M::S>> {
        let one = M::S::lit(1.0);
        let [at_start, at_end] = [M::S::ZERO, one].map(|theta| self.near(theta) & self.relevant);
        // A kink function that stays at zero is not crossed.
        let leaves = at_start & !at_end;
        if leaves != 0 {
            return self.over((M::S::ZERO, nothing), leaves.trailing_zeros() as usize);
        }
        self.relevant &= !at_start;
        let (theta, index) = self.found(M::S::ZERO)?;
        if theta <= nothing {
            return self.over((theta, nothing), index);
        }
        let left = if theta > SHORT_OF_KINK.of::<M::S>() { LEFT_BY_LONG.get() } else { LEFT_BY_SHORT.get() };
        Some(Pass::To(theta * M::S::lit(1.0 - left)))
    }

    /// End of a step over a kink that is near its beginning.
    fn over(&self, (theta, mut beyond): (M::S, M::S), index: usize) -> Option<Pass<M::S>> {
        while theta + beyond < M::S::lit(1.0) {
            let end = theta + beyond;
            let (here, noise) = self.with_rounding(end, index);
            if here.abs() > BEYOND_KINK.of::<M::S>() * noise {
                return Some(Pass::Over(end));
            }
            beyond = beyond + beyond;
        }
        None
    }

    /// Kinks that are zero within rounding, one bit each.
    fn near(&self, theta: M::S) -> u128 {
        let mut near = 0;
        self.rounded(theta, |i, value, noise| {
            near |= if value.abs() <= noise { bit(i).unwrap_or(0) } else { 0 };
        });
        near
    }

    /// Value of one kink, and its error by rounding.
    fn with_rounding(&self, theta: M::S, index: usize) -> (M::S, M::S) {
        let mut found = (M::S::ZERO, M::S::ZERO);
        self.rounded(theta, |i, value, noise| {
            if i == index {
                found = (value, noise);
            }
        });
        found
    }

    /// Gives every kink, and its error by rounding of the state and of the time.
    fn rounded(&self, theta: M::S, mut each: impl FnMut(usize, M::S, M::S)) {
        let (time, x, typical) = (self.path.time(theta), self.path.at(theta), self.system.typical());
        let ulps = STATE_ROUNDED.of::<M::S>() * M::S::EPSILON;
        let rounded = |s: M::S, size: M::S| Enclosed {
            slope: Interval { low: -ulps * size, high: ulps * size },
            ..Enclosed::constant(s)
        };
        let state = |i: usize| rounded(x.at(i), typical.at(i) + x.at(i).abs());
        self.system.guards_within(rounded(time, time.abs()), &self.held, &state, &mut |i, number| {
            if let Some(kink) = i.checked_sub(M::G::LEN) {
                each(kink, number.middle, number.slope.size() + ulps * number.middle.abs());
            }
        });
    }
}
