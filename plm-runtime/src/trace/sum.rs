//! Linear combinations of recorded numbers as one operation.

use super::{LAST, Term, Traced};
use crate::scalar::Real;

impl<S: Real> Traced<'_, S> {
    /// `self + h * sum of weight * number` as one operation, where `h` is a constant.
    #[inline]
    pub(super) fn moved_by<const K: usize>(
        self,
        h: S,
        weights: [f64; K],
        number: impl Fn(usize) -> Self,
    ) -> Self {
        let value = self.value.moved(h, weights, |k| number(k).value);
        let (mut trace, mut count) = (self.trace(), usize::from(self.trace().is_some()));
        for k in 0..K {
            let own = number(k).trace();
            trace = trace.or(own);
            count += usize::from(own.is_some());
        }
        let Some(trace) = trace else { return Self::constant(value) };
        let (end, terms) = trace.take(count);
        let mut terms = terms.iter();
        let mut put = |operand: Option<u64>, slope: S| {
            let Some(operand) = operand else { return };
            if let Some(term) = terms.next() {
                let mark = if terms.len() == 0 { LAST } else { 0 };
                term.set(Term { operand: operand | mark, slope });
            }
        };
        put(self.place(), S::lit(1.0));
        for k in 0..K {
            put(number(k).place(), h * S::lit(weights[k]));
        }
        Self::at(value, end - 1, trace)
    }
}
