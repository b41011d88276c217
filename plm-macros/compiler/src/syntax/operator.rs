//! Binary operators.

use proc_macro2::Spacing;

use super::input::Input;

/// Binary operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// `or`
    Or,
    /// `and`
    And,
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
    /// `==`
    Equal,
    /// `!=`
    NotEqual,
    /// `+`
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `/`
    Div,
}

impl Operator {
    /// The operator that stands here. `||` and `&&` are none of the language, and understood.
    pub(super) fn peek(input: Input) -> Option<Operator> {
        if let Some((word, _)) = input.cursor().ident() {
            return match word.to_string().as_str() {
                "or" => Some(Operator::Or),
                "and" => Some(Operator::And),
                _ => None,
            };
        }
        let (mark, after) = input.cursor().punct()?;
        let next = after.punct().filter(|_| mark.spacing() == Spacing::Joint);
        Some(match (mark.as_char(), next.map(|(next, _)| next.as_char())) {
            ('|', Some('|')) => Operator::Or,
            ('&', Some('&')) => Operator::And,
            ('<', Some('=')) => Operator::LessEqual,
            ('>', Some('=')) => Operator::GreaterEqual,
            ('=', Some('=')) => Operator::Equal,
            ('!', Some('=')) => Operator::NotEqual,
            ('<', _) => Operator::Less,
            ('>', _) => Operator::Greater,
            ('+', _) => Operator::Add,
            ('-', _) => Operator::Sub,
            ('*', _) => Operator::Mul,
            ('/', _) => Operator::Div,
            _ => return None,
        })
    }

    /// How tightly it binds, from 0.
    pub fn precedence(self) -> u8 {
        match self {
            Operator::Or => 0,
            Operator::And => 1,
            Operator::Less
            | Operator::LessEqual
            | Operator::Greater
            | Operator::GreaterEqual
            | Operator::Equal
            | Operator::NotEqual => 2,
            Operator::Add | Operator::Sub => 3,
            Operator::Mul | Operator::Div => 4,
        }
    }

    /// Does it compare two numbers?
    pub fn compares(self) -> bool {
        self.precedence() == Operator::Less.precedence()
    }

    /// As it is written.
    pub fn text(self) -> &'static str {
        match self {
            Operator::Or => "or",
            Operator::And => "and",
            Operator::Less => "<",
            Operator::LessEqual => "<=",
            Operator::Greater => ">",
            Operator::GreaterEqual => ">=",
            Operator::Equal => "==",
            Operator::NotEqual => "!=",
            Operator::Add => "+",
            Operator::Sub => "-",
            Operator::Mul => "*",
            Operator::Div => "/",
        }
    }
}
