//! The first pass: binding names.

use std::borrow::Cow;

use plm_cas::Expr;

use super::expect::Wanted;
use super::scope::{ScopeId, SlotId, Thunk};
use super::value::{Nature, Reads, Value};
use super::{Resolver, StateState, ValueState};
use crate::diag::Code;
use crate::model::{Name, Rung};
use crate::syntax::ast::{self, ExprKind, Item, ItemKind, Mechanism};
use crate::units::{Dimension, DisplayUnit};

/// All repetitions together may have so many turns.
const MAX_TURNS: usize = 4096;

impl<'a> Resolver<'a> {
    /// The slot of `gravity`; zero if nothing is declared.
    pub(super) fn default_gravity(&mut self, mechanism: &'a Mechanism) -> SlotId {
        let zero = Value::Scalar(Expr::ZERO, Nature::written(Dimension::ACCELERATION, Reads::NOTHING));
        self.known_slot(mechanism.name.span, zero)
    }

    /// Binds what items declare, in a scope; inside a part, with the index of the mechanism's part that it belongs to.
    pub(super) fn declare(&mut self, items: &'a [Item], scope: ScopeId, part: Option<usize>) {
        for item in items {
            match &item.kind {
                ItemKind::Gravity(value) => self.declare_gravity(scope, item, value),
                ItemKind::Rung(rung) => self.declare_rung(scope, rung),
                ItemKind::Stabilisation(method, time) => {
                    self.declare_stabilisation(scope, method, time.as_ref());
                }
                ItemKind::Allow(codes) => self.declare_allowed(codes),
                ItemKind::Param(value) => self.declare_value(scope, item, value, Reads::PARAM),
                ItemKind::Input(value) => self.declare_value(scope, item, value, Reads::INPUT),
                ItemKind::State(value) => self.declare_state(scope, value),
                ItemKind::Let(name, value) => self.declare_let(scope, name, value),
                ItemKind::Rate(name, value) => self.declare_rate(scope, name, value),
                ItemKind::Choice(choice) => self.declare_choice(scope, choice),
                ItemKind::Ground(ports) => self.declare_ground(scope, ports),
                ItemKind::Body(body) => self.declare_body(scope, body),
                ItemKind::Instance(instance) => self.declare_instance(scope, instance, part),
                ItemKind::Constraint(name, left, right) => self.declare_row(scope, name, (left, right), part),
                ItemKind::Require(name, condition) => self.declare_requirement(scope, name, condition),
                ItemKind::Load(load) => self.declare_load(scope, load, part),
                ItemKind::Node(node) => self.declare_node(scope, node),
                ItemKind::Output(outputs) => self.declare_outputs(scope, outputs, &item.docs),
                ItemKind::Picture(names) => self.declare_picture(scope, names),
                ItemKind::Observe(list) => self.observed.extend(list.iter().map(|expr| (scope, expr))),
                ItemKind::Repeat(repeat) => self.declare_repeat(scope, repeat, part),
                // Read when the part is used, and when the library is loaded.
                ItemKind::Pair(_) | ItemKind::Definition(_) | ItemKind::Domain(_) => {}
            }
        }
    }

    fn declare_gravity(&mut self, scope: ScopeId, item: &'a Item, value: &'a ast::Expr) {
        let reads = Reads::SCHEDULED.and(Reads::INPUT);
        let thunk =
            Thunk { scope, expr: value, wanted: Wanted::NumberOrVector(Dimension::ACCELERATION, reads) };
        if self.gravity_is_declared {
            let first = self.slots[self.gravity].span;
            self.error(scope, Code::RepeatedItem, item.span, "gravity is declared twice")
                .note_at(first, "it is declared first here");
            return;
        }
        self.gravity_is_declared = true;
        self.gravity = self.waiting_slot(item.span, thunk);
        self.checks.push(self.gravity);
    }

    fn declare_stabilisation(&mut self, scope: ScopeId, method: &'a ast::Ident, time: Option<&'a ast::Expr>) {
        if let Some((first, _)) = self.stabilisation {
            let first = first.span;
            self.error(scope, Code::RepeatedItem, method.span, "the stabilisation is declared twice")
                .note_at(first, "it is declared first here");
        } else if method.text == "projection" || method.text == "baumgarte" {
            self.stabilisation = Some((method, time));
        } else {
            self.unknown_option(scope, &method.text, method.span, &["projection", "baumgarte"]);
        }
    }

    fn declare_rung(&mut self, scope: ScopeId, rung: &'a ast::Ident) {
        if let Some(first) = self.rung {
            let first = first.span;
            self.error(scope, Code::RepeatedItem, rung.span, "the rung is declared twice")
                .note_at(first, "it is declared first here");
        } else if Rung::NAMES.iter().any(|(name, _)| rung.text == *name) {
            self.rung = Some(rung);
        } else {
            self.unknown_option(scope, &rung.text, rung.span, &Rung::NAMES.map(|(name, _)| name));
        }
    }

    fn declare_allowed(&mut self, codes: &'a [ast::Ident]) {
        for code in codes {
            if Code::ALL.iter().any(|known| known.id() == code.text && known.id().starts_with('W')) {
                self.allowed.push(code.text.clone());
            } else {
                let message = format!("there is no warning `{}` to allow", code.text);
                self.sink.warning(Code::UnknownCode, code.span, message);
            }
        }
    }

    /// A `param` or an `input`: a field of the mechanism, or what the use of a part sets.
    fn declare_value(&mut self, scope: ScopeId, item: &'a Item, ast: &'a ast::Value, kind: Reads) {
        self.refuse_unit_name(scope, &ast.name, dimension_of(ast.unit.as_ref(), ast.value.as_ref()));
        let Some((key, unit)) = self.name_and_unit(scope, ast) else { return };
        let span = ast.name.ident.span;
        let slot = if let Some(instance) = self.scopes[self.home(scope)].instance {
            self.field_slot(instance, scope, ast, &unit, kind)
        } else {
            let name = Name { text: key.to_string(), span };
            let symbol = Expr::symbol(&name.text);
            let value = Value::Scalar(symbol, Nature::written(unit.dimension, kind));
            if kind == Reads::INPUT {
                self.input_symbols.push(symbol);
            }
            let fields = if kind == Reads::PARAM { &mut self.params } else { &mut self.inputs };
            fields.push(ValueState { ast, docs: &item.docs, scope, name, symbol, unit });
            self.known_slot(span, value)
        };
        let what = if kind == Reads::INPUT { "input" } else { "parameter" };
        self.should_be_read(what, &ast.name.ident, slot);
        self.bind(scope, &ast.name.ident, key, slot);
    }

    /// The key and the unit of a declared value. Without a unit, that of its default counts.
    fn name_and_unit(&mut self, scope: ScopeId, ast: &'a ast::Value) -> Option<(Cow<'a, str>, DisplayUnit)> {
        let key = self.key(scope, &ast.name).ok()?;
        let unit = match (&ast.unit, &ast.value) {
            (Some(unit), _) | (None, Some(ast::Expr { kind: ExprKind::Quantity(_, unit), .. })) => {
                unit.clone()
            }
            (None, Some(ast::Expr { kind: ExprKind::Number(_), .. })) => DisplayUnit::si(Dimension::NUMBER),
            (None, value) => {
                let span = ast.name.ident.span;
                if !matches!(value, Some(ast::Expr { kind: ExprKind::Unknown, .. })) {
                    let message = format!("`{key}` has no unit");
                    let help = format!("write `{key}: m`, or `{key}: 1` for a bare number");
                    self.error(scope, Code::MissingUnit, span, message).help(help);
                }
                // What reads it has been told already.
                let slot = self.failed_slot(span);
                self.bind(scope, &ast.name.ident, key, slot);
                return None;
            }
        };
        Some((key, unit))
    }

    fn declare_state(&mut self, scope: ScopeId, ast: &'a ast::Value) {
        self.refuse_unit_name(scope, &ast.name, dimension_of(ast.unit.as_ref(), ast.value.as_ref()));
        let Some((key, unit)) = self.name_and_unit(scope, ast) else { return };
        let text = format!("{}{key}", self.prefix(scope));
        let symbol = Expr::symbol(&text);
        let stand_in = Expr::symbol(format!("rate_{text}"));
        self.directions.insert(symbol, stand_in);
        let name = Name { text, span: ast.name.ident.span };
        let value = Value::Scalar(symbol, Nature::written(unit.dimension, Reads::STATE));
        self.state_of.insert(symbol, self.states.len());
        let set = self.scopes[self.home(scope)].instance.and_then(|instance| self.field(instance, &key));
        let (start, locked) = match set {
            Some((outer, field)) => (Some((outer, &field.value)), field.locked.is_some()),
            None => (ast.value.as_ref().map(|value| (scope, value)), ast.locked),
        };
        self.states.push(StateState { ast, scope, name, symbol, unit, start, locked, stand_in, rate: None });
        let slot = self.known_slot(ast.name.ident.span, value);
        self.bind(scope, &ast.name.ident, key, slot);
    }

    fn declare_rate(&mut self, scope: ScopeId, name: &'a ast::IndexedName, value: &'a ast::Expr) {
        self.late_rates.push((scope, name, value));
    }

    /// Rates are given to their states when all states are declared.
    pub(super) fn assign_rates(&mut self) {
        for (scope, name, value) in std::mem::take(&mut self.late_rates) {
            let Ok(key) = self.key(scope, name) else { continue };
            let span = name.ident.span;
            let slot = self.find(scope, &key).map(|slot| self.force(slot, scope, span));
            let state = match slot {
                Some(Err(_)) => continue,
                Some(Ok(Value::Scalar(symbol, _))) => self.state_of.get(&symbol).copied(),
                _ => None,
            };
            let Some(state) = state else {
                let message = format!("there is no state `{key}`");
                self.error(scope, Code::StateRate, span, message)
                    .help(format!("write `state {key}: unit = 0;`"));
                continue;
            };
            let state = &mut self.states[state];
            match state.rate {
                None => state.rate = Some((scope, value, span)),
                Some((.., first)) => {
                    self.error(scope, Code::StateRate, span, format!("the state `{key}` has two rates"))
                        .note_at(first, "the first stands here");
                }
            }
        }
    }

    fn declare_let(&mut self, scope: ScopeId, name: &'a ast::IndexedName, value: &'a ast::Expr) {
        self.refuse_unit_name(scope, name, dimension_of(None, Some(value)));
        let Ok(key) = self.key(scope, name) else { return };
        let slot = self.waiting_slot(name.ident.span, Thunk { scope, expr: value, wanted: Wanted::Anything });
        self.checks.push(slot);
        self.should_be_read("`let`", &name.ident, slot);
        self.bind(scope, &name.ident, key, slot);
    }

    fn declare_outputs(&mut self, scope: ScopeId, outputs: &'a [ast::Output], docs: &'a [String]) {
        let home = self.home(scope);
        for output in outputs {
            if self.scopes[home].instance.is_none() {
                self.outputs.push((scope, output, docs));
                continue;
            }
            let ((Some(name), _) | (None, ExprKind::Name(name))) = (&output.name, &output.value.kind) else {
                let message = "an output of a part has a name";
                self.error(scope, Code::UnexpectedToken, output.value.span, message)
                    .help("write `output name = …;`");
                continue;
            };
            let Ok(key) = self.key(scope, name) else { continue };
            let thunk = Thunk { scope, expr: &output.value, wanted: Wanted::Anything };
            let slot = self.waiting_slot(name.ident.span, thunk);
            match self.scopes[home].outputs.get(&key) {
                Some(first) => {
                    let first = self.slots[*first].span;
                    self.duplicate(scope, &key, name.ident.span, first);
                }
                None => {
                    self.scopes[home].outputs.insert(key, slot);
                }
            }
        }
    }

    fn declare_repeat(&mut self, scope: ScopeId, repeat: &'a ast::Repeat, part: Option<usize>) {
        let bounds = (self.eval_int(scope, &repeat.from), self.eval_int(scope, &repeat.to));
        let (Ok(from), Ok(to)) = bounds else { return };
        let to = if repeat.inclusive { to.saturating_add(1) } else { to };
        for index in from..to {
            self.turns += 1;
            if self.turns > MAX_TURNS {
                let message = format!("more than {MAX_TURNS} repetitions in all");
                self.error(scope, Code::TooMany, repeat.from.span.to(repeat.to.span), message);
                return;
            }
            let turn = self.new_scope(Some(scope), None);
            let value = Value::Scalar(Expr::from(index), Nature::BARE);
            let slot = self.known_slot(repeat.index.span, value);
            self.bind(turn, &repeat.index, Cow::Borrowed(&repeat.index.text), slot);
            self.declare(&repeat.items, turn, part);
        }
    }

    /// In a repetition a name that the rest of the mechanism can see needs an index.
    pub(super) fn needs_index(&mut self, scope: ScopeId, name: &ast::IndexedName) -> bool {
        let repeated = self.scopes[scope].parent.is_some() && name.indices.is_empty();
        if repeated {
            let text = &name.ident.text;
            self.error(
                scope,
                Code::NeedsIndex,
                name.ident.span,
                format!("`{text}` is repeated and needs an index"),
            )
            .help(format!("write `{text}[i]` with the index of the repetition"));
        }
        repeated
    }
}

/// The dimension that a declaration shows, by its unit or by a literal.
fn dimension_of(unit: Option<&DisplayUnit>, value: Option<&ast::Expr>) -> Option<Dimension> {
    match (unit, value) {
        (Some(unit), _) | (None, Some(ast::Expr { kind: ExprKind::Quantity(_, unit), .. })) => {
            Some(unit.dimension)
        }
        _ => None,
    }
}
