//! The equations of motion in independent coordinates, body by body.
//!
//! ```text
//! M_kl = sum over bodies of m J_k . J_l + I w_k w_l,    Q_k = sum over bodies of J_k . (F + m g - m c) + w_k (T - I e)
//! ```
//!
//! with the partial velocities `J`, `w` of a body and its acceleration `c`, `e` while the second derivatives of the coordinates
//! are zero (T. R. Kane, D. A. Levinson, Dynamics: Theory and Applications, 1985, chapters 2 and 6). Those of G follow
//! from the body before it, so that the work is in proportion to the bodies. What [`inertia`](super::inertia) sets up for all
//! unknowns of the loops is constant but for cosines and sines; it grows with the square of their number.
//!
//! The compiler takes these equations or those of `inertia`, whichever have fewer operations.

use crate::collect::CollectVec;
use crate::sorted::SortedMap;

use plm_cas::{Expr, Vec2};

use super::inertia::Dense;
use super::joints::coordinates::TreeEdge;
use super::motion::{Arm, Motion, Way};
use crate::model::Model;

/// How G of a body moves.
#[derive(Clone)]
struct Moves {
    /// `J` by coordinate.
    partial: Vec<Vec2>,
    /// `c`; with a pace, over its square.
    bias: Vec2,
}

/// Sets up the equations; `force` are the applied forces at each G in absolute axes, without gravity.
pub(crate) fn dense(model: &Model, motion: &Motion, force: &[[Expr; 3]]) -> Dense {
    let freedom = motion.independent.len();
    let moves = moves(model, motion);
    let mut mass: SortedMap<(usize, usize), Expr> = SortedMap::new();
    let (mut applied, mut turning) = (vec![Expr::ZERO; freedom], vec![Expr::ZERO; freedom]);
    let mut momentum = vec![Vec2::ZERO; freedom];
    for (body, declared) in model.bodies.iter().enumerate() {
        let Moves { partial, bias } = &moves[body];
        let orientation = motion.coordinates.absolute_angles[body].orientation;
        let [x, y, torque] = force[body];
        for k in 0..freedom {
            let (own, spin) = (declared.mass * partial[k], motion.turning_by(orientation, k));
            let turned = declared.inertia * spin;
            for l in 0..=k {
                let entry = own.dot(partial[l]) + turned * motion.turning_by(orientation, l);
                *mass.or_insert((k, l), Expr::ZERO) += entry;
            }
            momentum[k] += own;
            applied[k] += partial[k].dot(Vec2::new(x, y)) + spin * torque;
            turning[k] += own.dot(*bias) + turned * motion.turning_bias(orientation);
        }
    }
    mass.retain(|&(k, l), entry| k == l || !entry.is_zero());
    for k in 0..freedom {
        applied[k] += momentum[k].dot(model.gravity);
        if motion.pace.is_none() {
            applied[k] -= turning[k];
        }
    }
    Dense { mass, force: applied, turning }
}

/// How the bodies move, each from the one before.
fn moves(model: &Model, motion: &Motion) -> Vec<Moves> {
    let coordinates = motion.coordinates;
    let still = Moves { partial: vec![Vec2::ZERO; motion.independent.len()], bias: Vec2::ZERO };
    let mut moves = vec![still.clone(); model.bodies.len()];
    for edge in &coordinates.order {
        let body = edge.body;
        let free = |of: &[Expr]| coordinates.centre(body, of);
        let found = match edge.joint {
            Some(joint) => {
                let before = edge.parent.map_or(&still, |parent| &moves[parent]);
                beyond(model, motion, before, (edge, joint))
            }
            None => Moves {
                partial: (0..still.partial.len()).map(|k| free(&motion.coefficients(k))).collect_vec(),
                bias: free(&motion.bias),
            },
        };
        let name = &model.bodies[body].name.text;
        let partial = found.partial.into_iter().enumerate();
        moves[body] = Moves {
            partial: partial.map(|(k, partial)| partial.named(format!("{name}.partial_{k}"))).collect_vec(),
            bias: found.bias.named(format!("{name}.turning")),
        };
    }
    moves
}

/// How G of a body moves beyond a joint.
fn beyond(model: &Model, motion: &Motion, before: &Moves, (edge, joint): (&TreeEdge, usize)) -> Moves {
    let Moves { mut partial, mut bias } = before.clone();
    let Way { displacement, arms } = motion.way(model, edge, joint);
    if let Some((displacement, orientation, axis)) = displacement {
        let axis = motion.turned(orientation, axis);
        for (k, partial) in partial.iter_mut().enumerate() {
            *partial += motion.coefficient[displacement][k] * axis;
        }
        // Coriolis: 2 omega s'.
        let coriolis = 2 * motion.turning[orientation] * motion.rate_over_pace(displacement);
        bias += motion.bias[displacement] * axis + coriolis * axis.left();
    }
    for Arm { orientation, vector, at_rest } in arms {
        for (k, partial) in partial.iter_mut().enumerate() {
            *partial += motion.turning_by(orientation, k) * vector.left();
        }
        if orientation == 0 {
            bias += at_rest.diff(model.time).diff(model.time);
        }
        bias +=
            motion.turning_bias(orientation) * vector.left() - motion.turning[orientation].squared() * vector;
    }
    Moves { partial, bias }
}
