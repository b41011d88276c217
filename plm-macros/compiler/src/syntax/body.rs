//! Bodies and the ground.

use proc_macro2::Delimiter;
use syn::{LitStr, Token};

use super::expr::{Expr, ExprKind};
use super::input::{Input, Reported, Result};
use super::keyword as kw;
use super::name::{Ident, IndexedName};
use crate::diag::{Code, nearest};
use crate::span::Span;

/// A body.
#[derive(Clone, Debug)]
pub struct Body {
    /// Its name.
    pub name: IndexedName,
    /// `mass`, `inertia`, `centre`, `density`, `thickness`, `width`, `drawing_angle`, `depth`: one expression each.
    pub fields: Vec<(Ident, Expr)>,
    /// `coordinates: relative` or `absolute`.
    pub coordinates: Option<Ident>,
    /// Its outline, for pictures and for the mass of a plate.
    pub contour: Option<Contour>,
    /// Outlines of its holes, for the mass of a plate.
    pub holes: Vec<Contour>,
    /// Its ports.
    pub ports: Vec<Port>,
    /// Its starts.
    pub starts: Vec<Start>,
}

/// The outline of a body.
#[derive(Clone, Debug)]
pub enum Contour {
    /// `contour: (x, y), (x, y), … unit;`
    Points(Vec<Expr>),
    /// `contour: "file.csv";`
    File(String, Span),
}

/// `port name: (x, y) m, angle: expr;`
#[derive(Clone, Debug)]
pub struct Port {
    /// Its name.
    pub name: IndexedName,
    /// Position of its origin.
    pub at: Expr,
    /// Direction of its x axis, an angle or a vector.
    pub angle: Option<Expr>,
    /// Depth for pictures; on the ground alone.
    pub depth: Option<Expr>,
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

/// Fields of a body that hold one expression. The second spelling is understood too.
const FIELDS: &[&str] =
    &["mass", "inertia", "centre", "center", "density", "thickness", "width", "drawing_angle", "depth"];

/// All that may begin an item of a body.
pub(crate) const WORDS: &[&str] = &[
    "mass",
    "inertia",
    "centre",
    "density",
    "thickness",
    "width",
    "coordinates",
    "drawing_angle",
    "port",
    "start",
    "depth",
    "contour",
    "hole",
];

impl Body {
    /// `name { … }` after `body`.
    pub(super) fn parse(input: Input) -> Result<Body> {
        let mut body = Body {
            name: IndexedName::parse(input, "the name of the body")?,
            fields: Vec::new(),
            coordinates: None,
            contour: None,
            holes: Vec::new(),
            ports: Vec::new(),
            starts: Vec::new(),
        };
        let mut unread = None;
        input.group(Delimiter::Brace, "`{`", |input| {
            while !input.is_empty() {
                let start = input.position();
                input.docs();
                if body.item(input).is_err() {
                    input.recover(start);
                    unread = Some(input.span_from(start));
                }
            }
            Ok(())
        })?;
        if let Some(span) = unread {
            body.may_have_had(span);
        }
        Ok(body)
    }

    fn item(&mut self, input: Input) -> Result<()> {
        match input.next() {
            "port" => self.ports.push(Port::parse(input, false)?),
            "start" => self.starts.push(Start::parse(input)?),
            "coordinates" => {
                input.advance();
                self.coordinates = Some(input.field_name("`relative` or `absolute`")?);
            }
            "contour" => {
                let word = input.here();
                let contour = Contour::parse(input)?;
                if self.contour.replace(contour).is_some() {
                    input.error(Code::RepeatedItem, word, "the contour is given twice");
                }
            }
            "hole" => self.holes.push(Contour::parse(input)?),
            word if FIELDS.contains(&word) => self.field(input)?,
            word => return Err(unknown_item(input, word)),
        }
        Ok(())
    }

    /// `mass: expr;`
    fn field(&mut self, input: Input) -> Result<()> {
        let mut name = Ident::parse(input, "a field")?;
        if name.text == "center" {
            name.text = "centre".to_string();
        }
        let start = input.position();
        let colon = input.colon_of(&name.text);
        let value = match colon {
            Ok(()) => Expr::value(input),
            Err(Reported) => Expr { kind: ExprKind::Unknown, span: input.span_from(start) },
        };
        self.fields.push((name, value.clone()));
        colon?;
        input.end_of(&value)
    }

    /// Notes that unreadable text may have been the mass or the inertia: that they are missing would be no second mistake.
    fn may_have_had(&mut self, span: Span) {
        for field in ["mass", "inertia"] {
            if !self.fields.iter().any(|(name, _)| name.text == field) {
                let name = Ident { text: field.to_string(), span };
                self.fields.push((name, Expr { kind: ExprKind::Unknown, span }));
            }
        }
    }
}

fn unknown_item(input: Input, word: &str) -> Reported {
    let mut diagnostic = input.error(Code::UnknownItem, input.here(), format!("a body has no `{word}`"));
    if let Some(near) = nearest(word, WORDS.iter().copied()) {
        diagnostic.help_with(format!("an item with a similar name exists: `{near}`"), near);
    }
    diagnostic.note(format!("items of a body: {}", WORDS.join(", ")));
    Reported
}

impl Contour {
    /// Span of its points or of the name of its file; `None` without a point.
    pub(crate) fn span(&self) -> Option<Span> {
        match self {
            Contour::Points(points) => Some(points.first()?.span.to(points.last()?.span)),
            Contour::File(_, span) => Some(*span),
        }
    }

    /// `contour: (x, y), (x, y), … unit;` or `contour: "file.csv";`
    fn parse(input: Input) -> Result<Contour> {
        input.advance();
        input.expect(Token![:], "`:`")?;
        let span = input.here();
        if let Ok(name) = input.parse::<LitStr>() {
            input.semicolon()?;
            return Ok(Contour::File(name.value(), span));
        }
        let mut points = input.listed(Expr::parse)?;
        share_unit(&mut points);
        Ok(Contour::Points(points))
    }
}

/// The unit after the last of several points is that of all.
pub(super) fn share_unit(points: &mut [Expr]) {
    let Some((Expr { kind: ExprKind::Quantity(_, unit), .. }, others)) = points.split_last_mut() else {
        return;
    };
    for point in others.iter_mut().filter(|point| matches!(point.kind, ExprKind::Pair(..))) {
        let bare = Expr { kind: std::mem::replace(&mut point.kind, ExprKind::Unknown), span: point.span };
        point.kind = ExprKind::Quantity(Box::new(bare), unit.clone());
    }
}

impl Port {
    /// `{ ports }` after `ground`.
    pub(super) fn of_ground(input: Input) -> Result<Vec<Port>> {
        let port = |input: Input| {
            input.docs();
            if input.peek(kw::port) { Port::parse(input, true) } else { Err(input.expected("`port`")) }
        };
        input.group(Delimiter::Brace, "`{`", |input| Ok(input.all(port)))
    }

    /// `port name: expr, angle: expr;`; on the ground with a depth.
    fn parse(input: Input, on_ground: bool) -> Result<Port> {
        input.advance();
        let name = IndexedName::parse(input, "the name of the port")?;
        input.colon_of(&format!("port {}", name.ident.text))?;
        let at = Expr::value(input);
        let (mut angle, mut depth) = (None, None);
        while input.eat(Token![,]) {
            let slot = if input.peek(kw::angle) || input.peek(kw::axis) {
                &mut angle
            } else if on_ground && input.peek(kw::depth) {
                &mut depth
            } else if input.peek_number() || input.peek(Token![-]) {
                let name = &name.ident.text;
                let help = format!("a point stands in brackets: `port {name}: (x, y) m;`");
                return Err(input.expected_but("`angle`", &help));
            } else {
                return Err(input.expected(if on_ground { "`angle` or `depth`" } else { "`angle`" }));
            };
            if slot.is_some() {
                return Err(input.expected("`;`"));
            }
            input.advance();
            input.expect(Token![:], "`:`")?;
            *slot = Some(Expr::value(input));
        }
        input.end_of(depth.as_ref().or(angle.as_ref()).unwrap_or(&at))?;
        Ok(Port { name, at, angle, depth })
    }
}

impl Start {
    /// `start coordinate: expr, locked;`
    fn parse(input: Input) -> Result<Start> {
        input.advance();
        let coordinate = Ident::parse(input, "a coordinate")?;
        input.expect(Token![:], "`:`")?;
        if input.peek(kw::locked) {
            input
                .error(Code::MissingValue, input.here(), "a locked start needs a value")
                .help(format!("write `start {}: 0, locked;`", coordinate.text));
            return Err(Reported);
        }
        let value = Expr::value(input);
        let locked = input.locked()?.is_some();
        input.end_of(&value)?;
        Ok(Start { coordinate, value, locked })
    }
}
