//! Events that give states other values.
//!
//! ```text
//! "when" (expr | "start") "{" { path "=" expr ";" } "}"
//! ```

use proc_macro2::Delimiter;
use syn::buffer::Cursor;
use syn::ext::IdentExt;
use syn::{Token, token};

use super::expr::{Expr, ExprKind, Link};
use super::input::{Input, Reported, Result};
use super::operator::Operator;
use crate::diag::Code;
use crate::span::Span;

/// `when condition { target = value; … }`
#[derive(Clone, Debug)]
pub struct When {
    /// At this moment.
    pub moment: Moment,
    /// Targets and values.
    pub assignments: Vec<Assignment>,
}

/// The moment of an event.
#[derive(Clone, Debug)]
pub enum Moment {
    /// `start`: as a run begins.
    Start(Span),
    /// When a condition becomes true.
    BecomesTrue(Expr),
}

/// The moment as a run begins.
const START: &str = "start";

/// Words that let go of a joint elsewhere.
const RELEASES: [&str; 4] = ["release", "detach", "remove", "disconnect"];

/// `target = value;`
#[derive(Clone, Debug)]
pub struct Assignment {
    /// A state, or the velocity of a body.
    pub target: Expr,
    /// Its value from then on.
    pub value: Expr,
}

impl When {
    /// `condition { … }` after `when`.
    pub(super) fn parse(input: Input) -> Result<When> {
        if input.next() == START && input.peek2(token::Brace) {
            let moment = Moment::Start(input.here());
            input.advance();
            return Ok(When { moment, assignments: Self::assignments(input)? });
        }
        let start = input.position();
        let condition = Expr::parse(input).unwrap_or_else(|Reported| {
            input.advance_to(|input| input.peek(Token![;]) || input.peek(token::Brace));
            Expr { kind: ExprKind::Unknown, span: input.span_from(start) }
        });
        if !input.peek(token::Brace) && matches!(condition.kind, ExprKind::Unknown) {
            return Err(Reported);
        }
        if !input.peek(token::Brace) {
            return Err(input.expected_but("`{`", "write `when condition { state = value; }`"));
        }
        Ok(When { moment: Moment::BecomesTrue(condition), assignments: Self::assignments(input)? })
    }

    fn assignments(input: Input) -> Result<Vec<Assignment>> {
        let mut assignments = Vec::new();
        input.group(Delimiter::Brace, "`{`", |input| {
            while !input.is_empty() {
                let start = input.position();
                match Assignment::parse(input) {
                    Ok(assignment) => assignments.push(assignment),
                    Err(Reported) => input.recover(start),
                }
            }
            Ok(())
        })?;
        Ok(assignments)
    }
}

impl Assignment {
    fn parse(input: Input) -> Result<Assignment> {
        let word = input.next();
        if RELEASES.contains(&word) && input.peek2(syn::Ident::peek_any) {
            let help = "give the joint a condition, `{ when: holds > 0.5; }`, and set it here: `holds = 0;`";
            let message = format!("`{word}` sets nothing");
            input.error(Code::UnexpectedToken, input.here(), message).help(help);
            return Err(Reported);
        }
        if let Some(operator) = compound(input.cursor()) {
            return Err(set_by_compound(input, operator));
        }
        let target = Expr::parse(input)?;
        if let ExprKind::Chain(left, links) = &target.kind
            && let [Link { operator: Operator::Equal, operand }] = &links[..]
        {
            let [left, right] = [left.span, operand.span].map(|span| input.text_of(span));
            let help = format!("write `{left} = {right};`");
            input.error(Code::UnexpectedToken, target.span, "a value is set with one `=`").help(help);
            return Err(Reported);
        }
        input.expect(Token![=], "`=`")?;
        Ok(Assignment { target, value: input.last_value()? })
    }
}

/// The operator of `target += value`, if that is how the assignment here is written.
fn compound(mut cursor: Cursor) -> Option<char> {
    loop {
        let Some((mark, after)) = cursor.punct() else {
            cursor = cursor.token_tree()?.1;
            continue;
        };
        let is_equals = after.punct().is_some_and(|(mark, _)| mark.as_char() == '=');
        match mark.as_char() {
            operator @ ('+' | '-' | '*' | '/') if is_equals => return Some(operator),
            '=' | ';' => return None,
            _ => cursor = after,
        }
    }
}

/// Says how `target += value` is written here.
fn set_by_compound(input: Input, operator: char) -> Reported {
    let start = input.position();
    input.advance_to(|input| compound(input.cursor()).is_some() && input.next() == operator.to_string());
    let target = input.text_of(input.span_from(start));
    let span = input.here();
    input.advance_to(|input| input.peek(Token![;]));
    input
        .error(Code::UnexpectedToken, span, format!("`{operator}=` is no operator here"))
        .help(format!("write `{target} = {target} {operator} …;`"));
    Reported
}
