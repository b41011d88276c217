//! `<include file="…"/>`: the children of another file in the place of the element.

use std::rc::Rc;

use crate::notice::Notices;
use crate::xml::{Element, parse};

/// Files within files.
const DEEPEST: usize = 16;

/// Replaces all includes within `element`; `read` gives the text of a file by its name.
pub(crate) fn included(
    element: &mut Element,
    read: &mut dyn FnMut(&str) -> Result<String, String>,
    notices: &mut Notices,
) {
    expand(element, read, notices, 0);
}

fn expand(
    element: &mut Element,
    read: &mut dyn FnMut(&str) -> Result<String, String>,
    notices: &mut Notices,
    depth: usize,
) {
    let mut children = Vec::with_capacity(element.children.len());
    for mut child in std::mem::take(&mut element.children) {
        if child.name != "include" {
            expand(&mut child, read, notices, depth);
            children.push(child);
            continue;
        }
        let name = child.get("file").unwrap_or_default().to_owned();
        if depth == DEEPEST {
            notices.error(&child.place, format!("<include>: `{name}` is included by itself"));
            continue;
        }
        let text = match read(&name) {
            Ok(text) => text,
            Err(why) => {
                notices.error(&child.place, format!("<include>: {name}: {why}"));
                continue;
            }
        };
        match parse(&Rc::from(name), &text) {
            Ok(mut root) => {
                expand(&mut root, read, notices, depth + 1);
                children.append(&mut root.children);
            }
            Err((place, why)) => notices.error(&place, why),
        }
    }
    element.children = children;
}
