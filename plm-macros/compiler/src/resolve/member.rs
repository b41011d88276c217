//! Members: what stands behind a point.

use plm_cas::Expr;
use plm_cas::algebra::{Rotation, Vec2};

use super::Resolver;
use super::instance::PartInUse;
use super::names::ScopeId;
use super::value::{Eval, Failed, Nature, Reads, Value};
use crate::diag::{Code, help_similar, nearest};
use crate::model::FrameRef;
use crate::syntax::ast::IndexedName;
use crate::units::Dimension;

/// Members of a frame.
const OF_FRAME: &[&str] =
    &["x", "y", "angle", "position", "axis", "normal", "velocity", "omega", "acceleration", "alpha", "body"];

/// Members of a body besides its ports; a port may not take their names.
pub(super) const OF_BODY: &[&str] = &[
    "x",
    "y",
    "angle",
    "position",
    "axis",
    "normal",
    "vx",
    "vy",
    "omega",
    "velocity",
    "ax",
    "ay",
    "alpha",
    "acceleration",
];

impl<'a> Resolver<'a> {
    /// `value.name`
    pub(super) fn member(&mut self, scope: ScopeId, value: &Value, member: &'a IndexedName) -> Eval<Value> {
        let name = member.ident.text.as_str();
        let found = match value {
            Value::Instance(instance) => self.output_of(scope, *instance, member)?,
            Value::Body(None) => {
                let name = format!("{}{}", self.names.prefix(scope), self.key(scope, member)?);
                self.body_member(None, &name)?
            }
            _ if !member.indices.is_empty() => None,
            Value::Frame(frame) => self.frame_member(*frame, name)?,
            Value::Node(node) => self.node_member(*node, name),
            Value::Body(body) => self.body_member(*body, name)?,
            Value::Vector(Vec2 { x, y }, nature) => match name {
                "x" => Some(Value::Scalar(*x, *nature)),
                "y" => Some(Value::Scalar(*y, *nature)),
                _ => None,
            },
            Value::Scalar(..) | Value::Condition(..) | Value::Choice(_) => None,
        };
        found.ok_or_else(|| self.unknown_member(scope, value, member))
    }

    pub(super) fn frame_member(&mut self, frame: FrameRef, name: &str) -> Eval<Option<Value>> {
        let geometry = self.frame(frame)?;
        let reads = geometry.reads;
        let length = Nature::derived(Dimension::LENGTH, reads);
        let number = Nature::derived(Dimension::NUMBER, reads);
        let angle = Nature::derived(Dimension::ANGLE, reads);
        Ok(Some(match name {
            "x" => Value::Scalar(geometry.position.x, length),
            "y" => Value::Scalar(geometry.position.y, length),
            "angle" => Value::Scalar(geometry.angle, angle),
            "position" => Value::Vector(geometry.position, length),
            "axis" => Value::Vector(geometry.rotation.axis(), number),
            "normal" => Value::Vector(geometry.rotation.axis().left(), number),
            "velocity" => {
                let velocity = geometry.position.map(|x| self.calculus.total_derivative(x));
                Value::Vector(velocity, Nature::derived(Dimension::VELOCITY, moving(reads)))
            }
            "omega" => {
                let omega = self.calculus.total_derivative(geometry.angle);
                Value::Scalar(omega, Nature::derived(Dimension::ANGULAR_VELOCITY, moving(reads)))
            }
            "acceleration" => {
                let acceleration = geometry.position.map(|x| self.calculus.second_derivative(x));
                Value::Vector(acceleration, Nature::derived(Dimension::ACCELERATION, accelerating(reads)))
            }
            "alpha" => {
                let alpha = self.calculus.second_derivative(geometry.angle);
                Value::Scalar(alpha, Nature::derived(Dimension::ANGULAR_ACCELERATION, accelerating(reads)))
            }
            "body" => Value::Body(frame.body),
            _ => return Ok(None),
        }))
    }

    pub(super) fn body_member(&mut self, body: Option<usize>, name: &str) -> Eval<Option<Value>> {
        if let Some(port) = self.draft.port_index(body, name) {
            return Ok(Some(Value::Frame(FrameRef { body, port })));
        }
        let (q, v, a, rotation) = if let Some(body) = body {
            let body = &self.draft.bodies[body];
            (body.q, body.v, body.a, body.rotation)
        } else {
            let zero = [Expr::ZERO; 3];
            (zero, zero, zero, Rotation::IDENTITY)
        };
        let at = Reads::POSITION;
        let of = |dimension, reads| {
            Nature::derived(dimension, if body.is_some() { reads } else { Reads::NOTHING })
        };
        let scalar = |value: Expr, dimension, reads| Value::Scalar(value, of(dimension, reads));
        let vector =
            |[x, y, _]: [Expr; 3], dimension, reads| Value::Vector(Vec2::new(x, y), of(dimension, reads));
        let axis = rotation.axis();
        Ok(Some(match name {
            "x" => scalar(q[0], Dimension::LENGTH, at),
            "y" => scalar(q[1], Dimension::LENGTH, at),
            "angle" => scalar(q[2], Dimension::ANGLE, at),
            "position" => vector(q, Dimension::LENGTH, at),
            "axis" => Value::Vector(axis, of(Dimension::NUMBER, at)),
            "normal" => Value::Vector(axis.left(), of(Dimension::NUMBER, at)),
            "vx" => scalar(v[0], Dimension::VELOCITY, Reads::VELOCITY),
            "vy" => scalar(v[1], Dimension::VELOCITY, Reads::VELOCITY),
            "omega" => scalar(v[2], Dimension::ANGULAR_VELOCITY, Reads::VELOCITY),
            "velocity" => vector(v, Dimension::VELOCITY, Reads::VELOCITY),
            "ax" => scalar(a[0], Dimension::ACCELERATION, Reads::ACCELERATION),
            "ay" => scalar(a[1], Dimension::ACCELERATION, Reads::ACCELERATION),
            "alpha" => scalar(a[2], Dimension::ANGULAR_ACCELERATION, Reads::ACCELERATION),
            "acceleration" => vector(a, Dimension::ACCELERATION, Reads::ACCELERATION),
            _ => return Ok(None),
        }))
    }

    /// An output of a part in use, or a part that it contains.
    fn output_of(&mut self, scope: ScopeId, instance: usize, member: &'a IndexedName) -> Eval<Option<Value>> {
        let key = self.key(scope, member)?;
        let inside = self.names.instances[instance].scope;
        if let Some(slot) = self.names.scopes[inside].outputs.get(key.as_ref()).copied() {
            return self.force(slot, scope, member.ident.span).map(Some);
        }
        Ok(self.part_inside(inside, &key))
    }

    /// A part that a part contains.
    fn part_inside(&self, inside: ScopeId, key: &str) -> Option<Value> {
        let is_it = |of: &PartInUse| self.names.home(of.outer) == inside && of.key == key;
        self.names.instances.iter().position(is_it).map(Value::Instance)
    }

    fn unknown_member(&mut self, scope: ScopeId, value: &Value, member: &'a IndexedName) -> Failed {
        let span = member.ident.span;
        let Ok(name) = self.key(scope, member) else { return Failed };
        let name = name.as_ref();
        match value {
            Value::Body(body) => {
                let ports = self.draft.port_names(*body);
                let of = body.map_or("ground".to_string(), |body| self.draft.bodies[body].name.text.clone());
                let names: Vec<&str> = ports.iter().map(String::as_str).collect();
                let message = format!("unknown port `{name}` of `{of}`");
                let diagnostic = self.error(scope, Code::UnknownPort, span, message);
                help_similar(diagnostic, name, "port", &format!("ports of `{of}`"), &names);
                if body.is_some() && nearest(name, names.iter().copied()).is_none() {
                    diagnostic.note(format!("beside its ports a body has {}", OF_BODY.join(", ")));
                }
            }
            Value::Frame(_) => {
                let diagnostic =
                    self.error(scope, Code::UnknownMember, span, format!("a frame has no `{name}`"));
                help_similar(diagnostic, name, "member", "members of a frame", OF_FRAME);
            }
            Value::Node(node) => {
                let names = self.members_of_node(*node);
                let message = format!("the node `{}` has no `{name}`", self.draft.nodes[*node].name);
                let diagnostic = self.error(scope, Code::UnknownMember, span, message);
                help_similar(diagnostic, name, "member", "members of the node", &names);
            }
            Value::Instance(instance) => {
                let inside = self.names.instances[*instance].scope;
                let names: Vec<String> =
                    self.names.scopes[inside].outputs.keys().map(ToString::to_string).collect();
                let names: Vec<&str> = names.iter().map(String::as_str).collect();
                let of = self.names.instances[*instance].name.clone();
                let message = format!("the part `{of}` has no output `{name}`");
                let diagnostic = self.error(scope, Code::UnknownMember, span, message);
                help_similar(diagnostic, name, "output", &format!("outputs of `{of}`"), &names);
            }
            other => {
                let message = format!("{} has no `{name}`", other.kind());
                self.error(scope, Code::UnknownMember, span, message);
            }
        }
        Failed
    }
}

/// What the rate of a place reads: a place that depends on the time alone has a rate that does so too.
fn moving(reads: Reads) -> Reads {
    if reads.has(Reads::POSITION) { reads.and(Reads::VELOCITY) } else { reads }
}

/// What the rate of its rate reads.
fn accelerating(reads: Reads) -> Reads {
    if reads.has(Reads::POSITION) { moving(reads).and(Reads::ACCELERATION) } else { reads }
}
