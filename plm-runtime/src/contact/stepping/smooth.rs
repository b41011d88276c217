//! Time step without contact rows.

use super::{Solution, Stride, drift, predicted};
use crate::fault::Fault;
use crate::scalar::Scalar;
use crate::system::{Health, Rate};
use crate::vector::Vector;

/// Equations (1) and (2) of the time step without contact rows; `rate` writes the rate at a time and state, once for each
/// evaluation.
pub fn smooth_step<M: Rate, const EVALUATIONS: usize>(
    stride: &Stride<M::S>,
    x: &mut M::X,
    mut rate: impl FnMut(M::S, &M::X, &mut M::X),
) {
    let [before, after] = stride.parts();
    drift::<M>(before, x);
    let mut dx = *x;
    rate(stride.t + before, x, &mut dx);
    for _ in 1..EVALUATIONS {
        let place = predicted::<M>(before, x, &dx);
        rate(stride.t + before, &place, &mut dx);
    }
    for i in M::NQ..M::X::LEN {
        x.set(i, stride.h.mul_add(dx.at(i), x.at(i)));
    }
    drift::<M>(after, x);
}

/// Makes a [`smooth_step`] by the rate of a system, then calls `after`.
///
/// # Errors
/// Those of `after`.
pub fn smooth_stride<M: Rate, const EVALUATIONS: usize>(
    system: &M,
    stride: &Stride<M::S>,
    (u, x): (&mut M::U, &mut M::X),
    after: impl FnOnce(&mut M::U, &mut M::X, &Solution<M::S>) -> Result<(), Fault>,
) -> Result<Solution<M::S>, Fault> {
    let mut worst: Option<Health<M::S>> = None;
    smooth_step::<M, EVALUATIONS>(stride, x, |t, x, dx| {
        let health = system.rate(t, u, x, dx);
        worst = Some(worst.map_or(health, |worst| worst.worst(health)));
    });
    let health = worst.unwrap_or_else(Health::perfect);
    let solution = Solution { residual: M::S::ZERO, rounds: 0, evaluations: EVALUATIONS as u32, health };
    after(u, x, &solution).map(|()| solution)
}
