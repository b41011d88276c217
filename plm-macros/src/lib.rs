//! The `mechanism!` and `parts!` macros: a shim between rustc's tokens and the compiler's.
//!
//! Everything that can be tested without rustc stands in `plm-compiler`; use this crate through `plm`.

mod diagnostics;
mod sharing;
mod tokens;

use std::panic::{AssertUnwindSafe, catch_unwind};

use plm_compiler::{Expansion, compile};
use plm_compiler::token::Sources;
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
    // A panic is a bug in plm, never the user's mistake; it must not look like one of rustc.
    match catch_unwind(AssertUnwindSafe(|| compile(&mut sources))) {
        Ok(expansion) => emit(&expansion, &sources, &spans),
        Err(panic) => diagnostics::bug(&panic_text(panic.as_ref())),
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
    match expansion.code.as_ref().map(|code| tokens::code(code, spans)) {
        Some(Ok(code)) => output.extend(code),
        Some(Err(error)) => output.extend(diagnostics::bug(&format!("the emitted code does not lex: {error}"))),
        None => {}
    }
    output
}

fn panic_text(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("no message").to_owned()
}
