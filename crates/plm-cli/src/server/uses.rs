//! Uses of a name: references, and renaming.

use std::ops::Range;

use plm_compiler::words;
use serde_json::{Value, json};

use super::document::{Declaration, Document};
use super::meaning::{Meaning, meaning};
use super::names::{Kind, Name};
use super::path::tokens_around;
use super::text;
use crate::lexer::{Kind as TokenKind, tokens};

/// All places of the name at a place, in their order; with where it is declared, if that is asked for.
pub(super) fn references(document: &Document, at: usize, with_declaration: bool) -> Option<Value> {
    let (declared, places) = places(document, at)?;
    let places = places.iter().filter(|place| with_declaration || **place != declared);
    Some(
        places
            .map(|place| json!({ "uri": document.uri, "range": text::range(&document.text, place) }))
            .collect(),
    )
}

/// Range of the name at a place, if it can be renamed.
pub(super) fn renamed(document: &Document, at: usize) -> Option<Value> {
    let (_, places) = places(document, at)?;
    let here = places.iter().find(|place| place.start <= at && at <= place.end)?;
    Some(text::range(&document.text, here))
}

/// The edits that give the name at a place another one.
///
/// # Errors
/// Nothing with a name of its own stands there, or the new one is none.
pub(super) fn rename(document: &Document, at: Option<usize>, name: &str) -> Result<Value, String> {
    let word = tokens(name);
    let is_word =
        matches!(&word[..], [word] if word.kind == TokenKind::Word && word.range == (0..name.len()));
    if !is_word || words::is_taken(name) {
        return Err(format!(
            "`{name}` is no name: a name is a word of letters, digits and `_`, and none of the language"
        ));
    }
    let found = at.and_then(|at| places(document, at));
    let (_, places) = found.ok_or("the declaration gives no name here")?;
    let edits: Vec<Value> = places
        .iter()
        .map(|place| json!({ "range": text::range(&document.text, place), "newText": name }))
        .collect();
    Ok(json!({ "changes": { &document.uri: edits } }))
}

/// Range of the declaration of the name at a place, and of all its uses.
fn places(document: &Document, at: usize) -> Option<(Range<usize>, Vec<Range<usize>>)> {
    let declaration = document.declaration(at)?;
    let is_declared = |name: &&Name| name.place.start <= at && at <= name.place.end;
    let target = match declaration.names.all.iter().find(is_declared) {
        Some(name) => name,
        None => match meaning(document, at)?.0 {
            Meaning::Name(name) => name,
            // A part that the declaration defines itself, by its use.
            Meaning::Part(_) => of_definition(document, declaration, at)?,
            _ => return None,
        },
    };
    let range = &declaration.excerpt.range;
    let tokens = tokens_around(&document.text, range, range.start)?.into_iter();
    let words =
        tokens.filter(|token| token.kind == TokenKind::Word && token.text(&document.text) == target.text);
    let means_it = |place: &Range<usize>| {
        *place == target.place
            || match meaning(document, place.start) {
                Some((Meaning::Name(name), ..)) => name.place == target.place,
                Some((Meaning::Part(_), ..)) => of_definition(document, declaration, place.start)
                    .is_some_and(|of| of.place == target.place),
                _ => false,
            }
    };
    let places = words.map(|token| token.range).filter(means_it).collect();
    Some((target.place.clone(), places))
}

fn of_definition<'a>(document: &Document, declaration: &'a Declaration, at: usize) -> Option<&'a Name> {
    let (_, word, _) = meaning(document, at)?;
    declaration.names.visible(word.path.last()?, at).filter(|name| name.kind == Kind::Definition)
}
