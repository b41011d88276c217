//! `quote!`, as the crate of that name has it, with less code where it stands.
//!
//! There each token is a call, and a third of what rustc checks in this crate, which every user builds, would be such calls.
//! Here the tokens are one text, which is lexed when it is wanted, and only what is interpolated is a call. Repetitions are
//! left to the crate.

use proc_macro2::{Delimiter, Group, Punct, Spacing, TokenStream, TokenTree};
use quote::ToTokens;

/// Values for the `#` of a template, in their order.
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
                    // Up to the asterisk, which may stand after a separator.
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

/// Streams one after the other. To `collect` them builds a chain of iterators over the tokens of all.
pub(crate) fn joined(streams: Vec<TokenStream>) -> TokenStream {
    let mut all = TokenStream::new();
    for stream in streams {
        all.extend(Some(stream));
    }
    all
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

/// Pushes what stands for each `#`, in their order: each token is looked at with the three after it.
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

#[cfg(test)]
mod tests {
    use proc_macro2::{Delimiter, TokenStream, TokenTree};

    /// Tokens with their spacing, which the text of a stream does not show.
    fn shown(stream: TokenStream) -> String {
        let tokens = stream.into_iter().map(|token| match token {
            TokenTree::Group(group) => {
                let open = if group.delimiter() == Delimiter::None { '<' } else { '(' };
                format!("{open}{:?} {})", group.delimiter(), shown(group.stream()))
            }
            TokenTree::Punct(mark) => format!("{}{:?} ", mark.as_char(), mark.spacing()),
            other => format!("{other} "),
        });
        tokens.collect()
    }

    /// Expands a template by both macros.
    macro_rules! both {
        ($($tokens:tt)*) => {
            assert_eq!(shown(quote!($($tokens)*)), shown(::quote::quote!($($tokens)*)))
        };
    }

    #[test]
    fn templates_are_those_of_the_crate_quote() {
        let (name, value) = (::quote::format_ident!("name"), 1.5);
        let (names, none) = ([&name, &name], Vec::<TokenStream>::new());
        both!();
        both!(#name);
        both!(fn f<'a, S: Real>(x: &'a mut [S; 3], y: &<S as T>::U) -> Vec<Vec<S>> { x[0] += -#value; #name() });
        both!({ #(#names: #value,)* } [#(#names),*] (#(#none)*) #(#names)|* => a..=b && c >> 2 <= !d);
        both!(#[doc = "of it"] /// A line.
            #[allow(dead_code)] match x { 0 | 1 => *k = &&y, 'a' => "#name", _ => { #({ #names })* } });
    }
}
