//! Values of variables, states and rates.

use alloc::boxed::Box;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

use plm_runtime::{Moment, Rate, Vector};

use super::{Handle, Outcome, Reason, fill, opened, put, read, with};
use crate::fmi::{Call, Exchanged, Facts, Instance, Variable, follow};
use crate::{Error, Status};

/// Why values were not had or set.
enum Refused {
    /// The call is wrong as a whole.
    Call(Error),
    /// No variable has this value reference.
    Reference(u32),
    /// A variable by its name.
    Variable(Box<(String, Error)>),
}

impl Refused {
    fn of<M: Exchanged>(instance: &Instance<M>, reference: u32, error: Error) -> Self {
        let name = usize::try_from(reference)
            .ok()
            .and_then(|place| Facts::of(instance.declared()).names().into_iter().nth(place));
        Self::Variable(Box::new((name.unwrap_or_default(), error)))
    }
}

impl From<Error> for Refused {
    fn from(error: Error) -> Self {
        Self::Call(error)
    }
}

impl From<Status> for Refused {
    fn from(status: Status) -> Self {
        Self::Call(status.into())
    }
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Call(error) => error.fmt(f),
            Self::Reference(reference) => write!(f, "no variable has the value reference {reference}"),
            Self::Variable(of) => write!(f, "{}: {}", of.0, of.1),
        }
    }
}

impl Reason for Refused {
    fn is_of_state(&self) -> bool {
        match self {
            Self::Call(error) => error.is_of_state(),
            Self::Variable(of) => of.1.is_of_state(),
            Self::Reference(_) => false,
        }
    }
}

/// The variables of value references.
///
/// # Safety
/// As of [`read`].
unsafe fn variables<M: Exchanged>(
    of: &Instance<M>,
    (at, count): (*const u32, usize),
) -> Result<Vec<(u32, Variable)>, Refused> {
    // SAFETY: the caller's part.
    let references = unsafe { read(at, count)? };
    let found = references.iter().map(|reference| {
        let variable = Variable::of(of.declared(), *reference).ok_or(Refused::Reference(*reference))?;
        Ok((*reference, variable))
    });
    found.collect()
}

/// The value of each of some variables.
fn each<M: Exchanged, T>(
    instance: &mut Instance<M>,
    wanted: &[(u32, Variable)],
    mut of: impl FnMut(&mut Instance<M>, Variable) -> Result<T, Error>,
) -> Result<Vec<T>, Refused> {
    let value = |(reference, variable): &(u32, Variable)| {
        of(instance, *variable).map_err(|error| Refused::of(instance, *reference, error))
    };
    wanted.iter().map(value).collect()
}

/// `fmi3GetFloat64`
///
/// # Safety
/// As of [`with`]; the arrays are null or the caller's.
pub unsafe fn get<M: Exchanged>(
    handle: *mut Handle<M>,
    references: (*const u32, usize),
    values: (*mut f64, usize),
) -> Outcome {
    let work = |Handle { instance, .. }: &mut Handle<M>| {
        // SAFETY: the caller's part.
        let wanted = unsafe { variables(instance, references)? };
        // The first output works out all of them: they have the pose and the accelerations in common.
        let indices = wanted.iter().filter_map(|(_, variable)| variable.output());
        let (indices, mut outputs): (Vec<usize>, Option<_>) = (indices.collect(), None);
        let found = each(instance, &wanted, |instance, variable| {
            if variable.output().is_none() {
                return instance.get(variable);
            }
            let all = match &mut outputs {
                Some(all) => all,
                none => none.insert(instance.outputs(&indices)?.into_iter()),
            };
            all.next().flatten().ok_or(Status::NoSuch.into())
        })?;
        // SAFETY: the caller's part.
        unsafe { fill(values, &found)? };
        Ok::<_, Refused>(())
    };
    // SAFETY: the caller's part.
    unsafe { opened(handle, Some(Call::Get), work) }
}

/// `fmi3SetFloat64`; where one of several is refused, none is set.
///
/// # Safety
/// As of [`get`].
pub unsafe fn set<M: Exchanged>(
    handle: *mut Handle<M>,
    references: (*const u32, usize),
    values: (*const f64, usize),
) -> Outcome {
    let work = |Handle { instance, .. }: &mut Handle<M>| {
        // SAFETY: the caller's part.
        let (wanted, values) = unsafe { (variables(instance, references)?, read(values.0, values.1)?) };
        if wanted.len() != values.len() {
            return Err(Refused::from(Status::NoSuch));
        }
        let mut changed = instance.clone();
        for (value, (reference, variable)) in values.iter().zip(wanted) {
            let outcome = changed.set(variable, *value);
            outcome.map_err(|error| Refused::of(instance, reference, error))?;
        }
        *instance = changed;
        Ok(())
    };
    // SAFETY: the caller's part.
    unsafe { opened(handle, Some(Call::Set), work) }
}

/// `fmi3GetDirectionalDerivative`
///
/// # Safety
/// As of [`get`].
pub unsafe fn tangents<M: Exchanged>(
    handle: *mut Handle<M>,
    (unknowns, knowns): ((*const u32, usize), (*const u32, usize)),
    seeds: (*const f64, usize),
    tangents: (*mut f64, usize),
) -> Outcome {
    let work = |Handle { instance, .. }: &mut Handle<M>| {
        // SAFETY: the caller's part.
        let (unknowns, knowns) = unsafe { (variables(instance, unknowns)?, variables(instance, knowns)?) };
        // SAFETY: the caller's part.
        let seeds = unsafe { read(seeds.0, seeds.1)? };
        if seeds.len() != knowns.len() {
            return Err(Status::NoSuch.into());
        }
        if let Some(((reference, _), _)) = knowns.iter().zip(seeds).find(|(_, seed)| !seed.is_finite()) {
            return Err(Refused::of(instance, *reference, Status::NotFinite.into()));
        }
        let knowns: Vec<_> = knowns.into_iter().map(|(_, known)| known).zip(seeds.iter().copied()).collect();
        let unknowns: Vec<_> = unknowns.into_iter().map(|(_, unknown)| unknown).collect();
        let found = instance.tangents(&knowns, &unknowns)?;
        // SAFETY: the caller's part.
        unsafe { fill(tangents, &found)? };
        Ok(())
    };
    // SAFETY: the caller's part.
    unsafe { opened(handle, Some(Call::GetDirectionalDerivative), work) }
}

/// A vector that a simulator asks for.
#[derive(Clone, Copy, Debug)]
pub enum Given {
    /// `fmi3GetContinuousStates`
    States,
    /// `fmi3GetContinuousStateDerivatives`
    Rates,
    /// `fmi3GetEventIndicators`
    Indicators,
    /// `fmi3GetNominalsOfContinuousStates`
    Nominals,
}

impl Given {
    fn call(self) -> Call {
        match self {
            Self::States => Call::GetContinuousStates,
            Self::Rates => Call::GetContinuousStateDerivatives,
            Self::Indicators => Call::GetEventIndicators,
            Self::Nominals => Call::GetNominalsOfContinuousStates,
        }
    }

    fn of<M: Exchanged>(self, instance: &mut Instance<M>) -> Result<Vec<f64>, Error> {
        instance.renew()?;
        Ok(match self {
            Self::States => numbers(instance.state()?.x()),
            Self::Rates => numbers(&instance.rates()?),
            Self::Indicators => instance.indicators()?,
            Self::Nominals => numbers(&instance.state()?.mechanism().typical()),
        })
    }
}

fn numbers<X: Vector<f64>>(vector: &X) -> Vec<f64> {
    (0..X::LEN).map(|index| vector.at(index)).collect()
}

/// A vector of the mechanism into room of the caller.
///
/// # Safety
/// As of [`get`].
pub unsafe fn give<M: Exchanged>(handle: *mut Handle<M>, what: Given, room: (*mut f64, usize)) -> Outcome {
    let work = |instance: &mut Instance<M>| {
        let numbers = what.of(instance)?;
        // SAFETY: the caller's part.
        unsafe { fill(room, &numbers) }
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, what.call(), work) }
}

/// `fmi3GetNumberOfContinuousStates`, `fmi3GetNumberOfEventIndicators`
///
/// # Safety
/// As of [`with`]; `count` is null or the caller's.
pub unsafe fn count<M: Exchanged>(handle: *mut Handle<M>, call: Call, count: *mut usize) -> Outcome {
    let work = |instance: &mut Instance<M>| {
        let number = match call {
            Call::GetNumberOfEventIndicators => follow::indicators(instance.declared()),
            _ => <M as Rate>::X::LEN,
        };
        // SAFETY: the caller's part.
        unsafe { put(count, number) }
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, call, work) }
}

/// `fmi3SetContinuousStates`
///
/// # Safety
/// As of [`get`].
pub unsafe fn set_states<M: Exchanged>(handle: *mut Handle<M>, (at, count): (*const f64, usize)) -> Outcome {
    let work = |instance: &mut Instance<M>| {
        // SAFETY: the caller's part.
        let states = unsafe { read(at, count)? };
        if states.len() != <M as Rate>::X::LEN {
            return Err(Status::NoSuch.into());
        }
        let x = <M as Rate>::X::from_fn(|index| states.get(index).copied().unwrap_or_default());
        instance.place(None, Some(x))
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, Call::SetContinuousStates, work) }
}

/// `fmi3GetInt64`, `fmi2GetInteger`: the method of co-simulation, and what rows of contact do.
///
/// # Safety
/// As of [`get`].
pub unsafe fn get_integers<M: Exchanged, T: TryFrom<i64> + Copy>(
    handle: *mut Handle<M>,
    references: (*const u32, usize),
    values: (*mut T, usize),
) -> Outcome {
    let work = |Handle { instance, .. }: &mut Handle<M>| {
        // SAFETY: the caller's part.
        let wanted = unsafe { variables(instance, references)? };
        let found = each(instance, &wanted, |instance, variable| {
            T::try_from(instance.integer(variable)?).map_err(|_| Status::NoSuch.into())
        })?;
        // SAFETY: the caller's part.
        unsafe { fill(values, &found)? };
        Ok::<_, Refused>(())
    };
    // SAFETY: the caller's part.
    unsafe { opened(handle, Some(Call::Get), work) }
}

/// `fmi3SetInt64`, `fmi2SetInteger`: the method alone; where one of several is refused, none is set.
///
/// # Safety
/// As of [`get`].
pub unsafe fn set_integers<M: Exchanged, T: Into<i64> + Copy>(
    handle: *mut Handle<M>,
    references: (*const u32, usize),
    values: (*const T, usize),
) -> Outcome {
    let mut wanted = None;
    let look = |Handle { instance, .. }: &mut Handle<M>| {
        // SAFETY: the caller's part.
        let (named, values) = unsafe { (variables(instance, references)?, read(values.0, values.1)?) };
        if named.len() != values.len() {
            return Err(Status::NoSuch.into());
        }
        if let Some((reference, other)) = named.iter().find(|(_, variable)| *variable != Variable::Method) {
            let status =
                if matches!(other, Variable::Contact(_)) { Status::ReadOnly } else { Status::NoSuch };
            return Err(Refused::of(instance, *reference, status.into()));
        }
        wanted = values.last().map(|value| (*value).into());
        Ok(())
    };
    // SAFETY: the caller's part.
    let outcome = unsafe { opened(handle, Some(Call::Set), look) };
    match wanted {
        // SAFETY: the caller's part.
        Some(number) if outcome == 0 => unsafe {
            opened(handle, None, |handle| handle.instance.set_method(number))
        },
        _ => outcome,
    }
}
