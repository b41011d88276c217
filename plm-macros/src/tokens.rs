//! Emitted source as tokens, its names where the user wrote them.

use std::collections::BTreeMap;

use plm_compiler::Code;
use plm_compiler::token::Sources;
use proc_macro::LexError;
use proc_macro2::{Delimiter, Group, Span, TokenStream, TokenTree};

/// Emitted source as tokens. Identifiers of its public part get the spans of their declarations, so that an editor
/// finds them; what stands behind is long and is not walked.
pub(crate) fn code(code: &Code, sources: &Sources) -> Result<TokenStream, LexError> {
    let places: BTreeMap<&str, Span> = code
        .names
        .iter()
        .filter_map(|(name, span)| Some((name.as_str(), sources.ends(*span)?[0])))
        .map(|(name, span)| (name, span.resolved_at(Span::call_site())))
        .collect();
    let mut output = respan(lexed(&code.before)?, &places, 1);
    let mut inner = respan(lexed(&code.public)?, &places, 2);
    inner.extend(lexed(&code.implementation)?);
    let mut content = respan(lexed(&code.face)?, &places, 2);
    content.extend(lexed(&code.inner)?);
    content.extend(braces(inner));
    output.extend(lexed(&code.module)?);
    output.extend(braces(content));
    Ok(output)
}

/// Tokens of rustc's lexer. proc-macro2 would read the text with its own before, for mistakes that rustc does not forgive:
/// 0.1 s for a chain of 64 bars.
fn lexed(text: &str) -> Result<TokenStream, LexError> {
    text.parse::<proc_macro::TokenStream>().map(TokenStream::from)
}

fn braces(content: TokenStream) -> [TokenTree; 1] {
    [TokenTree::Group(Group::new(Delimiter::Brace, content))]
}

fn respan(code: TokenStream, places: &BTreeMap<&str, Span>, depth: usize) -> TokenStream {
    let respan = |tree| match tree {
        // The identifier stays what it is, raw or not; what is made anew from text would have to know.
        TokenTree::Ident(mut ident) => {
            if let Some(&span) = places.get(ident.to_string().as_str()) {
                ident.set_span(span);
            }
            TokenTree::Ident(ident)
        }
        TokenTree::Group(group) if depth > 0 => {
            let mut inner = Group::new(group.delimiter(), respan(group.stream(), places, depth - 1));
            inner.set_span(group.span());
            TokenTree::Group(inner)
        }
        other => other,
    };
    code.into_iter().map(respan).collect()
}
