//! What the functions of all charts are laid out from.

use plm_cas::{Expr, algebra};

use super::coordinates::Coordinates;
use super::memory::Memory;
use super::motion::Motion;
use crate::derive::Equations;
use crate::model::Model;

/// What all charts share.
pub(super) struct Layout<'a> {
    pub(super) model: &'a Model,
    pub(super) equations: &'a Equations,
    pub(super) coordinates: &'a Coordinates,
    pub(super) memory: &'a Memory,
    pub(super) length: Expr,
}

/// Applied forces and torques at each G, without gravity, as functions of the coordinates.
pub(super) fn loads(model: &Model, motion: &Motion) -> Vec<[Expr; 3]> {
    let mut terms: Vec<[Vec<Expr>; 3]> = vec![Default::default(); model.bodies.len()];
    for load in &model.loads {
        for (sum, &component) in terms[load.body].iter_mut().zip(&load.force) {
            sum.push(component);
        }
    }
    let sums: Vec<Expr> = terms.iter().flatten().map(|sum| algebra::sum(sum)).collect();
    let sums = algebra::substitute(&sums, &motion.substitution);
    sums.chunks_exact(3).map(|sum| [sum[0], sum[1], sum[2]]).collect()
}
