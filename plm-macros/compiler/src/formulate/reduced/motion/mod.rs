//! How the unknowns and the bodies move when the coordinates do.

pub(crate) mod bases;
pub(crate) mod memory;
pub(crate) mod solution;

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, Rotation, Vec2};

use crate::formulate::reduced::joints::chain::Chain;
use crate::formulate::reduced::joints::coordinates::{AbsoluteAngle, Coordinates, TreeEdge, Unknown, port};
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
    /// Kinematic coefficients `K`, derivatives of the unknowns by the coordinates: by unknown, by coordinate.
    pub(crate) coefficient: Vec<Vec<Expr>>,
    /// `k`.
    pub(crate) time_rate: Vec<Expr>,
    /// Second derivative of each unknown while those of the coordinates are zero; with a pace, over its square.
    pub(crate) bias: Vec<Expr>,
    /// The rate of the one coordinate on which everything depends, if there is nothing else that moves: all rates are coefficients
    /// times the pace, all that velocities ask for is a function of the pose times its square. Such a function need not
    /// wait for the velocity.
    pub(crate) pace: Option<Expr>,
    /// How far each orientation is turned.
    pub(crate) rotation: Vec<Rotation>,
    /// Vectors that turn with the orientations, and their products.
    pub(crate) bases: Bases,
    /// Angular velocity of each orientation.
    pub(crate) omega: Vec<Expr>,
    /// Angular velocity of each orientation; with a pace, over it.
    pub(crate) turning: Vec<Expr>,
    /// G of each body.
    pub(crate) position: Vec<Vec2>,
    /// Velocity of G of each body.
    pub(crate) velocity: Vec<Vec2>,
    /// The loops, in the order of solution.
    pub(crate) solutions: Vec<Solution>,
    /// Values for the symbols of the model: angles and their sines, positions, rates.
    pub(crate) substitution: Vec<(Expr, Expr)>,
}

impl<'a> Motion<'a> {
    /// All unknowns as functions of the pose.
    pub(crate) fn of_pose(model: &Model, coordinates: &'a Coordinates, length: Expr) -> Motion<'a> {
        let mut motion = Motion::still(model, coordinates, length);
        for (k, &unknown) in coordinates.unknowns.iter().enumerate() {
            let value = of_pose(model, coordinates, unknown);
            motion.value[k] = value;
            if let Unknown::Angle { orientation, .. } = unknown {
                motion.rotation[orientation] = Rotation::by(value);
            }
        }
        motion
    }

    pub(crate) fn still(model: &Model, coordinates: &'a Coordinates, length: Expr) -> Motion<'a> {
        let zeros = vec![Expr::ZERO; coordinates.unknowns.len()];
        let orientations = coordinates.angle_of_orientation.len();
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
            coefficient: vec![Vec::new(); coordinates.unknowns.len()],
            time_rate: zeros.clone(),
            bias: zeros,
            pace: None,
            rotation: vec![Rotation::IDENTITY; orientations],
            bases: Bases::default(),
            omega: vec![Expr::ZERO; orientations],
            turning: vec![Expr::ZERO; orientations],
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

    /// A vector in the axes of an orientation over the orientation's base.
    pub(crate) fn over_base(&self, orientation: usize, vector: Vec2) -> Vec2 {
        let Some(base) = self.bases.of_orientation(orientation) else { return vector };
        Rotation::between(base.own, vector).axis() / base.square
    }

    /// A vector in the axes of an orientation, in absolute axes.
    pub(crate) fn turned(&self, orientation: usize, vector: Vec2) -> Vec2 {
        let vector = self.over_base(orientation, vector);
        Rotation::to(self.base(orientation)) * vector
    }

    /// The products of two vectors that are given over the bases of their orientations.
    pub(crate) fn products(&self, (a, u): (usize, Vec2), (b, w): (usize, Vec2)) -> Products {
        let constant = Products::of(u, w);
        let bases = self.products_of_bases(a, b);
        constant.turned(Rotation { cos: bases.dot, sin: bases.cross })
    }

    /// The products of the bases of two orientations.
    pub(crate) fn products_of_bases(&self, a: usize, b: usize) -> Products {
        if a == b {
            let square = self.bases.of_orientation(a).map_or(Expr::ONE, |base| base.square);
            return Products { dot: square, cross: Expr::ZERO };
        }
        self.bases.products(a, b).unwrap_or_else(|| Products::of(self.base(a), self.base(b)))
    }

    fn base(&self, orientation: usize) -> Vec2 {
        self.bases.of_orientation(orientation).map_or(self.rotation[orientation].axis(), |base| base.vector)
    }

    /// Sum of the vectors of a loop that turn with none of some orientations, without some displacements.
    pub(crate) fn known_sum(&self, chain: &Chain, turns: &[usize], displacements: &[usize]) -> Vec2 {
        let orientations =
            chain.orientations().into_iter().filter(|orientation| !turns.contains(orientation));
        orientations
            .map(|orientation| self.turned(orientation, self.arm(chain, orientation, displacements)))
            .sum()
    }

    /// The vector of a loop in the axes of an orientation, without some displacements.
    pub(crate) fn arm(&self, chain: &Chain, orientation: usize, without: &[usize]) -> Vec2 {
        let vectors = chain.of_orientation(orientation).filter(|(displacement, _)| {
            displacement.is_none_or(|displacement| !without.contains(&displacement))
        });
        vectors
            .map(|(displacement, vector)| {
                displacement.map_or(vector, |displacement| self.value[displacement] * vector)
            })
            .sum()
    }

    /// The vector of a loop that turns with an orientation, in absolute axes.
    pub(crate) fn absolute_arm(&self, chain: &Chain, orientation: usize) -> Vec2 {
        self.turned(orientation, self.arm(chain, orientation, &[]))
    }

    /// Names the vector of a loop that turns with an unknown angle.
    pub(crate) fn name_arm(&self, unknown: usize, arm: Vec2) -> Vec2 {
        let name = self.names[unknown].trim_end_matches(".angle");
        arm.named(format!("{name}.arm"))
    }

    /// Writes how far an orientation is turned.
    pub(crate) fn set_rotation(&mut self, unknown: usize, orientation: usize, rotation: Rotation) {
        let name = self.names[unknown].trim_end_matches(".angle");
        self.rotation[orientation] = rotation.named(format!("{name}.cos"), format!("{name}.sin"));
    }

    /// Writes the value of an unknown.
    pub(crate) fn set_value(&mut self, unknown: usize, value: Expr) -> Expr {
        let value = value.named(&self.names[unknown]);
        self.value[unknown] = value;
        value
    }

    /// Writes the rate of an unknown whose coefficients are known.
    pub(crate) fn set_rate(&mut self, unknown: usize) {
        let driven = self.independent.iter().enumerate();
        let driven = driven.map(|(k, &coordinate)| self.coefficient[unknown][k] * self.rate[coordinate]);
        let rate: Expr = [self.time_rate[unknown]].into_iter().chain(driven).sum();
        let rate = rate.named(format!("{}.rate", self.names[unknown]));
        self.rate[unknown] = rate;
        if let Unknown::Angle { orientation, .. } = self.coordinates.unknowns[unknown] {
            self.omega[orientation] = rate;
            self.turning[orientation] = self.rate_over_pace(unknown);
        }
    }

    /// Rate of an unknown; with a pace, over it.
    pub(crate) fn rate_over_pace(&self, unknown: usize) -> Expr {
        match (self.pace, self.coefficient[unknown].first()) {
            (Some(_), Some(&coefficient)) => coefficient,
            _ => self.rate[unknown],
        }
    }

    /// Angular velocity of an orientation over the rate of a coordinate.
    pub(crate) fn turning_by(&self, orientation: usize, coordinate: usize) -> Expr {
        self.coordinates.angle_of_orientation[orientation]
            .map_or(Expr::ZERO, |angle| self.coefficient[angle][coordinate])
    }

    /// Angular acceleration of an orientation while the second derivatives of the coordinates are zero; with a pace, over its square.
    pub(crate) fn turning_bias(&self, orientation: usize) -> Expr {
        self.coordinates.angle_of_orientation[orientation].map_or(Expr::ZERO, |angle| self.bias[angle])
    }

    /// A column of `K`.
    pub(crate) fn coefficients(&self, coordinate: usize) -> Vec<Expr> {
        self.coefficient.iter().map(|coefficients| coefficients[coordinate]).collect_vec()
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
        if let Some((displacement, orientation, axis)) = way.displacement {
            velocity += self.turned(orientation, self.rate[displacement] * axis);
        }
        for Arm { orientation, vector, at_rest } in way.arms {
            position += vector;
            // A port of the ground may move with the time.
            if orientation == 0 {
                velocity += at_rest.diff(model.time);
            }
            velocity += self.omega[orientation] * vector.left();
        }
        (position, velocity)
    }

    /// The way through a joint, from G of the body before it to G of the body beyond.
    pub(crate) fn way(&self, model: &Model, edge: &TreeEdge, joint: usize) -> Way {
        let coordinates = self.coordinates;
        let joint = coordinates.joints[joint];
        let outward = joint.b.body == Some(edge.body);
        let signed = |vector: Vec2, positive: bool| if positive { vector } else { -vector };
        let (orientation, start) = coordinates.arm(model, joint.a);
        let (mut out, mut displacement) = (start, None);
        if let Some(unknown) = joint.displacement {
            let (_, axis) = coordinates.axis(model, joint.a);
            out += self.value[unknown] * axis;
            displacement = Some((unknown, orientation, signed(axis, outward)));
        }
        let (other, back) = coordinates.arm(model, joint.b);
        let arm = |orientation: usize, arm: Vec2, at_rest: Vec2, positive: bool| Arm {
            orientation,
            vector: signed(self.turned(orientation, arm), positive),
            at_rest: signed(at_rest, positive),
        };
        Way { displacement, arms: [arm(orientation, out, start, outward), arm(other, back, back, !outward)] }
    }

    pub(crate) fn substitute_absolute_angles(&mut self, model: &Model) {
        let mut pairs = Vec::new();
        for (body, declared) in model.bodies.iter().enumerate() {
            let absolute_angle = self.coordinates.absolute_angles[body];
            let angle = self.angle(absolute_angle);
            let omega = self.omega[absolute_angle.orientation];
            let axis = self.turned(absolute_angle.orientation, Rotation::by(absolute_angle.offset).axis());
            let [x, y, theta] = declared.q;
            let [vx, vy, spin] = declared.v;
            pairs.push_all([(theta.cos(), axis.x), (theta.sin(), axis.y), (theta, angle), (spin, omega)]);
            pairs.push_all([x, y].into_iter().zip(self.position[body].components()));
            pairs.push_all([vx, vy].into_iter().zip(self.velocity[body].components()));
        }
        pairs.retain(|(old, new)| old != new);
        self.substitution = pairs;
    }

    /// The absolute angle of a body.
    pub(crate) fn angle(&self, absolute_angle: AbsoluteAngle) -> Expr {
        let unknown = self.coordinates.angle_of_orientation[absolute_angle.orientation];
        let of_orientation = unknown.map_or(Expr::ZERO, |unknown| self.value[unknown]);
        of_orientation + absolute_angle.offset
    }
}

/// How one gets from a body to the next.
pub(crate) struct Way {
    /// The displacement of the joint, the orientation with which its axis turns, and the axis in that orientation's axes.
    pub(crate) displacement: Option<(usize, usize, Vec2)>,
    /// To the joint and on from it.
    pub(crate) arms: [Arm; 2],
}

/// A vector that turns with an orientation.
pub(crate) struct Arm {
    pub(crate) orientation: usize,
    /// In absolute axes.
    pub(crate) vector: Vec2,
    /// Without the displacement, in the axes of the orientation.
    pub(crate) at_rest: Vec2,
}

/// The coordinate as a function of the absolute pose: the inverse of the pose.
pub(crate) fn of_pose(model: &Model, coordinates: &Coordinates, unknown: Unknown) -> Expr {
    match unknown {
        Unknown::Angle { body, .. } => model.bodies[body].q[2],
        Unknown::Centre { body, axis } => model.bodies[body].q[axis],
        Unknown::Displacement { part } => {
            let frames = &model.parts[part].frames;
            let (a, b) = (frames[0], frames[1]);
            let (start, end) = (point(model, a), point(model, b));
            let between = end - start;
            let absolute_angle = coordinates.absolute_angle(a);
            let own = a.body.map_or(absolute_angle.offset, |body| model.bodies[body].q[2]);
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
