//! Scopes: which name means what, and values that are worked out at their first use.
//!
//! Names are bound before anything is evaluated, so that the order of declaration does not matter: a force may read
//! the output of a part that stands below it.

use crate::collect::CollectVec;
use std::borrow::Cow;
use std::fmt::Write;

use plm_cas::Expr;

use crate::diag::{Code, help_similar};
use crate::resolve::Resolver;
use crate::resolve::names::unknown::instead_of;
use crate::resolve::names::{RowId, ScopeId, Slot, SlotId, Thunk};
use crate::resolve::values::expect::Wanted;
use crate::resolve::values::lazy::Lazy;
use crate::resolve::values::{Eval, Failed, Nature, Quantity, Reads, Value};
use crate::span::Span;
use crate::syntax::ast::{self, Ident, IndexedName};
use crate::units::{Dimension, MAY_BE_NAMES, unit};

/// Names that the language has taken.
pub(crate) const RESERVED: &[&str] =
    &["t", "pi", "gravity", "if", "then", "else", "and", "or", "not", "in", "for", "ground"];

impl<'a> Resolver<'a> {
    /// The value of a slot, worked out if this is its first use.
    pub(crate) fn slot_value(&mut self, slot: SlotId, user: ScopeId, at: Span) -> Eval<Value> {
        let Slot { span: declared, thunk, ref value, .. } = self.names.slots[slot];
        // The through quantities of a node are known before its across quantity, which may read them.
        if let (Lazy::Busy, Some(Thunk { wanted: Wanted::Node(node), .. })) = (value, thunk) {
            return Ok(Value::Node(node));
        }
        self.lazy(
            |of| &mut of.names.slots[slot].value,
            |of| {
                of.error(user, Code::Cycle, at, "this value needs itself")
                    .note_at(declared, "its definition stands here");
            },
            |of| {
                let Thunk { scope, expr, wanted } = thunk.ok_or(Failed)?;
                let value = of.eval(scope, expr)?;
                of.wanted(scope, expr, value, wanted)
            },
        )
    }

    /// The full text of a name: `bar`, `bar[3]`.
    pub(crate) fn key(&mut self, scope: ScopeId, name: &'a IndexedName) -> Eval<Cow<'a, str>> {
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
    pub(crate) fn bind(&mut self, scope: ScopeId, ident: &Ident, key: Cow<'a, str>, slot: SlotId) {
        let scope = if key.contains('[') { self.names.home(scope) } else { self.names.owner(scope) };
        if RESERVED.contains(&key.as_ref()) {
            let message = format!("`{key}` is a word of the language");
            self.error(scope, Code::ReservedName, ident.span, message).help("choose another name");
            return;
        }
        match self.names.scopes[scope].names.get(&key) {
            Some(first) => {
                let first = self.names.slots[*first].span;
                self.duplicate(scope, &key, ident.span, first);
            }
            None => {
                self.names.scopes[scope].names.insert(key, slot);
            }
        }
    }

    pub(crate) fn duplicate(&mut self, scope: ScopeId, name: &str, span: Span, first: Span) {
        let message = format!("`{name}` is declared twice");
        self.error(scope, Code::DuplicateName, span, message).note_at(first, "it is declared first here");
    }

    /// A name that stands for a number may not be the name of a unit: `10 N/m` could not be told apart.
    /// The dimension that it is to stand for tells which name would do.
    pub(crate) fn refuse_unit_name(&mut self, scope: ScopeId, name: &IndexedName, of: Option<Dimension>) {
        let text = &name.ident.text;
        let is_free = MAY_BE_NAMES.contains(&text.as_str());
        if let Some(unit) = unit(text).filter(|_| name.indices.is_empty() && !is_free) {
            let message = format!("`{text}` is {}", unit.word);
            let help = format!("try `{}`", instead_of(of.unwrap_or(unit.dimension)));
            self.error(scope, Code::UnitAsName, name.ident.span, message).help(help);
        }
    }

    /// The value of a name.
    pub(crate) fn lookup(&mut self, scope: ScopeId, name: &'a IndexedName) -> Eval<Value> {
        let key = self.key(scope, name)?;
        if let Some(slot) = self.names.find(scope, &key) {
            self.names.slots[slot].is_read = true;
            return self.slot_value(slot, scope, name.ident.span);
        }
        if self.is_missing_list(scope, name) {
            return Err(Failed);
        }
        match key.as_ref() {
            "t" => {
                Ok(Quantity::new(self.calculus.time, Nature::derived(Dimension::TIME, Reads::TIME)).into())
            }
            "pi" => Ok(Quantity::new(Expr::pi(), Nature::BARE).into()),
            "gravity" => self.gravity(scope, name.ident.span),
            _ => Err(self.unknown_name(scope, name, &key)),
        }
    }

    /// Is it an element of a list whose mistake has been told already?
    fn is_missing_list(&self, scope: ScopeId, name: &IndexedName) -> bool {
        let list = self.names.find(scope, &name.ident.text).filter(|_| !name.indices.is_empty());
        list.is_some_and(|slot| matches!(self.names.slots[slot].value, Lazy::Failed))
    }

    /// A row of this part, or of a part in use: `row`, `part.row`, `part.inside.row[2]`.
    pub(crate) fn lookup_row(&mut self, scope: ScopeId, expr: &'a ast::Expr) -> Eval<RowId> {
        let found = match &expr.kind {
            ast::ExprKind::Name(name) => Some((name, None)),
            ast::ExprKind::Path(base, members) => match members.split_last() {
                Some((name, parts)) => {
                    self.part_in_use(scope, base, parts)?.map(|instance| (name, Some(instance)))
                }
                None => None,
            },
            _ => None,
        };
        let Some((name, instance)) = found else {
            self.error(scope, Code::UnknownRow, expr.span, "the name of a row is expected")
                .note("a row is a constraint, a gap or a friction, here or in a part: `row`, `part.row`");
            return Err(Failed);
        };
        let key = self.key(scope, name)?;
        let home = match instance {
            Some(instance) => self.names.instances[instance].scope,
            None => self.names.home(scope),
        };
        match self.names.scopes[home].rows.get(key.as_ref()) {
            Some((row, _)) => Ok(*row),
            None => match self.part_of_name(scope, &key).filter(|_| instance.is_none()) {
                Some(part) => Err(self.part_for_row(scope, expr, part)),
                None => Err(self.unknown_row(scope, name.ident.span, &key, home, instance)),
            },
        }
    }

    /// The part in use that stands in front of the last point of a path, if it is one.
    fn part_in_use(
        &mut self,
        scope: ScopeId,
        base: &'a ast::Expr,
        members: &'a [IndexedName],
    ) -> Eval<Option<usize>> {
        let mut value = self.eval(scope, base)?;
        for member in members {
            value = self.member(scope, &value, member)?;
        }
        Ok(if let Value::Instance(instance) = value { Some(instance) } else { None })
    }

    /// The part in use of a name, as its own declaration has it.
    fn part_of_name(&self, scope: ScopeId, key: &str) -> Option<usize> {
        let home = self.names.home(scope);
        self.names.instances.iter().position(|part| part.name == key && self.names.home(part.outer) == home)
    }

    /// A part where one of its rows is wanted.
    fn part_for_row(&mut self, scope: ScopeId, expr: &ast::Expr, part: usize) -> Failed {
        let (inside, name) = (self.names.instances[part].scope, self.names.instances[part].name.clone());
        let rows = self.names.scopes[inside].rows.keys();
        let rows: Vec<String> = rows.map(|row| format!("`{name}.{row}`")).collect_vec();
        let message = format!("`{name}` is a part, and a reaction is that of a row");
        let diagnostic = self.error(scope, Code::UnknownRow, expr.span, message);
        if rows.is_empty() {
            diagnostic
                .help(format!("`{name}` has no row of its own; what it shows is an output: `{name}.…`"));
        } else {
            diagnostic.help(format!("name one of its rows: {}", rows.join(", ")));
        }
        Failed
    }

    fn unknown_row(
        &mut self,
        scope: ScopeId,
        span: Span,
        key: &str,
        home: ScopeId,
        instance: Option<usize>,
    ) -> Failed {
        let shown = self.names.scopes[home].rows.keys().filter(|_| self.sink.shows(Code::UnknownRow));
        let rows: Vec<String> = shown.map(ToString::to_string).collect_vec();
        let rows: Vec<&str> = rows.iter().map(String::as_str).collect_vec();
        let (message, of) = match instance {
            Some(part) => {
                let part = &self.names.instances[part].name;
                (format!("the part `{part}` has no row `{key}`"), format!("rows of `{part}`"))
            }
            None => (format!("unknown row `{key}`"), "rows here".to_string()),
        };
        let given = instance.and_then(|part| self.where_given(part, key));
        let diagnostic = self.error(scope, Code::UnknownRow, span, message);
        match given {
            Some(given) => {
                diagnostic.help(given);
            }
            None => help_similar(diagnostic, key, "row", &of, &rows),
        }
        Failed
    }
}
