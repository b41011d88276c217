//! Event detector: the data about guards that is stored between two steps.

use super::chattering::Chattering;
use super::guard_free::GuardFree;
use crate::scalar::Real;
use crate::vector::Vector;

/// The event at the end of a step.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Event {
    /// No condition is triggered.
    None,
    /// This condition is triggered; the detector has ended the step there.
    At(usize),
    /// The detector has not ended the step: conditions whose guards are violated at its end switch there. Others were `missed`: they
    /// came and went within the step.
    Behind {
        /// One of them, by its index, and their number.
        missed: Option<(usize, u64)>,
    },
}

/// Agreement of the modes in the discrete state with the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Modes {
    /// Nothing has been decided yet: a condition on its boundary begins in the mode that the motion leads to.
    New,
    /// The modes were decided at the start, and no step has been made.
    Decided,
    /// State, parameters or inputs may have changed since.
    Unknown,
    /// The modes are those of the state.
    Known,
}

/// Event detector, with the data about guards that is stored between two steps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Detector<S, G> {
    pub(super) modes: Modes,
    /// Residual of each guard: the value by which it was violated when its event was committed; zero for most.
    pub(super) residual: G,
    /// Guard-free region, for steps of fixed length.
    pub(super) guard_free: GuardFree<S>,
    /// Counter of switches in a short time.
    pub(super) chattering: Chattering<S>,
    /// True if the last step of numbers with derivatives has crossed a kink.
    pub(super) has_passed: bool,
}

impl<S: Real, G: Vector<S>> Detector<S, G> {
    pub(crate) fn new() -> Self {
        Self {
            modes: Modes::New,
            residual: G::fill(S::ZERO),
            guard_free: GuardFree::new(),
            chattering: Chattering::new(),
            has_passed: false,
        }
    }

    /// Records that state, parameters or inputs may have changed.
    pub(crate) fn forget(&mut self) {
        self.modes = match self.modes {
            Modes::New | Modes::Decided => Modes::New,
            Modes::Unknown | Modes::Known => Modes::Unknown,
        };
        self.guard_free.forget();
        self.residual = G::fill(S::ZERO);
    }

    /// True if the sides in the discrete state are those that apply.
    #[inline]
    pub(crate) fn is_known(&self) -> bool {
        G::LEN == 0 || matches!(self.modes, Modes::Decided | Modes::Known)
    }

    /// Records that the state reached has these guards.
    pub(super) fn arrive(&mut self, guards: G) {
        self.modes = Modes::Known;
        self.release(&guards);
    }

    /// Drops the residuals of guards that are satisfied again.
    pub(super) fn release(&mut self, guards: &G) {
        self.residual = self.residual.map2(guards, |left, g| if g < S::ZERO { left } else { S::ZERO });
    }
}
