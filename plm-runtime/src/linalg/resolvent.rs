//! The linear systems of implicit methods: (lambda I - J) k = r.

use super::complex::{Both, Complex, Entry};
use super::lu::Lu;
use crate::scalar::Real;
use crate::vector::Vector;
use crate::words::Words;

/// Vectors over which there are square matrices.
pub trait Dense<S: Real>: Vector<S> {
    /// A square matrix.
    type Matrix: Copy;

    /// All zeros.
    fn zeros() -> Self::Matrix;
    /// The entry in row `i` and column `j`; zero beyond the end.
    fn entry(matrix: &Self::Matrix, i: usize, j: usize) -> S;
    /// Gives an entry a value; nothing happens beyond the end.
    fn set_entry(matrix: &mut Self::Matrix, i: usize, j: usize, s: S);
}

/// Derivatives of a rate over vectors `X`, in a form in which (lambda I - J) k = r is solved.
pub trait Derivatives<S: Real, X: Dense<S>>: Clone {
    /// A decomposed lambda I - J.
    type Resolvent<T: Entry<S>>: Clone;

    /// All zeros.
    fn zeros() -> Self;
    /// Room for a decomposed matrix.
    fn room<T: Entry<S>>(&self) -> Self::Resolvent<T>;
    /// Decomposes lambda I - J where it is to stay, where the first `nq` rows of J say q' = v; false if it is singular.
    #[must_use]
    fn decompose<T: Entry<S>>(&self, lambda: T, nq: usize, into: &mut Self::Resolvent<T>) -> bool;
    /// As [`decompose`](Self::decompose), by value; `None` if it is singular.
    #[inline]
    fn resolvent<T: Entry<S>>(&self, lambda: T, nq: usize) -> Option<Self::Resolvent<T>> {
        let mut resolvent = self.room();
        self.decompose(lambda, nq, &mut resolvent).then_some(resolvent)
    }
    /// Solves (lambda I - J) k = r with the matrix that was decomposed; gives `each` every index and its k.
    fn resolve<T: Entry<S>>(
        &self,
        resolvent: &Self::Resolvent<T>,
        nq: usize,
        r: impl FnMut(usize) -> T,
        each: impl FnMut(usize, T),
    );
    /// Solves for a real and for a complex lambda, each with a right-hand side of its own.
    fn resolve_both(
        &self,
        (real, complex): (&Self::Resolvent<S>, &Self::Resolvent<Complex<S>>),
        nq: usize,
        mut r: impl FnMut(usize) -> Both<S>,
        mut each: impl FnMut(usize, Both<S>),
    ) {
        let mut first = X::fill(S::ZERO);
        self.resolve(real, nq, |i| r(i).real, |i, k| first.set(i, k));
        self.resolve(
            complex,
            nq,
            |i| r(i).complex,
            |i, complex| each(i, Both { real: first.at(i), complex }),
        );
    }
    /// The matrix J, if it is stored as such.
    fn full(&mut self) -> Option<&mut X::Matrix>;
    /// Shows all numbers, always as many.
    fn in_words(&mut self, words: &mut impl Words);
}

/// lambda I - J, decomposed in the unknowns that q' = v leaves.
///
/// With x = (q, w), w = (v, first-order states), the first rows say lambda k_q - k_v = r_q. Eliminated, there remains
/// (lambda I - J_ww - J_wq \[I 0\] / lambda) k_w = r_w + J_wq r_q / lambda: half of the unknowns of a mechanism, an eighth
/// of the operations (E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, IV.8, "special structure").
#[derive(Clone, Copy, Debug)]
pub struct Resolvent<T, const N: usize> {
    /// 1 / lambda.
    pub(super) inverse: T,
    pub(super) lu: Lu<T, N>,
}

impl<S: Real, const N: usize> Dense<S> for [S; N] {
    type Matrix = [[S; N]; N];

    #[inline]
    fn zeros() -> [[S; N]; N] {
        [[S::ZERO; N]; N]
    }

    #[inline]
    fn entry(matrix: &[[S; N]; N], i: usize, j: usize) -> S {
        matrix.get(i).map_or(S::ZERO, |row| row.at(j))
    }

    #[inline]
    fn set_entry(matrix: &mut [[S; N]; N], i: usize, j: usize, s: S) {
        if let Some(row) = matrix.get_mut(i) {
            row.set(j, s);
        }
    }
}

impl<S: Real, const N: usize> Derivatives<S, [S; N]> for [[S; N]; N] {
    type Resolvent<T: Entry<S>> = Resolvent<T, N>;

    #[inline]
    fn zeros() -> Self {
        [[S::ZERO; N]; N]
    }

    fn room<T: Entry<S>>(&self) -> Resolvent<T, N> {
        Resolvent { inverse: T::real(S::ZERO), lu: Lu::room() }
    }

    fn decompose<T: Entry<S>>(&self, lambda: T, nq: usize, into: &mut Resolvent<T, N>) -> bool {
        let inverse = lambda.reciprocal();
        into.inverse = inverse;
        let rows = &mut into.lu.rows;
        for (i, (row, rates)) in rows.iter_mut().zip(self.iter().skip(nq)).enumerate() {
            for (entry, by_w) in row.iter_mut().zip(rates.iter().skip(nq)) {
                *entry = T::real(-*by_w);
            }
            for (entry, by_q) in row.iter_mut().zip(rates).take(nq) {
                *entry = entry.less_product(inverse, T::real(*by_q));
            }
            if let Some(diagonal) = row.get_mut(i) {
                *diagonal = *diagonal + lambda;
            }
        }
        into.lu.decompose(N - nq.min(N))
    }

    fn resolve<T: Entry<S>>(
        &self,
        resolvent: &Resolvent<T, N>,
        nq: usize,
        mut r: impl FnMut(usize) -> T,
        mut each: impl FnMut(usize, T),
    ) {
        let Resolvent { inverse, lu } = resolvent;
        let zero = T::real(S::ZERO);
        let (mut kq, mut kw) = ([zero; N], [zero; N]);
        for (i, k) in kq.iter_mut().enumerate().take(nq) {
            *k = r(i) * *inverse;
        }
        for ((i, k), rates) in kw.iter_mut().enumerate().zip(self.iter().skip(nq)) {
            let known = rates.iter().zip(&kq).take(nq);
            *k = known.fold(r(nq + i), |sum, (by_q, k)| sum + T::real(*by_q) * *k);
        }
        lu.solve(&mut kw);
        for (i, (kq, kv)) in kq.iter().zip(&kw).enumerate().take(nq) {
            each(i, *kq + *kv * *inverse);
        }
        for (i, k) in kw.iter().enumerate().take(N.saturating_sub(nq)) {
            each(nq + i, *k);
        }
    }

    #[inline]
    fn full(&mut self) -> Option<&mut [[S; N]; N]> {
        Some(self)
    }

    fn in_words(&mut self, words: &mut impl Words) {
        for row in self {
            words.numbers(row);
        }
    }
}
