//! Scales of contact rows: smaller values are rounding.

use super::multipliers::multipliers;
use super::rows::{Rows, indices};
use super::{Contacts, Modal};
use crate::enclosure::{Enclosed, Interval};
use crate::scalar::{Real, Scalar};
use crate::vector::Vector;

/// Rate, in roundings of the largest one before the impacts of the event, below which it is zero.
const RATE_ULPS: f64 = 4096.0;

/// Speed that the accelerations of the rows give over the length of the mechanism.
pub(super) fn speed<M: Contacts<N>, const N: usize>(system: &M, rows: &Rows<M::S, N>, u: &M::U) -> M::S {
    (acceleration::<M, N>(rows, u) * system.length()).sqrt()
}

/// Largest term of the accelerations of the rows, with the forces of the modes before the event.
pub(super) fn acceleration<M: Contacts<N>, const N: usize>(rows: &Rows<M::S, N>, u: &M::U) -> M::S {
    let lambda = multipliers(rows, &u.modes().of).map_or([M::S::ZERO; N], |found| found.lambda);
    indices::<N>().fold(M::S::ZERO, |largest, i| {
        let terms = rows.delassus[i].iter().zip(&lambda);
        terms.fold(largest.max(rows.free[i].abs()), |largest, (d, lambda)| largest.max((*d * *lambda).abs()))
    })
}

/// Rounding of velocities, in units in the last place.
const VELOCITY_ULPS: f64 = 16.0;

/// Error of the rates by rounding of the velocities: if bodies move on together, rates are small differences of large velocities.
pub(super) fn rounding_of_velocities<M: Contacts<N>, const N: usize>(
    system: &M,
    (t, u): (M::S, &M::U),
    x: &M::X,
) -> M::S {
    let ulps = M::S::lit(VELOCITY_ULPS) * M::S::EPSILON;
    let rounded = |i: usize| {
        let is_velocity = (M::NQ..2 * M::NQ).contains(&i);
        let size = if is_velocity { ulps * x.at(i).abs() } else { M::S::ZERO };
        Enclosed { slope: Interval { low: -size, high: size }, ..Enclosed::constant(x.at(i)) }
    };
    let rows = system.kinematics(Enclosed::constant(t), u, &rounded, &Enclosed::constant);
    let sizes = rows.rate.iter().map(|rate| rate.slope.size()).filter(|size| size.is_finite());
    sizes.fold(M::S::ZERO, M::S::max)
}

/// Rounding of the rates.
pub(super) fn rounding<S: Real, const N: usize>(rows: &Rows<S, N>) -> S {
    let largest = rows.rate.iter().fold(S::ZERO, |largest, rate| largest.max(rate.abs()));
    S::lit(RATE_ULPS) * S::EPSILON * largest
}
