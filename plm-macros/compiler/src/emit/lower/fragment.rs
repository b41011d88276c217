//! Code fragments: the text of a value that is written where it is used.

use crate::collect::CollectVec;

/// Text of a value while it has no name.
#[derive(Clone, Default)]
pub(super) struct Fragment {
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

impl Fragment {
    pub(super) fn atom(text: String) -> Fragment {
        Fragment { text, strength: 4, terms: 1, reads: Vec::new() }
    }

    /// A constant as a factor, `by(2.0)`; all else as it is.
    pub(super) fn as_factor(&self) -> Fragment {
        match self.text.strip_prefix("lit(").and_then(|rest| rest.strip_suffix(')')) {
            Some(value) if !value.contains(')') => Fragment { text: format!("by({value})"), ..self.clone() },
            _ => self.clone(),
        }
    }

    /// In brackets, unless it binds at least this strongly.
    pub(super) fn within(&self, strength: u8) -> String {
        if self.strength >= strength { self.text.clone() } else { format!("({})", self.text) }
    }

    /// `-self`.
    pub(super) fn negated(&self) -> Fragment {
        Fragment { text: format!("-{}", self.within(3)), strength: 3, ..self.clone() }
    }

    /// `self operator right`; equal strength on the right needs brackets, or the order would change.
    pub(super) fn joined(&self, operator: &str, right: &Fragment, strength: u8) -> Fragment {
        let text = format!("{}{operator}{}", self.within(strength), right.within(strength + 1));
        Fragment { text, strength, terms: self.terms + right.terms, reads: merged(&[self, right]) }
    }

    /// `self.function(arguments)`.
    pub(super) fn called(&self, function: &str, arguments: &[&Fragment]) -> Fragment {
        let listed: Vec<&str> = arguments.iter().map(|fragment| fragment.text.as_str()).collect_vec();
        let mut all = vec![self];
        all.extend(arguments);
        Fragment {
            text: format!("{}.{function}({})", self.within(4), listed.join(", ")),
            strength: 4,
            terms: all.iter().map(|fragment| fragment.terms).sum(),
            reads: merged(&all),
        }
    }

    /// `function(arguments)`.
    pub(super) fn call(function: &str, arguments: &[&Fragment]) -> Fragment {
        let listed: Vec<&str> = arguments.iter().map(|fragment| fragment.text.as_str()).collect_vec();
        Fragment {
            text: format!("{function}({})", listed.join(", ")),
            strength: 4,
            terms: arguments.iter().map(|fragment| fragment.terms).sum(),
            reads: merged(arguments),
        }
    }
}

fn merged(fragments: &[&Fragment]) -> Vec<usize> {
    fragments.iter().flat_map(|fragment| fragment.reads.iter().copied()).collect_vec()
}
