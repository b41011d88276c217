//! The `mechanism!` and `parts!` macros: a shim between rustc and the compiler.
//!
//! Everything that can be tested without rustc stands in `plm-compiler`; use this crate through `plm`.

mod diagnostics;
mod files;
mod sharing;

use plm_compiler::token::{Sources, shallow};
use plm_compiler::{Code, Expansion, compile, names_only, without_panic};
use proc_macro2::TokenStream;
use syn::parse::Parser;

/// Declares a planar mechanism; the language is described in the documentation of `plm`.
#[proc_macro]
pub fn mechanism(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    let input = shallow(input.into());
    sharing::carried(&input).unwrap_or_else(|| expanded(input)).into()
}

/// Names parts that several mechanisms share: `parts! { pub valves { joint … part … } }`, then
/// `mechanism! { use valves; pub Press { … } }`, in this crate or, by its path, in another.
#[proc_macro]
pub fn parts(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    sharing::shared.parse2(shallow(input.into())).unwrap_or_else(|error| diagnostics::error(&error)).into()
}

fn expanded(input: TokenStream) -> TokenStream {
    let mut sources = Sources::new();
    sources.add_tokens("declaration", input);
    files::read(&mut sources);
    match without_panic(|| compile(&mut sources)) {
        Ok(expansion) => emit(&expansion, &sources),
        Err(what) => {
            let mut output = diagnostics::bug(&what);
            let names = without_panic(|| names_only(&mut sources)).ok().flatten();
            output.extend(names.and_then(|code| code.tokens(lexed).ok()));
            output
        }
    }
}

/// Code and diagnostics as tokens of rustc.
fn emit(expansion: &Expansion, sources: &Sources) -> TokenStream {
    let sorted = expansion.diagnostics.sorted();
    let mut output: TokenStream =
        sorted.into_iter().map(|diagnostic| diagnostics::tokens(diagnostic, sources)).collect();
    match expansion.code.as_ref().map(|code| Code::tokens(code, lexed)) {
        Some(Ok(code)) => output.extend(code),
        Some(Err(error)) => {
            output.extend(diagnostics::bug(&format!("the emitted code does not lex: {error}")));
        }
        None => {}
    }
    output
}

/// Tokens of rustc's lexer. proc-macro2 would read the text with its own before, for mistakes that rustc does not forgive:
/// 0.1 s for a chain of 64 bars.
fn lexed(text: &str) -> Result<TokenStream, proc_macro::LexError> {
    text.parse::<proc_macro::TokenStream>().map(TokenStream::from)
}
