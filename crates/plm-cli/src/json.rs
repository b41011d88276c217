//! Diagnostics as JSON. Names of fields are those of rustc, so that tools which read its messages read these.

use plm_compiler::diag::{Diagnostic, Note, NoteKind, Severity};
use plm_compiler::span::Span;
use plm_compiler::token::Sources;
pub(crate) use plm_draw::as_declared;
use serde_json::{Value, json};

use crate::checked::{Checked, Declarations};

/// The diagnostics of a declaration, in the form of `plm check --json`; its name is that of a file, and files that it names are read
/// beside that.
pub fn diagnostics(name: &str, text: &str) -> Vec<Value> {
    let found = Declarations::new(name, text).checked().filter_map(Result::ok).collect::<Vec<_>>();
    let all = found.iter().flat_map(|Checked { sources, expansion }| {
        expansion.diagnostics.sorted().into_iter().map(|diagnostic| message(diagnostic, sources, text))
    });
    all.collect()
}

/// One diagnostic. `declared` is the text as it stands in its file.
pub(crate) fn message(diagnostic: &Diagnostic, sources: &Sources, declared: &str) -> Value {
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
    let spans: Vec<Value> = spans.into_iter().flatten().collect();
    let children: Vec<Value> = diagnostic.notes.iter().map(|note| texts.child(note, diagnostic)).collect();
    json!({
        "$message_type": "diagnostic",
        "level": level,
        "code": {
            "code": diagnostic.code.id(),
            "explanation": diagnostic.code.title(),
            "page": format!("diagnostics/{}.html", diagnostic.code),
        },
        "message": diagnostic.message,
        "spans": spans,
        "children": children,
        "rendered": diagnostic.render(sources),
    })
}

/// Texts that spans are ranges of.
struct Texts<'a> {
    sources: &'a Sources,
    declared: &'a str,
}

impl Texts<'_> {
    fn child(&self, note: &Note, of: &Diagnostic) -> Value {
        let level = match note.kind {
            NoteKind::Help => "help",
            NoteKind::Note => "note",
        };
        let place = note.span.or(note.replacement.as_ref().map(|_| of.span));
        let mut spans: Vec<Value> = place.and_then(|span| self.span(span, true, None)).into_iter().collect();
        if let (Some(text), Some(span)) = (&note.replacement, spans.first_mut()) {
            span["suggested_replacement"] = json!(text);
            span["suggestion_applicability"] = json!("MaybeIncorrect");
        }
        json!({
            "level": level, "code": null, "message": note.text, "spans": spans, "children": [], "rendered": null,
        })
    }

    /// Bytes count from 0; lines and columns, in characters, from 1. Ends are after the last byte and character.
    fn span(&self, span: Span, is_primary: bool, label: Option<&str>) -> Option<Value> {
        let source = self.sources.get(span.source)?;
        let (mut text, mut range) = (source.file()?, source.range(span)?);
        if span.source == 0 {
            range = as_declared(text, self.declared, range);
            text = self.declared;
        }
        let [first, last] = [range.start, range.end].map(|at| place(text, at));
        let lines = text.lines().enumerate().skip(first.0 - 1).take(last.0 - first.0 + 1);
        let lines = lines.map(|(index, line)| {
            let start = if index + 1 == first.0 { first.1 } else { 1 };
            let end = if index + 1 == last.0 { last.1 } else { line.chars().count() + 1 };
            json!({ "text": line, "highlight_start": start, "highlight_end": end })
        });
        Some(json!({
            "file_name": source.name,
            "byte_start": range.start,
            "byte_end": range.end,
            "line_start": first.0,
            "line_end": last.0,
            "column_start": first.1,
            "column_end": last.1,
            "is_primary": is_primary,
            "text": lines.collect::<Vec<Value>>(),
            "label": label,
            "suggested_replacement": null,
            "suggestion_applicability": null,
        }))
    }
}

/// Line and column of a byte, both from 1.
fn place(text: &str, at: usize) -> (usize, usize) {
    let before = text.get(..at).unwrap_or(text);
    let line = before.rfind('\n').map_or(0, |end| end + 1);
    (before.matches('\n').count() + 1, before[line..].chars().count() + 1)
}
