//! Steps of fixed length by themselves, as targets make them.

use plm_runtime::contact::{Solution, Stride};
use plm_runtime::{Events, Fault, Health, Moment, MoreauJean, Rate, Real, step};

use crate::handle::Dynamic;
use crate::numbers::Numbers;
use crate::run::{Error, Mechanism};
use crate::sizes::{Large, Models, Small, with_inputs};
use crate::system::State;

/// A mechanism that is taken on by steps of fixed length, one by one, of the classical Runge-Kutta method: conditions change at the end of a
/// step, and nothing else is done within one. It is what compiled code does where a declaration orders `emit: step(rk4)`.
#[derive(Clone, Debug)]
pub struct Steps(OfSize);

#[derive(Clone, Debug)]
enum OfSize {
    Small(Box<State<f64, 24, 32, 64>>),
    Large(Box<State<f64, 192, 224, 448, 64>>),
}

/// Evaluates an expression on the state of any size.
macro_rules! of_each {
    ($steps:expr, $state:ident => $value:expr) => {
        match $steps {
            OfSize::Small($state) => $value,
            OfSize::Large($state) => $value,
        }
    };
}

impl Mechanism {
    /// Assembles it for steps by themselves.
    ///
    /// # Errors
    /// [`Error::NotGiven`], [`Error::Fault`] of assembly.
    pub fn steps(&self) -> Result<Steps, Error> {
        self.all_given()?;
        let given = &self.given;
        Ok(Steps(match self.models {
            Models::Tiny([_, small], _) | Models::Small(small, _) => {
                let own: Small = given.mechanism(small);
                OfSize::Small(Box::new(with_inputs(&own, &given.inputs, given.time)?))
            }
            Models::Large(large) => {
                let own: Large = given.mechanism(large);
                OfSize::Large(Box::new(with_inputs(&own, &given.inputs, given.time)?))
            }
        }))
    }
}

impl Steps {
    /// Makes a step of `h`, s.
    ///
    /// # Errors
    /// Those of [`plm_runtime::step::step`]; the mechanism stays as it was.
    pub fn step(&mut self, h: f64) -> Result<(), Fault> {
        of_each!(&mut self.0, state => one(state, h))
    }

    /// Makes a step of `h`, s, by the time stepping of J. J. Moreau and M. Jean, over impacts and friction: what compiled code does where a
    /// declaration orders `emit: step(moreau_jean)`.
    ///
    /// # Errors
    /// Those of [`plm_runtime::step::moreau_jean`]; the mechanism stays as it was.
    pub fn step_moreau_jean(&mut self, h: f64) -> Result<Solution<f64>, Fault> {
        of_each!(&mut self.0, state => step::moreau_jean::<_, _, 1>(&mut **state, h, MoreauJean::<f64>::THETA))
    }

    /// The coordinates, velocities and first-order states to which the formula of [`step_moreau_jean`](Self::step_moreau_jean) leads from
    /// here in numbers of a type, to which all numbers are rounded.
    ///
    /// # Errors
    /// Those of the step.
    pub fn moreau_jean_in<S: Real>(&self, h: f64) -> Result<Vec<S>, Fault> {
        of_each!(&self.0, state => state.moreau_jean_in(h))
    }

    /// All its numbers.
    pub fn numbers(&self) -> Numbers {
        of_each!(&self.0, state => state.numbers())
    }

    /// An output by its number, declared and observed, SI.
    pub fn output(&self, number: usize) -> Option<f64> {
        of_each!(&self.0, state => state.output(number))
    }
}

fn one<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
>(
    state: &mut State<S, NQ, NC, N, L, H, R, P>,
    h: S,
) -> Result<(), Fault> {
    step::step(state, h, |system, t, held, x| {
        let health: Health<S>;
        (*x, health) = step::rk4(system, t, held, *x, h);
        Ok(health)
    })
}

impl<
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> State<f64, NQ, NC, N, L, H, R, P>
{
    fn moreau_jean_in<S: Real>(&self, h: f64) -> Result<Vec<S>, Fault> {
        let number = |number: f64| S::lit(number);
        let own = self.mechanism().map(&number);
        let mut held = Dynamic::<f64, NQ, NC, N, L, H, R, P>::map_held(&self.held(), &number);
        let mut x = self.x().map(number);
        let stride = Stride { t: number(self.time()), h: number(h), theta: number(MoreauJean::<S>::THETA) };
        own.stride::<1>(&stride, &mut held, &mut x, |_, _, _| Ok(()))?;
        let mechanism = self.mechanism();
        Ok((0..N).filter(|place| mechanism.has_number(*place)).map(|place| x[place]).collect())
    }
}
