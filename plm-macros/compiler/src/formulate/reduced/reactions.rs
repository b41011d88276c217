//! Reactions of a tree: accelerations from the ground outwards, then, from the tips inwards, what each joint passes on.
//!
//! Once the accelerations are known, the three equations of a body, `phi_q^T lambda = Q - M a`, hold no unknowns but the
//! multipliers of what holds it, those further out being known (J. Y. S. Luh, M. W. Walker, R. P. C. Paul, J. Dyn. Syst.
//! Meas. Control 102, 1980: the recursive Newton-Euler method). So every joint costs a system of at most three rows.

use plm_cas::{Expr, algebra};

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
        let second = second_derivatives(motion, &of_drivers);
        let acceleration = self.accelerations(motion, &second);
        let a: Vec<Expr> = acceleration.iter().flatten().copied().collect();
        let phi_q = self.jacobian(motion);
        let force = algebra::substitute(&self.equations.force, &motion.substitution);
        let mut left: Vec<Vec<Expr>> = Vec::with_capacity(3 * bodies);
        for ((&force, &mass), &a) in force.iter().zip(&self.equations.mass).zip(&a) {
            let inertial = mass * a;
            left.push(vec![force, -inertial]);
        }
        let (lambda, trace) = self.multipliers(&phi_q, left)?;
        let mut sections = rate.sections.clone();
        sections.push(Section::new("Accelerations of the bodies, from the ground outwards", a.clone()));
        sections.push(Section::new("From the tips inwards: phi_q^T lambda = Q - M a", trace));
        let mut results = stored("a", a.iter());
        results.extend(stored("lambda", lambda.iter()));
        Some(Function { sections, results }.optimise())
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
            let holding = rows.map(|row| (row, column(&phi_q[row], body)));
            let holding: Vec<(usize, Triple)> =
                holding.filter(|(_, column)| column.iter().any(|&entry| !entry.is_zero())).collect();
            if holding.is_empty() {
                continue;
            }
            let asked = [0, 1, 2].map(|axis| {
                let sum = algebra::sum(&left[3 * body + axis]);
                let name =
                    format!("{}.left_{}", self.model.bodies[body].name.text, ["x", "y", "angle"][axis]);
                sum.named(&name)
            });
            let columns: Vec<Triple> = holding.iter().map(|held| held.1).collect();
            let is_pair =
                |&(row, _): &(usize, Triple)| self.model.parts[self.model.rows[row].part].pair.is_some();
            let solution = solve(&columns, asked, holding.iter().all(is_pair))?;
            for (&(row, _), value) in holding.iter().zip(solution) {
                let name = format!("lambda_{}", self.model.rows[row].name);
                let value = value.named(&name);
                trace.push(value);
                lambda[row] = Some(value);
                for &(column, entry) in phi_q[row].iter().filter(|(column, _)| column / 3 != body) {
                    let passed = entry * value;
                    left[column].push(-passed);
                }
            }
        }
        Some((lambda.into_iter().collect::<Option<_>>()?, trace))
    }

    /// Accelerations of G and of the angle of every body.
    fn accelerations(&mut self, motion: &Motion, second: &[Expr]) -> Vec<Triple> {
        let Layout { model, coordinates, .. } = *self;
        let zero = Expr::ZERO;
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
                        across = plane::negated(across);
                    }
                    plane::add(from, across)
                }
            };
            let name = &model.bodies[body].name.text;
            let x = x.named(format!("{name}.ax"));
            let y = y.named(format!("{name}.ay"));
            let class = coordinates.headings[body].class;
            reached[body] = [x, y, self.alpha(second, class)];
        }
        reached
    }

    /// How much more G of the body of `b` accelerates than G of the body of `a`.
    fn across(&mut self, motion: &Motion, second: &[Expr], joint: &Joint) -> Vec2 {
        let Layout { model, coordinates, .. } = *self;
        let (near, start) = coordinates.arm(model, joint.a);
        let (far, back) = coordinates.arm(model, joint.b);
        let mut out = start;
        let mut sum = self.drifting(near, start);
        if let Some(slide) = joint.slide {
            let (_, axis) = coordinates.axis(model, joint.a);
            let way = plane::scale(motion.value[slide], axis);
            out = plane::add(out, way);
            let along = motion.turned(near, axis);
            let speeding = plane::scale(second[slide], along);
            sum = plane::add(sum, speeding);
            // Coriolis: 2 omega s'.
            let turning = motion.omega[near] * motion.rate[slide];
            let twice = turning + turning;
            let sideways = plane::left(along);
            let coriolis = plane::scale(twice, sideways);
            sum = plane::add(sum, coriolis);
        }
        let there = self.turning(motion, second, near, out);
        sum = plane::add(sum, there);
        for beyond in [self.drifting(far, back), self.turning(motion, second, far, back)] {
            let beyond = plane::negated(beyond);
            sum = plane::add(sum, beyond);
        }
        sum
    }

    /// `alpha x arm - omega^2 arm` of an arm in the axes of its class.
    fn turning(&mut self, motion: &Motion, second: &[Expr], class: usize, arm: Vec2) -> Vec2 {
        let alpha = self.alpha(second, class);
        let arm = motion.turned(class, arm);
        let sideways = plane::left(arm);
        let speeding = plane::scale(alpha, sideways);
        let squared = motion.omega[class].powi(2);
        let squared = -squared;
        let inward = plane::scale(squared, arm);
        plane::add(speeding, inward)
    }

    /// The acceleration of a port of the ground, which may move with the time.
    fn drifting(&mut self, class: usize, at: Vec2) -> Vec2 {
        if class > 0 {
            return [Expr::ZERO; 2];
        }
        let speed = at.map(|component| component.diff(self.model.time));
        speed.map(|component| component.diff(self.model.time))
    }

    fn alpha(&self, second: &[Expr], class: usize) -> Expr {
        let unknown = self.coordinates.angle_of_class[class];
        unknown.map_or(Expr::ZERO, |unknown| second[unknown])
    }

    /// `phi_q` as a function of the coordinates.
    fn jacobian(&mut self, motion: &Motion) -> Vec<SparseRow> {
        let entries: Vec<Expr> = self.equations.phi_q.iter().flatten().map(|&(_, entry)| entry).collect();
        let mut entries = algebra::substitute(&entries, &motion.substitution).into_iter();
        let row = |row: &SparseRow| row.iter().map(|&(k, _)| k).zip(entries.by_ref()).collect();
        self.equations.phi_q.iter().map(row).collect()
    }
}

/// The entries of a row in the columns of a body.
fn column(row: &SparseRow, body: usize) -> Triple {
    let mut entries = [Expr::ZERO; 3];
    for &(column, entry) in row.iter().filter(|(column, _)| column / 3 == body) {
        entries[column % 3] = entry;
    }
    entries
}

/// Solves `sum of lambda_k column_k = asked`: the forces from the first two rows, then what is a couple alone from the third.
///
/// One force is the part of what is asked along its direction: the equations agree, so nothing is left across it. The direction
/// of a row that is no pair's could vanish where it depends on the pose.
fn solve(columns: &[Triple], asked: Triple, pairs: bool) -> Option<Vec<Expr>> {
    let direction = |k: usize| [columns[k][0], columns[k][1]];
    let (couples, forces): (Vec<usize>, Vec<usize>) =
        (0..columns.len()).partition(|&k| plane::is_zero(direction(k)));
    let [x, y, about] = asked;
    let mut lambda = vec![Expr::ZERO; columns.len()];
    match forces[..] {
        [] => {}
        [one] => {
            let along = plane::dot(direction(one), [x, y]);
            let square = plane::dot(direction(one), direction(one));
            if !pairs && square.as_number().is_none() {
                return None;
            }
            lambda[one] = along / square;
        }
        [first, second] => {
            let determinant = plane::cross(direction(first), direction(second));
            // What depends on the pose could vanish.
            determinant.as_number().filter(|number| !number.is_zero())?;
            let numerators =
                [plane::cross([x, y], direction(second)), plane::cross(direction(first), [x, y])];
            [lambda[first], lambda[second]] = numerators.map(|value| value / determinant);
        }
        _ => return None,
    }
    match couples[..] {
        [] => {}
        [one] => {
            let carried = forces.iter().map(|&k| columns[k][2] * lambda[k]);
            let carried: Vec<Expr> = carried.collect();
            let carried = algebra::sum(&carried);
            let left = about - carried;
            lambda[one] = left / columns[one][2];
        }
        _ => return None,
    }
    Some(lambda)
}

/// Second derivatives of all unknowns from those of the coordinates.
fn second_derivatives(motion: &Motion, of_drivers: &[Expr]) -> Vec<Expr> {
    // With a pace, what the velocities ask for is over its square.
    let square = motion.pace.map_or(Expr::ONE, |pace| pace.powi(2));
    let gains = motion.gain.iter().zip(&motion.bias);
    let values = gains.map(|(gains, &bias)| {
        let mut terms = vec![square * bias];
        let zero = Expr::ZERO;
        let moving = gains.iter().zip(of_drivers).filter(|(gain, _)| **gain != zero);
        terms.extend(moving.map(|(&gain, &value)| gain * value));
        algebra::sum(&terms)
    });
    values.collect()
}
