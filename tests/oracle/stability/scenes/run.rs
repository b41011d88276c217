//! Running a scene and keeping what a probe reads.

use crate::text::By;
use plm_run::AnySim;
use plm_runtime::{Fault, Moment};

/// What a probe read over a run, and how the run ended.
#[derive(Debug)]
pub struct Trace<const N: usize> {
    /// Time, s, and the values that the probe gave.
    pub rows: Vec<(f64, [f64; N])>,
    pub end: Result<(), Fault>,
}

impl<const N: usize> Trace<N> {
    /// The largest absolute value of a column; infinite if one is not a number.
    pub fn largest(&self, column: usize) -> f64 {
        let sizes = self.rows.iter().map(|(_, row)| row[column].abs());
        sizes.fold(0.0, |largest, size| if size.is_nan() { f64::INFINITY } else { largest.max(size) })
    }

    /// A column over time.
    pub fn over_time(&self, column: usize) -> Vec<(f64, f64)> {
        self.rows.iter().map(|(time, row)| (*time, row[column])).collect()
    }

    /// The last row.
    pub fn last(&self) -> [f64; N] {
        self.rows.last().map_or([f64::NAN; N], |(_, row)| *row)
    }

    /// It ran to its end.
    pub fn survived(&self) -> bool {
        self.end.is_ok()
    }
}

/// Runs until the time `until` and reads the probe every `every`, in s.
pub fn trace<M: By<S = f64>, const N: usize>(
    sim: &mut AnySim<M>,
    until: f64,
    every: f64,
    probe: impl Fn(&M::State) -> [f64; N],
) -> Trace<N> {
    let mut rows = Vec::new();
    let end = sim.run(until, every, |state| rows.push((state.time(), probe(state))));
    Trace { rows, end }
}

/// Runs until the time `until`, whatever comes.
pub fn at_end<M: By<S = f64>, R>(
    sim: &mut AnySim<M>,
    until: f64,
    read: impl Fn(&M::State) -> R,
) -> Result<R, Fault> {
    sim.step(until - sim.time())?;
    Ok(read(sim))
}

/// Distance of two points, m.
pub fn gap(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}
