//! Bodies: mass, inertia, ports, starts.

use plm_cas::algebra::{Rotation, Vec2};
use plm_cas::{Expr, Number};

use crate::collect::MapEach;
use crate::diag::{Code, help_similar};
use crate::model::{Name, Port, Start};
use crate::resolve::Resolver;
use crate::resolve::declarations::frame::{Placement, UnresolvedPort};
use crate::resolve::declarations::plate::Plate;
use crate::resolve::names::ScopeId;
use crate::resolve::values::lazy::Lazy;
use crate::resolve::values::member_table::{Member, Owner};
use crate::resolve::values::{Eval, Failed, Reads, Value};
use crate::span::Span;
use crate::syntax::ast;
use crate::units::Dimension;

/// A body on the way to the model.
pub(crate) struct UnresolvedBody<'a> {
    pub(crate) ast: &'a ast::Body,
    pub(crate) scope: ScopeId,
    pub(crate) name: Name,
    /// Symbols of `(x, y, theta)` of G.
    pub(crate) q: [Expr; 3],
    /// Symbols of the rates of `q`.
    pub(crate) v: [Expr; 3],
    /// Symbols of the rates of `v`.
    pub(crate) a: [Expr; 3],
    /// From its axes to the absolute ones: by `theta`.
    pub(crate) rotation: Rotation,
    pub(crate) ports: Vec<UnresolvedPort<'a>>,
    placement: Lazy<Placement>,
    pub(crate) outline: Lazy<Vec<Vec2>>,
    pub(crate) holes: Lazy<Vec<Vec<Vec2>>>,
    pub(crate) plate: Lazy<Plate>,
}

/// Coordinates that can start somewhere: those of the position, then those of the velocity.
const COORDINATES: [(&str, Dimension); 6] = [
    ("x", Dimension::LENGTH),
    ("y", Dimension::LENGTH),
    ("angle", Dimension::ANGLE),
    ("vx", Dimension::VELOCITY),
    ("vy", Dimension::VELOCITY),
    ("omega", Dimension::ANGULAR_VELOCITY),
];

/// Advice for a mass or an inertia that is not positive.
pub(crate) fn positive_help(name: &str, dimension: Dimension) -> String {
    let small = if name == "mass" { "1e-3" } else { "1e-6" };
    format!(
        "the equations of motion divide by it: write a small one, `{name}: {small} {};`. A parameter may be 0 where \
         other masses carry the body (the book, E0402)",
        dimension.si_unit()
    )
}

/// Mass and inertia that equations hold of a body without any, kg and kg m^2. No result depends on them, and the
/// elimination is well conditioned where the inertia is the mass times the square of the body's size.
pub(crate) fn assumed_mass(ports: &[Port]) -> [Expr; 2] {
    // The exponent of two, which is the same on every host.
    let exponent = |at: f64| (at.abs().to_bits() >> 52) as i32 - 1023;
    let places = ports.iter().flat_map(|port| port.at.components()).filter_map(Expr::as_number);
    let sizes = places.filter(|at| !at.is_zero()).map(|at| exponent(at.to_f64()));
    [Expr::ONE, Expr::from(2).powi(2 * sizes.max().unwrap_or(0).clamp(-15, 15))]
}

impl<'a> Resolver<'a> {
    pub(crate) fn declare_ground(&mut self, scope: ScopeId, ports: &'a [ast::Port]) {
        for port in ports {
            if self.needs_index(scope, &port.name) {
                continue;
            }
            let Ok(key) = self.key(scope, &port.name) else { continue };
            let name = format!("{}{key}", self.names.prefix(scope));
            if let Some(first) = self.unresolved.port_index(None, &name) {
                let first = self.unresolved.ground[first].ast.name.ident.span;
                self.duplicate(scope, &key, port.name.ident.span, first);
            } else {
                self.refuse_member_name(scope, port);
                self.unresolved.ground.push(UnresolvedPort {
                    ast: port,
                    name,
                    scope,
                    used: false,
                    place: Lazy::Waiting,
                    frame: Lazy::Waiting,
                });
            }
        }
    }

    fn refuse_member_name(&mut self, scope: ScopeId, port: &ast::Port) {
        let text = &port.name.ident.text;
        if Member::named(Owner::Body, text).is_some() {
            let message = format!("a port cannot be called `{text}`");
            self.error(scope, Code::ReservedName, port.name.ident.span, message).note(format!(
                "every body has members of these names: {}",
                Member::names(Owner::Body).join(", ")
            ));
        }
    }

    pub(crate) fn declare_body(&mut self, scope: ScopeId, ast: &'a ast::Body) {
        if self.needs_index(scope, &ast.name) {
            return;
        }
        let Ok(key) = self.key(scope, &ast.name) else { return };
        let name = format!("{}{key}", self.names.prefix(scope));
        let symbols =
            |members: [&str; 3]| members.map_each(|member| Expr::symbol(format!("{name}.{member}")));
        let q = symbols(["x", "y", "angle"]);
        let v = symbols(["vx", "vy", "omega"]);
        let a = symbols(["ax", "ay", "alpha"]);
        for i in 0..3 {
            self.calculus.changes(q[i], v[i]);
            self.calculus.changes(v[i], a[i]);
        }
        let rotation = Rotation::by(q[2]);
        rotation.cos.hint(&format!("{name}.cos"));
        rotation.sin.hint(&format!("{name}.sin"));
        let span = ast.name.ident.span;
        let slot = self.names.known_slot(span, Value::Body(Some(self.unresolved.bodies.len())));
        let ports = self.ports_of(scope, ast);
        let name = Name { text: name, span };
        self.unresolved.bodies.push(UnresolvedBody {
            ast,
            scope,
            name,
            q,
            v,
            a,
            rotation,
            ports,
            placement: Lazy::Waiting,
            outline: Lazy::Waiting,
            holes: Lazy::Waiting,
            plate: Lazy::Waiting,
        });
        self.bind(scope, &ast.name.ident, key, slot);
    }

    fn ports_of(&mut self, scope: ScopeId, ast: &'a ast::Body) -> Vec<UnresolvedPort<'a>> {
        let mut ports: Vec<UnresolvedPort<'a>> = Vec::with_capacity(ast.ports.len());
        for port in &ast.ports {
            let Ok(key) = self.key(scope, &port.name) else { continue };
            if let Some(first) = ports.iter().find(|of| of.name == key) {
                let first = first.ast.name.ident.span;
                self.duplicate(scope, &key, port.name.ident.span, first);
            } else {
                self.refuse_member_name(scope, port);
                let name = key.into_owned();
                ports.push(UnresolvedPort {
                    ast: port,
                    name,
                    scope,
                    used: false,
                    place: Lazy::Waiting,
                    frame: Lazy::Waiting,
                });
            }
        }
        ports
    }

    /// A field of a body; said twice, the first counts.
    pub(crate) fn body_field(&mut self, body: usize, name: &str) -> Option<&'a ast::Expr> {
        let (ast, scope) = (self.unresolved.bodies[body].ast, self.unresolved.bodies[body].scope);
        let mut fields = ast.fields.iter().filter(|(ident, _)| ident.text == name);
        let (first, value) = fields.next()?;
        if let Some((again, _)) = fields.next() {
            self.error(scope, Code::RepeatedItem, again.span, format!("`{name}` is given twice"))
                .note_at(first.span, "it is given first here");
        }
        Some(value)
    }

    /// Does a body declare a mass, an inertia or a density? One of the first two needs the other.
    pub(crate) fn names_mass(&self, body: usize) -> bool {
        let fields = &self.unresolved.bodies[body].ast.fields;
        fields.iter().any(|(ident, _)| matches!(ident.text.as_str(), "mass" | "inertia" | "density"))
    }

    /// The mass or the inertia, and where it stands. An assumed value keeps a mistake from causing others.
    pub(crate) fn body_quantity(
        &mut self,
        body: usize,
        name: &str,
        dimension: Dimension,
    ) -> Eval<(Expr, Span)> {
        let (scope, declared) =
            (self.unresolved.bodies[body].scope, self.unresolved.bodies[body].name.clone());
        let Some(expr) = self.body_field(body, name) else {
            let message = format!("the body `{}` has no {name}", declared.text);
            let help = format!("write `{name}: 1 {};`", dimension.si_unit());
            self.error(scope, Code::MissingValue, declared.span, message).help(help);
            return Err(Failed);
        };
        let value = self.eval_number(scope, expr, dimension, Reads::FIXED)?;
        let number = value.as_number();
        if let Some(number) = number.filter(|number| number.is_zero() || number.is_negative()) {
            let found = crate::resolve::values::expect::literal_text(expr)
                .unwrap_or_else(|| Number::to_f64(number).to_string());
            let message = format!("the {name} of `{}` must be positive, found {found}", declared.text);
            let diagnostic = self.error(scope, Code::NotPositive, expr.span, message);
            match name {
                "mass" | "inertia" => diagnostic.help(positive_help(name, dimension)),
                "width" => diagnostic.note("the outline is half of it away from the hull of the ports"),
                _ => diagnostic.note("the mass of a plate is the area of its contour times both"),
            };
            return Err(Failed);
        }
        Ok((value, expr.span))
    }

    /// Coordinate system in which a body is declared, evaluated at its first use.
    pub(crate) fn placement(&mut self, body: usize) -> Eval<Placement> {
        // Ports are looked at first, and tell of a circle.
        self.lazy(|of| &mut of.unresolved.bodies[body].placement, |_| (), |of| of.evaluate_placement(body))
    }

    fn evaluate_placement(&mut self, body: usize) -> Eval<Placement> {
        let (ast, scope) = (self.unresolved.bodies[body].ast, self.unresolved.bodies[body].scope);
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
            Some(expr) => self.eval_vector(scope, expr, Dimension::LENGTH, Reads::FIXED)?.value,
            None if self.is_plate(body) => self.plate(body)?.centre,
            None => Vec2::ZERO,
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
            None => Expr::ZERO,
        };
        Ok(Placement { drawing, drawing_angle, centre })
    }

    /// Reports what is wrong with a body, whether or not anything reads it.
    pub(crate) fn check_body(&mut self, body: usize) {
        let (ast, scope) = (self.unresolved.bodies[body].ast, self.unresolved.bodies[body].scope);
        for (k, start) in ast.starts.iter().enumerate() {
            let (text, span) = (start.coordinate.text.as_str(), start.coordinate.span);
            let names = COORDINATES.map_each(|(name, _)| name);
            if !names.contains(&text) {
                let diagnostic =
                    self.error(scope, Code::UnknownItem, span, format!("`{text}` cannot start anywhere"));
                help_similar(diagnostic, text, "coordinate", "coordinates", &names);
            }
            if let Some(first) = ast.starts[..k].iter().find(|before| before.coordinate.text == text) {
                let first = first.coordinate.span;
                self.error(scope, Code::RepeatedItem, span, format!("`{text}` starts twice"))
                    .note_at(first, "it starts first here");
            }
        }
        for port in 0..self.unresolved.bodies[body].ports.len() {
            let _ = self.frame(crate::model::FrameRef { body: Some(body), port });
        }
    }

    /// Starts of (x, y, angle) and (vx, vy, omega) of the origin. A body in drawing coordinates stands where it was
    /// drawn unless it is told otherwise.
    pub(crate) fn starts(&mut self, body: usize) -> Eval<[Start; 6]> {
        let placement = self.placement(body)?;
        let zero = Expr::ZERO;
        let Vec2 { x, y } = placement.centre;
        let drawn = [x, y, placement.drawing_angle, zero, zero, zero];
        let default = if placement.drawing { drawn } else { [zero; 6] };
        let span = self.unresolved.bodies[body].name.span;
        let mut starts = default.map_each(|value| Start { value, locked: false, given: false, span });
        for start in &mut starts[..3] {
            start.given = placement.drawing;
        }
        let (ast, scope) = (self.unresolved.bodies[body].ast, self.unresolved.bodies[body].scope);
        let mut result = Ok(());
        for start in &ast.starts {
            let Some(i) = COORDINATES.iter().position(|(name, _)| *name == start.coordinate.text) else {
                continue;
            };
            match self.eval_number(scope, &start.value, COORDINATES[i].1, Reads::FIXED) {
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
