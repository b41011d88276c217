//! Texts and their tokens: where each token stands, and what proc-macro2 cannot read.
//!
//! proc-macro2 knows places of tokens outside rustc alone, so they are found again: tokens stand in a text in their
//! order, with blanks and comments between them.

use std::ops::Range;

use proc_macro2::TokenStream;

use crate::diag::Code;

/// Byte range of each token in its text. The tokens of a line of documentation, `# [ doc = "…" ]`, have that of the line.
/// A token that the text does not hold has an empty range.
pub(crate) fn locate<'a>(text: &str, tokens: impl Iterator<Item = &'a str>) -> Vec<Range<usize>> {
    let (mut at, mut documentation) = (0, false);
    let mut ranges: Vec<Range<usize>> = Vec::new();
    for token in tokens {
        if let Some(line) = ranges.last().filter(|_| documentation).cloned() {
            documentation = token != "]";
            ranges.push(line);
            continue;
        }
        at += blank(&text[at..]);
        let rest = &text[at..];
        documentation = is_documentation(rest);
        let raw = if rest.starts_with("r#") && !token.starts_with("r#") { 2 } else { 0 };
        let length = match documentation {
            true => comment(rest),
            false if rest[raw..].starts_with(token) => raw + token.len(),
            false => 0,
        };
        ranges.push(at..at + length);
        at += length;
    }
    ranges
}

/// Length of the blanks and comments that a text begins with.
fn blank(text: &str) -> usize {
    let mut rest = text.trim_start();
    while !is_documentation(rest) && comment(rest) > 0 {
        rest = rest[comment(rest)..].trim_start();
    }
    text.len() - rest.len()
}

fn is_documentation(text: &str) -> bool {
    let begins = |with: &str, without: &[&str]| {
        text.starts_with(with) && !without.iter().any(|other| text.starts_with(other))
    };
    begins("///", &["////"]) || begins("/**", &["/***", "/**/"]) || begins("//!", &[]) || begins("/*!", &[])
}

/// Length of the comment that a text begins with, 0 without one. Block comments nest, as in Rust.
fn comment(text: &str) -> usize {
    if text.starts_with("//") {
        return text.lines().next().map_or(0, str::len);
    }
    let (bytes, mut depth, mut at) = (text.as_bytes(), 0_usize, 0);
    while at < bytes.len() {
        match (&bytes[at..], depth) {
            ([b'/', b'*', ..], _) => (depth, at) = (depth + 1, at + 2),
            (_, 0) => return 0,
            ([b'*', b'/', ..], 1) => return at + 2,
            ([b'*', b'/', ..], _) => (depth, at) = (depth - 1, at + 2),
            _ => at += 1,
        }
    }
    at
}

/// An error that keeps a text from being a tree of tokens.
#[derive(Clone, Debug)]
pub(crate) struct LexicalError {
    pub(crate) code: Code,
    pub(crate) message: String,
    /// Byte in the text with its brackets closed.
    pub(crate) at: usize,
}

/// A text that proc-macro2 cannot read, with what lexical recovery made of it.
pub(crate) struct Recovered {
    /// The text with its brackets closed.
    pub(crate) shown: String,
    /// The text with blanks for everything that begins no token.
    pub(crate) lexed: String,
    /// Its tokens.
    pub(crate) stream: TokenStream,
    /// The errors.
    pub(crate) lexical_errors: Vec<LexicalError>,
    /// Brackets that are open, and where.
    open: Vec<(usize, char)>,
}

pub(crate) fn recover(text: &str) -> Recovered {
    let mut recovered = Recovered {
        shown: String::new(),
        lexed: String::new(),
        stream: TokenStream::new(),
        lexical_errors: Vec::new(),
        open: Vec::new(),
    };
    let mut rest = text;
    // After a string that is not closed all marks are escaped, and so begin none that is closed.
    let mut closes = true;
    while let Some(first) = rest.chars().next() {
        let whole = match blank(rest) {
            0 if is_documentation(rest) => comment(rest),
            0 if first == '"' && closes => string(rest),
            blank => blank,
        };
        closes &= first != '"' || whole > 0;
        let length = if whole > 0 {
            recovered.push(&rest[..whole]);
            whole
        } else if first.is_ascii_digit() {
            recovered.number(rest)
        } else {
            recovered.take(first);
            first.len_utf8()
        };
        rest = &rest[length..];
    }
    recovered.close(0);
    if let Ok(stream) = recovered.lexed.parse() {
        recovered.stream = stream;
    } else {
        let message = "a comment is not closed".to_owned();
        recovered.lexical_errors.push(LexicalError { code: Code::UnexpectedToken, message, at: 0 });
    }
    recovered
}

/// Length of the string that a text begins with, 0 if it is not closed.
fn string(text: &str) -> usize {
    let mut escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        match c {
            '"' if !escaped => return at + 1,
            _ => escaped = c == '\\' && !escaped,
        }
    }
    0
}

impl Recovered {
    /// Takes the number that a text begins with, as far as it looks like a word; gives its length.
    fn number(&mut self, text: &str) -> usize {
        let length = text.find(|c: char| c != '_' && !c.is_alphanumeric()).unwrap_or(text.len());
        let word = &text[..length];
        if word.parse::<TokenStream>().is_ok() {
            self.push(word);
        } else {
            self.leave_out(word, Code::BadNumber, format!("`{word}` is not a number that can be read"));
        }
        length
    }

    fn take(&mut self, c: char) {
        let mut bytes = [0; 4];
        let word: &str = c.encode_utf8(&mut bytes);
        match c {
            '(' | '[' | '{' => self.open.push((self.shown.len(), c)),
            ')' | ']' | '}' => {
                let Some(partner) = self.open.iter().rposition(|(_, open)| closing(*open) == c) else {
                    return self.leave_out(word, Code::UnclosedDelimiter, format!("`{c}` closes nothing"));
                };
                self.close(partner + 1);
                self.open.pop();
            }
            '"' => {
                return self.leave_out(word, Code::UnclosedDelimiter, "a string is not closed".to_owned());
            }
            c if ['\'', '\\', '`'].contains(&c) || !(c.is_ascii_graphic() || c.is_alphanumeric()) => {
                return self.leave_out(word, Code::UnexpectedToken, format!("`{c}` begins no token"));
            }
            _ => {}
        }
        self.push(word);
    }

    fn push(&mut self, text: &str) {
        self.shown.push_str(text);
        self.lexed.push_str(text);
    }

    fn leave_out(&mut self, word: &str, code: Code, message: String) {
        self.lexical_errors.push(LexicalError { code, message, at: self.shown.len() });
        self.shown.push_str(word);
        // A zero for a number, which needs no unit: nothing else is said of it.
        let placeholder = if code == Code::BadNumber { "0" } else { " " };
        self.lexed.push_str(placeholder);
        self.lexed.push_str(&" ".repeat(word.len() - 1));
    }

    /// Closes all brackets but the first few.
    fn close(&mut self, but: usize) {
        for (at, open) in self.open.split_off(but).into_iter().rev() {
            let message = format!("`{open}` is not closed");
            self.lexical_errors.push(LexicalError { code: Code::UnclosedDelimiter, message, at });
            self.push(closing(open).encode_utf8(&mut [0; 4]));
        }
    }
}

fn closing(open: char) -> char {
    match open {
        '(' => ')',
        '[' => ']',
        _ => '}',
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::{Recovered, recover};
    use crate::token::Sources;

    /// Text at the places of the tokens of a source.
    fn located(text: &str) -> Vec<String> {
        let mut sources = Sources::new();
        let id = sources.add_text("text", text);
        let source = sources.get(id).unwrap();
        let span = |at: usize| crate::span::Span { source: id, first: at as u32, last: at as u32 };
        (0..source.count()).map(|at| source.text(span(at)).unwrap().to_owned()).collect()
    }

    #[test]
    fn tokens_are_found_between_blanks_and_comments() {
        assert_eq!(located("a /* b /* c */ d */ e // f a\n g"), ["a", "e", "g"]);
        assert_eq!(
            located("  é { 1.5 r#in, 0..64 }"),
            ["é", "{", "1.5", "r#in", ",", "0", ".", ".", "64", "}"]
        );
        assert_eq!(located("a: \"é // }\";"), ["a", ":", "\"é // }\"", ";"]);
        assert_eq!(located("/// A ] b.\n//// no\n/**/ a"), [&["/// A ] b."; 6][..], &["a"]].concat());
    }

    #[test]
    fn brackets_are_closed_where_the_enclosing_one_is() {
        let Recovered { shown, lexed, stream, lexical_errors, .. } = recover("a { (1; } ] b[");
        assert_eq!((shown.as_str(), lexed.as_str()), ("a { (1; )} ] b[]", "a { (1; )}   b[]"));
        assert_eq!(stream.into_iter().count(), 4);
        let found: Vec<_> = lexical_errors.iter().map(|error| (error.at, error.message.as_str())).collect();
        assert_eq!(found, [(4, "`(` is not closed"), (11, "`]` closes nothing"), (14, "`[` is not closed")]);
    }

    #[test]
    fn what_is_no_token_is_left_out() {
        assert_eq!(recover("30 ° \\ 'a \"b").lexed, "30       a  b");
        assert_eq!(recover("a = 0bar;").lexed, "a = 0   ;");
        assert_eq!(recover("a /* b").lexical_errors.len(), 1);
    }
}
