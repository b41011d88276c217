//! Copies: a body again, beside the one that it is of, without its joints.

use plm_compiler::syntax::ast::{Body, Item, ItemKind};

use crate::draw::{named_point, point_at};
use crate::edit::{Edit, applied, in_order};
use crate::gesture::Drawn;
use crate::insert::{Insertion, Section, Words};
use crate::lexer::tokens;
use crate::number::{degrees, rounded};
use crate::picture::{Picture, Point, turned};
use crate::refusal::Refusal;
use crate::rules::{FINE, turn_of_axes};
use crate::sheet::{Axes, Handle, Place, Sheet, mentions};

/// A body again, so far from the one with this name.
///
/// # Errors
/// The text has no such body, or a repetition makes it; none of its places has numbers.
pub(crate) fn body(
    sheet: &Sheet<'_>,
    picture: &Picture,
    name: &str,
    by: Point,
    grid: f64,
) -> Result<Drawn, Refusal> {
    let (item, body) = named(sheet, name)?;
    let handles = sheet.handles();
    let own: Vec<&Handle> = handles.iter().filter(|of| of.name.owner == name && of.body.is_some()).collect();
    let (mut words, mut insertion) = (Words::of(sheet.text), Insertion::default());
    let stem = name.trim_end_matches(|letter: char| letter.is_ascii_digit());
    let copy = words.fresh(if stem.is_empty() { "bar" } else { stem });
    let whole = sheet.range(item.span);
    let mut edits = vec![Edit::new(sheet.range(body.name.ident.span), copy.clone())];
    if own.first().is_some_and(|first| first.axes == Axes::Own) {
        edits.extend(starts(sheet, picture, body, &own, (by, grid))?);
    } else {
        edits.extend(points(sheet, item, &own, (by, grid), &mut words, &mut insertion));
    }
    let of_copy =
        |edit: Edit| Edit { range: edit.range.start - whole.start..edit.range.end - whole.start, ..edit };
    let inside: Vec<Edit> = in_order(edits).into_iter().map(of_copy).collect();
    insertion.put(Section::Things, applied(&sheet.text[whole], &inside));
    Ok(Drawn { edits: insertion.edits(sheet)?, made: vec![copy], ..Drawn::default() })
}

/// A body of the text, with its item.
fn named<'s>(sheet: &'s Sheet<'_>, name: &str) -> Result<(&'s Item, &'s Body), Refusal> {
    let base = name.split('[').next().unwrap_or(name);
    if base != name {
        return Err(Refusal::Repeated(name.to_owned()));
    }
    let found = sheet.items().iter().find_map(|item| match &item.kind {
        ItemKind::Body(body) if body.name.ident.text == name => Some((item, body)),
        _ => None,
    });
    found.ok_or_else(|| Refusal::Unknown(name.to_owned()))
}

/// A body of a drawing: each of its points again, with a name of its own where the one has a name.
fn points(
    sheet: &Sheet<'_>,
    item: &Item,
    own: &[&Handle<'_>],
    ([dx, dy], grid): (Point, f64),
    words: &mut Words,
    insertion: &mut Insertion,
) -> Vec<Edit> {
    let (mut edits, mut names) = (Vec::new(), Vec::new());
    for handle in own {
        let Some([x, y]) = handle.place.at() else { continue };
        let at = [x + dx, y + dy];
        let (through, pair) = match &handle.place {
            Place::Numbers { through, pair, .. } => (*through, pair),
            Place::Polar { through, value, .. } => (Some(*through), value),
            Place::Expression(_) => continue,
        };
        match through {
            None => edits.push(Edit::new(pair.clone(), point_at(at, grid))),
            Some(name) if names.iter().any(|(known, _)| *known == name) => {}
            Some(name) => names.push((name, named_point(at, grid, words, insertion))),
        }
    }
    mentions(item, &mut |mention| {
        let new = names.iter().find(|(known, _)| *known == mention.name.text);
        edits.extend(new.map(|(_, new)| Edit::new(sheet.range(mention.name.span), new.clone())));
    });
    edits
}

/// A body with axes of its own: it starts beside the other one.
fn starts(
    sheet: &Sheet<'_>,
    picture: &Picture,
    body: &Body,
    own: &[&Handle<'_>],
    ([dx, dy], grid): (Point, f64),
) -> Result<Vec<Edit>, Refusal> {
    let known = own.iter().find_map(|handle| {
        handle.place.at().zip(picture.port(&handle.name)).map(|(at, placed)| (*handle, at, placed))
    });
    let (handle, at, placed) = known.ok_or_else(|| Refusal::NotShown(own[0].name.clone()))?;
    let angle = turn_of_axes(handle.axes, placed.angle);
    let [x, y] = turned(at, angle);
    let origin =
        [placed.at[0] - x + dx, placed.at[1] - y + dy].map(|part| rounded(1e3 * part, 1e3 * FINE * grid));
    let degrees = degrees(angle);
    let mut edits = Vec::new();
    for start in &body.starts {
        if !["x", "y", "angle"].contains(&start.coordinate.text.as_str()) {
            continue;
        }
        let word = sheet.range(start.coordinate.span);
        let from = sheet.text[..word.start].rfind("start").unwrap_or(word.start);
        let rest = &sheet.text[word.end..];
        let end =
            tokens(rest).iter().find(|token| token.is_mark(rest, ';')).map_or(0, |token| token.range.end);
        let blanks = sheet.text[..from].len() - sheet.text[..from].trim_end().len();
        edits.push(Edit::new(from - blanks..word.end + end, ""));
    }
    let port = body.ports.last().ok_or_else(|| Refusal::Unknown(body.name.ident.text.clone()))?;
    let last = crate::remove::statement(sheet, port).end;
    let [x, y] = origin;
    edits.push(Edit::insertion(
        last,
        format!(" start x: {x} mm; start y: {y} mm; start angle: {degrees} deg;"),
    ));
    Ok(edits)
}
