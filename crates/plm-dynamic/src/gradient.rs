//! Derivatives of the outputs of a run, by a run on dual numbers.

use plm_run::Integrator;
use plm_runtime::sim::Seen;
use plm_runtime::{Described, Dop853, Dual, Fault, Method, Moment, Rk4, Sim, with_derivatives};

use crate::capacity::{PARAMETERS, ROWS, SWITCHES};
use crate::handle::Dynamic;
use crate::model::Model;
use crate::run::{Error, Mechanism};
use crate::sizes::{Models, with_inputs};

/// A number with its derivative.
type Lifted = Dual<f64, 1>;
/// Mechanisms of at most 8 bodies on such numbers.
type Small = Dynamic<Lifted, 24, 32, 64, 24>;

/// Variable of differentiation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// A parameter by its number.
    Parameter(usize),
    /// A start value by its number.
    Start(usize),
    /// An input by its number, constant over the run.
    Input(usize),
}

/// Numbers of a run over time, and their derivatives.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Derivative {
    /// Times, s.
    pub times: Vec<f64>,
    /// Of each quantity its values, SI.
    pub values: Vec<Vec<f64>>,
    /// Of each quantity its derivatives, SI.
    pub slopes: Vec<Vec<f64>>,
}

impl Mechanism {
    /// Runs until a time, s, with a sample every so often, s, of quantities by their numbers among
    /// [`observables`](Mechanism::observables), and gives their derivatives; of mechanisms of at most 8 bodies, by `Dop853` and `Rk4`.
    /// The values have the bits of a run, but after what `max`, `abs` and the like bend, where steps end; it ends early where `goes_on` says so.
    ///
    /// # Errors
    /// As [`start_with`](Mechanism::start_with); [`Error::NoDerivative`]; [`Error::Fault`] of the run.
    pub fn derivative(
        &self,
        by: By,
        method: Integrator,
        (until, every): (f64, f64),
        quantities: &[usize],
        goes_on: &mut dyn FnMut() -> bool,
    ) -> Result<Derivative, Error> {
        let (Models::Tiny([_, model], _) | Models::Small(model, _)) = self.models else {
            return Err(Error::NoDerivative);
        };
        self.all_given()?;
        let own = self.lifted(model, by);
        let mut inputs: Vec<Option<Lifted>> =
            self.given.inputs.iter().map(|given| given.map(Dual::constant)).collect();
        if let By::Input(k) = by
            && let (Some(input), Some(declared)) = (inputs.get_mut(k), own.declared_input().get(k))
        {
            *input = Some(Dual::variable(input.unwrap_or(*declared).value, 0));
        }
        let state = with_inputs(&own, &inputs, Dual::constant(self.given.time))?;
        let times = [until, every].map(Dual::constant);
        Ok(match method {
            Integrator::Dop853(rtol) => {
                over(Sim::new(state, Dop853::new(Dual::constant(rtol))), times, quantities, goes_on)
            }
            Integrator::Rk4(h) => {
                over(Sim::new(state, Rk4::new(Dual::constant(h))), times, quantities, goes_on)
            }
            _ => return Err(Error::NoDerivative),
        }?)
    }

    /// The mechanism on numbers with a derivative by one of its own.
    fn lifted(&self, model: &'static Model, by: By) -> Small {
        let own = self.given.mechanism::<24, 32, 64, 24, SWITCHES, ROWS, PARAMETERS>(model);
        let name = match by {
            By::Parameter(k) => self.parameters().nth(k).map(|(name, _)| plm_runtime::By::Parameter(name)),
            By::Start(k) => self.starts().get(k).map(|name| plm_runtime::By::Start(name)),
            By::Input(_) => None,
        };
        let named = name.and_then(|name| with_derivatives(&own, [name]).ok());
        named.unwrap_or_else(|| own.map(&Dual::constant))
    }
}

/// Runs a simulation until a time with samples.
fn over<I: Method<Small>>(
    mut sim: Sim<Small, I>,
    [until, every]: [Lifted; 2],
    quantities: &[usize],
    goes_on: &mut dyn FnMut() -> bool,
) -> Result<Derivative, Fault> {
    let columns = vec![Vec::new(); quantities.len()];
    let mut derivative = Derivative { times: Vec::new(), values: columns.clone(), slopes: columns };
    let see = |seen: Seen<'_, <Small as plm_runtime::Mechanism>::State>| {
        let Seen::Sample(state) = seen else { return };
        derivative.times.push(state.time().value);
        let mut columns = derivative.values.iter_mut().zip(&mut derivative.slopes);
        Small::observe(state, quantities.iter().copied(), &mut |number| {
            let Dual { value, tangents: [slope] } = number.unwrap_or(Dual::constant(f64::NAN));
            if let Some((values, slopes)) = columns.next() {
                values.push(value);
                slopes.push(slope);
            }
        });
    };
    Sim::watch_events_while(&mut sim, until, every, see, |_| goes_on())?;
    Ok(derivative)
}
