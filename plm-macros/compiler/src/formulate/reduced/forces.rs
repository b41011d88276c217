//! Forces that joints pass on, where the accelerations are known: from the tips of the spanning tree inwards, with the forces of the
//! joints that close loops from the virtual work of the loops' own unknowns.
//!
//! With `w = Q - M a = phi_q^T lambda` of each body, and loops `C_k(u) = 0` of the unknowns `u` of the tree,
//!
//! ```text
//! (1)  sum over bodies of (d(pose)/du)^T w = sum over loops of (dC_k/du)^T mu_k + sum over rows of (d phi/du) lambda
//! ```
//!
//! Groups of unknowns come apart in the order in which they are solved, so that the multipliers `mu` follow from the last loop to the
//! first, a pair from the two unknowns of its dyad, by Cramer's rule. A joint of the tree passes on the sum of what the bodies beyond it
//! are left with (J. Y. S. Luh, M. W. Walker, R. P. C. Paul, J. Dyn. Syst. Meas. Control 102, 1980).

use crate::collect::{CollectVec, MapEach};
use plm_cas::{Expr, Vec2, algebra};

use super::charts::Scheme;
use super::groups::Group;
use super::groups::dyad::Dyad;
use super::groups::explicit_row::ExplicitRow;
use super::joints::coordinates::{Joint, TreeEdge, Unknown};
use super::layout::Layout;
use super::motion::{Arm, Motion, Way};
use super::tree::reactions::by_force;
use super::tree::spatial::Spatial;
use crate::derive::SparseRow;

impl Layout<'_> {
    /// `lambda` of the rows of joints that are forces, where the bodies have these accelerations, three each. Nothing for couples, and
    /// where loops are redundant or solved together.
    pub(super) fn forces_of_joints(&self, motion: &Motion, scheme: &Scheme, a: &[Expr]) -> Vec<Option<Expr>> {
        let force = algebra::substitute(&self.equations.force, &motion.substitution);
        let left =
            force.iter().zip(&self.equations.mass).zip(a).map(|((&force, &mass), &a)| force - mass * a);
        let left = left.collect_vec();
        let left = left.chunks_exact(3).map(|body| Spatial::new(Vec2::new(body[0], body[1]), body[2]));
        let phi_q = self.phi_q(motion);
        let mut passing = Passing { layout: self, motion, phi_q: &phi_q, left: left.collect_vec() };
        let mut lambda = vec![None; phi_q.len()];
        if passing.open_loops(scheme, &mut lambda).is_some() {
            passing.pass_on(&mut lambda);
        }
        lambda
    }
}

/// Bodies and the wrenches that they are left with while forces are passed on.
struct Passing<'a> {
    layout: &'a Layout<'a>,
    motion: &'a Motion<'a>,
    phi_q: &'a [SparseRow],
    /// By body.
    left: Vec<Spatial>,
}

impl Passing<'_> {
    /// Takes the forces that close loops and those of explicit rows off the bodies.
    fn open_loops(&mut self, scheme: &Scheme, lambda: &mut [Option<Expr>]) -> Option<()> {
        let coordinates = self.layout.coordinates;
        let mut work = self.virtual_work();
        let mut closing = vec![Vec2::ZERO; coordinates.joints.len()];
        let mut place = scheme.loops().count();
        for group in scheme.groups.iter().rev() {
            match group {
                Group::Dyad(dyad) => {
                    place -= 1;
                    let multiplier = self.of_dyad(dyad, place, &mut work);
                    for &(joint, times) in &coordinates.crossed[dyad.closure] {
                        closing[joint] -= Expr::from(times) * multiplier;
                    }
                }
                Group::ExplicitRow(row) => {
                    let (number, value) = self.of_row(row, &mut work)?;
                    for &(column, entry) in &self.phi_q[number] {
                        self.left[column / 3] = self.left[column / 3] - on_axis(column % 3, entry * value);
                    }
                    lambda[number] = Some(value);
                }
                Group::RedundantRow(_) | Group::Newton(_) => return None,
            }
        }
        for &chord in &coordinates.chords {
            let Joint { a, b, .. } = coordinates.joints[chord];
            let force = closing[chord].named_by([format!("chord_{chord}_x"), format!("chord_{chord}_y")]);
            // Moments are of no use beyond.
            for (body, force) in [(a.body, -force), (b.body, force)] {
                let Some(body) = body else { continue };
                self.left[body] = self.left[body] - Spatial::new(force, Expr::ZERO);
            }
            match (a.body, b.body) {
                (_, Some(body)) => self.rows_of(chord, body, force, lambda),
                (Some(body), None) => self.rows_of(chord, body, -force, lambda),
                (None, None) => {}
            }
        }
        Some(())
    }

    /// The left side of (1), by unknown.
    fn virtual_work(&self) -> Vec<Expr> {
        let Layout { model, coordinates, .. } = *self.layout;
        let mut terms: Vec<Vec<Expr>> = vec![Vec::new(); coordinates.unknowns.len()];
        for (body, left) in self.left.iter().enumerate() {
            let orientation = coordinates.absolute_angles[body].orientation;
            if let Some(angle) = coordinates.angle_of_orientation[orientation] {
                terms[angle].push(left.about());
            }
        }
        let mut beyond: Vec<Vec2> = self.left.iter().map(|left| left.plane()).collect_vec();
        for edge in coordinates.order.iter().rev() {
            let force = beyond[edge.body];
            let Some(joint) = edge.joint else {
                for (k, unknown) in coordinates.unknowns.iter().enumerate() {
                    if let Unknown::Centre { body, axis } = *unknown
                        && body == edge.body
                    {
                        terms[k].push(force.components()[axis]);
                    }
                }
                continue;
            };
            let Way { displacement, arms } = self.motion.way(model, edge, joint);
            if let Some((unknown, orientation, axis)) = displacement {
                terms[unknown].push(self.motion.turned(orientation, axis).dot(force));
            }
            for Arm { orientation, vector, .. } in arms {
                if let Some(angle) = coordinates.angle_of_orientation[orientation] {
                    terms[angle].push(vector.left().dot(force));
                }
            }
            if let Some(parent) = edge.parent {
                beyond[parent] += force;
            }
        }
        terms.iter().map(|terms| algebra::sum(terms)).collect_vec()
    }

    /// The multiplier of the loop of a dyad, whose work is taken off that of the other unknowns.
    fn of_dyad(&self, dyad: &Dyad, place: usize, work: &mut [Expr]) -> Vec2 {
        let motion = self.motion;
        let solution = &motion.solutions[place];
        let reciprocal = solution.determinant.recip().named(format!("reciprocal_{}", dyad.closure));
        let [first, second] = solution.columns;
        let [one, other] = dyad.unknowns.map_each(|unknown| work[unknown]);
        let multiplier = reciprocal * (other * first.left() - one * second.left());
        let multiplier =
            multiplier.named_by(["x", "y"].map_each(|axis| format!("closing_{}_{axis}", dyad.closure)));
        let coordinates = self.layout.coordinates;
        let chain = &coordinates.closures[dyad.closure];
        for orientation in chain.orientations() {
            if let Some(angle) = coordinates.angle_of_orientation[orientation] {
                work[angle] -= motion.absolute_arm(chain, orientation).left().dot(multiplier);
            }
        }
        for (orientation, displacement, vector) in chain.terms() {
            if let Some(displacement) = displacement {
                work[displacement] -= motion.turned(orientation, vector).dot(multiplier);
            }
        }
        multiplier
    }

    /// The number of an explicit row, and its multiplier, whose work is taken off.
    fn of_row(&self, group: &ExplicitRow, work: &mut [Expr]) -> Option<(usize, Expr)> {
        let Layout { model, coordinates, .. } = *self.layout;
        let rows = model.rows.iter().enumerate().filter(|(_, row)| model.parts[row.part].pair.is_none());
        let number = rows.map(|(number, _)| number).nth(group.row)?;
        let row = &coordinates.rows[group.row];
        let slopes = group.slopes(self.motion);
        let own = row.coefficient(group.unknown)?;
        let value = work[group.unknown] / own;
        let value = value.named(format!("lambda_{}", model.rows[number].name));
        for (unknown, slope) in slopes {
            work[unknown] -= slope * value;
        }
        Some((number, value))
    }

    /// Rows of the joints of the tree, from the tips inwards.
    fn pass_on(&mut self, lambda: &mut [Option<Expr>]) {
        let Layout { model, coordinates, .. } = *self.layout;
        for &TreeEdge { body, joint, parent } in coordinates.order.iter().rev() {
            let name = &model.bodies[body].name.text;
            let force =
                self.left[body].plane().named_by([format!("{name}.passed_x"), format!("{name}.passed_y")]);
            let Some(joint) = joint else { continue };
            self.rows_of(joint, body, force, lambda);
            if let Some(parent) = parent {
                self.left[parent] = self.left[parent] + Spatial::new(force, Expr::ZERO);
            }
        }
    }

    /// The rows of a joint that give a body this force.
    fn rows_of(&self, joint: usize, body: usize, force: Vec2, lambda: &mut [Option<Expr>]) {
        let Layout { model, coordinates, .. } = *self.layout;
        let part = coordinates.joints[joint].part;
        let rows = (0..self.phi_q.len()).filter(|&row| model.rows[row].part == part);
        let directions = rows.map(|row| (row, direction(&self.phi_q[row], body)));
        let forces: Vec<(usize, Vec2)> = directions.filter(|(_, along)| !along.is_zero()).collect_vec();
        let along: Vec<Vec2> = forces.iter().map(|row| row.1).collect_vec();
        let Some(values) = by_force(&along, force, true) else { return };
        for (&(row, _), value) in forces.iter().zip(values) {
            lambda[row] = Some(value.named(format!("lambda_{}", model.rows[row].name)));
        }
    }
}

/// A wrench along one axis.
fn on_axis(axis: usize, size: Expr) -> Spatial {
    let [x, y, about] = [0, 1, 2].map_each(|k| if k == axis { size } else { Expr::ZERO });
    Spatial::new(Vec2::new(x, y), about)
}

/// The entries of a row for the place of a body.
fn direction(row: &SparseRow, body: usize) -> Vec2 {
    let entry = |axis: usize| row.iter().find(|(column, _)| *column == 3 * body + axis);
    Vec2::from([0, 1].map_each(|axis| entry(axis).map_or(Expr::ZERO, |found| found.1)))
}
