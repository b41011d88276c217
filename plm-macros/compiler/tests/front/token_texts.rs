//! Declarations as lists of tokens, to be disturbed.

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};

/// The tokens of a text, brackets among them. A blank stands after each, but for marks that touch the next one.
pub(crate) fn token_texts(text: &str) -> Vec<String> {
    let mut token_texts = Vec::new();
    flatten(text.parse().unwrap(), &mut token_texts);
    token_texts
}

fn flatten(stream: TokenStream, token_texts: &mut Vec<String>) {
    for tree in stream {
        match tree {
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Parenthesis => ("( ", ") "),
                    Delimiter::Bracket => ("[ ", "] "),
                    Delimiter::Brace => ("{ ", "} "),
                    Delimiter::None => ("", ""),
                };
                token_texts.push(open.to_owned());
                flatten(group.stream(), token_texts);
                token_texts.push(close.to_owned());
            }
            TokenTree::Punct(mark) if mark.spacing() == Spacing::Joint => {
                token_texts.push(mark.as_char().to_string());
            }
            leaf => token_texts.push(format!("{leaf} ")),
        }
    }
}
