//! Derivatives that are sparse where elimination is healthy, and a full matrix where it is not.

use super::complex::{Both, Complex, Entry};
use super::resolvent::{Dense, Derivatives};
use crate::scalar::Real;
use crate::words::Words;

/// One of two forms of derivatives; the second holds the full matrix.
#[derive(Clone, Copy, Debug)]
pub enum Mixed<A, B> {
    /// The form that costs less.
    Sparse(A),
    /// The form that a solution by rank can also give.
    Full(B),
}

impl<S: Real, X: Dense<S>, A: Derivatives<S, X>, B: Derivatives<S, X>> Derivatives<S, X> for Mixed<A, B> {
    type Resolvent<T: Entry<S>> = Mixed<A::Resolvent<T>, B::Resolvent<T>>;

    fn zeros() -> Self {
        Mixed::Sparse(A::zeros())
    }

    fn room<T: Entry<S>>(&self) -> Self::Resolvent<T> {
        match self {
            Mixed::Sparse(sparse) => Mixed::Sparse(sparse.room()),
            Mixed::Full(full) => Mixed::Full(full.room()),
        }
    }

    fn decompose<T: Entry<S>>(&self, lambda: T, nq: usize, into: &mut Self::Resolvent<T>) -> bool {
        match (self, &*into) {
            (Mixed::Sparse(_), Mixed::Sparse(_)) | (Mixed::Full(_), Mixed::Full(_)) => {}
            _ => *into = self.room(),
        }
        match (self, into) {
            (Mixed::Sparse(sparse), Mixed::Sparse(into)) => sparse.decompose(lambda, nq, into),
            (Mixed::Full(full), Mixed::Full(into)) => full.decompose(lambda, nq, into),
            _ => false,
        }
    }

    fn resolve<T: Entry<S>>(
        &self,
        resolvent: &Self::Resolvent<T>,
        nq: usize,
        r: impl FnMut(usize) -> T,
        each: impl FnMut(usize, T),
    ) {
        match (self, resolvent) {
            (Mixed::Sparse(sparse), Mixed::Sparse(resolvent)) => sparse.resolve(resolvent, nq, r, each),
            (Mixed::Full(full), Mixed::Full(resolvent)) => full.resolve(resolvent, nq, r, each),
            // A resolvent of the other form belongs to other derivatives.
            _ => {}
        }
    }

    fn resolve_both(
        &self,
        (real, complex): (&Self::Resolvent<S>, &Self::Resolvent<Complex<S>>),
        nq: usize,
        r: impl FnMut(usize) -> Both<S>,
        each: impl FnMut(usize, Both<S>),
    ) {
        match (self, real, complex) {
            (Mixed::Sparse(sparse), Mixed::Sparse(real), Mixed::Sparse(complex)) => {
                sparse.resolve_both((real, complex), nq, r, each);
            }
            (Mixed::Full(full), Mixed::Full(real), Mixed::Full(complex)) => {
                full.resolve_both((real, complex), nq, r, each);
            }
            // As above.
            _ => {}
        }
    }

    fn full(&mut self) -> Option<&mut X::Matrix> {
        if let Mixed::Sparse(_) = self {
            *self = Mixed::Full(B::zeros());
        }
        match self {
            Mixed::Full(full) => full.full(),
            Mixed::Sparse(_) => None,
        }
    }

    /// Both forms, of which the unused one is zero.
    fn in_words(&mut self, words: &mut impl Words) {
        let (mut is_full, mut sparse, mut full) = match self {
            Mixed::Sparse(sparse) => (false, sparse.clone(), B::zeros()),
            Mixed::Full(full) => (true, A::zeros(), full.clone()),
        };
        words.flag(&mut is_full);
        sparse.in_words(words);
        full.in_words(words);
        *self = if is_full { Mixed::Full(full) } else { Mixed::Sparse(sparse) };
    }
}
