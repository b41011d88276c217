//! Derivatives of the outputs of a run, by a run on dual numbers.

use plm_run::{AnySim, Integrator};
use plm_runtime::sim::Seen;
use plm_runtime::{Described, Dual, Fault, Moment, Sim, with_derivatives};

use crate::capacity::{PARAMETERS, ROWS, SWITCHES};
use crate::handle::Dynamic;
use crate::model::Model;
use crate::run::{Error, Mechanism};
use crate::sizes::{Models, with_inputs};
use crate::system::State;

/// A number with its derivative.
type Lifted = Dual<f64, 1>;
/// Mechanisms on such numbers.
type Of<const NQ: usize, const NC: usize, const N: usize, const L: usize> = Dynamic<Lifted, NQ, NC, N, L>;

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
    /// [`observables`](Mechanism::observables), and gives their derivatives. The values have the bits of a run, but after what `max`, `abs`
    /// and the like bend, where steps end; it ends early where `goes_on` says so.
    ///
    /// # Errors
    /// As [`start_with`](Mechanism::start_with).
    pub fn derivative(
        &self,
        by: By,
        method: Integrator,
        times: (f64, f64),
        quantities: &[usize],
        goes_on: &mut dyn FnMut() -> bool,
    ) -> Result<Derivative, Error> {
        self.all_given()?;
        Ok(match self.models {
            Models::Tiny([_, model], _) | Models::Small(model, _) => {
                over(self.lifted::<24, 32, 64, 24>(model, by, method)?, times, quantities, goes_on)
            }
            Models::Large(model) => {
                over(self.lifted::<192, 224, 448, 64>(model, by, method)?, times, quantities, goes_on)
            }
        }?)
    }

    /// A run on numbers with a derivative by one of its own.
    fn lifted<const NQ: usize, const NC: usize, const N: usize, const L: usize>(
        &self,
        model: &'static Model,
        by: By,
        method: Integrator,
    ) -> Result<Box<AnySim<Of<NQ, NC, N, L>>>, Fault> {
        let own = self.given.mechanism::<NQ, NC, N, L, SWITCHES, ROWS, PARAMETERS>(model);
        let name = match by {
            By::Parameter(k) => self.parameters().nth(k).map(|(name, _)| plm_runtime::By::Parameter(name)),
            By::Start(k) => self.starts().get(k).map(|name| plm_runtime::By::Start(name)),
            By::Input(_) => None,
        };
        let named = name.and_then(|name| with_derivatives(&own, [name]).ok());
        let lifted = named.unwrap_or_else(|| own.map(&Dual::constant));
        let mut inputs: Vec<Option<Lifted>> =
            self.given.inputs.iter().map(|given| given.map(Dual::constant)).collect();
        if let By::Input(k) = by
            && let (Some(input), Some(declared)) = (inputs.get_mut(k), lifted.declared_input().get(k))
        {
            *input = Some(Dual::variable(input.unwrap_or(*declared).value, 0));
        }
        Ok(Box::new(method.of(with_inputs(&lifted, &inputs, Dual::constant(self.given.time))?)))
    }
}

/// Runs a simulation until a time with samples.
fn over<const NQ: usize, const NC: usize, const N: usize, const L: usize>(
    mut sim: Box<AnySim<Of<NQ, NC, N, L>>>,
    (until, every): (f64, f64),
    quantities: &[usize],
    goes_on: &mut dyn FnMut() -> bool,
) -> Result<Derivative, Fault> {
    let columns = vec![Vec::new(); quantities.len()];
    let mut derivative = Derivative { times: Vec::new(), values: columns.clone(), slopes: columns };
    let see = |seen: Seen<'_, State<Lifted, NQ, NC, N, L>>| {
        let Seen::Sample(state) = seen else { return };
        derivative.times.push(state.time().value);
        let mut columns = derivative.values.iter_mut().zip(&mut derivative.slopes);
        Of::<NQ, NC, N, L>::observe(state, quantities.iter().copied(), &mut |number| {
            let Dual { value, tangents: [slope] } = number.unwrap_or(Dual::constant(f64::NAN));
            if let Some((values, slopes)) = columns.next() {
                values.push(value);
                slopes.push(slope);
            }
        });
    };
    let [until, every] = [until, every].map(Dual::constant);
    Sim::watch_events_while(&mut sim, until, every, see, |_| goes_on())?;
    Ok(derivative)
}
