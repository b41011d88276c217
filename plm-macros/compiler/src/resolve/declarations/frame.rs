//! Frames: where the ports of bodies and of the ground are.
//!
//! A point P of a body, `(px, py)` from its centre of gravity G in its own axes, stands at `x_G + px cos(theta) - py sin(theta)`,
//! `y_G + px sin(theta) + py cos(theta)` (manual, section 4.2.2.1, relations (a) to (d)): `G + R(theta) p`. Each body has one
//! rotation `R(theta)`, so that all that is derived from it shares its sine and cosine.

use crate::collect::CollectVec;
use plm_cas::Expr;
use plm_cas::algebra::{Rotation, Vec2};

use crate::diag::Code;
use crate::model::FrameRef;
use crate::resolve::Resolver;
use crate::resolve::declarations::UnresolvedModel;
use crate::resolve::names::ScopeId;
use crate::resolve::values::lazy::Lazy;
use crate::resolve::values::{Direction, Eval, Reads};
use crate::syntax::ast;
use crate::units::Dimension;

/// A port on the way from its declaration to its frame.
pub(crate) struct UnresolvedPort<'a> {
    pub(crate) ast: &'a ast::Port,
    /// Its name; of a ground port in a part, with the path of the part.
    pub(crate) name: String,
    pub(crate) scope: ScopeId,
    pub(crate) used: bool,
    pub(crate) place: Lazy<(Vec2, Reads)>,
    pub(crate) frame: Lazy<FrameGeometry>,
}

/// Position and angle of a frame.
#[derive(Clone, Copy)]
pub(crate) struct FrameGeometry {
    /// Its point from G, in the axes of the body; on the ground from the origin.
    pub(crate) local: Vec2,
    /// Its angle against the x axis of the body, or of the ground.
    pub(crate) turn: Expr,
    /// Its point from G, in absolute axes; on the ground from the origin.
    pub(crate) arm: Vec2,
    /// Its point from the origin, in absolute axes.
    pub(crate) position: Vec2,
    /// Its angle against the absolute x axis.
    pub(crate) angle: Expr,
    /// By its angle: takes the absolute axes to its own.
    pub(crate) rotation: Rotation,
    /// Reads of position and angle.
    pub(crate) reads: Reads,
}

/// Coordinate system in which a body is declared.
#[derive(Clone, Copy)]
pub(crate) struct Placement {
    /// Are they those of the assembled drawing (manual, section 4.3.2: absolute)?
    pub(crate) drawing: bool,
    /// Angle of the body in the drawing.
    pub(crate) drawing_angle: Expr,
    /// G as it was written.
    pub(crate) centre: Vec2,
}

impl<'a> UnresolvedModel<'a> {
    /// Ports of a body or, without one, of the ground.
    pub(crate) fn ports(&self, body: Option<usize>) -> &[UnresolvedPort<'a>] {
        match body {
            Some(body) => &self.bodies[body].ports,
            None => &self.ground,
        }
    }

    pub(crate) fn port(&mut self, frame: FrameRef) -> &mut UnresolvedPort<'a> {
        match frame.body {
            Some(body) => &mut self.bodies[body].ports[frame.port],
            None => &mut self.ground[frame.port],
        }
    }

    pub(crate) fn port_index(&self, body: Option<usize>, name: &str) -> Option<usize> {
        self.ports(body).iter().position(|port| port.name == name)
    }

    pub(crate) fn port_names(&self, body: Option<usize>) -> Vec<String> {
        self.ports(body).iter().map(|port| port.name.clone()).collect_vec()
    }
}

impl Resolver<'_> {
    /// The frame of a port, worked out at its first use.
    pub(crate) fn frame(&mut self, frame: FrameRef) -> Eval<FrameGeometry> {
        let port = self.unresolved.port(frame);
        let (ast, scope) = (port.ast, port.scope);
        self.lazy(
            |of| &mut of.unresolved.port(frame).frame,
            |of| {
                of.error(scope, Code::Cycle, ast.name.ident.span, "the place of this port needs itself");
            },
            |of| match frame.body {
                Some(body) => of.body_frame(body, frame),
                None => of.ground_frame(frame),
            },
        )
    }

    /// Position of a port as it was written, worked out at its first use: the outline of its body may need it before its frame does.
    pub(crate) fn place_of_port(&mut self, frame: FrameRef, reads: Reads) -> Eval<(Vec2, Reads)> {
        let port = self.unresolved.port(frame);
        let (ast, scope) = (port.ast, port.scope);
        self.lazy(
            |of| &mut of.unresolved.port(frame).place,
            |of| {
                of.error(scope, Code::Cycle, ast.name.ident.span, "the place of this port needs itself");
            },
            |of| {
                let at = of.eval_vector(scope, &ast.at, Dimension::LENGTH, reads)?;
                Ok((at.value, at.nature.reads))
            },
        )
    }

    /// Position and direction of a port as they were written.
    fn written(&mut self, frame: FrameRef, reads: Reads) -> Eval<(Vec2, Direction, Reads)> {
        let port = self.unresolved.port(frame);
        let (ast, scope) = (port.ast, port.scope);
        let at = self.place_of_port(frame, reads);
        let direction = match &ast.angle {
            Some(angle) => self.eval_direction(scope, angle, reads),
            None => Ok((Direction::Angle(Expr::ZERO), Reads::NOTHING)),
        };
        let ((at, reads), (direction, of_direction)) = (at?, direction?);
        Ok((at, direction, reads.and(of_direction)))
    }

    /// A port of the ground may move as the time goes.
    fn ground_frame(&mut self, frame: FrameRef) -> Eval<FrameGeometry> {
        let (at, direction, reads) = self.written(frame, Reads::SCHEDULED)?;
        let angle = direction.angle();
        let rotation = Rotation::by(angle);
        Ok(FrameGeometry { local: at, turn: angle, arm: at, position: at, angle, rotation, reads })
    }

    fn body_frame(&mut self, body: usize, frame: FrameRef) -> Eval<FrameGeometry> {
        let (at, direction, _) = self.written(frame, Reads::FIXED)?;
        let placement = self.placement(body)?;
        let alpha = placement.turn(direction);
        let local = placement.place(at);
        let state = &self.unresolved.bodies[body];
        let [x, y, theta] = state.q;
        let arm = state.rotation * local;
        let own_rotation = Rotation::by(alpha);
        Ok(FrameGeometry {
            local,
            turn: alpha,
            arm,
            // Manual, section 4.2.2.1, relations (a) to (d).
            position: Vec2::new(x, y) + arm,
            angle: theta + alpha,
            rotation: state.rotation * own_rotation,
            reads: Reads::POSITION,
        })
    }
}

impl Placement {
    /// A point as it was written, from G in the axes of the body.
    pub(crate) fn place(&self, at: Vec2) -> Vec2 {
        let from_centre = at - self.centre;
        if self.drawing { Rotation::by(-self.drawing_angle) * from_centre } else { from_centre }
    }

    /// The angle of a port against the x axis of the body. A vector points in the drawing, as points stand in it.
    fn turn(&self, direction: Direction) -> Expr {
        match direction {
            Direction::Vector(_) if self.drawing => direction.angle() - self.drawing_angle,
            _ => direction.angle(),
        }
    }
}
