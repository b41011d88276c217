//! A pair of formulas from its tableau.

use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Implements [`Rows`](super::Rows) and [`Pair`](super::Pair) for a tableau. Rows have the coefficients that are not zero, each
/// with the stages that they belong to. Only the stages that the error and the dense output need are stored.
///
/// `end` has the weights of the formula that continues the solution. A pair whose last stage is the rate at the end of the step
/// names it after `last`. `error` has the weights of one estimate, or of two that are combined. `rate_at_end` names the rate at the
/// end of the step, after a projection; the stages of `dense` are evaluated if dense output is requested.
macro_rules! pair {
    (
        $(#[$doc:meta])*
        $pair:ident { name: $name:literal, order: $order:literal, rates: $rates:literal, $(#[$why:meta])* rtol: $rtol:literal, $(#[$because:meta])* limits: $limits:expr }
        stages: $stages:literal [$($k:ident),*] at $nodes:expr;
        $($stage:literal: $row:ident [$($of:ident),*];)*
        end: $end:ident [$($end_of:ident),*];
        $(last: $last:ident;)?
        kept: $kept_count:literal [$($kept:ident),*];
        error: $($error:ident),*;
        $(rate_at_end: $rate_at_end:ident;)?
        dense {
            $(stage $more:ident at $node:ident: $more_row:ident [$($more_of:ident),*];)*
            bends: $bends:literal [$($bend:ident),*] of [$($bend_of:ident),*];
        }
    ) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $pair;

        impl $crate::method::embedded::Rows<$stages> for $pair {
            const NODES: [f64; $stages] = $nodes;

            // A separate function in builds without optimisation, as each stage with its rate.
            #[allow(unused_variables, reason = "a stage may count in no row")]
            #[cfg_attr(
                not(debug_assertions),
                allow(clippy::inline_always, reason = "as the stages"),
                inline(always)
            )]
            fn row<S: $crate::Scalar, X: $crate::Vector<S>>(
                stage: usize,
                part: core::ops::Range<usize>,
                (x, h): (&X, S),
                k: &[X; $stages],
                at: &mut X,
            ) {
                let [$($k),*] = k;
                match stage {
                    $($stage => at.shift(part, (x, h), $row, [$($of),*]),)*
                    _ => at.shift(part, (x, h), $end, [$($end_of),*]),
                }
            }
        }

        impl $crate::method::Pair for $pair {
            const NAME: &'static str = $name;
            const ORDER: u32 = $order;
            const EVALUATIONS: u64 = $rates;
            $(#[$why])*
            const RTOL: f64 = $rtol;
            $(#[$because])*
            const LIMITS: $crate::method::Limits = $limits;

            const KEPT: usize = $kept_count;
            type Stages<X: Copy + core::fmt::Debug> = [X; $kept_count];
            type Bends<X: Copy + core::fmt::Debug> = [X; $bends];

            #[inline]
            fn map<X: Copy + core::fmt::Debug, Y: Copy + core::fmt::Debug>(
                k: &[X; $kept_count],
                to: &mut [Y; $kept_count],
                mut each: impl FnMut(&X, &mut Y),
            ) {
                for (k, to) in k.iter().zip(to) {
                    each(k, to);
                }
            }

            fn blank<X: Copy + core::fmt::Debug>(x: X) -> [X; $kept_count] {
                [x; $kept_count]
            }

            #[allow(unused_variables, reason = "not every stage is kept")]
            #[allow(clippy::inline_always, reason = "as the stages")]
            #[inline(always)]
            fn step<M: $crate::Rate>(
                t: M::S,
                h: M::S,
                x: &M::X,
                first: &M::X,
                kept: &mut [M::X; $kept_count],
                mut rates: impl $crate::method::Rates<M>,
            ) -> M::X {
                let mut all = [*first; $stages];
                let end = $crate::method::embedded::stages::<M, Self, $stages>((t, h), x, &mut all, &mut rates);
                let [$($k),*] = &all;
                $(
                    let mut $last = *first;
                    rates.at(t + h, &end, &mut $last);
                    let $last = &$last;
                )?
                *kept = [$(*$kept),*];
                end
            }

            #[allow(unused_variables, reason = "not every pair has the last rate among its stages")]
            #[inline]
            fn rate_at_end<X: Copy + core::fmt::Debug>(kept: &[X; $kept_count]) -> Option<&X> {
                let [$($kept),*] = kept;
                None$(.or(Some($last)))?
            }

            #[inline]
            fn error<S: $crate::Scalar, X: $crate::Vector<S>>(h: S, kept: &[X; $kept_count], (weight, count): (&X, usize)) -> S {
                let weights = $crate::method::embedded::tableau::Weights([$($error),*]);
                $crate::method::embedded::tableau::norm(h, weights.squares(kept, weight), count)
            }

            #[inline]
            fn error_of_values<S: $crate::Real, X: $crate::Vector<S>>(
                h: S::Plain,
                kept: &[X; $kept_count],
                (weight, count): (&X, usize),
            ) -> S::Plain {
                let weights = $crate::method::embedded::tableau::Weights([$($error),*]);
                $crate::method::embedded::tableau::norm(h, weights.plain_squares(kept, weight), count)
            }

            #[inline]
            fn plain_error<S: $crate::Real, X: $crate::Vector<S>>(
                h: S::Plain,
                kept: &[X; $kept_count],
                (weight, count): (&X, usize),
            ) -> S::Plain {
                let weights = $crate::method::embedded::tableau::Weights([$($error),*]);
                $crate::method::embedded::tableau::first_norm(h, weights.plain_squares(kept, weight), count)
            }

            #[allow(unused_variables, unused_mut, reason = "not every stage counts, and some pairs need no more of them")]
            fn bend<M: $crate::System>(
                t: M::S,
                h: M::S,
                x: &M::X,
                kept: &[M::X; $kept_count],
                last: &M::X,
                mut rate: impl FnMut(M::S, &M::X, &mut M::X),
            ) -> [M::X; $bends] {
                let [$($kept),*] = kept;
                $(let $rate_at_end = last;)?
                $(
                    let $more = &$crate::method::embedded::tableau::stage::<M, _>(
                        ($node, (t, h), x), ($more_row, [$($more_of),*]), last, &mut rate
                    );
                )*
                [$($bend),*].map(|weights| $crate::method::embedded::tableau::bend::<M, _>(h, weights, [$($bend_of),*]))
            }
        }
    };
}
pub(in crate::method) use pair;

/// Weights of `N` error estimates over the `K` stages that are stored.
pub(in crate::method) struct Weights<const K: usize, const N: usize>(pub(in crate::method) [[f64; K]; N]);

impl<const K: usize, const N: usize> Weights<K, N> {
    /// Squares of the errors in numbers without derivatives, each component by its `weight`.
    #[inline]
    pub(in crate::method) fn squares<S: Scalar, X: Vector<S>>(&self, k: &[X; K], weight: &X) -> [S; N] {
        self.0.map(|weights| {
            let error = X::weighted(weights, k.each_ref()).map2(weight, |error, weight| error * weight);
            error.fold(S::ZERO, |sum, e| e.mul_add(e, sum))
        })
    }

    /// As [`squares`](Self::squares), of numbers that may have derivatives. The result has none, since it only decides.
    #[inline]
    pub(in crate::method) fn plain_squares<S: Real, X: Vector<S>>(
        &self,
        k: &[X; K],
        weight: &X,
    ) -> [S::Plain; N] {
        if !S::HAS_DERIVATIVES {
            return self.squares(k, weight).map(S::plain);
        }
        self.0.map(|weights| {
            let mut sum = S::Plain::ZERO;
            for i in 0..X::LEN {
                let e = S::Plain::weighted(weights, |j| k[j].at(i).plain()) * weight.at(i).plain();
                sum = e.mul_add(e, sum);
            }
            sum
        })
    }
}

/// Norm of the error of a step of `h` with so many components, by the squares of one estimate or of two.
///
/// Of one it is the root mean square. Of two it is err5^2 / sqrt(err5^2 + 0.01 err3^2): of order 7, and safe where err5 vanishes by chance
/// (Hairer, Nørsett, Wanner I, II.10).
#[inline]
pub(in crate::method) fn norm<S: Scalar, const N: usize>(h: S, squares: [S; N], count: usize) -> S {
    let [fifth, third] = squares[..] else { return first_norm(h, squares, count) };
    let both = S::lit(0.01).mul_add(third, fifth);
    let error = h.abs() * fifth / (S::lit(count as f64) * both).sqrt();
    // Zero stays zero, and NaN stays NaN.
    S::select(S::ZERO.lt(both), error, both)
}

/// Root mean square of the first error.
#[inline]
pub(in crate::method) fn first_norm<S: Scalar, const N: usize>(h: S, squares: [S; N], count: usize) -> S {
    let mean = squares[0] / S::lit(count.max(1) as f64);
    h.abs() * mean.sqrt()
}

/// Rate at a stage of the dense output; `last` is a vector of its size.
#[allow(clippy::inline_always, reason = "the stages stay where they are")]
#[inline(always)]
pub(in crate::method) fn stage<M: System, const K: usize>(
    (node, (t, h), x): (f64, (M::S, M::S), &M::X),
    (row, of): ([f64; K], [&M::X; K]),
    last: &M::X,
    rate: &mut impl FnMut(M::S, &M::X, &mut M::X),
) -> M::X {
    let mut k = *last;
    rate(M::S::lit(node).mul_add(h, t), &x.moved(h, row, of), &mut k);
    k
}

/// A coefficient of the dense output.
#[allow(clippy::inline_always, reason = "as above")]
#[inline(always)]
pub(in crate::method) fn bend<M: System, const K: usize>(h: M::S, weights: [f64; K], of: [&M::X; K]) -> M::X {
    M::X::weighted(weights, of).map(|s| h * s)
}
