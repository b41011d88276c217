//! The way back through a record: adjoints of all operands.

use super::carried::{Carried, Table};
use super::{Lack, NoGradient};
use crate::scalar::Real;
use crate::trace::Trace;

/// Adjoints by place, of variables, of what was computed before the run, of a segment, and of what earlier segments have made.
pub(super) struct Adjoints<'m, S, const R: usize> {
    variables: &'m mut [[S; R]],
    /// Those of what was computed before the run, then those of the segment.
    dense: &'m mut [[S; R]],
    /// How many variables there are.
    count: u64,
    /// Terms of what was computed before the run.
    prefix: u64,
    /// The first place of the segment.
    segment: u64,
    earlier: Table<'m, S, R>,
    /// There was no room for one.
    is_full: bool,
}

impl<'m, S: Real, const R: usize> Adjoints<'m, S, R> {
    pub(super) fn new(
        [variables, dense]: [&'m mut [[S; R]]; 2],
        carried: &'m mut [Carried<S, R>],
        (count, prefix): (u64, u64),
    ) -> Self {
        variables.fill([S::ZERO; R]);
        let (start, _) = dense.split_at_mut(dense.len().min(prefix as usize));
        start.fill([S::ZERO; R]);
        let segment = u64::MAX;
        Self { variables, dense, count, prefix, segment, earlier: Table::new(carried), is_full: false }
    }

    /// Adds 1 to the adjoint of a result.
    pub(super) fn seed(&mut self, place: Option<u64>, result: usize) {
        let one = core::array::from_fn(|k| if k == result { S::lit(1.0) } else { S::ZERO });
        if let Some(place) = place {
            self.add(place, &one, S::lit(1.0));
        }
    }

    /// Makes a segment between these places the present one: its adjoints are those that later segments have carried to it.
    pub(super) fn enter(&mut self, first: u64, end: u64) {
        let Self { dense, prefix, earlier, .. } = self;
        let own = *prefix as usize..(*prefix + end - first) as usize;
        if let Some(own) = dense.get_mut(own) {
            own.fill([S::ZERO; R]);
        }
        earlier.take_from(first, |place, adjoint| {
            if let Some(own) = dense.get_mut((*prefix + place - first) as usize) {
                *own = adjoint;
            }
        });
        self.segment = first;
    }

    /// Goes back through the present segment, which is recorded up to this place.
    pub(super) fn go_back(&mut self, trace: &Trace<'_, S>, end: u64) -> Result<(), NoGradient> {
        let first = self.segment;
        self.sweep(trace, self.prefix..self.prefix + end - first);
        if self.is_full {
            return Err(NoGradient::Short(Lack {
                terms: trace.room(),
                adjoints: trace.room(),
                carried: 2 * self.earlier.room(),
                saved: 0,
            }));
        }
        Ok(())
    }

    /// Goes back through what was computed before the run.
    pub(super) fn go_back_start(&mut self, trace: &Trace<'_, S>) {
        self.sweep(trace, 0..self.prefix);
    }

    /// Adds to the adjoint of each operand that of the operation times its slope.
    fn sweep(&mut self, trace: &Trace<'_, S>, indices: core::ops::Range<u64>) {
        let (mut adjoint, mut counts) = ([S::ZERO; R], false);
        let indices = indices.start as usize..indices.end as usize;
        trace.backward(indices, |index, is_last, operand, slope| {
            if is_last && let Some(own) = self.dense.get(index) {
                adjoint = *own;
                counts = adjoint.iter().any(|adjoint| *adjoint != S::ZERO);
            }
            if counts {
                self.add(operand, &adjoint, slope);
            }
        });
    }

    #[inline]
    fn add(&mut self, place: u64, adjoint: &[S; R], slope: S) {
        let own = if place >= self.segment {
            self.dense.get_mut((self.prefix + place - self.segment) as usize)
        } else if place < self.count {
            self.variables.get_mut(place as usize)
        } else if place < self.count + self.prefix {
            self.dense.get_mut((place - self.count) as usize)
        } else {
            let entry = self.earlier.entry(place);
            self.is_full |= entry.is_none();
            entry
        };
        for (own, adjoint) in own.into_iter().flatten().zip(adjoint) {
            *own = slope.mul_add(*adjoint, *own);
        }
    }
}
