//! Lines of a declaration in messages that have no place of their own: faults of a run, and what a run has no room for.

use plm_compiler::diag::Diagnostics;
use plm_compiler::syntax::ast::all_items;
use plm_compiler::syntax::parse;
use plm_compiler::token::Sources;
use plm_dynamic::Refused;

use crate::read::File;

/// What a run of a text has no room for, with its place and what to do.
pub(crate) fn too_large(refused: &Refused, severity: &str, file: &File) -> String {
    let Refused::TooLarge { first, .. } = refused else { return refused.to_string() };
    let place = quote(first, file).unwrap_or_default();
    format!(
        "{severity}: {refused}\n{place}  = help: fewer of them, as by fewer corners; or a compiled program, which has room for all: \
         `plm export {} --rust FOLDER`\n",
        file.name
    )
}

/// The line of the declaration in which a part has its name, with the place of it; nothing of a part that stands in no line of it.
pub(crate) fn quote(part: &str, file: &File) -> Option<String> {
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
    let start = file.text[..at].rfind('\n').map_or(0, |end| end + 1);
    let line = file.text[start..].lines().next()?;
    let (number, column) =
        (file.text[..start].matches('\n').count() + 1, file.text[start..at].chars().count());
    let margin = " ".repeat(number.to_string().len());
    Some(format!(
        "{margin}--> {}:{number}:{}\n{margin} |\n{number} | {line}\n{margin} | {}{}\n",
        file.name,
        column + 1,
        " ".repeat(column),
        "^".repeat(name.chars().count()),
    ))
}

/// Where a whole word stands first in a text.
fn word(text: &str, name: &str) -> Option<usize> {
    let is_letter = |letter: char| letter.is_alphanumeric() || letter == '_';
    text.match_indices(name)
        .map(|(at, _)| at)
        .find(|at| !text[..*at].ends_with(is_letter) && !text[at + name.len()..].starts_with(is_letter))
}
