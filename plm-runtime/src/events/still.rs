//! What comes to zero nowhere in a step, by one enclosure of all guards and kinks: most steps need no other look.

use super::heeded::{Heeded, bit};
use super::kinks;
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
    /// The kinks that matter, given the same, one bit each; none if none of them may change its sign in the step.
    pub(super) kinks: u128,
    /// The conditions that matter, given which of them may change their sides in the step.
    pub(super) heeded: Heeded,
}

impl Still {
    /// Nothing is known: any condition may change its side.
    pub(super) fn unknown<M: System>(system: &M, held: &M::U) -> Self {
        let kinks = Heeded::kinks(system, held, u64::MAX);
        Self { guards: false, kinks, heeded: Heeded::of(system, held, u64::MAX) }
    }

    /// By the ranges of all of them over a step with this dense output.
    pub(super) fn over<M: System<S: Real>>(course: &Course<'_, M>, path: &Path<M::S, M::X>) -> Self {
        let (half, zero) = (M::S::lit(0.5), M::S::ZERO);
        let (time, x) = path.around(half, half);
        let (mut still, mut moves, mut bends) = (Self { guards: true, kinks: 0, heeded: Heeded::ALL }, 0, 0);
        let known = course.system.guards_within(time, &course.held, &x, &mut |i, tube: Tube<M::S>| {
            let range = tube.range(half);
            // Comparisons with what is not a number are false.
            if i < M::G::LEN {
                let stays = range.low >= -course.system.band(i);
                still.guards &= stays;
                moves |= if stays { 0 } else { bit(i) };
            } else {
                let stays = range.low > zero || range.high <= zero;
                bends |= if stays { 0 } else { kinks::bit(i - M::G::LEN).unwrap_or(0) };
            }
        });
        if !known {
            return Self::unknown(course.system, &course.held);
        }
        if M::SELECTIVE && !still.guards {
            still.heeded = Heeded::of(course.system, &course.held, moves);
            still.guards = still.heeded.is_apart(moves);
        }
        if bends != 0 {
            let kinks = Heeded::kinks(course.system, &course.held, moves);
            still.kinks = if bends & kinks == 0 { 0 } else { kinks };
        }
        still
    }
}
