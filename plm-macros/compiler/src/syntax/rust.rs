//! Syntax of Rust in a declaration: paths, visibilities and attributes, as their tokens.
//!
//! syn has them too, among the types of all that `derive` macros read, which take longer to build than the rest of it.

use proc_macro2::{Delimiter, Group, Ident, Punct, TokenStream, TokenTree};
use quote::quote_spanned;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser, Result};
use syn::{Token, token};

/// A path without arguments: `a::b`, `crate::c`, `::d`.
///
/// # Errors
/// No path stands here.
pub fn path(input: ParseStream) -> Result<TokenStream> {
    let mut path = TokenStream::new();
    loop {
        if let Some(colons) = input.parse::<Option<Token![::]>>()? {
            path.extend(quote_spanned!(colons.spans[0]=> ::));
        } else if !path.is_empty() {
            return Ok(path);
        }
        path.extend([TokenTree::from(segment(input)?)]);
    }
}

fn segment(input: ParseStream) -> Result<Ident> {
    let is_keyword = input.peek(Token![crate])
        || input.peek(Token![self])
        || input.peek(Token![Self])
        || input.peek(Token![super]);
    if is_keyword { input.call(Ident::parse_any) } else { input.parse() }
}

/// `pub`, `pub(crate)`, `pub(in path)`; empty where none stands.
///
/// # Errors
/// No path stands after `in`.
pub fn visibility(input: ParseStream) -> Result<TokenStream> {
    let mut visibility = TokenStream::new();
    // What `$visible:vis` of a macro leaves where it has found none.
    if input.cursor().group(Delimiter::None).is_some_and(|(inside, ..)| inside.eof()) {
        input.parse::<TokenTree>()?;
    }
    if input.peek(Token![pub]) {
        visibility.extend([TokenTree::from(input.call(Ident::parse_any)?)]);
        visibility.extend(restriction(input)?.map(TokenTree::from));
    }
    Ok(visibility)
}

/// The brackets after `pub`, unless they belong to what follows.
fn restriction(input: ParseStream) -> Result<Option<Group>> {
    let Some((inside, ..)) = input.cursor().group(Delimiter::Parenthesis) else { return Ok(None) };
    let Some((word, after)) = inside.ident() else { return Ok(None) };
    if word == "in" {
        let brackets: Group = input.parse()?;
        let inside = |input: ParseStream| input.parse::<Token![in]>().and_then(|_| path(input));
        inside.parse2(brackets.stream())?;
        return Ok(Some(brackets));
    }
    let is_alone = after.eof() && ["crate", "self", "super"].iter().any(|known| word == known);
    if is_alone { input.parse().map(Some) } else { Ok(None) }
}

/// All `#[…]` that stand here. rustc looks at what they hold.
///
/// # Errors
/// After `#` stand no brackets.
pub fn attributes(input: ParseStream) -> Result<TokenStream> {
    let mut attributes = TokenStream::new();
    while input.peek(Token![#]) {
        attributes.extend([TokenTree::from(input.parse::<Punct>()?)]);
        if !input.peek(token::Bracket) {
            return Err(input.error("expected square brackets"));
        }
        attributes.extend([TokenTree::from(input.parse::<Group>()?)]);
    }
    Ok(attributes)
}

#[cfg(test)]
mod tests {
    use super::{attributes, path, visibility};
    use proc_macro2::TokenStream;
    use syn::parse::{ParseStream, Parser, Result};

    /// Text that a rule takes of a text, and what it leaves.
    fn taken(rule: fn(ParseStream) -> Result<TokenStream>, text: &str) -> Option<(String, String)> {
        let both = |input: ParseStream| Ok((rule(input)?, input.parse::<TokenStream>()?));
        let compact = |tokens: TokenStream| tokens.to_string().replace(' ', "");
        both.parse_str(text).ok().map(|(taken, left)| (compact(taken), compact(left)))
    }

    #[test]
    fn rust_is_read_as_rust_reads_it() {
        for (rule, text, expected) in [
            (path as fn(ParseStream) -> Result<TokenStream>, "crate::a::b; c", Some(("crate::a::b", ";c"))),
            (path, "::a = 1", Some(("::a", "=1"))),
            (path, "a::", None),
            (path, "fn", None),
            (visibility, "Name", Some(("", "Name"))),
            (visibility, "pub Name", Some(("pub", "Name"))),
            (visibility, "pub(super) Name", Some(("pub(super)", "Name"))),
            (visibility, "pub(in crate::a) Name", Some(("pub(incrate::a)", "Name"))),
            (visibility, "pub (crate::a)", Some(("pub", "(crate::a)"))),
            (visibility, "pub(in 3) Name", None),
            (attributes, "#[a] #[b = 1] pub", Some(("#[a]#[b=1]", "pub"))),
            (attributes, "#!", None),
        ] {
            let expected = expected.map(|(taken, left): (&str, &str)| (taken.to_string(), left.to_string()));
            assert_eq!(taken(rule, text), expected, "{text}");
        }
    }
}
