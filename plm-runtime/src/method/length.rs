//! Decides if a step of fixed length is so short that its error needs no estimate, by a few comparisons in every step.
//!
//! For mechanisms with few states the rates of the stages decide, which are in registers. Storing those of many would cost a tenth
//! of a step: for their coordinates the ends of a step decide, of every eighth one as long as these are short, and for their
//! first-order states the rates.

use super::fixed::Formula;
use crate::scalar::{Real, Scalar};
use crate::stats::Stats;
use crate::system::Rate;
use crate::vector::Vector;

/// Velocities and first-order states up to this number are few: to compare their rates costs less than a fiftieth of a step.
const FEW: usize = 4;
/// Number of first steps whose ends are all compared.
const FIRST: u64 = 64;
/// Bits that are zero in the number of a later step whose ends are compared: in every eighth.
const OFTEN: u64 = 7;

/// True if the ends of a step are compared, for mechanisms with many states: in the first steps, in every eighth one after them,
/// and in every one again after a step that was too long.
#[inline]
pub(super) fn is_due<M: Rate>(system: &M, stats: &Stats) -> bool {
    !has_few(moving(system)) && (stats.steps < FIRST || stats.steps & OFTEN == 0 || stats.largest_error > 0.0)
}

/// Number of velocities and first-order states.
#[inline]
fn moving<M: Rate>(system: &M) -> usize {
    system.states() - system.coordinates()
}

/// True if the mechanism has few velocities and first-order states.
#[inline]
pub(super) fn has_few(velocities_and_states: usize) -> bool {
    velocities_and_states <= FEW
}

/// Index of the first state whose rates are compared.
#[inline]
fn first<F: Formula, M: Rate>(has_few: bool) -> usize {
    match has_few {
        true if F::OF_PLACES => 0,
        true => M::NQ,
        false => 2 * M::NQ,
    }
}

/// True if the rates of a step of `h` to `x` differ little ([`Formula::apart`]).
#[allow(clippy::needless_bitwise_bool, reason = "a branch for each state would keep compilers from vectors")]
#[allow(clippy::inline_always, reason = "the rates stay in registers")]
#[inline(always)]
pub(super) fn are_near<F: Formula, M: Rate<S: Real>>(
    system: &M,
    h: M::S,
    x: &M::X,
    stages: &F::Stages<M::X>,
) -> bool {
    let typical = system.typical();
    let apart = F::apart::<M>(h, stages, |i| x.at(i).abs() + typical.at(i));
    // All are compared, so that compilers make vectors of them. False for NaN.
    (first::<F, M>(has_few(moving(system)))..M::X::LEN).fold(true, |all, i| {
        let [apart, most] = apart(i);
        all & (apart <= most)
    })
}

/// Largest excess of the differences that [`are_near`] compares, in any numbers, none of which decides: above zero if they are not
/// near. A state that is NaN is found separately.
pub(super) fn spread<F: Formula, M: Rate>(system: &M, h: M::S, x: &M::X, stages: &F::Stages<M::X>) -> M::S {
    let typical = system.typical();
    let apart = F::apart::<M>(h, stages, |i| x.at(i).abs() + typical.at(i));
    let own = (first::<F, M>(has_few(moving(system)))..M::X::LEN).filter(|i| system.has_number(*i));
    own.fold(M::S::ZERO, |spread, i| {
        let [apart, most] = apart(i);
        spread.max(apart - most)
    })
}

/// True if the positions of a step of `h` between two states are near to those by the trapezoidal rule. A call, since few steps
/// need it: it must not take the registers of all.
#[allow(clippy::needless_bitwise_bool, reason = "a branch for each state would keep compilers from vectors")]
#[inline(never)]
pub(super) fn are_straight<F: Formula, M: Rate<S: Real>>(system: &M, h: M::S, ends: [&M::X; 2]) -> bool {
    let typical = system.typical();
    (0..M::NQ).fold(true, |all, i| {
        let [bend, most] = bend::<F, M>(&typical, h, ends, i);
        all & (bend <= most)
    })
}

/// Distance of a position from that by the trapezoidal rule, and its bound.
#[inline]
fn bend<F: Formula, M: Rate>(typical: &M::X, h: M::S, [from, to]: [&M::X; 2], i: usize) -> [M::S; 2] {
    let (v, half) = (M::NQ + i, M::S::lit(0.5) * h);
    let bend = (to.at(i) - from.at(i)) - half * (from.at(v) + to.at(v));
    [bend.abs(), M::S::lit(F::STRAIGHT) * (from.at(i).abs() + typical.at(i))]
}

/// Both comparisons in numbers of several lanes: above zero in lanes that are not short, zero in others.
#[inline]
pub(crate) fn coarseness<F: Formula, M: Rate>(
    typical: &M::X,
    h: M::S,
    ends: [&M::X; 2],
    stages: &F::Stages<M::X>,
) -> M::S {
    let zero = M::S::lit(0.0);
    let apart = F::apart::<M>(h, stages, |i| ends[1].at(i).abs() + typical.at(i));
    let beyond = |coarse: M::S, [apart, most]: [M::S; 2]| coarse.max(apart - most);
    let has_few = has_few(M::X::LEN - M::NQ);
    let coarse = (first::<F, M>(has_few)..M::X::LEN).fold(zero, |coarse, i| beyond(coarse, apart(i)));
    if has_few {
        return coarse;
    }
    (0..M::NQ).fold(coarse, |coarse, i| beyond(coarse, bend::<F, M>(typical, h, ends, i)))
}
