//! Rows of contact: gaps that push, and frictions.
//!
//! ```text
//! "unilateral" name ":" expr (">=" | "<=") expr (";" | "{" ["restitution" ":" expr ";"] ["when" ":" expr ";"] "}")
//! "friction" name ":" "rate" "(" expr ")" "within" bound (";" | "{" ["static" ":" bound ";"] ["when" ":" expr ";"] "}")
//! bound := expr [".." expr]
//! ```

use proc_macro2::Delimiter;
use syn::{Token, token};

use super::expr::{Expr, ExprKind};
use super::input::{Input, Reported, Result};
use super::keyword as kw;
use super::name::IndexedName;
use super::operator::Operator;
use crate::diag::{Code, nearest};
use crate::span::Span;

/// `unilateral name: left >= right { restitution: expr; }`
#[derive(Clone, Debug)]
pub struct Unilateral {
    /// Its name.
    pub name: IndexedName,
    /// The greater side and the lesser one: the gap is their difference.
    pub sides: [Expr; 2],
    /// The coefficient of restitution.
    pub restitution: Option<Expr>,
    /// It exists while this holds; always, where it is not written.
    pub when: Option<Expr>,
}

/// `friction name: rate(expr) within bound { static: bound; }`
#[derive(Clone, Debug)]
pub struct Friction {
    /// Its name.
    pub name: IndexedName,
    /// The displacement whose rate is the slip.
    pub displacement: Expr,
    /// The bound while it slips.
    pub kinetic: Bound,
    /// The bound while it sticks, if it is another one.
    pub adhesion: Option<Bound>,
    /// It exists while this holds; always, where it is not written.
    pub when: Option<Expr>,
}

/// The bound of a friction.
#[derive(Clone, Debug)]
pub struct Bound {
    /// The lower limit, written negative; that of `upper` on the other side, if it is not written.
    pub lower: Option<Expr>,
    /// The upper limit.
    pub upper: Expr,
}

impl Unilateral {
    /// `name: left >= right …` after `unilateral`.
    pub(super) fn parse(input: Input) -> Result<Unilateral> {
        let start = input.position();
        let name = IndexedName::parse(input, "the name of the row")?;
        if [".", "<", ">", "+", "-", "*", "/"].contains(&input.next()) {
            return Err(input.row_without_name(start, "unilateral"));
        }
        input.expect(Token![:], "`:`")?;
        let condition = readable(input);
        let is_read = !is_unknown(&condition);
        let sides = input.sides_of_gap(condition);
        let Beside { said: restitution, when } =
            Beside::parse(input, is_read, "a unilateral row", "restitution", Expr::parse)?;
        Ok(Unilateral { name, sides, restitution, when })
    }
}

impl Friction {
    /// `name: rate(expr) within bound …` after `friction`.
    pub(super) fn parse(input: Input) -> Result<Friction> {
        let start = input.position();
        let name = IndexedName::parse(input, "the name of the row")?;
        if input.peek(token::Paren) && name.ident.text == "rate" {
            return Err(input.row_without_name(start, "friction"));
        }
        if !input.eat(Token![:]) {
            let help = "write `friction name: rate(…) within 5 N;`; a part of your own has another name than `friction`";
            return Err(input.expected_but("`:`", help));
        }
        let slip = readable(input);
        let displacement = input.displacement_of(slip);
        let kinetic = Bound::after(input, !is_unknown(&displacement));
        let Beside { said: adhesion, when } =
            Beside::parse(input, !is_unknown(&kinetic.upper), "a friction", "static", Bound::parse)?;
        Ok(Friction { name, displacement, kinetic, adhesion, when })
    }
}

fn is_unknown(expr: &Expr) -> bool {
    matches!(expr.kind, ExprKind::Unknown)
}

impl Bound {
    /// `within bound` after a slip; one that cannot be read is unknown. What is missing after an unreadable slip is no second
    /// mistake.
    fn after(input: Input, slip_is_read: bool) -> Bound {
        let start = input.position();
        if input.eat(kw::within) {
            if let Ok(bound) = Bound::parse(input) {
                return bound;
            }
        } else if slip_is_read {
            input.expected_but("`within`", "say how great it may be: `friction name: rate(…) within 5 N;`");
        }
        Bound { lower: None, upper: skipped(input, start) }
    }

    /// `expr` or `expr .. expr`
    fn parse(input: Input) -> Result<Bound> {
        let first = Expr::parse(input)?;
        if !input.eat(Token![.]) {
            return Ok(Bound { lower: None, upper: first });
        }
        input.expect(Token![.], "`..`")?;
        Ok(Bound { lower: Some(first), upper: Expr::parse(input)? })
    }

    /// From its first token to its last.
    pub fn span(&self) -> Span {
        self.lower.as_ref().map_or(self.upper.span, |lower| lower.span.to(self.upper.span))
    }
}

/// An expression of a row. If it cannot be read, what is left of it is skipped.
fn readable(input: Input) -> Expr {
    let start = input.position();
    Expr::parse(input).unwrap_or_else(|Reported| skipped(input, start))
}

/// Skips what cannot be read of a row: to its bound, to its braces or to its end.
fn skipped(input: Input, start: usize) -> Expr {
    input.advance_to(|input| input.peek(Token![;]) || input.peek(token::Brace) || input.peek(kw::within));
    Expr { kind: ExprKind::Unknown, span: input.span_from(start) }
}

/// Sentences of a row in braces.
struct Beside<T> {
    /// After its own word.
    said: Option<T>,
    /// After `when`.
    when: Option<Expr>,
}

impl<T> Beside<T> {
    /// The end of a row: `;`, or in braces what it says beside its condition, by its `word` and by `when`.
    fn parse(
        input: Input,
        is_read: bool,
        row: &str,
        word: &str,
        read: fn(Input) -> Result<T>,
    ) -> Result<Beside<T>> {
        let mut beside = Beside { said: None, when: None };
        if !input.peek(token::Brace) {
            if is_read {
                input.semicolon()?;
            } else {
                input.advance_to(|input| input.peek(Token![;]));
                input.eat(Token![;]);
            }
            return Ok(beside);
        }
        input.group(Delimiter::Brace, "`{`", |input| {
            while !input.is_empty() {
                let start = input.position();
                let found = if input.next() == "when" {
                    once(input, &mut beside.when, "when", Expr::parse)
                } else {
                    known(input, row, word).and_then(|()| once(input, &mut beside.said, word, read))
                };
                if let Err(Reported) = found {
                    input.recover(start);
                }
            }
            Ok(())
        })?;
        Ok(beside)
    }
}

impl Input<'_> {
    /// The end of a constraint: `;`, or `{ when: condition; }`
    pub(super) fn condition_of_row(self) -> Result<Option<Expr>> {
        if !self.peek(token::Brace) {
            self.semicolon()?;
            return Ok(None);
        }
        let mut when = None;
        self.group(Delimiter::Brace, "`{`", |input| {
            while !input.is_empty() {
                let start = input.position();
                let found = known(input, "a constraint", "when");
                if found.and_then(|()| once(input, &mut when, "when", Expr::parse)).is_err() {
                    input.recover(start);
                }
            }
            Ok(())
        })?;
        Ok(when)
    }
}

/// `word: value;`, which may stand once.
fn once<T>(input: Input, place: &mut Option<T>, word: &str, read: fn(Input) -> Result<T>) -> Result<()> {
    let start = input.position();
    input.advance();
    input.colon_of(word)?;
    let value = read(input)?;
    input.semicolon()?;
    if place.is_some() {
        let span = Span { first: start as u32, last: start as u32, ..input.here() };
        input.error(Code::RepeatedItem, span, format!("`{word}` is given twice"));
    } else {
        *place = Some(value);
    }
    Ok(())
}

/// Refuses words that a row does not have.
fn known(input: Input, row: &str, word: &str) -> Result<()> {
    let found = input.next();
    if found == word {
        return Ok(());
    }
    let mut diagnostic = input.error(Code::UnknownItem, input.here(), format!("{row} has no `{found}`"));
    match (later(found), nearest(found, [word, "when"])) {
        (Some(help), _) => diagnostic.help(help),
        (None, Some(near)) => diagnostic.help(format!("write `{near}: …;`")),
        (None, None) if word == "when" => diagnostic.note("in its braces stands `when: …;`"),
        (None, None) => diagnostic.note(format!("in its braces stand `{word}: …;` and `when: …;`")),
    };
    Err(Reported)
}

/// Help for words that a row of contact does not have.
fn later(word: &str) -> Option<&'static str> {
    Some(match word {
        "if" | "where" | "while" => "write `when: …;`: the row exists while that holds",
        "mu" | "coefficient" => "the bound says it: `friction name: rate(…) within mu*reaction(row);`",
        "friction" => "a friction is a row of its own: `friction name: rate(…) within mu*reaction(row);`",
        "stiffness" | "damping" => "a row of contact is rigid; what gives way is a `spring`",
        _ => return None,
    })
}

/// The sides of a gap and the displacement of a slip.
impl Input<'_> {
    /// The greater side of a comparison and the lesser one.
    fn sides_of_gap(self, condition: Expr) -> [Expr; 2] {
        let Expr { kind, span } = condition;
        let unknown = || Expr { kind: ExprKind::Unknown, span };
        let (left, link) = match kind {
            ExprKind::Unknown => return [unknown(), unknown()],
            ExprKind::Chain(left, mut links) if links.len() == 1 && links[0].operator.compares() => {
                (*left, links.remove(0))
            }
            _ => {
                let message = format!("expected a gap and `>= 0`, found `{}`", self.text_of(span));
                let help = format!("write `{} >= 0`", self.text_of(span));
                self.error(Code::UnexpectedToken, span, message).help(help);
                return [unknown(), unknown()];
            }
        };
        let right = link.operand;
        let mark = Span { first: left.span.last + 1, last: right.span.first - 1, ..span };
        let better = match link.operator {
            Operator::GreaterEqual => return [left, right],
            Operator::LessEqual => return [right, left],
            Operator::Less => "<=",
            _ => ">=",
        };
        let message = format!("expected `>=` or `<=`, found `{}`", link.operator.text());
        let help = match link.operator {
            Operator::Less | Operator::Greater => format!("a gap may be zero: write `{better}`"),
            _ => "a row that always holds is a `constraint`".to_string(),
        };
        self.error(Code::UnexpectedToken, mark, message).help(help);
        if better == "<=" { [right, left] } else { [left, right] }
    }

    /// The displacement in `rate(displacement)`.
    fn displacement_of(self, slip: Expr) -> Expr {
        let Expr { kind, span } = slip;
        match kind {
            ExprKind::Call(function, mut arguments) if function.text == "rate" && arguments.len() == 1 => {
                return arguments.remove(0);
            }
            ExprKind::Unknown => {}
            ExprKind::Chain(left, links) if links.len() == 1 && links[0].operator.compares() => {
                let bound = &links[0].operand;
                let mark = Span { first: left.span.last + 1, last: bound.span.first - 1, ..span };
                let message = format!("expected `within`, found `{}`", links[0].operator.text());
                let help = format!("write `{} within {}`", self.text_of(left.span), self.text_of(bound.span));
                self.error(Code::UnexpectedToken, mark, message).help(help);
            }
            _ => {
                let message = format!("expected a slip `rate(…)`, found `{}`", self.text_of(span));
                self.error(Code::UnexpectedToken, span, message).help(
                    "a slip is the rate of one length or angle, which is kept while it sticks: write `rate(…)` around all of it",
                );
            }
        }
        Expr { kind: ExprKind::Unknown, span }
    }

    /// `unilateral b.y >= 0`: a name is missing. Shows the item with one.
    fn row_without_name(self, start: usize, word: &str) -> Reported {
        self.advance_to(|input| input.peek(Token![;]) || input.peek(token::Brace));
        let span = self.span_from(start);
        let help = format!("write `{word} name: {};`", self.text_of(span));
        self.error(Code::UnexpectedToken, span, format!("a `{word}` needs a name")).help(help);
        Reported
    }
}
