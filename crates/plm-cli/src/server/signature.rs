//! Arguments within the brackets that are open at a place: the ports of a part.

use serde_json::{Value, json};

use super::document::Document;
use super::path::tokens_around;
use crate::lexer::Kind;

/// The head of the part in whose brackets a place is, and which of its ports stands there.
pub(super) fn signature(document: &Document, at: usize) -> Option<Value> {
    let text = &document.text;
    let declaration = document.declaration(at)?;
    let mut before = tokens_around(text, &declaration.excerpt.range, at)?;
    before.retain(|token| token.range.start < at);
    let mut depth = 0_i32;
    let open = before.iter().rposition(|token| {
        depth += i32::from(token.is_mark(text, '(')) - i32::from(token.is_mark(text, ')'));
        depth > 0
    })?;
    // `revolute hinge(`: the kind of the part, and its name.
    let [.., kind, name] = &before[..open] else { return None };
    if kind.kind != Kind::Word || name.kind != Kind::Word {
        return None;
    }
    let part = declaration.names.part(kind.text(text))?;
    let inside = &before[open + 1..];
    let count = inside.iter().filter(|token| token.is_mark(text, ',')).count();
    let ports: Vec<Value> = part.ports().map(|port| json!({ "label": port })).collect();
    let signature = json!({ "label": part.head, "documentation": part.docs, "parameters": ports });
    Some(json!({ "signatures": [signature], "activeSignature": 0, "activeParameter": count }))
}
