//! Diagnostics as JSON, each an object on a line of its own. Names of fields are those of rustc.

use std::fmt::Write;
use std::ops::Range;

use plm_compiler::diag::{Diagnostic, Note, NoteKind, Severity};
use plm_compiler::span::Span;
use plm_compiler::token::Sources;

/// One diagnostic, without the end of its line. `declared` is the declaration as it stands in its file.
pub(crate) fn line(diagnostic: &Diagnostic, sources: &Sources, declared: &str) -> String {
    let texts = Texts { sources, declared };
    let level = match diagnostic.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
    };
    let mut spans = vec![texts.span(diagnostic.anchor(), true, None)];
    if diagnostic.anchor() != diagnostic.span {
        spans.push(texts.span(diagnostic.span, false, None));
    }
    for of in &diagnostic.uses {
        let label = format!("the part `{}`, used as `{}`", of.part, of.instance);
        spans.push(texts.span(of.span, of.span == diagnostic.anchor(), Some(&label)));
    }
    let code = object(&[
        ("code", quoted(diagnostic.code.id())),
        ("explanation", quoted(diagnostic.code.title())),
        ("page", quoted(&format!("diagnostics/{}.html", diagnostic.code))),
    ]);
    let children: Vec<String> = diagnostic.notes.iter().map(|note| texts.child(note)).collect();
    object(&[
        ("$message_type", quoted("diagnostic")),
        ("level", quoted(level)),
        ("code", code),
        ("message", quoted(&diagnostic.message)),
        ("spans", list(&spans.into_iter().flatten().collect::<Vec<_>>())),
        ("children", list(&children)),
        ("rendered", quoted(&diagnostic.render(sources))),
    ])
}

/// What spans are ranges of.
struct Texts<'a> {
    sources: &'a Sources,
    declared: &'a str,
}

impl Texts<'_> {
    fn child(&self, note: &Note) -> String {
        let level = match note.kind {
            NoteKind::Help => "help",
            NoteKind::Note => "note",
        };
        let spans: Vec<String> = note.span.and_then(|span| self.span(span, true, None)).into_iter().collect();
        object(&[
            ("level", quoted(level)),
            ("code", "null".to_owned()),
            ("message", quoted(&note.text)),
            ("spans", list(&spans)),
            ("children", list(&[])),
            ("rendered", "null".to_owned()),
        ])
    }

    /// Bytes count from 0; lines and columns, in characters, from 1. Ends are behind the last byte and character.
    fn span(&self, span: Span, is_primary: bool, label: Option<&str>) -> Option<String> {
        let source = self.sources.get(span.source)?;
        let (mut text, mut range) = (source.whole(), source.range(span)?);
        if span.source == 0 {
            range = as_declared(&text, self.declared, range);
            self.declared.clone_into(&mut text);
        }
        let [first, last] = [range.start, range.end].map(|at| place(&text, at));
        let lines = text.lines().enumerate().skip(first.0 - 1).take(last.0 - first.0 + 1);
        let lines = lines.map(|(index, line)| {
            let start = if index + 1 == first.0 { first.1 } else { 1 };
            let end = if index + 1 == last.0 { last.1 } else { line.chars().count() + 1 };
            object(&[
                ("text", quoted(line)),
                ("highlight_start", start.to_string()),
                ("highlight_end", end.to_string()),
            ])
        });
        Some(object(&[
            ("file_name", quoted(&source.name)),
            ("byte_start", range.start.to_string()),
            ("byte_end", range.end.to_string()),
            ("line_start", first.0.to_string()),
            ("line_end", last.0.to_string()),
            ("column_start", first.1.to_string()),
            ("column_end", last.1.to_string()),
            ("is_primary", is_primary.to_string()),
            ("text", list(&lines.collect::<Vec<_>>())),
            ("label", label.map_or("null".to_owned(), quoted)),
        ]))
    }
}

/// The range in the text as declared of one in the text as read, which has brackets that were missing.
fn as_declared(read: &str, declared: &str, range: Range<usize>) -> Range<usize> {
    let place = |end: usize| {
        let mut rest = declared.chars().peekable();
        let mut bytes = 0;
        for letter in read.get(..end).unwrap_or(read).chars() {
            if rest.next_if_eq(&letter).is_some() {
                bytes += letter.len_utf8();
            }
        }
        bytes
    };
    place(range.start)..place(range.end)
}

/// Line and column of a byte.
fn place(text: &str, at: usize) -> (usize, usize) {
    let before = text.get(..at).unwrap_or(text);
    let line = before.rfind('\n').map_or(0, |end| end + 1);
    (before.matches('\n').count() + 1, before[line..].chars().count() + 1)
}

fn object(fields: &[(&str, String)]) -> String {
    let fields: Vec<String> =
        fields.iter().map(|(name, value)| format!("{}:{value}", quoted(name))).collect();
    format!("{{{}}}", fields.join(","))
}

fn list(values: &[String]) -> String {
    format!("[{}]", values.join(","))
}

/// A text in quotes of JSON.
fn quoted(text: &str) -> String {
    let mut quoted = "\"".to_owned();
    for letter in text.chars() {
        match letter {
            '"' | '\\' => quoted.extend(['\\', letter]),
            '\n' => quoted.push_str("\\n"),
            // Writing to a string does not fail.
            letter if letter < ' ' => drop(write!(quoted, "\\u{:04x}", u32::from(letter))),
            letter => quoted.push(letter),
        }
    }
    quoted + "\""
}
