//! A declaration with other values of parameters and of starts.

use std::ops::Range;

use plm_compiler::diag::Diagnostics;
use plm_compiler::syntax::ast::{Body, Item, ItemKind, Value, all_items};
use plm_compiler::syntax::parse;
use plm_compiler::token::{Source, Sources};

/// A value that a declaration is to have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found<'a> {
    /// Name of a parameter, of a state, or of a start of a body, such as `bob.angle`.
    pub name: &'a str,
    /// In the unit.
    pub value: f64,
    /// The unit that it is written with.
    pub unit: &'a str,
}

/// The text of a declaration with other values, and the names that stand nowhere in it, such as those of parts and of repetitions.
pub fn with_values<'a>(name: &str, text: &str, found: &[Found<'a>]) -> (String, Vec<&'a str>) {
    let mut sources = Sources::new();
    let id = sources.add_text(name, text);
    let Some(source) = sources.get(id) else {
        return (text.to_owned(), found.iter().map(|found| found.name).collect());
    };
    let declaration = parse(source, &mut Diagnostics::new());
    let items = declaration.mechanism.map(|mechanism| mechanism.items).unwrap_or_default();
    let items: Vec<&Item> = all_items(&items).collect();
    let (mut changes, mut missing) = (Vec::new(), Vec::new());
    for own in found {
        match items.iter().find_map(|item| change(source, text, item, own)) {
            Some(change) => changes.push(change),
            None => missing.push(own.name),
        }
    }
    // From the last to the first, so that places stay.
    changes.sort_by_key(|(range, _): &(Range<usize>, String)| std::cmp::Reverse(range.start));
    let mut text = text.to_owned();
    for (range, value) in changes {
        text.replace_range(range, &value);
    }
    (text, missing)
}

/// The change of an item, if the value is its own.
fn change(source: &Source, text: &str, item: &Item, found: &Found) -> Option<(Range<usize>, String)> {
    match &item.kind {
        ItemKind::Param(value) | ItemKind::State(value) => of_value(source, text, item, value, found),
        ItemKind::Body(body) => of_body(source, text, item, body, found),
        _ => None,
    }
}

fn of_value(
    source: &Source,
    text: &str,
    item: &Item,
    value: &Value,
    found: &Found,
) -> Option<(Range<usize>, String)> {
    if value.name.ident.text != found.name || !value.name.indices.is_empty() {
        return None;
    }
    if let Some(own) = &value.value {
        return Some((source.range(own.span)?, shown(found)));
    }
    let range = source.range(item.span)?;
    let end = range.start + text.get(range)?.rfind(';')?;
    Some((end..end, format!(" = {}", shown(found))))
}

fn of_body(
    source: &Source,
    text: &str,
    item: &Item,
    body: &Body,
    found: &Found,
) -> Option<(Range<usize>, String)> {
    let coordinate = found.name.strip_prefix(&body.name.ident.text)?.strip_prefix('.')?;
    if !body.name.indices.is_empty() {
        return None;
    }
    if let Some(start) = body.starts.iter().find(|start| start.coordinate.text == coordinate) {
        return Some((source.range(start.value.span)?, shown(found)));
    }
    let range = source.range(item.span)?;
    let end = range.start + text.get(range)?.rfind('}')?;
    let before = if text[..end].ends_with(char::is_whitespace) { "" } else { " " };
    Some((end..end, format!("{before}start {coordinate}: {}; ", shown(found))))
}

/// The value with its unit; reads back to the same bits.
fn shown(found: &Found) -> String {
    let unit = if found.unit.is_empty() { String::new() } else { format!(" {}", found.unit) };
    format!("{:?}{unit}", found.value)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::{Found, with_values};

    #[test]
    fn values_stand_where_they_stood() {
        let text = "pub A { param k: N/m; param m = 1 kg; // about\n\
                    body b { mass: m; inertia: 1 kg*m^2; start x: 2*1 m, locked; }\n\
                    repeat i in 0..2 { body c[i] { mass: m; inertia: 1 kg*m^2; } } }";
        let of = |name, value, unit| Found { name, value, unit };
        let found = [
            of("k", 2.5, "N/m"),
            of("m", 1e-9, "kg"),
            of("b.x", -0.25, "m"),
            of("b.vx", 3.0, "m/s"),
            of("c[1].x", 1.0, "m"),
        ];
        let (text, missing) = with_values("a.plm", text, &found);
        assert_eq!(missing, ["c[1].x"]);
        assert_eq!(
            text,
            "pub A { param k: N/m = 2.5 N/m; param m = 1e-9 kg; // about\n\
             body b { mass: m; inertia: 1 kg*m^2; start x: -0.25 m, locked; start vx: 3.0 m/s; }\n\
             repeat i in 0..2 { body c[i] { mass: m; inertia: 1 kg*m^2; } } }"
        );
    }
}
