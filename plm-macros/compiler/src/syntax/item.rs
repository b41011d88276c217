//! Items: what stands in a mechanism, in a part, or in a repetition.

use proc_macro2::Delimiter;
use syn::ext::IdentExt;
use syn::{Token, token};

use super::block::{Given, Repeat};
use super::body::{Body, Port};
use super::contact::{Friction, Unilateral};
use super::domain::{Domain, Node};
use super::event::When;
use super::expr::{Expr, ExprKind};
use super::foreign_syntax::{after_value, instead_of_item};
use super::handed::{Function, Points};
use super::input::{Input, Reported, Result};
use super::instance::Instance;
use super::keyword as kw;
use super::name::{Ident, IndexedName};
use super::output::Output;
use super::part::{Choice, Definition};
use super::row::{Load, constraint};
use super::shape::{Shape, picture};
use super::value::{Mark, Value, named};
use crate::collect::CollectVec;
use crate::diag::{Code, nearest};
use crate::library::PARTS;
use crate::span::Span;

/// An item with its documentation.
#[derive(Clone, Debug)]
pub struct Item {
    /// Documentation lines.
    pub docs: Vec<String>,
    /// The item.
    pub kind: ItemKind,
    /// All of it.
    pub span: Span,
}

/// Items of a mechanism, of a part, or of both.
#[derive(Clone, Debug)]
pub enum ItemKind {
    /// `gravity: expr;`
    Gravity(Expr),
    /// `formulation: tree;`
    Formulation(Ident),
    /// `code: rolled;`
    Code(Ident),
    /// `emit: step(rk4, linearly_implicit);`
    Emit(Vec<Ident>),
    /// `stabilisation: projection;` or `baumgarte(expr);`
    Stabilisation(Ident, Option<Expr>),
    /// `impacts: newton;`
    Impacts(Ident),
    /// `allow(W0002, …);`
    Allow(Vec<Ident>),
    /// `param name: unit = expr;`
    Param(Value),
    /// `input name: unit = expr;`
    Input(Value),
    /// `state name: unit = expr;`
    State(Value),
    /// `discrete name: unit = expr;`
    Discrete(Value),
    /// `when condition { target = expr; }`
    When(When),
    /// `let name = expr;`
    Let(IndexedName, Expr),
    /// `rate name = expr;`
    Rate(IndexedName, Expr),
    /// `choice name: option | option = option;`
    Choice(Choice),
    /// `function name(argument: unit): unit = expr;`
    Function(Function),
    /// `points name: unit;`
    Points(Points),
    /// `pair: revolute;`
    Pair(Ident),
    /// `picture pin_diameter;`
    Picture(Vec<IndexedName>),
    /// `picture outline on a: (0, 0), (1, 0), (1, 1) cm;`
    Shape(Box<Shape>),
    /// `ground { … }`
    Ground(Vec<Port>),
    /// `body name { … }`
    Body(Body),
    /// `kind name(args) { fields }`
    Instance(Instance),
    /// `constraint name: expr = expr { when: condition; }`
    Constraint(IndexedName, Expr, Expr, Option<Expr>),
    /// `unilateral name: expr >= expr { restitution: expr; }`
    Unilateral(Box<Unilateral>),
    /// `friction name: rate(expr) within expr .. expr { static: expr .. expr; }`
    Friction(Box<Friction>),
    /// `require name: condition;`
    Require(IndexedName, Expr),
    /// `force on b from a: expr;`, `torque on b: expr;`, `flow on b from a: expr;`
    Load(Load),
    /// `node name: kind = expr;`
    Node(Node),
    /// `output path, name = expr in unit;`
    Output(Vec<Output>),
    /// `observe arm, shoulder;`, `observe all;`
    Observe(Vec<Expr>),
    /// `repeat i in 0..n { … }`
    Repeat(Repeat),
    /// `given friction { … } else { … }`
    Given(Box<Given>),
    /// A part of the user's own.
    Definition(Definition),
    /// A domain of the user's own.
    Domain(Domain),
}

/// Block in which an item stands.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Context {
    Mechanism,
    Part,
}

use Context::{Mechanism, Part};

/// Context of an item that is about to be read.
struct Head {
    context: Context,
    docs: Vec<String>,
}

/// Reads what stands after the word of an item.
type Reader = fn(Input, &Head) -> Result<ItemKind>;

/// Words that begin an item, where it may stand (`None`: in both), and what reads it.
const WORDS: &[(&str, Option<Context>, Reader)] = &[
    ("gravity", Some(Mechanism), |input, _| input.field_value("gravity").map(ItemKind::Gravity)),
    ("stabilisation", Some(Mechanism), |input, _| stabilisation(input)),
    ("formulation", Some(Mechanism), |input, _| {
        input.field_name("`tree`, `loops` or `absolute`").map(ItemKind::Formulation)
    }),
    ("code", Some(Mechanism), |input, _| input.field_name("`rolled` or `unrolled`").map(ItemKind::Code)),
    ("emit", Some(Mechanism), |input, _| steps(input)),
    ("impacts", Some(Mechanism), |input, _| {
        input.field_name("`poisson`, `newton` or `sequential`").map(ItemKind::Impacts)
    }),
    ("allow", Some(Mechanism), |input, _| allow(input)),
    ("joint", Some(Mechanism), |input, Head { docs, .. }| {
        Definition::parse(input, true, docs.clone()).map(ItemKind::Definition)
    }),
    ("part", Some(Mechanism), |input, Head { docs, .. }| {
        Definition::parse(input, false, docs.clone()).map(ItemKind::Definition)
    }),
    ("domain", Some(Mechanism), |input, Head { docs, .. }| {
        Domain::parse(input, docs.clone()).map(ItemKind::Domain)
    }),
    ("observe", Some(Mechanism), |input, _| input.listed(Expr::parse).map(ItemKind::Observe)),
    ("choice", Some(Part), |input, _| Choice::parse(input).map(ItemKind::Choice)),
    ("function", Some(Part), |input, _| Function::parse(input).map(ItemKind::Function)),
    ("points", Some(Part), |input, _| Points::parse(input).map(ItemKind::Points)),
    ("pair", Some(Part), |input, _| input.field_name("the name of a pair").map(ItemKind::Pair)),
    ("given", Some(Part), |input, _| Given::parse(input).map(|given| ItemKind::Given(Box::new(given)))),
    ("picture", Some(Part), |input, _| picture(input)),
    ("param", None, |input, _| Value::parse(input, Some(Mark::Optional)).map(ItemKind::Param)),
    ("input", None, |input, _| Value::parse(input, Some(Mark::Optional)).map(ItemKind::Input)),
    ("state", None, |input, _| Value::parse(input, Some(Mark::Locked)).map(ItemKind::State)),
    ("discrete", None, |input, _| Value::parse(input, None).map(ItemKind::Discrete)),
    ("when", None, |input, _| When::parse(input).map(ItemKind::When)),
    ("let", None, |input, _| named(input, "let").map(|(name, value)| ItemKind::Let(name, value))),
    ("rate", None, |input, _| named(input, "rate").map(|(name, value)| ItemKind::Rate(name, value))),
    ("ground", None, |input, _| Port::of_ground(input).map(ItemKind::Ground)),
    ("body", None, |input, _| Body::parse(input).map(ItemKind::Body)),
    ("node", None, |input, _| Node::parse(input).map(ItemKind::Node)),
    ("constraint", None, |input, _| constraint(input)),
    ("unilateral", None, |input, _| Unilateral::parse(input).map(|row| ItemKind::Unilateral(Box::new(row)))),
    ("friction", None, |input, _| Friction::parse(input).map(|row| ItemKind::Friction(Box::new(row)))),
    ("require", None, |input, _| requirement(input)),
    ("output", None, |input, _| input.listed(Output::parse).map(ItemKind::Output)),
    ("repeat", None, |input, Head { context, .. }| Repeat::parse(input, *context).map(ItemKind::Repeat)),
];

/// The words that begin an item, in the order of their table.
pub(crate) fn item_words() -> Vec<&'static str> {
    WORDS.iter().map(|(word, ..)| *word).collect_vec()
}

/// Former names of items, which are still accepted, and the present ones.
const RENAMED: [(&str, &str); 1] = [("rung", "formulation")];

impl Item {
    /// `{ items }`
    pub(super) fn block(input: Input, context: Context) -> Result<Vec<Item>> {
        input.nested(|input| input.group(Delimiter::Brace, "`{`", |input| Ok(input.items(context))))
    }

    fn parse(input: Input, context: Context) -> Result<Item> {
        let head = Head { context, docs: input.docs() };
        let first = input.position();
        let kind = ItemKind::parse(input, &head)?;
        Ok(Item { docs: head.docs, kind, span: input.span_from(first) })
    }
}

impl ItemKind {
    fn parse(input: Input, head: &Head) -> Result<ItemKind> {
        if Load::peek(input) {
            only_in(Part, head.context, "what acts on a port", input)?;
            return Load::parse(input).map(ItemKind::Load);
        }
        if !input.peek(syn::Ident::peek_any) {
            return Err(match input.next() {
                "#" => input.expected_but("an item", "a comment begins with `//`"),
                _ => input.expected("an item"),
            });
        }
        let name = renamed(input).unwrap_or(input.next());
        let Some((word, place, read)) = WORDS.iter().find(|(word, ..)| *word == name) else {
            return instance_or_unknown(input);
        };
        if let Some(place) = place {
            only_in(*place, head.context, &format!("`{word}`"), input)?;
        }
        input.advance();
        read(input, head)
    }
}

/// The present name of an item that is written by its former one, which is warned of.
fn renamed(input: Input) -> Option<&'static str> {
    let (old, now) = RENAMED.iter().find(|(old, _)| *old == input.next())?;
    let message = format!("`{old}` is now called `{now}`");
    input
        .warning(Code::Renamed, input.here(), message)
        .help_with(format!("write `{now}`; the former name is still accepted"), *now);
    Some(now)
}

fn only_in(place: Context, context: Context, what: &str, input: Input) -> Result<()> {
    if place == context {
        return Ok(());
    }
    let (here, there) = match place {
        Mechanism => ("a part", "a mechanism"),
        Part => ("a mechanism", "a part"),
    };
    let message = format!("{what} has no place in {here}");
    input.error(Code::MisplacedItem, input.here(), message).note(format!("it stands in {there}"));
    Err(Reported)
}

fn instance_or_unknown(input: Input) -> Result<ItemKind> {
    let is_used = input.peek3(token::Paren) || input.peek3(token::Bracket);
    if input.peek2(syn::Ident::peek_any) && is_used {
        return Instance::parse(input).map(ItemKind::Instance);
    }
    let word = input.next();
    if PARTS.iter().any(|(part, _)| *part == word) {
        return Err(input.part_without_brackets(word));
    }
    let near = nearest(word, WORDS.iter().map(|(word, ..)| *word));
    let mut diagnostic = input.error(Code::UnknownItem, input.here(), format!("`{word}` begins no item"));
    match (instead_of_item(word), near) {
        (Some(help), _) => diagnostic.help(help),
        (None, Some(near)) => {
            diagnostic.help_with(format!("an item with a similar name exists: `{near}`"), near)
        }
        (None, None) => diagnostic.help("a part is used as `revolute name(a, b);`"),
    };
    Err(Reported)
}

/// Rules that many items have in common.
impl Input<'_> {
    /// Items, as far as they go.
    pub(super) fn items(self, context: Context) -> Vec<Item> {
        self.all(|input| Item::parse(input, context))
    }

    /// Does an item of a mechanism begin here, where the name of the mechanism is wanted? Parts and domains may stand before it.
    pub(super) fn begins_item_without_name(self) -> bool {
        let is = |word: &str| self.next() == word;
        let is_item = WORDS.iter().any(|(word, place, _)| is(word) && *place != Some(Part));
        let is_part = PARTS.iter().any(|(part, _)| is(part)) && self.peek3(token::Paren);
        let is_definition = is("part") || is("joint") || is("domain");
        let is_name = self.peek2(token::Brace) && !is("ground");
        (is_item || is_part) && !is_definition && !is_name
    }

    /// The end of an item. If it is missing but the next item begins here, that is said and nothing is skipped.
    pub(super) fn semicolon(self) -> Result<()> {
        if self.eat(Token![;]) {
            return Ok(());
        }
        let begins_item = self.is_empty() || WORDS.iter().any(|(word, ..)| *word == self.next());
        let begins_field = self.peek2(Token![:]) || self.peek(kw::port) || self.peek(kw::start);
        let reported = match after_value(self.next()) {
            Some(help) => self.expected_but("`;`", help),
            None => self.expected("`;`"),
        };
        if begins_field || begins_item { Ok(()) } else { Err(reported) }
    }

    /// The end of an item after its value; what stands after an unreadable one, or is missing, is no second mistake.
    pub(super) fn end_of(self, value: &Expr) -> Result<()> {
        if !matches!(value.kind, ExprKind::Unknown) {
            return self.semicolon();
        }
        self.advance_to(|input| input.peek(Token![;]));
        self.eat(Token![;]);
        Ok(())
    }

    /// `: expr;` after a word.
    pub(super) fn field_value(self, word: &str) -> Result<Expr> {
        self.colon_of(word)?;
        self.last_value()
    }

    /// `expr;`
    pub(super) fn last_value(self) -> Result<Expr> {
        let value = Expr::value(self);
        self.end_of(&value)?;
        Ok(value)
    }

    /// `: name;` after a word.
    pub(super) fn field_name(self, what: &str) -> Result<Ident> {
        self.expect(Token![:], "`:`")?;
        let name = Ident::parse(self, what)?;
        self.semicolon()?;
        Ok(name)
    }

    /// Items of a rule, between commas, and a semicolon.
    pub(super) fn listed<T>(self, rule: impl Fn(Self) -> Result<T>) -> Result<Vec<T>> {
        let list = self.list(rule)?;
        self.semicolon()?;
        Ok(list)
    }
}

fn stabilisation(input: Input) -> Result<ItemKind> {
    input.expect(Token![:], "`:`")?;
    let method = Ident::parse(input, "`projection` or `baumgarte`")?;
    let mut time = None;
    if input.peek(token::Paren) {
        time = Some(input.group(Delimiter::Parenthesis, "`(`", Expr::parse)?);
    }
    input.semicolon()?;
    Ok(ItemKind::Stabilisation(method, time))
}

fn allow(input: Input) -> Result<ItemKind> {
    let codes = input.group(Delimiter::Parenthesis, "`(`", |input| {
        input.terminated(|input| Ident::parse(input, "a code"))
    })?;
    input.semicolon()?;
    Ok(ItemKind::Allow(codes))
}

/// `: step(rk4, linearly_implicit);`
fn steps(input: Input) -> Result<ItemKind> {
    input.expect(Token![:], "`:`")?;
    input.expect(kw::step, "`step(…)`")?;
    let methods = input
        .group(Delimiter::Parenthesis, "`(`", |input| input.list(|input| Ident::parse(input, "a method")))?;
    input.semicolon()?;
    Ok(ItemKind::Emit(methods))
}

/// `name: condition;`
fn requirement(input: Input) -> Result<ItemKind> {
    let name = IndexedName::parse(input, "the name of the requirement")?;
    input.expect(Token![:], "`:`")?;
    Ok(ItemKind::Require(name, input.last_value()?))
}
