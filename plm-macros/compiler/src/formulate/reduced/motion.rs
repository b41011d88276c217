//! How the unknowns and the bodies move when the coordinates do.

use plm_cas::{Expr, algebra};

use super::bases::Bases;
use super::chain::Chain;
use super::charts::Scheme;
use super::coordinates::{Coordinates, Heading, Unknown};
use super::memory::Memory;
use super::plane::{self, Vec2};
use super::solution::Solution;
use crate::model::{FrameRef, Model};

/// Values of the unknowns and of all that follows from them, as expressions.
#[derive(Debug)]
pub(crate) struct Motion {
    /// The unknowns that are coordinates, in the order of the state.
    pub(crate) drivers: Vec<usize>,
    /// Name of each unknown, as a path of the model.
    pub(crate) names: Vec<String>,
    /// Size of the scene, m.
    pub(crate) length: Expr,
    /// The part of a length, one in so many, that is rounding.
    pub(crate) agreement: Expr,
    /// Value of each unknown, rad or m.
    pub(crate) value: Vec<Expr>,
    /// Its rate, `K y' + k`.
    pub(crate) rate: Vec<Expr>,
    /// `K`: by unknown, by coordinate.
    pub(crate) gain: Vec<Vec<Expr>>,
    /// `k`.
    pub(crate) drift: Vec<Expr>,
    /// Second derivative of each unknown while those of the coordinates are zero; with a pace, over its square.
    pub(crate) bias: Vec<Expr>,
    /// The rate of the one coordinate on which everything depends, if there is nothing else that moves: all rates are gains
    /// times the pace, all that velocities ask for is a function of the pose times its square. Such a function need not
    /// wait for the velocity.
    pub(crate) pace: Option<Expr>,
    /// Cosine and sine of each class.
    pub(crate) axis: Vec<Vec2>,
    /// Vectors that turn with the classes, and their products.
    pub(crate) bases: Bases,
    /// Angular velocity of each class.
    pub(crate) omega: Vec<Expr>,
    /// The same; with a pace, over it.
    pub(crate) turning: Vec<Expr>,
    /// G of each body.
    pub(crate) position: Vec<Vec2>,
    /// Velocity of G of each body.
    pub(crate) velocity: Vec<Vec2>,
    /// The loops, in the order of solution.
    pub(crate) solutions: Vec<Solution>,
    /// What stands for the symbols of the model: angles and their sines, positions, rates.
    pub(crate) substitution: Vec<(Expr, Expr)>,
}

impl Motion {
    /// Coordinates that are angles or centres keep the symbols of their bodies; slides get their own.
    pub(crate) fn new(
        model: &Model,
        coordinates: &Coordinates,
        scheme: &Scheme,
        memory: &Memory,
        length: Expr,
    ) -> Motion {
        let mut motion = Motion::still(model, coordinates, length);
        let paced = scheme.drivers.len() == 1 && !coordinates.moves_with(model.time);
        for (place, &unknown) in scheme.drivers.iter().enumerate() {
            let (value, rate) = symbols(model, coordinates.unknowns[unknown]);
            motion.pace = paced.then_some(rate);
            (motion.value[unknown], motion.rate[unknown]) = (value, rate);
            for gains in &mut motion.gain {
                gains.push(Expr::ZERO);
            }
            motion.gain[unknown][place] = Expr::ONE;
            motion.drivers.push(unknown);
            if let Unknown::Angle { class, .. } = coordinates.unknowns[unknown] {
                motion.axis[class] = [value.cos(), value.sin()];
                motion.omega[class] = rate;
                motion.turning[class] = if paced { Expr::ONE } else { rate };
            }
        }
        for group in &scheme.groups {
            let place = motion.solutions.len();
            group.solve(coordinates, &mut motion, (memory, place), model.time);
        }
        motion.place(model, coordinates);
        motion.substitute_headings(model, coordinates);
        motion
    }

    /// All unknowns as functions of the pose.
    pub(crate) fn of_pose(model: &Model, coordinates: &Coordinates, length: Expr) -> Motion {
        let mut motion = Motion::still(model, coordinates, length);
        for (k, &unknown) in coordinates.unknowns.iter().enumerate() {
            let value = of_pose(model, coordinates, unknown);
            motion.value[k] = value;
            if let Unknown::Angle { class, .. } = unknown {
                motion.axis[class] = [value.cos(), value.sin()];
            }
        }
        motion
    }

    fn still(model: &Model, coordinates: &Coordinates, length: Expr) -> Motion {
        let zeros = vec![Expr::ZERO; coordinates.unknowns.len()];
        let classes = coordinates.angle_of_class.len();
        Motion {
            drivers: Vec::new(),
            names: coordinates.unknowns.iter().map(|&unknown| super::inertia::name(model, unknown)).collect(),
            length,
            agreement: model.agreement,
            value: zeros.clone(),
            rate: zeros.clone(),
            gain: vec![Vec::new(); coordinates.unknowns.len()],
            drift: zeros.clone(),
            bias: zeros,
            pace: None,
            axis: vec![[Expr::ONE, Expr::ZERO]; classes],
            bases: Bases::default(),
            omega: vec![Expr::ZERO; classes],
            turning: vec![Expr::ZERO; classes],
            position: Vec::new(),
            velocity: Vec::new(),
            solutions: Vec::new(),
            substitution: Vec::new(),
        }
    }

    /// The vector of a loop in the axes of a class, without some slides.
    pub(crate) fn arm(&self, chain: &Chain, class: usize, without: &[usize]) -> Vec2 {
        let mut sum = [Expr::ZERO; 2];
        for (slide, vector) in chain.of_class(class) {
            let vector = match slide {
                Some(slide) if without.contains(&slide) => continue,
                Some(slide) => plane::scale(self.value[slide], vector),
                None => vector,
            };
            sum = plane::add(sum, vector);
        }
        sum
    }

    /// The vector of a loop that turns with a class, in absolute axes.
    pub(crate) fn whole_arm(&self, chain: &Chain, class: usize) -> Vec2 {
        let arm = self.arm(chain, class, &[]);
        self.turned(class, arm)
    }

    /// Names the vector of a loop that turns with an unknown angle.
    pub(crate) fn name_arm(&self, unknown: usize, arm: Vec2) -> Vec2 {
        let name = self.names[unknown].trim_end_matches(".angle");
        [arm[0].named(format!("{name}.arm_x")), arm[1].named(format!("{name}.arm_y"))]
    }

    /// Writes the axis of a class.
    pub(crate) fn turn_class(&mut self, unknown: usize, class: usize, axis: Vec2) {
        let name = self.names[unknown].trim_end_matches(".angle");
        self.axis[class] = [axis[0].named(format!("{name}.cos")), axis[1].named(format!("{name}.sin"))];
    }

    /// Writes the value of a slide.
    pub(crate) fn set_slide(&mut self, unknown: usize, value: Expr) -> Expr {
        let value = value.named(&self.names[unknown]);
        self.value[unknown] = value;
        value
    }

    /// Writes the rate of an unknown whose coefficients are known.
    pub(crate) fn set_rate(&mut self, coordinates: &Coordinates, unknown: usize) {
        let mut terms = vec![self.drift[unknown]];
        for (place, &driver) in self.drivers.iter().enumerate() {
            terms.push(self.gain[unknown][place] * self.rate[driver]);
        }
        let rate = algebra::sum(&terms);
        let rate = rate.named(format!("{}.rate", self.names[unknown]));
        self.rate[unknown] = rate;
        if let Unknown::Angle { class, .. } = coordinates.unknowns[unknown] {
            self.omega[class] = rate;
            self.turning[class] = self.sliding(unknown);
        }
    }

    /// Rate of an unknown; with a pace, over it.
    pub(crate) fn sliding(&self, unknown: usize) -> Expr {
        match (self.pace, self.gain[unknown].first()) {
            (Some(_), Some(&gain)) => gain,
            _ => self.rate[unknown],
        }
    }

    /// Positions and velocities from the ground outwards, each from the one before.
    fn place(&mut self, model: &Model, coordinates: &Coordinates) {
        let zero = [Expr::ZERO; 2];
        self.position = vec![zero; model.bodies.len()];
        self.velocity = vec![zero; model.bodies.len()];
        for hold in &coordinates.order {
            let body = hold.body;
            let names = &model.bodies[body];
            let Some(joint) = hold.joint else {
                for axis in 0..2 {
                    let centre = Unknown::Centre { body, axis };
                    let Some(unknown) = coordinates.unknowns.iter().position(|&of| of == centre) else {
                        continue;
                    };
                    self.position[body][axis] = self.value[unknown];
                    self.velocity[body][axis] = self.rate[unknown];
                }
                continue;
            };
            let joint = coordinates.joints[joint];
            let negative = joint.b.body != Some(body);
            let mut position = hold.parent.map_or(zero, |parent| self.position[parent]);
            let mut velocity = hold.parent.map_or(zero, |parent| self.velocity[parent]);
            let (class, start) = coordinates.arm(model, joint.a);
            let mut out = start;
            if let Some(slide) = joint.slide {
                let (_, axis) = coordinates.axis(model, joint.a);
                let along = plane::scale(self.value[slide], axis);
                out = plane::add(out, along);
                let speed = plane::scale(self.rate[slide], axis);
                let speed = self.turned(class, speed);
                velocity = signed_sum(velocity, speed, negative);
            }
            let (other, back) = coordinates.arm(model, joint.b);
            for (class, arm, fixed, negative) in
                [(class, out, start, negative), (other, back, back, !negative)]
            {
                let arm = self.turned(class, arm);
                position = signed_sum(position, arm, negative);
                // A port of the ground may move with the time.
                if class == 0 {
                    let drift = fixed.map(|component| component.diff(model.time));
                    velocity = signed_sum(velocity, drift, negative);
                }
                let across = plane::left(arm);
                let across = plane::scale(self.omega[class], across);
                velocity = signed_sum(velocity, across, negative);
            }
            let named = |value: Vec2, kind: [&str; 2]| {
                [0, 1].map(|i| value[i].named(format!("{}.{}", names.name.text, kind[i])))
            };
            self.position[body] = named(position, ["x", "y"]);
            self.velocity[body] = named(velocity, ["vx", "vy"]);
        }
    }

    /// Cosine and sine of a body's own angle.
    fn axis_of(&self, heading: Heading) -> Vec2 {
        let offset = [heading.offset.cos(), heading.offset.sin()];
        self.turned(heading.class, offset)
    }

    fn substitute_headings(&mut self, model: &Model, coordinates: &Coordinates) {
        let mut pairs = Vec::new();
        for (body, declared) in model.bodies.iter().enumerate() {
            let heading = coordinates.headings[body];
            let angle = self.angle(coordinates, heading);
            let omega = self.omega[heading.class];
            let [cos, sin] = self.axis_of(heading);
            let [x, y, theta] = declared.q;
            let [vx, vy, spin] = declared.v;
            let (own_cos, own_sin) = (theta.cos(), theta.sin());
            pairs.extend([(own_cos, cos), (own_sin, sin), (theta, angle), (spin, omega)]);
            pairs.extend([x, y].into_iter().zip(self.position[body]));
            pairs.extend([vx, vy].into_iter().zip(self.velocity[body]));
        }
        pairs.retain(|(old, new)| old != new);
        self.substitution = pairs;
    }

    /// The angle of a heading.
    pub(crate) fn angle(&self, coordinates: &Coordinates, heading: Heading) -> Expr {
        let unknown = coordinates.angle_of_class[heading.class];
        let of_class = unknown.map_or(Expr::ZERO, |unknown| self.value[unknown]);
        of_class + heading.offset
    }
}

/// The coordinate as a function of the absolute pose: what a state on rung 5 becomes here.
pub(crate) fn of_pose(model: &Model, coordinates: &Coordinates, unknown: Unknown) -> Expr {
    match unknown {
        Unknown::Angle { body, .. } => model.bodies[body].q[2],
        Unknown::Centre { body, axis } => model.bodies[body].q[axis],
        Unknown::Slide { part } => {
            let frames = &model.parts[part].frames;
            let (a, b) = (frames[0], frames[1]);
            let (start, end) = (point(model, a), point(model, b));
            let between = [0, 1].map(|i| end[i] - start[i]);
            let heading = coordinates.heading(a);
            let own = super::coordinates::port(model, a).angle;
            let angle = a.body.map_or(heading.offset, |body| model.bodies[body].q[2]);
            let angle = angle + own;
            let axis = [angle.cos(), angle.sin()];
            plane::dot(between, axis)
        }
    }
}

/// Absolute position of a port as a function of the pose.
fn point(model: &Model, frame: FrameRef) -> Vec2 {
    let at = super::coordinates::port(model, frame).at.components();
    let Some(body) = frame.body else { return at };
    let [x, y, theta] = model.bodies[body].q;
    let axis = [theta.cos(), theta.sin()];
    let arm = plane::turn(axis, at);
    plane::add([x, y], arm)
}

fn symbols(model: &Model, unknown: Unknown) -> (Expr, Expr) {
    match unknown {
        Unknown::Angle { body, .. } => (model.bodies[body].q[2], model.bodies[body].v[2]),
        Unknown::Centre { body, axis } => (model.bodies[body].q[axis], model.bodies[body].v[axis]),
        Unknown::Slide { part } => {
            let name = &model.parts[part].name.text;
            (Expr::symbol(format!("s_{name}")), Expr::symbol(format!("v_{name}")))
        }
    }
}

fn signed_sum(a: Vec2, b: Vec2, negative: bool) -> Vec2 {
    let b = if negative { b.map(|component| -component) } else { b };
    plane::add(a, b)
}
