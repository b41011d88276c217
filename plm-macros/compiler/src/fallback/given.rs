//! Blocks that exist where something is given, as far as that can be read.

use super::Names;
use crate::syntax::ast::{Expr, ExprKind, ItemKind, Operator, all_items};

impl<'a> Names<'a> {
    /// Does the condition of a block hold? What cannot be read does not.
    pub(super) fn is_given(&self, condition: &'a Expr) -> bool {
        match &condition.kind {
            ExprKind::Name(name) => self.field(&name.ident.text).is_some(),
            ExprKind::Not(inner) => !self.is_given(inner),
            ExprKind::Chain(first, links) => {
                let mut operands = links.iter().map(|link| &link.operand);
                match links[0].operator {
                    Operator::And => self.is_given(first) && operands.all(|of| self.is_given(of)),
                    Operator::Or => self.is_given(first) || operands.any(|of| self.is_given(of)),
                    Operator::Equal => self.is_chosen(first, &links[0].operand),
                    Operator::NotEqual => !self.is_chosen(first, &links[0].operand),
                    _ => false,
                }
            }
            _ => false,
        }
    }

    /// Is an option chosen, by the use of the part or by default?
    fn is_chosen(&self, choice: &'a Expr, option: &'a Expr) -> bool {
        let (Some(choice), Some(option), Some((_, _, definition))) =
            (word(choice), word(option), self.uses.last())
        else {
            return false;
        };
        let default = all_items(&definition.items).find_map(|item| match &item.kind {
            ItemKind::Choice(of) if of.name.text == choice => of.default.as_ref(),
            _ => None,
        });
        let set = self.field(choice);
        let chosen = if set.is_some() { set.and_then(word) } else { default.map(|of| of.text.as_str()) };
        chosen == Some(option)
    }

    /// The value that the uses around an item set for a name of its part. The outermost has the last word.
    fn field(&self, name: &str) -> Option<&'a Expr> {
        let mut path = name.to_owned();
        let mut found = None;
        for (key, instance, _) in self.uses.iter().rev() {
            let here = instance.fields.iter().find(|field| {
                let names = field.path.iter().map(|name| self.key(name));
                names.collect::<Option<Vec<_>>>().is_some_and(|names| names.join(".") == path)
            });
            found = here.map(|field| &field.value).or(found);
            path = format!("{key}.{path}");
        }
        found
    }
}

/// A name alone.
fn word(expr: &Expr) -> Option<&str> {
    match &expr.kind {
        ExprKind::Name(name) => Some(&name.ident.text),
        _ => None,
    }
}
