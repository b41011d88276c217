//! What both programs run: assembly, each method of integration, and the solution by rank, in both precisions.

#[path = "pendulum.rs"]
mod pendulum;

use pendulum::Pendulum;
use plm_runtime::method::{Dopri5, Method, Rk4, SemiImplicitEuler};
use plm_runtime::{Fault, Mechanism, Moment, Real, Scalar, Vector};

/// Gives the bits of time and state at some moments of some runs.
///
/// # Errors
/// If the mechanism cannot be assembled or moved.
pub fn run(mut emit: impl FnMut(u64)) -> Result<(), Fault> {
    by_every_method::<f64>(&mut emit)?;
    by_every_method::<f32>(&mut emit)
}

fn by_every_method<S: Real>(emit: &mut impl FnMut(u64)) -> Result<(), Fault> {
    let locked = Pendulum::<S>::new();
    moments(locked, SemiImplicitEuler::new(S::lit(1e-3)), emit)?;
    moments(locked, Rk4::new(S::lit(1e-3)), emit)?;
    let unlocked = Pendulum { locked: false, ..locked };
    moments(unlocked, Dopri5::default(), emit)
}

/// Half a second, with a look at the state every 50 ms; then the rate by rank where that ended.
fn moments<M: Mechanism>(
    mechanism: M,
    method: impl Method<M>,
    emit: &mut impl FnMut(u64),
) -> Result<(), Fault> {
    let mut emit_all = |time: M::S, numbers: &M::X| {
        emit(time.to_f64().to_bits());
        for index in 0..M::X::LEN {
            emit(numbers.at(index).to_f64().to_bits());
        }
    };
    let mut sim = mechanism.start_with(method)?;
    sim.run(M::S::lit(0.5), M::S::lit(0.05), |state| emit_all(state.time(), state.x()))?;

    let state = sim.state();
    let mut rate = *state.x();
    mechanism.rate_by_rank(state.time(), state.input(), state.x(), &mut rate)?;
    emit_all(state.time(), &rate);
    Ok(())
}
