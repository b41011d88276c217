//! Scopes: which name means what, and values that are worked out at their first use.
//!
//! Names are bound before anything is evaluated, so that the order of declaration does not matter: a force may read
//! the output of a part that stands below it.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt::Write;

use plm_cas::Expr;

use super::Resolver;
use super::expect::Wanted;
use super::unknown::instead_of;
use super::value::{Eval, Failed, Nature, Reads, Value};
use crate::diag::{Code, help_similar};
use crate::span::Span;
use crate::syntax::ast::{self, Ident, IndexedName};
use crate::units::{Dimension, unit};

pub(super) type ScopeId = usize;
pub(super) type SlotId = usize;

/// Names of one block.
#[derive(Debug, Default)]
pub(super) struct Scope<'a> {
    /// Where to look next: from one turn of a repetition to what encloses it.
    pub(super) parent: Option<ScopeId>,
    /// Names of values, parts, bodies.
    pub(super) names: BTreeMap<Cow<'a, str>, SlotId>,
    /// Names of constraint rows.
    pub(super) rows: BTreeMap<Cow<'a, str>, (usize, Span)>,
    /// Outputs of a part.
    pub(super) outputs: BTreeMap<Cow<'a, str>, SlotId>,
    /// The part whose inside this is.
    pub(super) instance: Option<usize>,
}

/// A named value.
#[derive(Debug)]
pub(super) struct Slot<'a> {
    /// Where it was declared.
    pub(super) span: Span,
    /// Has an expression named it?
    pub(super) is_read: bool,
    state: SlotState<'a>,
}

#[derive(Debug)]
enum SlotState<'a> {
    Known(Value),
    Waiting(Thunk<'a>),
    Busy,
    Failed,
}

/// An expression that waits for its first use.
#[derive(Clone, Copy, Debug)]
pub(super) struct Thunk<'a> {
    pub(super) scope: ScopeId,
    pub(super) expr: &'a ast::Expr,
    pub(super) wanted: Wanted,
}

/// Names that the language has taken.
const RESERVED: &[&str] = &["t", "pi", "gravity", "if", "then", "else", "and", "or", "not", "in", "ground"];

impl<'a> Resolver<'a> {
    pub(super) fn new_scope(&mut self, parent: Option<ScopeId>, instance: Option<usize>) -> ScopeId {
        self.scopes.push(Scope { parent, instance, ..Scope::default() });
        self.scopes.len() - 1
    }

    pub(super) fn known_slot(&mut self, span: Span, value: Value) -> SlotId {
        self.slots.push(Slot { span, is_read: false, state: SlotState::Known(value) });
        self.slots.len() - 1
    }

    pub(super) fn failed_slot(&mut self, span: Span) -> SlotId {
        self.slots.push(Slot { span, is_read: false, state: SlotState::Failed });
        self.slots.len() - 1
    }

    pub(super) fn waiting_slot(&mut self, span: Span, thunk: Thunk<'a>) -> SlotId {
        self.slots.push(Slot { span, is_read: false, state: SlotState::Waiting(thunk) });
        self.slots.len() - 1
    }

    /// The value of a slot, worked out if this is its first use.
    pub(super) fn force(&mut self, slot: SlotId, user: ScopeId, at: Span) -> Eval<Value> {
        match &self.slots[slot].state {
            SlotState::Known(value) => return Ok(value.clone()),
            SlotState::Failed => return Err(Failed),
            SlotState::Busy => {
                let declared = self.slots[slot].span;
                self.error(user, Code::Cycle, at, "this value needs itself")
                    .note_at(declared, "its definition stands here");
                self.slots[slot].state = SlotState::Failed;
                return Err(Failed);
            }
            SlotState::Waiting(_) => {}
        }
        let SlotState::Waiting(thunk) = std::mem::replace(&mut self.slots[slot].state, SlotState::Busy)
        else {
            return Err(Failed);
        };
        let value = self.eval(thunk.scope, thunk.expr);
        let value = value.and_then(|value| self.wanted(thunk.scope, thunk.expr, value, thunk.wanted));
        self.slots[slot].state = match &value {
            Ok(value) => SlotState::Known(value.clone()),
            Err(Failed) => SlotState::Failed,
        };
        value
    }

    /// The full text of a name: `bar`, `bar[3]`.
    pub(super) fn key(&mut self, scope: ScopeId, name: &'a IndexedName) -> Eval<Cow<'a, str>> {
        let mut key = Cow::Borrowed(name.ident.text.as_str());
        for index in &name.indices {
            let value = self.eval_int(scope, index)?;
            // Writing to a string does not fail.
            let _ = write!(key.to_mut(), "[{value}]");
        }
        Ok(key)
    }

    /// Binds a name, unless it is taken. Names without index belong to the turn of the repetition that they stand in,
    /// names with one to what encloses it.
    pub(super) fn bind(&mut self, scope: ScopeId, ident: &Ident, key: Cow<'a, str>, slot: SlotId) {
        let scope = if key.contains('[') { self.home(scope) } else { scope };
        if RESERVED.contains(&key.as_ref()) {
            let message = format!("`{key}` is a word of the language");
            self.error(scope, Code::ReservedName, ident.span, message).help("choose another name");
            return;
        }
        match self.scopes[scope].names.get(&key) {
            Some(first) => {
                let first = self.slots[*first].span;
                self.duplicate(scope, &key, ident.span, first);
            }
            None => {
                self.scopes[scope].names.insert(key, slot);
            }
        }
    }

    pub(super) fn duplicate(&mut self, scope: ScopeId, name: &str, span: Span, first: Span) {
        let message = format!("`{name}` is declared twice");
        self.error(scope, Code::DuplicateName, span, message).note_at(first, "it is declared first here");
    }

    /// A name that stands for a number may not be the name of a unit: `10 N/m` could not be told apart.
    /// What it is to stand for tells which name would do.
    pub(super) fn refuse_unit_name(&mut self, scope: ScopeId, name: &IndexedName, of: Option<Dimension>) {
        let text = &name.ident.text;
        if let Some(unit) = unit(text).filter(|_| name.indices.is_empty()) {
            let message = format!("`{text}` is {}", unit.word);
            let help = format!("try `{}`", instead_of(of.unwrap_or(unit.dimension)));
            self.error(scope, Code::UnitAsName, name.ident.span, message).help(help);
        }
    }

    /// The scope that a repetition stands in.
    pub(super) fn home(&self, mut scope: ScopeId) -> ScopeId {
        while let Some(parent) = self.scopes[scope].parent {
            scope = parent;
        }
        scope
    }

    /// The value of a name.
    pub(super) fn lookup(&mut self, scope: ScopeId, name: &'a IndexedName) -> Eval<Value> {
        let key = self.key(scope, name)?;
        if let Some(slot) = self.find(scope, &key) {
            self.slots[slot].is_read = true;
            return self.force(slot, scope, name.ident.span);
        }
        match key.as_ref() {
            "t" => Ok(Value::Scalar(self.time, Nature::derived(Dimension::TIME, Reads::TIME))),
            "pi" => Ok(Value::Scalar(Expr::pi(), Nature::BARE)),
            "gravity" => self.force(self.gravity, scope, name.ident.span),
            _ => Err(self.unknown_name(scope, name, &key)),
        }
    }

    pub(super) fn find(&self, scope: ScopeId, key: &str) -> Option<SlotId> {
        let mut next = Some(scope);
        while let Some(scope) = next {
            if let Some(slot) = self.scopes[scope].names.get(key) {
                return Some(*slot);
            }
            next = self.scopes[scope].parent;
        }
        None
    }

    /// A constraint row of this part.
    pub(super) fn lookup_row(&mut self, scope: ScopeId, expr: &'a ast::Expr) -> Eval<usize> {
        let ast::ExprKind::Name(name) = &expr.kind else {
            self.error(scope, Code::UnknownRow, expr.span, "the name of a constraint row is expected");
            return Err(Failed);
        };
        let key = self.key(scope, name)?;
        let home = self.home(scope);
        if let Some((row, _)) = self.scopes[home].rows.get(key.as_ref()) {
            return Ok(*row);
        }
        let rows: Vec<String> = self.scopes[home].rows.keys().map(ToString::to_string).collect();
        let rows: Vec<&str> = rows.iter().map(String::as_str).collect();
        let diagnostic =
            self.error(scope, Code::UnknownRow, expr.span, format!("unknown constraint row `{key}`"));
        help_similar(diagnostic, &key, "row", "rows here", &rows);
        Err(Failed)
    }
}
