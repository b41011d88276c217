//! A scene as equations `M a + phi_q^T lambda = Q`, `phi = 0` in absolute coordinates (x, y, theta) of every body.
//!
//! E. J. Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems (1989), sections 3.3 and 6.3.

use super::dd::{Dd, convolved};
use super::tape::{Id, Tape};
use crate::scene::{Frame, Joint, Kind, Load, Scene};

/// A derivative of a constraint: constant, or a node.
#[derive(Clone, Copy)]
pub enum Entry {
    Constant(Dd),
    Node(Id),
}

/// A constraint: its residual, and its derivatives by coordinates.
pub struct Row {
    pub residual: Id,
    pub entries: Vec<(usize, Entry)>,
}

/// Spring, damper and load of a joint: `measure` is what they count, `along` its derivatives by coordinates.
struct Force {
    measure: Id,
    along: Vec<(usize, Entry)>,
    joint: Joint,
    driven: bool,
}

/// Equations of a scene.
pub struct Model {
    pub tape: Tape,
    pub rows: Vec<Row>,
    forces: Vec<Force>,
    /// 1/m, 1/m, 1/J of each body.
    pub inverse: Vec<Dd>,
    load: Load,
    masses: Vec<f64>,
    inertias: Vec<f64>,
    gravity: f64,
    /// Half the diagonal of the box of everything, m.
    pub size: f64,
}

/// A frame on the tape: its place from the origin of its body, its place, the direction of its axis.
struct Placed {
    body: Option<usize>,
    arm: [Id; 2],
    place: [Id; 2],
    axis: [Id; 2],
    angle: Id,
}

impl Model {
    pub fn new(scene: &Scene) -> Self {
        let mut tape = Tape::default();
        let bodies: Vec<[Id; 5]> = (0..scene.bodies.len())
            .map(|body| {
                let [x, y, angle] = [0, 1, 2].map(|k| tape.coordinate(3 * body + k));
                let (sine, cosine) = tape.sin_cos(angle);
                [x, y, angle, sine, cosine]
            })
            .collect();
        let (mut rows, mut forces) = (Vec::new(), Vec::new());
        for (index, shape) in scene.shape.joints.iter().enumerate() {
            let a = place(&mut tape, &bodies, scene, scene.frame(shape.a));
            let b = place(&mut tape, &bodies, scene, scene.frame(shape.b));
            let measure = constrain(&mut tape, shape.kind, &a, &b, &mut rows);
            let along = measure.1;
            forces.push(Force { measure: measure.0, along, joint: scene.joints[index], driven: index == 0 });
        }
        let one = Dd::ONE;
        let inverse = scene.bodies.iter().flat_map(|body| {
            let (mass, inertia) = (one / Dd::from(body.mass), one / Dd::from(body.inertia));
            [mass, mass, inertia]
        });
        let arms = scene.bodies.iter().flat_map(|body| &body.ports).chain(&scene.ground);
        let size = arms.fold(0.0_f64, |size, port| size.max(port[0].hypot(port[1])));
        Self {
            tape,
            rows,
            forces,
            inverse: inverse.collect(),
            load: scene.load,
            masses: scene.bodies.iter().map(|body| body.mass).collect(),
            inertias: scene.bodies.iter().map(|body| body.inertia).collect(),
            gravity: scene.gravity,
            size,
        }
    }

    /// Applied forces of order `k` at the time `t`; series are known up to order `k + 1`.
    pub fn applied(&self, t: Dd, k: usize, into: &mut [Dd]) {
        into.fill(Dd::ZERO);
        if k == 0 {
            for (body, mass) in self.masses.iter().enumerate() {
                into[3 * body + 1] = -(Dd::from(*mass) * Dd::from(self.gravity));
            }
        }
        for force in &self.forces {
            let (joint, driven) = (force.joint, force.driven && self.load.push != 0.0);
            if joint.stiffness == 0.0 && joint.damping == 0.0 && !driven {
                continue;
            }
            // A product with a direction needs every order of the force; orders are few, and forces fewer.
            let strength: Vec<Dd> = (0..=k).map(|order| self.strength(force, t, order)).collect();
            for (index, entry) in &force.along {
                into[*index] += match entry {
                    Entry::Constant(factor) => strength[k] * *factor,
                    Entry::Node(node) => convolved(&strength, &self.tape.series[*node], k),
                };
            }
        }
    }

    /// Of order `k` in what a joint's spring, damper and load do along its measure.
    fn strength(&self, force: &Force, t: Dd, k: usize) -> Dd {
        let (series, joint) = (&self.tape.series[force.measure], force.joint);
        let rest = if k == 0 { Dd::from(joint.rest) } else { Dd::ZERO };
        let mut sum = -(Dd::from(joint.stiffness) * (series[k] - rest));
        sum -= Dd::from(joint.damping) * series[k + 1] * Dd::from((k + 1) as f64);
        if force.driven && k < 4 {
            let load = self.load;
            let up = step(t, load.begin, load.rise)[k];
            let down = step(t, load.turn, load.fall)[k];
            sum += Dd::from(load.push) * (up - down * Dd::from(2.0));
        }
        sum
    }

    /// Derivatives of the constraints at order zero, row by row, dense.
    pub fn derivatives(&self) -> Vec<Vec<(usize, Dd)>> {
        let value = |entry: &Entry| match entry {
            Entry::Constant(value) => *value,
            Entry::Node(node) => self.tape.series[*node][0],
        };
        let rows = self.rows.iter();
        rows.map(|row| row.entries.iter().map(|(index, entry)| (*index, value(entry))).collect()).collect()
    }

    /// Kinetic energy and that of gravity, J.
    pub fn energy(&self, q: &[Dd], v: &[Dd]) -> [Dd; 2] {
        let (mut kinetic, mut gravity) = (Dd::ZERO, Dd::ZERO);
        for (body, (mass, inertia)) in self.masses.iter().zip(&self.inertias).enumerate() {
            let [vx, vy, omega] = [0, 1, 2].map(|k| v[3 * body + k]);
            let twice = Dd::from(*mass) * (vx * vx + vy * vy) + Dd::from(*inertia) * omega * omega;
            kinetic += twice * Dd::from(0.5);
            gravity += Dd::from(*mass) * Dd::from(self.gravity) * q[3 * body + 1];
        }
        [kinetic, gravity]
    }

    /// Energy of the joints' springs, J; order zero of the tape is at the pose.
    pub fn spring_energy(&self) -> Dd {
        self.forces.iter().fold(Dd::ZERO, |sum, force| {
            let stretch = self.tape.series[force.measure][0] - Dd::from(force.joint.rest);
            sum + Dd::from(0.5 * force.joint.stiffness) * stretch * stretch
        })
    }

    /// The next time after `t` at which the load is not analytic.
    pub fn next_knot(&self, t: f64, end: f64) -> f64 {
        let knots = self.load.knots().into_iter().filter(|knot| self.load.push != 0.0 && *knot > t);
        knots.fold(end, f64::min)
    }
}

/// Coefficients at `t` of the step 3u^2 - 2u^3, u = (t - begin)/rise.
fn step(t: Dd, begin: f64, rise: f64) -> [Dd; 4] {
    let slope = Dd::ONE / Dd::from(rise);
    let u = (t - Dd::from(begin)) * slope;
    if t.hi < begin {
        return [Dd::ZERO; 4];
    }
    if t.hi >= begin + rise {
        return [Dd::ONE, Dd::ZERO, Dd::ZERO, Dd::ZERO];
    }
    let [two, three, six] = [2.0, 3.0, 6.0].map(Dd::from);
    [
        u * u * (three - two * u),
        six * u * (Dd::ONE - u) * slope,
        (three - six * u) * slope * slope,
        -two * slope * slope * slope,
    ]
}

fn place(tape: &mut Tape, bodies: &[[Id; 5]], scene: &Scene, frame: Frame) -> Placed {
    let [px, py, turn] = scene.port(frame).map(Dd::from);
    let px = px + Dd::from(scene.rest(frame));
    let (zero, one) = (Dd::ZERO, Dd::ONE);
    let (sine, cosine) = turn.sin_cos();
    let Some(body) = frame.0 else {
        let place = [tape.linear(px, &[]), tape.linear(py, &[])];
        let arm = [tape.linear(zero, &[]), tape.linear(zero, &[])];
        let axis = [tape.linear(cosine, &[]), tape.linear(sine, &[])];
        return Placed { body: None, arm, place, axis, angle: tape.linear(turn, &[]) };
    };
    let [x, y, angle, s, c] = bodies[body];
    let arm = [tape.linear(zero, &[(c, px), (s, -py)]), tape.linear(zero, &[(s, px), (c, py)])];
    let place =
        [tape.linear(zero, &[(x, one), (arm[0], one)]), tape.linear(zero, &[(y, one), (arm[1], one)])];
    let axis = [tape.linear(zero, &[(c, cosine), (s, -sine)]), tape.linear(zero, &[(s, cosine), (c, sine)])];
    Placed { body: Some(body), arm, place, axis, angle: tape.linear(turn, &[(angle, one)]) }
}

/// Derivatives of something that moves with both frames: (x, y, theta) of each, where there is a body.
fn entries(a: &Placed, of_a: [Entry; 3], b: &Placed, of_b: [Entry; 3]) -> Vec<(usize, Entry)> {
    let mut all = Vec::new();
    for (frame, of) in [(a, of_a), (b, of_b)] {
        let Some(body) = frame.body else { continue };
        let some =
            of.into_iter().enumerate().filter(|(_, e)| !matches!(e, Entry::Constant(c) if *c == Dd::ZERO));
        all.extend(some.map(|(k, entry)| (3 * body + k, entry)));
    }
    all
}

/// Adds the rows of a joint; what its forces count, with the derivatives of that.
fn constrain(
    tape: &mut Tape,
    kind: Kind,
    a: &Placed,
    b: &Placed,
    rows: &mut Vec<Row>,
) -> (Id, Vec<(usize, Entry)>) {
    use Entry::{Constant, Node};
    let (zero, one) = (Dd::ZERO, Dd::ONE);
    let negative = |tape: &mut Tape, node: Id| Node(tape.linear(zero, &[(node, -one)]));
    let turn = tape.linear(zero, &[(b.angle, one), (a.angle, -one)]);
    let turns = |of_a, of_b| {
        let row = |value: Dd| [Constant(zero), Constant(zero), Constant(value)];
        entries(a, row(of_a), b, row(of_b))
    };
    let d = [0, 1].map(|k| tape.linear(zero, &[(b.place[k], one), (a.place[k], -one)]));
    if kind == Kind::Revolute {
        for k in 0..2 {
            let unit = |value: Dd| if k == 0 { [value, zero] } else { [zero, value] }.map(Constant);
            let other = 1 - k;
            let [of_a, of_b] = if k == 0 {
                [Node(a.arm[other]), negative(tape, b.arm[other])]
            } else {
                [negative(tape, a.arm[other]), Node(b.arm[other])]
            };
            let ([ax, ay], [bx, by]) = (unit(-one), unit(one));
            rows.push(Row { residual: d[k], entries: entries(a, [ax, ay, of_a], b, [bx, by, of_b]) });
        }
        return (turn, turns(-one, one));
    }
    let [ux, uy] = a.axis;
    let sum = |tape: &mut Tape, p: (Id, Id), q: (Id, Id), sign: Dd| {
        let (p, q) = (tape.product(p.0, p.1), tape.product(q.0, q.1));
        tape.linear(zero, &[(p, one), (q, sign)])
    };
    let normal = sum(tape, (d[0], uy), (d[1], ux), -one);
    let slide = sum(tape, (d[0], ux), (d[1], uy), one);
    let (down_x, down_y) = (negative(tape, ux), negative(tape, uy));
    let along = |tape: &mut Tape, arm: [Id; 2]| sum(tape, (arm[0], ux), (arm[1], uy), one);
    let (a_along, b_along) = (along(tape, a.arm), along(tape, b.arm));
    let by_a = Node(tape.linear(zero, &[(a_along, one), (slide, one)]));
    let by_b = negative(tape, b_along);
    rows.push(Row {
        residual: normal,
        entries: entries(a, [down_y, Node(ux), by_a], b, [Node(uy), down_x, by_b]),
    });
    let across = |tape: &mut Tape, arm: [Id; 2]| sum(tape, (arm[0], uy), (arm[1], ux), -one);
    let (a_across, b_across) = (across(tape, a.arm), across(tape, b.arm));
    // An arm's rate along the axis; that of the axis itself is normal to the line between the two points.
    let (by_a, by_b) = (negative(tape, a_across), Node(b_across));
    let measured = entries(a, [down_x, down_y, by_a], b, [Node(ux), Node(uy), by_b]);
    if kind == Kind::Prismatic {
        rows.push(Row { residual: turn, entries: turns(-one, one) });
    }
    (slide, measured)
}
