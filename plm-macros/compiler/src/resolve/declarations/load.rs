//! Loads: forces and torques on bodies, and what acts on nodes.

use plm_cas::Expr;
use plm_cas::algebra::Vec2;

use crate::diag::{Code, help_similar};
use crate::model::{FrameRef, Load};
use crate::resolve::Resolver;
use crate::resolve::names::ScopeId;
use crate::resolve::values::{Eval, Failed, Reads, Value};
use crate::syntax::ast;
use crate::units::Dimension;

/// Force or torque of a part on a body or on the ground.
#[derive(Clone, Copy)]
pub(crate) struct Action {
    /// Scope of its declaration.
    pub(crate) scope: ScopeId,
    /// `None` is the ground.
    pub(crate) body: Option<usize>,
    /// Lever arm of the force, m: from G of the body in absolute axes; on the ground from the origin.
    pub(crate) arm: Vec2,
    /// The force in absolute axes, N.
    pub(crate) force: Vec2,
    /// The torque that is applied beside the moment of the force, N m.
    pub(crate) torque: Expr,
}

/// A force or a torque that was declared.
pub(crate) struct UnresolvedLoad<'a> {
    scope: ScopeId,
    ast: &'a ast::Load,
    part: usize,
}

impl<'a> Resolver<'a> {
    /// `force on port from port: value;` of a part.
    pub(crate) fn declare_load(&mut self, scope: ScopeId, ast: &'a ast::Load, part: Option<usize>) {
        if let Some(part) = part {
            self.unresolved.loads.push(UnresolvedLoad { scope, ast, part });
        }
    }

    /// All loads, carried to the centres of gravity.
    pub(crate) fn evaluate_loads(&mut self) -> Vec<Load> {
        let mut loads = Vec::new();
        for load in std::mem::take(&mut self.unresolved.loads) {
            // A mistake has been reported; what else is wrong is found all the same.
            let _ = self.load(&load, &mut loads);
        }
        self.unresolved.has_all_loads = true;
        loads
    }

    fn load(&mut self, load: &UnresolvedLoad<'a>, loads: &mut Vec<Load>) -> Eval<()> {
        let UnresolvedLoad { scope, ast, .. } = *load;
        let on = self.eval(scope, &ast.on);
        let from = ast.from.as_ref().map(|from| self.eval(scope, from)).transpose();
        let (on, from) = (on?, from?);
        if let Value::Node(node) = on {
            let from = match (&ast.from, from) {
                (Some(expr), Some(value)) => Some(self.other_node(scope, expr, value, node)?),
                _ => None,
            };
            return self.act_on_node(scope, ast, node, from);
        }
        let on = self.loaded_frame(scope, &ast.on, on);
        let from = match (&ast.from, from) {
            (Some(expr), Some(value)) => Some(self.loaded_frame(scope, expr, value)),
            _ => None,
        };
        let value = match ast.quantity.text.as_str() {
            "torque" => {
                self.eval_number(scope, &ast.value, Dimension::TORQUE, Reads::ACTING).map(Applied::Torque)
            }
            "force" => self
                .eval_vector(scope, &ast.value, Dimension::FORCE, Reads::ACTING)
                .map(|force| Applied::Force(force.value)),
            other => {
                let message = format!("`{other}` does not act on a frame");
                let diagnostic = self.error(scope, Code::UnknownMember, ast.quantity.span, message);
                help_similar(diagnostic, other, "quantity", "what acts on it", &["force", "torque"]);
                Err(Failed)
            }
        };
        let (on, value) = (on?, value?);
        self.apply(load, on, value, loads)?;
        if let Some(from) = from {
            let opposite = match value {
                Applied::Torque(torque) => Applied::Torque(-torque),
                Applied::Force(force) => Applied::Force(-force),
            };
            self.apply(load, from?, opposite, loads)?;
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
        load: &UnresolvedLoad<'a>,
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
        self.unresolved.applied.push(Action { scope: load.scope, body, arm, force, torque });
        let moment = arm.cross(force);
        let force = [force.x, force.y, moment + torque];
        if let Some(body) = body.filter(|_| force != [Expr::ZERO; 3]) {
            loads.push(Load { body, part: load.part, force });
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
