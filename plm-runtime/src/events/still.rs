//! What comes to zero nowhere in a step, by one enclosure of all guards and kinks: most steps need no other look.

use crate::method::{Course, Path};
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::tube::Tube;
use crate::vector::Vector;

/// Of which nothing comes to zero in a step.
#[derive(Clone, Copy)]
pub(super) struct Still {
    /// All guards stay on their sides.
    pub(super) guards: bool,
    /// No kink changes its sign.
    pub(super) kinks: bool,
}

impl Still {
    /// Nothing is known.
    pub(super) const UNKNOWN: Self = Self { guards: false, kinks: false };

    /// By the ranges of all of them over a step with this dense output.
    pub(super) fn over<M: System<S: Real>>(course: &Course<'_, M>, path: &Path<M::S, M::X>) -> Self {
        let (half, zero) = (M::S::lit(0.5), M::S::ZERO);
        let (time, x) = path.around(half, half);
        let mut still = Self { guards: true, kinks: true };
        let known = course.system.guards_within(time, &course.held, &x, &mut |i, tube: Tube<M::S>| {
            let range = tube.range(half);
            // Comparisons with what is not a number are false.
            if i < M::G::LEN {
                still.guards &= range.low >= -course.system.band(i);
            } else {
                still.kinks &= range.low > zero || range.high <= zero;
            }
        });
        if known { still } else { Self::UNKNOWN }
    }
}
