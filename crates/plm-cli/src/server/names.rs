//! Names that a declaration declares: where, and what they are.

use std::collections::BTreeMap;
use std::ops::Range;

use plm_compiler::diag::Diagnostics;
use plm_compiler::span::Span;
use plm_compiler::syntax::ast::{Definition, Ident, Item, ItemKind, Port, all_items};
use plm_compiler::syntax::parse;
use plm_compiler::token::{Source, Sources};

use super::parts::{self, Part, code};
use crate::excerpt::Excerpt;
use crate::json::as_declared;
use crate::lexer::{Kind::Mark, Token, tokens};

/// Kind of a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Body,
    /// Of a body, or of the ground.
    Port,
    /// The use of a part, with the name of its definition.
    Instance(String),
    Node,
    /// A definition of a part, or of a domain.
    Definition,
    /// A parameter, an input, a state, a `let`: what has a value.
    Value,
    /// A row or a requirement.
    Row,
}

/// A name.
#[derive(Clone, Debug)]
pub(super) struct Name {
    pub(super) text: String,
    pub(super) kind: Kind,
    /// The body of a port, or `ground`.
    pub(super) owner: Option<String>,
    /// Range of its name.
    pub(super) place: Range<usize>,
    /// Range in which it can be read.
    pub(super) scope: Range<usize>,
    /// All of its item.
    pub(super) item: Range<usize>,
    /// As it is declared, in a line.
    pub(super) written: String,
    pub(super) docs: String,
}

/// The names of one declaration.
#[derive(Debug, Default)]
pub(super) struct Names {
    pub(super) all: Vec<Name>,
    /// Parts that it defines.
    pub(super) parts: BTreeMap<String, Part>,
    /// Names of its own `let`s without an index.
    pub(super) lets: Vec<String>,
}

impl Names {
    /// The names of a declaration, as far as it can be read.
    pub(super) fn new(name: &str, text: &str, excerpt: &Excerpt) -> Names {
        let mut sources = Sources::new();
        let id = match &excerpt.masked(text) {
            Some(masked) => sources.add_excerpt(name, text, masked),
            None => sources.add_text(name, text),
        };
        let Some(source) = sources.get(id) else { return Names::default() };
        let declaration = parse(source, &mut Diagnostics::new());
        let marks = tokens(text).into_iter().filter(|token| token.kind == Mark).collect();
        let mut reader = Reader { text, source, marks, names: Names::default() };
        for part in &declaration.shared.parts {
            reader.definition(part, &excerpt.range);
        }
        if let Some(mechanism) = &declaration.mechanism {
            for item in all_items(&mechanism.items) {
                reader.item(item, &excerpt.range);
            }
        }
        reader.names
    }

    /// The name that is meant at a place: of the innermost scope.
    pub(super) fn visible(&self, text: &str, at: usize) -> Option<&Name> {
        let names = self.all.iter().filter(|name| name.owner.is_none() && name.text == text);
        names.filter(|name| name.scope.contains(&at)).min_by_key(|name| name.scope.len())
    }

    /// Is a place within the definition of a part?
    pub(super) fn is_in_part(&self, at: usize) -> bool {
        self.all.iter().any(|name| name.kind == Kind::Definition && name.item.contains(&at))
    }

    /// A port by its owner.
    pub(super) fn port(&self, owner: &str, port: &str) -> Option<&Name> {
        self.all.iter().find(|name| name.owner.as_deref() == Some(owner) && name.text == port)
    }

    /// The definition of a part by its name: its own, or of the library.
    pub(super) fn part(&self, kind: &str) -> Option<Part> {
        self.parts.get(kind).cloned().or_else(|| parts::of_library(kind))
    }

    /// The use of a part within whose braces a place is.
    pub(super) fn instance_around(&self, at: usize) -> Option<&Name> {
        let uses = self.all.iter().filter(|name| matches!(name.kind, Kind::Instance(_)));
        uses.filter(|name| name.item.contains(&at)).min_by_key(|name| name.item.len())
    }
}

struct Reader<'a> {
    text: &'a str,
    source: &'a Source,
    /// The marks of the text.
    marks: Vec<Token>,
    names: Names,
}

impl Reader<'_> {
    fn range(&self, span: Span) -> Range<usize> {
        let range = self.source.range(span).unwrap_or_default();
        as_declared(self.source.file().unwrap_or_default(), self.text, range)
    }

    /// The end of the braces that open after a place; other brackets may be open while one types.
    fn end_of_braces(&self, at: usize) -> usize {
        let mut depth = 0_i32;
        for mark in self.marks.iter().filter(|mark| mark.range.start >= at) {
            depth += i32::from(mark.is_mark(self.text, '{')) - i32::from(mark.is_mark(self.text, '}'));
            if depth <= 0 && mark.is_mark(self.text, '}') {
                return mark.range.end;
            }
        }
        self.text.len()
    }

    fn add(&mut self, ident: &Ident, kind: Kind, item: &Item, scope: &Range<usize>) {
        let name = Name {
            text: ident.text.clone(),
            kind,
            owner: None,
            place: self.range(ident.span),
            scope: scope.clone(),
            item: self.range(item.span),
            written: code(self.source.text(item.span).unwrap_or_default()),
            docs: item.docs.join("\n"),
        };
        self.names.all.push(name);
    }

    fn ports(&mut self, ports: &[Port], owner: &str, scope: &Range<usize>) {
        for port in ports {
            let span =
                port.name.ident.span.to(port.depth.as_ref().or(port.angle.as_ref()).unwrap_or(&port.at).span);
            let name = Name {
                text: port.name.ident.text.clone(),
                kind: Kind::Port,
                owner: Some(owner.to_owned()),
                place: self.range(port.name.ident.span),
                scope: scope.clone(),
                item: self.range(span),
                written: format!("port {};", code(self.source.text(span).unwrap_or_default())),
                docs: String::new(),
            };
            self.names.all.push(name);
        }
    }

    fn definition(&mut self, part: &Definition, scope: &Range<usize>) {
        let place = self.range(part.name.span);
        let inside = place.start..self.end_of_braces(place.end);
        let made = Part::new(part, self.source);
        let name = Name {
            text: part.name.text.clone(),
            kind: Kind::Definition,
            owner: None,
            place,
            scope: scope.clone(),
            item: inside.clone(),
            written: made.head.clone(),
            docs: made.docs.clone(),
        };
        self.names.all.push(name);
        self.names.parts.insert(part.name.text.clone(), made);
        for argument in &part.arguments {
            let name = Name {
                text: argument.name.text.clone(),
                kind: if argument.kind.text == "body" { Kind::Body } else { Kind::Node },
                owner: None,
                place: self.range(argument.name.span),
                scope: inside.clone(),
                item: self.range(argument.name.span.to(argument.kind.span)),
                written: format!("{}: {}", argument.name.text, argument.kind.text),
                docs: String::new(),
            };
            self.names.all.push(name);
        }
        for item in all_items(&part.items) {
            self.item(item, &inside);
        }
    }

    fn item(&mut self, item: &Item, scope: &Range<usize>) {
        match &item.kind {
            ItemKind::Param(of) | ItemKind::Input(of) | ItemKind::State(of) | ItemKind::Discrete(of) => {
                self.add(&of.name.ident, Kind::Value, item, scope);
            }
            ItemKind::Let(name, _) => {
                self.add(&name.ident, Kind::Value, item, scope);
                if name.indices.is_empty() {
                    self.names.lets.push(name.ident.text.clone());
                }
            }
            ItemKind::Choice(of) => self.add(&of.name, Kind::Value, item, scope),
            ItemKind::Function(of) => self.add(&of.name, Kind::Value, item, scope),
            ItemKind::Points(of) => self.add(&of.name, Kind::Value, item, scope),
            ItemKind::Node(of) => self.add(&of.name.ident, Kind::Node, item, scope),
            ItemKind::Body(of) => {
                self.add(&of.name.ident, Kind::Body, item, scope);
                self.ports(&of.ports, &of.name.ident.text, scope);
            }
            ItemKind::Ground(ports) => self.ports(ports, "ground", scope),
            ItemKind::Instance(of) => {
                self.add(&of.name.ident, Kind::Instance(of.kind.text.clone()), item, scope);
            }
            ItemKind::Constraint(name, ..) | ItemKind::Require(name, _) => {
                self.add(&name.ident, Kind::Row, item, scope);
            }
            ItemKind::Unilateral(of) => self.add(&of.name.ident, Kind::Row, item, scope),
            ItemKind::Friction(of) => self.add(&of.name.ident, Kind::Row, item, scope),
            ItemKind::Output(outputs) => {
                for name in outputs.iter().filter_map(|output| output.name.as_ref()) {
                    self.add(&name.ident, Kind::Value, item, scope);
                }
            }
            ItemKind::Definition(part) => self.definition(part, scope),
            _ => {}
        }
    }
}
