//! A mechanism with its numbers: a handle that is copied.

use plm_runtime::charts::OfLoops;
use plm_runtime::contact;
use plm_runtime::held::Held as HeldOf;
use plm_runtime::{Scalar, Start, StartValues};

use crate::capacity::{INPUTS, PARAMETERS, ROWS, SWITCHES, WATCHED};
use crate::code::{Argument, Array, Code, Place};
use crate::memory::Memory;
use crate::model::Model;
use plm_compiler::OfScalar;
use plm_compiler::lowered::Form;
use plm_compiler::model::ContactMode;

/// A mechanism of at most `NQ / 3` bodies and `NC` constraint rows, with `N` numbers in a state [q, v, first-order states]. Coordinates
/// of its own stand in the places of the first ones of these.
#[derive(Clone, Copy, Debug)]
pub struct Dynamic<S, const NQ: usize, const NC: usize, const N: usize> {
    pub(crate) model: &'static Model,
    pub(crate) parameters: [S; PARAMETERS],
    pub(crate) starts: Starts<S, N>,
}

/// Start values: x, y, angle, vx, vy, omega of each body, then first-order states.
#[derive(Clone, Copy, Debug)]
pub struct Starts<S, const N: usize> {
    pub(crate) model: &'static Model,
    pub(crate) values: [Start<S>; N],
}

/// What is held over a step.
pub(crate) type Held<S, const NQ: usize> = HeldOf<
    [S; INPUTS],
    [S; SWITCHES],
    [<S as Scalar>::Turns; NQ],
    OfLoops<Memory<S, NQ>, [S; NQ]>,
    contact::Held<S, ROWS>,
>;

/// The numbers that a function reads, beside parameters.
#[derive(Clone, Copy)]
pub(crate) struct Frame<'a, S: Scalar, const NQ: usize> {
    pub(crate) t: S,
    pub(crate) held: Option<&'a Held<S, NQ>>,
    pub(crate) x: &'a [S],
    pub(crate) q: &'a [S],
    pub(crate) v: &'a [S],
    pub(crate) a: &'a [S],
    pub(crate) lambda: &'a [S],
    pub(crate) weights: &'a [S],
    pub(crate) residuals: &'a [S],
    pub(crate) rates: &'a [S],
    pub(crate) sliding: Sliding<'a, S>,
}

/// The numbers of rows of contact that all slip.
#[derive(Clone, Copy)]
pub(crate) struct Sliding<'a, S> {
    pub(crate) slip: &'a [S],
    pub(crate) line: &'a [S],
    pub(crate) force: &'a [S],
    pub(crate) second: &'a [S],
    pub(crate) known: &'a [S],
}

impl<S> Sliding<'_, S> {
    /// No numbers.
    pub(crate) const NONE: Self = Sliding { slip: &[], line: &[], force: &[], second: &[], known: &[] };
}

impl<'a, S: Scalar, const NQ: usize> Frame<'a, S, NQ> {
    /// The time alone.
    pub(crate) fn at(t: S) -> Self {
        let none: &[S] = &[];
        Frame {
            t,
            held: None,
            x: none,
            q: none,
            v: none,
            a: none,
            lambda: none,
            weights: none,
            residuals: none,
            rates: none,
            sliding: Sliding::NONE,
        }
    }

    /// A pose, and velocities.
    pub(crate) fn of_pose(t: S, q: &'a [S], v: &'a [S]) -> Self {
        Frame { q, v, ..Frame::at(t) }
    }

    /// A state with what is held.
    pub(crate) fn of_state(t: S, held: &'a Held<S, NQ>, x: &'a [S]) -> Self {
        Frame { held: Some(held), x, ..Frame::at(t) }
    }
}

impl<S: Scalar, const NQ: usize, const NC: usize, const N: usize> Dynamic<S, NQ, NC, N> {
    /// Evaluates a function: its outputs go to arrays, what it returns comes back.
    pub(crate) fn run<const K: usize>(
        &self,
        code: &Code,
        frame: &Frame<S, NQ>,
        mut outputs: [&mut [S]; K],
    ) -> S {
        let mut returned = S::ZERO;
        code.run(
            |argument| self.read(argument, frame),
            |place, value| match place {
                Place::Value => returned = value,
                Place::Element(output, k) => {
                    if let Some(to) = outputs.get_mut(output).and_then(|output| output.get_mut(k)) {
                        *to = value;
                    }
                }
                _ => {}
            },
        );
        returned
    }

    /// Evaluates a function of what is to be remembered.
    pub(crate) fn remembered(&self, code: &Code, frame: &Frame<S, NQ>) -> (Memory<S, NQ>, S) {
        let (mut memory, mut returned) = (Memory::new(self.model.counts), S::ZERO);
        code.run(
            |argument| self.read(argument, frame),
            |place, value| match place {
                Place::Value => returned = value,
                Place::Remembered(k) => {
                    if let Some(to) = memory.number_mut(k) {
                        *to = value;
                    }
                }
                _ => {}
            },
        );
        (memory, returned)
    }

    /// Evaluates a function of the entries of a matrix.
    pub(crate) fn entries(&self, code: &Code, frame: &Frame<S, NQ>, matrix: &mut [[S; N]; N]) {
        code.run(
            |argument| self.read(argument, frame),
            |place, value| {
                if let Place::Entry(row, column) = place
                    && let Some(entry) = matrix.get_mut(row).and_then(|row| row.get_mut(column))
                {
                    *entry = value;
                }
            },
        );
    }

    /// Values of parameters and the time.
    pub(crate) fn values(&self, t: S, code: &Code, count: usize) -> Vec<S> {
        let mut values = vec![S::ZERO; count];
        self.run(code, &Frame::at(t), [&mut values]);
        values
    }

    #[inline]
    pub(crate) fn read(&self, argument: Argument, frame: &Frame<S, NQ>) -> S {
        let of = |list: &[S], k: usize| list.get(k).copied().unwrap_or(S::ZERO);
        match argument {
            Argument::Time => frame.t,
            Argument::Parameter(k) => of(&self.parameters, k),
            Argument::Element(array, k) => {
                let list = match array {
                    Array::X => frame.x,
                    Array::Q => frame.q,
                    Array::V => frame.v,
                    Array::A => frame.a,
                    Array::Lambda => frame.lambda,
                    Array::Weights => frame.weights,
                    Array::Residuals => frame.residuals,
                    Array::Rates => frame.rates,
                    Array::Slip => frame.sliding.slip,
                    Array::Line => frame.sliding.line,
                    Array::Force => frame.sliding.force,
                    Array::Second => frame.sliding.second,
                    Array::Known => frame.sliding.known,
                };
                of(list, k)
            }
            Argument::Scalar(OfScalar::MostGrowth) => S::lit(S::MOST_GROWTH),
            Argument::Scalar(OfScalar::Agreement) => S::lit(S::AGREEMENT),
            Argument::Scalar(OfScalar::Precision) => S::lit(S::PRECISION),
            Argument::Input(k) => frame.held.map_or(S::ZERO, |held| of(&held.input, k)),
            Argument::Switch(k) => frame.held.map_or(S::ZERO, |held| of(&held.switches, k)),
            Argument::Turns(k) => {
                frame.held.and_then(|held| held.turns.get(k)).map_or(S::ZERO, |turns| S::of_turns(*turns))
            }
            Argument::Remembered(k) => match frame.held.map(|held| &held.of_loops) {
                Some(OfLoops::InChart { continuation, .. }) => continuation.number(k),
                _ => S::ZERO,
            },
            Argument::Multiplier(k) => frame.held.map_or(S::ZERO, |held| of(&held.contact.lambda, k)),
            Argument::Mode(k, mode) => {
                let is_so = frame.held.is_some_and(|held| match mode {
                    ContactMode::Open => held.contact.modes.is_open(k),
                    ContactMode::Sticking => held.contact.modes.is_sticking(k),
                });
                S::lit(if is_so { 1.0 } else { 0.0 })
            }
            Argument::None => S::lit(f64::NAN),
        }
    }

    /// The same mechanism in other numbers.
    pub(crate) fn map<T: Scalar>(&self, number: &impl Fn(S) -> T) -> Dynamic<T, NQ, NC, N> {
        Dynamic {
            model: self.model,
            parameters: self.parameters.map(number),
            starts: Starts { model: self.model, values: self.starts.values.map(|start| start.map(number)) },
        }
    }

    /// What is held, in other numbers.
    pub(crate) fn map_held<T: Scalar>(held: &Held<S, NQ>, number: &impl Fn(S) -> T) -> Held<T, NQ> {
        HeldOf {
            input: held.input.map(number),
            switches: held.switches.map(number),
            turns: held.turns.map(|turns| T::to_turns(number(S::of_turns(turns)))),
            of_loops: match &held.of_loops {
                OfLoops::InChart { chart, continuation } => {
                    OfLoops::InChart { chart: *chart, continuation: continuation.map(number) }
                }
                OfLoops::Free { q, v } => OfLoops::Free { q: q.map(number), v: v.map(number) },
            },
            contact: contact::Held::packed(&held.contact, [&held.contact], &|[value]: [S; 1]| number(value)),
        }
    }

    /// Is the state in absolute coordinates?
    pub(crate) fn is_absolute(&self) -> bool {
        self.model.lowered.form == Form::Absolute
    }

    /// Are loops solved in charts?
    pub(crate) fn is_charted(&self) -> bool {
        self.model.lowered.form == Form::Loops
    }

    /// Guards, then kinks, where they need no accelerations.
    pub(crate) fn watched(&self, t: S, held: &Held<S, NQ>, x: &[S], out: &mut [S; WATCHED]) {
        let frame = Frame::of_state(t, held, x);
        let code = match held.of_loops {
            OfLoops::InChart { chart, .. } if !self.is_absolute() => {
                self.model.in_charts.get(chart).map(|chart| &chart.guards)
            }
            _ => Some(&self.model.absolute.guards),
        };
        if let Some(code) = code {
            self.run(code, &frame, [out]);
        }
    }
}

impl<S: Scalar, const N: usize> StartValues<S> for Starts<S, N> {
    fn each(&mut self, each: &mut impl FnMut(&'static str, &mut Start<S>)) {
        for (name, start) in self.model.names_of_starts.iter().zip(&mut self.values) {
            each(name, start);
        }
    }
}
