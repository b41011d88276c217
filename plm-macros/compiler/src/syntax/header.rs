//! What `mechanism!` holds: headers, then the mechanism.

use super::ast::{Declaration, Mechanism, Shared};
use super::cursor::{Cursor, Parse, Reported};
use super::item::Context;
use crate::diag::Code;
use crate::token::{Delimiter, Token, TokenKind};

impl Cursor<'_> {
    pub(super) fn declaration(mut self) -> Declaration {
        let mut declaration = Declaration::default();
        while self.peek().is_some() && declaration.mechanism.is_none() {
            let start = self.position();
            if self.header(&mut declaration).is_err() {
                self.recover(start);
            }
        }
        self.only_one(&declaration);
        declaration
    }

    fn only_one(&mut self, declaration: &Declaration) {
        let span = self.here();
        if declaration.mechanism.is_some() && self.peek().is_some() {
            self.error(Code::UnexpectedToken, span, "something stands behind the mechanism")
                .help("a declaration holds one mechanism; parts stand before it or inside");
        } else if declaration.mechanism.is_none() && !self.sink.has_errors() {
            self.error(Code::NoMechanism, span, "no mechanism is declared")
                .help("write `pub Name { body … }`");
        }
    }

    fn header(&mut self, declaration: &mut Declaration) -> Parse<()> {
        let docs = self.docs();
        let next = |mark: char| move |token: &Token| token.is_punct(mark);
        if self.is_word("crate") && self.peek_at(1).is_some_and(next('=')) {
            declaration.crate_path = Some(self.crate_path()?);
        } else if self.is_word("parts") {
            let start = self.position();
            self.advance();
            let read = self.group(Delimiter::Brace, "`{`", |cursor| {
                cursor.definitions(&mut declaration.shared);
                Ok(())
            });
            declaration.carried.push(self.span_from(start));
            read?;
        } else if self.is_word("use") {
            let span = self.here();
            self.error(Code::MisplacedItem, span, "`use` must be the first word of the declaration");
            return Err(Reported);
        } else if self.is_definition() {
            declaration.shared.parts.push(self.definition(docs)?);
        } else if self.is_domain() {
            declaration.shared.domains.push(self.domain(docs)?);
        } else {
            declaration.mechanism = Some(self.mechanism(docs)?);
        }
        Ok(())
    }

    /// Definitions up to the end.
    pub(super) fn definitions(&mut self, shared: &mut Shared) {
        while self.peek().is_some() {
            let start = self.position();
            let docs = self.docs();
            let found = if self.is_definition() {
                self.definition(docs).map(|part| shared.parts.push(part))
            } else if self.is_domain() {
                self.domain(docs).map(|domain| shared.domains.push(domain))
            } else {
                Err(self.expected("`joint`, `part` or `domain`"))
            };
            if let Err(Reported) = found {
                self.recover(start);
            }
        }
    }

    fn mechanism(&mut self, docs: Vec<String>) -> Parse<Mechanism> {
        let visibility = self.visibility()?;
        self.skip_word_of_types(&visibility);
        let name = self.ident("the name of the mechanism")?;
        self.skip_generics();
        let items = self.block(Context::Mechanism)?;
        Ok(Mechanism { docs, visibility, name, items })
    }

    fn crate_path(&mut self) -> Parse<String> {
        self.word("crate")?;
        self.punct('=', "`=`")?;
        let mut path = String::new();
        while let Some(token) = self.peek() {
            if token.kind != TokenKind::Ident && !token.is_punct(':') {
                break;
            }
            path.push_str(&token.text);
            self.advance();
        }
        self.semicolon()?;
        Ok(path)
    }

    /// `pub`, `pub(crate)`, `pub(in path)`, or nothing.
    fn visibility(&mut self) -> Parse<String> {
        if !self.eat_word("pub") {
            return Ok(String::new());
        }
        if !self.is_open(Delimiter::Paren) {
            return Ok("pub".to_string());
        }
        self.group(Delimiter::Paren, "`(`", |cursor| {
            let mut text = "pub(".to_string();
            while let Some(token) = cursor.peek() {
                text.push_str(&token.text);
                text.push_str(if token.is_word("in") { " " } else { "" });
                cursor.advance();
            }
            text.push(')');
            Ok(text)
        })
    }

    /// Documentation: `///` lines, or `#[doc = "…"]`, which is what rustc makes of them. Other attributes
    /// are mistakes.
    pub(super) fn docs(&mut self) -> Vec<String> {
        let mut docs = Vec::new();
        while let Some(token) = self.peek() {
            if token.kind == TokenKind::Doc {
                docs.push(token.text.trim().to_string());
                self.advance();
            } else if let Some(text) = self.doc_attribute() {
                docs.extend(text.lines().map(|line| line.trim().to_string()));
                if text.is_empty() {
                    docs.push(String::new());
                }
                self.advance();
                let behind = self.behind_group(self.position());
                self.go_to(behind);
            } else if !self.eat_attribute() {
                break;
            }
        }
        docs
    }

    /// The text of `# [ doc = "…" ]` if it stands here.
    fn doc_attribute(&self) -> Option<String> {
        let is_attribute = self.is_punct('#')
            && self.peek_at(1)?.is_open(Delimiter::Bracket)
            && self.peek_at(2)?.is_word("doc")
            && self.peek_at(3)?.is_punct('=');
        let literal = self.peek_at(4).filter(|token| is_attribute && token.kind == TokenKind::Str)?;
        Some(unquote(&literal.text))
    }
}

/// The text of a string literal, raw or with the escapes that rustc writes.
fn unquote(literal: &str) -> String {
    if let Some(raw) = literal.strip_prefix('r') {
        let raw = raw.trim_start_matches('#').trim_end_matches('#');
        return raw.trim_matches('"').to_string();
    }
    let inner = literal.strip_prefix('"').unwrap_or(literal);
    let inner = inner.strip_suffix('"').unwrap_or(inner);
    let mut text = String::new();
    let mut chars = inner.chars();
    while let Some(c) = chars.next() {
        match c {
            '\\' => match chars.next() {
                Some('n') => text.push('\n'),
                Some('t') => text.push('\t'),
                Some('u') => text.extend(unicode(&mut chars)),
                Some(other) => text.push(other),
                None => {}
            },
            c => text.push(c),
        }
    }
    text
}

/// The character of `{1F600}` behind `\u`.
fn unicode(chars: &mut std::str::Chars) -> Option<char> {
    let digits: String = chars.by_ref().skip(1).take_while(|c| *c != '}').collect();
    u32::from_str_radix(&digits, 16).ok().and_then(char::from_u32)
}

#[cfg(test)]
mod tests {
    use super::unquote;

    #[test]
    fn literals_lose_their_quotes() {
        assert_eq!(unquote(r#"" a \"b\" \u{e9}\n""#), " a \"b\" é\n");
        assert_eq!(unquote(r##"r#" a "b" "#"##), " a \"b\" ".trim_end_matches('"'));
    }
}
