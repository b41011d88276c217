//! Observed quantities: every one of a body, a port, a node or a part, by name.
//!
//! Actions of a part on the bodies of its ports are found from its loads and constraint rows, so that they hold for every
//! part: `Q - phi_q^T lambda`, of contacts `+z_q^T lambda`, summed over all that the part contains, carried to the point of the port. What it does to
//! the ground keeps the balance: constraints hold when everything is moved together, ground included.
//!
//! Observed quantities are outputs that are not declared. They have a graph of their own, so that the step keeps its bits.

use crate::collect::{CollectVec, MapEach, PushAll};
use crate::sorted::{SortedMap, SortedSet};

use plm_cas::Expr;
use plm_cas::algebra::{self, Vec2};

use crate::diag::Code;
use crate::model::{FrameRef, Name, Output};
use crate::resolve::Resolver;
use crate::resolve::declarations::load::Action;
use crate::resolve::names::{RowId, ScopeId};
use crate::resolve::values::member_table::{Member, Owner};
use crate::resolve::values::{Eval, Failed, Nature, Quantity, Reads, Value};
use crate::span::Span;
use crate::syntax::ast::{Expr as Written, ExprKind};
use crate::units::{Dimension, DisplayUnit};

/// Actions of the parts, and on whom.
struct Actions {
    /// Rows of each part, with those of the parts that it contains.
    rows: Vec<Vec<RowId>>,
    /// Forces and torques of each part, with those of the parts that it contains.
    applied: Vec<Vec<Action>>,
    /// Whose coordinate a symbol is.
    coordinates: SortedMap<Expr, (usize, usize)>,
}

/// The observed quantities, in order, none twice.
struct Shown {
    outputs: Vec<Output>,
    names: SortedSet<String>,
    span: Span,
}

impl Shown {
    fn push(&mut self, text: String, value: &Value, docs: String) {
        let Some((components, nature)) = value.components() else { return };
        if self.names.insert(text.clone()) {
            let (name, unit) = (Name { text, span: self.span }, DisplayUnit::si(nature.dimension));
            self.outputs.push(Output { name, components, unit, declared: false, docs });
        }
    }
}

impl<'a> Resolver<'a> {
    /// Adds to the outputs what is observed and not declared.
    pub(crate) fn evaluate_observed(&mut self, outputs: &mut Vec<Output>) {
        let mut targets: Vec<(Value, Span)> = Vec::new();
        for (scope, expr) in std::mem::take(&mut self.unresolved.observed) {
            // A mistake has been reported; the others are shown all the same.
            let _ = self.targets(scope, expr, &mut targets);
        }
        let Some(&(_, span)) = targets.first() else { return };
        let actions = self.actions();
        let names = outputs.iter().map(|output| output.name.text.clone()).collect();
        let mut shown = Shown { outputs: std::mem::take(outputs), names, span };
        for (target, span) in targets {
            shown.span = span;
            let _ = match target {
                Value::Body(body) => self.show_body(body, &mut shown),
                Value::Frame(frame) => self.show_port(frame, &mut shown),
                Value::Node(node) => {
                    self.show_node(node, &mut shown);
                    Ok(())
                }
                Value::Instance(instance) => self.show_part(instance, &actions, &mut shown),
                _ => Ok(()),
            };
        }
        *outputs = shown.outputs;
    }

    /// Targets of an `observe`; `all` is every body, the ground, every node and every part, those inside of parts too.
    fn targets(&mut self, scope: ScopeId, expr: &'a Written, targets: &mut Vec<(Value, Span)>) -> Eval<()> {
        let is_all = matches!(&expr.kind, ExprKind::Name(name) if name.ident.text == "all");
        if is_all && self.names.find(scope, "all").is_none() {
            // One that is another name of a node has no quantities of its own.
            let nodes =
                (0..self.unresolved.nodes.len()).filter(|&node| self.unresolved.nodes[node].across.is_some());
            let nodes = nodes.map(Value::Node);
            let bodies = (0..self.unresolved.bodies.len()).map(Some).chain([None]).map(Value::Body);
            let parts = (0..self.names.instances.len()).map(Value::Instance);
            targets.push_all(bodies.chain(nodes).chain(parts).map(|target| (target, expr.span)));
            return Ok(());
        }
        let value = self.eval(scope, expr)?;
        let help = match &value {
            Value::Body(_) | Value::Frame(_) | Value::Node(_) | Value::Instance(_) => {
                targets.push((value, expr.span));
                return Ok(());
            }
            Value::Scalar(..) | Value::Vector(..) => "a single quantity is shown by `output`",
            _ => "name a body, the ground, a port, a node, a part, or `all`",
        };
        let message = format!("{} cannot be observed", value.kind());
        self.error(scope, Code::WrongKind, expr.span, message).help(help);
        Err(Failed)
    }

    /// A body and its ports; the ground has no more than ports.
    fn show_body(&mut self, body: Option<usize>, shown: &mut Shown) -> Eval<()> {
        if let Some(moving) = body {
            let name = self.unresolved.bodies[moving].name.text.clone();
            for Member { name: member, .. } in Member::observed(Owner::Body) {
                if let Some(value) = self.body_member(body, member) {
                    shown.push(format!("{name}.{member}"), &value, String::new());
                }
            }
        }
        let ports =
            body.map_or(self.unresolved.ground.len(), |body| self.unresolved.bodies[body].ports.len());
        (0..ports).try_for_each(|port| self.show_port(FrameRef { body, port }, shown))
    }

    fn show_port(&mut self, frame: FrameRef, shown: &mut Shown) -> Eval<()> {
        let name = self.name_of_port(frame);
        for Member { name: member, .. } in Member::observed(Owner::Frame) {
            if let Some(value) = self.frame_member(frame, member)? {
                shown.push(format!("{name}.{member}"), &value, String::new());
            }
        }
        Ok(())
    }

    fn show_node(&mut self, node: usize, shown: &mut Shown) {
        let name = self.unresolved.nodes[node].name.clone();
        for member in self.members_of_node(node) {
            if let Some(value) = self.node_member(node, member) {
                shown.push(format!("{name}.{member}"), &value, String::new());
            }
        }
    }

    /// Outputs of the definition of a part, in its order; then its actions on each of its frames. Its nodes are shown by
    /// themselves.
    fn show_part(&mut self, id: usize, actions: &Actions, shown: &mut Shown) -> Eval<()> {
        let (inside, name) = (self.names.instances[id].scope, self.names.instances[id].name.clone());
        let outputs = self.names.scopes[inside].outputs.iter();
        let mut outputs: Vec<_> = outputs.map(|(key, slot)| (*slot, key.to_string())).collect_vec();
        outputs.sort_unstable();
        for (slot, key) in outputs {
            let value = self.slot_value(slot, inside, shown.span)?;
            let docs = self.docs_of_output(id, &key);
            shown.push(format!("{name}.{key}"), &value, docs);
        }
        if actions.rows[id].is_empty() && actions.applied[id].is_empty() {
            return Ok(());
        }
        let arguments = self.names.instances[id].definition.arguments.iter();
        let ports: Vec<&'a str> = arguments.map(|argument| argument.name.text.as_str()).collect_vec();
        let slots = self.names.instances[id].arguments.clone();
        for (port, slot) in ports.into_iter().zip(slots) {
            let Value::Frame(frame) = self.slot_value(slot, inside, shown.span)? else { continue };
            let (force, torque) = self.action_on(frame, id, actions)?;
            let of_frame = self.name_of_port(frame);
            let nature = |dimension| Nature::derived(dimension, Reads::ALL);
            shown.push(
                format!("{name}.force_on_{port}"),
                &Quantity::new(force, nature(Dimension::FORCE)).into(),
                format!("What `{name}` does to its port `{port}`, which is `{of_frame}`: the force, absolute axes."),
            );
            shown.push(
                format!("{name}.torque_on_{port}"),
                &Quantity::new(torque, nature(Dimension::TORQUE)).into(),
                format!(
                    "What `{name}` does to its port `{port}`, which is `{of_frame}`: the torque about it, positive to the left."
                ),
            );
        }
        Ok(())
    }

    pub(crate) fn name_of_port(&mut self, frame: FrameRef) -> String {
        let of =
            frame.body.map_or("ground".to_owned(), |body| self.unresolved.bodies[body].name.text.clone());
        format!("{of}.{}", self.unresolved.port(frame).name)
    }

    fn actions(&self) -> Actions {
        let count = self.names.instances.len();
        let (mut rows, mut applied) = (vec![Vec::new(); count], vec![Vec::new(); count]);
        for (row, state) in self.unresolved.rows.iter().enumerate() {
            self.names.around(state.scope).for_each(|part: usize| rows[part].push(RowId::Constraint(row)));
        }
        for (row, state) in self.unresolved.contacts.iter().enumerate() {
            self.names.around(state.scope).for_each(|part: usize| rows[part].push(RowId::Contact(row)));
        }
        for action in &self.unresolved.applied {
            self.names.around(action.scope).for_each(|part: usize| applied[part].push(*action));
        }
        let bodies = self.unresolved.bodies.iter().enumerate();
        let coordinates = bodies.flat_map(|(i, body)| (0..3).map(move |k| (body.q[k], (i, k)))).collect();
        Actions { rows, applied, coordinates }
    }

    /// Force and torque of a part on the body of a frame, about the point of the frame.
    fn action_on(&mut self, frame: FrameRef, part: usize, actions: &Actions) -> Eval<(Vec2, Expr)> {
        let about = self.frame(frame)?.arm;
        let mut terms = [const { Vec::new() }; 3];
        for action in actions.applied[part].iter().filter(|action| action.body == frame.body) {
            let arm = action.arm - about;
            let moment = arm.cross(action.force);
            terms[0].push(action.force.x);
            terms[1].push(action.force.y);
            terms[2].push_all([action.torque, moment]);
        }
        for &row in &actions.rows[part] {
            let reaction = self.reaction_on(frame.body, about, row, &actions.coordinates)?;
            terms.iter_mut().zip(reaction).for_each(|(sum, term)| sum.push(term));
        }
        let [x, y, torque] = terms.map_each(|sum| algebra::sum(&sum));
        Ok((Vec2::new(x, y), torque))
    }

    /// `-phi_q^T lambda` of one row, `+z_q^T lambda` of a contact, on a body as force and torque about a point, an arm from G; on the ground, about a
    /// point of the plane, the opposite of the sum over all bodies.
    fn reaction_on(
        &mut self,
        body: Option<usize>,
        about: Vec2,
        row: RowId,
        coordinates: &SortedMap<Expr, (usize, usize)>,
    ) -> Eval<[Expr; 3]> {
        let (phi, lambda) = match row {
            RowId::Constraint(row) => (self.row(row)?.phi, self.unresolved.rows[row].lambda),
            RowId::Contact(row) => (self.displacement(row)?.value, -self.unresolved.contacts[row].lambda),
        };
        let mut terms = [const { Vec::new() }; 3];
        let held = algebra::symbols(&[phi]);
        let touched: SortedSet<usize> =
            held.iter().filter_map(|symbol| coordinates.get(symbol)).map(|(i, _)| *i).collect();
        for i in touched.into_iter().filter(|i| body.is_none_or(|body| body == *i)) {
            let q = self.unresolved.bodies[i].q;
            let [x, y, theta] = q.map_each(|symbol| phi.diff(symbol));
            // From the point to G.
            let arm = match body {
                Some(_) => -about,
                None => Vec2::new(q[0], q[1]) - about,
            };
            let moment = arm.cross(Vec2::new(x, y));
            terms[0].push(x);
            terms[1].push(y);
            terms[2].push_all([theta, moment]);
        }
        let factor = if body.is_some() { -lambda } else { lambda };
        Ok(terms.map_each(|sum| factor * algebra::sum(&sum)))
    }
}
