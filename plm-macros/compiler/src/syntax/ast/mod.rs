//! The tree of a declaration, as written: names are not bound, but units are known (their table is closed).

mod expr;

pub use expr::{Expr, ExprKind, Link, Operator};

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
    /// Parts and domains that were declared before the mechanism: its own, or carried here by `plm::parts!`.
    pub shared: Shared,
    /// The mechanism; `None` if its head could not be read.
    pub mechanism: Option<Mechanism>,
    /// Where parts stand that `parts!` has carried here, from another crate perhaps.
    pub carried: Vec<Span>,
}

/// Definitions: parts and domains.
#[derive(Clone, Debug, Default)]
pub struct Shared {
    /// Parts.
    pub parts: Vec<Definition>,
    /// Domains.
    pub domains: Vec<Domain>,
}

/// `domain name { across name: unit; through name: unit; … }`
#[derive(Clone, Debug)]
pub struct Domain {
    /// Documentation lines.
    pub docs: Vec<String>,
    /// Its name.
    pub name: Ident,
    /// What all that meets at a node has in common.
    pub across: Quantity,
    /// What adds up at a node.
    pub through: Vec<Quantity>,
}

/// `name: unit` of a domain.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// Its name.
    pub name: Ident,
    /// Its unit.
    pub unit: DisplayUnit,
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
    /// Kind of port: `frame`, `body` or the name of a domain.
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
    /// `picture pin_diameter;`
    Picture(Vec<IndexedName>),
    /// `ground { … }`
    Ground(Vec<Port>),
    /// `body name { … }`
    Body(Body),
    /// `kind name(args) { fields }`
    Instance(Instance),
    /// `constraint name: expr = expr;`
    Constraint(IndexedName, Expr, Expr),
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
    /// A part of the user's own.
    Definition(Definition),
    /// A domain of the user's own.
    Domain(Domain),
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
    /// A state that a search for an equilibrium must leave alone?
    pub locked: bool,
}

/// `node name: kind = expr;`
#[derive(Clone, Debug)]
pub struct Node {
    /// Its name.
    pub name: IndexedName,
    /// Kind of port: `frame`, `body` or the name of a domain.
    pub kind: Ident,
    /// Its across quantity, or the port that it is another name of.
    pub value: Expr,
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
    /// Its name; on the ground it may have indices.
    pub name: IndexedName,
    /// Where it is.
    pub at: Expr,
    /// Direction of its x axis.
    pub angle: Option<Expr>,
    /// Depth for pictures; on the ground alone.
    pub depth: Option<Expr>,
}

/// The outline of a body.
#[derive(Clone, Debug)]
pub enum Contour {
    /// `contour: (x, y), (x, y), … unit;`
    Points(Vec<Expr>),
    /// `contour: "file.csv";`
    File(String, Span),
}

/// A body.
#[derive(Clone, Debug)]
pub struct Body {
    /// Its name.
    pub name: IndexedName,
    /// `mass`, `inertia`, `centre`, `drawing_angle`, `depth`: one expression each.
    pub fields: Vec<(Ident, Expr)>,
    /// `coordinates: relative` or `absolute`.
    pub coordinates: Option<Ident>,
    /// Its outline for pictures.
    pub contour: Option<Contour>,
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
    /// Its parameters, and starts of its states.
    pub fields: Vec<Field>,
}

/// `name: expr, locked;` in the use of a part; `part.name: expr;` reaches into the parts that it contains.
#[derive(Clone, Debug)]
pub struct Field {
    /// What is set, segment by segment.
    pub path: Vec<IndexedName>,
    /// To what.
    pub value: Expr,
    /// Is it the start of a state that is locked?
    pub locked: Option<Span>,
}

impl Field {
    /// All of its path.
    pub fn span(&self) -> Span {
        let first = self.path.first().map(|name| name.ident.span);
        let last = self.path.last().map(|name| name.ident.span);
        first.zip(last).map_or(self.value.span, |(first, last)| first.to(last))
    }
}

/// What flows into a port: `force` or `torque` on a frame, a through quantity of its domain on a node.
#[derive(Clone, Debug)]
pub struct Load {
    /// What it is: `force`, `torque`, `flow`.
    pub quantity: Ident,
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
