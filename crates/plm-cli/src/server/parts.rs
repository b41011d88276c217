//! Parts by their definitions: what a use of one can set and read.

use plm_compiler::diag::Diagnostics;
use plm_compiler::syntax::ast::{Definition, ExprKind, Item, ItemKind, all_items};
use plm_compiler::syntax::parse_parts;
use plm_compiler::token::{Source, Sources};
use plm_compiler::words;

/// A definition of a part.
#[derive(Clone, Debug)]
pub(super) struct Part {
    /// `joint revolute(a: frame, b: frame)`
    pub(super) head: String,
    pub(super) docs: String,
    pub(super) members: Vec<Member>,
}

/// Kind of a member of a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// A parameter, an input, a state, a choice, a function or points: a use sets it.
    Set,
    /// An output or a node: a use reads it.
    Read,
    /// A part inside.
    Part,
}

/// A name that a use of a part can set or read.
#[derive(Clone, Debug)]
pub(super) struct Member {
    pub(super) name: String,
    pub(super) role: Role,
    /// As it is declared.
    pub(super) written: String,
    pub(super) docs: String,
    /// Of a part inside: the name of its definition.
    pub(super) kind: Option<String>,
}

/// A part or a domain of the library by its name.
pub(super) fn of_library(name: &str) -> Option<Part> {
    let (_, text) = words::parts().iter().find(|(known, _)| *known == name)?;
    let mut sources = Sources::new();
    let id = sources.add_text(name, text);
    let source = sources.get(id)?;
    let shared = parse_parts(source, &mut Diagnostics::new());
    shared.parts.iter().find(|part| part.name.text == name).map(|part| Part::new(part, source))
}

impl Part {
    pub(super) fn new(definition: &Definition, source: &Source) -> Part {
        let arguments: Vec<String> =
            definition.arguments.iter().map(|of| format!("{}: {}", of.name.text, of.kind.text)).collect();
        let kind = if definition.is_joint { "joint" } else { "part" };
        Part {
            head: format!("{kind} {}({})", definition.name.text, arguments.join(", ")),
            docs: definition.docs.join("\n"),
            members: all_items(&definition.items).flat_map(|item| members(item, source)).collect(),
        }
    }

    /// The ports that it joins, each with its kind: `a: frame`.
    pub(super) fn ports(&self) -> impl Iterator<Item = &str> {
        ports(&self.head)
    }

    pub(super) fn member(&self, name: &str) -> Option<&Member> {
        self.members.iter().find(|member| member.name == name)
    }
}

/// The ports in the head of a part.
pub(super) fn ports(head: &str) -> impl Iterator<Item = &str> {
    let inside =
        head.split_once('(').and_then(|(_, rest)| rest.rsplit_once(')')).map_or("", |(inside, _)| inside);
    inside.split(',').map(str::trim).filter(|port| !port.is_empty())
}

fn members(item: &Item, source: &Source) -> Vec<Member> {
    let member = |name: &str, role, kind: Option<&str>| {
        let (written, docs) = (code(source.text(item.span).unwrap_or_default()), item.docs.join("\n"));
        Member { name: name.to_owned(), role, written, docs, kind: kind.map(str::to_owned) }
    };
    match &item.kind {
        ItemKind::Param(of) | ItemKind::Input(of) | ItemKind::State(of) | ItemKind::Discrete(of) => {
            vec![member(&of.name.ident.text, Role::Set, None)]
        }
        ItemKind::Choice(of) => vec![member(&of.name.text, Role::Set, None)],
        ItemKind::Function(of) => vec![member(&of.name.text, Role::Set, None)],
        ItemKind::Points(of) => vec![member(&of.name.text, Role::Set, None)],
        ItemKind::Node(of) => vec![member(&of.name.ident.text, Role::Read, None)],
        ItemKind::Instance(of) => vec![member(&of.name.ident.text, Role::Part, Some(&of.kind.text))],
        ItemKind::Output(outputs) => {
            let names = outputs.iter().filter_map(|of| match (&of.name, &of.value.kind) {
                (Some(name), _) | (None, ExprKind::Name(name)) => Some(&name.ident.text),
                _ => None,
            });
            names.map(|name| member(name, Role::Read, None)).collect()
        }
        _ => Vec::new(),
    }
}

/// The lines of an item without its documentation, and without their indentation.
pub(super) fn code(written: &str) -> String {
    let lines = written.lines().map(str::trim).filter(|line| !line.starts_with("///"));
    lines.collect::<Vec<_>>().join(" ")
}
