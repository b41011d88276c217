//! What people write who know Rust, or another language: told once, with what it is here.

use super::ast::{Expr, ExprKind, IndexedName, Link, Operator};
use super::cursor::{Cursor, Parse, Reported};
use crate::diag::Code;
use crate::span::Span;
use crate::token::{Delimiter, Token, TokenKind};

/// Words of languages that stand before the name of a type.
const TYPES: &[&str] =
    &["struct", "mechanism", "mod", "module", "model", "system", "class", "enum", "fn", "type"];

impl Cursor<'_> {
    /// Do two equal marks stand here, as in `&&`?
    pub(super) fn is_double(&self, mark: char) -> bool {
        let is_joint = self.peek().is_some_and(|token| token.kind == TokenKind::Punct { joint: true });
        is_joint && self.is_punct(mark) && self.peek_at(1).is_some_and(|token| token.is_punct(mark))
    }

    /// Takes two marks and says what they are here.
    fn take_double(&mut self, help: String) {
        let start = self.position();
        self.advance();
        self.advance();
        let span = self.span_from(start);
        let marks = self.text_of(span);
        self.error(Code::UnexpectedToken, span, format!("`{marks}` is no operator here")).help(help);
    }

    /// `&&` and `||`, which are words.
    pub(super) fn take_marks_of(&mut self, operator: Operator) {
        self.take_double(format!("write `{}`", operator.text()));
    }

    /// `!` before an operand.
    pub(super) fn eat_exclamation(&mut self) -> bool {
        let span = self.here();
        let found = self.eat_punct('!');
        if found {
            self.error(Code::UnexpectedToken, span, "`!` is no operator here").help("write `not`");
        }
        found
    }

    /// `^`, or `**` for it; what stands before it began at `start`.
    pub(super) fn eat_power(&mut self, start: usize) -> bool {
        if !self.is_double('*') {
            return self.eat_punct('^');
        }
        let base = self.text_of(self.span_from(start));
        let exponent = self.peek_at(2).map_or("2", |token| token.text.as_str());
        self.take_double(format!("write `{base}^{exponent}`"));
        true
    }

    /// `arm.angle.sin()`: functions stand before their arguments. The receiver began at `start`, and the brackets of the
    /// call stand here.
    pub(super) fn method_call(&mut self, start: usize, method: &IndexedName) -> Reported {
        let name = method.ident.text.as_str();
        let receiver = self.text_of(Span {
            first: start as u32,
            last: method.ident.span.first - 2,
            ..method.ident.span
        });
        let open = self.position();
        self.go_to(self.behind_group(open));
        let all = self.span_from(open);
        let inside = Span { first: all.first + 1, last: all.last - 1, ..all };
        let arguments = if inside.last < inside.first { String::new() } else { self.text_of(inside) };
        let call = match name {
            "pow" | "powi" | "powf" => format!("{receiver}^{arguments}"),
            "to_radians" => format!("{receiver} deg"),
            _ if arguments.is_empty() => format!("{name}({receiver})"),
            _ => format!("{name}({receiver}, {arguments})"),
        };
        let message = format!("`{name}` stands behind a point, and there are functions alone");
        self.error(Code::UnexpectedToken, method.ident.span, message).help(format!("write `{call}`"));
        Reported
    }

    /// `std::f64::consts::PI`, behind its first word.
    pub(super) fn path_of_rust(&mut self, start: usize) -> Reported {
        while self.is_double(':') {
            self.advance();
            self.advance();
            self.advance();
        }
        let span = self.span_from(start);
        let text = self.text_of(span);
        let help = match text.rsplit("::").next() {
            Some("PI") => "write `pi`",
            _ => CONSTANTS,
        };
        self.error(Code::UnexpectedToken, span, format!("`{text}` is a path of Rust")).help(help);
        Reported
    }

    /// `struct` and its like before the name of the mechanism.
    pub(super) fn skip_word_of_types(&mut self, visibility: &str) {
        let is_word = self.peek().is_some_and(|token| TYPES.contains(&token.text.as_str()));
        let Some(name) = self.peek_at(1).filter(|next| is_word && next.kind == TokenKind::Ident) else {
            return;
        };
        let word = self.peek().map_or("", |token| token.text.as_str());
        let space = if visibility.is_empty() { "" } else { " " };
        let help = format!("write `{visibility}{space}{} {{ … }}`", name.text);
        let message = format!("`{word}` does not stand before a mechanism");
        self.error(Code::UnexpectedToken, self.here(), message).help(help);
        self.advance();
    }

    /// `<T>` behind the name of the mechanism.
    pub(super) fn skip_generics(&mut self) {
        if !self.is_punct('<') {
            return;
        }
        let start = self.position();
        while self.peek().is_some_and(|token| !token.is_open(Delimiter::Brace)) {
            self.go_to(self.behind(self.position()));
        }
        let span = self.span_from(start);
        self.error(Code::UnexpectedToken, span, "a mechanism is not generic over types")
            .help("every mechanism runs on any scalar: leave this out, and see `of` beside `new`");
    }

    /// An attribute that is not documentation, if one stands here.
    pub(super) fn eat_attribute(&mut self) -> bool {
        let bang = usize::from(self.peek_at(1).is_some_and(|token| token.is_punct('!')));
        if !self.is_punct('#')
            || !self.peek_at(1 + bang).is_some_and(|token| token.is_open(Delimiter::Bracket))
        {
            return false;
        }
        let start = self.position();
        let is_allow = self.peek_at(2 + bang).is_some_and(|token| token.is_word("allow"));
        self.go_to(self.behind_group(start + 1 + bang));
        let span = self.span_from(start);
        let diagnostic = self.error(Code::UnexpectedToken, span, "attributes have no place in a declaration");
        diagnostic.help(if is_allow {
            "a warning is switched off by an item of the mechanism: `allow(W0001);`"
        } else {
            "those of an item of Rust stand before `plm::mechanism!`, in a module of its own"
        });
        true
    }

    /// The `:` behind the name of a field, or what stands for it: `mass = 1 kg`, `mass 1 kg`.
    pub(super) fn colon_of(&mut self, name: &str) -> Parse<()> {
        let is_equals = self.is_punct('=') && !self.is_double('=');
        let begins_value = self.peek().is_some_and(|token| {
            token.kind == TokenKind::Number || token.is_punct('-') || token.is_open(Delimiter::Paren)
        });
        if self.eat_punct(':') {
            return Ok(());
        }
        if !is_equals && !begins_value {
            return Err(self.expected("`:`"));
        }
        let found = self.peek().map_or("", |token| token.text.as_str());
        let message = format!("expected `:`, found `{found}`");
        self.error(Code::UnexpectedToken, self.here(), message).help(format!("write `{name}: …;`"));
        if is_equals {
            self.advance();
        }
        Ok(())
    }

    /// `force(arm.a);`, `force hook arm.a;`: a part in use has a name, and joins what stands in brackets.
    pub(super) fn part_without_brackets(&mut self, kind: &str) -> Reported {
        let name = self.peek_at(1).filter(|token| token.kind == TokenKind::Ident);
        let (message, name) = match name {
            Some(name) => (format!("what the part `{kind}` joins stands in brackets"), name.text.as_str()),
            None => (format!("the part `{kind}` has no name here"), "name"),
        };
        self.error(Code::UnknownItem, self.here(), message).help(format!("write `{kind} {name}(…);`"));
        Reported
    }

    /// `mut` behind `let`.
    pub(super) fn skip_mut(&mut self) {
        if self.is_word("mut") && self.peek_at(1).is_some_and(|token| token.kind == TokenKind::Ident) {
            self.error(
                Code::UnexpectedToken,
                self.here(),
                "`mut` has no meaning: a name stands for one expression",
            )
            .help("leave it out; what changes as it runs is a `state` or an `input`");
            self.advance();
        }
    }

    /// A unit behind the name in `let l: m = …` and in `rate p: Pa/s = …`.
    pub(super) fn skip_unit_of(&mut self, word: &str) -> Parse<()> {
        if !self.is_punct(':') {
            return Ok(());
        }
        let start = self.position();
        self.advance();
        self.declared_unit()?;
        let span = self.span_from(start);
        let diagnostic = self.error(Code::UnexpectedToken, span, format!("a `{word}` takes no unit"));
        diagnostic.help(if word == "let" {
            "leave it out: it has that of its value; a `param` takes one"
        } else {
            "leave it out: it is that of the state, per second"
        });
        Ok(())
    }

    /// `constraint rod.x = …`: a name is missing. Shows the item with one.
    pub(super) fn constraint_without_name(&mut self, start: usize) -> Reported {
        while self.peek().is_some_and(|token| !token.is_punct(';')) {
            self.go_to(self.behind(self.position()));
        }
        let span = self.span_from(start);
        let text = self.text_of(span).replace("==", "=").replacen('=', " = ", 1);
        self.error(Code::UnexpectedToken, span, "a constraint needs a name")
            .help(format!("write `constraint name: {text};`"));
        Reported
    }

    /// Takes `a == b` for the two sides of a constraint.
    pub(super) fn sides_of_equality(&mut self, expr: Expr) -> Result<(Expr, Expr), Expr> {
        match expr.kind {
            ExprKind::Chain(left, mut links)
                if matches!(links.as_slice(), [Link { operator: Operator::Equal, .. }]) =>
            {
                let Some(link) = links.pop() else {
                    return Err(Expr { kind: ExprKind::Unknown, span: expr.span });
                };
                let help =
                    format!("write `{} = {}`", self.text_of(left.span), self.text_of(link.operand.span));
                self.error(Code::UnexpectedToken, expr.span, "a constraint has one `=`").help(help);
                Ok((*left, link.operand))
            }
            kind => Err(Expr { kind, span: expr.span }),
        }
    }

    /// `output b.angle as tilt`: the name stands in front.
    pub(super) fn name_behind(&mut self, value: &Expr) -> Option<IndexedName> {
        let names =
            self.is_word("as") && self.peek_at(1).is_some_and(|token: &Token| token.kind == TokenKind::Ident);
        if !names {
            return None;
        }
        let start = self.position();
        self.advance();
        let name = self.indexed_name("a name").ok()?;
        let span = self.span_from(start);
        let help = format!("write `output {} = {};`", name.ident.text, self.text_of(value.span));
        self.error(Code::UnexpectedToken, span, "the name of an output stands in front of it").help(help);
        Some(name)
    }
}

/// Where a number of the user's program is wanted.
pub(crate) const CONSTANTS: &str = "a declaration cannot see Rust's constants: declare a `param`, and set it in the value of the mechanism; a bound of `repeat` \
     comes by the argument of a `macro_rules!`";

/// What a word that begins no item is here.
pub(super) fn instead_of_item(word: &str) -> Option<&'static str> {
    Some(match word {
        "const" | "static" | "final" => {
            "a number that can be set is a `param`, a name for an expression a `let`"
        }
        "var" | "val" | "mut" => {
            "a name for an expression is a `let`; what changes as it runs is a `state` or an `input`"
        }
        "if" | "when" | "else" => "a condition stands in a value: `if t < 1 s then 1 N else 0 N`",
        "for" | "while" | "loop" => "repetitions are `repeat i in 0..8 { … }`",
        "der" | "ddt" => "the rate of a state is `rate name = …;`",
        "fn" | "def" | "function" => "a formula is a `let`, and what acts on bodies a `part`",
        "use" | "import" | "include" => "`use path;` is the first word of a declaration",
        "struct" | "class" | "enum" | "type" => "a part of your own is `part name(a: frame) { … }`",
        "port" => "a port stands in `body name { … }` or in `ground { … }`",
        "start" => "a start stands in `body name { … }`",
        "g" | "gravitation" => "write `gravity: 9.81 m/s^2;`",
        "print" | "println" | "plot" | "show" | "log" => "what is to be looked at is an `output`",
        _ => return None,
    })
}

/// What a mark behind a value is here.
pub(super) fn behind_value(text: &str) -> Option<&'static str> {
    Some(match text {
        "?" => "a choice is written `if a < b then c else d`",
        "%" => "there is no remainder",
        "," => "an item ends with `;`",
        "locked" => "a comma stands before it: `30 deg, locked`",
        "°" => "write `deg`",
        "as" => "there is one kind of number: leave `as` out",
        _ => return None,
    })
}
