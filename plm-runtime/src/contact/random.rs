//! Random numbers and rows for tests.

use super::loads::Affine;
use super::rows::{Friction, Limit, Rows};

/// A number in -1 to 1: splitmix64 (G. L. Steele, D. Lea, C. H. Flood, Fast splittable pseudorandom number generators, OOPSLA
/// 2014).
pub(super) fn number(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

/// Three contacts with friction, gaps and frictions in turn, on `M` degrees of freedom: with fewer than six the rows depend on
/// each other.
pub(super) fn contacts<const M: usize>(state: &mut u64, friction: f64) -> Rows<f64, 6> {
    let directions: [[f64; M]; 6] = core::array::from_fn(|_| core::array::from_fn(|_| number(state)));
    let push: [f64; M] = core::array::from_fn(|_| 9.81 * number(state));
    let dot = |a: &[f64; M], b: &[f64; M]| a.iter().zip(b).map(|(a, b)| a * b).sum();
    let mut rows = Rows::none();
    rows.free = core::array::from_fn(|i| dot(&directions[i], &push));
    rows.delassus = core::array::from_fn(|i| core::array::from_fn(|j| dot(&directions[i], &directions[j])));
    for i in [1, 3, 5] {
        rows.kinetic[i] = Friction::both(Limit::of(i - 1, friction));
        rows.adhesion[i] = rows.kinetic[i];
    }
    rows
}

/// Copies rows into arrays that have room for more.
pub(super) fn with_room<const N: usize, const W: usize>(rows: &Rows<f64, N>) -> Rows<f64, W> {
    let mut wide = Rows::none();
    put(&mut wide.gap, &rows.gap);
    put(&mut wide.rate, &rows.rate);
    put(&mut wide.free, &rows.free);
    put(&mut wide.bias, &rows.bias);
    put(&mut wide.load, &rows.load);
    for i in 0..N {
        put(&mut wide.delassus[i], &rows.delassus[i]);
        put(&mut wide.read[i], &rows.read[i]);
        wide.kinetic[i] = friction(&rows.kinetic[i]);
        wide.adhesion[i] = friction(&rows.adhesion[i]);
        wide.reaction[i] = rows.reaction[i].map(|Affine { own, by }| Affine { own, by: filled(&by, 0.0) });
    }
    wide
}

/// A list, continued with `after`.
pub(super) fn filled<T: Copy, const N: usize, const W: usize>(list: &[T; N], after: T) -> [T; W] {
    core::array::from_fn(|i| list.get(i).copied().unwrap_or(after))
}

/// Bits of the first `count` numbers of a list.
pub(super) fn bits<const W: usize>(numbers: &[f64; W], count: usize) -> impl Iterator<Item = u64> {
    numbers.iter().take(count).map(|number| number.to_bits())
}

fn put<T: Copy>(to: &mut [T], from: &[T]) {
    to[..from.len()].copy_from_slice(from);
}

fn friction<const N: usize, const W: usize>(of: &Friction<f64, N>) -> Friction<f64, W> {
    let limit = |limit: &Limit<f64, N>| Limit {
        own: limit.own,
        by: filled(&limit.by, 0.0),
        share: filled(&limit.share, 0.0),
    };
    Friction { lower: limit(&of.lower), upper: limit(&of.upper) }
}
