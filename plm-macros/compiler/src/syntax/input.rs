//! The stream that all parsers read: syn's, with numbers of tokens, the sink, and a bound of its depth.

use std::cell::{Cell, RefCell, RefMut};
use std::ops::Deref;

use proc_macro2::Delimiter;
use syn::buffer::Cursor;
use syn::parse::{ParseBuffer, ParseStream, Parser, Peek};
use syn::{Token, token};

use super::foreign_syntax::after_value;
use crate::collect::MapEach;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::span::Span;
use crate::token::Source;

/// An error was reported; what could not be read is left out.
#[derive(Clone, Copy)]
pub(super) struct Reported;

/// Result of a rule of the grammar.
pub(super) type Result<T> = std::result::Result<T, Reported>;

/// Expressions and items may nest this deeply: recursion must end before the stack does.
const MAX_DEPTH: u32 = 64;

/// Contents of one pair of brackets, or all of a source.
#[derive(Clone, Copy)]
pub(super) struct Input<'a> {
    stream: ParseStream<'a>,
    reading: &'a Reading<'a>,
}

/// State that all streams of one source share.
struct Reading<'a> {
    source: &'a Source,
    /// Cursors at the tokens of the source, in order.
    places: Vec<Cursor<'a>>,
    depth: Cell<u32>,
    sink: RefCell<Diagnostics>,
}

impl<'a> Deref for Input<'a> {
    type Target = ParseBuffer<'a>;

    fn deref(&self) -> &ParseBuffer<'a> {
        self.stream
    }
}

/// Reads a source by a rule of the grammar. Mistakes go to the sink.
pub(super) fn read<T: Default>(source: &Source, sink: &mut Diagnostics, rule: impl FnOnce(Input) -> T) -> T {
    for error in &source.lexical_errors {
        sink.error(error.code, source.token_at(error.at), &error.message);
    }
    let mut tree = T::default();
    let parse = |stream: ParseStream| {
        let mut places = Vec::with_capacity(source.count());
        let end = visit(stream.cursor(), &mut places);
        debug_assert!(end.eof() && places.len() == source.count(), "each token has a place");
        let sink_of_all = RefCell::new(std::mem::take(sink));
        let reading = Reading { source, places, depth: Cell::new(0), sink: sink_of_all };
        tree = rule(Input { stream, reading: &reading });
        *sink = reading.sink.into_inner();
        Ok(())
    };
    // The mistakes that syn finds by itself, tokens that are left over, have been reported by the rule.
    let _ = parse.parse2(source.stream.clone());
    tree
}

/// Appends the places of tokens, in the order of [`Source`]'s; gives that of the end.
fn visit<'a>(mut cursor: Cursor<'a>, places: &mut Vec<Cursor<'a>>) -> Cursor<'a> {
    while let Some((_, next)) = cursor.token_tree() {
        match cursor.any_group() {
            Some((inside, Delimiter::None, ..)) => drop(visit(inside, places)),
            Some((inside, ..)) => {
                places.push(cursor);
                let end = visit(inside, places);
                places.push(end);
            }
            None => places.push(cursor),
        }
        cursor = next;
    }
    cursor
}

/// Places and texts.
impl<'a> Input<'a> {
    /// The number of the token here; at the end, of the closing bracket.
    pub(super) fn position(self) -> usize {
        let here = self.cursor();
        self.reading.places.partition_point(|place| *place < here)
    }

    /// Place of the token here; at the end, of the closing bracket.
    pub(super) fn here(self) -> Span {
        let at = self.position().min(self.reading.source.count().saturating_sub(1)) as u32;
        Span { source: self.reading.source.id, first: at, last: at }
    }

    /// From a position to the last token that was taken.
    pub(super) fn span_from(self, first: usize) -> Span {
        let last = self.position().saturating_sub(1).max(first) as u32;
        Span { source: self.reading.source.id, first: first as u32, last }
    }

    /// Text of a span, in one line.
    pub(super) fn text_of(self, span: Span) -> String {
        self.reading.source.written(span)
    }

    /// The text of the token here, empty at the end.
    pub(super) fn next(self) -> &'a str {
        let token = self.reading.source.token(self.position());
        token.filter(|_| !self.is_empty()).unwrap_or_default()
    }

    /// The texts of the token here and of the two after it, of brackets too; empty at the end of the source.
    pub(super) fn ahead(self) -> [&'a str; 3] {
        let at = self.position();
        [at, at + 1, at + 2].map_each(|at| self.reading.source.token(at).unwrap_or_default())
    }

    /// Does a number stand here?
    pub(super) fn peek_number(self) -> bool {
        self.cursor().literal().is_some() && self.next().starts_with(|c: char| c.is_ascii_digit())
    }
}

/// Taking tokens.
impl<'a> Input<'a> {
    /// Takes a mark or a word if it is here.
    pub(super) fn eat(self, token: impl Peek) -> bool {
        let found = self.peek(token);
        if found {
            self.advance();
        }
        found
    }

    /// Takes a mark or a word that must be here.
    pub(super) fn expect(self, token: impl Peek, what: &str) -> Result<()> {
        if self.eat(token) { Ok(()) } else { Err(self.expected(what)) }
    }

    /// Goes on over a token or a group, in a captured path to its first token.
    pub(super) fn advance(self) {
        let _ = self.stream.step(|cursor| {
            let word = cursor.ident().map(|(_, after)| after);
            let token = word.or_else(|| cursor.punct().map(|(_, after)| after));
            let after = token.or_else(|| cursor.token_tree().map(|(_, after)| after));
            Ok(((), after.unwrap_or(*cursor)))
        });
    }

    /// Goes on to where something ends, over groups.
    pub(super) fn advance_to(self, is_end: impl Fn(Input<'a>) -> bool) {
        while !self.is_empty() && !is_end(self) {
            self.advance();
        }
    }

    /// Goes one level deeper for a rule that recurses.
    pub(super) fn nested<T>(self, rule: impl FnOnce(Input<'a>) -> Result<T>) -> Result<T> {
        let depth = &self.reading.depth;
        if depth.get() >= MAX_DEPTH {
            let message = format!("more than {MAX_DEPTH} levels, one inside the other");
            self.error(Code::TooDeep, self.here(), message).help("name a part of it with `let`");
            return Err(Reported);
        }
        depth.set(depth.get() + 1);
        let result = rule(self);
        depth.set(depth.get() - 1);
        result
    }

    /// Reads what stands in the brackets that open here, and leaves them. If the rule leaves something over, that is
    /// reported; after a mistake the rest is skipped. A rule that reads groups within groups counts its own depth.
    pub(super) fn group<T>(
        self,
        delimiter: Delimiter,
        what: &str,
        rule: impl FnOnce(Input) -> Result<T>,
    ) -> Result<T> {
        // A fork and not a buffer of the group: syn would report by itself what is left over in that.
        let inside = self.fork();
        let enter = inside.step(|cursor| match cursor.group(delimiter) {
            Some((inside, ..)) => Ok(((), inside)),
            None => Err(cursor.error("")),
        });
        if enter.is_err() {
            return Err(self.expected(what));
        }
        let content = Input { stream: &inside, reading: self.reading };
        let mut result = rule(content);
        if result.is_ok() && !content.is_empty() {
            result = Err(match after_value(content.next()).filter(|_| content.next() != ",") {
                Some(help) => content.expected_but("the closing bracket", help),
                None => content.expected("the closing bracket"),
            });
        }
        let _ = self.stream.step(|cursor| match cursor.group(delimiter) {
            Some((_, _, after)) => Ok(((), after)),
            None => Ok(((), *cursor)),
        });
        result
    }

    /// Items of a rule, between commas; one at least.
    pub(super) fn list<T>(self, rule: impl Fn(Input<'a>) -> Result<T>) -> Result<Vec<T>> {
        let mut list = vec![rule(self)?];
        while self.eat(Token![,]) {
            list.push(rule(self)?);
        }
        Ok(list)
    }

    /// Items of a rule, between commas, one after the last among them; may be nothing.
    pub(super) fn terminated<T>(self, rule: impl Fn(Input<'a>) -> Result<T>) -> Result<Vec<T>> {
        let mut list = Vec::new();
        while !self.is_empty() {
            list.push(rule(self)?);
            if !self.eat(Token![,]) {
                break;
            }
        }
        Ok(list)
    }

    /// All that a rule reads up to the end, without what it cannot read.
    pub(super) fn all<T>(self, mut rule: impl FnMut(Input<'a>) -> Result<T>) -> Vec<T> {
        let mut all = Vec::new();
        while !self.is_empty() {
            let start = self.position();
            match rule(self) {
                Ok(read) => all.push(read),
                Err(Reported) => self.recover(start),
            }
        }
        all
    }

    /// Skips what is left of an item that began at `start`: to after a `;` or a `{ … }`, over one token at least.
    pub(super) fn recover(self, start: usize) {
        let at = self.position();
        let before =
            at.checked_sub(1).filter(|_| at > start).and_then(|last| self.reading.source.token(last));
        let mut is_after = before.is_some_and(|token| [";", "{", "}"].contains(&token));
        while !is_after && !self.is_empty() {
            is_after = self.peek(Token![;]) || self.peek(token::Brace);
            self.advance();
        }
    }
}

/// Mistakes.
impl<'a> Input<'a> {
    pub(super) fn error(self, code: Code, span: Span, message: impl Into<String>) -> RefMut<'a, Diagnostic> {
        RefMut::map(self.reading.sink.borrow_mut(), |sink| sink.error(code, span, message))
    }

    pub(super) fn warning(
        self,
        code: Code,
        span: Span,
        message: impl Into<String>,
    ) -> RefMut<'a, Diagnostic> {
        RefMut::map(self.reading.sink.borrow_mut(), |sink| sink.warning(code, span, message))
    }

    pub(super) fn has_errors(self) -> bool {
        self.reading.sink.borrow().has_errors()
    }

    /// Reports that something else was expected here.
    pub(super) fn expected(self, what: &str) -> Reported {
        drop(self.report_expected(what));
        Reported
    }

    /// Reports that something else was expected here, and what to write.
    pub(super) fn expected_but(self, what: &str, help: &str) -> Reported {
        self.report_expected(what).help(help);
        Reported
    }

    fn report_expected(self, what: &str) -> RefMut<'a, Diagnostic> {
        let found = match self.reading.source.token(self.position()) {
            Some(token) => format!("`{token}`"),
            None => "the end".to_string(),
        };
        self.error(Code::UnexpectedToken, self.here(), format!("expected {what}, found {found}"))
    }
}
