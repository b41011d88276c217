//! Sheet: which thing of a picture stands where in the text.
//!
//! It reads the syntax tree alone, so that it tells of texts with errors too, and of half a text.

mod expand;
mod mention;
mod polar;

use std::collections::BTreeSet;
use std::ops::Range;

use plm_compiler::diag::Diagnostics;
use plm_compiler::span::Span;
use plm_compiler::syntax::ast::{Body, Expr, ExprKind, IndexedName, Item, ItemKind, Mechanism, Port};
use plm_compiler::syntax::parse;
use plm_compiler::token::Sources;
use plm_compiler::units::{DisplayUnit, unit};

use crate::edit::as_declared;
use crate::names::{GROUND, PortName};
use crate::number::Literal;
use crate::refusal::Refusal;
pub(crate) use expand::{Turn, expanded};
pub(crate) use mention::{Mention, mentions, of_expr as mentions_of_expr};
pub use polar::Polar;

/// A text with its tree.
pub struct Sheet<'t> {
    /// The text.
    pub text: &'t str,
    sources: Sources,
    mechanism: Option<Mechanism>,
}

/// Axes in which the place of a port is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Axes {
    /// Those of the body.
    Own,
    /// Those of a drawing, from which the axes of the body are turned by so much, rad.
    Drawing(f64),
    /// The absolute ones, of the ground.
    Absolute,
}

/// The place of a port as it is written.
#[derive(Clone, Debug, PartialEq)]
pub enum Place<'s> {
    /// Two numbers.
    Numbers {
        /// Of x and y.
        numbers: Box<[Literal; 2]>,
        /// The pair, with the unit behind it.
        pair: Range<usize>,
        /// Do both share that unit?
        is_shared: bool,
        /// The `let` where they stand, and its name.
        through: Option<&'s str>,
    },
    /// A length and an angle from another point.
    Polar {
        /// Both.
        polar: Box<Polar>,
        /// The expression.
        value: Range<usize>,
        /// The `let` where it stands.
        through: &'s str,
    },
    /// Anything else, as it is written.
    Expression(String),
}

impl Place<'_> {
    /// The point in the axes in which it is written, m, as far as numbers say it.
    pub(crate) fn at(&self) -> Option<[f64; 2]> {
        match self {
            Place::Numbers { numbers, .. } => Some(numbers.each_ref().map(Literal::si)),
            Place::Polar { polar, .. } => Some(polar.at()),
            Place::Expression(_) => None,
        }
    }
}

/// A port that can be drawn.
#[derive(Clone, Debug)]
pub struct Handle<'s> {
    /// Its name, as the picture has it.
    pub name: PortName,
    /// Its axes.
    pub axes: Axes,
    /// Its place.
    pub place: Place<'s>,
    /// How many bodies of a `repeat` have this place.
    pub turns: usize,
    /// Does a constraint prescribe the angle of its body?
    pub is_driven: bool,
    /// Its body; nothing on the ground.
    pub(crate) body: Option<&'s Body>,
}

/// A use of a part.
#[derive(Clone, Debug)]
pub(crate) struct Joint {
    pub(crate) name: String,
    pub(crate) kind: String,
    pub(crate) ports: Vec<PortName>,
}

impl Joint {
    /// Does it hold its two ports at one place?
    pub(crate) fn is_pin(&self) -> bool {
        ["revolute", "weld"].contains(&self.kind.as_str())
    }

    /// Does it leave the poses of bodies alone? What is not known may hold them.
    pub(crate) fn is_load(&self) -> bool {
        ["spring", "force", "attached_mass"].contains(&self.kind.as_str())
    }

    /// Does it take a port of a body?
    pub(crate) fn is_on(&self, body: &str) -> bool {
        self.ports.iter().any(|port| port.owner == body)
    }
}

impl<'t> Sheet<'t> {
    /// Reads a text. Of a file with more in it than a declaration, `masked` is the text with a blank for each byte of the rest.
    pub fn read(text: &'t str, masked: Option<&str>) -> Sheet<'t> {
        let mut sources = Sources::new();
        let id = match masked {
            Some(masked) => sources.add_excerpt("declaration", text, masked),
            None => sources.add_text("declaration", text),
        };
        let mut sink = Diagnostics::new();
        let mechanism = sources.get(id).and_then(|source| parse(source, &mut sink).mechanism);
        Sheet { text, sources, mechanism }
    }

    /// The mechanism.
    pub(crate) fn mechanism(&self) -> Result<&Mechanism, Refusal> {
        self.mechanism.as_ref().ok_or(Refusal::NoMechanism)
    }

    /// Its items; none where there is no mechanism.
    pub(crate) fn items(&self) -> &[Item] {
        self.mechanism.as_ref().map_or(&[], |mechanism| &mechanism.items)
    }

    /// The bytes of a span.
    pub(crate) fn range(&self, span: Span) -> Range<usize> {
        let Some(source) = self.sources.get(span.source) else { return 0..0 };
        as_declared(source.file().unwrap_or_default(), self.text, source.range(span).unwrap_or_default())
    }

    /// The text of a span.
    pub(crate) fn text_of(&self, span: Span) -> &'t str {
        self.text.get(self.range(span)).unwrap_or_default()
    }

    /// The value of a `let` of the mechanism.
    fn value_of(&self, name: &str) -> Option<(&str, &Expr)> {
        self.items().iter().find_map(|item| match &item.kind {
            ItemKind::Let(of, value) if of.indices.is_empty() && of.ident.text == name => {
                Some((of.ident.text.as_str(), value))
            }
            _ => None,
        })
    }

    /// The literal that an expression is, if it is one of a length or of an angle.
    pub(crate) fn literal(&self, expr: &Expr, zero: &str) -> Option<Literal> {
        Literal::of(expr, None, &unit_named(zero), &|of| self.range(of.span))
    }

    /// The number that a name has, which no hand moves: that of a parameter, or of a `let` of the mechanism.
    fn locked(&self, expr: &Expr, zero: &str) -> Option<Literal> {
        let ExprKind::Name(IndexedName { ident, indices }) = &expr.kind else { return None };
        let found = self.items().iter().find_map(|item| match &item.kind {
            ItemKind::Param(of) if of.name.indices.is_empty() && of.name.ident.text == ident.text => {
                Some((of.value.as_ref()?, of.unit.as_ref().map_or(zero, |unit| &unit.text)))
            }
            ItemKind::Let(of, value) if of.indices.is_empty() && of.ident.text == ident.text => {
                Some((value, zero))
            }
            _ => None,
        });
        let (value, zero) = found.filter(|_| indices.is_empty())?;
        Some(Literal { is_locked: true, ..self.literal(value, zero)? })
    }

    /// A literal, or the number that a name has.
    pub(crate) fn number(&self, expr: &Expr, zero: &str) -> Option<Literal> {
        self.literal(expr, zero).or_else(|| self.locked(expr, zero))
    }

    /// The name of the parameter or of the `let` whose value a number is.
    pub(crate) fn name_of_value(&self, literal: &Literal) -> Option<&str> {
        self.items().iter().find_map(|item| match &item.kind {
            ItemKind::Param(of) => {
                let value = of.value.as_ref()?;
                (self.range(value.span) == literal.whole).then_some(of.name.ident.text.as_str())
            }
            ItemKind::Let(of, value) => {
                (self.range(value.span) == literal.whole).then_some(of.ident.text.as_str())
            }
            _ => None,
        })
    }

    /// The two literals of a point, the range of the pair, and whether they share a unit.
    pub(crate) fn pair(&self, expr: &Expr) -> Option<([Literal; 2], Range<usize>, bool)> {
        let (pair, shared) = match &expr.kind {
            ExprKind::Quantity(pair, unit) => (&**pair, Some(unit)),
            _ => (expr, None),
        };
        let ExprKind::Pair(x, y) = &pair.kind else { return None };
        // A zero takes the unit of its neighbour.
        let neighbour = [x, y].into_iter().find_map(|of| own_unit(of)).unwrap_or_else(|| unit_named("m"));
        let literal = |of: &Expr| {
            let own = Literal::of(of, shared, &neighbour, &|of| self.range(of.span));
            own.or_else(|| self.locked(of, "m").filter(|_| shared.is_none()))
        };
        Some(([literal(x)?, literal(y)?], self.range(expr.span), shared.is_some()))
    }

    /// Pairs of literals that share the unit behind them: places of ports, points with a name, centres.
    pub(crate) fn shared_pairs(&self) -> Vec<([Literal; 2], Range<usize>)> {
        let mut pairs = Vec::new();
        let mut put = |expr: &Expr| {
            if let Some((numbers, pair, true)) = self.pair(expr) {
                pairs.push((numbers, pair));
            }
        };
        // A turn of a repetition has the same text.
        expanded(self.items(), &mut |item, _| match &item.kind {
            ItemKind::Let(_, value) => std::iter::once(value).chain(polar::along(value)).for_each(&mut put),
            ItemKind::Ground(ports) => ports.iter().for_each(|port| put(&port.at)),
            ItemKind::Body(body) => {
                body.ports.iter().map(|port| &port.at).chain(field(body, "centre")).for_each(&mut put);
            }
            _ => {}
        });
        pairs
    }

    fn place<'s>(&'s self, at: &'s Expr) -> Place<'s> {
        let (mut expr, mut through) = (at, None);
        // As many steps as there are names, and a circle has none.
        for _ in 0..self.items().len() {
            let ExprKind::Name(IndexedName { ident, indices }) = &expr.kind else { break };
            let Some((name, value)) = self.value_of(&ident.text).filter(|_| indices.is_empty()) else {
                break;
            };
            (expr, through) = (value, Some(name));
        }
        match self.pair(expr) {
            Some((numbers, pair, is_shared)) => {
                Place::Numbers { numbers: Box::new(numbers), pair, is_shared, through }
            }
            None => match self.polar(expr).zip(through) {
                Some((polar, through)) => {
                    Place::Polar { polar: Box::new(polar), value: self.range(expr.span), through }
                }
                None => Place::Expression(self.text_of(at.span).to_owned()),
            },
        }
    }

    /// All ports of the mechanism, in the order of the text; one of each turn of a `repeat`.
    pub fn handles(&self) -> Vec<Handle<'_>> {
        let mut handles = Vec::new();
        let driven = self.driven();
        expanded(self.items(), &mut |item, turn| match &item.kind {
            ItemKind::Ground(ports) => {
                let of_ground =
                    ports.iter().filter_map(|port| self.handle(GROUND.to_owned(), port, (None, false), turn));
                handles.extend(of_ground);
            }
            ItemKind::Body(body) => {
                let Some(owner) = turn.name(&body.name) else { return };
                let of = (Some(body), driven.contains(&owner));
                let of_body = body.ports.iter();
                handles.extend(of_body.filter_map(|port| self.handle(owner.clone(), port, of, turn)));
            }
            _ => {}
        });
        handles
    }

    fn handle<'s>(
        &'s self,
        owner: String,
        port: &'s Port,
        (body, is_driven): (Option<&'s Body>, bool),
        turn: &Turn<'_>,
    ) -> Option<Handle<'s>> {
        let name = PortName::new(owner, turn.name(&port.name)?);
        let axes = body.map_or(Axes::Absolute, |body| self.axes(body));
        Some(Handle { name, axes, place: self.place(&port.at), turns: turn.count, is_driven, body })
    }

    fn axes(&self, body: &Body) -> Axes {
        if body.coordinates.as_ref().is_none_or(|of| of.text != "absolute") {
            return Axes::Own;
        }
        let angle = field(body, "drawing_angle").and_then(|angle| self.literal(angle, "rad"));
        Axes::Drawing(angle.map_or(0.0, |angle| angle.si()))
    }

    /// Does a constraint prescribe the angle of a body?
    pub(crate) fn drives(&self, body: &str) -> bool {
        self.driven().contains(body)
    }

    /// Things whose angles constraints prescribe.
    fn driven(&self) -> BTreeSet<String> {
        let mut driven = BTreeSet::new();
        expanded(self.items(), &mut |item, turn| {
            if let ItemKind::Constraint(_, left, right, _) = &item.kind {
                let of = [left, right].into_iter().filter_map(|expr| turn.port(expr));
                driven.extend(of.filter(|of| of.port == "angle").map(|of| of.owner));
            }
        });
        driven
    }

    /// Things that something moves: those with prescribed angles, and those of joints with a drive.
    pub(crate) fn moved(&self) -> BTreeSet<String> {
        let mut moved = self.driven();
        expanded(self.items(), &mut |item, turn| {
            let ItemKind::Instance(instance) = &item.kind else { return };
            if instance
                .fields
                .iter()
                .any(|field| field.path.last().is_some_and(|name| name.ident.text == "drive"))
            {
                let ports = instance.arguments.iter().filter_map(|argument| turn.port(argument));
                moved.extend(ports.map(|port| port.owner).filter(|owner| owner != GROUND));
            }
        });
        moved
    }

    /// Uses of parts with the ports that they join.
    pub(crate) fn joints(&self) -> Vec<Joint> {
        let mut joints = Vec::new();
        expanded(self.items(), &mut |item, turn| {
            if let ItemKind::Instance(instance) = &item.kind {
                let ports = instance.arguments.iter().filter_map(|argument| turn.port(argument)).collect();
                let name = turn.name(&instance.name).unwrap_or_default();
                joints.push(Joint { name, kind: instance.kind.text.clone(), ports });
            }
        });
        joints
    }

    /// The ports that stand where a port stands because joints hold them there, itself among them, in the order of the text.
    pub fn pin(&self, port: &PortName) -> Vec<PortName> {
        let joints = self.joints();
        let holds = |joint: &&Joint| joint.is_pin() && joint.ports.len() == 2;
        let mut pin = vec![port.clone()];
        let mut next = 0;
        while let Some(of) = pin.get(next).cloned() {
            for joint in joints.iter().filter(holds).filter(|joint| joint.ports.contains(&of)) {
                for other in &joint.ports {
                    if !pin.contains(other) {
                        pin.push(other.clone());
                    }
                }
            }
            next += 1;
        }
        let all: Vec<PortName> = self.handles().into_iter().map(|handle| handle.name).collect();
        pin.sort_by_key(|of| all.iter().position(|name| name == of));
        pin
    }
}

/// A field of a body.
pub(crate) fn field<'s>(body: &'s Body, name: &str) -> Option<&'s Expr> {
    body.fields.iter().find(|(field, _)| field.text == name).map(|(_, value)| value)
}

/// The unit that stands at a number.
fn own_unit(expr: &Expr) -> Option<DisplayUnit> {
    match &expr.kind {
        ExprKind::Quantity(_, unit) => Some(unit.clone()),
        ExprKind::Neg(inner) => own_unit(inner),
        _ => None,
    }
}

/// A unit by its name.
pub(crate) fn unit_named(name: &str) -> DisplayUnit {
    let factors: Vec<_> =
        unit(name).map(|unit| plm_compiler::units::UnitFactor { unit, exponent: 1 }).into_iter().collect();
    DisplayUnit::product(name.to_owned(), &factors)
}
