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
    /// Whether steps are.
    #[must_use]
    pub const fn has_steps(self) -> bool {
        !matches!(self, Self::Nothing)
    }

    /// Whether rates are.
    #[must_use]
    pub const fn has_rates(self) -> bool {
        matches!(self, Self::Rates)
    }
}
