//! A method that is chosen by the eigenvalues at the start.

use std::fmt;

use plm_runtime::method::{Context, DenseOutput, ErrorControl, FixedLength, Path, RadauIia5};
use plm_runtime::system::Drift;
use plm_runtime::{Adams, Dop853, Events, Fault, Linear, Method, Moment, Rate, Sim, Vector, Vern9};

use crate::analysis::linearise::{Linearisable, Mode, linearise};

/// How many times faster than the motion that is followed something has to die out until the stiff method costs less.
///
/// The explicit method needs twelve evaluations a step, and steps of at most 6.4 over the fastest decay, whatever the tolerance
/// is; the work of Radau IIA more than doubles for a thousandth of the tolerance. Where both cost alike is measured
/// (examples/auto.rs): at 1e-8 it is 140 times in a creeping mass (two states), 80 in a chain (eight), 60 in a hydraulic
/// arm (six).
fn even(rtol: f64) -> f64 {
    100.0 * (1e-8 / rtol).powf(0.1)
}

/// Tolerance from which on Verner's 9(8) is the cheaper explicit method to the same error, by a tenth to a half in four benchmark
/// scenes (double pendulum, four-bar, slider-crank, Andrews' mechanism), unless something dies out faster than the pace: in
/// each evaluation its region of stability is half that of DOP853.
const NINTH_ORDER_FROM: f64 = 1e-9;

/// States from which on Adams' method of variable order is the cheaper explicit one in smooth runs, where nothing drifts and nothing
/// dies out faster than the pace: rates then take longer than what is remembered of them. A chain of 64 bars (128 states) that
/// hangs takes 0.5 to 0.75 of the time of the cheaper of the others to the same error, one of 16 (32 states) 1.2 to 1.4.
const MULTISTEP_FROM: usize = 100;

/// Damping ratio from which on a motion dies out rather than swings.
const DIES_OUT: f64 = 0.5;
/// Rates below this, 1/s, count as zero.
const STANDS: f64 = 1e-3;

/// Starts that choose their method.
pub trait StartAuto: Linearisable {
    /// Assembles the mechanism at time zero and makes it ready to run, with a relative tolerance of 1e-8 and the method that the
    /// eigenvalues at the start ask for; `sim.method().choice()` says which and why.
    ///
    /// # Errors
    /// As those of `start`.
    fn start_auto(self) -> Result<Sim<Self, Auto<Self>>, Fault> {
        self.start_auto_with(1e-8)
    }

    /// Starts with a relative tolerance of choice.
    ///
    /// # Errors
    /// As those of `start`.
    fn start_auto_with(self, rtol: f64) -> Result<Sim<Self, Auto<Self>>, Fault> {
        let (held, x) = self.start_state(0.0)?;
        let state = Self::State::new(self, held, 0.0, x);
        Ok(Sim::new(state, Auto::new(Choice::at(&state, rtol), rtol)))
    }
}

impl<M: Linearisable> StartAuto for M {}

/// Which method was taken, and why.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice {
    /// Radau IIA rather than an explicit method.
    pub stiff: bool,
    /// Of the explicit methods Verner's 9(8) rather than Dormand and Prince's 8(5,3).
    pub ninth_order: bool,
    /// Of the explicit methods Adams' of variable order.
    pub multistep: bool,
    /// How fast the motion is that has to be followed, 1/s: the fastest that swings or grows, or else the slowest that dies
    /// out; none if nothing moves, or if no linear system describes the start.
    pub pace: Option<Pace>,
    /// How many eigenvalues are faster than the pace by the factor that makes a system stiff, and die out.
    pub fast: usize,
    /// The fastest decay, 1/s; zero if nothing dies out.
    pub decay: f64,
    /// How many times faster than the pace something has to die out until the stiff method is the cheaper one.
    pub even: f64,
}

/// The motion that has to be followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pace {
    /// It swings or grows, by so many 1/s.
    Swings(f64),
    /// It dies out, by so many 1/s.
    DiesOut(f64),
}

impl Pace {
    /// The size of its eigenvalue, 1/s.
    pub fn rate(self) -> f64 {
        let (Self::Swings(rate) | Self::DiesOut(rate)) = self;
        rate
    }
}

impl Choice {
    /// By the linear system at a state; the explicit method where there is none.
    pub fn at<T: Moment<M: Linearisable<State = T>>>(state: &T, rtol: f64) -> Self {
        match linearise(state) {
            Ok(system) => {
                let modes = system.modes();
                let choice = Self::by(&modes, rtol);
                // Guards switch, and each switch is a new beginning; what drifts is projected after many short steps.
                let smooth = <<T::M as Events>::G as Vector<f64>>::LEN == 0;
                let free = modes.len() == <<T::M as Rate>::X as Vector<f64>>::LEN;
                let multistep = modes.len() >= MULTISTEP_FROM && smooth && free && choice.is_calm();
                Self { multistep, ninth_order: choice.ninth_order && !multistep, ..choice }
            }
            Err(_) => Self {
                stiff: false,
                ninth_order: false,
                multistep: false,
                pace: None,
                fast: 0,
                decay: 0.0,
                even: even(rtol),
            },
        }
    }

    /// By eigenvalues, for a relative tolerance.
    pub fn by(modes: &[Mode], rtol: f64) -> Self {
        let moving = || modes.iter().filter(|mode| mode.frequency > STANDS);
        let (dies, swings) =
            (|mode: &&Mode| mode.damping >= DIES_OUT, |mode: &&Mode| mode.damping < DIES_OUT);
        let fastest = moving().filter(swings).map(|mode| mode.frequency).reduce(f64::max).map(Pace::Swings);
        let slowest = moving().filter(dies).map(|mode| mode.frequency).reduce(f64::min).map(Pace::DiesOut);
        let decay = moving().filter(dies).map(|mode| mode.frequency).fold(0.0, f64::max);
        // One that stands still beside a decay is a motion that nothing slows down: some seconds of it are of interest.
        let stands = (moving().count() < modes.len()).then_some(Pace::DiesOut(1.0));
        let slowest = match (slowest, stands) {
            (Some(slowest), Some(stands)) if stands.rate() < slowest.rate() => Some(stands),
            (slowest, _) => slowest,
        };
        let pace = fastest.or(slowest);
        let even = even(rtol);
        let limit = pace.map_or(f64::INFINITY, |pace| even * pace.rate());
        let fast = moving().filter(dies).filter(|mode| mode.frequency > limit).count();
        let choice = Self { stiff: fast > 0, ninth_order: false, multistep: false, pace, fast, decay, even };
        Self { ninth_order: choice.is_calm() && rtol <= NINTH_ORDER_FROM, ..choice }
    }

    /// Something moves, and nothing dies out faster.
    fn is_calm(&self) -> bool {
        self.pace.is_some_and(|pace| self.decay <= pace.rate())
    }
}

impl fmt::Display for Choice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { stiff, pace, fast, decay, even, .. } = self;
        f.write_str(match self {
            Self { stiff: true, .. } => "Radau IIA: ",
            Self { multistep: true, .. } => "Adams: ",
            Self { ninth_order: true, .. } => "Verner 9(8): ",
            _ => "DOP853: ",
        })?;
        let Some(pace) = pace else { return f.write_str("no eigenvalue tells of motion at the start") };
        if *stiff {
            let die = if *fast == 1 { "eigenvalue dies" } else { "eigenvalues die" };
            write!(f, "{fast} {die} out by up to {decay:.2e} 1/s, while ")?;
        }
        match pace {
            Pace::Swings(rate) => write!(f, "what has to be followed swings or grows with {rate:.2e} 1/s")?,
            Pace::DiesOut(rate) => write!(f, "the slowest takes {:.2e} s", 1.0 / rate)?,
        }
        if *stiff {
            return Ok(());
        }
        match *decay {
            0.0 => f.write_str(", and nothing dies out"),
            _ => write!(f, ", and nothing dies out {even:.0} times faster (at most {decay:.2e} 1/s)"),
        }
    }
}

/// The method that was chosen.
#[derive(Clone)]
pub struct Auto<M: Linear> {
    method: Chosen<M>,
    choice: Choice,
}

impl<M: Linear> fmt::Debug for Auto<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Auto").field("choice", &self.choice).finish_non_exhaustive()
    }
}

#[derive(Clone)]
enum Chosen<M: Linear> {
    Explicit(Dop853<M>),
    NinthOrder(Vern9<M>),
    Multistep(Adams<M>),
    Stiff(RadauIia5<M>),
}

impl<M: Linear<S = f64>> Auto<M> {
    /// The method of a choice, with a relative tolerance.
    pub fn new(choice: Choice, rtol: f64) -> Self {
        let method = if choice.stiff {
            Chosen::Stiff(RadauIia5::new(rtol))
        } else if choice.multistep {
            Chosen::Multistep(Adams::new(rtol))
        } else if choice.ninth_order {
            Chosen::NinthOrder(Vern9::new(rtol))
        } else {
            Chosen::Explicit(Dop853::new(rtol))
        };
        Self { method, choice }
    }

    /// Which method it is, and why.
    pub fn choice(&self) -> &Choice {
        &self.choice
    }
}

/// Evaluates an expression on the run, whichever method it has.
macro_rules! whichever {
    ($auto:ident, $method:ident => $value:expr) => {
        match $auto.method {
            Chosen::Explicit(ref $method) => $value,
            Chosen::NinthOrder(ref $method) => $value,
            Chosen::Multistep(ref $method) => $value,
            Chosen::Stiff(ref $method) => $value,
        }
    };
    (mut $auto:ident, $method:ident => $value:expr) => {
        match $auto.method {
            Chosen::Explicit(ref mut $method) => $value,
            Chosen::NinthOrder(ref mut $method) => $value,
            Chosen::Multistep(ref mut $method) => $value,
            Chosen::Stiff(ref mut $method) => $value,
        }
    };
}

impl<M: Linear<S = f64> + Copy> Method<M> for Auto<M> {
    #[inline]
    fn name(&self) -> &'static str {
        "Auto"
    }

    fn advance(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        whichever!(mut self, method => method.advance(context))
    }
    fn restart(&mut self) {
        whichever!(mut self, method => Method::<M>::restart(method));
    }
    fn turned(&mut self) {
        whichever!(mut self, method => Method::<M>::turned(method));
    }
    fn fresh(&self) -> Self {
        let method = match &self.method {
            Chosen::Explicit(method) => Chosen::Explicit(Method::<M>::fresh(method)),
            Chosen::NinthOrder(method) => Chosen::NinthOrder(Method::<M>::fresh(method)),
            Chosen::Multistep(method) => Chosen::Multistep(Method::<M>::fresh(method)),
            Chosen::Stiff(method) => Chosen::Stiff(Method::<M>::fresh(method)),
        };
        Self { method, choice: self.choice }
    }
    fn drift_limit(&self, system: &M) -> Drift<f64> {
        whichever!(self, method => method.drift_limit(system))
    }
}

impl<M: Linear<S = f64> + Copy> DenseOutput<M> for Auto<M> {
    #[inline]
    fn is_dense(&self) -> bool {
        true
    }
    fn densify(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        whichever!(mut self, method => method.densify(context))
    }
    fn interpolate(&self, time: f64) -> M::X {
        whichever!(self, method => method.interpolate(time))
    }
    fn path(&self) -> Option<Path<f64, M::X>> {
        whichever!(self, method => DenseOutput::<M>::path(method))
    }
}

impl<M: Linear<S = f64> + Copy> ErrorControl<M> for Auto<M> {
    fn shorten(&mut self, h: f64) -> bool {
        whichever!(mut self, method => ErrorControl::<M>::shorten(method, h))
    }
    fn most_steps(&self) -> u64 {
        whichever!(self, method => ErrorControl::<M>::most_steps(method))
    }
    fn tolerance(&self) -> Option<f64> {
        whichever!(self, method => ErrorControl::<M>::tolerance(method))
    }
    fn limited_by(&self, system: &M) -> Option<usize> {
        whichever!(self, method => ErrorControl::<M>::limited_by(method, system))
    }
}

impl<M: Linear<S = f64> + Copy> FixedLength<M> for Auto<M> {}
