//! Observer of a run in progress: polls Ctrl+C, counts steps, and reports steps that stability limits.

use std::io::Write;
use std::time::{Duration, Instant};

use plm_dynamic::{Integrator, Mechanism};

use crate::interrupt;

/// Steps between two reads of the clock.
const LOOK: u64 = 64;
/// A run is slow that has taken so long, ...
const PATIENCE: Duration = Duration::from_secs(2);
/// ... and has so many times as long before it.
const AHEAD: f64 = 5.0;
/// Fewer steps are no reason to think of another method.
const MANY: u64 = 20_000;

/// Follows a run.
pub(super) struct Following<'a> {
    /// Of its start stiffness is asked.
    mechanism: &'a Mechanism,
    /// The run begins there, s.
    begin: f64,
    method: Integrator,
    until: f64,
    clock: Instant,
    steps: u64,
    /// The last step ends there, s.
    time: f64,
    has_told: bool,
    /// Stream for the notice of a stiff run, which is written at once: a run may take hours.
    errors: &'a mut dyn Write,
}

impl<'a> Following<'a> {
    /// A run of a mechanism that begins at a time, s, and has a method and an end, s.
    pub(super) fn new(
        (mechanism, begin): (&'a Mechanism, f64),
        (method, until): (Integrator, f64),
        errors: &'a mut dyn Write,
    ) -> Following<'a> {
        interrupt::wait();
        let clock = Instant::now();
        Following { mechanism, begin, method, until, clock, steps: 0, time: begin, has_told: false, errors }
    }

    /// Does the run go on after a step to this time, s?
    pub(super) fn goes_on(&mut self, time: f64) -> bool {
        self.steps += 1;
        self.time = time;
        if self.steps.is_multiple_of(LOOK) && !self.has_told {
            let taken = self.clock.elapsed();
            let ahead = (self.until - time) / (time - self.begin).max(f64::MIN_POSITIVE);
            if taken > PATIENCE && ahead > AHEAD {
                self.tell();
            }
        }
        !interrupt::came()
    }

    /// The run has ended.
    pub(super) fn end(&mut self) {
        if self.steps > MANY && !self.has_told {
            self.tell();
        }
    }

    /// Writes a notice that the run is stiff, if it is.
    fn tell(&mut self) {
        self.has_told = true;
        let step = (self.time - self.begin) / self.steps as f64;
        if let Some(rate) = stiffness(self.mechanism, self.method, step) {
            // If messages cannot be written, there is no place to report it.
            let _ = writeln!(
                self.errors,
                "plm: notice: at t = {:.3e} s, after {:.1} s of work: stiff; something dies out at {rate:.1e} 1/s, which keeps steps at {step:.1e} s \
                 whatever the tolerance; `--method RadauIia5` takes longer ones",
                self.time,
                self.clock.elapsed().as_secs_f64(),
            );
        }
    }
}

/// The fastest decay at the start, 1/s, where stability by an explicit method holds steps as short as these, s.
#[cfg(feature = "identify")]
fn stiffness(mechanism: &Mechanism, method: Integrator, step: f64) -> Option<f64> {
    let (Integrator::Dop853(tolerance)
    | Integrator::Vern9(tolerance)
    | Integrator::Adams(tolerance)
    | Integrator::Dopri5(tolerance)) = method
    else {
        return None;
    };
    // It was assembled for the run.
    let choice = mechanism.at_start(AtStart(tolerance)).ok()?;
    // The boundary of stability of these methods lies at products between 0.2 (Adams) and 8.
    (choice.stiff && choice.decay * step > 0.1).then_some(choice.decay)
}

/// Without eigenvalues nothing is known.
#[cfg(not(feature = "identify"))]
fn stiffness(_: &Mechanism, _: Integrator, _: f64) -> Option<f64> {
    None
}

/// The choice of a method by the eigenvalues at the start, for a relative tolerance.
#[cfg(feature = "identify")]
struct AtStart(f64);

#[cfg(feature = "identify")]
impl plm_dynamic::OnStart for AtStart {
    type Output = plm_studies::analysis::Choice;

    fn on<M>(self, state: &M::State) -> plm_studies::analysis::Choice
    where
        M: plm_runtime::Described<S = f64, U: plm_runtime::held::Discrete>
            + plm_runtime::Statics
            + plm_runtime::Linear<Lifted<1>: plm_runtime::Described + plm_runtime::Statics>,
    {
        plm_studies::analysis::Choice::at(state, self.0)
    }
}
