//! Insertion: where new items stand, and how they are indented.
//!
//! Things stand behind the last thing, joints behind the last joint, rows behind the last row; each begins a line, with the indentation
//! that the layout gives it.

use std::collections::BTreeSet;

use plm_compiler::syntax::ast::{Item, ItemKind};

use crate::edit::Edit;
use crate::lexer::{Kind, tokens};
use crate::refusal::Refusal;
use crate::sheet::Sheet;

/// Columns of a level of the layout.
pub(crate) const LEVEL: usize = 4;

/// The name of a mechanism that a drawing begins.
const FIRST: &str = "Drawing";

/// A kind of item, by where it stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Section {
    /// Points, bodies, the ground.
    Things,
    /// Uses of parts.
    Joints,
    /// Constraints.
    Rows,
}

impl Section {
    fn holds(self, item: &Item) -> bool {
        match self {
            Section::Things => matches!(item.kind, ItemKind::Body(_) | ItemKind::Ground(_)),
            Section::Joints => matches!(item.kind, ItemKind::Instance(_)),
            Section::Rows => matches!(item.kind, ItemKind::Constraint(..)),
        }
    }

    /// The item behind which one of this section stands: that of its own kind, or of what stands before it.
    fn anchor(self, items: &[Item]) -> Option<&Item> {
        let last = |section: Section| items.iter().rfind(|item| section.holds(item));
        // Bodies in repetitions and settings of the mechanism come before what is drawn.
        let is_end = |item: &&Item| {
            !matches!(
                item.kind,
                ItemKind::Output(_) | ItemKind::Observe(_) | ItemKind::Instance(_) | ItemKind::Constraint(..)
            )
        };
        let things =
            || last(Section::Things).map(|of| with_points(items, of)).or_else(|| items.iter().rfind(is_end));
        // A joint is declared behind what it joins, wherever that stands.
        match self {
            Section::Things => things(),
            Section::Joints => last(Section::Joints).or_else(things),
            Section::Rows => last(Section::Rows).or_else(|| last(Section::Joints)).or_else(things),
        }
    }
}

/// The last of the names that follow a thing: points that were drawn after it.
fn with_points<'i>(items: &'i [Item], thing: &'i Item) -> &'i Item {
    let at = items.iter().position(|item| item.span == thing.span).unwrap_or_default();
    let points = items[at..].iter().skip(1).take_while(|item| matches!(item.kind, ItemKind::Let(..)));
    points.last().unwrap_or(thing)
}

/// New items, by section.
#[derive(Debug, Default)]
pub(crate) struct Insertion {
    lines: Vec<(Section, String)>,
}

impl Insertion {
    /// A line more.
    pub(crate) fn put(&mut self, section: Section, line: impl Into<String>) {
        self.lines.push((section, line.into()));
    }

    /// The edits that write the lines.
    pub(crate) fn edits(mut self, sheet: &Sheet<'_>) -> Result<Vec<Edit>, Refusal> {
        self.lines.sort_by_key(|(section, _)| *section);
        if sheet.mechanism().is_err() {
            return Ok(vec![self.first(sheet)?]);
        }
        let mut places: Vec<(Option<&Item>, Vec<String>)> = Vec::new();
        for (section, line) in self.lines {
            let anchor = section.anchor(sheet.items());
            let same =
                |(other, _): &&mut (Option<&Item>, _)| other.map(|of| of.span) == anchor.map(|of| of.span);
            match places.iter_mut().find(same) {
                Some((_, lines)) => lines.push(line),
                None => places.push((anchor, vec![line])),
            }
        }
        places.into_iter().map(|(anchor, lines)| behind(sheet, anchor, &lines)).collect()
    }

    /// A mechanism of the lines, in a text that has none.
    fn first(self, sheet: &Sheet<'_>) -> Result<Edit, Refusal> {
        // What is no comment is a text that cannot be read.
        if tokens(sheet.text).iter().any(|token| !token.kind.is_comment()) {
            return Err(Refusal::NoMechanism);
        }
        let items = self.lines.into_iter().map(|(_, line)| line);
        let items = std::iter::once("gravity: 9.81 m/s^2;".to_owned()).chain(items);
        let items = items.map(|line| format!("{:LEVEL$}{line}\n", "")).collect::<Vec<_>>().concat();
        let end = sheet.text.trim_end().len();
        let begin = if end == 0 { "" } else { "\n" };
        Ok(Edit::new(end..sheet.text.len(), format!("{begin}pub {FIRST} {{\n{items}}}\n")))
    }
}

/// The byte behind the bracket that opens the mechanism.
pub(crate) fn opening(sheet: &Sheet<'_>) -> Result<usize, Refusal> {
    let name = sheet.range(sheet.mechanism()?.name.span).end;
    let open = tokens(sheet.text.get(name..).unwrap_or_default());
    let open = open.iter().find(|token| token.is_mark(&sheet.text[name..], '{'));
    open.map(|token| name + token.range.end).ok_or(Refusal::NoMechanism)
}

/// The indentation of the line in which a byte stands.
pub(crate) fn indentation(text: &str, at: usize) -> usize {
    let line = text[..at].rfind('\n').map_or(0, |end| end + 1);
    text[line..].len() - text[line..].trim_start_matches(' ').len()
}

/// Lines behind an item, or behind the bracket that opens the mechanism.
fn behind(sheet: &Sheet<'_>, anchor: Option<&Item>, lines: &[String]) -> Result<Edit, Refusal> {
    let text = sheet.text;
    let open = opening(sheet)?;
    let outside = indentation(text, open);
    let indent = outside + LEVEL;
    let made = lines.iter().map(|line| format!("\n{:indent$}{line}", "")).collect::<Vec<_>>().concat();
    let at = anchor.map_or(open, |item| sheet.range(item.span).end);
    let rest = text.get(at..).unwrap_or_default();
    let line = rest.find('\n').map_or(rest, |end| &rest[..end]);
    let in_line = tokens(line);
    // A comment at the end of the line belongs to what stands there.
    let Some(next) = in_line.iter().find(|token| !token.kind.is_comment()) else {
        let end = at + line.trim_end().len();
        // A comment of several lines goes on.
        let end = if in_line.iter().any(|token| token.kind == Kind::Unclosed) { at } else { end };
        let needs_break = end == text.len() || text[end..].starts_with(['\n', '\r']);
        return Ok(Edit::insertion(end, if needs_break { made } else { made + "\n" }));
    };
    let closes = next.is_mark(line, '}');
    let blanks = at..at + next.range.start;
    let before = if closes { outside } else { indent };
    Ok(Edit::new(blanks, format!("{made}\n{:before$}", "")))
}

/// All words of a text, with those that were given since.
#[derive(Debug, Default)]
pub(crate) struct Words {
    taken: BTreeSet<String>,
}

impl Words {
    /// The words of a text.
    pub(crate) fn of(text: &str) -> Words {
        let all = tokens(text);
        let words = all.iter().filter(|token| token.kind == Kind::Word);
        Words { taken: words.map(|token| token.text(text).to_owned()).collect() }
    }

    /// Is it a word of the text?
    pub(crate) fn has(&self, word: &str) -> bool {
        self.taken.contains(word)
    }

    /// A name that nothing has: `bar1`, `bar2`.
    pub(crate) fn fresh(&mut self, stem: &str) -> String {
        let mut number = 1_usize;
        loop {
            let name = format!("{stem}{number}");
            if self.taken.insert(name.clone()) {
                return name;
            }
            number += 1;
        }
    }
}
