//! Reactions of a tree: accelerations from the ground outwards, then, from the tips inwards, what each joint passes on.
//!
//! Once the accelerations are known, the three equations of a body, `phi_q^T lambda = Q - M a`, hold no unknowns but the
//! multipliers of what holds it, those further out being known (J. Y. S. Luh, M. W. Walker, R. P. C. Paul, J. Dyn. Syst.
//! Meas. Control 102, 1980: the recursive Newton-Euler method). So every joint costs a system of at most three rows.

use plm_cas::{Expr, Graph};

use super::super::function::{Function, Section};
use super::coordinates::{Joint, Unknown};
use super::motion::Motion;
use super::plane::{self, Vec2};
use super::{Layout, stored};
use crate::derive::SparseRow;

/// Along x, along y, about z.
type Triple = [Expr; 3];

impl Layout<'_> {
    /// `a` of all bodies and `lambda` of all rows, where `rate` gives the accelerations of the coordinates; nothing if some
    /// body is held by more than its own equations can tell apart.
    pub(super) fn reactions(&mut self, motion: &Motion, rate: &Function) -> Option<Function> {
        let (n, bodies) = (motion.drivers.len(), self.model.bodies.len());
        let of_drivers: Vec<Expr> = rate.results.iter().skip(n).take(n).map(|&(_, value)| value).collect();
        let second = self.second_derivatives(motion, &of_drivers);
        let acceleration = self.accelerations(motion, &second);
        let a: Vec<Expr> = acceleration.iter().flatten().copied().collect();
        let phi_q = self.jacobian(motion);
        let force = self.graph.substitute(&self.equations.force, &motion.substitution);
        let mut left: Vec<Vec<Expr>> = Vec::with_capacity(3 * bodies);
        for ((&force, &mass), &a) in force.iter().zip(&self.equations.mass).zip(&a) {
            let inertial = self.graph.mul(mass, a);
            left.push(vec![force, self.graph.neg(inertial)]);
        }
        let (lambda, trace) = self.multipliers(&phi_q, left)?;
        let mut sections = rate.sections.clone();
        sections.push(Section::new("Accelerations of the bodies, from the ground outwards", a.clone()));
        sections.push(Section::new("From the tips inwards: phi_q^T lambda = Q - M a", trace));
        let mut results = stored("a", a.iter());
        results.extend(stored("lambda", lambda.iter()));
        Some(Function { sections, results }.optimise(self.graph))
    }

    /// `lambda`, and the order of its solution; `left` are the sums of the terms of `Q - M a`.
    fn multipliers(
        &mut self,
        phi_q: &[SparseRow],
        mut left: Vec<Vec<Expr>>,
    ) -> Option<(Vec<Expr>, Vec<Expr>)> {
        let (mut lambda, mut trace) = (vec![None; phi_q.len()], Vec::new());
        for hold in self.coordinates.order.iter().rev() {
            let body = hold.body;
            let rows = (0..phi_q.len()).filter(|&row| lambda[row].is_none());
            let holding = rows.map(|row| (row, column(&phi_q[row], body, self.graph)));
            let holding: Vec<(usize, Triple)> = holding
                .filter(|(_, column)| column.iter().any(|&entry| !self.graph.is_zero(entry)))
                .collect();
            if holding.is_empty() {
                continue;
            }
            let asked = [0, 1, 2].map(|axis| {
                let sum = self.graph.sum(&left[3 * body + axis]);
                let name =
                    format!("{}.left_{}", self.model.bodies[body].name.text, ["x", "y", "angle"][axis]);
                self.graph.define(&name, sum)
            });
            let columns: Vec<Triple> = holding.iter().map(|held| held.1).collect();
            let is_pair =
                |&(row, _): &(usize, Triple)| self.model.parts[self.model.rows[row].part].pair.is_some();
            let solution = solve(&columns, asked, holding.iter().all(is_pair), self.graph)?;
            for (&(row, _), value) in holding.iter().zip(solution) {
                let name = format!("lambda_{}", self.model.rows[row].name);
                let value = self.graph.define(&name, value);
                trace.push(value);
                lambda[row] = Some(value);
                for &(column, entry) in phi_q[row].iter().filter(|(column, _)| column / 3 != body) {
                    let passed = self.graph.mul(entry, value);
                    left[column].push(self.graph.neg(passed));
                }
            }
        }
        Some((lambda.into_iter().collect::<Option<_>>()?, trace))
    }

    /// Second derivatives of all unknowns from those of the coordinates.
    fn second_derivatives(&mut self, motion: &Motion, of_drivers: &[Expr]) -> Vec<Expr> {
        // With a pace, what the velocities ask for is over its square.
        let square = motion.pace.map_or(self.graph.one(), |pace| self.graph.powi(pace, 2));
        let gains = motion.gain.iter().zip(&motion.bias);
        let values = gains.map(|(gains, &bias)| {
            let mut terms = vec![self.graph.mul(square, bias)];
            let zero = self.graph.zero();
            let moving = gains.iter().zip(of_drivers).filter(|(gain, _)| **gain != zero);
            terms.extend(moving.map(|(&gain, &value)| self.graph.mul(gain, value)));
            self.graph.sum(&terms)
        });
        values.collect()
    }

    /// Accelerations of G and of the angle of every body.
    fn accelerations(&mut self, motion: &Motion, second: &[Expr]) -> Vec<Triple> {
        let Layout { model, coordinates, .. } = *self;
        let zero = self.graph.zero();
        let mut reached = vec![[zero; 3]; model.bodies.len()];
        for hold in &coordinates.order {
            let body = hold.body;
            let centre =
                |axis| coordinates.unknowns.iter().position(|&u| u == Unknown::Centre { body, axis });
            let from = hold.parent.map_or([zero; 2], |parent| [reached[parent][0], reached[parent][1]]);
            let [x, y] = match hold.joint.map(|joint| coordinates.joints[joint]) {
                None => [0, 1].map(|axis| centre(axis).map_or(zero, |unknown| second[unknown])),
                Some(joint) => {
                    let mut across = self.across(motion, second, &joint);
                    if joint.b.body != Some(body) {
                        across = plane::negated(self.graph, across);
                    }
                    plane::add(self.graph, from, across)
                }
            };
            let name = &model.bodies[body].name.text;
            let x = self.graph.define(&format!("{name}.ax"), x);
            let y = self.graph.define(&format!("{name}.ay"), y);
            let class = coordinates.headings[body].class;
            reached[body] = [x, y, self.alpha(second, class)];
        }
        reached
    }

    /// How much more G of the body of `b` accelerates than G of the body of `a`.
    fn across(&mut self, motion: &Motion, second: &[Expr], joint: &Joint) -> Vec2 {
        let Layout { model, coordinates, .. } = *self;
        let (near, start) = coordinates.arm(model, self.graph, joint.a);
        let (far, back) = coordinates.arm(model, self.graph, joint.b);
        let mut out = start;
        let mut sum = self.drifting(near, start);
        if let Some(slide) = joint.slide {
            let (_, axis) = coordinates.axis(model, self.graph, joint.a);
            let way = plane::scale(self.graph, motion.value[slide], axis);
            out = plane::add(self.graph, out, way);
            let along = motion.turned(self.graph, near, axis);
            let speeding = plane::scale(self.graph, second[slide], along);
            sum = plane::add(self.graph, sum, speeding);
            // Coriolis: 2 omega s'.
            let turning = self.graph.mul(motion.omega[near], motion.rate[slide]);
            let twice = self.graph.add(turning, turning);
            let sideways = plane::left(self.graph, along);
            let coriolis = plane::scale(self.graph, twice, sideways);
            sum = plane::add(self.graph, sum, coriolis);
        }
        let there = self.turning(motion, second, near, out);
        sum = plane::add(self.graph, sum, there);
        for beyond in [self.drifting(far, back), self.turning(motion, second, far, back)] {
            let beyond = plane::negated(self.graph, beyond);
            sum = plane::add(self.graph, sum, beyond);
        }
        sum
    }

    /// `alpha x arm - omega^2 arm` of an arm in the axes of its class.
    fn turning(&mut self, motion: &Motion, second: &[Expr], class: usize, arm: Vec2) -> Vec2 {
        let alpha = self.alpha(second, class);
        let graph = &mut *self.graph;
        let arm = motion.turned(graph, class, arm);
        let sideways = plane::left(graph, arm);
        let speeding = plane::scale(graph, alpha, sideways);
        let squared = graph.powi(motion.omega[class], 2);
        let squared = graph.neg(squared);
        let inward = plane::scale(graph, squared, arm);
        plane::add(graph, speeding, inward)
    }

    /// The acceleration of a port of the ground, which may move with the time.
    fn drifting(&mut self, class: usize, at: Vec2) -> Vec2 {
        if class > 0 {
            return [self.graph.zero(); 2];
        }
        let speed = at.map(|component| self.graph.diff(component, self.model.time));
        speed.map(|component| self.graph.diff(component, self.model.time))
    }

    fn alpha(&self, second: &[Expr], class: usize) -> Expr {
        let unknown = self.coordinates.angle_of_class[class];
        unknown.map_or(self.graph.zero(), |unknown| second[unknown])
    }

    /// `phi_q` as a function of the coordinates.
    fn jacobian(&mut self, motion: &Motion) -> Vec<SparseRow> {
        let entries: Vec<Expr> = self.equations.phi_q.iter().flatten().map(|&(_, entry)| entry).collect();
        let mut entries = self.graph.substitute(&entries, &motion.substitution).into_iter();
        let row = |row: &SparseRow| row.iter().map(|&(k, _)| k).zip(entries.by_ref()).collect();
        self.equations.phi_q.iter().map(row).collect()
    }
}

/// The entries of a row in the columns of a body.
fn column(row: &SparseRow, body: usize, graph: &Graph) -> Triple {
    let mut entries = [graph.zero(); 3];
    for &(column, entry) in row.iter().filter(|(column, _)| column / 3 == body) {
        entries[column % 3] = entry;
    }
    entries
}

/// Solves `sum of lambda_k column_k = asked`: the forces from the first two rows, then what is a couple alone from the third.
///
/// One force is the part of what is asked along its direction: the equations agree, so nothing is left across it. The direction
/// of a row that is no pair's could vanish where it depends on the pose.
fn solve(columns: &[Triple], asked: Triple, pairs: bool, graph: &mut Graph) -> Option<Vec<Expr>> {
    let direction = |k: usize| [columns[k][0], columns[k][1]];
    let (couples, forces): (Vec<usize>, Vec<usize>) =
        (0..columns.len()).partition(|&k| plane::is_zero(graph, direction(k)));
    let [x, y, about] = asked;
    let mut lambda = vec![graph.zero(); columns.len()];
    match forces[..] {
        [] => {}
        [one] => {
            let along = plane::dot(graph, direction(one), [x, y]);
            let square = plane::dot(graph, direction(one), direction(one));
            if !pairs && graph.as_number(square).is_none() {
                return None;
            }
            lambda[one] = graph.div(along, square);
        }
        [first, second] => {
            let determinant = plane::cross(graph, direction(first), direction(second));
            // What depends on the pose could vanish.
            graph.as_number(determinant).filter(|number| !number.is_zero())?;
            let numerators = [
                plane::cross(graph, [x, y], direction(second)),
                plane::cross(graph, direction(first), [x, y]),
            ];
            [lambda[first], lambda[second]] = numerators.map(|value| graph.div(value, determinant));
        }
        _ => return None,
    }
    match couples[..] {
        [] => {}
        [one] => {
            let carried = forces.iter().map(|&k| graph.mul(columns[k][2], lambda[k]));
            let carried: Vec<Expr> = carried.collect();
            let carried = graph.sum(&carried);
            let left = graph.sub(about, carried);
            lambda[one] = graph.div(left, columns[one][2]);
        }
        _ => return None,
    }
    Some(lambda)
}
