//! Items that exist where the use of a part sets a parameter or chooses an option: `given friction { … } else { … }`.
//!
//! Items of a block stand in the part as if there was no block. A parameter without a default that need not be set is known in
//! the block alone, so that nothing reads a value which is not there.

use std::borrow::Cow;

use crate::collect::{CollectVec, PushAll};
use crate::diag::Code;
use crate::resolve::Resolver;
use crate::resolve::declarations::fields::field_name;
use crate::resolve::names::{Names, Optional, ScopeId, SlotId};
use crate::resolve::values::expect::text_of;
use crate::resolve::values::{Condition, Eval, Failed, Value};
use crate::syntax::ast::{self, ExprKind, Field, Given, Item, ItemKind, Link, Operator, all_items};

/// Parameters that a condition requires to be set, and their slots.
type Known<'a> = Vec<(Cow<'a, str>, SlotId)>;

impl<'a> Resolver<'a> {
    /// `given condition { … } else { … }`
    pub(crate) fn declare_given(&mut self, scope: ScopeId, given: &'a Given, part: Option<usize>) {
        let mut known = Vec::new();
        let Ok(holds) = self.is_given(scope, &given.condition, &mut known) else { return };
        let block = self.names.new_block(scope);
        if holds {
            for (key, slot) in known {
                self.names.scopes[block].names.insert(key, slot);
            }
        }
        self.declare(if holds { &given.items } else { &given.otherwise }, block, part);
    }

    /// Does the use of a part set an optional parameter? In a mechanism there is none.
    pub(crate) fn is_set(&mut self, scope: ScopeId, ast: &'a ast::Value, key: &str) -> bool {
        let Some(instance) = self.names.instance(scope) else {
            let span = ast.optional.unwrap_or(ast.name.ident.span);
            self.error(scope, Code::MisplacedItem, span, "what a mechanism has is never left out")
                .help("give it a default; a parameter of a part may be `optional`");
            return true;
        };
        self.names.field(instance, key).is_some()
    }

    /// True where a condition of a block holds; adds the parameters that it says are set.
    fn is_given(&mut self, scope: ScopeId, expr: &'a ast::Expr, known: &mut Known<'a>) -> Eval<bool> {
        match &expr.kind {
            ExprKind::Unknown => Err(Failed),
            ExprKind::Name(name) => self.sets(scope, name, known),
            ExprKind::Not(inner) => self.is_given(scope, inner, &mut Vec::new()).map(|holds| !holds),
            ExprKind::Chain(first, links) if links[0].operator == Operator::And => {
                let mut holds = self.is_given(scope, first, known)?;
                for link in links {
                    holds &= self.is_given(scope, &link.operand, known)?;
                }
                Ok(holds)
            }
            ExprKind::Chain(first, links) if links[0].operator == Operator::Or => {
                let mut holds = self.is_given(scope, first, &mut Vec::new())?;
                for link in links {
                    holds |= self.is_given(scope, &link.operand, &mut Vec::new())?;
                }
                Ok(holds)
            }
            ExprKind::Chain(_, links)
                if matches!(links[0].operator, Operator::Equal | Operator::NotEqual) =>
            {
                match self.eval(scope, expr)? {
                    Value::Condition(Condition::Known(holds), _) => Ok(holds),
                    _ => Err(Failed),
                }
            }
            _ => {
                self.error(scope, Code::WrongKind, expr.span, "`given` asks whether a parameter is set")
                    .note("it takes names of parameters, `choice == option`, and `and`, `or`, `not`")
                    .help("what depends on values is `if … then … else …`, or `when` of a row");
                Err(Failed)
            }
        }
    }

    /// True where the use sets a parameter or an input.
    fn sets(&mut self, scope: ScopeId, name: &'a ast::IndexedName, known: &mut Known<'a>) -> Eval<bool> {
        let key = self.key(scope, name)?;
        match self.names.optional(scope, &key) {
            Some(Optional::Set(slot)) => {
                self.names.slots[slot].is_read = true;
                known.push((key, slot));
                return Ok(true);
            }
            Some(Optional::Unset) => return Ok(false),
            None => {}
        }
        let Some(instance) = self.names.instance(scope) else { return Err(Failed) };
        let text = name.ident.text.as_str();
        let items = &self.names.instances[instance].definition.items;
        let is_parameter = all_items(items).any(|item| match &item.kind {
            ItemKind::Param(value) | ItemKind::Input(value) => value.name.ident.text == text,
            _ => false,
        });
        let Some(slot) = self.names.find(scope, &key) else {
            if !is_parameter {
                return Err(self.unknown_name(scope, name, &key));
            }
            let message = format!("`{key}` is not known here");
            self.error(scope, Code::UnknownName, name.ident.span, message)
                .help("a parameter stands above the block that asks for it");
            return Err(Failed);
        };
        if !is_parameter {
            let message = format!("`{key}` is no parameter, and so never given");
            self.error(scope, Code::WrongKind, name.ident.span, message)
                .help("`given` asks whether the use sets a parameter or an input");
            return Err(Failed);
        }
        self.names.slots[slot].is_read = true;
        Ok(self.names.field(instance, &key).is_some())
    }

    /// Refuses what the use of a part sets of blocks that are left out.
    pub(crate) fn refuse_left_out(&mut self, id: usize) {
        let (definition, inside) = (self.names.instances[id].definition, self.names.instances[id].scope);
        let mut blocks = Vec::new();
        conditional(&definition.items, &[], &mut blocks);
        for (name, within) in blocks {
            if self.names.is_declared(inside, name) {
                continue;
            }
            for (outer, path, field) in self.names.fields_within(id, name) {
                let message = format!("`{path}` is set, and does not exist here");
                let diagnostic = self.error(outer, Code::UnknownField, field.span(), message);
                diagnostic.help(format!("it exists {}", text_of_blocks(&within)));
            }
        }
    }

    /// Help for an output that a part has in other uses.
    pub(crate) fn where_given(&self, id: usize, name: &str) -> Option<String> {
        let mut blocks = Vec::new();
        conditional(&self.names.instances[id].definition.items, &[], &mut blocks);
        let (_, within) = blocks.into_iter().find(|(of, _)| *of == name)?;
        Some(format!("`{name}` exists {}", text_of_blocks(&within)))
    }
}

impl<'a> Names<'a> {
    /// An optional parameter that can be seen in a scope.
    fn optional(&self, scope: ScopeId, key: &str) -> Option<Optional> {
        self.outwards(scope).find_map(|scope| self.scopes[scope].optional.get(key).copied())
    }

    /// Is a name of a part an optional parameter?
    pub(crate) fn is_optional(&self, scope: ScopeId, key: &str) -> bool {
        self.optional(scope, key).is_some()
    }

    /// Does a part in use have a name, alone or with indices?
    fn is_declared(&self, inside: ScopeId, name: &str) -> bool {
        let scope = &self.scopes[inside];
        let mut keys = scope.names.keys().chain(scope.optional.keys());
        keys.any(|key| key.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with('[')))
    }

    /// Fields of the uses around a part that set a name inside it, or something of the part of that name.
    fn fields_within(&self, id: usize, name: &str) -> Vec<(ScopeId, String, &'a Field)> {
        let mut path = name.to_string();
        let mut found = Vec::new();
        for part in std::iter::once(id).chain(self.around(self.instances[id].outer)) {
            let part = &self.instances[part];
            let inner = format!("{path}.");
            let here = part.fields.iter().filter(|(of, _)| *of == path || of.starts_with(&inner));
            found.append(&mut here.map(|(of, field)| (part.outer, of.clone(), *field)).collect_vec());
            path = format!("{}.{path}", part.key);
        }
        found
    }
}

/// A block that a name stands in.
#[derive(Clone, Copy)]
struct Block<'a> {
    given: &'a Given,
    /// After `else`?
    is_otherwise: bool,
}

/// Blocks in words, from the outermost inwards: "where `friction` is set".
fn text_of_blocks(blocks: &[Block]) -> String {
    let conditions = blocks.iter().filter_map(|of| condition_text(&of.given.condition, of.is_otherwise));
    format!("where {}", conditions.collect_vec().join(", and "))
}

/// A condition in words; negated, where the block stands after `else`.
fn condition_text(expr: &ast::Expr, negated: bool) -> Option<String> {
    match &expr.kind {
        ExprKind::Name(name) => {
            Some(format!("`{}` is {}set", name.ident.text, if negated { "not " } else { "" }))
        }
        ExprKind::Not(inner) => condition_text(inner, !negated),
        ExprKind::Chain(first, links) if matches!(links[0].operator, Operator::And | Operator::Or) => {
            let word = if (links[0].operator == Operator::And) == negated { " or " } else { " and " };
            let parts = std::iter::once(&**first).chain(links.iter().map(|link| &link.operand));
            let parts = parts.map(|part| condition_text(part, negated)).collect::<Option<Vec<_>>>()?;
            Some(parts.join(word))
        }
        ExprKind::Chain(first, links) => {
            let [Link { operator, operand }] = &links[..] else { return None };
            let is = if (*operator == Operator::Equal) == negated { "is not" } else { "is" };
            Some(format!("`{}` {is} `{}`", text_of(first)?, text_of(operand)?))
        }
        _ => None,
    }
}

/// Names of parameters, states, choices, outputs and parts that stand in blocks, with the blocks around each.
fn conditional<'a>(items: &'a [Item], within: &[Block<'a>], found: &mut Vec<(&'a str, Vec<Block<'a>>)>) {
    for item in items {
        match &item.kind {
            ItemKind::Given(given) => {
                for (items, is_otherwise) in [(&given.items, false), (&given.otherwise, true)] {
                    let mut within = within.to_vec();
                    within.push(Block { given, is_otherwise });
                    conditional(items, &within, found);
                }
            }
            ItemKind::Repeat(repeat) => conditional(&repeat.items, within, found),
            kind if !within.is_empty() => {
                found.push_all(names_of(kind).into_iter().map(|name| (name, within.to_vec())));
            }
            _ => {}
        }
    }
}

/// Names of an item that a mechanism with the part can write.
fn names_of(item: &ItemKind) -> Vec<&str> {
    match item {
        ItemKind::Instance(instance) => vec![instance.name.ident.text.as_str()],
        ItemKind::Node(node) => vec![node.name.ident.text.as_str()],
        ItemKind::Constraint(name, ..) => vec![name.ident.text.as_str()],
        ItemKind::Unilateral(row) => vec![row.name.ident.text.as_str()],
        ItemKind::Friction(row) => vec![row.name.ident.text.as_str()],
        ItemKind::Output(outputs) => {
            let names = outputs.iter().filter_map(|output| match (&output.name, &output.value.kind) {
                (Some(name), _) | (None, ExprKind::Name(name)) => Some(name.ident.text.as_str()),
                _ => None,
            });
            names.collect_vec()
        }
        kind => field_name(kind).into_iter().collect_vec(),
    }
}
