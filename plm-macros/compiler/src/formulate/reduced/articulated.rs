//! Accelerations of a tree by elimination from its tips to the ground, in work that grows with the number of bodies.
//!
//! Method: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 7 (articulated bodies), in absolute axes and
//! absolute angles. A body with all that hangs on it answers the acceleration `x = (a_x, a_y, alpha)` of its reference
//! point, the port by which it is held, with the wrench `I x + p` that its joint has to pass on. A freedom s of the joint
//! passes on nothing, `s . (I x + p) = 0`, which gives its acceleration and removes it:
//!
//! ```text
//! x = x_0 + s y,   g = I s / (s . I s),   y = -(g . x_0 + s . p / (s . I s))
//! I <- I - g (I s)^T,   p <- p - g (s . p)
//! ```
//!
//! What is left, carried to the reference point of the parent, adds to the parent's own. Absolute angles leave no Coriolis
//! terms in a revolute; gravity is an acceleration of the ground against it.

use plm_cas::{Expr, Graph};

use super::super::function::Section;
use super::coordinates::{Coordinates, Hold, Joint, Unknown};
use super::motion::Motion;
use super::plane::{self, Vec2};
use crate::model::Model;

/// Along x, along y, about z.
type Triple = [Expr; 3];

/// `I x + p`.
#[derive(Clone, Copy)]
struct Answer {
    inertia: [Triple; 3],
    force: Triple,
}

/// How a body is held: `x_0 = (a + alpha lever + bias, alpha or 0)` of the parent's `a` and `alpha`, and freedoms.
struct Link {
    lever: Vec2,
    bias: Vec2,
    /// Does the body turn with its parent?
    turns_along: bool,
    /// Unknowns, and how they move the body.
    freedoms: Vec<(usize, Triple)>,
}

/// What the way back needs of a freedom that was eliminated.
struct Eliminated {
    unknown: usize,
    freedom: Triple,
    /// `I s` and `I s / (s . I s)`.
    answered: Triple,
    gain: Triple,
    /// `1 / (s . I s)`.
    reciprocal: Expr,
    /// `s . p / (s . I s)`.
    rest: Expr,
}

/// Second derivatives of the unknowns of a tree, and how a person would write that down; `force` are the applied forces
/// at each G in absolute axes, without gravity.
pub(crate) fn accelerations(
    model: &Model,
    coordinates: &Coordinates,
    motion: &Motion,
    force: &[Triple],
    graph: &mut Graph,
) -> (Vec<Expr>, Vec<Section>) {
    let squared = |&omega: &Expr| {
        let square = graph.powi(omega, 2);
        graph.define("omega_squared", square)
    };
    let squares = motion.omega.iter().map(squared).collect();
    let mut work = Elimination { model, coordinates, motion, squares, graph, trace: Vec::new() };
    let zero = work.graph.zero();
    let [x, y] = model.gravity.map(|gravity| work.graph.neg(gravity));
    let mut answers: Vec<Answer> =
        (0..model.bodies.len()).map(|body| work.alone(body, force[body])).collect();
    let mut held = Vec::new();
    for hold in coordinates.order.iter().rev() {
        let link = work.link(hold);
        let whole = answers[hold.body];
        let (left, eliminated) = work.eliminate(whole, &link);
        if let Some(parent) = hold.parent {
            let carried = work.carry(whole, left, &link, &eliminated);
            answers[parent] = work.sum(answers[parent], carried);
        }
        held.push((hold, link, eliminated));
    }
    let inward =
        Section::new("From the tips inwards: what each body asks of its joint", work.trace.split_off(0));
    let mut accelerations = vec![zero; coordinates.unknowns.len()];
    let mut reached = vec![[zero; 3]; model.bodies.len()];
    for (hold, link, eliminated) in held.iter().rev() {
        let parent = hold.parent.map_or([x, y, zero], |parent| reached[parent]);
        reached[hold.body] = work.follow(parent, link, eliminated, &mut accelerations);
    }
    (accelerations, vec![inward, Section::new("From the ground outwards: accelerations", work.trace)])
}

/// The equations while they are being set up and eliminated.
struct Elimination<'a> {
    model: &'a Model,
    coordinates: &'a Coordinates,
    motion: &'a Motion,
    /// Squares of the angular velocities of the classes.
    squares: Vec<Expr>,
    graph: &'a mut Graph,
    trace: Vec<Expr>,
}

impl Elimination<'_> {
    /// A body by itself.
    fn alone(&mut self, body: usize, [fx, fy, torque]: Triple) -> Answer {
        let Model { bodies, .. } = self.model;
        let (mass, class) = (bodies[body].mass, self.coordinates.headings[body].class);
        let arm = self.reference(body);
        let squared = plane::dot(self.graph, arm, arm);
        let arm = self.motion.turned(self.graph, class, arm);
        let graph = &mut *self.graph;
        let to_centre = plane::negated(graph, arm);
        let across = plane::left(graph, to_centre);
        let [hx, hy] = plane::scale(graph, mass, across);
        let steiner = graph.mul(mass, squared);
        let inertia = graph.add(bodies[body].inertia, steiner);
        let inward = graph.mul(mass, self.squares[class]);
        let [cx, cy] = plane::scale(graph, inward, to_centre);
        let moment = plane::cross(graph, to_centre, [fx, fy]);
        let against = [graph.add(cx, fx), graph.add(cy, fy), graph.add(torque, moment)];
        let zero = graph.zero();
        Answer {
            inertia: [[mass, zero, hx], [zero, mass, hy], [hx, hy, inertia]],
            force: against.map(|component| graph.neg(component)),
        }
    }

    /// From G of a body to its reference point, in the axes of its class.
    fn reference(&mut self, body: usize) -> Vec2 {
        let joint = self.coordinates.order.iter().find(|hold| hold.body == body).and_then(|hold| hold.joint);
        let Some(joint) = joint else { return [self.graph.zero(); 2] };
        let joint = self.coordinates.joints[joint];
        let own = if joint.b.body == Some(body) { joint.b } else { joint.a };
        self.coordinates.arm(self.model, self.graph, own).1
    }

    fn link(&mut self, hold: &Hold) -> Link {
        let Some(joint) = hold.joint else { return self.free(hold.body) };
        let (zero, one) = (self.graph.zero(), self.graph.one());
        let joint = self.coordinates.joints[joint];
        let near = if joint.b.body == Some(hold.body) { joint.a } else { joint.b };
        let (parent, mut arm) = self.coordinates.arm(self.model, self.graph, near);
        if let Some(body) = hold.parent {
            let start = self.reference(body);
            arm = [0, 1].map(|i| self.graph.sub(arm[i], start[i]));
        }
        let arm = self.motion.turned(self.graph, parent, arm);
        // With a name the lengths in it are multiplied once, not wherever the arm is used.
        let arm = [0, 1].map(|i| self.define(["arm_x", "arm_y"][i], arm[i]));
        let lever = plane::left(self.graph, arm);
        let mut link =
            Link { lever, bias: self.inward(parent, arm), turns_along: true, freedoms: Vec::new() };
        if parent == 0 {
            // A port of the ground may move with the time.
            let speed = arm.map(|component| self.graph.diff(component, self.model.time));
            let moved = speed.map(|component| self.graph.diff(component, self.model.time));
            link.bias = plane::add(self.graph, link.bias, moved);
        }
        let class = self.coordinates.headings[hold.body].class;
        if let (Some(angle), true) = (self.coordinates.angle_of_class[class], class != parent) {
            link.turns_along = false;
            link.freedoms.push((angle, [zero, zero, one]));
        }
        if let Some(slide) = joint.slide {
            self.slide(&mut link, &joint, slide, near == joint.a);
        }
        link
    }

    /// A body that hangs on nothing.
    fn free(&mut self, body: usize) -> Link {
        let (zero, one) = (self.graph.zero(), self.graph.one());
        let moves = |&unknown: &Unknown| match unknown {
            Unknown::Centre { body: other, axis: 0 } if other == body => Some([one, zero, zero]),
            Unknown::Centre { body: other, .. } if other == body => Some([zero, one, zero]),
            Unknown::Angle { body: other, .. } if other == body => Some([zero, zero, one]),
            _ => None,
        };
        let unknowns = self.coordinates.unknowns.iter().enumerate();
        let freedoms = unknowns.filter_map(|(k, unknown)| Some((k, moves(unknown)?))).collect();
        Link { lever: [zero; 2], bias: [zero; 2], turns_along: false, freedoms }
    }

    /// Adds the displacement along the x axis of the port `a`, which the parent carries or the body itself.
    fn slide(&mut self, link: &mut Link, joint: &Joint, slide: usize, on_parent: bool) {
        let (class, axis) = self.coordinates.axis(self.model, self.graph, joint.a);
        let Self { motion, graph, .. } = self;
        let mut along = motion.turned(graph, class, axis);
        if !on_parent {
            along = plane::negated(graph, along);
        }
        let way = plane::scale(graph, motion.value[slide], along);
        let across = plane::left(graph, way);
        match link.freedoms.first_mut() {
            Some((_, spin)) if !on_parent => (spin[0], spin[1]) = (across[0], across[1]),
            _ => link.lever = plane::add(graph, link.lever, across),
        }
        // Coriolis: 2 omega s'.
        let turning = graph.mul(motion.omega[class], motion.rate[slide]);
        let twice = graph.add(turning, turning);
        let sideways = plane::left(graph, along);
        let coriolis = plane::scale(graph, twice, sideways);
        link.bias = plane::add(graph, link.bias, coriolis);
        link.freedoms.push((slide, [along[0], along[1], graph.zero()]));
        let inward = self.inward(class, way);
        link.bias = plane::add(self.graph, link.bias, inward);
    }

    /// `-omega^2 arm`.
    fn inward(&mut self, class: usize, arm: Vec2) -> Vec2 {
        let factor = self.graph.neg(self.squares[class]);
        plane::scale(self.graph, factor, arm)
    }

    /// Removes the freedoms of a joint, one after the other.
    fn eliminate(&mut self, mut answer: Answer, link: &Link) -> (Answer, Vec<Eliminated>) {
        let mut eliminated = Vec::new();
        for &(unknown, freedom) in &link.freedoms {
            let answered = answer.inertia.map(|row| self.dot(row, freedom));
            let named = ["x", "y", "a"];
            let answered = [0, 1, 2].map(|i| self.define(&format!("u_{unknown}{}", named[i]), answered[i]));
            let pivot = self.dot(freedom, answered);
            let one = self.graph.one();
            let reciprocal = self.graph.div(one, pivot);
            let reciprocal = self.define(&format!("r_{unknown}"), reciprocal);
            let gain = [0, 1, 2].map(|i| {
                let gain = self.graph.mul(answered[i], reciprocal);
                self.define(&format!("g_{unknown}{}", named[i]), gain)
            });
            let pushed = self.dot(freedom, answer.force);
            let pushed = self.define(&format!("n_{unknown}"), pushed);
            let rest = self.graph.mul(pushed, reciprocal);
            for i in 0..3 {
                for j in 0..=i {
                    let less = self.graph.mul(gain[i], answered[j]);
                    let left = self.graph.sub(answer.inertia[i][j], less);
                    (answer.inertia[i][j], answer.inertia[j][i]) = (left, left);
                }
                let less = self.graph.mul(gain[i], pushed);
                answer.force[i] = self.graph.sub(answer.force[i], less);
            }
            self.clear(&mut answer, freedom);
            eliminated.push(Eliminated { unknown, freedom, answered, gain, reciprocal, rest });
        }
        (answer, eliminated)
    }

    /// Along a freedom that is an axis nothing is left; rounding would leave something.
    fn clear(&mut self, answer: &mut Answer, freedom: Triple) {
        let zero = self.graph.zero();
        let along: Vec<usize> = (0..3).filter(|&i| freedom[i] != zero).collect();
        if let [i] = along[..] {
            answer.force[i] = zero;
            for j in 0..3 {
                (answer.inertia[i][j], answer.inertia[j][i]) = (zero, zero);
            }
        }
    }

    /// What a body asks of its joint, as a wrench at the reference point of its parent; `whole` is its answer before
    /// elimination.
    fn carry(
        &mut self,
        mut whole: Answer,
        mut left: Answer,
        link: &Link,
        eliminated: &[Eliminated],
    ) -> Answer {
        let (zero, one) = (self.graph.zero(), self.graph.one());
        if !link.turns_along {
            // The third row waits for an angular acceleration that the parent does not give.
            self.clear(&mut whole, [zero, zero, one]);
            self.clear(&mut left, [zero, zero, one]);
        }
        let [[xx, xy, _], [_, yy, _], _] = left.inertia;
        let (across, about) = self.levered(whole, left, link, eliminated);
        let [bx, by] = link.bias;
        let mut force = left.force;
        for (i, component) in force.iter_mut().enumerate() {
            let by_bias = self.dot(left.inertia[i], [bx, by, zero]);
            *component = self.graph.add(*component, by_bias);
            *component = self.define(["p_x", "p_y", "p_a"][i], *component);
        }
        let [lx, ly] = link.lever;
        Answer {
            inertia: [[xx, xy, across[0]], [xy, yy, across[1]], [across[0], across[1], about]],
            force: [force[0], force[1], self.dot(force, [lx, ly, one])],
        }
    }

    /// `w = I l` and `l . w` of the lever `l`, for what elimination left of I.
    ///
    /// Of a revolute, `I_0 l - g (u . l)` and `l . I_0 l - (u . l)^2 / (s . I s)`: more operations, but the next division
    /// waits for this one and two operations, not for seven (chain of 64: 4280 ns a step or 5060).
    fn levered(
        &mut self,
        whole: Answer,
        left: Answer,
        link: &Link,
        eliminated: &[Eliminated],
    ) -> (Triple, Expr) {
        let lever = [link.lever[0], link.lever[1], self.graph.one()];
        let revolute = match eliminated {
            [one] if !link.turns_along => Some(one),
            _ => None,
        };
        let inertia = if revolute.is_some() { whole.inertia } else { left.inertia };
        let mut across = inertia.map(|row| self.dot(row, lever));
        let mut about = self.dot(across, lever);
        if let Some(&Eliminated { answered: [ux, uy, _], gain, reciprocal, .. }) = revolute {
            let part = plane::dot(self.graph, [ux, uy], link.lever);
            let part = self.define("c", part);
            let square = self.graph.powi(part, 2);
            let square = self.define("c_squared", square);
            let less = self.graph.mul(square, reciprocal);
            about = self.define("w_a", about);
            about = self.graph.sub(about, less);
            for i in 0..2 {
                let less = self.graph.mul(gain[i], part);
                across[i] = self.graph.sub(across[i], less);
            }
        }
        let across = [0, 1, 2].map(|i| self.define(["w_x", "w_y", "w_a"][i], across[i]));
        (across, about)
    }

    fn sum(&mut self, a: Answer, b: Answer) -> Answer {
        let graph = &mut *self.graph;
        let mut sum = a;
        for i in 0..3 {
            for j in 0..3 {
                sum.inertia[i][j] = graph.add(a.inertia[i][j], b.inertia[i][j]);
            }
            sum.force[i] = graph.add(a.force[i], b.force[i]);
        }
        sum
    }

    /// The acceleration of a body's reference point, and of the freedoms that were eliminated there.
    fn follow(
        &mut self,
        parent: Triple,
        link: &Link,
        eliminated: &[Eliminated],
        accelerations: &mut [Expr],
    ) -> Triple {
        let [ax, ay, alpha] = parent;
        let carried = plane::scale(self.graph, alpha, link.lever);
        let carried = plane::add(self.graph, carried, link.bias);
        let [x, y] = plane::add(self.graph, [ax, ay], carried);
        let spin = if link.turns_along { alpha } else { self.graph.zero() };
        let mut reached = [x, y, spin];
        for Eliminated { unknown, freedom, gain, rest, .. } in eliminated.iter().rev() {
            reached = [0, 1, 2].map(|i| self.define(["a_x", "a_y", "alpha"][i], reached[i]));
            let answered = self.dot(*gain, reached);
            let sum = self.graph.add(answered, *rest);
            let value = self.graph.neg(sum);
            let value = self.define(&format!("{}_acceleration", self.motion.names[*unknown]), value);
            accelerations[*unknown] = value;
            for i in 0..3 {
                let moved = self.graph.mul(freedom[i], value);
                reached[i] = self.graph.add(reached[i], moved);
            }
        }
        reached
    }

    fn define(&mut self, name: &str, value: Expr) -> Expr {
        let atom = self.graph.define(name, value);
        self.trace.push(atom);
        atom
    }

    fn dot(&mut self, a: Triple, b: Triple) -> Expr {
        let products = [0, 1, 2].map(|i| self.graph.mul(a[i], b[i]));
        self.graph.sum(&products)
    }
}
