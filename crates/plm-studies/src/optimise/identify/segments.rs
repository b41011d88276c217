//! Segments of an experiment, and first values of the states in which they begin.

use std::ops::Range;

use nalgebra::{DMatrix, DVector};
use plm_runtime::{Fault, Moment, Vector};

use super::problem::{Readings, derived};
use crate::optimise::least_squares::{Evaluation, FIRST_DAMPING, Limits, Problem, minimise};
use crate::optimise::mechanism::{Integration, Optimisable};
use crate::optimise::node::Node;
use crate::optimise::rows::Rows;
use crate::optimise::shot::{Begin, Direction, Flow};

/// A part of an experiment, by numbers of its samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Segment {
    /// The sample at whose time it begins; none at the start.
    from: Option<usize>,
    /// The sample at whose time it ends.
    to: usize,
}

impl Segment {
    /// Time at which it begins, s.
    pub(crate) fn begin(&self, times: &[f64]) -> f64 {
        self.from.map_or(0.0, |from| times[from])
    }

    /// Time at which it ends, s.
    pub(crate) fn end(&self, times: &[f64]) -> f64 {
        times[self.to]
    }

    /// Its samples.
    pub(crate) fn samples(&self) -> Range<usize> {
        self.from.map_or(0, |from| from + 1)..self.to + 1
    }
}

/// The segments of so many samples each, as nearly as can be.
pub(crate) fn segments(times: &[f64], count: usize) -> Vec<Segment> {
    let last = times.len() - 1;
    let count = count.min(last.max(1));
    let border = |k: usize| k * last / count;
    (0..count).map(|k| Segment { from: (k > 0).then(|| border(k)), to: border(k + 1) }).collect()
}

/// States in which the segments of an experiment begin: each is fitted to the readings of its segment, from where the one before ends.
///
/// # Errors
/// A run that ends with a fault.
pub(crate) fn nodes<M: Optimisable, D: Integration<M>>(
    readings: &Readings<M, D>,
    number: usize,
    z: &DVector<f64>,
) -> Result<Vec<Node<M>>, Fault> {
    let experiment = &readings.experiments[number];
    let mechanism = readings.mechanism(number, z);
    let (mut nodes, mut begin): (Vec<Node<M>>, _) = (Vec::new(), Begin::Start);
    for (k, segment) in readings.segments[number].iter().enumerate() {
        if k > 0
            && let Begin::At(held, x) = begin
        {
            let mut own = OneSegment { readings, number, segment: *segment, mechanism, held, x };
            let guess =
                DVector::from_iterator(readings.own.len(), readings.own.iter().map(|place| x.at(*place)));
            let limits =
                Limits { iterations: 20, step: 1e-6, cosine: 1e-6, constraint: 0.0, damping: FIRST_DAMPING };
            let x = match minimise(&mut own, &guess, &limits) {
                Ok(found) => own.state(&found.z),
                Err(_) => x,
            };
            nodes.push(Node::new(&mechanism, segment.begin(&experiment.times), held, x));
            begin = Begin::At(held, x);
        }
        let run = |begin| {
            derived(experiment, segment, (&mechanism, begin), |shot| {
                shot.run(&readings.integration, &mut |_, _| ())
            })
        };
        let state = run(begin)?;
        begin = Begin::At(state.held(), *state.x());
    }
    Ok(nodes)
}

/// The readings of one segment as a function of the state in which it begins, which is to stay near a first value.
struct OneSegment<'a, M: Optimisable, D> {
    readings: &'a Readings<M, D>,
    number: usize,
    segment: Segment,
    mechanism: M,
    held: M::U,
    x: M::X,
}

/// The state stays near its first value with a deviation of so many typical sizes.
const DEVIATION: f64 = 10.0;

impl<M: Optimisable, D: Integration<M>> OneSegment<'_, M, D> {
    fn state(&self, z: &DVector<f64>) -> M::X {
        let mut x = self.x;
        for (k, place) in self.readings.own.iter().enumerate() {
            x.set(*place, z[k]);
        }
        x
    }

    fn flow(&self, z: &DVector<f64>) -> Result<Flow, Fault> {
        let directions: Vec<Direction> =
            self.readings.own.iter().map(|place| Direction::State(*place)).collect();
        let begin = Begin::At(self.held, self.state(z));
        let experiment = &self.readings.experiments[self.number];
        derived(experiment, &self.segment, (&self.mechanism, begin), |shot| {
            shot.derive(&self.readings.integration, &directions)
        })
    }
}

impl<M: Optimisable, D: Integration<M>> Problem for OneSegment<'_, M, D> {
    fn evaluate(&mut self, z: &DVector<f64>) -> Result<Evaluation, Fault> {
        let flow = self.flow(z)?;
        let outputs = &self.readings.experiments[self.number].outputs;
        let mut rows = Rows::default();
        for (row, sample) in self.segment.samples().enumerate() {
            for (k, output) in outputs.iter().enumerate() {
                let from = row * outputs.len() + k;
                if output.values[sample].is_finite() {
                    let by = (0..z.len()).map(|c| (c, flow.outputs_by[(from, c)] / output.deviation));
                    rows.push((flow.outputs[from] - output.values[sample]) / output.deviation, by);
                }
            }
        }
        for (k, place) in self.readings.own.iter().enumerate() {
            let size = DEVIATION * self.readings.typical[k];
            rows.push((z[k] - self.x.at(*place)) / size, std::iter::once((k, 1.0 / size)));
        }
        let (residuals, jacobian) = rows.matrices(z.len());
        let constraints_by = DMatrix::zeros(0, z.len());
        Ok(Evaluation { residuals, jacobian, constraints: DVector::zeros(0), constraints_by })
    }

    fn bounds(&self, _variable: usize) -> [f64; 2] {
        [f64::NEG_INFINITY, f64::INFINITY]
    }

    fn scale(&self, variable: usize) -> f64 {
        self.readings.typical[variable]
    }

    fn is_stopped(&self) -> bool {
        self.readings.is_stopped()
    }
}
