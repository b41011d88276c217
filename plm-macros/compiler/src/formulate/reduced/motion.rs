//! How the bodies move when the coordinates do.

use plm_cas::{Expr, Graph};

use super::coordinates::{Coordinates, Heading, Unknown};
use super::plane::{self, Vec2};
use crate::model::{FrameRef, Model};

/// Values of the coordinates and of all that follows from them, as expressions.
#[derive(Debug)]
pub(crate) struct Motion {
    /// Value of each coordinate, rad or m.
    pub(crate) value: Vec<Expr>,
    /// Its rate.
    pub(crate) rate: Vec<Expr>,
    /// Cosine and sine of each class.
    pub(crate) axis: Vec<Vec2>,
    /// Angular velocity of each class.
    pub(crate) omega: Vec<Expr>,
    /// G of each body.
    pub(crate) position: Vec<Vec2>,
    /// Velocity of G of each body.
    pub(crate) velocity: Vec<Vec2>,
    /// What stands for the symbols of the model: angles and their sines, positions, rates.
    pub(crate) substitution: Vec<(Expr, Expr)>,
}

impl Motion {
    /// Coordinates that are angles or centres keep the symbols of their bodies; slides get their own.
    pub(crate) fn new(model: &Model, coordinates: &Coordinates, graph: &mut Graph) -> Motion {
        let mut motion = Motion {
            value: Vec::new(),
            rate: Vec::new(),
            axis: Vec::new(),
            omega: Vec::new(),
            position: Vec::new(),
            velocity: Vec::new(),
            substitution: Vec::new(),
        };
        for unknown in &coordinates.unknowns {
            let (value, rate) = symbols(model, graph, *unknown);
            motion.value.push(value);
            motion.rate.push(rate);
        }
        for angle in &coordinates.angle_of_class {
            let (axis, omega) = match *angle {
                Some(unknown) => {
                    let angle = motion.value[unknown];
                    ([graph.cos(angle), graph.sin(angle)], motion.rate[unknown])
                }
                None => ([graph.one(), graph.zero()], graph.zero()),
            };
            motion.axis.push(axis);
            motion.omega.push(omega);
        }
        motion.place(model, coordinates, graph);
        motion.substitute_headings(model, coordinates, graph);
        motion
    }

    /// Positions and velocities from the ground outwards, each from the one before.
    fn place(&mut self, model: &Model, coordinates: &Coordinates, graph: &mut Graph) {
        let zero = [graph.zero(); 2];
        self.position = vec![zero; model.bodies.len()];
        self.velocity = vec![zero; model.bodies.len()];
        for hold in &coordinates.order {
            let body = hold.body;
            let names = &model.bodies[body];
            let Some(joint) = hold.joint else {
                self.position[body] = [names.q[0], names.q[1]];
                self.velocity[body] = [names.v[0], names.v[1]];
                continue;
            };
            let joint = coordinates.joints[joint];
            let negative = joint.b.body != Some(body);
            let mut position = hold.parent.map_or(zero, |parent| self.position[parent]);
            let mut velocity = hold.parent.map_or(zero, |parent| self.velocity[parent]);
            let (class, mut out) = coordinates.arm(model, graph, joint.a);
            if let Some(slide) = joint.slide {
                let (_, axis) = coordinates.axis(model, graph, joint.a);
                let along = plane::scale(graph, self.value[slide], axis);
                out = plane::add(graph, out, along);
                let speed = plane::scale(graph, self.rate[slide], axis);
                let speed = self.turned(graph, class, speed);
                velocity = signed_sum(graph, velocity, speed, negative);
            }
            let (other, back) = coordinates.arm(model, graph, joint.b);
            for (class, arm, negative) in [(class, out, negative), (other, back, !negative)] {
                let arm = self.turned(graph, class, arm);
                position = signed_sum(graph, position, arm, negative);
                // A port of the ground may move with the time.
                if class == 0 {
                    let drift = arm.map(|component| graph.diff(component, model.time));
                    velocity = signed_sum(graph, velocity, drift, negative);
                }
                let across = plane::left(graph, arm);
                let across = plane::scale(graph, self.omega[class], across);
                velocity = signed_sum(graph, velocity, across, negative);
            }
            let named = |graph: &mut Graph, value: Vec2, kind: [&str; 2]| {
                [0, 1].map(|i| graph.define(&format!("{}.{}", names.name.text, kind[i]), value[i]))
            };
            self.position[body] = named(graph, position, ["x", "y"]);
            self.velocity[body] = named(graph, velocity, ["vx", "vy"]);
        }
    }

    /// A vector in the axes of a class, in absolute axes.
    pub(crate) fn turned(&self, graph: &mut Graph, class: usize, vector: Vec2) -> Vec2 {
        plane::turn(graph, self.axis[class], vector)
    }

    /// Cosine and sine of a body's own angle.
    fn axis_of(&self, graph: &mut Graph, heading: Heading) -> Vec2 {
        let offset = [graph.cos(heading.offset), graph.sin(heading.offset)];
        self.turned(graph, heading.class, offset)
    }

    fn substitute_headings(&mut self, model: &Model, coordinates: &Coordinates, graph: &mut Graph) {
        let mut pairs = Vec::new();
        for (body, declared) in model.bodies.iter().enumerate() {
            let heading = coordinates.headings[body];
            let angle = self.angle(coordinates, graph, heading);
            let omega = self.omega[heading.class];
            let [cos, sin] = self.axis_of(graph, heading);
            let [x, y, theta] = declared.q;
            let [vx, vy, spin] = declared.v;
            let (own_cos, own_sin) = (graph.cos(theta), graph.sin(theta));
            pairs.extend([(own_cos, cos), (own_sin, sin), (theta, angle), (spin, omega)]);
            pairs.extend([x, y].into_iter().zip(self.position[body]));
            pairs.extend([vx, vy].into_iter().zip(self.velocity[body]));
        }
        pairs.retain(|(old, new)| old != new);
        self.substitution = pairs;
    }

    /// The angle of a heading.
    pub(crate) fn angle(&self, coordinates: &Coordinates, graph: &mut Graph, heading: Heading) -> Expr {
        let unknown = coordinates.angle_of_class[heading.class];
        let of_class = unknown.map_or(graph.zero(), |unknown| self.value[unknown]);
        graph.add(of_class, heading.offset)
    }
}

/// The coordinate as a function of the absolute pose: what a state on rung 5 becomes here.
pub(crate) fn of_pose(model: &Model, coordinates: &Coordinates, graph: &mut Graph, unknown: Unknown) -> Expr {
    match unknown {
        Unknown::Angle { body, .. } => model.bodies[body].q[2],
        Unknown::Centre { body, axis } => model.bodies[body].q[axis],
        Unknown::Slide { part } => {
            let frames = &model.parts[part].frames;
            let (a, b) = (frames[0], frames[1]);
            let (start, end) = (point(model, graph, a), point(model, graph, b));
            let between = [0, 1].map(|i| graph.sub(end[i], start[i]));
            let heading = coordinates.heading(a, graph);
            let own = super::coordinates::port(model, a).angle;
            let angle = a.body.map_or(heading.offset, |body| model.bodies[body].q[2]);
            let angle = graph.add(angle, own);
            let axis = [graph.cos(angle), graph.sin(angle)];
            plane::dot(graph, between, axis)
        }
    }
}

/// Absolute position of a port as a function of the pose.
fn point(model: &Model, graph: &mut Graph, frame: FrameRef) -> Vec2 {
    let at = super::coordinates::port(model, frame).at;
    let Some(body) = frame.body else { return at };
    let [x, y, theta] = model.bodies[body].q;
    let axis = [graph.cos(theta), graph.sin(theta)];
    let arm = plane::turn(graph, axis, at);
    plane::add(graph, [x, y], arm)
}

fn symbols(model: &Model, graph: &mut Graph, unknown: Unknown) -> (Expr, Expr) {
    match unknown {
        Unknown::Angle { body, .. } => (model.bodies[body].q[2], model.bodies[body].v[2]),
        Unknown::Centre { body, axis } => (model.bodies[body].q[axis], model.bodies[body].v[axis]),
        Unknown::Slide { part } => {
            let name = &model.parts[part].name.text;
            (graph.symbol(&format!("s_{name}")), graph.symbol(&format!("v_{name}")))
        }
    }
}

fn signed_sum(graph: &mut Graph, a: Vec2, b: Vec2, negative: bool) -> Vec2 {
    let b = if negative { b.map(|component| graph.neg(component)) } else { b };
    plane::add(graph, a, b)
}
