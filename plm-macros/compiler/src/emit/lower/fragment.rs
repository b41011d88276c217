//! Text of a value that stands where it is used.

use crate::collect::CollectVec;

/// Text of a value while it has no name.
#[derive(Clone, Default)]
pub(super) struct Piece {
    /// Rust source.
    pub(super) text: String,
    /// How strongly its outermost operation binds: 1 sum, 2 product, 3 negation, 4 atom.
    pub(super) strength: u8,
    /// Leaves of the expression.
    pub(super) terms: usize,
    /// Locals that it reads, by their numbers.
    pub(super) reads: Vec<usize>,
}

/// A constant of any scalar.
pub(super) fn literal(value: f64) -> String {
    if value.is_finite() {
        format!("lit({value:?})")
    } else if value.is_nan() {
        "lit(f64::NAN)".to_owned()
    } else {
        format!("lit({}f64::INFINITY)", if value < 0.0 { "-" } else { "" })
    }
}

impl Piece {
    pub(super) fn atom(text: String) -> Piece {
        Piece { text, strength: 4, terms: 1, reads: Vec::new() }
    }

    /// In brackets, unless it binds at least this strongly.
    pub(super) fn within(&self, strength: u8) -> String {
        if self.strength >= strength { self.text.clone() } else { format!("({})", self.text) }
    }

    /// `-self`.
    pub(super) fn negated(&self) -> Piece {
        Piece { text: format!("-{}", self.within(3)), strength: 3, ..self.clone() }
    }

    /// `self operator right`; equal strength on the right needs brackets, or the order would change.
    pub(super) fn joined(&self, operator: &str, right: &Piece, strength: u8) -> Piece {
        let text = format!("{}{operator}{}", self.within(strength), right.within(strength + 1));
        Piece { text, strength, terms: self.terms + right.terms, reads: merged(&[self, right]) }
    }

    /// `self.function(arguments)`.
    pub(super) fn called(&self, function: &str, arguments: &[&Piece]) -> Piece {
        let listed: Vec<&str> = arguments.iter().map(|piece| piece.text.as_str()).collect_vec();
        let mut all = vec![self];
        all.extend(arguments);
        Piece {
            text: format!("{}.{function}({})", self.within(4), listed.join(", ")),
            strength: 4,
            terms: all.iter().map(|piece| piece.terms).sum(),
            reads: merged(&all),
        }
    }

    /// `function(arguments)`.
    pub(super) fn call(function: &str, arguments: &[&Piece]) -> Piece {
        let listed: Vec<&str> = arguments.iter().map(|piece| piece.text.as_str()).collect_vec();
        Piece {
            text: format!("{function}({})", listed.join(", ")),
            strength: 4,
            terms: arguments.iter().map(|piece| piece.terms).sum(),
            reads: merged(arguments),
        }
    }
}

fn merged(pieces: &[&Piece]) -> Vec<usize> {
    pieces.iter().flat_map(|piece| piece.reads.iter().copied()).collect_vec()
}
