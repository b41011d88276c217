//! Lengths of steps by their errors, in any numbers without derivatives: a run has one pace, lanes have one each.

use super::control::Control;
use super::pair::Pair;
use crate::method::adaptive::Steady;
use crate::scalar::{Real, Scalar};
use crate::words::{InWords, Words};

/// The next step, and what is stored of the last ones to choose it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace<T: Scalar> {
    /// Length of the next step, s; zero before the first.
    pub(crate) proposal: T,
    control: Control<T>,
    steady: Steady<T>,
}

impl<T: Scalar> Pace<T> {
    pub(super) fn new() -> Self {
        Self { proposal: T::ZERO, control: Control::new(), steady: Steady::new() }
    }

    /// Error of a step of `h`: its estimate, or what the last step lets expect if that is larger.
    #[inline]
    pub(crate) fn error<P: Pair>(&self, h: T, estimate: T) -> T {
        self.steady.error(h, estimate, P::ORDER)
    }

    /// Proposes the step after an accepted one of `h`, where so much was proposed. A step that was cut to reach the end tells little about
    /// the next one.
    #[inline]
    pub(crate) fn accept<P: Pair>(&mut self, proposal: T, h: T, (error, estimate): (T, T)) {
        let (is_cut, before) = (h.lt(proposal), *self);
        self.proposal = h * self.control.accept(&P::LIMITS, error);
        self.steady.accept(h, estimate, P::ORDER);
        if T::any(is_cut) {
            let kept = Self { proposal: self.proposal.max(proposal), ..before };
            *self = Self::select(is_cut, &kept, self);
        }
    }

    /// Length of another attempt after one of `h` with an error above 1, or NaN.
    #[inline]
    pub(crate) fn reject<P: Pair>(&mut self, h: T, error: T) -> T {
        h * self.control.reject(&P::LIMITS, error)
    }

    /// Records that a step of `h` was accepted by its error and refused for another reason.
    pub(super) fn refuse(&mut self, h: T) {
        self.control.refuse();
        self.proposal = T::lit(0.5) * h;
    }

    /// Forgets the errors of the last steps.
    pub(super) fn forget(&mut self) {
        self.steady = Steady::new();
    }

    /// Has no step given an error yet?
    pub(super) fn is_new(&self) -> bool {
        self.steady.is_new()
    }

    /// The first of two where the mask is set, the second elsewhere.
    #[inline]
    pub(crate) fn select(mask: T::Mask, a: &Self, b: &Self) -> Self {
        Self {
            proposal: T::select(mask, a.proposal, b.proposal),
            control: Control::select(mask, &a.control, &b.control),
            steady: Steady::select(mask, &a.steady, &b.steady),
        }
    }

    /// A pace whose numbers are taken one by one of another's, or of several: `number` has the place of each. Masks are passed as the
    /// numbers 1 and 0.
    pub(crate) fn of<S: Scalar>(number: impl Fn(fn(&Pace<S>) -> S) -> T) -> Self {
        let is_set = |of| T::ZERO.lt(number(of));
        Self {
            proposal: number(|pace| pace.proposal),
            control: Control {
                last_error: number(|pace| pace.control.last_error),
                rejected: is_set(|pace| as_number(pace.control.rejected)),
            },
            steady: Steady {
                last: (number(|pace| pace.steady.last.0), number(|pace| pace.steady.last.1)),
                doubted: is_set(|pace| as_number(pace.steady.doubted)),
            },
        }
    }
}

/// 1 where a mask is set, 0 elsewhere.
fn as_number<S: Scalar>(mask: S::Mask) -> S {
    S::select(mask, S::lit(1.0), S::ZERO)
}

impl<T: Real> InWords for Pace<T> {
    fn each(&mut self, words: &mut impl Words) {
        let mut proposal = (self.proposal != T::ZERO).then_some(self.proposal);
        words.perhaps(&mut proposal, T::ZERO, Words::number);
        self.proposal = proposal.unwrap_or(T::ZERO);
        self.control.each(words);
        self.steady.each(words);
    }
}
