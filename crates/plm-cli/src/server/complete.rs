//! Completion: what may stand at a place.

use plm_compiler::units;
use plm_compiler::words;
use serde_json::{Value, json};

use super::document::{Declaration, Document};
use super::names::{Kind, Names};
use super::parts::{Part, Role, ports};
use super::path::{begin, path, tokens_around};
use crate::lexer::{Kind as TokenKind, Token};

/// `CompletionItemKind` of the protocol.
#[derive(Clone, Copy)]
enum Sort {
    Function = 3,
    Field = 5,
    Variable = 6,
    Class = 7,
    Property = 10,
    Unit = 11,
    Keyword = 14,
    Constant = 21,
}

/// `InsertTextFormat` of the protocol.
const SNIPPET: u8 = 2;

/// Items with their places to fill in.
const SNIPPETS: [(&str, &str); 4] = [
    (
        "body",
        "body ${1:name} {\n    mass: ${2:1 kg};\n    inertia: ${3:0.1 kg*m^2};\n    port ${4:a}: (${5:0}, ${6:0}) m;\n}",
    ),
    ("ground", "ground { port ${1:o}: (${2:0}, ${3:0}) m; }"),
    ("gravity", "gravity: ${1:9.81 m/s^2};"),
    ("repeat", "repeat ${1:i} in 0..${2:8} {\n    $0\n}"),
];

/// A completion.
struct Choice {
    label: String,
    sort: Sort,
    detail: String,
    docs: String,
    /// Text that is inserted if an editor supports snippets.
    snippet: Option<String>,
}

fn choice(label: &str, sort: Sort, detail: &str, docs: &str) -> Choice {
    Choice { label: label.to_owned(), sort, detail: detail.to_owned(), docs: docs.to_owned(), snippet: None }
}

/// The completions at a place, the likely ones first; as snippets if the editor supports them.
pub(super) fn completion(document: &Document, at: usize, with_snippets: bool) -> Vec<Value> {
    let choices = document.declaration(at).and_then(|declaration| choices(document, declaration, at));
    let shown = choices.into_iter().flatten().enumerate().map(|(place, of)| {
        let mut shown = json!({
            "label": of.label, "kind": of.sort as u8, "detail": of.detail, "documentation": of.docs,
            // An editor sorts by letters by default.
            "sortText": format!("{place:04}"),
        });
        if let Some(snippet) = of.snippet.filter(|_| with_snippets) {
            shown["insertText"] = json!(snippet);
            shown["insertTextFormat"] = json!(SNIPPET);
        }
        shown
    });
    shown.collect()
}

fn choices(document: &Document, declaration: &Declaration, at: usize) -> Option<Vec<Choice>> {
    let text = &document.text;
    let mut before = tokens_around(text, &declaration.excerpt.range, at)?;
    before.retain(|token| token.range.start < at);
    // The name that is being typed.
    before.pop_if(|token| token.kind == TokenKind::Word && token.range.end >= at);
    let names = &declaration.names;
    let Some(last) = before.last() else { return Some(items(names)) };
    Some(match last.text(text) {
        "." => members(text, &before, names, at),
        _ if last.kind == TokenKind::Number || is_unit_wanted(text, &before) => of_units(),
        ";" | "{" | "}" => beginnings(text, &before, names, at),
        "start" => of_words(&["x", "y", "angle", "vx", "vy", "omega"], Sort::Property),
        ":" if sets_option(text, &before) => of_words(&words::options(), Sort::Keyword),
        // After a pair, `(0, 0) m`, or after an expression.
        ")" => [of_units(), expression(names, at)].concat_all(),
        _ => expression(names, at),
    })
}

/// After `formulation:` and the like.
fn sets_option(text: &str, before: &[Token]) -> bool {
    let word = before.len().checked_sub(2).map_or("", |at| before[at].text(text));
    ["code", "formulation", "impacts", "stabilisation"].contains(&word)
}

/// After `param k:`, `in`, and an operator within a unit.
fn is_unit_wanted(text: &str, before: &[Token]) -> bool {
    let word = |back: usize| before.len().checked_sub(back).map_or("", |at| before[at].text(text));
    let is_value =
        |word: &str| ["param", "input", "state", "discrete", "points", "across", "through"].contains(&word);
    let is_unit = |word: &str| units::unit(word).is_some();
    match word(1) {
        ":" => is_value(word(3)),
        "*" | "/" => is_unit(word(2)),
        "in" => {
            let item = before.iter().rposition(|token| ["{", "}", ";"].contains(&token.text(text)));
            before.get(item.map_or(0, |at| at + 1)).is_some_and(|token| token.text(text) == "output")
        }
        _ => false,
    }
}

fn of_units() -> Vec<Choice> {
    let unit = |name: &&str| {
        let word = units::unit(name).map_or("", |unit| unit.word);
        choice(name, Sort::Unit, word, "")
    };
    words::units().iter().map(unit).collect()
}

/// After a dot.
fn members(text: &str, before: &[Token], names: &Names, at: usize) -> Vec<Choice> {
    // The dot, and after it an empty name.
    let Some(end) = before.len().checked_sub(2) else { return Vec::new() };
    let first = if before[end].kind == TokenKind::Word {
        begin(text, before, end)
    } else {
        begin_of_index(text, before)
    };
    let path = path(text, &before[first..=end]);
    let Some((owner, rest)) = path.split_first() else { return Vec::new() };
    let found = names.visible(owner, at);
    match found.map(|name| &name.kind) {
        Some(Kind::Instance(kind)) => {
            names.part(kind).map_or(Vec::new(), |part| of_part(names, &part, rest, &[Role::Read, Role::Set]))
        }
        Some(Kind::Body) if rest.is_empty() => {
            [ports_of(names, owner), of_words(&words::members_of_bodies(), Sort::Property)].concat_all()
        }
        None if owner == "ground" && rest.is_empty() => ports_of(names, owner),
        // The field of a part in use: a part inside of it.
        None if owner != "ground" => match names.instance_around(at).map(|name| &name.kind) {
            Some(Kind::Instance(kind)) => {
                names.part(kind).map_or(Vec::new(), |part| of_part(names, &part, &path, &[Role::Set]))
            }
            _ => Vec::new(),
        },
        _ => of_words(&words::members_of_frames(), Sort::Property),
    }
}

/// The first token of a path that ends with an index in front of the last token.
fn begin_of_index(text: &str, before: &[Token]) -> usize {
    let mut depth = 0_i32;
    let open = before[..before.len() - 1].iter().rposition(|token| {
        depth += i32::from(token.is_mark(text, ']')) - i32::from(token.is_mark(text, '['));
        depth == 0
    });
    open.and_then(|open| open.checked_sub(1)).map_or(before.len() - 2, |name| begin(text, before, name))
}

trait ConcatAll {
    fn concat_all(self) -> Vec<Choice>;
}

impl<const N: usize> ConcatAll for [Vec<Choice>; N] {
    fn concat_all(self) -> Vec<Choice> {
        self.into_iter().flatten().collect()
    }
}

fn of_words(words: &[&str], sort: Sort) -> Vec<Choice> {
    words.iter().map(|word| choice(word, sort, "", "")).collect()
}

fn ports_of(names: &Names, owner: &str) -> Vec<Choice> {
    let ports = names.all.iter().filter(|name| name.owner.as_deref() == Some(owner));
    ports.map(|port| choice(&port.text, Sort::Field, &port.written, "")).collect()
}

/// Members of a part, or of a part inside of it.
fn of_part(names: &Names, part: &Part, path: &[String], roles: &[Role]) -> Vec<Choice> {
    if let Some((first, rest)) = path.split_first() {
        let kind = part.member(first).and_then(|member| member.kind.clone());
        let inner = kind.and_then(|kind| names.part(&kind));
        return inner.map_or(Vec::new(), |inner| of_part(names, &inner, rest, roles));
    }
    let members =
        part.members.iter().filter(|member| roles.contains(&member.role) || member.role == Role::Part);
    members.map(|member| choice(&member.name, Sort::Field, &member.written, &member.docs)).collect()
}

/// Completions at the beginning of an item.
fn beginnings(text: &str, before: &[Token], names: &Names, at: usize) -> Vec<Choice> {
    let Some(head) = block(text, before) else { return items(names) };
    let words: Vec<&str> = head.iter().map(|token| token.text(text)).collect();
    match words.as_slice() {
        ["body", ..] => of_words(&words::of_bodies(), Sort::Keyword),
        ["ground"] => of_words(&["port"], Sort::Keyword),
        ["unilateral", ..] => of_words(&["restitution", "when"], Sort::Keyword),
        ["friction", ..] => of_words(&["static", "when"], Sort::Keyword),
        ["constraint", ..] => of_words(&["when"], Sort::Keyword),
        ["domain", ..] => of_words(&["across", "through"], Sort::Keyword),
        ["when", ..] => expression(names, at),
        [kind, ..] => match names.part(kind) {
            Some(part) => of_part(names, &part, &[], &[Role::Set]),
            None => items(names),
        },
        [] => items(names),
    }
}

/// The tokens in front of the bracket that is open, up to the item before.
fn block<'a>(text: &str, before: &'a [Token]) -> Option<&'a [Token]> {
    let mut depth = 0_i32;
    let open = before.iter().rposition(|token| {
        depth += i32::from(token.is_mark(text, '{')) - i32::from(token.is_mark(text, '}'));
        depth > 0
    })?;
    let head = &before[..open];
    let start =
        head.iter().rposition(|token| ["{", "}", ";"].contains(&token.text(text))).map_or(0, |at| at + 1);
    Some(&head[start..])
}

/// Keywords that begin an item, and the parts.
fn items(names: &Names) -> Vec<Choice> {
    let mut all = of_words(&words::items(), Sort::Keyword);
    for item in &mut all {
        let snippet = SNIPPETS.iter().find(|(word, _)| *word == item.label);
        item.snippet = snippet.map(|(_, snippet)| (*snippet).to_owned());
    }
    let own = names.parts.iter().map(|(name, part)| Choice {
        snippet: Some(use_of(name, &part.head)),
        ..choice(name, Sort::Class, &part.head, &part.docs)
    });
    all.extend(own);
    let of_library = words::parts().iter().map(|(name, text)| Choice {
        snippet: Some(use_of(name, head(text))),
        ..choice(name, Sort::Class, "a part of the library", first_line(text))
    });
    all.extend(of_library);
    all
}

/// The use of a part, with its name and its ports to fill in.
fn use_of(name: &str, head: &str) -> String {
    let port = |(k, port): (usize, &str)| {
        format!("${{{}:{}}}", k + 2, port.split(':').next().unwrap_or_default().trim())
    };
    let ports: Vec<String> = ports(head).enumerate().map(port).collect();
    format!("{name} ${{1:name}}({});$0", ports.join(", "))
}

/// The head of a part of the library: up to its brackets.
fn head(text: &str) -> &str {
    let is_head = |line: &&str| line.starts_with("part ") || line.starts_with("joint ");
    text.lines().find(is_head).unwrap_or_default()
}

/// The first line of the documentation that a text begins with.
fn first_line(text: &str) -> &str {
    text.lines().next().and_then(|line| line.strip_prefix("/// ")).unwrap_or_default()
}

/// Completions within an expression, or for the name of a port.
fn expression(names: &Names, at: usize) -> Vec<Choice> {
    let visible = names.all.iter().filter(|name| name.owner.is_none() && name.scope.contains(&at));
    let mut all: Vec<Choice> = visible
        .filter(|name| name.kind != Kind::Definition)
        .map(|name| choice(&name.text, Sort::Variable, &name.written, &name.docs))
        .collect();
    all.push(choice("ground", Sort::Variable, "", ""));
    all.extend(of_words(&words::functions(), Sort::Function));
    all.extend(of_words(&words::constants(), Sort::Constant));
    all.extend(of_words(&["if", "then", "else", "and", "or", "not"], Sort::Keyword));
    all
}
