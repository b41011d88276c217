//! Counts of operations, as constants of generated code.

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
}

/// `30 operations: 14 add, 12 mul, 4 sin_cos`, the kinds that occur.
impl fmt::Display for Operations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kinds = [
            (self.add, "add"),
            (self.mul, "mul"),
            (self.div, "div"),
            (self.sqrt, "sqrt"),
            (self.sin_cos, "sin_cos"),
            (self.other, "other"),
        ];
        write!(f, "{} operation{}", self.total(), if self.total() == 1 { "" } else { "s" })?;
        let mut separator = ": ";
        for (count, kind) in kinds.into_iter().filter(|kind| kind.0 > 0) {
            write!(f, "{separator}{count} {kind}")?;
            separator = ", ";
        }
        Ok(())
    }
}
