//! Rounding errors of guards.

use crate::enclosure::{Enclosed, Interval};
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Rounding of a state and of the time, in units in the last place.
pub(super) const ULPS: f64 = 8.0;

/// Error of each guard by rounding of the state `x` and of a time, up to `end`.
pub(super) fn rounding<M: System<S: Real>>(
    (system, held): (&M, &M::U),
    (time, end): (M::S, M::S),
    x: &M::X,
    here: &M::G,
) -> M::G {
    let ulps = M::S::lit(ULPS) * M::S::EPSILON;
    let rounded = |s: M::S, size: M::S| Enclosed {
        slope: Interval { low: -ulps * size, high: ulps * size },
        ..Enclosed::constant(s)
    };
    let typical = system.typical();
    let size = |i: usize| typical.at(i) + x.at(i).abs();
    let mut noise = here.map(|g| ulps * g.abs());
    system.guards_within(rounded(time, end.abs()), held, &|i| rounded(x.at(i), size(i)), &mut |i, guard| {
        let size = guard.slope.size();
        if i < M::G::LEN && size.is_finite() {
            noise.set(i, noise.at(i) + size);
        }
    });
    noise
}
