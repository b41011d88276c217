//! Constraint rows and loads.

use plm_cas::Expr;
use plm_cas::algebra::Vec2;

use super::Resolver;
use super::lazy::Lazy;
use super::names::ScopeId;
use super::value::{Eval, Failed, Reads, Value};
use crate::diag::{Code, help_similar};
use crate::model::{Declared, FrameRef, Load, Name, Part};
use crate::span::Span;
use crate::syntax::ast;
use crate::units::Dimension;

/// A constraint row on the way to its residual.
#[derive(Debug)]
pub(super) struct RowDraft<'a> {
    pub(super) scope: ScopeId,
    left: &'a ast::Expr,
    right: &'a ast::Expr,
    /// Full name, `shoulder.x`.
    pub(super) name: String,
    pub(super) part: usize,
    pub(super) span: Span,
    pub(super) lambda: Expr,
    residual: Lazy<Residual>,
}

/// What a row says.
#[derive(Clone, Copy, Debug)]
pub(super) struct Residual {
    pub(super) phi: Expr,
    pub(super) dimension: Dimension,
}

/// What a part applies to a body or to the ground.
#[derive(Clone, Copy, Debug)]
pub(super) struct Action {
    /// Where it was declared.
    pub(super) scope: ScopeId,
    /// `None` is the ground.
    pub(super) body: Option<usize>,
    /// Where the force acts: from G of the body in absolute axes; on the ground from the origin.
    pub(super) arm: Vec2,
    /// Absolute axes.
    pub(super) force: Vec2,
    /// Beside that of the force.
    pub(super) torque: Expr,
}

/// A force or a torque that was declared.
#[derive(Debug)]
pub(super) struct LoadDraft<'a> {
    scope: ScopeId,
    ast: &'a ast::Load,
    part: usize,
}

impl<'a> Resolver<'a> {
    /// A row in a part; at the top of the mechanism it is a part of its own.
    pub(super) fn declare_row(
        &mut self,
        scope: ScopeId,
        name: &'a ast::IndexedName,
        (left, right): (&'a ast::Expr, &'a ast::Expr),
        part: Option<usize>,
    ) {
        if self.needs_index(scope, name) {
            return;
        }
        let Ok(key) = self.key(scope, name) else { return };
        let home = self.names.home(scope);
        let full = format!("{}{key}", self.names.prefix(scope));
        if let Some((_, first)) = self.names.scopes[home].rows.get(&key) {
            let first = *first;
            self.duplicate(scope, &key, name.ident.span, first);
            return;
        }
        let span = match self.names.instance(scope) {
            Some(_) => self.draft.parts[part.unwrap_or(0)].name.span,
            None => name.ident.span,
        };
        let part = part.unwrap_or_else(|| {
            let name = Name { text: full.clone(), span };
            let kind = "constraint".to_string();
            self.draft.parts.push(Part {
                name,
                kind,
                pair: None,
                declared: None,
                frames: Vec::new(),
                branch: None,
            });
            self.draft.parts.len() - 1
        });
        let lambda = Expr::symbol(format!("lambda_{full}"));
        self.names.scopes[home].rows.insert(key, (self.draft.rows.len(), name.ident.span));
        let residual = Lazy::Waiting;
        self.draft.rows.push(RowDraft { scope, left, right, name: full, part, span, lambda, residual });
    }

    /// Where a row was written.
    pub(super) fn row_declared(&self, row: usize) -> Declared {
        let RowDraft { scope, left, right, .. } = self.draft.rows[row];
        Declared { span: left.span.to(right.span), uses: self.names.uses(scope) }
    }

    /// The residual of a row, worked out at its first use.
    pub(super) fn row(&mut self, row: usize) -> Eval<Residual> {
        // A constraint that reads its own reaction is told so where it does.
        self.lazy(|of| &mut of.draft.rows[row].residual, |_| (), |of| of.residual(row))
    }

    fn residual(&mut self, row: usize) -> Eval<Residual> {
        let RowDraft { scope, left, right, .. } = self.draft.rows[row];
        let (a, b) = (self.eval_scalar(scope, left), self.eval_scalar(scope, right));
        let (a, b) = (a?, b?);
        let nature = self.joined(scope, left.span.to(right.span), a, b)?;
        let beyond = nature.reads.beyond(Reads::GEOMETRY);
        if beyond != Reads::NOTHING {
            let message = format!("a constraint reads {}", beyond.describe());
            let diagnostic = self
                .error(scope, Code::NotConstant, left.span.to(right.span), message)
                .note(format!("it may read {}", Reads::GEOMETRY.describe()));
            if let Some([why, instead]) = beyond.no_place() {
                diagnostic.note(why).help(instead);
            }
            return Err(Failed);
        }
        let phi = a.value - b.value;
        if phi.as_number().is_some() && !nature.reads.has(Reads::POSITION) {
            self.error(scope, Code::NotConstant, left.span, "a constraint that holds no position")
                .help("it must tie the positions of bodies");
            return Err(Failed);
        }
        Ok(Residual { phi, dimension: nature.dimension })
    }

    pub(super) fn declare_load(&mut self, scope: ScopeId, ast: &'a ast::Load, part: Option<usize>) {
        if let Some(part) = part {
            self.draft.loads.push(LoadDraft { scope, ast, part });
        }
    }

    /// All loads, carried to the centres of gravity.
    pub(super) fn evaluate_loads(&mut self) -> Vec<Load> {
        let mut loads = Vec::new();
        for LoadDraft { scope, ast, part } in std::mem::take(&mut self.draft.loads) {
            // A mistake has been reported; what else is wrong is found all the same.
            let _ = self.load(scope, ast, part, &mut loads);
        }
        loads
    }

    fn load(&mut self, scope: ScopeId, ast: &'a ast::Load, part: usize, loads: &mut Vec<Load>) -> Eval<()> {
        let on = self.eval(scope, &ast.on);
        let from = ast.from.as_ref().map(|from| self.eval(scope, from)).transpose();
        let (on, from) = (on?, from?);
        if let Value::Node(node) = on {
            let from = match (&ast.from, from) {
                (Some(expr), Some(value)) => Some(self.other_node(scope, expr, value, node)?),
                _ => None,
            };
            return self.act(scope, ast, node, from);
        }
        let on = self.loaded_frame(scope, &ast.on, on);
        let from = match (&ast.from, from) {
            (Some(expr), Some(value)) => Some(self.loaded_frame(scope, expr, value)),
            _ => None,
        };
        let value = match ast.quantity.text.as_str() {
            "torque" => {
                self.eval_number(scope, &ast.value, Dimension::TORQUE, Reads::ALL).map(Applied::Torque)
            }
            "force" => self
                .eval_vector(scope, &ast.value, Dimension::FORCE, Reads::ALL)
                .map(|force| Applied::Force(force.value)),
            other => {
                let message = format!("`{other}` does not act on a frame");
                let diagnostic = self.error(scope, Code::UnknownMember, ast.quantity.span, message);
                help_similar(diagnostic, other, "quantity", "what acts on it", &["force", "torque"]);
                Err(Failed)
            }
        };
        let (on, value) = (on?, value?);
        self.apply((scope, part), on, value, loads)?;
        if let Some(from) = from {
            let opposite = match value {
                Applied::Torque(torque) => Applied::Torque(-torque),
                Applied::Force(force) => Applied::Force(-force),
            };
            self.apply((scope, part), from?, opposite, loads)?;
        }
        Ok(())
    }

    /// The frame that a load acts on; for a body alone its centre of gravity.
    fn loaded_frame(&mut self, scope: ScopeId, expr: &'a ast::Expr, value: Value) -> Eval<Target> {
        match value {
            Value::Frame(frame) => Ok(Target::Frame(frame)),
            Value::Body(body) => Ok(Target::Centre(body)),
            other => Err(self.wrong_kind(scope, expr, "a frame", &other)),
        }
    }

    /// A force F at P acts on G as F and the torque (P - G) x F (manual, equation (6), which omits the torques).
    fn apply(
        &mut self,
        (scope, part): (ScopeId, usize),
        target: Target,
        value: Applied,
        loads: &mut Vec<Load>,
    ) -> Eval<()> {
        let (body, arm) = match target {
            Target::Frame(frame) => (frame.body, self.frame(frame)?.arm),
            Target::Centre(body) => (body, Vec2::ZERO),
        };
        let (force, torque) = match value {
            Applied::Torque(torque) => (Vec2::ZERO, torque),
            Applied::Force(force) => (force, Expr::ZERO),
        };
        self.draft.applied.push(Action { scope, body, arm, force, torque });
        let moment = arm.cross(force);
        let force = [force.x, force.y, moment + torque];
        if let Some(body) = body.filter(|_| force != [Expr::ZERO; 3]) {
            loads.push(Load { body, part, force });
        }
        Ok(())
    }
}

#[derive(Clone, Copy)]
enum Target {
    Frame(FrameRef),
    Centre(Option<usize>),
}

#[derive(Clone, Copy)]
enum Applied {
    Force(Vec2),
    Torque(Expr),
}
