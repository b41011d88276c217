//! Fixed arrays of scalars: states and their rates.
//!
//! Generated code names its state type by an associated type, so that no user sees the number of states; methods
//! reach the components through [`Vector`]. Every loop has a constant bound, and no index can fail.
//!
//! Loops count by themselves. `core::array::from_fn` makes a compiler translate six functions for every closure, and an iterator over
//! numbers, or `get`, takes several times as long as the work in it where nothing is optimised.

use core::fmt::Debug;
use core::ops::Range;

use crate::scalar::Scalar;

/// A fixed number of scalars.
pub trait Vector<S: Scalar>: Copy + Debug {
    /// Number of components.
    const LEN: usize;

    /// Every component is `s`.
    fn fill(s: S) -> Self;
    /// Component `i` is `f(i)`.
    fn from_fn(f: impl FnMut(usize) -> S) -> Self;
    /// Component `i`; zero beyond the end.
    fn at(&self, i: usize) -> S;
    /// Gives component `i` the value `s`; nothing happens beyond the end.
    fn set(&mut self, i: usize, s: S);
    /// `f` of each component.
    #[must_use]
    fn map(&self, f: impl FnMut(S) -> S) -> Self;
    /// `f` of each pair of components.
    #[must_use]
    fn map2(&self, other: &Self, f: impl FnMut(S, S) -> S) -> Self;
    /// `f` from the first component to the last, beginning with `start`.
    fn fold<T>(&self, start: T, f: impl FnMut(T, S) -> T) -> T;
    /// Becomes `base + sum of factor * vector`, added in the order of the terms.
    fn combine<const K: usize>(&mut self, base: &Self, terms: [(S, &Self); K]);
    /// `sum of weight * vector`, in the order of the terms, in one pass; the weights are constants.
    #[must_use]
    fn weighted<const K: usize>(weights: [f64; K], vectors: [&Self; K]) -> Self;
    /// `self + h * weighted(...)`, in one pass.
    #[must_use]
    fn moved<const K: usize>(&self, h: S, weights: [f64; K], vectors: [&Self; K]) -> Self;
    /// The components of `part` become those of `x + h * weighted(...)`.
    fn shift<const K: usize>(
        &mut self,
        part: Range<usize>,
        from: (&Self, S),
        weights: [f64; K],
        vectors: [&Self; K],
    );
    /// Adds `sum of factor * vector`, in the order of the terms.
    fn add<const K: usize>(&mut self, terms: [(S, &Self); K]);
    /// Neither infinite nor NaN in any component.
    fn is_finite(&self) -> bool;
}

impl<S: Scalar, const N: usize> Vector<S> for [S; N] {
    const LEN: usize = N;

    #[inline]
    fn fill(s: S) -> Self {
        [s; N]
    }

    #[inline]
    fn from_fn(mut f: impl FnMut(usize) -> S) -> Self {
        let (mut x, mut i) = ([S::lit(0.0); N], 0);
        while i < N {
            x[i] = f(i);
            i += 1;
        }
        x
    }

    #[inline]
    fn at(&self, i: usize) -> S {
        if i < N { self[i] } else { S::lit(0.0) }
    }

    #[inline]
    fn set(&mut self, i: usize, s: S) {
        if i < N {
            self[i] = s;
        }
    }

    #[inline]
    fn map(&self, mut f: impl FnMut(S) -> S) -> Self {
        let (mut x, mut i) = ([S::lit(0.0); N], 0);
        while i < N {
            x[i] = f(self[i]);
            i += 1;
        }
        x
    }

    #[inline]
    fn map2(&self, other: &Self, mut f: impl FnMut(S, S) -> S) -> Self {
        let (mut x, mut i) = ([S::lit(0.0); N], 0);
        while i < N {
            x[i] = f(self[i], other[i]);
            i += 1;
        }
        x
    }

    #[inline]
    fn fold<T>(&self, start: T, mut f: impl FnMut(T, S) -> T) -> T {
        let (mut folded, mut i) = (start, 0);
        while i < N {
            folded = f(folded, self[i]);
            i += 1;
        }
        folded
    }

    #[inline]
    fn combine<const K: usize>(&mut self, base: &Self, terms: [(S, &Self); K]) {
        let mut i = 0;
        while i < N {
            let (mut sum, mut k) = (base[i], 0);
            while k < K {
                let (factor, vector) = terms[k];
                sum = factor.mul_add(vector[i], sum);
                k += 1;
            }
            self[i] = sum;
            i += 1;
        }
    }

    #[inline]
    fn weighted<const K: usize>(weights: [f64; K], vectors: [&Self; K]) -> Self {
        Self::from_fn(|i| S::weighted(weights, |k| vectors[k][i]))
    }

    #[inline]
    fn moved<const K: usize>(&self, h: S, weights: [f64; K], vectors: [&Self; K]) -> Self {
        Self::from_fn(|i| self[i].moved(h, weights, |k| vectors[k][i]))
    }

    #[cfg_attr(
        not(debug_assertions),
        allow(clippy::inline_always, reason = "as the stages, of which it is a part"),
        inline(always)
    )]
    fn shift<const K: usize>(
        &mut self,
        part: Range<usize>,
        (x, h): (&Self, S),
        weights: [f64; K],
        vectors: [&Self; K],
    ) {
        for i in 0..N {
            if part.contains(&i) {
                self[i] = x[i].moved(h, weights, |k| vectors[k][i]);
            }
        }
    }

    #[inline]
    fn add<const K: usize>(&mut self, terms: [(S, &Self); K]) {
        let mut i = 0;
        while i < N {
            let mut k = 0;
            while k < K {
                let (factor, vector) = terms[k];
                self[i] = factor.mul_add(vector[i], self[i]);
                k += 1;
            }
            i += 1;
        }
    }

    #[inline]
    fn is_finite(&self) -> bool {
        if S::HAS_DERIVATIVES {
            return self.iter().all(|s| s.is_finite());
        }
        // Zero times NaN or infinity is NaN; four sums, so that the additions do not wait for each other. They begin with what
        // is neutral: the first addition is none.
        let zero = S::lit(0.0);
        let mut probe = [S::lit(-0.0); 4];
        let (quads, rest) = self.as_chunks::<4>();
        for quad in quads {
            for (sum, s) in probe.iter_mut().zip(quad) {
                *sum = *sum + *s * zero;
            }
        }
        for (sum, s) in probe.iter_mut().zip(rest) {
            *sum = *sum + *s * zero;
        }
        ((probe[0] + probe[2]) + (probe[1] + probe[3])).is_finite()
    }
}
