//! Numbers of a mechanism that are to be found, by their names.

use plm_runtime::StartValues;

use crate::optimise::error::{Error, place};
use crate::optimise::mechanism::Optimisable;
use crate::optimise::shot::Direction;

/// A number of a mechanism that is to be found, with guess, bounds and prior; in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Unknown {
    pub(crate) name: String,
    pub(crate) kind: Kind,
    pub(crate) guess: Option<f64>,
    pub(crate) bounds: [f64; 2],
    /// The value that is expected, and its standard deviation.
    pub(crate) prior: Option<[f64; 2]>,
    pub(crate) scale: Option<f64>,
}

/// Which number of a mechanism it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Parameter,
    Start,
}

impl Unknown {
    /// A parameter; start values that are declared by it follow.
    pub fn parameter(name: impl Into<String>) -> Self {
        Self::new(name, Kind::Parameter)
    }

    /// A start value, such as `mass.vx`, or a first-order state at the start.
    pub fn start(name: impl Into<String>) -> Self {
        Self::new(name, Kind::Start)
    }

    fn new(name: impl Into<String>, kind: Kind) -> Self {
        let bounds = [f64::NEG_INFINITY, f64::INFINITY];
        Self { name: name.into(), kind, guess: None, bounds, prior: None, scale: None }
    }

    /// Begins the search at this value rather than at that of the mechanism.
    #[must_use]
    pub fn from(self, guess: f64) -> Self {
        Self { guess: Some(guess), ..self }
    }

    /// Bounds the value; a bound may be infinite.
    #[must_use]
    pub fn within(self, least: f64, most: f64) -> Self {
        Self { bounds: [least, most], ..self }
    }

    /// Adds prior knowledge: a value and its standard deviation.
    #[must_use]
    pub fn expected(self, value: f64, deviation: f64) -> Self {
        Self { prior: Some([value, deviation]), ..self }
    }

    /// Sets the typical size of the value, for values near zero; without it the guess, the bounds or the expected deviation determine it.
    #[must_use]
    pub fn of_size(self, size: f64) -> Self {
        Self { scale: Some(size), ..self }
    }
}

/// An unknown that was found in the tables of the mechanism.
#[derive(Clone, Debug)]
pub(crate) struct Place {
    pub(crate) name: String,
    pub(crate) direction: Direction,
    pub(crate) guess: f64,
    pub(crate) bounds: [f64; 2],
    pub(crate) prior: Option<[f64; 2]>,
    pub(crate) scale: f64,
    /// Unit of its declaration.
    pub(crate) unit: &'static str,
    /// A value in SI is one in this unit times the factor.
    pub(crate) factor: f64,
}

impl Place {
    /// Looks an unknown up; `known` has what the mechanism is set to.
    ///
    /// # Errors
    /// A name that is not there, bounds that are not in order, a deviation that is not positive.
    pub(crate) fn of<M: Optimisable>(unknown: &Unknown, known: &M) -> Result<Self, Error> {
        let Unknown { name, kind, guess, bounds, prior, scale } = unknown;
        let (direction, declared, unit, factor) = match kind {
            Kind::Parameter => {
                let all = known.tables().parameters;
                let index = place("parameter", name, all.iter().map(|parameter| parameter.name))?;
                let value = known.parameter(index).unwrap_or(f64::NAN);
                let (unit, factor) = all.get(index).map_or(("", 1.0), |own| (own.unit, own.factor));
                (Direction::Parameter(index), value, unit, factor)
            }
            Kind::Start => {
                let all = starts(known);
                let index = place("start value", name, all.iter().map(|(name, _)| *name))?;
                let (unit, factor) = unit_of_start(known, name);
                let value = all.get(index).map_or(f64::NAN, |(_, value)| *value);
                (Direction::Start(index), value, unit, factor)
            }
        };
        let guess = guess.unwrap_or(declared);
        let is_size = |size: f64| size > 0.0 && size.is_finite();
        let is_right = bounds[0] <= bounds[1]
            && prior.is_none_or(|[value, deviation]| value.is_finite() && is_size(deviation))
            && scale.is_none_or(is_size)
            && guess.is_finite();
        if !is_right {
            return Err(Error::Senseless { name: name.clone(), guess, bounds: *bounds });
        }
        let scale = scale.unwrap_or_else(|| typical(guess, *bounds, *prior));
        Ok(Self { name: name.clone(), direction, guess, bounds: *bounds, prior: *prior, scale, unit, factor })
    }

    /// Gives the number of a mechanism this value.
    pub(crate) fn set<M: Optimisable>(&self, mechanism: &mut M, value: f64) {
        match self.direction {
            Direction::Parameter(index) => {
                plm_runtime::described::by_number::set_parameter(mechanism, index, value);
            }
            Direction::Start(index) => set_start(mechanism, index, value),
            _ => {}
        }
    }
}

/// Name and value of each start.
pub(crate) fn starts<M: Optimisable>(mechanism: &M) -> Vec<(&'static str, f64)> {
    let (mut own, mut all) = (*mechanism, Vec::new());
    own.starts_mut().each(&mut |name, start| all.push((name, start.value)));
    all
}

/// Gives a start value, by its number.
pub(crate) fn set_start<M: Optimisable>(mechanism: &mut M, index: usize, value: f64) {
    let mut k = 0;
    mechanism.starts_mut().each(&mut |_, start| {
        if k == index {
            *start = start.at(value);
        }
        k += 1;
    });
}

/// Unit and factor of a start value: those of the declaration of a state, SI of a pose and its velocity.
fn unit_of_start<M: Optimisable>(mechanism: &M, name: &str) -> (&'static str, f64) {
    if let Some(state) = mechanism.tables().states.iter().find(|state| state.name == name) {
        return (state.unit, state.factor);
    }
    let unit = match name.rsplit('.').next().unwrap_or_default() {
        "angle" => "rad",
        "omega" => "rad/s",
        "vx" | "vy" => "m/s",
        _ => "m",
    };
    (unit, 1.0)
}

fn typical(guess: f64, bounds: [f64; 2], prior: Option<[f64; 2]>) -> f64 {
    let range = bounds[1] - bounds[0];
    let sizes = [
        guess.abs(),
        prior.map_or(0.0, |[_, deviation]| deviation),
        if range.is_finite() { range } else { 0.0 },
    ];
    sizes.into_iter().find(|size| *size > 0.0).unwrap_or(1.0)
}
