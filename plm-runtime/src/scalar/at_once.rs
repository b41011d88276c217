//! Operations of many numbers that are made at once.

/// Which operations of a number are made at once, by [`Real::make`](super::Real::make), which finds derivatives in fewer numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AtOnce {
    /// None.
    Nothing,
    /// Steps of explicit formulas.
    Steps,
    /// Such steps and all other rates.
    Rates,
}

impl AtOnce {
    /// True if steps are made at once.
    #[must_use]
    pub const fn has_steps(self) -> bool {
        !matches!(self, Self::Nothing)
    }

    /// True if rates are made at once.
    #[must_use]
    pub const fn has_rates(self) -> bool {
        matches!(self, Self::Rates)
    }
}
