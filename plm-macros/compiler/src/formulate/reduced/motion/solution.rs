//! Solution of a loop, for the functions that follow.

use plm_cas::{Expr, Vec2};

/// Values of a dyad's solution that velocities and the choice of charts need.
#[derive(Clone)]
pub(crate) struct Solution {
    /// `D`, m^2, m or 1; of a group without mirror images its measure.
    pub(crate) determinant: Expr,
    /// `D^2`; negative where the loop cannot be closed.
    pub(crate) square: Expr,
    /// `D^2` in the best of poses: `square / scale` is the square of a sine, a cosine, or a length over the scene's.
    pub(crate) scale: Expr,
    /// The loop's Jacobian by the two unknowns.
    pub(crate) columns: [Vec2; 2],
    /// The vectors of the loop that turn with the unknown orientations.
    pub(crate) arms: Vec<(usize, Vec2)>,
}

impl Solution {
    /// Of a group without mirror images that a sign could tell apart: the square of its measure, and whether it is closed.
    pub(crate) fn of_measure(measure: Expr, closed: Expr) -> Solution {
        let square = closed.select(measure, Expr::from(-1));
        Solution { determinant: square.sqrt(), square, ..Solution::certain() }
    }

    /// A loop that has nothing to decide.
    pub(crate) fn certain() -> Solution {
        Solution {
            determinant: Expr::ONE,
            square: Expr::ONE,
            scale: Expr::ONE,
            columns: [Vec2::ZERO; 2],
            arms: Vec::new(),
        }
    }
}

/// The smallest square of the measures of some loops.
pub(crate) fn measure(solutions: &[Solution]) -> Expr {
    let mut worst: Option<Expr> = None;
    for solution in solutions {
        let own = solution.square / solution.scale;
        worst = Some(worst.map_or(own, |worst| worst.min(own)));
    }
    worst.unwrap_or(Expr::ONE)
}
