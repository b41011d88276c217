//! Sizes of mechanisms from text: the smallest one that has room is taken.

use std::sync::Arc;

use plm_run::{AnySim, Integrator};
use plm_runtime::{Fault, Moment, Real};

use crate::handle::Dynamic;
use crate::model::Model;
use crate::native::Translator;
use crate::running::Running;
use crate::system::State;
use crate::text::{Compiled, Refused};

/// Mechanisms of at most 3 bodies, 8 constraint rows and 14 first-order states.
pub(crate) type Tiny = Dynamic<f64, 9, 8, 32>;
/// Those without contact, of at most 2 first-order states, 8 inputs and 8 conditions, whose loops remember at most 6 numbers of each kind.
pub(crate) type PlainTiny = Dynamic<f64, 9, 8, 20, 6, 8, 0>;
/// Those without contact as [`PlainTiny`], of at most 14 first-order states.
pub(crate) type PlainTinyStates = Dynamic<f64, 9, 8, 32, 6, 8, 0>;
/// Mechanisms of at most 8 bodies, 32 constraint rows and 16 first-order states.
pub type Small = Dynamic<f64, 24, 32, 64>;
/// Those without contact, of at most 8 inputs and 8 conditions, whose loops remember at most 12 numbers of each kind.
pub(crate) type PlainSmall = Dynamic<f64, 24, 32, 64, 12, 8, 0>;
/// Mechanisms of at most 64 bodies, 224 constraint rows and 64 first-order states, whose loops remember at most 64 numbers of each kind.
pub type Large = Dynamic<f64, 192, 224, 448, 64>;

/// The tables of a mechanism, of the smallest size that has room.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Models {
    /// Those of [`Tiny`], and those of [`Small`], in which derivatives and steps by themselves are made.
    Tiny([&'static Model; 2], Contents),
    /// Those of [`Small`].
    Small(&'static Model, Contents),
    /// Those of [`Large`].
    Large(&'static Model),
}

/// Contents for which a discrete state needs room: it is copied in each step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Contents {
    /// Few inputs and conditions, small loops and no contact: [`PlainTiny`] or [`PlainSmall`] is enough.
    Plain,
    /// As `Plain`, with more first-order states than [`PlainTiny`] has room for: [`PlainTinyStates`] is enough.
    PlainStates,
    /// More.
    Full,
}

impl<
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> Dynamic<f64, NQ, NC, N, L, H, R, P>
{
    /// Is there room for a mechanism?
    fn has_room(of: &Compiled) -> Result<(), Refused> {
        of.fits::<NQ, NC, N, L, H, R, P>()
    }
}

/// Values that are given to parameters, inputs and start values, by number, and when runs begin.
#[derive(Clone, Debug)]
pub(crate) struct Given {
    pub(crate) parameters: Vec<Option<f64>>,
    pub(crate) inputs: Vec<Option<f64>>,
    pub(crate) starts: Vec<Option<f64>>,
    /// s.
    pub(crate) time: f64,
}

impl Given {
    /// Nothing is given of a mechanism, whose runs begin at 0 s.
    pub(crate) fn nothing(of: &Model) -> Given {
        let lowered = of.lowered;
        let counts = [lowered.parameters.len(), lowered.inputs.len(), of.names_of_starts.len()];
        let [parameters, inputs, starts] = counts.map(|count| vec![None; count]);
        Given { parameters, inputs, starts, time: 0.0 }
    }

    /// A mechanism with the values of its parameters and starts.
    pub(crate) fn mechanism<
        const NQ: usize,
        const NC: usize,
        const N: usize,
        const L: usize,
        const H: usize,
        const R: usize,
        const P: usize,
    >(
        &self,
        model: &'static Model,
    ) -> Dynamic<f64, NQ, NC, N, L, H, R, P> {
        let mut own = Dynamic::declared(model, &self.parameters);
        for (place, value) in own.parameters.iter_mut().zip(&self.parameters) {
            *place = value.unwrap_or(*place);
        }
        if self.starts.iter().any(Option::is_some) {
            own.starts = own.declared_starts();
            let given = own.starts.values.iter_mut().zip(&self.starts);
            for (start, value) in given.filter_map(|(start, value)| value.map(|value| (start, value))) {
                *start = start.at(value);
            }
        }
        own
    }
}

impl Compiled {
    /// Is there room for it in the largest size?
    pub(crate) fn fits_largest(&self) -> Result<(), Refused> {
        Large::has_room(self)
    }
}

impl Models {
    pub(crate) fn new(compiled: Compiled) -> Result<Models, Refused> {
        if Tiny::has_room(&compiled).is_ok() {
            let contents = match (PlainTiny::has_room(&compiled), PlainTinyStates::has_room(&compiled)) {
                (Ok(()), _) => Contents::Plain,
                (_, Ok(())) => Contents::PlainStates,
                _ => Contents::Full,
            };
            let small = compiled.clone().model(24);
            return Ok(Self::Tiny([compiled.model(9), small], contents));
        }
        if Small::has_room(&compiled).is_ok() {
            let contents = PlainSmall::has_room(&compiled).map_or(Contents::Full, |()| Contents::Plain);
            return Ok(Self::Small(compiled.model(24), contents));
        }
        Large::has_room(&compiled)?;
        Ok(Self::Large(compiled.model(192)))
    }

    /// Those of the smallest size.
    pub(crate) fn smallest(self) -> &'static Model {
        match self {
            Self::Tiny([model, _], _) | Self::Small(model, _) | Self::Large(model) => model,
        }
    }

    pub(crate) fn translate_by(self, translator: Arc<dyn Translator>) {
        if let Self::Tiny([_, small], _) = self {
            small.translate_by(Arc::clone(&translator));
        }
        self.smallest().translate_by(translator);
    }

    /// Warning about a start that closes only far from where it is declared.
    pub(crate) fn far(self, given: &Given) -> Option<String> {
        match self {
            Self::Tiny([_, model], _) | Self::Small(model, _) => {
                let small: Small = given.mechanism(model);
                small.told_far(given.time)
            }
            Self::Large(model) => {
                let large: Large = given.mechanism(model);
                large.told_far(given.time)
            }
        }
    }

    /// A run by a method.
    pub(crate) fn start(self, method: Integrator, given: &Given) -> Result<Running, Fault> {
        Ok(match self {
            Self::Tiny([tiny, _], Contents::Plain) => Running::PlainTiny(sim((tiny, given), method)?),
            Self::Tiny([tiny, _], Contents::PlainStates) => {
                Running::PlainTinyStates(sim((tiny, given), method)?)
            }
            Self::Tiny([tiny, _], Contents::Full) => Running::Tiny(sim((tiny, given), method)?),
            Self::Small(small, Contents::Plain | Contents::PlainStates) => {
                Running::PlainSmall(sim((small, given), method)?)
            }
            Self::Small(small, Contents::Full) => Running::Small(sim((small, given), method)?),
            Self::Large(large) => Running::Large(sim((large, given), method)?),
        })
    }
}

fn sim<
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
>(
    (model, given): (&'static Model, &Given),
    method: Integrator,
) -> Result<Box<AnySim<Dynamic<f64, NQ, NC, N, L, H, R, P>>>, Fault> {
    Ok(Box::new(method.of(started(model, given)?)))
}

/// A start with the values that are given.
pub(crate) fn started<
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
>(
    model: &'static Model,
    given: &Given,
) -> Result<State<f64, NQ, NC, N, L, H, R, P>, Fault> {
    with_inputs(&given.mechanism(model), &given.inputs, given.time)
}

/// A start of a mechanism at a time with the inputs that are given.
pub(crate) fn with_inputs<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
>(
    mechanism: &Dynamic<S, NQ, NC, N, L, H, R, P>,
    given: &[Option<S>],
    time: S,
) -> Result<State<S, NQ, NC, N, L, H, R, P>, Fault> {
    let mut inputs = mechanism.declared_input();
    for (input, given) in inputs.iter_mut().zip(given) {
        *input = given.unwrap_or(*input);
    }
    let (held, x) = mechanism.start_holding(time, inputs)?;
    Ok(State::new(*mechanism, held, time, x))
}
