//! Kinks in steps of numbers with derivatives.
//!
//! At a kink the derivatives of the rate jump, but not the rate itself. A step over it, with stages on both sides, has values that its
//! error control has checked, and derivatives that are off by the length of the step. Therefore steps end at kinks, even if the values do
//! not require it. A step to the kink itself would not suffice: stages are less accurate than its end, and some would lie beyond. Steps
//! approach the kink, each so far that its stages stay on their side, and a very short one crosses it.

use super::kinks::{Kinks, bit};
use super::rounding::ULPS;
use crate::enclosure::{Enclosed, Interval};
use crate::fault::Fault;
use crate::method::{Context, Method, Path};
use crate::scalar::{Real, Scalar};
use crate::system::{Question, System, value};
use crate::vector::Vector;

/// Part of the distance to a kink that a step leaves if the distance is long, ...
const LEFT_BY_LONG: f64 = 1.0 / 16.0;
/// ... and if it is short: the error of the stages of a step is a power of its length.
const LEFT_BY_SHORT: f64 = 1.0 / 1024.0;
/// Distances below this part of the proposed step are short.
const SHORT: f64 = 1.0 / 64.0;
/// Part of the proposed step that the last step before a kink leaves, and by which the step over it goes beyond, ...
const BESIDE: f64 = 1.0 / (1_u64 << 34) as f64;
/// ... at least so many times the longest step that counts as none.
const STEPS: f64 = 2.0;
/// Least distance of a kink function from zero after the crossing, in its roundings.
const BEYOND: f64 = 4.0;

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
        let least = N::S::lit(STEPS) * value::<S, N::S>(self.least) / kinks.path.h;
        kinks.pass(N::S::lit(BESIDE).max(least)).map(|pass| match pass {
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
        let left = if theta > M::S::lit(SHORT) { LEFT_BY_LONG } else { LEFT_BY_SHORT };
        Some(Pass::To(theta * M::S::lit(1.0 - left)))
    }

    /// End of a step over a kink that is near its beginning.
    fn over(&self, (theta, mut beyond): (M::S, M::S), index: usize) -> Option<Pass<M::S>> {
        while theta + beyond < M::S::lit(1.0) {
            let end = theta + beyond;
            let (here, noise) = self.with_rounding(end, index);
            if here.abs() > M::S::lit(BEYOND) * noise {
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
        let ulps = M::S::lit(ULPS) * M::S::EPSILON;
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
