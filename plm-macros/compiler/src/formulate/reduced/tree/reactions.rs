//! Reactions of a tree: accelerations from the ground outwards, then, from the tips inwards, what each joint passes on.
//!
//! Once the accelerations are known, the three equations of a body, `phi_q^T lambda = Q - M a`, hold no unknowns but the
//! multipliers of what holds it, those further out being known (J. Y. S. Luh, M. W. Walker, R. P. C. Paul, J. Dyn. Syst.
//! Meas. Control 102, 1980: the recursive Newton-Euler method). So every joint costs a system of at most three rows.

use crate::collect::{CollectVec, MapEach, PushAll};
use plm_cas::{Expr, Vec2, algebra};

use crate::derive::SparseRow;
use crate::formulate::function::{Function, Section, stored};
use crate::formulate::reduced::joints::coordinates::Joint;
use crate::formulate::reduced::layout::Layout;
use crate::formulate::reduced::motion::Motion;
use crate::formulate::reduced::tree::spatial::Spatial;

impl Layout<'_> {
    /// `a` of all bodies and `lambda` of all rows, where `rate` gives the accelerations of the coordinates; nothing if some
    /// body is held by more than its own equations can tell apart.
    pub(crate) fn reactions(&mut self, motion: &Motion, rate: &Function) -> Option<Function> {
        let bodies = self.model.bodies.len();
        let a = self.accelerations_of_bodies(motion, &of_coordinates(motion, rate));
        let phi_q = self.phi_q(motion);
        let force = algebra::substitute(&self.equations.force, &motion.substitution);
        let mut left: Vec<Vec<Expr>> = Vec::with_capacity(3 * bodies);
        for ((&force, &mass), &a) in force.iter().zip(&self.equations.mass).zip(&a) {
            left.push(vec![force, -(mass * a)]);
        }
        let (lambda, trace) = self.multipliers(&phi_q, left)?;
        let mut sections = rate.sections.clone();
        sections.push(Section::new("Accelerations of the bodies, from the ground outwards", a.clone()));
        sections.push(Section::new("From the tips inwards: phi_q^T lambda = Q - M a", trace));
        let mut results = stored("a", a.iter());
        results.extend(stored("lambda", lambda.iter()));
        Some(Function { sections, results }.optimise())
    }

    /// `a` of all bodies, three each, where the coordinates have these accelerations.
    pub(crate) fn accelerations_of_bodies(&self, motion: &Motion, of_coordinates: &[Expr]) -> Vec<Expr> {
        let second = second_derivatives(motion, of_coordinates);
        self.accelerations(motion, &second).iter().flat_map(|a| a.0).collect_vec()
    }

    /// `lambda`, and the order of its solution; `left` are the sums of the terms of `Q - M a`.
    fn multipliers(
        &mut self,
        phi_q: &[SparseRow],
        mut left: Vec<Vec<Expr>>,
    ) -> Option<(Vec<Expr>, Vec<Expr>)> {
        let (mut lambda, mut trace) = (vec![None; phi_q.len()], Vec::new());
        for edge in self.coordinates.order.iter().rev() {
            let body = edge.body;
            let rows = (0..phi_q.len()).filter(|&row| lambda[row].is_none());
            let holding = rows.map(|row| (row, column(&phi_q[row], body)));
            let holding: Vec<(usize, Spatial)> =
                holding.filter(|(_, column)| *column != Spatial::ZERO).collect_vec();
            if holding.is_empty() {
                continue;
            }
            let name = &self.model.bodies[body].name.text;
            let asked = [0, 1, 2].map_each(|axis| {
                let sum = algebra::sum(&left[3 * body + axis]);
                sum.named(format!("{name}.left_{}", ["x", "y", "angle"][axis]))
            });
            let columns: Vec<Spatial> = holding.iter().map(|held| held.1).collect_vec();
            let is_pair =
                |&(row, _): &(usize, Spatial)| self.model.parts[self.model.rows[row].part].pair.is_some();
            let solution = solve(&columns, Spatial(asked), holding.iter().all(is_pair))?;
            for (&(row, _), value) in holding.iter().zip(solution) {
                let value = value.named(format!("lambda_{}", self.model.rows[row].name));
                trace.push(value);
                lambda[row] = Some(value);
                for &(column, entry) in phi_q[row].iter().filter(|(column, _)| column / 3 != body) {
                    left[column].push(-(entry * value));
                }
            }
        }
        Some((lambda.into_iter().collect::<Option<_>>()?, trace))
    }

    /// Accelerations of G and of the angle of every body.
    fn accelerations(&self, motion: &Motion, second: &[Expr]) -> Vec<Spatial> {
        let Layout { model, coordinates, .. } = *self;
        let mut reached = vec![Spatial::ZERO; model.bodies.len()];
        for edge in &coordinates.order {
            let body = edge.body;
            let from = edge.parent.map_or(Vec2::ZERO, |parent| reached[parent].plane());
            let a = match edge.joint.map(|joint| coordinates.joints[joint]) {
                None => coordinates.centre(body, second),
                Some(joint) => {
                    let across = self.across(motion, second, &joint);
                    from + if joint.b.body == Some(body) { across } else { -across }
                }
            };
            let name = &model.bodies[body].name.text;
            let a = a.named_by([format!("{name}.ax"), format!("{name}.ay")]);
            reached[body] =
                Spatial::new(a, self.alpha(second, coordinates.absolute_angles[body].orientation));
        }
        reached
    }

    /// How much more G of the body of `b` accelerates than G of the body of `a`.
    fn across(&self, motion: &Motion, second: &[Expr], joint: &Joint) -> Vec2 {
        let Layout { model, coordinates, .. } = *self;
        let (near, start) = coordinates.arm(model, joint.a);
        let (far, back) = coordinates.arm(model, joint.b);
        let mut out = start;
        let mut sum = self.drifting(near, start);
        if let Some(displacement) = joint.displacement {
            let (_, axis) = coordinates.axis(model, joint.a);
            out += motion.value[displacement] * axis;
            let along = motion.turned(near, axis);
            sum += second[displacement] * along;
            // Coriolis: 2 omega s'.
            let turning = motion.omega[near] * motion.rate[displacement];
            sum += (turning + turning) * along.left();
        }
        sum += self.turning(motion, second, near, out);
        sum -= self.drifting(far, back);
        sum - self.turning(motion, second, far, back)
    }

    /// `alpha J arm - omega^2 arm` of an arm in the axes of its orientation.
    fn turning(&self, motion: &Motion, second: &[Expr], orientation: usize, arm: Vec2) -> Vec2 {
        let alpha = self.alpha(second, orientation);
        let arm = motion.turned(orientation, arm);
        alpha * arm.left() + -motion.omega[orientation].squared() * arm
    }

    /// The acceleration of a port of the ground, which may move with the time.
    fn drifting(&self, orientation: usize, at: Vec2) -> Vec2 {
        if orientation > 0 { Vec2::ZERO } else { at.diff(self.model.time).diff(self.model.time) }
    }

    fn alpha(&self, second: &[Expr], orientation: usize) -> Expr {
        let unknown = self.coordinates.angle_of_orientation[orientation];
        unknown.map_or(Expr::ZERO, |unknown| second[unknown])
    }

    /// `phi_q` as a function of the coordinates.
    pub(crate) fn phi_q(&self, motion: &Motion) -> Vec<SparseRow> {
        let entries: Vec<Expr> = self.equations.phi_q.iter().flatten().map(|&(_, entry)| entry).collect_vec();
        let mut entries = algebra::substitute(&entries, &motion.substitution).into_iter();
        let row = |row: &SparseRow| row.iter().map(|&(k, _)| k).zip(entries.by_ref()).collect_vec();
        self.equations.phi_q.iter().map(row).collect_vec()
    }
}

/// The entries of a row in the columns of a body.
fn column(row: &SparseRow, body: usize) -> Spatial {
    let mut entries = Spatial::ZERO;
    for &(column, entry) in row.iter().filter(|(column, _)| column / 3 == body) {
        entries.0[column % 3] = entry;
    }
    entries
}

/// Solves `sum of lambda_k column_k = asked`: the forces from the first two rows, then what is a couple alone from the third.
///
/// One force is the part of what is asked along its direction: the equations agree, so nothing is left across it. The direction
/// of a row that is no pair's could vanish where it depends on the pose.
fn solve(columns: &[Spatial], asked: Spatial, pairs: bool) -> Option<Vec<Expr>> {
    let direction = |k: usize| columns[k].plane();
    let (couples, forces): (Vec<usize>, Vec<usize>) =
        (0..columns.len()).partition(|&k| direction(k).is_zero());
    let mut lambda = vec![Expr::ZERO; columns.len()];
    let directions = forces.iter().map(|&k| direction(k)).collect_vec();
    for (&k, value) in forces.iter().zip(by_force(&directions, asked.plane(), pairs)?) {
        lambda[k] = value;
    }
    match couples[..] {
        [] => {}
        [one] => {
            let carried: Expr = forces.iter().map(|&k| columns[k].about() * lambda[k]).sum();
            lambda[one] = (asked.about() - carried) / columns[one].about();
        }
        _ => return None,
    }
    Some(lambda)
}

/// Multipliers that give a force along these directions of rows.
pub(crate) fn by_force(directions: &[Vec2], force: Vec2, pairs: bool) -> Option<Vec<Expr>> {
    match *directions {
        [] => Some(Vec::new()),
        [one] => {
            let square = one.squared();
            let is_safe = pairs || square.as_number().is_some();
            is_safe.then(|| vec![one.dot(force) / square])
        }
        [first, second] => {
            let determinant = first.cross(second);
            // What depends on the pose could vanish.
            determinant.as_number().filter(|number| !number.is_zero())?;
            let minors = [force.cross(second), first.cross(force)];
            Some(minors.map_each(|minor| minor / determinant).to_vec())
        }
        _ => None,
    }
}

/// The accelerations of the coordinates in the results of a rate.
pub(crate) fn of_coordinates(motion: &Motion, rate: &Function) -> Vec<Expr> {
    let n = motion.independent.len();
    rate.results.iter().skip(n).take(n).map(|&(_, value)| value).collect_vec()
}

/// Second derivatives of all unknowns from those of the coordinates.
fn second_derivatives(motion: &Motion, of_independent: &[Expr]) -> Vec<Expr> {
    // With a pace, what the velocities ask for is over its square.
    let square = motion.pace.map_or(Expr::ONE, Expr::squared);
    let coefficients = motion.coefficient.iter().zip(&motion.bias);
    let values = coefficients.map(|(coefficients, &bias)| {
        let mut terms = vec![square * bias];
        let moving =
            coefficients.iter().zip(of_independent).filter(|(coefficient, _)| !coefficient.is_zero());
        terms.push_all(moving.map(|(&coefficient, &value)| coefficient * value));
        algebra::sum(&terms)
    });
    values.collect_vec()
}
