//! Number or vector? Told from the form of an expression, since after errors nothing may have a value.

use std::cell::Cell;

use crate::library::Library;
use crate::resolve::{CallShape, Function, Member};
use crate::sorted::SortedMap;
use crate::syntax::ast::{Expr, ExprKind, IndexedName, Instance, Item, ItemKind, Operator, all_items};

/// Definitions that are followed for one answer, in all and one inside the other: they may form circles.
const MAX_STEPS: u32 = 1000;
const MAX_DEPTH: u32 = 8;

/// The names that an expression can read.
pub(super) struct Shapes<'a> {
    library: &'a Library,
    items: &'a [Item],
    /// Of the mechanism; those of parts are looked for.
    named: Named<'a>,
    steps: Cell<u32>,
    depth: Cell<u32>,
}

impl<'a> Shapes<'a> {
    pub(super) fn new(library: &'a Library, items: &'a [Item]) -> Shapes<'a> {
        Shapes { library, items, named: Named::of(items), steps: Cell::new(0), depth: Cell::new(0) }
    }

    /// The declaration of a name among items.
    fn declared(&self, items: &'a [Item], name: &str) -> (Option<&'a Expr>, Option<&'a Instance>) {
        if std::ptr::eq(items, self.items) { self.named.get(name) } else { Named::of(items).get(name) }
    }

    /// Is it a vector? What cannot be told is a number.
    pub(super) fn is_vector(&self, expr: &Expr) -> bool {
        self.steps.set(0);
        self.of(self.items, expr)
    }

    /// Is it one inside a definition?
    pub(super) fn is_vector_in(&self, items: &'a [Item], expr: &Expr) -> bool {
        self.steps.set(0);
        self.of(items, expr)
    }

    fn of(&self, items: &'a [Item], expr: &Expr) -> bool {
        match &expr.kind {
            ExprKind::Pair(..) => true,
            ExprKind::Quantity(value, _) | ExprKind::Neg(value) | ExprKind::If(_, value, _) => {
                self.of(items, value)
            }
            ExprKind::Chain(first, links) => {
                let compares =
                    links.iter().any(|link| link.operator.precedence() < Operator::Add.precedence());
                !compares && (self.of(items, first) || links.iter().any(|link| self.of(items, &link.operand)))
            }
            ExprKind::Call(function, arguments) => match Function::named(&function.text).map(Function::shape)
            {
                Some(CallShape::Vector) => true,
                Some(CallShape::OfCount) => arguments.len() == 2,
                Some(CallShape::OfArgument) => {
                    arguments.first().is_some_and(|argument| self.of(items, argument))
                }
                Some(CallShape::Number) | None => false,
            },
            ExprKind::Name(name) if name.ident.text == "gravity" => {
                let mut declared = self.items.iter().filter_map(|item| match &item.kind {
                    ItemKind::Gravity(value) => Some(value),
                    _ => None,
                });
                declared.next().is_some_and(|value| self.follow(self.items, value))
            }
            ExprKind::Name(name) => {
                let (value, _) = self.declared(items, &name.ident.text);
                value.is_some_and(|value| self.follow(items, value))
            }
            ExprKind::Path(base, members) => self.path(items, base, members),
            ExprKind::Unknown | ExprKind::Number(_) | ExprKind::Not(_) | ExprKind::Power(..) => false,
        }
    }

    /// `joint.force`, `body.port.position`
    fn path(&self, items: &'a [Item], base: &Expr, members: &[IndexedName]) -> bool {
        let Some((first, rest)) = members.split_first() else { return false };
        let ExprKind::Name(base) = &base.kind else { return false };
        let (_, instance) = self.declared(items, &base.ident.text);
        let last = members.last().map_or("", |member| member.ident.text.as_str());
        let Some(definition) = instance.and_then(|instance| self.library.get(&instance.kind.text)) else {
            // Of a part that is not known, a force is taken for a vector.
            return Member::names_vector(last) || (instance.is_some() && last == "force");
        };
        let outputs = all_items(&definition.items).filter_map(|item| match &item.kind {
            ItemKind::Output(list) => Some(list),
            _ => None,
        });
        let output = outputs.flatten().find(|output| match (&output.name, &output.value.kind) {
            (Some(name), _) | (None, ExprKind::Name(name)) => name.ident.text == first.ident.text,
            _ => false,
        });
        rest.is_empty() && output.is_some_and(|output| self.follow(&definition.items, &output.value))
    }

    /// The shape of a definition that stands elsewhere.
    fn follow(&self, items: &'a [Item], expr: &Expr) -> bool {
        let (steps, depth) = (self.steps.get() + 1, self.depth.get() + 1);
        if steps > MAX_STEPS || depth > MAX_DEPTH {
            return false;
        }
        self.steps.set(steps);
        self.depth.set(depth);
        let found = self.of(items, expr);
        self.depth.set(depth - 1);
        found
    }
}

/// Of each name the first `let` and the first part in use.
struct Named<'a> {
    lets: SortedMap<&'a str, &'a Expr>,
    instances: SortedMap<&'a str, &'a Instance>,
}

impl<'a> Named<'a> {
    fn of(items: &'a [Item]) -> Named<'a> {
        let lets = all_items(items).filter_map(|item| match &item.kind {
            ItemKind::Let(name, value) => Some((name.ident.text.as_str(), value)),
            _ => None,
        });
        let instances = all_items(items).filter_map(|item| match &item.kind {
            ItemKind::Instance(instance) => Some((instance.name.ident.text.as_str(), instance)),
            _ => None,
        });
        Named { lets: first_of_each(lets), instances: first_of_each(instances) }
    }

    fn get(&self, name: &str) -> (Option<&'a Expr>, Option<&'a Instance>) {
        (self.lets.get(name).copied(), self.instances.get(name).copied())
    }
}

fn first_of_each<'a, V>(entries: impl Iterator<Item = (&'a str, V)>) -> SortedMap<&'a str, V> {
    let mut first = SortedMap::new();
    for (name, value) in entries {
        if !first.contains_key(name) {
            first.insert(name, value);
        }
    }
    first
}
