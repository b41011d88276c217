//! Spans: ranges of tokens in a source.

/// A range of tokens of one source. The caller of the compiler knows what a token's index means: a span of rustc for
/// a macro, a byte range for text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// Which source: 0 is the declaration, the others are parts libraries in the order of loading.
    pub source: u32,
    /// First token.
    pub first: u32,
    /// Last token, inclusive.
    pub last: u32,
}

impl Span {
    /// The span from the beginning of `self` to the end of `other`; `self` where they are of different sources.
    #[must_use]
    pub fn to(self, other: Span) -> Span {
        if self.source == other.source { Span { last: other.last.max(self.last), ..self } } else { self }
    }
}
