//! Diagnostics: what is wrong, where, and what to do about it.
//!
//! Every pass reports to one [`Diagnostics`] and goes on where it can, so that one compilation shows all mistakes.
//! Messages are lower case without a full stop, quote the language in backticks, and say both what was found and what
//! was expected.

mod code;
mod render;
mod suggestions;

use crate::collect::CollectVec;
use crate::sorted::sort_by_key;
use crate::sorted::{SortedMap, SortedSet};

pub use code::Code;
pub use suggestions::{help_similar, list, nearest};

use crate::span::Span;

/// Does it stop the compilation?
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// Yes.
    Error,
    /// No.
    Warning,
}

/// Kind of a line below the message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoteKind {
    /// Advice.
    Help,
    /// Explanation.
    Note,
}

/// A line below the message.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// Help or note.
    pub kind: NoteKind,
    /// Its text.
    pub text: String,
    /// The place that it speaks of, if there is one.
    pub span: Option<Span>,
    /// Text that follows the advice where it is put in the place of the diagnostic's span.
    pub replacement: Option<String>,
}

/// One mistake.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Its entry in the catalogue.
    pub code: Code,
    /// Error or warning.
    pub severity: Severity,
    /// The smallest range of tokens that is to blame.
    pub span: Span,
    /// The message.
    pub message: String,
    /// Help and notes, in order.
    pub notes: Vec<Note>,
    /// If it stands inside a part: the uses that lead there, from the declaration inwards.
    pub uses: Vec<Use>,
}

/// The use of a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Use {
    /// Span of the name of the instance.
    pub span: Span,
    /// Name of the instance.
    pub instance: String,
    /// Name of the part's definition.
    pub part: String,
}

impl Diagnostic {
    /// Adds a line of help.
    pub fn help(&mut self, text: impl Into<String>) -> &mut Diagnostic {
        self.push(NoteKind::Help, text.into(), None)
    }

    /// Adds a line of help, with the text that would stand right in the place of the span.
    pub fn help_with(&mut self, text: impl Into<String>, replacement: impl Into<String>) -> &mut Diagnostic {
        let (kind, text, replacement) = (NoteKind::Help, text.into(), Some(replacement.into()));
        self.notes.push(Note { kind, text, span: None, replacement });
        self
    }

    /// Adds a note.
    pub fn note(&mut self, text: impl Into<String>) -> &mut Diagnostic {
        self.push(NoteKind::Note, text.into(), None)
    }

    /// Adds a note that speaks of a place.
    pub fn note_at(&mut self, span: Span, text: impl Into<String>) -> &mut Diagnostic {
        self.push(NoteKind::Note, text.into(), Some(span))
    }

    fn push(&mut self, kind: NoteKind, text: String, span: Option<Span>) -> &mut Diagnostic {
        self.notes.push(Note { kind, text, span, replacement: None });
        self
    }

    /// Span in the declaration at which it is shown: its own, else that of the innermost use that leads to it.
    pub fn anchor(&self) -> Span {
        let of_declaration = |span: &Span| span.source == 0;
        let uses = self.uses.iter().rev().map(|of| of.span);
        std::iter::once(self.span).chain(uses).find(of_declaration).unwrap_or(Span {
            source: 0,
            first: 0,
            last: 0,
        })
    }
}

/// Of one code so many are shown; of the others their number. Nobody reads more, and rustc takes a tenth of a millisecond for
/// each.
const MOST_OF_A_CODE: usize = 100;

/// The sink that every pass reports to.
#[derive(Debug, Default)]
pub struct Diagnostics {
    list: Vec<Diagnostic>,
    seen: SortedSet<(Code, Span, String)>,
    /// How often each code was reported, at different places.
    counts: SortedMap<Code, usize>,
    /// Last diagnostic that is not shown, to which callers may still add help: a repetition, or one beyond the limit of its code. A mistake
    /// in a part that is used 64 times is reported once.
    unshown: Option<Diagnostic>,
}

impl Diagnostics {
    /// Nothing is wrong yet.
    pub fn new() -> Diagnostics {
        Diagnostics::default()
    }

    /// Reports an error; add help and notes to what comes back.
    pub fn error(&mut self, code: Code, span: Span, message: impl Into<String>) -> &mut Diagnostic {
        self.report(code, Severity::Error, span, message.into())
    }

    /// Reports a warning; add help and notes to what comes back.
    pub fn warning(&mut self, code: Code, span: Span, message: impl Into<String>) -> &mut Diagnostic {
        self.report(code, Severity::Warning, span, message.into())
    }

    fn report(&mut self, code: Code, severity: Severity, span: Span, message: String) -> &mut Diagnostic {
        let is_new = self.seen.insert((code, span, message.clone()));
        let diagnostic = Diagnostic { code, severity, span, message, notes: Vec::new(), uses: Vec::new() };
        if !is_new {
            return self.unshown.insert(diagnostic);
        }
        let count = self.counts.or_insert(code, 0);
        *count += 1;
        if *count > MOST_OF_A_CODE {
            return self.unshown.insert(diagnostic);
        }
        self.list.push(diagnostic);
        let last = self.list.len() - 1;
        &mut self.list[last]
    }

    /// Are more of a code shown? Else nobody reads the help, which may take long to find.
    pub fn shows(&self, code: Code) -> bool {
        self.counts.get(&code).is_none_or(|count| *count < MOST_OF_A_CODE)
    }

    /// Says, at the last that is shown of each code, how many there are beyond: when all are reported.
    pub fn count_unshown(&mut self) {
        for (code, count) in std::mem::take(&mut self.counts) {
            let last = self.list.iter_mut().rfind(|diagnostic| diagnostic.code == code);
            if let Some(last) = last.filter(|_| count > MOST_OF_A_CODE) {
                last.note(format!(
                    "{code} stands for {} places more, which are not shown",
                    count - MOST_OF_A_CODE
                ));
            }
        }
    }

    /// Is there an error (not only warnings)?
    pub fn has_errors(&self) -> bool {
        self.list.iter().any(|diagnostic| diagnostic.severity == Severity::Error)
    }

    /// All of them, in the order of discovery.
    pub fn iter(&self) -> impl Iterator<Item = &Diagnostic> {
        self.list.iter()
    }

    /// Drops the warnings whose codes the declaration allows.
    pub fn allow(&mut self, codes: &[String]) {
        self.list.retain(|diagnostic| {
            diagnostic.severity == Severity::Error || !codes.iter().any(|code| code == diagnostic.code.id())
        });
    }

    /// Drops the hints: they wait until there is no error.
    pub fn drop_hints(&mut self) {
        self.list.retain(|diagnostic| !diagnostic.code.is_hint());
    }

    /// All of them, by source and place: the order in which people read.
    pub fn sorted(&self) -> Vec<&Diagnostic> {
        let mut list: Vec<_> = self.list.iter().collect_vec();
        sort_by_key(&mut list, |diagnostic| (diagnostic.anchor(), diagnostic.span));
        list
    }
}
