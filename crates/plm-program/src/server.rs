//! A page that a running program serves itself: it shows the results of the loop, and the program obeys the page.

use std::io;
use std::thread;
use std::time::{Duration, Instant};

use plm_runtime::described::by_number::{self, SizeNames};
use plm_runtime::described::pulls::pull_input;
use plm_runtime::{AsMoment, Described, Fault, Method, Moment, Ports, Sim, Statics};
use plm_view::Recorder;
use plm_view::serve::{Host, Message, Pull};

/// A page served to browsers on this machine, for a loop of the user's own: hardware, a controller.
///
/// The page shows the mechanism with its curves as it moves, and has a slider for each input and parameter, pause, step, restart and reset.
/// A browser never delays the loop: [`show`](Self::show) does not wait, and a slow browser gets fewer rows.
///
/// ```no_run
/// plm::mechanism! {
///     pub Pendulum {
///         gravity: 9.81 m/s^2;
///         input torque: N*m = 0;
///         ground { port o: (0, 0) m; }
///         body bob { mass: 1 kg; inertia: 0.01 kg*m^2; port pivot: (0, 1) m; start angle: 30 deg, locked; }
///         revolute hinge(ground.o, bob.pivot) { drive: torque; }
///     }
/// }
///
/// fn main() -> Result<(), Box<dyn std::error::Error>> {
///     let mut sim = Pendulum::new().start()?;
///     let mut server = plm::view::Server::start(&sim, 0)?;
///     println!("{}", server.url());
///     loop {
///         server.obey(&mut sim);
///         if server.wait_for_step(0.005) {
///             // Here a controller would read sensors and set `sim.input`.
///             match sim.step(0.005) {
///                 Ok(()) => server.show(&sim),
///                 Err(fault) => server.stop(&fault),
///             }
///         }
///     }
/// }
/// ```
#[derive(Debug)]
pub struct Server<M> {
    host: Host,
    declared: M,
    numbers: Vec<f64>,
    runs: bool,
    /// Steps were asked for up to this time, s.
    goal: Option<f64>,
    speed: f64,
    pull: Option<Pull>,
    /// When the next step is due.
    due: Instant,
    has_trouble: bool,
}

/// A step is waited for no longer, so that messages are heard.
const LONGEST_WAIT: Duration = Duration::from_millis(50);
/// While it is paused it is listened so often.
const PAUSE: Duration = Duration::from_millis(10);
/// A loop that is later than this does not catch up.
const MOST_LATE: Duration = Duration::from_millis(100);

impl<M: Described<S = f64> + Statics> Server<M> {
    /// Begins to serve the page of a run on a port of the loopback interface; 0 leaves the choice to the system. Bodies can be
    /// pulled where the mechanism has the inputs of `plm::live::with_pulls`.
    ///
    /// # Errors
    /// If the port cannot be had.
    pub fn start<I: Method<M>>(sim: &Sim<M, I>, port: u16) -> io::Result<Self> {
        let mut described = Recorder::observing_all(sim).into_recording();
        described.about.method = String::from("served by a program");
        let pulls = pull_input(sim.state().mechanism(), 0, "x").is_some();
        let host = Host::start(&described, port, pulls)?;
        let mut server = Self {
            host,
            declared: *sim.state().mechanism(),
            numbers: Vec::new(),
            runs: true,
            goal: None,
            speed: 1.0,
            pull: None,
            due: Instant::now(),
            has_trouble: false,
        };
        server.begin(sim);
        server.host.running(true, 1.0);
        Ok(server)
    }

    /// Address of the page: `http://127.0.0.1:40123/`.
    pub fn url(&self) -> String {
        format!("http://{}/", self.host.address())
    }

    /// Shows a moment as the next row.
    pub fn show(&mut self, of: &impl AsMoment<State = M::State>) {
        let state = of.as_moment();
        self.numbers.clear();
        by_number::moment::<M>(state, &mut |number| self.numbers.push(number));
        self.host.row(&self.numbers);
        if self.goal.is_some_and(|goal| state.time() >= goal) {
            self.goal = None;
        }
    }

    /// Stands still because of a fault, and shows it; something has to be changed in the page before it runs again.
    pub fn stop(&mut self, fault: &Fault) {
        self.set_running(false);
        self.has_trouble = true;
        let (part, text) = (fault.part.to_owned(), fault.cause.to_string());
        self.host.trouble(Some(&plm_view::Fault { time: fault.time, part, text }));
    }

    /// True if the loop is to step: while it is paused only for single steps.
    pub fn is_running(&self) -> bool {
        self.runs || self.goal.is_some()
    }

    /// How many seconds of the run go into a second, as chosen in the page; 1 at first.
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// The next message from the page, for a loop that handles messages by itself; `None` if there is none.
    pub fn message(&self) -> Option<Message> {
        self.host.message()
    }

    /// Handles all messages from the page: see [`apply`](Self::apply).
    pub fn obey<I: Method<M>>(&mut self, sim: &mut Sim<M, I>) {
        while let Some(message) = self.message() {
            self.apply(message, sim);
        }
        if let Some(pull) = self.pull {
            pull_by(sim, &pull);
        }
    }

    /// Does what a message says: sets an input, a parameter with the starts that are made of it, begins again, remembers that
    /// it pauses. What the mechanism does not have is left alone.
    pub fn apply<I: Method<M>>(&mut self, message: Message, sim: &mut Sim<M, I>) {
        match message {
            Message::Run => self.set_running(true),
            Message::Pause => self.set_running(false),
            Message::Step { dt, count } => {
                self.set_running(false);
                // A little less, so that rounding does not add a step.
                self.goal = Some(sim.state().time() + dt * (f64::from(count) - 1e-6));
            }
            Message::Speed { speed } => {
                self.speed = speed;
                self.host.running(self.runs, speed);
            }
            Message::Input { index, value } => {
                by_number::set_input(sim, index, value);
                self.tell_settings(sim);
            }
            Message::Parameter { index, value } => {
                by_number::set_running_parameter(sim, index, value);
                // At the start it acts on the assembly at once.
                if sim.state().time() == 0.0 { self.restart(sim) } else { self.tell_settings(sim) }
            }
            Message::Pull { pull } => {
                if let Some(before) = self.pull {
                    set_wrench(sim, before.body, [0.0; 3]);
                }
                self.pull = pull;
            }
            Message::Restart => self.restart(sim),
            Message::Reset => match self.declared.start_with(sim.method().fresh()) {
                Ok(started) => {
                    *sim = started;
                    self.begin(sim);
                }
                Err(fault) => self.stop(&fault),
            },
        }
        let is_change = !matches!(message, Message::Pause | Message::Speed { .. });
        if is_change && self.has_trouble && self.is_running() {
            self.end_trouble();
        }
    }

    /// Waits for the next step of `dt`, s of the run, and says whether it is to be made now: by the clock, times the speed; not
    /// while it is paused. It waits no longer than 50 ms, so that messages are heard. A loop that is late is not waited for, and
    /// one that is more than a tenth of a second late does not catch up.
    pub fn wait_for_step(&mut self, dt: f64) -> bool {
        let now = Instant::now();
        if self.goal.is_some() {
            self.due = now;
            return true;
        }
        if !self.runs {
            self.due = now;
            thread::sleep(PAUSE);
            return false;
        }
        let earliest = now.checked_sub(MOST_LATE).unwrap_or(now);
        let due = self.due.max(earliest);
        let wait = due.saturating_duration_since(now);
        thread::sleep(wait.min(LONGEST_WAIT));
        if wait > LONGEST_WAIT {
            return false;
        }
        let turn = Duration::try_from_secs_f64(dt / self.speed).unwrap_or(LONGEST_WAIT);
        self.due = due + turn;
        true
    }

    /// Begins again with parameters and inputs as they are.
    fn restart<I: Method<M>>(&mut self, sim: &mut Sim<M, I>) {
        let inputs: Vec<Option<f64>> = inputs(sim.state()).collect();
        let outcome = sim.reset();
        for (index, value) in inputs.into_iter().enumerate() {
            if let Some(value) = value {
                by_number::set_input(sim, index, value);
            }
        }
        match outcome {
            Ok(()) => self.begin(sim),
            Err(fault) => {
                self.stop(&fault);
                self.tell_settings(sim);
            }
        }
    }

    /// Reports to the page that it is at its start.
    fn begin<I: Method<M>>(&mut self, sim: &Sim<M, I>) {
        self.goal = None;
        self.numbers.clear();
        by_number::moment::<M>(sim.state(), &mut |number| self.numbers.push(number));
        self.host.began(&self.numbers, true);
        self.end_trouble();
        self.tell_settings(sim);
    }

    fn end_trouble(&mut self) {
        self.has_trouble = false;
        self.host.trouble(None);
    }

    fn tell_settings<I: Method<M>>(&self, sim: &Sim<M, I>) {
        let (state, mut shape) = (sim.state(), Vec::new());
        let mechanism = state.mechanism();
        let parameters = 0..mechanism.tables().parameters.len();
        let parameters = parameters.map(|k| mechanism.parameter(k).unwrap_or(f64::NAN));
        let inputs = inputs(state).map(|input| input.unwrap_or(f64::NAN));
        by_number::shape(mechanism, &mut |number| shape.push(number));
        let (parameters, inputs): (Vec<_>, Vec<_>) = (parameters.collect(), inputs.collect());
        self.host.settings(&parameters, &inputs, (&shape, &SizeNames::of(mechanism).to_string()));
    }

    fn set_running(&mut self, runs: bool) {
        self.goal = None;
        self.runs = runs;
        self.host.running(runs, self.speed);
    }
}

/// All inputs of a run, SI.
fn inputs<T: Moment<M: Described<S = f64, State = T>>>(state: &T) -> impl Iterator<Item = Option<f64>> {
    let count = state.mechanism().input_names().len();
    (0..count).map(|k| by_number::input::<T::M>(state, k))
}

/// The pull as it is with the body where it is now.
fn pull_by<M: Described<S = f64>, I: Method<M>>(sim: &mut Sim<M, I>, pull: &Pull) {
    let Some(pose) = M::pose(sim.state(), pull.body) else { return };
    let wrench = pull.wrench([pose.x, pose.y, pose.angle], [pose.vx, pose.vy, pose.omega]);
    set_wrench(sim, pull.body, wrench);
}

fn set_wrench<M: Described<S = f64>, I: Method<M>>(sim: &mut Sim<M, I>, body: usize, wrench: [f64; 3]) {
    for (suffix, value) in ["x", "y", "turn"].into_iter().zip(wrench) {
        if let Some(index) = pull_input(sim.state().mechanism(), body, suffix) {
            by_number::set_input(sim, index, value);
        }
    }
}
