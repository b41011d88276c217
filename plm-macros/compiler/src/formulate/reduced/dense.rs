//! Accelerations from the dense mass matrix.

use crate::collect::{CollectVec, MapEach};
use plm_cas::{Expr, Vec2};

use crate::formulate::function::Section;
use crate::formulate::ldl::factorise;
use crate::formulate::reduced::inertia::Dense;
use crate::formulate::reduced::motion::Motion;

/// Solves `M a = Q`, and how a person would write that down.
pub(crate) fn accelerations(motion: &Motion, dense: &Dense) -> (Vec<Expr>, Vec<Section>) {
    let names: Vec<String> = motion
        .independent
        .iter()
        .map(|&unknown| format!("{}_acceleration", motion.names[unknown]))
        .collect_vec();
    let mut mass = dense.mass.clone();
    for (&(i, j), entry) in mass.iter_mut() {
        *entry = (*entry).named(format!("m_{i}_{j}"));
    }
    let force: Vec<Expr> = dense
        .right_hand_side(motion)
        .into_iter()
        .enumerate()
        .map(|(i, force)| force.named(format!("force_{i}")))
        .collect_vec();
    let mut roots: Vec<Expr> = mass.values().copied().chain(force.iter().copied()).collect_vec();
    let at = |key| mass.get(&key).copied();
    let solution = match (force.as_slice(), at((1, 0))) {
        (&[], _) => Vec::new(),
        // The mass is known before the forces, which wait for velocities: let its division begin early.
        (&[force], _) => {
            let reciprocal = (1 / mass[&(0, 0)]).named("reciprocal");
            vec![force * reciprocal]
        }
        // Cramer's rule: one division instead of two in a row.
        (&[first, second], Some(coupling)) => {
            let columns = [Vec2::new(mass[&(0, 0)], coupling), Vec2::new(coupling, mass[&(1, 1)])];
            let force = Vec2::new(first, second);
            let minors = [force.cross(columns[1]), columns[0].cross(force)];
            let reciprocal = (1 / columns[0].cross(columns[1])).named("reciprocal");
            minors.map_each(|minor| minor * reciprocal).to_vec()
        }
        _ => {
            let factor = factorise(force.len(), &mass, None);
            let (solution, trace) = factor.solve(&force, &names);
            roots.extend(factor.trace);
            roots.extend(trace);
            solution
        }
    };
    let named = solution.iter().zip(&names).map(|(&value, name)| value.named(name));
    (named.collect_vec(), vec![Section::new("Masses and forces along the coordinates: M a = Q", roots)])
}
