//! Pictures of bodies and parts: contours, depths, sizes. Nothing of it enters the equations.

use crate::collect::{CollectVec, MapEach};
use plm_cas::Expr;
use plm_cas::algebra::Vec2;

use crate::diag::Code;
use crate::model::{Instance, Pair, Size};
use crate::outline;
use crate::resolve::Resolver;
use crate::resolve::names::{ScopeId, SlotId};
use crate::resolve::values::{Eval, Failed, Reads, Value, all};
use crate::span::Span;
use crate::syntax::ast::{self, Contour, IndexedName};
use crate::units::Dimension;

/// A size of a part: the parameter, and whose it is.
pub(crate) struct UnresolvedSize {
    instance: usize,
    name: String,
    slot: SlotId,
    scope: ScopeId,
    span: Span,
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

    /// Parts in the tables: all of the declaration, and inside of them those that join frames or have sizes.
    pub(crate) fn evaluate_instances(&mut self) -> Eval<Vec<Instance>> {
        let mut sizes: Vec<Vec<Size>> = self.names.instances.iter().map(|_| Vec::new()).collect_vec();
        let drafts = std::mem::take(&mut self.unresolved.sizes).into_iter();
        let known = all(drafts.map(|UnresolvedSize { instance, name, slot, scope, span }| {
            self.size(slot, scope, span).map(|value| (instance, Size { name, value }))
        }));
        for (instance, size) in known? {
            sizes[instance].push(size);
        }
        let instances = sizes.into_iter().enumerate().filter_map(|(id, sizes)| self.told(id, sizes));
        Ok(instances.collect_vec())
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
    fn told(&mut self, id: usize, sizes: Vec<Size>) -> Option<Instance> {
        let instance = &self.names.instances[id];
        let (definition, outer, name) = (instance.definition, instance.outer, instance.name.clone());
        let arguments = definition.arguments.iter().zip(instance.arguments.clone());
        let frames: Vec<_> = arguments
            .filter_map(|(argument, slot)| match self.slot_value(slot, outer, argument.name.span) {
                Ok(Value::Frame(frame)) => Some((argument.name.text.clone(), frame)),
                _ => None,
            })
            .collect_vec();
        let is_inside = self.names.instance(outer).is_some();
        if is_inside && frames.is_empty() && sizes.is_empty() {
            return None;
        }
        let pair = definition.items.iter().find_map(|item| match &item.kind {
            ast::ItemKind::Pair(pair) => Pair::named(&pair.text),
            _ => None,
        });
        Some(Instance { name, kind: definition.name.text.clone(), pair, frames, sizes })
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
