//! Which functions may be called when: the states of an FMU.
//!
//! FMI 3.0.2, sections 2.3 (states in common), 3.2 (model exchange), 4.2 (co-simulation): "Allowed Function Calls"; FMI 2.0.5,
//! sections 3.2.3 and 4.2.4. The protocol is that of 3.0; what 2.0 allows beyond it stands in [`Call::also_in_two`].

use core::fmt;

use plm_runtime::words::{InWords, Words};

use super::Version;
use super::version::Function;
use Mode::{ContinuousTime, Event, Initialization, Instantiated, Step, Terminated};

/// Purpose of an instance of an FMU.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interface {
    /// Model exchange.
    ModelExchange,
    /// Co-simulation, with event mode or without.
    CoSimulation {
        /// The simulator handles events in event mode.
        has_events: bool,
    },
}

/// Mode of an FMU.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Not started.
    Instantiated,
    /// Initialization Mode
    Initialization,
    /// Event Mode
    Event,
    /// Continuous-Time Mode
    ContinuousTime,
    /// Step Mode
    Step,
    /// Ended.
    Terminated,
}

/// The modes between the start and the end.
const INITIALIZED: [Mode; 3] = [Event, ContinuousTime, Step];
/// The modes in which equations hold.
const COMPUTED: [Mode; 5] = [Initialization, Event, ContinuousTime, Step, Terminated];

impl Mode {
    /// All modes.
    pub const ALL: [Self; 6] = [Instantiated, Initialization, Event, ContinuousTime, Step, Terminated];
}

/// A function that is not allowed in every mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Call {
    /// `fmi2SetupExperiment`, of 2.0 alone; in 3.0 its arguments are those of the next one.
    SetupExperiment,
    /// `fmi3EnterInitializationMode`
    EnterInitializationMode,
    /// `fmi3ExitInitializationMode`
    ExitInitializationMode,
    /// `fmi3EnterEventMode`
    EnterEventMode,
    /// `fmi3EnterContinuousTimeMode`
    EnterContinuousTimeMode,
    /// `fmi3EnterStepMode`
    EnterStepMode,
    /// `fmi3Terminate`
    Terminate,
    /// `fmi3GetFloat64`, `fmi3GetInt64`
    Get,
    /// `fmi3SetFloat64`, `fmi3SetInt64`
    Set,
    /// `fmi3GetDirectionalDerivative`
    GetDirectionalDerivative,
    /// `fmi3UpdateDiscreteStates`
    UpdateDiscreteStates,
    /// `fmi3CompletedIntegratorStep`
    CompletedIntegratorStep,
    /// `fmi3SetTime`
    SetTime,
    /// `fmi3SetContinuousStates`
    SetContinuousStates,
    /// `fmi3GetContinuousStates`
    GetContinuousStates,
    /// `fmi3GetContinuousStateDerivatives`
    GetContinuousStateDerivatives,
    /// `fmi3GetEventIndicators`
    GetEventIndicators,
    /// `fmi3GetNominalsOfContinuousStates`
    GetNominalsOfContinuousStates,
    /// `fmi3GetNumberOfContinuousStates`
    GetNumberOfContinuousStates,
    /// `fmi3GetNumberOfEventIndicators`
    GetNumberOfEventIndicators,
    /// `fmi3DoStep`
    DoStep,
    /// `fmi2GetRealStatus` and others of 2.0 alone.
    GetStatus,
}

impl Call {
    /// The modes in which it may be called, and whether in one of the interfaces alone.
    fn modes(self) -> (&'static [Mode], Option<bool>) {
        let (exchange, co_simulation) = (Some(true), Some(false));
        match self {
            Self::SetupExperiment | Self::EnterInitializationMode => (&[Instantiated], None),
            Self::ExitInitializationMode => (&[Initialization], None),
            Self::EnterEventMode => (&[ContinuousTime, Step], None),
            Self::EnterContinuousTimeMode => (&[Event], exchange),
            Self::EnterStepMode => (&[Event], co_simulation),
            Self::Terminate => (&INITIALIZED, None),
            Self::Get => (&Mode::ALL, None),
            Self::Set => (&[Instantiated, Initialization, Event, ContinuousTime, Step], None),
            Self::GetDirectionalDerivative => (&COMPUTED, None),
            Self::UpdateDiscreteStates => (&[Event], None),
            Self::CompletedIntegratorStep | Self::SetTime | Self::SetContinuousStates => {
                (&[ContinuousTime], exchange)
            }
            Self::GetContinuousStates
            | Self::GetContinuousStateDerivatives
            | Self::GetEventIndicators
            | Self::GetNominalsOfContinuousStates => (&COMPUTED, exchange),
            // Constants of the FMU; the standard lists them where they could have changed.
            Self::GetNumberOfContinuousStates | Self::GetNumberOfEventIndicators => (&Mode::ALL, exchange),
            Self::DoStep => (&[Step], co_simulation),
            Self::GetStatus => (&[Step, Terminated], co_simulation),
        }
    }

    /// The modes in which 2.0 allows it, and 3.0 does not.
    fn also_in_two(self) -> &'static [Mode] {
        match self {
            Self::EnterEventMode => &[Event],
            Self::GetNominalsOfContinuousStates => &[Instantiated],
            _ => &[],
        }
    }

    /// May it be called?
    pub fn is_allowed(self, version: Version, interface: Interface, mode: Mode) -> bool {
        let (modes, exchange) = self.modes();
        let is_in_two = version == Version::Two && self.also_in_two().contains(&mode);
        let has_events = interface != Interface::CoSimulation { has_events: false };
        let fits = exchange.is_none_or(|exchange| exchange == (interface == Interface::ModelExchange));
        fits && (modes.contains(&mode) || is_in_two) && (has_events || self != Self::EnterEventMode)
    }

    /// The mode after it.
    pub(super) fn leads(self, interface: Interface, mode: Mode) -> Mode {
        match self {
            Self::EnterInitializationMode => Initialization,
            Self::ExitInitializationMode if interface == (Interface::CoSimulation { has_events: false }) => {
                Step
            }
            Self::ExitInitializationMode | Self::EnterEventMode => Event,
            Self::EnterContinuousTimeMode => ContinuousTime,
            Self::EnterStepMode => Step,
            Self::Terminate => Terminated,
            _ => mode,
        }
    }
}

/// A call that is not allowed.
pub(super) struct NotAllowed(pub(super) Version, pub(super) Call, pub(super) Interface, pub(super) Mode);

impl fmt::Display for NotAllowed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(version, call, interface, mode) = *self;
        let name = match interface {
            Interface::ModelExchange => "model exchange",
            Interface::CoSimulation { has_events: true } => "co-simulation with event mode",
            Interface::CoSimulation { has_events: false } => "co-simulation without event mode",
        };
        let function = Function(version, call);
        write!(f, "{function} is not allowed in the mode {mode:?} of {name}; it is allowed in")?;
        let allowed = Mode::ALL.into_iter().filter(|mode| call.is_allowed(version, interface, *mode));
        let reached = allowed.filter(|mode| mode.is_of(interface));
        let count =
            reached.map(|mode| write!(f, " {mode:?}")).try_fold(0, |count, done| done.map(|()| count + 1))?;
        if count == 0 { f.write_str(" none") } else { Ok(()) }
    }
}

impl Mode {
    /// Is there such a mode?
    fn is_of(self, interface: Interface) -> bool {
        match self {
            Step => interface != Interface::ModelExchange,
            ContinuousTime => interface == Interface::ModelExchange,
            Event => interface != Interface::CoSimulation { has_events: false },
            _ => true,
        }
    }
}

/// Writes or reads the place of a value among all; an unknown place leaves the value unchanged.
pub(super) fn place<T: Copy + PartialEq>(own: &mut T, all: &[T], words: &mut impl Words) {
    let mut place = all.iter().position(|one| one == own).unwrap_or_default() as u64;
    words.word(&mut place);
    *own = usize::try_from(place).ok().and_then(|place| all.get(place)).copied().unwrap_or(*own);
}

impl InWords for Mode {
    fn each(&mut self, words: &mut impl Words) {
        place(self, &Self::ALL, words);
    }
}

impl InWords for Interface {
    fn each(&mut self, words: &mut impl Words) {
        let co_simulation = [false, true].map(|has_events| Self::CoSimulation { has_events });
        place(self, &[Self::ModelExchange, co_simulation[0], co_simulation[1]], words);
    }
}
