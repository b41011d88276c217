//! A declaration with what the compiler says of it.

use plm_compiler::diag::Diagnostics;
use plm_compiler::span::Span;
use plm_compiler::syntax::parse;
use plm_compiler::token::Sources;
use plm_compiler::{Expansion, analyse, bug_message, compile, without_panic};
use plm_import::Place;

use crate::excerpt::{Excerpt, Excerpts, excerpts};
use crate::read;

/// A declaration after its compilation.
#[derive(Debug)]
pub(crate) struct Checked {
    /// The declaration and the library files that it uses.
    pub(crate) sources: Sources,
    /// Code where it was asked for, diagnostics and report.
    pub(crate) expansion: Expansion,
}

/// The place of a span of a declaration.
pub(crate) fn place(sources: &Sources, span: Span) -> Place {
    let source = sources.get(span.source);
    let at = source.and_then(|source| source.place(span)).map(|(at, _)| at);
    let [line, column] =
        at.map_or([1; 2], |at| [at.line, at.column].map(|count| u32::try_from(count).unwrap_or(u32::MAX)));
    Place { file: source.map_or("", |source| source.name.as_str()).into(), line, column }
}

/// Declarations of a file.
#[derive(Debug)]
pub(crate) struct Declarations {
    name: String,
    /// Its text; lines end as on Unix.
    text: String,
    found: Vec<Excerpt>,
    /// Those that are not compiled: a message each.
    pub(crate) left_out: Vec<String>,
}

impl Declarations {
    /// The declarations of a text; its name says what it is, and where the files are that it names.
    pub(crate) fn new(name: &str, text: &str) -> Declarations {
        let text = text.replace("\r\n", "\n");
        let Excerpts { found, left_out } = excerpts(name, &text);
        let message = |(at, why): (usize, String)| {
            format!("{name}:{}: not checked: {why}", text[..at].matches('\n').count() + 1)
        };
        let left_out = left_out.into_iter().map(message).collect();
        Declarations { name: name.to_owned(), text, found, left_out }
    }

    /// Has the file none?
    pub(crate) fn is_empty(&self) -> bool {
        self.found.is_empty() && self.left_out.is_empty()
    }

    /// Analyses the declarations one after the other, without their code; a bug of the compiler is a message.
    pub(crate) fn checked(&self) -> impl Iterator<Item = Result<Checked, String>> {
        self.expanded_by(analyse)
    }

    /// Compiles the declarations one after the other; a bug of the compiler is a message.
    pub(crate) fn compiled(&self) -> impl Iterator<Item = Result<Checked, String>> {
        self.expanded_by(compile)
    }

    /// Text and analysis of the declaration with this name, or of the only one; nothing where the file has none.
    ///
    /// # Errors
    /// The file has several, or none of this name: a message with their names. A bug of the compiler.
    pub(crate) fn named(&self, name: Option<&str>) -> Result<Option<(String, Checked)>, String> {
        let names: Vec<String> = self.found.iter().map(|excerpt| self.name_of(excerpt)).collect();
        let wanted = |known: &String| name.is_none_or(|name| known == name);
        let mut found = (0..names.len()).filter(|k| wanted(&names[*k]));
        match (found.next(), found.next(), names.is_empty()) {
            (Some(only), None, _) => {
                let excerpt = &self.found[only];
                Ok(Some((excerpt.own_text(&self.text), self.expanded(analyse, excerpt)?)))
            }
            (None, _, true) => Ok(None),
            (None, ..) => {
                let name = name.unwrap_or_default();
                Err(format!("{}: there is no `{name}` in it: {}", self.name, names.join(", ")))
            }
            _ => Err(format!("{}: `--name` says which of these: {}", self.name, names.join(", "))),
        }
    }

    /// The name of the mechanism of a declaration; empty where it has none.
    fn name_of(&self, excerpt: &Excerpt) -> String {
        let mut sources = Sources::new();
        let at = sources.add_text(&self.name, &excerpt.own_text(&self.text));
        let read = sources.get(at).map(|source| parse(source, &mut Diagnostics::new()));
        let mechanism = read.and_then(|declaration| declaration.mechanism);
        mechanism.map_or(String::new(), |mechanism| mechanism.name.text)
    }

    fn expanded_by(&self, compile: Compile) -> impl Iterator<Item = Result<Checked, String>> {
        self.found.iter().map(move |excerpt| self.expanded(compile, excerpt))
    }

    fn expanded(&self, compile: Compile, excerpt: &Excerpt) -> Result<Checked, String> {
        let masked = excerpt.masked(&self.text);
        let compiled = without_panic(|| expanded(compile, &self.name, &self.text, masked.as_deref()));
        compiled.map_err(|what| format!("{}: {}", self.name, bug_message(&what)))
    }
}

/// `compile` or `analyse` of the compiler.
type Compile = fn(&mut Sources) -> Expansion;

/// Analyses one declaration of a text, whose lines end as on Unix; `masked` is that of its excerpt.
pub(crate) fn checked(name: &str, text: &str, masked: Option<&str>) -> Checked {
    expanded(analyse, name, text, masked)
}

fn expanded(compile: Compile, name: &str, text: &str, masked: Option<&str>) -> Checked {
    let mut sources = Sources::new();
    match masked {
        Some(masked) => sources.add_excerpt(name, text, masked),
        None => sources.add_text(name, text),
    };
    for file in sources.named_files() {
        sources.add_file(&file, read::named(&file, name));
    }
    let expansion = compile(&mut sources);
    Checked { sources, expansion }
}
