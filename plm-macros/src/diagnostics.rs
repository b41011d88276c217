//! Diagnostics as tokens that rustc reports at the user's own source.

use plm_compiler::bug_message;
use plm_compiler::diag::{Code, Diagnostic, Severity};
use plm_compiler::token::Sources;
use proc_macro2::{Literal, Span, TokenStream};
use quote::{format_ident, quote, quote_spanned};

/// `compile_error!` for an error, the use of a deprecated macro for a warning.
pub(crate) fn tokens(diagnostic: &Diagnostic, sources: &Sources) -> TokenStream {
    let ends = sources.ends(diagnostic.anchor()).unwrap_or([Span::call_site(); 2]);
    let file = |span: Span| span.unwrap().file();
    let place_of = |span| {
        let [place, _] = sources.ends(span)?;
        let (line, column) = (place.unwrap().line(), place.unwrap().column());
        Some(if file(place) == file(ends[0]) {
            format!("line {line}, column {column}")
        } else {
            format!("{}:{line}:{column}", file(place))
        })
    };
    let text = diagnostic.message(sources, &place_of);
    match diagnostic.severity {
        Severity::Error => compile_error(&text, ends),
        Severity::Warning => deprecated_use(diagnostic.code, &text, ends[0]),
    }
}

/// A bug of the compiler.
pub(crate) fn bug(what: &str) -> TokenStream {
    compile_error(&bug_message(what), [Span::call_site(); 2])
}

/// A mistake that the compiler never sees: the form is wrong.
pub(crate) fn error(error: &syn::Error) -> TokenStream {
    compile_error(&format!("[{}] {error}", Code::UnexpectedToken), [error.span(); 2])
}

/// rustc underlines from the first token's span to the last's.
fn compile_error(text: &str, [first, last]: [Span; 2]) -> TokenStream {
    let mut text = Literal::string(text);
    text.set_span(last);
    let name = quote_spanned!(first=> ::core::compile_error!);
    quote_spanned!(last=> #name { #text })
}

/// A warning on stable Rust: the use, at the user's span, of a macro that is deprecated with the text as note. Its name says the
/// code and what it is about; of a constant or a function rustc would tell the path of the block that it stands in.
fn deprecated_use(code: Code, text: &str, at: Span) -> TokenStream {
    let name = format_ident!("{code}_{}", code.title().replace([' ', '-'], "_").replace(['\'', ','], ""));
    let used = {
        let mut used = name.clone();
        used.set_span(at);
        used
    };
    quote! {
        const _: () = {
            #[deprecated(note = #text)]
            macro_rules! #name { () => {}; }
            #used!();
        };
    }
}
