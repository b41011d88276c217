//! Diagnostics as text: with the line and carets where there is text, as lines of one message where rustc shows the
//! place by itself.

use std::fmt::Write;

use super::{Diagnostic, Note, NoteKind, Severity};
use crate::span::Span;
use crate::token::Sources;

impl Diagnostic {
    /// The whole message as rustc would set it, with the line and carets.
    pub fn render(&self, sources: &Sources) -> String {
        let severity = match self.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
        };
        let mut text = format!("{severity}[{}]: {}\n", self.code, self.message);
        text.push_str(&quote(self.span, sources));
        for note in self.all_notes(sources) {
            let _ = writeln!(text, "  = {note}");
        }
        text
    }

    /// The message for a span of rustc at [`Diagnostic::anchor`]: the code, the message, help and notes as lines; a
    /// mistake inside a library part is quoted with its line.
    pub fn message(&self, sources: &Sources) -> String {
        let mut text = format!("[{}] {}", self.code, self.message);
        if self.span != self.anchor() {
            let quoted = quote(self.span, sources);
            if !quoted.is_empty() {
                let _ = write!(text, "\n{}", quoted.trim_end());
            }
        }
        for note in self.all_notes(sources) {
            let _ = write!(text, "\n= {note}");
        }
        text
    }

    fn all_notes(&self, sources: &Sources) -> Vec<String> {
        let mut lines: Vec<String> = self.notes.iter().map(|note| note_line(note, sources)).collect();
        for of in self.uses.iter().rev() {
            let place = place(of.span, sources);
            lines.push(format!("note: in the part `{}`, used as `{}`{place}", of.part, of.instance));
        }
        lines
    }
}

fn note_line(note: &Note, sources: &Sources) -> String {
    let kind = match note.kind {
        NoteKind::Help => "help",
        NoteKind::Note => "note",
    };
    let place = note.span.map_or(String::new(), |span| place(span, sources));
    format!("{kind}: {}{place}", note.text)
}

/// ` (revolute.plm:12:5)`; empty where the text is not known.
fn place(span: Span, sources: &Sources) -> String {
    let Some(source) = sources.get(span.source) else { return String::new() };
    let Some((place, _)) = source.place(span) else { return String::new() };
    format!(" ({}:{}:{})", source.name, place.line, place.column)
}

/// The place, the line and the carets.
fn quote(span: Span, sources: &Sources) -> String {
    let Some(source) = sources.get(span.source) else { return String::new() };
    let (Some((place, line)), Some((start, end))) = (source.place(span), source.range(span)) else {
        return String::new();
    };
    let number = place.line.to_string();
    let margin = " ".repeat(number.len());
    let indent = " ".repeat(place.column - 1);
    let left = line.chars().count().saturating_sub(place.column - 1);
    let quoted = source.text.as_ref().and_then(|text| text.text.get(start..end)).unwrap_or("");
    let carets = "^".repeat(quoted.chars().count().min(left).max(1));
    format!(
        "{margin}--> {}:{}:{}\n{margin} |\n{number} | {line}\n{margin} | {indent}{carets}\n",
        source.name, place.line, place.column
    )
}
