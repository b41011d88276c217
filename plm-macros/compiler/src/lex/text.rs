//! The lexer for text.

use super::number::split_number;
use crate::token::{Delimiter, Token, TokenKind};

/// Tokens of a text, and the byte range of each. It accepts every text: what it does not know becomes
/// [`TokenKind::Other`], and the parser says so.
pub fn lex(text: &str) -> (Vec<Token>, Vec<(u32, u32)>) {
    let mut lexer = Lexer { text, at: 0, tokens: Vec::new(), ranges: Vec::new() };
    while lexer.skip_space() {
        lexer.token();
    }
    (lexer.tokens, lexer.ranges)
}

struct Lexer<'a> {
    text: &'a str,
    at: usize,
    tokens: Vec<Token>,
    ranges: Vec<(u32, u32)>,
}

impl<'a> Lexer<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    /// Skips blanks and comments; is anything left? `///` is documentation, `//` and `////` are not.
    fn skip_space(&mut self) -> bool {
        loop {
            let rest = self.rest();
            let trimmed = rest.trim_start();
            self.at += rest.len() - trimmed.len();
            let doc = trimmed.starts_with("///") && !trimmed.starts_with("////");
            if trimmed.starts_with("//") && !doc {
                self.at += trimmed.find('\n').unwrap_or(trimmed.len());
            } else if trimmed.starts_with("/*") {
                self.at += block_comment(trimmed);
            } else {
                return !trimmed.is_empty();
            }
        }
    }

    fn token(&mut self) {
        let rest = self.rest();
        let first = rest.chars().next().unwrap_or(' ');
        if rest.starts_with("///") {
            let line = rest.lines().next().unwrap_or("");
            self.push(line.len(), Token::new(TokenKind::Doc, &line[3..]));
        } else if first.is_ascii_digit() {
            let length = number_length(rest);
            self.push(length, Token::new(TokenKind::Number, &rest[..length]));
        } else if first == '"' {
            let length = string_length(rest);
            self.push(length, Token::new(TokenKind::Str, &rest[..length]));
        } else if is_name_start(first) {
            let raw = if rest.starts_with("r#") { 2 } else { 0 };
            let length = raw + rest[raw..].find(|c| !is_name(c)).unwrap_or(rest.len() - raw);
            self.push(length, Token::ident(&rest[..length]));
        } else if let Some(token) = bracket(first) {
            self.push(1, token);
        } else if first.is_ascii_punctuation() {
            let joint =
                rest[1..].chars().next().is_some_and(|c| c.is_ascii_punctuation() && bracket(c).is_none());
            self.push(1, Token::punct(first, joint));
        } else {
            self.push(first.len_utf8(), Token::new(TokenKind::Other, first));
        }
    }

    fn push(&mut self, length: usize, token: Token) {
        self.ranges.push((self.at as u32, (self.at + length) as u32));
        self.tokens.push(token);
        self.at += length;
    }
}

fn is_name_start(c: char) -> bool {
    c == '_' || c.is_alphabetic()
}

fn is_name(c: char) -> bool {
    c == '_' || c.is_alphanumeric()
}

/// Length of a number with its suffix, which runs on as a name does.
fn number_length(rest: &str) -> usize {
    let number = split_number(rest).number.len();
    number + rest[number..].find(|c| !is_name(c)).unwrap_or(rest.len() - number)
}

/// Length of a string literal with its quotes; to the end of the text if it is not closed.
fn string_length(rest: &str) -> usize {
    let mut escaped = false;
    for (at, c) in rest.char_indices().skip(1) {
        match c {
            '"' if !escaped => return at + 1,
            '\\' => escaped = !escaped,
            _ => escaped = false,
        }
    }
    rest.len()
}

/// Length of a block comment; they nest, as in Rust.
fn block_comment(rest: &str) -> usize {
    let bytes = rest.as_bytes();
    let (mut depth, mut at) = (0_usize, 0);
    while at < bytes.len() {
        match (bytes[at], bytes.get(at + 1)) {
            (b'/', Some(b'*')) => (depth, at) = (depth + 1, at + 2),
            (b'*', Some(b'/')) if depth == 1 => return at + 2,
            (b'*', Some(b'/')) => (depth, at) = (depth - 1, at + 2),
            _ => at += 1,
        }
    }
    rest.len()
}

fn bracket(c: char) -> Option<Token> {
    Some(match c {
        '(' => Token::open(Delimiter::Paren),
        ')' => Token::close(Delimiter::Paren),
        '[' => Token::open(Delimiter::Bracket),
        ']' => Token::close(Delimiter::Bracket),
        '{' => Token::open(Delimiter::Brace),
        '}' => Token::close(Delimiter::Brace),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::lex;
    use crate::token::TokenKind;

    fn texts(text: &str) -> Vec<String> {
        lex(text).0.into_iter().map(|token| token.text).collect()
    }

    #[test]
    fn tokens_come_out_in_order_without_comments() {
        assert_eq!(texts("a /* b /* c */ d */ e // f\n g"), ["a", "e", "g"]);
        assert_eq!(texts("bar[i-1].b"), ["bar", "[", "i", "-", "1", "]", ".", "b"]);
        assert_eq!(texts("0..64"), ["0", ".", ".", "64"]);
        assert_eq!(texts("9.81 m/s^2;"), ["9.81", "m", "/", "s", "^", "2", ";"]);
        assert_eq!(texts("0.5m r#in"), ["0.5m", "in"]);
    }

    #[test]
    fn documentation_is_kept() {
        let (tokens, _) = lex("/// One.\n//// no\n// no\nx");
        assert_eq!((tokens[0].kind, tokens[0].text.as_str()), (TokenKind::Doc, " One."));
        assert_eq!(tokens.len(), 2);
    }

    #[test]
    fn ranges_point_at_the_text() {
        let text = "body  é { 1.5 }";
        let (tokens, ranges) = lex(text);
        for (token, (start, end)) in tokens.iter().zip(ranges) {
            assert_eq!(token.text, text[start as usize..end as usize]);
        }
    }

    #[test]
    fn what_is_not_closed_ends_with_the_text() {
        assert_eq!(texts("a \"b"), ["a", "\"b"]);
        assert_eq!(texts("a /* b"), ["a"]);
    }
}
