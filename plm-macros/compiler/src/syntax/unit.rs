//! Units in expressions and declarations.
//!
//! ```text
//! unit  := uatom { ("*" | "/") uatom }      greedy, binds tighter than * and / of expressions
//! uatom := UNIT ["^" ["-"] INT] | "(" unit ")"
//! ```
//! After `*` or `/` the unit goes on only if the next token is the name of a unit that is not followed by `(`, `.` or
//! `[`, or a group that is wholly a unit: `10 N/area`, `2 m*min(a, b)` and `1 N/bar[1].x` come out right.

use super::cursor::{Cursor, Parse, Reported};
use crate::diag::{Code, nearest};
use crate::token::{Delimiter, TokenKind};
use crate::units::{DisplayUnit, UnitFactor, is_unit, names, unit};

/// Words that may follow a number without being a unit.
const WORDS: &[&str] = &["then", "else", "and", "or", "in"];

/// Largest exponent of a unit.
const MAX_EXPONENT: i32 = 9;

impl Cursor<'_> {
    /// The unit after a number or a pair, if there is one.
    pub(super) fn unit_after_number(&mut self) -> Parse<Option<DisplayUnit>> {
        let Some(token) = self.peek() else { return Ok(None) };
        let is_word = token.kind == TokenKind::Ident && !WORDS.contains(&token.text.as_str());
        // `mass: 10 inertia: 1` lacks a semicolon, not a unit.
        let is_next_field = self.peek_at(1).is_some_and(|next| next.is_punct(':'));
        if (is_word && !is_next_field) || self.is_unit_group(0) { self.unit().map(Some) } else { Ok(None) }
    }

    /// A unit where a value is declared: also `1` for a bare number, and `1/s`.
    pub(super) fn declared_unit(&mut self) -> Parse<DisplayUnit> {
        let is_one = self.peek().is_some_and(|token| token.kind == TokenKind::Number && token.text == "1");
        let mut unit = UnitText { text: String::new(), factors: Vec::new() };
        if is_one {
            self.advance();
            self.further_factors(&mut unit, 1)?;
            unit.text = if unit.text.is_empty() { String::new() } else { format!("1{}", unit.text) };
        } else {
            self.unit_factors(&mut unit, 1)?;
        }
        if self.is_punct('*') || self.is_punct('/') {
            // No expression can go on here: it is a unit, and none that is known.
            self.advance();
            self.unit_atom(&mut unit, 1)?;
        }
        Ok(DisplayUnit::product(unit.text, &unit.factors))
    }

    /// A unit.
    pub(super) fn unit(&mut self) -> Parse<DisplayUnit> {
        let mut unit = UnitText { text: String::new(), factors: Vec::new() };
        self.unit_factors(&mut unit, 1)?;
        Ok(DisplayUnit::product(unit.text, &unit.factors))
    }

    fn unit_factors(&mut self, unit: &mut UnitText, sign: i32) -> Parse<()> {
        self.unit_atom(unit, sign)?;
        self.further_factors(unit, sign)
    }

    fn further_factors(&mut self, unit: &mut UnitText, sign: i32) -> Parse<()> {
        while self.unit_goes_on() {
            let below = self.is_punct('/');
            self.advance();
            unit.text.push(if below { '/' } else { '*' });
            self.unit_atom(unit, if below { -sign } else { sign })?;
        }
        Ok(())
    }

    fn unit_goes_on(&self) -> bool {
        (self.is_punct('*') || self.is_punct('/')) && (self.is_unit_name(1) || self.is_unit_group(1))
    }

    fn unit_atom(&mut self, unit: &mut UnitText, sign: i32) -> Parse<()> {
        if self.is_open(Delimiter::Paren) {
            unit.text.push('(');
            self.nested(|cursor| {
                cursor.group(Delimiter::Paren, "a unit", |cursor| cursor.unit_factors(unit, sign))
            })?;
            unit.text.push(')');
            return Ok(());
        }
        let start = self.position();
        let name = self.ident("a unit")?;
        let Some(found) = self::unit(&name.text) else {
            return Err(self.unknown_unit(&name.text, name.span));
        };
        unit.text.push_str(found.name);
        let exponent = if self.eat_power(start) { self.unit_exponent(unit)? } else { 1 };
        unit.factors.push(UnitFactor { unit: found, exponent: sign * exponent });
        Ok(())
    }

    fn unit_exponent(&mut self, unit: &mut UnitText) -> Parse<i32> {
        let negative = self.eat_punct('-');
        let number = self.peek().filter(|token| token.kind == TokenKind::Number);
        let value =
            number.and_then(|token| token.text.parse::<i32>().ok()).filter(|value| *value <= MAX_EXPONENT);
        let Some(value) = value else {
            let message = format!("the exponent of a unit is a whole number up to {MAX_EXPONENT}");
            self.error(Code::BadUnit, self.here(), message);
            return Err(Reported);
        };
        self.advance();
        unit.text.push('^');
        unit.text.push_str(if negative { "-" } else { "" });
        unit.text.push_str(&value.to_string());
        Ok(if negative { -value } else { value })
    }

    fn unknown_unit(&mut self, name: &str, span: crate::span::Span) -> Reported {
        // Units of two letters are all alike: what differs in one is another.
        let near = nearest(name, names()).filter(|near| name.len() > 2 || near.eq_ignore_ascii_case(name));
        let help = unit_help(name).or_else(|| Some(format!("write `{}`", near?)));
        let diagnostic = self.error(Code::UnknownUnit, span, format!("unknown unit `{name}`"));
        match help {
            Some(help) => diagnostic.help(help),
            None => diagnostic.note(format!("units: {}", names().collect::<Vec<_>>().join(", "))),
        };
        Reported
    }

    /// Is the token some places ahead a unit, not a function, a body or an array of the same name?
    fn is_unit_name(&self, ahead: usize) -> bool {
        let is_name = self.peek_at(ahead).is_some_and(|t| t.kind == TokenKind::Ident && is_unit(&t.text));
        is_name && !self.peek_at(ahead + 1).is_some_and(holds_on_name)
    }

    /// Does a group open some places ahead that is wholly a unit?
    fn is_unit_group(&self, ahead: usize) -> bool {
        if !self.peek_at(ahead).is_some_and(|token| token.is_open(Delimiter::Paren)) {
            return false;
        }
        let length = self.behind_group(self.position() + ahead) - self.position();
        let mut names = 0;
        for at in ahead + 1..length.saturating_sub(1) {
            let Some(token) = self.peek_at(at) else { return false };
            let fits = match token.kind {
                TokenKind::Ident => self.is_unit_name(at),
                TokenKind::Number => self.peek_at(at - 1).is_some_and(|before| "^-".contains(&before.text)),
                TokenKind::Punct { .. } => "*/^-".contains(&token.text),
                TokenKind::Open(Delimiter::Paren) | TokenKind::Close(Delimiter::Paren) => true,
                _ => false,
            };
            if !fits {
                return false;
            }
            names += usize::from(token.kind == TokenKind::Ident);
        }
        names > 0
    }
}

/// What is written for a unit that goes by another name elsewhere.
pub(crate) fn unit_help(name: &str) -> Option<String> {
    let word = if name.len() > 2 { name.to_lowercase() } else { name.to_string() };
    let known = match word.as_str() {
        "Nm" => "N*m",
        "meter" | "meters" | "metre" | "metres" => "m",
        "kilogram" | "kilograms" => "kg",
        "second" | "seconds" | "sec" => "s",
        "newton" | "newtons" => "N",
        "turn" | "turns" => "rev",
        "rpm" => "rev/min",
        "l" => "L",
        "hr" => "h",
        "degrees" => "deg",
        "radian" | "radians" => "rad",
        "g" | "gram" | "grams" => {
            return Some("grams and g are no units here: write `1e-3 kg` or `9.81 m/s^2`".to_string());
        }
        "f64" | "f32" | "float" | "double" | "i32" | "int" | "usize" => {
            let help = "a number has a unit and no type: write `m`, `N/m`, or `1` where it has none";
            return Some(help.to_string());
        }
        // `m2`
        _ => {
            let (unit, exponent) = name.split_at_checked(name.len().checked_sub(1)?)?;
            let is_power = is_unit(unit) && exponent.starts_with(|digit: char| ('2'..='9').contains(&digit));
            return is_power.then(|| format!("write `{unit}^{exponent}`"));
        }
    };
    Some(format!("write `{known}`"))
}

struct UnitText {
    text: String,
    factors: Vec<UnitFactor>,
}

/// Does this token make a name of what stands before it: a call, a member, an index?
fn holds_on_name(next: &crate::token::Token) -> bool {
    next.is_open(Delimiter::Paren) || next.is_open(Delimiter::Bracket) || next.is_punct('.')
}
