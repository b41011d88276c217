//! Expressions, by precedence climbing.
//!
//! ```text
//! expr     := "if" expr "then" expr "else" expr | chain
//! chain    := operand { operator operand }      or < and < comparison < + - < * /
//! operand  := ("-" | "+") operand | "not" chain | primary ["^" operand]
//! primary  := (quantity | NAME index | NAME "(" exprs ")" | "(" expr ")") { "." NAME index }
//! quantity := NUMBER [unit] | "(" expr "," expr ")" [unit]
//! index    := { "[" expr "]" }
//! ```
//!
//! What a `macro_rules!` has captured is a primary too, and takes a unit as a number does.

use plm_cas::Number;

use super::ast::{Expr, ExprKind, IndexedName, Link, Operator};
use super::cursor::{Cursor, Parse, Reported};
use crate::diag::Code;
use crate::lex::split_number;
use crate::span::Span;
use crate::token::{Delimiter, TokenKind};
use crate::units::{DisplayUnit, UnitFactor, unit};

impl Cursor<'_> {
    /// An expression.
    pub(super) fn expr(&mut self) -> Parse<Expr> {
        self.nested(|cursor| if cursor.is_word("if") { cursor.if_expr() } else { cursor.chain(0) })
    }

    /// The value of an item. If it cannot be read, what is left of it is skipped: to a `;` or a `,`.
    pub(super) fn value_expr(&mut self) -> Expr {
        let start = self.position();
        self.expr().unwrap_or_else(|Reported| self.unknown_expr(start))
    }

    /// Skips what is left of the value of an item.
    pub(super) fn unknown_expr(&mut self, start: usize) -> Expr {
        while self.peek().is_some_and(|token| !token.is_punct(';') && !token.is_punct(',')) {
            self.go_to(self.behind(self.position()));
        }
        Expr { kind: ExprKind::Unknown, span: self.span_from(start) }
    }

    fn if_expr(&mut self) -> Parse<Expr> {
        let start = self.position();
        self.word("if")?;
        let condition = self.expr()?;
        if self.is_open(Delimiter::Brace) {
            return Err(self.expected_but("`then`", "write `if a < b then c else d`"));
        }
        self.word("then")?;
        let yes = self.expr()?;
        if !self.is_word("else") {
            return Err(self.expected_but("`else`", "there is always a value: `if a < b then c else d`"));
        }
        self.word("else")?;
        let no = self.expr()?;
        let kind = ExprKind::If(Box::new(condition), Box::new(yes), Box::new(no));
        Ok(Expr { kind, span: self.span_from(start) })
    }

    /// Operands joined by operators that bind at least as tightly as `least`.
    fn chain(&mut self, least: u8) -> Parse<Expr> {
        let start = self.position();
        let mut left = self.operand()?;
        while let Some(precedence) = self.operator().map(Operator::precedence).filter(|p| *p >= least) {
            let mut links = Vec::new();
            while let Some(operator) = self.operator().filter(|o| o.precedence() == precedence) {
                self.take_operator(operator);
                links.push(Link { operator, operand: self.chain(precedence + 1)? });
            }
            if precedence == Operator::Less.precedence() && links.len() > 1 {
                let span = self.span_from(start);
                self.error(Code::UnexpectedToken, span, "comparisons do not chain")
                    .help("join them with `and`: `a < b and b < c`");
                return Err(Reported);
            }
            left = Expr { kind: ExprKind::Chain(Box::new(left), links), span: self.span_from(start) };
        }
        Ok(left)
    }

    /// The operator here, if there is one.
    fn operator(&self) -> Option<Operator> {
        let token = self.peek()?;
        let equals = matches!(token.kind, TokenKind::Punct { joint: true })
            && self.peek_at(1).is_some_and(|next| next.is_punct('='));
        Some(match (token.text.as_str(), token.kind) {
            ("or", TokenKind::Ident) => Operator::Or,
            ("and", TokenKind::Ident) => Operator::And,
            ("|", _) if self.is_double('|') => Operator::Or,
            ("&", _) if self.is_double('&') => Operator::And,
            (_, TokenKind::Ident) => return None,
            ("<", _) if equals => Operator::LessEqual,
            (">", _) if equals => Operator::GreaterEqual,
            ("=", _) if equals => Operator::Equal,
            ("!", _) if equals => Operator::NotEqual,
            ("<", _) => Operator::Less,
            (">", _) => Operator::Greater,
            ("+", _) => Operator::Add,
            ("-", _) => Operator::Sub,
            ("*", _) => Operator::Mul,
            ("/", _) => Operator::Div,
            _ => return None,
        })
    }

    fn take_operator(&mut self, operator: Operator) {
        if self.is_double('|') || self.is_double('&') {
            self.take_marks_of(operator);
            return;
        }
        let is_two_marks = operator.text().ends_with('=');
        self.advance();
        if is_two_marks {
            self.advance();
        }
    }

    fn operand(&mut self) -> Parse<Expr> {
        let start = self.position();
        if self.eat_punct('-') {
            let inner = self.nested(Cursor::operand)?;
            return Ok(Expr { kind: ExprKind::Neg(Box::new(inner)), span: self.span_from(start) });
        }
        if self.eat_punct('+') {
            return self.nested(Cursor::operand);
        }
        if self.eat_word("not") || self.eat_exclamation() {
            // `not a < b` is `not (a < b)`: nothing else of it has a meaning.
            let inner = self.nested(|cursor| cursor.chain(Operator::Less.precedence()))?;
            return Ok(Expr { kind: ExprKind::Not(Box::new(inner)), span: self.span_from(start) });
        }
        let base = self.primary()?;
        if !self.eat_power(start) {
            return Ok(base);
        }
        let exponent = self.nested(Cursor::operand)?;
        let kind = ExprKind::Power(Box::new(base), Box::new(exponent));
        Ok(Expr { kind, span: self.span_from(start) })
    }

    fn primary(&mut self) -> Parse<Expr> {
        let start = self.position();
        let base = match self.peek().map(|token| token.kind) {
            Some(TokenKind::Number) => return self.quantity(),
            Some(TokenKind::Open(Delimiter::Captured)) => return self.captured(),
            Some(TokenKind::Open(Delimiter::Paren)) => self.parenthesised()?,
            Some(TokenKind::Ident) => self.name_or_call()?,
            _ => return Err(self.expected("an expression")),
        };
        if self.is_double(':') {
            return Err(self.path_of_rust(start));
        }
        let mut members = Vec::new();
        while self.is_punct('.') && self.peek_at(1).is_some_and(|token| token.kind == TokenKind::Ident) {
            self.advance();
            members.push(self.indexed_name("a member")?);
        }
        if let Some(method) = members.last().filter(|_| self.is_open(Delimiter::Paren)) {
            return Err(self.method_call(start, method));
        }
        if members.is_empty() {
            return Ok(base);
        }
        Ok(Expr { kind: ExprKind::Path(Box::new(base), members), span: self.span_from(start) })
    }

    fn name_or_call(&mut self) -> Parse<Expr> {
        let start = self.position();
        let is_call = self.peek_at(1).is_some_and(|next| next.is_open(Delimiter::Paren));
        let kind = if is_call {
            let function = self.ident("a function")?;
            ExprKind::Call(function, self.expr_list()?)
        } else {
            ExprKind::Name(self.indexed_name("a name")?)
        };
        Ok(Expr { kind, span: self.span_from(start) })
    }

    /// `name`, `name[i]`, `name[i][j]`
    pub(super) fn indexed_name(&mut self, what: &str) -> Parse<IndexedName> {
        let ident = self.ident(what)?;
        let mut indices = Vec::new();
        while self.is_open(Delimiter::Bracket) {
            indices.push(self.group(Delimiter::Bracket, "an index", Cursor::expr)?);
        }
        Ok(IndexedName { ident, indices })
    }

    /// `(a, b, …)`, also empty.
    pub(super) fn expr_list(&mut self) -> Parse<Vec<Expr>> {
        self.group(Delimiter::Paren, "`(`", |cursor| {
            let mut list = Vec::new();
            while cursor.peek().is_some() {
                list.push(cursor.expr()?);
                if !cursor.eat_punct(',') {
                    if cursor.peek().is_some() {
                        return Err(cursor.expected("`,` or `)`"));
                    }
                    break;
                }
            }
            Ok(list)
        })
    }

    /// `(expr)`, which takes no unit, or `(expr, expr)`, which may.
    fn parenthesised(&mut self) -> Parse<Expr> {
        let start = self.position();
        let (x, y) = self.group(Delimiter::Paren, "`(`", |cursor| {
            let x = cursor.expr()?;
            let y = if cursor.eat_punct(',') { Some(cursor.expr()?) } else { None };
            if y.is_some() && cursor.is_punct(',') {
                return Err(
                    cursor.expected_but("the closing bracket", "in the plane a vector has two components")
                );
            }
            Ok((x, y))
        })?;
        let Some(y) = y else { return Ok(x) };
        let pair = Expr { kind: ExprKind::Pair(Box::new(x), Box::new(y)), span: self.span_from(start) };
        self.with_unit(pair, start)
    }

    /// An expression that a `macro_rules!` has captured; where it stands, a number could.
    fn captured(&mut self) -> Parse<Expr> {
        let start = self.position();
        let inner = self.group(Delimiter::Captured, "an expression", Cursor::expr)?;
        self.with_unit(inner, start)
    }

    fn with_unit(&mut self, bare: Expr, start: usize) -> Parse<Expr> {
        Ok(match self.unit_after_number()? {
            Some(unit) => {
                Expr { kind: ExprKind::Quantity(Box::new(bare), unit), span: self.span_from(start) }
            }
            None => bare,
        })
    }

    fn quantity(&mut self) -> Parse<Expr> {
        let start = self.position();
        let span = self.here();
        let text = self.peek().map_or("", |token| token.text.as_str());
        self.advance();
        let parts = split_number(text);
        let value = Number::parse_decimal(parts.number.trim_end_matches('.'));
        let Some(value) = value.filter(|value| value.to_f64().is_finite()) else {
            self.error(Code::BadNumber, span, format!("`{text}` is not a number that can be read"));
            return Err(Reported);
        };
        let number = Expr { kind: ExprKind::Number(value), span };
        if parts.suffix.is_empty() {
            return self.with_unit(number, start);
        }
        self.suffixed(number, parts.number, parts.suffix, span)
    }

    /// `0.5m`, `1.0_f64 kg`: an error, and then what was meant.
    fn suffixed(&mut self, number: Expr, text: &str, suffix: &str, span: Span) -> Parse<Expr> {
        if let Some(found) = unit(suffix) {
            self.error(Code::SuffixedNumber, span, format!("the unit `{suffix}` touches its number"))
                .help(format!("write `{text} {suffix}`"));
            let unit = DisplayUnit::product(suffix.to_string(), &[UnitFactor { unit: found, exponent: 1 }]);
            return Ok(Expr { kind: ExprKind::Quantity(Box::new(number), unit), span });
        }
        let whole = self.with_unit(number, span.first as usize)?;
        let text = text.trim_end_matches('_');
        if text == "0" && suffix.starts_with(['x', 'b', 'o']) {
            self.error(Code::BadNumber, span, format!("`{text}{suffix}` is not a decimal number"))
                .help("numbers are decimal");
            return Ok(whole);
        }
        let meant = match &whole.kind {
            ExprKind::Quantity(_, unit) => format!("{text} {}", unit.text),
            _ => text.to_string(),
        };
        self.error(Code::BadNumber, span, format!("a number cannot end in `{suffix}`"))
            .help(format!("numbers are decimal and of one type: write `{meant}`"));
        Ok(whole)
    }
}
