//! Operations of few arguments in many directions.
//!
//! The derivatives of a step are those by its arguments times the derivatives of the arguments. Where fewer arguments than directions have
//! any, the step takes as many directions as it has such arguments (preaccumulation: A. Griewank, A. Walther, Evaluating Derivatives, 2nd
//! ed., SIAM 2008, 10.2).

use core::cell::Cell;

use super::Dual;
use crate::scalar::{Operation, Real, Scalar};

/// Arguments with derivatives for which that is done.
pub(super) const MOST: usize = 4;

/// Arguments that have derivatives, in their order.
struct Moving<S, const K: usize> {
    arguments: [Cell<Dual<S, K>>; MOST],
    count: Cell<usize>,
}

impl<S: Real, const K: usize> Moving<S, K> {
    /// Those of an operation.
    #[inline]
    fn of(operation: &impl Operation<Dual<S, K>>) -> Self {
        let moving = Self { arguments: [const { Cell::new(Dual::<S, K>::ZERO) }; MOST], count: Cell::new(0) };
        operation.arguments(|number| {
            if moves(number) {
                let count = moving.count.get();
                if let Some(own) = moving.arguments.get(count) {
                    own.set(number);
                }
                moving.count.set(count + 1);
            }
        });
        moving
    }

    /// The operation in `D` directions.
    #[inline]
    fn derive<O: Operation<Dual<S, K>>, const D: usize>(&self, operation: O) -> O::Output {
        let met = Cell::new(0);
        let number = |number: Dual<S, K>| {
            if !moves(number) {
                return Dual::<S, D>::constant(number.value);
            }
            let direction = met.get();
            met.set(direction + 1);
            Dual::variable(number.value, direction)
        };
        operation.in_numbers(number, |result| self.chain(result))
    }

    /// A result with derivatives by the arguments. What does not move stays so where a slope is infinite.
    #[inline]
    fn chain<const D: usize>(&self, result: Dual<S, D>) -> Dual<S, K> {
        let mut sum = Dual::constant(result.value);
        for (slope, argument) in result.tangents.into_iter().zip(&self.arguments) {
            let Dual { tangents, .. } = argument.get();
            for k in 0..K {
                let (own, tangent) = (sum.tangents[k], tangents[k]);
                sum.tangents[k] = if tangent == S::ZERO { own } else { slope.mul_add(tangent, own) };
            }
        }
        sum
    }
}

#[inline]
fn moves<S: Real, const K: usize>(number: Dual<S, K>) -> bool {
    number.tangents.into_iter().any(|tangent| tangent != S::ZERO)
}

/// [`Real::make`] of numbers in more than [`MOST`] directions.
#[inline(never)]
pub(super) fn make<S: Real, O: Operation<Dual<S, K>>, const K: usize>(operation: O) -> O::Output {
    let value = |number: Dual<S, K>| number.value;
    if !O::HAS_DERIVATIVES {
        return operation.in_numbers(value, Dual::constant);
    }
    if O::IS_WIDE {
        return operation.make();
    }
    let moving = Moving::of(&operation);
    match moving.count.get() {
        0 => operation.in_numbers(value, Dual::constant),
        1..=2 => moving.derive::<O, 2>(operation),
        3..=MOST => moving.derive::<O, MOST>(operation),
        _ => operation.make(),
    }
}
