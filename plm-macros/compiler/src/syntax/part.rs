//! Parts: their definitions and uses, and the items that only they hold.

use super::ast::{
    Argument, Choice, Definition, Domain, Expr, ExprKind, Field, Ident, Instance, ItemKind, Load, Node,
    Quantity,
};
use super::cursor::{Cursor, Parse, Reported};
use super::item::Context;
use crate::token::{Delimiter, TokenKind};

impl Cursor<'_> {
    /// Does the definition of a part begin here?
    pub(super) fn is_definition(&self) -> bool {
        (self.is_word("joint") || self.is_word("part"))
            && self.peek_at(1).is_some_and(|token| token.kind == TokenKind::Ident)
    }

    /// `joint name(arguments) { items }`
    pub(super) fn definition(&mut self, docs: Vec<String>) -> Parse<Definition> {
        let is_joint = self.is_word("joint");
        self.advance();
        let name = self.ident("the name of the part")?;
        let arguments = self.group(Delimiter::Paren, "`(`", Cursor::arguments)?;
        let items = self.block(Context::Part)?;
        Ok(Definition { docs, is_joint, name, arguments, items })
    }

    fn arguments(&mut self) -> Parse<Vec<Argument>> {
        let mut arguments = Vec::new();
        while self.peek().is_some() {
            let name = self.ident("the name of an argument")?;
            self.punct(':', "`:`")?;
            let kind = self.ident("`frame`, `body` or a domain")?;
            arguments.push(Argument { name, kind });
            if !self.eat_punct(',') {
                break;
            }
        }
        Ok(arguments)
    }

    /// `kind name(args);` or `kind name(args) { fields }`
    pub(super) fn instance(&mut self) -> Parse<Instance> {
        let kind = self.ident("the name of a part")?;
        let name = self.indexed_name("a name")?;
        let start = self.position();
        let arguments = self
            .expr_list()
            .unwrap_or_else(|Reported| vec![Expr { kind: ExprKind::Unknown, span: self.span_from(start) }]);
        let mut fields = Vec::new();
        if self.is_open(Delimiter::Brace) {
            self.group(Delimiter::Brace, "`{`", |cursor| {
                cursor.fields(&mut fields);
                Ok(())
            })?;
            self.eat_punct(';');
        } else {
            self.semicolon()?;
        }
        Ok(Instance { kind, name, arguments, fields })
    }

    fn fields(&mut self, fields: &mut Vec<Field>) {
        while self.peek().is_some() {
            let start = self.position();
            match self.field() {
                Ok(field) => fields.push(field),
                Err(Reported) => self.recover(start),
            }
        }
    }

    fn field(&mut self) -> Parse<Field> {
        self.docs();
        let start = self.position();
        let mut path = vec![self.indexed_name("the name of a parameter")?];
        while self.eat_punct('.') {
            path.push(self.indexed_name("the name of a parameter")?);
        }
        let name = self.text_of(self.span_from(start));
        self.colon_of(&name)?;
        let value = self.value_expr();
        let locked = self.locked()?;
        self.end_of(&value)?;
        Ok(Field { path, value, locked })
    }

    /// Does the definition of a domain begin here?
    pub(super) fn is_domain(&self) -> bool {
        self.is_word("domain") && self.peek_at(1).is_some_and(|token| token.kind == TokenKind::Ident)
    }

    /// `domain name { across name: unit; through name: unit; … }`
    pub(super) fn domain(&mut self, docs: Vec<String>) -> Parse<Domain> {
        self.advance();
        let name = self.ident("the name of the domain")?;
        self.group(Delimiter::Brace, "`{`", |cursor| {
            let across = cursor.quantity_of("across")?;
            let mut through = vec![cursor.quantity_of("through")?];
            while cursor.peek().is_some() {
                through.push(cursor.quantity_of("through")?);
            }
            Ok(Domain { docs, name, across, through })
        })
    }

    /// `across name: unit;`
    fn quantity_of(&mut self, word: &str) -> Parse<Quantity> {
        self.docs();
        self.word(word)?;
        let name = self.ident("the name of a quantity")?;
        self.punct(':', "`:`")?;
        let unit = self.declared_unit()?;
        self.semicolon()?;
        Ok(Quantity { name, unit })
    }

    /// `node name: kind = expr;`
    pub(super) fn node(&mut self) -> Parse<Node> {
        self.advance();
        let name = self.indexed_name("the name of the node")?;
        self.punct(':', "`:`")?;
        let kind = self.ident("`frame`, `body` or a domain")?;
        self.punct('=', "`=`")?;
        let value = self.value_expr();
        self.end_of(&value)?;
        Ok(Node { name, kind, value })
    }

    /// `choice name: option | option = option;`
    pub(super) fn choice(&mut self) -> Parse<Choice> {
        self.advance();
        let name = self.ident("the name of the choice")?;
        self.punct(':', "`:`")?;
        let mut options = vec![self.ident("an option")?];
        while self.eat_punct('|') {
            options.push(self.ident("an option")?);
        }
        let default = if self.eat_punct('=') { Some(self.ident("an option")?) } else { None };
        self.semicolon()?;
        Ok(Choice { name, options, default })
    }

    /// `pair: name;`
    pub(super) fn pair(&mut self) -> Parse<Ident> {
        self.advance();
        self.punct(':', "`:`")?;
        let pair = self.ident("the name of a pair")?;
        self.semicolon()?;
        Ok(pair)
    }

    /// `constraint name: left = right;`
    pub(super) fn constraint(&mut self) -> Parse<ItemKind> {
        self.advance();
        let start = self.position();
        let name = self.indexed_name("the name of the row")?;
        if [".", "=", "+", "-", "*", "/"]
            .iter()
            .any(|mark| self.peek().is_some_and(|token| token.text == *mark))
        {
            return Err(self.constraint_without_name(start));
        }
        self.punct(':', "`:`")?;
        let left = self.expr()?;
        let (left, right) = match self.sides_of_equality(left) {
            Ok(sides) => sides,
            Err(left) => {
                self.punct('=', "`= 0`")?;
                (left, self.expr()?)
            }
        };
        self.semicolon()?;
        Ok(ItemKind::Constraint(name, left, right))
    }

    /// `require name: condition;`
    pub(super) fn requirement(&mut self) -> Parse<ItemKind> {
        self.advance();
        let name = self.indexed_name("the name of the requirement")?;
        self.punct(':', "`:`")?;
        let condition = self.value_expr();
        self.end_of(&condition)?;
        Ok(ItemKind::Require(name, condition))
    }

    /// Does `force on name` stand here, and not a part of that name?
    pub(super) fn is_load(&self) -> bool {
        self.peek().is_some_and(|token| token.kind == TokenKind::Ident)
            && self.peek_at(1).is_some_and(|token| token.is_word("on"))
            && self.peek_at(2).is_some_and(|token| token.kind == TokenKind::Ident)
    }

    /// `force on b from a: expr;`
    pub(super) fn load(&mut self) -> Parse<Load> {
        let start = self.position();
        let quantity = self.ident("what acts")?;
        self.word("on")?;
        let on = self.expr()?;
        let from = if self.eat_word("from") { Some(self.expr()?) } else { None };
        let span = self.span_from(start);
        self.punct(':', "`:`")?;
        let value = self.expr()?;
        self.semicolon()?;
        Ok(Load { quantity, on, from, value, span })
    }
}
