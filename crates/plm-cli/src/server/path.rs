//! The name at a place, with the path that leads to it: `arm.tip.position`.

use std::ops::Range;

use crate::lexer::{Kind, Token, tokens};

/// A name in a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Word {
    /// The names of its path up to it, without indices.
    pub(super) path: Vec<String>,
    /// The path with indices, as it is written: `bar[3].a`.
    pub(super) written: String,
    /// Its range in the text.
    pub(super) range: Range<usize>,
    /// Does a `:` follow? Then it may be the parameter of a part.
    pub(super) is_field: bool,
}

/// Tokens of a declaration without comments; `None` where the place is within a comment or a string.
pub(super) fn tokens_around(text: &str, declaration: &Range<usize>, at: usize) -> Option<Vec<Token>> {
    let part = text.get(declaration.clone())?;
    let moved = |token: Token| Token {
        range: token.range.start + declaration.start..token.range.end + declaration.start,
        ..token
    };
    let all: Vec<Token> = tokens(part).into_iter().map(moved).collect();
    let is_text =
        |kind| matches!(kind, Kind::LineComment | Kind::BlockComment | Kind::Literal | Kind::Unclosed);
    let is_inside = |token: &Token| {
        // Up to the end of its line a comment goes on.
        let end = token.range.end + usize::from(token.kind == Kind::LineComment);
        is_text(token.kind) && (token.range.start + 1..end).contains(&at)
    };
    if all.iter().any(is_inside) {
        return None;
    }
    Some(all.into_iter().filter(|token| !token.kind.is_comment()).collect())
}

/// The name at a place, or that ends there.
pub(super) fn word(text: &str, declaration: &Range<usize>, at: usize) -> Option<Word> {
    let all = tokens_around(text, declaration, at)?;
    let index = all.iter().position(|token| token.range.start <= at && at < token.range.end);
    let index = index.filter(|index| all[*index].kind == Kind::Word);
    let index =
        index.or_else(|| all.iter().position(|token| token.kind == Kind::Word && token.range.end == at))?;
    let begin = begin(text, &all, index);
    let path = path(text, &all[begin..=index]);
    let written = text[all[begin].range.start..all[index].range.end].split_whitespace().collect();
    let is_field = all.get(index + 1).is_some_and(|token| token.is_mark(text, ':'));
    Some(Word { path, written, range: all[index].range.clone(), is_field })
}

/// Index of the first token of the path that ends at a token.
pub(super) fn begin(text: &str, all: &[Token], end: usize) -> usize {
    let mut first = end;
    loop {
        let Some(dot) = first.checked_sub(1).filter(|at| all[*at].is_mark(text, '.')) else { return first };
        let Some(mut before) = dot.checked_sub(1) else { return first };
        while all[before].is_mark(text, ']') {
            let Some(open) = all[..before].iter().rposition(|token| token.is_mark(text, '[')) else {
                return first;
            };
            let Some(name) = open.checked_sub(1) else { return first };
            before = name;
        }
        if all[before].kind != Kind::Word {
            return first;
        }
        first = before;
    }
}

/// The names of a path, without the contents of brackets.
pub(super) fn path(text: &str, tokens: &[Token]) -> Vec<String> {
    let mut depth = 0_i32;
    let mut words = Vec::new();
    for token in tokens {
        match token.text(text) {
            "[" => depth += 1,
            "]" => depth -= 1,
            word if depth == 0 && token.kind == Kind::Word => words.push(word.to_owned()),
            _ => {}
        }
    }
    words
}

#[cfg(test)]
mod tests {
    use super::word;

    #[test]
    fn a_path_goes_back_over_indices() {
        let text = "let a = bar[i + 1].tip.position; // bar.b\nk: \"c.d\";";
        let found = |at: &str| word(text, &(0..text.len()), text.find(at).unwrap_or(0));
        let tip = found("tip").map(|word| (word.path.join(" "), word.written, word.is_field));
        assert_eq!(tip, Some(("bar tip".to_owned(), "bar[i+1].tip".to_owned(), false)));
        assert_eq!(found("k:").map(|word| word.is_field), Some(true));
        assert_eq!((found("bar.b"), found("c.d"), found("+")), (None, None, None));
        assert_eq!(word(text, &(0..text.len()), 3).map(|word| word.path), Some(vec!["let".to_owned()]));
    }
}
