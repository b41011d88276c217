//! The state of a run as numbers: read, set, its rates and their derivatives.

use plm_runtime::events::switch_where_due;
use plm_runtime::held::Discrete;
use plm_runtime::{Cause, Fault, Method, Moment, Sim, Start, StartValues, Vector};
use plm_studies::analysis::{DMatrix, Derivatives, derivatives};

use super::Runnable;

/// Parts of a number by which a state that loops are closed at may differ from the one that was asked for: it is closed to rounding,
/// which a pose near a flat one makes larger.
const CLOSED: f64 = 1e-7;

/// Places of the numbers that a state has.
fn places<M: Runnable>(mechanism: &M) -> impl Iterator<Item = usize> {
    (0..M::X::LEN).filter(|place| mechanism.has_number(*place))
}

/// The names of the numbers of a state, in the present chart.
pub(super) fn names<M: Runnable>(state: &M::State) -> Vec<&'static str> {
    let (mechanism, held) = (state.mechanism(), state.held());
    places(mechanism).map(|index| mechanism.name_in_chart(&held, index)).collect()
}

/// Coordinates, velocities and first-order states, SI.
pub(super) fn numbers<M: Runnable>(state: &M::State) -> Result<Vec<f64>, Fault> {
    regular::<M>(state)?;
    Ok(listed(state.mechanism(), state.x()))
}

/// Sets the state of a run.
pub(super) fn set<M: Runnable, I: Method<M>>(sim: &mut Sim<M, I>, numbers: &[f64]) -> Result<(), Fault> {
    let state = sim.state();
    regular::<M>(state)?;
    let (time, held) = (state.time(), state.held());
    let places: Vec<usize> = places(state.mechanism()).collect();
    if numbers.len() != places.len() || !numbers.iter().all(|number| number.is_finite()) {
        return Err(Fault::new(time, Cause::NotFinite));
    }
    let mut x = M::X::fill(0.0);
    for (place, number) in places.into_iter().zip(numbers) {
        x.set(place, *number);
    }
    let (held, x) = if <M::U as Discrete>::CHARTED {
        closed::<M>(state, &x)?
    } else {
        let (mut held, mut x) = (held, x);
        state.mechanism().state_was_set(time, &mut held, &mut x)?;
        state.mechanism().project(time, &held, &mut x)?;
        (held, x)
    };
    put(sim, held, x)
}

/// Sets a first-order state; false if there is none with this index.
pub(super) fn set_first_order<M: Runnable, I: Method<M>>(
    sim: &mut Sim<M, I>,
    index: usize,
    value: f64,
) -> Result<bool, Fault> {
    let state = sim.state();
    let count = state.mechanism().tables().states.len();
    let (held, mut x) = (state.held(), *state.x());
    if index < count {
        x.set(2 * M::NQ + index, value);
        put(sim, held, x)?;
    }
    Ok(index < count)
}

/// Puts a run into a state, with conditions on the sides on which they are there.
fn put<M: Runnable, I: Method<M>>(sim: &mut Sim<M, I>, mut held: M::U, mut x: M::X) -> Result<(), Fault> {
    let (mechanism, time) = (*sim.state().mechanism(), sim.state().time());
    switch_where_due(&mechanism, time, &mut held, &mut x)?;
    **sim = M::State::new(mechanism, held, time, x);
    Ok(())
}

/// The rates of the states, SI.
pub(super) fn rates<M: Runnable>(state: &M::State) -> Result<Vec<f64>, Fault> {
    regular::<M>(state)?;
    let (mechanism, time, held) = (state.mechanism(), state.time(), state.held());
    let mut rates = *state.x();
    if !mechanism.rate(time, &held, state.x(), &mut rates).is_good() {
        mechanism.rate_by_rank(time, &held, state.x(), &mut rates)?;
    }
    Ok(listed(mechanism, &rates))
}

/// The derivatives of the rates by states and inputs, then those of the declared outputs, in their units.
pub(super) fn jacobian<M: Runnable>(state: &M::State) -> Result<[DMatrix<f64>; 4], Fault> {
    let Derivatives { a, b, c, d, .. } = derivatives(state)?;
    Ok([a, b, c, d])
}

/// Has the state coordinates?
fn regular<M: Runnable>(state: &M::State) -> Result<(), Fault> {
    let mechanism = state.mechanism();
    if mechanism.is_regular(&state.held()) {
        return Ok(());
    }
    Err(Fault::new(state.time(), Cause::Singular { rows: mechanism.states() }))
}

/// Discrete state and state, in the best chart at the pose of a state whose loops are closed.
fn closed<M: Runnable>(state: &M::State, x: &M::X) -> Result<(M::U, M::X), Fault> {
    let (mechanism, time, held) = (*state.mechanism(), state.time(), state.held());
    let wanted = M::full(&M::State::new(mechanism, held, time, *x));
    let open = |gap| Fault::new(time, Cause::Open { gap });
    if !wanted.is_finite() {
        return Err(open(f64::NAN));
    }
    let mut own = mechanism;
    *own.starts_mut() = own.starts_at(&wanted);
    own.starts_mut().each(&mut |_, start| *start = Start::free(start.value));
    let (held, x) = own.start_with_inputs(time, &held)?;
    let found = M::full(&M::State::new(mechanism, held, time, x));
    let gap = (0..M::Full::LEN).fold(0.0, |gap: f64, index| {
        let (found, wanted) = (found.at(index), wanted.at(index));
        gap.max((found - wanted).abs() / (1.0 + wanted.abs()))
    });
    if gap <= CLOSED { Ok((held, x)) } else { Err(open(gap)) }
}

/// The numbers that a state has.
fn listed<M: Runnable>(mechanism: &M, x: &M::X) -> Vec<f64> {
    places(mechanism).map(|index| x.at(index)).collect()
}
