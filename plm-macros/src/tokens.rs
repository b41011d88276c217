//! From rustc's tokens to the compiler's.

use plm_compiler::token::{Delimiter, Token};
use proc_macro::{Group, Spacing, Span, TokenStream, TokenTree};

/// The compiler's tokens, brackets among them, and rustc's span of each.
pub(crate) fn flatten(input: TokenStream) -> (Vec<Token>, Vec<Span>) {
    let mut flat = Flat { tokens: Vec::new(), spans: Vec::new() };
    let mut open: Vec<(Trees, Option<(Delimiter, Span)>)> = vec![(list(input), None)];
    while let Some((trees, closing)) = open.last_mut() {
        match trees.next() {
            Some(TokenTree::Group(group)) => match delimiter(&group) {
                Some(kind) => {
                    flat.push(Token::open(kind), group.span_open());
                    open.push((list(group.stream()), Some((kind, group.span_close()))));
                }
                None => open.push((list(group.stream()), None)),
            },
            Some(TokenTree::Ident(ident)) => flat.push(Token::ident(&ident.to_string()), ident.span()),
            Some(TokenTree::Punct(mark)) => {
                flat.push(Token::punct(mark.as_char(), mark.spacing() == Spacing::Joint), mark.span());
            }
            Some(TokenTree::Literal(literal)) => {
                flat.push(Token::literal(&literal.to_string()), literal.span());
            }
            None => {
                if let Some((kind, span)) = closing.take() {
                    flat.push(Token::close(kind), span);
                }
                open.pop();
            }
        }
    }
    (flat.tokens, flat.spans)
}

struct Flat {
    tokens: Vec<Token>,
    spans: Vec<Span>,
}

impl Flat {
    fn push(&mut self, token: Token, span: Span) {
        self.tokens.push(token);
        self.spans.push(span);
    }
}

/// What is left of a stream.
type Trees = std::vec::IntoIter<TokenTree>;

fn list(stream: TokenStream) -> Trees {
    stream.into_iter().collect::<Vec<_>>().into_iter()
}

/// `None` for the invisible group around what a `macro_rules!` captured, unless that is an operation: `2 + 1` in place of
/// `$n` is one operand, while a path or a literal is what it is without a group.
fn delimiter(group: &Group) -> Option<Delimiter> {
    match group.delimiter() {
        proc_macro::Delimiter::Parenthesis => Some(Delimiter::Paren),
        proc_macro::Delimiter::Bracket => Some(Delimiter::Bracket),
        proc_macro::Delimiter::Brace => Some(Delimiter::Brace),
        proc_macro::Delimiter::None => {
            group.stream().into_iter().any(is_operator).then_some(Delimiter::Captured)
        }
    }
}

fn is_operator(tree: TokenTree) -> bool {
    matches!(tree, TokenTree::Punct(mark) if "+-*/<>&|^".contains(mark.as_char()))
}
