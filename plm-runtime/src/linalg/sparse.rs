//! Augmented linear systems whose pattern the compiler found: elimination in work that grows with the number of entries.

use core::marker::PhantomData;

use super::complex::{Both, Complex, Entry};
use super::resolvent::{Dense, Derivatives};
use crate::scalar::Real;
use crate::words::Words;

/// Factor of a coefficient of an augmented system: the unknown or one of its derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The unknown itself: a first-order state, or one that is neither state nor coordinate.
    Value,
    /// The rate of a first-order state.
    Rate,
    /// A coordinate.
    Position,
    /// Its rate.
    Velocity,
    /// Its second derivative.
    Acceleration,
}

/// A coefficient in an equation.
#[derive(Clone, Copy, Debug)]
pub struct Term {
    /// Place of the coefficient.
    pub coefficient: u32,
    /// The equation.
    pub row: u32,
    /// The unknown: coordinates first, then first-order states, then all others.
    pub column: u32,
    /// Index of the entry of this row and column.
    pub entry: u32,
    /// Factor of the coefficient: the unknown or one of its derivatives.
    pub part: Part,
}

/// An entry below a pivot, in its column.
#[derive(Clone, Copy, Debug)]
pub struct Below {
    /// The equation.
    pub row: u32,
    /// Place of the entry.
    pub entry: u32,
    /// Place of the entry of this unknown in the equation of the pivot; beyond the end if there is none.
    pub across: u32,
}

/// A pivot, with the entries below and right of it at its turn in the elimination.
#[derive(Clone, Copy, Debug)]
pub struct Pivot {
    /// The equation, and the unknown that it is solved for.
    pub row: u32,
    /// Place of the entry.
    pub entry: u32,
    /// Begin and end of the pivot's part of [`Pattern::below`].
    pub below: [u32; 2],
    /// Begin and end of its part of [`Pattern::right`].
    pub right: [u32; 2],
    /// Begin of its part of [`Pattern::targets`]: below by below, right by right.
    pub targets: u32,
}

/// Which entries there are, and in which order unknowns are eliminated.
#[derive(Clone, Copy, Debug)]
pub struct Pattern {
    /// Number of coordinates.
    pub coordinates: u32,
    /// Number of first-order states.
    pub states: u32,
    /// All coefficients where they stand.
    pub terms: &'static [Term],
    /// The pivots in the order of elimination.
    pub pivots: &'static [Pivot],
    /// Entries below pivots.
    pub below: &'static [Below],
    /// Entries right of pivots: unknown, place.
    pub right: &'static [[u32; 2]],
    /// Places of the entries that elimination changes.
    pub targets: &'static [u32],
}

/// The pattern that belongs to a mechanism.
pub trait Patterned: Copy {
    /// The pattern.
    const PATTERN: Pattern;
}

/// Linearised equations of motion before anything is eliminated, as `COEFFICIENTS` numbers.
///
/// Beside coordinates and first-order states they have unknowns that tie neighbours only (accelerations of bodies, forces in joints), so
/// that there are few entries, and eliminating outwards to inwards makes few more: along a chain the work grows with the number of bodies,
/// while df/dx is full (R. Featherstone, Rigid Body Dynamics Algorithms, 2008, 8.8, on branch-induced sparsity; I. S. Duff, A. M. Erisman,
/// J. K. Reid, Direct Methods for Sparse Matrices, 1986, chapter 10).
#[derive(Clone, Copy, Debug)]
pub struct Sparse<S, P, const COEFFICIENTS: usize, const ENTRIES: usize, const UNKNOWNS: usize> {
    /// The coefficients.
    pub coefficients: [S; COEFFICIENTS],
    pattern: PhantomData<P>,
}

/// An eliminated augmented system for one lambda.
#[derive(Clone, Copy, Debug)]
pub struct Eliminated<T, const ENTRIES: usize> {
    /// L below the pivots, U right of them, reciprocals in their place.
    entries: [T; ENTRIES],
    /// 1 / lambda.
    inverse: T,
}

/// Pivots below this multiple of rounding, measured by what they were made of, are nothing but rounding.
const ROUNDING: f64 = 64.0;

impl<S: Real, P: Patterned, X: Dense<S>, const C: usize, const E: usize, const U: usize> Derivatives<S, X>
    for Sparse<S, P, C, E, U>
{
    type Resolvent<T: Entry<S>> = Eliminated<T, E>;

    fn zeros() -> Self {
        Self { coefficients: [S::ZERO; C], pattern: PhantomData }
    }

    fn room<T: Entry<S>>(&self) -> Eliminated<T, E> {
        let zero = T::real(S::ZERO);
        Eliminated { entries: [zero; E], inverse: zero }
    }

    /// With the unknowns v for q' = v, lambda q - v = r_q, and s for the first-order states, an equation
    /// `c_q q + c_v v + c_a v' + c_s s + c_r s' + c z = 0` of the derivatives says
    /// `(c_q / lambda + c_v + lambda c_a) v + (c_s + lambda c_r) s + c z = -c_q r_q / lambda + c_a r_v + c_r r_s`.
    fn decompose<T: Entry<S>>(&self, lambda: T, _nq: usize, into: &mut Eliminated<T, E>) -> bool {
        into.inverse = lambda.reciprocal();
        into.entries = [T::real(S::ZERO); E];
        let inverses = (lambda, into.inverse);
        decompose((&P::PATTERN, &self.coefficients), inverses, &mut into.entries, &mut [S::ZERO; U])
    }

    fn resolve<T: Entry<S>>(
        &self,
        resolvent: &Eliminated<T, E>,
        nq: usize,
        r: impl FnMut(usize) -> T,
        each: impl FnMut(usize, T),
    ) {
        let entry = |place| at::<S, T>(&resolvent.entries, place);
        let zero = T::real(S::ZERO);
        let (mut knowns, mut b) = ([[zero; U]; 3], [zero; U]);
        let work = Work::of(&mut knowns, &mut b);
        solve((&P::PATTERN, &self.coefficients), (entry, resolvent.inverse), nq, (r, each), work);
    }

    /// Traverses the pattern once, which costs more than the arithmetic.
    fn resolve_both(
        &self,
        (real, complex): (&Eliminated<S, E>, &Eliminated<Complex<S>, E>),
        nq: usize,
        r: impl FnMut(usize) -> Both<S>,
        each: impl FnMut(usize, Both<S>),
    ) {
        let entry = |place| Both {
            real: at::<S, S>(&real.entries, place),
            complex: at::<S, Complex<S>>(&complex.entries, place),
        };
        let inverse = Both { real: real.inverse, complex: complex.inverse };
        let zero = Both::real(S::ZERO);
        let (mut knowns, mut b) = ([[zero; U]; 3], [zero; U]);
        let work = Work::of(&mut knowns, &mut b);
        solve((&P::PATTERN, &self.coefficients), (entry, inverse), nq, (r, each), work);
    }

    fn full(&mut self) -> Option<&mut X::Matrix> {
        None
    }

    fn in_words(&mut self, words: &mut impl Words) {
        words.numbers(&mut self.coefficients);
    }
}

/// The entry at a place; zero beyond the end.
pub fn at<S: Real, T: Entry<S>>(entries: &[T], place: u32) -> T {
    entries.get(place as usize).copied().unwrap_or(T::real(S::ZERO))
}

/// A part of a list; nothing if it is beyond the end.
fn part<T>(list: &[T], [from, to]: [u32; 2]) -> &[T] {
    list.get(from as usize..to as usize).unwrap_or(&[])
}

/// The entries, which are zeros at first, for a lambda and its reciprocal, eliminated; false where a pivot is nothing but rounding, or not
/// finite. `made_of`, zeros at first, has room for as many numbers as there are unknowns.
#[inline]
#[must_use]
pub fn decompose<S: Real, T: Entry<S>>(
    (pattern, coefficients): (&Pattern, &[S]),
    (lambda, inverse): (T, T),
    entries: &mut [T],
    made_of: &mut [S],
) -> bool {
    for term in pattern.terms {
        let coefficient = at::<S, S>(coefficients, term.coefficient);
        let value = match term.part {
            Part::Value | Part::Velocity => T::real(coefficient),
            Part::Rate | Part::Acceleration => lambda.times(coefficient),
            Part::Position => inverse.times(coefficient),
        };
        if let Some(entry) = entries.get_mut(term.entry as usize) {
            *entry = *entry + value;
        }
    }
    eliminate(pattern, entries, made_of).is_some()
}

/// L U in the order of the pattern; none where a pivot is nothing but rounding, or not finite.
fn eliminate<S: Real, T: Entry<S>>(pattern: &Pattern, entries: &mut [T], made_of: &mut [S]) -> Option<()> {
    for pivot in pattern.pivots {
        let size = at::<S, T>(entries, pivot.entry).size();
        let made_of_it = made_of.get(pivot.row as usize).copied().unwrap_or(S::ZERO);
        if !size.is_finite() || size <= S::lit(ROUNDING) * S::EPSILON * made_of_it {
            return None;
        }
        let reciprocal = at::<S, T>(entries, pivot.entry).reciprocal();
        *entries.get_mut(pivot.entry as usize)? = reciprocal;
        let right = part(pattern.right, pivot.right);
        let mut targets = pattern.targets.get(pivot.targets as usize..)?;
        for below in part(pattern.below, pivot.below) {
            let factor = at::<S, T>(entries, below.entry) * reciprocal;
            *entries.get_mut(below.entry as usize)? = factor;
            if let Some(made_of) = made_of.get_mut(below.row as usize) {
                *made_of = made_of.max((factor * at::<S, T>(entries, below.across)).size());
            }
            let (own, rest) = targets.split_at_checked(right.len())?;
            targets = rest;
            for ([_, place], target) in right.iter().zip(own) {
                let across = at::<S, T>(entries, *place);
                let target = entries.get_mut(*target as usize)?;
                *target = target.less_product(factor, across);
            }
        }
    }
    Some(())
}

/// Room for a solution, zeros at first.
#[derive(Debug)]
pub struct Work<'a, T> {
    /// Of each coordinate r_q, and the factor of the coefficients of its position.
    of_positions: [&'a mut [T]; 2],
    /// Factors of the coefficients of second derivatives and rates.
    by_rate: &'a mut [T],
    /// The right-hand side of each equation, later its unknown.
    b: &'a mut [T],
}

impl<'a, T> Work<'a, T> {
    /// In arrays.
    pub fn of<const K: usize>([r_q, by_position, by_rate]: &'a mut [[T; K]; 3], b: &'a mut [T]) -> Self {
        Work { of_positions: [r_q, by_position], by_rate, b }
    }
}

/// Solves an eliminated system of these entries, where `inverse` is 1 / lambda.
#[inline]
pub fn solve<S: Real, T: Entry<S>>(
    (pattern, coefficients): (&Pattern, &[S]),
    (entry, inverse): (impl Fn(u32) -> T, T),
    nq: usize,
    (mut r, mut each): (impl FnMut(usize) -> T, impl FnMut(usize, T)),
    Work { of_positions: [r_q, by_position], by_rate, b }: Work<'_, T>,
) {
    let (n, zero) = (pattern.coordinates as usize, T::real(S::ZERO));
    let rates = n + pattern.states as usize;
    // What columns are multiplied by stands in many terms.
    for (i, (r_q, known)) in r_q.iter_mut().zip(by_position.iter_mut()).enumerate().take(n) {
        *r_q = r(i);
        *known = zero - *r_q * inverse;
    }
    for (i, known) in by_rate.iter_mut().enumerate().take(rates) {
        *known = r(nq + i);
    }
    for term in pattern.terms {
        let knowns: &[T] = match term.part {
            Part::Value | Part::Velocity => continue,
            Part::Position => by_position,
            Part::Acceleration | Part::Rate => by_rate,
        };
        let coefficient = at::<S, S>(coefficients, term.coefficient);
        if let Some(b) = b.get_mut(term.row as usize) {
            *b = *b + at::<S, T>(knowns, term.column).times(coefficient);
        }
    }
    substitute(pattern, entry, b);
    for (i, (r_q, v)) in r_q.iter().zip(&*b).enumerate().take(n) {
        each(i, (*r_q + *v) * inverse);
    }
    for (i, k) in b.iter().enumerate().take(rates) {
        each(nq + i, *k);
    }
}

/// Solves L U y = b in place.
#[inline]
fn substitute<S: Real, T: Entry<S>>(pattern: &Pattern, entry: impl Fn(u32) -> T, b: &mut [T]) {
    for pivot in pattern.pivots {
        let known = at::<S, T>(b, pivot.row);
        for below in part(pattern.below, pivot.below) {
            if let Some(b) = b.get_mut(below.row as usize) {
                *b = b.less_product(entry(below.entry), known);
            }
        }
    }
    for pivot in pattern.pivots.iter().rev() {
        let mut rest = at::<S, T>(b, pivot.row);
        for [column, place] in part(pattern.right, pivot.right) {
            rest = rest.less_product(entry(*place), at::<S, T>(b, *column));
        }
        if let Some(b) = b.get_mut(pivot.row as usize) {
            *b = rest * entry(pivot.entry);
        }
    }
}
