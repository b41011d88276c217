//! Declarations as lists of tokens, to be disturbed.

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};

/// The tokens of a text, brackets among them. A blank stands behind each, but for marks that touch the next one.
pub(crate) fn pieces(text: &str) -> Vec<String> {
    let mut pieces = Vec::new();
    flatten(text.parse().unwrap(), &mut pieces);
    pieces
}

fn flatten(stream: TokenStream, pieces: &mut Vec<String>) {
    for tree in stream {
        match tree {
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Parenthesis => ("( ", ") "),
                    Delimiter::Bracket => ("[ ", "] "),
                    Delimiter::Brace => ("{ ", "} "),
                    Delimiter::None => ("", ""),
                };
                pieces.push(open.to_owned());
                flatten(group.stream(), pieces);
                pieces.push(close.to_owned());
            }
            TokenTree::Punct(mark) if mark.spacing() == Spacing::Joint => {
                pieces.push(mark.as_char().to_string());
            }
            leaf => pieces.push(format!("{leaf} ")),
        }
    }
}
