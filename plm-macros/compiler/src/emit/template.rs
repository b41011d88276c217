//! `quote!`, as the crate of that name has it, with less code where it stands.
//!
//! There each token is a call; in a crate that users build without optimisation a third of all checking was spent on them.
//! Here the tokens are one text, which is lexed when it is wanted, and only what is interpolated is a call. Repetitions are
//! left to the crate.

use proc_macro2::{Delimiter, Group, Punct, Spacing, TokenStream, TokenTree};
use quote::ToTokens;

/// What stands for the `#` of a template, in their order.
#[derive(Default)]
pub(crate) struct Holes(Vec<TokenStream>);

impl Holes {
    /// The next one.
    pub(crate) fn push(&mut self, tokens: &dyn ToTokens) {
        self.0.push(tokens.to_token_stream());
    }

    /// The text of a template, with these in their places.
    pub(crate) fn fill(self, text: &str) -> TokenStream {
        let template: TokenStream = text.parse().expect("a template is made of tokens");
        filled(template, &mut self.0.into_iter())
    }
}

fn filled(template: TokenStream, holes: &mut std::vec::IntoIter<TokenStream>) -> TokenStream {
    let mut output = TokenStream::new();
    let mut tokens = template.into_iter().peekable();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Punct(mark) if mark.as_char() == '#' => match tokens.peek() {
                Some(TokenTree::Ident(_)) => {
                    tokens.next();
                    output.extend(holes.next());
                }
                Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis => {
                    // Up to the asterisk, which may stand behind a separator.
                    tokens.find(|token| matches!(token, TokenTree::Punct(mark) if mark.as_char() == '*'));
                    output.extend(holes.next());
                }
                _ => output.extend([TokenTree::Punct(mark)]),
            },
            TokenTree::Group(group) => {
                let inside = filled(group.stream(), holes);
                output.extend([TokenTree::Group(Group::new(group.delimiter(), inside))]);
            }
            TokenTree::Punct(mark) => output.extend([TokenTree::Punct(spaced(&mark, tokens.peek()))]),
            other => output.extend([other]),
        }
    }
    output
}

/// A mark, joint with the next where both are of one operator or lifetime: the text of `&'a` joins more.
fn spaced(mark: &Punct, next: Option<&TokenTree>) -> Punct {
    let mark = mark.as_char();
    let is_joint = match next {
        Some(TokenTree::Punct(next)) => match (mark, next.as_char()) {
            ('-' | '=', '>') => true,
            (mark, '=') => "+-*/%^&|<>=!.".contains(mark),
            (mark, next) => mark == next && "&|<>:.".contains(mark),
        },
        _ => mark == '\'',
    };
    Punct::new(mark, if is_joint { Spacing::Joint } else { Spacing::Alone })
}

/// Tokens as they stand, with `#name` and `#(…)*` replaced: the language of the crate quote.
macro_rules! quote {
    ($($tokens:tt)*) => {{
        #[allow(unused_mut, reason = "templates without holes")]
        let mut holes = $crate::emit::template::Holes::default();
        $crate::emit::template::holes!(holes $($tokens)*);
        holes.fill(stringify!($($tokens)*))
    }};
}

/// Pushes what stands for each `#`, in their order: each token is looked at with the three behind it.
macro_rules! holes {
    ($holes:ident $($tokens:tt)*) => {
        $crate::emit::template::holes_in_windows! {
            $holes
            (@ @ @ $($tokens)*) (@ @ $($tokens)* @) (@ $($tokens)* @ @) ($($tokens)* @ @ @)
        }
    };
}

macro_rules! holes_in_windows {
    ($holes:ident ($($a:tt)*) ($($b:tt)*) ($($c:tt)*) ($($d:tt)*)) => {
        $($crate::emit::template::hole!($holes $a $b $c $d);)*
    };
}

macro_rules! hole {
    ($holes:ident # ($($inner:tt)*) * $d:tt) => {
        $holes.push(&::quote::quote!(#($($inner)*)*));
    };
    ($holes:ident # ($($inner:tt)*) $separator:tt *) => {
        $holes.push(&::quote::quote!(#($($inner)*)$separator*));
    };
    ($holes:ident # $name:ident $c:tt $d:tt) => {
        $holes.push(&$name);
    };
    ($holes:ident $a:tt ($($inner:tt)*) $c:tt $d:tt) => {
        $crate::emit::template::holes!($holes $($inner)*);
    };
    ($holes:ident $a:tt [$($inner:tt)*] $c:tt $d:tt) => {
        $crate::emit::template::holes!($holes $($inner)*);
    };
    ($holes:ident $a:tt {$($inner:tt)*} $c:tt $d:tt) => {
        $crate::emit::template::holes!($holes $($inner)*);
    };
    ($holes:ident $a:tt $b:tt $c:tt $d:tt) => {};
}

pub(crate) use {hole, holes, holes_in_windows, quote};
