//! From the tree to the model: names bound, units checked, parts taken apart.
//!
//! Three steps. `declare` walks the items in order, unrolls repetitions, opens parts, and binds every name to a value
//! or to an expression that waits. Then everything that the model needs is evaluated; an expression that waits is
//! worked out at its first use. So the order of declaration does not matter, a part may read the outputs of another,
//! and only a true circle is an error. Last, rates of states and sums at nodes take the places of the symbols that stood for
//! them (`late`).

mod body;
mod branch;
mod compliance;
mod condition;
mod declare;
mod expect;
mod expr;
mod field;
mod finish;
mod frame;
mod function;
mod instance;
mod late;
mod member;
mod node;
mod observe;
mod output;
mod picture;
mod rate;
mod require;
mod row;
mod scope;
mod shape;
mod silence;
mod table;
mod unknown;
mod value;

use std::collections::{BTreeMap, BTreeSet};

use plm_cas::Expr;

use crate::diag::{Code, Diagnostic, Diagnostics, Use};
use crate::library::Library;
use crate::model::{self, Model};
use crate::span::Span;
use crate::syntax::ast::{self, Mechanism};
use crate::token::Files;
use crate::units::DisplayUnit;
use body::BodyState;
use frame::PortState;
use instance::InstanceState;
use node::NodeState;
pub(crate) use observe::{OF_CENTRE, OF_PORT};
use picture::SizeItem;
use require::{Requirement, Switched};
use row::{Action, LoadItem, RowState};
use scope::{Scope, ScopeId, Slot, SlotId};
use silence::Readable;
use value::Value;

/// Binds the names of a mechanism. `None` if it has errors; they are in the sink.
pub(crate) fn resolve(
    declaration: &ast::Declaration,
    mechanism: &Mechanism,
    (library, files): (&Library, &Files),
    observes: bool,
    sink: &mut Diagnostics,
) -> Option<Model> {
    let mut resolver = Resolver::new(library, files, sink);
    let top = resolver.new_scope(None, None);
    resolver.begin(mechanism, top);
    resolver.evaluate();
    if !observes {
        resolver.observed.clear();
    }
    resolver.finish(declaration, mechanism)
}

/// Everything that is known so far.
struct Resolver<'a> {
    sink: &'a mut Diagnostics,
    library: &'a Library,
    /// Files that the declaration names.
    files: &'a Files,
    scopes: Vec<Scope<'a>>,
    slots: Vec<Slot<'a>>,
    /// Depth of evaluation.
    depth: u32,
    /// Turns of repetitions so far.
    turns: usize,
    /// Has it been said that there are too many parts?
    too_many: bool,

    time: Expr,
    most_growth: Expr,
    agreement: Expr,
    gravity: SlotId,
    gravity_is_declared: bool,
    stabilisation: Option<(&'a ast::Ident, Option<&'a ast::Expr>)>,
    rung: Option<&'a ast::Ident>,
    allowed: Vec<String>,
    params: Vec<ValueState<'a>>,
    inputs: Vec<ValueState<'a>>,
    states: Vec<StateState<'a>>,
    /// Index of the state of each symbol.
    state_of: BTreeMap<Expr, usize>,
    /// Symbols of the inputs of the mechanism.
    input_symbols: Vec<Expr>,
    ground: Vec<PortState<'a>>,
    domains: Vec<&'a ast::Domain>,
    nodes: Vec<NodeState<'a>>,
    bodies: Vec<BodyState<'a>>,
    instances: Vec<InstanceState<'a>>,
    parts: Vec<model::Part>,
    rows: Vec<RowState<'a>>,
    requirements: Vec<Requirement<'a>>,
    /// Requirements that uses of parts switch on or off.
    switched: Vec<Switched>,
    /// Values that must be positive when parameters are known.
    limits: Vec<model::Limit>,
    loads: Vec<LoadItem<'a>>,
    /// Rates, until all states are declared.
    late_rates: Vec<(ScopeId, &'a ast::IndexedName, &'a ast::Expr)>,
    /// With the documentation of their items.
    outputs: Vec<(ScopeId, &'a ast::Output, &'a [String])>,
    observed: Vec<(ScopeId, &'a ast::Expr)>,
    /// What parts apply to bodies and to the ground, for who observes them.
    applied: Vec<Action>,
    /// Sizes of parts for pictures.
    sizes: Vec<SizeItem>,
    /// What is chosen, and between what.
    choices: Vec<(&'a str, Vec<&'a str>)>,
    /// Slots to evaluate even if nothing reads them: their mistakes count.
    checks: Vec<SlotId>,
    /// Params, inputs and `let`s of the user's own, with their names.
    readable: Vec<(String, Readable)>,
    /// Definitions whose outputs are checked already.
    checked: BTreeSet<&'a str>,

    /// Symbols and their total derivatives with respect to time.
    directions: BTreeMap<Expr, Expr>,
    /// Total derivatives worked out so far.
    rates: BTreeMap<Expr, Expr>,
}

/// A `param` or an `input` of the mechanism.
struct ValueState<'a> {
    ast: &'a ast::Value,
    docs: &'a [String],
    scope: ScopeId,
    name: model::Name,
    symbol: Expr,
    unit: DisplayUnit,
}

/// A state.
struct StateState<'a> {
    ast: &'a ast::Value,
    scope: ScopeId,
    name: model::Name,
    symbol: Expr,
    unit: DisplayUnit,
    /// Where it starts: as the use of its part says, else as it is declared.
    start: Option<(ScopeId, &'a ast::Expr)>,
    locked: bool,
    /// Its rate: where it is used before it is known.
    stand_in: Expr,
    rate: Option<(ScopeId, &'a ast::Expr, Span)>,
}

impl<'a> Resolver<'a> {
    fn new(library: &'a Library, files: &'a Files, sink: &'a mut Diagnostics) -> Resolver<'a> {
        let time = Expr::symbol("t");
        let most_growth = Expr::symbol("most_growth");
        let agreement = Expr::symbol("agreement");
        let directions = BTreeMap::from([(time, Expr::ONE)]);
        Resolver {
            sink,
            library,
            files,
            scopes: Vec::new(),
            slots: Vec::new(),
            depth: 0,
            turns: 0,
            too_many: false,
            time,
            most_growth,
            agreement,
            gravity: 0,
            gravity_is_declared: false,
            stabilisation: None,
            rung: None,
            allowed: Vec::new(),
            params: Vec::new(),
            inputs: Vec::new(),
            states: Vec::new(),
            state_of: BTreeMap::new(),
            input_symbols: Vec::new(),
            ground: Vec::new(),
            domains: Vec::new(),
            nodes: Vec::new(),
            bodies: Vec::new(),
            instances: Vec::new(),
            parts: Vec::new(),
            rows: Vec::new(),
            requirements: Vec::new(),
            switched: Vec::new(),
            limits: Vec::new(),
            loads: Vec::new(),
            late_rates: Vec::new(),
            outputs: Vec::new(),
            observed: Vec::new(),
            applied: Vec::new(),
            sizes: Vec::new(),
            choices: Vec::new(),
            checks: Vec::new(),
            readable: Vec::new(),
            checked: BTreeSet::new(),
            directions,
            rates: BTreeMap::new(),
        }
    }

    /// Binds what every mechanism has, then what this one declares.
    fn begin(&mut self, mechanism: &'a Mechanism, top: ScopeId) {
        let ground = self.known_slot(mechanism.name.span, Value::Body(None));
        self.scopes[top].names.insert("ground".into(), ground);
        self.gravity = self.default_gravity(mechanism);
        self.declare(&mechanism.items, top, None);
    }

    /// Evaluates all that the model needs, in the order of declaration.
    fn evaluate(&mut self) {
        for slot in std::mem::take(&mut self.checks) {
            let span = self.slots[slot].span;
            let _ = self.force(slot, 0, span);
        }
        for body in 0..self.bodies.len() {
            self.check_body(body);
        }
        for instance in 0..self.instances.len() {
            self.connect(instance);
        }
        for row in 0..self.rows.len() {
            let _ = self.row(row);
        }
    }

    /// Reports an error in a scope: if it is the inside of a part, with the uses that lead there.
    fn error(
        &mut self,
        scope: ScopeId,
        code: Code,
        span: Span,
        message: impl Into<String>,
    ) -> &mut Diagnostic {
        let uses = self.uses(scope);
        let diagnostic = self.sink.error(code, span, message);
        diagnostic.uses = uses;
        diagnostic
    }

    /// The uses that lead to a scope, from the declaration inwards.
    fn uses(&self, scope: ScopeId) -> Vec<Use> {
        let mut uses = Vec::new();
        let mut scope = self.home(scope);
        while let Some(instance) = self.scopes[scope].instance {
            let instance = &self.instances[instance];
            let part = instance.definition.name.text.clone();
            uses.push(Use { span: instance.span, instance: instance.name.clone(), part });
            scope = self.home(instance.outer);
        }
        uses.reverse();
        uses
    }

    /// The path of the part that a scope is inside of, as a prefix of names: empty at the top, else `arm.spring.`.
    fn prefix(&self, scope: ScopeId) -> String {
        match self.scopes[self.home(scope)].instance {
            Some(instance) => format!("{}.", self.instances[instance].name),
            None => String::new(),
        }
    }
}
