//! Direct single and multiple shooting: an optimal control as a nonlinear program (H. G. Bock, K. J. Plitt, A multiple shooting
//! algorithm for direct solution of optimal control problems, IFAC 1984).

use std::cmp::Ordering;

use nalgebra::DVector;
use plm_runtime::{Fault, Moment, Vector};

use super::values::{Parts, Values};
use super::{Control, Cost, Optimum};
use crate::optimise::error::{Error, place};
use crate::optimise::mechanism::{Integration, Optimisable};
use crate::optimise::node::{Node, own_numbers};
use crate::optimise::shot::{Begin, Direction, Flow, Shot};
use crate::optimise::signal::{Schedule, Signal};

/// A part of the cost of outputs: number among the outputs that are seen, value, weight.
type OfOutput = (usize, f64, f64);

/// The program. Its variables are the inputs interval by interval, the duration, and the states in which segments begin.
pub(crate) struct Transcription<M: Optimisable, D> {
    mechanism: M,
    integration: D,
    intervals: usize,
    segment: usize,
    duration: [f64; 3],
    /// Number, bounds and guess of each input.
    inputs: Vec<(usize, [f64; 2], Vec<f64>)>,
    names: Vec<(String, &'static str, f64)>,
    /// Outputs that are read at the end of each interval, by number among the observables.
    outputs: Vec<usize>,
    ends: Vec<(usize, f64)>,
    paths: Vec<(usize, [f64; 2])>,
    efforts: Vec<(usize, f64)>,
    deviations: Vec<OfOutput>,
    end_deviations: Vec<OfOutput>,
    end_costs: Vec<(usize, f64)>,
    time: f64,
    nodes: Vec<Node<M>>,
    own: Vec<usize>,
    typical: Vec<f64>,
    pub(crate) runs: usize,
}

impl<M: Optimisable, D: Integration<M>> Transcription<M, D> {
    pub(super) fn new(of: &Control<M>, integration: D) -> Result<Self, Error> {
        let (own, typical) = own_numbers(&of.mechanism);
        let (mut inputs, mut names) = (Vec::new(), Vec::new());
        let all = of.mechanism.tables().inputs;
        for input in &of.inputs {
            let number = place("input", &input.name, all.iter().map(|input| input.name))?;
            inputs.push((number, input.bounds, input.guess.clone()));
            let (unit, factor) = all.get(number).map_or(("", 1.0), |own| (own.unit, own.factor));
            names.push((input.name.clone(), unit, factor));
        }
        let mut program = Self {
            mechanism: of.mechanism,
            integration,
            intervals: of.intervals,
            segment: of.segment.min(of.intervals),
            duration: of.duration,
            inputs,
            names,
            outputs: Vec::new(),
            ends: Vec::new(),
            paths: Vec::new(),
            efforts: Vec::new(),
            deviations: Vec::new(),
            end_deviations: Vec::new(),
            end_costs: Vec::new(),
            time: 0.0,
            nodes: Vec::new(),
            own,
            typical,
            runs: 0,
        };
        for (name, value) in &of.ends {
            let output = program.see(name)?;
            program.ends.push((output, *value));
        }
        for (name, bounds) in &of.paths {
            let output = program.see(name)?;
            program.paths.push((output, *bounds));
        }
        for cost in &of.costs {
            program.add(of, cost)?;
        }
        Ok(program)
    }

    fn add(&mut self, of: &Control<M>, cost: &Cost) -> Result<(), Error> {
        match cost {
            Cost::Effort { input, weight } => self.efforts.push((of.input_number(input)?, *weight)),
            Cost::Deviation { output, value, weight } => {
                let output = self.see(output)?;
                self.deviations.push((output, *value, *weight));
            }
            Cost::EndDeviation { output, value, weight } => {
                let output = self.see(output)?;
                self.end_deviations.push((output, *value, *weight));
            }
            Cost::End { output, weight } => {
                let output = self.see(output)?;
                self.end_costs.push((output, *weight));
            }
            Cost::Time { weight } => self.time += weight,
        }
        Ok(())
    }

    /// The place of an output among those that are seen.
    fn see(&mut self, name: &str) -> Result<usize, Error> {
        let number = place("output", name, self.mechanism.observables().iter().map(|(name, _)| *name))?;
        Ok(self.outputs.iter().position(|own| *own == number).unwrap_or_else(|| {
            self.outputs.push(number);
            self.outputs.len() - 1
        }))
    }

    /// The variable of the duration.
    fn of_duration(&self) -> usize {
        self.intervals * self.inputs.len()
    }

    fn of_node(&self, node: usize) -> usize {
        self.of_duration() + 1 + node * self.own.len()
    }

    /// The guesses, and the states of their run in which segments begin.
    ///
    /// # Errors
    /// The run ends with a fault.
    pub(super) fn start(&mut self) -> Result<DVector<f64>, Fault> {
        let mut z = Vec::new();
        for k in 0..self.intervals {
            for (_, bounds, guess) in &self.inputs {
                z.push(guess.get(k).or(guess.last()).copied().unwrap_or(0.0).max(bounds[0]).min(bounds[1]));
            }
        }
        let [guess, least, most] = self.duration;
        z.push(guess.max(least).min(most));
        let signals = self.signals(&z);
        let mut begin = Begin::Start;
        for first in (0..self.intervals).step_by(self.segment) {
            if let Begin::At(held, x) = begin {
                self.nodes.push(Node::new(&self.mechanism, self.at(first, &z), held, x));
                z.extend(self.own.iter().map(|place| x.at(*place)));
            }
            let state =
                self.shot(first, begin, (&z, &signals), |shot| shot.run(&self.integration, &mut |_, _| ()))?;
            begin = Begin::At(state.held(), *state.x());
        }
        Ok(DVector::from_vec(z))
    }

    /// Time at which an interval begins, s.
    fn at(&self, interval: usize, z: &[f64]) -> f64 {
        z[self.of_duration()] * interval as f64 / self.intervals as f64
    }

    fn signals(&self, z: &[f64]) -> Vec<Signal> {
        let width = self.inputs.len();
        let times: Vec<f64> = (0..self.intervals).map(|k| self.at(k, z)).collect();
        let signal = |(k, (input, ..)): (usize, &(usize, [f64; 2], Vec<f64>))| {
            let values = (0..self.intervals).map(|interval| z[interval * width + k]).collect();
            Signal { input: *input, times: times.clone(), values }
        };
        self.inputs.iter().enumerate().map(signal).collect()
    }

    /// Does something with the run of the segment whose first interval is given.
    fn shot<T>(
        &self,
        first: usize,
        begin: Begin<M>,
        (z, signals): (&[f64], &[Signal]),
        work: impl FnOnce(Shot<'_, M>) -> T,
    ) -> T {
        let last = self.intervals.min(first + self.segment);
        let samples: Vec<f64> = (first + 1..=last).map(|k| self.at(k, z)).collect();
        work(Shot {
            mechanism: &self.mechanism,
            begin,
            time: self.at(first, z),
            schedule: Schedule { signals, samples: &samples, end: self.at(last, z) },
            outputs: &self.outputs,
            duration: z[self.of_duration()],
        })
    }

    /// The run of a segment with its derivatives, and the variables that are its columns.
    fn flow(&mut self, first: usize, z: &[f64], signals: &[Signal]) -> Result<(Flow, Vec<usize>), Fault> {
        let (width, last) = (self.inputs.len(), self.intervals.min(first + self.segment));
        let mut reads: Vec<(usize, Direction)> = (first..last)
            .flat_map(|piece| (0..width).map(move |k| (piece * width + k, Direction::Input(k, piece))))
            .collect();
        if self.duration[1] < self.duration[2] {
            reads.push((self.of_duration(), Direction::Duration));
        }
        let mut begin = Begin::Start;
        if let Some(node) = (first / self.segment).checked_sub(1) {
            let variable = self.of_node(node);
            begin = self.nodes[node].begin(&self.own, &z[variable..]);
            reads.extend(
                self.own.iter().enumerate().map(|(k, place)| (variable + k, Direction::State(*place))),
            );
        }
        let (columns, directions): (Vec<usize>, Vec<Direction>) = reads.into_iter().unzip();
        let flow =
            self.shot(first, begin, (z, signals), |shot| shot.derive(&self.integration, &directions))?;
        self.runs += 1;
        Ok((flow, columns))
    }

    /// Values and derivatives of the program.
    ///
    /// # Errors
    /// A run ends with a fault.
    pub(super) fn evaluate(&mut self, z: &DVector<f64>) -> Result<Values, Fault> {
        let (signals, z) = (self.signals(z.as_slice()), z.as_slice());
        let mut parts = Parts { linear_by: DVector::zeros(z.len()), ..Parts::default() };
        self.efforts(z, &mut parts);
        for first in (0..self.intervals).step_by(self.segment) {
            let (flow, columns) = self.flow(first, z, &signals)?;
            self.of_outputs(first, z, (&flow, &columns), &mut parts);
            let node = first / self.segment;
            parts.columns.push(columns.clone());
            if let Some(next) = self.nodes.get(node) {
                let variable = self.of_node(node);
                let numbers = &z[variable..variable + self.own.len()];
                next.gaps(
                    (&self.own, &self.typical),
                    (&flow, &columns),
                    (variable, numbers),
                    &mut parts.equal,
                )?;
            }
            parts.own_up_to(node);
        }
        Ok(parts.values())
    }

    /// Costs of inputs and of the duration.
    fn efforts(&self, z: &[f64], parts: &mut Parts) {
        let (width, duration) = (self.inputs.len(), self.of_duration());
        parts.linear += self.time * z[duration];
        parts.linear_by[duration] += self.time;
        for (input, weight) in &self.efforts {
            let root = (weight * z[duration] / self.intervals as f64).sqrt();
            for k in 0..self.intervals {
                let variable = k * width + input;
                let by_duration = 0.5 * root * z[variable] / z[duration];
                parts
                    .squares
                    .push(root * z[variable], [(variable, root), (duration, by_duration)].into_iter());
                parts.owners[0].push(k / self.segment);
            }
        }
    }

    /// Costs and demands of outputs in a segment.
    fn of_outputs(&self, first: usize, z: &[f64], (flow, columns): (&Flow, &[usize]), parts: &mut Parts) {
        let (width, duration) = (self.outputs.len(), self.of_duration());
        let last = self.intervals.min(first + self.segment);
        let slopes = |row: usize, factor: f64| {
            let by = columns.iter().enumerate();
            by.map(move |(c, z)| (*z, factor * flow.outputs_by[(row, c)])).collect::<Vec<_>>()
        };
        for interval in first..last {
            let row = |output: usize| (interval - first) * width + output;
            for (output, value, weight) in &self.deviations {
                let root = (weight * z[duration] / self.intervals as f64).sqrt();
                let residual = flow.outputs[row(*output)] - value;
                let by_duration = (duration, 0.5 * root * residual / z[duration]);
                let by = slopes(row(*output), root).into_iter().chain([by_duration]);
                parts.squares.push(root * residual, by);
            }
            for (output, bounds) in &self.paths {
                parts.within.push(flow.outputs[row(*output)], slopes(row(*output), 1.0).into_iter());
                parts.limits.push(*bounds);
            }
        }
        if last < self.intervals {
            return;
        }
        let row = |output: usize| (last - 1 - first) * width + output;
        for (output, value, weight) in &self.end_deviations {
            let root = weight.sqrt();
            let residual = root * (flow.outputs[row(*output)] - value);
            parts.squares.push(residual, slopes(row(*output), root).into_iter());
        }
        for (output, weight) in &self.end_costs {
            parts.linear += weight * flow.outputs[row(*output)];
            for (variable, slope) in slopes(row(*output), *weight) {
                parts.linear_by[variable] += slope;
            }
        }
        for (output, value) in &self.ends {
            parts.equal.push(flow.outputs[row(*output)] - value, slopes(row(*output), 1.0).into_iter());
        }
    }

    /// Least and largest value of a variable.
    pub(super) fn bounds(&self, variable: usize) -> [f64; 2] {
        match variable.cmp(&self.of_duration()) {
            Ordering::Less => self.inputs[variable % self.inputs.len()].1,
            Ordering::Equal => [self.duration[1], self.duration[2]],
            Ordering::Greater => [f64::NEG_INFINITY, f64::INFINITY],
        }
    }

    /// Typical size of a variable.
    pub(super) fn scale(&self, variable: usize) -> f64 {
        if variable > self.of_duration() {
            return self.typical[(variable - self.of_duration() - 1) % self.own.len().max(1)];
        }
        if variable == self.of_duration() {
            return self.duration[0];
        }
        let (_, [least, most], guess) = &self.inputs[variable % self.inputs.len()];
        let range = if (most - least).is_finite() { most - least } else { 0.0 };
        let guess = guess.iter().fold(0.0, |largest: f64, guess| largest.max(guess.abs()));
        [range, guess].into_iter().find(|size| *size > 0.0).unwrap_or(1.0)
    }

    /// Of each input its value in each interval.
    pub(super) fn plan(&self, z: &[f64]) -> Vec<Vec<f64>> {
        let width = self.inputs.len();
        let inputs =
            (0..width).map(|k| (0..self.intervals).map(|interval| z[interval * width + k]).collect());
        inputs.collect()
    }

    /// The result at a point.
    pub(super) fn optimum(&self, found: &super::sequential::Found) -> Optimum {
        let z = found.z.as_slice();
        Optimum {
            times: (0..=self.intervals).map(|k| self.at(k, z)).collect(),
            inputs: self.plan(z),
            names: self.names.clone(),
            duration: z[self.of_duration()],
            cost: found.values.cost(),
            violation: found.violation,
            iterations: found.iterations,
            runs: self.runs,
        }
    }
}
