//! A run behind a dynamic interface, which hides mechanism and method: all operations that Python needs.

use plm_foreign::{Error, Kind, Status};
use plm_runtime::described::by_number;
use plm_runtime::{Fault, Method, Moment, Notice, Sim, Stats};
use plm_studies::analysis::{DMatrix, Linearisation, linearise};

use super::record::{Asked, NoRoom, Record, record, room, rows};
use super::state;
use super::{Runnable, finite, found, number};

/// Work on a run, whatever its mechanism and its method.
pub trait Work {
    /// Result of the work.
    type Output;

    /// Does it.
    fn on<M: Runnable, I: Method<M>>(self, sim: &mut Sim<M, I>) -> Self::Output;
}

/// Defines a work by its fields, its result, and what it does with a simulation.
macro_rules! work {
    ($name:ident$(<$life:lifetime>)? { $($field:ident: $kind:ty),* } -> $output:ty, |$sim:ident| $value:expr) => {
        struct $name$(<$life>)? { $($field: $kind),* }

        impl$(<$life>)? Work for $name$(<$life>)? {
            type Output = $output;

            fn on<M: Runnable, I: Method<M>>(self, $sim: &mut Sim<M, I>) -> $output {
                let Self { $($field),* } = self;
                $value
            }
        }
    };
}

work!(Time {} -> f64, |sim| sim.state().time());
work!(Get { kind: Kind, index: usize } -> Option<f64>, |sim| number::<M>(sim.state(), kind, index));
work!(Pose { body: usize } -> Option<[f64; 6]>, |sim| M::pose(sim.state(), body).map(|pose| pose.components()));
work!(Set { kind: Kind, index: usize, value: f64 } -> Result<bool, Fault>, |sim| match kind {
    Kind::Parameter => {
        by_number::set_running_parameter(sim, index, value);
        Ok(true)
    }
    Kind::Input => Ok(by_number::set_input(sim, index, value)),
    _ => state::set_first_order(sim, index, value),
});
work!(Step<'a> { dt: f64, goes_on: &'a mut dyn FnMut(f64) -> bool } -> Result<(), Fault>, |sim| {
    let before = sim.clone();
    Sim::step_while(sim, dt, goes_on).inspect_err(|_| *sim = before)
});
work!(Recorded<'a> { asked: Asked<'a>, goes_on: &'a mut dyn FnMut(f64) -> bool } -> (Record, Result<(), Fault>), |sim| {
    record(sim, asked, goes_on)
});
work!(StateNames {} -> Vec<&'static str>, |sim| state::names::<M>(sim.state()));
work!(StateOf {} -> Result<Vec<f64>, Fault>, |sim| state::numbers::<M>(sim.state()));
work!(SetState<'a> { numbers: &'a [f64] } -> Result<(), Fault>, |sim| state::set(sim, numbers));
work!(Rates {} -> Result<Vec<f64>, Fault>, |sim| state::rates::<M>(sim.state()));
work!(Jacobian {} -> Result<[DMatrix<f64>; 4], Fault>, |sim| state::jacobian::<M>(sim.state()));
work!(Linearised {} -> Result<Linearisation, Fault>, |sim| linearise(sim.state()));
work!(Counted {} -> Stats, |sim| sim.stats());
work!(Bodies {} -> usize, |sim| sim.state().mechanism().tables().bodies.len());
work!(Noticed {} -> Vec<Notice>, |sim| Sim::notices(sim).collect());

/// A run by number.
pub trait Running {
    /// Does something with its simulation.
    fn then<W: Work>(&mut self, work: W) -> W::Output;

    /// The time, s.
    fn time(&mut self) -> f64 {
        self.then(Time {})
    }

    /// A number, SI.
    ///
    /// # Errors
    /// [`Status::NoSuch`], of start values too: they belong to the start.
    fn get(&mut self, kind: Kind, index: usize) -> Result<f64, Error> {
        found(self.then(Get { kind, index }))
    }

    /// Sets a parameter, an input or a first-order state, SI. A parameter is checked when the run goes on.
    ///
    /// # Errors
    /// [`Status::NotFinite`], [`Status::NoSuch`]; [`Status::ReadOnly`] of all others.
    fn set(&mut self, kind: Kind, index: usize, value: f64) -> Result<(), Error> {
        finite(value)?;
        self.get(kind, index)?;
        if !matches!(kind, Kind::Parameter | Kind::Input | Kind::State) {
            return Err(Status::ReadOnly.into());
        }
        found(self.then(Set { kind, index, value })?.then_some(()))
    }

    /// Pose and velocity of the centre of gravity of a body: x, y (m), angle (rad), vx, vy (m/s), omega (rad/s).
    ///
    /// # Errors
    /// [`Status::NoSuch`]
    fn pose(&mut self, body: usize) -> Result<[f64; 6], Error> {
        found(self.then(Pose { body }))
    }

    /// Runs for `dt`, s, with the bits of [`Sim::step`], as long as `goes_on` says so, which is asked with the time, s, after
    /// each internal step.
    ///
    /// # Errors
    /// As [`Sim::step`]; the run is then as it was before the call.
    fn step(&mut self, dt: f64, goes_on: &mut dyn FnMut(f64) -> bool) -> Result<(), Fault> {
        self.then(Step { dt, goes_on })
    }

    /// Is there memory for what a run will have?
    ///
    /// # Errors
    /// [`NoRoom`]
    fn has_room(&mut self, asked: &Asked<'_>) -> Result<(), NoRoom> {
        let bodies = if asked.poses { self.then(Bodies {}) } else { 0 };
        let columns = 1 + asked.quantities.len() + 6 * bodies;
        room(rows((self.time(), asked.until), asked.every), columns)
    }

    /// Runs until a time with the bits of [`Sim::run`], as long as `goes_on` says so. Gives what is asked for, what has switched, and
    /// how it ended. Where it ended early the last row is where it came to, and it can go on from there.
    fn run(&mut self, asked: Asked<'_>, goes_on: &mut dyn FnMut(f64) -> bool) -> (Record, Result<(), Fault>) {
        self.then(Recorded { asked, goes_on })
    }

    /// Notices to the user that do not end the run, the most important one first.
    fn notices(&mut self) -> Vec<Notice> {
        self.then(Noticed {})
    }

    /// Counters of the run so far.
    fn stats(&mut self) -> Stats {
        self.then(Counted {})
    }

    /// The names of the numbers of [`state`](Self::state), in the present chart.
    fn state_names(&mut self) -> Vec<&'static str> {
        self.then(StateNames {})
    }

    /// Coordinates, velocities and first-order states, SI.
    ///
    /// # Errors
    /// [`Cause::Singular`](plm_runtime::Cause::Singular): next to a flat pose of a loop no coordinates are good.
    fn state(&mut self) -> Result<Vec<f64>, Fault> {
        self.then(StateOf {})
    }

    /// Sets it. Loops are closed on the mirror image on which they are, and the state is projected onto the constraints.
    ///
    /// # Errors
    /// [`Cause::NotFinite`](plm_runtime::Cause::NotFinite): a number is none, or there are not as many as there are states.
    /// [`Cause::Open`](plm_runtime::Cause::Open): loops cannot be closed there. The run is then what it was.
    fn set_state(&mut self, numbers: &[f64]) -> Result<(), Fault> {
        self.then(SetState { numbers })
    }

    /// The rates of the states, SI.
    ///
    /// # Errors
    /// [`Cause::Singular`](plm_runtime::Cause::Singular): they are not determined.
    fn rates(&mut self) -> Result<Vec<f64>, Fault> {
        self.then(Rates {})
    }

    /// The derivatives of the rates by states and inputs, then those of the declared outputs, in their units.
    ///
    /// # Errors
    /// As [`linearise`].
    fn jacobian(&mut self) -> Result<[DMatrix<f64>; 4], Fault> {
        self.then(Jacobian {})
    }

    /// As [`linearise`], at the present state.
    ///
    /// # Errors
    /// As [`linearise`].
    fn linearise(&mut self) -> Result<Linearisation, Fault> {
        self.then(Linearised {})
    }
}
