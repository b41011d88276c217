//! Tokens of a text with its comments: what a formatter keeps, and where declarations stand in a Rust file.
//!
//! The lexical rules are those of Rust, which declarations share (The Rust Reference, chapter 2). A text may be anything: what begins
//! no token is a mark, and a token that is not closed ends with the text.

use std::ops::Range;

/// Kind of a token.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A name or a keyword.
    Word,
    /// A number with what touches it: `0.5m`.
    Number,
    /// A string, a byte string, or a character.
    Literal,
    /// `'a`.
    Lifetime,
    /// One mark: `{`, `+`.
    Mark,
    /// `// …`, documentation among them, without the end of the line.
    LineComment,
    /// `/* … */`.
    BlockComment,
    /// A string or a comment that is not closed.
    Unclosed,
}

impl Kind {
    /// Is it a comment? Documentation is one.
    #[must_use]
    pub fn is_comment(self) -> bool {
        matches!(self, Kind::LineComment | Kind::BlockComment)
    }
}

/// A token and its place, in bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    /// Its kind.
    pub kind: Kind,
    /// Its range in the text.
    pub range: Range<usize>,
}

impl Token {
    /// Its text.
    pub fn text<'a>(&self, all: &'a str) -> &'a str {
        all.get(self.range.clone()).unwrap_or_default()
    }

    /// Is it the mark?
    pub fn is_mark(&self, all: &str, mark: char) -> bool {
        self.kind == Kind::Mark && self.text(all).starts_with(mark)
    }
}

/// All tokens of a text in their order; blanks stand between them.
pub fn tokens(text: &str) -> Vec<Token> {
    let (mut tokens, mut at) = (Vec::new(), 0);
    loop {
        let rest = text.get(at..).unwrap_or_default();
        at += rest.len() - rest.trim_start().len();
        let rest = rest.trim_start();
        let Some(first) = rest.chars().next() else { return tokens };
        let (kind, length) = token(rest, first);
        let length = length.max(first.len_utf8());
        tokens.push(Token { kind, range: at..at + length });
        at += length;
    }
}

/// Kind and length of the token that a text begins with.
fn token(text: &str, first: char) -> (Kind, usize) {
    if text.starts_with("//") {
        return (Kind::LineComment, text.find('\n').map_or(text, |end| &text[..end]).trim_end().len());
    }
    if text.starts_with("/*") {
        return closed(Kind::BlockComment, block_comment(text), text);
    }
    if let Some(found) = string(text) {
        return found;
    }
    if first.is_ascii_digit() {
        return (Kind::Number, number(text));
    }
    if first == '\'' {
        return character(text);
    }
    let begin = if text.starts_with("r#") { 2 } else { 0 };
    if text[begin..].starts_with(is_word) {
        return (Kind::Word, begin + word(&text[begin..]));
    }
    (Kind::Mark, first.len_utf8())
}

fn is_word(c: char) -> bool {
    c == '_' || c.is_alphanumeric()
}

/// Length of the name or keyword at the beginning of a text.
fn word(text: &str) -> usize {
    text.find(|c| !is_word(c)).unwrap_or(text.len())
}

fn closed(kind: Kind, length: Option<usize>, text: &str) -> (Kind, usize) {
    length.map_or((Kind::Unclosed, text.len()), |length| (kind, length))
}

/// Comments nest.
fn block_comment(text: &str) -> Option<usize> {
    let (bytes, mut depth, mut at) = (text.as_bytes(), 0_usize, 0);
    while at < bytes.len() {
        match &bytes[at..] {
            [b'/', b'*', ..] => (depth, at) = (depth + 1, at + 2),
            [b'*', b'/', ..] if depth == 1 => return Some(at + 2),
            [b'*', b'/', ..] => (depth, at) = (depth - 1, at + 2),
            _ => at += 1,
        }
    }
    None
}

/// `"…"`, `b"…"`, `c"…"`, and raw ones: `r"…"`, `br#"…"#`.
fn string(text: &str) -> Option<(Kind, usize)> {
    let prefix = text.find(|c: char| !['b', 'c', 'r'].contains(&c)).filter(|length| *length <= 2)?;
    let is_raw = text[..prefix].ends_with('r');
    let rest = &text[prefix..];
    let marks = rest.len() - rest.trim_start_matches('#').len();
    if !rest[marks..].starts_with('"') || (marks > 0 && !is_raw) {
        return None;
    }
    let begin = prefix + marks + 1;
    if is_raw {
        let end = format!("\"{}", "#".repeat(marks));
        let length = text[begin..].find(&end).map(|at| begin + at + end.len());
        return Some(closed(Kind::Literal, length, text));
    }
    Some(closed(Kind::Literal, quoted(&text[begin..], '"').map(|length| begin + length), text))
}

/// Length up to after the mark that closes; a backslash takes the next letter.
fn quoted(text: &str, close: char) -> Option<usize> {
    let mut is_escaped = false;
    for (at, c) in text.char_indices() {
        if c == close && !is_escaped {
            return Some(at + c.len_utf8());
        }
        is_escaped = c == '\\' && !is_escaped;
    }
    None
}

/// `'a'`, `'\n'` or the lifetime `'a`; a mark where it is neither.
fn character(text: &str) -> (Kind, usize) {
    let rest = &text[1..];
    let mut letters = rest.char_indices().skip(1);
    if rest.starts_with('\\') {
        return quoted(rest, '\'').map_or((Kind::Mark, 1), |length| (Kind::Literal, 1 + length));
    }
    match letters.next() {
        Some((at, '\'')) => (Kind::Literal, at + 2),
        _ if rest.starts_with(is_word) => (Kind::Lifetime, 1 + word(rest)),
        _ => (Kind::Mark, 1),
    }
}

/// `1`, `0.5`, `1e-3`, `0x1f`, with a suffix. The point of `0..8` is none of a number's, and neither is that of `1.abs()`.
fn number(text: &str) -> usize {
    let mut at = word(text);
    let rest = &text[at..];
    let after = rest.strip_prefix('.').unwrap_or_default();
    if rest.starts_with('.') && !after.starts_with(|c: char| c == '.' || c == '_' || c.is_alphabetic()) {
        at += 1 + word(after);
    }
    let is_decimal = !text.starts_with("0x");
    if is_decimal && text[..at].ends_with(['e', 'E']) && text[at..].starts_with(['+', '-']) {
        let digits = word(&text[at + 1..]);
        at += if digits > 0 { 1 + digits } else { 0 };
    }
    at
}

#[cfg(test)]
mod tests {
    use super::{Kind, tokens};

    fn read(text: &str) -> Vec<(Kind, &str)> {
        tokens(text).iter().map(|token| (token.kind, token.text(text))).collect()
    }

    fn texts(text: &str) -> Vec<&str> {
        read(text).into_iter().map(|(_, text)| text).collect()
    }

    #[test]
    fn numbers_words_and_marks_are_those_of_rust() {
        assert_eq!(
            texts("0..8 1.5e-3m 2. 0.5m r#in é_1"),
            ["0", ".", ".", "8", "1.5e-3m", "2.", "0.5m", "r#in", "é_1"]
        );
        assert_eq!(texts("bar[i-1].b<=2"), ["bar", "[", "i", "-", "1", "]", ".", "b", "<", "=", "2"]);
        assert_eq!(texts("0xe+1 1e+2 brb"), ["0xe", "+", "1", "1e+2", "brb"]);
    }

    #[test]
    fn comments_and_strings_are_one_token_each() {
        let text = "a /* b /* c */ d */ // e \n \"f\\\"}\" r#\"\"g\"# '{' '\\'' 'h b\"i\"";
        let kinds: Vec<Kind> = read(text).into_iter().map(|(kind, _)| kind).collect();
        let expected = [
            Kind::Word,
            Kind::BlockComment,
            Kind::LineComment,
            Kind::Literal,
            Kind::Literal,
            Kind::Literal,
            Kind::Literal,
            Kind::Lifetime,
            Kind::Literal,
        ];
        assert_eq!(kinds, expected);
        assert_eq!(texts(text)[2], "// e");
    }

    #[test]
    fn what_is_not_closed_ends_with_the_text() {
        for text in ["/* a", "\"a\\", "r#\"a\"", "b\""] {
            assert_eq!(read(text), [(Kind::Unclosed, text)]);
        }
        assert_eq!(texts("' \\ \u{a7}"), ["'", "\\", "\u{a7}"]);
    }
}
