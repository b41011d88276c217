//! How the unknowns and the bodies move when the coordinates do.

pub(crate) mod bases;
pub(crate) mod memory;
pub(crate) mod solution;

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, Rotation, Vec2};

use crate::formulate::reduced::joints::chain::Chain;
use crate::formulate::reduced::joints::coordinates::{Coordinates, Heading, TreeEdge, Unknown, port};
use crate::formulate::reduced::motion::bases::{Bases, Products};
use crate::formulate::reduced::motion::solution::Solution;
use crate::model::{FrameRef, Model};

/// Values of the unknowns and of all that follows from them, as expressions.
pub(crate) struct Motion<'a> {
    pub(crate) coordinates: &'a Coordinates,
    pub(crate) time: Expr,
    /// The unknowns that are coordinates, in the order of the state.
    pub(crate) independent: Vec<usize>,
    /// Name of each unknown, as a path of the model.
    pub(crate) names: Vec<String>,
    /// Size of the scene, m.
    pub(crate) length: Expr,
    /// The part of a length, one in so many, that is rounding.
    pub(crate) agreement: Expr,
    /// A unit in the last place of 1.
    pub(crate) precision: Expr,
    /// Value of each unknown, rad or m.
    pub(crate) value: Vec<Expr>,
    /// Its rate, `K y' + k`.
    pub(crate) rate: Vec<Expr>,
    /// `K`: by unknown, by coordinate.
    pub(crate) gain: Vec<Vec<Expr>>,
    /// `k`.
    pub(crate) time_rate: Vec<Expr>,
    /// Second derivative of each unknown while those of the coordinates are zero; with a pace, over its square.
    pub(crate) bias: Vec<Expr>,
    /// The rate of the one coordinate on which everything depends, if there is nothing else that moves: all rates are gains
    /// times the pace, all that velocities ask for is a function of the pose times its square. Such a function need not
    /// wait for the velocity.
    pub(crate) pace: Option<Expr>,
    /// How far each class is turned.
    pub(crate) rotation: Vec<Rotation>,
    /// Vectors that turn with the classes, and their products.
    pub(crate) bases: Bases,
    /// Angular velocity of each class.
    pub(crate) omega: Vec<Expr>,
    /// Angular velocity of each class; with a pace, over it.
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

impl<'a> Motion<'a> {
    /// All unknowns as functions of the pose.
    pub(crate) fn of_pose(model: &Model, coordinates: &'a Coordinates, length: Expr) -> Motion<'a> {
        let mut motion = Motion::still(model, coordinates, length);
        for (k, &unknown) in coordinates.unknowns.iter().enumerate() {
            let value = of_pose(model, coordinates, unknown);
            motion.value[k] = value;
            if let Unknown::Angle { class, .. } = unknown {
                motion.rotation[class] = Rotation::by(value);
            }
        }
        motion
    }

    pub(crate) fn still(model: &Model, coordinates: &'a Coordinates, length: Expr) -> Motion<'a> {
        let zeros = vec![Expr::ZERO; coordinates.unknowns.len()];
        let classes = coordinates.angle_of_class.len();
        Motion {
            coordinates,
            time: model.time,
            independent: Vec::new(),
            names: coordinates.unknowns.iter().map(|&unknown| unknown.name(model)).collect_vec(),
            length,
            agreement: model.agreement,
            precision: model.precision,
            value: zeros.clone(),
            rate: zeros.clone(),
            gain: vec![Vec::new(); coordinates.unknowns.len()],
            time_rate: zeros.clone(),
            bias: zeros,
            pace: None,
            rotation: vec![Rotation::IDENTITY; classes],
            bases: Bases::default(),
            omega: vec![Expr::ZERO; classes],
            turning: vec![Expr::ZERO; classes],
            position: Vec::new(),
            velocity: Vec::new(),
            solutions: Vec::new(),
            substitution: Vec::new(),
        }
    }

    /// Of values by unknown, those of the independent coordinates.
    pub(crate) fn of_independent(&self, of: &[Expr]) -> Vec<Expr> {
        self.independent.iter().map(|&unknown| of[unknown]).collect_vec()
    }

    /// A vector in the axes of a class over the class's base.
    pub(crate) fn over_base(&self, class: usize, vector: Vec2) -> Vec2 {
        let Some(base) = self.bases.of_class(class) else { return vector };
        Rotation::between(base.own, vector).axis() / base.square
    }

    /// A vector in the axes of a class, in absolute axes.
    pub(crate) fn turned(&self, class: usize, vector: Vec2) -> Vec2 {
        let vector = self.over_base(class, vector);
        Rotation::to(self.base(class)) * vector
    }

    /// The products of two vectors that are given over the bases of their classes.
    pub(crate) fn products(&self, (a, u): (usize, Vec2), (b, w): (usize, Vec2)) -> Products {
        let constant = Products::of(u, w);
        let bases = self.products_of_bases(a, b);
        constant.turned(Rotation { cos: bases.dot, sin: bases.cross })
    }

    /// The products of the bases of two classes.
    pub(crate) fn products_of_bases(&self, a: usize, b: usize) -> Products {
        if a == b {
            let square = self.bases.of_class(a).map_or(Expr::ONE, |base| base.square);
            return Products { dot: square, cross: Expr::ZERO };
        }
        self.bases.products(a, b).unwrap_or_else(|| Products::of(self.base(a), self.base(b)))
    }

    fn base(&self, class: usize) -> Vec2 {
        self.bases.of_class(class).map_or(self.rotation[class].axis(), |base| base.vector)
    }

    /// Sum of the vectors of a loop that turn with none of some classes, without some slides.
    pub(crate) fn known_sum(&self, chain: &Chain, turns: &[usize], slides: &[usize]) -> Vec2 {
        let classes = chain.classes().into_iter().filter(|class| !turns.contains(class));
        classes.map(|class| self.turned(class, self.arm(chain, class, slides))).sum()
    }

    /// The vector of a loop in the axes of a class, without some slides.
    pub(crate) fn arm(&self, chain: &Chain, class: usize, without: &[usize]) -> Vec2 {
        let vectors =
            chain.of_class(class).filter(|(slide, _)| slide.is_none_or(|slide| !without.contains(&slide)));
        vectors.map(|(slide, vector)| slide.map_or(vector, |slide| self.value[slide] * vector)).sum()
    }

    /// The vector of a loop that turns with a class, in absolute axes.
    pub(crate) fn whole_arm(&self, chain: &Chain, class: usize) -> Vec2 {
        self.turned(class, self.arm(chain, class, &[]))
    }

    /// Names the vector of a loop that turns with an unknown angle.
    pub(crate) fn name_arm(&self, unknown: usize, arm: Vec2) -> Vec2 {
        let name = self.names[unknown].trim_end_matches(".angle");
        arm.named(format!("{name}.arm"))
    }

    /// Writes how far a class is turned.
    pub(crate) fn turn_class(&mut self, unknown: usize, class: usize, rotation: Rotation) {
        let name = self.names[unknown].trim_end_matches(".angle");
        self.rotation[class] = rotation.named(format!("{name}.cos"), format!("{name}.sin"));
    }

    /// Writes the value of a slide.
    pub(crate) fn set_slide(&mut self, unknown: usize, value: Expr) -> Expr {
        let value = value.named(&self.names[unknown]);
        self.value[unknown] = value;
        value
    }

    /// Writes the rate of an unknown whose coefficients are known.
    pub(crate) fn set_rate(&mut self, unknown: usize) {
        let driven = self.independent.iter().enumerate();
        let driven = driven.map(|(k, &coordinate)| self.gain[unknown][k] * self.rate[coordinate]);
        let rate: Expr = [self.time_rate[unknown]].into_iter().chain(driven).sum();
        let rate = rate.named(format!("{}.rate", self.names[unknown]));
        self.rate[unknown] = rate;
        if let Unknown::Angle { class, .. } = self.coordinates.unknowns[unknown] {
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

    /// Angular velocity of a class over the rate of a coordinate.
    pub(crate) fn turning_by(&self, class: usize, coordinate: usize) -> Expr {
        self.coordinates.angle_of_class[class].map_or(Expr::ZERO, |angle| self.gain[angle][coordinate])
    }

    /// Angular acceleration of a class while the second derivatives of the coordinates are zero; with a pace, over its square.
    pub(crate) fn turning_bias(&self, class: usize) -> Expr {
        self.coordinates.angle_of_class[class].map_or(Expr::ZERO, |angle| self.bias[angle])
    }

    /// A column of `K`.
    pub(crate) fn gains(&self, coordinate: usize) -> Vec<Expr> {
        self.gain.iter().map(|gains| gains[coordinate]).collect_vec()
    }

    /// Positions and velocities from the ground outwards, each from the one before.
    pub(crate) fn pose_bodies(&mut self, model: &Model) {
        let coordinates = self.coordinates;
        self.position = vec![Vec2::ZERO; model.bodies.len()];
        self.velocity = vec![Vec2::ZERO; model.bodies.len()];
        for edge in &coordinates.order {
            let body = edge.body;
            let Some(joint) = edge.joint else {
                self.position[body] = coordinates.centre(body, &self.value);
                self.velocity[body] = coordinates.centre(body, &self.rate);
                continue;
            };
            let (position, velocity) = self.beyond(model, edge, joint);
            let name = &model.bodies[body].name.text;
            self.position[body] = position.named_by([format!("{name}.x"), format!("{name}.y")]);
            self.velocity[body] = velocity.named_by([format!("{name}.vx"), format!("{name}.vy")]);
        }
    }

    /// Position and velocity of G of a body beyond a joint.
    fn beyond(&self, model: &Model, edge: &TreeEdge, joint: usize) -> (Vec2, Vec2) {
        let mut position = edge.parent.map_or(Vec2::ZERO, |parent| self.position[parent]);
        let mut velocity = edge.parent.map_or(Vec2::ZERO, |parent| self.velocity[parent]);
        let way = self.way(model, edge, joint);
        if let Some((slide, class, axis)) = way.slide {
            velocity += self.turned(class, self.rate[slide] * axis);
        }
        for Arm { class, vector, at_rest } in way.arms {
            position += vector;
            // A port of the ground may move with the time.
            if class == 0 {
                velocity += at_rest.diff(model.time);
            }
            velocity += self.omega[class] * vector.left();
        }
        (position, velocity)
    }

    /// The way through a joint, from G of the body before it to G of the body beyond.
    pub(crate) fn way(&self, model: &Model, edge: &TreeEdge, joint: usize) -> Way {
        let coordinates = self.coordinates;
        let joint = coordinates.joints[joint];
        let outward = joint.b.body == Some(edge.body);
        let signed = |vector: Vec2, positive: bool| if positive { vector } else { -vector };
        let (class, start) = coordinates.arm(model, joint.a);
        let (mut out, mut slide) = (start, None);
        if let Some(unknown) = joint.slide {
            let (_, axis) = coordinates.axis(model, joint.a);
            out += self.value[unknown] * axis;
            slide = Some((unknown, class, signed(axis, outward)));
        }
        let (other, back) = coordinates.arm(model, joint.b);
        let arm = |class: usize, arm: Vec2, at_rest: Vec2, positive: bool| Arm {
            class,
            vector: signed(self.turned(class, arm), positive),
            at_rest: signed(at_rest, positive),
        };
        Way { slide, arms: [arm(class, out, start, outward), arm(other, back, back, !outward)] }
    }

    pub(crate) fn substitute_headings(&mut self, model: &Model) {
        let mut pairs = Vec::new();
        for (body, declared) in model.bodies.iter().enumerate() {
            let heading = self.coordinates.headings[body];
            let angle = self.angle(heading);
            let omega = self.omega[heading.class];
            let axis = self.turned(heading.class, Rotation::by(heading.offset).axis());
            let [x, y, theta] = declared.q;
            let [vx, vy, spin] = declared.v;
            pairs.push_all([(theta.cos(), axis.x), (theta.sin(), axis.y), (theta, angle), (spin, omega)]);
            pairs.push_all([x, y].into_iter().zip(self.position[body].components()));
            pairs.push_all([vx, vy].into_iter().zip(self.velocity[body].components()));
        }
        pairs.retain(|(old, new)| old != new);
        self.substitution = pairs;
    }

    /// The angle of a heading.
    pub(crate) fn angle(&self, heading: Heading) -> Expr {
        let unknown = self.coordinates.angle_of_class[heading.class];
        let of_class = unknown.map_or(Expr::ZERO, |unknown| self.value[unknown]);
        of_class + heading.offset
    }
}

/// How one gets from a body to the next.
pub(crate) struct Way {
    /// The slide of the joint, the class with which its axis turns, and the axis in that class's axes.
    pub(crate) slide: Option<(usize, usize, Vec2)>,
    /// To the joint and on from it.
    pub(crate) arms: [Arm; 2],
}

/// A vector that turns with a class.
pub(crate) struct Arm {
    pub(crate) class: usize,
    /// In absolute axes.
    pub(crate) vector: Vec2,
    /// Without the slide, in the axes of the class.
    pub(crate) at_rest: Vec2,
}

/// The coordinate as a function of the absolute pose: the inverse of the pose.
pub(crate) fn of_pose(model: &Model, coordinates: &Coordinates, unknown: Unknown) -> Expr {
    match unknown {
        Unknown::Angle { body, .. } => model.bodies[body].q[2],
        Unknown::Centre { body, axis } => model.bodies[body].q[axis],
        Unknown::Slide { part } => {
            let frames = &model.parts[part].frames;
            let (a, b) = (frames[0], frames[1]);
            let (start, end) = (point(model, a), point(model, b));
            let between = end - start;
            let heading = coordinates.heading(a);
            let own = a.body.map_or(heading.offset, |body| model.bodies[body].q[2]);
            let angle = own + port(model, a).angle;
            between.dot(Rotation::by(angle).axis())
        }
    }
}

/// Absolute position of a port as a function of the pose.
fn point(model: &Model, frame: FrameRef) -> Vec2 {
    let at = port(model, frame).at;
    let Some(body) = frame.body else { return at };
    let [x, y, theta] = model.bodies[body].q;
    Vec2::new(x, y) + Rotation::by(theta) * at
}
