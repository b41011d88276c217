//! Numbers that record what was done with them, and their record: derivatives are found backward along it.
//!
//! Reverse mode of automatic differentiation (A. Griewank, A. Walther, Evaluating Derivatives, 2nd ed., SIAM 2008, 3.2). The record stands
//! in memory that the caller gives. An operation takes one [`Term`] of it for each operand that depends on a variable; what depends on none is
//! a constant, and takes nothing.

mod operation;
mod scalar;
mod sum;
mod traced;

pub use traced::Traced;

use core::cell::Cell;

use crate::scalar::Real;

/// A partial derivative of an operation by one of its operands.
#[derive(Clone, Copy, Debug)]
pub struct Term<S = f64> {
    /// The place of the operand; [`LAST`] is added in the last term of an operation.
    operand: u64,
    slope: S,
}

/// A mark in places of operands: this term is the last one of its operation.
const LAST: u64 = 1 << 63;

impl<S: Real> Term<S> {
    /// A term of memory that is not used yet.
    pub const EMPTY: Self = Self { operand: 0, slope: S::ZERO };
}

/// A record of operations, in the order in which they were made.
///
/// Variables have the first places. An operation has the place of its last term, counted on while nothing is recorded: whatever is computed
/// once more from the same numbers has the same places.
pub struct Trace<'t, S = f64> {
    terms: &'t [Cell<Term<S>>],
    variables: u64,
    /// The place of the next term.
    next: Cell<u64>,
    /// Range of places whose terms are recorded, with their index in the memory.
    window: Cell<Window>,
}

/// A range of places that is recorded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Window {
    /// The first place.
    pub(crate) first: u64,
    /// The place after the last one for which there is room.
    pub(crate) end: u64,
    /// The place of the memory's first term, as if all of it were of this range.
    pub(crate) base: u64,
}

impl Window {
    /// Nothing.
    const NONE: Self = Self { first: 0, end: 0, base: 0 };
}

impl<'t, S: Real> Trace<'t, S> {
    /// A record in this memory, of what is computed from so many variables.
    pub fn new(memory: &'t mut [Term<S>], variables: usize) -> Self {
        let variables = variables as u64;
        let terms = Cell::from_mut(memory).as_slice_of_cells();
        let window = Window { first: variables, end: variables + terms.len() as u64, base: variables };
        Self { terms, variables, next: Cell::new(variables), window: Cell::new(window) }
    }

    /// The variable with this index; a constant where there are fewer.
    #[inline]
    pub fn variable(&'t self, value: S, index: usize) -> Traced<'t, S> {
        match index as u64 {
            place if place < self.variables => Traced::at(value, place, self),
            _ => Traced::constant(value),
        }
    }

    /// How many variables there are.
    pub fn variables(&self) -> usize {
        self.variables as usize
    }

    /// Terms of all operations so far, recorded or counted.
    pub fn terms(&self) -> usize {
        (self.next.get() - self.variables) as usize
    }

    /// Terms for which there is room.
    pub fn room(&self) -> usize {
        self.terms.len()
    }

    /// The place of the next term.
    pub(crate) fn next(&self) -> u64 {
        self.next.get()
    }

    /// Counts on from a place.
    pub(crate) fn go_to(&self, place: u64) {
        self.next.set(place);
    }

    /// Records from a place on, in the memory after so many terms, which stay.
    pub(crate) fn record(&self, first: u64, after: u64) {
        let end = first.saturating_add((self.terms.len() as u64).saturating_sub(after));
        self.window.set(Window { first, end, base: first - after });
    }

    /// Records nothing.
    pub(crate) fn pause(&self) {
        self.window.set(Window::NONE);
    }

    /// Records an operation with partial derivatives by operands in these places, and gives its place.
    #[inline]
    fn push<const N: usize>(&self, operands: [(u64, S); N]) -> u64 {
        let (end, terms) = self.take(N);
        for (k, (term, (operand, slope))) in terms.iter().zip(operands).enumerate() {
            let mark = if k + 1 == N { LAST } else { 0 };
            term.set(Term { operand: operand | mark, slope });
        }
        end - 1
    }

    /// The place after the next operation of so many terms, and their memory; none where nothing is recorded.
    #[inline]
    fn take(&self, count: usize) -> (u64, &'t [Cell<Term<S>>]) {
        let next = self.next.get();
        let end = next + count as u64;
        self.next.set(end);
        let window = self.window.get();
        if end <= window.end {
            let index = (next - window.base) as usize;
            if let Some(terms) = self.terms.get(index..index + count) {
                return (end, terms);
            }
        }
        (end, &[])
    }

    /// Is an operation of so many terms recorded?
    #[inline]
    fn records(&self, count: usize) -> bool {
        self.next.get() + count as u64 <= self.window.get().end
    }

    /// Gives `each` the terms in a range of the memory, the last one first: its index, whether it is the last one of its operation, the place of
    /// its operand and its partial derivative.
    #[inline]
    pub(crate) fn backward(
        &self,
        indices: core::ops::Range<usize>,
        mut each: impl FnMut(usize, bool, u64, S),
    ) {
        let Some(mut terms) = self.terms.get(indices.clone()) else { return };
        while let Some((term, before)) = terms.split_last() {
            terms = before;
            let Term { operand, slope } = term.get();
            each(indices.start + terms.len(), operand & LAST != 0, operand & !LAST, slope);
        }
    }
}
