//! Hints for the syntax of Rust and other languages: each form is reported once, with what to write here.

use syn::ext::IdentExt;
use syn::{Token, token};

use super::expr::{Expr, ExprKind, Link};
use super::input::{Input, Reported, Result};
use super::item::Context;
use super::keyword as kw;
use super::name::IndexedName;
use super::operator::Operator;
use super::unit::declared_unit;
use crate::diag::Code;
use crate::span::Span;

/// Words of languages that stand before the name of a type.
const TYPES: &[&str] =
    &["struct", "mechanism", "mod", "module", "model", "system", "class", "enum", "fn", "type"];

impl Input<'_> {
    /// Takes an operator. `&&` and `||` are words.
    pub(super) fn take_operator(self, operator: Operator) {
        if self.peek(Token![||]) || self.peek(Token![&&]) {
            self.take_double(format!("write `{}`", operator.text()));
            return;
        }
        self.advance();
        if operator.text().ends_with('=') {
            self.advance();
        }
    }

    /// Takes two marks and says what they are here.
    fn take_double(self, help: String) {
        let start = self.position();
        self.advance();
        self.advance();
        let span = self.span_from(start);
        let message = format!("`{}` is no operator here", self.text_of(span));
        self.error(Code::UnexpectedToken, span, message).help(help);
    }

    /// `!` before an operand.
    pub(super) fn eat_exclamation(self) -> bool {
        let span = self.here();
        let found = self.eat(Token![!]);
        if found {
            self.error(Code::UnexpectedToken, span, "`!` is no operator here").help("write `not`");
        }
        found
    }

    /// `^`, or `**` for it; what stands before it began at `start`.
    pub(super) fn eat_power(self, start: usize) -> bool {
        if !self.peek(kw::Power) {
            return self.eat(Token![^]);
        }
        let base = self.text_of(self.span_from(start));
        let [.., exponent] = self.ahead();
        let exponent = if exponent.is_empty() { "2" } else { exponent };
        self.take_double(format!("write `{base}^{exponent}`"));
        true
    }

    /// `arm.angle.sin()`: functions stand before their arguments. The receiver began at `start`, and the brackets of the
    /// call stand here.
    pub(super) fn method_call(self, start: usize, method: &IndexedName) -> Reported {
        let (name, span) = (method.ident.text.as_str(), method.ident.span);
        let receiver = self.text_of(Span { first: start as u32, last: span.first - 2, ..span });
        let open = self.position();
        self.advance();
        let all = self.span_from(open);
        let inside = Span { first: all.first + 1, last: all.last - 1, ..all };
        let arguments = if inside.last < inside.first { String::new() } else { self.text_of(inside) };
        let call = match name {
            "pow" | "powi" | "powf" => format!("{receiver}^{arguments}"),
            "to_radians" => format!("{receiver} deg"),
            _ if arguments.is_empty() => format!("{name}({receiver})"),
            _ => format!("{name}({receiver}, {arguments})"),
        };
        let message = format!("`{name}` stands after a point, and there are functions alone");
        self.error(Code::UnexpectedToken, span, message).help(format!("write `{call}`"));
        Reported
    }

    /// `std::f64::consts::PI`, after its first word.
    pub(super) fn path_of_rust(self, start: usize) -> Reported {
        while self.peek(Token![::]) {
            (0..3).for_each(|_| self.advance());
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
    pub(super) fn skip_word_of_types(self, visibility: &str) {
        let [word, name, _] = self.ahead();
        if !TYPES.contains(&word) || !self.peek2(syn::Ident::peek_any) {
            return;
        }
        let space = if visibility.is_empty() { "" } else { " " };
        let help = format!("write `{visibility}{space}{name} {{ … }}`");
        let message = format!("`{word}` does not stand before a mechanism");
        self.error(Code::UnexpectedToken, self.here(), message).help(help);
        self.advance();
    }

    /// `<T>` after the name of the mechanism.
    pub(super) fn skip_generics(self) {
        if !self.peek(Token![<]) {
            return;
        }
        let start = self.position();
        self.advance_to(|input| input.peek(token::Brace));
        let span = self.span_from(start);
        self.error(Code::UnexpectedToken, span, "a mechanism is not generic over types")
            .help("every mechanism runs on any scalar: leave this out, and see `of` beside `new`");
    }

    /// An attribute that is not documentation.
    pub(super) fn attribute_without_meaning(self, span: Span, name: &str) -> Reported {
        self.error(Code::UnexpectedToken, span, "attributes have no place in a declaration").help(
            if name == "allow" {
                "a warning is switched off by an item of the mechanism: `allow(W0001);`"
            } else {
                "those of an item of Rust stand before `plm::mechanism!`, in a module of its own"
            },
        );
        Reported
    }

    /// The `:` after the name of a field, or what stands for it: `mass = 1 kg`, `mass 1 kg`.
    pub(super) fn colon_of(self, name: &str) -> Result<()> {
        if self.eat(Token![:]) {
            return Ok(());
        }
        let is_equals = self.peek(Token![=]) && !self.peek(Token![==]);
        let begins_value = self.peek_number() || self.peek(Token![-]) || self.peek(token::Paren);
        if !is_equals && !begins_value {
            return Err(self.expected("`:`"));
        }
        let message = format!("expected `:`, found `{}`", self.next());
        self.error(Code::UnexpectedToken, self.here(), message).help(format!("write `{name}: …;`"));
        if is_equals {
            self.advance();
        }
        Ok(())
    }

    /// `force(arm.a);`, `force hook arm.a;`: a part in use has a name, and joins what stands in brackets.
    pub(super) fn part_without_brackets(self, kind: &str) -> Reported {
        let [_, name, _] = self.ahead();
        let (message, name) = if self.peek2(syn::Ident::peek_any) {
            (format!("what the part `{kind}` joins stands in brackets"), name)
        } else {
            (format!("the part `{kind}` has no name here"), "name")
        };
        self.error(Code::UnknownItem, self.here(), message).help(format!("write `{kind} {name}(…);`"));
        Reported
    }

    /// `force push(arm.a): 5 N;`: the parameters of a part stand in braces. Skips them.
    pub(super) fn parameters_without_braces(self, kind: &str, name: &str) {
        let help = format!("its parameters stand in braces: `{kind} {name}(…) {{ parameter: …; }}`");
        self.expected_but("`;` or `{`", &help);
        self.advance_to(|input| input.peek(Token![;]));
        self.eat(Token![;]);
    }

    /// `start ball[0].vx: 1 m/s;` beside the body.
    pub(super) fn start_beside_its_body(self, word: Span, body: Span) -> Reported {
        let body = self.text_of(body);
        self.error(Code::UnexpectedToken, word, "a start stands in its body, or in the use of a part").help(format!(
            "write it in `body {body} {{ start …: …; }}`; of the first of a repetition: `if i < 1 then … else …`"
        ));
        self.advance_to(|input| input.peek(Token![;]));
        self.eat(Token![;]);
        Reported
    }

    /// `gravity: 9.81 m/s^2; …` with no mechanism around it. Reads the items, for their own mistakes.
    pub(super) fn items_without_name(self) -> Reported {
        let message =
            format!("`{}` begins an item, and a mechanism has a name before its items", self.next());
        self.error(Code::NoMechanism, self.here(), message).help("write `Name { … }` around all items");
        self.items(Context::Mechanism);
        Reported
    }

    /// `mut` after `let`.
    pub(super) fn skip_mut(self) {
        if self.peek(Token![mut]) && self.peek2(syn::Ident::peek_any) {
            let message = "`mut` has no meaning: a name stands for one expression";
            self.error(Code::UnexpectedToken, self.here(), message)
                .help("leave it out; what changes as it runs is a `state` or an `input`");
            self.advance();
        }
    }

    /// A unit after the name in `let l: m = …` and in `rate p: Pa/s = …`.
    pub(super) fn skip_unit_of(self, word: &str) -> Result<()> {
        let start = self.position();
        if !self.eat(Token![:]) {
            return Ok(());
        }
        declared_unit(self)?;
        let span = self.span_from(start);
        self.error(Code::UnexpectedToken, span, format!("a `{word}` takes no unit")).help(match word {
            "let" => "leave it out: it has that of its value; a `param` takes one",
            _ => "leave it out: it is that of the state, per second",
        });
        Ok(())
    }

    /// `constraint rod.x = …`: a name is missing. Shows the item with one.
    pub(super) fn constraint_without_name(self, start: usize) -> Reported {
        self.advance_to(|input| input.peek(Token![;]));
        let span = self.span_from(start);
        let text = self.text_of(span).replace("==", "=");
        self.error(Code::UnexpectedToken, span, "a constraint needs a name")
            .help(format!("write `constraint name: {text};`"));
        Reported
    }

    /// Takes `a == b` for the two sides of a constraint.
    pub(super) fn sides_of_equality(self, expr: Expr) -> std::result::Result<(Expr, Expr), Expr> {
        let Expr { kind, span } = expr;
        match kind {
            ExprKind::Chain(left, links) if matches!(links[..], [Link { operator: Operator::Equal, .. }]) => {
                let right = links.into_iter().map(|link| link.operand).next();
                let right = right.unwrap_or(Expr { kind: ExprKind::Unknown, span });
                let help = format!("write `{} = {}`", self.text_of(left.span), self.text_of(right.span));
                self.error(Code::UnexpectedToken, span, "a constraint has one `=`").help(help);
                Ok((*left, right))
            }
            kind => Err(Expr { kind, span }),
        }
    }

    /// `output b.angle as tilt`: the name stands in front.
    pub(super) fn name_after(self, value: &Expr) -> Option<IndexedName> {
        if !self.peek(Token![as]) || !self.peek2(syn::Ident::peek_any) {
            return None;
        }
        let start = self.position();
        self.advance();
        let name = IndexedName::parse(self, "a name").ok()?;
        let span = self.span_from(start);
        let help = format!("write `output {} = {};`", name.ident.text, self.text_of(value.span));
        self.error(Code::UnexpectedToken, span, "the name of an output stands in front of it").help(help);
        Some(name)
    }
}

/// Help for a name or a path that could be a constant of the user's program.
pub(crate) const CONSTANTS: &str = "a declaration cannot see Rust's constants: declare a `param`, and set it in the value of the mechanism; a bound of `repeat` \
     comes by the argument of a `macro_rules!`";

/// Equivalent of a word that begins no item.
pub(super) fn instead_of_item(word: &str) -> Option<&'static str> {
    Some(match word {
        "const" | "static" | "final" => {
            "a number that can be set is a `param`, a name for an expression a `let`"
        }
        "var" | "val" | "mut" => {
            "a name for an expression is a `let`; what changes as it runs is a `state` or an `input`"
        }
        "contact" | "gap" | "inequality" | "stop" | "obstacle" => {
            "what must not be negative is `unilateral name: gap >= 0;`"
        }
        "coulomb" | "dry_friction" | "stick" => {
            "a friction is `friction name: rate(displacement) within bound;`"
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

/// Equivalent of a mark after a value.
pub(super) fn after_value(text: &str) -> Option<&'static str> {
    Some(match text {
        "?" => "a choice is written `if a < b then c else d`",
        "%" => "five per cent are `0.05`, and the remainder is `mod(x, period)`",
        "in" => "`in` is a word of the language: an inch is `25.4 mm`",
        "," => "an item ends with `;`",
        "locked" => "a comma stands before it: `30 deg, locked`",
        "°" => "write `deg`",
        "as" => "there is one kind of number: leave `as` out",
        _ => return None,
    })
}
