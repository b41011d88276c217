//! Counts of operations by kind: those of a tape that the compiler evaluates, of generated code, of what a results file tells.

use core::fmt;

/// Operations of one call of a straight-line function.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Additions, subtractions and changes of sign.
    pub add: u32,
    /// Multiplications.
    pub mul: u32,
    /// Divisions.
    pub div: u32,
    /// Square roots.
    pub sqrt: u32,
    /// Pairs of sine and cosine, or one of them.
    pub sin_cos: u32,
    /// Everything else: other functions, minimum, maximum, selection.
    pub other: u32,
}

impl Operations {
    /// All of them.
    pub const fn total(&self) -> u32 {
        self.add + self.mul + self.div + self.sqrt + self.sin_cos + self.other
    }

    /// The name and the count of each kind.
    pub const fn kinds(&self) -> [(&'static str, u32); 6] {
        let Self { add, mul, div, sqrt, sin_cos, other } = *self;
        [("add", add), ("mul", mul), ("div", div), ("sqrt", sqrt), ("sin_cos", sin_cos), ("other", other)]
    }
}

impl core::ops::Add for Operations {
    type Output = Self;

    fn add(self, with: Self) -> Self {
        Self {
            add: self.add + with.add,
            mul: self.mul + with.mul,
            div: self.div + with.div,
            sqrt: self.sqrt + with.sqrt,
            sin_cos: self.sin_cos + with.sin_cos,
            other: self.other + with.other,
        }
    }
}

/// `30 operations: 14 add, 12 mul, 4 sin_cos`, the kinds that occur.
impl fmt::Display for Operations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} operation{}", self.total(), if self.total() == 1 { "" } else { "s" })?;
        let mut separator = ": ";
        for (kind, count) in self.kinds().into_iter().filter(|(_, count)| *count > 0) {
            write!(f, "{separator}{count} {kind}")?;
            separator = ", ";
        }
        Ok(())
    }
}
