//! Resources by name: the skill, the language in short, pages of the book, parts of the library, and declarations of the pages.

use std::sync::LazyLock;

use plm_compiler::{diag, words};
use serde_json::{Value, json};

use super::wire::{Code, Wrong};
use crate::declarations;

mod book {
    include!(concat!(env!("OUT_DIR"), "/pages.rs"));
}

/// Advice for agents, in the form in which they read it.
const SKILL: &str = include_str!("../../skills/plm/SKILL.md");

/// A resource.
struct Resource {
    uri: String,
    title: String,
    kind: &'static str,
    text: String,
}

const MARKDOWN: &str = "text/markdown";
const PLAIN: &str = "text/plain";

/// All of them. The declarations of the pages are found once.
fn all() -> &'static [Resource] {
    static ALL: LazyLock<Vec<Resource>> = LazyLock::new(collected);
    &ALL
}

fn collected() -> Vec<Resource> {
    let own = |uri: &str, title: &str, kind, text: &str| Resource {
        uri: uri.to_owned(),
        title: title.to_owned(),
        kind,
        text: text.to_owned(),
    };
    let mut all = vec![
        own("plm://skill", "How an agent works with plm", MARKDOWN, SKILL),
        own("plm://language", "The language in short: grammar, parts, units, codes", PLAIN, book::LANGUAGE),
    ];
    for (name, title, text) in book::PAGES {
        all.push(own(&format!("plm://book/{name}"), title, MARKDOWN, text));
    }
    for (name, text) in words::parts().iter().chain(words::domains()) {
        all.push(own(&format!("plm://part/{name}"), &format!("The source of `{name}`"), PLAIN, text));
    }
    all.extend(examples());
    all
}

/// Whole declarations of the pages, named by page and mechanism; of a name that a page has twice the first.
fn examples() -> Vec<Resource> {
    let mut all: Vec<Resource> = Vec::new();
    for (page, title, text) in book::PAGES {
        for (fence, block) in blocks(text) {
            let found = match fence {
                "plm" => vec![block.to_owned()],
                _ if fence.split(',').any(|word| word == "rust") && !fence.contains("compile_fail") => {
                    declarations("page.rs", block)
                }
                _ => continue,
            };
            for declaration in found {
                let Some(name) = name_of(&declaration) else { continue };
                let uri = format!("plm://example/{page}/{name}");
                if all.iter().all(|own| own.uri != uri) {
                    let title = format!("{name}, of the page {title}");
                    all.push(Resource { uri, title, kind: PLAIN, text: declaration });
                }
            }
        }
    }
    all
}

/// The fenced blocks of a page: the words after the fence, and the lines between.
fn blocks(page: &str) -> Vec<(&str, &str)> {
    let mut found = Vec::new();
    let mut rest = page;
    while let Some((_, after)) = rest.split_once("\n```") {
        let Some((fence, body)) = after.split_once('\n') else { break };
        let Some((block, after)) = body.split_once("\n```") else { break };
        found.push((fence.trim(), block));
        rest = after;
    }
    found
}

/// The name of the mechanism that a text declares.
fn name_of(declaration: &str) -> Option<&str> {
    let line = declaration.lines().find_map(|line| line.trim_start().strip_prefix("pub "))?;
    let name = line.split(|letter: char| !letter.is_alphanumeric()).next()?;
    (line[name.len()..].trim_start().starts_with('{') && !name.is_empty()).then_some(name)
}

/// The resources as the protocol lists them.
pub(super) fn list() -> Vec<Value> {
    let shown = |own: &Resource| {
        let size = own.text.len();
        let name = own.uri.trim_start_matches("plm://").to_owned();
        json!({ "uri": own.uri, "name": name, "title": own.title, "mimeType": own.kind, "size": size })
    };
    all().iter().map(shown).collect()
}

/// The forms of their addresses.
pub(super) fn templates() -> Value {
    let form =
        |uri: &str, name: &str, kind: &str| json!({ "uriTemplate": uri, "name": name, "mimeType": kind });
    json!([
        form(
            "plm://book/{+page}",
            "a page of the book, as `running/command-line` or `diagnostics/E0503`",
            MARKDOWN
        ),
        form("plm://part/{name}", "the source of a part, as `revolute`", PLAIN),
        form("plm://example/{+page}/{name}", "a declaration of a page", PLAIN),
    ])
}

/// The text of a resource.
///
/// # Errors
/// There is none of this address; the nearest one is named.
pub(super) fn read(uri: &str) -> Result<Value, Wrong> {
    let all = all();
    if let Some(own) = all.iter().find(|own| own.uri == uri) {
        return Ok(json!({ "uri": own.uri, "mimeType": own.kind, "text": own.text }));
    }
    let near = diag::nearest(uri, all.iter().map(|own| own.uri.as_str()));
    let near = near.map_or(String::new(), |near| format!("; `{near}` is one"));
    let message = format!("there is no resource `{uri}`{near}");
    Err(Wrong::new(Code::Resource, message).with(json!({ "uri": uri })))
}
