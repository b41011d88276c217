//! Scales of rows of contact: what is small beside them is rounding.

use super::multipliers::multipliers;
use super::rows::{Rows, indices};
use super::{Contacts, Modal};
use crate::scalar::{Real, Scalar};

/// A rate of so many roundings of the largest one, before the impacts of the event, is none.
const RATE_ULPS: f64 = 4096.0;

/// The speed that the accelerations of the rows give over the length of the mechanism.
pub(super) fn speed<M: Contacts<N>, const N: usize>(system: &M, rows: &Rows<M::S, N>, u: &M::U) -> M::S {
    (acceleration::<M, N>(rows, u) * system.length()).sqrt()
}

/// The largest term of an acceleration of the rows, with the forces of the modes until now.
pub(super) fn acceleration<M: Contacts<N>, const N: usize>(rows: &Rows<M::S, N>, u: &M::U) -> M::S {
    let lambda = multipliers(rows, &u.modes().of).map_or([M::S::ZERO; N], |found| found.lambda);
    indices::<N>().fold(M::S::ZERO, |largest, i| {
        let terms = rows.delassus[i].iter().zip(&lambda);
        terms.fold(largest.max(rows.free[i].abs()), |largest, (d, lambda)| largest.max((*d * *lambda).abs()))
    })
}

/// Rounding of the rates.
pub(super) fn rounding<S: Real, const N: usize>(rows: &Rows<S, N>) -> S {
    let largest = rows.rate.iter().fold(S::ZERO, |largest, rate| largest.max(rate.abs()));
    S::lit(RATE_ULPS) * S::EPSILON * largest
}
