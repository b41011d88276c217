//! An operation of many numbers as one record of each result, with the derivatives of all by dual numbers.
//!
//! Preaccumulation (A. Griewank, A. Walther, Evaluating Derivatives, 2nd ed., SIAM 2008, 10.2): a step of a method has some hundred to
//! thousand operations of few numbers. Their record is longer than the matrix of their derivatives, which takes as many directions as there
//! are arguments that depend on a variable.

use core::cell::Cell;

use super::{LAST, Term, Trace, Traced};
use crate::dual::Dual;
use crate::scalar::{Operation, Real};

/// Directions in which all derivatives cost less than the record of single operations.
const MOST: usize = 12;

/// Arguments that depend on variables, in their order.
struct Active<'t, S> {
    trace: Cell<Option<&'t Trace<'t, S>>>,
    places: [Cell<u64>; MOST],
    count: Cell<usize>,
}

impl<'t, S: Real> Active<'t, S> {
    /// Those of an operation.
    #[inline]
    fn of(operation: &impl Operation<Traced<'t, S>>) -> Self {
        let active =
            Self { trace: Cell::new(None), places: [const { Cell::new(0) }; MOST], count: Cell::new(0) };
        operation.arguments(|number| {
            if let (Some(place), Some(trace)) = (number.place(), number.trace()) {
                let count = active.count.get();
                if let Some(own) = active.places.get(count) {
                    own.set(place);
                }
                active.trace.set(Some(trace));
                active.count.set(count + 1);
            }
        });
        active
    }

    /// Records a result with its derivatives.
    #[inline]
    fn record(
        &self,
        trace: &'t Trace<'t, S>,
        value: S,
        slopes: impl IntoIterator<Item = S>,
    ) -> Traced<'t, S> {
        let (end, terms) = trace.take(self.count.get());
        let mut terms = terms.iter();
        for (operand, slope) in self.places.iter().zip(slopes) {
            let Some(term) = terms.next() else { break };
            let mark = if terms.len() == 0 { LAST } else { 0 };
            term.set(Term { operand: operand.get() | mark, slope });
        }
        Traced::at(value, end - 1, trace)
    }

    /// In `K` directions, recorded.
    #[inline]
    fn derive<O: Operation<Traced<'t, S>>, const K: usize>(
        &self,
        operation: O,
        trace: &'t Trace<'t, S>,
    ) -> O::Output {
        let met = Cell::new(0);
        let number = |number: Traced<'t, S>| {
            if number.place().is_none() {
                return Dual::<S, K>::constant(number.value);
            }
            let direction = met.get();
            met.set(direction + 1);
            Dual::variable(number.value, direction)
        };
        operation.in_numbers(number, |Dual { value, tangents }| self.record(trace, value, tangents))
    }
}

/// [`Real::make`] of recorded numbers.
#[inline(never)]
pub(super) fn make<'t, S: Real, O: Operation<Traced<'t, S>>>(operation: O) -> O::Output {
    let value = |number: Traced<'t, S>| number.value;
    if !O::HAS_DERIVATIVES {
        return operation.in_numbers(value, Traced::constant);
    }
    if O::IS_WIDE {
        return operation.make();
    }
    let active = Active::of(&operation);
    let count = active.count.get();
    let Some(trace) = active.trace.get() else { return operation.in_numbers(value, Traced::constant) };
    if count > MOST {
        return operation.make();
    }
    if !trace.records(operation.results() * count) {
        return operation.in_numbers(value, |value| active.record(trace, value, []));
    }
    match count {
        0..=2 => active.derive::<O, 2>(operation, trace),
        3..=4 => active.derive::<O, 4>(operation, trace),
        5..=8 => active.derive::<O, 8>(operation, trace),
        _ => active.derive::<O, MOST>(operation, trace),
    }
}
