//! Warnings of declarations that are right and yet hardly meant: gravity upwards, parts that do nothing, names that nothing reads.

use crate::collect::CollectVec;
use crate::sorted::SortedMap;

use plm_cas::algebra::Vec2;

use crate::diag::Code;
use crate::resolve::Resolver;
use crate::resolve::names::SlotId;
use crate::resolve::values::Value;
use crate::resolve::values::expect::literal_text;
use crate::span::Span;
use crate::syntax::ast::{self, ExprKind, ItemKind, Mechanism};

/// A name that should be read.
#[derive(Clone, Copy)]
pub(crate) struct Readable {
    what: &'static str,
    slot: SlotId,
}

impl<'a> Resolver<'a> {
    /// Notes a param, an input or a `let` of the user's own. One whose name begins with `_` says that it is for nobody.
    pub(crate) fn should_be_read(&mut self, what: &'static str, name: &ast::Ident, slot: SlotId) {
        if name.span.source == 0 && !name.text.starts_with('_') {
            self.names.readable.push((name.text.clone(), Readable { what, slot }));
        }
    }

    /// Warns of what is silent, when all has been evaluated. After errors much has not been.
    pub(crate) fn warn(&mut self, declaration: &ast::Declaration, mechanism: &'a Mechanism) {
        if self.sink.has_errors() {
            return;
        }
        self.warn_of_gravity(mechanism);
        self.warn_of_idle_parts();
        self.warn_of_unread_names(&declaration.carried);
        self.sink.allow(&self.unresolved.settings.allowed);
    }

    fn warn_of_gravity(&mut self, mechanism: &'a Mechanism) {
        let declared = mechanism.items.iter().find_map(|item| match &item.kind {
            ItemKind::Gravity(value) => Some(value),
            _ => None,
        });
        let (Some(declared), Ok(Vec2 { x, y })) = (declared, self.evaluate_gravity()) else { return };
        let down = -y;
        let is_upwards = down.as_number().is_some_and(plm_cas::Number::is_negative);
        if !is_upwards || !x.is_zero() {
            return;
        }
        let message = match self.gravity(0, declared.span) {
            Ok(Value::Vector(..)) => "this gravity points along y, so that it pulls upwards",
            _ => "gravity acts along -y, so that a negative one pulls upwards",
        };
        let help =
            downwards(declared).map_or("turn its sign".to_string(), |value| format!("write `{value}`"));
        self.sink.warning(Code::Upwards, declared.span, message).help(help);
    }

    /// A part of forces and torques alone, all of which are zero whatever happens.
    fn warn_of_idle_parts(&mut self) {
        let mut acts: SortedMap<usize, bool> = SortedMap::new();
        for action in &self.unresolved.applied {
            if let Some(instance) = self.names.around(action.scope).last() {
                let acts = acts.or_insert(instance, false);
                *acts |= !action.force.is_zero() || !action.torque.is_zero();
            }
        }
        // What ties or remembers something is not idle.
        let others = self
            .unresolved
            .rows
            .iter()
            .map(|row| row.scope)
            .chain(self.unresolved.states.iter().map(|state| state.scope));
        let contacts = self.unresolved.contacts.iter().map(|contact| contact.scope);
        let nodes = self.unresolved.nodes.iter().map(|node| node.scope);
        for scope in others.chain(contacts).chain(nodes).chain(self.unresolved.on_nodes.iter().copied()) {
            if let Some(instance) = self.names.around(scope).last() {
                acts.insert(instance, true);
            }
        }
        for (instance, _) in acts.into_iter().filter(|(_, acts)| !acts) {
            let state = &self.names.instances[instance];
            let params: Vec<&str> = state.definition.items.iter().filter_map(settable).collect_vec();
            let message = format!("`{}` does nothing: all that it applies is zero", state.name);
            let diagnostic = self.sink.warning(Code::Idle, state.span, message);
            if !params.is_empty() {
                diagnostic.help(format!("set what it needs: {}", params.join(", ")));
            }
        }
    }

    /// In a part that is used several times, and in a repetition, one reader is enough. Parts that were carried here are not
    /// for who uses them to mend.
    fn warn_of_unread_names(&mut self, carried: &[Span]) {
        let mut read: SortedMap<Span, (String, &'static str, bool)> = SortedMap::new();
        for (name, Readable { what, slot }) in std::mem::take(&mut self.names.readable) {
            let slot = &self.names.slots[slot];
            read.or_insert(slot.span, (name, what, false)).2 |= slot.is_read;
        }
        let is_carried = |span: Span| carried.iter().any(|of| (of.first..=of.last).contains(&span.first));
        for (span, (name, what, _)) in read.into_iter().filter(|(_, (.., is_read))| !is_read) {
            if is_carried(span) {
                continue;
            }
            self.sink
                .warning(Code::Unread, span, format!("nothing reads the {what} `{name}`"))
                .help(format!("leave it out, or call it `_{name}`"));
        }
    }
}

/// A literal gravity that points upwards, turned.
fn downwards(declared: &ast::Expr) -> Option<String> {
    match &declared.kind {
        ExprKind::Neg(inner) => literal_text(inner),
        ExprKind::Quantity(inner, unit) => match &inner.kind {
            ExprKind::Pair(x, y) => {
                Some(format!("({}, -{}) {}", literal_text(x)?, literal_text(y)?, unit.text))
            }
            _ => None,
        },
        _ => None,
    }
}

/// The name of what the use of a part can set.
fn settable(item: &ast::Item) -> Option<&str> {
    match &item.kind {
        ItemKind::Param(value) | ItemKind::Input(value) => Some(&value.name.ident.text),
        _ => None,
    }
}
