//! An open text: its declarations, their diagnostics and names.

use std::cell::OnceCell;
use std::ops::Range;

use plm_compiler::diag::{Diagnostic, NoteKind, Severity};
use plm_compiler::token::Sources;
use plm_compiler::{StartValue, without_panic};
use serde_json::{Value, json};

use super::names::Names;
use super::text;
use crate::checked::{Checked, checked};
use crate::excerpt::{Excerpt, excerpts};
use crate::json::as_declared;
use crate::read::LARGEST;

/// A declaration of a text.
pub(super) struct Declaration {
    pub(super) excerpt: Excerpt,
    pub(super) names: Names,
    /// Values at the start, when they are first asked for.
    values: OnceCell<Vec<StartValue>>,
}

/// A text that an editor has open.
pub(super) struct Document {
    pub(super) uri: String,
    /// Path of its file.
    pub(super) name: String,
    /// Its text; lines end as on Unix.
    pub(super) text: String,
    /// Its text as the editor has it.
    pub(super) original: String,
    pub(super) declarations: Vec<Declaration>,
    pub(super) problems: Vec<Problem>,
}

/// A diagnostic, as the protocol has it.
pub(super) struct Problem {
    pub(super) range: Range<usize>,
    pub(super) shown: Value,
    /// Titles and texts that answer it, in the place of its range.
    pub(super) replacements: Vec<(String, String)>,
}

impl Document {
    pub(super) fn new(uri: &str, original: String) -> Document {
        let (name, text) = (text::path(uri), original.replace("\r\n", "\n"));
        let is_small = text.len() as u64 <= LARGEST;
        let found = if is_small { excerpts(&name, &text).found } else { Vec::new() };
        let declaration = |excerpt: Excerpt| Declaration {
            names: without_panic(|| Names::new(&name, &text, &excerpt)).unwrap_or_default(),
            excerpt,
            values: OnceCell::new(),
        };
        let declarations = found.into_iter().map(declaration).collect();
        Document { uri: uri.to_owned(), name, text, original, declarations, problems: Vec::new() }
    }

    /// The declaration around a place.
    pub(super) fn declaration(&self, at: usize) -> Option<&Declaration> {
        self.declarations.iter().find(|of| of.excerpt.range.contains(&at) || of.excerpt.range.end == at)
    }

    /// Compiles all declarations; returns the diagnostics in the form of the protocol.
    pub(super) fn check(&mut self) -> Vec<Value> {
        let mut problems = Vec::new();
        for declaration in &self.declarations {
            let compiled = without_panic(|| {
                checked(&self.name, &self.text, declaration.excerpt.masked(&self.text).as_deref())
            });
            let Ok(Checked { sources, expansion }) = compiled else { continue };
            problems.extend(expansion.diagnostics.sorted().into_iter().map(|of| self.problem(of, &sources)));
        }
        self.problems = problems;
        self.problems.iter().map(|problem| problem.shown.clone()).collect()
    }

    /// Range in the text of a span of the declaration.
    fn range(&self, span: plm_compiler::span::Span, sources: &Sources) -> Option<Range<usize>> {
        let source = sources.get(span.source).filter(|_| span.source == 0)?;
        Some(as_declared(source.file()?, &self.text, source.range(span)?))
    }

    fn problem(&self, of: &Diagnostic, sources: &Sources) -> Problem {
        let range = self.range(of.anchor(), sources).unwrap_or_default();
        let place =
            |range: &Range<usize>| json!({ "uri": self.uri, "range": text::range(&self.text, range) });
        let mut message = of.message(sources, &|_| None);
        if of.severity == Severity::Error {
            // The code has a place of its own.
            message = message.split_once("] ").map_or(message.clone(), |(_, message)| message.to_owned());
        }
        let notes = of.notes.iter().filter_map(|note| {
            let range = self.range(note.span?, sources)?;
            Some(json!({ "location": place(&range), "message": note.text }))
        });
        let shown = json!({
            "range": text::range(&self.text, &range),
            "severity": if of.severity == Severity::Error { 1 } else { 2 },
            "code": of.code.id(),
            "source": "plm",
            "message": message,
            "relatedInformation": notes.collect::<Vec<Value>>(),
        });
        let is_here = of.anchor() == of.span;
        let helps = of.notes.iter().filter(|note| note.kind == NoteKind::Help && is_here);
        let replacements =
            helps.filter_map(|note| Some((note.text.clone(), note.replacement.clone()?))).collect();
        Problem { range, shown, replacements }
    }

    /// Values of a declaration at its start by full names; none where it has errors.
    pub(super) fn values<'a>(&self, declaration: &'a Declaration) -> &'a [StartValue] {
        declaration.values.get_or_init(|| {
            let lets = declaration.names.lets.iter().map(|name| format!("output {VALUE_OF}{name} = {name};"));
            let lets = lets.collect::<Vec<_>>().concat();
            // A `let` may be no quantity; then the others are shown.
            let tries = [format!("observe all;{lets}"), "observe all;".to_owned(), String::new()];
            tries.iter().find_map(|more| self.compiled_with(declaration, more)).unwrap_or_default()
        })
    }

    /// The values with further items at the end of a mechanism.
    fn compiled_with(&self, declaration: &Declaration, more: &str) -> Option<Vec<StartValue>> {
        let range = &declaration.excerpt.range;
        let end = range.start + self.text.get(range.clone())?.rfind('}')?;
        let insert = |text: &str| [&text[..end], more, &text[end..]].concat();
        let masked = declaration.excerpt.masked(&self.text).as_deref().map(insert);
        let compiled = without_panic(|| checked(&self.name, &insert(&self.text), masked.as_deref())).ok()?;
        let oracle = compiled.expansion.oracle?;
        without_panic(|| oracle.start_values()).ok()
    }
}

/// Begins the name of an output that shows a `let`.
pub(super) const VALUE_OF: &str = "plm_value_of_";
