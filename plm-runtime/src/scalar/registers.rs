//! Use of vector registers by numbers.

/// How numbers use vector registers, which decides whether two of them side by side take less time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Registers {
    /// One number at a time.
    Scalar,
    /// Compilers join two numbers in one register.
    Pairs,
    /// A number fills its registers by itself: it has several lanes.
    Filled,
}

impl Registers {
    /// True if two rates in a row take less time side by side; `in_lanes` is the answer of a rate for numbers that fill registers.
    #[must_use]
    pub const fn pays_in_pairs(self, in_lanes: bool) -> bool {
        match self {
            Self::Scalar => false,
            Self::Pairs => true,
            Self::Filled => in_lanes,
        }
    }

    /// True if a number has several lanes.
    #[must_use]
    pub const fn are_filled(self) -> bool {
        matches!(self, Self::Filled)
    }
}
