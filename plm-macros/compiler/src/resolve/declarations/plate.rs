//! Plates: bodies whose mass, centre and inertia follow from their outline, its holes, a density and a thickness. The outline is a
//! contour, or the rounded hull of the ports.
//!
//! Integrals over a polygon are sums over its sides, by Green's theorem (C. Steger, On the calculation of arbitrary moments of polygons,
//! TU Muenchen 1996, FGBV-96-05): with `c = x0 y1 - x1 y0` of a side from `p0` to `p1`
//!
//! ```text
//! (1)  area                = sum c/2
//! (2)  first moment        = sum (p0 + p1) c/6
//! (3)  second moment       = sum (p0.p0 + p0.p1 + p1.p1) c/12
//! ```

use plm_cas::algebra::Vec2;
use plm_cas::{Expr, Number};

use crate::collect::{CollectVec, MapEach};
use crate::diag::Code;
use crate::evaluated;
use crate::model::FrameRef;
use crate::resolve::Resolver;
use crate::resolve::declarations::hull::{corners, rounded};
use crate::resolve::values::{Eval, Failed, Reads, all};
use crate::span::Span;
use crate::syntax::ast;
use crate::units::Dimension;

/// A plate about its centre.
#[derive(Clone, Copy)]
pub(crate) struct Plate {
    /// kg
    pub(crate) mass: Expr,
    /// About the centre, kg m^2.
    pub(crate) inertia: Expr,
    /// From the origin of the body, m.
    pub(crate) centre: Vec2,
    /// Width of the outline round its ports, m; of a plate without contour.
    pub(crate) width: Option<Expr>,
    /// Place of the density.
    pub(crate) span: Span,
}

/// Area and moments of a surface about a point.
#[derive(Clone, Copy)]
pub(crate) struct Moments {
    pub(crate) area: Expr,
    pub(crate) first: Vec2,
    pub(crate) second: Expr,
}

impl Resolver<'_> {
    /// Is the mass of a body that of a plate?
    pub(crate) fn is_plate(&self, body: usize) -> bool {
        self.unresolved.bodies[body].ast.fields.iter().any(|(ident, _)| ident.text == "density")
    }

    /// Reports a hole, a thickness or a width of a body that has no density.
    pub(crate) fn check_plate(&mut self, body: usize) {
        if self.is_plate(body) {
            return;
        }
        let (ast, scope) = (self.unresolved.bodies[body].ast, self.unresolved.bodies[body].scope);
        let hole = ast.holes.first().and_then(ast::Contour::span).map(|span| ("hole", span));
        let sizes = ast.fields.iter().map(|(field, _)| (field.text.as_str(), field.span));
        let sizes = sizes.filter(|(field, _)| ["thickness", "width"].contains(field));
        for (field, span) in hole.into_iter().chain(sizes) {
            self.error(scope, Code::MisplacedItem, span, format!("a {field} of a body without a density"))
                .help("write `density: 7850 kg/m^3;` in the place of mass and inertia");
        }
    }

    /// The plate that a body with a density is, worked out at its first use.
    pub(crate) fn plate(&mut self, body: usize) -> Eval<Plate> {
        self.lazy(|of| &mut of.unresolved.bodies[body].plate, |_| (), |of| of.evaluate_plate(body))
    }

    fn evaluate_plate(&mut self, body: usize) -> Eval<Plate> {
        self.check_fields_of_plate(body)?;
        let scope = self.unresolved.bodies[body].scope;
        let density = self.body_quantity(body, "density", Dimension::DENSITY);
        let thickness = self.body_quantity(body, "thickness", Dimension::LENGTH);
        let surface = self.surface(body);
        let ((density, span), (thickness, _), (origin, whole, width)) = (density?, thickness?, surface?);
        let moments = self.holes(body)?.iter().map(|hole| moments_of(hole, origin)).collect_vec();
        let whole = moments.into_iter().fold(whole, Moments::less);
        if whole.area.as_number().is_some_and(|area| area.is_zero() || area.is_negative()) {
            let area = whole.area.as_number().map_or(0.0, Number::to_f64);
            let name = &self.unresolved.bodies[body].name.text;
            let message = format!("the contour of `{name}` encloses {area} m^2 beside its holes");
            self.error(scope, Code::NotPositive, span, message);
            return Err(Failed);
        }
        let from_origin = whole.first / whole.area;
        let surface = density * thickness;
        Ok(Plate {
            mass: surface * whole.area,
            inertia: surface * (whole.second - whole.area * from_origin.squared()),
            centre: origin + from_origin,
            width,
            span,
        })
    }

    /// Reports what a plate cannot have, and what it lacks.
    fn check_fields_of_plate(&mut self, body: usize) -> Eval<()> {
        let (ast, scope) = (self.unresolved.bodies[body].ast, self.unresolved.bodies[body].scope);
        let name = self.unresolved.bodies[body].name.clone();
        let mut result = Ok(());
        for (field, _) in &ast.fields {
            if matches!(field.text.as_str(), "mass" | "inertia" | "centre") {
                let message = format!("the {} of `{}` follows from its density", field.text, name.text);
                self.error(scope, Code::MisplacedItem, field.span, message)
                    .help(format!("leave out the density, or the {}", field.text));
                result = Err(Failed);
            }
        }
        let width = ast.fields.iter().find(|(field, _)| field.text == "width").map(|(field, _)| field.span);
        if let (Some(span), Some(_)) = (width, &ast.contour) {
            let message =
                format!("the outline of `{}` is its contour, and follows from its width", name.text);
            self.error(scope, Code::MisplacedItem, span, message).help("leave out the width, or the contour");
            result = Err(Failed);
        }
        if let Some(span) = width.filter(|_| ast.ports.is_empty()) {
            let message = format!("`{}` has a width and no port, round which it would be", name.text);
            self.error(scope, Code::MissingValue, span, message).help("write `port a: (0, 0) mm;`");
            result = Err(Failed);
        }
        for field in ["thickness", "contour"] {
            let has_outline = ast.contour.is_some() || width.is_some();
            let is_there = if field == "contour" { has_outline } else { has(ast, field) };
            if !is_there {
                let message = format!("`{}` has a density and no {field}", name.text);
                let help = if field == "contour" {
                    "write `contour: (0, 0), (1, 0), (1, 1) m;`, or `width: 20 mm;` round its ports"
                } else {
                    "write `thickness: 1 cm;`"
                };
                self.error(scope, Code::MissingValue, name.span, message).help(help);
                result = Err(Failed);
            }
        }
        result
    }

    /// A point of the outline, the moments of what it encloses about that point, and its width round the ports.
    fn surface(&mut self, body: usize) -> Eval<(Vec2, Moments, Option<Expr>)> {
        let ast = self.unresolved.bodies[body].ast;
        if !has(ast, "width") {
            let outline = self.outline(body)?;
            return Ok((outline[0], moments_of(&outline, outline[0]), None));
        }
        let width = self.body_quantity(body, "width", Dimension::LENGTH);
        let ports = all((0..self.unresolved.bodies[body].ports.len()).map(|port| {
            self.place_of_port(FrameRef { body: Some(body), port }, Reads::FIXED).map(|(at, _)| at)
        }));
        let ((width, _), ports) = (width?, ports?);
        // Which ports are corners is a question of numbers: the declared ones of parameters decide.
        let declared = self.declared_values();
        let numbers = ports.iter().map(|at| at.components().map_each(|x| evaluated::value(x, &declared)));
        let hull = corners(&numbers.collect_vec()).into_iter().map(|corner| ports[corner]).collect_vec();
        let origin = hull[0];
        Ok((origin, rounded(&hull, width / Expr::from(2), origin), Some(width)))
    }
}

fn has(ast: &ast::Body, field: &str) -> bool {
    ast.fields.iter().any(|(ident, _)| ident.text == field)
}

/// (1) to (3) about a point, whichever way the polygon goes round.
pub(crate) fn moments_of(points: &[Vec2], about: Vec2) -> Moments {
    let from = points.iter().map(|at| *at - about).collect_vec();
    let sides = from.iter().zip(from.iter().cycle().skip(1));
    let (mut area, mut first, mut second) = (Expr::ZERO, Vec2::ZERO, Expr::ZERO);
    for (&p, &q) in sides {
        let cross = p.cross(q);
        area += cross / Expr::from(2);
        first += cross / Expr::from(6) * (p + q);
        second += (p.dot(p) + p.dot(q) + q.dot(q)) * cross / Expr::from(12);
    }
    let sense = area.sign();
    Moments { area: sense * area, first: sense * first, second: sense * second }
}

impl Moments {
    /// Of nothing.
    pub(crate) const ZERO: Moments = Moments { area: Expr::ZERO, first: Vec2::ZERO, second: Expr::ZERO };

    /// Without a hole.
    fn less(self, hole: Moments) -> Moments {
        Moments {
            area: self.area - hole.area,
            first: self.first - hole.first,
            second: self.second - hole.second,
        }
    }
}
