//! Steps that a system computes as one function: a formula with the rates of its stages, to the bits of the formula.

use super::{Health, Rate};
use crate::scalar::Scalar;

/// A formula of steps of fixed length, for systems that compute such steps as a whole.
pub trait OneStep {
    /// Name of the formula.
    const NAME: &'static str;
    /// Rates per step.
    const STAGES: u64;

    /// Takes the state `x` from `t` to `t + h`; `rates` writes the rate at a time and state. The result is above zero where the rates are so
    /// far apart that the error of the step is to be estimated.
    fn one_step<M: Rate>(
        system: &M,
        times: (M::S, M::S),
        x: &mut M::X,
        rates: impl FnMut(M::S, &M::X, &mut M::X),
    ) -> M::S;
}

/// A step that a system has computed as a whole ([`Rate::whole_step`]).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WholeStep<S: Scalar> {
    /// The worst health of its stages.
    pub health: Health<S>,
    /// Above zero where the rates are so far apart that the error is to be estimated.
    pub spread: S,
}
