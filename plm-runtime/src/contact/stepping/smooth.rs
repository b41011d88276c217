//! The step without rows of contact.

use super::{Stride, drift};
use crate::scalar::Scalar;
use crate::system::Rate;
use crate::vector::Vector;

/// (1) and (2) of this module without rows of contact; `rate` writes the rate at a time and state.
pub fn smooth_step<M: Rate>(stride: &Stride<M::S>, x: &mut M::X, rate: impl FnOnce(M::S, &M::X, &mut M::X)) {
    let [before, behind] = stride.parts();
    drift::<M>(before, x);
    let mut dx = *x;
    rate(stride.t + before, x, &mut dx);
    for i in M::NQ..M::X::LEN {
        x.set(i, stride.h.mul_add(dx.at(i), x.at(i)));
    }
    drift::<M>(behind, x);
}
