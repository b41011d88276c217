//! Names of what is observed, as `resolve` would find them.

use crate::collect::CollectVec;
use crate::sorted::sort_by_key;
use plm_cas::Expr;

use super::{Names, name, no_unit};
use crate::model::{Name, Output};
use crate::resolve::{Member, Owner};
use crate::span::Span;
use crate::syntax::ast::{self, Definition, ExprKind, ItemKind};

/// An item that can be observed.
#[derive(Clone, Copy)]
pub(super) enum Observable<'a> {
    Body(&'a ast::Body),
    /// A port of a body or of the ground.
    Port,
    Part(&'a Definition),
    Node(&'a ast::Node),
}

impl Observable<'_> {
    /// Rank in the order of `observe all`: bodies with their ports, ports by themselves, nodes, parts.
    fn place(self) -> usize {
        match self {
            Observable::Body(_) => 0,
            Observable::Port => 1,
            Observable::Node(_) => 2,
            Observable::Part(_) => 3,
        }
    }
}

impl<'a> Names<'a> {
    /// Adds the outputs of all that is observed.
    pub(super) fn show_observed(&mut self) {
        let mut observables = std::mem::take(&mut self.observables);
        sort_by_key(&mut observables, |(_, observable)| observable.place());
        for Name { text, span } in std::mem::take(&mut self.observed) {
            for (name, observable) in &observables {
                let is_of_ground = text == "ground" && name.starts_with("ground.");
                if text == "all" || text == *name || is_of_ground {
                    self.show(name, *observable, span);
                }
            }
        }
    }

    fn show(&mut self, of: &str, observable: Observable<'a>, span: Span) {
        match observable {
            Observable::Body(body) => {
                self.show_members(of, Owner::Body, span);
                for port in &body.ports {
                    self.show_members(&format!("{of}.{}", port.name.ident.text), Owner::Frame, span);
                }
            }
            Observable::Port => self.show_members(of, Owner::Frame, span),
            Observable::Node(node) => self.show_node(of, node, span),
            Observable::Part(definition) => self.show_part(of, definition, span),
        }
    }

    fn show_members(&mut self, of: &str, owner: Owner, span: Span) {
        for member in Member::observed(owner) {
            self.push(format!("{of}.{}", member.name), member.is_vector(), span);
        }
    }

    fn show_node(&mut self, of: &str, node: &'a ast::Node, span: Span) {
        let Some(domain) = self.library.domain(&node.kind.text) else { return };
        let quantities = std::iter::once(&domain.across).chain(&domain.through);
        let members: Vec<&str> = quantities.map(|quantity| quantity.name.text.as_str()).collect_vec();
        for member in members {
            self.push(format!("{of}.{member}"), false, span);
        }
    }

    fn show_part(&mut self, of: &str, definition: &'a Definition, span: Span) {
        for item in &definition.items {
            let ItemKind::Output(list) = &item.kind else { continue };
            for output in list {
                let ((Some(key), _) | (None, ExprKind::Name(key))) = (&output.name, &output.value.kind)
                else {
                    continue;
                };
                let is_vector = self.shapes.is_vector_in(&definition.items, &output.value);
                self.push(format!("{of}.{}", key.ident.text), is_vector, span);
            }
        }
        for argument in definition.arguments.iter().filter(|argument| argument.kind.text == "frame") {
            self.push(format!("{of}.force_on_{}", argument.name.text), true, span);
            self.push(format!("{of}.torque_on_{}", argument.name.text), false, span);
        }
    }

    fn push(&mut self, text: String, is_vector: bool, span: Span) {
        if self.found.outputs.iter().any(|output| output.name.text == text) {
            return;
        }
        let components = vec![Expr::ZERO; if is_vector { 2 } else { 1 }];
        let (name, unit) = (name(text, span), no_unit());
        self.found.outputs.push(Output { name, components, unit, declared: false, docs: String::new() });
    }
}
