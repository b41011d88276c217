//! The step without rows of contact.

use super::{Stride, drift, predicted};
use crate::scalar::Scalar;
use crate::system::Rate;
use crate::vector::Vector;

/// (1) and (2) of this module without rows of contact; `rate` writes the rate at a time and state, once for each evaluation.
pub fn smooth_step<M: Rate, const EVALUATIONS: usize>(
    stride: &Stride<M::S>,
    x: &mut M::X,
    mut rate: impl FnMut(M::S, &M::X, &mut M::X),
) {
    let [before, behind] = stride.parts();
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
    drift::<M>(behind, x);
}
