//! Ranges of values that depend on parameters.

use plm_cas::Expr;

use crate::diag::Code;
use crate::span::Span;

/// A value that depends on parameters and has a range.
#[derive(Clone, Debug)]
pub struct Limit {
    /// Joint, row of contact or requirement that it belongs to.
    pub part: String,
    /// Its name as written: `compliance`.
    pub what: String,
    /// Its value, SI.
    pub value: Expr,
    /// Its SI unit.
    pub unit: String,
    /// The values that are allowed.
    pub range: Range,
    /// The code of the mistake that it is where it is known to be wrong.
    pub code: Code,
    /// Span of the value as written.
    pub span: Span,
}

/// The range of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Range {
    /// Above zero.
    Positive,
    /// Zero or more.
    NotNegative,
    /// Zero or less.
    NotPositive,
    /// Zero to one.
    Share,
    /// Zero or more, infinity too: the margin of a requirement.
    Required,
}

impl Range {
    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Range::Positive => "positive and finite",
            Range::NotNegative => "finite and not negative",
            Range::NotPositive => "finite and not positive",
            Range::Share => "0 to 1",
            Range::Required => "kept",
        }
    }

    /// Is a value in it?
    pub fn holds(self, value: f64) -> bool {
        let is_allowed = value.is_finite() || matches!(self, Range::Required);
        is_allowed
            && match self {
                Range::Positive => value > 0.0,
                Range::NotNegative | Range::Required => value >= 0.0,
                Range::NotPositive => value <= 0.0,
                Range::Share => (0.0..=1.0).contains(&value),
            }
    }
}
