//! Accelerations of a tree by elimination from its tips to the ground, in work that grows with the number of bodies.
//!
//! Method: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 7 (articulated bodies), in absolute axes and
//! absolute angles. A body with all that hangs on it answers the acceleration `x = (a_x, a_y, alpha)` of its reference
//! point, the port by which it is held, with the wrench `I x + p` that its joint has to pass on. A freedom s of the joint
//! passes on nothing, `s . (I x + p) = 0`, which gives its acceleration y and removes it:
//!
//! ```text
//! x = x_0 + s y,   g = I s / (s . I s),   y = -(g . x_0 + s . p / (s . I s))
//! I <- I - g (I s)^T,   p <- p - g (s . p)
//! ```
//!
//! The remainder, carried to the reference point of the parent, adds to the parent's own. Absolute angles leave no Coriolis
//! terms in a revolute; gravity is an acceleration of the ground against it.

use crate::collect::{CollectVec, MapEach, PushAll};
use plm_cas::{Expr, Vec2};

use crate::formulate::function::Section;
use crate::formulate::reduced::joints::coordinates::{Coordinates, Joint, TreeEdge, Unknown};
use crate::formulate::reduced::motion::Motion;
use crate::formulate::reduced::tree::spatial::{Inertia, Spatial};
use crate::model::Model;

/// Bodies up to which sums along the tree stay as they are: what is shared in them saves some operations.
const FEW_BODIES: usize = 64;

/// `I x + p`.
#[derive(Clone, Copy)]
struct Answer {
    inertia: Inertia,
    force: Spatial,
}

/// How a body is held: `x_0 = (a + alpha lever + bias, alpha or 0)` of the parent's `a` and `alpha`, and freedoms.
struct Link {
    lever: Vec2,
    bias: Vec2,
    /// Does the body turn with its parent?
    turns_along: bool,
    /// Unknowns, and how they move the body.
    freedoms: Vec<(usize, Spatial)>,
}

/// Values of an eliminated freedom that the way back needs.
struct Eliminated {
    unknown: usize,
    /// `s`
    freedom: Spatial,
    /// `I s`
    answered: Spatial,
    /// `g = I s / (s . I s)`
    gain: Spatial,
    /// `1 / (s . I s)`
    reciprocal: Expr,
    /// `s . p / (s . I s)`
    rest: Expr,
}

/// Second derivatives of the unknowns of a tree, and how a person would write that down; `force` are the applied forces
/// at each G in absolute axes, without gravity.
pub(crate) fn accelerations(
    model: &Model,
    motion: &Motion,
    force: &[[Expr; 3]],
) -> (Vec<Expr>, Vec<Section>) {
    let coordinates = motion.coordinates;
    let squares = motion.omega.iter().map(|omega| omega.squared().named("omega_squared")).collect_vec();
    let mut work = Elimination { model, coordinates, motion, squares, trace: Vec::new() };
    let against_gravity = Spatial::new(-model.gravity, Expr::ZERO);
    let bodies = 0..model.bodies.len();
    let mut answers: Vec<Answer> = bodies.map(|body| work.alone(body, Spatial(force[body]))).collect_vec();
    let mut held = Vec::new();
    for edge in coordinates.order.iter().rev() {
        let link = work.link(edge);
        let answer = answers[edge.body];
        let (left, eliminated) = work.eliminate(answer, &link);
        if let Some(parent) = edge.parent {
            let carried = work.carry(answer, left, &link, &eliminated);
            let Answer { inertia, force } = answers[parent];
            let inertia = work.summed(inertia + carried.inertia);
            answers[parent] = Answer { inertia, force: force + carried.force };
        }
        held.push((edge, link, eliminated));
    }
    let inward =
        Section::new("From the tips inwards: what each body asks of its joint", work.trace.split_off(0));
    let mut accelerations = vec![Expr::ZERO; coordinates.unknowns.len()];
    let mut reached = vec![Spatial::ZERO; model.bodies.len()];
    for (edge, link, eliminated) in held.iter().rev() {
        let parent = edge.parent.map_or(against_gravity, |parent| reached[parent]);
        reached[edge.body] = work.follow(parent, link, eliminated, &mut accelerations);
    }
    (accelerations, vec![inward, Section::new("From the ground outwards: accelerations", work.trace)])
}

/// The equations while they are being set up and eliminated.
struct Elimination<'a> {
    model: &'a Model,
    coordinates: &'a Coordinates,
    motion: &'a Motion<'a>,
    /// Squares of the angular velocities of the orientations.
    squares: Vec<Expr>,
    trace: Vec<Expr>,
}

impl Elimination<'_> {
    /// A body by itself: `m a_G - f` and `J alpha - torque`, about the reference point.
    fn alone(&mut self, body: usize, applied: Spatial) -> Answer {
        let Model { bodies, .. } = self.model;
        let (mass, orientation) = (bodies[body].mass, self.coordinates.absolute_angles[body].orientation);
        let arm = self.reference(body);
        let steiner = mass * arm.squared();
        let to_centre = -self.motion.turned(orientation, arm);
        let coupling = mass * to_centre.left();
        let inertia = Inertia::new([mass, Expr::ZERO, mass], coupling, bodies[body].inertia + steiner);
        let force = applied.plane();
        let centrifugal = (mass * self.squares[orientation]) * to_centre;
        let moment = to_centre.cross(force);
        let against = Spatial::new(centrifugal + force, applied.about() + moment);
        Answer { inertia, force: -against }
    }

    /// From G of a body to its reference point, in the axes of its orientation.
    fn reference(&self, body: usize) -> Vec2 {
        let joint = self.coordinates.order.iter().find(|edge| edge.body == body).and_then(|edge| edge.joint);
        let Some(joint) = joint else { return Vec2::ZERO };
        let joint = self.coordinates.joints[joint];
        let own = if joint.b.body == Some(body) { joint.b } else { joint.a };
        self.coordinates.arm(self.model, own).1
    }

    fn link(&mut self, edge: &TreeEdge) -> Link {
        let Some(joint) = edge.joint else { return self.free(edge.body) };
        let joint = self.coordinates.joints[joint];
        let near = if joint.b.body == Some(edge.body) { joint.a } else { joint.b };
        let (parent, mut arm) = self.coordinates.arm(self.model, near);
        if let Some(body) = edge.parent {
            arm -= self.reference(body);
        }
        // With a name the lengths in it are multiplied once, not wherever the arm is used.
        let arm = self.motion.turned(parent, arm).named("arm");
        self.trace.push_all(arm.components());
        let lever = arm.left();
        let mut link =
            Link { lever, bias: self.inward(parent, arm), turns_along: true, freedoms: Vec::new() };
        if parent == 0 {
            // A port of the ground may move with the time.
            let time = self.model.time;
            link.bias += arm.diff(time).diff(time);
        }
        let orientation = self.coordinates.absolute_angles[edge.body].orientation;
        if let (Some(angle), true) =
            (self.coordinates.angle_of_orientation[orientation], orientation != parent)
        {
            link.turns_along = false;
            link.freedoms.push((angle, Spatial::ABOUT));
        }
        if let Some(displacement) = joint.displacement {
            self.displacement(&mut link, &joint, displacement, near == joint.a);
        }
        link
    }

    /// A body that hangs on nothing.
    fn free(&mut self, body: usize) -> Link {
        let moves = |&unknown: &Unknown| match unknown {
            Unknown::Centre { body: other, axis: 0 } if other == body => {
                Some(Spatial::new(Vec2::X, Expr::ZERO))
            }
            Unknown::Centre { body: other, .. } if other == body => Some(Spatial::new(Vec2::Y, Expr::ZERO)),
            Unknown::Angle { body: other, .. } if other == body => Some(Spatial::ABOUT),
            _ => None,
        };
        let unknowns = self.coordinates.unknowns.iter().enumerate();
        let freedoms = unknowns.filter_map(|(k, unknown)| Some((k, moves(unknown)?))).collect_vec();
        Link { lever: Vec2::ZERO, bias: Vec2::ZERO, turns_along: false, freedoms }
    }

    /// Adds the displacement along the x axis of the port `a`, which the parent carries or the body itself.
    fn displacement(&mut self, link: &mut Link, joint: &Joint, displacement: usize, on_parent: bool) {
        let (orientation, axis) = self.coordinates.axis(self.model, joint.a);
        let motion = self.motion;
        let along = motion.turned(orientation, axis);
        let along = if on_parent { along } else { -along };
        let way = motion.value[displacement] * along;
        match link.freedoms.first_mut() {
            Some((_, spin)) if !on_parent => *spin = Spatial::new(way.left(), spin.about()),
            _ => link.lever += way.left(),
        }
        // Coriolis: 2 omega s'.
        let turning = motion.omega[orientation] * motion.rate[displacement];
        link.bias += (turning + turning) * along.left();
        link.freedoms.push((displacement, Spatial::new(along, Expr::ZERO)));
        link.bias += self.inward(orientation, way);
    }

    /// `-omega^2 arm`.
    fn inward(&self, orientation: usize, arm: Vec2) -> Vec2 {
        -self.squares[orientation] * arm
    }

    /// Removes the freedoms of a joint, one after the other.
    fn eliminate(&mut self, mut answer: Answer, link: &Link) -> (Answer, Vec<Eliminated>) {
        let mut eliminated = Vec::new();
        for &(unknown, freedom) in &link.freedoms {
            let answered = self.named(answer.inertia * freedom, |axis| format!("u_{unknown}{axis}"));
            let reciprocal = self.define(&format!("r_{unknown}"), 1 / freedom.dot(answered));
            let gain = self.named(reciprocal * answered, |axis| format!("g_{unknown}{axis}"));
            let pushed = self.define(&format!("n_{unknown}"), freedom.dot(answer.force));
            let rest = pushed * reciprocal;
            answer.inertia = answer.inertia.less_outer(gain, answered);
            answer.force = answer.force - pushed * gain;
            if let Some(axis) = freedom.axis() {
                answer = answer.without(axis);
            }
            eliminated.push(Eliminated { unknown, freedom, answered, gain, reciprocal, rest });
        }
        (answer, eliminated)
    }

    /// Wrench of a body on its joint, at the reference point of its parent; `answer` is its inertia and force before
    /// elimination.
    fn carry(
        &mut self,
        mut answer: Answer,
        mut left: Answer,
        link: &Link,
        eliminated: &[Eliminated],
    ) -> Answer {
        if !link.turns_along {
            // The third row waits for an angular acceleration that the parent does not give.
            (answer, left) = (answer.without(2), left.without(2));
        }
        let (across, about) = self.levered(answer, left, link, eliminated);
        let force = left.force + left.inertia * Spatial::new(link.bias, Expr::ZERO);
        let force = self.named(force, |axis| format!("p_{axis}"));
        let moment = force.dot(Spatial::new(link.lever, Expr::ONE));
        Answer {
            inertia: Inertia::new(left.inertia.plane(), across.plane(), about),
            force: Spatial::new(force.plane(), moment),
        }
    }

    /// `w = I l` and `l . w` of the lever `l`, for what elimination left of I.
    ///
    /// Of a revolute, `I_0 l - g (u . l)` and `l . I_0 l - (u . l)^2 / (s . I s)`: more operations, but the next division
    /// waits for this one and two operations, not for seven (chain of 64: 4280 ns a step or 5060).
    fn levered(
        &mut self,
        answer: Answer,
        left: Answer,
        link: &Link,
        eliminated: &[Eliminated],
    ) -> (Spatial, Expr) {
        let lever = Spatial::new(link.lever, Expr::ONE);
        let revolute = match eliminated {
            [one] if !link.turns_along => Some(one),
            _ => None,
        };
        let inertia = if revolute.is_some() { answer.inertia } else { left.inertia };
        let mut across = inertia * lever;
        let mut about = across.dot(lever);
        if let Some(&Eliminated { answered, gain, reciprocal, .. }) = revolute {
            let part = self.define("c", answered.plane().dot(link.lever));
            let square = self.define("c_squared", part.squared());
            let less = square * reciprocal;
            about = self.define("w_a", about) - less;
            across = across - Spatial::new(part * gain.plane(), Expr::ZERO);
        }
        (self.named(across, |axis| format!("w_{axis}")), about)
    }

    /// The acceleration of a body's reference point, and of the freedoms that were eliminated there.
    fn follow(
        &mut self,
        parent: Spatial,
        link: &Link,
        eliminated: &[Eliminated],
        accelerations: &mut [Expr],
    ) -> Spatial {
        let alpha = parent.about();
        let point = parent.plane() + (alpha * link.lever + link.bias);
        let mut reached = Spatial::new(point, if link.turns_along { alpha } else { Expr::ZERO });
        for Eliminated { unknown, freedom, gain, rest, .. } in eliminated.iter().rev() {
            reached = Spatial([0, 1, 2].map_each(|i| self.define(["a_x", "a_y", "alpha"][i], reached.0[i])));
            let value = -(gain.dot(reached) + *rest);
            let value = self.define(&format!("{}_acceleration", self.motion.names[*unknown]), value);
            accelerations[*unknown] = value;
            reached = reached + value * *freedom;
        }
        reached
    }

    /// Inertia of bodies with all that hangs on them. In the entries of the plane each body adds terms to those after it, which
    /// makes a row of n bodies n^2 terms to sort and to share.
    fn summed(&mut self, inertia: Inertia) -> Inertia {
        if self.model.bodies.len() <= FEW_BODIES {
            return inertia;
        }
        let plane = inertia.plane();
        inertia.with_plane([0, 1, 2].map_each(|i| self.define(["i_xx", "i_xy", "i_yy"][i], plane[i])))
    }

    fn define(&mut self, name: &str, value: Expr) -> Expr {
        let atom = value.named(name);
        self.trace.push(atom);
        atom
    }

    /// Components by the names of their axes.
    fn named(&mut self, vector: Spatial, name: impl Fn(&str) -> String) -> Spatial {
        Spatial([0, 1, 2].map_each(|i| self.define(&name(["x", "y", "a"][i]), vector.0[i])))
    }
}

impl Answer {
    /// Along a freedom that is an axis nothing is left; rounding would leave something.
    fn without(self, axis: usize) -> Answer {
        let mut force = self.force;
        force.0[axis] = Expr::ZERO;
        Answer { inertia: self.inertia.without(axis), force }
    }
}
