//! Bodies: mass, inertia, ports, starts.

use plm_cas::{Expr, Number};

use super::Resolver;
use super::frame::{Placement, PortState};
use super::member::OF_BODY;
use super::scope::ScopeId;
use super::value::{Eval, Failed, Lazy, Reads, Value};
use crate::diag::{Code, help_similar};
use crate::model::{Name, Start};
use crate::span::Span;
use crate::syntax::ast;
use crate::units::Dimension;

/// A body on the way to the model.
#[derive(Debug)]
pub(super) struct BodyState<'a> {
    pub(super) ast: &'a ast::Body,
    pub(super) scope: ScopeId,
    pub(super) name: Name,
    pub(super) q: [Expr; 3],
    pub(super) v: [Expr; 3],
    pub(super) a: [Expr; 3],
    /// `(cos theta, sin theta)`
    pub(super) axis: [Expr; 2],
    pub(super) ports: Vec<PortState<'a>>,
    placement: Lazy<Placement>,
}

/// Coordinates that can start somewhere: those of the position, then those of the velocity.
const COORDINATES: [&str; 6] = ["x", "y", "angle", "vx", "vy", "omega"];

const DIMENSIONS: [Dimension; 6] = [
    Dimension::LENGTH,
    Dimension::LENGTH,
    Dimension::ANGLE,
    Dimension::VELOCITY,
    Dimension::VELOCITY,
    Dimension::ANGULAR_VELOCITY,
];

impl<'a> Resolver<'a> {
    pub(super) fn declare_ground(&mut self, scope: ScopeId, ports: &'a [ast::Port]) {
        for port in ports {
            if self.needs_index(scope, &port.name) {
                continue;
            }
            let Ok(key) = self.key(scope, &port.name) else { continue };
            let name = format!("{}{key}", self.prefix(scope));
            if let Some(first) = self.port_index(None, &name) {
                let first = self.ground[first].ast.name.ident.span;
                self.duplicate(scope, &key, port.name.ident.span, first);
            } else {
                self.refuse_member_name(scope, port);
                self.ground.push(PortState { ast: port, name, scope, used: false, frame: Lazy::Waiting });
            }
        }
    }

    fn refuse_member_name(&mut self, scope: ScopeId, port: &ast::Port) {
        let text = &port.name.ident.text;
        if OF_BODY.contains(&text.as_str()) {
            let message = format!("a port cannot be called `{text}`");
            self.error(scope, Code::ReservedName, port.name.ident.span, message)
                .note(format!("every body has members of these names: {}", OF_BODY.join(", ")));
        }
    }

    pub(super) fn declare_body(&mut self, scope: ScopeId, ast: &'a ast::Body) {
        if self.needs_index(scope, &ast.name) {
            return;
        }
        let Ok(key) = self.key(scope, &ast.name) else { return };
        let name = format!("{}{key}", self.prefix(scope));
        let symbols = |members: [&str; 3]| members.map(|member| Expr::symbol(format!("{name}.{member}")));
        let q = symbols(["x", "y", "angle"]);
        let v = symbols(["vx", "vy", "omega"]);
        let a = symbols(["ax", "ay", "alpha"]);
        for i in 0..3 {
            self.directions.insert(q[i], v[i]);
            self.directions.insert(v[i], a[i]);
        }
        let axis = [q[2].cos(), q[2].sin()];
        axis[0].hint(&format!("{name}.cos"));
        axis[1].hint(&format!("{name}.sin"));
        let span = ast.name.ident.span;
        let slot = self.known_slot(span, Value::Body(Some(self.bodies.len())));
        let ports = self.ports_of(scope, ast);
        let name = Name { text: name, span };
        self.bodies.push(BodyState { ast, scope, name, q, v, a, axis, ports, placement: Lazy::Waiting });
        self.bind(scope, &ast.name.ident, key, slot);
    }

    fn ports_of(&mut self, scope: ScopeId, ast: &'a ast::Body) -> Vec<PortState<'a>> {
        let mut ports: Vec<PortState<'a>> = Vec::with_capacity(ast.ports.len());
        for port in &ast.ports {
            if let Some(first) = ports.iter().find(|of| of.ast.name.ident.text == port.name.ident.text) {
                let first = first.ast.name.ident.span;
                self.duplicate(scope, &port.name.ident.text, port.name.ident.span, first);
            } else {
                self.refuse_member_name(scope, port);
                let name = port.name.ident.text.clone();
                ports.push(PortState { ast: port, name, scope, used: false, frame: Lazy::Waiting });
            }
        }
        ports
    }

    /// A field of a body; said twice, the first counts.
    pub(super) fn body_field(&mut self, body: usize, name: &str) -> Option<&'a ast::Expr> {
        let (ast, scope) = (self.bodies[body].ast, self.bodies[body].scope);
        let mut fields = ast.fields.iter().filter(|(ident, _)| ident.text == name);
        let (first, value) = fields.next()?;
        if let Some((again, _)) = fields.next() {
            self.error(scope, Code::RepeatedItem, again.span, format!("`{name}` is given twice"))
                .note_at(first.span, "it is given first here");
        }
        Some(value)
    }

    /// The mass or the inertia, and where it stands. An assumed value keeps a mistake from causing others.
    pub(super) fn body_quantity(
        &mut self,
        body: usize,
        name: &str,
        dimension: Dimension,
    ) -> Eval<(Expr, Span)> {
        let (scope, declared) = (self.bodies[body].scope, self.bodies[body].name.clone());
        let Some(expr) = self.body_field(body, name) else {
            let message = format!("the body `{}` has no {name}", declared.text);
            let help = format!("write `{name}: 1 {};`", dimension.si_unit());
            self.error(scope, Code::MissingValue, declared.span, message).help(help);
            return Err(Failed);
        };
        let value = self.eval_number(scope, expr, dimension, Reads::FIXED)?;
        let number = value.as_number();
        if let Some(number) = number.filter(|number| number.is_zero() || number.is_negative()) {
            let found =
                super::expect::literal_text(expr).unwrap_or_else(|| Number::to_f64(number).to_string());
            let message = format!("the {name} of `{}` must be positive, found {found}", declared.text);
            self.error(scope, Code::NotPositive, expr.span, message);
            return Err(Failed);
        }
        Ok((value, expr.span))
    }

    /// Where the origin of a body's coordinates is, worked out at its first use.
    pub(super) fn placement(&mut self, body: usize) -> Eval<Placement> {
        match self.bodies[body].placement {
            Lazy::Known(placement) => return Ok(placement),
            Lazy::Busy | Lazy::Failed => return Err(Failed),
            Lazy::Waiting => self.bodies[body].placement = Lazy::Busy,
        }
        let placement = self.evaluate_placement(body);
        self.bodies[body].placement = placement.map_or(Lazy::Failed, Lazy::Known);
        placement
    }

    fn evaluate_placement(&mut self, body: usize) -> Eval<Placement> {
        let (ast, scope) = (self.bodies[body].ast, self.bodies[body].scope);
        let zero = Expr::ZERO;
        let drawing = match &ast.coordinates {
            None => false,
            Some(word) if word.text == "relative" => false,
            Some(word) if word.text == "absolute" => true,
            Some(word) => {
                self.unknown_option(scope, &word.text, word.span, &["relative", "absolute"]);
                return Err(Failed);
            }
        };
        let centre = match self.body_field(body, "centre") {
            Some(expr) => self.eval_vector(scope, expr, Dimension::LENGTH, Reads::FIXED)?.0,
            None => [zero, zero],
        };
        let drawing_angle = match self.body_field(body, "drawing_angle") {
            Some(expr) if drawing => self.eval_number(scope, expr, Dimension::ANGLE, Reads::FIXED)?,
            Some(expr) => {
                self.error(
                    scope,
                    Code::MisplacedItem,
                    expr.span,
                    "a drawing angle without drawing coordinates",
                )
                .help("write `coordinates: absolute;`");
                return Err(Failed);
            }
            None => zero,
        };
        Ok(Placement { drawing, drawing_angle, centre })
    }

    /// Reports what is wrong with a body, whether or not anything reads it.
    pub(super) fn check_body(&mut self, body: usize) {
        let (ast, scope) = (self.bodies[body].ast, self.bodies[body].scope);
        for (k, start) in ast.starts.iter().enumerate() {
            let (text, span) = (start.coordinate.text.as_str(), start.coordinate.span);
            if !COORDINATES.contains(&text) {
                let diagnostic =
                    self.error(scope, Code::UnknownItem, span, format!("`{text}` cannot start anywhere"));
                help_similar(diagnostic, text, "coordinate", "coordinates", &COORDINATES);
            }
            if let Some(first) = ast.starts[..k].iter().find(|before| before.coordinate.text == text) {
                let first = first.coordinate.span;
                self.error(scope, Code::RepeatedItem, span, format!("`{text}` starts twice"))
                    .note_at(first, "it starts first here");
            }
        }
        for port in 0..self.bodies[body].ports.len() {
            let _ = self.frame(crate::model::FrameRef { body: Some(body), port });
        }
    }

    /// Starts of (x, y, angle) and (vx, vy, omega) of the origin. A body in drawing coordinates stands where it was
    /// drawn unless it is told otherwise.
    pub(super) fn starts(&mut self, body: usize) -> Eval<[Start; 6]> {
        let placement = self.placement(body)?;
        let zero = Expr::ZERO;
        let [x, y] = placement.centre;
        let drawn = [x, y, placement.drawing_angle, zero, zero, zero];
        let span = self.bodies[body].name.span;
        let mut starts = [0, 1, 2, 3, 4, 5].map(|i| {
            let value = if placement.drawing { drawn[i] } else { zero };
            Start { value, locked: false, given: false, span }
        });
        let (ast, scope) = (self.bodies[body].ast, self.bodies[body].scope);
        let mut result = Ok(());
        for start in &ast.starts {
            let Some(i) = COORDINATES.iter().position(|name| *name == start.coordinate.text) else {
                continue;
            };
            match self.eval_number(scope, &start.value, DIMENSIONS[i], Reads::FIXED) {
                Ok(value) => {
                    let span = start.coordinate.span.to(start.value.span);
                    starts[i] = Start { value, locked: start.locked, given: true, span };
                }
                Err(Failed) => result = Err(Failed),
            }
        }
        result.map(|()| starts)
    }
}
