//! Counts of operations, as constants of generated code.

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
