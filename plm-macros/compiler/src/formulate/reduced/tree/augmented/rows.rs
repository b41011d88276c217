//! The equations, linearised term by term.

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, Vec2, algebra};

use super::unknowns::{Kind, Unknowns};
use crate::formulate::linearised::{Part, Terms};
use crate::formulate::reduced::joints::coordinates::{Coordinates, TreeEdge};
use crate::formulate::reduced::motion::Motion;
use crate::model::Model;

/// `D_b` and what follows from it.
pub(crate) struct Way {
    /// The coordinates that it depends on.
    touched: Vec<usize>,
    position: Vec2,
    speed: Vec2,
    pub(crate) acceleration: Vec2,
}

/// The derivatives of all equations, and the way to each body in the order of [`Coordinates::order`].
pub(crate) fn terms(model: &Model, motion: &Motion, unknowns: &Unknowns) -> (Vec<Way>, Terms) {
    let coordinates = motion.coordinates;
    let mut work = Rows { model, coordinates: motion.coordinates, motion, unknowns, terms: Terms::new() };
    let ways: Vec<Way> = coordinates.order.iter().map(|edge| work.way(edge)).collect_vec();
    work.kinematics(&ways);
    work.forces();
    work.virtual_power(&ways);
    work.states();
    (ways, work.terms)
}

/// The equations while they are being linearised.
struct Rows<'a> {
    model: &'a Model,
    coordinates: &'a Coordinates,
    motion: &'a Motion<'a>,
    unknowns: &'a Unknowns,
    terms: Terms,
}

impl Rows<'_> {
    /// Adds an expression to an equation: its derivatives by everything unknown.
    fn add(&mut self, row: usize, value: Expr) {
        let symbols = algebra::symbols(&[value]);
        for symbol in symbols {
            if let Some(&(column, part)) = self.unknowns.column.get(&symbol) {
                let derivative = value.diff(symbol);
                self.add_term((row, column, part), derivative);
            }
        }
    }

    fn add_term(&mut self, key: (usize, usize, Part), value: Expr) {
        *self.terms.or_insert(key, Expr::ZERO) += value;
    }

    /// From G of the body that holds it, or from the origin, to G of a body.
    fn way(&mut self, edge: &TreeEdge) -> Way {
        let position = self.position(edge);
        let symbols = algebra::symbols(&position.components());
        let touches = |k: &usize| symbols.binary_search(&self.motion.value[*k]).is_ok();
        let touched: Vec<usize> = (0..self.motion.value.len()).filter(touches).collect_vec();
        let mut flow = vec![(self.model.time, Expr::ONE)];
        for &k in &touched {
            let (value, speed) = (self.motion.value[k], self.motion.rate[k]);
            flow.push_all([(value, speed), (speed, self.unknowns.accelerations[k])]);
        }
        let rate = |of: Vec2| of.map(|component| component.directional(&flow));
        let speed = rate(position);
        Way { touched, position, speed, acceleration: rate(speed) }
    }

    fn position(&mut self, edge: &TreeEdge) -> Vec2 {
        let Rows { model, coordinates, motion, .. } = self;
        let Some(joint) = edge.joint else {
            let declared = &model.bodies[edge.body];
            return Vec2::new(declared.q[0], declared.q[1]);
        };
        let joint = coordinates.joints[joint];
        let (orientation, mut out) = coordinates.arm(model, joint.a);
        if let Some(displacement) = joint.displacement {
            let (_, axis) = coordinates.axis(model, joint.a);
            out += motion.value[displacement] * axis;
        }
        let out = motion.turned(orientation, out);
        let (orientation, back) = coordinates.arm(model, joint.b);
        let back = motion.turned(orientation, back);
        let way = out - back;
        if joint.b.body == Some(edge.body) { way } else { -way }
    }

    /// Accelerations, velocities and places of bodies follow from those of the bodies that hold them.
    fn kinematics(&mut self, ways: &[Way]) {
        for (edge, way) in self.coordinates.order.iter().zip(ways) {
            let of = |body: usize, kind: Kind| {
                let declared = &self.model.bodies[body];
                let [x, y, _] = match kind {
                    Kind::Place => declared.q,
                    Kind::Velocity => declared.v,
                    _ => declared.a,
                };
                Vec2::new(x, y)
            };
            let moved = [way.acceleration, way.speed, way.position];
            for (kind, moved) in [Kind::Acceleration, Kind::Velocity, Kind::Place].into_iter().zip(moved) {
                let Some(rows) = self.unknowns.of_body[edge.body].get(&kind).copied() else { continue };
                let mut value = of(edge.body, kind) - moved;
                if let Some(parent) = edge.parent {
                    value -= of(parent, kind);
                }
                for (row, component) in rows.into_iter().zip(value.components()) {
                    self.add(row, component);
                }
            }
        }
    }

    /// Forces that a body passes on to its joint.
    fn forces(&mut self) {
        let one = Expr::ONE;
        let minus = -one;
        for edge in &self.coordinates.order {
            let declared = &self.model.bodies[edge.body];
            let rows = self.unknowns.of_body[edge.body][&Kind::Force];
            let against = -declared.mass;
            for i in 0..2 {
                let (own, _) = self.unknowns.column[&declared.a[i]];
                self.add_term((rows[i], rows[i], Part::Value), one);
                self.add_term((rows[i], own, Part::Value), against);
                if let Some(parent) = edge.parent {
                    let outer = self.unknowns.of_body[parent][&Kind::Force];
                    self.add_term((outer[i], rows[i], Part::Value), minus);
                }
            }
        }
        for load in &self.model.loads {
            let rows = self.unknowns.of_body[load.body][&Kind::Force];
            for i in 0..2 {
                self.add(rows[i], load.force[i]);
            }
        }
    }

    /// One equation for every coordinate.
    fn virtual_power(&mut self, ways: &[Way]) {
        for (edge, way) in self.coordinates.order.iter().zip(ways) {
            let force = self.unknowns.forces[edge.body];
            for &unknown in &way.touched {
                let along = way.position.diff(self.motion.value[unknown]);
                self.add(unknown, force.dot(along));
            }
        }
        let angle = |body: usize| {
            self.coordinates.angle_of_orientation[self.coordinates.absolute_angles[body].orientation]
        };
        for (body, declared) in self.model.bodies.iter().enumerate() {
            if let Some(angle) = angle(body) {
                self.add_term((angle, angle, Part::Acceleration), declared.inertia);
            }
        }
        for load in &self.model.loads {
            if let Some(angle) = angle(load.body) {
                self.add(angle, -load.force[2]);
            }
        }
    }

    /// Rates of first-order states.
    fn states(&mut self) {
        let n = self.coordinates.unknowns.len();
        let one = Expr::ONE;
        for (k, state) in self.model.states.iter().enumerate() {
            self.add_term((n + k, n + k, Part::Rate), one);
            self.add(n + k, -state.rate);
        }
    }
}
