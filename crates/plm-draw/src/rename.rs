//! Renaming: a thing or a port has another name wherever it is named.

use plm_compiler::syntax::ast::{Ident, Item, ItemKind, Port};
use plm_compiler::words;

use crate::edit::Edit;
use crate::insert::Words;
use crate::lexer::{Kind, tokens};
use crate::names::{GROUND, PortName};
use crate::refusal::Refusal;
use crate::remove::declared;
use crate::sheet::{Mention, Sheet, mentions};

/// The edits that give a thing another name.
///
/// # Errors
/// The text has no such thing, or the new name is none, or is a word of the text.
pub(crate) fn thing(sheet: &Sheet<'_>, from: &str, to: &str) -> Result<Vec<Edit>, Refusal> {
    check(sheet, to)?;
    let mut places = Vec::new();
    for item in sheet.items() {
        collect(item, from, &mut places);
    }
    if places.is_empty() {
        return Err(Refusal::Unknown(from.to_owned()));
    }
    for item in sheet.items() {
        mentions(item, &mut |Mention { name, .. }| {
            if name.text == from {
                places.push(name);
            }
        });
    }
    Ok(edits(sheet, &places, to))
}

/// The edits that give a port another name.
///
/// # Errors
/// Those of the name of a thing.
pub(crate) fn port(sheet: &Sheet<'_>, from: &PortName, to: &str) -> Result<Vec<Edit>, Refusal> {
    check(sheet, to)?;
    let mut places: Vec<&Ident> = Vec::new();
    for item in sheet.items() {
        ports(item, &from.owner, &mut |port| {
            if port.name.ident.text == from.port {
                places.push(&port.name.ident);
            }
        });
    }
    if places.is_empty() {
        return Err(Refusal::Unknown(from.to_string()));
    }
    for item in sheet.items() {
        mentions(item, &mut |Mention { name, member }| {
            places.extend(member.filter(|member| name.text == from.owner && member.text == from.port));
        });
    }
    Ok(edits(sheet, &places, to))
}

fn check(sheet: &Sheet<'_>, to: &str) -> Result<(), Refusal> {
    let word = tokens(to);
    let is_word = matches!(&word[..], [word] if word.kind == Kind::Word && word.range == (0..to.len()));
    if !is_word || to.starts_with("r#") || words::is_taken(to) {
        return Err(Refusal::NoName(to.to_owned()));
    }
    if Words::of(sheet.text).has(to) { Err(Refusal::Taken(to.to_owned())) } else { Ok(()) }
}

fn edits(sheet: &Sheet<'_>, places: &[&Ident], to: &str) -> Vec<Edit> {
    let mut ranges: Vec<_> = places.iter().map(|place| sheet.range(place.span)).collect();
    ranges.sort_by_key(|range| range.start);
    ranges.dedup();
    ranges.into_iter().map(|range| Edit::new(range, to)).collect()
}

/// Names that declare a thing.
fn collect<'s>(item: &'s Item, name: &str, places: &mut Vec<&'s Ident>) {
    if let ItemKind::Repeat(repeat) = &item.kind {
        repeat.items.iter().for_each(|item| collect(item, name, places));
    }
    places.extend(declared(item).filter(|of| of.text == name));
}

/// Ports of an owner.
fn ports<'s>(item: &'s Item, owner: &str, take: &mut impl FnMut(&'s Port)) {
    match &item.kind {
        ItemKind::Repeat(repeat) => repeat.items.iter().for_each(|item| ports(item, owner, take)),
        ItemKind::Ground(all) if owner == GROUND => all.iter().for_each(take),
        ItemKind::Body(body) if body.name.ident.text == owner => body.ports.iter().for_each(take),
        _ => {}
    }
}
