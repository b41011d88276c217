//! Lines of a declaration in messages that have no place of their own: faults of a run, and what a run has no room for.

use std::ops::Range;

use plm_compiler::diag::Diagnostics;
use plm_compiler::syntax::ast::all_items;
use plm_compiler::syntax::parse;
use plm_compiler::token::Sources;
use plm_dynamic::Refused;

use crate::read::File;

/// Message for a declaration that is too large for a run from text, with its place and advice.
pub(crate) fn too_large(refused: &Refused, severity: &str, file: &File) -> String {
    let Refused::TooLarge { first, .. } = refused else { return refused.to_string() };
    let place = quote(first, file).unwrap_or_default();
    format!(
        "{severity}: {refused}\n{place}  = help: fewer of them, as by fewer corners; or a compiled program, which has room for all: \
         `plm export {} --rust FOLDER`\n",
        file.name
    )
}

/// The line of the declaration in which a part has its name, or in which a condition is written, with the place of it; nothing of what
/// stands in no line of it.
pub(crate) fn quote(part: &str, file: &File) -> Option<String> {
    let is_name = |letter: char| letter.is_alphanumeric() || "_.[]".contains(letter);
    let place = if part.chars().all(is_name) { named(part, file)? } else { written(part, &file.text)? };
    let start = file.text[..place.start].rfind('\n').map_or(0, |end| end + 1);
    let line = file.text[start..].lines().next()?;
    let length = file.text[place.clone()].lines().next()?.chars().count();
    let (number, column) =
        (file.text[..start].matches('\n').count() + 1, file.text[start..place.start].chars().count());
    let margin = " ".repeat(number.to_string().len());
    Some(format!(
        "{margin}--> {}:{number}:{}\n{margin} |\n{number} | {line}\n{margin} | {}{}\n",
        file.name,
        column + 1,
        " ".repeat(column),
        "^".repeat(length),
    ))
}

/// The place of a part's name.
fn named(part: &str, file: &File) -> Option<Range<usize>> {
    let name = part.split(['.', '[']).next().filter(|name| !name.is_empty())?;
    let mut sources = Sources::new();
    let id = sources.add_text(&file.name, &file.text);
    let source = sources.get(id)?;
    let mechanism = parse(source, &mut Diagnostics::new()).mechanism?;
    let at = all_items(&mechanism.items).find_map(|item| {
        let range = source.range(item.span)?;
        // The name of an item stands in front of its brackets and its equation.
        let head = file.text[range.clone()].split(['(', '{', ';', '=']).next()?;
        word(head, name).map(|at| range.start + at)
    })?;
    Some(at..at + name.len())
}

/// The place of an expression, whatever the blanks in it.
fn written(expression: &str, text: &str) -> Option<Range<usize>> {
    let (mut dense, mut places) = (String::new(), Vec::new());
    for (at, letter) in text.char_indices().filter(|(_, letter)| !letter.is_whitespace()) {
        places.resize(dense.len() + letter.len_utf8(), at);
        dense.push(letter);
    }
    let wanted: String = expression.split_whitespace().collect();
    let at = dense.find(&wanted)?;
    let (first, last) = (*places.get(at)?, *places.get(at + wanted.len() - 1)?);
    Some(first..last + text[last..].chars().next()?.len_utf8())
}

/// Position of the first whole occurrence of a name in a text.
fn word(text: &str, name: &str) -> Option<usize> {
    let is_letter = |letter: char| letter.is_alphanumeric() || letter == '_';
    text.match_indices(name)
        .map(|(at, _)| at)
        .find(|at| !text[..*at].ends_with(is_letter) && !text[at + name.len()..].starts_with(is_letter))
}
