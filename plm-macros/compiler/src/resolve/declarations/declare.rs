//! The first pass: binding names.

use std::borrow::Cow;
use std::ops::Range;

use plm_cas::Expr;

use crate::collect::PushAll;
use crate::diag::Code;
use crate::model::Name;
use crate::resolve::Resolver;
use crate::resolve::declarations::contact::WrittenContact;
use crate::resolve::declarations::state::StateKind;
use crate::resolve::names::{Optional, ScopeId, Thunk};
use crate::resolve::values::expect::Wanted;
use crate::resolve::values::{Eval, Nature, Quantity, Reads};
use crate::syntax::ast::{self, ExprKind, Item, ItemKind};
use crate::units::{Dimension, DisplayUnit};

/// A `param` or an `input` of the mechanism: a field of an emitted type.
pub(crate) struct UnresolvedField<'a> {
    pub(crate) ast: &'a ast::Value,
    pub(crate) docs: &'a [String],
    pub(crate) scope: ScopeId,
    pub(crate) name: Name,
    pub(crate) symbol: Expr,
    pub(crate) unit: DisplayUnit,
}

/// All repetitions together may have so many turns.
const MAX_TURNS: usize = 4096;

impl<'a> Resolver<'a> {
    /// Binds what items declare, in a scope; inside a part, with the index of the mechanism's part that it belongs to.
    pub(crate) fn declare(&mut self, items: &'a [Item], scope: ScopeId, part: Option<usize>) {
        for item in items {
            match &item.kind {
                ItemKind::Gravity(value) => self.declare_gravity(scope, item, value),
                ItemKind::Formulation(formulation) => self.declare_formulation(scope, formulation),
                ItemKind::Code(repetitions) => self.declare_code(scope, repetitions),
                ItemKind::Emit(methods) => self.declare_steps(scope, methods),
                ItemKind::Stabilisation(method, time) => {
                    self.declare_stabilisation(scope, method, time.as_ref());
                }
                ItemKind::Impacts(law) => self.declare_impacts(scope, law),
                ItemKind::Allow(codes) => self.declare_allowed(codes),
                ItemKind::Param(value) => self.declare_value(scope, item, value, Reads::PARAM),
                ItemKind::Input(value) => self.declare_value(scope, item, value, Reads::INPUT),
                ItemKind::State(value) => self.declare_state(scope, value, StateKind::Continuous),
                ItemKind::Discrete(value) => self.declare_state(scope, value, StateKind::Discrete),
                ItemKind::When(when) => self.unresolved.whens.push((scope, when)),
                ItemKind::Let(name, value) => self.declare_let(scope, name, value),
                ItemKind::Rate(name, value) => self.declare_rate(scope, name, value),
                ItemKind::Choice(choice) => self.declare_choice(scope, choice),
                ItemKind::Function(function) => self.declare_function(scope, function),
                ItemKind::Points(points) => self.declare_points(scope, points),
                ItemKind::Ground(ports) => self.declare_ground(scope, ports),
                ItemKind::Body(body) => self.declare_body(scope, body),
                ItemKind::Instance(instance) => self.declare_instance(scope, instance, part),
                ItemKind::Constraint(name, left, right, when) => {
                    self.declare_row(scope, name, ([left, right], when.as_ref()), part);
                }
                ItemKind::Unilateral(row) => {
                    self.declare_contact(scope, WrittenContact::Unilateral(row), part);
                }
                ItemKind::Friction(row) => self.declare_contact(scope, WrittenContact::Friction(row), part),
                ItemKind::Require(name, condition) => self.declare_requirement(scope, name, condition),
                ItemKind::Load(load) => self.declare_load(scope, load, part),
                ItemKind::Node(node) => self.declare_node(scope, node),
                ItemKind::Output(outputs) => self.declare_outputs(scope, outputs, &item.docs),
                ItemKind::Picture(names) => self.declare_picture(scope, names),
                ItemKind::Shape(shape) => self.declare_shape(scope, shape),
                ItemKind::Observe(list) => {
                    self.unresolved.observed.push_all(list.iter().map(|expr| (scope, expr)));
                }
                ItemKind::Repeat(repeat) => self.declare_repeat(scope, repeat, part),
                ItemKind::Given(given) => self.declare_given(scope, given, part),
                // Read when the part is used, and when the library is loaded.
                ItemKind::Pair(_) | ItemKind::Definition(_) | ItemKind::Domain(_) => {}
            }
        }
    }

    /// A `param` or an `input`: a field of the mechanism, or what the use of a part sets.
    fn declare_value(&mut self, scope: ScopeId, item: &'a Item, ast: &'a ast::Value, kind: Reads) {
        self.refuse_unit_name(scope, &ast.name, dimension_of(ast.unit.as_ref(), ast.value.as_ref()));
        let Some((key, unit)) = self.name_and_unit(scope, ast) else { return };
        let span = ast.name.ident.span;
        if ast.optional.is_some() && !self.is_set(scope, ast, &key) {
            let owner = self.names.owner(scope);
            self.names.scopes[owner].optional.insert(key, Optional::Unset);
            return;
        }
        let slot = if let Some(instance) = self.names.instance(scope) {
            self.field_slot(instance, scope, ast, &unit, kind)
        } else {
            let name = Name { text: key.to_string(), span };
            let symbol = Expr::symbol(&name.text);
            let value = Quantity::new(symbol, Nature::written(unit.dimension, kind)).into();
            if kind == Reads::INPUT {
                self.calculus.held.push(symbol);
            }
            let fields =
                if kind == Reads::PARAM { &mut self.unresolved.params } else { &mut self.unresolved.inputs };
            fields.push(UnresolvedField { ast, docs: &item.docs, scope, name, symbol, unit });
            self.names.known_slot(span, value)
        };
        let what = if kind == Reads::INPUT { "input" } else { "parameter" };
        self.should_be_read(what, &ast.name.ident, slot);
        if ast.optional.is_some() {
            let owner = self.names.owner(scope);
            self.names.scopes[owner].optional.insert(key, Optional::Set(slot));
        } else {
            self.bind(scope, &ast.name.ident, key, slot);
        }
    }

    /// The key and the unit of a declared value. Without a unit, that of its default counts.
    pub(crate) fn name_and_unit(
        &mut self,
        scope: ScopeId,
        ast: &'a ast::Value,
    ) -> Option<(Cow<'a, str>, DisplayUnit)> {
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
                let slot = self.names.failed_slot(span);
                self.bind(scope, &ast.name.ident, key, slot);
                return None;
            }
        };
        Some((key, unit))
    }

    fn declare_let(&mut self, scope: ScopeId, name: &'a ast::IndexedName, value: &'a ast::Expr) {
        self.refuse_unit_name(scope, name, dimension_of(None, Some(value)));
        let Ok(key) = self.key(scope, name) else { return };
        let slot =
            self.names.waiting_slot(name.ident.span, Thunk { scope, expr: value, wanted: Wanted::Anything });
        self.names.checks.push(slot);
        self.should_be_read("`let`", &name.ident, slot);
        self.bind(scope, &name.ident, key, slot);
    }

    fn declare_outputs(&mut self, scope: ScopeId, outputs: &'a [ast::Output], docs: &'a [String]) {
        let home = self.names.home(scope);
        for output in outputs {
            if self.names.instance(scope).is_none() {
                self.unresolved.outputs.push((scope, output, docs));
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
            let slot = self.names.waiting_slot(name.ident.span, thunk);
            match self.names.scopes[home].outputs.get(&key) {
                Some(first) => {
                    let first = self.names.slots[*first].span;
                    self.duplicate(scope, &key, name.ident.span, first);
                }
                None => {
                    self.names.scopes[home].outputs.insert(key, slot);
                }
            }
        }
    }

    fn declare_repeat(&mut self, scope: ScopeId, repeat: &'a ast::Repeat, part: Option<usize>) {
        let Ok(indices) = self.indices(scope, &repeat.turns) else { return };
        for index in indices {
            self.unresolved.turns += 1;
            if self.unresolved.turns > MAX_TURNS {
                let message = format!("more than {MAX_TURNS} repetitions in all");
                let span = repeat.turns.from.span.to(repeat.turns.to.span);
                self.error(scope, Code::TooMany, span, message);
                return;
            }
            let turn = self.turn(scope, &repeat.turns, index);
            self.declare(&repeat.items, turn, part);
        }
    }

    /// The values of the index of a repetition.
    pub(crate) fn indices(&mut self, scope: ScopeId, turns: &'a ast::Turns) -> Eval<Range<i64>> {
        let (from, to) = (self.eval_int(scope, &turns.from), self.eval_int(scope, &turns.to));
        let (from, to) = (from?, to?);
        Ok(from..if turns.inclusive { to.saturating_add(1) } else { to })
    }

    /// A scope that has a value of the index of a repetition.
    pub(crate) fn turn(&mut self, scope: ScopeId, turns: &'a ast::Turns, index: i64) -> ScopeId {
        let turn = self.names.new_scope(Some(scope), None);
        let value = Quantity::new(Expr::from(index), Nature::BARE).into();
        let slot = self.names.known_slot(turns.index.span, value);
        self.bind(turn, &turns.index, Cow::Borrowed(&turns.index.text), slot);
        turn
    }

    /// In a repetition a name that the rest of the mechanism can see needs an index.
    pub(crate) fn needs_index(&mut self, scope: ScopeId, name: &ast::IndexedName) -> bool {
        let repeated = self.names.is_repeated(scope) && name.indices.is_empty();
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
pub(crate) fn dimension_of(unit: Option<&DisplayUnit>, value: Option<&ast::Expr>) -> Option<Dimension> {
    match (unit, value) {
        (Some(unit), _) | (None, Some(ast::Expr { kind: ExprKind::Quantity(_, unit), .. })) => {
            Some(unit.dimension)
        }
        _ => None,
    }
}
