//! The pose as drawn: every body at its declared start, but where joints say better where it stands.
//!
//! Positions may be left out of a declaration, and those that are written may be rounded. So bodies are placed from the ground on: by
//! a pin at the declared angle, by a weld also at the angle of the body that it holds, on a slide at the place of its line that is
//! nearest to the declared one. A body that no joint reaches stands where it is declared. Loops need not close.

use crate::collect::{CollectVec, MapEach};
use plm_cas::Expr;
use plm_cas::algebra::{self, Rotation, Vec2};

use crate::diag::Code;
use crate::model::{FrameRef, Pair};
use crate::resolve::Resolver;
use crate::resolve::declarations::body::UnresolvedBody;
use crate::resolve::declarations::frame::FrameGeometry;
use crate::resolve::names::ScopeId;
use crate::resolve::values::{Eval, Failed, Nature, Quantity, Reads, Value};
use crate::span::Span;
use crate::syntax::ast;

/// The pose as drawn.
#[derive(Clone)]
pub(crate) struct DrawnPose {
    /// The coordinates of all bodies, and the time, with what stands for them.
    pairs: Vec<(Expr, Expr)>,
    /// Has a weld put a body there, to one whose angle is not locked? One of each body.
    welded: Vec<bool>,
}

/// Pose of a body, at its G, or of the ground, at the origin.
#[derive(Clone, Copy)]
struct Stand {
    position: Vec2,
    angle: Expr,
    /// Is its angle declared?
    given: bool,
    /// Is its angle locked, or that of what holds it?
    locked: bool,
}

impl Stand {
    const GROUND: Stand = Stand { position: Vec2::ZERO, angle: Expr::ZERO, given: true, locked: true };

    /// The point of a frame of it.
    fn point(&self, frame: &FrameGeometry) -> Vec2 {
        self.position + Rotation::by(self.angle) * frame.local
    }

    /// Stand at a place where a point of it is known.
    fn with(self, point: Vec2, frame: &FrameGeometry) -> Stand {
        Stand { position: point - Rotation::by(self.angle) * frame.local, ..self }
    }
}

impl<'a> Resolver<'a> {
    /// `drawn(expr)`
    pub(crate) fn drawn(&mut self, scope: ScopeId, argument: &'a ast::Expr) -> Eval<Value> {
        Ok(match self.eval(scope, argument)? {
            Value::Scalar(x) => {
                let nature = self.nature_of_drawn(scope, argument, x.nature)?;
                let pairs = self.drawn_pose(scope, argument.span)?;
                Quantity::new(algebra::substitute(&[x.value], &pairs)[0], nature).into()
            }
            Value::Vector(v) => {
                let nature = self.nature_of_drawn(scope, argument, v.nature)?;
                self.unresolved.draws_rows = true;
                let pairs = self.drawn_pose(scope, argument.span)?;
                Quantity::new(v.value.map(|x| algebra::substitute(&[x], &pairs)[0]), nature).into()
            }
            other => return Err(self.wrong_kind(scope, argument, "a number or a vector", &other)),
        })
    }

    fn nature_of_drawn(&mut self, scope: ScopeId, argument: &ast::Expr, nature: Nature) -> Eval<Nature> {
        let beyond = nature.reads.beyond(Reads::GEOMETRY);
        if beyond == Reads::NOTHING {
            return Ok(Nature { reads: Reads::FIXED, ..nature });
        }
        let message = format!("no drawing shows {}", beyond.describe());
        self.error(scope, Code::NotConstant, argument.span, message)
            .note(format!("`drawn` takes what reads {}", Reads::GEOMETRY.describe()));
        Err(Failed)
    }

    /// The coordinates of all bodies, with what stands for them, and the time.
    fn drawn_pose(&mut self, scope: ScopeId, span: Span) -> Eval<Vec<(Expr, Expr)>> {
        self.pose(scope, span).map(|pose| pose.pairs)
    }

    fn pose(&mut self, scope: ScopeId, span: Span) -> Eval<DrawnPose> {
        self.lazy(
            |of| &mut of.unresolved.drawn,
            |of| {
                of.error(scope, Code::Cycle, span, "the pose as drawn needs itself");
            },
            Self::place_bodies,
        )
    }

    /// The origin of a body in the pose as drawn.
    pub(crate) fn drawn_origin(&mut self, body: usize) -> Eval<[Expr; 2]> {
        let (scope, span) = (self.unresolved.bodies[body].scope, self.unresolved.bodies[body].name.span);
        let pairs = self.drawn_pose(scope, span)?;
        let placement = self.placement(body)?;
        let centre = if placement.drawing { Vec2::ZERO } else { placement.centre };
        let UnresolvedBody { q: [x, y, _], rotation, .. } = self.unresolved.bodies[body];
        let origin = Vec2::new(x, y) - rotation * centre;
        Ok(origin.components().map_each(|x| algebra::substitute(&[x], &pairs)[0]))
    }

    /// The origin and the angle of a body in the pose as drawn, if a weld puts it there and it could turn what holds it.
    pub(crate) fn welded_start(&mut self, body: usize) -> Eval<Option<[Expr; 3]>> {
        let parts = &self.unresolved.parts;
        if !self.names.instances.iter().any(|instance| instance.pair(parts) == Some(Pair::Weld)) {
            return Ok(None);
        }
        let (scope, span) = (self.unresolved.bodies[body].scope, self.unresolved.bodies[body].name.span);
        let DrawnPose { pairs, welded } = self.pose(scope, span)?;
        if !welded[body] {
            return Ok(None);
        }
        let [x, y] = self.drawn_origin(body)?;
        let [_, _, angle] = self.unresolved.bodies[body].q;
        Ok(Some([x, y, algebra::substitute(&[angle], &pairs)[0]]))
    }

    fn place_bodies(&mut self) -> Eval<DrawnPose> {
        let declared = self.declared_stands()?;
        let joints = self.joints_of_drawing()?;
        let mut welded = vec![false; declared.len()];
        let mut placed: Vec<Option<Stand>> = declared.iter().map(|_| None).collect_vec();
        loop {
            let mut is_over = true;
            for (pair, frames, geometry) in &joints {
                let of = |frame: &FrameRef| frame.body.map_or(Some(Stand::GROUND), |body| placed[body]);
                let (known, unknown) = match [of(&frames[0]), of(&frames[1])] {
                    [Some(_), None] => (0, 1),
                    [None, Some(_)] => (1, 0),
                    _ => continue,
                };
                let Some((stand, body)) = of(&frames[known]).zip(frames[unknown].body) else { continue };
                let stand = placed_by(*pair, geometry, (known, stand), (unknown, declared[body]));
                placed[body] = Some(stand);
                // Nothing pulls an angle that is locked.
                welded[body] = *pair == Pair::Weld && !stand.locked;
                is_over = false;
            }
            if is_over {
                break;
            }
        }
        let stands = placed.iter().zip(&declared).map(|(placed, declared)| placed.unwrap_or(*declared));
        let bodies = self.unresolved.bodies.iter().zip(stands);
        let pairs = bodies.flat_map(|(body, Stand { position: Vec2 { x, y }, angle, .. })| {
            body.q.into_iter().zip([x, y, angle])
        });
        let pairs = pairs.chain([(self.calculus.time, Expr::ZERO)]).collect_vec();
        Ok(DrawnPose { pairs, welded })
    }

    /// The declared starts of all bodies, at G.
    fn declared_stands(&mut self) -> Eval<Vec<Stand>> {
        let mut stands = Vec::new();
        for body in 0..self.unresolved.bodies.len() {
            let placement = self.placement(body)?;
            let [x, y, angle, ..] = self.starts(body)?;
            let centre = if placement.drawing { Vec2::ZERO } else { placement.centre };
            let position = Vec2::new(x.value, y.value) + Rotation::by(angle.value) * centre;
            stands.push(Stand { position, angle: angle.value, given: angle.given, locked: angle.locked });
        }
        Ok(stands)
    }

    /// The joints that are kinematic pairs, with the frames that they join, in the order of declaration.
    fn joints_of_drawing(&mut self) -> Eval<Vec<DrawnJoint>> {
        let mut joints = Vec::new();
        for id in 0..self.names.instances.len() {
            let instance = &self.names.instances[id];
            let Some(pair) = instance.pair(&self.unresolved.parts) else { continue };
            let (arguments, outer, span) = (instance.arguments.clone(), instance.outer, instance.span);
            let mut frames = Vec::new();
            for slot in arguments {
                if let Value::Frame(frame) = self.slot_value(slot, outer, span)? {
                    frames.push(frame);
                }
            }
            let [a, b] = frames[..] else { continue };
            let mut geometry = [self.frame(a)?, self.frame(b)?];
            let start = [(self.calculus.time, Expr::ZERO)];
            for of in &mut geometry {
                of.local = of.local.map(|x| algebra::substitute(&[x], &start)[0]);
                of.turn = algebra::substitute(&[of.turn], &start)[0];
            }
            joints.push((pair, [a, b], geometry));
        }
        Ok(joints)
    }
}

/// A joint that is a kinematic pair, the frames that it joins, and where these stand on their bodies.
type DrawnJoint = (Pair, [FrameRef; 2], [FrameGeometry; 2]);

/// Pose of the unknown body by a joint to the known one. Its declared pose supplies what the joint leaves open.
fn placed_by(
    pair: Pair,
    frames: &[FrameGeometry; 2],
    (known, stand): (usize, Stand),
    (unknown, declared): (usize, Stand),
) -> Stand {
    let mut own = declared;
    if !pair.turns() && !own.given {
        own.angle = stand.angle + frames[known].turn - frames[unknown].turn;
    }
    own.locked |= !pair.turns() && stand.locked;
    let (point, there) = (stand.point(&frames[known]), own.point(&frames[unknown]));
    match pair {
        Pair::Revolute | Pair::Weld => own.with(point, &frames[unknown]),
        // The line is the x axis of the first frame.
        Pair::Prismatic | Pair::PinSlot => {
            let first = if known == 0 { stand } else { own };
            let angle = first.angle + frames[0].turn;
            let axis = Vec2::new(angle.cos(), angle.sin());
            own.with(point + (there - point).dot(axis) * axis, &frames[unknown])
        }
    }
}
