//! The tree of a declaration, as written: names are not bound, but units are known (their table is closed).

use plm_cas::Number;

use crate::span::Span;
use crate::units::DisplayUnit;

/// A name and its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ident {
    /// The name.
    pub text: String,
    /// Its place.
    pub span: Span,
}

/// What `mechanism!` holds.
#[derive(Clone, Debug, Default)]
pub struct Declaration {
    /// `crate = path;`: the path of the runtime crate in emitted code.
    pub crate_path: Option<String>,
    /// Parts that were declared before the mechanism: its own, or carried here by `plm::parts!`.
    pub parts: Vec<Definition>,
    /// The mechanism; `None` if its head could not be read.
    pub mechanism: Option<Mechanism>,
}

/// `pub Name { … }`
#[derive(Clone, Debug)]
pub struct Mechanism {
    /// Documentation lines.
    pub docs: Vec<String>,
    /// Visibility as written.
    pub visibility: String,
    /// Its name.
    pub name: Ident,
    /// Its items.
    pub items: Vec<Item>,
}

/// `joint kind(a: frame, …) { … }` or `part kind(…) { … }`
#[derive(Clone, Debug)]
pub struct Definition {
    /// Documentation lines.
    pub docs: Vec<String>,
    /// Does it hold constraints?
    pub is_joint: bool,
    /// Its name.
    pub name: Ident,
    /// What it is connected to.
    pub arguments: Vec<Argument>,
    /// Its items.
    pub items: Vec<Item>,
}

/// `a: frame`
#[derive(Clone, Debug)]
pub struct Argument {
    /// Its name inside.
    pub name: Ident,
    /// Kind of port: `frame` or `body`.
    pub kind: Ident,
}

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

/// What may stand in a mechanism, in a part, or in both.
#[derive(Clone, Debug)]
pub enum ItemKind {
    /// `gravity: expr;`
    Gravity(Expr),
    /// `rung: tree;`
    Rung(Ident),
    /// `stabilisation: projection;` or `baumgarte(expr);`
    Stabilisation(Ident, Option<Expr>),
    /// `allow(W0002, …);`
    Allow(Vec<Ident>),
    /// `param name: unit = expr;`
    Param(Value),
    /// `input name: unit = expr;`
    Input(Value),
    /// `state name: unit = expr;`
    State(Value),
    /// `let name = expr;`
    Let(IndexedName, Expr),
    /// `rate name = expr;`
    Rate(IndexedName, Expr),
    /// `choice name: option | option = option;`
    Choice(Choice),
    /// `pair: revolute;`
    Pair(Ident),
    /// `ground { … }`
    Ground(Vec<Port>),
    /// `body name { … }`
    Body(Body),
    /// `kind name(args) { fields }`
    Instance(Instance),
    /// `constraint name: expr = expr;`
    Constraint(IndexedName, Expr, Expr),
    /// `force on b from a: expr;`, `torque on b: expr;`
    Load(Load),
    /// `output path, name = expr in unit;`
    Output(Vec<Output>),
    /// `repeat i in 0..n { … }`
    Repeat(Repeat),
    /// A part of the user's own.
    Definition(Definition),
}

/// A name with its indices: `bar`, `bar[i]`.
#[derive(Clone, Debug)]
pub struct IndexedName {
    /// The name.
    pub ident: Ident,
    /// Its indices.
    pub indices: Vec<Expr>,
}

/// `name: unit = expr` of a param, an input or a state.
#[derive(Clone, Debug)]
pub struct Value {
    /// Its name.
    pub name: IndexedName,
    /// Its unit, if it is written.
    pub unit: Option<DisplayUnit>,
    /// Its default or start, if it is written.
    pub value: Option<Expr>,
}

/// A choice that is made at compile time.
#[derive(Clone, Debug)]
pub struct Choice {
    /// Its name.
    pub name: Ident,
    /// What can be chosen.
    pub options: Vec<Ident>,
    /// What is chosen unless the use says otherwise.
    pub default: Option<Ident>,
}

/// `port name: (x, y) m, angle: expr;`
#[derive(Clone, Debug)]
pub struct Port {
    /// Its name.
    pub name: Ident,
    /// Where it is.
    pub at: Expr,
    /// Direction of its x axis.
    pub angle: Option<Expr>,
}

/// A body.
#[derive(Clone, Debug)]
pub struct Body {
    /// Its name.
    pub name: IndexedName,
    /// `mass`, `inertia`, `centre`, `drawing_angle`: one expression each.
    pub fields: Vec<(Ident, Expr)>,
    /// `coordinates: relative` or `absolute`.
    pub coordinates: Option<Ident>,
    /// Its ports.
    pub ports: Vec<Port>,
    /// Its starts.
    pub starts: Vec<Start>,
}

/// `start angle: expr, locked;`
#[derive(Clone, Debug)]
pub struct Start {
    /// `x`, `y`, `angle`, `vx`, `vy`, `omega`.
    pub coordinate: Ident,
    /// Its value.
    pub value: Expr,
    /// Must the assembly leave it alone?
    pub locked: bool,
}

/// The use of a part.
#[derive(Clone, Debug)]
pub struct Instance {
    /// Name of the definition.
    pub kind: Ident,
    /// Its own name.
    pub name: IndexedName,
    /// What it is connected to.
    pub arguments: Vec<Expr>,
    /// Its parameters.
    pub fields: Vec<(Ident, Expr)>,
}

/// `force` or `torque` on a port.
#[derive(Clone, Debug)]
pub struct Load {
    /// A torque, not a force?
    pub is_torque: bool,
    /// On what.
    pub on: Expr,
    /// From what: it feels the opposite.
    pub from: Option<Expr>,
    /// How much.
    pub value: Expr,
    /// The words `force on b from a`.
    pub span: Span,
}

/// One output.
#[derive(Clone, Debug)]
pub struct Output {
    /// Its name, if it is written; else the path is its name.
    pub name: Option<IndexedName>,
    /// What to show.
    pub value: Expr,
    /// In which unit.
    pub unit: Option<(DisplayUnit, Span)>,
}

/// `repeat i in from..to { … }`
#[derive(Clone, Debug)]
pub struct Repeat {
    /// The index.
    pub index: Ident,
    /// Its first value.
    pub from: Expr,
    /// The bound.
    pub to: Expr,
    /// Is the bound a value of the index, `0..=n`?
    pub inclusive: bool,
    /// What to repeat.
    pub items: Vec<Item>,
}

/// An expression.
#[derive(Clone, Debug)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Its place.
    pub span: Span,
}

/// Forms of expressions.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// What could not be read. The mistake is reported; the item keeps its name, so that its uses are no mistakes.
    Unknown,
    /// A bare number.
    Number(Number),
    /// A number or a pair with a unit.
    Quantity(Box<Expr>, DisplayUnit),
    /// `(x, y)`
    Pair(Box<Expr>, Box<Expr>),
    /// `name`, `name[i]`
    Name(IndexedName),
    /// `expr.name.name[i]`
    Path(Box<Expr>, Vec<IndexedName>),
    /// `f(args)`
    Call(Ident, Vec<Expr>),
    /// `-expr`
    Neg(Box<Expr>),
    /// `not expr`
    Not(Box<Expr>),
    /// `base ^ exponent`
    Power(Box<Expr>, Box<Expr>),
    /// `expr op expr op expr …`, operators of one precedence, from left to right. A list and not a tree, so that a
    /// long sum is not deep.
    Chain(Box<Expr>, Vec<Link>),
    /// `if expr then expr else expr`
    If(Box<Expr>, Box<Expr>, Box<Expr>),
}

/// An operator with its right operand.
#[derive(Clone, Debug)]
pub struct Link {
    /// The operator.
    pub operator: Operator,
    /// Its right operand.
    pub operand: Expr,
}

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
