//! Inputs and outputs by number: for linearisation, and for coupling mechanisms without their names.

use crate::mechanism::Mechanism;
use crate::system::Rate;

/// The inputs and outputs of a mechanism, in the order of the declaration.
pub trait Ports: Mechanism {
    /// The inputs, as they stand in a simulation.
    type Input;
    /// Names and units of the inputs.
    const INPUTS: &'static [(&'static str, &'static str)];
    /// Names and units of the outputs; a vector is two outputs.
    const OUTPUTS: &'static [(&'static str, &'static str)];

    /// Names and units of the inputs: [`INPUTS`](Self::INPUTS), or those of a mechanism whose type has none, as one from text.
    #[inline]
    fn input_names(&self) -> &'static [(&'static str, &'static str)] {
        Self::INPUTS
    }

    /// Names and units of the outputs.
    #[inline]
    fn output_names(&self) -> &'static [(&'static str, &'static str)] {
        Self::OUTPUTS
    }

    /// The inputs in the discrete state.
    fn inputs(held: &mut <Self as Rate>::U) -> &mut Self::Input;

    /// The input with this index, in SI units; none beyond the last.
    fn input(input: &mut Self::Input, index: usize) -> Option<&mut <Self as Rate>::S>;

    /// Gives `each` the value of every output, in its unit.
    fn outputs(state: &Self::State, each: &mut impl FnMut(<Self as Rate>::S));
}
