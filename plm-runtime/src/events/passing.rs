//! Kinks on the way of numbers with derivatives.
//!
//! Derivatives of the rate jump at a kink, where the rate itself does not: a step over it, whose stages stand on both sides, has values that
//! its error control has seen to, and derivatives that are off by the length of the step. So steps end there, where the values would not
//! ask for it. A step to the kink itself would not do: stages at its end are less exact than its end, and some would stand beyond. Steps
//! come nearer to it, each by so much that its stages stay on their side, and one that is next to nothing goes over it.

use super::kinks::{Kinks, bit};
use super::rounding::ULPS;
use crate::enclosure::{Enclosed, Interval};
use crate::fault::Fault;
use crate::method::{Context, Method, Path};
use crate::scalar::{Real, Scalar};
use crate::system::{Question, System, value};
use crate::vector::Vector;

/// Of the way to a kink a step leaves so much where it is long, ...
const LEFT_BY_LONG: f64 = 1.0 / 16.0;
/// ... and so much where it is short: the stages of a step are off by a power of its length.
const LEFT_BY_SHORT: f64 = 1.0 / 1024.0;
/// Ways of a smaller part of the step that was proposed are short.
const SHORT: f64 = 1.0 / 64.0;
/// Of that step the last one before a kink leaves so much, and the one over it goes so far beyond, ...
const BESIDE: f64 = 1.0 / (1_u64 << 34) as f64;
/// ... which are so many times what is no step at least.
const STEPS: f64 = 2.0;
/// After a kink a number is beyond zero by so many times its rounding.
const BEYOND: f64 = 4.0;

/// Where a step ends because of a kink, as a fraction of it.
#[derive(Clone, Copy, Debug)]
pub(super) enum Pass<S> {
    /// Before it.
    To(S),
    /// Just beyond it.
    Over(S),
}

impl<S> Pass<S> {
    /// The end.
    pub(super) fn end(self) -> S {
        let (Self::To(end) | Self::Over(end)) = self;
        end
    }
}

/// Where the last step, which was proposed, is to end because of the first kink on its way; none where it may go on. What is not longer
/// than `least`, s, is no step.
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

/// Asks for the first kink over a step.
struct OnTheWay<'a, S, X> {
    path: &'a Path<S, X>,
    /// Those that are looked at, one bit each.
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
    /// Where the step is to end because of the first kink, as a fraction of it; so much of it is next to nothing.
    fn pass(mut self, nothing: M::S) -> Option<Pass<M::S>> {
        let one = M::S::lit(1.0);
        let [at_start, at_end] = [M::S::ZERO, one].map(|theta| self.near(theta) & self.relevant);
        // What rests on a kink does not pass it.
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

    /// The end of a step over a kink that is next to its beginning.
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

    /// Which numbers are zero but for rounding.
    fn near(&self, theta: M::S) -> u128 {
        let mut near = 0;
        self.rounded(theta, |i, value, noise| {
            near |= if value.abs() <= noise { bit(i).unwrap_or(0) } else { 0 };
        });
        near
    }

    /// One of the numbers, and what rounding makes of it.
    fn with_rounding(&self, theta: M::S, index: usize) -> (M::S, M::S) {
        let mut found = (M::S::ZERO, M::S::ZERO);
        self.rounded(theta, |i, value, noise| {
            if i == index {
                found = (value, noise);
            }
        });
        found
    }

    /// Gives every number, and what rounding of the state and of the time makes of it.
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
