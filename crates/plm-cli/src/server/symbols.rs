//! The outline of a text: its declarations, and in each what it names.

use std::ops::Range;

use serde_json::{Value, json};

use super::document::{Declaration, Document};
use super::names::{Kind, Name};
use super::text;
use crate::lexer::{Kind as TokenKind, tokens};

/// `SymbolKind` of the protocol.
#[derive(Clone, Copy)]
enum Sort {
    Module = 2,
    Class = 5,
    Field = 8,
    Interface = 11,
    Variable = 13,
    Object = 19,
    Operator = 25,
}

impl Sort {
    fn of(kind: &Kind) -> Self {
        match kind {
            Kind::Body | Kind::Instance(_) => Self::Object,
            Kind::Port => Self::Field,
            Kind::Node => Self::Interface,
            Kind::Definition => Self::Class,
            Kind::Value => Self::Variable,
            Kind::Row => Self::Operator,
        }
    }
}

/// The symbols of a text, each with those inside of it.
pub(super) fn symbols(document: &Document) -> Value {
    document.declarations.iter().map(|declaration| of_declaration(document, declaration)).collect()
}

fn of_declaration(document: &Document, declaration: &Declaration) -> Value {
    let all = &declaration.excerpt.range;
    let inside = declaration.names.all.iter().filter(|name| name.owner.is_none() && name.scope == *all);
    let children: Vec<Value> = inside.map(|name| of_name(document, declaration, name)).collect();
    let (name, place) = title(&document.text, all);
    symbol(document, (&name, ""), Sort::Module, [all, &place], &children)
}

fn of_name(document: &Document, declaration: &Declaration, name: &Name) -> Value {
    let is_inside = |inner: &&Name| match name.kind {
        Kind::Body => inner.owner.as_deref() == Some(&name.text),
        Kind::Definition => inner.owner.is_none() && inner.scope == name.item,
        _ => false,
    };
    let children = declaration.names.all.iter().filter(is_inside);
    let children: Vec<Value> = children.map(|inner| of_name(document, declaration, inner)).collect();
    let detail = match &name.kind {
        Kind::Instance(kind) => kind.as_str(),
        Kind::Body => "body",
        _ => "",
    };
    // An item may begin after its name: that of an argument of a part.
    let item = name.item.start.min(name.place.start)..name.item.end.max(name.place.end);
    symbol(document, (&name.text, detail), Sort::of(&name.kind), [&item, &name.place], &children)
}

fn symbol(
    document: &Document,
    (name, detail): (&str, &str),
    sort: Sort,
    [range, place]: [&Range<usize>; 2],
    children: &[Value],
) -> Value {
    let [range, place] = [range, place].map(|of| text::range(&document.text, of));
    json!({
        "name": name, "detail": detail, "kind": sort as u8,
        "range": range, "selectionRange": place, "children": children,
    })
}

/// The name of a mechanism and its place: the last name in front of its items.
fn title(text: &str, declaration: &Range<usize>) -> (String, Range<usize>) {
    let part = text.get(declaration.clone()).unwrap_or_default();
    let before = tokens(part).into_iter().take_while(|token| !token.is_mark(part, '{'));
    let last = before.filter(|token| token.kind == TokenKind::Word).last();
    match last {
        Some(word) => {
            let place = word.range.start + declaration.start..word.range.end + declaration.start;
            (word.text(part).to_owned(), place)
        }
        None => ("mechanism".to_owned(), declaration.start..declaration.start),
    }
}
