//! Emitted code: one description, as tokens for rustc and as text for people.

use std::cell::RefCell;

use proc_macro2::{Delimiter, Group, Literal, TokenStream, TokenTree};

use super::print;

/// Emitted source.
///
/// The structure is tokens, with the user's spans on the user's names. Straight-line code and tables are texts: rustc lexes
/// them in a fraction of the time that an unoptimised macro needs to build their tokens, and they have comments. A group
/// without delimiters that holds a number, which the structure has no other use for, stands where the text of that number
/// goes.
#[derive(Clone, Debug, Default)]
pub struct Code {
    structure: TokenStream,
    texts: Vec<String>,
}

/// The texts of one emission.
#[derive(Default)]
pub(super) struct Texts(RefCell<Vec<String>>);

impl Texts {
    /// Keeps a text, and gives what stands for it in the structure.
    pub(super) fn add(&self, text: String) -> TokenStream {
        if text.is_empty() {
            return TokenStream::new();
        }
        let mut texts = self.0.borrow_mut();
        texts.push(text);
        let number = TokenTree::from(Literal::usize_unsuffixed(texts.len() - 1));
        TokenTree::from(Group::new(Delimiter::None, number.into())).into()
    }

    pub(super) fn with(self, structure: TokenStream) -> Code {
        Code { structure, texts: self.0.into_inner() }
    }
}

/// The text that a group of the structure stands for.
pub(super) fn text_of<'a>(group: &Group, texts: &'a [String]) -> Option<&'a str> {
    let number = (group.delimiter() == Delimiter::None).then(|| group.stream().to_string())?;
    texts.get(number.trim().parse::<usize>().ok()?).map(String::as_str)
}

impl Code {
    /// The whole source as tokens, its texts by this lexer.
    ///
    /// # Errors
    /// A text is not Rust, which is a bug of the compiler.
    pub fn tokens<E>(&self, lexed: impl Fn(&str) -> Result<TokenStream, E>) -> Result<TokenStream, E> {
        spliced(self.structure.clone(), &self.texts, &lexed)
    }

    /// The whole source as one text, with the titles of sections as comments.
    pub fn text(&self) -> String {
        print::text(&self.structure, &self.texts)
    }
}

/// A stream with its texts lexed in their places.
fn spliced<E>(
    stream: TokenStream,
    texts: &[String],
    lexed: &impl Fn(&str) -> Result<TokenStream, E>,
) -> Result<TokenStream, E> {
    let mut output = TokenStream::new();
    for tree in stream {
        match tree {
            TokenTree::Group(group) => {
                if let Some(text) = text_of(&group, texts) {
                    output.extend(lexed(text)?);
                } else {
                    let mut inner = Group::new(group.delimiter(), spliced(group.stream(), texts, lexed)?);
                    inner.set_span(group.span());
                    output.extend([TokenTree::Group(inner)]);
                }
            }
            other => output.extend([other]),
        }
    }
    Ok(output)
}
