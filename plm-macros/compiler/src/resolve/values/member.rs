//! Members: what stands after a point.

use crate::collect::CollectVec;
use plm_cas::Expr;
use plm_cas::algebra::{Rotation, Vec2};

use crate::diag::{Code, help_similar, nearest};
use crate::library::OUTPUTS;
use crate::model::FrameRef;
use crate::resolve::Resolver;
use crate::resolve::declarations::body::UnresolvedBody;
use crate::resolve::declarations::frame::FrameGeometry;
use crate::resolve::declarations::part::PartInUse;
use crate::resolve::names::ScopeId;
use crate::resolve::values::member_table::{Member, Of, Owner};
use crate::resolve::values::{Eval, Failed, Nature, Quantity, Reads, Value};
use crate::syntax::ast::IndexedName;
use crate::units::Dimension;

/// Pose from which the members of a body, at its G, or of a frame are read.
struct Pose {
    body: Option<usize>,
    position: Vec2,
    angle: Expr,
    rotation: Rotation,
    /// Reads of it, of its rate, and of the rate of that.
    reads: [Reads; 3],
}

impl Pose {
    const GROUND: Pose = Pose {
        body: None,
        position: Vec2::ZERO,
        angle: Expr::ZERO,
        rotation: Rotation::IDENTITY,
        reads: [Reads::NOTHING; 3],
    };
}

impl<'a> Resolver<'a> {
    /// `value.name`
    pub(crate) fn member(&mut self, scope: ScopeId, value: &Value, member: &'a IndexedName) -> Eval<Value> {
        let name = member.ident.text.as_str();
        let found = match value {
            Value::Instance(instance) => self.output_of(scope, *instance, member)?,
            Value::Body(body) => {
                let key = self.key(scope, member)?;
                // Ports of the ground of a part have its path.
                let prefix = if body.is_none() { self.names.prefix(scope) } else { String::new() };
                self.body_member(*body, &format!("{prefix}{key}"))
            }
            _ if !member.indices.is_empty() => None,
            Value::Frame(frame) => self.frame_member(*frame, name)?,
            Value::Node(node) => {
                let found = self.node_member(*node, name);
                if found.is_none() && self.members_of_node(*node).first() == Some(&name) {
                    return Err(self.needs_itself(scope, *node, member.ident.span));
                }
                found
            }
            Value::Vector(vector) => match name {
                "x" => Some(vector.map(|v| v.x).into()),
                "y" => Some(vector.map(|v| v.y).into()),
                _ => None,
            },
            Value::Scalar(..)
            | Value::Condition(..)
            | Value::Choice(_)
            | Value::Function(_)
            | Value::Points(_) => None,
        };
        found.ok_or_else(|| self.unknown_member(scope, value, member))
    }

    pub(crate) fn frame_member(&mut self, frame: FrameRef, name: &str) -> Eval<Option<Value>> {
        let FrameGeometry { position, angle, rotation, reads, .. } = self.frame(frame)?;
        let reads = [reads, moving(reads), accelerating(reads)];
        let pose = Pose { body: frame.body, position, angle, rotation, reads };
        Ok(Member::named(Owner::Frame, name).map(|member| self.member_of(&pose, member)))
    }

    /// A port of a body or of the ground, or what its pose gives.
    pub(crate) fn body_member(&mut self, body: Option<usize>, name: &str) -> Option<Value> {
        if let Some(port) = self.unresolved.port_index(body, name) {
            return Some(Value::Frame(FrameRef { body, port }));
        }
        let pose = match body {
            Some(index) => {
                let UnresolvedBody { q: [x, y, angle], rotation, .. } = self.unresolved.bodies[index];
                let reads = [Reads::POSITION, Reads::VELOCITY, Reads::ACCELERATION];
                Pose { body, position: Vec2::new(x, y), angle, rotation, reads }
            }
            None => Pose::GROUND,
        };
        Member::named(Owner::Body, name).map(|member| self.member_of(&pose, member))
    }

    fn member_of(&mut self, pose: &Pose, member: &Member) -> Value {
        let order = member.order;
        let nature = |of: Dimension| {
            Nature::derived(of.over(Dimension::TIME.power(order.into())), pose.reads[usize::from(order)])
        };
        let mut derivative = |of: Expr| self.calculus.derivative(of, order);
        match member.of {
            Of::X => Quantity::new(derivative(pose.position.x), nature(Dimension::LENGTH)).into(),
            Of::Y => Quantity::new(derivative(pose.position.y), nature(Dimension::LENGTH)).into(),
            Of::Position => Quantity::new(pose.position.map(derivative), nature(Dimension::LENGTH)).into(),
            Of::Angle => Quantity::new(derivative(pose.angle), nature(Dimension::ANGLE)).into(),
            Of::Axis => Quantity::new(pose.rotation.axis(), nature(Dimension::NUMBER)).into(),
            Of::Normal => Quantity::new(pose.rotation.axis().left(), nature(Dimension::NUMBER)).into(),
            Of::Body => Value::Body(pose.body),
        }
    }

    /// An output of a part in use, or a part that it contains.
    fn output_of(&mut self, scope: ScopeId, instance: usize, member: &'a IndexedName) -> Eval<Option<Value>> {
        let key = self.key(scope, member)?;
        let inside = self.names.instances[instance].scope;
        if let Some(slot) = self.names.scopes[inside].outputs.get(key.as_ref()).copied() {
            return self.slot_value(slot, scope, member.ident.span).map(Some);
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
        let is_shown = [Code::UnknownPort, Code::UnknownMember].iter().all(|of| self.sink.shows(*of));
        match value {
            Value::Body(body) => {
                let ports = if is_shown { self.unresolved.port_names(*body) } else { Vec::new() };
                let of =
                    body.map_or("ground".to_string(), |body| self.unresolved.bodies[body].name.text.clone());
                let names: Vec<&str> = ports.iter().map(String::as_str).collect_vec();
                let message = format!("unknown port `{name}` of `{of}`");
                let diagnostic = self.error(scope, Code::UnknownPort, span, message);
                // A member, where no port is near.
                let is_port = body.is_none() || nearest(name, names.iter().copied()).is_some();
                let members = if is_port { Vec::new() } else { Member::names(Owner::Body) };
                let member = nearest(name, members.iter().copied());
                if let Some(near) = member {
                    diagnostic.help_with(format!("a member with a similar name exists: `{near}`"), near);
                }
                help_similar(diagnostic, name, "port", &format!("ports of `{of}`"), &names);
                if member.is_none() && !members.is_empty() {
                    diagnostic.note(format!("beside its ports a body has {}", members.join(", ")));
                }
            }
            Value::Frame(_) => {
                let diagnostic =
                    self.error(scope, Code::UnknownMember, span, format!("a frame has no `{name}`"));
                help_similar(diagnostic, name, "member", "members of a frame", &Member::names(Owner::Frame));
            }
            Value::Node(node) => {
                let names = self.members_of_node(*node);
                let message = format!("the node `{}` has no `{name}`", self.unresolved.nodes[*node].name);
                let diagnostic = self.error(scope, Code::UnknownMember, span, message);
                help_similar(diagnostic, name, "member", "members of the node", &names);
            }
            Value::Instance(instance) => {
                let inside = self.names.instances[*instance].scope;
                let outputs = self.names.scopes[inside].outputs.keys().filter(|_| is_shown);
                let names: Vec<String> = outputs.map(ToString::to_string).collect_vec();
                let names: Vec<&str> = names.iter().map(String::as_str).collect_vec();
                let of = self.names.instances[*instance].name.clone();
                let message = format!("the part `{of}` has no output `{name}`");
                let is_row = self.names.scopes[inside].rows.get(name).is_some();
                let given = self.where_given(*instance, name);
                let diagnostic = self.error(scope, Code::UnknownMember, span, message);
                if let Some(given) = given {
                    diagnostic.help(given);
                    return Failed;
                }
                if is_row {
                    diagnostic.help(format!("`{name}` is a row of it: its force is `reaction({of}.{name})`"));
                }
                match OUTPUTS.iter().find(|(word, here)| *word == name && names.contains(here)) {
                    Some((_, here)) => {
                        diagnostic.help(format!("write `{of}.{here}`"));
                    }
                    None => help_similar(diagnostic, name, "output", &format!("outputs of `{of}`"), &names),
                }
            }
            other => {
                let message = format!("{} has no `{name}`", other.kind());
                self.error(scope, Code::UnknownMember, span, message);
            }
        }
        Failed
    }
}

/// Reads of the rate of a place: a place that depends on the time alone has a rate that does so too.
fn moving(reads: Reads) -> Reads {
    if reads.has(Reads::POSITION) { reads.and(Reads::VELOCITY) } else { reads }
}

/// Reads of the rate of its rate.
fn accelerating(reads: Reads) -> Reads {
    if reads.has(Reads::POSITION) { moving(reads).and(Reads::ACCELERATION) } else { reads }
}
