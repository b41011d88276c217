//! Blanks between neighbours in a line.

use std::ops::Range;

use crate::lexer::{Kind, Token};

/// A token, or marks that are one operator.
#[derive(Clone, Debug)]
pub(super) struct Unit {
    pub(super) kind: Kind,
    pub(super) range: Range<usize>,
}

impl Unit {
    pub(super) fn text<'a>(&self, all: &'a str) -> &'a str {
        &all[self.range.clone()]
    }
}

/// Operators of several marks; longer ones first.
const OPERATORS: [&str; 10] = ["..=", "..", "::", "==", "!=", "<=", ">=", "**", "&&", "||"];

/// Tokens with the marks of an operator joined.
pub(super) fn units(text: &str, tokens: &[Token]) -> Vec<Unit> {
    let (mut units, mut at) = (Vec::new(), 0);
    while let Some(token) = tokens.get(at) {
        let rest = &text[token.range.start..];
        let operator = OPERATORS.iter().find(|of| token.kind == Kind::Mark && rest.starts_with(**of));
        let length = operator.map_or(token.range.len(), |operator| operator.len());
        units.push(Unit { kind: token.kind, range: token.range.start..token.range.start + length });
        at += operator.map_or(1, |operator| operator.len());
    }
    units
}

/// Keywords that begin an operand, so that a `-` after them is a sign and a `(` stands apart.
const IN_FRONT: [&str; 5] = ["given", "if", "not", "output", "when"];
/// Keywords that stand between operands. Where an operand is expected they are names.
const BETWEEN: [&str; 10] = ["and", "at", "else", "for", "from", "in", "on", "or", "then", "within"];
/// Those of them that name parts as well: the blank decides the meaning of a `(` after them.
const NAMES_TOO: [&str; 5] = ["at", "for", "from", "on", "output"];

/// Place of a unit among its neighbours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Role {
    /// Nothing stands before.
    #[default]
    Begin,
    /// It ends an operand: a name, a number, `)`.
    Operand,
    /// A keyword that an operand follows.
    Word,
    /// `(` or `[`.
    Open,
    /// `{`.
    Block,
    /// `}`.
    BlockEnd,
    /// `,`, `;` or `:`.
    Separator,
    /// `*`, `/`, `^`, `.`, `::`: without blanks.
    Tight,
    /// `+`, `=`, `<`: with blanks.
    Loose,
    /// A sign, or another mark that touches the operand after it.
    Prefix,
    /// A unit without a place in the language: the blank stays as it was.
    Other,
}

/// The neighbour before, and what the present item has had.
#[derive(Debug, Default)]
pub(super) struct Spacing {
    before: Role,
    /// Was there the keyword `in`? Then a range is one of numbers, `0..8`, and no bound.
    counts: bool,
    /// The `}` before begins its line.
    begins_line: bool,
    /// The keyword before may be a name.
    may_be_name: bool,
}

impl Spacing {
    /// Is there a blank before a unit? `was_apart` is true if the text has one, `begins_line` if it is a bracket at the beginning of a
    /// line.
    pub(super) fn take(&mut self, text: &str, unit: &Unit, was_apart: bool, begins_line: bool) -> bool {
        let word = unit.text(text);
        if unit.kind.is_comment() {
            return true;
        }
        let role = self.role(unit.kind, word);
        let is_apart = self.is_apart(role, word, was_apart);
        match word {
            ";" | "{" | "}" => self.counts = false,
            "in" => self.counts = true,
            _ => {}
        }
        self.begins_line = begins_line;
        self.may_be_name = NAMES_TOO.contains(&word);
        self.before = role;
        is_apart
    }

    fn role(&self, kind: Kind, word: &str) -> Role {
        let is_after_operand = matches!(self.before, Role::Operand | Role::BlockEnd);
        match kind {
            Kind::Word if IN_FRONT.contains(&word) && self.before != Role::Tight => return Role::Word,
            Kind::Word if BETWEEN.contains(&word) && is_after_operand => return Role::Word,
            Kind::Mark => {}
            _ => return Role::Operand,
        }
        let is_sign = !is_after_operand;
        match word {
            "(" | "[" => Role::Open,
            ")" | "]" => Role::Operand,
            "{" => Role::Block,
            "}" => Role::BlockEnd,
            "," | ";" | ":" => Role::Separator,
            "-" | "+" | "!" if is_sign => Role::Prefix,
            "#" | "$" => Role::Prefix,
            ".." | "..=" if self.counts => Role::Tight,
            "*" | "/" | "^" | "**" | "." | "::" => Role::Tight,
            "+" | "-" | "=" | "==" | "!=" | "<" | "<=" | ">" | ">=" | "|" | "||" | "&&" | ".." | "..=" => {
                Role::Loose
            }
            _ => Role::Other,
        }
    }

    fn is_apart(&self, role: Role, word: &str, was_apart: bool) -> bool {
        match (self.before, role) {
            (Role::Begin, _) => false,
            (Role::Other, _) | (_, Role::Other) => was_apart,
            (Role::Block, Role::BlockEnd) | (_, Role::Separator) | (Role::Open | Role::Prefix, _) => false,
            (Role::BlockEnd, Role::BlockEnd) => !self.begins_line,
            (_, Role::Block | Role::BlockEnd) | (Role::Block, _) => true,
            (Role::BlockEnd, _) => ![")", "]"].contains(&word),
            // A path may begin with `::`.
            (Role::Loose | Role::Separator | Role::Word, Role::Tight) => word == "::",
            (Role::Word, Role::Open) if self.may_be_name => was_apart,
            (Role::Tight, _) | (_, Role::Tight) => false,
            (_, _) if [")", "]"].contains(&word) => false,
            (Role::Operand, Role::Open) => false,
            _ => true,
        }
    }
}
