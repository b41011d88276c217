//! States in which segments of a run begin.

use plm_runtime::{Cause, Fault, Vector};

use crate::optimise::mechanism::Optimisable;
use crate::optimise::rows::Rows;
use crate::optimise::shot::{Begin, Flow, chart};

/// The state in which a segment begins.
#[derive(Clone, Debug)]
pub(crate) struct Node<M: Optimisable> {
    held: M::U,
    pub(crate) x: M::X,
    /// The coordinates that the state is counted in.
    chart: Vec<&'static str>,
    time: f64,
}

impl<M: Optimisable> Node<M> {
    /// A state of a run at a time, s.
    pub(crate) fn new(mechanism: &M, time: f64, held: M::U, x: M::X) -> Self {
        Self { held, x, chart: chart(mechanism, &held), time }
    }

    /// The state with other numbers in the places that it has.
    pub(crate) fn begin(&self, own: &[usize], numbers: &[f64]) -> Begin<M> {
        let mut x = self.x;
        for (place, number) in own.iter().zip(numbers) {
            x.set(*place, *number);
        }
        Begin::At(self.held, x)
    }

    /// Adds rows for how far the end of the segment before is from here, in typical sizes; `first` is the first variable of the state.
    ///
    /// # Errors
    /// That segment ends in other coordinates.
    pub(crate) fn gaps(
        &self,
        (own, typical): (&[usize], &[f64]),
        (flow, columns): (&Flow, &[usize]),
        (first, numbers): (usize, &[f64]),
        rows: &mut Rows,
    ) -> Result<(), Fault> {
        if self.chart != flow.chart {
            return Err(Fault::new(self.time, Cause::NotRegular));
        }
        for (k, (place, size)) in own.iter().zip(typical).enumerate() {
            let by = columns.iter().enumerate().map(|(c, z)| (*z, flow.end_by[(*place, c)] / size));
            rows.push((flow.end[*place] - numbers[k]) / size, by.chain([(first + k, -1.0 / size)]));
        }
        Ok(())
    }
}

/// Places of the numbers that a state has, and their typical sizes.
pub(crate) fn own_numbers<M: Optimisable>(mechanism: &M) -> (Vec<usize>, Vec<f64>) {
    let places = (0..<M::X as Vector<f64>>::LEN).filter(|place| mechanism.has_number(*place));
    places.map(|place| (place, mechanism.typical_at(place))).unzip()
}
