//! First-order states and their rates.

use crate::collect::CollectVec;
use plm_cas::{Expr, algebra};

use crate::diag::Code;
use crate::model::{Name, State};
use crate::resolve::Resolver;
use crate::resolve::declarations::declare::dimension_of;
use crate::resolve::names::ScopeId;
use crate::resolve::values::{Nature, Quantity, Reads, Value};
use crate::syntax::ast::{self, IndexedName};
use crate::units::{Dimension, DisplayUnit};

/// How a state changes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum StateKind {
    /// With its rate.
    Continuous,
    /// At events alone.
    Discrete,
}

/// A state that was declared.
pub(crate) struct UnresolvedState<'a> {
    ast: &'a ast::Value,
    pub(crate) scope: ScopeId,
    pub(crate) kind: StateKind,
    pub(crate) name: Name,
    symbol: Expr,
    pub(crate) unit: DisplayUnit,
    /// Start value, and the scope in which it is evaluated: from the use of its part if that sets it, else from its declaration.
    start: Option<(ScopeId, &'a ast::Expr)>,
    locked: bool,
    /// Stands for its rate where that is used before it is known.
    pub(crate) placeholder: Expr,
    rate: Option<UnresolvedRate<'a>>,
}

/// A rate that was declared.
#[derive(Clone, Copy)]
pub(crate) struct UnresolvedRate<'a> {
    scope: ScopeId,
    /// The name of its state.
    name: &'a IndexedName,
    value: &'a ast::Expr,
}

impl<'a> Resolver<'a> {
    /// `state name: unit = start;`, `discrete name: unit = start;`
    pub(crate) fn declare_state(&mut self, scope: ScopeId, ast: &'a ast::Value, kind: StateKind) {
        self.refuse_unit_name(scope, &ast.name, dimension_of(ast.unit.as_ref(), ast.value.as_ref()));
        let Some((key, unit)) = self.name_and_unit(scope, ast) else { return };
        let text = format!("{}{key}", self.names.prefix(scope));
        let symbol = Expr::symbol(&text);
        let placeholder = Expr::symbol(format!("rate_{text}"));
        self.calculus.changes(symbol, placeholder);
        let name = Name { text, span: ast.name.ident.span };
        let value = Quantity::new(symbol, Nature::written(unit.dimension, Reads::STATE)).into();
        let set = self.names.instance(scope).and_then(|instance| self.names.field(instance, &key));
        let (start, locked) = match set {
            Some((outer, field)) => (Some((outer, &field.value)), field.locked.is_some()),
            None => (ast.value.as_ref().map(|value| (scope, value)), ast.locked),
        };
        self.unresolved.states.push(UnresolvedState {
            ast,
            scope,
            kind,
            name,
            symbol,
            unit,
            start,
            locked,
            placeholder,
            rate: None,
        });
        let slot = self.names.known_slot(ast.name.ident.span, value);
        self.bind(scope, &ast.name.ident, key, slot);
    }

    /// `rate name = value;`
    pub(crate) fn declare_rate(&mut self, scope: ScopeId, name: &'a IndexedName, value: &'a ast::Expr) {
        self.unresolved.rates.push(UnresolvedRate { scope, name, value });
    }

    /// Gives the rates to their states.
    fn assign_rates(&mut self) {
        for rate in std::mem::take(&mut self.unresolved.rates) {
            let (scope, span) = (rate.scope, rate.name.ident.span);
            let Ok(key) = self.key(scope, rate.name) else { continue };
            let named = self.names.find(scope, &key).map(|slot| self.slot_value(slot, scope, span));
            let state = match named {
                Some(Err(_)) => continue,
                Some(Ok(Value::Scalar(named))) => self.state_of(named.value),
                _ => None,
            };
            let Some(state) = state else {
                let message = format!("there is no state `{key}`");
                self.error(scope, Code::StateRate, span, message)
                    .help(format!("write `state {key}: unit = 0;`"));
                continue;
            };
            if self.unresolved.states[state].kind == StateKind::Discrete {
                let message = format!("`{key}` is discrete: it has no rate");
                self.error(scope, Code::StateRate, span, message)
                    .help("a `when` sets it; what has a rate is a `state`");
            } else if let Some(first) = self.unresolved.states[state].rate {
                self.error(scope, Code::StateRate, span, format!("the state `{key}` has two rates"))
                    .note_at(first.name.ident.span, "the first stands here");
            } else {
                self.unresolved.states[state].rate = Some(rate);
            }
        }
    }

    /// The state that a symbol stands for; symbols of later states are greater.
    pub(crate) fn state_of(&self, symbol: Expr) -> Option<usize> {
        self.unresolved.states.binary_search_by_key(&symbol, |state| state.symbol).ok()
    }

    /// Are the states that a value reads discrete, all of them?
    pub(crate) fn reads_discrete_states_alone(&self, value: Expr) -> bool {
        let states = algebra::symbols(&[value]).into_iter().filter_map(|symbol| self.state_of(symbol));
        states
            .collect_vec()
            .into_iter()
            .all(|state| self.unresolved.states[state].kind == StateKind::Discrete)
    }

    /// All states whose start and rate could be evaluated.
    pub(crate) fn evaluate_states(&mut self) -> Vec<State> {
        self.assign_rates();
        (0..self.unresolved.states.len()).filter_map(|state| self.evaluate_state(state)).collect_vec()
    }

    fn evaluate_state(&mut self, state: usize) -> Option<State> {
        let UnresolvedState { ast, scope, kind, symbol, start, locked, rate, .. } =
            self.unresolved.states[state];
        let (name, unit) =
            (self.unresolved.states[state].name.clone(), self.unresolved.states[state].unit.clone());
        let start = match start {
            Some((scope, expr)) => self.eval_number(scope, expr, unit.dimension, Reads::FIXED),
            None => Ok(Expr::ZERO),
        };
        if kind == StateKind::Discrete {
            let start = start.ok()?;
            return Some(State { name, symbol, rate: Expr::ZERO, start, locked: true, unit });
        }
        let Some(rate) = rate else {
            let text = &ast.name.ident.text;
            let message = format!("the state `{}` has no rate", name.text);
            self.error(scope, Code::StateRate, name.span, message)
                .help(format!("write `rate {text} = …;`; one that only events change is `discrete`"));
            return None;
        };
        let dimension = unit.dimension.over(Dimension::TIME);
        let rate = self.eval_number(rate.scope, rate.value, dimension, Reads::ACTING);
        let (start, rate) = (start.ok()?, rate.ok()?);
        Some(State { name, symbol, rate, start, locked, unit })
    }
}
