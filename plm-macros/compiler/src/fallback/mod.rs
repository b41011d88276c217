//! Placeholder for a declaration with errors: a mechanism with all names that could be read and nothing after them.
//!
//! It goes the way of every model through derivation and emission, so that code which uses the mechanism sees the very
//! types that it would see without the errors, and adds none of its own. Its bodies float, its outputs are zero.

mod given;
mod observe;
mod shape;

use crate::collect::{CollectVec, MapEach};
use crate::sorted::SortedSet;
use plm_cas::algebra::Vec2;
use plm_cas::{Expr, Graph};
use std::fmt::Write;

use crate::front::Reading;
use crate::library::Library;
use crate::model::{
    Body, Decisions, Impacts, Input, Model, Name, Output, Param, Stabilisation, Start, State, Step,
};
use crate::span::Span;
use crate::syntax::ast::{self, ExprKind, IndexedName, Item, ItemKind, Operator};
use crate::units::{Dimension, DisplayUnit};
use observe::Observable;
use shape::Shapes;

/// Parts within parts that are looked into.
const MAX_DEPTH: usize = 16;
/// Items that are looked at, those of repetitions counted by turns.
const MAX_ITEMS: usize = 1 << 12;

/// The names of a declaration as a mechanism; `None` if it has none itself.
pub(crate) fn model(reading: &Reading) -> Option<Model> {
    let Reading { declaration, library, .. } = reading;
    let mechanism = declaration.mechanism.as_ref()?;
    let shapes = Shapes::new(library, &mechanism.items);
    let mut names = Names {
        library,
        shapes,
        indices: Vec::new(),
        uses: Vec::new(),
        items: 0,
        found: Found::default(),
        observables: Vec::new(),
        observed: Vec::new(),
    };
    names.walk(&mechanism.items, "", 0);
    names.show_observed();
    let Found { params, inputs, mut bodies, states, outputs, .. } = names.found;
    if bodies.is_empty() {
        // No array of the emitted code is empty that must not be.
        bodies.push(body(name("unread".to_owned(), mechanism.name.span)));
    }
    Some(Model {
        name: name(mechanism.name.text.clone(), mechanism.name.span),
        visibility: mechanism.visibility.clone(),
        docs: mechanism.docs.clone(),
        text: String::new(),
        crate_path: declaration.crate_path.clone().unwrap_or_else(|| "::plm".to_owned()),
        graph: Graph::new(),
        time: Expr::symbol("t"),
        most_growth: Expr::symbol("most_growth"),
        agreement: Expr::symbol("agreement"),
        precision: Expr::symbol("precision"),
        gravity: Vec2::ZERO,
        formulation: None,
        repetitions: None,
        steps: steps(&mechanism.items),
        stabilisation: Stabilisation::Projection,
        params,
        inputs,
        bodies,
        ground: Vec::new(),
        parts: Vec::new(),
        rows: Vec::new(),
        compliant: Vec::new(),
        contacts: Vec::new(),
        impacts: Impacts::default(),
        limits: Vec::new(),
        jumps: Vec::new(),
        released: Vec::new(),
        loads: Vec::new(),
        states,
        outputs,
        instances: Vec::new(),
        files: Vec::new(),
        whens: Vec::new(),
        switches: Vec::new(),
        comparisons: Vec::new(),
        decisions: Decisions::default(),
        kinks: Vec::new(),
        turns: Vec::new(),
        allowed: Vec::new(),
    })
}

/// The steps that are ordered, as far as they can be read.
fn steps(items: &[Item]) -> SortedSet<Step> {
    let methods = items.iter().filter_map(|item| match &item.kind {
        ItemKind::Emit(methods) => Some(methods),
        _ => None,
    });
    methods.flatten().filter_map(|method| Step::named(&method.text)).collect()
}

/// Names that were found so far.
#[derive(Default)]
struct Found {
    params: Vec<Param>,
    inputs: Vec<Input>,
    bodies: Vec<Body>,
    states: Vec<State>,
    outputs: Vec<Output>,
    symbols: usize,
}

/// Collects the names that the emitted types have.
struct Names<'a> {
    library: &'a Library,
    shapes: Shapes<'a>,
    /// Indices of the repetitions around an item, and their values.
    indices: Vec<(&'a str, i64)>,
    /// Parts in use around an item, with their names, from the outside inwards.
    uses: Vec<(String, &'a ast::Instance, &'a ast::Definition)>,
    items: usize,
    found: Found,
    /// Items that can be observed.
    observables: Vec<(String, Observable<'a>)>,
    /// Names of the observed ones.
    observed: Vec<Name>,
}

impl<'a> Names<'a> {
    /// Items of the mechanism (no prefix), or of a part: `arm.spring.`.
    fn walk(&mut self, items: &'a [Item], prefix: &str, depth: usize) {
        for item in items {
            self.items += 1;
            if self.items > MAX_ITEMS {
                return;
            }
            match &item.kind {
                ItemKind::Body(of) => {
                    if let Some(name) = self.name(prefix, &of.name) {
                        let ports = of.ports.iter().filter_map(|port| self.key(&port.name));
                        let ports = ports
                            .map(|port| (format!("{}.{port}", name.text), Observable::Port))
                            .collect_vec();
                        self.observables.extend(ports);
                        self.observables.push((name.text.clone(), Observable::Body(of)));
                        self.found.bodies.push(body(name));
                    }
                }
                ItemKind::State(value) | ItemKind::Discrete(value) => self.state(prefix, value),
                ItemKind::Repeat(repeat) => self.repeat(repeat, prefix, depth),
                ItemKind::Given(given) => {
                    let holds = self.is_given(&given.condition);
                    self.walk(if holds { &given.items } else { &given.otherwise }, prefix, depth);
                }
                ItemKind::Instance(instance) => self.instance(instance, prefix, depth),
                ItemKind::Param(value) if depth == 0 => self.param(item, value),
                ItemKind::Input(value) if depth == 0 => self.input(item, value),
                ItemKind::Output(list) if depth == 0 => list.iter().for_each(|output| self.output(output)),
                ItemKind::Observe(list) => {
                    let names: Vec<Name> = list.iter().filter_map(|of| self.path(of)).collect_vec();
                    self.observed.extend(names);
                }
                ItemKind::Node(node) => {
                    if let Some(name) = self.name(prefix, &node.name) {
                        self.observables.push((name.text, Observable::Node(node)));
                    }
                }
                ItemKind::Ground(ports) => {
                    let names = ports.iter().filter_map(|port| self.name(prefix, &port.name));
                    let ports: Vec<_> =
                        names.map(|name| (format!("ground.{}", name.text), Observable::Port)).collect_vec();
                    self.observables.extend(ports);
                }
                _ => {}
            }
        }
    }

    fn repeat(&mut self, repeat: &'a ast::Repeat, prefix: &str, depth: usize) {
        let (Some(from), Some(to)) = (self.int(&repeat.turns.from), self.int(&repeat.turns.to)) else {
            return;
        };
        let to = if repeat.turns.inclusive { to.saturating_add(1) } else { to };
        for value in from..to {
            if self.items > MAX_ITEMS {
                return;
            }
            self.items += 1;
            self.indices.push((&repeat.turns.index.text, value));
            self.walk(&repeat.items, prefix, depth);
            self.indices.pop();
        }
    }

    fn instance(&mut self, instance: &'a ast::Instance, prefix: &str, depth: usize) {
        let (Some(name), Some(definition)) =
            (self.key(&instance.name), self.library.get(&instance.kind.text))
        else {
            return;
        };
        self.observables.push((format!("{prefix}{name}"), Observable::Part(definition)));
        if depth < MAX_DEPTH {
            let outside = std::mem::take(&mut self.indices);
            let inside = format!("{prefix}{name}.");
            self.uses.push((name, instance, definition));
            self.walk(&definition.items, &inside, depth + 1);
            self.uses.pop();
            self.indices = outside;
        }
    }

    fn param(&mut self, item: &Item, value: &'a ast::Value) {
        let Some(name) = self.name("", &value.name) else { return };
        let (symbol, default) = (self.symbol(), Expr::ZERO);
        let (unit, docs) = (value.unit.clone().unwrap_or_else(no_unit), item.docs.clone());
        let required = value.value.is_none();
        self.found.params.push(Param { name, symbol, default, required, unit, docs });
    }

    fn input(&mut self, item: &Item, value: &'a ast::Value) {
        let Some(name) = self.name("", &value.name) else { return };
        let (symbol, default) = (self.symbol(), Expr::ZERO);
        let (unit, docs) = (value.unit.clone().unwrap_or_else(no_unit), item.docs.clone());
        self.found.inputs.push(Input { name, symbol, default, unit, docs });
    }

    fn state(&mut self, prefix: &str, value: &'a ast::Value) {
        let Some(name) = self.name(prefix, &value.name) else { return };
        let (symbol, zero) = (self.symbol(), Expr::ZERO);
        let unit = value.unit.clone().unwrap_or_else(no_unit);
        self.found.states.push(State { name, symbol, rate: zero, start: zero, locked: false, unit });
    }

    fn output(&mut self, output: &'a ast::Output) {
        let Some(name) = self.output_name(output) else { return };
        let count = if self.shapes.is_vector(&output.value) { 2 } else { 1 };
        let components = vec![Expr::ZERO; count];
        let unit = output.unit.as_ref().map_or_else(no_unit, |(unit, _)| unit.clone());
        self.found.outputs.push(Output { name, components, unit, declared: true, docs: String::new() });
    }

    /// The name as written, or the path of what is shown.
    fn output_name(&self, output: &'a ast::Output) -> Option<Name> {
        if let Some(written) = &output.name {
            return self.name("", written);
        }
        self.path(&output.value)
    }

    /// `arm.p12` as text.
    fn path(&self, expr: &'a ast::Expr) -> Option<Name> {
        let text = match &expr.kind {
            ExprKind::Name(path) => self.key(path)?,
            ExprKind::Path(base, members) => {
                let ExprKind::Name(base) = &base.kind else { return None };
                let mut text = self.key(base)?;
                for member in members {
                    text.push('.');
                    text.push_str(&self.key(member)?);
                }
                text
            }
            _ => return None,
        };
        Some(name(text, expr.span))
    }

    fn name(&self, prefix: &str, written: &IndexedName) -> Option<Name> {
        Some(name(format!("{prefix}{}", self.key(written)?), written.ident.span))
    }

    /// `bar[3]`; `None` if an index has no value.
    fn key(&self, written: &IndexedName) -> Option<String> {
        let mut key = written.ident.text.clone();
        for index in &written.indices {
            let _ = write!(key, "[{}]", self.int(index)?);
        }
        Some(key)
    }

    /// The value of a whole number: literals, indices of repetitions, and what `+ - *` make of them.
    fn int(&self, expr: &ast::Expr) -> Option<i64> {
        match &expr.kind {
            ExprKind::Number(number) => number.as_int(),
            ExprKind::Name(name) if name.indices.is_empty() => self
                .indices
                .iter()
                .rev()
                .find(|(index, _)| *index == name.ident.text)
                .map(|(_, value)| *value),
            ExprKind::Neg(inner) => self.int(inner)?.checked_neg(),
            ExprKind::Chain(first, links) => links.iter().try_fold(self.int(first)?, |left, link| {
                let right = self.int(&link.operand)?;
                match link.operator {
                    Operator::Add => left.checked_add(right),
                    Operator::Sub => left.checked_sub(right),
                    Operator::Mul => left.checked_mul(right),
                    _ => None,
                }
            }),
            _ => None,
        }
    }

    /// A symbol of its own, whatever else is called the same.
    fn symbol(&mut self) -> Expr {
        self.found.symbols += 1;
        Expr::symbol(format!("value_{}", self.found.symbols))
    }
}

fn name(text: String, span: Span) -> Name {
    Name { text, span }
}

fn no_unit() -> DisplayUnit {
    DisplayUnit::si(Dimension::NUMBER)
}

/// A body of 1 kg that floats.
fn body(name: Name) -> Body {
    let symbols =
        |members: [&str; 3]| members.map_each(|member| Expr::symbol(format!("{}.{member}", name.text)));
    let (q, v, a) =
        (symbols(["x", "y", "angle"]), symbols(["vx", "vy", "omega"]), symbols(["ax", "ay", "alpha"]));
    let (zero, one, span) = (Expr::ZERO, Expr::ONE, name.span);
    let start = Start { value: zero, locked: false, given: false, span };
    Body {
        mass: one,
        mass_span: span,
        inertia: one,
        inertia_span: span,
        has_mass: true,
        q,
        v,
        a,
        centre: Vec2::ZERO,
        ports: Vec::new(),
        contour: Vec::new(),
        width: None,
        holes: Vec::new(),
        depth: None,
        start: [start; 3],
        start_velocity: [start; 3],
        name,
    }
}
