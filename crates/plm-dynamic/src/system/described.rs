//! Names, numbers and outputs by number, for drawing, recording and setting a mechanism.

use plm_runtime::described::{Described, Hole, Shape, Tables};
use plm_runtime::{BodyState, Common, Moment, Ports, Real};

use crate::handle::{Dynamic, Frame, Held};

/// A constant of types that the compiler writes: a mechanism from text has it in its value. Code that asks its type is not built.
#[allow(clippy::panic, reason = "evaluated while rustc compiles")]
pub(super) const fn of_the_value() -> ! {
    panic!(
        "a mechanism from text has its names in its value: `tables()`, `input_names()`, `row_names()`, not `TABLES`, `INPUTS`, `ROWS`"
    )
}

/// Names with their units.
type Named = &'static [(&'static str, &'static str)];

impl<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> Described for Dynamic<S, NQ, NC, N, L, H, R, P>
{
    const TABLES: &'static Tables = of_the_value();
    const OBSERVED: Named = of_the_value();
    const DECLARATION: &'static str = of_the_value();
    const FILES: Named = of_the_value();
    const SHAPES: &'static [Shape] = of_the_value();
    const HOLES: &'static [Hole] = of_the_value();

    fn tables(&self) -> &'static Tables {
        self.model.description.tables
    }

    fn observables(&self) -> Named {
        self.model.description.observed
    }

    fn declaration(&self) -> &'static str {
        self.model.description.declaration
    }

    fn files(&self) -> Named {
        self.model.description.files
    }

    fn shapes(&self) -> &'static [Shape] {
        self.model.description.shapes
    }

    fn holes(&self) -> &'static [Hole] {
        self.model.description.holes
    }

    fn figure(&self, t: S, index: usize) -> Option<S> {
        let (constants, varying) = (&self.model.description.constants, &self.model.description.varying);
        match varying.binary_search_by_key(&index, |(place, _)| *place) {
            Ok(found) => varying.get(found).map(|(_, code)| self.run(code, &Frame::at(t), [])),
            Err(_) => constants.get(index).copied().map(S::lit),
        }
    }

    fn parameter(&self, index: usize) -> Option<S> {
        let own = index < self.model.lowered.parameters.len();
        self.parameters.get(index).copied().filter(|_| own)
    }

    fn parameter_mut(&mut self, index: usize) -> Option<&mut S> {
        let own = index < self.model.lowered.parameters.len();
        self.parameters.get_mut(index).filter(|_| own)
    }

    fn poses(state: &Self::State, each: &mut impl FnMut(BodyState<S>)) {
        let (q, v) = state.unwrapped_pose();
        let bodies = 0..state.mechanism().model.lowered.bodies.len();
        bodies.filter_map(|k| BodyState::among(&q, &v, k)).for_each(each);
    }

    fn observed(state: &Self::State, index: usize) -> Option<S> {
        state.output(index)
    }

    fn observe(
        state: &Self::State,
        quantities: impl IntoIterator<Item = usize>,
        each: &mut impl FnMut(Option<S>),
    ) {
        let common = &Common::new();
        quantities.into_iter().for_each(|index| each(state.output_of(index, common)));
    }

    fn state(state: &Self::State, index: usize) -> Option<S> {
        let own = index < state.mechanism().model.lowered.states.len();
        state.x().get(2 * NQ + index).copied().filter(|_| own)
    }
}

impl<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> Ports for Dynamic<S, NQ, NC, N, L, H, R, P>
{
    /// Room for inputs: after the last one they are zero, and nothing reads them.
    type Input = [S; H];
    const INPUTS: Named = of_the_value();
    const OUTPUTS: Named = of_the_value();

    fn input_names(&self) -> Named {
        self.model.description.inputs
    }

    fn output_names(&self) -> Named {
        self.model.description.outputs
    }

    fn inputs(held: &mut Held<S, NQ, L, H, R>) -> &mut [S; H] {
        &mut held.input
    }

    fn input(input: &mut [S; H], index: usize) -> Option<&mut S> {
        input.get_mut(index)
    }

    fn outputs(state: &Self::State, each: &mut impl FnMut(S)) {
        state.declared(each);
    }
}
