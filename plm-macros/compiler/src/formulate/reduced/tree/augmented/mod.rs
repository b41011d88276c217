//! The equations of motion of a tree before anything is eliminated, linearised: sparse, where df/dx is full.
//!
//! With the place `X_b = X_p + D_b(y, t)` of G of each body as seen from the body p that holds it, and the force `f_b` that
//! comes through its joint with all that hangs on it,
//!
//! ```text
//! A_b - A_p - D_b''                                                    = 0
//! f_b - m_b (A_b - g) + F_b - sum of f_c over the bodies c held by b   = 0
//! sum of f_b . dD_b/dy_k over bodies + sum of (I_b y_k'' - tau_b) over those that turn with y_k = 0
//! ```
//!
//! the last for every coordinate: the principle of virtual power (T. R. Kane, D. A. Levinson, Dynamics: Theory and
//! Applications, 1985, chapter 6) with the work of the bodies summed from the tips inwards. Places and velocities are
//! unknowns too where a force depends on them. Every equation ties neighbours; eliminated from the tips to the ground it
//! is the method of articulated bodies.

mod rows;
mod unknowns;

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, Vec2, algebra};

use self::rows::Way;
use self::unknowns::Unknowns;
use crate::derive::Equations;
use crate::formulate::function::Section;
use crate::formulate::linearised::Augmented;
use crate::formulate::reduced::layout::loads;
use crate::formulate::reduced::motion::Motion;
use crate::model::Model;

/// States up to which implicit methods take the full matrix of derivatives.
const MOST_FULL: usize = 24;

/// Lays out the linearised equations of a tree; nothing where df/dx is small.
pub(crate) fn augmented(model: &Model, equations: &Equations, motion: &Motion) -> Option<Augmented> {
    if 2 * motion.independent.len() + equations.x.len() <= MOST_FULL {
        return None;
    }
    Some(laid_out(model, equations, motion))
}

/// The augmented equations for any number of states.
pub(crate) fn laid_out(model: &Model, equations: &Equations, motion: &Motion) -> Augmented {
    let coordinates = motion.coordinates;
    let unknowns = Unknowns::new(model, equations, motion);
    let (ways, mut terms) = rows::terms(model, motion, &unknowns);
    let (pairs, sections) = known(model, motion, &unknowns, &ways);
    let values: Vec<Expr> = terms.values().copied().collect_vec();
    let values = algebra::substitute(&values, &pairs);
    for ((_, old), value) in terms.iter_mut().zip(values) {
        *old = value;
    }
    let order = unknowns.order(coordinates);
    let accelerations = unknowns.accelerations;
    Augmented::new(terms, (accelerations, equations.x.len()), &order, |_| sections)
}

/// Values for the symbols of accelerations of bodies, outwards, and forces in joints, inwards.
fn known(
    model: &Model,
    motion: &Motion,
    unknowns: &Unknowns,
    ways: &[Way],
) -> (Vec<(Expr, Expr)>, Vec<Section>) {
    let coordinates = motion.coordinates;
    let applied = loads(model, motion);
    let mut pairs = motion.substitution.clone();
    let (mut outward, mut inward) = (Vec::new(), Vec::new());
    let mut reached = vec![Vec2::ZERO; model.bodies.len()];
    for (edge, way) in coordinates.order.iter().zip(ways) {
        let start = edge.parent.map_or(Vec2::ZERO, |parent| reached[parent]);
        reached[edge.body] = (start + way.acceleration).named("a");
        outward.push_all(reached[edge.body].components());
    }
    let mut passed = vec![Vec2::ZERO; model.bodies.len()];
    for edge in coordinates.order.iter().rev() {
        let body = edge.body;
        let [fx, fy, _] = applied[body];
        let inertial = model.bodies[body].mass * (reached[body] - model.gravity);
        let force = (passed[body] + (inertial - Vec2::new(fx, fy))).named("force");
        inward.push_all(force.components());
        pairs.push_all(unknowns.forces[body].components().into_iter().zip(force.components()));
        if let Some(parent) = edge.parent {
            passed[parent] += force;
        }
    }
    let outward = Section::new("Accelerations of G of the bodies", outward);
    (pairs, vec![outward, Section::new("Forces in the joints", inward)])
}
