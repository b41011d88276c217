//! How many freedoms a mechanism has: its coordinates less the rank of `phi_q` at a regular pose.
//!
//! Structure counts rows and unknowns, and cannot see that dimensions make a row say what others say, nor that a pose does.
//! Next to an assembled pose the rank is that of the manifold of poses but where the pose itself is singular (a flat
//! parallelogram), where it is less. So where rows depend on others at the start, poses next to it are assembled too, and
//! the largest rank counts.

use super::assembly::Assembly;
use super::constraints::{Constraints, are_closed};
use super::random::Random;
use super::scene::Scene;
use crate::collect::CollectVec;

/// Poses next to the start.
const POSES: usize = 3;
/// How far from the start they are sought, rad or parts of the scene's length: near enough to stay among poses of its kind.
const NEXT_TO: f64 = 0.03;
/// Poses that assembly takes further away than this are of another kind.
const FAR: f64 = 0.5;

/// Can a body move at an assembled start, as far as constraints go? A row for each of its coordinates adds to the rank then.
pub(crate) fn moves(scene: &Scene, found: &Assembly, body: usize) -> bool {
    let constraints = Constraints::new(scene);
    let rank = |held: bool| {
        let of_body = |k: usize| held && k / 3 == body;
        constraints.rank(&found.q, &(0..found.q.len()).map(of_body).collect_vec()).value()
    };
    rank(true) > rank(false)
}

/// Coordinates less rank, for an assembled start.
pub(crate) fn freedom(scene: &Scene, found: &Assembly) -> usize {
    let (coordinates, rows) = (scene.equations.q.len(), scene.equations.phi.len());
    let constraints = Constraints::new(scene);
    let free = vec![false; coordinates];
    let rank = |q: &[f64]| constraints.rank(q, &free).value();
    let mut most = rank(&found.q);
    let mut random = Random(1);
    for _ in 0..POSES {
        if most == rows {
            break;
        }
        let size = |k: usize| if k % 3 == 2 { 1.0 } else { scene.length };
        let moved = |(k, q): (usize, &f64)| q + NEXT_TO * size(k) * random.unit();
        let near: Vec<f64> = found.q.iter().enumerate().map(moved).collect_vec();
        let near = constraints.close(near, &free, |_| found.closed.clone());
        let away = near.q.iter().zip(&found.q).enumerate().map(|(k, (q, from))| (q - from).abs() / size(k));
        if are_closed(&near.phi, &found.closed) && away.fold(0.0, f64::max) <= FAR {
            most = most.max(rank(&near.q));
        }
    }
    coordinates - most
}
