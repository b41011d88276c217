//! A mechanism with its numbers: a handle that is copied.

use std::sync::Arc;

use plm_runtime::charts::OfLoops;
use plm_runtime::contact;
use plm_runtime::held::Held as HeldOf;
use plm_runtime::{Real, Scalar, Start, StartValues};

use crate::capacity::{PARAMETERS, ROWS, SWITCHES};
use crate::code::{Code, FIRST};
use crate::memory::Memory;
use crate::model::Model;
use crate::native::{MachineCode, Translator};
use crate::places::{Argument, Array, List, Place, of_scalar};
use plm_compiler::lowered::Form;
use plm_compiler::model::ContactMode;

/// A mechanism of at most `NQ / 3` bodies and `NC` constraint rows, with `N` numbers in a state [q, v, first-order states]. Coordinates
/// of its own stand in the places of the first ones of these. Loops remember at most `L` numbers of each kind; there are at most `H` inputs,
/// and as many conditions with guards of contact, `R` rows of contact, and `P` parameters.
#[derive(Clone, Copy, Debug)]
pub struct Dynamic<
    S,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize = NQ,
    const H: usize = SWITCHES,
    const R: usize = ROWS,
    const P: usize = PARAMETERS,
> {
    pub(crate) model: &'static Model,
    pub(crate) parameters: [S; P],
    pub(crate) starts: Starts<S, N>,
}

/// An array of other values: a loop, where `map` of arrays would be code for each of their lengths.
fn converted<A: Copy, B: Copy, const N: usize>(from: &[A; N], zero: B, by: &impl Fn(A) -> B) -> [B; N] {
    let mut to = [zero; N];
    for (to, from) in to.iter_mut().zip(from) {
        *to = by(*from);
    }
    to
}

/// The most lists of results that a function has.
const OUTPUTS: usize = 4;

/// Start values: x, y, angle, vx, vy, omega of each body, then first-order states.
#[derive(Clone, Copy, Debug)]
pub struct Starts<S, const N: usize> {
    pub(crate) model: &'static Model,
    pub(crate) values: [Start<S>; N],
}

/// Discrete state of a mechanism from text.
pub(crate) type Held<S, const NQ: usize, const L: usize, const H: usize, const R: usize> =
    HeldOf<[S; H], [S; H], [<S as Scalar>::Turns; NQ], OfLoops<Memory<S, L>, [S; NQ]>, contact::Held<S, R>>;

/// The numbers that a function reads, beside parameters.
#[derive(Clone, Copy)]
pub(crate) struct Frame<'a, S: Scalar, const NQ: usize, const L: usize, const H: usize, const R: usize> {
    pub(crate) t: S,
    pub(crate) held: Option<&'a Held<S, NQ, L, H, R>>,
    pub(crate) x: &'a [S],
    pub(crate) q: &'a [S],
    pub(crate) v: &'a [S],
    pub(crate) beside: Option<&'a Beside<'a, S>>,
}

/// Numbers that few functions read: accelerations, multipliers, those of a correction, rates, those of rows of contact that all slip.
#[derive(Clone, Copy)]
pub(crate) struct Beside<'a, S> {
    pub(crate) a: &'a [S],
    pub(crate) lambda: &'a [S],
    pub(crate) weights: &'a [S],
    pub(crate) residuals: &'a [S],
    pub(crate) rates: &'a [S],
    pub(crate) slip: &'a [S],
    pub(crate) line: &'a [S],
    pub(crate) force: &'a [S],
    pub(crate) second: &'a [S],
    pub(crate) known: &'a [S],
    pub(crate) step: &'a [S],
}

impl<S> Beside<'_, S> {
    /// No numbers.
    pub(crate) const NONE: Self = Beside {
        a: &[],
        lambda: &[],
        weights: &[],
        residuals: &[],
        rates: &[],
        slip: &[],
        line: &[],
        force: &[],
        second: &[],
        known: &[],
        step: &[],
    };
}

impl<'a, S: Scalar, const NQ: usize, const L: usize, const H: usize, const R: usize>
    Frame<'a, S, NQ, L, H, R>
{
    /// The time alone.
    pub(crate) fn at(t: S) -> Self {
        let none: &[S] = &[];
        Frame { t, held: None, x: none, q: none, v: none, beside: None }
    }

    /// A pose, and velocities.
    pub(crate) fn of_pose(t: S, q: &'a [S], v: &'a [S]) -> Self {
        Frame { q, v, ..Frame::at(t) }
    }

    /// Arguments of a state with its discrete state.
    pub(crate) fn of_state(t: S, held: &'a Held<S, NQ, L, H, R>, x: &'a [S]) -> Self {
        Frame { held: Some(held), x, ..Frame::at(t) }
    }
}

impl<
    S: Scalar,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> Dynamic<S, NQ, NC, N, L, H, R, P>
{
    /// Evaluates a function: its outputs go to arrays, what it returns comes back, or zero.
    pub(crate) fn run<const K: usize>(
        &self,
        code: &'static Code,
        frame: &Frame<S, NQ, L, H, R>,
        mut outputs: [&mut [S]; K],
    ) -> S {
        self.evaluate(code, frame, &mut outputs, &mut |_, _| {}).unwrap_or(S::ZERO)
    }

    /// Evaluates a function of continuation data.
    pub(crate) fn remembered(&self, code: &'static Code, frame: &Frame<S, NQ, L, H, R>) -> (Memory<S, L>, S) {
        let mut memory = Memory::new(self.model.counts);
        let returned = self.evaluate(code, frame, &mut [], &mut |place, value| {
            if let Place::Remembered(k) = place
                && let Some(to) = memory.number_mut(k)
            {
                *to = value;
            }
        });
        (memory, returned.unwrap_or(S::ZERO))
    }

    /// Evaluates a function of the entries of a matrix.
    pub(crate) fn entries(
        &self,
        code: &'static Code,
        frame: &Frame<S, NQ, L, H, R>,
        matrix: &mut [[S; N]; N],
    ) {
        self.evaluate(code, frame, &mut [], &mut |place, value| {
            if let Place::Entry(row, column) = place
                && let Some(entry) = matrix.get_mut(row).and_then(|row| row.get_mut(column))
            {
                *entry = value;
            }
        });
    }

    /// Evaluates a function, by machine code where it has some: its outputs go to arrays, other results to `other`.
    pub(crate) fn evaluate(
        &self,
        code: &'static Code,
        frame: &Frame<S, NQ, L, H, R>,
        outputs: &mut [&mut [S]],
        other: &mut dyn FnMut(Place, S),
    ) -> Option<S> {
        if let Some(value) = self.compute(code, frame, outputs, other) {
            return code.returns().then_some(value);
        }
        code.interpret(&|argument| self.read(argument, frame), outputs, other)
    }

    /// Evaluates a function by machine code, and gives what it returns, or zero; nothing where it has none.
    #[inline]
    pub(crate) fn compute(
        &self,
        code: &'static Code,
        frame: &Frame<S, NQ, L, H, R>,
        outputs: &mut [&mut [S]],
        other: &mut dyn FnMut(Place, S),
    ) -> Option<S> {
        let machine_code = self.machine_code(code)?;
        let (mut own, count): ([&mut [f64]; OUTPUTS], _) = (Default::default(), outputs.len());
        for (to, list) in own.iter_mut().zip(&mut *outputs) {
            *to = S::f64s_mut(list)?;
        }
        let own = own.get_mut(..count)?;
        let list = |list| S::f64s(self.list(list, frame)).unwrap_or_default();
        let gathered = |argument| self.read(argument, frame).to_f64();
        let value = code.compute(
            machine_code,
            self.first_lists(frame),
            &list,
            &gathered,
            own,
            &mut |place, value| other(place, S::lit(value)),
        )?;
        Some(S::lit(value))
    }

    /// The lists of [`FIRST`].
    #[inline]
    fn first_lists<'a>(&'a self, frame: &'a Frame<'a, S, NQ, L, H, R>) -> [&'a [f64]; FIRST.len()] {
        let of = |list: &'a [S]| S::f64s(list).unwrap_or_default();
        let (inputs, switches) =
            frame.held.map_or((&[][..], &[][..]), |held| (of(&held.input), of(&held.switches)));
        let step = frame.beside.map_or(&[][..], |beside| of(beside.step));
        [of(std::slice::from_ref(&frame.t)), of(&self.parameters), inputs, switches, of(frame.x), step]
    }

    /// Machine code of a function; no other scalar than f64 has some.
    #[inline]
    pub(crate) fn machine_code(&self, code: &'static Code) -> Option<&'static dyn MachineCode> {
        S::f64s(&[])?;
        code.machine_code(self.model.translator.get()?)
    }

    /// Values of parameters and the time.
    pub(crate) fn values(&self, t: S, code: &'static Code, count: usize) -> Vec<S> {
        let mut values = vec![S::ZERO; count];
        self.run(code, &Frame::at(t), [&mut values]);
        values
    }

    /// A list of what a function reads; those of the discrete state are empty where none is at hand.
    #[inline]
    fn list<'a>(&'a self, list: List, frame: &'a Frame<'a, S, NQ, L, H, R>) -> &'a [S] {
        match list {
            List::Time => std::slice::from_ref(&frame.t),
            List::Parameters => &self.parameters,
            List::Inputs => frame.held.map_or(&[], |held| &held.input),
            List::Switches => frame.held.map_or(&[], |held| &held.switches),
            List::Multipliers => frame.held.map_or(&[], |held| &held.contact.lambda),
            List::Array(Array::X) => frame.x,
            List::Array(Array::Q) => frame.q,
            List::Array(Array::V) => frame.v,
            List::Array(array) => frame.beside.map_or(&[], |beside| match array {
                Array::A => beside.a,
                Array::Lambda => beside.lambda,
                Array::Weights => beside.weights,
                Array::Residuals => beside.residuals,
                Array::Rates => beside.rates,
                Array::Slip => beside.slip,
                Array::Line => beside.line,
                Array::Force => beside.force,
                Array::Second => beside.second,
                Array::Known => beside.known,
                Array::Step => beside.step,
                Array::X | Array::Q | Array::V => &[],
            }),
            List::Gathered => &[],
        }
    }

    #[inline]
    pub(crate) fn read(&self, argument: Argument, frame: &Frame<S, NQ, L, H, R>) -> S {
        let of = |list, k: usize| self.list(list, frame).get(k).copied().unwrap_or(S::ZERO);
        match argument {
            Argument::Time => frame.t,
            Argument::Parameter(k) => of(List::Parameters, k),
            Argument::Element(array, k) => of(List::Array(array), k),
            Argument::Scalar(number) => of_scalar(number),
            Argument::Input(k) => of(List::Inputs, k),
            Argument::Switch(k) => of(List::Switches, k),
            Argument::Turns(k) => {
                frame.held.and_then(|held| held.turns.get(k)).map_or(S::ZERO, |turns| S::of_turns(*turns))
            }
            Argument::Remembered(k) => match frame.held.map(|held| &held.of_loops) {
                Some(OfLoops::InChart { continuation, .. }) => continuation.number(k),
                _ => S::ZERO,
            },
            Argument::Multiplier(k) => of(List::Multipliers, k),
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

    /// The mechanism with numbers of another type.
    #[doc(hidden)]
    pub fn map<T: Scalar>(&self, number: &impl Fn(S) -> T) -> Dynamic<T, NQ, NC, N, L, H, R, P> {
        Dynamic {
            model: self.model,
            parameters: converted(&self.parameters, T::ZERO, number),
            starts: Starts {
                model: self.model,
                values: converted(&self.starts.values, Start::free(T::ZERO), &|start: Start<S>| {
                    start.map(number)
                }),
            },
        }
    }

    /// The discrete state with numbers of another type.
    pub(crate) fn map_held<T: Scalar>(
        held: &Held<S, NQ, L, H, R>,
        number: &impl Fn(S) -> T,
    ) -> Held<T, NQ, L, H, R> {
        HeldOf {
            input: converted(&held.input, T::ZERO, number),
            switches: converted(&held.switches, T::ZERO, number),
            turns: converted(&held.turns, T::to_turns(T::ZERO), &|turns| {
                T::to_turns(number(S::of_turns(turns)))
            }),
            of_loops: match &held.of_loops {
                OfLoops::InChart { chart, continuation } => {
                    OfLoops::InChart { chart: *chart, continuation: continuation.map(number) }
                }
                OfLoops::Free { q, v } => {
                    OfLoops::Free { q: converted(q, T::ZERO, number), v: converted(v, T::ZERO, number) }
                }
            },
            contact: contact::Held::packed(&held.contact, [&held.contact], &|[value]: [S; 1]| number(value)),
        }
    }

    /// The mechanism and what it holds, without derivatives of what the rate does not depend on: start values and continuation data.
    pub(crate) fn without_derivatives(&self, held: &Held<S, NQ, L, H, R>) -> (Self, Held<S, NQ, L, H, R>)
    where
        S: Real,
    {
        let plain = |number: S| S::of_plain(number.plain());
        let own = self.map(&plain);
        let of_loops = Self::map_held(held, &plain).of_loops;
        (Dynamic { starts: own.starts, ..*self }, HeldOf { of_loops, ..*held })
    }

    /// Has functions computed by machine code of a translator from now on, in all copies of this mechanism. The first translator stays.
    pub fn translate_by(&self, translator: Arc<dyn Translator>) {
        self.model.translate_by(translator);
    }

    /// Is the state in absolute coordinates?
    pub(crate) fn is_absolute(&self) -> bool {
        self.model.lowered.form == Form::Absolute
    }

    /// Are loops solved in charts?
    pub(crate) fn is_charted(&self) -> bool {
        self.model.lowered.form == Form::Loops
    }

    /// The function of guards, then kinks, in the present coordinates.
    pub(crate) fn guards_of_state(&self, held: &Held<S, NQ, L, H, R>) -> Option<&'static Code> {
        match held.of_loops {
            OfLoops::InChart { chart, .. } if !self.is_absolute() => {
                self.model.in_charts.get(chart).map(|chart| &chart.guards)
            }
            _ => Some(&self.model.absolute.guards),
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
