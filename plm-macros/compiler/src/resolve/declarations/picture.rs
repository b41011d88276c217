//! Pictures of bodies and parts: contours, depths, sizes. Nothing of it enters the equations.

use crate::collect::{CollectVec, MapEach};
use plm_cas::Expr;
use plm_cas::algebra::Vec2;

use crate::diag::Code;
use crate::model::{Body, FrameRef, Instance, Look, Pair, SetField, Shape, Size};
use crate::outline;
use crate::resolve::Resolver;
use crate::resolve::declarations::part::PartInUse;
use crate::resolve::names::{Optional, ScopeId, SlotId};
use crate::resolve::values::lazy::Lazy;
use crate::resolve::values::{Eval, Failed, Reads, Value, all};
use crate::span::Span;
use crate::syntax::ast::{self, Contour, IndexedName};
use crate::units::Dimension;

/// A shape has so many points at most.
const MAX_POINTS: usize = 1024;

/// A size of a part: the parameter, and whose it is.
pub(crate) struct UnresolvedSize {
    instance: usize,
    name: String,
    slot: SlotId,
    scope: ScopeId,
    span: Span,
}

/// A shape of a part, and whose it is.
pub(crate) struct UnresolvedShape<'a> {
    instance: usize,
    scope: ScopeId,
    ast: &'a ast::Shape,
}

impl<'a> Resolver<'a> {
    /// `picture piston_diameter, …;` in a part.
    pub(crate) fn declare_picture(&mut self, scope: ScopeId, names: &'a [IndexedName]) {
        let home = self.names.home(scope);
        let Some(instance) = self.names.instance(scope) else { return };
        for written in names {
            let Ok(key) = self.key(scope, written) else { continue };
            let span = written.ident.span;
            match self.names.scopes[home].names.get(&key).copied() {
                Some(slot) => {
                    self.names.slots[slot].is_read = true;
                    let name = key.to_string();
                    self.unresolved.sizes.push(UnresolvedSize { instance, name, slot, scope, span });
                }
                None => {
                    self.error(scope, Code::UnknownName, span, format!("unknown name `{key}`"))
                        .note("a picture shows parameters that stand above it");
                }
            }
        }
    }

    /// `picture outline on a: (0, 0), (1, 0), (1, 1) cm;` in a part.
    pub(crate) fn declare_shape(&mut self, scope: ScopeId, ast: &'a ast::Shape) {
        if let Some(instance) = self.names.instance(scope) {
            self.unresolved.shapes.push(UnresolvedShape { instance, scope, ast });
        }
    }

    /// A shape of a part; none on a node that is nowhere in the plane.
    fn shape(&mut self, scope: ScopeId, ast: &'a ast::Shape) -> Eval<Option<Shape>> {
        let look = Look::ALL.iter().find(|(name, _)| *name == ast.look.text).map(|(_, look)| *look);
        let Some(look) = look else {
            self.unknown_option(scope, &ast.look.text, ast.look.span, &Look::ALL.map_each(|(name, _)| name));
            return Err(Failed);
        };
        let at = self.place_of(scope, &ast.on, look);
        let towards = ast.towards.as_ref().map(|of| self.place_of(scope, of, look)).transpose();
        let origin =
            ast.origin.as_ref().map(|of| self.eval_vector(scope, of, Dimension::LENGTH, Reads::FIXED));
        let points = self.shape_points(scope, ast, look);
        let (at, towards, origin, points) = (at?, towards?, origin.transpose()?, points?);
        let Some(at) = at.filter(|_| towards != Some(None)) else { return Ok(None) };
        if !self.has_points(scope, ast, look, points.len())? {
            return Ok(None);
        }
        // Bare numbers alone make a symbol.
        let is_symbol =
            !points.is_empty() && points.iter().all(|(_, dimension)| *dimension == Dimension::NUMBER);
        let origin = origin.map_or(Vec2::ZERO, |origin| origin.value);
        let has_origin = is_symbol || look == Look::Circle;
        let mut places = if has_origin { vec![origin] } else { Vec::new() };
        places.extend(points.into_iter().map(|(at, _)| if has_origin { at } else { origin + at }));
        Ok(Some(Shape { look, at, towards: towards.flatten(), is_symbol, points: places }))
    }

    /// The frame of a shape. That of a node is the last one of the part that it belongs to, and of a mark the first, which stands.
    fn place_of(&mut self, scope: ScopeId, expr: &'a ast::Expr, look: Look) -> Eval<Option<FrameRef>> {
        match self.eval(scope, expr)? {
            Value::Frame(frame) => Ok(Some(frame)),
            Value::Node(node) => {
                let owner = self.names.instance(self.unresolved.nodes[node].scope);
                let frames = owner.map_or_else(Vec::new, |owner| self.frames_of(owner));
                let frame = if look == Look::Mark { frames.first() } else { frames.last() };
                Ok(frame.map(|(_, frame)| *frame))
            }
            other => Err(self.wrong_kind(scope, expr, "a frame or a node", &other)),
        }
    }

    /// Points with their dimension, in every turn; a radius stands on the x axis.
    fn shape_points(
        &mut self,
        scope: ScopeId,
        ast: &'a ast::Shape,
        look: Look,
    ) -> Eval<Vec<(Vec2, Dimension)>> {
        let scopes = match &ast.turns {
            None => vec![scope],
            Some(turns) => {
                let indices = self.indices(scope, turns)?;
                let count = indices.clone().count().saturating_mul(ast.points.len());
                if count > MAX_POINTS {
                    let (message, span) = (format!("a shape has {MAX_POINTS} points at most"), ast.look.span);
                    self.error(scope, Code::TooMany, span, message);
                    return Err(Failed);
                }
                indices.map(|index| self.turn(scope, turns, index)).collect_vec()
            }
        };
        let mut points = Vec::new();
        for scope in scopes {
            for expr in &ast.points {
                points.push(self.shape_point(scope, expr, look));
            }
        }
        points.into_iter().collect()
    }

    fn shape_point(&mut self, scope: ScopeId, expr: &'a ast::Expr, look: Look) -> Eval<(Vec2, Dimension)> {
        let found = self.eval(scope, expr)?;
        let dimension = found.components().map_or(Dimension::LENGTH, |(_, nature)| nature.dimension);
        // A zero without a unit is one of metres, too.
        let dimension = if dimension.same(Dimension::NUMBER) { Dimension::NUMBER } else { Dimension::LENGTH };
        let at = if look == Look::Circle {
            Vec2::new(self.eval_number(scope, expr, dimension, Reads::FIXED)?, Expr::ZERO)
        } else {
            self.eval_vector(scope, expr, dimension, Reads::FIXED)?.value
        };
        Ok((at, dimension))
    }

    /// As many points as the shape needs? A list that a use hands over may be too short for a shape.
    fn has_points(&mut self, scope: ScopeId, ast: &'a ast::Shape, look: Look, found: usize) -> Eval<bool> {
        let (is_right, needed) = match look {
            Look::Outline | Look::Mark => (found >= 3, "three points at least"),
            Look::Line => (found >= 2, "two points at least"),
            Look::Surface => (found != 1, "two points at least, or none: then it is the x axis"),
            Look::Circle => (found == 1, "one radius"),
        };
        if !is_right && ast.turns.is_none() {
            let message = format!("a shape `{}` has {needed}, found {found}", ast.look.text);
            self.error(scope, Code::WrongCount, ast.look.span, message);
            return Err(Failed);
        }
        Ok(is_right)
    }

    /// Parts in the tables: all of the declaration, and inside of them those that join frames or have sizes.
    pub(crate) fn evaluate_instances(&mut self) -> Eval<Vec<Instance>> {
        let mut sizes: Vec<Vec<Size>> = self.names.instances.iter().map(|_| Vec::new()).collect_vec();
        let drafts = std::mem::take(&mut self.unresolved.sizes).into_iter();
        let known = all(drafts.map(|UnresolvedSize { instance, name, slot, scope, span }| {
            self.size(slot, scope, span).map(|value| (instance, Size { name, value }))
        }));
        let drafts = std::mem::take(&mut self.unresolved.shapes).into_iter();
        let drawn = all(drafts.map(|UnresolvedShape { instance, scope, ast }| {
            self.shape(scope, ast).map(|shape| (instance, shape))
        }));
        for (instance, size) in known? {
            sizes[instance].push(size);
        }
        let mut shapes: Vec<Vec<Shape>> = self.names.instances.iter().map(|_| Vec::new()).collect_vec();
        for (instance, shape) in drawn? {
            shapes[instance].extend(shape);
        }
        let looks = sizes.into_iter().zip(shapes).enumerate();
        Ok(looks.filter_map(|(id, (sizes, shapes))| self.told(id, sizes, shapes)).collect_vec())
    }

    fn size(&mut self, slot: SlotId, scope: ScopeId, span: Span) -> Eval<Expr> {
        match self.slot_value(slot, scope, span)? {
            Value::Scalar(size) if size.nature.reads.beyond(Reads::FIXED) == Reads::NOTHING => Ok(size.value),
            _ => {
                self.error(scope, Code::NotConstant, span, "a picture shows parameters alone");
                Err(Failed)
            }
        }
    }

    /// A part in use, if tables tell of it.
    fn told(&mut self, id: usize, sizes: Vec<Size>, shapes: Vec<Shape>) -> Option<Instance> {
        let frames = self.frames_of(id);
        let instance = &self.names.instances[id];
        let (definition, outer, name) = (instance.definition, instance.outer, instance.name.clone());
        let is_inside = self.names.instance(outer).is_some();
        if is_inside && frames.is_empty() && sizes.is_empty() && shapes.is_empty() {
            return None;
        }
        let pair = definition.items.iter().find_map(|item| match &item.kind {
            ast::ItemKind::Pair(pair) => Pair::named(&pair.text),
            _ => None,
        });
        let fields = self.set_fields(id);
        Some(Instance { name, kind: definition.name.text.clone(), pair, frames, fields, sizes, shapes })
    }

    /// The fields that a use sets, with those values that have been worked out: what nothing reads changes nothing.
    fn set_fields(&self, id: usize) -> Vec<SetField> {
        let PartInUse { scope, ref fields, .. } = self.names.instances[id];
        let scope = &self.names.scopes[scope];
        let set = |(name, field): &(String, &ast::Field)| {
            let slot = scope.names.get(name.as_str()).copied().or(match scope.optional.get(name.as_str()) {
                Some(Optional::Set(slot)) => Some(*slot),
                _ => None,
            });
            let is_number = field.arguments.is_empty() && field.others.is_empty();
            let value = match slot.filter(|_| is_number).map(|slot| &self.names.slots[slot].value) {
                Some(Lazy::Known(Value::Scalar(scalar))) => Some(scalar.value),
                _ => None,
            };
            SetField { name: name.clone(), value }
        };
        fields.iter().map(set).collect_vec()
    }

    /// The arguments of a part that are frames, by name.
    fn frames_of(&mut self, id: usize) -> Vec<(String, FrameRef)> {
        let instance = &self.names.instances[id];
        let (definition, outer) = (instance.definition, instance.outer);
        let arguments = definition.arguments.iter().zip(instance.arguments.clone());
        let frames =
            arguments.filter_map(|(argument, slot)| match self.slot_value(slot, outer, argument.name.span) {
                Ok(Value::Frame(frame)) => Some((argument.name.text.clone(), frame)),
                _ => None,
            });
        frames.collect_vec()
    }

    /// A depth, m; only pictures know of it.
    pub(crate) fn depth(&mut self, scope: ScopeId, depth: Option<&'a ast::Expr>) -> Eval<Option<Expr>> {
        depth.map(|expr| self.eval_number(scope, expr, Dimension::LENGTH, Reads::FIXED)).transpose()
    }

    /// The outline of a body, from G in the axes of the body: like its ports it is written from the body's origin.
    pub(crate) fn contour(&mut self, body: usize) -> Eval<Vec<Vec2>> {
        let points = self.outline(body)?;
        let placement = self.placement(body)?;
        Ok(points.into_iter().map(|at| placement.place(at)).collect_vec())
    }

    /// The contour of a body as it was written, worked out at its first use; empty where there is none.
    pub(crate) fn outline(&mut self, body: usize) -> Eval<Vec<Vec2>> {
        self.lazy(
            |of| &mut of.unresolved.bodies[body].outline,
            |_| (),
            |of| {
                let (ast, scope) = (of.unresolved.bodies[body].ast, of.unresolved.bodies[body].scope);
                ast.contour.as_ref().map_or(Ok(Vec::new()), |contour| of.points(scope, contour))
            },
        )
    }

    /// The holes of the contour of a body as they were written, worked out at their first use.
    pub(crate) fn holes(&mut self, body: usize) -> Eval<Vec<Vec<Vec2>>> {
        self.lazy(
            |of| &mut of.unresolved.bodies[body].holes,
            |_| (),
            |of| {
                let (ast, scope) = (of.unresolved.bodies[body].ast, of.unresolved.bodies[body].scope);
                all(ast.holes.iter().map(|points| of.points(scope, points)))
            },
        )
    }

    /// Bodies with their holes, from G in the axes of each.
    pub(crate) fn with_holes(&mut self, mut bodies: Vec<Body>) -> Eval<Vec<Body>> {
        for (k, body) in bodies.iter_mut().enumerate() {
            if self.is_plate(k) {
                let (holes, placement) = (self.holes(k)?, self.placement(k)?);
                let placed = |hole: Vec<Vec2>| hole.into_iter().map(|at| placement.place(at)).collect_vec();
                body.holes = holes.into_iter().map(placed).collect_vec();
            }
        }
        Ok(bodies)
    }

    /// The points of a contour or of a hole, three at least.
    pub(crate) fn points(&mut self, scope: ScopeId, contour: &'a Contour) -> Eval<Vec<Vec2>> {
        let points = match contour {
            Contour::Points(points) => {
                let points = all(points.iter().map(|point| {
                    self.eval_vector(scope, point, Dimension::LENGTH, Reads::FIXED).map(|at| at.value)
                }));
                points?
            }
            Contour::File(name, span) => self.points_of_file(scope, name, *span)?,
        };
        // One without any point is not parsed.
        if let Some(span) = contour.span().filter(|_| points.len() < 3) {
            let message = format!("a contour has three points at least, found {}", points.len());
            self.error(scope, Code::BadContour, span, message);
            return Err(Failed);
        }
        Ok(points)
    }

    fn points_of_file(&mut self, scope: ScopeId, name: &str, span: Span) -> Eval<Vec<Vec2>> {
        let content = match self.files.get(name) {
            Some(Ok(content)) => content,
            Some(Err(reason)) => {
                let message = format!("the contour `{name}` cannot be read: {reason}");
                return Err(self.bad_file(scope, span, message));
            }
            None => {
                let message = format!("the contour `{name}` cannot be read here");
                return Err(self.bad_file(scope, span, message));
            }
        };
        match outline::read(content) {
            Ok(points) => Ok(points.into_iter().map(|at| Vec2::from(at.map_each(Expr::from))).collect_vec()),
            Err(outline::Problem { line, column, what }) => {
                let message = format!("`{name}`, line {line}, column {column}: {what}");
                Err(self.bad_file(scope, span, message))
            }
        }
    }

    fn bad_file(&mut self, scope: ScopeId, span: Span, message: String) -> Failed {
        self.error(scope, Code::BadContour, span, message)
            .note("two numbers a line, `0.1, 0.2`, in metres or as a first line `x (mm), y (mm)` says")
            .note("the path counts from the folder of Cargo.toml");
        Failed
    }
}
