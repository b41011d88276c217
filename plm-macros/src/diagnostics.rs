//! Diagnostics as tokens that rustc reports at the user's own source.

use plm_compiler::bug_message;
use plm_compiler::diag::{Code, Diagnostic, Severity};
use plm_compiler::token::Sources;
use proc_macro::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};

/// `compile_error!` for an error, the use of a deprecated constant for a warning.
pub(crate) fn tokens(diagnostic: &Diagnostic, sources: &Sources, spans: &[Span]) -> TokenStream {
    let anchor = diagnostic.anchor();
    let at = |token: u32| spans.get(token as usize).copied().unwrap_or_else(Span::call_site);
    let (first, last) = (at(anchor.first), at(anchor.last));
    let place_of = |span: plm_compiler::span::Span| {
        let place = spans.get(span.first as usize).filter(|_| span.source == 0)?;
        let (line, column) = (place.line(), place.column());
        Some(if place.file() == first.file() {
            format!("line {line}, column {column}")
        } else {
            format!("{}:{line}:{column}", place.file())
        })
    };
    let text = diagnostic.message(sources, &place_of);
    match diagnostic.severity {
        Severity::Error => compile_error(&text, first, last),
        Severity::Warning => {
            deprecated_use(&format!("{}_{:?}", diagnostic.code, diagnostic.code), &text, first)
        }
    }
}

/// A bug of the compiler.
pub(crate) fn bug(what: &str) -> TokenStream {
    compile_error(&bug_message(what), Span::call_site(), Span::call_site())
}

/// A mistake that the compiler never sees: the form is wrong.
pub(crate) fn error(text: &str, span: Span) -> TokenStream {
    compile_error(&format!("[{}] {text}", Code::UnexpectedToken), span, span)
}

/// `::core::compile_error! { text }`; rustc underlines from the first token's span to the last's.
fn compile_error(text: &str, first: Span, last: Span) -> TokenStream {
    let mut literal = Literal::string(text);
    literal.set_span(last);
    let mut group = Group::new(Delimiter::Brace, TokenTree::Literal(literal).into());
    group.set_span(last);
    let mark = |character, spacing| {
        let mut mark = Punct::new(character, spacing);
        mark.set_span(first);
        TokenTree::Punct(mark)
    };
    [
        mark(':', Spacing::Joint),
        mark(':', Spacing::Alone),
        TokenTree::Ident(Ident::new("core", first)),
        mark(':', Spacing::Joint),
        mark(':', Spacing::Alone),
        TokenTree::Ident(Ident::new("compile_error", first)),
        mark('!', Spacing::Alone),
        TokenTree::Group(group),
    ]
    .into_iter()
    .collect()
}

/// A warning on stable Rust: the use, at the user's span, of a constant that is deprecated with the text as note.
fn deprecated_use(constant: &str, text: &str, at: Span) -> TokenStream {
    let declaration = format!(
        "#[deprecated(note = {text:?})] #[allow(non_upper_case_globals, dead_code)] const {constant}: () = ();"
    );
    let mut body: TokenStream = declaration.parse().unwrap_or_default();
    body.extend("#[warn(deprecated)] let _ = ".parse::<TokenStream>().unwrap_or_default());
    body.extend([
        TokenTree::Ident(Ident::new(constant, at)),
        TokenTree::Punct(Punct::new(';', Spacing::Alone)),
    ]);
    let mut item: TokenStream = "const _: () = ".parse().unwrap_or_default();
    item.extend([
        TokenTree::Group(Group::new(Delimiter::Brace, body)),
        TokenTree::Punct(Punct::new(';', Spacing::Alone)),
    ]);
    item
}
