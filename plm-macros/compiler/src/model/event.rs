//! Events that give states other values.

use plm_cas::Expr;

use crate::span::Span;

/// An event: the moment at which a condition becomes true or a run begins, and the values that are set then.
#[derive(Clone, Debug)]
pub struct When {
    /// The condition as it was written.
    pub text: String,
    /// 1 where it holds, else 0; none of an event that happens as a run begins. These stand after all others.
    pub condition: Option<Expr>,
    /// The targets and their values; all are worked out before any is set.
    pub set: Vec<(Target, Expr)>,
    /// Place of the condition, or of `start`.
    pub span: Span,
}

/// A target of an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// A first-order or discrete state: an index into [`Model::states`](super::Model::states).
    State(usize),
    /// A velocity of a body, by its coordinate.
    Velocity(usize),
}

impl When {
    /// Those that follow conditions, and those that happen as a run begins.
    pub(crate) fn parted(whens: &[When]) -> (&[When], &[When]) {
        whens.split_at(whens.partition_point(|when| when.condition.is_some()))
    }

    /// The values that events set, one event after the other.
    pub(crate) fn values(whens: &[When]) -> Vec<Expr> {
        whens.iter().flat_map(|when| &when.set).map(|(_, value)| *value).collect()
    }

    /// Its expressions.
    pub(crate) fn expressions_mut(&mut self) -> impl Iterator<Item = &mut Expr> {
        self.condition.iter_mut().chain(self.set.iter_mut().map(|(_, value)| value))
    }
}
