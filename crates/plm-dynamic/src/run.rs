//! A mechanism from text with its values, and its runs.

use std::fmt;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;

use plm_compiler::lowered::{Lowered, Named};
use plm_run::Integrator;
use plm_runtime::contact::Counts;
use plm_runtime::sim::Notice;
use plm_runtime::{BodyState, Fault, Stats};

use crate::column::Column;
use crate::handle::Dynamic;
use crate::native::Translator;
use crate::numbers::Numbers;
use crate::record::{Sample, Seeing, Watch};
use crate::running::{Counted, CountedContacts, Noticed, OnRun, Record, Running, SetInput, StepTo};
use crate::sizes::{Given, Models};
use crate::text::{Compiled, Refused};

/// A mechanism from text, with the values of its parameters and inputs.
///
/// ```
/// use plm_dynamic::Mechanism;
///
/// let mut pendulum = Mechanism::from_text(
///     "pub Pendulum {
///         param length: m = 1 m;
///         gravity: 9.81 m/s^2;
///         ground { port o: (0, 0) m; }
///         body bob {
///             mass: 1 kg; inertia: 0.01 kg*m^2;
///             port pivot: (0 m, length);
///             start angle: 30 deg, locked;
///         }
///         revolute hinge(ground.o, bob.pivot);
///         output bob.angle;
///     }",
/// )?;
/// pendulum.set_parameter("length", 0.5)?;
/// let mut run = pendulum.start()?;
/// run.step_to(0.2)?;
/// assert!(run.output("bob.angle")? < 0.5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Mechanism {
    pub(crate) models: Models,
    pub(crate) given: Given,
}

/// Why a mechanism does not run.
#[derive(Clone, Debug, PartialEq)]
pub enum Error {
    /// Its text gives none.
    Refused(Refused),
    /// It has nothing of this name: what was looked for, the name, and those that there are.
    Unknown {
        /// `parameter`, `input`, `start value`, `body`, `output`.
        what: &'static str,
        /// The name.
        name: String,
        /// All names, separated by commas.
        known: String,
    },
    /// A parameter that has no default was not given.
    NotGiven(String),
    /// There is no room for more than 8 bodies in [`Small`](crate::Small).
    MoreThanSmall,
    /// The run has ended.
    Fault(Fault),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Refused(refused) => refused.fmt(f),
            Self::Unknown { what, name, known } if known.is_empty() => {
                write!(f, "there is no {what} `{name}`: the mechanism has none")
            }
            Self::Unknown { what, name, known } => {
                write!(f, "there is no {what} `{name}`; there are {known}")
            }
            Self::NotGiven(name) => write!(f, "the parameter `{name}` has no default: it must be given"),
            Self::MoreThanSmall => f.write_str("mechanisms of at most 8 bodies are identified"),
            Self::Fault(fault) => fault.fmt(f),
        }
    }
}

impl std::error::Error for Error {}

impl From<Fault> for Error {
    fn from(fault: Fault) -> Self {
        Self::Fault(fault)
    }
}

impl From<Refused> for Error {
    fn from(refused: Refused) -> Self {
        Self::Refused(refused)
    }
}

/// The place of a name.
pub(crate) fn place<'a>(
    what: &'static str,
    name: &str,
    names: impl Iterator<Item = &'a str> + Clone,
) -> Result<usize, Error> {
    names.clone().position(|own| own == name).ok_or_else(|| Error::Unknown {
        what,
        name: name.to_owned(),
        known: names.collect::<Vec<_>>().join(", "),
    })
}

impl Mechanism {
    /// Compiles a declaration: the inside of a call of `mechanism!`.
    ///
    /// # Errors
    /// [`Error::Refused`], with the diagnostics of its mistakes, or where it is too large.
    pub fn from_text(text: &str) -> Result<Self, Error> {
        Self::from_named_text("<text>", text)
    }

    /// Compiles the declaration in a file; files that it names are read beside it.
    ///
    /// # Errors
    /// As [`from_text`](Self::from_text); [`Refused::Mistakes`] where the file cannot be read.
    pub fn from_file(path: impl AsRef<Path>) -> Result<Self, Error> {
        let name = path.as_ref().display().to_string();
        let unread = |error: std::io::Error| Refused::Mistakes(format!("{name}: {error}"));
        Self::from_named_text(&name, &std::fs::read_to_string(&path).map_err(unread)?)
    }

    /// Compiles a declaration whose diagnostics have this name of a file; files that it names are read beside that.
    ///
    /// # Errors
    /// As [`from_text`](Self::from_text).
    pub fn from_named_text(name: &str, text: &str) -> Result<Self, Error> {
        let models = Models::new(Compiled::new(name, text)?)?;
        let given = Given::nothing(models.smallest());
        Ok(Self { models, given })
    }

    /// Its tables and routines.
    pub fn lowered(&self) -> &'static Lowered {
        self.models.smallest().lowered
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.lowered().name
    }

    /// Name and SI unit of each parameter.
    pub fn parameters(&self) -> impl Iterator<Item = (&str, &str)> + Clone {
        self.lowered().parameters.iter().map(|param| (param.name.as_str(), param.unit.as_str()))
    }

    /// Name and SI unit of each input.
    pub fn inputs(&self) -> impl Iterator<Item = (&str, &str)> + Clone {
        self.lowered().inputs.iter().map(|Named { name, unit }| (name.as_str(), unit.as_str()))
    }

    /// Has functions computed by machine code of a translator from now on, also in runs of it that have begun. The first translator
    /// stays.
    pub fn translate_by(&self, translator: Arc<dyn Translator>) {
        self.models.translate_by(translator);
    }

    /// Gives a parameter a value, SI.
    ///
    /// # Errors
    /// [`Error::Unknown`].
    pub fn set_parameter(&mut self, name: &str, value: f64) -> Result<(), Error> {
        let place = place("parameter", name, self.parameters().map(|(name, _)| name))?;
        self.given.parameters[place] = Some(value);
        Ok(())
    }

    /// Gives an input the value, SI, that it begins with.
    ///
    /// # Errors
    /// [`Error::Unknown`].
    pub fn set_input(&mut self, name: &str, value: f64) -> Result<(), Error> {
        let place = place("input", name, self.inputs().map(|(name, _)| name))?;
        self.given.inputs[place] = Some(value);
        Ok(())
    }

    /// The mechanism by the contracts of the runtime, with its parameters and start values, for work on dual numbers; of at most 8
    /// bodies.
    ///
    /// # Errors
    /// [`Error::NotGiven`]; [`Error::MoreThanSmall`].
    pub fn small(&self) -> Result<Dynamic<f64, 24, 32, 64, 24>, Error> {
        let (Models::Tiny([_, model], _) | Models::Small(model, _)) = self.models else {
            return Err(Error::MoreThanSmall);
        };
        self.all_given()?;
        Ok(self.given.mechanism(model))
    }

    /// Says that the start closes only far from where it is declared, if it does: it is hardly the one that is meant.
    pub fn far_start(&self) -> Option<String> {
        self.models.far(&self.given)
    }

    /// Assembles it, and gives a run by the method of Dormand and Prince of order 8.
    ///
    /// # Errors
    /// As [`start_with`](Self::start_with).
    pub fn start(&self) -> Result<Run, Error> {
        self.start_with(Integrator::default())
    }

    /// Assembles it, and gives a run by a method.
    ///
    /// # Errors
    /// [`Error::NotGiven`], [`Error::Fault`] of assembly.
    pub fn start_with(&self, method: Integrator) -> Result<Run, Error> {
        self.all_given()?;
        let lowered = self.lowered();
        let sim = self.models.start(method, &self.given)?;
        Ok(Run {
            sim,
            stats: Stats::default(),
            bodies: lowered.bodies.clone(),
            inputs: lowered.inputs.iter().map(|input| input.name.clone()).collect(),
            outputs: lowered.outputs.iter().map(Column::of).collect(),
        })
    }
}

/// A running simulation. A copy goes on as the original does, to the bit.
#[derive(Clone)]
pub struct Run {
    sim: Running,
    stats: Stats,
    bodies: Vec<String>,
    inputs: Vec<String>,
    outputs: Vec<Column>,
}

impl fmt::Debug for Run {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Run").field("time", &self.time()).finish_non_exhaustive()
    }
}

impl Run {
    /// All its numbers at the present moment.
    pub fn numbers(&self) -> Numbers {
        self.sim.numbers()
    }

    /// The time, s.
    pub fn time(&self) -> f64 {
        self.sim.time()
    }

    /// Runs to a time, s.
    ///
    /// # Errors
    /// [`Error::Fault`]: time, part and cause; the run stands where it ended.
    pub fn step_to(&mut self, time: f64) -> Result<(), Error> {
        Ok(self.then(StepTo(time))?)
    }

    /// Runs to a time, s, and shows a sample every so often, s: the first one at once, further ones before and after events, as the
    /// recorder of compiled programs. A run whose observer breaks ends before its time.
    ///
    /// # Errors
    /// [`Error::Fault`]; the last sample is where the run ended.
    pub fn record(
        &mut self,
        until: f64,
        every: f64,
        see: impl FnMut(&Sample) -> ControlFlow<()>,
    ) -> Result<(), Error> {
        let watch = &mut Seeing(see, ControlFlow::Continue(()));
        Ok(self.then(Record { times: (until, every), shows_end: false, watch })?)
    }

    /// Runs to a time, s, as [`record`](Self::record) does, shows more, and ends with a sample of where it ends.
    ///
    /// # Errors
    /// [`Error::Fault`]; the last sample is where the run ended.
    pub fn watch(&mut self, until: f64, every: f64, watch: &mut dyn Watch) -> Result<(), Error> {
        Ok(self.then(Record { times: (until, every), shows_end: true, watch })?)
    }

    /// Notices to the user that do not end the run.
    pub fn notices(&mut self) -> Vec<Notice> {
        self.sim.then(Noticed)
    }

    /// Counters of contact events.
    pub fn contact_stats(&mut self) -> Counts {
        self.sim.then(CountedContacts)
    }

    /// Does something with the simulation, whatever its size and its method: records it, looks for an equilibrium, linearises it.
    pub fn then<W: OnRun>(&mut self, work: W) -> W::Output {
        let output = self.sim.then(work);
        self.stats = self.sim.then(Counted);
        output
    }

    /// Counters of the run so far.
    pub fn stats(&self) -> Stats {
        self.stats
    }

    /// Names of the bodies, in the order of the declaration.
    pub fn bodies(&self) -> impl Iterator<Item = &str> {
        self.bodies.iter().map(String::as_str)
    }

    /// Pose and velocity of the centre of gravity of a body.
    ///
    /// # Errors
    /// [`Error::Unknown`].
    pub fn body(&self, name: &str) -> Result<BodyState<f64>, Error> {
        let at = place("body", name, self.bodies.iter().map(String::as_str))?;
        let missing = || Error::Unknown { what: "body", name: name.to_owned(), known: String::new() };
        self.sim.body(at).ok_or_else(missing)
    }

    /// A number of the outputs, declared or observed, SI; of a vector `hinge.force.x`.
    ///
    /// # Errors
    /// [`Error::Unknown`].
    pub fn output(&self, name: &str) -> Result<f64, Error> {
        let at = place("output", name, self.outputs.iter().map(|column| column.name.as_str()))?;
        Ok(self.sim.output(at))
    }

    /// All numbers that can be read, declared outputs among them: those of a [`Sample`].
    pub fn all_columns(&self) -> &[Column] {
        &self.outputs
    }

    /// Name and unit of each number of [`row`](Self::row).
    pub fn columns(&self) -> impl Iterator<Item = (&str, &str)> {
        let declared = self.outputs.iter().filter(|column| column.declared);
        declared.map(|column| (column.name.as_str(), column.unit.as_str()))
    }

    /// The declared outputs in the units of [`columns`](Self::columns), as `outputs()` of compiled mechanisms gives them.
    pub fn row(&self) -> Vec<f64> {
        let declared = self.outputs.iter().enumerate().filter(|(_, column)| column.declared);
        let value = |(k, column): (usize, &Column)| {
            let value = self.sim.output(k);
            if (column.factor - 1.0).abs() > 0.0 { value / column.factor } else { value }
        };
        declared.map(value).collect()
    }

    /// Gives an input a value, SI, from now on.
    ///
    /// # Errors
    /// [`Error::Unknown`].
    pub fn set_input(&mut self, name: &str, value: f64) -> Result<(), Error> {
        let at = place("input", name, self.inputs.iter().map(String::as_str))?;
        self.then(SetInput(at, value));
        Ok(())
    }
}
