//! Diagnostics as text: with the line and carets where there is text, as lines of one message where rustc shows the
//! place by itself.

use crate::collect::CollectVec;
use std::fmt::Write;

use super::{Diagnostic, Note, NoteKind, Severity};
use crate::span::Span;
use crate::token::Sources;

/// Says where a span is, if the caller of the compiler knows better than its sources.
type PlaceOf<'a> = &'a dyn Fn(Span) -> Option<String>;

impl Diagnostic {
    /// The whole message as rustc would set it, with the line and carets.
    pub fn render(&self, sources: &Sources) -> String {
        let severity = match self.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
        };
        let mut text = format!("{severity}[{}]: {}\n", self.code, self.message);
        text.push_str(&quote(self.span, sources));
        for note in self.all_notes(sources, &|_| None) {
            let _ = writeln!(text, "  = {note}");
        }
        text
    }

    /// The message for a span of rustc at [`Diagnostic::anchor`]: help and notes are lines of it. A mistake inside a
    /// library part is quoted with its line. `place_of` tells where a span of the declaration is; a warning goes without
    /// its code, which rustc shows as the name of a constant.
    pub fn message(&self, sources: &Sources, place_of: PlaceOf) -> String {
        let mut text = match self.severity {
            Severity::Error => format!("[{}] {}", self.code, self.message),
            Severity::Warning => self.message.clone(),
        };
        if self.span != self.anchor() {
            let quoted = quote(self.span, sources);
            if !quoted.is_empty() {
                let _ = write!(text, "\n{}", quoted.trim_end());
            }
        }
        for note in self.all_notes(sources, place_of) {
            let _ = write!(text, "\n= {note}");
        }
        text
    }

    fn all_notes(&self, sources: &Sources, place_of: PlaceOf) -> Vec<String> {
        let place = |span| place(span, sources).or_else(|| place_of(span));
        let mut lines: Vec<String> =
            self.notes.iter().map(|note| note_line(note, note.span.and_then(place))).collect_vec();
        for of in self.uses.iter().rev() {
            let at = place(of.span).map_or(String::new(), |place| format!(" at {place}"));
            lines.push(format!("note: in the part `{}`, used as `{}`{at}", of.part, of.instance));
        }
        lines
    }
}

/// A note; if it speaks of a place, its ` here` becomes that place.
fn note_line(note: &Note, place: Option<String>) -> String {
    let kind = match note.kind {
        NoteKind::Help => "help",
        NoteKind::Note => "note",
    };
    match place {
        Some(place) => format!("{kind}: {} at {place}", note.text.trim_end_matches(" here")),
        None => format!("{kind}: {}", note.text),
    }
}

/// `revolute.plm:12:5`; `None` where the text is not known.
fn place(span: Span, sources: &Sources) -> Option<String> {
    let source = sources.get(span.source)?;
    let (place, _) = source.place(span)?;
    Some(format!("{}:{}:{}", source.name, place.line, place.column))
}

/// The place, the line and the carets.
fn quote(span: Span, sources: &Sources) -> String {
    let Some(source) = sources.get(span.source) else { return String::new() };
    let (Some((place, line)), Some(quoted)) = (source.place(span), source.text(span)) else {
        return String::new();
    };
    let number = place.line.to_string();
    let margin = " ".repeat(number.len());
    let indent = " ".repeat(place.column - 1);
    let left = line.chars().count().saturating_sub(place.column - 1);
    let carets = "^".repeat(quoted.chars().count().min(left).max(1));
    format!(
        "{margin}--> {}:{}:{}\n{margin} |\n{number} | {line}\n{margin} | {indent}{carets}\n",
        source.name, place.line, place.column
    )
}
