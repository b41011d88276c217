//! Values at the start, after the names that stand for them.

use std::ops::Range;

use serde_json::{Value, json};

use super::document::Document;
use super::meaning::{shown, value};
use super::names::Kind;
use super::text;

/// `InlayHintKind` of the protocol.
const PARAMETER: u8 = 2;

/// The hints of a range: the value of each `let`, whose text is no number.
pub(super) fn hints(document: &Document, range: &Range<usize>) -> Value {
    let mut hints = Vec::new();
    for declaration in &document.declarations {
        let names = &declaration.names;
        let is_here = |place: &Range<usize>| range.start <= place.end && place.start <= range.end;
        let lets =
            names.all.iter().filter(|name| name.kind == Kind::Value && names.lets.contains(&name.text));
        // Within the definition of a part a name has a value for each use.
        let lets = lets.filter(|name| is_here(&name.place) && !names.is_in_part(name.place.start));
        for name in lets {
            let Some(found) = value(document.values(declaration), &name.text) else { continue };
            hints.push(json!({
                "position": text::position(&document.text, name.place.end),
                "label": format!("= {}", shown(found)),
                "kind": PARAMETER,
                "paddingLeft": true,
            }));
        }
    }
    Value::Array(hints)
}
