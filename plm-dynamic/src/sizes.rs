//! Sizes of mechanisms from text: the smallest one that has room is taken.

use std::sync::Arc;

use plm_run::Integrator;
use plm_runtime::{Dop853, Fault, Method, Moment, Real, Rk4, Sim};

use crate::handle::Dynamic;
use crate::model::Model;
use crate::native::Translator;
use crate::run::Error;
use crate::running::Running;
use crate::system::State;
use crate::text::{Compiled, Refused};

/// Mechanisms of at most 3 bodies, 8 constraint rows and 14 first-order states.
pub(crate) type Tiny = Dynamic<f64, 9, 8, 32>;
/// Mechanisms of at most 8 bodies, 32 constraint rows and 16 first-order states.
pub type Small = Dynamic<f64, 24, 32, 64>;
/// Mechanisms of at most 64 bodies, 224 constraint rows and 64 first-order states, whose loops remember at most 64 numbers of each kind.
pub type Large = Dynamic<f64, 192, 224, 448, 64>;

/// The tables of a mechanism, of the smallest size that has room.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Models {
    /// Those of [`Tiny`], and those of [`Small`], which runs by every method.
    Tiny([&'static Model; 2]),
    /// Those of [`Small`].
    Small(&'static Model),
    /// Those of [`Large`].
    Large(&'static Model),
}

/// Values that are given to parameters, inputs and starts, by number, and the time at which runs begin, s.
#[derive(Clone, Debug)]
pub(crate) struct Given {
    pub(crate) parameters: Vec<Option<f64>>,
    pub(crate) inputs: Vec<Option<f64>>,
    pub(crate) starts: Vec<Option<f64>>,
    pub(crate) time: f64,
}

impl Given {
    /// All as declared.
    pub(crate) fn nothing(model: &Model) -> Self {
        let [parameters, inputs, starts] =
            [model.lowered.parameters.len(), model.lowered.inputs.len(), model.names_of_starts.len()]
                .map(|count| vec![None; count]);
        Self { parameters, inputs, starts, time: 0.0 }
    }

    /// A mechanism with the values of parameters and starts.
    pub(crate) fn to<const NQ: usize, const NC: usize, const N: usize, const L: usize>(
        &self,
        model: &'static Model,
    ) -> Dynamic<f64, NQ, NC, N, L> {
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

impl Models {
    pub(crate) fn new(compiled: Compiled) -> Result<Models, Refused> {
        if compiled.fits::<9, 8, 32, 9>().is_ok() {
            let small = compiled.clone().model(24);
            return Ok(Self::Tiny([compiled.model(9), small]));
        }
        if compiled.fits::<24, 32, 64, 24>().is_ok() {
            return Ok(Self::Small(compiled.model(24)));
        }
        compiled.fits::<192, 224, 448, 64>()?;
        Ok(Self::Large(compiled.model(192)))
    }

    /// Those of the smallest size.
    pub(crate) fn smallest(self) -> &'static Model {
        match self {
            Self::Tiny([model, _]) | Self::Small(model) | Self::Large(model) => model,
        }
    }

    /// Those of [`Small`], where it has room.
    pub(crate) fn small(self) -> Option<&'static Model> {
        match self {
            Self::Tiny([_, small]) | Self::Small(small) => Some(small),
            Self::Large(_) => None,
        }
    }

    pub(crate) fn translate_by(self, translator: Arc<dyn Translator>) {
        if let Self::Tiny([_, small]) = self {
            small.translate_by(Arc::clone(&translator));
        }
        self.smallest().translate_by(translator);
    }

    /// A run by a method.
    pub(crate) fn start(self, method: Integrator, given: &Given) -> Result<Running, Error> {
        Ok(match (self, method) {
            (Self::Tiny([tiny, _]), Integrator::Dop853(rtol)) => {
                Running::TinyDop853(sim::<9, 8, 32, 9, _>((tiny, given), Dop853::new(rtol))?)
            }
            (Self::Tiny([tiny, _]), Integrator::Rk4(h)) => {
                Running::TinyRk4(sim::<9, 8, 32, 9, _>((tiny, given), Rk4::new(h))?)
            }
            (Self::Tiny([_, small]) | Self::Small(small), method) => {
                let small: Small = given.to(small);
                Running::Small(Box::new(method.of(started(&small, &given.inputs, given.time)?)))
            }
            (Self::Large(large), Integrator::Dop853(rtol)) => {
                Running::LargeDop853(sim::<192, 224, 448, 64, _>((large, given), Dop853::new(rtol))?)
            }
            (Self::Large(large), Integrator::Rk4(h)) => {
                Running::LargeRk4(sim::<192, 224, 448, 64, _>((large, given), Rk4::new(h))?)
            }
            (Self::Large(_), _) => return Err(Error::Method("Dop853 and Rk4")),
        })
    }
}

/// A simulation by a method.
type Boxed<M, I> = Box<Sim<M, I>>;

fn sim<
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    I: Method<Dynamic<f64, NQ, NC, N, L>>,
>(
    (model, given): (&'static Model, &Given),
    method: I,
) -> Result<Boxed<Dynamic<f64, NQ, NC, N, L>, I>, Fault> {
    let mechanism: Dynamic<f64, NQ, NC, N, L> = given.to(model);
    Ok(Box::new(Sim::new(started(&mechanism, &given.inputs, given.time)?, method)))
}

/// A start with the inputs that are given.
pub(crate) fn started<S: Real, const NQ: usize, const NC: usize, const N: usize, const L: usize>(
    mechanism: &Dynamic<S, NQ, NC, N, L>,
    given: &[Option<S>],
    time: S,
) -> Result<State<S, NQ, NC, N, L>, Fault> {
    let mut inputs = mechanism.declared_input();
    for (input, given) in inputs.iter_mut().zip(given) {
        *input = given.unwrap_or(*input);
    }
    let (held, x) = mechanism.start_holding(time, inputs)?;
    Ok(State::new(*mechanism, held, time, x))
}
