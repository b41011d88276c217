//! What a package of Python has of a mechanism: a run by number, by a method that is named, which can be ended on its way.
//!
//! `plm::view::wheel` writes such a package.

use std::boxed::Box;
use std::format;
use std::string::String;
use std::vec::Vec;

use plm_foreign::{Foreign, Kind, Status, Trouble};
use plm_runtime::{Described, Fault, Method, Moment, Seen, Sim, StartValues};

use crate::any_sim::{AnySim, OnSim};
pub use crate::integrator::Integrator;
use crate::linearise::{Linearisable, Linearisation, linearise};
use crate::live::by_number;
pub use crate::mistake::BadOption;

/// What can be in a package of Python: every mechanism in `f64`.
pub trait Runnable: Foreign + Linearisable {}

impl<M: Foreign + Linearisable> Runnable for M {}

/// Which method it is, and how exactly.
///
/// # Errors
/// A name that there is not, with the nearest; a tolerance where a longest step is wanted, or the other way round; one that is
/// missing, or not positive.
pub fn method(
    name: &str,
    tolerance: Option<f64>,
    longest_step: Option<f64>,
) -> Result<Integrator, BadOption> {
    let number = tolerance.or(longest_step);
    let text = number.map_or(String::from(name), |number| format!("{name}:{number:e}"));
    let method: Integrator = text.parse()?;
    match (method.is_fixed(), tolerance, longest_step) {
        (true, Some(_), _) => {
            Err(BadOption::new(format!("{name} has steps of fixed length: longest_step, not tolerance")))
        }
        (false, _, Some(_)) => Err(BadOption::new(format!(
            "{name} chooses its steps by their error: tolerance, not longest_step"
        ))),
        _ => Ok(method),
    }
}

/// A run of a mechanism. A copy goes on as the original does, to the bit.
#[derive(Clone)]
pub struct Run<M: Runnable>(Box<AnySim<M>>);

/// Numbers by index, SI.
pub type Numbers = [(usize, f64)];

impl<M: Runnable> Run<M> {
    /// Sets parameters of a declared mechanism, makes the start values of them, sets those that are given, and assembles at a
    /// time, s.
    ///
    /// # Errors
    /// [`Status::NotFinite`], [`Status::NoSuch`]; as [`start_state`](plm_runtime::Mechanism::start_state).
    pub fn start(
        declared: M,
        method: Integrator,
        (parameters, starts): (&Numbers, &Numbers),
        time: f64,
    ) -> Result<Self, Trouble> {
        let mut mechanism = declared;
        finite(time)?;
        for (index, value) in parameters {
            found(mechanism.set_parameter(*index, finite(*value)?).then_some(()))?;
        }
        let mut values = mechanism.declared_starts();
        for (index, value) in starts {
            finite(*value)?;
            let (mut at, mut is_there) = (0, false);
            values.each(&mut |_, start| {
                if at == *index {
                    start.value = *value;
                    is_there = true;
                }
                at += 1;
            });
            found(is_there.then_some(()))?;
        }
        *mechanism.starts_mut() = values;
        Ok(Self(Box::new(method.start_at(mechanism, time)?)))
    }

    /// The time, s.
    pub fn time(&self) -> f64 {
        self.0.state().time()
    }

    /// A number, SI.
    ///
    /// # Errors
    /// [`Status::NoSuch`], of start values too: they belong to the start.
    pub fn get(&self, kind: Kind, index: usize) -> Result<f64, Trouble> {
        let state = self.0.state();
        found(match kind {
            Kind::Parameter => state.mechanism().parameter(index),
            Kind::Input => by_number::input::<M>(state, index),
            Kind::State => <M as Described>::state(state, index),
            Kind::Output => M::observed(state, index),
            Kind::Start | Kind::Body | Kind::Integrated | Kind::Rate => None,
        })
    }

    /// Sets a parameter or an input, SI. A parameter is looked at when the run goes on.
    ///
    /// # Errors
    /// [`Status::NotFinite`], [`Status::NoSuch`]; [`Status::ReadOnly`] of all others.
    pub fn set(&mut self, kind: Kind, index: usize, value: f64) -> Result<(), Trouble> {
        finite(value)?;
        self.get(kind, index)?;
        match kind {
            Kind::Parameter | Kind::Input => self.0.then(Set { kind, index, value }),
            _ => return Err(Status::ReadOnly.into()),
        }
        Ok(())
    }

    /// Pose and velocity of the centre of gravity of a body: x, y (m), angle (rad), vx, vy (m/s), omega (rad/s).
    ///
    /// # Errors
    /// [`Status::NoSuch`]
    pub fn pose(&self, body: usize) -> Result<[f64; 6], Trouble> {
        found(M::pose(self.0.state(), body)).map(|pose| pose.components())
    }

    /// Runs for `dt`, s, with the bits of [`Sim::step`], as long as `goes_on` says so, which is asked with the time, s, after
    /// each internal step.
    ///
    /// # Errors
    /// As [`Sim::step`]; the run is then as it was before the call.
    pub fn step(&mut self, dt: f64, goes_on: &mut dyn FnMut(f64) -> bool) -> Result<(), Fault> {
        self.0.then(Step { dt, goes_on })
    }

    /// Runs until a time, s, with the bits of [`Sim::run`], as long as `goes_on` says so. Gives a column of the times, one of
    /// each observed quantity that is asked for, SI, one row every so many seconds, and how it ended. Where it ended early the
    /// last row is where it came to, and it can go on from there.
    pub fn run(
        &mut self,
        (until, every): (f64, f64),
        quantities: &[usize],
        goes_on: &mut dyn FnMut(f64) -> bool,
    ) -> (Vec<Vec<f64>>, Result<(), Fault>) {
        let columns = std::vec![Vec::new(); 1 + quantities.len()];
        let mut table = Table::<'_> { quantities, columns };
        let outcome = self.0.then(Record { until, every, table: &mut table, goes_on });
        if table.columns.first().and_then(|times| times.last()).is_some_and(|last| *last < self.time())
            && self.time() < until
        {
            table.take::<M>(self.0.state());
        }
        (table.columns, outcome)
    }

    /// As [`linearise`], at the present state.
    ///
    /// # Errors
    /// As [`linearise`].
    pub fn linearise(&self) -> Result<Linearisation, Fault> {
        linearise(self.0.state())
    }
}

fn found<T>(found: Option<T>) -> Result<T, Trouble> {
    found.ok_or(Status::NoSuch.into())
}

fn finite(value: f64) -> Result<f64, Trouble> {
    if value.is_finite() { Ok(value) } else { Err(Status::NotFinite.into()) }
}

/// Sets a parameter or an input.
struct Set {
    kind: Kind,
    index: usize,
    value: f64,
}

impl<M: Runnable> OnSim<M> for Set {
    type Output = ();

    fn on<I: Method<M>>(self, sim: &mut Sim<M, I>) {
        let Self { kind, index, value } = self;
        if kind == Kind::Parameter {
            by_number::set_running_parameter(sim, index, value);
        } else {
            by_number::set_input(sim, index, value);
        }
    }
}

/// A step; after a fault the run is what it was.
struct Step<'a> {
    dt: f64,
    goes_on: &'a mut dyn FnMut(f64) -> bool,
}

impl<M: Runnable> OnSim<M> for Step<'_> {
    type Output = Result<(), Fault>;

    fn on<I: Method<M>>(self, sim: &mut Sim<M, I>) -> Self::Output {
        let before = *sim;
        Sim::step_while(sim, self.dt, self.goes_on).inspect_err(|_| *sim = before)
    }
}

/// Rows of a run, by columns.
struct Table<'a> {
    quantities: &'a [usize],
    columns: Vec<Vec<f64>>,
}

impl Table<'_> {
    fn take<M: Runnable>(&mut self, state: &M::State) {
        let values = self.quantities.iter().map(|index| M::observed(state, *index).unwrap_or(f64::NAN));
        for (column, value) in self.columns.iter_mut().zip(std::iter::once(state.time()).chain(values)) {
            column.push(value);
        }
    }
}

/// A run that is recorded.
struct Record<'a, 'q> {
    until: f64,
    every: f64,
    table: &'a mut Table<'q>,
    goes_on: &'a mut dyn FnMut(f64) -> bool,
}

impl<M: Runnable> OnSim<M> for Record<'_, '_> {
    type Output = Result<(), Fault>;

    fn on<I: Method<M>>(self, sim: &mut Sim<M, I>) -> Self::Output {
        let Self { until, every, table, goes_on } = self;
        let see = |seen: Seen<'_, M::State>| {
            if let Seen::Sample(state) = seen {
                table.take::<M>(state);
            }
        };
        Sim::watch_while(sim, until, every, see, goes_on)
    }
}

#[cfg(test)]
mod tests {
    use std::string::ToString;

    use super::{Integrator, method};

    #[test]
    fn methods_are_told_by_name_and_number() {
        for (name, tolerance, step, said) in [
            ("dop853", None, None, Ok(Integrator::Dop853(1e-9))),
            ("Dopri5", Some(1e-6), None, Ok(Integrator::Dopri5(1e-6))),
            ("rk4", None, Some(1e-3), Ok(Integrator::Rk4(1e-3))),
            ("rk4:2e-3", None, None, Ok(Integrator::Rk4(2e-3))),
            ("rk4", Some(1e-6), None, Err("rk4 has steps of fixed length: longest_step, not tolerance")),
            (
                "dop853",
                None,
                Some(1.0),
                Err("dop853 chooses its steps by their error: tolerance, not longest_step"),
            ),
            (
                "dop853",
                Some(-1.0),
                None,
                Err("Dop853 wants a positive relative tolerance, as in Dop853:1e-9, not `-1e0`"),
            ),
            ("rk4", None, None, Err("Rk4 wants its longest step in seconds, as in Rk4:1e-3")),
        ] {
            let found = method(name, tolerance, step).map_err(|bad| bad.to_string());
            assert_eq!(found, said.map_err(ToString::to_string), "{name}");
        }
    }
}
