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

use plm_cas::{Expr, algebra};

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
) -> (Vec<Expr>, Vec<Section>) {
    let squared = |&omega: &Expr| {
        let square = omega.powi(2);
        square.named("omega_squared")
    };
    let squares = motion.omega.iter().map(squared).collect();
    let mut work = Elimination { model, coordinates, motion, squares, trace: Vec::new() };
    let zero = Expr::ZERO;
    let [x, y] = model.gravity.components().map(|gravity| -gravity);
    let mut answers: Vec<Answer> =
        (0..model.bodies.len()).map(|body| work.alone(body, force[body])).collect();
    let mut held = Vec::new();
    for hold in coordinates.order.iter().rev() {
        let link = work.link(hold);
        let whole = answers[hold.body];
        let (left, eliminated) = work.eliminate(whole, &link);
        if let Some(parent) = hold.parent {
            let carried = work.carry(whole, left, &link, &eliminated);
            answers[parent] = sum(answers[parent], carried);
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
    trace: Vec<Expr>,
}

impl Elimination<'_> {
    /// A body by itself.
    fn alone(&mut self, body: usize, [fx, fy, torque]: Triple) -> Answer {
        let Model { bodies, .. } = self.model;
        let (mass, class) = (bodies[body].mass, self.coordinates.headings[body].class);
        let arm = self.reference(body);
        let squared = plane::dot(arm, arm);
        let arm = self.motion.turned(class, arm);
        let to_centre = plane::negated(arm);
        let across = plane::left(to_centre);
        let [hx, hy] = plane::scale(mass, across);
        let steiner = mass * squared;
        let inertia = bodies[body].inertia + steiner;
        let inward = mass * self.squares[class];
        let [cx, cy] = plane::scale(inward, to_centre);
        let moment = plane::cross(to_centre, [fx, fy]);
        let against = [cx + fx, cy + fy, torque + moment];
        let zero = Expr::ZERO;
        Answer {
            inertia: [[mass, zero, hx], [zero, mass, hy], [hx, hy, inertia]],
            force: against.map(|component| -component),
        }
    }

    /// From G of a body to its reference point, in the axes of its class.
    fn reference(&mut self, body: usize) -> Vec2 {
        let joint = self.coordinates.order.iter().find(|hold| hold.body == body).and_then(|hold| hold.joint);
        let Some(joint) = joint else { return [Expr::ZERO; 2] };
        let joint = self.coordinates.joints[joint];
        let own = if joint.b.body == Some(body) { joint.b } else { joint.a };
        self.coordinates.arm(self.model, own).1
    }

    fn link(&mut self, hold: &Hold) -> Link {
        let Some(joint) = hold.joint else { return self.free(hold.body) };
        let (zero, one) = (Expr::ZERO, Expr::ONE);
        let joint = self.coordinates.joints[joint];
        let near = if joint.b.body == Some(hold.body) { joint.a } else { joint.b };
        let (parent, mut arm) = self.coordinates.arm(self.model, near);
        if let Some(body) = hold.parent {
            let start = self.reference(body);
            arm = [0, 1].map(|i| arm[i] - start[i]);
        }
        let arm = self.motion.turned(parent, arm);
        // With a name the lengths in it are multiplied once, not wherever the arm is used.
        let arm = [0, 1].map(|i| self.define(["arm_x", "arm_y"][i], arm[i]));
        let lever = plane::left(arm);
        let mut link =
            Link { lever, bias: self.inward(parent, arm), turns_along: true, freedoms: Vec::new() };
        if parent == 0 {
            // A port of the ground may move with the time.
            let speed = arm.map(|component| component.diff(self.model.time));
            let moved = speed.map(|component| component.diff(self.model.time));
            link.bias = plane::add(link.bias, moved);
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
        let (zero, one) = (Expr::ZERO, Expr::ONE);
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
        let (class, axis) = self.coordinates.axis(self.model, joint.a);
        let Self { motion, .. } = self;
        let mut along = motion.turned(class, axis);
        if !on_parent {
            along = plane::negated(along);
        }
        let way = plane::scale(motion.value[slide], along);
        let across = plane::left(way);
        match link.freedoms.first_mut() {
            Some((_, spin)) if !on_parent => (spin[0], spin[1]) = (across[0], across[1]),
            _ => link.lever = plane::add(link.lever, across),
        }
        // Coriolis: 2 omega s'.
        let turning = motion.omega[class] * motion.rate[slide];
        let twice = turning + turning;
        let sideways = plane::left(along);
        let coriolis = plane::scale(twice, sideways);
        link.bias = plane::add(link.bias, coriolis);
        link.freedoms.push((slide, [along[0], along[1], Expr::ZERO]));
        let inward = self.inward(class, way);
        link.bias = plane::add(link.bias, inward);
    }

    /// `-omega^2 arm`.
    fn inward(&mut self, class: usize, arm: Vec2) -> Vec2 {
        let factor = -self.squares[class];
        plane::scale(factor, arm)
    }

    /// Removes the freedoms of a joint, one after the other.
    fn eliminate(&mut self, mut answer: Answer, link: &Link) -> (Answer, Vec<Eliminated>) {
        let mut eliminated = Vec::new();
        for &(unknown, freedom) in &link.freedoms {
            let answered = answer.inertia.map(|row| dot(row, freedom));
            let named = ["x", "y", "a"];
            let answered = [0, 1, 2].map(|i| self.define(&format!("u_{unknown}{}", named[i]), answered[i]));
            let pivot = dot(freedom, answered);
            let one = Expr::ONE;
            let reciprocal = one / pivot;
            let reciprocal = self.define(&format!("r_{unknown}"), reciprocal);
            let gain = [0, 1, 2].map(|i| {
                let gain = answered[i] * reciprocal;
                self.define(&format!("g_{unknown}{}", named[i]), gain)
            });
            let pushed = dot(freedom, answer.force);
            let pushed = self.define(&format!("n_{unknown}"), pushed);
            let rest = pushed * reciprocal;
            for i in 0..3 {
                for j in 0..=i {
                    let less = gain[i] * answered[j];
                    let left = answer.inertia[i][j] - less;
                    (answer.inertia[i][j], answer.inertia[j][i]) = (left, left);
                }
                let less = gain[i] * pushed;
                answer.force[i] -= less;
            }
            clear(&mut answer, freedom);
            eliminated.push(Eliminated { unknown, freedom, answered, gain, reciprocal, rest });
        }
        (answer, eliminated)
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
        let (zero, one) = (Expr::ZERO, Expr::ONE);
        if !link.turns_along {
            // The third row waits for an angular acceleration that the parent does not give.
            clear(&mut whole, [zero, zero, one]);
            clear(&mut left, [zero, zero, one]);
        }
        let [[xx, xy, _], [_, yy, _], _] = left.inertia;
        let (across, about) = self.levered(whole, left, link, eliminated);
        let [bx, by] = link.bias;
        let mut force = left.force;
        for (i, component) in force.iter_mut().enumerate() {
            let by_bias = dot(left.inertia[i], [bx, by, zero]);
            *component += by_bias;
            *component = self.define(["p_x", "p_y", "p_a"][i], *component);
        }
        let [lx, ly] = link.lever;
        Answer {
            inertia: [[xx, xy, across[0]], [xy, yy, across[1]], [across[0], across[1], about]],
            force: [force[0], force[1], dot(force, [lx, ly, one])],
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
        let lever = [link.lever[0], link.lever[1], Expr::ONE];
        let revolute = match eliminated {
            [one] if !link.turns_along => Some(one),
            _ => None,
        };
        let inertia = if revolute.is_some() { whole.inertia } else { left.inertia };
        let mut across = inertia.map(|row| dot(row, lever));
        let mut about = dot(across, lever);
        if let Some(&Eliminated { answered: [ux, uy, _], gain, reciprocal, .. }) = revolute {
            let part = plane::dot([ux, uy], link.lever);
            let part = self.define("c", part);
            let square = part.powi(2);
            let square = self.define("c_squared", square);
            let less = square * reciprocal;
            about = self.define("w_a", about);
            about -= less;
            for i in 0..2 {
                let less = gain[i] * part;
                across[i] -= less;
            }
        }
        let across = [0, 1, 2].map(|i| self.define(["w_x", "w_y", "w_a"][i], across[i]));
        (across, about)
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
        let carried = plane::scale(alpha, link.lever);
        let carried = plane::add(carried, link.bias);
        let [x, y] = plane::add([ax, ay], carried);
        let spin = if link.turns_along { alpha } else { Expr::ZERO };
        let mut reached = [x, y, spin];
        for Eliminated { unknown, freedom, gain, rest, .. } in eliminated.iter().rev() {
            reached = [0, 1, 2].map(|i| self.define(["a_x", "a_y", "alpha"][i], reached[i]));
            let answered = dot(*gain, reached);
            let sum = answered + *rest;
            let value = -sum;
            let value = self.define(&format!("{}_acceleration", self.motion.names[*unknown]), value);
            accelerations[*unknown] = value;
            for i in 0..3 {
                let moved = freedom[i] * value;
                reached[i] += moved;
            }
        }
        reached
    }

    fn define(&mut self, name: &str, value: Expr) -> Expr {
        let atom = value.named(name);
        self.trace.push(atom);
        atom
    }
}

/// Along a freedom that is an axis nothing is left; rounding would leave something.
fn clear(answer: &mut Answer, freedom: Triple) {
    let zero = Expr::ZERO;
    let along: Vec<usize> = (0..3).filter(|&i| freedom[i] != zero).collect();
    if let [i] = along[..] {
        answer.force[i] = zero;
        for j in 0..3 {
            (answer.inertia[i][j], answer.inertia[j][i]) = (zero, zero);
        }
    }
}

fn sum(a: Answer, b: Answer) -> Answer {
    let mut sum = a;
    for i in 0..3 {
        for j in 0..3 {
            sum.inertia[i][j] = a.inertia[i][j] + b.inertia[i][j];
        }
        sum.force[i] = a.force[i] + b.force[i];
    }
    sum
}

fn dot(a: Triple, b: Triple) -> Expr {
    let products = [0, 1, 2].map(|i| a[i] * b[i]);
    algebra::sum(&products)
}
