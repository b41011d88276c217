//! From rustc's tokens to the compiler's, and names of the emitted code back to where the user wrote them.

use std::collections::BTreeMap;

use plm_compiler::Code;
use plm_compiler::token::{Delimiter, Token};
use proc_macro::{Group, LexError, Spacing, Span, TokenStream, TokenTree};

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

/// Emitted source as tokens. Identifiers of its public part get the spans of their declarations, so that an editor
/// finds them; what stands behind is long and is not walked.
pub(crate) fn code(code: &Code, spans: &[Span]) -> Result<TokenStream, LexError> {
    let places: BTreeMap<&str, Span> = code
        .names
        .iter()
        .filter_map(|(name, span)| Some((name.as_str(), *spans.get(span.first as usize)?)))
        .map(|(name, span)| (name, span.resolved_at(Span::call_site())))
        .collect();
    let mut output = respan(code.before.parse()?, &places, 1);
    let mut inner = respan(code.public.parse()?, &places, 2);
    inner.extend(code.implementation.parse::<TokenStream>()?);
    let mut content = respan(code.face.parse()?, &places, 2);
    content.extend(code.inner.parse::<TokenStream>()?);
    content.extend(braces(inner));
    output.extend(code.module.parse::<TokenStream>()?);
    output.extend(braces(content));
    Ok(output)
}

fn braces(content: TokenStream) -> [TokenTree; 1] {
    [TokenTree::Group(Group::new(proc_macro::Delimiter::Brace, content))]
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
