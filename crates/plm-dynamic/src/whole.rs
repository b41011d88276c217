//! Whole steps of explicit formulas as functions: the formula of the runtime is recorded once, with the steps of the rate in each stage.
//!
//! The record has the operations of the formula and of the rates in their order, so that a step has the bits that it has by rates one by
//! one. What one call of machine code computes need not be handed over stage by stage.

use plm_compiler::lowered::{Form, Register, Step};
use plm_runtime::system::OneStep;
use plm_runtime::{Health, Rate, Scalar, Vector};

use crate::code::Code;
use crate::model::Model;
use crate::native::Element;
use crate::places::{Argument, Array};
use crate::recorded::{Record, Recorded, record, register, result};

/// A function of more steps is not worth the time of its translation: its rates by themselves take nearly all of it.
const MOST_STEPS: usize = 6000;

/// The list of the state after the step, and that of the health.
const STATE: usize = 0;
const HEALTH: usize = 1;

/// A mechanism as formulas know it, in numbers that are recorded. They have its rates from elsewhere.
struct Recording<'a, const NQ: usize, const N: usize>(&'a Model);

impl<const NQ: usize, const N: usize> Rate for Recording<'_, NQ, N> {
    type S = Recorded;
    type X = [Recorded; N];
    type U = ();
    const NQ: usize = NQ;

    fn rate(&self, _t: Recorded, _u: &(), _x: &[Recorded; N], _dx: &mut [Recorded; N]) -> Health<Recorded> {
        Health::perfect()
    }

    fn coordinates(&self) -> usize {
        self.0.coordinates
    }

    fn states(&self) -> usize {
        self.0.states()
    }

    fn typical(&self) -> [Recorded; N] {
        Vector::from_fn(|place| Recorded::lit(self.0.typical_at(place)))
    }
}

/// The function of a step of a formula, by a rate: it reads time, length and state, and what the rate reads beside these; it writes the state
/// after the step and the worst health of its rates, and returns how far these are apart. None where it would be too long.
pub(crate) fn whole_step<F: OneStep, const NQ: usize, const N: usize>(
    model: &Model,
    rate: &Code,
) -> Option<Code> {
    if rate.steps().len() as u64 * F::STAGES > MOST_STEPS as u64 {
        return None;
    }
    let system = &Recording::<NQ, N>(model);
    let own = |place: &usize| *place < N && system.has_number(*place);
    let places: Vec<usize> = (0..N).filter(own).collect();
    let mut arguments = vec![Argument::Time, Argument::Element(Array::Step, 0)];
    arguments.extend(places.iter().map(|place| Argument::Element(Array::X, *place)));
    let ahead = arguments.len();
    arguments.extend(rate.arguments());
    let ((elements, returned), steps) = record(|| {
        let all: Vec<Recorded> = (0..arguments.len() as Register).map(argument).collect();
        let mut x = [Recorded::ZERO; N];
        for (place, number) in places.iter().zip(&all[2..]) {
            x[*place] = *number;
        }
        let mut health = Health::perfect();
        let rates = |t: Recorded, x: &[Recorded; N], dx: &mut [Recorded; N]| {
            let read = |k: usize| match arguments[ahead + k] {
                Argument::Time => t,
                Argument::Element(Array::X, place) => x[place],
                _ => all[ahead + k],
            };
            let (rates, returned) = rate.repeated(read);
            for (place, number) in rates {
                dx[place] = number;
            }
            // The rate of a tree solves nothing.
            if let Some(own) = returned.filter(|_| model.lowered.form != Form::Tree) {
                health = health.worst(Health(own));
            }
        };
        let spread = F::one_step(system, (all[0], all[1]), &mut x, rates);
        let mut elements: Vec<(Element, Register)> =
            places.iter().map(|&index| (Element { list: STATE, index }, register(x[index]))).collect();
        elements.push((Element { list: HEALTH, index: 0 }, register(health.0)));
        (elements, register(spread))
    });
    let results = elements.iter().map(|(_, register)| *register).chain([returned]);
    let registers = steps.registers as usize;
    Some(Code::of_steps((needed(steps, results), registers), arguments, elements, returned))
}

fn argument(number: Register) -> Recorded {
    result(plm_compiler::lowered::Operation::Argument(number))
}

/// The steps that results need.
fn needed(record: Record, results: impl Iterator<Item = Register>) -> Vec<Step> {
    let mut is_needed = vec![false; record.registers as usize];
    results.for_each(|register| is_needed[register as usize] = true);
    let mut steps = Vec::with_capacity(record.steps.len());
    for mut step in record.steps.into_iter().rev() {
        if step.results().any(|register| is_needed[register as usize]) {
            step.operation.operands_mut().into_iter().for_each(|operand| is_needed[*operand as usize] = true);
            steps.push(step);
        }
    }
    steps.reverse();
    steps
}
