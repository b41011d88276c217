//! Directional derivatives by dual numbers.

use alloc::vec::Vec;

use plm_runtime::{Cause, Described, Dual, Fault, Linear, Moment, Ports, Rate, Vector};

use super::{Exchanged, Variable};
use crate::{Error, Status};

/// Derivatives of `unknowns` (rates and outputs) along `seeds` of `knowns` (time, states, inputs, parameters), exact but for rounding.
///
/// # Errors
/// [`Status::NoSuch`] for other variables; [`Status::NotFinite`] for seeds that are no numbers; a fault where the rate needs a solution by rank.
pub(super) fn along<M: Exchanged>(
    state: &M::State,
    knowns: &[(Variable, f64)],
    unknowns: &[Variable],
) -> Result<Vec<f64>, Error> {
    type Lifted<M> = <M as Linear>::Lifted<1>;
    if !knowns.iter().all(|(_, seed)| seed.is_finite()) {
        return Err(Status::NotFinite.into());
    }
    let (mut lifted, mut held) = state.mechanism().lift::<1>(&state.held());
    let mut x =
        <<Lifted<M> as Rate>::X as Vector<Dual<f64, 1>>>::from_fn(|i| Dual::constant(state.x().at(i)));
    let mut time = Dual::constant(state.time());
    for (known, seed) in knowns {
        let moved = |number: Dual<f64, 1>| Dual { value: number.value, tangents: [*seed] };
        match *known {
            Variable::Time => time = moved(time),
            Variable::State(i) => x.set(i, moved(x.at(i))),
            Variable::Input(i) => {
                let input = <Lifted<M>>::input(<Lifted<M>>::inputs(&mut held), i).ok_or(Status::NoSuch)?;
                *input = moved(*input);
            }
            Variable::Parameter(i) => {
                let parameter = lifted.parameter_mut(i).ok_or(Status::NoSuch)?;
                *parameter = moved(*parameter);
            }
            _ => return Err(Status::NoSuch.into()),
        }
    }
    let mut rate = x;
    let health = lifted.rate(time, &held, &x, &mut rate);
    if !health.is_good() {
        let rows = <M as Rate>::X::LEN;
        return Err(Fault::new(state.time(), Cause::Singular { rows }).into());
    }
    let moment = <Lifted<M> as plm_runtime::Mechanism>::State::new(lifted, held, time, x);
    let tangent = |unknown: &Variable| match *unknown {
        Variable::Rate(i) => Some(rate.at(i)),
        Variable::Output(i) => <Lifted<M>>::observed(&moment, i),
        _ => None,
    };
    let tangents = unknowns.iter().map(|unknown| tangent(unknown).map(|number| number.tangents[0]));
    tangents.map(|tangent| tangent.ok_or(Status::NoSuch.into())).collect()
}
