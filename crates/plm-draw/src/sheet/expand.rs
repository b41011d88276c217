//! Items of a mechanism with those of its repetitions turn by turn, and the names that they have there.

use plm_compiler::syntax::ast::{Expr, ExprKind, IndexedName, Item, ItemKind, Operator};

use crate::names::PortName;

/// A picture has no more turns that a hand could reach.
const MOST_TURNS: i64 = 1000;

/// A turn of repetitions, one in the other.
#[derive(Clone, Debug, Default)]
pub(crate) struct Turn<'s> {
    /// Indices and their values.
    indices: Vec<(&'s str, i64)>,
    /// All turns that the same item has.
    pub(crate) count: usize,
}

/// Calls `take` with each item in each turn.
pub(crate) fn expanded<'s>(items: &'s [Item], take: &mut impl FnMut(&'s Item, &Turn<'s>)) {
    go(items, &Turn { indices: Vec::new(), count: 1 }, take);
}

fn go<'s>(items: &'s [Item], turn: &Turn<'s>, take: &mut impl FnMut(&'s Item, &Turn<'s>)) {
    for item in items {
        let ItemKind::Repeat(repeat) = &item.kind else {
            take(item, turn);
            continue;
        };
        let Some((from, to)) = turn.number(&repeat.turns.from).zip(turn.number(&repeat.turns.to)) else {
            continue;
        };
        let to = (to + i64::from(repeat.turns.inclusive)).min(from + MOST_TURNS);
        let count = turn.count * usize::try_from(to - from).unwrap_or(0);
        for index in from..to {
            let mut indices = turn.indices.clone();
            indices.push((repeat.turns.index.text.as_str(), index));
            go(&repeat.items, &Turn { indices, count }, take);
        }
    }
}

impl Turn<'_> {
    /// The value of an index.
    fn number(&self, expr: &Expr) -> Option<i64> {
        match &expr.kind {
            ExprKind::Number(number) => {
                let value = number.to_f64();
                (value.fract() == 0.0 && value.abs() < 1e9).then_some(value as i64)
            }
            ExprKind::Name(name) if name.indices.is_empty() => self
                .indices
                .iter()
                .rev()
                .find(|(index, _)| *index == name.ident.text)
                .map(|(_, value)| *value),
            ExprKind::Neg(inner) => Some(-self.number(inner)?),
            ExprKind::Chain(first, links) => links.iter().try_fold(self.number(first)?, |value, link| {
                let other = self.number(&link.operand)?;
                match link.operator {
                    Operator::Add => value.checked_add(other),
                    Operator::Sub => value.checked_sub(other),
                    Operator::Mul => value.checked_mul(other),
                    _ => None,
                }
            }),
            _ => None,
        }
    }

    /// A name with its indices as numbers.
    pub(crate) fn name(&self, name: &IndexedName) -> Option<String> {
        let mut made = vec![name.ident.text.clone()];
        for index in &name.indices {
            made.push(format!("[{}]", self.number(index)?));
        }
        Some(made.concat())
    }

    /// The port, or another member, that an expression names.
    pub(crate) fn port(&self, expr: &Expr) -> Option<PortName> {
        let ExprKind::Path(base, members) = &expr.kind else { return None };
        let (ExprKind::Name(owner), [port]) = (&base.kind, &members[..]) else { return None };
        Some(PortName::new(self.name(owner)?, self.name(port)?))
    }
}
