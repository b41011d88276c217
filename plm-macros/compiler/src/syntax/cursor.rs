//! The cursor over tokens: looking, taking, entering brackets, recovering.
//!
//! The partner of every bracket is known beforehand, and what stands in brackets is read with the cursor confined to
//! them. So a mistake inside cannot leak out, and to skip a group costs nothing.

use super::ast::Ident;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::span::Span;
use crate::token::{Delimiter, Source, Token, TokenKind, written};

/// An error was reported; what could not be read is left out.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reported;

/// What a rule of the grammar gives.
pub(crate) type Parse<T> = Result<T, Reported>;

/// Expressions and items may nest this deeply: recursion must end before the stack does.
const MAX_DEPTH: u32 = 64;

pub(crate) struct Cursor<'a> {
    tokens: &'a [Token],
    partners: Vec<u32>,
    source: u32,
    at: usize,
    end: usize,
    depth: u32,
    pub(crate) sink: &'a mut Diagnostics,
}

impl<'a> Cursor<'a> {
    pub(crate) fn new(source: &'a Source, sink: &'a mut Diagnostics) -> Cursor<'a> {
        let tokens = &source.tokens;
        let mut cursor = Cursor {
            tokens,
            partners: Vec::new(),
            source: source.id,
            at: 0,
            end: tokens.len(),
            depth: 0,
            sink,
        };
        cursor.match_brackets();
        cursor
    }

    /// Finds the partner of each opening bracket. One that has none reaches to the end of what encloses it.
    fn match_brackets(&mut self) {
        self.partners = vec![0; self.tokens.len()];
        let mut open: Vec<(usize, Delimiter)> = Vec::new();
        for (at, token) in self.tokens.iter().enumerate() {
            match token.kind {
                TokenKind::Open(delimiter) => open.push((at, delimiter)),
                TokenKind::Close(delimiter) => {
                    let Some(partner) = open.iter().rposition(|(_, other)| *other == delimiter) else {
                        self.unmatched(at);
                        continue;
                    };
                    for (lost, _) in open.drain(partner + 1..) {
                        self.partners[lost] = at as u32;
                        unclosed(self.sink, self.source, lost, self.tokens);
                    }
                    if let Some((partner, _)) = open.pop() {
                        self.partners[partner] = at as u32;
                    }
                }
                _ => {}
            }
        }
        for (lost, _) in open {
            self.partners[lost] = self.tokens.len() as u32;
            unclosed(self.sink, self.source, lost, self.tokens);
        }
    }

    fn unmatched(&mut self, at: usize) {
        let message = format!("`{}` closes nothing", self.tokens[at].text);
        self.sink.error(Code::UnclosedDelimiter, self.span_at(at), message);
    }

    fn span_at(&self, at: usize) -> Span {
        Span { source: self.source, first: at as u32, last: at as u32 }
    }

    /// The token here; `None` at the end of the brackets.
    pub(crate) fn peek(&self) -> Option<&'a Token> {
        self.peek_at(0)
    }

    /// The token some places ahead, within the brackets.
    pub(crate) fn peek_at(&self, ahead: usize) -> Option<&'a Token> {
        let at = self.at + ahead;
        if at < self.end { self.tokens.get(at) } else { None }
    }

    pub(crate) fn position(&self) -> usize {
        self.at
    }

    pub(crate) fn go_to(&mut self, position: usize) {
        self.at = position;
    }

    pub(crate) fn advance(&mut self) {
        if self.at < self.end {
            self.at += 1;
        }
    }

    /// Place of the token here; at the end, of the closing bracket.
    pub(crate) fn here(&self) -> Span {
        self.span_at(self.at.min(self.tokens.len().saturating_sub(1)))
    }

    /// From a position to the last token that was taken.
    pub(crate) fn span_from(&self, first: usize) -> Span {
        Span { source: self.source, first: first as u32, last: self.at.saturating_sub(1).max(first) as u32 }
    }

    /// What was written there, in one line.
    pub(crate) fn text_of(&self, span: Span) -> String {
        written(self.tokens.get(span.first as usize..=span.last as usize).unwrap_or_default())
    }

    pub(crate) fn is_word(&self, word: &str) -> bool {
        self.peek().is_some_and(|token| token.is_word(word))
    }

    pub(crate) fn is_punct(&self, mark: char) -> bool {
        self.peek().is_some_and(|token| token.is_punct(mark))
    }

    pub(crate) fn is_open(&self, delimiter: Delimiter) -> bool {
        self.peek().is_some_and(|token| token.is_open(delimiter))
    }

    /// Takes a word if it is here.
    pub(crate) fn eat_word(&mut self, word: &str) -> bool {
        let found = self.is_word(word);
        self.at += usize::from(found);
        found
    }

    /// Takes a mark if it is here.
    pub(crate) fn eat_punct(&mut self, mark: char) -> bool {
        let found = self.is_punct(mark);
        self.at += usize::from(found);
        found
    }

    pub(crate) fn ident(&mut self, what: &str) -> Parse<Ident> {
        match self.peek() {
            Some(token) if token.kind == TokenKind::Ident => {
                let ident = Ident { text: token.text.clone(), span: self.here() };
                self.at += 1;
                Ok(ident)
            }
            _ => Err(self.expected(what)),
        }
    }

    pub(crate) fn punct(&mut self, mark: char, what: &str) -> Parse<()> {
        if self.eat_punct(mark) { Ok(()) } else { Err(self.expected(what)) }
    }

    pub(crate) fn word(&mut self, word: &str) -> Parse<()> {
        if self.eat_word(word) { Ok(()) } else { Err(self.expected(&format!("`{word}`"))) }
    }

    /// Reports that something else was expected here, and what to write.
    pub(crate) fn expected_but(&mut self, what: &str, help: &str) -> Reported {
        self.report_expected(what).help(help);
        Reported
    }

    /// Reports that something else was expected here.
    pub(crate) fn expected(&mut self, what: &str) -> Reported {
        self.report_expected(what);
        Reported
    }

    fn report_expected(&mut self, what: &str) -> &mut Diagnostic {
        let found = match self.tokens.get(self.at) {
            Some(token) => format!("`{}`", token.text),
            None => "the end".to_string(),
        };
        let message = format!("expected {what}, found {found}");
        self.error(Code::UnexpectedToken, self.here(), message)
    }

    pub(crate) fn error(&mut self, code: Code, span: Span, message: impl Into<String>) -> &mut Diagnostic {
        self.sink.error(code, span, message)
    }

    /// Goes one level deeper for a rule that recurses.
    pub(crate) fn nested<T>(&mut self, rule: impl FnOnce(&mut Self) -> Parse<T>) -> Parse<T> {
        if self.depth >= MAX_DEPTH {
            let message = format!("more than {MAX_DEPTH} levels, one inside the other");
            self.error(Code::TooDeep, self.here(), message).help("name a part of it with `let`");
            return Err(Reported);
        }
        self.depth += 1;
        let result = rule(self);
        self.depth -= 1;
        result
    }

    /// Reads what stands in the brackets that open here, and leaves them. If the rule leaves something over, that is
    /// reported; after a mistake the rest is skipped. A rule that reads groups within groups counts its own depth.
    pub(crate) fn group<T>(
        &mut self,
        delimiter: Delimiter,
        what: &str,
        rule: impl FnOnce(&mut Self) -> Parse<T>,
    ) -> Parse<T> {
        if !self.is_open(delimiter) {
            return Err(self.expected(what));
        }
        let partner = (self.partners[self.at] as usize).min(self.end);
        let end = std::mem::replace(&mut self.end, partner);
        self.at += 1;
        let mut result = rule(self);
        if result.is_ok() && self.at < partner {
            result = Err(self.expected("the closing bracket"));
        }
        self.end = end;
        self.at = (partner + 1).min(end);
        result
    }

    /// Position behind the group that opens some places ahead.
    pub(crate) fn behind_group(&self, position: usize) -> usize {
        (self.partners.get(position).map_or(self.end, |partner| *partner as usize) + 1).min(self.end)
    }

    /// Position behind a token, or behind the group that it opens.
    pub(crate) fn behind(&self, position: usize) -> usize {
        match self.tokens.get(position).map(|token| token.kind) {
            Some(TokenKind::Open(_)) => self.behind_group(position),
            _ => position + 1,
        }
    }

    /// Skips what is left of an item that began at `start`: to behind a `;` or a `{ … }`, over one token at least.
    pub(crate) fn recover(&mut self, start: usize) {
        if self.at > start && ends_item(&self.tokens[self.at - 1]) {
            return;
        }
        while let Some(token) = self.peek() {
            self.at = self.behind(self.at);
            if ends_item(token) {
                return;
            }
        }
    }
}

fn ends_item(token: &Token) -> bool {
    token.is_punct(';') || token.is_open(Delimiter::Brace) || token.kind == TokenKind::Close(Delimiter::Brace)
}

fn unclosed(sink: &mut Diagnostics, source: u32, at: usize, tokens: &[Token]) {
    let span = Span { source, first: at as u32, last: at as u32 };
    sink.error(Code::UnclosedDelimiter, span, format!("`{}` is not closed", tokens[at].text));
}
