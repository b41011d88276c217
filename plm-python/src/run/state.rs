//! The state of a run as numbers: read, set, its rates and their derivatives.

use plm_analysis::{DMatrix, Derivatives, Linearisation, derivatives, linearise};
use plm_runtime::events::switch_where_due;
use plm_runtime::{Cause, Fault, Moment, Start, StartValues, Vector};

use super::{Put, Run, Runnable};

/// Parts of a number by which a state that loops are closed at may differ from the one that was asked for: it is closed to rounding,
/// which a pose near a flat one makes larger.
const CLOSED: f64 = 1e-7;

impl<M: Runnable> Run<M> {
    /// The names of the numbers of [`state`](Self::state), in the chart that is held.
    pub fn state_names(&self) -> Vec<&'static str> {
        let (state, held) = (self.0.state(), self.0.state().held());
        (0..M::X::LEN).map(|index| state.mechanism().name_in_chart(&held, index)).collect()
    }

    /// Coordinates, velocities and first-order states, SI.
    ///
    /// # Errors
    /// [`Cause::Singular`]: next to a flat pose of a loop no coordinates are good.
    pub fn state(&self) -> Result<Vec<f64>, Fault> {
        self.regular()?;
        Ok(numbers(self.0.state().x()))
    }

    /// Sets it. Loops are closed on the mirror image on which they are, and what is off the constraints is projected onto them.
    ///
    /// # Errors
    /// [`Cause::NotFinite`]: a number is none, or there are not as many as there are states. [`Cause::Open`]: loops cannot be closed
    /// there. The run is then what it was.
    pub fn set_state(&mut self, numbers: &[f64]) -> Result<(), Fault> {
        let state = self.regular()?;
        let (time, held) = (state.time(), state.held());
        if numbers.len() != M::X::LEN || !numbers.iter().all(|number| number.is_finite()) {
            return Err(Fault::new(time, Cause::NotFinite));
        }
        let x = M::X::from_fn(|index| numbers.get(index).copied().unwrap_or_default());
        let (held, x) = if <M::U as plm_runtime::held::Discrete>::CHARTED {
            closed::<M>(state, &x)?
        } else {
            let (mut held, mut x) = (held, x);
            state.mechanism().state_was_set(time, &mut held, &mut x)?;
            state.mechanism().project(time, &held, &mut x)?;
            (held, x)
        };
        self.put(held, x)
    }

    /// Sets a first-order state; false if there is none with this index.
    ///
    /// # Errors
    /// When no mode applies there.
    pub(super) fn set_first_order(&mut self, index: usize, value: f64) -> Result<bool, Fault> {
        let (state, count) = (self.0.state(), M::TABLES.states.len());
        let (held, mut x) = (state.held(), *state.x());
        if index < count {
            x.set(M::X::LEN - count + index, value);
            self.put(held, x)?;
        }
        Ok(index < count)
    }

    /// Puts the run into a state, with conditions on the sides on which they are there.
    ///
    /// # Errors
    /// When no mode applies there.
    fn put(&mut self, mut held: M::U, mut x: M::X) -> Result<(), Fault> {
        let state = self.0.state();
        switch_where_due(state.mechanism(), state.time(), &mut held, &mut x)?;
        self.0.then(Put { held, x });
        Ok(())
    }

    /// The rates of the states, SI.
    ///
    /// # Errors
    /// [`Cause::Singular`]: they are not determined.
    pub fn rates(&self) -> Result<Vec<f64>, Fault> {
        let state = self.regular()?;
        let (mechanism, time, held) = (state.mechanism(), state.time(), state.held());
        let mut rates = *state.x();
        if !mechanism.rate(time, &held, state.x(), &mut rates).is_good() {
            mechanism.rate_by_rank(time, &held, state.x(), &mut rates)?;
        }
        Ok(numbers(&rates))
    }

    /// The derivatives of the rates by states and inputs, then those of the declared outputs, in their units.
    ///
    /// # Errors
    /// As [`linearise`].
    pub fn jacobian(&self) -> Result<[DMatrix<f64>; 4], Fault> {
        let Derivatives { a, b, c, d, .. } = derivatives(self.0.state())?;
        Ok([a, b, c, d])
    }

    /// As [`linearise`], at the present state.
    ///
    /// # Errors
    /// As [`linearise`].
    pub fn linearise(&self) -> Result<Linearisation, Fault> {
        linearise(self.0.state())
    }

    /// The moment, where the state has coordinates.
    fn regular(&self) -> Result<&M::State, Fault> {
        let state = self.0.state();
        if state.mechanism().is_regular(&state.held()) {
            Ok(state)
        } else {
            Err(Fault::new(state.time(), Cause::Singular { rows: M::X::LEN }))
        }
    }
}

/// What is held, and the state, in the best chart at the pose of a state whose loops are closed.
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

fn numbers<X: Vector<f64>>(vector: &X) -> Vec<f64> {
    (0..X::LEN).map(|index| vector.at(index)).collect()
}
