//! A declaration with what the compiler says of it.

use plm_compiler::token::Sources;
use plm_compiler::{Expansion, bug_message, compile, without_panic};

use crate::excerpt::{Excerpt, Excerpts, excerpts};
use crate::read;

/// A declaration after its compilation.
#[derive(Debug)]
pub(crate) struct Checked {
    /// The declaration and the library files that it uses.
    pub(crate) sources: Sources,
    /// Code, diagnostics and report.
    pub(crate) expansion: Expansion,
}

/// Declarations of a file after their compilation.
#[derive(Debug, Default)]
pub(crate) struct Declarations {
    /// Those that could be compiled.
    pub(crate) checked: Vec<Checked>,
    /// Those that rustc alone can read: a message each.
    pub(crate) left_out: Vec<String>,
    /// Bugs of the compiler: a message each.
    pub(crate) bugs: Vec<String>,
}

/// Compiles all declarations of a text; its name says what it is, and where the files are that it names.
pub(crate) fn declarations(name: &str, text: &str) -> Declarations {
    let text = &text.replace("\r\n", "\n");
    let Excerpts { found, elsewhere } = excerpts(name, text);
    let mut declarations = Declarations::default();
    for excerpt in &found {
        match without_panic(|| checked(name, text, excerpt)) {
            Ok(checked) => declarations.checked.push(checked),
            Err(what) => declarations.bugs.push(format!("{name}: {}", bug_message(&what))),
        }
    }
    for (range, path) in elsewhere {
        let line = text[..range.start].matches('\n').count() + 1;
        declarations
            .left_out
            .push(format!("{name}:{line}: not checked: the parts of `use {path};` stand in another file"));
    }
    declarations
}

/// Compiles one declaration of a text, whose lines end as on Unix.
pub(crate) fn checked(name: &str, text: &str, excerpt: &Excerpt) -> Checked {
    let mut sources = Sources::new();
    match &excerpt.masked {
        Some(masked) => sources.add_excerpt(name, text, masked),
        None => sources.add_text(name, text),
    };
    for file in sources.named_files() {
        sources.add_file(&file, read::named(&file, name));
    }
    let expansion = compile(&mut sources);
    Checked { sources, expansion }
}
