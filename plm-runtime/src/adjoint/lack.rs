//! Reasons why there is no gradient.

use core::fmt;

use crate::fault::Fault;

/// The reason why there is no gradient.
///
/// Its `Debug` reads like its `Display`, since a `main` that returns it, and `unwrap`, show that one.
#[derive(Clone, Copy, PartialEq)]
pub enum NoGradient {
    /// The run ends early, or has no derivatives.
    Fault(Fault),
    /// Memory does not suffice.
    Short(Lack),
}

/// The memory that a gradient takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lack {
    /// Terms of the trace, for the start and the longest step.
    pub terms: usize,
    /// [`Memory::adjoints`](super::Memory::adjoints).
    pub adjoints: usize,
    /// [`Memory::carried`](super::Memory::carried).
    pub carried: usize,
    /// [`Memory::saved`](super::Memory::saved).
    pub saved: usize,
}

impl Lack {
    /// Is it there?
    pub(super) fn met_by(self, there: Self) -> Result<(), NoGradient> {
        let suffices = self.terms <= there.terms
            && self.adjoints <= there.adjoints
            && self.carried <= there.carried
            && self.saved <= there.saved;
        if suffices { Ok(()) } else { Err(NoGradient::Short(self)) }
    }
}

impl From<Fault> for NoGradient {
    fn from(fault: Fault) -> Self {
        Self::Fault(fault)
    }
}

impl fmt::Display for NoGradient {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fault(fault) => fault.fmt(f),
            Self::Short(Lack { terms, adjoints, carried, saved }) => write!(
                f,
                "the memory is too short: {terms} terms of the trace, {adjoints} adjoints, {carried} carried and {saved} saved states \
                 are needed at least"
            ),
        }
    }
}

impl fmt::Debug for NoGradient {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl core::error::Error for NoGradient {}
