//! The `mechanism!` and `parts!` macros: a shim between rustc's tokens and the compiler's.
//!
//! Everything that can be tested without rustc stands in `plm-compiler`; use this crate through `plm`.

mod diagnostics;
mod files;
mod sharing;
mod tokens;

use plm_compiler::token::Sources;
use plm_compiler::{Code, Expansion, compile, names_only, without_panic};
use proc_macro::{Span, TokenStream};

/// Declares a planar mechanism; the language is described in the documentation of `plm`.
#[proc_macro]
pub fn mechanism(input: TokenStream) -> TokenStream {
    if let Some(call) = sharing::carried(&input) {
        return call;
    }
    let (tokens, spans) = tokens::flatten(input);
    let mut sources = Sources::new();
    sources.add_tokens("declaration", tokens);
    sources.add_places(spans.iter().map(|span| (*span).into()).collect());
    files::read(&mut sources);
    match without_panic(|| compile(&mut sources)) {
        Ok(expansion) => emit(&expansion, &sources, &spans),
        Err(what) => {
            let mut output = diagnostics::bug(&what);
            let names = without_panic(|| names_only(&mut sources)).ok().flatten();
            output.extend(names.and_then(|code| code.tokens().ok()).map(TokenStream::from));
            output
        }
    }
}

/// Names parts that several mechanisms share: `parts! { pub valves { joint … part … } }`, then
/// `mechanism! { use valves; pub Press { … } }`, in this crate or, by its path, in another.
#[proc_macro]
pub fn parts(input: TokenStream) -> TokenStream {
    sharing::shared(input).unwrap_or_else(|(span, expected)| diagnostics::error(expected, span))
}

/// Code and diagnostics as tokens of rustc.
fn emit(expansion: &Expansion, sources: &Sources, spans: &[Span]) -> TokenStream {
    let mut output = TokenStream::new();
    for diagnostic in expansion.diagnostics.sorted() {
        output.extend(diagnostics::tokens(diagnostic, sources, spans));
    }
    match expansion.code.as_ref().map(Code::tokens) {
        Some(Ok(code)) => output.extend(TokenStream::from(code)),
        Some(Err(error)) => {
            output.extend(diagnostics::bug(&format!("the emitted code does not lex: {error}")));
        }
        None => {}
    }
    output
}
