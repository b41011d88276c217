//! Stages of an explicit formula, one after another.

use core::ops::Range;

use crate::method::Rates;
use crate::method::rates::each_stage;
use crate::scalar::Scalar;
use crate::system::Rate;
use crate::vector::Vector;

/// Largest number of states for which stages stay in registers. Copies of the rate for more gain nothing, as in a chain of six
/// bars.
const FEW_STATES: usize = 8;

/// Rows of an explicit formula of `N` stages, up to 16 of them.
pub(in crate::method) trait Rows<const N: usize> {
    /// Times of the stages, as fractions of the step.
    const NODES: [f64; N];

    /// A part of the state `at` a stage, from the state `x` at the beginning of a step `h` and the rates `k` of the stages
    /// before, all counted from 0. Stage `N` is the end of the step.
    fn row<S: Scalar, X: Vector<S>>(stage: usize, part: Range<usize>, from: (&X, S), k: &[X; N], at: &mut X);
}

/// Rates `k` of all stages of a step `h` at `t`, the first of which is known, and the state at its end.
///
/// Coordinates of a stage follow from velocities of earlier stages, not from the last acceleration. They are computed before
/// the rate of the stage, so that processors work on the next pose while they wait for an acceleration. After the rate
/// compilers would pack both into vectors that wait for the later one: a four-bar's evaluation takes a quarter longer.
// The rate's captures (health, system, inputs) stay in registers only if the formula is part of its caller; and the rate,
// unless it is short, becomes part of the formula only if it is called in one place, hence the loop.
#[allow(clippy::inline_always)]
#[inline(always)]
pub(in crate::method) fn stages<M: Rate, R: Rows<N>, const N: usize>(
    (t, h): (M::S, M::S),
    x: &M::X,
    k: &mut [M::X; N],
    rates: &mut impl Rates<M>,
) -> M::X {
    if const { M::SHORT && M::X::LEN <= FEW_STATES } {
        return each_with_its_rate::<M, R, N>((t, h), x, k, rates);
    }
    let mut at = *x;
    for stage in 1..N {
        R::row(stage, 0..M::X::LEN, (x, h), k, &mut at);
        rates.at(time::<M, R, N>((t, h), stage), &at, &mut k[stage]);
    }
    R::row(N, 0..M::X::LEN, (x, h), k, &mut at);
    at
}

/// Makes the stages with a copy of the rate for each.
// A separate function in builds without optimisation, in which the stack of a large system has room for little else.
#[cfg_attr(not(debug_assertions), allow(clippy::inline_always), inline(always))]
fn each_with_its_rate<M: Rate, R: Rows<N>, const N: usize>(
    (t, h): (M::S, M::S),
    x: &M::X,
    k: &mut [M::X; N],
    rates: &mut impl Rates<M>,
) -> M::X {
    let mut at = *x;
    let (coordinates, rest) = (0..M::NQ, M::NQ..M::X::LEN);
    R::row(1, coordinates.clone(), (x, h), k, &mut at);
    each_stage!(stage < N in [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15] {
        R::row(stage, rest.clone(), (x, h), k, &mut at);
        for i in coordinates.clone() {
            k[stage].set(i, at.at(M::NQ + i));
        }
        let mut next = at;
        R::row(stage + 1, coordinates.clone(), (x, h), k, &mut next);
        rates.at(time::<M, R, N>((t, h), stage), &at, &mut k[stage]);
        at = next;
    });
    R::row(N, rest, (x, h), k, &mut at);
    at
}

/// Time of a stage.
#[inline]
fn time<M: Rate, R: Rows<N>, const N: usize>((t, h): (M::S, M::S), stage: usize) -> M::S {
    M::S::lit(R::NODES[stage]).mul_add(h, t)
}
