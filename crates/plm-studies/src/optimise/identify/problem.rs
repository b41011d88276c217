//! Residuals of all experiments as a function of the unknowns and of the states in which segments begin.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use nalgebra::DVector;
use plm_runtime::{Fault, Vector};

use super::experiment::Prepared;
use super::loss::{Loss, median};
use super::segments::{Segment, nodes, segments};
use super::watch::{Progress, Watch};
use crate::optimise::least_squares::{Evaluation, Problem};
use crate::optimise::mechanism::{Integration, Optimisable};
use crate::optimise::node::{Node, own_numbers};
use crate::optimise::rows::Rows;
use crate::optimise::shot::{Begin, Direction, Flow, Shot};
use crate::optimise::signal::Schedule;
use crate::optimise::unknown::Place;

/// The least squares of readings. The variables are the unknowns, then the states in which segments begin.
pub(crate) struct Readings<M: Optimisable, D> {
    /// All unknowns: those that experiments have in common, then those of each.
    pub(crate) places: Vec<Place>,
    pub(crate) experiments: Vec<Prepared<M>>,
    pub(crate) integration: D,
    /// For each experiment the variables that it reads, with their directions.
    pub(crate) reads: Vec<Vec<(usize, Direction)>>,
    pub(crate) segments: Vec<Vec<Segment>>,
    /// For each experiment the states in which its segments begin, but for the first.
    pub(crate) nodes: Vec<Vec<Node<M>>>,
    /// Places of the numbers that a state has.
    pub(crate) own: Vec<usize>,
    pub(crate) typical: Vec<f64>,
    /// The experiment whose run has ended with a fault last.
    pub(crate) failed: usize,
    /// Runs of experiments or segments with derivatives.
    pub(crate) runs: usize,
    /// How residuals count.
    pub(crate) loss: Loss,
    watch: Option<Watch>,
    /// Ends the search.
    pub(crate) stop: Arc<AtomicBool>,
}

impl<M: Optimisable, D: Integration<M>> Readings<M, D> {
    pub(crate) fn new(
        mechanism: M,
        shared: Vec<Place>,
        experiments: Vec<Prepared<M>>,
        integration: D,
        (stop, watch): (Arc<AtomicBool>, Option<Watch>),
    ) -> Self {
        let (mut places, mut reads) = (shared, Vec::new());
        let count = places.len();
        for experiment in &experiments {
            let own: Vec<Direction> = experiment.unknowns.iter().map(|place| place.direction).collect();
            let is_its_own =
                |direction: &Direction| own.contains(direction) || experiment.fixed.contains(direction);
            let shared = places.iter().take(count).enumerate().map(|(k, place)| (k, place.direction));
            let mut list: Vec<(usize, Direction)> = shared.filter(|(_, own)| !is_its_own(own)).collect();
            list.extend(own.iter().enumerate().map(|(k, direction)| (places.len() + k, *direction)));
            places.extend(experiment.unknowns.iter().cloned());
            reads.push(list);
        }
        let (own, typical) = own_numbers(&mechanism);
        let segments =
            experiments.iter().map(|experiment| segments(&experiment.times, experiment.segments)).collect();
        let nodes = vec![Vec::new(); experiments.len()];
        let (failed, runs) = (0, 0);
        let loss = Loss::Squares;
        Self {
            places,
            experiments,
            integration,
            reads,
            segments,
            nodes,
            own,
            typical,
            failed,
            runs,
            loss,
            watch,
            stop,
        }
    }

    /// The number of residuals: of readings, and of unknowns with an expected value.
    pub(crate) fn rows(&self) -> usize {
        let of = |experiment: &Prepared<M>| -> usize {
            let count = |values: &[f64]| values.iter().filter(|value| value.is_finite()).count();
            experiment.outputs.iter().map(|output| count(&output.values)).sum()
        };
        let priors = self.places.iter().filter(|place| place.prior.is_some()).count();
        self.experiments.iter().map(of).sum::<usize>() + priors
    }

    /// The guesses, and states in which segments begin.
    ///
    /// # Errors
    /// A run that ends with a fault.
    pub(crate) fn start(&mut self) -> Result<DVector<f64>, Fault> {
        let mut z: Vec<f64> =
            self.places.iter().map(|place| place.guess.max(place.bounds[0]).min(place.bounds[1])).collect();
        let guesses = DVector::from_column_slice(&z);
        for number in 0..self.experiments.len() {
            if self.segments[number].len() > 1 {
                self.failed = number;
                self.nodes[number] = nodes(self, number, &guesses)?;
            }
        }
        for node in self.nodes.iter().flatten() {
            z.extend(self.own.iter().map(|place| node.x.at(*place)));
        }
        Ok(DVector::from_vec(z))
    }

    /// The mechanism of an experiment with the unknowns as they are.
    pub(crate) fn mechanism(&self, number: usize, z: &DVector<f64>) -> M {
        let mut mechanism = self.experiments[number].mechanism;
        for kind in [is_parameter as fn(Direction) -> bool, |direction| !is_parameter(direction)] {
            for (k, _) in self.reads[number].iter().filter(|(_, direction)| kind(*direction)) {
                self.places[*k].set(&mut mechanism, z[*k]);
            }
        }
        mechanism
    }

    /// The first variable of the state in which a segment begins.
    pub(crate) fn variable(&self, number: usize, segment: usize) -> usize {
        let before: usize = self.nodes.iter().take(number).map(Vec::len).sum();
        self.places.len() + (before + segment - 1) * self.own.len()
    }

    /// The state of a segment with the numbers of the variables.
    pub(crate) fn begin(&self, number: usize, segment: usize, z: &DVector<f64>) -> Begin<M> {
        let Some(node) = segment.checked_sub(1).and_then(|k| self.nodes[number].get(k)) else {
            return Begin::Start;
        };
        let first = self.variable(number, segment);
        node.begin(&self.own, &z.as_slice()[first..])
    }

    /// A segment of an experiment with its derivatives, and the variables that are its columns.
    fn flow(&mut self, number: usize, segment: usize, z: &DVector<f64>) -> Result<(Flow, Vec<usize>), Fault> {
        let mut reads = self.reads[number].clone();
        if segment > 0 {
            reads.retain(|(_, direction)| is_parameter(*direction));
            let first = self.variable(number, segment);
            reads.extend(self.own.iter().enumerate().map(|(k, place)| (first + k, Direction::State(*place))));
        }
        let (columns, directions): (Vec<usize>, Vec<Direction>) = reads.into_iter().unzip();
        let begin = self.begin(number, segment, z);
        let mechanism = self.mechanism(number, z);
        let flow = derived(
            &self.experiments[number],
            &self.segments[number][segment],
            (&mechanism, begin),
            |shot| shot.derive(&self.integration, &directions),
        )?;
        self.runs += 1;
        Ok((flow, columns))
    }

    /// Residuals of the readings in a segment.
    fn residuals(&self, number: usize, segment: usize, (flow, columns): (&Flow, &[usize]), rows: &mut Rows) {
        let Prepared { outputs, .. } = &self.experiments[number];
        for (row, sample) in self.segments[number][segment].samples().enumerate() {
            for (k, output) in outputs.iter().enumerate() {
                if output.values[sample].is_finite() {
                    let from = row * outputs.len() + k;
                    let residual = (flow.outputs[from] - output.values[sample]) / output.deviation;
                    let (counted, slope) = self.loss.of(residual);
                    let slope = slope / output.deviation;
                    let by = columns.iter().enumerate();
                    rows.push(counted, by.map(|(c, z)| (*z, flow.outputs_by[(from, c)] * slope)));
                }
            }
        }
    }
}

impl<M: Optimisable, D: Integration<M>> Readings<M, D> {
    /// Takes the deviations that are not given from plain residuals, and says by how much one changes most, relatively.
    pub(super) fn spread(&mut self, residuals: &DVector<f64>) -> f64 {
        let mut sizes: Vec<Vec<Vec<f64>>> =
            self.experiments.iter().map(|own| vec![Vec::new(); own.outputs.len()]).collect();
        let mut rows = residuals.iter();
        for (number, experiment) in self.experiments.iter().enumerate() {
            for sample in self.segments[number].iter().flat_map(Segment::samples) {
                for (k, output) in experiment.outputs.iter().enumerate() {
                    if output.values[sample].is_finite() {
                        sizes[number][k].extend(rows.next().map(|own| own.abs()));
                    }
                }
            }
        }
        let outputs = self.experiments.iter_mut().flat_map(|own| &mut own.outputs);
        let mut most: f64 = 0.0;
        for (output, sizes) in outputs.zip(sizes.into_iter().flatten()).filter(|(own, _)| !own.is_given) {
            // Most readings may be met to rounding: a deviation of zero would have them all count for ever.
            let factor = median(sizes).map_or(1.0, |own| (1.4826 * own).max(1e-9));
            output.deviation *= factor;
            most = most.max((factor - 1.0).abs());
        }
        most
    }
}

/// Does something with the run of a segment, which is seen at its readings.
pub(crate) fn derived<M: Optimisable, T>(
    experiment: &Prepared<M>,
    segment: &Segment,
    of: (&M, Begin<M>),
    work: impl FnOnce(Shot<'_, M>) -> T,
) -> T {
    let samples = experiment.times.get(segment.samples()).unwrap_or_default();
    seen_at(experiment, (segment, samples), of, work)
}

/// Does something with the run of a segment, which is seen at these times.
pub(crate) fn seen_at<M: Optimisable, T>(
    experiment: &Prepared<M>,
    (segment, samples): (&Segment, &[f64]),
    (mechanism, begin): (&M, Begin<M>),
    work: impl FnOnce(Shot<'_, M>) -> T,
) -> T {
    let outputs: Vec<usize> = experiment.outputs.iter().map(|output| output.index).collect();
    work(Shot {
        mechanism,
        begin,
        time: segment.begin(&experiment.times),
        schedule: Schedule { signals: &experiment.signals, samples, end: segment.end(&experiment.times) },
        outputs: &outputs,
        duration: 1.0,
    })
}

fn is_parameter(direction: Direction) -> bool {
    matches!(direction, Direction::Parameter(_))
}

impl<M: Optimisable, D: Integration<M>> Problem for Readings<M, D> {
    fn evaluate(&mut self, z: &DVector<f64>) -> Result<Evaluation, Fault> {
        let (mut residuals, mut gaps) = (Rows::default(), Rows::default());
        for number in 0..self.experiments.len() {
            self.failed = number;
            for segment in 0..self.segments[number].len() {
                let (flow, columns) = self.flow(number, segment, z)?;
                self.residuals(number, segment, (&flow, &columns), &mut residuals);
                if let Some(node) = self.nodes[number].get(segment) {
                    let first = self.variable(number, segment + 1);
                    let numbers = &z.as_slice()[first..first + self.own.len()];
                    node.gaps((&self.own, &self.typical), (&flow, &columns), (first, numbers), &mut gaps)?;
                }
            }
        }
        for (k, place) in self.places.iter().enumerate() {
            if let Some([value, deviation]) = place.prior {
                residuals.push((z[k] - value) / deviation, std::iter::once((k, 1.0 / deviation)));
            }
        }
        let (residuals, jacobian) = residuals.matrices(z.len());
        let (constraints, constraints_by) = gaps.matrices(z.len());
        Ok(Evaluation { residuals, jacobian, constraints, constraints_by })
    }

    fn bounds(&self, variable: usize) -> [f64; 2] {
        self.places.get(variable).map_or([f64::NEG_INFINITY, f64::INFINITY], |place| place.bounds)
    }

    fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    fn reached(&self, iteration: usize, z: &DVector<f64>, at: &Evaluation) {
        if let Some(Watch(watch)) = &self.watch {
            let values = self.places.iter().zip(z.iter()).map(|(place, value)| (place.name.clone(), *value));
            let rms = at.residuals.norm() / (at.residuals.len().max(1) as f64).sqrt();
            watch(&Progress { iteration, rms, values: values.collect() });
        }
    }

    fn scale(&self, variable: usize) -> f64 {
        match variable.checked_sub(self.places.len()) {
            Some(k) => self.typical[k % self.own.len().max(1)],
            None => self.places[variable].scale,
        }
    }
}
