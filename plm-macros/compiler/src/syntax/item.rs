//! Items: what stands in a mechanism, in a part, or in a repetition.

use super::ast::{Expr, ExprKind, Ident, IndexedName, Item, ItemKind, Output, Repeat, Value};
use super::cursor::{Cursor, Parse, Reported};
use super::habits::{behind_value, instead_of_item};
use crate::diag::{Code, nearest};
use crate::library::PARTS;
use crate::span::Span;
use crate::token::{Delimiter, Token, TokenKind};

/// Where items stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Context {
    Mechanism,
    Part,
}

/// Words that begin an item, and where it may stand (`None`: in both).
const WORDS: &[(&str, Option<Context>)] = &[
    ("gravity", Some(Context::Mechanism)),
    ("stabilisation", Some(Context::Mechanism)),
    ("rung", Some(Context::Mechanism)),
    ("allow", Some(Context::Mechanism)),
    ("joint", Some(Context::Mechanism)),
    ("part", Some(Context::Mechanism)),
    ("domain", Some(Context::Mechanism)),
    ("observe", Some(Context::Mechanism)),
    ("choice", Some(Context::Part)),
    ("pair", Some(Context::Part)),
    ("picture", Some(Context::Part)),
    ("param", None),
    ("input", None),
    ("state", None),
    ("let", None),
    ("rate", None),
    ("ground", None),
    ("body", None),
    ("node", None),
    ("constraint", None),
    ("require", None),
    ("output", None),
    ("repeat", None),
];

impl Cursor<'_> {
    /// `{ items }`
    pub(super) fn block(&mut self, context: Context) -> Parse<Vec<Item>> {
        self.nested(|cursor| cursor.group(Delimiter::Brace, "`{`", |cursor| Ok(cursor.items(context))))
    }

    fn items(&mut self, context: Context) -> Vec<Item> {
        let mut items = Vec::new();
        while self.peek().is_some() {
            let start = self.position();
            let docs = self.docs();
            let first = self.position();
            match self.item(&docs, context) {
                Ok(kind) => items.push(Item { docs, kind, span: self.span_from(first) }),
                Err(Reported) => self.recover(start),
            }
        }
        items
    }

    fn item(&mut self, docs: &[String], context: Context) -> Parse<ItemKind> {
        if self.is_load() {
            self.only_in(Context::Part, context, "what acts on a port")?;
            return self.load().map(ItemKind::Load);
        }
        let word =
            self.peek().filter(|token| token.kind == TokenKind::Ident).map(|token| token.text.as_str());
        let Some(word) = word else { return Err(self.expected("an item")) };
        if let Some((_, Some(place))) = WORDS.iter().find(|(name, _)| *name == word) {
            self.only_in(*place, context, &format!("`{word}`"))?;
        }
        match word {
            "gravity" => self.field_value().map(ItemKind::Gravity),
            "stabilisation" => self.stabilisation(),
            "rung" => self.rung(),
            "allow" => self.allow(),
            "param" => self.value().map(ItemKind::Param),
            "input" => self.value().map(ItemKind::Input),
            "state" => self.state().map(ItemKind::State),
            "let" => self.definition_of_name(ItemKind::Let),
            "rate" => self.definition_of_name(ItemKind::Rate),
            "choice" => self.choice().map(ItemKind::Choice),
            "pair" => self.pair().map(ItemKind::Pair),
            "picture" => self.picture().map(ItemKind::Picture),
            "ground" => self.ground().map(ItemKind::Ground),
            "body" => self.body().map(ItemKind::Body),
            "constraint" => self.constraint(),
            "require" => self.requirement(),
            "output" => self.outputs().map(ItemKind::Output),
            "observe" => self.observed().map(ItemKind::Observe),
            "repeat" => self.repeat(context).map(ItemKind::Repeat),
            "node" => self.node().map(ItemKind::Node),
            "joint" | "part" => self.definition(docs.to_vec()).map(ItemKind::Definition),
            "domain" => self.domain(docs.to_vec()).map(ItemKind::Domain),
            word => self.instance_or_unknown(word),
        }
    }

    fn only_in(&mut self, place: Context, context: Context, what: &str) -> Parse<()> {
        if place == context {
            return Ok(());
        }
        let (here, there) = match place {
            Context::Mechanism => ("a part", "a mechanism"),
            Context::Part => ("a mechanism", "a part"),
        };
        let message = format!("{what} has no place in {here}");
        self.error(Code::MisplacedItem, self.here(), message).note(format!("it stands in {there}"));
        Err(Reported)
    }

    fn instance_or_unknown(&mut self, word: &str) -> Parse<ItemKind> {
        let is_word = |token: &Token| token.kind == TokenKind::Ident;
        let behind_name =
            self.peek_at(2).is_some_and(|t| t.is_open(Delimiter::Paren) || t.is_open(Delimiter::Bracket));
        if self.peek_at(1).is_some_and(is_word) && behind_name {
            return self.instance().map(ItemKind::Instance);
        }
        let words = WORDS.iter().map(|(word, _)| *word);
        let near = nearest(word, words);
        if PARTS.iter().any(|(part, _)| *part == word) {
            return Err(self.part_without_brackets(word));
        }
        let diagnostic = self.error(Code::UnknownItem, self.here(), format!("`{word}` begins no item"));
        if let Some(help) = instead_of_item(word) {
            diagnostic.help(help);
            return Err(Reported);
        }
        match near {
            Some(near) => diagnostic.help(format!("an item with a similar name exists: `{near}`")),
            None => diagnostic.help("a part is used as `revolute name(a, b);`"),
        };
        Err(Reported)
    }

    /// The end of an item. If it is missing but the next item begins here, that is said and nothing is skipped.
    pub(super) fn semicolon(&mut self) -> Parse<()> {
        if self.eat_punct(';') {
            return Ok(());
        }
        let reported = match self.peek().and_then(|token| behind_value(&token.text)) {
            Some(help) => self.expected_but("`;`", help),
            None => self.expected("`;`"),
        };
        let begins_field = self.peek_at(1).is_some_and(|next| next.is_punct(':'));
        let begins_item = self.peek().is_none_or(|token| WORDS.iter().any(|(word, _)| token.is_word(word)));
        let begins_part = ["port", "start"].iter().any(|word| self.is_word(word));
        if begins_field || begins_item || begins_part { Ok(()) } else { Err(reported) }
    }

    /// The end of an item behind its value; what stands behind an unreadable one, or is missing, is no second mistake.
    pub(super) fn end_of(&mut self, value: &Expr) -> Parse<()> {
        if !matches!(value.kind, ExprKind::Unknown) {
            return self.semicolon();
        }
        while self.peek().is_some() && !self.is_punct(';') {
            self.go_to(self.behind(self.position()));
        }
        self.eat_punct(';');
        Ok(())
    }

    /// `word: expr;`, the word being known.
    pub(super) fn field_value(&mut self) -> Parse<Expr> {
        let word = self.peek().map_or("", |token| token.text.as_str());
        self.advance();
        self.colon_of(word)?;
        let value = self.value_expr();
        self.end_of(&value)?;
        Ok(value)
    }

    fn stabilisation(&mut self) -> Parse<ItemKind> {
        self.advance();
        self.punct(':', "`:`")?;
        let method = self.ident("`projection` or `baumgarte`")?;
        let time = if self.is_open(Delimiter::Paren) {
            Some(self.group(Delimiter::Paren, "`(`", Cursor::expr)?)
        } else {
            None
        };
        self.semicolon()?;
        Ok(ItemKind::Stabilisation(method, time))
    }

    fn rung(&mut self) -> Parse<ItemKind> {
        self.advance();
        self.punct(':', "`:`")?;
        let rung = self.ident("`tree`, `loops` or `absolute`")?;
        self.semicolon()?;
        Ok(ItemKind::Rung(rung))
    }

    fn allow(&mut self) -> Parse<ItemKind> {
        self.advance();
        let codes = self.group(Delimiter::Paren, "`(`", |cursor| {
            let mut codes = Vec::new();
            while cursor.peek().is_some() {
                codes.push(cursor.ident("a code")?);
                if !cursor.eat_punct(',') {
                    break;
                }
            }
            Ok(codes)
        })?;
        self.semicolon()?;
        Ok(ItemKind::Allow(codes))
    }

    /// `param name: unit = expr;`
    fn value(&mut self) -> Parse<Value> {
        self.value_with(|_| Ok(false))
    }

    /// `state name: unit = expr, locked;`
    fn state(&mut self) -> Parse<Value> {
        self.value_with(|cursor| cursor.locked().map(|locked| locked.is_some()))
    }

    /// `, locked`, if it stands here.
    pub(super) fn locked(&mut self) -> Parse<Option<Span>> {
        if !self.eat_punct(',') {
            return Ok(None);
        }
        let span = self.here();
        self.word("locked")?;
        Ok(Some(span))
    }

    fn value_with(&mut self, locked: impl FnOnce(&mut Self) -> Parse<bool>) -> Parse<Value> {
        self.advance();
        let name = self.indexed_name("a name")?;
        let start = self.position();
        let mut unit = None;
        if self.eat_punct(':') {
            let Ok(found) = self.declared_unit() else {
                let value = self.unknown_expr(start);
                self.end_of(&value)?;
                return Ok(Value { name, unit, value: Some(value), locked: false });
            };
            unit = Some(found);
        }
        let value = self.eat_punct('=').then(|| self.value_expr());
        let locked = locked(self)?;
        match &value {
            Some(value) => self.end_of(value)?,
            None => self.semicolon()?,
        }
        Ok(Value { name, unit, value, locked })
    }

    fn definition_of_name(&mut self, make: impl FnOnce(IndexedName, Expr) -> ItemKind) -> Parse<ItemKind> {
        let word = self.peek().map_or("", |token| token.text.as_str());
        self.advance();
        self.skip_mut();
        let name = self.indexed_name("a name")?;
        self.skip_unit_of(word)?;
        self.punct('=', "`=`")?;
        let value = self.value_expr();
        self.end_of(&value)?;
        Ok(make(name, value))
    }

    fn outputs(&mut self) -> Parse<Vec<Output>> {
        self.advance();
        let mut outputs = vec![self.output()?];
        while self.eat_punct(',') {
            outputs.push(self.output()?);
        }
        self.semicolon()?;
        Ok(outputs)
    }

    fn picture(&mut self) -> Parse<Vec<IndexedName>> {
        self.advance();
        let mut names = vec![self.indexed_name("a parameter")?];
        while self.eat_punct(',') {
            names.push(self.indexed_name("a parameter")?);
        }
        self.semicolon()?;
        Ok(names)
    }

    fn observed(&mut self) -> Parse<Vec<Expr>> {
        self.advance();
        let mut observed = vec![self.expr()?];
        while self.eat_punct(',') {
            observed.push(self.expr()?);
        }
        self.semicolon()?;
        Ok(observed)
    }

    fn output(&mut self) -> Parse<Output> {
        let name = if self.names_output() {
            let name = self.indexed_name("a name")?;
            self.punct('=', "`=`")?;
            Some(name)
        } else {
            None
        };
        let value = self.expr()?;
        let name = name.or_else(|| self.name_behind(&value));
        let unit = if self.eat_word("in") {
            let start = self.position();
            let unit = self.unit()?;
            Some((unit, self.span_from(start)))
        } else {
            None
        };
        Ok(Output { name, value, unit })
    }

    /// Does `name =` or `name[i] =` stand here?
    fn names_output(&self) -> bool {
        let mut at = 1;
        while self.peek_at(at).is_some_and(|token| token.is_open(Delimiter::Bracket)) {
            at = self.behind_group(self.position() + at) - self.position();
        }
        self.peek_at(at).is_some_and(|token| token.is_punct('='))
            && !self.peek_at(at + 1).is_some_and(|token| token.is_punct('='))
    }

    fn repeat(&mut self, context: Context) -> Parse<Repeat> {
        self.advance();
        let index: Ident = self.ident("the name of an index")?;
        self.word("in")?;
        let from = self.expr()?;
        self.punct('.', "`..`")?;
        self.punct('.', "`..`")?;
        let inclusive = self.eat_punct('=');
        let to = self.expr()?;
        let items = self.block(context)?;
        Ok(Repeat { index, from, to, inclusive, items })
    }
}
